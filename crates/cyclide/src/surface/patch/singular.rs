//! Where a parameter line shrinks to a point.

use super::CyclidePatch;
use super::polar::{at_half, runs_backwards};
use crate::base::quadratic::value as quadratic;

impl CyclidePatch {
    /// The parameters t in (0, 1) whose s-line is one point: the zeros of `q1`. Sorted.
    #[must_use]
    pub fn singular_t(&self) -> Vec<f64> {
        roots(self.polar.q1, self.speed_rounding(0.0)[0])
    }

    /// The parameters s in (0, 1) whose t-line is one point: the zeros of `q2`. Sorted.
    #[must_use]
    pub fn singular_s(&self) -> Vec<f64> {
        roots(self.polar.q2, self.speed_rounding(0.0)[1])
    }

    /// True if no parameter line shrinks to a point inside; sides that are one point are allowed.
    #[must_use]
    pub fn is_regular(&self) -> bool {
        self.singular_s().is_empty() && self.singular_t().is_empty()
    }

    /// Which of t = 0 and t = 1 are s-lines of one point that is a node of the surface: the normals along the line are
    /// those of a cone, and [`k1`](Self::k1) grows beyond all bounds towards it. A pole, as of a sphere, is none: there
    /// the normals along the line are equal.
    #[must_use]
    pub fn node_t(&self) -> Vec<f64> {
        nodes(self.polar.q1, self.polar.m.map(|m| [m.dot(self.v[1]), m.length()]))
    }

    /// Which of s = 0 and s = 1 are t-lines of one point that is a node, as [`node_t`](Self::node_t).
    #[must_use]
    pub fn node_s(&self) -> Vec<f64> {
        nodes(self.polar.q2, self.polar.m_star.map(|m| [m.dot(self.v[0]), m.length()]))
    }

    /// The side of the [unit normal](Self::unit_normal) on which `f_s × f_t` is: 1, or -1 where it is against it. It changes
    /// at singular lines and nowhere else, also where a speed is so small that rounding gives it any sign.
    #[must_use]
    pub fn side_of_normal(&self, s: f64, t: f64) -> f64 {
        self.speed_sign(0)(t) * self.speed_sign(1)(s)
    }

    /// The sign of the speed of the s-lines by t (`direction` 0), or of the t-lines by s.
    pub(crate) fn speed_sign(&self, direction: usize) -> impl Fn(f64) -> f64 + use<> {
        let (speed, singular) = match direction {
            0 => (self.polar.q1, self.singular_t()),
            _ => (self.polar.q2, self.singular_s()),
        };
        move |x| {
            let from = singular.iter().copied().filter(|r| *r <= x).fold(0.0, f64::max);
            let to = singular.iter().copied().filter(|r| *r > x).fold(1.0, f64::min);
            if runs_backwards(&speed, 0.5 * (from + to)) { -1.0 } else { 1.0 }
        }
    }

    /// True if `f_s × f_t` is against the normal `D V3 D^-1`, judged in the middle: so it is beyond a focal set, after
    /// an [`offset`](Self::offset) by more than one of the two radii of curvature.
    #[must_use]
    pub fn is_flipped(&self) -> bool {
        at_half(&self.polar.q1) * at_half(&self.polar.q2) < 0.0
    }
}

impl CyclidePatch {
    /// Bernstein coefficients of the rounding of `q1` and of `q2` of the [`offset`](Self::offset) at `h`: that of the
    /// products `~w_i a_j w_j` of which they are sums.
    pub(super) fn speed_rounding(&self, h: f64) -> [[f64; 3]; 2] {
        let sizes: [[f64; 2]; 4] = std::array::from_fn(|k| {
            let weight = self.weights[k].norm();
            [weight, weight * (self.corners[k].to_vec().max_abs() + h.abs())]
        });
        // Equal corners have speed zero exactly.
        let products = |i: usize, j: usize| {
            let same = self.corners[i] == self.corners[j] && h == 0.0;
            if same { 0.0 } else { ROUNDING * (sizes[i][0] * sizes[j][1] + sizes[i][1] * sizes[j][0]) }
        };
        let middle = products(0, 3);
        [
            [products(0, 1), 0.5 * (middle + products(2, 1)), products(2, 3)],
            [products(0, 2), 0.5 * (middle + products(1, 2)), products(1, 3)],
        ]
    }
}

/// Rounding of a speed in units of its terms: products of three quaternions of rounded weights and corners.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Along a side of one point the normals turn about an axis: about themselves at a pole, where this cosine of the
/// angle to the tangent plane is 0.
pub(super) const POLE_LIMIT: f64 = 1e-9;

/// The ends at which the speed is zero and the bending `[m·V, |m|]` across the normal is not.
fn nodes(speed: [f64; 3], bending: [[f64; 2]; 3]) -> Vec<f64> {
    let node = |k: usize| speed[k] == 0.0 && bending[k][0].abs() > POLE_LIMIT * bending[k][1];
    [(0, 0.0), (2, 1.0)].into_iter().filter(|&(k, _)| node(k)).map(|(_, at)| at).collect()
}

/// Zeros in (0, 1) of the quadratic with these Bernstein coefficients, which are known up to `rounding`. An end that is
/// exactly zero is a side of one point, not a zero inside.
///
/// A double zero is one zero, or none at a side: rounding makes two of it, or none. Two are two if the quadratic between them
/// is above its rounding.
pub(super) fn roots(c: [f64; 3], rounding: [f64; 3]) -> Vec<f64> {
    let found = zeros(c);
    let vanishes = |t: f64| quadratic(&c, t).abs() <= quadratic(&rounding, t);
    let between = |from: f64, to: f64| from + 0.5 * (to - from);
    match found[..] {
        [r] if c[0] == 0.0 && vanishes(between(0.0, r)) => Vec::new(),
        [r] if c[2] == 0.0 && vanishes(between(r, 1.0)) => Vec::new(),
        [r0, r1] if vanishes(between(r0, r1)) => vec![between(r0, r1)],
        [] if c[0] != 0.0 && c[2] != 0.0 => {
            let extreme = (c[0] - c[1]) / ((c[0] - c[1]) + (c[2] - c[1]));
            let double = extreme > 0.0 && extreme < 1.0 && vanishes(extreme);
            double.then_some(extreme).into_iter().collect()
        }
        _ => found,
    }
}

/// The zeros in (0, 1) of the quadratic as it is, ends that are zero left out.
fn zeros(c: [f64; 3]) -> Vec<f64> {
    let [a, b, e] = c;
    // a u² + 2 b u t + e t² = 0 with u = 1 - t.
    let inside = |t: f64, u: f64| {
        let r = t / (t + u);
        ((t > 0.0) == (u > 0.0) && t != 0.0 && u != 0.0 && r > 0.0 && r < 1.0).then_some(r)
    };
    let mut found: Vec<f64> = if a == 0.0 {
        // t (2 b u + e t) = 0
        inside(-2.0 * b, e).into_iter().collect()
    } else if e == 0.0 {
        // u (a u + 2 b t) = 0
        inside(a, -2.0 * b).into_iter().collect()
    } else {
        let discriminant = b * b - a * e;
        if discriminant < 0.0 {
            return Vec::new();
        }
        // Stable pair of roots (t : u) of e t² + 2 b t u + a u².
        let q = -(b + discriminant.sqrt().copysign(b));
        if discriminant == 0.0 {
            inside(q, e).into_iter().collect()
        } else {
            [inside(q, e), inside(a, q)].into_iter().flatten().collect()
        }
    };
    found.sort_by(f64::total_cmp);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_those_inside() {
        let exact = |c| roots(c, [0.0; 3]);
        // (t - 1/4)(t - 3/4) and (t - 1/2)(t - 2) by values at 0, the blossom at (0,1), 1.
        let bernstein = |p: f64, q: f64| [p * q, 0.5 * (p * (q - 1.0) + q * (p - 1.0)), (1.0 - p) * (1.0 - q)];
        assert_eq!(exact(bernstein(0.25, 0.75)), [0.25, 0.75]);
        assert_eq!(exact(bernstein(0.5, 2.0)), [0.5]);
        assert_eq!(exact(bernstein(0.5, 1.0)), [0.5], "the zero at the end is a side");
        assert_eq!(exact(bernstein(0.0, 0.5)), [0.5]);
        assert!(exact([0.0, 0.0, 0.0]).is_empty() && exact([1.0, 1.0, 1.0]).is_empty());
    }

    #[test]
    fn double_zeros_are_one() {
        // A side of one point has speed zero exactly.
        let known = |c: [f64; 3]| roots(c, c.map(|c| if c == 0.0 { 0.0 } else { 1e-16 }));
        for end in [0.5, -1e-13, 1e-14] {
            // As flat as it may be: only the middle coefficient tells whether there is another zero.
            let c = [0.0, -1e-17_f64.copysign(end), end];
            assert!(known(c).is_empty() && known([c[2], c[1], c[0]]).is_empty(), "{end:e}");
        }
        assert_eq!(known([0.0, -1e-10, 0.5]).len(), 1, "a simple zero beside a side");
        // (t - 1/3)², moved up and down by rounding and by more.
        let square = |by: f64| [1.0 / 9.0 + by, -2.0 / 9.0 + by, 4.0 / 9.0 + by];
        for by in [0.0, 5e-17, -5e-17] {
            let found = known(square(by));
            assert!(found.len() == 1 && (found[0] - 1.0 / 3.0).abs() < 1e-15, "{by:e}: {found:?}");
        }
        assert_eq!(known(square(-1e-14)).len(), 2);
        assert!(known(square(1e-14)).is_empty());
    }
}
