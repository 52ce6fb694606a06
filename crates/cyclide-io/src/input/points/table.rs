//! Lines and fields of a delimited text, with the place of each field; read line by line, nothing is kept of the rows.

use super::fields::{Delimiter, Field, about, split};
use super::preamble::Preamble;
use super::unit::{UnitWord, unit_in_name, unit_of_convention};
use crate::text::lines::lines;
use crate::text::place::{Diagnostic, Source, quoted};
use crate::text::suggest::did_you_mean;

/// Names of columns in a message at most.
const NAMED: usize = 12;

/// A line of data, and which block between blank lines it stands in.
#[derive(Debug, Clone)]
pub(super) struct Row<'r, 'a> {
    pub(super) fields: &'r [Field<'a>],
    pub(super) block: usize,
    end: usize,
}

impl<'a> Row<'_, 'a> {
    /// A field, or the message that the line is too short.
    pub(super) fn field(&self, source: Source<'_>, column: usize, what: &str) -> Result<Field<'a>, Box<Diagnostic>> {
        self.fields.get(column).copied().ok_or_else(|| {
            let count = self.fields.len();
            let fields = if count == 1 { "field" } else { "fields" };
            let message = format!(
                "the {what} of column {} is missing: the line has {count} {fields}; remove it if it is no point",
                column + 1
            );
            source.diagnostic(self.end..self.end, "", message)
        })
    }

    /// Refuses more fields than there are columns, as decimal commas make them; empty fields do not count.
    fn refuse_longer(&self, source: Source<'_>, width: usize, delimiter: Delimiter) -> Result<(), Box<Diagnostic>> {
        let Some(beyond) = self.fields.iter().skip(width).find(|f| !f.text.is_empty()) else { return Ok(()) };
        let (count, whole) = (self.fields.len(), |f: &Field<'_>| f.text.parse::<i64>().is_ok());
        let pairs = width >= 2 && count <= 2 * width && self.fields.iter().all(whole);
        let hint = match delimiter {
            _ if pairs => "; if its commas are decimal, separate the columns by semicolons",
            Delimiter::Blanks => {
                "; put names of several words in quotes, or separate the columns by semicolons or tabs; if the first column has no name, write one"
            }
            Delimiter::Char(_) => "; put texts that contain the separator in quotes",
        };
        Err(beyond.refused(source, format!("the line has {count} fields for {width} columns{hint}")))
    }
}

/// A text whose header and first line of data have been read.
#[derive(Debug, Clone)]
pub(super) struct Table<'a> {
    source: Source<'a>,
    pub(super) delimiter: Delimiter,
    /// Names of the columns; empty if the text has none.
    pub(super) header: Vec<Field<'a>>,
    /// The units of a line of them below the header, one for each column; empty without such a line.
    pub(super) units: Vec<Option<UnitWord>>,
    /// The words of that line.
    pub(super) unit_words: Vec<Field<'a>>,
    /// Where lines of text above the header start, which are passed over.
    pub(super) titles: Vec<usize>,
    /// The unit that a title or a remark above the data says the coordinates are in, with that line.
    pub(super) said: Option<(UnitWord, &'a str)>,
    /// Number of columns of the header, else of the first line of data.
    pub(super) width: usize,
    /// The first line of data.
    pub(super) first: Vec<Field<'a>>,
    /// Where the line of it starts.
    start: usize,
}

impl<'a> Table<'a> {
    /// Reads up to the first line of data. `wanted` are column names asked for: they help to tell a header behind a `#`
    /// from a remark.
    pub(super) fn parse(source: Source<'a>, wanted: &[String]) -> Result<Self, Box<Diagnostic>> {
        Self::parse_with(source, wanted, |_| false)
    }

    /// As [`parse`](Self::parse); `known` tells the names of columns that such a table has besides.
    pub(super) fn parse_with(
        source: Source<'a>,
        wanted: &[String],
        known: fn(&Field<'_>) -> bool,
    ) -> Result<Self, Box<Diagnostic>> {
        let preamble = Preamble::read(source, wanted, known)?;
        let Preamble { delimiter, header, units, unit_words, titles, said, first, start } = preamble;
        let width = if header.is_empty() { first.len() } else { header.len() };
        let table = Self { source, delimiter, header, units, unit_words, titles, said, width, first, start };
        table.with_names_of_words(wanted)?.without_gaps(wanted)
    }

    /// Leaves out names that are empty where no line has a field for them, as between two tabs that align names.
    fn without_gaps(mut self, wanted: &[String]) -> Result<Self, Box<Diagnostic>> {
        let is_named = |field: &Field<'_>| !field.text.is_empty();
        let count = self.header.iter().rposition(is_named).map_or(0, |last| last + 1);
        let gaps: Vec<usize> = (0..count).filter(|i| !is_named(&self.header[*i])).collect();
        if gaps.is_empty() {
            return Ok(self);
        }
        let (mut widest, mut are_filled) = (0, false);
        self.for_first_rows(|fields| {
            widest = widest.max(fields.len());
            are_filled |= gaps.iter().any(|i| fields.get(*i).is_some_and(is_named));
            widest < count
        });
        // Lines that leave the same gaps may only lack their last fields.
        if widest >= count || !are_filled {
            return Ok(self);
        }
        let names = count - gaps.len();
        if names == widest {
            let kept = |i: usize| !gaps.contains(&i);
            if self.units.len() > widest {
                self.units = (0..).zip(self.units).filter(|(i, _)| kept(*i)).map(|(_, unit)| unit).collect();
                self.unit_words = (0..).zip(self.unit_words).filter(|(i, _)| kept(*i)).map(|(_, word)| word).collect();
            }
            self.header.retain(is_named);
        } else if !wanted.is_empty() && wanted.iter().all(|name| name.parse::<usize>().is_ok()) {
            self.header.clear();
        } else {
            return Err(self.header_refused(format!(
                "there are {names} names and {} empty ones for {widest} columns, and which column has which name is not known: choose the columns by number (`--columns 2,3`, in a document `columns`)",
                gaps.len()
            )));
        }
        self.width = widest;
        Ok(self)
    }

    /// Names of several words, in a table whose columns are separated by blanks, are parted by two blanks: else their columns are not known.
    fn with_names_of_words(mut self, wanted: &[String]) -> Result<Self, Box<Diagnostic>> {
        let count = self.header.len();
        if self.delimiter != Delimiter::Blanks || count <= self.first.len() {
            return Ok(self);
        }
        let mut widest = 0;
        self.for_first_rows(|fields| {
            widest = widest.max(fields.len());
            widest < count
        });
        if widest >= count {
            return Ok(self);
        }
        let mut joined: Vec<Field<'a>> = Vec::new();
        for field in &self.header {
            let after = joined.last().map(|last| last.start + last.text.len());
            match (joined.last_mut(), after) {
                (Some(last), Some(end)) if &self.source.text[end..field.start] == " " => {
                    last.text = &self.source.text[last.start..field.start + field.text.len()];
                }
                _ => joined.push(*field),
            }
        }
        let by_number = |name: &String| name.parse().is_ok_and(|n: usize| (1..=widest).contains(&n));
        if joined.len() == widest {
            self.header = joined;
        } else if !wanted.is_empty() && wanted.iter().all(by_number) {
            self.header.clear();
        } else {
            return Err(self.header_refused(format!(
                "there are {count} names for {widest} columns, and which names have several words is not known: separate the columns by two \
                 blanks, tabs or semicolons, or choose them by number (`--columns 2,3`, in a document `columns`)"
            )));
        }
        self.width = widest;
        Ok(self)
    }

    /// The unit of a column of coordinates: its own, else that of a title.
    pub(super) fn unit(&self, column: usize) -> Option<UnitWord> {
        self.own_unit(column).or(self.said.map(|(unit, _)| unit))
    }

    /// That of the name of a column, of the line of units, or of a convention.
    fn own_unit(&self, column: usize) -> Option<UnitWord> {
        let name = self.header.get(column).map(|field| field.text);
        let below = || self.units.get(column).copied().flatten();
        name.and_then(unit_in_name).or_else(below).or_else(|| name.and_then(unit_of_convention))
    }

    /// True if one of some columns has a unit of its own.
    pub(super) fn columns_have_units(&self, columns: &[usize]) -> bool {
        columns.iter().any(|column| self.own_unit(*column).is_some())
    }

    /// True if a mark that may separate thousands is in the data: a look at the bytes, which costs little.
    pub(super) fn may_have_groups(&self) -> bool {
        let data = &self.source.text[self.start..];
        let comma_separates = self.delimiter == Delimiter::Char(',');
        let commas = data.contains(',') && (!comma_separates || data.contains('"'));
        let blanks = self.delimiter != Delimiter::Blanks && data.contains(' ');
        commas
            || blanks
            || data.contains(['\'', '\u{2019}', '\u{a0}', '\u{202f}', '\u{2009}'])
            || !comma_separates && data.contains('.')
    }

    /// Replaces `fields` by those of a line.
    fn split(&self, start: usize, line: &'a str, fields: &mut Vec<Field<'a>>) -> Result<(), Box<Diagnostic>> {
        split(self.source, self.delimiter, start, line, fields)
    }

    /// Visits the lines of data.
    pub(super) fn for_each_row(
        &self,
        mut visit: impl FnMut(&Row<'_, 'a>) -> Result<(), Box<Diagnostic>>,
    ) -> Result<(), Box<Diagnostic>> {
        let (mut block, mut gap, mut any) = (0, false, false);
        let mut fields = Vec::new();
        for (start, line) in lines(&self.source.text[self.start..]) {
            let start = self.start + start;
            self.split(start, line, &mut fields)?;
            if fields.iter().all(|f| f.text.is_empty()) {
                // A remark alone on its line separates nothing.
                gap |= any && !line.contains('#');
                continue;
            }
            block += usize::from(gap);
            (any, gap) = (true, false);
            let row = Row { fields: &fields, block, end: start + content(line).trim_end().len() };
            row.refuse_longer(self.source, self.width, self.delimiter)?;
            visit(&row)?;
        }
        Ok(())
    }

    /// Visits the fields of the first lines of data, as long as that returns true and they can be read.
    pub(super) fn for_first_rows(&self, mut visit: impl FnMut(&[Field<'a>]) -> bool) {
        let mut fields = Vec::new();
        for (start, line) in lines(&self.source.text[self.start..]) {
            if self.split(self.start + start, line, &mut fields).is_err() {
                return;
            }
            if fields.iter().any(|f| !f.text.is_empty()) && !visit(&fields) {
                return;
            }
        }
    }

    /// Visits all lines that are not blank, from the first one on and those of empty fields too, with their fields and where they end.
    pub(super) fn for_each_line(
        &self,
        mut visit: impl FnMut(&[Field<'a>], usize) -> Result<(), Box<Diagnostic>>,
    ) -> Result<(), Box<Diagnostic>> {
        let mut fields = Vec::new();
        for (start, line) in lines(self.source.text) {
            let text = content(line).trim_end_matches(' ');
            if text.is_empty() {
                continue;
            }
            self.split(start, line, &mut fields)?;
            if !fields.is_empty() {
                visit(&fields, start + text.len())?;
            }
        }
        Ok(())
    }

    /// A message about the first line of data.
    pub(super) fn refused(&self, message: impl Into<String>) -> Box<Diagnostic> {
        self.about(&self.first, message)
    }

    /// A message about the header.
    pub(super) fn header_refused(&self, message: impl Into<String>) -> Box<Diagnostic> {
        self.about(&self.header, message)
    }

    fn about(&self, fields: &[Field<'_>], message: impl Into<String>) -> Box<Diagnostic> {
        about(self.source, fields, message)
    }

    /// The names of columns for a message; their numbers where they have no names.
    pub(super) fn names(&self, columns: impl IntoIterator<Item = usize>) -> String {
        let name = |i: usize| match self.header.get(i) {
            Some(field) => quoted(field.text).into_owned(),
            None => (i + 1).to_string(),
        };
        let mut columns = columns.into_iter();
        let mut named: Vec<String> = columns.by_ref().take(NAMED).map(name).collect();
        match columns.count() {
            0 => {}
            more => named.push(format!("and {more} more")),
        }
        named.join(", ")
    }

    /// The message that a column asked for does not exist.
    pub(super) fn no_column(&self, name: &str) -> Box<Diagnostic> {
        let name = quoted(name);
        if self.header.is_empty() {
            return self.refused(format!(
                "no column `{name}`: the file has no header line, so columns have numbers from 1 to {}",
                self.width
            ));
        }
        let hint = did_you_mean(&name, self.header.iter().map(|f| f.text));
        let names = self.names(0..self.header.len());
        self.header_refused(format!("no column is named `{name}`; there are {names}{hint}"))
    }
}

/// A line up to a remark.
fn content(line: &str) -> &str {
    line.split('#').next().unwrap_or_default()
}

/// Numbers of columns, from 1, as `--columns` takes them.
pub(super) fn numbers_of(columns: impl IntoIterator<Item = usize>) -> String {
    columns.into_iter().map(|i| (i + 1).to_string()).collect::<Vec<_>>().join(",")
}
