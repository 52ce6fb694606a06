//! What terminals act on, or do not show, made visible: names, messages and pieces of files may hold it.
//!
//! Control characters move the cursor and change colors, bidirectional controls show a text in another order than it has, and
//! format characters are not seen at all. Each is shown by its number, as in Rust: `\u{202e}`.

use std::borrow::Cow;
use std::fmt::Write as _;

/// Ranges of what is shown by its number: the categories Cc, Cf, Zl and Zp of Unicode 16, and what else is ignored where it
/// cannot be displayed (`Default_Ignorable_Code_Point`: fillers, variation selectors).
const HIDDEN: [(char, char); 27] = [
    ('\0', '\u{1f}'),
    ('\u{7f}', '\u{9f}'),
    ('\u{ad}', '\u{ad}'),
    ('\u{34f}', '\u{34f}'),
    ('\u{600}', '\u{605}'),
    ('\u{61c}', '\u{61c}'),
    ('\u{6dd}', '\u{6dd}'),
    ('\u{70f}', '\u{70f}'),
    ('\u{890}', '\u{891}'),
    ('\u{8e2}', '\u{8e2}'),
    ('\u{115f}', '\u{1160}'),
    ('\u{17b4}', '\u{17b5}'),
    ('\u{180b}', '\u{180f}'),
    ('\u{200b}', '\u{200f}'),
    ('\u{2028}', '\u{202e}'),
    ('\u{2060}', '\u{206f}'),
    ('\u{3164}', '\u{3164}'),
    ('\u{fe00}', '\u{fe0f}'),
    ('\u{feff}', '\u{feff}'),
    ('\u{ffa0}', '\u{ffa0}'),
    ('\u{fff0}', '\u{fffb}'),
    ('\u{110bd}', '\u{110bd}'),
    ('\u{110cd}', '\u{110cd}'),
    ('\u{13430}', '\u{1343f}'),
    ('\u{1bca0}', '\u{1bca3}'),
    ('\u{1d173}', '\u{1d17a}'),
    ('\u{e0000}', '\u{e0fff}'),
];

/// True for a character that a terminal acts on or does not show.
fn is_hidden(c: char) -> bool {
    // Most text is ASCII.
    c < ' ' || c > '~' && HIDDEN.iter().any(|(first, last)| (*first..=*last).contains(&c))
}

/// A name or a piece of a file as one line of a message shows it: line ends and tabs too are escaped.
///
/// ```
/// assert_eq!(cyclide_io::text::escaped("gnp.\u{202e}exe\n"), r"gnp.\u{202e}exe\n");
/// assert_eq!(cyclide_io::text::escaped("Möbius"), "Möbius");
/// ```
#[must_use]
pub fn escaped(text: &str) -> Cow<'_, str> {
    with(text, |_| false, rust_escape)
}

/// A text of several lines as a terminal shows it: as [`escaped`], except for the line feeds.
///
/// ```
/// assert_eq!(cyclide_io::text::escaped_lines("one\n\u{1b}[2Jtwo\n"), "one\n\\u{1b}[2Jtwo\n");
/// ```
#[must_use]
pub fn escaped_lines(text: &str) -> Cow<'_, str> {
    with(text, |c| c == '\n', rust_escape)
}

/// A JSON text with the same characters escaped in its strings, as JSON does it: the value stays what it is.
///
/// ```
/// assert_eq!(cyclide_io::text::escaped_json("{\n\t\"a\": \"\u{202e}\u{e0041}\"}"), "{\n\t\"a\": \"\\u202e\\udb40\\udc41\"}");
/// ```
#[must_use]
pub fn escaped_json(text: &str) -> Cow<'_, str> {
    // Between its strings JSON has these alone.
    with(
        text,
        |c| matches!(c, '\n' | '\r' | '\t'),
        |out, c| {
            for unit in c.encode_utf16(&mut [0; 2]) {
                let _ = write!(out, "\\u{unit:04x}");
            }
        },
    )
}

fn rust_escape(out: &mut String, c: char) {
    match c {
        '\n' => out.push_str("\\n"),
        '\r' => out.push_str("\\r"),
        '\t' => out.push_str("\\t"),
        c => out.extend(c.escape_unicode()),
    }
}

fn with(text: &str, stays: fn(char) -> bool, escape: fn(&mut String, char)) -> Cow<'_, str> {
    let is_escaped = |c: char| is_hidden(c) && !stays(c);
    if !text.chars().any(is_escaped) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_escaped(c) { escape(&mut out, c) } else { out.push(c) }
    }
    Cow::Owned(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_hidden_character_is_shown() {
        // From the Unicode character database: controls, bidirectional controls, joiners, a mark of byte order, tags, fillers.
        let hidden = "\0\u{7}\u{1b}\u{7f}\u{85}\u{9b}\u{ad}\u{61c}\u{200b}\u{200d}\u{200e}\u{202a}\u{202e}\u{2028}\u{2060}\u{2066}\u{2069}\u{feff}\u{fffb}\u{e0001}\u{e007f}\u{3164}\u{fe0f}";
        for c in hidden.chars() {
            let shown = escaped(&c.to_string()).into_owned();
            assert_eq!(shown, format!("\\u{{{:x}}}", u32::from(c)));
            let json = format!("\"{}\"", escaped_json(&c.to_string()));
            assert!(json.is_ascii());
            assert_eq!(serde_json::from_str::<String>(&json).unwrap(), c.to_string());
        }
    }

    #[test]
    fn what_is_seen_stays_and_nothing_is_copied() {
        let text = "Dach/Süd ß 屋根 крыша سقف 🏠 e\u{301} “x” … ~";
        assert!(matches!(escaped(text), Cow::Borrowed(same) if same == text));
        assert!(matches!(escaped_lines("a\nb"), Cow::Borrowed(_)));
        // What has been escaped is not escaped again.
        assert_eq!(escaped(&escaped("\u{202e}")), "\\u{202e}");
    }
}
