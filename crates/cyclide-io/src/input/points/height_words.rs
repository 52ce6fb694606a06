//! Words of heights in the names of columns: alone, joined to others (`Geländehöhe`), or beside them (`ell. Höhe`, `Höhe (DHHN)`).

/// Words that are heights.
const HEIGHTS: &str = "up hoogte hojd hoyde alti otmetka \u{43e}\u{442}\u{43c}\u{435}\u{442}\u{43a}\u{430} \u{432}\u{44b}\u{441}\u{43e}\u{442}\u{430} h q height \
    heights ht hgt elevation elevations elev elevacion elevacao el altitude altitudes alt altitud altitudine altura altezza hauteur hohe hoehe hohen quota \
    quote cota cotas cote level lvl rl niveau kote koten kota kot rzedna wysokosc korkeus visina vyska magassag yukseklik inaltime \
    gok okg orthometric orthometrisch orthometrique hell ellh hellip horth hort";

/// Endings of joined words that are heights: `Geländehöhe`, `maanpinnankorkeus`.
const ENDINGS: &str =
    "hohe hoehe hohen height elevation altitude hojd hoyde hoogte korkeus wysokosc kote kota cota quota hohenwert";

/// Beginnings of such words that say nothing but over what the height is, and that it is one of the ground.
const OVER: &str = "gelande gelaende ell ellips ellipsoid ortho orthometrische meeres see punkt boden terrain terreng terrang mark ground land \
    maanpinnan nn nhn nap msl normal gebrauchs absolut hohen grund strassen profil spot point grid";

/// Systems of heights, whose names alone say that a column is one: `NHN`, `DHHN2016`, `NAVD88`.
const SYSTEMS: &str = "nhn dhhn nn navd ngvd evrf nap amsl msl msnm mnn ngf ign lhn ahd unn dvr cgvd";

/// Words beside heights that make them those of instruments and signals, and differences: no place of a point.
const NO_PLACE: &str = "antenna antennen antenne instrument instrumenten reflektor reflector prisma prismen prism stab geraete gerate pole rod \
    tripod stativ target ziel zieltafel signal delta diff difference differenz differenzen unterschied dh shift korrektur correction residual";

/// Words beside heights that say over which surface they are.
const SURFACES: &str = "ellipsoidal ellipsoid ellipsoidische ellipsoidisch ellip ell hell ellh hellip wgs";

/// True for a word of a list.
fn is_among(list: &str, word: &str) -> bool {
    list.split_whitespace().any(|own| own == word)
}

/// A word without the year or number behind it: `dhhn2016`.
fn without_number(word: &str) -> &str {
    word.trim_end_matches(|c: char| c.is_ascii_digit())
}

/// True for the word of a height, in small letters without accents.
pub(super) fn is_height(word: &str) -> bool {
    is_among(HEIGHTS, word)
}

/// True for the name of a system of heights, with its year.
pub(super) fn is_system(word: &str) -> bool {
    is_among(SYSTEMS, without_number(word))
}

/// What a word that ends as heights do begins with: `gelande`.
fn beginning(word: &str) -> Option<&str> {
    ENDINGS.split_whitespace().find_map(|ending| word.strip_suffix(ending)).filter(|start| start.len() > 1)
}

/// Whether the words of a name, apart from its unit, mean a height, and whether that is certain: `Geländehöhe` is, what `Deckenhöhe` is the height of may
/// be no point. `beside` tells the words that say nothing.
pub(super) fn height_in(words: &[&str], beside: impl Fn(&str) -> bool) -> Option<bool> {
    let begins = |word: &str| beginning(word).is_some_and(|start| is_among(NO_PLACE, start));
    if words.iter().any(|word| is_among(NO_PLACE, word) || begins(word)) {
        return None;
    }
    if let [only] = words
        && is_system(only)
    {
        return Some(true);
    }
    let (mut found, mut clear) = (false, true);
    for word in words {
        if word.len() > 1 && is_height(word) {
            found = true;
        } else if let Some(start) = beginning(word) {
            found = true;
            clear &= is_among(OVER, start);
        } else {
            // Its letter may stand beside the word.
            clear &= matches!(*word, "h" | "z" | "q") || is_system(word) || is_among(SURFACES, word) || beside(word);
        }
    }
    found.then_some(clear)
}

/// True if the words of a height say that it is one over an ellipsoid, which receivers write beside the one over the sea.
pub(super) fn is_over_ellipsoid(words: &[String]) -> bool {
    words.iter().any(|word| {
        is_among(SURFACES, without_number(word)) || beginning(word).is_some_and(|start| is_among(SURFACES, start))
    })
}

#[cfg(test)]
mod tests {
    use super::super::fields::Field;
    use super::super::names::Role;

    #[test]
    fn heights_are_known_in_many_forms() {
        for (name, clear) in [
            ("Höhe H", Some(true)),
            ("Ell.Höhe", Some(true)),
            ("ell. Höhe [m]", Some(true)),
            ("Ellipsoidal Height", Some(true)),
            ("WGS84 Ellipsoidal Height (m)", Some(true)),
            ("Geländehöhe", Some(true)),
            ("GELAENDEHOEHE_M", Some(true)),
            ("Höhe (DHHN)", Some(true)),
            ("Höhe DHHN2016", Some(true)),
            ("H_NHN", Some(true)),
            ("NHN", Some(true)),
            ("DHHN2016", Some(true)),
            ("Elev (m NAVD88)", Some(true)),
            ("Orthometric", Some(true)),
            ("Kote", Some(true)),
            ("Kota", Some(true)),
            ("Rzędna", Some(true)),
            ("Wysokość", Some(true)),
            ("Korkeus", Some(true)),
            ("Höjd", Some(true)),
            ("Høyde", Some(true)),
            ("GOK", Some(true)),
            ("Hell", Some(true)),
            ("NAP-hoogte", Some(true)),
            ("Deckenhöhe", Some(false)),
            ("Baumhöhe", Some(false)),
            ("wall height [m]", Some(false)),
            ("Soll Höhe", Some(false)),
            ("Antennenhöhe", None),
            ("antenna height", None),
            ("Zielhöhe", None),
            ("Delta Höhe", None),
            ("Höhengenauigkeit", None),
            ("Height SD", None),
            ("Std. Höhe", None),
            ("Höhe Bemerkung", None),
            ("nhn_code", None),
        ] {
            let expected = clear.map(|clear| Role::Height { clear });
            let found = Role::of(&Field { text: name, start: 0 });
            assert_eq!(Some(found).filter(|role| matches!(role, Role::Height { .. })), expected, "{name}: {found:?}");
        }
    }
}
