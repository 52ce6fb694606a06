//! Where a parameter line shrinks to a point.

use super::CyclidePatch;
use super::polar::at_half;

impl CyclidePatch {
    /// The parameters t in (0, 1) whose s-line is one point: the zeros of `q1`. Sorted.
    #[must_use]
    pub fn singular_t(&self) -> Vec<f64> {
        roots(self.polar.q1)
    }

    /// The parameters s in (0, 1) whose t-line is one point: the zeros of `q2`. Sorted.
    #[must_use]
    pub fn singular_s(&self) -> Vec<f64> {
        roots(self.polar.q2)
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

    /// True if `f_s × f_t` is against the normal `D V3 D^-1`, judged in the middle: so it is beyond a focal set, after
    /// an [`offset`](Self::offset) by more than one of the two radii of curvature.
    #[must_use]
    pub fn is_flipped(&self) -> bool {
        at_half(&self.polar.q1) * at_half(&self.polar.q2) < 0.0
    }
}

/// Along a side of one point the normals turn about an axis: about themselves at a pole, where this cosine of the
/// angle to the tangent plane is 0.
const POLE_LIMIT: f64 = 1e-9;

/// The ends at which the speed is zero and the bending `[m·V, |m|]` across the normal is not.
fn nodes(speed: [f64; 3], bending: [[f64; 2]; 3]) -> Vec<f64> {
    let node = |k: usize| speed[k] == 0.0 && bending[k][0].abs() > POLE_LIMIT * bending[k][1];
    [(0, 0.0), (2, 1.0)].into_iter().filter(|&(k, _)| node(k)).map(|(_, at)| at).collect()
}

/// A side of one point where the speed has a double zero has its other zero nearer to it than this, by rounding.
pub(super) const DOUBLE_ZERO: f64 = 16.0 * f64::EPSILON;

/// Zeros in (0, 1) of the quadratic with these Bernstein coefficients. An end that is exactly zero is a side of one
/// point, not a zero inside.
pub(super) fn roots(c: [f64; 3]) -> Vec<f64> {
    let [a, b, e] = c;
    // a u² + 2 b u t + e t² = 0 with u = 1 - t.
    let inside = |t: f64, u: f64| {
        let r = t / (t + u);
        ((t > 0.0) == (u > 0.0) && t != 0.0 && u != 0.0 && r > 0.0 && r < 1.0).then_some(r)
    };
    let mut found: Vec<f64> = if a == 0.0 {
        // t (2 b u + e t) = 0
        inside(-2.0 * b, e).filter(|r| *r > DOUBLE_ZERO).into_iter().collect()
    } else if e == 0.0 {
        // u (a u + 2 b t) = 0
        inside(a, -2.0 * b).filter(|r| *r < 1.0 - DOUBLE_ZERO).into_iter().collect()
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
        // (t - 1/4)(t - 3/4) and (t - 1/2)(t - 2) by values at 0, the blossom at (0,1), 1.
        let bernstein = |p: f64, q: f64| [p * q, 0.5 * (p * (q - 1.0) + q * (p - 1.0)), (1.0 - p) * (1.0 - q)];
        assert_eq!(roots(bernstein(0.25, 0.75)), [0.25, 0.75]);
        assert_eq!(roots(bernstein(0.5, 2.0)), [0.5]);
        assert_eq!(roots(bernstein(0.5, 1.0)), [0.5], "the zero at the end is a side");
        assert_eq!(roots(bernstein(0.0, 0.5)), [0.5]);
        assert!(roots([0.0, -1e-17, 0.5]).is_empty(), "a double zero at the side");
        assert!(roots([0.0, 0.0, 0.0]).is_empty() && roots([1.0, 1.0, 1.0]).is_empty());
    }
}
