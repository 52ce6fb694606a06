//! Names in letters that can be drawn: Cyrillic and Greek ones are transliterated, others are left out.
//!
//! Cyrillic after BGN/PCGN, simplified; Greek words after ISO 843, single Greek letters by their names, since they are
//! symbols.

use super::Letter;

/// Cyrillic letters.
const CYRILLIC: &[(char, &str)] = &[
    ('а', "a"),
    ('б', "b"),
    ('в', "v"),
    ('г', "g"),
    ('д', "d"),
    ('е', "e"),
    ('ё', "yo"),
    ('ж', "zh"),
    ('з', "z"),
    ('и', "i"),
    ('й', "y"),
    ('к', "k"),
    ('л', "l"),
    ('м', "m"),
    ('н', "n"),
    ('о', "o"),
    ('п', "p"),
    ('р', "r"),
    ('с', "s"),
    ('т', "t"),
    ('у', "u"),
    ('ф', "f"),
    ('х', "kh"),
    ('ц', "ts"),
    ('ч', "ch"),
    ('ш', "sh"),
    ('щ', "shch"),
    ('ъ', ""),
    ('ы', "y"),
    ('ь', ""),
    ('э', "e"),
    ('ю', "yu"),
    ('я', "ya"),
    ('і', "i"),
    ('ї', "yi"),
    ('є', "ye"),
    ('ґ', "g"),
    ('ў', "u"),
    ('ј', "j"),
    ('љ', "lj"),
    ('њ', "nj"),
    ('ћ', "c"),
    ('ђ', "dj"),
    ('џ', "dz"),
];

/// Greek letters in words, and by their names.
const GREEK: &[(char, &str, &str)] = &[
    ('α', "a", "alpha"),
    ('β', "v", "beta"),
    ('γ', "g", "gamma"),
    ('δ', "d", "delta"),
    ('ε', "e", "epsilon"),
    ('ζ', "z", "zeta"),
    ('η', "i", "eta"),
    ('θ', "th", "theta"),
    ('ι', "i", "iota"),
    ('κ', "k", "kappa"),
    ('λ', "l", "lambda"),
    ('μ', "m", "mu"),
    ('ν', "n", "nu"),
    ('ξ', "x", "xi"),
    ('ο', "o", "omicron"),
    ('π', "p", "pi"),
    ('ρ', "r", "rho"),
    ('σ', "s", "sigma"),
    ('ς', "s", "sigma"),
    ('τ', "t", "tau"),
    ('υ', "y", "upsilon"),
    ('φ', "f", "phi"),
    ('χ', "ch", "chi"),
    ('ψ', "ps", "psi"),
    ('ω', "o", "omega"),
    ('ά', "a", "alpha"),
    ('έ', "e", "epsilon"),
    ('ή', "i", "eta"),
    ('ί', "i", "iota"),
    ('ό', "o", "omicron"),
    ('ύ', "y", "upsilon"),
    ('ώ', "o", "omega"),
    ('ϊ', "i", "iota"),
    ('ϋ', "y", "upsilon"),
    ('ΐ', "i", "iota"),
    ('ΰ', "y", "upsilon"),
    ('ϕ', "f", "phi"),
    ('ϑ', "th", "theta"),
    ('ϵ', "e", "epsilon"),
];

/// Other letters and signs.
const OTHERS: &[(char, &str)] = &[
    ('Æ', "AE"),
    ('œ', "oe"),
    ('Œ', "OE"),
    ('đ', "d"),
    ('Đ', "D"),
    ('ð', "d"),
    ('Ð', "D"),
    ('þ', "th"),
    ('Þ', "Th"),
    ('ď', "d"),
    ('ť', "t"),
    ('ľ', "l"),
    ('Ľ', "L"),
    ('ħ', "h"),
    ('ŋ', "ng"),
    ('ſ', "s"),
    ('ẞ', "SS"),
    ('‘', "'"),
    ('‚', "'"),
    ('“', "\""),
    ('”', "\""),
    ('„', "\""),
    ('«', "\""),
    ('»', "\""),
    ('‐', "-"),
    ('‑', "-"),
    ('−', "-"),
    ('→', "->"),
    ('←', "<-"),
    ('⌀', "dia."),
    ('∅', "dia."),
    ('½', "1/2"),
    ('¼', "1/4"),
    ('¾', "3/4"),
    ('№', "No."),
    ('•', "·"),
    ('\u{a0}', " "),
    ('\t', " "),
];

/// A text in letters that can be drawn.
#[derive(Debug, PartialEq)]
pub(in crate::formats::png) struct Drawable {
    pub(in crate::formats::png) text: String,
    /// The letters that were left out.
    pub(in crate::formats::png) lost: String,
}

/// The text in letters that can be drawn; `None` if less than half of it can.
pub(in crate::formats::png) fn drawable(text: &str) -> Option<Drawable> {
    let chars: Vec<char> = text.chars().collect();
    let is_greek = |c: Option<&char>| c.is_some_and(|c| greek(*c).is_some());
    let (mut drawn, mut lost) = (0, String::new());
    let mut out = String::new();
    for (i, &c) in chars.iter().enumerate() {
        // A letter between others of its script is part of a word, one alone is a symbol.
        let alone = !is_greek(i.checked_sub(1).and_then(|i| chars.get(i))) && !is_greek(chars.get(i + 1));
        match replaced(c, alone) {
            Some(letters) => {
                drawn += usize::from(!letters.trim().is_empty());
                out += &letters;
            }
            // Marks that join the letter before them, and signs without a width.
            None if matches!(c, '\u{300}'..='\u{36f}' | '\u{200b}'..='\u{200f}' | '\u{fe00}'..='\u{fe0f}') => {}
            None => {
                lost.push(c);
                out.push(' ');
            }
        }
    }
    let words: Vec<&str> = out.split_whitespace().collect();
    (drawn > lost.chars().count()).then(|| Drawable { text: words.join(" "), lost })
}

fn replaced(c: char, alone: bool) -> Option<String> {
    if Letter::can_draw(c) && greek(c).is_none() {
        return Some(c.to_string());
    }
    if let Some((_, letters)) = OTHERS.iter().find(|(other, _)| *other == c) {
        return Some((*letters).to_owned());
    }
    let small = c.to_lowercase().next().unwrap_or(c);
    let letters = match CYRILLIC.iter().find(|(letter, _)| *letter == small) {
        Some((_, letters)) => letters,
        None => greek(c).map(|(word, name)| if alone { name } else { word })?,
    };
    let mut letters = letters.chars();
    let first = letters.next().map(|first| if c.is_uppercase() { first.to_ascii_uppercase() } else { first });
    Some(first.into_iter().chain(letters).collect())
}

/// A Greek letter in a word, and its name.
fn greek(c: char) -> Option<(&'static str, &'static str)> {
    let small = c.to_lowercase().next().unwrap_or(c);
    GREEK.iter().find(|(letter, ..)| *letter == small).map(|(_, word, name)| (*word, *name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_out_in_letters_that_can_be_drawn() {
        for (name, drawn) in [
            ("outer skin 2", Some("outer skin 2")),
            ("Łódź Søren Øre, Żółć", Some("Łódź Søren Øre, Żółć")),
            ("Привет мир", Some("Privet mir")),
            ("Щука и объём", Some("Shchuka i obyom")),
            ("ελληνικά", Some("ellinika")),
            ("angle φ2, Δ", Some("angle phi2, Delta")),
            ("emoji \u{1f680} rail", Some("emoji rail")),
            ("gold 金 ring", Some("gold ring")),
            ("cafe\u{301}", Some("cafe")),
            ("“a”→b", Some("\"a\"->b")),
            ("東京タワー", None),
            ("العربية", None),
            ("", None),
        ] {
            let found = drawable(name);
            assert_eq!(found.as_ref().map(|found| found.text.as_str()), drawn, "{name}");
            assert!(found.is_none_or(|found| found.text.chars().all(Letter::can_draw)), "{name}");
        }
        let lost = |name: &str| drawable(name).map(|found| found.lost);
        assert_eq!(lost("gold 金 ring"), Some("金".to_owned()));
        assert_eq!(lost("Łódź φ cafe\u{301}"), Some(String::new()));
    }
}
