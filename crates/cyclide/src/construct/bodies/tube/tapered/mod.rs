//! Tubes of circles across a spine: the circle of the radius about each point of the spine, in the plane across it. So a tube begins and
//! ends where its spine does, with the radii there (`docs/math/tubes.md#circles-across-a-spine`).
//!
//! Over an arc of the spine the circle is carried by the rotation of the arc, and the radius is a polynomial of the parameter: faces of degree
//! (2, 2 + d), exact. On segments the cubic of the law is one of the parameter, so these are exact; on arcs it is fitted to the length by
//! Hermite data, within the tolerance.

mod meeting;
mod piece;
mod skin;

use super::PipeEnds;
use super::along::MOST_ARCS;
use super::beside::{self, Beside};
use super::radius_law::RadiusLaw;
use super::{MOST_ARCS_OF_PIECE, along};
use crate::base::range;
use crate::curve::{ArcPath, Correspondence, CurvePlace, ParamCurve};
use crate::error::{CurveError, Error, ErrorItem, NumberError, Result, ShellError};
use crate::topology::Body;
use piece::Piece;
use skin::Stations;

/// Places of each stretch of a curve at which its direction is compared with that of the arcs.
const PLACES: usize = 8;

/// A tube whose circles lie across its spine, solid or with a wall.
///
/// ```
/// use cyclide::{Point3, construct::{RadiusLaw, TaperedTube}, curve::ArcPath};
/// let line = ArcPath::rounded_polyline(&[[0.0, 0.0, 0.0], [0.0, 0.0, 100.0]].map(Point3::from), false, &[0.0; 2])?;
/// let reducer = TaperedTube::along(&line, &RadiusLaw::new(&[[0.0, 60.0], [1.0, 30.0]])?, 1e-3)?;
/// let frustum = std::f64::consts::PI / 3.0 * 100.0 * (60.0 * 60.0 + 60.0 * 30.0 + 30.0 * 30.0);
/// assert!(reducer.bound() == 0.0 && (reducer.body()?.outer.volume() - frustum).abs() < 1e-8);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TaperedTube {
    pieces: Vec<Piece>,
    bound: f64,
    proved: bool,
    closed: bool,
    wall: Option<f64>,
    ends: PipeEnds,
}

impl TaperedTube {
    /// The tube along a chain of arcs, with a law of the radius over the fraction of its length. No circle has a radius farther than the tolerance from the law
    /// ([`bound`](Self::bound), proved); along segments, and where the radius stays, it is exact. How fast the radius changes is not limited.
    ///
    /// # Errors
    /// `parameter-out-of-range` (the tolerance), `corner-not-mitred` (a joint of the spine that is not smooth), `radius-not-closed`, `tube-folds` (a bend narrower
    /// than the tube, with its place), `too-many-pieces` (more than 4096, and 4 for each arc of the spine).
    pub fn along(spine: &ArcPath, law: &RadiusLaw, tolerance: f64) -> Result<Self> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            let name = ErrorItem::Tolerance;
            return Err(
                NumberError::ParameterOutOfRange { name, value: tolerance, min: 0.0, max: f64::INFINITY }.into()
            );
        }
        let closed = spine.is_closed();
        let law = if closed { law.clone().closed()? } else { law.clone() };
        let (pieces, bound) = piece::pieces(spine, &law, tolerance)?;
        Ok(Self { pieces, bound, proved: true, closed, wall: None, ends: PipeEnds::Flat })
    }

    /// The tube along any curve, with the arcs that stand for it and the parts of the curve that they stand for ([`Lower::lower_to_arcs`](crate::model::Lower::lower_to_arcs)): as [`along`](Self::along) these arcs,
    /// but no point of it is farther than the tolerance from the tube along the curve itself. Half the tolerance is for the arcs. Distances and lengths are proved as those of
    /// [`Tube::along_curve`](crate::construct::Tube::along_curve); by how much the planes of the circles lean is looked at in 8 places of each arc ([`is_proved`](Self::is_proved)).
    ///
    /// ```
    /// use cyclide::{Point3, construct::{FairSplineOptions, RadiusLaw, TaperedTube}, curve::CircleSpline, model::Lower};
    /// let points = [[0.0, 0.0, 0.0], [60.0, 0.0, 0.0], [95.0, 35.0, 10.0], [70.0, 75.0, 30.0]].map(Point3::from);
    /// let way = CircleSpline::fair(&points, &FairSplineOptions::default())?;
    /// let arcs = way.lower_to_arcs(1e-3)?;
    /// let horn = TaperedTube::along_curve(&way, (&arcs.form, &arcs.correspondence), &RadiusLaw::new(&[[0.0, 3.0], [1.0, 6.0]])?, 0.01)?;
    /// assert!(horn.bound() <= 0.01 && horn.body()?.is_solid());
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`along`](Self::along); `not-within-tolerance` (the arcs are too far from the curve), `too-many-pieces` (more arcs than 4096 and 64 for each piece of the curve).
    pub fn along_curve(
        curve: &dyn ParamCurve,
        (arcs, parts): (&ArcPath, &Correspondence),
        law: &RadiusLaw,
        tolerance: f64,
    ) -> Result<Self> {
        let (count, cap) = (arcs.arcs().len(), MOST_ARCS + MOST_ARCS_OF_PIECE * curve.piece_count());
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
        let Beside { distance, lag } = beside::beside(curve, arcs, parts, half, steepest > 0.0)?;
        let mut bound = distance;
        if steepest > 0.0 {
            // A plane that leans moves points along the tube, by the radius at most, over what is left of the width in a bend.
            let left = tube.pieces.iter().map(|piece| 1.0 - piece.arc.curvature() * piece.most).fold(1.0, f64::min);
            let [_, most] = tube.radii();
            bound += steepest * (lag + most * lean(curve, arcs, parts) / (left * arcs.length()));
        }
        if !(bound <= half) {
            return Err(CurveError::NotWithinTolerance { piece: 0, bound, tolerance: half }.into());
        }
        Ok(Self { bound: bound + tube.bound, proved: steepest == 0.0, ..tube })
    }

    /// The same with a bore that leaves this thickness of the wall, measured across the spine: the bore has the radius less the wall everywhere, and ends in the
    /// planes of the ends.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless the wall is thinner than the least radius.
    pub fn with_wall(self, wall: f64) -> Result<Self> {
        let [max, _] = self.radii();
        if !(wall > 0.0 && wall < max) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Wall, value: wall, min: 0.0, max }.into());
        }
        Ok(Self { wall: Some(wall), ..self })
    }

    /// The same with other ends; a closed tube has none. A round end is the part of a ball that goes on from the circle there with its slope.
    #[must_use]
    pub fn with_ends(self, ends: PipeEnds) -> Self {
        Self { ends, ..self }
    }

    /// No point is farther than this from the tube of the law; 0 if exact.
    #[must_use]
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// Whether the bound is proved; else a part of it is looked at in places.
    #[must_use]
    pub fn is_proved(&self) -> bool {
        self.proved
    }

    /// The least and the largest radius.
    #[must_use]
    pub fn radii(&self) -> [f64; 2] {
        let ends = self.pieces.iter().flat_map(|piece| [0.0, 1.0].map(|t| piece.radius.value(t)));
        ends.fold([f64::INFINITY, 0.0], |[low, high], r| [low.min(r), high.max(r)])
    }

    /// How many pieces it consists of.
    #[must_use]
    pub fn piece_count(&self) -> usize {
        self.pieces.len()
    }

    /// True if it comes back to its start.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The body. Outside is outwards; a solid unless the ends of an open tube are open.
    ///
    /// # Errors
    /// `pipe-meets-itself` (circles of parts of the tube cross; parts are proved apart, or halved until they are half their radius long, and compared there),
    /// `below-rounding-of-place` (so thin for where it is), as [`Arc::from_weight_ratio`](crate::curve::Arc::from_weight_ratio).
    pub fn body(&self) -> Result<Body> {
        meeting::check(&self.course())?;
        let thin = |error| match error {
            Error::Shell(ShellError::NotAShell { .. }) => self.thinner_than_rounding().unwrap_or(error),
            other => other,
        };
        self.sewn().map_err(thin)
    }

    fn sewn(&self) -> Result<Body> {
        let stations = Stations::new(&self.pieces, self.closed)?;
        let outer = |ends| stations.skin(&self.pieces, 0.0, ends);
        let Some(wall) = self.wall else {
            return Ok(Body { outer: outer(self.ends)?, voids: Vec::new() });
        };
        if self.closed || self.ends == PipeEnds::Round {
            let void = stations.skin(&self.pieces, wall, self.ends)?.flipped();
            return Ok(Body { outer: outer(self.ends)?, voids: vec![void] });
        }
        Ok(Body { outer: stations.with_bore(&self.pieces, wall)?, voids: Vec::new() })
    }

    /// The first two of several tubes, by their numbers, that run into each other, with the distance of the centers of two circles that do: looked for as by
    /// [`body`](Self::body).
    ///
    /// ```
    /// use cyclide::{Point3, construct::{RadiusLaw, TaperedTube}, curve::ArcPath};
    /// let rod = |ends: [[f64; 3]; 2]| {
    ///     let line = ArcPath::rounded_polyline(&ends.map(Point3::from), false, &[0.0; 2])?;
    ///     TaperedTube::along(&line, &RadiusLaw::new(&[[0.0, 1.0], [1.0, 2.0]])?, 1e-3)
    /// };
    /// let cross = [rod([[-9.0, 0.0, 0.0], [9.0, 0.0, 0.0]])?, rod([[0.0, -9.0, 1.0], [0.0, 9.0, 1.0]])?];
    /// assert!(TaperedTube::first_meeting(&cross).is_some());
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn first_meeting(tubes: &[Self]) -> Option<([usize; 2], f64)> {
        meeting::first(&tubes.iter().map(Self::course).collect::<Vec<_>>())
    }

    fn course(&self) -> meeting::Course {
        meeting::Course::new(&self.pieces, self.closed, self.ends == PipeEnds::Round)
    }

    fn thinner_than_rounding(&self) -> Option<Error> {
        let far = |piece: &Piece| piece.arc.start().to_vec().max_abs().max(piece.arc.end().to_vec().max_abs());
        let place = self.pieces.iter().map(far).fold(0.0, f64::max);
        let size = self.radii()[0] - self.wall.unwrap_or(0.0);
        range::check_size_in_place(ErrorItem::Radius, size, place, super::LEAST_IN_PLACE).err()
    }
}

/// The largest angle between a curve and the arcs that stand for it, at places of each of its stretches and the points of the arcs nearest to them.
fn lean(curve: &dyn ParamCurve, arcs: &ArcPath, parts: &Correspondence) -> f64 {
    let (n, mut start, mut arc, mut most) = (curve.piece_count(), parts.start, 0, 0.0_f64);
    for span in &parts.spans {
        let own = &arcs.arcs()[arc..arc + span.pieces];
        arc += span.pieces;
        let at = |place: CurvePlace| place.piece as f64 + place.s;
        let [from, to] = [at(start), at(span.end)];
        for k in 0..=PLACES {
            let place = from + (to - from) * (k as f64 / PLACES as f64);
            // A joint belongs to the piece before the end of a stretch, and to that behind its start.
            let piece = if k == PLACES { (place.ceil() - 1.0).max(0.0) } else { place.floor() };
            let jet = curve.piece_jet(piece as usize % n, place - piece);
            let nearest = own.iter().map(|arc| (arc, arc.closest_point(jet.point)));
            let nearest = nearest.min_by(|a, b| a.1.distance.total_cmp(&b.1.distance));
            let along = nearest.and_then(|(arc, found)| arc.piece_jet(0, found.t).d1.unit());
            if let (Some(along), Some(own)) = (along, jet.d1.unit()) {
                most = most.max(along.angle(own));
            }
        }
        start = span.end;
    }
    most
}
