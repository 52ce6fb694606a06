//! A smooth patch over one triangle, shaped at each corner by a sphere (`docs/math/triangle-surfaces.md#sphere-blend`;
//! source: `004`, (69)-(74)).
//!
//! Every corner has a sphere through the circle of the three corners. Between them the spheres are blended, and each point of
//! the triangle goes to the sphere of its place by the rotation that bends the triangle's plane into that sphere. In closed
//! form, with the circumcentre `o`, the circumradius `ρ`, the unit normal `n` and barycentric coordinates `λ`:
//!
//! ```text
//! x = y + σ W (n + σ Y)/(1 + σ² |Y|²),   y = Σ λ_i x_i,   Y = y - o,   W = Σ λ_i λ_j |x_i - x_j|²,   σ = τ/ρ
//! τ = b/(L + a),   a = Σ λ_i C_i,   b = Σ λ_i S_i,   L = hypot(a, b)
//! ```
//! `(C_i, S_i)` are cosine and sine of the angle at which the sphere of corner i leaves the plane. Analytic inside. Patches
//! over neighbouring triangles meet in their corners only, see [`SmoothMesh`](super::SmoothMesh) for surfaces over meshes.

use super::barycentric::Barycentric;
use super::smooth::Jet;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, Result};

/// Triangles with less than this, twice the area over the longest edge squared, have no circle.
pub(super) const DEGENERATE_TRIANGLE: f64 = 1e-12;
/// Control points nearer to the circle, relative to it and to their distance, tell no sphere.
const ON_CIRCLE: f64 = 1e-12;
/// Blended spheres that are shorter cancel each other.
const OPPOSITE: f64 = 1e-12;
/// Blended spheres that leave the plane by less than this angle, turned over, pass through infinity.
const TURNED_OVER: f64 = 1e-12;

/// Twice the area of a triangle over its longest edge squared, and that edge.
pub(super) fn relative_area(corners: [Point3; 3]) -> (f64, f64) {
    let [a, b, c] = corners;
    let longest = (b - a).length().max((c - b).length()).max((a - c).length());
    if !(longest > 0.0) {
        return (0.0, 0.0);
    }
    (((b - a) / longest).cross((c - a) / longest).length(), longest)
}

/// Refuses triangles with coordinates or edges out of range, and those whose corners are on a line; returns the longest edge.
///
/// # Errors
/// `not-finite`, `parameter-out-of-range`, `degenerate-triangle`.
pub(super) fn check_triangle(corners: [Point3; 3]) -> Result<f64> {
    for (index, p) in corners.into_iter().enumerate() {
        range::check_point(index, p.to_vec())?;
    }
    let (area, longest) = relative_area(corners);
    if !(area > DEGENERATE_TRIANGLE && longest >= range::MIN_DISTANCE) {
        return Err(Error::DegenerateTriangle { area, limit: DEGENERATE_TRIANGLE });
    }
    Ok(longest)
}

/// A patch over a triangle whose corners have spheres through the circle of the triangle.
///
/// ```
/// use cyclide::{Point3, SphereBlend};
/// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let ball = SphereBlend::from_normals(corners, corners.map(Point3::to_vec))?;
/// assert!((ball.point([1.0, 1.0, 1.0])?.to_vec().length() - 1.0).abs() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphereBlend {
    corners: [Point3; 3],
    /// Longest edge: all that follows is in units of it.
    size: f64,
    /// Corners as seen from the circumcentre.
    spokes: [Vec3; 3],
    radius: f64,
    normal: Vec3,
    /// Cosine and sine of the angle at which the sphere of each corner leaves the plane.
    leave: [[f64; 2]; 3],
}

/// A place of the patch, in units of the size: the way from the triangle to it, and the derivatives of its point.
struct Place {
    lift: Vec3,
    derivatives: [Vec3; 2],
}

impl SphereBlend {
    /// The patch whose sphere at each corner passes through a control point; it lies on their side of the plane. Control points
    /// in the plane and inside the circle give the flat triangle, three on one sphere through the corners give exactly a
    /// piece of that sphere.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates above 1e150), `degenerate-triangle`,
    /// `control-point-on-circumcircle`.
    pub fn from_control_points(corners: [Point3; 3], control: [Point3; 3]) -> Result<Self> {
        for (index, p) in control.into_iter().enumerate() {
            range::check_point(3 + index, p.to_vec())?;
        }
        let mut blend = Self::over(corners)?;
        for i in 0..3 {
            // Seen from the corner first: far from the origin the centre has the rounding of its coordinates.
            let seen = (control[i] - corners[i]) / blend.size + blend.spokes[i];
            let distance = seen.length();
            let reach = blend.radius.hypot(distance);
            let c = ((blend.radius - distance) / reach) * ((blend.radius + distance) / reach);
            let s = 2.0 * (blend.radius / reach) * (blend.normal.dot(seen) / reach);
            let off = c.hypot(s);
            if !(off > ON_CIRCLE) {
                return Err(Error::ControlPointOnCircumcircle { corner: i, distance: off, limit: ON_CIRCLE });
            }
            blend.leave[i] = [c / off, s / off];
        }
        Ok(blend)
    }

    /// The patch whose normals at the corners are as near to given ones (of any length) as spheres through all three corners
    /// allow: a normal is turned about the circle's tangent at its corner.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates above 1e150), `degenerate-triangle`, `undefined-normal` (zero, or
    /// along the circle's tangent).
    pub fn from_normals(corners: [Point3; 3], normals: [Vec3; 3]) -> Result<Self> {
        let mut blend = Self::over(corners)?;
        for (i, normal) in normals.into_iter().enumerate() {
            if !normal.is_finite() {
                return Err(Error::NotFinite { what: ErrorItem::Normal, index: i });
            }
            let undefined = |length| Error::UndefinedNormal { vertex: i, length, limit: ON_CIRCLE };
            let unit = normal.unit().ok_or_else(|| undefined(0.0))?;
            let (c, s) = (unit.dot(blend.normal), unit.dot(blend.spokes[i] / blend.radius));
            let length = c.hypot(s);
            if !(length > ON_CIRCLE) {
                return Err(undefined(length));
            }
            blend.leave[i] = [c / length, s / length];
        }
        Ok(blend)
    }

    /// The flat patch.
    fn over(corners: [Point3; 3]) -> Result<Self> {
        let size = check_triangle(corners)?;
        let [a, b, c] = corners;
        let [p, q] = [(a - b) / size, (c - b) / size];
        let w = p.cross(q);
        let centre = (q.cross(w) * p.length_squared() + w.cross(p) * q.length_squared()) / (2.0 * w.length_squared());
        let normal = (-w).unit().ok_or(Error::DegenerateTriangle { area: 0.0, limit: DEGENERATE_TRIANGLE })?;
        let spokes = [p - centre, -centre, q - centre];
        Ok(Self { corners, size, spokes, radius: centre.length(), normal, leave: [[1.0, 0.0]; 3] })
    }

    /// The patch with the same angles at its corners, taken in an order, over a similar triangle.
    pub(super) fn over_similar(&self, corners: [Point3; 3], order: [usize; 3]) -> Result<Self> {
        Ok(Self { leave: order.map(|k| self.leave[k]), ..Self::over(corners)? })
    }

    /// Corners.
    #[must_use]
    pub fn corners(&self) -> [Point3; 3] {
        self.corners
    }

    /// The point at barycentric coordinates, not negative, in any scale; at the corners these, to the bit.
    ///
    /// # Errors
    /// `parameter-out-of-range` (coordinates not finite, negative or all zero), `opposite-spheres`,
    /// `patch-through-infinity`.
    pub fn point(&self, lambda: [f64; 3]) -> Result<Point3> {
        let at = Barycentric::new(lambda)?;
        if let Some(corner) = at.corner() {
            return Ok(self.corners[corner]);
        }
        Ok(self.point_of(&at, &self.place(&at)?))
    }

    /// Unit normal at barycentric coordinates, on the side from which the corners are seen counter-clockwise where the patch is not folded over.
    ///
    /// # Errors
    /// As [`point`](Self::point); `undefined-normal` where the derivatives have one direction.
    pub fn normal(&self, lambda: [f64; 3]) -> Result<Vec3> {
        let at = Barycentric::new(lambda)?;
        let [d1, d2] = self.place(&at)?.derivatives;
        d1.cross(d2).unit().ok_or(Error::UndefinedNormal { vertex: at.largest(), length: 0.0, limit: 0.0 })
    }

    /// Point and derivatives at a place that is no corner.
    pub(super) fn jet(&self, at: &Barycentric) -> Result<Jet> {
        let place = self.place(at)?;
        Ok(Jet { point: self.point_of(at, &place), derivatives: place.derivatives.map(|d| d * self.size) })
    }

    fn point_of(&self, at: &Barycentric, place: &Place) -> Point3 {
        // From the nearest corner: the circumcentre of a thin triangle is far away.
        let (nearest, coordinates) = (self.corners[at.largest()], at.coordinates());
        let flat = (0..3).fold(Vec3::ZERO, |sum, i| sum + (self.corners[i] - nearest) * coordinates[i]);
        nearest + (flat + place.lift * self.size)
    }

    /// The derivatives by the first two coordinates, the third being what is left to 1
    /// (`docs/math/triangle-surfaces.md#sphere-blend`).
    fn place(&self, at: &Barycentric) -> Result<Place> {
        let [l1, l2, l3] = at.coordinates();
        let [e1, e2, e3] = self.spokes;
        let mix = |k: usize| l1 * self.leave[0][k] + l2 * self.leave[1][k] + l3 * self.leave[2][k];
        let (a, b) = (mix(0), mix(1));
        let length = a.hypot(b);
        if !(length > OPPOSITE) {
            return Err(Error::OppositeSpheres { at: [l1, l2], length, limit: OPPOSITE });
        }
        if a < 0.0 && b.abs() <= TURNED_OVER * length {
            return Err(Error::PatchThroughInfinity { s: l1, t: l2 });
        }
        let tau = if a < 0.0 { (length - a) / b } else { b / (length + a) };
        let sigma = tau / self.radius;
        let [y1, y2] = [e1 - e3, e2 - e3];
        let w = l1 * l2 * (e1 - e2).length_squared() + l2 * l3 * y2.length_squared() + l1 * l3 * y1.length_squared();
        let flat = e1 * l1 + e2 * l2 + e3 * l3;
        let e = 1.0 + sigma * sigma * flat.length_squared();
        let up = self.normal + flat * sigma;
        let derivatives = [(0, y1), (1, y2)].map(|(i, y)| {
            let [a_i, b_i] = [0, 1].map(|k| self.leave[i][k] - self.leave[2][k]);
            let sigma_i = 0.5 * (1.0 + tau * tau) * (a * b_i - b * a_i) / (length * length * self.radius);
            let w_i = -2.0 * flat.dot(y);
            let e_i = 2.0 * sigma * sigma_i * flat.length_squared() - sigma * sigma * w_i;
            let lifted = up * (sigma_i * w + sigma * w_i) + (flat * sigma_i + y * sigma) * (sigma * w);
            y + lifted / e - up * (sigma * w * e_i / (e * e))
        });
        Ok(Place { lift: up * (sigma * w / e), derivatives })
    }
}
