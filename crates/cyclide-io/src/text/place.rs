//! Places in a text and the messages that show them: file, line, column, the line itself and a caret.

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

use crate::text::escape::escaped;
use crate::text::lines::line_ends;

/// A text with the name under which messages speak of it.
///
/// ```
/// use cyclide_io::text::Source;
/// let source = Source { name: "p.csv", text: "1,2\n3;4\n" };
/// let message = source.diagnostic(5..6, "", "a comma is needed");
/// assert!(message.to_string().contains("p.csv:2:2"));
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    /// Name of the file.
    pub name: &'a str,
    /// Its text.
    pub text: &'a str,
}

/// A refused piece of input text: where it is, what is wrong with it, and the line it stands on.
///
/// Displayed as `file:line:column: path: message`, then the line with carets under the piece.
///
/// ```
/// use cyclide_io::text::Source;
/// let source = Source { name: "p.csv", text: "1,2\n3;4\n" };
/// let message = source.diagnostic(5..6, "", "a comma is needed");
/// assert!(message.to_string().contains("p.csv:2:2"));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Name of the file.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Path inside a document (`objects.track.points[3]`); empty where there is none.
    pub path: String,
    /// What is wrong.
    pub message: String,
    /// The stable name of the kernel's reason, if the kernel refused it.
    pub reason: Option<&'static str>,
    snippet: Snippet,
}

/// Part of a line and the piece of it to underline.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Snippet {
    text: String,
    skip: usize,
    width: usize,
}

/// Longest part of a line shown before and after the piece, in characters.
const CONTEXT: usize = 48;
/// Longest underlined piece shown, in characters.
const MAX_UNDERLINE: usize = 40;

impl<'a> Source<'a> {
    /// The message about the bytes `span` of the text (clipped to the text; only its first line is shown).
    #[must_use]
    pub fn diagnostic(self, span: Range<usize>, path: &str, message: impl Into<String>) -> Box<Diagnostic> {
        let start = self.boundary(span.start);
        let line_start = self.text[..start].rfind(['\n', '\r']).map_or(0, |i| i + 1);
        let line_end = self.text[start..].find(['\n', '\r']).map_or(self.text.len(), |i| start + i);
        let end = self.boundary(span.end).clamp(start, line_end.max(start));
        // A line may be as long as the file: only what is shown is taken out of it.
        let before = &self.text[line_start..start];
        let shown: Vec<char> = before.chars().rev().take(CONTEXT).collect();
        let piece: Vec<char> = self.text[start..end].chars().take(MAX_UNDERLINE + 1).collect();
        let after = self.text[end..line_end.max(end)].chars();
        let width = piece.len().min(MAX_UNDERLINE);
        let tail = if piece.len() > width { 0 } else { CONTEXT };
        let [before_it, piece, after] = [
            shown.iter().rev().copied().collect::<String>(),
            piece[..width].iter().collect(),
            after.take(tail).collect(),
        ]
        .map(|part| on_the_line(&part));
        let count = |part: &str| part.chars().count();
        Box::new(Diagnostic {
            file: self.name.to_owned(),
            line: 1 + line_ends(&self.text[..line_start]),
            column: 1 + before.chars().count(),
            path: path.to_owned(),
            message: escaped(&message.into()).into_owned(),
            reason: None,
            snippet: Snippet {
                skip: count(&before_it),
                width: count(&piece).max(1),
                text: before_it + &piece + &after,
            },
        })
    }

    /// Line of a byte offset, from 1.
    #[must_use]
    pub fn line_of(self, offset: usize) -> usize {
        1 + line_ends(&self.text[..self.boundary(offset)])
    }

    /// The character that holds the byte before an offset; empty at the start of the text.
    pub(crate) fn character_before(self, offset: usize) -> Range<usize> {
        let start = self.boundary(offset.saturating_sub(1));
        let width = self.text[start..].chars().next().map_or(0, char::len_utf8);
        start..start + if offset == 0 { 0 } else { width }
    }

    /// The nearest character boundary at or before an offset.
    fn boundary(self, offset: usize) -> usize {
        let mut at = offset.min(self.text.len());
        while !self.text.is_char_boundary(at) {
            at -= 1;
        }
        at
    }
}

impl Diagnostic {
    /// Attaches the kernel's reason.
    #[must_use]
    pub fn with_reason(mut self: Box<Self>, reason: &'static str) -> Box<Self> {
        self.reason = Some(reason);
        self
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}: ", escaped(&self.file), self.line, self.column)?;
        if !self.path.is_empty() {
            write!(f, "{}: ", escaped(&self.path))?;
        }
        write!(f, "{}", self.message)?;
        if let Some(reason) = self.reason {
            write!(f, " [{reason}]")?;
        }
        let Snippet { text, skip, width } = &self.snippet;
        if text.trim().is_empty() {
            return Ok(());
        }
        let margin = self.line.to_string();
        let blank = " ".repeat(margin.len());
        write!(f, "\n  {margin} | {}", text.trim_end())?;
        write!(f, "\n  {blank} | {}{}", " ".repeat(*skip), "^".repeat(*width))
    }
}

impl std::error::Error for Diagnostic {}

/// A part of a line as it is shown: a tab takes one column, and nothing moves the caret or is not seen.
fn on_the_line(text: &str) -> String {
    escaped(&text.replace('\t', " ")).into_owned()
}

/// What messages quote of an input at most, in characters.
const QUOTED: usize = 60;

/// A piece of the input as a message quotes it: cut where it is long.
pub(crate) fn quoted(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(QUOTED) {
        None => Cow::Borrowed(text),
        Some((end, _)) => Cow::Owned(format!("{}…", &text[..end])),
    }
}

/// Bytes in which zeros tell that a text is not in UTF-8.
const HEAD: usize = 4096;

/// The text of bytes that must be UTF-8, without a byte-order mark.
///
/// ```
/// assert_eq!(cyclide_io::text::decode("a.csv", b"\xef\xbb\xbf1,2")?.trim_start_matches('\u{feff}'), "1,2");
/// assert!(cyclide_io::text::decode("a.csv", b"\xff\xff").is_err());
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
///
/// # Errors
/// A message with the place of the first byte that is not UTF-8, or about UTF-16, with its mark or without.
pub fn decode<'a>(name: &str, bytes: &'a [u8]) -> Result<&'a str, Box<Diagnostic>> {
    let source = |text: &'a str| Source { name, text };
    if bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF]) {
        return Err(source("").diagnostic(0..0, "", "the file is UTF-16; save it as UTF-8"));
    }
    // Latin letters and digits in UTF-16 are valid UTF-8 with zeros between them.
    if let [first, second, ..] = bytes
        && (*first == 0) != (*second == 0)
    {
        return Err(source("").diagnostic(
            0..0,
            "",
            "the file seems to be UTF-16 (every other byte is 0); save it as UTF-8",
        ));
    }
    if bytes[..bytes.len().min(HEAD)].contains(&0) {
        return Err(source("").diagnostic(0..0, "", "the file is not text: it holds zero bytes"));
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(text.strip_prefix('\u{feff}').unwrap_or(text)),
        Err(error) => {
            let good = error.valid_up_to();
            let text = std::str::from_utf8(&bytes[..good]).unwrap_or_default();
            Err(source(text).diagnostic(good..good, "", format!("byte {:#04x} is not UTF-8 text", bytes[good])))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn caret_stands_under_the_piece() {
        let source = Source { name: "a.json", text: "{\r\n\t\"é\": 12,\r\n}" };
        let at = source.text.find("12").unwrap();
        let d = source.diagnostic(at..at + 2, "objects.x", "wrong");
        assert_eq!((d.line, d.column), (2, 7));
        assert_eq!(d.to_string(), "a.json:2:7: objects.x: wrong\n  2 |  \"é\": 12,\n    |       ^^");
    }

    #[test]
    fn long_lines_are_clipped_around_the_piece() {
        let text = format!("{}BAD{}", "x".repeat(1000), "y".repeat(1000));
        let shown = Source { name: "f", text: &text }.diagnostic(1000..1003, "", "m").to_string();
        assert!(shown.lines().all(|l| l.chars().count() < 2 * CONTEXT + 20), "{shown}");
        assert!(shown.contains("f:1:1001: m"));
        assert!(shown.ends_with("^^^"));
    }

    #[test]
    fn offsets_outside_the_text_are_clipped() {
        let source = Source { name: "f", text: "é" };
        assert_eq!(source.diagnostic(1..99, "", "m").column, 1);
        assert_eq!(source.diagnostic(99..100, "", "m").column, 2);
    }

    #[test]
    fn bytes_that_are_not_text_are_refused_with_their_place() {
        let d = decode("f.csv", b"1,2\n3,\xff").unwrap_err();
        assert_eq!((d.line, d.column), (2, 3));
        assert_eq!(decode("f", b"\xef\xbb\xbf1,2").unwrap(), "1,2");
        for utf16 in [&b"\xff\xfe1\0"[..], b"1\0,\0", b"\x001\0,"] {
            assert!(decode("f", utf16).unwrap_err().message.contains("UTF-16"));
        }
        assert!(decode("f", b"ab\0\0").unwrap_err().message.contains("not text"));
    }

    #[test]
    fn a_line_as_long_as_the_file_costs_its_bytes_only() {
        let text = format!("{}BAD", "x".repeat(30_000_000));
        let at = text.len() - 3;
        // Anything that grows faster than the text does not come back with 30 MB.
        let d = Source { name: "f", text: &text }.diagnostic(at..at + 3, "", "m");
        assert_eq!((d.line, d.column), (1, at + 1));
    }

    #[test]
    fn lone_carriage_returns_end_lines() {
        let d = Source { name: "f", text: "1\r2\r\n3\rBAD\r5" }.diagnostic(7..10, "", "m");
        assert_eq!((d.line, d.column), (4, 1));
        assert_eq!(d.to_string(), "f:4:1: m\n  4 | BAD\n    | ^^^");
    }

    #[test]
    fn messages_are_one_line_whatever_they_quote() {
        let d = Source { name: "f", text: "a" }.diagnostic(0..1, "", "`\u{1b}[2J\n` is no word");
        assert_eq!(d.message, "`\\u{1b}[2J\\n` is no word");
    }

    #[test]
    fn carets_stand_under_pieces_with_hidden_characters() {
        let source = Source { name: "gnp.\u{202e}csv", text: "\u{202e}1,\u{200b}x,2" };
        let at = source.text.find('\u{200b}').unwrap();
        let d = source.diagnostic(at..at + 4, "a\u{1b}b", "wrong");
        let shown = "gnp.\\u{202e}csv:1:4: a\\u{1b}b: wrong\n  1 | \\u{202e}1,\\u{200b}x,2\n    |           ^^^^^^^^^";
        assert_eq!(d.to_string(), shown);
    }

    #[test]
    fn what_messages_quote_is_cut() {
        assert_eq!(quoted("short"), "short");
        assert_eq!(quoted(&"é".repeat(1000)).chars().count(), QUOTED + 1);
    }
}
