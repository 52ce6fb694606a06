//! The pairs of a QB curve as rows of numbers. Most curves are spans of degree 1 or 2: theirs stand in the curve itself, so that a
//! spline of a hundred thousand spans is one piece of memory.

use super::Row;
use std::ops::{Deref, DerefMut};

/// Most rows that stand in the curve itself.
const FEW: usize = 3;

/// One row for each pair.
#[derive(Debug, Clone)]
pub(super) enum Rows {
    /// Up to three, and how many.
    Few([Row; FEW], usize),
    /// More.
    Many(Vec<Row>),
}

impl Deref for Rows {
    type Target = [Row];

    fn deref(&self) -> &[Row] {
        match self {
            Self::Few(rows, count) => &rows[..*count],
            Self::Many(rows) => rows,
        }
    }
}

impl DerefMut for Rows {
    fn deref_mut(&mut self) -> &mut [Row] {
        match self {
            Self::Few(rows, count) => &mut rows[..*count],
            Self::Many(rows) => rows,
        }
    }
}

impl FromIterator<Row> for Rows {
    fn from_iter<I: IntoIterator<Item = Row>>(given: I) -> Self {
        let (mut few, mut count) = ([[0.0; 8]; FEW], 0);
        let mut given = given.into_iter();
        for row in given.by_ref() {
            if count == FEW {
                let first = few.into_iter().chain([row]);
                return Self::Many(first.chain(given).collect());
            }
            few[count] = row;
            count += 1;
        }
        Self::Few(few, count)
    }
}

impl From<Vec<Row>> for Rows {
    fn from(rows: Vec<Row>) -> Self {
        if rows.len() > FEW { Self::Many(rows) } else { rows.into_iter().collect() }
    }
}

impl PartialEq for Rows {
    fn eq(&self, other: &Self) -> bool {
        self[..] == other[..]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_and_many_are_what_was_given() {
        for count in 0..7 {
            let given: Vec<Row> = (0..count).map(|k| [f64::from(k); 8]).collect();
            let mut rows: Rows = given.iter().copied().collect();
            assert_eq!(rows[..], given[..]);
            assert_eq!(rows, Rows::from(given.clone()));
            assert_eq!(matches!(rows, Rows::Few(..)), given.len() <= FEW);
            if let Some(last) = rows.last_mut() {
                last[7] = -1.0;
                assert_ne!(rows, Rows::from(given));
            }
        }
    }
}
