//! The circular arc: two end points and a quaternion weight ratio.
//!
//! ```text
//! xi(t) = (a0 w0 (1-t) + a1 w1 t) (w0 (1-t) + w1 t)^-1 = a0 + c (t w x^-1)
//! c = a1 - a0,  w = w1 w0^-1 = (r, p),  x(t) = (1-t) + t w
//! ```
//! (source: `000`, equations (4), (11)). Only the ratio `w` matters. The arc stays in three-space exactly when
//! `<c, p> = 0` (Proposition 4) and turns by `2 alpha`, right-handed about `p`, where `alpha = atan2(|p|, r)`; a
//! straight segment is `p = 0` and needs no special case. `|w|` is parametrisation only, but it is kept: it matters
//! as soon as the arc is a line of a surface.

mod construct;
pub(super) mod measure;
pub(super) mod subdivide;
mod transform;

use super::param_curve::ParamCurve;
use super::piece_form::PieceForm;
use super::piece_hull::PieceHull;
use crate::base::bounds::Aabb;
use crate::base::jet::CurveJet;
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ArcError, ErrorItem, NumberError, Result};
use crate::rational::RationalBezier;

/// What an arc must leave of a full turn at least, radians: a bulge of ten millions. Points at a parameter are off their
/// circle by about as many roundings of its size as the bulge says: 3e-9 of it at the limit.
const FULL_CIRCLE_LIMIT: f64 = 3.9e-7;

/// Up to this part of a negative real ratio its vector part is rounding: the arc runs through infinity.
const POLE_LIMIT: f64 = 8.0 * f64::EPSILON;

/// A circular arc or straight segment in space, parametrised by a linear fraction over `t` in `[0, 1]`.
///
/// Never a full circle (its ends would coincide): see [`Circle`](crate::curve::Circle).
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// assert!((arc.angle() - std::f64::consts::PI).abs() < 1e-15 && arc.midpoint().distance(b) < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    p0: Point3,
    p1: Point3,
    /// Real part of the weight ratio.
    r: f64,
    /// Vector part of the weight ratio, perpendicular to the chord.
    p: Vec3,
    /// Chord `a1 - a0`.
    c: Vec3,
    /// `c × p`.
    cp: Vec3,
    /// `|p|`.
    pn: f64,
    /// `|w|`.
    n: f64,
}

/// Numbers `s + q p` of the commutative field spanned by 1 and the vector part `p` of the weight (`p² = -|p|²`).
/// Kept as `(s, q)` so that lines (`p = 0`) need no division by `|p|`.
#[derive(Clone, Copy)]
struct Along {
    s: f64,
    q: f64,
}

impl Along {
    fn mul(self, o: Self, p2: f64) -> Self {
        Self { s: self.s * o.s - self.q * o.q * p2, q: self.s * o.q + self.q * o.s }
    }
}

impl Arc {
    /// The one place where arcs are made: checks that the data give a finite curve in three-space.
    ///
    /// `r + p` is the weight ratio; the part of `p` along the chord must be rounding and is removed.
    pub(super) fn from_ratio(p0: Point3, p1: Point3, r: f64, p: Vec3) -> Result<Self> {
        range::check_point(0, p0.to_vec())?;
        range::check_point(1, p1.to_vec())?;
        range::check_distance(p0.distance(p1))?;
        if !(r.is_finite() && p.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Weight, index: 1 }.into());
        }
        let pn = p.length();
        let n = r.hypot(pn);
        if n == 0.0 {
            return Err(ArcError::ZeroWeight { index: 1 }.into());
        }
        range::check_weight_ratio(n)?;
        let limit = POLE_LIMIT * -r;
        if r < 0.0 && pn <= limit {
            return Err(ArcError::PoleOnSegment { real: r, vector: pn, limit }.into());
        }
        Ok(Self::from_ratio_unchecked(p0, p1, r, p))
    }

    /// The same arc with another parameter: with weights of equal length, so that it runs at the same speed at both ends.
    /// Where their lengths are very different, numbers near an end of `[0, 1]` cannot tell the places apart that most of
    /// the arc is made of.
    #[must_use]
    pub fn evened(&self) -> Self {
        Self::from_ratio_unchecked(self.p0, self.p1, self.r / self.n, self.p / self.n)
    }

    /// The arc, unless it is nearly a full circle: the more it turns, the shorter is the part of its parameter in which it
    /// does, and its points lose as many digits as that is short.
    ///
    /// # Errors
    /// `nearly-full-circle`.
    pub(super) fn short_of_full_circle(self) -> Result<Self> {
        let rest = 2.0 * self.pn.atan2(-self.r);
        if self.r < 0.0 && rest < FULL_CIRCLE_LIMIT {
            return Err(ArcError::NearlyFullCircle { rest, limit: FULL_CIRCLE_LIMIT }.into());
        }
        Ok(self)
    }

    /// As [`from_ratio`](Self::from_ratio) for data that are valid by construction (no pole, finite, `p` across the
    /// chord).
    pub(crate) fn from_ratio_unchecked(p0: Point3, p1: Point3, r: f64, p: Vec3) -> Self {
        let (c, pn) = (p1 - p0, p.length());
        Self { p0, p1, r, p, c, cp: c.cross(p), pn, n: r.hypot(pn) }
    }

    /// Start point.
    #[must_use]
    pub fn start(&self) -> Point3 {
        self.p0
    }

    /// End point.
    #[must_use]
    pub fn end(&self) -> Point3 {
        self.p1
    }

    /// Chord, end minus start.
    #[must_use]
    pub fn chord(&self) -> Vec3 {
        self.c
    }

    /// Weight ratio `w1 w0^-1`.
    #[must_use]
    pub fn weight_ratio(&self) -> Quat {
        Quat::from_parts(self.r, self.p)
    }

    /// Unit normal of the arc's plane, about which it turns right-handed; `None` for a straight segment.
    #[must_use]
    pub fn normal(&self) -> Option<Vec3> {
        if self.c.max_abs() > 0.0 { self.p.unit() } else { None }
    }

    /// True if the arc is a straight segment (or one point).
    #[must_use]
    pub fn is_straight(&self) -> bool {
        self.pn == 0.0 || self.c.max_abs() == 0.0
    }

    /// Half the swept angle, in `[0, pi)`.
    fn alpha(&self) -> f64 {
        self.pn.atan2(self.r)
    }

    /// Swept angle in `[0, 2 pi)`, right-handed about [`normal`](Self::normal), radians.
    #[must_use]
    pub fn angle(&self) -> f64 {
        2.0 * self.alpha()
    }

    /// Curvature `2|p|/(|c| |w|)`; 0 for a straight segment.
    #[must_use]
    pub fn curvature(&self) -> f64 {
        self.curvature_binormal().length()
    }

    /// Curvature times the binormal: `2 p/(|c| |w|)` (`000`, Proposition 3 in the form of no radius). Zero for a
    /// straight segment and for a constant arc.
    #[must_use]
    pub fn curvature_binormal(&self) -> Vec3 {
        let l = self.c.length();
        if l > 0.0 { self.p * (2.0 / self.n) / l } else { Vec3::ZERO }
    }

    /// Radius; `None` for a straight segment.
    #[must_use]
    pub fn radius(&self) -> Option<f64> {
        let radius = self.c.length() * self.n / (2.0 * self.pn);
        (!self.is_straight() && radius.is_finite()).then_some(radius)
    }

    /// Center; `None` for a straight segment. (`000`, Proposition 3; finite also for a half circle, where (13) is not.)
    #[must_use]
    pub fn center(&self) -> Option<Point3> {
        if self.is_straight() {
            return None;
        }
        // u × c = -(c × p)/|p|
        let center = self.p0.midpoint(self.p1) - self.cp * (0.5 * self.r / self.pn / self.pn);
        center.is_finite().then_some(center)
    }

    /// Denominator parts `X = 1 - t + t r` and `D = |x|² = X² + t²|p|²`.
    fn denominator(&self, t: f64) -> (f64, f64) {
        let x = 1.0 - t + t * self.r;
        let y = t * self.pn;
        (x, x * x + y * y)
    }

    /// The point at `t`, exact at both ends, without cancellation for lines.
    #[must_use]
    pub fn point(&self, t: f64) -> Point3 {
        let (x, d) = self.denominator(t);
        let s = 1.0 - t;
        if t <= 0.5 {
            self.p0 + (self.c * (t * (t * self.n * self.n + s * self.r)) + self.cp * (t * s)) / d
        } else {
            self.p1 - (self.c * (s * x) - self.cp * (t * s)) / d
        }
    }

    /// Derivatives of orders 1 to 3: `(-1)^(k-1) k! c w (w-1)^(k-1) x^-(k+1)`; 1 and `w` commute.
    fn derivatives(&self, t: f64) -> [Vec3; 3] {
        let p2 = self.pn * self.pn;
        let (x, d) = self.denominator(t);
        let inverse = Along { s: x / d, q: -t / d };
        let minus_step = Along { s: 1.0 - self.r, q: -1.0 }; // -(w - 1)
        let mut z = Along { s: self.r, q: 1.0 }.mul(inverse, p2);
        let mut factorial = 1.0;
        std::array::from_fn(|k| {
            z = z.mul(inverse, p2);
            if k > 0 {
                z = z.mul(minus_step, p2);
                factorial *= (k + 1) as f64;
            }
            (self.c * z.s + self.cp * z.q) * factorial
        })
    }

    /// Derivative at `t = 0`: `c w`.
    #[must_use]
    pub fn start_derivative(&self) -> Vec3 {
        self.c * self.r + self.cp
    }

    /// Derivative at `t = 1`: `c w^-1`.
    #[must_use]
    pub fn end_derivative(&self) -> Vec3 {
        (self.c * self.r - self.cp) / self.n / self.n
    }

    /// Unit tangent at the start; `None` if the arc is one point.
    #[must_use]
    pub fn start_tangent(&self) -> Option<Vec3> {
        self.start_derivative().unit()
    }

    /// Unit tangent at the end; `None` if the arc is one point.
    #[must_use]
    pub fn end_tangent(&self) -> Option<Vec3> {
        (self.c * self.r - self.cp).unit()
    }

    /// The same points run backwards: `xi(1 - t)`.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let n2 = self.n * self.n;
        Self::from_ratio_unchecked(self.p1, self.p0, self.r / n2, -self.p / n2)
    }

    /// The arc itself, or the segment if it departs from its chord by no more than the rounding of its coordinates:
    /// its curvature would be noise.
    pub(crate) fn settled(&self) -> Self {
        let size = self.p0.to_vec().max_abs().max(self.p1.to_vec().max_abs());
        let sagitta = 0.5 * self.c.length() * self.bulge_vector().length();
        if sagitta <= f64::EPSILON * size { self.straightened() } else { self.without_lost_circle() }
    }

    /// The arc itself, or the segment if its radius is within the rounding of its coordinates: its center would be the
    /// same doubles as its points.
    fn without_lost_circle(&self) -> Self {
        let size = self.p0.to_vec().max_abs().max(self.p1.to_vec().max_abs());
        let lost = self.radius().is_some_and(|radius| radius <= 2.0 * f64::EPSILON * size);
        if lost { self.straightened() } else { *self }
    }

    /// The segment between the same ends, at the same start speed.
    pub(crate) fn straightened(&self) -> Self {
        Self::from_ratio_unchecked(self.p0, self.p1, self.n, Vec3::ZERO)
    }

    /// The same weight with the start moved (by rounding): ties the joints of a chain to equal doubles.
    pub(crate) fn with_start(&self, p0: Point3) -> Self {
        Self::tied(p0, self.p1, self.r, self.p)
    }

    /// The same weight with the end moved (by rounding).
    pub(crate) fn with_end(&self, p1: Point3) -> Self {
        Self::tied(self.p0, p1, self.r, self.p)
    }

    fn tied(p0: Point3, p1: Point3, r: f64, p: Vec3) -> Self {
        let across = (p1 - p0).unit().map_or(p, |c| p - c * p.dot(c));
        Self::from_ratio_unchecked(p0, p1, r, across)
    }

    /// The homogeneous rows `[X, Y, Z, W]` of the exact rational quadratic with the same parameter, first weight 1
    /// (`000`, Proposition 2, (10), (15)). The middle weight is 0 for a half circle and negative beyond: write
    /// the row, never the quotient, or take [`to_nurbs`](Self::to_nurbs).
    #[must_use]
    pub fn bezier_rows(&self) -> [[f64; 4]; 3] {
        let row = |v: Vec3, w: f64| [v.x, v.y, v.z, w];
        let (a0, a1, n2) = (self.p0.to_vec(), self.p1.to_vec(), self.n * self.n);
        [row(a0, 1.0), row(((a0 + a1) * self.r + self.cp) * 0.5, self.r), row(a1 * n2, n2)]
    }
}

impl Arc {
    /// The rational quadratic of [`bezier_rows`](Arc::bezier_rows), with the same parameter.
    #[must_use]
    pub fn to_rational(&self) -> RationalBezier {
        RationalBezier::from_rows_unchecked(self.bezier_rows().to_vec())
    }
}

impl ParamCurve for Arc {
    fn piece_count(&self) -> usize {
        1
    }
    fn piece_jet(&self, _piece: usize, s: f64) -> CurveJet {
        let [d1, d2, d3] = self.derivatives(s);
        CurveJet { point: self.point(s), d1, d2, d3 }
    }
    fn is_closed(&self) -> bool {
        false
    }
    fn piece_point(&self, _piece: usize, s: f64) -> Point3 {
        self.point(s)
    }
    /// `|c| |w|/D` (`docs/math/arcs.md#evaluation`).
    fn piece_speed(&self, _piece: usize, s: f64) -> f64 {
        self.c.length() * self.n / self.denominator(s).1
    }
    fn piece_hull(&self, _piece: usize, _tolerance: f64) -> Result<PieceHull> {
        Ok(PieceHull::closed_form())
    }
    fn piece_form(&self, _piece: usize) -> PieceForm {
        PieceForm::Arc(*self)
    }
    fn piece_length(&self, _piece: usize, s0: f64, s1: f64) -> f64 {
        self.length_to(s1) - self.length_to(s0)
    }
    fn piece_bounds(&self, _piece: usize) -> Aabb {
        self.bounds()
    }
}
