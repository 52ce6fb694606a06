//! A smooth patch over one triangle, shaped at each corner by a sphere (`docs/math/triangle-surfaces.md#sphere-blend`;
//! source: `004`, (69)-(74)).
//!
//! Every corner has a sphere through the circle of the three corners. Between them the spheres are blended, and each point of
//! the triangle goes to the sphere of its place by the rotation that bends the triangle's plane into that sphere. In closed
//! form, with the circumcenter `o`, the circumradius `ρ`, the unit normal `n` and barycentric coordinates `λ`:
//!
//! ```text
//! x = y + σ W (n + σ Y)/(1 + σ² |Y|²),   y = Σ λ_i x_i,   Y = y - o,   W = Σ λ_i λ_j |x_i - x_j|²,   σ = τ/ρ
//! τ = b/(L + a),   a = Σ λ_i C_i,   b = Σ λ_i S_i,   L = hypot(a, b)
//! ```
//! `(C_i, S_i)` are cosine and sine of the angle at which the sphere of corner i leaves the plane. With cosine and sine of half the
//! angle of `(a, b)` for `τ = s/c` it is `y + W/ρ s (c n + s Z)/(c² + s² |Z|²)`, `Z = Y/ρ`, which has no infinity but at the circumcenter, where the
//! plane is turned over. Analytic inside. Patches
//! over neighboring triangles meet in their corners only, see [`SmoothMesh`](super::SmoothMesh) for surfaces over meshes.

use super::barycentric::Barycentric;
use super::smooth::Jet;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, MeshError, NumberError, PatchError, Result, TriangleError};
use crate::warning::{MeshWarning, Warning};

/// Triangles with less than this, twice the area over the longest edge squared, have no circle.
pub(super) const DEGENERATE_TRIANGLE: f64 = 1e-12;
/// Control points nearer to the circle, relative to it and to their distance, tell no sphere.
const ON_CIRCLE: f64 = 1e-12;
/// Blended spheres that are shorter cancel each other: there is no point.
const CANCELLED: f64 = 1e-12;
/// Where they are shorter than this the patch swings round by half a turn over this part of the triangle: it is torn.
const OPPOSITE: f64 = 1e-4;
/// Where they are shorter than this the patch swings round within a twentieth of the triangle or so, which is said.
const NEARLY_OPPOSITE: f64 = 0.1;
/// A patch that reaches farther than the circumradius over this passes through infinity.
const INFINITE: f64 = 1e-4;

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
        return Err(TriangleError::Degenerate { area, limit: DEGENERATE_TRIANGLE }.into());
    }
    Ok(longest)
}

/// A patch over a triangle whose corners have spheres through the circle of the triangle.
///
/// ```
/// use cyclide::{Point3, surface::SphereBlend};
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
    /// Corners as seen from the circumcenter.
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
    /// `control-point-on-circumcircle`. Spheres may cancel somewhere: see [`whole`](Self::whole).
    pub fn from_control_points(corners: [Point3; 3], control: [Point3; 3]) -> Result<Self> {
        for (index, p) in control.into_iter().enumerate() {
            range::check_point(3 + index, p.to_vec())?;
        }
        let mut blend = Self::over(corners)?;
        for i in 0..3 {
            // Seen from the corner first: far from the origin the center has the rounding of its coordinates.
            let seen = (control[i] - corners[i]) / blend.size + blend.spokes[i];
            let distance = seen.length();
            let reach = blend.radius.hypot(distance);
            let c = ((blend.radius - distance) / reach) * ((blend.radius + distance) / reach);
            let s = 2.0 * (blend.radius / reach) * (blend.normal.dot(seen) / reach);
            let off = c.hypot(s);
            if !(off > ON_CIRCLE) {
                return Err(
                    TriangleError::ControlPointOnCircumcircle { corner: i, distance: off, limit: ON_CIRCLE }.into()
                );
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
                return Err(NumberError::NotFinite { what: ErrorItem::Normal, index: i }.into());
            }
            let undefined = |length, limit| Error::Mesh(MeshError::UndefinedNormal { vertex: i, length, limit });
            let unit = normal.unit().ok_or_else(|| undefined(0.0, 0.0))?;
            let (c, s) = (unit.dot(blend.normal), unit.dot(blend.spokes[i] / blend.radius));
            let length = c.hypot(s);
            if !(length > ON_CIRCLE) {
                return Err(undefined(length, ON_CIRCLE));
            }
            blend.leave[i] = [c / length, s / length];
        }
        Ok(blend)
    }

    /// The patch, if it has a point everywhere: what is torn, or passes through infinity, is refused. Both are known beforehand:
    /// `(a, b)` is linear in the coordinates, so it is nowhere 0 if the origin is outside the triangle of the three `(C_i, S_i)`; and only
    /// the circumcenter, or the place nearest to it, goes far.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, surface::SphereBlend};
    /// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
    /// let ball = SphereBlend::from_normals(corners, corners.map(Point3::to_vec))?;
    /// assert_eq!(ball.whole()?, ball);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// Where the spheres cancel or nearly so (a blend below 1e-4) `opposite-spheres`, where the patch reaches farther than 1e4 circumradii
    /// `patch-through-infinity`.
    pub fn whole(self) -> Result<Self> {
        let (length, [s, t, _]) = nearest_to_origin(self.leave);
        if !(length > OPPOSITE) {
            return Err(TriangleError::OppositeSpheres { at: [s, t], length, limit: OPPOSITE }.into());
        }
        let at = self.nearest_to_circumcentre();
        let half = self.half_turn(at)?;
        let off = (0..3).fold(Vec3::ZERO, |sum, i| sum + self.spokes[i] * at[i]).length() / self.radius;
        if !(half.cosine.hypot(half.sine * off) > INFINITE) {
            return Err(PatchError::ThroughInfinity { s: at[0], t: at[1] }.into());
        }
        Ok(self)
    }

    /// What should be known of it (`spheres-nearly-opposite`): where a tenth or less of the blended spheres is left the patch swings round.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let (length, _) = nearest_to_origin(self.leave);
        let near = (length <= NEARLY_OPPOSITE)
            .then_some(Warning::Mesh(MeshWarning::SpheresNearlyOpposite { length, limit: NEARLY_OPPOSITE }));
        near.into_iter().collect()
    }

    /// The place of the triangle that is nearest to the circumcenter: this, or the middle of the longest side.
    fn nearest_to_circumcentre(&self) -> [f64; 3] {
        let squared = [0, 1, 2].map(|i| (self.spokes[(i + 1) % 3] - self.spokes[(i + 2) % 3]).length_squared());
        let weights = [0, 1, 2].map(|i| {
            let [own, next, last] = [squared[i], squared[(i + 1) % 3], squared[(i + 2) % 3]];
            own * (next + last - own)
        });
        if let Some(obtuse) = weights.iter().position(|w| !(*w > 0.0)) {
            let mut middle = [0.5; 3];
            middle[obtuse] = 0.0;
            return middle;
        }
        let sum: f64 = weights.iter().sum();
        weights.map(|w| w / sum)
    }

    /// Half the angle at which the blended sphere leaves the plane.
    fn half_turn(&self, [l1, l2, l3]: [f64; 3]) -> Result<HalfTurn> {
        let mix = |k: usize| l1 * self.leave[0][k] + l2 * self.leave[1][k] + l3 * self.leave[2][k];
        let (a, b) = (mix(0), mix(1));
        let length = a.hypot(b);
        if !(length > CANCELLED) {
            return Err(TriangleError::OppositeSpheres { at: [l1, l2], length, limit: CANCELLED }.into());
        }
        // The larger of both without cancellation. Both may change their sign together.
        let [c, s] = if a < 0.0 { [b, length - a] } else { [length + a, b] };
        let unit = c.hypot(s);
        Ok(HalfTurn { cosine: c / unit, sine: s / unit, of: [a / length, b / length], length })
    }

    /// The flat patch.
    fn over(corners: [Point3; 3]) -> Result<Self> {
        let size = check_triangle(corners)?;
        let [a, b, c] = corners;
        let [p, q] = [(a - b) / size, (c - b) / size];
        let w = p.cross(q);
        let centre = (q.cross(w) * p.length_squared() + w.cross(p) * q.length_squared()) / (2.0 * w.length_squared());
        let normal = (-w).unit().ok_or(TriangleError::Degenerate { area: 0.0, limit: DEGENERATE_TRIANGLE })?;
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
        d1.cross(d2).unit().ok_or(Error::Mesh(MeshError::UndefinedNormal {
            vertex: at.largest(),
            length: 0.0,
            limit: f64::MIN_POSITIVE,
        }))
    }

    /// Point and derivatives at a place that is no corner.
    pub(super) fn jet(&self, at: &Barycentric) -> Result<Jet> {
        let place = self.place(at)?;
        Ok(Jet { point: self.point_of(at, &place), derivatives: place.derivatives.map(|d| d * self.size) })
    }

    fn point_of(&self, at: &Barycentric, place: &Place) -> Point3 {
        // From the nearest corner: the circumcenter of a thin triangle is far away.
        let (nearest, coordinates) = (self.corners[at.largest()], at.coordinates());
        let flat = (0..3).fold(Vec3::ZERO, |sum, i| sum + (self.corners[i] - nearest) * coordinates[i]);
        nearest + (flat + place.lift * self.size)
    }

    /// The derivatives by the first two coordinates, the third being what is left to 1
    /// (`docs/math/triangle-surfaces.md#sphere-blend`).
    fn place(&self, at: &Barycentric) -> Result<Place> {
        let lambda @ [l1, l2, l3] = at.coordinates();
        let half = self.half_turn(lambda)?;
        let HalfTurn { cosine: c, sine: s, of: [a, b], length } = half;
        let [e1, e2, e3] = self.spokes.map(|spoke| spoke / self.radius);
        let [y1, y2] = [e1 - e3, e2 - e3];
        // All in units of the circumradius from here on.
        let w = l1 * l2 * (e1 - e2).length_squared() + l2 * l3 * y2.length_squared() + l1 * l3 * y1.length_squared();
        let flat = e1 * l1 + e2 * l2 + e3 * l3;
        let e = c * c + s * s * flat.length_squared();
        if !(e > 0.0) {
            return Err(PatchError::ThroughInfinity { s: l1, t: l2 }.into());
        }
        let up = self.normal * c + flat * s;
        let derivatives = [(0, y1), (1, y2)].map(|(i, y)| {
            let [a_i, b_i] = [0, 1].map(|k| self.leave[i][k] - self.leave[2][k]);
            let turn = 0.5 * (a * b_i - b * a_i) / length;
            let (c_i, s_i) = (-s * turn, c * turn);
            let w_i = -2.0 * flat.dot(y);
            let e_i = 2.0 * (c * c_i + s * s_i * flat.length_squared() + s * s * flat.dot(y));
            let lifted = up * (w_i * s + w * s_i) + (self.normal * c_i + flat * s_i + y * s) * (w * s);
            y + lifted / e - up * (w * s * e_i / (e * e))
        });
        let (lift, radius) = (up * (w * s / e), self.radius);
        Ok(Place { lift: lift * radius, derivatives: derivatives.map(|d| d * radius) })
    }
}

/// Cosine and sine of half the angle of a blended sphere, and its own, with the length of the blend.
struct HalfTurn {
    cosine: f64,
    sine: f64,
    of: [f64; 2],
    length: f64,
}

/// The distance of a triangle in the plane from the origin, 0 if that is inside, and the place there.
fn nearest_to_origin(corners: [[f64; 2]; 3]) -> (f64, [f64; 3]) {
    let cross = |[a, b]: [f64; 2], [c, d]: [f64; 2]| a * d - b * c;
    let parts = [0, 1, 2].map(|i| cross(corners[(i + 1) % 3], corners[(i + 2) % 3]));
    if parts.iter().all(|part| *part > 0.0) || parts.iter().all(|part| *part < 0.0) {
        let sum: f64 = parts.iter().sum();
        return (0.0, parts.map(|part| part / sum));
    }
    let side = |i: usize| {
        let (from, to) = ((i + 1) % 3, (i + 2) % 3);
        let [p, q] = [corners[from], corners[to]];
        let way = [q[0] - p[0], q[1] - p[1]];
        let along = -(p[0] * way[0] + p[1] * way[1]) / (way[0] * way[0] + way[1] * way[1]);
        let t = if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.0 };
        let mut at = [0.0; 3];
        (at[from], at[to]) = (1.0 - t, t);
        ((p[0] + t * way[0]).hypot(p[1] + t * way[1]), at)
    };
    let [first, second, third] = [side(0), side(1), side(2)];
    let nearer = |a: (f64, [f64; 3]), b: (f64, [f64; 3])| if b.0 < a.0 { b } else { a };
    nearer(nearer(first, second), third)
}
