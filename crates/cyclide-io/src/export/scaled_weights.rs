//! Weights of a curve or patch times one factor, which changes no point.

/// The weights times a power of two, which is exact, so that the largest is in [1, 2).
pub(crate) fn scaled_weights(weights: &[f64]) -> Vec<f64> {
    let largest = weights.iter().fold(0.0, |m: f64, w| m.max(w.abs()));
    if !largest.is_normal() {
        return weights.to_vec();
    }
    let exponent = ((largest.to_bits() >> 52) & 0x7ff) as i32 - 1023;
    weights.iter().map(|w| w * 2.0_f64.powi(-exponent)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_are_scaled_exactly() {
        let weights = [3e-40, 1e-40, 2e-40];
        let out = scaled_weights(&weights);
        assert!(out[0] >= 1.0 && out[0] < 2.0);
        assert_eq!((out[1] / out[0]).to_bits(), (weights[1] / weights[0]).to_bits());
    }
}
