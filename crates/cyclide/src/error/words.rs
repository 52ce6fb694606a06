//! Phrases that messages of several subjects share.

use crate::short_number::ShortNumber;

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

/// The parameter of a direction, and the other two in order.
pub(super) const fn parameters(axis: usize) -> [char; 3] {
    match axis {
        0 => ['s', 't', 'u'],
        1 => ['t', 's', 'u'],
        _ => ['u', 's', 't'],
    }
}
