//! The Euclidean length of a few numbers.

/// Squares in this range were neither rounded to zero nor to infinity, nor was any part of them that counts.
const SAFE: std::ops::RangeInclusive<f64> = 1e-280..=1e280;

/// Root of the sum of squares, without overflow or underflow of the squares; NaN if one of them is.
///
/// Within three units of rounding, the same on every machine. `hypot` is some ten times slower, as it handles every size
/// alike; here only what needs it is scaled.
#[inline]
pub(crate) fn length<const N: usize>(v: [f64; N]) -> f64 {
    let square = |v: [f64; N]| v.iter().map(|x| x * x).sum::<f64>();
    let plain = square(v);
    if SAFE.contains(&plain) || plain.is_nan() {
        return plain.sqrt();
    }
    let largest = v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    if largest > 0.0 && largest.is_finite() { square(v.map(|x| x / largest)).sqrt() * largest } else { largest }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_of_any_size() {
        for scale in [1.0, 1e-320, 1e-300, 1e-150, 1e-140, 1e140, 1e150, 1e307] {
            let expected = 7.0 * scale;
            let found = length([2.0 * scale, -3.0 * scale, 6.0 * scale]);
            // Denormal numbers have fewer digits.
            assert!((found - expected).abs() <= 4.0 * f64::EPSILON * expected + 1e-322, "{scale:e}: {found:e}");
        }
        assert_eq!(length([0.0, -0.0]).to_bits(), 0);
        assert_eq!(length([1.0, f64::NEG_INFINITY]).to_bits(), f64::INFINITY.to_bits());
        assert!(length([f64::NAN, 1.0, 0.0]).is_nan() && length([f64::NAN, f64::INFINITY]).is_nan());
        // A part whose square vanishes next to one at the end of the range counts for nothing.
        assert_eq!(length([1e-140, 1e-170]).to_bits(), 1e-140_f64.to_bits());
    }
}
