//! Phrases of messages that depend on what was measured.

use crate::short_number::ShortNumber;

/// In words, that a value is outside its interval.
pub(super) fn outside(min: f64, max: f64) -> String {
    if max >= f64::MAX {
        return format!("out of range: at least {:#}", ShortNumber(min));
    }
    format!("outside {:#} to {:#}", ShortNumber(min), ShortNumber(max))
}

/// What it means if all edges of a polyhedron are reflex.
pub(super) fn clockwise(reflex: usize, edges: usize) -> &'static str {
    if reflex == edges { "; are the faces clockwise, seen from outside?" } else { "" }
}

/// A size next to its place; where all its points round to the same numbers nothing is left of it.
pub(super) fn size_in_place(size: f64) -> String {
    if size > 0.0 { format!("{} large", ShortNumber(size)) } else { "one single point".to_owned() }
}

/// The number of a segment, where there is one.
pub(super) fn numbered(segment: Option<usize>) -> String {
    segment.map_or(String::new(), |segment| format!(" {segment}"))
}

/// A count in words; one that was given up is infinite.
pub(super) fn at_least(needed: f64) -> String {
    if needed.is_finite() { ShortNumber(needed).to_string() } else { "ever more".to_owned() }
}

/// The first of some points and how many more there are.
pub(super) fn points_in_words(points: &[usize]) -> String {
    let shown: Vec<String> = points.iter().take(8).map(usize::to_string).collect();
    let more = points.len().saturating_sub(shown.len());
    let and = if more > 0 { format!(" and {more} more") } else { String::new() };
    format!("point(s) {}{and}", shown.join(", "))
}

/// The ratio of speeds `1 + stretch` in words, where it is worth any.
pub(super) fn speed_ratio(stretch: f64, limit: f64) -> String {
    if stretch.abs() <= limit {
        return String::new();
    }
    let sign = if stretch < 0.0 { '-' } else { '+' };
    format!(" and the speed of the lines across by the factor 1 {sign} {}", ShortNumber(stretch.abs()))
}
