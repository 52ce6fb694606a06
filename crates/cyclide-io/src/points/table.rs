//! Lines and fields of a delimited text, with the place of each field.

use crate::place::{Diagnostic, Source};
use crate::suggest::did_you_mean;

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

/// A line of data: which of the table's fields are its own, and which block between blank lines it stands in.
#[derive(Debug)]
pub(super) struct Row {
    first: usize,
    count: usize,
    end: usize,
    pub(super) block: usize,
}

impl Row {
    /// The message about the whole line.
    pub(super) fn refused(&self, source: Source<'_>, table: &Table<'_>, message: &str) -> Box<Diagnostic> {
        let start = table.fields(self).first().map_or(self.end, |f| f.start);
        source.diagnostic(start..self.end, "", message)
    }
}

/// The parsed text.
#[derive(Debug)]
pub(super) struct Table<'a> {
    /// Names of the columns; empty if the text has none.
    pub(super) header: Vec<Field<'a>>,
    /// Number of columns of the header, else of the first line of data.
    pub(super) width: usize,
    pub(super) rows: Vec<Row>,
    fields: Vec<Field<'a>>,
}

/// What separates the fields.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Delimiter {
    Char(char),
    Blanks,
}

impl Delimiter {
    /// The first of tab, semicolon, comma that occurs, else blanks.
    fn of(line: &str) -> Self {
        ['\t', ';', ','].into_iter().find(|&c| line.contains(c)).map_or(Self::Blanks, Self::Char)
    }

    /// Appends the fields of a line that starts at byte `start` of the text.
    fn split<'a>(self, line: &'a str, start: usize, out: &mut Vec<Field<'a>>) {
        let mut push = |from: usize, to: usize| {
            let piece = &line[from..to];
            let trimmed = piece.trim();
            let lead = piece.len() - piece.trim_start().len();
            let quoted = trimmed.strip_prefix('"').and_then(|t| t.strip_suffix('"'));
            let text = quoted.unwrap_or(trimmed);
            out.push(Field { text, start: start + from + lead + usize::from(quoted.is_some()) });
        };
        let (mut from, mut quoted) = (None, false);
        for (at, c) in line.char_indices() {
            let separates = match self {
                Self::Char(d) => c == d,
                Self::Blanks => c.is_whitespace(),
            };
            quoted ^= c == '"';
            match (self, separates && !quoted, from) {
                (Self::Char(d), true, start) => {
                    push(start.unwrap_or(0), at);
                    from = Some(at + d.len_utf8());
                }
                (Self::Blanks, true, Some(start)) => {
                    push(start, at);
                    from = None;
                }
                (Self::Blanks, false, None) => from = Some(at),
                _ => {}
            }
        }
        match (self, from) {
            (Self::Char(_), start) => push(start.unwrap_or(0), line.len()),
            (Self::Blanks, Some(start)) => push(start, line.len()),
            (Self::Blanks, None) => {}
        }
    }
}

/// True for the texts that stand for a number, NaN and infinity included: those belong to data, not to a header.
fn is_number(field: &Field<'_>) -> bool {
    field.text.parse::<f64>().is_ok()
}

impl<'a> Table<'a> {
    /// Splits the text. `wanted` are column names asked for: they help to tell a header behind a `#` from a remark.
    pub(super) fn parse(source: Source<'a>, wanted: &[String]) -> Result<Self, Box<Diagnostic>> {
        let lines = || lines(source.text);
        let first = lines().find(|(_, line)| !content(line).trim().is_empty());
        let Some((_, first_line)) = first else {
            return Err(source.diagnostic(0..0, "", "the file holds no points"));
        };
        let delimiter = Delimiter::of(content(first_line));
        let mut table = Self { header: Vec::new(), width: 0, rows: Vec::new(), fields: Vec::new() };
        // The last remark before the data that could be a header.
        let mut remark: Vec<Field<'a>> = Vec::new();
        let (mut block, mut gap, mut seen) = (0, false, false);
        for (start, line) in lines() {
            if let (false, Some(text)) = (seen, line.trim_start().strip_prefix('#')) {
                let text_start = start + line.len() - text.len();
                let mut names = Vec::new();
                delimiter.split(text, text_start, &mut names);
                if is_header(&names, wanted) {
                    remark = names;
                }
                continue;
            }
            let text = content(line);
            let from = table.fields.len();
            if !text.trim().is_empty() {
                delimiter.split(text, start, &mut table.fields);
            }
            let own = &table.fields[from..];
            if own.iter().all(|f| f.text.is_empty()) {
                // A remark alone on its line separates nothing.
                gap |= seen && !line.contains('#');
                table.fields.truncate(from);
                continue;
            }
            if !seen && !own.iter().any(is_number) {
                table.header = table.fields.split_off(from);
                seen = true;
                continue;
            }
            if !table.rows.is_empty() && gap {
                block += 1;
            }
            (seen, gap) = (true, false);
            let count = own.len();
            table.rows.push(Row { first: from, count, end: start + text.trim_end().len(), block });
        }
        if table.rows.is_empty() {
            return Err(source.diagnostic(0..0, "", "the file holds no points"));
        }
        if table.header.is_empty() && remark.len() == table.rows[0].count {
            table.header = remark;
        }
        table.width = if table.header.is_empty() { table.rows[0].count } else { table.header.len() };
        table.refuse_longer_lines(source)?;
        Ok(table)
    }

    /// Refuses lines with more fields than there are columns, as decimal commas make them; empty fields do not count.
    fn refuse_longer_lines(&self, source: Source<'_>) -> Result<(), Box<Diagnostic>> {
        for row in &self.rows {
            let beyond = self.fields(row).iter().skip(self.width).find(|f| !f.text.is_empty());
            if let Some(field) = beyond {
                let message = format!("the line has {} fields for {} columns", row.count, self.width);
                return Err(field.refused(source, message));
            }
        }
        Ok(())
    }

    /// The fields of a row.
    pub(super) fn fields(&self, row: &Row) -> &[Field<'a>] {
        &self.fields[row.first..row.first + row.count]
    }

    pub(super) fn first_row_field(&self, column: usize) -> Option<Field<'a>> {
        self.rows.first().and_then(|row| self.fields(row).get(column).copied())
    }

    /// A field of a row, or the message that the line is too short.
    pub(super) fn field(
        &self,
        source: Source<'_>,
        row: &Row,
        column: usize,
        what: &str,
    ) -> Result<Field<'a>, Box<Diagnostic>> {
        self.fields(row).get(column).copied().ok_or_else(|| {
            let message = format!("the {what} of column {} is missing: the line has {} fields", column + 1, row.count);
            source.diagnostic(row.end..row.end, "", message)
        })
    }

    /// The message that a column asked for does not exist.
    pub(super) fn no_column(&self, source: Source<'_>, name: &str) -> Box<Diagnostic> {
        match (self.header.first(), self.header.last()) {
            (Some(first), Some(last)) => {
                let names: Vec<&str> = self.header.iter().map(|f| f.text).collect();
                let hint = did_you_mean(name, names.iter().copied());
                let message = format!("no column is named `{name}`; there are {}{hint}", names.join(", "));
                source.diagnostic(first.start..last.start + last.text.len(), "", message)
            }
            _ => {
                let message = format!(
                    "no column `{name}`: the file has no header line, so columns have numbers from 1 to {}",
                    self.width
                );
                self.rows[0].refused(source, self, &message)
            }
        }
    }
}

/// A remark is a header if it names a column we would look for and holds no numbers.
fn is_header(names: &[Field<'_>], wanted: &[String]) -> bool {
    let known = |f: &Field<'_>| {
        let base = f.text.split(['_', ' ', '[', '(']).next().unwrap_or_default();
        ["x", "y", "z"].iter().any(|axis| base.eq_ignore_ascii_case(axis))
            || wanted.iter().any(|w| w.eq_ignore_ascii_case(f.text))
    };
    names.len() > 1 && names.iter().any(known) && !names.iter().any(is_number)
}

/// A line up to a remark.
fn content(line: &str) -> &str {
    line.split('#').next().unwrap_or_default()
}

/// The lines with their byte offsets; `\n`, `\r\n` and `\r` end a line.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut at = 0;
    text.split_inclusive(['\n', '\r']).filter_map(move |piece| {
        let start = at;
        at += piece.len();
        // The line feed of a `\r\n` is no line of its own.
        let second_half = piece == "\n" && text.as_bytes()[..start].last() == Some(&b'\r');
        (!second_half).then(|| (start, piece.trim_end_matches(['\n', '\r'])))
    })
}
