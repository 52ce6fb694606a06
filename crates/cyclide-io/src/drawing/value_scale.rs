//! A scale for numbers that are shown as colors: its range, round numbers on it, and the color of each value.

use super::colour_map::Ramp;

/// Colors of the table.
const COLOURS: usize = 512;
/// Ranges narrower than this part of the values are one value: rounding.
const ONE_VALUE: f64 = 1e-6;
/// Values of one sign that are smaller than this part of those of the other are rounding of zero.
const ONE_SIGN: f64 = 1e-6;
/// The parts of the weight that are left out at each end where a few values would take the scale from the others, and how much wider
/// the whole range is than the rest then.
const OUTLIERS: f64 = 0.01;
const MUCH_WIDER: f64 = 4.0;

/// The scale of a picture.
#[derive(Debug, Clone)]
pub(crate) struct ValueScale {
    /// The values at the ends of the scale.
    pub(crate) shown: [f64; 2],
    /// The least and the greatest value that there is, infinite where there is no bound.
    pub(crate) all: [f64; 2],
    ramp: Ramp,
    colours: Vec<[f64; 3]>,
}

impl ValueScale {
    /// The scale of values with weights; `None` if there are none. What is smaller than `zero` is rounding of 0.
    ///
    /// It shows the whole range, unless that is four times as wide as the range of 98 % of the weight.
    pub(crate) fn new(mut values: Vec<(f64, f64)>, zero: f64) -> Option<Self> {
        values.retain(|(value, weight)| !value.is_nan() && *weight >= 0.0);
        for (value, _) in &mut values {
            if value.abs() <= zero {
                *value = 0.0;
            }
        }
        values.sort_by(|a, b| a.0.total_cmp(&b.0));
        let all = [values.first()?.0, values.last()?.0];
        let total: f64 = values.iter().map(|(_, weight)| weight).sum();
        let quantile = |part: f64| {
            let mut sum = 0.0;
            let reached = values.iter().find(|(_, weight)| {
                sum += weight;
                sum >= part * total
            });
            reached.map_or(all[1], |(value, _)| *value)
        };
        let most = [quantile(OUTLIERS), quantile(1.0 - OUTLIERS)];
        let finite = all.iter().all(|v| v.is_finite());
        let wide = |range: [f64; 2]| range[1] - range[0];
        // Where nearly all values are one, the others are what there is to see.
        let few = wide(most) > ONE_VALUE * wide(all) && wide(all) > MUCH_WIDER * wide(most);
        let mut shown = if !finite || few { most } else { all };
        if shown.iter().any(|v| !v.is_finite()) {
            let bounded = || values.iter().map(|(v, _)| *v).filter(|v| v.is_finite());
            shown = [bounded().next()?, bounded().next_back()?];
        }
        let largest = shown[0].abs().max(shown[1].abs());
        for v in &mut shown {
            if v.abs() <= ONE_SIGN * largest {
                *v = 0.0;
            }
        }
        let both = shown[0] < 0.0 && shown[1] > 0.0;
        let ramp = if both || largest == 0.0 { Ramp::Diverging } else { Ramp::Sequential };
        Some(Self { shown, all, ramp, colours: ramp.table(COLOURS) })
    }

    /// True if all values are one but for rounding.
    pub(crate) fn is_one_value(&self) -> bool {
        let [low, high] = self.shown;
        high - low <= ONE_VALUE * low.abs().max(high.abs())
    }

    /// Whether there are values below and above the scale.
    pub(crate) fn is_clipped(&self) -> [bool; 2] {
        let rounding = ONE_VALUE * (self.shown[1] - self.shown[0]);
        [self.all[0] < self.shown[0] - rounding, self.all[1] > self.shown[1] + rounding]
    }

    /// The color of a value in linear light. Zero is the middle of a scale with both signs.
    pub(crate) fn colour(&self, value: f64) -> [f64; 3] {
        let [low, high] = self.shown;
        let place = match self.ramp {
            _ if self.is_one_value() => 0.5,
            // Darker the farther from zero.
            Ramp::Sequential if high <= 0.0 => (high - value) / (high - low),
            Ramp::Sequential => (value - low) / (high - low),
            Ramp::Diverging => 0.5 + 0.5 * value / high.max(-low),
        };
        let last = self.colours.len() - 1;
        let at = place.clamp(0.0, 1.0) * last as f64;
        let (first, part) = (at as usize, at.fract());
        let (a, b) = (self.colours[first.min(last)], self.colours[(first + 1).min(last)]);
        std::array::from_fn(|k| a[k] + (b[k] - a[k]) * part)
    }

    /// About so many round values of the scale, rising.
    pub(crate) fn ticks(&self, count: f64) -> Vec<f64> {
        let [low, high] = self.shown;
        if self.is_one_value() {
            return vec![0.5 * (low + high)];
        }
        let least = (high - low) / count.max(1.0);
        let decade = 10_f64.powf(least.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * decade).find(|s| *s >= least).unwrap_or(least);
        let slack = 1e-9 * (high - low);
        let (first, last) = (((low - slack) / step).ceil(), ((high + slack) / step).floor());
        (0..=(last - first).max(0.0) as usize)
            .map(|k| (first + k as f64) * step)
            .filter(|v| *v <= high + slack)
            .collect()
    }
}

#[cfg(test)]
#[allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    reason = "a test fails by panicking; values are taken over as they are"
)]
mod tests {
    use super::*;

    fn scale(values: &[f64]) -> ValueScale {
        ValueScale::new(values.iter().map(|v| (*v, 1.0)).collect(), 1e-12).unwrap()
    }

    #[test]
    fn zero_is_pale_on_a_scale_of_both_signs() {
        let scale = scale(&[-1.0, 0.0, 3.0]);
        let [r, g, b] = scale.colour(0.0);
        // A warm grey: its chroma of 0.006 takes 0.036 of the blue.
        assert!((r - g).abs() < 0.01 && (g - b - 0.036).abs() < 0.001 && r > 0.8);
        // One step of a value is one step of color on both sides: -1 is as pale as 1.
        let luminance =
            |v: f64| scale.colour(v).iter().zip([0.2126, 0.7152, 0.0722]).map(|(c, part)| c * part).sum::<f64>();
        assert!((luminance(-1.0) / luminance(1.0) - 1.0).abs() < 0.12);
        assert!(scale.colour(3.0)[0] > 3.0 * scale.colour(3.0)[2] && scale.colour(-1.0)[2] > scale.colour(-1.0)[0]);
    }

    #[test]
    fn a_few_outliers_do_not_take_the_scale() {
        let even: Vec<f64> = (0..1000).map(|k| 1.0 + 0.001 * f64::from(k)).collect();
        let shown = scale(&even).shown;
        assert!(shown[0] == 1.0 && (shown[1] - 1.999).abs() < 1e-12);
        let spoiled = scale(&[&even[..], &[f64::INFINITY, -1e9]].concat());
        assert!(spoiled.shown[0] >= 1.0 && spoiled.shown[1] < 2.0 && spoiled.is_clipped() == [true; 2]);
        assert_eq!(spoiled.all, [-1e9, f64::INFINITY]);
        // A flat plate with a dent: the dent is what there is to see.
        let dent = scale(&[&[0.0; 1000][..], &[-0.5]].concat());
        assert_eq!((dent.shown, dent.is_clipped()), ([-0.5, 0.0], [false; 2]));
    }

    #[test]
    fn ticks_are_round_and_on_the_scale() {
        assert_eq!(scale(&[-0.31, 0.52]).ticks(5.0), [-0.2, 0.0, 0.2, 0.4]);
        let few = scale(&[1e-7, 9.7e-7]).ticks(6.0);
        assert!(few.len() >= 4 && few.iter().all(|v| (v / 2e-7 - (v / 2e-7).round()).abs() < 1e-9), "{few:?}");
        for value in [0.25, 0.0, -7.0] {
            let one = scale(&[value, value * (1.0 + 1e-15)]);
            assert!(one.is_one_value() && (one.ticks(5.0)[0] - value).abs() < 1e-12);
        }
    }
}
