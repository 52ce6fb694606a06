//! The loop of balls between two pipes that pass each other: pieces of the plane of the torus through balls whose radius follows a law, refined
//! until it does within its tolerance (`docs/math/pipe-crossings.md#the-loop`).

use super::balls::Balls;
use super::contacts::PieceForms;
use super::corners::Corners;
use super::law_fold::LawFold;
use super::mixed::MixedPiece;
use super::torus_pair::TorusPair;
use crate::base::frame::Frame;
use crate::base::vector::Vec3;
use crate::construct::bodies::ball_centers::{BallCenters, CenterTorus, closed_path, reach_of_places};
use crate::construct::bodies::halving::Halving;
use crate::construct::bodies::pierced::{HolePiece, Node};
use crate::construct::curves::{TorusSplineOptions, TorusTangent};
use crate::error::{CrossingError, Result};
use crate::rational::Polynomial;
use crate::surface::{CanalPatch, Torus, TorusPiece, TorusSpline};

/// Pieces of a loop at most. Shorter spans, in radians, are not halved: where a law leaps no blend follows it.
const HALVING: Halving =
    Halving { what: "the blend", cap: 2048, least: 1e-6, remedy: "use a larger tolerance, or a law that changes less" };
/// Places of a piece at which its radius is compared with the law.
const PLACES: u32 = 8;
/// Halvings of pieces at most, until as many are on both sides beside each hole.
const EVENINGS: usize = 512;

/// The balls of a piece, with their contacts.
#[derive(Debug, Clone)]
pub(super) struct LoopPiece {
    way: Way,
    /// The canal of the outer skin, with even arcs at both ends.
    pub(super) patch: CanalPatch,
    /// Half directions of the contacts round both pipes.
    pub(super) halves: [[Polynomial; 2]; 2],
    /// Their places along the pipes, times the weight.
    pub(super) along: [Polynomial; 2],
}

/// What a piece is made from.
#[derive(Debug, Clone)]
enum Way {
    /// In the plane of the torus: balls on one side of both pipes.
    Torus(TorusPiece),
    /// It holds the frames of its pair.
    Mixed(Box<MixedPiece>),
}

/// The whole loop, once round the common normal.
pub(super) struct BallLoop {
    pub(super) pieces: Vec<LoopPiece>,
    /// For both pipes the numbers of the nodes that are corners of its hole: those towards its end, at low and at high angles, then those towards its start, at
    /// high and at low angles.
    pub(super) corners: [[usize; 4]; 2],
    /// The least and the largest radius, proved.
    pub(super) radii: [f64; 2],
    /// The largest difference from the law.
    pub(super) deviation: f64,
}

/// The border of the hole of a pipe as a way round it: from the corner at the end of the pipe and low angles on towards high ones.
pub(super) struct HoleOrder {
    /// The numbers of nodes, and of the pieces that follow on them.
    pub(super) nodes: Vec<usize>,
    pub(super) pieces: Vec<usize>,
    /// Whether this is the way of the loop.
    pub(super) ahead: bool,
    /// Where the sides start in these: towards the end of the pipe, beside the hole, towards the start, beside; last the number of all.
    pub(super) sides: [usize; 5],
}

impl BallLoop {
    /// The width of its blend has to be near to that of `fold`.
    ///
    /// # Errors
    /// `too-many-pieces`; as [`CanalPatch::along`].
    pub(super) fn new(balls: &Balls<'_>, fold: Option<&LawFold>) -> Result<Self> {
        let corners = Corners::new(balls)?;
        let mut made = Self {
            pieces: Vec::new(),
            corners: [[0; 4]; 2],
            radii: [f64::INFINITY, f64::NEG_INFINITY],
            deviation: 0.0,
        };
        let mut nodes = vec![0];
        for ends in corners.bounds.windows(2) {
            HALVING.extend(&mut made.pieces, [ends[0], ends[1]], |part| {
                let Some(span) = balls.span(part, fold)? else { return Ok(None) };
                made.radii = [made.radii[0].min(span.radii[0]), made.radii[1].max(span.radii[1])];
                made.deviation = made.deviation.max(span.deviation);
                Ok(Some(span.pieces))
            })?;
            nodes.push(made.pieces.len());
        }
        made.corners = corners.of_pipes.map(|corners| corners.map(|bound| nodes[bound]));
        made.even_sides(balls)?;
        Ok(made)
    }

    /// Halves pieces until each hole has as many on one side of it as on the other: the lines behind it join their nodes one by one.
    ///
    /// # Errors
    /// `crossing-hole-turns-back` (corners that do not follow each other).
    fn even_sides(&mut self, balls: &Balls<'_>) -> Result<()> {
        for pipe in (0..2).filter(|pipe| balls.side.leaves(*pipe)) {
            let order = self.hole_order(pipe);
            if !order.sides.is_sorted() {
                let along = self.pieces[order.pieces[0]].along_at(pipe, 0.0);
                return Err(CrossingError::HoleTurnsBack { pipe, along }.into());
            }
        }
        for _ in 0..EVENINGS {
            let orders = [0, 1].map(|pipe: usize| self.hole_order(pipe));
            // By how many pieces the first side of each hole has more, and what a piece adds to that.
            let more = [0, 1].map(|pipe: usize| {
                let [_, front, back, rear, count] = orders[pipe].sides;
                if balls.side.leaves(pipe) { (back - front) as i64 - (count - rear) as i64 } else { 0 }
            });
            if more == [0, 0] {
                break;
            }
            let mut adds = vec![[0_i64; 2]; self.pieces.len()];
            for (pipe, HoleOrder { pieces, sides: [_, front, back, rear, count], .. }) in
                orders.iter().enumerate().filter(|(pipe, _)| balls.side.leaves(*pipe))
            {
                pieces[*front..*back].iter().for_each(|&k| adds[k][pipe] = 1);
                pieces[*rear..*count].iter().for_each(|&k| adds[k][pipe] = -1);
            }
            // The one that leaves least, of these the largest.
            let left =
                |k: usize| [0, 1].map(|pipe: usize| more[pipe] + adds[k][pipe]).into_iter().map(|d| d * d).sum::<i64>();
            let size = |k: usize| self.pieces[k].way.size();
            let better = |a: &usize, b: &usize| left(*b).cmp(&left(*a)).then(size(*a).total_cmp(&size(*b)));
            let Some(best) = (0..self.pieces.len()).max_by(better) else { break };
            let [first, second] = self.pieces[best].way.halves();
            let halves = [balls.piece(first)?, balls.piece(second)?];
            self.pieces.splice(best..=best, halves);
            for corner in self.corners.iter_mut().flatten() {
                *corner += usize::from(*corner > best);
            }
        }
        Ok(())
    }

    /// The way round the hole of a pipe. Seen from the first pipe the loop turns as angles do, seen from the second the other way.
    pub(super) fn hole_order(&self, pipe: usize) -> HoleOrder {
        let (count, corners, ahead) = (self.pieces.len(), self.corners[pipe], pipe == 0);
        let first = corners[0];
        let nodes: Vec<usize> = (0..count).map(|j| if ahead { first + j } else { first + count - j } % count).collect();
        let pieces = nodes.iter().map(|&node| if ahead { node } else { (node + count - 1) % count }).collect();
        let from_first = |corner: usize| if ahead { corner + count - first } else { first + count - corner } % count;
        let [_, front, back, rear] = corners.map(from_first);
        HoleOrder { nodes, pieces, ahead, sides: [0, front, back, rear, count] }
    }

    /// The way of the centers, which are counted from the middle of the common normal, this far up.
    ///
    /// # Errors
    /// As [`closed_path`].
    pub(super) fn centers(&self, pair: &TorusPair, height: f64) -> Result<BallCenters> {
        let rows: Vec<_> =
            self.pieces.iter().map(|piece| piece.patch.center().clone().moved(Vec3::Z * height)).collect();
        // All of one way or none.
        let places = self.pieces.iter().filter_map(|piece| match &piece.way {
            Way::Torus(piece) => Some((0..=PLACES).map(|k| piece.place(f64::from(k) / f64::from(PLACES)))),
            Way::Mixed(_) => None,
        });
        let places: Vec<_> = places.flatten().collect();
        let torus = CenterTorus { pair: pair.of_centers(), reach: reach_of_places(places.iter().copied()), height };
        Ok(BallCenters::new(vec![closed_path(rows.iter())?], (!places.is_empty()).then_some(torus)))
    }

    /// How far the contact with a pipe reaches along it.
    pub(super) fn reach(&self, pipe: usize) -> [f64; 2] {
        let places = self.pieces.iter().flat_map(|piece| (0..=16).map(|k| piece.along_at(pipe, f64::from(k) / 16.0)));
        places.fold([0.0_f64; 2], |[low, high], at| [low.min(at), high.max(at)])
    }
}

/// Pieces between two angles, with the bounds of their radius and what it is off the law.
struct Span {
    pieces: Vec<LoopPiece>,
    radii: [f64; 2],
    deviation: f64,
}

impl Balls<'_> {
    /// What pieces between two angles are made from, with balls and directions of the law at both.
    fn ways(&self, ends: [f64; 2]) -> Result<Option<Vec<Way>>> {
        if let Some(mixed) = &self.mixed {
            let contacts = [self.contacts(ends[0])?, self.contacts(ends[1])?];
            return Ok(mixed
                .span(&contacts, ends.map(|angle| self.law.at(angle)))
                .map(|pieces| pieces.map(|piece| Way::Mixed(Box::new(piece))).to_vec()));
        }
        let place = |angle: f64| self.pair.place(self.law.at(angle).map(|x| self.side.sign() * x), angle);
        let places = [place(ends[0])?, place(ends[1])?];
        let tangents = places.map(|(_, rate)| TorusTangent::Rate(rate));
        let options = TorusSplineOptions { tangents: tangents.to_vec(), knots: ends.to_vec(), ..Default::default() };
        // Places are all that counts: any torus will do.
        let torus = Torus::new(Frame::WORLD, 2.0, 1.0)?;
        let spline = TorusSpline::through_places(&torus, &places.map(|(place, _)| place), &options)?;
        Ok(Some(spline.pieces().iter().copied().map(Way::Torus).collect()))
    }

    fn piece(&self, way: Way) -> Result<LoopPiece> {
        let forms = match &way {
            Way::Mixed(piece) => piece.forms(),
            Way::Torus(piece) => self.pair.forms(piece)?,
        };
        Ok(LoopPiece::upright(way, forms))
    }

    /// The pieces between two angles, no value of the law between them, if radius and width keep to the law and weights are positive.
    fn span(&self, ends: [f64; 2], fold: Option<&LawFold>) -> Result<Option<Span>> {
        let Some(ways) = self.ways(ends)? else { return Ok(None) };
        let asked = ends.map(|angle| self.law.at(angle)[0]);
        let (low, high) = (asked[0].min(asked[1]), asked[0].max(asked[1]));
        let mut span = Span { pieces: Vec::new(), radii: [f64::INFINITY, f64::NEG_INFINITY], deviation: 0.0 };
        for way in ways {
            let made = self.piece(way)?;
            let Some(bounds) = made.patch.radius_bounds() else { return Ok(None) };
            let [least, most] = if self.side.sign() > 0.0 { bounds } else { [-bounds[1], -bounds[0]] };
            let beyond = (low - least).max(most - high);
            if !(least > 0.0 && beyond <= self.allowed(low) && made.patch.to_rational()?.has_positive_weights()) {
                return Ok(None);
            }
            span.deviation = span.deviation.max(beyond);
            for k in 1..PLACES {
                let (center, radius) = made.patch.ball(f64::from(k) / f64::from(PLACES));
                let [asked, _] = self.law.at(center.y.atan2(center.x));
                let off = (self.side.sign() * radius - asked).abs();
                if !(off <= self.allowed(asked)) {
                    return Ok(None);
                }
                span.deviation = span.deviation.max(off);
            }
            span.radii = [span.radii[0].min(least), span.radii[1].max(most)];
            span.pieces.push(made);
        }
        if let Some(fold) = fold {
            let left = span.pieces.iter().map(|piece| fold.of_piece(&piece.patch)).fold(f64::INFINITY, f64::min);
            if !fold.is_met(self, ends, left) {
                return Ok(None);
            }
        }
        Ok(Some(span))
    }
}

impl Way {
    /// How far it goes.
    fn size(&self) -> f64 {
        match self {
            Self::Torus(piece) => piece.step().length(),
            Self::Mixed(piece) => piece.size(),
        }
    }

    /// The same in two parts.
    fn halves(&self) -> [Self; 2] {
        match self {
            Self::Torus(piece) => [piece.part(0.0, 0.5), piece.part(0.5, 1.0)].map(Self::Torus),
            Self::Mixed(piece) => piece.halves().map(|half| Self::Mixed(Box::new(half))),
        }
    }
}

impl LoopPiece {
    /// With half directions of angles between -π and π.
    fn upright(way: Way, PieceForms { patch, halves, along }: PieceForms) -> Self {
        let upright = |[c, s]: [Polynomial; 2]| if c.value(0.5) < 0.0 { [&c * -1.0, &s * -1.0] } else { [c, s] };
        Self { way, patch, halves: halves.map(upright), along }
    }

    pub(super) fn along_at(&self, pipe: usize, s: f64) -> f64 {
        self.along[pipe].value(s) / self.patch.center().weight().value(s)
    }

    /// Where it starts on a pipe.
    pub(super) fn node(&self, pipe: usize) -> Node {
        let [c, s] = self.halves[pipe].each_ref().map(|p| p.value(0.0));
        let length = c.hypot(s);
        Node { half: [c / length, s / length], along: self.along_at(pipe, 0.0) }
    }

    /// Its contact with a pipe.
    pub(super) fn border(&self, pipe: usize) -> HolePiece {
        let weight = self.patch.center().weight().clone();
        HolePiece { half: self.halves[pipe].clone(), along: self.along[pipe].clone(), weight }
    }

    /// The angle round a pipe.
    pub(super) fn angle_at(&self, pipe: usize, s: f64) -> f64 {
        let [cos, sin] = self.halves[pipe].each_ref().map(|p| p.value(s));
        2.0 * sin.atan2(cos)
    }
}
