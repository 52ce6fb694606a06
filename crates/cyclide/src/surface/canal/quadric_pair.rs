//! Two cylinders or cones in any position, and the balls that touch both
//! (`docs/math/canal-blends.md#cylinders-and-cones-in-any-position`).
//!
//! Each surface has three linear forms `X`, `Y`, `L` of `(1, center, radius)` with `X² + Y² = L²` for the balls that touch it. The spans of both triples
//! meet in one form `l = a·(X1, Y1, L1) = b·(X2, Y2, L2)`, whose norm `N = aX² + aY² - aL²` is the same for both. Where it is negative the pair is the image of two
//! skew cylinders under a motion of the space of balls: the balls form a torus.

use super::moved_cylinders::{BallLine, MovedCylinders};
use super::{CanalPatch, NaturalQuadric, RollingBall};
use crate::base::elimination::null_vector;
use crate::base::planar::Point2;
use crate::error::{BallError, Error, ErrorItem, NumberError, Result};
use crate::surface::TorusPiece;

/// Norm ratios of this size or less are those of a degenerate pair.
const DEGENERATE: f64 = 1e-10;

/// Smallest pivot over the largest below which the spans have more than one form in common.
const MANY_FORMS: f64 = 1e-10;

/// The kind of a pair of cylinders and cones, by the sign of the norm of their common form.
///
/// ```
/// use cyclide::{Point3, Vec3, surface::{NaturalQuadric, PairKind, QuadricPair}};
/// let along = |axis: Vec3, height: f64| NaturalQuadric::cylinder(Point3::new(0.0, 0.0, height), axis, 1.0);
/// assert_eq!(QuadricPair::new([along(Vec3::X, 0.0)?, along(Vec3::Y, 3.0)?])?.kind(), PairKind::Timelike);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PairKind {
    /// Negative norm: the balls that touch both are those of a torus.
    Timelike,
    /// Positive norm: one surface runs through the other. The balls are those of the split form.
    Spacelike,
}

/// Two cylinders or cones in any position.
///
/// ```
/// use cyclide::{Point2, Point3, Vec3, surface::{NaturalQuadric, QuadricPair}};
/// let pipe = NaturalQuadric::cylinder(Point3::new(5.0, 0.0, -1.5), Vec3::X, 0.8)?;
/// let other = NaturalQuadric::cylinder(Point3::new(0.0, -7.0, 1.5), Vec3::Y, 1.3)?;
/// let ball = QuadricPair::new([pipe, other])?.ball(Point2::new(0.2, 1.3))?;
/// let contact = ball.contacts[0];
/// assert!((contact.y.hypot(contact.z + 1.5) - 0.8).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuadricPair {
    surfaces: [NaturalQuadric; 2],
    norm_ratio: f64,
    /// Of a timelike pair.
    moved: Option<MovedCylinders>,
}

impl QuadricPair {
    /// The pair, classified.
    ///
    /// # Errors
    /// `degenerate-pair` (the axes meet or are parallel in the space of balls: a common tangent ball for an axis, parallel or equal
    /// axes).
    pub fn new(surfaces: [NaturalQuadric; 2]) -> Result<Self> {
        let [p, q] = surfaces.map(|surface| surface.origin());
        let origin = p.midpoint(q);
        let unit = p.distance(q).max(surfaces[0].radius()).max(surfaces[1].radius()).max(f64::MIN_POSITIVE);
        let forms = surfaces.map(|surface| surface.forms(origin).map(|[c, rest @ ..]| in_unit(c / unit, rest)));
        let column = |j: usize| if j < 3 { forms[0][j] } else { forms[1][j - 3].map(|x| -x) };
        let rows: [[f64; 6]; 5] = std::array::from_fn(|i| std::array::from_fn(|j| column(j)[i]));
        let (v, pivot) = null_vector(rows).unwrap_or(([0.0; 6], 0.0));
        if !(pivot > MANY_FORMS) {
            return Err(BallError::DegeneratePair { measured: pivot, limit: MANY_FORMS }.into());
        }
        let [x, y, l] = [v[0], v[1], v[2]];
        let gradient: f64 = (1..5).map(|k| (0..3).map(|i| v[i] * forms[0][i][k]).sum::<f64>().powi(2)).sum();
        let norm_ratio = (x * x + y * y - l * l) / gradient;
        let degenerate = Error::Ball(BallError::DegeneratePair { measured: norm_ratio, limit: DEGENERATE });
        if !(norm_ratio.abs() > DEGENERATE) {
            return Err(degenerate);
        }
        let moved = if norm_ratio < 0.0 {
            Some(MovedCylinders::new([0, 1].map(|i: usize| BallLine::of_quadric(&surfaces[i]))).ok_or(degenerate)?)
        } else {
            None
        };
        Ok(Self { surfaces, norm_ratio, moved })
    }

    /// The surfaces.
    #[must_use]
    pub fn surfaces(&self) -> &[NaturalQuadric; 2] {
        &self.surfaces
    }

    /// The kind.
    #[must_use]
    pub fn kind(&self) -> PairKind {
        if self.norm_ratio < 0.0 { PairKind::Timelike } else { PairKind::Spacelike }
    }

    /// Norm of the common form over the square of the length of its gradient by center and radius: negative for timelike pairs,
    /// between -1 and 1.
    #[must_use]
    pub fn norm_ratio(&self) -> f64 {
        self.norm_ratio
    }

    /// The ball of a place `(A, B)` of the plane of a torus, radians, each modulo pi, inside the diamond of [`SkewCylinders`](super::SkewCylinders). Its radius may
    /// be negative: a ball inside both.
    ///
    /// # Errors
    /// `not-finite`; `not-timelike-pair`; `sphere-at-infinity` (on the border of the diamond); `wrong-side` (outside: it touches from the other side, or the
    /// other nappe of a cone).
    pub fn ball(&self, place: Point2) -> Result<RollingBall> {
        if !place.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Angle, index: 0 }.into());
        }
        self.moved()?.ball(place)
    }

    /// The radius of the smallest ball outside both, negative where they overlap: of cylinders half the gap.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, surface::{NaturalQuadric, QuadricPair}};
    /// let pipe = NaturalQuadric::cylinder(Point3::ORIGIN, Vec3::X, 1.0)?;
    /// let cone = NaturalQuadric::cone(Point3::new(0.0, -4.0, 3.0), Vec3::Y, 0.2)?;
    /// let radius = QuadricPair::new([pipe, cone])?.smallest_radius()?;
    /// // The height between both over the origin is 2 less 4 tan 0.2; the gap is least where the cone is thicker.
    /// assert!(radius < 1.0 - 2.0 * 0.2_f64.tan() && radius > 0.4);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-timelike-pair`; `sphere-at-infinity` (cones that overlap without end).
    pub fn smallest_radius(&self) -> Result<f64> {
        self.moved()?.smallest_radius().ok_or(Error::Ball(BallError::SphereAtInfinity { measured: -1.0, limit: 0.0 }))
    }

    /// The place of a ball of a given radius, at an angle `theta` of the closed curve of all such balls
    /// (`docs/math/canal-blends.md#cylinders-and-cones-in-any-position`). This curve is not rational.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, surface::{NaturalQuadric, QuadricPair}};
    /// let pipe = NaturalQuadric::cylinder(Point3::ORIGIN, Vec3::X, 1.0)?;
    /// let cone = NaturalQuadric::cone(Point3::new(0.0, -4.0, 3.0), Vec3::Y, 0.2)?;
    /// let pair = QuadricPair::new([pipe, cone])?;
    /// let ball = pair.ball(pair.place_of_radius(0.9, 1.0)?)?;
    /// assert!((ball.radius - 0.9).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-finite`, `not-timelike-pair`, `radius-too-small`, `sphere-at-infinity` (the curve is not closed).
    pub fn place_of_radius(&self, radius: f64, theta: f64) -> Result<Point2> {
        for (what, value) in [(ErrorItem::Radius, radius), (ErrorItem::Angle, theta)] {
            if !value.is_finite() {
                return Err(NumberError::NotFinite { what, index: 0 }.into());
            }
        }
        Ok(self.moved()?.radius_loop(radius)?.place(theta))
    }

    pub(super) fn moved(&self) -> Result<MovedCylinders> {
        self.moved.ok_or(Error::Ball(BallError::NotTimelikePair { measured: self.norm_ratio, limit: 0.0 }))
    }
}

impl CanalPatch {
    /// The patch between two cylinders or cones in any position along a piece of a spline in the plane of their balls, inside the diamond. Its degrees are those
    /// [between two skew cylinders](Self::between_skew_cylinders).
    ///
    /// ```
    /// use cyclide::{Frame, Point3, Vec3, construct::TorusSplineOptions, surface::{CanalPatch, NaturalQuadric, QuadricPair, Torus, TorusSpline}};
    /// let pipe = NaturalQuadric::cylinder(Point3::ORIGIN, Vec3::X, 1.0)?;
    /// let cone = NaturalQuadric::cone(Point3::new(0.0, -4.0, 2.0), Vec3::Y, 0.2)?;
    /// let pair = QuadricPair::new([pipe, cone])?;
    /// let places = (0..8).map(|k| pair.place_of_radius(0.5, 0.785 * f64::from(k))).collect::<Result<Vec<_>, _>>()?;
    /// // The plane of any torus serves: places are all that counts.
    /// let options = TorusSplineOptions { closed: true, ..Default::default() };
    /// let spline = TorusSpline::through_places(&Torus::new(Frame::WORLD, 2.0, 1.0)?, &places, &options)?;
    /// let patch = CanalPatch::between_quadrics(&pair, &spline.pieces()[0])?;
    /// let on_pipe = patch.point(0.3, 0.0);
    /// assert!((on_pipe.y.hypot(on_pipe.z) - 1.0).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `not-timelike-pair`; as [`along`](Self::along).
    pub fn between_quadrics(pair: &QuadricPair, piece: &TorusPiece) -> Result<Self> {
        let [patch, _] = pair.moved()?.patches(piece)?;
        Ok(patch)
    }
}

fn in_unit(first: f64, [a, b, c, d]: [f64; 4]) -> [f64; 5] {
    [first, a, b, c, d]
}
