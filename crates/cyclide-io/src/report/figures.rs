//! Figures and lines of the text.

use std::fmt;

use cyclide::ShortNumber;

use super::range::RangeReport;

/// Writes one line of a report: its label and its text.
pub(super) type Line<'a> = &'a mut dyn FnMut(&str, String) -> fmt::Result;

pub(super) fn short(value: f64) -> String {
    ShortNumber(value).to_string()
}

/// Smallest and largest value, or the one where they look alike.
pub(super) fn range(range: &RangeReport) -> String {
    match [range.min, range.max].map(short) {
        [min, max] if min == max => min,
        [min, max] => format!("{min} to {max}"),
    }
}

pub(super) fn plural(count: usize, one: &str) -> String {
    format!("{count} {one}{}", if count == 1 { "" } else { "s" })
}

/// An area or a volume.
pub(super) fn measure(value: f64, units: &str, power: &str) -> String {
    if value.is_nan() { "not known".to_owned() } else { format!("{} {units}{power}", short(value)) }
}
