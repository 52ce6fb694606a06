//! Numbers as tables write them: with decimal points, or with decimal commas where commas separate nothing, and with
//! separators of thousands where these are certain.

use std::borrow::Cow;

use super::fields::{Delimiter, Field, has_decimal_comma, plain_sign};
use super::groups::{Evidence, Groups, may_have_groups};
use super::table::Table;
use crate::text::number::{NEARER_TO_ZERO, vanishes};
use crate::text::place::{Diagnostic, Source, quoted};

/// How the numbers of a file write their fractions: one way in one file.
#[derive(Debug, Default)]
pub(super) struct Decimals {
    point: bool,
    /// True if numbers were read with decimal commas.
    pub(super) comma: bool,
    /// What separates thousands.
    groups: Option<Groups>,
    /// True if numbers were read with separators of thousands.
    pub(super) grouped: bool,
}

impl Decimals {
    /// Looks through the columns that are read for separators of thousands; `None` takes all of them.
    ///
    /// # Errors
    /// As reading the lines has them; where nothing tells fractions from thousands, at the first such number.
    pub(super) fn of(
        source: Source<'_>,
        table: &Table<'_>,
        columns: Option<&[usize]>,
    ) -> Result<Self, Box<Diagnostic>> {
        if !table.may_have_groups() {
            return Ok(Self::default());
        }
        let mut evidence = Evidence::default();
        let mut first: Option<Field<'_>> = None;
        table.for_each_row(|row| {
            for (column, field) in row.fields.iter().enumerate() {
                if columns.is_none_or(|columns| columns.contains(&column)) {
                    evidence.see(field.text);
                    if first.is_none() && field.text.contains(',') && may_have_groups(field.text) {
                        first = Some(*field);
                    }
                }
            }
            Ok(())
        })?;
        if table.delimiter == Delimiter::Char(',')
            && evidence.commas_may_be_either()
            && let Some(field) = first
        {
            let message = format!(
                "`{}` has either a decimal comma or a thousands separator, and no number of the file decides which: separate the columns by semicolons if it is a decimal comma, otherwise remove the separator",
                quoted(field.text)
            );
            return Err(field.refused(source, message));
        }
        Ok(Self { groups: evidence.groups(), ..Self::default() })
    }

    /// A coordinate: any decimal number, but neither NaN nor infinite.
    pub(super) fn read(&mut self, source: Source<'_>, field: &Field<'_>) -> Result<f64, Box<Diagnostic>> {
        let given = plain_sign(field.text);
        let text = self.groups.map_or(Cow::Borrowed(&*given), |groups| groups.without(&given));
        self.grouped |= text.len() != given.len();
        let parsed = match text.parse::<f64>() {
            Ok(value) => {
                self.point |= text.contains('.');
                Some(value)
            }
            Err(_) if has_decimal_comma(&text) => {
                self.comma = true;
                text.replacen(',', ".", 1).parse().ok()
            }
            Err(_) => None,
        };
        let refused = |what: &str| Err(field.refused(source, format!("`{}` {what}", quoted(field.text))));
        match parsed {
            Some(_) if self.point && self.comma => {
                refused("contradicts the numbers before it: the file has decimal commas and decimal points")
            }
            Some(value) if vanishes(&text, value) => refused(NEARER_TO_ZERO),
            Some(value) if value.is_finite() => Ok(value),
            Some(_) => refused("is not a finite number"),
            None if text.is_empty() => Err(field.refused(source, "a number is missing")),
            None if text.contains(',') && text.replace([',', '.', '\''], "").parse::<f64>().is_ok() => {
                refused("is not a number: write it without thousands separators")
            }
            None if text.trim_matches(['(', ')', '[', ']', '{', '}']).parse::<f64>().is_ok() => {
                refused("is not a number: write it without brackets")
            }
            None => refused("is not a number"),
        }
    }
}
/// Looks for rows of whole numbers in which commas may be decimal ones: `1,5,2,5`, or `1,5,2`.
///
/// It takes a table without header, with three, four or six columns separated by commas, in which every field is a whole
/// number, and those that would be fractions have no sign: every second one, or of three the second or the third.
#[derive(Debug)]
pub(super) struct Pairs {
    /// The columns that may be fractions, one list for each way to read the rows.
    ways: Vec<&'static [usize]>,
    /// Those of them in which a whole number begins with a zero, as fractions do.
    begin_with_zero: [bool; 6],
}

impl Pairs {
    pub(super) fn new(table: &Table<'_>) -> Self {
        let plain = table.header.is_empty() && table.delimiter == Delimiter::Char(',');
        let ways: &[&[usize]] = match table.width {
            3 if plain => &[&[1], &[2]],
            4 if plain => &[&[1, 3]],
            6 if plain => &[&[1, 3, 5]],
            _ => &[],
        };
        Self { ways: ways.to_vec(), begin_with_zero: [false; 6] }
    }

    pub(super) fn row(&mut self, fields: &[Field<'_>]) {
        let digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
        let whole = |text: &str| digits(text.strip_prefix('-').unwrap_or(text));
        let fits = |fractions: &[usize]| {
            let field = |(column, field): (usize, &Field<'_>)| {
                if fractions.contains(&column) { digits(field.text) } else { whole(field.text) }
            };
            fields.iter().enumerate().all(field)
        };
        self.ways.retain(|fractions| fits(fractions));
        for (begins, field) in self.begin_with_zero.iter_mut().zip(fields) {
            *begins |= field.text.len() > 1 && field.text.starts_with('0');
        }
    }

    /// True if the fields are numbers with decimal commas: some of their fractions begin with a zero.
    pub(super) fn are_certain(&self) -> bool {
        let begins = |column: &usize| self.begin_with_zero.get(*column).is_some_and(|begins| *begins);
        self.ways.iter().any(|fractions| fractions.iter().any(begins))
    }

    pub(super) fn found(&self) -> bool {
        !self.ways.is_empty()
    }
}
