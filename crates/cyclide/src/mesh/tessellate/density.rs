//! Cuts of an interval by a density: the integral between two cuts is the same everywhere.

/// The `x` in `[0, 1]` at which the integral of the linear function from `d[0]` at 0 to `d[1]` at 1 is `goal`.
pub(super) fn fraction(d: &[f64], goal: f64) -> f64 {
    let root = (d[0] * d[0] + 2.0 * (d[1] - d[0]) * goal).max(0.0).sqrt();
    let x = 2.0 * goal / (d[0] + root);
    if x >= 0.0 { x.min(1.0) } else { 1.0 }
}

/// A density on `[0, 1]`, linear between its values at `k/(len - 1)`.
pub(super) struct Density<'a>(pub(super) &'a [f64]);

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
        let whole: f64 = self.0[..=k].windows(2).map(|d| 0.5 * (d[0] + d[1])).sum();
        (whole + x * (self.0[k] + 0.5 * x * (self.0[k + 1] - self.0[k]))) / (self.0.len() - 1) as f64
    }

    /// Integral between two places.
    pub(super) fn integral(&self, [a, b]: [f64; 2]) -> f64 {
        self.integral_to(b) - self.integral_to(a)
    }

    /// Appends the `n - 1` cuts between `a` and `b` that share the integral equally among `n` parts, evenly where it
    /// vanishes.
    pub(super) fn cut(&self, [a, b]: [f64; 2], n: usize, cuts: &mut Vec<f64>) {
        let step = 1.0 / (self.0.len() - 1) as f64;
        let (from, total) = (self.integral_to(a), self.integral([a, b]));
        let (mut k, _) = self.locate(a);
        let inside = |k: usize| 0.5 * (self.0[k] + self.0[k + 1]) * step;
        let mut before = self.integral_to(k as f64 * step);
        for j in 1..n {
            let even = j as f64 / n as f64;
            let goal = from + total * even;
            while k + 2 < self.0.len() && before + inside(k) < goal {
                before += inside(k);
                k += 1;
            }
            let place = step * (k as f64 + fraction(&self.0[k..], (goal - before) / step));
            let place = if total > 0.0 { place } else { a + (b - a) * even };
            // Rounding must not let two cuts meet.
            let last = cuts.last().copied().unwrap_or(a).max(a);
            if place > last && place < b {
                cuts.push(place);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_equal_integrals() {
        let density = Density(&[0.0, 3.0, 1.0, 1.0, 8.0]);
        for range in [[0.0, 1.0], [0.2, 0.9], [0.3, 0.4]] {
            let mut cuts = vec![range[0]];
            density.cut(range, 7, &mut cuts);
            cuts.push(range[1]);
            assert_eq!(cuts.len(), 8);
            let part = density.integral(range) / 7.0;
            for c in cuts.windows(2) {
                assert!((density.integral([c[0], c[1]]) - part).abs() < 1e-15, "{cuts:?}");
            }
        }
        let mut even = Vec::new();
        Density(&[0.0, 0.0]).cut([0.0, 0.5], 2, &mut even);
        assert_eq!(even, [0.25]);
    }
}
