//! The words of a name, whatever their letters.

/// The words of a name in small letters, without accents.
pub(super) fn folded(name: &str) -> Vec<String> {
    let words = name.split(|c: char| !c.is_alphanumeric() && !is_accent(c)).filter(|word| !word.is_empty());
    words
        .flat_map(by_capitals)
        .map(|word| word.chars().flat_map(char::to_lowercase).filter(|c| !is_accent(*c)).map(plain).collect())
        .collect()
}

/// The words that capitals begin: `NorthUSft`, `pointX`. One letter (`mN`) is no word of its own.
pub(super) fn by_capitals(word: &str) -> Vec<&str> {
    let letters: Vec<(usize, char)> = word.char_indices().collect();
    let (mut words, mut from) = (Vec::new(), 0);
    for pair in letters.windows(2) {
        let ((_, before), (at, c)) = (pair[0], pair[1]);
        if before.is_lowercase() && c.is_uppercase() && word[from..at].chars().count() > 1 {
            words.push(&word[from..at]);
            from = at;
        }
    }
    words.push(&word[from..]);
    words
}

/// Accents that stand behind their letter.
fn is_accent(c: char) -> bool {
    matches!(c, '\u{300}'..='\u{36f}')
}

/// A letter without its accent.
const fn plain(c: char) -> char {
    match c {
        'à' | 'á' | 'â' | 'ä' | 'ã' | 'å' | 'ą' | 'ă' => 'a',
        'è' | 'é' | 'ê' | 'ë' | 'ę' | 'ě' => 'e',
        'ì' | 'í' | 'î' | 'ï' | 'ı' => 'i',
        'ò' | 'ó' | 'ô' | 'ö' | 'õ' | 'ø' | 'ő' => 'o',
        'ù' | 'ú' | 'û' | 'ü' | 'ů' | 'ű' => 'u',
        'ý' => 'y',
        'ñ' | 'ń' => 'n',
        'ç' | 'ć' | 'č' => 'c',
        'ś' | 'š' | 'ş' | 'ș' => 's',
        'ź' | 'ż' | 'ž' => 'z',
        'ł' => 'l',
        'ř' => 'r',
        'ğ' => 'g',
        'ț' => 't',
        other => other,
    }
}
