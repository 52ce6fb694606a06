//! Where to cut a curve: global parameters to pieces, with joints recognized.

use crate::error::{ErrorItem, NumberError, Result};

/// The piece and its own parameter in `[0, 1)` at which a global parameter in `(0, 1)` cuts a curve of `n` pieces.
/// Parameters within rounding of a joint cut there: a sliver of a piece is never meant.
///
/// # Errors
/// `parameter-out-of-range`, also at the ends of the curve.
pub(crate) fn place_of_cut(t: f64, n: usize) -> Result<(usize, f64)> {
    let x = t * n as f64;
    let joint = x.round();
    // t = i/n and t n are each rounded once.
    let (piece, s) =
        if (x - joint).abs() <= 2.0 * f64::EPSILON * x { (joint as usize, 0.0) } else { (x as usize, x.fract()) };
    let inside = t > 0.0 && t < 1.0 && piece < n && (piece > 0 || s > 0.0);
    if inside {
        Ok((piece, s))
    } else {
        Err(NumberError::ParameterOutOfRange { name: ErrorItem::T, value: t, min: 0.0, max: 1.0 }.into())
    }
}

/// Parameters up to this far from an end of the curve are the end: a few roundings, as sums and quotients of them have. A sliver is never meant.
const AT_END: f64 = 4.0 * f64::EPSILON;

/// A parameter, the end of the curve if it is one but for rounding.
pub(crate) fn at_end(t: f64) -> f64 {
    [0.0, 1.0].into_iter().find(|end| (t - end).abs() <= AT_END).unwrap_or(t)
}

/// An interval of parameters, `0 <= t0 < t1 <= 1`, what is an end of the curve but for rounding taken for it.
///
/// # Errors
/// `parameter-out-of-range`.
pub(crate) fn interval(t0: f64, t1: f64) -> Result<[f64; 2]> {
    let [t0, t1] = [t0, t1].map(at_end);
    if t0 < t1 && t0 >= 0.0 && t1 <= 1.0 {
        Ok([t0, t1])
    } else {
        Err(NumberError::ParameterOutOfRange { name: ErrorItem::T1, value: t1, min: t0.max(0.0), max: 1.0 }.into())
    }
}

/// Checks an interval of parameters that leads past the start of a closed curve, `0 < t1 < t0 < 1`.
///
/// # Errors
/// `parameter-out-of-range`, also for every interval of an open curve.
pub(crate) fn check_past_start(closed: bool, t0: f64, t1: f64) -> Result<()> {
    if closed && t1 < t0 && t1 > 0.0 && t0 < 1.0 {
        Ok(())
    } else {
        let max = if closed { t0.min(1.0) } else { 0.0 };
        Err(NumberError::ParameterOutOfRange { name: ErrorItem::T1, value: t1, min: 0.0, max }.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_are_recognized() {
        let exact = |ends: [f64; 2]| ends.map(f64::to_bits);
        for off in [-3.0 * f64::EPSILON, -1e-300, 0.0, 1e-17, 4.0 * f64::EPSILON] {
            assert_eq!(exact(interval(off, 0.5).unwrap()), exact([0.0, 0.5]), "{off:e}");
            assert_eq!(exact(interval(0.5, 1.0 + off).unwrap()), exact([0.5, 1.0]), "{off:e}");
        }
        assert_eq!(exact(interval(1e-15, 1.0 - 1e-15).unwrap()), exact([1e-15, 1.0 - 1e-15]));
        for (t0, t1) in
            [(0.0, 1e-17), (1.0 - 1e-16, 1.0), (-1e-15, 0.5), (0.5, 1.0 + 1e-15), (f64::NAN, 0.5), (0.5, 0.5)]
        {
            assert_eq!(interval(t0, t1).unwrap_err().reason(), "parameter-out-of-range", "{t0:e} {t1:e}");
        }
        // What is left is taken by every count of pieces.
        for n in 1..2000_usize {
            assert!(place_of_cut(1.0 - 5.0 * f64::EPSILON, n).is_ok(), "{n}");
        }
    }

    #[test]
    fn joints_are_recognized_for_every_count() {
        for n in 2..2000_usize {
            for i in [1, n / 3 + 1, n - 1] {
                assert_eq!(place_of_cut(i as f64 / n as f64, n).unwrap(), (i.min(n - 1), 0.0), "{i}/{n}");
            }
        }
        assert_eq!(place_of_cut(0.3, 2).unwrap(), (0, 0.6));
        for t in [0.0, 1.0, -0.1, f64::NAN, 1e-300 * 0.0] {
            assert_eq!(place_of_cut(t, 3).unwrap_err().reason(), "parameter-out-of-range");
        }
    }
}
