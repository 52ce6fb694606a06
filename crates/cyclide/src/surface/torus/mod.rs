//! The placed ring torus and its plane of two angles.
//!
//! With radii `a > b > 0`, `c = sqrt((a-b)(a+b))`, a place is a pair `(A, B)` modulo `pi`, in which every circle of the four
//! families is a straight line (`docs/math/torus-splines.md#the-plane-of-the-torus`):
//! ```text
//! q = (a-b) + 2b sin² B,   rho = c²/q,   point = (rho cos 2A, rho sin 2A, b c sin 2B / q)
//! longitude = 2A,   tan(meridian angle / 2) = sqrt((a+b)/(a-b)) tan B
//! ```
//! The map is conformal for the lengths `|dA|`, `(b/c) |dB|`. Inside everything is in units of the major radius, so that no square
//! overflows.

mod circle;
mod class;
mod coordinates;
mod crossing;
mod family;
mod junction;
mod locate;
mod parallel;
mod piece;
pub(in crate::surface) mod rows;
mod spline;
mod spline_curve;
mod spline_edit;

pub use class::TorusClasses;
pub(crate) use class::within_a_turn;
pub(crate) use crossing::PlaceAngle;
pub use family::{CircleFamily, QuarticType};
pub use junction::TorusJunction;
pub(crate) use piece::Course;
pub use piece::TorusPiece;
pub(crate) use rows::Spans;
pub(crate) use spline::TorusChain;
pub use spline::{SegmentMethod, TorusSegment, TorusSpline};

use super::{DupinCyclide, ParamSurface};
use crate::base::frame::Frame;
use crate::base::jet::CurveJet;
use crate::base::planar::{Point2, Vec2};
use crate::base::range;
use crate::base::surface_jet::SurfaceJet;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::error::{Error, ErrorItem, NumberError, Result, TorusError};
use class::UnitPair;
use coordinates::{Jet3, Shape};

/// A ring torus in space: a tube about a circle, thinner than the circle.
///
/// Places are points of its plane, [`Point2`] with `x = A`, `y = B` in radians, each modulo pi: `A` is half the longitude, counted
/// about the third axis of the frame from its first one; `B` counts round the tube from its outer side, rising towards the third
/// axis. Speeds are [`Vec2`] with `x = dA/du`, `y = dB/du`. Horn and spindle tori are refused: they have no such plane.
///
/// As a [`ParamSurface`] it is `s -> A = pi s`, `t -> B = pi t`, normal outward.
///
/// ```
/// use cyclide::{Frame, Point2, Point3, surface::Torus};
/// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
/// assert_eq!(torus.point(Point2::new(0.0, 0.0)), Point3::new(4.0, 0.0, 0.0));
/// let place = torus.locate(Point3::new(0.0, 3.0, 1.0), 1e-9)?; // on top, a quarter round
/// assert!(torus.point(place).distance(Point3::new(0.0, 3.0, 1.0)) < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torus {
    frame: Frame,
    major: f64,
    minor: f64,
    shape: Shape,
}

impl Torus {
    /// The torus about the third axis of `frame`, whose tube of radius `minor` follows the circle of radius `major` about the
    /// origin of the frame.
    ///
    /// # Errors
    /// `not-finite`, `not-a-ring-torus` (unless `0 < minor < major`), `parameter-out-of-range` (coordinates or radii outside 1e-150
    /// to 1e150), `below-rounding-of-place` (the tube is below 1.5e-11 of the coordinates).
    pub fn new(frame: Frame, major: f64, minor: f64) -> Result<Self> {
        if !(major.is_finite() && minor.is_finite()) {
            return Err(
                NumberError::NotFinite { what: ErrorItem::Radius, index: usize::from(major.is_finite()) }.into()
            );
        }
        if !(minor > 0.0 && minor < major) {
            return Err(TorusError::NotARingTorus { major, minor }.into());
        }
        range::check_point(0, frame.origin().to_vec())?;
        range::check_distance(major)?;
        range::check_distance(minor)?;
        let place = frame.origin().to_vec().max_abs().max(major);
        range::check_size_in_place(ErrorItem::Torus, minor, place, range::SMALLEST_IN_PLACE)?;
        Ok(Self { frame, major, minor, shape: Shape::new(major, minor) })
    }

    /// Where the torus stands: its third axis is the axis of the torus.
    #[must_use]
    pub fn frame(&self) -> Frame {
        self.frame
    }

    /// Radius of the circle that the middle of the tube follows.
    #[must_use]
    pub fn major_radius(&self) -> f64 {
        self.major
    }

    /// Radius of the tube.
    #[must_use]
    pub fn minor_radius(&self) -> f64 {
        self.minor
    }

    /// The point at a place.
    #[must_use]
    pub fn point(&self, place: Point2) -> Point3 {
        self.world_point(self.shape.point(&UnitPair::at(place)))
    }

    /// Outward unit normal at a place.
    #[must_use]
    pub fn unit_normal(&self, place: Point2) -> Vec3 {
        self.normal_at(&UnitPair::at(place))
    }

    /// The velocity in space of a curve that passes a place at the speed `rate`.
    #[must_use]
    pub fn tangent(&self, place: Point2, rate: Vec2) -> Vec3 {
        self.jet_at(&UnitPair::at(place), &Jet3::linear(rate)).d1
    }

    /// The place at a longitude and a meridian angle, radians: the point of the circle of the tube that stands at `longitude`, turned
    /// by `meridian` from the outer side. Whole turns of both are kept.
    #[must_use]
    pub fn place_of_angles(&self, longitude: f64, meridian: f64) -> Point2 {
        Point2::new(0.5 * longitude, self.shape.tube_angle(0.5 * meridian))
    }

    /// Longitude and meridian angle of a place, radians: the inverse of [`place_of_angles`](Self::place_of_angles).
    #[must_use]
    pub fn angles_of_place(&self, place: Point2) -> [f64; 2] {
        [2.0 * place.x, 2.0 * self.shape.half_meridian(place.y)]
    }

    /// The speed in the plane of the torus, at a place, of a curve whose longitude and meridian angle have these rates, radians by its
    /// parameter.
    ///
    /// ```
    /// use cyclide::{Frame, Point2, surface::Torus};
    /// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
    /// let (from, to) = (torus.place_of_angles(0.3, 2.0), torus.place_of_angles(0.3 + 2e-6, 2.0 - 5e-6));
    /// let rate = torus.rate_of_angles(from, [2.0, -5.0]);
    /// assert!(((to - from) * 1e6 - rate).length() < 1e-4);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn rate_of_angles(&self, place: Point2, [longitude, meridian]: [f64; 2]) -> Vec2 {
        let radius = self.shape.radius(&UnitPair::at(place));
        Vec2::new(0.5 * longitude, 0.5 * self.shape.root * meridian / radius)
    }

    /// Rates of longitude and meridian angle of a curve that passes a place at the speed `rate`: the inverse of
    /// [`rate_of_angles`](Self::rate_of_angles).
    #[must_use]
    pub fn angle_rates(&self, place: Point2, rate: Vec2) -> [f64; 2] {
        let radius = self.shape.radius(&UnitPair::at(place));
        [2.0 * rate.x, 2.0 * rate.y * radius / self.shape.root]
    }

    /// Distance of a point from the axis of the torus, at a place.
    #[must_use]
    pub fn distance_from_axis(&self, place: Point2) -> f64 {
        self.major * self.shape.radius(&UnitPair::at(place))
    }

    /// Distance of a point from the torus, negative inside of the tube; NaN of a point that is not finite.
    ///
    /// ```
    /// use cyclide::{Frame, Point3, surface::Torus};
    /// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
    /// assert_eq!(torus.distance(Point3::new(0.0, 3.0, 1.5)), 0.5);
    /// assert_eq!(torus.distance(Point3::new(0.0, 3.0, 0.0)), -1.0);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn distance(&self, p: Point3) -> f64 {
        let (plane, height) = self.frame.to_local(p);
        let from_core = (plane - Point2::default()).length() / self.major - 1.0;
        (Vec2::new(from_core, height / self.major).length() - self.shape.tube) * self.major
    }

    /// The same torus as a cyclide, of which bodies are made: patches round both ways in the same frame.
    ///
    /// ```
    /// use cyclide::{Frame, surface::Torus};
    /// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
    /// let solid = torus.to_cyclide()?.to_bodies([8, 6])?.remove(0);
    /// assert!((solid.outer.volume() - 6.0 * std::f64::consts::PI.powi(2)).abs() < 1e-9); // Pappus
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `parameter-out-of-range` (the tube is below 1e-6 of the major radius).
    pub fn to_cyclide(&self) -> Result<DupinCyclide> {
        Ok(DupinCyclide::new(self.major, 0.0, self.minor)?.placed(self.frame))
    }

    /// The image under a similarity or a reflection. The longitude of the image of a place changes its sign under a map that turns
    /// the orientation round; everything else of the place stays.
    ///
    /// # Errors
    /// `not-a-similarity`; `not-finite`, or as [`new`](Self::new), if the image is too large or too small.
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        map.check_similarity()?;
        let lost = Error::Number(NumberError::NotFinite { what: ErrorItem::Frame, index: 0 });
        let f = self.frame;
        let origin = map.map_point(f.origin()).ok_or(lost.clone())?;
        let pushed = |v: Vec3| map.push_forward(f.origin(), v).filter(|v| v.is_finite()).ok_or(lost.clone());
        let (x, z) = (pushed(f.x())?, pushed(f.z())?);
        let scale = z.length();
        Self::new(Frame::from_normal(origin, z, x)?, self.major * scale, self.minor * scale)
    }

    /// In space, from the coordinates in units of the major radius.
    fn world_point(&self, local: Vec3) -> Point3 {
        self.frame.origin() + self.world_vector(local)
    }

    fn world_vector(&self, local: Vec3) -> Vec3 {
        let l = local * self.major;
        self.frame.x() * l.x + self.frame.y() * l.y + self.frame.z() * l.z
    }

    fn normal_at(&self, at: &UnitPair) -> Vec3 {
        let n = self.shape.normal(at);
        self.frame.x() * n.x + self.frame.y() * n.y + self.frame.z() * n.z
    }

    /// Speed in space of a curve that passes a place at the speed `rate`: the plane is conformal.
    fn speed_at(&self, at: &UnitPair, rate: Vec2) -> f64 {
        let tube = rate.y * self.shape.tube / self.shape.root;
        2.0 * self.major * self.shape.radius(at) * Vec2::new(rate.x, tube).length()
    }

    /// Point and derivatives of a curve through a place whose angles have these derivatives.
    fn jet_at(&self, at: &UnitPair, rates: &Jet3) -> CurveJet {
        let [p, d1, d2, d3] = self.shape.jet(at, rates);
        CurveJet {
            point: self.world_point(p),
            d1: self.world_vector(d1),
            d2: self.world_vector(d2),
            d3: self.world_vector(d3),
        }
    }
}

impl ParamSurface for Torus {
    fn jet(&self, s: f64, t: f64) -> SurfaceJet {
        let pi = std::f64::consts::PI;
        let at = UnitPair::at(Point2::new(pi * s, pi * t));
        let along = |rate: Vec2| self.jet_at(&at, &Jet3::linear(rate));
        let (s, t) = (along(Vec2::new(pi, 0.0)), along(Vec2::new(0.0, pi)));
        // x''(1,1) = x_ss + 2 x_st + x_tt.
        let both = along(Vec2::new(pi, pi));
        SurfaceJet { point: s.point, ds: s.d1, dt: t.d1, dss: s.d2, dst: (both.d2 - s.d2 - t.d2) * 0.5, dtt: t.d2 }
    }

    fn normal(&self, s: f64, t: f64) -> Option<Vec3> {
        let pi = std::f64::consts::PI;
        Some(self.unit_normal(Point2::new(pi * s, pi * t)))
    }
}
