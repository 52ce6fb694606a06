//! Pipes that pass each other, blended by a ball that rolls between them (`docs/math/pipe-crossings.md`).
//!
//! The distance of the axes is more than the radii differ: the case of `002`, section 4 (*timelike*), in which the balls that touch both pipes
//! are those of a torus. The loop of balls goes round neither pipe, so each has a hole in its side; where the pipes do not touch, the blend
//! is a bridge between them. All faces are exact; what is approximated is the radius, to a tolerance.

mod ball_loop;
mod check;
mod corners;
mod skin;

use super::pierced::{Ring, Skin};
use super::tee::{TeeBlendFacts, TeeEnds};
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, Result};
use crate::surface::SkewCylinders;
use crate::topology::{Body, Sewing};
use ball_loop::BallLoop;

/// The ball keeps its radius to this part of it where no tolerance is given.
const DEFAULT_TOLERANCE: f64 = 1e-3;

/// A pipe that passes another.
///
/// ```
/// use cyclide::CrossingPipe;
/// let pipe = CrossingPipe { radius: 20.0, ends: [-80.0, 80.0] };
/// assert!(pipe.ends[0] < pipe.ends[1]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrossingPipe {
    /// Its outer radius.
    pub radius: f64,
    /// Where it ends: places along its axis, from the common normal of both axes on.
    pub ends: [f64; 2],
}

/// Two pipes that pass each other with a blend between them, solid or with a wall: the first about the x axis, the second above it, along y or at another
/// [angle](Self::with_angle).
///
/// The ball touches both pipes from outside everywhere, and its radius is within the tolerance. Smooth (tangent planes) along the contacts.
/// Source: `002`, section 4, with `docs/math/pipe-crossings.md`.
///
/// ```
/// use cyclide::{CrossingPipe, PipeCrossing};
/// let pipe = |radius| CrossingPipe { radius, ends: [-80.0, 80.0] };
/// // Axes 30 apart: the pipes overlap by 10.
/// let crossing = PipeCrossing::new([pipe(20.0), pipe(20.0)], 30.0, 6.0)?.with_wall(3.0)?;
/// let made = crossing.made()?;
/// assert!(made.body.is_solid() && made.body.voids.is_empty());
/// assert!(made.blend.radii[0] >= 5.994 && made.blend.radii[1] <= 6.006);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PipeCrossing {
    pipes: [CrossingPipe; 2],
    pair: SkewCylinders,
    blend: f64,
    tolerance: f64,
    wall: Option<f64>,
    ends: TeeEnds,
}

/// A crossing as it was made.
///
/// ```
/// use cyclide::{CrossingPipe, PipeCrossing};
/// let pipe = CrossingPipe { radius: 2.0, ends: [-9.0, 9.0] };
/// let made = PipeCrossing::new([pipe, pipe], 3.0, 0.5)?.made()?;
/// assert!(made.body.is_solid() && made.blend.tightest > 0.0);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MadeCrossing {
    /// The body.
    pub body: Body,
    /// What is known of the blend; angles are those of its balls about the common normal of the axes, from the first axis on.
    pub blend: TeeBlendFacts,
}

impl PipeCrossing {
    /// A solid crossing at right angles: the distance of the axes, and the radius of the ball, to a thousandth of it.
    ///
    /// # Errors
    /// `not-finite`, `radius-not-positive`, `parameter-out-of-range`, `pipe-ends-reversed`; `crossing-axes-too-near` unless the distance is more than the radii differ;
    /// `radius-too-small` (of pipes that do not touch: the ball is above half the gap).
    pub fn new(pipes: [CrossingPipe; 2], distance: f64, blend: f64) -> Result<Self> {
        for (index, radius) in pipes.iter().map(|pipe| pipe.radius).chain([blend]).enumerate() {
            if !radius.is_finite() {
                return Err(Error::NotFinite { what: ErrorItem::Radius, index });
            }
            if radius <= 0.0 {
                return Err(Error::RadiusNotPositive { radius });
            }
            range::check_distance(radius)?;
        }
        if let Some(index) = pipes.iter().flat_map(|pipe| pipe.ends).position(|end| !end.is_finite()) {
            return Err(Error::NotFinite { what: ErrorItem::Coordinate, index });
        }
        for (pipe, CrossingPipe { ends: [start, end], .. }) in pipes.into_iter().enumerate() {
            if start >= end {
                return Err(Error::PipeEndsReversed { pipe, start, end });
            }
        }
        let limit = (pipes[0].radius - pipes[1].radius).abs();
        if distance <= limit {
            return Err(Error::CrossingAxesTooNear { distance, limit });
        }
        let pair = SkewCylinders::new(pipes.map(|pipe| pipe.radius), 0.5 * distance)?;
        let limit = pair.smallest_radius();
        if !(blend > limit) {
            return Err(Error::RadiusTooSmall { radius: blend, limit });
        }
        Ok(Self { pipes, pair, blend, tolerance: DEFAULT_TOLERANCE * blend, wall: None, ends: TeeEnds::Flat })
    }

    /// The same with the second pipe along `(cos angle, sin angle, 0)`, radians.
    ///
    /// # Errors
    /// As [`SkewCylinders::with_angle`].
    pub fn with_angle(self, angle: f64) -> Result<Self> {
        Ok(Self { pair: self.pair.with_angle(angle)?, ..self })
    }

    /// The same with another tolerance of the radius.
    ///
    /// # Errors
    /// `tolerance-not-positive`.
    pub fn with_tolerance(self, tolerance: f64) -> Result<Self> {
        if !(tolerance > 0.0) {
            return Err(Error::ToleranceNotPositive { tolerance });
        }
        Ok(Self { tolerance, ..self })
    }

    /// The same with one bore through both pipes that leaves this thickness of the wall, also in the blend.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless the wall is thinner than the thinner pipe.
    pub fn with_wall(self, wall: f64) -> Result<Self> {
        let max = self.pipes[0].radius.min(self.pipes[1].radius);
        if !(wall > 0.0 && wall < max) {
            return Err(Error::ParameterOutOfRange { name: ErrorItem::Wall, value: wall, min: 0.0, max });
        }
        Ok(Self { wall: Some(wall), ..self })
    }

    /// The same with other ends.
    #[must_use]
    pub fn with_ends(self, ends: TeeEnds) -> Self {
        Self { ends, ..self }
    }

    /// The body, with what is known of its blend.
    ///
    /// # Errors
    /// `below-rounding-of-place`, `too-many-pieces` (the tolerance), `crossing-folds`, `crossing-hole-too-wide`, `crossing-hole-turns-back`, `crossing-pipe-too-short`.
    pub fn made(&self) -> Result<MadeCrossing> {
        let ends = self.pipes.iter().flat_map(|pipe| pipe.ends);
        let place = ends.fold(2.0 * self.pair.half_gap(), |most, end| most.max(end.abs()));
        range::check_size_in_place(ErrorItem::Blend, self.blend, place, range::SMALLEST_IN_PLACE)?;
        check::check_reach_round(&self.pair, self.blend)?;
        let balls = BallLoop::new(&self.pair, self.blend, self.tolerance)?;
        let depth = self.wall.unwrap_or(0.0);
        check::check_holes(&balls)?;
        let tight = check::check_folds(&balls, depth)?;
        self.check_room(&balls)?;
        let blend = TeeBlendFacts {
            radii: balls.radii,
            deviation: balls.radii.map(|radius| (radius - self.blend).abs()).into_iter().fold(0.0, f64::max),
            pieces: balls.pieces.len(),
            tightest: tight.left,
            tightest_at: tight.angle,
        };
        Ok(MadeCrossing { body: self.sewn(&balls)?, blend })
    }

    /// The faces of all skins, closed as asked.
    fn sewn(&self, balls: &BallLoop) -> Result<Body> {
        let mut sewing = Sewing::default();
        let outer = self.skin(&mut sewing, balls, [0.0; 2])?;
        match (self.wall, self.ends) {
            (None, TeeEnds::Open) => {}
            (None, _) => self.disks(&mut sewing, &outer, [0.0; 2])?,
            (Some(wall), TeeEnds::Closed) => {
                self.disks(&mut sewing, &outer, [0.0; 2])?;
                let mut inside = Sewing::default();
                let inner = self.skin(&mut inside, balls, [wall; 2])?;
                self.disks(&mut inside, &inner, [wall; 2])?;
                return Ok(Body { outer: sewing.finish()?, voids: vec![inside.finish()?] });
            }
            (Some(wall), _) => {
                let inner = self.skin(&mut sewing, balls, [wall, 0.0])?;
                let mut skin = Skin { sewing: &mut sewing, depth: 0.0, inner: false };
                for ((outer, inner), (_, outwards)) in outer.iter().zip(&inner).zip(self.openings(0.0)) {
                    skin.between_rings(outer, inner, outwards)?;
                }
            }
        }
        Ok(Body { outer: sewing.finish()?, voids: Vec::new() })
    }

    /// The centres of the ends, and the directions out of them: of the first pipe, then of the second.
    fn openings(&self, short: f64) -> [(Point3, Vec3); 4] {
        let end = |pipe: usize, side: usize| {
            let axis = skin::axis(&self.pair, pipe);
            let (way, at) = if side == 0 {
                (-1.0, self.pipes[pipe].ends[0] + short)
            } else {
                (1.0, self.pipes[pipe].ends[1] - short)
            };
            (axis.centre(at), axis.along * way)
        };
        [end(0, 0), end(0, 1), end(1, 0), end(1, 1)]
    }

    fn disks(&self, sewing: &mut Sewing, rings: &[Ring], [depth, short]: [f64; 2]) -> Result<()> {
        let mut skin = Skin { sewing, depth, inner: depth > 0.0 };
        for (ring, (centre, outwards)) in rings.iter().zip(self.openings(short)) {
            skin.disk(ring, centre, if depth > 0.0 { -outwards } else { outwards })?;
        }
        Ok(())
    }

    /// The faces of a skin at a depth, with pipes shorter by a length at both ends, and its rings in the order of [`openings`](Self::openings).
    fn skin(&self, sewing: &mut Sewing, balls: &BallLoop, [depth, short]: [f64; 2]) -> Result<Vec<Ring>> {
        let mut skin = Skin { sewing, depth, inner: depth > 0.0 };
        let stretches = self.pipes.map(|pipe| [pipe.ends[0] + short, pipe.ends[1] - short]);
        skin.crossing(&self.pair, balls, stretches)
    }

    /// Refuses pipes that end within the blend.
    fn check_room(&self, balls: &BallLoop) -> Result<()> {
        let short = if self.ends == TeeEnds::Closed { self.wall.unwrap_or(0.0) } else { 0.0 };
        for (pipe, CrossingPipe { radius, ends }) in self.pipes.into_iter().enumerate() {
            let needed = balls.reach(pipe) + check::LEAST_REST * radius + short;
            for (end, needed, fits) in [(ends[0], -needed, ends[0] < -needed), (ends[1], needed, ends[1] > needed)] {
                if !fits {
                    return Err(Error::CrossingPipeTooShort { pipe, end, needed });
                }
            }
        }
        Ok(())
    }
}
