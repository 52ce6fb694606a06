//! Comparing results with the expected fields of a case, with a record of what was compared.

use super::case::Case;
use serde_json::{Map, Value};
use std::collections::BTreeSet;

/// The comparisons of one case.
#[derive(Debug)]
pub struct Check<'a> {
    expect: &'a Map<String, Value>,
    compared: BTreeSet<String>,
    failures: Vec<String>,
    /// Largest error over allowed error, with its field.
    worst: (f64, String),
}

/// The error allowed, from the expected numbers of a row.
pub(super) type Allowed<'f> = &'f dyn Fn(&[f64]) -> f64;

impl<'a> Check<'a> {
    /// No comparison yet.
    pub(super) fn new(case: &Case<'a>) -> Self {
        Self { expect: case.expect(), compared: BTreeSet::new(), failures: Vec::new(), worst: (0.0, String::new()) }
    }

    /// Largest error over allowed error, with its field.
    #[must_use]
    pub fn worst(&self) -> (f64, &str) {
        (self.worst.0, &self.worst.1)
    }

    /// What failed, as sentences.
    #[must_use]
    pub fn failures(&self) -> &[String] {
        &self.failures
    }

    pub(super) fn fail(&mut self, field: &str, what: String) {
        self.compared.insert(field.into());
        self.failures.push(format!("{field}: {what}"));
    }

    /// A field that agrees as a whole.
    pub(super) fn agree(&mut self, field: &str) {
        self.compared.insert(field.into());
    }

    /// Every field must have been compared, except information; something must have been compared.
    pub(super) fn finish(&mut self, information: &[&str]) {
        let expect = self.expect;
        for field in expect.keys() {
            if !self.compared.contains(field) && !information.contains(&field.as_str()) {
                self.fail(field, "no comparison handles this field".into());
            }
        }
        if self.compared.is_empty() {
            self.fail("expect", "nothing to compare".into());
        }
    }

    /// Marks a field as compared and returns its expected value; `None` if it is absent or null (undefined or
    /// infinite: not to be compared).
    fn want(&mut self, field: &str) -> Option<&'a Value> {
        let value = self.expect.get(field)?;
        self.compared.insert(field.into());
        (!value.is_null()).then_some(value)
    }

    /// The expected value of a field in which null has a meaning of its own.
    pub(super) fn want_raw(&mut self, field: &str) -> Option<&'a Value> {
        let value = self.expect.get(field)?;
        self.compared.insert(field.into());
        Some(value)
    }

    /// Records one comparison. Anything not finite fails.
    pub(super) fn measure(&mut self, field: &str, place: &str, error: f64, allowed: f64) {
        let ratio = if error == 0.0 { 0.0 } else { error / allowed };
        if !(ratio <= 1.0) {
            self.fail(field, format!("{place}error {error:e}, allowed {allowed:e}"));
        }
        if !(ratio <= self.worst.0) {
            self.worst = (if ratio.is_nan() { f64::INFINITY } else { ratio }, field.into());
        }
    }

    /// One row of numbers by the length of the difference.
    fn row(&mut self, field: &str, place: &str, got: &[f64], want: &[f64], allowed: Allowed) {
        if got.len() != want.len() {
            return self.fail(field, format!("{place}{} numbers, expected {}", got.len(), want.len()));
        }
        let error = got.iter().zip(want).fold(0.0, |sum: f64, (g, w)| sum.hypot(g - w));
        self.measure(field, place, error, allowed(want));
    }

    /// A number; undefined results count as wrong where a number is expected.
    pub(super) fn number(&mut self, field: &str, got: Option<f64>, allowed: Allowed) {
        self.vector(field, got.as_ref().map(std::slice::from_ref), allowed);
    }

    /// A point or vector.
    pub(super) fn vector(&mut self, field: &str, got: Option<&[f64]>, allowed: Allowed) {
        let Some(value) = self.want(field) else { return };
        match (numbers(value), got) {
            (Some(want), Some(got)) => self.row(field, "", got, &want, allowed),
            (Some(want), None) => self.fail(field, format!("undefined, expected {want:?}")),
            (None, _) => self.fail(field, "the expected value is not numeric".into()),
        }
    }

    /// A list of numbers or rows, each on its own; null elements are not compared.
    pub(super) fn list(&mut self, field: &str, got: &[Option<Vec<f64>>], allowed: Allowed) {
        let Some(value) = self.want(field) else { return };
        let Some(wanted) = value.as_array() else {
            return self.fail(field, "the expected value is not a list".into());
        };
        if wanted.len() != got.len() {
            return self.fail(field, format!("{} elements, expected {}", got.len(), wanted.len()));
        }
        for (i, (want, got)) in wanted.iter().zip(got).enumerate() {
            let place = format!("element {i}: ");
            match (numbers(want), got) {
                _ if want.is_null() => {}
                (Some(want), Some(got)) => self.row(field, &place, got, &want, allowed),
                (Some(_), None) => self.fail(field, format!("{place}undefined")),
                (None, _) => self.fail(field, format!("{place}the expected value is not numeric")),
            }
        }
    }

    /// A list of points.
    pub(super) fn points<T: Into<Vec<f64>>>(
        &mut self,
        field: &str,
        got: impl IntoIterator<Item = T>,
        allowed: Allowed,
    ) {
        let rows: Vec<_> = got.into_iter().map(|p| Some(p.into())).collect();
        self.list(field, &rows, allowed);
    }

    /// Sample rows: a parameter, then the coordinates there.
    pub(super) fn samples(&mut self, field: &str, at: impl Fn(f64) -> Vec<f64>, allowed: Allowed) {
        let Some(value) = self.want(field) else { return };
        let Some(rows) = value.as_array().filter(|rows| !rows.is_empty()) else {
            return self.fail(field, "the expected value is not a list of samples".into());
        };
        for (i, row) in rows.iter().enumerate() {
            let place = format!("sample {i}: ");
            match numbers(row).as_deref() {
                Some([t, want @ ..]) => self.row(field, &place, &at(*t), want, allowed),
                _ => self.fail(field, format!("{place}the expected value is not a row")),
            }
        }
    }

    /// Sample rows of a surface: two parameters, then the numbers there.
    pub(super) fn surface_samples(&mut self, field: &str, at: impl Fn(f64, f64) -> Vec<f64>, allowed: Allowed) {
        let Some(value) = self.want(field) else { return };
        let Some(rows) = value.as_array().filter(|rows| !rows.is_empty()) else {
            return self.fail(field, "the expected value is not a list of samples".into());
        };
        for (i, row) in rows.iter().enumerate() {
            let place = format!("sample {i}: ");
            match numbers(row).as_deref() {
                Some([s, t, want @ ..]) => self.row(field, &place, &at(*s, *t), want, allowed),
                _ => self.fail(field, format!("{place}the expected value is not a row")),
            }
        }
    }

    /// Rows of so many places, then the numbers there; `None` where there is nothing at a place.
    pub(super) fn rows(
        &mut self,
        field: &str,
        places: usize,
        at: impl Fn(&[f64]) -> Option<Vec<f64>>,
        allowed: Allowed,
    ) {
        let Some(value) = self.want(field) else { return };
        let Some(rows) = value.as_array().filter(|rows| !rows.is_empty()) else {
            return self.fail(field, "the expected value is not a list of rows".into());
        };
        for (i, row) in rows.iter().enumerate() {
            let place = format!("row {i}: ");
            match numbers(row).as_deref().and_then(|row| row.split_at_checked(places)) {
                Some((place_of_row, want)) => match at(place_of_row) {
                    Some(got) => self.row(field, &place, &got, want, allowed),
                    None => self.fail(field, format!("{place}there is no such place")),
                },
                None => self.fail(field, format!("{place}the expected value is not a row")),
            }
        }
    }

    /// Rows of numbers in lists of lists, which are compared in their order.
    pub(super) fn table(&mut self, field: &str, got: &[Vec<f64>], allowed: Allowed) {
        let Some(value) = self.want(field) else { return };
        let mut wanted = Vec::new();
        collect_rows(value, &mut wanted);
        if wanted.len() != got.len() {
            return self.fail(field, format!("{} rows, expected {}", got.len(), wanted.len()));
        }
        for (i, (want, got)) in wanted.iter().zip(got).enumerate() {
            match numbers(want) {
                Some(want) => self.row(field, &format!("row {i}: "), got, &want, allowed),
                None => self.fail(field, format!("row {i}: the expected value is not a row")),
            }
        }
    }

    /// Largest absolute value among the expected numbers of a field, without the first `skip` of every row; 0 if
    /// there are none. This does not count as a comparison.
    pub(super) fn largest_expected(&self, field: &str, skip: usize) -> f64 {
        let mut rows = Vec::new();
        collect_rows(self.expect.get(field).unwrap_or(&Value::Null), &mut rows);
        let entries = rows.into_iter().filter_map(numbers).flat_map(|row| row.into_iter().skip(skip));
        entries.fold(0.0, |m: f64, x| m.max(x.abs()))
    }

    /// A count, flag or word that must be equal.
    pub(super) fn exact(&mut self, field: &str, got: impl Into<Value>) {
        let Some(want) = self.want(field) else { return };
        let got = got.into();
        // As numbers, 3 and 3.0 are equal.
        let same = match (want.as_f64(), got.as_f64()) {
            (Some(w), Some(g)) => w.total_cmp(&g).is_eq(),
            _ => *want == got,
        };
        if !same {
            self.fail(field, format!("{got}, expected {want}"));
        }
    }

    /// A list of flags that must be equal.
    pub(super) fn flags(&mut self, field: &str, got: &[bool]) {
        let Some(want) = self.want(field) else { return };
        let got = Value::from(got);
        if *want != got {
            self.fail(field, format!("{got}, expected {want}"));
        }
    }

    /// A quantity that must not exceed the expected one.
    pub(super) fn at_most(&mut self, field: &str, got: f64) {
        let Some(value) = self.want(field) else { return };
        match value.as_f64() {
            Some(limit) => self.measure(field, "", got, limit),
            None => self.fail(field, "the expected value is not a number".into()),
        }
    }

    /// An expected number that another field's tolerance refers to; this does not count as a comparison.
    pub(super) fn number_expected(&self, field: &str) -> Option<f64> {
        self.expect.get(field).and_then(Value::as_f64)
    }

    /// An object inside a field: its members are compared by `compare` as a case of its own.
    pub(super) fn nested(&mut self, field: &str, place: &str, value: &'a Value, compare: impl FnOnce(&mut Self)) {
        let Some(expect) = value.as_object() else {
            return self.fail(field, format!("{place}the expected value is not an object"));
        };
        let mut inner = Self { expect, compared: BTreeSet::new(), failures: Vec::new(), worst: (0.0, String::new()) };
        compare(&mut inner);
        inner.finish(&[]);
        self.compared.insert(field.into());
        self.failures.extend(inner.failures.iter().map(|f| format!("{field}: {place}{f}")));
        if !(inner.worst.0 <= self.worst.0) {
            self.worst = (inner.worst.0, format!("{field}.{}", inner.worst.1));
        }
    }
}

/// A number as a row of one, a row of numbers as it is.
pub(super) fn numbers(value: &Value) -> Option<Vec<f64>> {
    match value {
        Value::Number(n) => n.as_f64().map(|x| vec![x]),
        Value::Array(row) => row.iter().map(Value::as_f64).collect(),
        _ => None,
    }
}

/// A list of rows of so many numbers.
pub(super) fn rows<const N: usize>(value: &Value) -> Option<Vec<[f64; N]>> {
    value.as_array()?.iter().map(|row| numbers(row)?.try_into().ok()).collect()
}

/// The rows of numbers below a value, in order; what is no number and no list is a row of its own.
fn collect_rows<'a>(value: &'a Value, rows: &mut Vec<&'a Value>) {
    match value {
        Value::Array(list) if list.iter().any(|v| !v.is_number()) => {
            list.iter().for_each(|inner| collect_rows(inner, rows));
        }
        other => rows.push(other),
    }
}
