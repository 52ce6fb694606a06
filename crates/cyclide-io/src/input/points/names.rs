//! What the name of a column says: the words of surveying, maps and CAD in English, German, French, Italian, Spanish and Portuguese.

use super::fields::Field;
use super::height_words::{height_in, is_height, is_system};
use super::unit::unit_in_name;
use super::words::folded;

/// What a column is by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// The x coordinate of maps. `clear` is false for letters that may mean something else.
    East {
        clear: bool,
    },
    /// The y coordinate of maps.
    North {
        clear: bool,
    },
    /// A height over the map. `clear` is false for what may be the height of something that is no point.
    Height {
        clear: bool,
    },
    /// Abscissa and ordinate.
    Abscissa,
    Ordinate,
    /// An axis by its letter: see [`axis_kind`].
    Axis,
    /// What a point is called, or its number.
    Label,
    /// Something else that has numbers: times, stations, distances, angles, qualities.
    Other,
    /// Not known.
    Unknown,
}

const EAST: &str = "e me east easting eastings rechtswert rechtsw rechts rw ost ostwert ostkoordinate osten ostlich oestlich est este oest leste lest \
    oost oostelijk rechtswerte";
const NORTH: &str = "n mn north northing northings hochwert hochw hoch hw nord nordwert nordkoordinate norden nordlich noerdlich norte \
    noord noordelijk hochwerte";
const ABSCISSA: &str = "abscissa abscisse abscisses ascissa abscisa abszisse";
const ORDINATE: &str = "ordinate ordonnee ordonnees ordinata ordenada";

/// Words of which the names of numbers and codes of points are made, alone (`Nr.`), beside each other (`Lfd. Nr.`) or joined
/// (`Punktnummer`).
const LABEL: &str = "no nr nro num numb nums number numbers numero numeros nummer nummern nº n° nø nokta cislo bodu punkty punktu id ids ident identifier fid oid gid uid \
    uuid guid pid key index indice idx ix row line seq sequence secuencia sequenza order ordre orden ordine count counter \
    lfd laufende pos point points pointe pt pts pnt pkt punkt punkte punto punti puntos pto vertex vertices vert vertice \
    vertici node nodes knoten noeud nodo sommet matricule matricola matricula bezeichnung kennung name names nom nombre \
    nome label labels etiquette etiqueta etichetta tag marker target ziel ref reference referenz referencia riferimento \
    site waypoint wp wpt feature object objekt record rec sample measurement messung mesure sr sl serial ser item shot peg \
    borne piquet picchetto estaca mojon p sno marke stutz grenz fest satz zeile ligne linea riga fila vermessungs pose ponto pontos";

/// Bytes of the longest word that is looked through for them.
const LONGEST_LABEL: usize = 100;

/// Words that stand beside them and say nothing.
const FILLERS: &str = "of de du des di del della delle the der le la el il d";

/// Words of columns that have numbers which are no coordinates.
const OTHER: &str = "station stations stationing stationierung stazione estacion sta chainage ch km kp mp pk pr kilometer kilometre \
    kilometrage kilometrierung progressiva progressive progressivo mileage milepost distance distancia distanza dist strecke strecken schragstrecke \
    schraegstrecke horizontalstrecke \
    distanz abstand entfernung cumul cumulative offset offsets versatz deport time timestamp t stamp date datum fecha data \
    heure hora ora uhrzeit zeit temps tiempo tempo epoch week secs nsecs hz vz sd hd vd azimuth azimut bearing heading \
    course kurs richtung gisement winkel angle angolo angulo zenith tilt speed velocity geschwindigkeit vitesse velocidad \
    velocita hdop pdop vdop gdop dop sats satellites fix quality qual accuracy acc genauigkeit precision precisione sigma \
    std stdev stddev error err rms hrms vrms rmse cq hcq vcq undulation separation drms residual weight gewicht poids temperature temp intensity epsg \
    srid zone cant curvature length lange laenge width breite radius radio rayon raggio westing westings southing \
    southings west south ouest sud suden oeste sur ovest westen code codigo codice kode desc description descripcion \
    descrizione beschreibung remark remarks remarque comment comments commentaire kommentar bemerkung bemerkungen note \
    notes nota notas type typ tipo art layer ebene calque capa class klasse classe clase group gruppe color colour farbe \
    couleur contour corner part polyline ring";

/// Words of maps and reference systems that may stand beside a coordinate or a height; words with a digit are such too.
const BESIDE_MAP: &str = "utm grid map gk lambert nad nn nhn mga ngf igm ign local lokal locale ellipsoidal ellipsoidisch orthometric ellip ell \
    ortho u ue uber ueber m nap false state plane reduced msl amsl ahd gauss kruger boaga";

/// Words before the last one of a unit.
const BEFORE_UNIT: &str = "us u s survey international intl int in";

/// Words behind a unit that say which foot it is: `ft (US survey)`.
const BEHIND_UNIT: &str = "us u s survey international intl int";

/// Words beside the letter of an axis: `point_x`, `x coordinate`.
const BESIDE: &str = "coord coords coordinate coordinates coor coordenada coordonnee coordinata koordinate koord wert value valor valeur \
    valore point pt pos position p loc location axis achse";

/// True for a word of a list.
fn is_among(list: &str, word: &str) -> bool {
    list.split(' ').any(|own| own == word)
}

impl Role {
    /// By a name, with whatever stands beside it.
    pub(super) fn of(field: &Field<'_>) -> Self {
        let raw = field.text.trim();
        // `N°` is a number, not a north, and so is `#`, or no name beside names.
        let mut start = raw.chars().map(|c| c.to_ascii_lowercase());
        if raw.is_empty() || raw.starts_with(['#', '\u{2116}']) {
            return Self::Label;
        }
        if start.next() == Some('n')
            && matches!(start.next(), Some('\u{b0}' | '\u{ba}' | '\u{2da}' | '\u{f8}' | '\u{a1}'))
        {
            return Self::Label;
        }
        let (words, unit) = words_of(raw);
        let words: Vec<&str> = words[..words.len() - usize::from(unit)].iter().map(String::as_str).collect();
        let has_digit = |word: &str| word.chars().any(|c| c.is_ascii_digit());
        let beside =
            |word: &str| is_among(BESIDE, word) || is_among(BESIDE_MAP, word) || is_system(word) || has_digit(word);
        let own: Vec<&str> = match words.as_slice() {
            [only] => vec![*only],
            several => several.iter().copied().filter(|word| !beside(word)).collect(),
        };
        // `Rechtswert (Y)`: the word of the map counts, not the letter beside it.
        let is_axis = |word: &&&str| matches!(**word, "x" | "y" | "z");
        let spoken: Vec<&str> = own.iter().filter(|word| !is_axis(word)).copied().collect();
        if let [word] = spoken.as_slice() {
            let (is, clear) = (|list: &str| is_among(list, word), word.len() > 1);
            // A letter beside the letter of an axis is anything.
            if clear || own.len() == 1 {
                if is(EAST) {
                    return Self::East { clear };
                } else if is(NORTH) {
                    return Self::North { clear };
                } else if is_height(word) && !own.iter().any(|word| matches!(*word, "x" | "y")) {
                    return Self::Height { clear: true };
                } else if is(ABSCISSA) {
                    return Self::Abscissa;
                } else if is(ORDINATE) {
                    return Self::Ordinate;
                }
            }
        }
        if ["x", "y", "z"].iter().any(|letter| axis_kind(letter, field).is_some()) {
            return Self::Axis;
        }
        if is_label(&words) {
            return Self::Label;
        }
        if words.iter().any(|word| is_among(OTHER, word)) {
            return Self::Other;
        }
        let says_nothing = |word: &str| beside(word) || is_among(FILLERS, word);
        height_in(&words, says_nothing).map_or(Self::Unknown, |clear| Self::Height { clear })
    }

    /// True for a coordinate, or what a point is called: words that titles rarely have.
    pub(super) const fn is_of_points(self) -> bool {
        !matches!(self, Self::Unknown | Self::Other)
    }

    /// True for what is a coordinate of a map, or an abscissa: nothing but its partner goes with it.
    pub(super) const fn is_of_a_pair(self) -> bool {
        matches!(self, Self::East { clear: true } | Self::North { clear: true } | Self::Abscissa | Self::Ordinate)
    }
}

/// True for a word that names a grid or a reference system, or has its number.
pub(super) fn is_of_system(word: &str) -> bool {
    is_among(BESIDE_MAP, word) || is_among(BESIDE, word) || word.chars().any(|c| c.is_ascii_digit())
}

/// True if words are those of numbers and names of points.
fn is_label(words: &[&str]) -> bool {
    let own: Vec<&str> = words.iter().copied().filter(|word| !is_among(FILLERS, word)).collect();
    // `P1`, the name of a point, is no name of a column of them; long words would take long.
    let short = own.iter().all(|word| word.len() <= LONGEST_LABEL);
    !own.is_empty() && short && own.iter().all(|word| is_made_of_labels(word))
}

/// True if a word is one of those of labels, or several of them joined.
fn is_made_of_labels(word: &str) -> bool {
    let whole = |rest: &str| is_among(LABEL, rest);
    // Joined words are long enough not to be met by chance.
    whole(word)
        || (1..word.len())
            .filter(|at| word.is_char_boundary(*at))
            .any(|at| at > 1 && word.len() - at > 1 && whole(&word[..at]) && is_made_of_labels(&word[at..]))
}

/// True if a word of a column's name is one of these, or ends in a long one: `lat_deg`, `X (Longitude)`, `GPSLatitude`.
pub(super) fn speaks_of(words: &[&str], field: &Field<'_>) -> bool {
    let known = |word: &String| words.iter().any(|w| word == w || w.len() > 6 && word.ends_with(w));
    folded(field.text).iter().any(known)
}

/// How a column's name speaks of an axis: `x` (0), `x_m` or `x coordinate` (1), `x_left` (2), `point_x` (3).
pub(super) fn axis_kind(letter: &str, field: &Field<'_>) -> Option<usize> {
    let (words, unit) = words_of(field.text);
    let beside = |word: &String| is_among(BESIDE, word.as_str());
    // `UTM_Y`, `Local X`: the letter is that of the map.
    let before_it = |word: &String| beside(word) || is_among(BESIDE_MAP, word.as_str());
    let joined =
        |word: &str| BESIDE.split(' ').any(|b| word == format!("{letter}{b}") || word == format!("{b}{letter}"));
    match words.as_slice() {
        [only] if only == letter => Some(0),
        [first, _] if first == letter && unit => Some(1),
        [first, second, ..] if first == letter && beside(second) => Some(1),
        [first, ..] if first == letter => Some(2),
        [before, last] if before_it(before) && last == letter => Some(3),
        [before, last, _] if before_it(before) && last == letter && unit => Some(3),
        [first, ..] if joined(first) => Some(3),
        _ => None,
    }
}

/// The words of a column's name in small letters without accents, and whether the last is a unit: one word of it, where it has several.
pub(super) fn words_of(name: &str) -> (Vec<String>, bool) {
    let mut words = folded(name);
    let unit = words.len() > 1 && unit_in_name(name).is_some();
    if unit {
        while words.len() > 2 && words.last().is_some_and(|word| is_among(BEHIND_UNIT, word)) {
            words.pop();
        }
        // `(US survey ft)`, `in m`.
        while words.len() > 2 && is_among(BEFORE_UNIT, &words[words.len() - 2]) {
            words.remove(words.len() - 2);
        }
    }
    (words, unit)
}

/// True if a name is this letter alone, or with its unit.
pub(super) fn is_letter(letter: &str, field: &Field<'_>) -> bool {
    let (words, unit) = words_of(field.text);
    words.len() == 1 + usize::from(unit) && words[0] == letter
}

#[cfg(test)]
mod tests {
    use super::*;

    fn role(text: &str) -> Role {
        Role::of(&Field { text, start: 0 })
    }

    #[test]
    fn numbers_and_names_of_points_are_known_in_five_languages() {
        for name in [
            "N°",
            "n° point",
            "Nº",
            "No.",
            "Nr.",
            "NR",
            "Num.",
            "Num. punto",
            "Pkt",
            "Pkt.-Nr.",
            "PktNr",
            "Punkt",
            "Punktnummer",
            "Punkt-Nr",
            "Punktnr.",
            "Punktbezeichnung",
            "Lfd. Nr.",
            "lfdnr",
            "OBJECTID",
            "FID",
            "ID",
            "id_point",
            "PtID",
            "Point ID",
            "PointNumber",
            "Pt No",
            "Pt#",
            "#",
            "",
            "Vertex",
            "vertex_index",
            "seq",
            "Matricule",
            "Punto",
            "Numéro",
            "Número",
            "Nombre",
            "idx",
            "index",
            "Name",
            "Numero punto",
            "Knoten",
            "Stützpunkt",
            "Grenzpunkt",
            "Sr. No.",
            "S.No.".trim_start_matches("S."),
            "Waypoint",
            "Id. del punto",
        ] {
            assert_eq!(role(name), Role::Label, "{name}");
        }
        for name in [
            "Station",
            "station_m",
            "Chainage",
            "km",
            "KM",
            "PK",
            "Pk (km)",
            "t",
            "Time",
            "Progressiva",
            "Distance",
            "HDOP",
            "Code",
            "Southing",
            "Hz",
            "Stationierung",
        ] {
            assert_eq!(role(name), Role::Other, "{name}");
        }
    }

    #[test]
    fn coordinates_of_maps_are_known_in_five_languages() {
        for name in [
            "Easting",
            "EAST",
            "East (m)",
            "Rechtswert",
            "Rechtswert (Y)",
            "Y (Rechtswert)",
            "Ost",
            "Ostwert",
            "Est",
            "Este",
            "Coord. Este",
            "Easting_ETRS89",
            "UTM East",
            "Leste",
            "Coord. Est",
            "Östlich",
            "Oestlich [m]",
            "Osten",
            "Oost",
            "Easting (ft (US survey))",
            "East (int ft)",
        ] {
            assert_eq!(role(name), Role::East { clear: true }, "{name}");
        }
        for name in [
            "Northing",
            "Hochwert",
            "Hochwert X",
            "Nord",
            "Norte",
            "Coordenada Norte",
            "North_ft",
            "Nördlich",
            "NOERDLICH",
            "Norden",
            "Coordonnée Nord",
            "Northing (US survey ft)",
            "North ft (int)",
        ] {
            assert_eq!(role(name), Role::North { clear: true }, "{name}");
        }
        for name in [
            "Elevation",
            "Elev.",
            "Höhe",
            "HOEHE",
            "Höhe ü. NN",
            "Altitude",
            "Quota",
            "Cota",
            "RL",
            "Level",
            "H",
            "Altura",
            "Ho\u{308}he",
            "Cote NGF",
        ] {
            assert_eq!(role(name), Role::Height { clear: true }, "{name}");
        }
        assert_eq!((role("NorthUSft"), role("eastM")), (Role::North { clear: true }, Role::East { clear: true }));
        assert_eq!((role("E"), role("n")), (Role::East { clear: false }, Role::North { clear: false }));
        assert_eq!((role("Abscisse"), role("Ordonnée")), (Role::Abscissa, Role::Ordinate));
        for name in [
            "x",
            "X_m",
            "POINT_X",
            "Koordinate Y",
            "xcoord",
            "Y-Wert",
            "z [mm]",
            "COORD_X",
            "x_left",
            "UTM_Y",
            "Local X",
            "grid_x_m",
        ] {
            assert_eq!(role(name), Role::Axis, "{name}");
        }
        for name in ["u", "foo", "a", "merkmal", "xylem", "nord est"] {
            assert_eq!(role(name), Role::Unknown, "{name}");
        }
    }
}
