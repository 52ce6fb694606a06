//! Circles in space: through points, by center and normal, as exact splines.

use super::arc::Arc;
use super::arc::measure::ClosestPoint;
use super::param_curve::ParamCurve;
use super::piece_form::PieceForm;
use super::piece_hull::PieceHull;
use crate::base::bounds::Aabb;
use crate::base::cut::{check_past_start, interval, place_of_cut};
use crate::base::jet::CurveJet;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::error::{ArcError, Error, ErrorItem, NumberError, PointError, Result};
use crate::rational::NurbsCurve;

/// Smallest sine of the angle at the middle point of three points that have a circle.
const COLLINEAR_LIMIT: f64 = 1e-12;

/// A full circle in space with a start point, run right-handed about its normal.
///
/// As a [`ParamCurve`] it is one smooth piece at constant speed, closed.
///
/// ```
/// use cyclide::{Point3, curve::{Circle, length}};
/// let circle = Circle::through_points([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from))?;
/// assert!((length(&circle) - std::f64::consts::TAU).abs() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    center: Point3,
    /// Unit normal.
    normal: Vec3,
    /// Start minus center, perpendicular to the normal; its length is the radius.
    spoke: Vec3,
}

impl Circle {
    /// The circle about `center` in the plane across `normal` through the projection of `start` to that plane.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates above 1e150, radius below 1e-150), `zero-axis`, `zero-radius`
    /// (start on the axis: at most 1e-14 of its distance away), `below-rounding-of-place` (as [`from_radius`](Self::from_radius)).
    pub fn from_center(center: Point3, normal: Vec3, start: Point3) -> Result<Self> {
        range::check_point(0, center.to_vec())?;
        range::check_point(1, start.to_vec())?;
        if !normal.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Normal, index: 0 }.into());
        }
        let normal = normal.unit().ok_or(Error::zero_axis(ErrorItem::Normal))?;
        let v = start - center;
        let spoke = across(v, normal);
        let radius = spoke.length();
        let limit = 1e-14 * v.length();
        if radius <= limit || radius == 0.0 {
            return Err(NumberError::ZeroRadius { radius, limit }.into());
        }
        Self::new(center, normal, spoke)
    }

    /// The circle of a given radius; it starts in the direction of the x axis projected to its plane (of the y
    /// axis, if the normal is along x).
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates or radius above 1e150, radius below 1e-150), `zero-axis`,
    /// `radius-not-positive`, `below-rounding-of-place` (below the rounding of the center: all points would be the same
    /// doubles).
    pub fn from_radius(center: Point3, normal: Vec3, radius: f64) -> Result<Self> {
        range::check_point(0, center.to_vec())?;
        if !normal.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Normal, index: 0 }.into());
        }
        if !(radius > 0.0) {
            return Err(NumberError::RadiusNotPositive { what: ErrorItem::Radius, index: 0, radius }.into());
        }
        let normal = normal.unit().ok_or(Error::zero_axis(ErrorItem::Normal))?;
        let toward = if normal.x.abs() < 1.0 - 1e-9 { Vec3::X } else { Vec3::Y };
        Self::new(center, normal, across(toward, normal).unit().ok_or(Error::zero_axis(ErrorItem::Normal))? * radius)
    }

    /// Center and radius are kept as they are, whatever the rounding of points: so only a radius below the rounding of the
    /// center's coordinates is none, where surfaces, which are made from points, need more of theirs.
    fn new(center: Point3, normal: Vec3, spoke: Vec3) -> Result<Self> {
        let radius = spoke.length();
        range::check_distance(radius)?;
        range::check_size_in_place(ErrorItem::RadiusOfCircle, radius, center.to_vec().max_abs(), f64::EPSILON)?;
        Ok(Self { center, normal, spoke })
    }

    /// The circle through three points in their order, starting at the first
    /// (`docs/math/conformal.md#circle-through-three-points`).
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range`, `coincident-points`, `degenerate-circle` (sine of the angle at
    /// the middle point <= 1e-12).
    pub fn through_points(points: [Point3; 3]) -> Result<Self> {
        for (index, p) in points.into_iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        let [a, b, c] = points;
        let (p, q) = (a - b, c - b);
        let (lp, lq) = (p.length(), q.length());
        for (first, second, distance) in [(0, 1, lp), (1, 2, lq), (0, 2, a.distance(c))] {
            if distance == 0.0 {
                return Err(PointError::CoincidentPoints { first, second, distance, limit: 0.0 }.into());
            }
        }
        // Unit legs: products of the fourth power of the size would overflow.
        let (u, v) = (p / lp, q / lq);
        let w = u.cross(v);
        let sine = w.length();
        if sine <= COLLINEAR_LIMIT {
            return Err(ArcError::DegenerateCircle { sine, limit: COLLINEAR_LIMIT }.into());
        }
        // center = b + (|p|² (q × w) + |q|² (w × p)) / (2|w|²) with w = p × q
        let center = b + (v.cross(w) * lp + w.cross(u) * lq) / (2.0 * sine * sine);
        // a -> b -> c turns about (b-a) × (c-b) = q × p... = -(p × q)
        Self::from_center(center, -w, a)
    }

    /// Center.
    #[must_use]
    pub fn center(&self) -> Point3 {
        self.center
    }

    /// Unit normal.
    #[must_use]
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// Radius.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.spoke.length()
    }

    /// Start (and end) point.
    #[must_use]
    pub fn start(&self) -> Point3 {
        self.center + self.spoke
    }

    /// Unit tangent at a point of the circle (the direction `normal × (point - center)`).
    #[must_use]
    pub fn tangent_at(&self, point: Point3) -> Option<Vec3> {
        self.normal.cross(point - self.center).unit()
    }

    /// The point of the circle nearest to `p`; on the axis, where all points are equally near, the start.
    #[must_use]
    pub fn closest_point(&self, p: Point3) -> ClosestPoint {
        let v = p - self.center;
        // Scaled by the spoke: coordinates in the plane of the circle, x along the spoke.
        let unit = self.spoke / self.radius();
        let (x, y) = (v.dot(unit), v.dot(self.normal.cross(unit)));
        let turn = y.atan2(x) / std::f64::consts::TAU;
        let t = if turn < 0.0 { (turn + 1.0).min(1.0) } else { turn };
        let point = self.piece_jet(0, t).point;
        ClosestPoint { t, point, distance: point.distance(p) }
    }

    /// The same points run backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { normal: -self.normal, ..*self }
    }

    /// The image under a similarity or a reflection, with the same parameter.
    ///
    /// # Errors
    /// `not-a-similarity`; `not-finite`, `below-rounding-of-place` or `parameter-out-of-range` if the image is too large or too
    /// small.
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        map.check_similarity()?;
        let lost = Error::Number(NumberError::NotFinite { what: ErrorItem::Point, index: 0 });
        let center = map.map_point(self.center).ok_or(lost.clone())?;
        let start = map.map_point(self.start()).ok_or(lost.clone())?;
        // A reflection turns the sense of running: the normal of the pushed vectors, not the pushed normal.
        let push = |v: Vec3| map.push_forward(self.center, v).and_then(Vec3::unit);
        let (x, y) = (push(self.spoke), push(self.normal.cross(self.spoke)));
        let (x, y) = (x.ok_or(lost.clone())?, y.ok_or(lost)?);
        Self::from_center(center, x.cross(y), start)
    }

    /// The part between two parameters, `0 <= t0 < t1 <= 1`, not the whole circle: the same points, at the arc's own
    /// parameter.
    ///
    /// # Errors
    /// `parameter-out-of-range`, `sweep-out-of-range` (the whole circle).
    pub fn restricted(&self, t0: f64, t1: f64) -> Result<Arc> {
        let [t0, t1] = interval(t0, t1)?;
        self.part([t0, t1], t1 - t0)
    }

    /// The part from a parameter past the start to a smaller one, `0 < t1 < t0 < 1`, at the arc's own parameter.
    ///
    /// # Errors
    /// `parameter-out-of-range`, `sweep-out-of-range` (all but rounding of the circle).
    pub fn restricted_past_start(&self, t0: f64, t1: f64) -> Result<Arc> {
        check_past_start(true, t0, t1)?;
        self.part([t0, t1], (1.0 - t0) + t1)
    }

    /// The arc from one parameter to another that is this part of the circle.
    fn part(&self, [t0, t1]: [f64; 2], share: f64) -> Result<Arc> {
        let (start, end) = (self.piece_point(0, t0), self.piece_point(0, t1));
        let arc = Arc::from_center(self.center, self.normal, start, std::f64::consts::TAU * share)?;
        Ok(arc.with_start(start).with_end(end))
    }

    /// The two arcs before and after a parameter in `(0, 1)`.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn split(&self, t: f64) -> Result<(Arc, Arc)> {
        place_of_cut(t, 1)?;
        Ok((self.restricted(0.0, t)?, self.restricted(t, 1.0)?))
    }

    /// The circle as two half-circle arcs (one linear arc cannot close: `000`, Example 1 corrected).
    #[must_use]
    pub fn to_arcs(&self) -> [Arc; 2] {
        let (p, q) = (self.center + self.spoke, self.center - self.spoke);
        // Weight ratio: the unit normal itself, a pure quaternion; always perpendicular to the chord and no pole.
        let half = |a, b| Arc::from_ratio_unchecked(a, b, 0.0, self.normal);
        [half(p, q), half(q, p)]
    }

    /// The exact nine-point rational quadratic: corners of the square around the circle, weights
    /// `1, sqrt(1/2), 1, ...` (`docs/math/arcs.md#rational-form`).
    ///
    /// # Errors
    /// `not-finite` if a corner of the square overflows.
    pub fn to_nurbs(&self) -> Result<NurbsCurve> {
        let (c, d, e) = (self.center, self.spoke, self.normal.cross(self.spoke));
        let points = vec![c + d, c + d + e, c + e, c - d + e, c - d, c - d - e, c - e, c + d - e, c + d];
        let weights = (0..9).map(|i| if i % 2 == 0 { 1.0 } else { std::f64::consts::FRAC_1_SQRT_2 }).collect();
        let knots = vec![0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0];
        NurbsCurve::new(2, knots, points, weights)
    }
}

/// The part of `v` across a unit vector. Twice: where little is left, the first step leaves rounding of `v` along it.
fn across(v: Vec3, unit: Vec3) -> Vec3 {
    let once = v - unit * v.dot(unit);
    once - unit * once.dot(unit)
}

impl ParamCurve for Circle {
    fn piece_count(&self) -> usize {
        1
    }
    fn piece_jet(&self, _piece: usize, s: f64) -> CurveJet {
        let tau = std::f64::consts::TAU;
        // The second half backwards from the end, so that the end is the start to the bit.
        let (sin, cos) = (tau * if s > 0.5 { s - 1.0 } else { s }).sin_cos();
        let (d, e) = (self.spoke, self.normal.cross(self.spoke));
        let radial = d * cos + e * sin;
        let tangent = e * cos - d * sin;
        CurveJet {
            point: self.center + radial,
            d1: tangent * tau,
            d2: radial * -(tau * tau),
            d3: tangent * -(tau * tau * tau),
        }
    }
    fn is_closed(&self) -> bool {
        true
    }
    fn piece_speed(&self, _piece: usize, _s: f64) -> f64 {
        std::f64::consts::TAU * self.radius()
    }
    fn piece_hull(&self, _piece: usize, _tolerance: f64) -> Result<PieceHull> {
        Ok(PieceHull::closed_form())
    }
    fn piece_form(&self, _piece: usize) -> PieceForm {
        PieceForm::Circle(*self)
    }
    fn piece_length(&self, _piece: usize, s0: f64, s1: f64) -> f64 {
        std::f64::consts::TAU * self.radius() * (s1 - s0)
    }
    fn piece_bounds(&self, _piece: usize) -> Aabb {
        let [a, b] = self.to_arcs();
        a.bounds().union(b.bounds())
    }
}
