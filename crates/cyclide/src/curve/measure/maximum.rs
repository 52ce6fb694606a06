//! The largest value of a smooth function on the unit interval from values and slopes.

use crate::base::roots::bracketed;

/// Intervals of the first scan.
const SCAN: usize = 16;
/// Halvings of an interval on which the function does not look like a cubic.
const DEPTH: u32 = 12;
/// Relative mismatch with the cubic at the middle that still counts as a cubic.
const CUBIC_LIMIT: f64 = 0.01;
/// Width to which the place is found; the value there is accurate to its square.
const PLACE_WIDTH: f64 = 1e-14;

/// A value and its derivative.
pub(super) type ValueSlope = (f64, f64);

/// Place and value of the maximum of `f` on `[0, 1]`, where `f` gives value and derivative.
///
/// Scanned at 17 places; intervals where the middle value disagrees with the cubic through the ends are halved, and
/// maxima inside (slope from plus to minus) are bracketed and refined. Values must be finite.
pub(super) fn maximum(f: &mut impl FnMut(f64) -> ValueSlope) -> (f64, f64) {
    let mut samples = [(0.0, 0.0, 0.0); SCAN + 1];
    for (i, sample) in samples.iter_mut().enumerate() {
        let s = i as f64 / SCAN as f64;
        let (value, slope) = f(s);
        *sample = (s, value, slope);
    }
    let mut best = (0.0, samples[0].1);
    for &(s, value, _) in &samples {
        improve(&mut best, s, value);
    }
    for w in samples.windows(2) {
        search(f, w[0], w[1], DEPTH, &mut best);
    }
    best
}

fn improve(best: &mut (f64, f64), s: f64, value: f64) {
    if value > best.1 {
        *best = (s, value);
    }
}

/// Searches one interval between samples `(place, value, slope)`.
fn search(
    f: &mut impl FnMut(f64) -> ValueSlope,
    a: (f64, f64, f64),
    b: (f64, f64, f64),
    depth: u32,
    best: &mut (f64, f64),
) {
    let h = b.0 - a.0;
    // Bernstein coefficients of the cubic with these end values and slopes.
    let c = [a.1, a.1 + h * a.2 / 3.0, b.1 - h * b.2 / 3.0, b.1];
    let (low, high) = c.iter().fold((c[0], c[0]), |(l, u), v| (l.min(*v), u.max(*v)));
    let s = 0.5 * (a.0 + b.0);
    let (value, slope) = f(s);
    improve(best, s, value);
    let mismatch = (value - (c[0] + 3.0 * (c[1] + c[2]) + c[3]) / 8.0).abs();
    let rounding = 1e-13 * low.abs().max(high.abs());
    let m = (s, value, slope);
    if depth > 0 && mismatch > CUBIC_LIMIT * (high - low) + rounding {
        search(f, a, m, depth - 1, best);
        search(f, m, b, depth - 1, best);
        return;
    }
    if high + mismatch <= best.1 {
        return;
    }
    for (a, b) in [(a, m), (m, b)] {
        if a.2 > 0.0 && b.2 < 0.0 {
            let s = bracketed(|s| f(s).1, a.0, b.0, PLACE_WIDTH);
            let value = f(s).0;
            improve(best, s, value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_peak_between_the_samples() {
        // A Lorentz peak 1/(1 + ((s-c)/w)²) a tenth as wide as the scan's step.
        let (c, w) = (0.456_789, 0.006);
        let mut f = |s: f64| {
            let x = (s - c) / w;
            let q = 1.0 / (1.0 + x * x);
            (q, -2.0 * x * q * q / w)
        };
        let (s, value) = maximum(&mut f);
        assert!((s - c).abs() < 1e-12 && (value - 1.0).abs() < 1e-15, "{s} {value}");
    }

    #[test]
    fn takes_the_higher_of_two_peaks_and_the_ends() {
        let mut f = |s: f64| ((9.0 * s).sin() + s, 9.0 * (9.0 * s).cos() + 1.0);
        let (s, value) = maximum(&mut f);
        // slope 0: cos(9 s) = -1/9, second maximum at 9 s = 2 pi + acos(-1/9)
        let want = (std::f64::consts::TAU + (-1.0_f64 / 9.0).acos()) / 9.0;
        assert!((s - want).abs() < 1e-12, "{s} {want} {value}");
        let (s, value) = maximum(&mut |s: f64| (2.0 * s, 2.0));
        assert_eq!((s, value), (1.0, 2.0));
    }
}
