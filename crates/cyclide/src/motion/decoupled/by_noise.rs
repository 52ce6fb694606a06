//! How much noisy poses are smoothed where nothing but their noise says so (`docs/math/motions.md#noisy-poses`).
//!
//! Of all smoothing splines the one is taken whose expected distance from the poses without their noise is least, by the unbiased estimate of that (C. L. Mallows,
//! *Some comments on C_p*, Technometrics 15 (1973)): with the noise `s` in each of `r` directions and residuals `e_i` it is `Σ|e_i|² − n r s² + 2 r s² tr S`. The
//! trace of the smoother is read from what it makes of random signs (M. F. Hutchinson, *Communications in Statistics* 18 (1989)), the same for all strengths, so
//! that the estimate is smooth in the strength.

use super::pose_noise::Noise;
use super::smoothed::{Rounds, STRENGTHS, Values};
use super::smoothing_spline::smoothed;
use crate::base::golden_section::GoldenSection;

/// The decimal power of the weakest strength: rounded poses that are far apart call for next to none.
const WEAKEST: f64 = -14.0;
/// The strength by which a value that does not count is smoothed.
const FREE: f64 = 1e6;
/// Strengths that are tried first, so many to a power of ten.
const TRIED: u32 = 3;
/// Sections of the bracket: a thousandth of a power of ten.
const SECTIONS: u32 = 12;
/// Rows of random signs.
const ROWS: usize = 4;
/// Noise below this part of the extent of the values is rounding, of which there is nothing to be smoothed.
const ROUNDING: f64 = 1e-12;

impl<const D: usize> Values<'_, D> {
    /// The values smoothed as their noise calls for; those that do not count have next to no influence.
    pub(super) fn by_noise(&self, noise: Noise, counts: &[bool]) -> Vec<[f64; D]> {
        let extent = self.values.iter().map(|value| (self.apart)(&self.values[0], value)).fold(0.0, f64::max);
        if self.values.len() < 3 || !(noise.sigma > ROUNDING * extent) {
            return self.values.clone();
        }
        let count = counts.len();
        let Rounds { values, steps, middle } = if self.closed {
            self.several_rounds()
        } else {
            Rounds { values: self.values.clone(), steps: self.steps.clone(), middle: 0..count }
        };
        let weights = |strength: f64| -> Vec<f64> {
            (0..values.len()).map(|i| if counts[i % count] { 1.0 } else { strength / FREE }).collect()
        };
        let signs = signs(count);
        let signs: Vec<[f64; ROWS]> = (0..values.len()).map(|i| signs[i % count]).collect();
        let by = |power: f64| {
            let strength = 10.0_f64.powf(power);
            smoothed(&values, &steps, &weights(strength), strength)
        };
        let variance = noise.rank * noise.sigma * noise.sigma;
        let risk = |power: f64| {
            let smooth = by(power);
            let strength = 10.0_f64.powf(power);
            let image = smoothed(&signs, &steps, &weights(strength), strength);
            let own = |i: usize| (self.apart)(&smooth[i], &self.values[i - middle.start]).powi(2);
            let trace = |i: usize| signs[i].iter().zip(&image[i]).map(|(z, x)| z * x).sum::<f64>() / ROWS as f64;
            let counted = || middle.clone().filter(|i| counts[i % count]);
            counted().map(own).sum::<f64>() + 2.0 * variance * counted().map(trace).sum::<f64>()
        };
        let [weak, strong] = [WEAKEST, STRENGTHS[1]];
        let powers = (0..=((strong - weak) * f64::from(TRIED)) as u32).map(|k| weak + f64::from(k) / f64::from(TRIED));
        let least = powers.map(|power| (risk(power), power)).min_by(|a, b| a.0.total_cmp(&b.0));
        let middle_power = least.map_or(weak, |least| least.1);
        let step = 1.0 / f64::from(TRIED);
        let power = GoldenSection::lowest(risk, [middle_power - step, middle_power + step], SECTIONS);
        let smooth = by(power);
        if self.closed { self.closed_round(&smooth[middle.clone()]) } else { smooth }
    }
}

/// Rows of signs without a pattern, the same in every run.
fn signs(count: usize) -> Vec<[f64; ROWS]> {
    let mut state = 1_u64;
    let mut sign = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        if state >> 63 == 0 { 1.0 } else { -1.0 }
    };
    (0..count).map(|_| std::array::from_fn(|_| sign())).collect()
}
