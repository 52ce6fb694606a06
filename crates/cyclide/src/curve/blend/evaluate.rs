//! Points and derivatives of a blend.

use super::segment::BlendSegment;
use crate::base::jet::CurveJet;
use crate::base::vector::{Point3, Vec3};

impl BlendSegment {
    /// The point at `l` in `[0, 1]`; the end points come out as given, to the bit.
    #[must_use]
    pub fn point(&self, l: f64) -> Point3 {
        self.point_of_whole(self.whole_parameter(l))
    }

    /// The point at a parameter of the whole segment: one division, measured from the nearer end.
    pub(super) fn point_of_whole(&self, l: f64) -> Point3 {
        let m = 1.0 - l;
        let [c, s, q] = self.law.at(l);
        // q t and q N: the common factor q of numerator and denominator stays in.
        let t = self.t1 * c + self.b * s;
        if l <= 0.5 {
            let n = self.u * (l * q) + t * m;
            self.x1 + n * (self.length * l * q / n.length_squared())
        } else {
            // The same arc from its other end: start tangent 2<u,t>u - t reversed, chord -u.
            let n = t * l - self.u * (m * q + 2.0 * l * self.u.dot(t));
            self.x2 + n * (self.length * m * q / n.length_squared())
        }
    }

    /// Speed by `l` in `[0, 1]`.
    ///
    /// `x - x1` is the inverse of `(u + t (1-l)/l)/|d|`, whose derivative has two parts at right angles, along `t`
    /// and along `t'`: with `phi'` the rate of the angle, `|x'| = |d| sqrt(1 + (l (1-l) phi')²)/|N|²`. (Own derivation.)
    #[must_use]
    pub fn speed(&self, l: f64) -> f64 {
        let [a, b] = self.range;
        let l = self.whole_parameter(l);
        let m = 1.0 - l;
        let [c, s, q] = self.law.at(l);
        let n = self.u * (l * q) + (self.t1 * c + self.b * s) * m;
        let turn = l * m * self.law.rate(l);
        (b - a) * self.length * (1.0 + turn * turn).sqrt() * (q * q / n.length_squared())
    }

    /// Point and derivatives by `l` in `[0, 1]`, all in closed form (`docs/math/circle-blends.md#derivatives`).
    #[must_use]
    pub fn jet(&self, l: f64) -> CurveJet {
        let [a, b] = self.range;
        self.jet_of_whole(self.whole_parameter(l)).scaled(b - a)
    }

    fn jet_of_whole(&self, l: f64) -> CurveJet {
        let m = 1.0 - l;
        let (c, s) = self.law.series(l);
        let t: [Vec3; 4] = std::array::from_fn(|j| self.t1 * c[j] + self.b * s[j]);
        // Taylor coefficients of N = l u + m t, of |N|² and of G = N/|N|².
        let n = [self.u * l + t[0] * m, self.u + t[1] * m - t[0], t[2] * m - t[1], t[3] * m - t[2]];
        let d: [f64; 4] = std::array::from_fn(|j| (0..=j).map(|i| n[i].dot(n[j - i])).sum());
        let mut g = [Vec3::ZERO; 4];
        for j in 0..4 {
            g[j] = (1..=j).fold(n[j], |sum, i| sum - g[j - i] * d[i]) / d[0];
        }
        let derivative = |j: usize, factorial: f64| (g[j] * l + g[j - 1]) * (factorial * self.length);
        CurveJet {
            point: self.point_of_whole(l),
            d1: derivative(1, 1.0),
            d2: derivative(2, 2.0),
            d3: derivative(3, 6.0),
        }
    }

    /// Calls with rising parameters up to 1 that are so close that neither the start tangent `t` of the arcs nor the
    /// direction of `N` (of the point seen from `x1`) turns by more than `turn` radians from one to the next, so the
    /// arcs' tangents, mirror images of `t` in `N`, turn by at most three times as much.
    ///
    /// Bisection cannot miss a part: between `t` and `u` the vector `N` turns by less than half a turn, and what it
    /// turns more follows `t`, whose angle is known.
    pub(crate) fn steps_of_turn(&self, turn: f64, step: &mut impl FnMut(f64)) {
        const DEPTH: u32 = 50;
        let at = |l: f64| {
            let whole = self.whole_parameter(l);
            let [c, s, q] = self.law.at(whole);
            (l, self.law.angle(whole), self.u * (whole * q) + (self.t1 * c + self.b * s) * (1.0 - whole))
        };
        let mut last = at(0.0);
        let mut ahead = vec![(at(1.0), DEPTH)];
        while let Some(&(next, depth)) = ahead.last() {
            if depth == 0 || (next.1 - last.1 <= turn && last.2.angle(next.2) <= turn) {
                step(next.0);
                last = next;
                ahead.pop();
            } else {
                let index = ahead.len() - 1;
                ahead[index].1 = depth - 1;
                ahead.push((at(0.5 * (last.0 + next.0)), depth - 1));
            }
        }
    }
}
