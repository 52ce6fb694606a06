//! Cuts of an interval by a density: the integral between two cuts is the same everywhere.

/// A density on `[0, 1]`, known at `k/(len - 1)`. Between, the reciprocal of its root is linear.
///
/// Densities of cuts go with `1/|D|²`, and `|D|` along a parameter line is convex, a hyperbola: its chords are above it. So
/// the integral is never too large; a spike at a sample, however narrow, has more than half of its own, where straight
/// lines between the densities would give it the width of the interval beside it. What is missing is for the
/// certificate to find.
pub(super) struct Density<'a>(pub(super) &'a [f64]);

/// Integral from 0 to `x` over an interval of length 1 between the densities at its ends.
fn part(d0: f64, d1: f64, x: f64) -> f64 {
    let (r0, r1) = (d0.sqrt(), d1.sqrt());
    let below = r1 + x * (r0 - r1);
    if below > 0.0 { x * r0 * r1 * (r0 / below) } else { 0.0 }
}

/// The inverse of [`part`]: the `x` in `[0, 1]` at which the integral is `goal`.
fn fraction(d0: f64, d1: f64, goal: f64) -> f64 {
    let (r0, r1) = (d0.sqrt(), d1.sqrt());
    let x = goal * r1 / (goal * r1 + r0 * (r0 * r1 - goal).max(0.0));
    if x >= 0.0 { x.min(1.0) } else { 1.0 }
}

impl Density<'_> {
    /// The interval between two values that holds `u`, and the place in it.
    fn locate(&self, u: f64) -> (usize, f64) {
        let last = self.0.len() - 2;
        let scaled = u * (last + 1) as f64;
        let k = (scaled as usize).min(last);
        (k, scaled - k as f64)
    }

    /// Integral from 0 to `u`.
    fn integral_to(&self, u: f64) -> f64 {
        let (k, x) = self.locate(u);
        let whole: f64 = self.0[..=k].windows(2).map(|d| part(d[0], d[1], 1.0)).sum();
        (whole + part(self.0[k], self.0[k + 1], x)) / (self.0.len() - 1) as f64
    }

    /// Integral between two places.
    pub(super) fn integral(&self, [a, b]: [f64; 2]) -> f64 {
        self.integral_to(b) - self.integral_to(a)
    }

    /// Appends the `n - 1` cuts between `a` and `b` that share the integral equally among `n` parts, evenly where it
    /// vanishes; those only that are `apart`.
    pub(super) fn cut(&self, [a, b]: [f64; 2], n: usize, cuts: &mut Vec<f64>, apart: impl Fn(f64, f64) -> bool) {
        let step = 1.0 / (self.0.len() - 1) as f64;
        let (from, total) = (self.integral_to(a), self.integral([a, b]));
        let (mut k, _) = self.locate(a);
        let inside = |k: usize| part(self.0[k], self.0[k + 1], 1.0) * step;
        let mut before = self.integral_to(k as f64 * step);
        for j in 1..n {
            let even = j as f64 / n as f64;
            let goal = from + total * even;
            while k + 2 < self.0.len() && before + inside(k) < goal {
                before += inside(k);
                k += 1;
            }
            let place = step * (k as f64 + fraction(self.0[k], self.0[k + 1], (goal - before) / step));
            let place = if total > 0.0 { place } else { a + (b - a) * even };
            let last = cuts.last().copied().unwrap_or(a).max(a);
            if apart(last, place) && apart(place, b) {
                cuts.push(place);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cuts(density: &[f64], range: [f64; 2], n: usize) -> Vec<f64> {
        let mut cuts = vec![range[0]];
        Density(density).cut(range, n, &mut cuts, |a, b| a < b);
        cuts.push(range[1]);
        cuts
    }

    #[test]
    fn parts_have_equal_integrals() {
        let density = [2.0, 3.0, 1.0, 1.0, 8.0];
        for range in [[0.0, 1.0], [0.2, 0.9], [0.3, 0.4]] {
            let cuts = cuts(&density, range, 7);
            assert_eq!(cuts.len(), 8);
            let part = Density(&density).integral(range) / 7.0;
            for c in cuts.windows(2) {
                // Sums of a few numbers up to 2.
                assert!((Density(&density).integral([c[0], c[1]]) - part).abs() < 1e-14, "{cuts:?}");
            }
        }
        assert_eq!(cuts(&[0.0, 0.0], [0.0, 0.5], 2), [0.0, 0.25, 0.5]);
    }

    #[test]
    fn narrow_spikes_have_their_own_integral() {
        // 1/(u² + w²): pi/2w - 1 from 0 to 1.
        for width in [1e-2, 1e-4, 1e-6_f64] {
            let values: Vec<f64> = (0..=16).map(|k| 1.0 / ((f64::from(k) / 16.0).powi(2) + width * width)).collect();
            let ratio = Density(&values).integral([0.0, 1.0]) * width * std::f64::consts::FRAC_2_PI;
            // 2/pi for the chord from the tip of a hyperbola, less beside it.
            assert!((0.6..=1.0).contains(&ratio), "{width:e}: {ratio}");
        }
    }
}
