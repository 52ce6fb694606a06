//! Tubes: envelopes of balls along a way, whose radius may change: hoses, cables, horns (`docs/math/tubes.md`).
//!
//! A ball is a point of a space with the square `v·v - r²`. A conic that is a circle of that space is envelope of a Dupin cyclide, so a chain of
//! biarcs there is a G1 tube of exact cyclides. Lines of curvature lead places of a ring to the next, and each quarter over an arc is a
//! principal patch; where places have to turn, at the seam of a closed tube or where lines of curvature crowd, faces on the same cyclide of degree
//! (4, 2) let them.

mod along;
mod ball;
mod ball_arc;
mod beside;
mod meeting;
mod radius_law;
mod ring;
mod skin;
mod tapered;
mod through;

pub use ball::Ball;
pub use radius_law::RadiusLaw;
pub use tapered::TaperedTube;

use super::PipeEnds;
use crate::base::range;
use crate::base::vector::Vec3;
use crate::curve::{ArcPath, Correspondence, ParamCurve};
use crate::error::{CurveError, Error, ErrorItem, NumberError, PointError, Result, ShellError, TubeError};
use crate::topology::Body;
use ball_arc::BallArc;
use ring::Ring;
use skin::{Skin, Step};

/// Width that a tube has left at the inner side of a bend, as part of its own: below, points there have lost their digits.
const LEAST_LEFT: f64 = 1e-7;

/// Circles of neighboring balls are told apart by so many times what they are uncertain by.
const LEAST_TOLD: f64 = 1e9;

/// The least radius as part of the coordinates: sides along the tube are known as well as the directions across it, a billionth (measured: tubes that are refused are
/// below a tenth to an eighth of that rounding times a billion).
const LEAST_IN_PLACE: f64 = 1e-7;

/// Places this near to those of another ring, radians, are the same.
const SAME_PLACES: f64 = 1e-11;

/// Arcs for each piece of a curve, besides those that any tube may have.
const MOST_ARCS_OF_PIECE: usize = 64;

/// A tube of changing radius, solid or with a wall.
///
/// ```
/// use cyclide::{Point3, construct::{RadiusLaw, Tube}, curve::ArcPath};
/// let bend = [[0.0, 0.0, 0.0], [20.0, 0.0, 0.0], [20.0, 20.0, 0.0]].map(Point3::from);
/// let spine = ArcPath::rounded_polyline(&bend, false, &[0.0, 8.0, 0.0])?;
/// let horn = Tube::along(&spine, &RadiusLaw::new(&[[0.0, 1.0], [1.0, 3.0]])?, 1e-3)?;
/// assert!(horn.bound() <= 1e-3 && horn.body()?.is_solid());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Tube {
    arcs: Vec<BallArc>,
    bound: f64,
    closed: bool,
    wall: Option<f64>,
    ends: PipeEnds,
}

impl Tube {
    /// The tube through balls: it touches each in a circle. Between two it is a cone or a cylinder; else it goes on by biarcs with, at each
    /// ball, the tangent of the arc of balls through it and its neighbors. Exact: this is what it is.
    ///
    /// # Errors
    /// `too-few-points` (2, or 3 of a closed tube), `not-finite`, `radius-not-positive`, `parameter-out-of-range`, `balls-nested` (one of two neighbors holds the
    /// other), `tube-turns-back` (no smooth tube goes on there).
    pub fn through(balls: &[Ball], closed: bool) -> Result<Self> {
        let arcs = through::through(balls, closed)?;
        Ok(Self { arcs, bound: 0.0, closed, wall: None, ends: PipeEnds::Flat })
    }

    /// The tube along a chain of arcs, with a law of the radius over the fraction of its length, no ball of which is farther than the tolerance from that of the law: centers and
    /// radii together ([`bound`](Self::bound), proved). Where the radius stays, and where it is linear along a segment, it is exact.
    ///
    /// # Errors
    /// `radius-not-positive` (the tolerance), `corner-not-mitred` (a joint of the spine that is not smooth), `radius-not-closed`, `radius-grows-too-fast` (as fast as the way
    /// or faster: its balls hold each other), `too-many-pieces` (more than 4096 arcs of balls, and 4 for each arc of the spine).
    pub fn along(spine: &ArcPath, law: &RadiusLaw, tolerance: f64) -> Result<Self> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(NumberError::ParameterOutOfRange {
                name: ErrorItem::Tolerance,
                value: tolerance,
                min: 0.0,
                max: f64::INFINITY,
            }
            .into());
        }
        let along::Along { arcs, bound, .. } = along::along(spine, law, tolerance)?;
        Ok(Self { arcs, bound, closed: spine.is_closed(), wall: None, ends: PipeEnds::Flat })
    }

    /// The tube along any curve, with the arcs that stand for it and the parts of the curve that they stand for ([`Lower::lower_to_arcs`](crate::model::Lower::lower_to_arcs)): as [`along`](Self::along) these arcs, but no ball is farther
    /// than the tolerance from that of the law along the curve itself, over the fraction of its own length. Half the tolerance is for the arcs: they need be within less of the curve, as a radius that changes
    /// counts what they are ahead or behind. Proved from the hulls of the curve; lengths are integrated to 1e-12.
    ///
    /// ```
    /// use cyclide::{Point3, construct::{FairSplineOptions, RadiusLaw, Tube}, curve::CircleSpline, model::Lower};
    /// let points = [[0.0, 0.0, 0.0], [60.0, 0.0, 0.0], [95.0, 35.0, 10.0], [70.0, 75.0, 30.0]].map(Point3::from);
    /// let way = CircleSpline::fair(&points, &FairSplineOptions::default())?;
    /// let arcs = way.lower_to_arcs(2e-3)?;
    /// let horn = Tube::along_curve(&way, (&arcs.form, &arcs.correspondence), &RadiusLaw::new(&[[0.0, 3.0], [1.0, 6.0]])?, 0.01)?;
    /// assert!(horn.bound() <= 0.01);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`along`](Self::along); `not-within-tolerance` (the arcs are farther from the curve than half the tolerance), `too-many-pieces` (more arcs than 4096 and 64 for each piece of the curve).
    pub fn along_curve(
        curve: &dyn ParamCurve,
        (arcs, parts): (&ArcPath, &Correspondence),
        law: &RadiusLaw,
        tolerance: f64,
    ) -> Result<Self> {
        let (count, cap) = (arcs.arcs().len(), along::MOST_ARCS + MOST_ARCS_OF_PIECE * curve.piece_count());
        if count > cap {
            return Err(along::too_many(curve.piece_count() - 1, cap));
        }
        let half = 0.5 * tolerance;
        let tube = Self::along(arcs, law, half)?;
        let closed;
        let law = if curve.is_closed() {
            closed = law.clone().closed()?;
            &closed
        } else {
            law
        };
        let steepest = law.steepest();
        let beside::Beside { distance, lag } = beside::beside(curve, arcs, parts, half, steepest > 0.0)?;
        let bound = if steepest > 0.0 { distance + steepest * lag } else { distance };
        if !(bound <= half) {
            return Err(CurveError::NotWithinTolerance { piece: 0, bound, tolerance: half }.into());
        }
        Ok(Self { bound: bound + tube.bound, ..tube })
    }

    /// The same with a bore that leaves this thickness of the wall, measured along the normals.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless the wall is thinner than the least radius.
    pub fn with_wall(self, wall: f64) -> Result<Self> {
        let max = self.radii()[0];
        if !(wall > 0.0 && wall < max) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Wall, value: wall, min: 0.0, max }.into());
        }
        Ok(Self { wall: Some(wall), ..self })
    }

    /// The same with other ends; a closed tube has none. Round ends are the rest of the balls there.
    #[must_use]
    pub fn with_ends(self, ends: PipeEnds) -> Self {
        Self { ends, ..self }
    }

    /// No ball is farther from those of the law than this; 0 if exact.
    #[must_use]
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// The least and the largest radius.
    #[must_use]
    pub fn radii(&self) -> [f64; 2] {
        let radii = self.arcs.iter().map(BallArc::radii);
        radii.fold([f64::INFINITY, 0.0], |[low, high], [a, b]| [low.min(a), high.max(b)])
    }

    /// How many arcs of balls it consists of.
    #[must_use]
    pub fn arc_count(&self) -> usize {
        self.arcs.len()
    }

    /// True if it comes back to its start.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The first two of several tubes, by their numbers, that run into each other, with the distance of the centers of two balls that do: looked for as by
    /// [`body`](Self::body).
    ///
    /// ```
    /// use cyclide::{Point3, construct::{Ball, Tube}};
    /// let rod = |a: [f64; 3], b: [f64; 3]| Tube::through(&[a, b].map(|p| Ball::new(Point3::from(p), 1.0)), false);
    /// let cross = [rod([-9.0, 0.0, 0.0], [9.0, 0.0, 0.0])?, rod([0.0, -9.0, 1.0], [0.0, 9.0, 1.0])?];
    /// assert!(Tube::first_meeting(&cross).is_some());
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn first_meeting(tubes: &[Self]) -> Option<([usize; 2], f64)> {
        let found = meeting::first(tubes.iter().map(Self::course).collect())?;
        Some((found.tubes, found.distance))
    }

    /// The body. Outside is outwards; a solid unless the ends of an open tube are open.
    ///
    /// # Errors
    /// `tube-radius-vanishes` (between balls), `coincident-points` (neighboring balls so near that the way between them is rounding), `below-rounding-of-place` (so thin for where it is), `tube-folds` (a bend narrower than the tube, with its place), `pipe-meets-itself` (parts are
    /// proved apart, but where they are as near as their hulls: there balls are compared in the middle of parts half their radius long and where the chords of these are nearest), as
    /// [`CyclidePatch::from_corners_and_frame`](crate::surface::CyclidePatch::from_corners_and_frame).
    pub fn body(&self) -> Result<Body> {
        self.check_arcs()?;
        meeting::check(self.course())?;
        let not_told_apart = |error| match error {
            Error::Shell(ShellError::NotAShell { .. }) => {
                self.nearest_balls().or_else(|| self.thinner_than_rounding()).unwrap_or(error)
            }
            other => other,
        };
        self.sewn().map_err(not_told_apart)
    }

    /// The balls, of those that a skin cannot be sewn between, that are nearest to each other for their size: where the way between two is known to its rounding only, their circles are
    /// as well, and these have to be much nearer than the balls are.
    fn nearest_balls(&self) -> Option<Error> {
        let reach = |arc: &BallArc| {
            let [a, b] = arc.ends.map(|ball| ball.center.to_vec().max_abs() + ball.radius);
            let (distance, size) = (arc.ends[0].center.distance(arc.ends[1].center), a.max(b));
            (distance, (LEAST_TOLD * f64::EPSILON * size * arc.radii()[1]).sqrt(), arc.source)
        };
        let nearest = self.arcs.iter().map(reach).min_by(|a, b| (a.0 / a.1).total_cmp(&(b.0 / b.1)));
        let (distance, limit, first) = nearest.filter(|(distance, limit, _)| distance <= limit)?;
        Some(Error::Point(PointError::CoincidentPoints { first, second: first + 1, distance, limit }))
    }

    /// Of a tube that cannot be sewn: so thin for where it is that the rounding of its places is its shape.
    fn thinner_than_rounding(&self) -> Option<Error> {
        let far = |arc: &BallArc| arc.ends.iter().map(|ball| ball.center.to_vec().max_abs()).fold(0.0, f64::max);
        let place = self.arcs.iter().map(far).fold(0.0, f64::max);
        let size = self.radii()[0] - self.wall.unwrap_or(0.0);
        range::check_size_in_place(ErrorItem::Radius, size, place, LEAST_IN_PLACE).err()
    }

    fn sewn(&self) -> Result<Body> {
        let (rings, steps) = self.rings();
        let outer = Skin::new(&rings, &steps, 0.0)?;
        let Some(wall) = self.wall else {
            return Ok(Body { outer: outer.closed(self.ends, !self.closed)?, voids: Vec::new() });
        };
        let inner = Skin::new(&rings, &steps, wall)?;
        if self.closed || self.ends == PipeEnds::Round {
            let void = inner.closed(self.ends, !self.closed)?.flipped();
            return Ok(Body { outer: outer.closed(self.ends, !self.closed)?, voids: vec![void] });
        }
        Ok(Body { outer: outer.with_bore(inner)?, voids: Vec::new() })
    }

    /// How far the rim of a wall leaves the plane of the outer circle at an end that is not round: it is along the normals, and where the
    /// radius changes at the end, or a ball there is not met in its middle, a part of a cone. 0 without a wall.
    ///
    /// ```
    /// use cyclide::{Point3, construct::{Ball, Tube}};
    /// let balls = [Ball::new(Point3::ORIGIN, 10.0), Ball::new(Point3::new(10.0, 0.0, 0.0), 5.0)];
    /// let funnel = Tube::through(&balls, false)?.with_wall(2.0)?;
    /// assert!((funnel.rim_depth() - 1.0).abs() < 1e-12); // the wall times the sine of the slope
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn rim_depth(&self) -> f64 {
        let (Some(wall), Some(first), Some(last)) = (self.wall, self.arcs.first(), self.arcs.last()) else {
            return 0.0;
        };
        if self.closed || self.ends == PipeEnds::Round {
            return 0.0;
        }
        let sine = |way: ball::Way| (way.r / way.v.length()).abs();
        wall * sine(first.tangents[0]).max(sine(last.tangents[1]))
    }

    fn course(&self) -> meeting::Course<'_> {
        meeting::Course { arcs: &self.arcs, closed: self.closed, round: self.ends == PipeEnds::Round }
    }

    fn check_arcs(&self) -> Result<()> {
        for arc in &self.arcs {
            let [radius, _] = arc.radii();
            if radius <= 0.0 {
                return Err(TubeError::RadiusVanishes { piece: arc.source, radius }.into());
            }
            let (left, at) = arc.left();
            if !(left > LEAST_LEFT) {
                return Err(TubeError::Folds { piece: arc.source, at, left }.into());
            }
        }
        Ok(())
    }

    /// The rings between arcs, and the steps from each to the next.
    fn rings(&self) -> (Vec<Ring>, Vec<Step>) {
        let start = self.arcs[0].station(0.0);
        let mut rings = vec![Ring::quarters(start, self.first_direction())];
        let mut steps = Vec::new();
        for (index, arc) in self.arcs.iter().enumerate() {
            let carried = rings[index].carried(arc.station(1.0));
            if self.closed && index + 1 == self.arcs.len() {
                steps.push(closing(carried, &rings[0]));
                break;
            }
            let respread = carried.respread();
            rings.push(respread.unwrap_or(carried));
            steps.push(Step { carried, next: index + 1, renumbered: 0, turned: respread.is_some() });
        }
        (rings, steps)
    }

    /// Across the plane of the first bend: the lines of a plane tube lie in its plane and across it.
    fn first_direction(&self) -> Vec3 {
        let bends = self.arcs.iter().map(|arc| arc.tangents[0].v.cross(arc.tangents[1].v));
        bends.filter_map(|bend| if bend.length() > 1e-9 { bend.unit() } else { None }).next().unwrap_or_default()
    }
}

/// The step to the first ring of a closed tube: to the places that are nearest.
fn closing(carried: Ring, first: &Ring) -> Step {
    let angles = carried.angles();
    let apart = |renumbered: usize| {
        let off = (0..4).map(|k| {
            let turn = first_angle(&carried, first, (k + renumbered) % 4) - angles[k];
            (turn + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI
        });
        off.map(f64::abs).fold(0.0, f64::max)
    };
    let renumbered = (0..4).min_by(|&a, &b| apart(a).total_cmp(&apart(b))).unwrap_or(0);
    Step { carried, next: 0, renumbered, turned: apart(renumbered) > SAME_PLACES }
}

fn first_angle(carried: &Ring, first: &Ring, place: usize) -> f64 {
    carried.angle(first.radial(place))
}
