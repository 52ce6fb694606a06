//! Convex polygons on a sphere whose sides are parts of great circles, as exact rational faces: the centroid fan
//! (`docs/math/polyhedron-offsets.md#polygons-of-spheres`; source: `000`, section 7).
//!
//! From the apex `m`, the unit vector along the sum of the corners, the circle to the point `E` of a side has the weights 1 and
//! `1 - E m = (1 + <E,m>, m × E)`. With the side `E = Ẽ/D`, `Ẽ = B[n0, (n0 + n1)/(2k), n1]`, `D = B[1, k, 1]`, `k` the cosine of
//! half its angle, and `g = D + <Ẽ,m>`, the face of a side has the rows (degree 2 in s)
//!
//! ```text
//! [ m D², D² ],   [ (m D + Ẽ) D, D g ],   [ 2 g Ẽ, 2 D g ]
//! ```
//!
//! of degree 4 in t. `s = 0` is the apex, `s = 1` the side with the parameter of its own arc: the common factor `g` cancels.

use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, NumberError, PointError, PolyhedronError, Result};
use crate::rational::RationalBezierSurface;
use std::f64::consts::TAU;

/// By so much the angles about the apex may differ from a whole turn: far below another turn, far above rounding.
const TURN_LIMIT: f64 = 1e-3;

/// A convex polygon on the unit sphere, counter-clockwise from outside, within an open half of it.
///
/// ```
/// use cyclide::{Vec3, construct::SphericalPolygon};
/// let octant = SphericalPolygon::new(&[Vec3::X, Vec3::Y, Vec3::Z])?;
/// assert!((octant.solid_angle() - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct SphericalPolygon {
    corners: Vec<Vec3>,
    apex: Vec3,
}

impl SphericalPolygon {
    /// The polygon with these corners, directions of any length.
    ///
    /// # Errors
    /// `too-few-points`, `not-finite`, `zero-axis` (a direction), `not-in-open-hemisphere` (a side does not run counter-clockwise
    /// about the sum of the corners, or all together run round it more than once).
    pub fn new(corners: &[Vec3]) -> Result<Self> {
        if corners.len() < 3 {
            return Err(PointError::TooFewPoints { given: corners.len(), needed: 3 }.into());
        }
        if let Some(index) = corners.iter().position(|n| !n.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Corner, index }.into());
        }
        let direction = |(index, n): (usize, &Vec3)| {
            n.unit().ok_or(Error::Point(PointError::ZeroAxis {
                what: ErrorItem::Direction,
                index,
                length: 0.0,
                limit: 0.0,
            }))
        };
        let corners: Vec<Vec3> = corners.iter().enumerate().map(direction).collect::<Result<_>>()?;
        let sum = corners.iter().fold(Vec3::ZERO, |sum, n| sum + *n);
        let apex = sum.unit().ok_or(PolyhedronError::NotInOpenHemisphere { side: None, measured: 0.0, limit: 0.0 })?;
        Self::about(corners, apex)
    }

    /// The polygon with these unit vectors as corners, and another point inside as its apex.
    ///
    /// # Errors
    /// `not-in-open-hemisphere`.
    pub(super) fn about(corners: Vec<Vec3>, apex: Vec3) -> Result<Self> {
        let polygon = Self { corners, apex };
        polygon.check_sides()?;
        Ok(polygon)
    }

    fn check_sides(&self) -> Result<()> {
        let mut turn = 0.0;
        for (side, [a, b]) in self.sides().enumerate() {
            // Of a small polygon the corners are next to the apex: the differences come first, which are exact there.
            let [a, b] = [a, b].map(|n| across(n - self.apex, self.apex));
            let sine = a.cross(b).dot(self.apex);
            let measured = sine.atan2(a.dot(b));
            if !(sine > 0.0) {
                return Err(PolyhedronError::NotInOpenHemisphere { side: Some(side), measured, limit: 0.0 }.into());
            }
            turn += measured;
        }
        let limit = TAU + TURN_LIMIT;
        if turn > limit {
            return Err(PolyhedronError::NotInOpenHemisphere { side: None, measured: turn, limit }.into());
        }
        Ok(())
    }

    /// The corners, unit vectors.
    #[must_use]
    pub fn corners(&self) -> &[Vec3] {
        &self.corners
    }

    /// The point inside from which the fan goes out, a unit vector.
    #[must_use]
    pub fn apex(&self) -> Vec3 {
        self.apex
    }

    /// The ends of each side.
    pub fn sides(&self) -> impl Iterator<Item = [Vec3; 2]> + '_ {
        (0..self.corners.len()).map(|k| [self.corners[k], self.corners[(k + 1) % self.corners.len()]])
    }

    /// The solid angle: the area on the unit sphere (A. van Oosterom, J. Strackee, *The solid angle of a plane triangle*, 1983,
    /// triangle by triangle from the apex).
    #[must_use]
    pub fn solid_angle(&self) -> f64 {
        let m = self.apex;
        let triangle = |[a, b]: [Vec3; 2]| {
            let of_circumference = 1.0 + m.dot(a) + a.dot(b) + b.dot(m);
            2.0 * a.cross(b).dot(m).atan2(of_circumference)
        };
        self.sides().map(triangle).sum()
    }

    /// The face between the apex (`s = 0`) and a side (`s = 1`, along t), of degree (2, 4), on the sphere about `center`. Its normal
    /// is outward. With sides far above a third of a turn a weight may be negative.
    ///
    /// # Errors
    /// `radius-not-positive`; `parameter-out-of-range` (no such side); `not-finite`.
    pub fn fan(&self, center: Point3, radius: f64, side: usize) -> Result<RationalBezierSurface> {
        if !(radius > 0.0) {
            return Err(NumberError::RadiusNotPositive { what: ErrorItem::Radius, index: 0, radius }.into());
        }
        let max = self.corners.len() as f64 - 1.0;
        let missing = Error::Number(NumberError::ParameterOutOfRange {
            name: ErrorItem::Side,
            value: side as f64,
            min: 0.0,
            max,
        });
        let ends = self.sides().nth(side).ok_or(missing)?;
        RationalBezierSurface::new([2, 4], placed(&sector(self.apex, ends), center, radius))
    }
}

/// The part of a vector across a unit vector.
fn across(v: Vec3, m: Vec3) -> Vec3 {
    v - m * v.dot(m)
}

/// The rows of the face between the apex and the arc between two corners, on the unit sphere.
pub(super) fn sector(m: Vec3, [n0, n1]: [Vec3; 2]) -> [[f64; 4]; 15] {
    let k = 0.5 * (n0 + n1).length();
    let e = [n0, (n0 + n1) / (2.0 * k), n1];
    let d = [1.0, k, 1.0];
    let g = [0, 1, 2].map(|i| d[i] + e[i].dot(m));
    let (e, axis) = (e.map(Vec3::to_array), m.to_array());
    let mixed: [[f64; 3]; 3] = [0, 1, 2].map(|i| [0, 1, 2].map(|c| axis[c] * d[i] + e[i][c]));
    let mut rows = [[0.0; 4]; 15];
    let (dd, dg) = (product(d, d), product(d, g));
    for c in 0..3 {
        let of = |v: [[f64; 3]; 3]| v.map(|v| v[c]);
        let (middle, last) = (product(of(mixed), d), product(g, of(e)));
        for j in 0..5 {
            rows[j][c] = axis[c] * dd[j];
            rows[5 + j][c] = middle[j];
            rows[10 + j][c] = 2.0 * last[j];
        }
    }
    for j in 0..5 {
        rows[j][3] = dd[j];
        rows[5 + j][3] = dg[j];
        rows[10 + j][3] = 2.0 * dg[j];
    }
    rows
}

/// The rows of the unit sphere on another one.
pub(super) fn placed(rows: &[[f64; 4]], center: Point3, radius: f64) -> Vec<[f64; 4]> {
    let o = center.to_vec();
    let row = |&[x, y, z, w]: &[f64; 4]| [radius * x + o.x * w, radius * y + o.y * w, radius * z + o.z * w, w];
    rows.iter().map(row).collect()
}

/// The product of two polynomials of degree 2 in Bernstein form.
fn product(a: [f64; 3], b: [f64; 3]) -> [f64; 5] {
    [
        a[0] * b[0],
        0.5 * (a[0] * b[1] + a[1] * b[0]),
        (a[0] * b[2] + 4.0 * a[1] * b[1] + a[2] * b[0]) / 6.0,
        0.5 * (a[1] * b[2] + a[2] * b[1]),
        a[2] * b[2],
    ]
}
