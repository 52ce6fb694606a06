//! Points whose coordinates are rounded to some decimals: of an outline with them, every sample on a slanted side is a corner that
//! lasts over the rounding alone (`docs/math/fair-fits.md#noise`).

use crate::base::vector::Point3;

/// Most decimals that are looked for.
const MOST: i32 = 9;
/// A coordinate is a multiple of a step if it is one to this part of it, or to a few roundings of its own.
const MULTIPLE: f64 = 1e-6;
const ROUNDINGS: f64 = 4.0;
/// Steps above this part of the mean edge are no rounding, but what was drawn.
const OF_EDGE: f64 = 0.02;

/// The step of coordinates that are all rounded to the same decimals, if it is far finer than the edges.
pub(in crate::construct) fn decimal_step(points: &[Point3]) -> Option<f64> {
    let is_multiple = |value: f64, step: f64| {
        let count = value / step;
        (count - count.round()).abs() <= MULTIPLE.max(ROUNDINGS * f64::EPSILON * count.abs())
    };
    let step = (0..=MOST)
        .map(|k| 10.0_f64.powi(-k))
        .find(|step| points.iter().all(|p| p.to_array().into_iter().all(|value| is_multiple(value, *step))))?;
    let edges = points.windows(2).map(|w| w[0].distance(w[1])).sum::<f64>();
    let count = points.len().saturating_sub(1).max(1) as f64;
    (step * count <= OF_EDGE * edges).then_some(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_that_all_coordinates_have_are_found() {
        let points = |digits: f64| -> Vec<Point3> {
            let at = |i: i32| {
                let (sin, cos) = (0.1 * f64::from(i)).sin_cos();
                Point3::new((50.0 * cos * digits).round() / digits, (50.0 * sin * digits).round() / digits, 0.0)
            };
            (0..60).map(at).collect()
        };
        for digits in [1e2, 1e3, 1e6] {
            let found = decimal_step(&points(digits)).unwrap();
            assert!((found * digits - 1.0).abs() < 1e-9, "{digits}: {found}");
        }
        // What is drawn on a grid is not rounded, and exact points are not either.
        assert_eq!(decimal_step(&points(1.0)), None);
        assert_eq!(decimal_step(&points(1e12)), None);
    }
}
