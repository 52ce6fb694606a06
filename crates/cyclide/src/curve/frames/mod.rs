//! Frames along a curve: a unit tangent with a normal and a binormal beside it, at every place.
//!
//! ```text
//! up, toward             normal: the part of a given direction, or of the direction to a point, across the tangent
//! look at                first axis: the direction to a point, in place of the tangent; normal: the part of a given direction across it
//! Frenet                 normal: to the centre of curvature; none where the curve is straight
//! rotation-minimizing    normal: carried along without turning about the tangent
//! ```
//! The first needs nothing but the place, and turns round where the tangent passes the direction. The third is [carried](transport)
//! from the start (`docs/math/curve-measures.md#frames`).

mod transport;

use crate::base::jet::CurveJet;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{ArcLength, ParamCurve};
use crate::error::{CurveError, Error, ErrorItem, NumberError, Result};
use transport::Transport;

/// Sine of the angle with the tangent up to which a direction says nothing about the normal.
const ALONG: f64 = 1e-9;
/// Curvature times length of the curve up to which the curvature has no direction.
const STRAIGHT: f64 = 1e-9;
/// Roundings of the coordinates that the second derivative of a place may be.
const ROUNDINGS: f64 = 64.0 * f64::EPSILON;
/// The default tolerance of rotation-minimizing frames, radians.
const TOLERANCE: f64 = 1e-9;

/// How the normals of frames are chosen.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{Circle, CurveFrames, FrameRule}};
/// let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 2.0)?;
/// let banked = CurveFrames::new(&circle, &FrameRule::Up(Vec3::Z))?.at(0.25)?;
/// assert!((banked.normal - Vec3::Z).length() < 1e-15); // up, and the binormal to the outer side
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FrameRule {
    /// Toward a fixed direction of any length: what is up for a road or a camera.
    Up(Vec3),
    /// Toward a point, as near as the tangent allows.
    Toward(Point3),
    /// The first axis exactly at a point: a camera or a tool that is carried along the curve and looks there. The curve's tangent plays no part.
    LookAt {
        /// What it looks at.
        target: Point3,
        /// The direction of any length that the normal is as near to as it can be.
        up: Vec3,
    },
    /// To the center of curvature.
    Frenet,
    /// Carried along without turning about the tangent: double reflection (Wang, Jüttler, Zheng, Liu 2008) with steps that are
    /// halved until one step and two halves agree.
    RotationMinimizing {
        /// The direction whose part across the first tangent is the first normal; by default z, or any where that is
        /// the tangent.
        start: Option<Vec3>,
        /// What becomes of the angle by which the frame of a closed curve misses itself.
        closed: ClosedTwist,
        /// Largest sum of these differences over the curve, radians, unless rounding is more; frames are wrong by about a
        /// fifteenth of it.
        tolerance: f64,
    },
}

impl FrameRule {
    /// Rotation-minimizing frames with the default start, within 1e-9 radians.
    #[must_use]
    pub const fn rotation_minimizing() -> Self {
        Self::RotationMinimizing { start: None, closed: ClosedTwist::Leave, tolerance: TOLERANCE }
    }
}

/// What becomes of the angle by which a rotation-minimizing frame that is carried once round a closed curve misses itself, the
/// *holonomy*.
///
/// ```
/// assert_eq!(cyclide::curve::ClosedTwist::default(), cyclide::curve::ClosedTwist::Leave);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ClosedTwist {
    /// It stays: the last frame is turned against the first one.
    #[default]
    Leave,
    /// It is spread over the length evenly: the frames close, and turn about the tangent as little as that allows.
    Spread,
}

/// A frame at a place of a curve: right-handed, first axis × normal = binormal.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{Circle, CurveFrames, FrameRule}};
/// let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 2.0)?;
/// let frame = CurveFrames::new(&circle, &FrameRule::Frenet)?.at(0.0)?;
/// assert!((frame.binormal - Vec3::Z).length() < 1e-15 && (frame.normal.dot(frame.point.to_vec()) + 2.0).abs() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CurveFrame {
    /// Global parameter in `[0, 1]`.
    pub t: f64,
    /// The point.
    pub point: Point3,
    /// Unit tangent, in the direction of travel; at a joint that of the piece that starts there.
    pub tangent: Vec3,
    /// The first axis: the tangent, or of a frame that looks at a point the unit direction to that.
    pub axis: Vec3,
    /// Unit normal, across the first axis.
    pub normal: Vec3,
    /// Unit binormal.
    pub binormal: Vec3,
}

/// The frames of a curve by one rule, prepared for any number of places.
///
/// ```
/// use cyclide::{Point3, construct::FairSplineOptions, curve::{CircleSpline, CurveFrames, FrameRule}};
/// let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0], [1.0, 4.0, 1.0]].map(Point3::from);
/// let spline = CircleSpline::fair(&points, &FairSplineOptions::default())?;
/// let frames = CurveFrames::new(&spline, &FrameRule::rotation_minimizing())?;
/// let frame = frames.at(0.4)?;
/// assert!((frame.tangent.cross(frame.normal) - frame.binormal).length() < 1e-15 && frames.holonomy().is_none());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug)]
pub struct CurveFrames<'a> {
    curve: &'a dyn ParamCurve,
    rule: FrameRule,
    lengths: ArcLength<'a>,
    transport: Option<Transport<'a>>,
}

impl<'a> CurveFrames<'a> {
    /// Prepares the frames; rotation-minimizing ones are carried along the whole curve.
    ///
    /// # Errors
    /// `not-finite`, `zero-axis` (a direction of length 0), `tolerance-not-positive`; of rotation-minimizing frames
    /// `no-frame` where the tangent turns back or the start direction is along it, `too-many-pieces`.
    pub fn new(curve: &'a dyn ParamCurve, rule: &FrameRule) -> Result<Self> {
        let lengths = ArcLength::new(curve);
        let finite =
            |ok: bool, what| if ok { Ok(()) } else { Err(Error::Number(NumberError::NotFinite { what, index: 0 })) };
        let transport = match *rule {
            FrameRule::Up(up) => {
                finite(up.is_finite(), ErrorItem::Direction)?;
                up.unit().ok_or(Error::zero_axis(ErrorItem::Direction))?;
                None
            }
            FrameRule::Toward(target) => {
                finite(target.is_finite(), ErrorItem::Point)?;
                None
            }
            FrameRule::LookAt { target, up } => {
                finite(target.is_finite(), ErrorItem::Point)?;
                finite(up.is_finite(), ErrorItem::Direction)?;
                up.unit().ok_or(Error::zero_axis(ErrorItem::Direction))?;
                None
            }
            FrameRule::Frenet => None,
            FrameRule::RotationMinimizing { start, tolerance, .. } => {
                finite(start.is_none_or(Vec3::is_finite), ErrorItem::Direction)?;
                crate::error::check_tolerance(tolerance)?;
                Some(Transport::new(curve, lengths.total(), start, tolerance)?)
            }
        };
        Ok(Self { curve, rule: *rule, lengths, transport })
    }

    /// The stations of the curve.
    #[must_use]
    pub fn lengths(&self) -> &ArcLength<'a> {
        &self.lengths
    }

    /// Of rotation-minimizing frames along a closed curve: the angle in `(-pi, pi]` by which the frame that was carried once round is
    /// turned against the first one, right-handed about the tangent. It does not depend on the first normal; 0 in a plane and on
    /// a sphere.
    #[must_use]
    pub fn holonomy(&self) -> Option<f64> {
        self.transport.as_ref().and_then(Transport::holonomy)
    }

    /// Of rotation-minimizing frames: the sum over the curve of what one step and two halves differ by, radians, at most the
    /// tolerance, or rounding. It is measured, not proved: frames are wrong by about a fifteenth of it.
    #[must_use]
    pub fn measured_error(&self) -> Option<f64> {
        self.transport.as_ref().map(Transport::measured_error)
    }

    /// The frame at a global parameter (clamped to `[0, 1]`).
    ///
    /// # Errors
    /// `no-frame` where there is no tangent, where the direction of the rule is along the first axis (sine below 1e-9), at the point that frames look at, or, of a
    /// Frenet frame, where the curvature is below 1e-9 of one over the length of the curve, or rounding.
    pub fn at(&self, t: f64) -> Result<CurveFrame> {
        let t = t.clamp(0.0, 1.0);
        let (piece, s) = self.curve.locate(t);
        let jet = self.curve.piece_jet(piece, s);
        let side = if s < 1.0 { 1.0 } else { -1.0 };
        let tangent = jet.limit_tangent(side).ok_or_else(|| no_frame("the velocity", t, 0.0, 0.0))?;
        let axis = match self.rule {
            FrameRule::LookAt { target, .. } => {
                let (way, limit) = (target - jet.point, ROUNDINGS * target.to_vec().max_abs());
                let distance = way.length();
                let seen = way.unit().filter(|_| distance > limit);
                seen.ok_or_else(|| no_frame("the distance from what is looked at", t, distance, limit))?
            }
            _ => tangent,
        };
        let toward = |direction: Vec3| across(direction, axis, t);
        let normal = match self.rule {
            FrameRule::Up(up) | FrameRule::LookAt { up, .. } => toward(up)?,
            FrameRule::Toward(target) => toward(target - jet.point)?,
            FrameRule::Frenet => self.principal_normal(&jet, t)?,
            FrameRule::RotationMinimizing { closed, .. } => match &self.transport {
                Some(transport) => self.carried(transport, closed, (piece, s), (jet.point, tangent), t)?,
                // Not reached: the rule has a transport.
                None => toward(Vec3::Z)?,
            },
        };
        Ok(CurveFrame { t, point: jet.point, tangent, axis, normal, binormal: axis.cross(normal) })
    }

    fn principal_normal(&self, jet: &CurveJet, t: f64) -> Result<Vec3> {
        let curvature = jet.curvature_vector().unwrap_or(Vec3::ZERO);
        let rounding = ROUNDINGS * jet.point.to_vec().max_abs() / jet.d1.length_squared();
        let limit = (STRAIGHT / self.lengths.total()).max(rounding);
        let measured = curvature.length();
        let normal = curvature.unit().filter(|_| measured > limit);
        normal.ok_or_else(|| no_frame("the curvature", t, measured, limit))
    }

    /// The normal carried to a place, turned back by its share of the holonomy where that is spread.
    fn carried(
        &self,
        transport: &Transport<'_>,
        closed: ClosedTwist,
        at: (usize, f64),
        (point, tangent): (Point3, Vec3),
        t: f64,
    ) -> Result<Vec3> {
        let normal = transport.normal(at, point, tangent).ok_or_else(|| no_frame("the velocity", t, 0.0, 0.0))?;
        Ok(match (closed, transport.holonomy()) {
            (ClosedTwist::Spread, Some(holonomy)) => {
                let share = self.lengths.station(t) / self.lengths.total();
                Quat::from_axis_angle(tangent, -holonomy * share).rotate(normal)
            }
            _ => normal,
        })
    }
}

/// The unit part of a direction across an axis.
fn across(direction: Vec3, axis: Vec3, t: f64) -> Result<Vec3> {
    let unit = direction.unit().unwrap_or(Vec3::ZERO);
    let part = unit - axis * unit.dot(axis);
    let measured = part.length();
    let what = "the sine of the angle between the direction and the first axis of the frame";
    let normal = part.unit().filter(|_| measured > ALONG).ok_or_else(|| no_frame(what, t, measured, ALONG))?;
    // Once more: the first difference has lost digits where the direction was nearly the axis.
    Ok((normal - axis * normal.dot(axis)).unit().unwrap_or(normal))
}

fn no_frame(what: &'static str, t: f64, measured: f64, limit: f64) -> Error {
    Error::Curve(CurveError::NoFrame { what, t, measured, limit })
}
