//! Pipes: the tube of a radius about a chain of arcs and segments, exact.
//!
//! A circle across the spine, carried along an arc of it by the arc's rotation, sweeps a torus; along a segment a cylinder. The
//! rotation is parallel transport too: it does not turn the circle about the spine. So four points of the circle, carried from
//! joint to joint, run along lines of curvature, and each quarter of the tube over a piece of the spine is a principal
//! patch with the weights `1, u, w, w u` (`u` of the quarter, `w` of the piece), of which neighbors share circles and lines.
//!
//! Two things break that. At a **corner** between two segments both cylinders end in their miter, an ellipse; the parts between
//! a circle and an ellipse are ruled by lines, rational of degree (2, 1). And a **closed** spine in space turns the circle by the
//! time it comes back: one piece is twisted by that angle, at most an eighth of a turn when quarters are renumbered, by a rational
//! rotation about the spine: it stays on the same torus or cylinder, of degree (2, 4) or (2, 2).

mod frame;
mod overlap;
mod ring;
mod tube;

use crate::curve::ArcPath;
use crate::error::{ErrorItem, NumberError, Result};
use crate::topology::Body;
use frame::Spine;
use tube::Tube;

/// How an open pipe ends.
///
/// Plane ends are disks, rings round a bore; a bore ends in a hemisphere where its pipe does.
///
/// ```
/// use cyclide::{Point3, construct::{Pipe, PipeEnds}, curve::ArcPath};
/// let spine = ArcPath::rounded_polyline(&[[0.0, 0.0, 0.0], [9.0, 0.0, 0.0]].map(Point3::from), false, &[0.0; 2])?;
/// let volume = |ends| Pipe::new(1.0).and_then(|pipe| pipe.with_ends(ends).body(&spine)).map(|body| body.outer.volume());
/// let caps = volume(PipeEnds::Round)? - volume(PipeEnds::Flat)?;
/// assert!((caps - 4.0 / 3.0 * std::f64::consts::PI).abs() < 1e-10); // two hemispheres
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(inline, description = "The ends of a pipe."))]
#[non_exhaustive]
pub enum PipeEnds {
    /// Planar ends.
    #[default]
    Flat,
    /// Spherical caps: hemispheres where the radius is constant.
    Round,
    /// No end faces: the surface only.
    Open,
}

/// A tube about a spine, solid or with a bore.
///
/// ```
/// use cyclide::{Point3, construct::Pipe, curve::ArcPath};
/// let bend = [[0.0, 0.0, 0.0], [20.0, 0.0, 0.0], [20.0, 20.0, 0.0]].map(Point3::from);
/// let spine = ArcPath::rounded_polyline(&bend, false, &[0.0, 5.0, 0.0])?;
/// let body = Pipe::new(2.0)?.body(&spine)?;
/// assert!((body.outer.volume() - 4.0 * std::f64::consts::PI * spine.length()).abs() < 1e-9); // Pappus
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pipe {
    radius: f64,
    bore: Option<f64>,
    ends: PipeEnds,
}

impl Pipe {
    /// A solid pipe with flat ends.
    ///
    /// # Errors
    /// `not-finite`, `radius-not-positive`.
    pub fn new(radius: f64) -> Result<Self> {
        if !radius.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Radius, index: 0 }.into());
        }
        if radius <= 0.0 {
            return Err(NumberError::RadiusNotPositive { what: ErrorItem::Radius, index: 0, radius }.into());
        }
        Ok(Self { radius, bore: None, ends: PipeEnds::Flat })
    }

    /// The same with a bore that leaves this thickness of the wall.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless the wall is thinner than the radius.
    pub fn with_wall(self, wall: f64) -> Result<Self> {
        if !(wall > 0.0 && wall < self.radius) {
            return Err(NumberError::ParameterOutOfRange {
                name: ErrorItem::Wall,
                value: wall,
                min: 0.0,
                max: self.radius,
            }
            .into());
        }
        Ok(Self { bore: Some(self.radius - wall), ..self })
    }

    /// The same with other ends; a closed spine has none.
    #[must_use]
    pub fn with_ends(self, ends: PipeEnds) -> Self {
        Self { ends, ..self }
    }

    /// The pipe about a spine. Outside is outwards; a solid unless the ends of an open spine are open. Smooth joints give
    /// tangent planes that go on, corners between segments a miter.
    ///
    /// # Errors
    /// `pipe-too-wide` (the radius is not below that of an arc), `corner-not-mitred` (a corner next to an arc, or one that turns
    /// back), `mitre-does-not-fit` (a segment is too short for its miters), `pipe-meets-itself` with the places (parts that are
    /// half a turn of the pipe's own radius or more apart along the spine are nearer than twice the radius), as
    /// [`CyclidePatch::from_weights`](crate::surface::CyclidePatch::from_weights).
    pub fn body(&self, spine: &ArcPath) -> Result<Body> {
        let spine = Spine::new(spine, self.radius)?;
        overlap::check(&spine, self.radius, self.ends)?;
        let outer = Tube::new(&spine, self.radius)?;
        let Some(bore) = self.bore else {
            return Ok(Body { outer: outer.closed(self.ends)?, voids: Vec::new() });
        };
        let inner = Tube::new(&spine, bore)?;
        if spine.closed || self.ends == PipeEnds::Round {
            let void = inner.closed(self.ends)?.flipped();
            return Ok(Body { outer: outer.closed(self.ends)?, voids: vec![void] });
        }
        Ok(Body { outer: outer.with_bore(inner)?, voids: Vec::new() })
    }

    /// The first two of several spines, by their numbers, whose pipes run into each other, with the distance of the spines there:
    /// each pipe is a body of its own, and what they have in common counts twice. Parts of pipes beyond the balls about their spines, the
    /// spikes of miters, are not looked at.
    ///
    /// ```
    /// use cyclide::{Point3, construct::Pipe, curve::ArcPath};
    /// let rod = |from: [f64; 3], to: [f64; 3]| ArcPath::rounded_polyline(&[from, to].map(Point3::from), false, &[0.0; 2]);
    /// let cross = [rod([-9.0, 0.0, 0.0], [9.0, 0.0, 0.0])?, rod([0.0, -9.0, 1.0], [0.0, 9.0, 1.0])?];
    /// assert_eq!(Pipe::new(1.0)?.first_meeting(&cross)?, Some(([0, 1], 1.0)));
    /// assert_eq!(Pipe::new(0.4)?.first_meeting(&cross)?, None);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// Of several, as [`body`](Self::body) of each spine.
    pub fn first_meeting(&self, spines: &[ArcPath]) -> Result<Option<([usize; 2], f64)>> {
        if spines.len() < 2 {
            return Ok(None);
        }
        let spines = spines.iter().map(|path| Spine::new(path, self.radius)).collect::<Result<Vec<_>>>()?;
        let found = overlap::first_meeting(&spines, self.radius, self.ends);
        Ok(found.map(|overlap::Meeting { spines, distance }| (spines, distance)))
    }
}
