//! Round coordinates: where rulers have their numbers and the floor its lines.

/// The smallest of 1, 2, 5, 10, 20, … and their tenths that is not below `least`.
pub(super) fn round_step(least: f64) -> f64 {
    let decade = 10_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * decade).find(|s| *s >= least).unwrap_or(least)
}

/// The multiples of a step between two values.
pub(super) fn multiples(low: f64, high: f64, step: f64) -> impl Iterator<Item = f64> {
    let count = ((high - low) / step) as usize + 1;
    let first = (low / step).ceil();
    (0..count).map(move |i| (first + i as f64) * step).filter(move |v| *v <= high)
}
