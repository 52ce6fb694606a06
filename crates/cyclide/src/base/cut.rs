//! Where to cut a curve: global parameters to pieces, with joints recognised.

use crate::error::{Error, ErrorItem, Result};

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
        Err(Error::ParameterOutOfRange { name: ErrorItem::T, value: t, min: 0.0, max: 1.0 })
    }
}

/// Checks an interval of parameters, `0 <= t0 < t1 <= 1`.
///
/// # Errors
/// `parameter-out-of-range`.
pub(crate) fn check_interval(t0: f64, t1: f64) -> Result<()> {
    if t0 < t1 && t0 >= 0.0 && t1 <= 1.0 {
        Ok(())
    } else {
        Err(Error::ParameterOutOfRange { name: ErrorItem::T1, value: t1, min: t0.max(0.0), max: 1.0 })
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
        Err(Error::ParameterOutOfRange { name: ErrorItem::T1, value: t1, min: 0.0, max })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joints_are_recognised_for_every_count() {
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
