//! The fields of a line, and which of them are numbers.

use std::borrow::Cow;

use super::groups::has_certain_groups;
use crate::text::place::{Diagnostic, Source};

/// Longest line that is read, in bytes; a row of a thousand columns is a third of it.
pub(super) const LONGEST_LINE: usize = 65_536;

/// A field: its text without blanks and quotes around it, and where it starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Field<'a> {
    pub(super) text: &'a str,
    pub(super) start: usize,
}

impl Field<'_> {
    pub(super) fn refused(&self, source: Source<'_>, message: impl Into<String>) -> Box<Diagnostic> {
        source.diagnostic(self.start..self.start + self.text.len(), "", message)
    }
}

/// What separates the fields.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Delimiter {
    Char(char),
    Blanks,
}

impl Delimiter {
    /// The first of tab, semicolon, upright stroke, comma that occurs outside quotes, else blanks. Commas between digits of numbers that
    /// blanks separate (`1,5 2,5`, `P1 1,5 2,5`) are decimal.
    pub(super) fn of(line: &str) -> Self {
        let outside: String = line.split('"').step_by(2).collect();
        let delimiter = ['\t', ';', '|', ','].into_iter().find(|&c| outside.contains(c));
        let decimal = || {
            let mut words = line.split_whitespace();
            let commas = words.clone().filter(|w| has_decimal_comma(w)).count();
            words.clone().nth(1).is_some()
                && (commas > 1 || words.all(|w| has_decimal_comma(w) || w.parse::<f64>().is_ok()))
        };
        match delimiter {
            Some(',') if decimal() => Self::Blanks,
            found => found.map_or(Self::Blanks, Self::Char),
        }
    }

    /// True for a `#` of a name (`Pt#2`, `Point #` before the next field), which starts no remark.
    fn belongs_to_a_name(self, before: &str, after: &str) -> bool {
        let field_ends = matches!(self, Self::Char(_)) && after.starts_with(|c| self.separates(c));
        before.ends_with(char::is_alphabetic) || field_ends && !before.trim().is_empty()
    }

    fn separates(self, c: char) -> bool {
        match self {
            Self::Char(delimiter) => c == delimiter,
            // Other blanks may stand in numbers, between thousands.
            Self::Blanks => c.is_ascii_whitespace(),
        }
    }

    /// Appends the fields of a line that starts at byte `start` of the text, up to a remark. Quotes count at the start of
    /// a field; the error is the place of one that has no end.
    pub(super) fn split<'a>(self, line: &'a str, start: usize, out: &mut Vec<Field<'a>>) -> Result<(), usize> {
        let mut push = |from: usize, to: usize| {
            let piece = &line[from..to];
            let trimmed = piece.trim();
            let lead = piece.len() - piece.trim_start().len();
            let inner = trimmed.strip_prefix('"').and_then(|t| t.strip_suffix('"'));
            let text = inner.unwrap_or(trimmed);
            out.push(Field { text, start: start + from + lead + usize::from(inner.is_some()) });
        };
        let keeps_empty = matches!(self, Self::Char(_));
        let mut from = keeps_empty.then_some(0);
        let mut fresh = true;
        let mut end = line.len();
        let mut chars = line.char_indices().peekable();
        while let Some((at, c)) = chars.next() {
            if c == '#' && !self.belongs_to_a_name(&line[..at], &line[at + 1..]) {
                end = at;
                break;
            }
            if self.separates(c) {
                if let Some(from) = from {
                    push(from, at);
                }
                from = keeps_empty.then_some(at + c.len_utf8());
                fresh = true;
                continue;
            }
            from = from.or(Some(at));
            if fresh && c == '"' {
                loop {
                    match chars.next() {
                        None => return Err(start + at),
                        Some((_, '"')) if chars.next_if(|(_, c)| *c == '"').is_none() => break,
                        Some(_) => {}
                    }
                }
            }
            fresh &= c.is_whitespace();
        }
        if let Some(from) = from {
            push(from, end);
        }
        Ok(())
    }
}

/// A message about the fields of a line.
pub(super) fn about(source: Source<'_>, fields: &[Field<'_>], message: impl Into<String>) -> Box<Diagnostic> {
    let span = match fields {
        [first, .., last] => first.start..last.start + last.text.len(),
        [only] => only.start..only.start + only.text.len(),
        [] => 0..0,
    };
    source.diagnostic(span, "", message)
}

/// Replaces `fields` by those of a line.
pub(super) fn split<'a>(
    source: Source<'a>,
    delimiter: Delimiter,
    start: usize,
    line: &'a str,
    fields: &mut Vec<Field<'a>>,
) -> Result<(), Box<Diagnostic>> {
    fields.clear();
    refuse_long(source, start, line)?;
    delimiter.split(line, start, fields).map_err(|quote| {
        let message = "the quote has no end on this line: fields with line breaks are not supported";
        source.diagnostic(quote..quote + 1, "", message)
    })
}

fn refuse_long(source: Source<'_>, start: usize, line: &str) -> Result<(), Box<Diagnostic>> {
    if line.len() <= LONGEST_LINE {
        return Ok(());
    }
    let message = format!("the line has {} bytes, maximum {LONGEST_LINE}", line.len());
    Err(source.diagnostic(start..start + 1, "", message))
}

/// True for a number with a decimal comma between digits: `-1,5`, `0,25e3`.
pub(super) fn has_decimal_comma(text: &str) -> bool {
    let Some((whole, fraction)) = text.split_once(',') else { return false };
    whole.ends_with(|c: char| c.is_ascii_digit())
        && fraction.starts_with(|c: char| c.is_ascii_digit())
        && text.replacen(',', ".", 1).parse::<f64>().is_ok()
}

/// A number with the minus of typographers as programs write it.
pub(super) fn plain_sign(text: &str) -> Cow<'_, str> {
    match text.strip_prefix('\u{2212}') {
        Some(rest) => Cow::Owned(format!("-{rest}")),
        None => Cow::Borrowed(text),
    }
}

/// True for the texts that stand for a number, NaN and infinity included: those belong to data, not to a header.
pub(super) fn is_number(field: &Field<'_>) -> bool {
    let text = plain_sign(field.text);
    text.parse::<f64>().is_ok() || has_decimal_comma(&text) || has_certain_groups(&text)
}
