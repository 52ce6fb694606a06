//! Ellipses in sectors: what necks and bridges are bounded by.

use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Arc;
use crate::error::Result;
use crate::rational::{Polynomial, PolynomialRow, RationalBezier};
use crate::topology::EdgeCurve;
use std::f64::consts::TAU;

/// An ellipse `center + u cos θ + v sin θ`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ellipse {
    pub(super) center: Point3,
    pub(super) u: Vec3,
    pub(super) v: Vec3,
}

impl Ellipse {
    /// The point at an angle given by its cosine and sine.
    pub(super) fn point(&self, [cos, sin]: [f64; 2]) -> Point3 {
        self.center + self.u * cos + self.v * sin
    }

    /// The homogeneous form over a sector, of degree 2.
    pub(super) fn row(&self, sector: &Sector) -> PolynomialRow {
        let entry = |c: f64, u: f64, v: f64| &(&(&sector.one * c) + &(&sector.cos * u)) + &(&sector.sin * v);
        let (c, u, v) = (self.center, self.u, self.v);
        PolynomialRow([entry(c.x, u.x, v.x), entry(c.y, u.y, v.y), entry(c.z, u.z, v.z), sector.one.clone()])
    }

    /// The curve over a sector: an arc of a circle, a rational quadratic of an ellipse that is none.
    pub(super) fn curve(&self, sector: &Sector) -> Result<EdgeCurve> {
        let (u, v) = (self.u.length(), self.v.length());
        let rounding = 4.0 * f64::EPSILON * u.max(v);
        if (u - v).abs() <= rounding && self.u.dot(self.v).abs() <= rounding * u {
            let axis = self.u.cross(self.v).unit().unwrap_or(Vec3::Z);
            let (sin, cos) = (0.5 * sector.angle()).sin_cos();
            let ratio = Quat::new(cos, axis.x * sin, axis.y * sin, axis.z * sin);
            return Ok(Arc::from_ratio_across(self.point(sector.start), self.point(sector.end), ratio)?.into());
        }
        let PolynomialRow([x, y, z, w]) = self.row(sector);
        let entries = [x, y, z, w];
        let row = |i: usize| entries.each_ref().map(|entry| entry.coefficients()[i]);
        Ok(RationalBezier::new((0..=2).map(row).collect())?.into())
    }

    /// The curves over all sectors.
    pub(super) fn curves(&self, sectors: &[Sector]) -> Result<Vec<EdgeCurve>> {
        sectors.iter().map(|sector| self.curve(sector)).collect()
    }
}

/// A part of a turn, less than half of one, with the exact form of its cosine and sine: `cos/one`, `sin/one`.
#[derive(Debug, Clone)]
pub(super) struct Sector {
    from: f64,
    to: f64,
    pub(super) start: [f64; 2],
    pub(super) end: [f64; 2],
    pub(super) cos: Polynomial,
    pub(super) sin: Polynomial,
    pub(super) one: Polynomial,
}

impl Sector {
    pub(super) fn new(from: f64, to: f64) -> Self {
        let (start, middle, end) = (direction(from), direction(0.5 * (from + to)), direction(to));
        let quadratic = |d: usize| Polynomial::new(vec![start[d], middle[d], end[d]]);
        let one = Polynomial::new(vec![1.0, (0.5 * (to - from)).cos(), 1.0]);
        Self { from, to, start, end, cos: quadratic(0), sin: quadratic(1), one }
    }

    /// A whole turn in so many equal parts, at least three. The end of the last one is the start of the first.
    pub(super) fn turn(count: usize) -> Vec<Self> {
        let at = |k: usize| TAU * k as f64 / count as f64;
        (0..count).map(|k| Self::new(at(k), at(k + 1))).collect()
    }

    pub(super) fn angle(&self) -> f64 {
        self.to - self.from
    }

    /// The angle where it begins.
    pub(super) fn from(&self) -> f64 {
        self.from
    }
}

/// Cosine and sine of an angle; where one is rounding of zero it is zero, so that what lies on an axis stays there.
pub(super) fn direction(angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos, sin].map(|x| if x.abs() < 4.0 * f64::EPSILON { 0.0 } else { x })
}
