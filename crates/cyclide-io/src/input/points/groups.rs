//! Separators of thousands: read where they are certain.
//!
//! Groups are certain if they are strict (one to three figures, then threes) and the mark that separates them can be no decimal
//! one: an apostrophe or a blank; or a point or a comma that stands twice in a number, or before the other one.

use std::borrow::Cow;

/// What separates thousands in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Groups {
    Points,
    Commas,
    /// Apostrophes or blanks, which no number has otherwise.
    Marks,
}

/// Apostrophes and blanks between groups.
const MARKS: [char; 6] = ['\'', '\u{2019}', ' ', '\u{a0}', '\u{202f}', '\u{2009}'];

/// A number in parts: its sign, the figures before the decimal mark, and the rest with it.
struct Parts<'a> {
    sign: &'a str,
    whole: &'a str,
    rest: &'a str,
}

/// What is known of the marks of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shape {
    /// Groups that are certain.
    Certain(Groups),
    /// One mark before three figures, which may be either.
    Either(Groups),
    /// No groups.
    Plain,
}

impl Groups {
    const fn separates(self, c: char) -> bool {
        match self {
            Self::Points => c == '.',
            Self::Commas => c == ',',
            Self::Marks => matches!(c, '\'' | '\u{2019}' | ' ' | '\u{a0}' | '\u{202f}' | '\u{2009}'),
        }
    }

    /// The text of a number without its groups; as it stands if it has none.
    pub(super) fn without(self, text: &str) -> Cow<'_, str> {
        match self.parts(text) {
            Some(Parts { sign, whole, rest }) => {
                let figures = whole.chars().filter(|c| !self.separates(*c));
                Cow::Owned(sign.chars().chain(figures).chain(rest.chars()).collect())
            }
            None => Cow::Borrowed(text),
        }
    }

    /// The parts of a number that has strict groups.
    fn parts(self, text: &str) -> Option<Parts<'_>> {
        let start = text.find(|c: char| c.is_ascii_digit())?;
        let (sign, number) = text.split_at(start);
        if !matches!(sign, "" | "-" | "+" | "\u{2212}") {
            return None;
        }
        let end = number.find(|c: char| !c.is_ascii_digit() && !self.separates(c)).unwrap_or(number.len());
        let (whole, rest) = number.split_at(end);
        let mut groups = whole.split(|c| self.separates(c));
        let first = groups.next()?;
        let mut others = groups.peekable();
        let strict = (1..=3).contains(&first.len()) && others.peek().is_some() && others.all(|group| group.len() == 3);
        // One kind of mark in one number.
        let mut marks = whole.chars().filter(|c| !c.is_ascii_digit());
        let mark = marks.next();
        let one = marks.all(|other| Some(other) == mark);
        let is_rest = rest.is_empty() || rest.starts_with(['.', ',']) && is_fraction(&rest[1..]);
        (strict && one && is_rest).then_some(Parts { sign, whole, rest })
    }
}

/// True for figures with an exponent, or none.
fn is_fraction(text: &str) -> bool {
    format!("0.{text}").parse::<f64>().is_ok() && !text.starts_with(['e', 'E', '+', '-'])
}

/// True for a number whose groups are certain.
pub(super) fn has_certain_groups(text: &str) -> bool {
    matches!(shape(text), Shape::Certain(_))
}

/// True for a number that may have groups.
pub(super) fn may_have_groups(text: &str) -> bool {
    shape(text) != Shape::Plain
}

fn shape(text: &str) -> Shape {
    if !text.contains(['.', ',']) && !text.contains(MARKS) {
        return Shape::Plain;
    }
    for groups in [Groups::Points, Groups::Commas] {
        let mark = if groups == Groups::Points { '.' } else { ',' };
        let Some(Parts { whole, rest, .. }) = groups.parts(text) else { continue };
        let count = whole.matches(mark).count();
        if count > 1 || !rest.is_empty() {
            return Shape::Certain(groups);
        }
        // Nobody separates the thousands of 0.
        let zero = whole.starts_with('0');
        return if zero { Shape::Plain } else { Shape::Either(groups) };
    }
    if Groups::Marks.parts(text).is_some() { Shape::Certain(Groups::Marks) } else { Shape::Plain }
}

/// What the numbers of a file say about groups.
#[derive(Debug, Default)]
pub(super) struct Evidence {
    points: bool,
    commas: bool,
    marks: bool,
    /// A comma or a point alone before three figures.
    either: [bool; 2],
    /// A number with a comma that can separate no thousands, and one with such a point.
    decimal_comma: bool,
    decimal_point: bool,
}

impl Evidence {
    /// Takes note of one number.
    pub(super) fn see(&mut self, text: &str) {
        match shape(text) {
            Shape::Certain(groups) => {
                match groups {
                    Groups::Points => self.points = true,
                    Groups::Commas => self.commas = true,
                    Groups::Marks => self.marks = true,
                }
                let rest = groups.parts(text).map_or("", |parts| parts.rest);
                self.decimal_comma |= rest.starts_with(',');
                self.decimal_point |= rest.starts_with('.');
            }
            Shape::Either(Groups::Commas) => self.either[0] = true,
            Shape::Either(_) => self.either[1] = true,
            Shape::Plain => {
                self.decimal_comma |= text.contains(',');
                self.decimal_point |= text.contains('.');
            }
        }
    }

    /// What separates thousands, if that is certain and goes with all numbers.
    pub(super) const fn groups(&self) -> Option<Groups> {
        match (self.points, self.commas, self.marks) {
            (true, false, false) if !self.decimal_point => Some(Groups::Points),
            (false, true, false) if !self.decimal_comma => Some(Groups::Commas),
            (false, false, true) if !(self.decimal_point && self.decimal_comma) => Some(Groups::Marks),
            _ => None,
        }
    }

    /// True if all commas stand alone before three figures, where commas separate the columns too: thousands or fractions.
    pub(super) const fn commas_may_be_either(&self) -> bool {
        self.either[0] && !self.decimal_comma && !self.commas
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn groups(numbers: &[&str]) -> Option<Groups> {
        let mut evidence = Evidence::default();
        numbers.iter().for_each(|number| evidence.see(number));
        evidence.groups()
    }

    #[test]
    fn groups_are_found_where_they_are_certain() {
        for (numbers, found) in [
            (&["1.234,5", "1.234"][..], Some(Groups::Points)),
            (&["5.334.000", "-334.000"], Some(Groups::Points)),
            (&["1,234.5", "1,234"], Some(Groups::Commas)),
            (&["1'234.56", "12"], Some(Groups::Marks)),
            (&["1 234,56"], Some(Groups::Marks)),
            (&["1\u{202f}234\u{202f}567"], Some(Groups::Marks)),
            (&["1.234", "5.678"], None),
            (&["1.234,5", "1.5"], None),
            (&["1,234,567", "1,5"], None),
            (&["12.34.56"], None),
            (&["1234.567,8"], None),
            (&["1'23.5"], None),
            (&["1.234.567,8", "1,234,567.8"], None),
            (&["0.500,1"], Some(Groups::Points)),
        ] {
            assert_eq!(groups(numbers), found, "{numbers:?}");
        }
        assert_eq!(Groups::Marks.without("-1'234'567.25"), "-1234567.25");
        assert_eq!(Groups::Points.without("1.234,5e3"), "1234,5e3");
        assert_eq!(Groups::Points.without("1.2345"), "1.2345");
        assert!(!has_certain_groups("1.234") && may_have_groups("1.234") && !may_have_groups("0.234"));
        assert!(!may_have_groups("12.03.2024") && !has_certain_groups("abc"));
    }
}
