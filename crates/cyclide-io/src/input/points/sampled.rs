//! What the first lines of a table say about its columns: whether one of them numbers the points.

use std::borrow::Cow;
use std::collections::HashSet;

use super::fields::{Field, has_decimal_comma, is_number};
use super::groups::{Evidence, Groups};
use super::table::Table;

/// Lines that are looked at.
const LOOKED_AT: usize = 500;
/// Fewer lines do not tell that a column counts,
const FEWEST: usize = 3;
/// nor, that whole numbers in any order number the points.
const ENOUGH: usize = 6;
/// With so many columns beside the first, a height that is 0 throughout says nothing.
const MAP_COLUMNS: usize = 3;
/// Parts of a drawing have this many points, on average.
const SHORTEST_RUN: usize = 3;
/// Eastings and northings have six or seven figures before the point, wherever the grid begins.
pub(super) const GRID: f64 = 1e5;
/// What is measured there is far smaller than its distance from the origin.
pub(super) const PART_OF_GRID: f64 = 0.1;
/// Steps of decimals are one to this part of them and of the number.
const SAME_STEP: f64 = 1e-9;
/// Seconds since 1970, from 2001 on.
const SECONDS: f64 = 1e9;
/// Coordinates on a grid of whole numbers range about as far as the numbers of their points.
const SAME_RANGE: f64 = 10.0;

/// What is known of one column.
#[derive(Debug, Clone, Default)]
struct Column {
    lines: usize,
    /// True if a field has a fraction, or is no plain number.
    fractions: bool,
    /// The last number, and the step to it if all are equal.
    last: Option<f64>,
    step: Option<f64>,
    even: bool,
    /// The same, apart from the rounding of decimals.
    regular: bool,
    rises: bool,
    range: Option<[f64; 2]>,
    /// Most figures behind the point of a number.
    decimals: usize,
    /// The range with numbers in any form.
    all_numbers: Option<[f64; 2]>,
    /// Whole numbers that were met, and whether one came twice.
    seen: HashSet<u64>,
    repeats: bool,
    /// Fields, how often one differs from the one before, and that.
    fields: usize,
    changes: usize,
    /// Those that are empty, those that are numbers in any form, and whether one is not 0.
    empty: usize,
    numbers: usize,
    nonzero: bool,
    text: String,
}

/// What the first lines of a table say about its columns.
#[derive(Debug)]
pub(super) struct Sampled {
    columns: Vec<Column>,
}

impl Sampled {
    pub(super) fn of(table: &Table<'_>) -> Self {
        let start = Column { even: true, regular: true, rises: true, ..Column::default() };
        let mut columns = vec![start; table.width];
        let groups = groups_of(table);
        let mut left = LOOKED_AT;
        // What is wrong with a line is said where it is read.
        table.for_first_rows(|fields| {
            for (column, field) in columns.iter_mut().zip(fields) {
                let plain = groups.map_or(Cow::Borrowed(field.text), |groups| groups.without(field.text));
                column.see(field.text, &plain);
            }
            left -= 1;
            left > 0
        });
        Self { columns }
    }

    /// True if the first of these columns numbers the points: it counts on in equal steps, or rises in whole numbers, where the
    /// others have fractions or range much farther.
    pub(super) fn numbers_points(&self, columns: &[usize]) -> bool {
        let [first, others @ ..] = columns else { return false };
        let Some(first) = self.columns.get(*first) else { return false };
        let others: Vec<&Column> = others.iter().filter_map(|i| self.columns.get(*i)).collect();
        // Where a height is 0 throughout the others are x and y.
        let flat = others.len() < MAP_COLUMNS
            && others.iter().any(|column| column.range.is_some_and(|range| range.iter().all(|z| z.abs() <= 0.0)));
        if first.fractions || first.lines < FEWEST || others.len() < 2 || flat {
            return false;
        }
        let width = |column: &Column| column.range.map_or(0.0, |[low, high]| high - low);
        let fractions = others.iter().filter(|column| column.fractions).count();
        let farther = others.iter().any(|column| width(column) > SAME_RANGE * width(first));
        let counts = first.even && first.step.is_some_and(|step| step != 0.0);
        let numbers = first.rises || !first.repeats && first.lines >= ENOUGH;
        counts && (fractions > 0 || farther && first.step == Some(1.0)) || numbers && fractions > 1
    }

    /// True if the first of these columns may be times or stations: it rises in equal steps, and there are three more or those are
    /// coordinates of a map grid; or it holds seconds since 1970.
    pub(super) fn may_be_times(&self, columns: &[usize]) -> bool {
        let [first, others @ ..] = columns else { return false };
        let Some(Column { all_numbers: Some([low, high]), rises: true, regular, lines, .. }) = self.columns.get(*first)
        else {
            return false;
        };
        let of_map = || *high < GRID && others.windows(2).any(|pair| self.are_on_a_grid([pair[0], pair[1]]));
        *lines >= FEWEST && others.len() > 1 && (*low > SECONDS || *regular && (others.len() > 2 || of_map()))
    }

    /// True if equal values of a column stand together, and more than one of them: it tells the parts of a drawing apart.
    pub(super) fn comes_in_runs(&self, column: usize) -> bool {
        self.columns
            .get(column)
            .is_some_and(|column| column.changes > 0 && (column.changes + 1) * SHORTEST_RUN <= column.fields)
    }

    /// True if what stands in a column are numbers, and not all of them 0.
    pub(super) fn is_of_numbers(&self, column: usize) -> bool {
        let fits = |column: &Column| column.nonzero && column.numbers + column.empty == column.fields;
        self.columns.get(column).is_some_and(fits)
    }

    /// True if what stands in a column are numbers.
    pub(super) fn are_numbers(&self, column: usize) -> bool {
        let fits = |column: &Column| column.numbers > 0 && column.numbers + column.empty == column.fields;
        self.columns.get(column).is_some_and(fits)
    }

    /// True if each value of a column may stand in two lines next to each other.
    pub(super) fn may_come_in_pairs(&self, column: usize) -> bool {
        self.columns.get(column).is_some_and(|column| (column.changes + 1) * 2 <= column.fields)
    }

    /// True if nothing stands in a column.
    pub(super) fn is_empty(&self, column: usize) -> bool {
        self.columns.get(column).is_none_or(|column| column.empty == column.fields)
    }

    /// True if a column has more than one value.
    pub(super) fn changes(&self, column: usize) -> bool {
        self.columns.get(column).is_some_and(|column| column.changes > 0)
    }

    /// True if a column counts its lines: whole numbers in equal steps.
    pub(super) fn counts(&self, column: usize) -> bool {
        let counts = |column: &Column| !column.fractions && column.lines >= FEWEST && column.even && column.rises;
        self.columns.get(column).is_some_and(counts)
    }

    /// The least and the most of a column, if all of it are numbers.
    pub(super) fn range(&self, column: usize) -> Option<[f64; 2]> {
        let column = self.columns.get(column).filter(|column| column.numbers == column.fields)?;
        column.all_numbers
    }

    /// Most figures behind the point of a number of a column.
    pub(super) fn decimals(&self, column: usize) -> usize {
        self.columns.get(column).map_or(0, |column| column.decimals)
    }

    /// True if two columns are coordinates of a map grid by their figures: far from 0, and near to each other.
    pub(super) fn are_on_a_grid(&self, columns: [usize; 2]) -> bool {
        let ranges = columns.map(|i| self.columns.get(i).and_then(|column| column.all_numbers));
        ranges.iter().all(|range| {
            range.is_some_and(|[low, high]| {
                low.abs().min(high.abs()) > GRID && high - low < PART_OF_GRID * low.abs().min(high.abs())
            })
        })
    }

    /// The columns except those that number the points or may be times.
    pub(super) fn without_numbers(&self, columns: &[usize]) -> Vec<usize> {
        let mut rest = columns;
        if self.numbers_points(rest) || self.may_be_times(rest) {
            rest = &rest[1..];
        }
        rest.to_vec()
    }
}

impl Column {
    /// Takes note of a field; `plain` is its text without separators of thousands.
    fn see(&mut self, text: &str, plain: &str) {
        if self.fields > 0 && text != self.text {
            self.changes += 1;
        }
        self.fields += 1;
        self.text.clear();
        self.text.push_str(text);
        self.empty += usize::from(text.is_empty());
        if let Some(number) = number_of(plain) {
            self.numbers += 1;
            let behind = plain.rsplit_once(['.', ',']).map_or("", |(_, behind)| behind);
            self.decimals = self.decimals.max(behind.bytes().take_while(u8::is_ascii_digit).count());
            self.nonzero |= number != 0.0;
            let [low, high] = self.all_numbers.unwrap_or([number; 2]);
            self.all_numbers = Some([low.min(number), high.max(number)]);
        }
        let comma = has_decimal_comma(plain);
        let number = if comma { plain.replacen(',', ".", 1).parse::<f64>() } else { plain.parse() };
        let Ok(number) = number else {
            self.fractions = true;
            return;
        };
        self.lines += 1;
        self.fractions |= !plain.bytes().all(|byte| byte.is_ascii_digit() || byte == b'-');
        self.repeats |= !self.seen.insert(number.to_bits());
        if let Some(last) = self.last {
            let step = number - last;
            self.rises &= step > 0.0;
            self.even &= self.step.is_none_or(|before| before.total_cmp(&step).is_eq());
            let rounding = SAME_STEP * (step.abs() + number.abs());
            self.regular &= self.step.is_none_or(|before| (step - before).abs() <= rounding);
            self.step = Some(step);
        }
        self.last = Some(number);
        let [low, high] = self.range.unwrap_or([number; 2]);
        self.range = Some([low.min(number), high.max(number)]);
    }
}

/// What separates thousands in the first lines of a table, if that is certain.
fn groups_of(table: &Table<'_>) -> Option<Groups> {
    let mut evidence = Evidence::default();
    let mut left = LOOKED_AT;
    table.for_first_rows(|fields| {
        // Dates and codes are no numbers.
        fields.iter().filter(|field| is_number(field)).for_each(|field| evidence.see(field.text));
        left -= 1;
        left > 0
    });
    evidence.groups()
}

/// A finite number in any form that tables have, roughly: what separates its thousands is left out.
fn number_of(text: &str) -> Option<f64> {
    if !is_number(&Field { text, start: 0 }) {
        return None;
    }
    let plain: String = text
        .replace('\u{2212}', "-")
        .chars()
        .filter(|c| !c.is_whitespace() && !matches!(c, '\'' | '\u{2019}'))
        .collect();
    let marks = |mark: char| plain.matches(mark).count();
    // The last of two marks is that of the fraction, and one that comes twice is not.
    let fraction = match (plain.rfind('.'), plain.rfind(',')) {
        (Some(point), Some(comma)) if point < comma => ',',
        (None, Some(_)) if marks(',') == 1 => ',',
        _ => '.',
    };
    let twice = marks(fraction) > 1;
    let digits = plain.chars().filter(|c| !matches!(c, '.' | ',') || *c == fraction && !twice);
    let value: f64 = digits.map(|c| if c == fraction { '.' } else { c }).collect::<String>().parse().ok()?;
    value.is_finite().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::place::Source;

    #[test]
    fn times_and_stations_are_told_from_coordinates() {
        let may_be_times = |text: &str| {
            let table = Table::parse(Source { name: "t", text }, &[]).unwrap();
            Sampled::of(&table).may_be_times(&(0..table.width).collect::<Vec<_>>())
        };
        for (text, found) in [
            ("0.0 600.1 200.2 43.1\n0.1 610.6 214.4 43.2\n0.2 620.6 227.7 43.1\n0.3 630 240 43\n", true),
            ("0,00;600,1;200,2;43,1\n25,00;610,6;214,4;43,2\n50,00;620,6;227,7;43,1\n", true),
            ("12.00;4468600.5;5334200.1\n12.02;4468610.6;5334214.4\n12.04;4468620.6;5334227.7\n", true),
            ("1700000000.0 600.1 200.2\n1700000001.5 610.6 214.4\n1700000002.0 620.6 227.7\n", true),
            // A curve in space over equal steps of x.
            ("0.0 0.5 0.2\n0.1 0.6 0.4\n0.2 0.6 0.7\n", false),
            ("0.0 600.1 200.2 43.1\n0.1 610.6 214.4 43.2\n0.3 620.6 227.7 43.1\n", false),
            ("12.0;4468600.5\n12.1;4468610.6\n12.2;4468620.6\n", false),
        ] {
            assert_eq!(may_be_times(text), found, "{text:?}");
        }
    }

    fn numbers_points(text: &str) -> bool {
        let table = Table::parse(Source { name: "t", text }, &[]).unwrap();
        Sampled::of(&table).numbers_points(&(0..table.width).collect::<Vec<_>>())
    }

    #[test]
    fn columns_that_number_the_points_are_found() {
        for (text, found) in [
            ("1 10.5 20\n2 11 21\n3 13 20\n", true),
            ("10;1,5;2\n20;2,5;2\n30;3,5;4\n", true),
            ("1001 10.5 20.5\n1003 11.5 21.5\n1009 13.5 20.5\n", true),
            ("1 1500 2000\n2 1700 2200\n3 1500 2900\n", true),
            // Number, northing, easting, height 0.
            ("1 10.5 20.5 0\n2 11.5 21.5 0\n3 13.5 20.5 0\n", true),
            ("2 1.5 2.5\n22 1.5 3.5\n8 2.5 1.5\n7 2.5 1.6\n1 2.5 1.7\n6 2.5 1.8\n", true),
            // Coordinates on a grid.
            ("1 10 20\n2 11 21\n3 13 20\n", false),
            ("0 0 0\n10 0 0\n20 10 0\n", false),
            ("0 0.5 0\n2 0.7 0\n3 0.9 0\n", false),
            ("1.0 1.5 2.5\n2.0 1.5 2.5\n3.0 1.5 2.5\n", false),
            ("1 10.5\n2 11.5\n3 13.5\n", false),
        ] {
            assert_eq!(numbers_points(text), found, "{text:?}");
        }
    }
}
