//! Cutting arcs: exact split, midpoint, uniform points by the bulge vector, rational pieces with positive weights.

use super::Arc;
use crate::base::cut::interval;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, NumberError, Result};
use crate::rational::NurbsCurve;

/// Largest angle of one rational piece that is always safe: weights stay at least `cos(pi/4)`.
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// let nurbs = arc.to_nurbs(cyclide::curve::DEFAULT_PIECE_ANGLE)?;
/// assert_eq!((nurbs.degree(), nurbs.span_count()), (2, 2));
/// # Ok::<(), cyclide::Error>(())
/// ```
pub const DEFAULT_PIECE_ANGLE: f64 = std::f64::consts::FRAC_PI_2;

impl Arc {
    /// Splits at `t` in `(0, 1)`; the parameter is kept exactly: `left(s) = xi(t s)`, `right(s) = xi(t + s(1-t))`
    /// (homogeneous de Casteljau).
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn split(&self, t: f64) -> Result<(Self, Self)> {
        if !(t > 0.0 && t < 1.0) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::T, value: t, min: 0.0, max: 1.0 }.into());
        }
        let m = self.point(t);
        let (x, d) = self.denominator(t);
        // left: x(t) = X + t p. right: w x^-1 = (r + p)(X - t p)/D.
        let left = (x, self.p * t);
        let right = ((self.r * x + t * self.pn * self.pn) / d, self.p * ((x - t * self.r) / d));
        Ok((Self::from_ratio(self.p0, m, left.0, left.1)?, Self::from_ratio(m, self.p1, right.0, right.1)?))
    }

    /// The part from parameter `t0` to `t1`, `0 <= t0 < t1 <= 1`.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn restricted(&self, t0: f64, t1: f64) -> Result<Self> {
        let [t0, t1] = interval(t0, t1)?;
        let left = if t1 < 1.0 { self.split(t1)?.0 } else { *self };
        if t0 > 0.0 { Ok(left.split(t0 / t1)?.1) } else { Ok(left) }
    }

    /// Equal parts, none of which turns by more than `max_angle`.
    pub(crate) fn in_parts(&self, max_angle: f64) -> Result<Vec<Self>> {
        let count = self.piece_count_for(max_angle);
        let mut rest = *self;
        let mut parts = Vec::with_capacity(count);
        for left in (2..=count).rev() {
            let (first, after) = rest.split(rest.parameter_at_length(1.0 / left as f64))?;
            parts.push(first);
            rest = after;
        }
        parts.push(rest);
        Ok(parts)
    }

    /// The bulge vector `tan(alpha/2) u`: its length is the DXF bulge `tan(sweep/4)`, its direction the normal.
    #[must_use]
    pub fn bulge_vector(&self) -> Vec3 {
        if self.r >= 0.0 { self.p / (self.n + self.r) } else { self.p * ((self.n - self.r) / self.pn / self.pn) }
    }

    /// The middle point by length (`000`, Proposition 6).
    #[must_use]
    pub fn midpoint(&self) -> Point3 {
        midpoint(self.p0, self.p1, self.bulge_vector())
    }

    /// `2^levels + 1` points uniform in arc length, ends included, by the bulge-vector recursion
    /// `b' = b/(1 + sqrt(1+|b|²))`: no trigonometry, no weights that overflow (`000`, (30), in the stable form).
    ///
    /// # Errors
    /// `parameter-out-of-range` if `levels > 24`.
    pub fn uniform_points(&self, levels: u32) -> Result<Vec<Point3>> {
        if levels > 24 {
            return Err(NumberError::ParameterOutOfRange {
                name: ErrorItem::Levels,
                value: f64::from(levels),
                min: 0.0,
                max: 24.0,
            }
            .into());
        }
        let n = 1_usize << levels;
        let mut points = vec![self.p0; n + 1];
        points[n] = self.p1;
        let mut b = self.bulge_vector();
        let mut step = n;
        while step > 1 {
            for i in (0..n).step_by(step) {
                points[i + step / 2] = midpoint(points[i], points[i + step], b);
            }
            b = b / (1.0 + 1.0_f64.hypot(b.length()));
            step /= 2;
        }
        Ok(points)
    }

    /// Number of equal rational pieces of at most `max_angle` radians each.
    fn piece_count_for(&self, max_angle: f64) -> usize {
        // 1e-9: a half circle made in floats must not need a third piece.
        ((self.angle() / max_angle - 1e-9).ceil() as usize).max(1)
    }

    /// The exact rational quadratic B-spline in equal pieces of at most `max_angle` radians (below pi), all weights
    /// positive: 1 at the ends of the pieces, `cos(alpha/m)` between. Points are exact, the parameter inside the
    /// arc is that of constant length per piece. Lines come out with weights 1, 1, 1.
    ///
    /// # Errors
    /// `parameter-out-of-range` if `max_angle` is not between 0.001 and pi, the ends excluded.
    pub fn to_nurbs(&self, max_angle: f64) -> Result<NurbsCurve> {
        if !(max_angle > 1e-3 && max_angle < std::f64::consts::PI) {
            return Err(NumberError::ParameterOutOfRange {
                name: ErrorItem::MaxAngle,
                value: max_angle,
                min: 1e-3,
                max: std::f64::consts::PI,
            }
            .into());
        }
        let m = self.piece_count_for(max_angle);
        let beta = self.alpha() / m as f64;
        // tan(beta) u/2 and cos(beta); for a line u is zero.
        let u = self.p.unit().map_or(Vec3::ZERO, |u| u * (0.5 * beta.tan()));
        let end = |j: usize| {
            if j == 0 {
                self.p0
            } else if j == m {
                self.p1
            } else {
                self.point_at_length(j as f64 / m as f64)
            }
        };
        let (mut points, mut weights, mut knots) = (vec![self.p0], vec![1.0], vec![0.0; 3]);
        let mut from = self.p0;
        for j in 1..=m {
            let to = end(j);
            let chord = to - from;
            points.extend([from.midpoint(to) + chord.cross(u), to]);
            weights.extend([beta.cos(), 1.0]);
            let knot = j as f64 / m as f64;
            knots.extend([knot, knot]);
            from = to;
        }
        knots.push(1.0);
        NurbsCurve::new(2, knots, points, weights)
    }
}

/// `a + (c + c × b)/2`, the middle point of the arc with bulge vector `b`.
pub(crate) fn midpoint(a: Point3, b: Point3, bulge: Vec3) -> Point3 {
    let c = b - a;
    a.midpoint(b) + c.cross(bulge) * 0.5
}
