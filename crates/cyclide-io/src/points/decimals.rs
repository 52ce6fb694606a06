//! Numbers as tables write them: with decimal points, or with decimal commas where commas separate nothing.

use std::num::FpCategory;

use super::table::{Delimiter, Field, Table};
use crate::place::{Diagnostic, Source, quoted};

/// True for a number with a decimal comma between digits: `-1,5`, `0,25e3`.
pub(super) fn has_decimal_comma(text: &str) -> bool {
    let Some((whole, fraction)) = text.split_once(',') else { return false };
    whole.ends_with(|c: char| c.is_ascii_digit())
        && fraction.starts_with(|c: char| c.is_ascii_digit())
        && text.replacen(',', ".", 1).parse::<f64>().is_ok()
}

/// True for the texts that stand for a number, NaN and infinity included: those belong to data, not to a header.
pub(super) fn is_number(field: &Field<'_>) -> bool {
    field.text.parse::<f64>().is_ok() || has_decimal_comma(field.text)
}

/// True if a figure other than 0 stands before the exponent.
fn has_figure(text: &str) -> bool {
    text.split(['e', 'E']).next().is_some_and(|figures| figures.contains(|c| matches!(c, '1'..='9')))
}

/// How the numbers of a file write their fractions: one way in one file.
#[derive(Debug, Default)]
pub(super) struct Decimals {
    point: bool,
    /// True if numbers were read with decimal commas.
    pub(super) comma: bool,
}

impl Decimals {
    /// A coordinate: any decimal number, but neither NaN nor infinite.
    pub(super) fn read(&mut self, source: Source<'_>, field: &Field<'_>) -> Result<f64, Box<Diagnostic>> {
        let text = field.text;
        let parsed = match text.parse::<f64>() {
            Ok(value) => {
                self.point |= text.contains('.');
                Some(value)
            }
            Err(_) if has_decimal_comma(text) => {
                self.comma = true;
                text.replacen(',', ".", 1).parse().ok()
            }
            Err(_) => None,
        };
        let refused = |what: &str| Err(field.refused(source, format!("`{}` {what}", quoted(text))));
        match parsed {
            Some(_) if self.point && self.comma => {
                refused("does not go with the numbers before: the file has decimal commas and decimal points")
            }
            Some(value) if value.classify() == FpCategory::Zero && has_figure(text) => {
                refused("is nearer to 0 than any number that can be read: write 0 if that is meant")
            }
            Some(value) if value.is_finite() => Ok(value),
            Some(_) => refused("is not a finite number"),
            None if text.is_empty() => Err(field.refused(source, "a number is missing")),
            None if text.contains(',') && text.replace([',', '.', '\''], "").parse::<f64>().is_ok() => {
                refused("is not a number: write it without separators of thousands")
            }
            None => refused("is not a number"),
        }
    }
}

/// Looks for rows of whole numbers in which commas may be decimal ones: `1,5,2,5`.
///
/// It takes a table without header, with four or six columns separated by commas, in which every field is a whole number
/// and every second one has no sign.
#[derive(Debug)]
pub(super) struct Pairs(bool);

impl Pairs {
    pub(super) fn new(table: &Table<'_>) -> Self {
        let shape = table.header.is_empty() && matches!(table.width, 4 | 6);
        Self(shape && table.delimiter == Delimiter::Char(','))
    }

    pub(super) fn row(&mut self, fields: &[Field<'_>]) {
        let digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
        let fits = |(column, field): (usize, &Field<'_>)| match column % 2 {
            0 => digits(field.text.strip_prefix('-').unwrap_or(field.text)),
            _ => digits(field.text),
        };
        self.0 = self.0 && fields.iter().enumerate().all(fits);
    }

    pub(super) const fn found(&self) -> bool {
        self.0
    }
}
