//! Pipes that pass each other, blended by a ball that rolls between them, or what they have in common with its edge rounded (`docs/math/pipe-crossings.md`).
//!
//! The distance of the axes is more than the radii differ: the case of `002`, section 4 (*timelike*), in which the balls that touch both pipes
//! are those of a torus. So it is of cones. The loop of balls goes round neither pipe, so each has a hole in its side; where the pipes do not touch, the blend
//! is a bridge between them. All faces are exact; what is approximated is the radius, to a tolerance.

mod ball_loop;
mod balls;
mod check;
mod cones;
mod contacts;
mod corners;
mod law_fold;
mod mixed;
mod skin;
mod torus_pair;
mod working_radius;

use super::angle_law::Law;
use super::ball_centers::BallCenters;
use super::pierced::{Mantle, Ring, Skin};
use super::tee::{TeeBlendFacts, TeeEnds};
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{
    BallError, CrossingError, Error, ErrorItem, NumberError, PipeError, PointError, Result, ShellError,
};
use crate::surface::SkewCylinders;
use crate::topology::{Body, Sewing};
use ball_loop::BallLoop;
use balls::Balls;
use law_fold::LawFold;
use mixed::MixedPair;
use std::f64::consts::PI;
use torus_pair::TorusPair;

/// Axes nearer to parallel than this, radians, are refused: the places of the blend, so much longer than wide, have lost their digits.
const LEAST_ANGLE: f64 = 1e-5;

/// The least ball that is told to do where one cannot be made, as part of the pipes and their distance (measured: lenses of pipes of 1 and 1000 down to a tenth of it are made).
const LEAST_BALL: f64 = 1e-7;

/// A pipe that passes another, a cylinder or a cone.
///
/// ```
/// use cyclide::construct::CrossingPipe;
/// let pipe = CrossingPipe { radius: 20.0, taper: 0.1, ends: [-80.0, 80.0] };
/// assert!(pipe.ends[0] < pipe.ends[1] && pipe.radius > pipe.ends[1] * pipe.taper.tan());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrossingPipe {
    /// Its outer radius; with a taper that where the axes are nearest.
    pub radius: f64,
    /// Half the angle of the cone that it is: above zero it grows thinner along its axis, below wider, 0 is a cylinder.
    pub taper: f64,
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
/// use cyclide::construct::{CrossingPipe, PipeCrossing};
/// let pipe = |radius| CrossingPipe { radius, taper: 0.0, ends: [-80.0, 80.0] };
/// // Axes 30 apart: the pipes overlap by 10.
/// let crossing = PipeCrossing::new([pipe(20.0), pipe(20.0)], 30.0, 6.0)?.with_wall(3.0)?;
/// let made = crossing.made()?;
/// assert!(made.body.is_solid() && made.body.voids.is_empty());
/// assert!(made.blend.radii[0] >= 5.994 && made.blend.radii[1] <= 6.006);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PipeCrossing {
    pipes: [CrossingPipe; 2],
    /// As cylinders of radius zero.
    axes: SkewCylinders,
    law: Law,
    side: CrossingSide,
    tolerance: Option<f64>,
    wall: Option<f64>,
    ends: TeeEnds,
}

/// The sides of the pipes on which the ball of a crossing rolls.
///
/// ```
/// use cyclide::construct::{CrossingPipe, CrossingSide, PipeCrossing};
/// let pipe = CrossingPipe { radius: 2.0, taper: 0.0, ends: [-9.0, 9.0] };
/// // Axes 2 apart: a lens 2 thick.
/// let lens = PipeCrossing::new([pipe, pipe], 2.0, 0.3)?.with_side(CrossingSide::Inside).made()?.body;
/// assert!(lens.is_solid() && (lens.bounds().max.z - lens.bounds().min.z - 2.0).abs() < 0.1);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(inline, description = "The sides of the pipes on which the ball rolls.")
)]
pub enum CrossingSide {
    /// Outside both: the body is the two pipes, with the corner between them filled.
    #[default]
    Outside,
    /// Inside both: the body is the intersection of the pipes, with its edge rounded.
    Inside,
    /// Outside the first pipe and inside the second: the body is the second pipe minus the first, with the edge of the
    /// notch rounded.
    Mixed,
}

impl CrossingSide {
    /// The sign of the radii of its balls.
    fn sign(self) -> f64 {
        if self == Self::Inside { -1.0 } else { 1.0 }
    }

    /// Whether the balls are in the material, at a convex edge.
    fn is_in_material(self) -> bool {
        self != Self::Outside
    }

    /// Whether a pipe with a hole is left, not a cap of it.
    fn leaves(self, pipe: usize) -> bool {
        match self {
            Self::Outside => true,
            Self::Inside => false,
            Self::Mixed => pipe == 1,
        }
    }

    /// Whether a skin below the outer one has a smaller pipe, 1, or a larger one, -1.
    fn depth_sign(self, pipe: usize) -> f64 {
        if self == Self::Mixed && pipe == 0 { -1.0 } else { 1.0 }
    }

    /// The same of the signed radii of its balls.
    fn ball_depth_sign(self) -> f64 {
        if self == Self::Mixed { -1.0 } else { 1.0 }
    }
}

/// A crossing as it was made.
///
/// ```
/// use cyclide::construct::{CrossingPipe, PipeCrossing};
/// let pipe = CrossingPipe { radius: 2.0, taper: 0.0, ends: [-9.0, 9.0] };
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
    /// Where the centers of its balls are.
    pub centers: BallCenters,
}

impl PipeCrossing {
    /// A solid crossing at right angles: the distance of the axes, and the radius of the ball, to a thousandth of it.
    ///
    /// # Errors
    /// `not-finite`, `radius-not-positive`, `parameter-out-of-range`, `pipe-ends-reversed`, `crossing-axes-too-near` (a distance not above 0).
    pub fn new(pipes: [CrossingPipe; 2], distance: f64, blend: f64) -> Result<Self> {
        let radii = pipes.map(|pipe| pipe.radius).into_iter().enumerate();
        let radii = radii.map(|(index, radius)| (ErrorItem::Pipe, index, radius));
        for (what, index, radius) in radii.chain([(ErrorItem::Blend, 0, blend)]) {
            range::check_radius(what, index, radius)?;
        }
        if let Some(index) = pipes.iter().flat_map(|pipe| pipe.ends).position(|end| !end.is_finite()) {
            return Err(Error::from(NumberError::NotFinite { what: ErrorItem::Coordinate, index }).in_field("pipes"));
        }
        if let Some(index) = pipes.iter().position(|pipe| !pipe.taper.is_finite()) {
            return Err(Error::from(NumberError::NotFinite { what: ErrorItem::Taper, index }).in_field("pipes"));
        }
        for (pipe, CrossingPipe { ends: [start, end], .. }) in pipes.into_iter().enumerate() {
            if start >= end {
                return Err(PipeError::EndsReversed { pipe, start, end }.into());
            }
        }
        if distance <= 0.0 {
            let limit = (pipes[0].radius - pipes[1].radius).abs();
            return Err(CrossingError::AxesTooNear { distance, limit }.into());
        }
        let axes = SkewCylinders::axes(0.5 * distance)?;
        let (law, side) = (Law::new(&[[0.0, blend]])?, CrossingSide::Outside);
        Ok(Self { pipes, axes, law, side, tolerance: None, wall: None, ends: TeeEnds::Flat })
    }

    /// The same with a ball that has these radii in these directions, pairs of an angle and the radius there in any order, and changes smoothly from one to
    /// the next without passing either. Angles are those of the ball about the common normal of the axes, from the first axis towards y.
    ///
    /// ```
    /// use cyclide::construct::{CrossingPipe, PipeCrossing};
    /// let pipe = CrossingPipe { radius: 2.0, taper: 0.0, ends: [-9.0, 9.0] };
    /// let crossing = PipeCrossing::new([pipe, pipe], 3.0, 0.5)?.with_radii(&[[0.0, 0.4], [2.0, 0.8]])?;
    /// let [least, most] = crossing.made()?.blend.radii;
    /// assert!((least - 0.4).abs() < 4e-4 && (most - 0.8).abs() < 8e-4);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `too-few-points`, `not-finite`, `radius-not-positive`, `parameter-out-of-range`, `coincident-points`.
    pub fn with_radii(self, values: &[[f64; 2]]) -> Result<Self> {
        let law = Law::new(values).map_err(|error| error.in_field("blend"))?;
        values.iter().try_for_each(|[_, radius]| range::check_distance(*radius))?;
        Ok(Self { law, ..self })
    }

    /// The same with the ball on other sides of the pipes.
    #[must_use]
    pub fn with_side(self, side: CrossingSide) -> Self {
        Self { side, ..self }
    }

    /// The same with the second pipe along `(cos angle, sin angle, 0)`, radians.
    ///
    /// # Errors
    /// `angle-out-of-range` (less than 1e-5 from parallel: the blend is longer than wide by so much that its places have lost their digits); as [`SkewCylinders::with_angle`].
    pub fn with_angle(self, angle: f64) -> Result<Self> {
        let axes = self.axes.with_angle(angle)?;
        let [min, max] = [LEAST_ANGLE, PI - LEAST_ANGLE];
        if !(angle.abs() >= min && angle.abs() <= max) {
            return Err(NumberError::AngleOutOfRange { name: ErrorItem::Angle, angle, min, max }.into());
        }
        Ok(Self { axes, ..self })
    }

    /// The same with another tolerance of the radius, a thousandth of it by default.
    ///
    /// # Errors
    /// `tolerance-not-positive`.
    pub fn with_tolerance(self, tolerance: f64) -> Result<Self> {
        if !(tolerance > 0.0) {
            return Err(NumberError::ToleranceNotPositive { tolerance }.into());
        }
        Ok(Self { tolerance: Some(tolerance), ..self })
    }

    /// The same with one bore through both pipes that leaves this thickness of the wall, also in the blend; inside a hollow without an opening, mixed the bore of the second pipe round the notch.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless the wall is thinner than the thinner pipe.
    pub fn with_wall(self, wall: f64) -> Result<Self> {
        let max = self.pipes[0].radius.min(self.pipes[1].radius);
        if !(wall > 0.0 && wall < max) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Wall, value: wall, min: 0.0, max }.into());
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
    /// `crossing-no-ball` (no radius works between these pipes), `crossing-axes-too-near` (unless their distance is more than the radii differ), `radius-too-small` (outside, of pipes that do not touch: a ball is no larger than half the gap), `crossing-ball-too-large` (inside and mixed: than half of the room there is), `crossing-pipes-apart` (mixed),
    /// `below-rounding-of-place`, `too-many-pieces` (the tolerance), `crossing-folds`, `crossing-hole-too-wide`, `crossing-hole-turns-back`,
    /// `crossing-pipe-too-short`, `parameter-out-of-range` (inside, a wall as thick as the radius of a ball). Of pipes with a taper also `radius-not-positive` (one that comes to an end before its own),
    /// `angle-out-of-range` (the angle of the axes, or its supplement, is not above the sum of the tapers), `crossing-needs-cylinders` (mixed, or a radius that changes).
    pub fn made(&self) -> Result<MadeCrossing> {
        self.made_as_asked().map_err(|error| self.with_working_radius(error))
    }

    fn made_as_asked(&self) -> Result<MadeCrossing> {
        self.check_tapers()?;
        let mantles = [0, 1].map(|pipe: usize| skin::mantle(&self.axes, pipe, &self.pipes[pipe]));
        let pair = TorusPair::new(&self.pipes, &self.axes, &mantles)?;
        let ends = self.pipes.iter().flat_map(|pipe| pipe.ends);
        let place = ends.fold(2.0 * self.axes.half_gap(), |most, end| most.max(end.abs()));
        let [least, most] = self.law.range();
        range::check_size_in_place(ErrorItem::Blend, least, place, range::SMALLEST_IN_PLACE)?;
        let smallest = pair.smallest_radius();
        let depth = self.wall.unwrap_or(0.0);
        let mixed = match (self.side, &pair) {
            (CrossingSide::Mixed, TorusPair::Cylinders(pair)) => Some(MixedPair::new(pair)?),
            _ => None,
        };
        let limit = match self.side {
            CrossingSide::Outside => smallest,
            _ => mixed.as_ref().map_or(-smallest, MixedPair::largest_radius),
        };
        if self.side.is_in_material() {
            if !(most < limit) {
                return Err(CrossingError::BallTooLarge { radius: most, limit, works: None }.into());
            }
            if depth >= least {
                return Err(NumberError::ParameterOutOfRange {
                    name: ErrorItem::Wall,
                    value: depth,
                    min: 0.0,
                    max: least,
                }
                .into());
            }
        } else if !(least > limit) {
            return Err(BallError::RadiusTooSmall { radius: least, limit, works: None }.into());
        }
        // The larger balls are those of the inner skin, in the material those of the outer one.
        let larger = if self.side.is_in_material() { 0.0 } else { depth };
        let (law, tolerance, side) = (&self.law, self.tolerance, self.side);
        let asked = Balls { pair, mantles, mixed, law, tolerance, side, limit };
        check::check_reach_round(&asked)?;
        let fold = LawFold::new(&asked, larger);
        let balls = BallLoop::new(&asked, fold.as_ref())?;
        for pipe in 0..2 {
            if self.side.leaves(pipe) { check::check_hole(&balls, pipe)? } else { check::check_cap(&balls, pipe)? }
        }
        let tight = check::check_folds(&asked, fold.as_ref(), &balls, larger)?;
        self.check_room(&balls)?;
        let blend = TeeBlendFacts {
            radii: balls.radii,
            deviation: balls.deviation,
            pieces: balls.pieces.len(),
            tightest: tight.left,
            tightest_at: tight.angle,
        };
        let centers = balls.centers(&asked.pair, self.axes.half_gap())?;
        let body = self.sewn(&mantles, &balls).map_err(|error| self.smaller_than_rounding(error))?;
        Ok(MadeCrossing { body, blend, centers })
    }

    /// Of a crossing that cannot be sewn: its ball is so small beside the pipes that the rounding of these is the shape of the blend.
    fn smaller_than_rounding(&self, error: Error) -> Error {
        let sizes = self.pipes.iter().map(|pipe| pipe.radius).chain([2.0 * self.axes.half_gap()]);
        let ([size, _], place) = (self.law.range(), sizes.fold(0.0, f64::max));
        // What failed is too small, wherever the limit is.
        let limit = (LEAST_BALL * place).max(2.0 * size);
        match error {
            Error::Shell(ShellError::NotAShell { .. }) => {
                Error::Point(PointError::BelowRoundingOfPlace { what: ErrorItem::Blend, size, place, limit })
            }
            other => other,
        }
    }

    /// The faces of all skins, closed as asked.
    fn sewn(&self, mantles: &[Mantle; 2], balls: &BallLoop) -> Result<Body> {
        let mut sewing = Sewing::default();
        let outer = self.skin(&mut sewing, mantles, balls, [0.0; 2])?;
        let ends = if self.side == CrossingSide::Inside { TeeEnds::Closed } else { self.ends };
        match (self.wall, ends) {
            (None, TeeEnds::Open) => {}
            (None, _) => self.disks(&mut sewing, mantles, &outer, [0.0; 2])?,
            (Some(wall), TeeEnds::Closed) => {
                self.disks(&mut sewing, mantles, &outer, [0.0; 2])?;
                let mut inside = Sewing::default();
                let inner = self.skin(&mut inside, mantles, balls, [wall; 2])?;
                self.disks(&mut inside, mantles, &inner, [wall; 2])?;
                return Ok(Body { outer: sewing.finish()?, voids: vec![inside.finish()?] });
            }
            (Some(wall), _) => {
                let inner = self.skin(&mut sewing, mantles, balls, [wall, 0.0])?;
                let mut skin = Skin { sewing: &mut sewing, depth: 0.0, inner: false };
                for ((outer, inner), (_, outwards)) in outer.iter().zip(&inner).zip(self.openings(mantles, 0.0)) {
                    skin.between_rings(outer, inner, outwards)?;
                }
            }
        }
        Ok(Body { outer: sewing.finish()?, voids: Vec::new() })
    }

    /// The centers of the ends, and the directions out of them: of the first pipe, then of the second, if they are left.
    fn openings(&self, mantles: &[Mantle; 2], short: f64) -> Vec<(Point3, Vec3)> {
        let end = |pipe: usize, side: usize| {
            let mantle = &mantles[pipe];
            let (way, at) = if side == 0 {
                (-1.0, self.pipes[pipe].ends[0] + short)
            } else {
                (1.0, self.pipes[pipe].ends[1] - short)
            };
            (mantle.centre(at), mantle.along * way)
        };
        (0..2).filter(|&pipe| self.side.leaves(pipe)).flat_map(|pipe| [end(pipe, 0), end(pipe, 1)]).collect()
    }

    fn disks(
        &self,
        sewing: &mut Sewing,
        mantles: &[Mantle; 2],
        rings: &[Ring],
        [depth, short]: [f64; 2],
    ) -> Result<()> {
        let mut skin = Skin { sewing, depth, inner: depth > 0.0 };
        for (ring, (centre, outwards)) in rings.iter().zip(self.openings(mantles, short)) {
            skin.disk(ring, centre, if depth > 0.0 { -outwards } else { outwards })?;
        }
        Ok(())
    }

    /// The faces of a skin at a depth, with pipes shorter by a length at both ends, and its rings in the order of [`openings`](Self::openings).
    fn skin(
        &self,
        sewing: &mut Sewing,
        mantles: &[Mantle; 2],
        balls: &BallLoop,
        [depth, short]: [f64; 2],
    ) -> Result<Vec<Ring>> {
        let mut skin = Skin { sewing, depth, inner: depth > 0.0 };
        let stretches = self.pipes.map(|pipe| [pipe.ends[0] + short, pipe.ends[1] - short]);
        skin.crossing(mantles, balls, stretches, self.side)
    }

    /// Refuses cones that come to an end before their own, and what is made of cylinders only.
    fn check_tapers(&self) -> Result<()> {
        let Some(pipe) = self.pipes.iter().position(|pipe| pipe.taper != 0.0) else { return Ok(()) };
        let [least, most] = self.law.range();
        let needing = [(self.side == CrossingSide::Mixed, ErrorItem::Side), (least < most, ErrorItem::Blend)];
        if let Some((_, what)) = needing.into_iter().find(|(needs, _)| *needs) {
            return Err(CrossingError::NeedsCylinders { what, pipe, taper: self.pipes[pipe].taper }.into());
        }
        let depth = self.wall.unwrap_or(0.0);
        for (pipe, CrossingPipe { radius, taper, ends }) in self.pipes.into_iter().enumerate() {
            let (sin, cos) = taper.sin_cos();
            let radius_at = |end: f64| radius - (end * sin + depth) / cos;
            let none_at = |end: f64| {
                Error::Number(NumberError::RadiusNotPositive {
                    what: ErrorItem::Pipe,
                    index: pipe,
                    radius: radius_at(end),
                })
            };
            if !(cos > 0.0) {
                return Err(none_at(ends[1]));
            }
            if let Some(reached) = ends.into_iter().find(|end| !(radius_at(*end) > 0.0)) {
                let apex = (radius * cos - depth) / sin;
                return Err(if apex.is_finite() {
                    Error::Pipe(PipeError::ConeReachesApex { pipe, apex, reached })
                } else {
                    none_at(reached)
                });
            }
        }
        Ok(())
    }

    /// Refuses pipes that end within the blend.
    fn check_room(&self, balls: &BallLoop) -> Result<()> {
        let short = if self.ends == TeeEnds::Closed { self.wall.unwrap_or(0.0) } else { 0.0 };
        for (pipe, CrossingPipe { radius, taper, ends }) in self.pipes.into_iter().enumerate() {
            // The hole of the inner skin is moved along a cone.
            let rest = check::LEAST_REST * radius + short + self.wall.unwrap_or(0.0) * taper.sin().abs();
            let [low, high] = balls.reach(pipe);
            let needed = [low - rest, high + rest];
            for (end, needed, fits) in
                [(ends[0], needed[0], ends[0] < needed[0]), (ends[1], needed[1], ends[1] > needed[1])]
            {
                if !fits {
                    return Err(CrossingError::PipeTooShort { pipe, end, needed }.into());
                }
            }
        }
        Ok(())
    }
}
