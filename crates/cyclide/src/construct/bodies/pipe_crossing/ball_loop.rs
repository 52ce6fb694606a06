//! The loop of balls between two pipes that pass each other: pieces of the plane of the torus through balls of one radius, refined until the
//! radius is within its tolerance (`docs/math/pipe-crossings.md#the-loop`).
//!
//! A half turn about the common normal of the axes leaves both pipes where they are, so half of the loop says all.

use super::corners::Corners;
use crate::base::frame::Frame;
use crate::base::planar::{Point2, Vec2};
use crate::construct::bodies::halving::Halving;
use crate::construct::curves::{TorusSplineOptions, TorusTangent};
use crate::error::Result;
use crate::rational::{Polynomial, QuatPolynomial};
use crate::surface::{CanalPatch, RollingBall, SkewCylinders, Torus, TorusSpline};

/// Pieces of half a loop at most.
const HALVING: Halving = Halving { what: "half of the blend", cap: 1024, least: 0.0, remedy: "use a larger tolerance" };

/// The balls of a piece, with their contacts.
#[derive(Debug, Clone)]
pub(super) struct LoopPiece {
    /// The canal of the outer skin, with even arcs at both ends.
    pub(super) patch: CanalPatch,
    /// Half directions of the contacts round both pipes.
    pub(super) halves: [[Polynomial; 2]; 2],
    /// Their places along the pipes, times the weight.
    pub(super) along: [Polynomial; 2],
}

/// The whole loop, once round the common normal.
pub(super) struct BallLoop {
    pub(super) pieces: Vec<LoopPiece>,
    /// For both pipes the numbers of the nodes that are corners of its hole: those towards its end, at low and at high angles. The others are half the loop from these.
    pub(super) corners: [[usize; 2]; 2],
    /// The least and the largest radius, proved.
    pub(super) radii: [f64; 2],
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
    /// # Errors
    /// `too-many-pieces`; as [`CanalPatch::along`].
    pub(super) fn new(pair: &SkewCylinders, radius: f64, tolerance: f64) -> Result<Self> {
        let balls = Balls { pair, radius };
        let corners = Corners::new(&balls)?;
        let mut half: Vec<LoopPiece> = Vec::new();
        let mut nodes = vec![0];
        let mut radii = [f64::INFINITY, f64::NEG_INFINITY];
        for ends in corners.bounds.windows(2) {
            HALVING.extend(&mut half, [ends[0], ends[1]], |part| {
                let Some((pieces, [low, high])) = balls.span(part, tolerance)? else { return Ok(None) };
                radii = [radii[0].min(low), radii[1].max(high)];
                Ok(Some(pieces))
            })?;
            nodes.push(half.len());
        }
        let node = |(bound, turned): (usize, bool)| nodes[bound] + if turned { half.len() } else { 0 };
        let corners = corners.of_pipes.map(|corners| corners.map(node));
        let pieces = half.iter().cloned().chain(half.iter().map(LoopPiece::turned)).collect();
        Ok(Self { pieces, corners, radii })
    }

    /// The way round the hole of a pipe. Seen from the first pipe the loop turns as angles do, seen from the second the other way.
    pub(super) fn hole_order(&self, pipe: usize) -> HoleOrder {
        let (count, [first, second], ahead) = (self.pieces.len(), self.corners[pipe], pipe == 0);
        let nodes: Vec<usize> = (0..count).map(|j| if ahead { first + j } else { first + count - j } % count).collect();
        let pieces = nodes.iter().map(|&node| if ahead { node } else { (node + count - 1) % count }).collect();
        let front = if ahead { second + count - first } else { first + count - second } % count;
        let half = count / 2;
        HoleOrder { nodes, pieces, ahead, sides: [0, front.min(half), half, half + front.min(half), count] }
    }

    /// How far the contact with a pipe reaches along it.
    pub(super) fn reach(&self, pipe: usize) -> f64 {
        let places = self.pieces.iter().flat_map(|piece| (0..=16).map(|k| piece.along_at(pipe, f64::from(k) / 16.0)));
        places.fold(0.0, |most: f64, at| most.max(at.abs()))
    }
}

/// Balls of one radius, by an angle.
pub(super) struct Balls<'a> {
    pair: &'a SkewCylinders,
    radius: f64,
}

impl Balls<'_> {
    fn place(&self, theta: f64) -> Result<Point2> {
        self.pair.place_of_radius(self.radius, theta)
    }

    pub(super) fn ball(&self, theta: f64) -> Result<RollingBall> {
        self.pair.ball(self.place(theta)?)
    }

    pub(super) fn pair(&self) -> &SkewCylinders {
        self.pair
    }

    /// The derivative of the place: of `sin A = a cos θ`, `cos B = -b sin θ`.
    fn rate(&self, place: Point2, theta: f64) -> Vec2 {
        let (sin, cos) = theta.sin_cos();
        let excess = self.radius - self.pair.smallest_radius();
        let [p, q] = self.pair.radii().map(|r| (excess / (r + self.radius)).sqrt());
        Vec2::new(-q * sin / place.x.cos(), p * cos / place.y.sin())
    }

    /// The pieces between two angles with the bounds of their radius, if that is within the tolerance and weights are positive.
    fn span(&self, ends: [f64; 2], tolerance: f64) -> Result<Option<(Vec<LoopPiece>, [f64; 2])>> {
        let places = [self.place(ends[0])?, self.place(ends[1])?];
        let tangents = [0, 1].map(|k: usize| TorusTangent::Rate(self.rate(places[k], ends[k])));
        let options = TorusSplineOptions { tangents: tangents.to_vec(), knots: ends.to_vec(), ..Default::default() };
        // Places are all that counts: any torus will do.
        let spline = TorusSpline::through_places(&Torus::new(Frame::WORLD, 2.0, 1.0)?, &places, &options)?;
        let mut radii = [f64::INFINITY, f64::NEG_INFINITY];
        let mut pieces = Vec::new();
        for piece in spline.pieces() {
            let halves = CanalPatch::half_directions(self.pair, piece)?;
            let made = LoopPiece::new(self.pair, CanalPatch::along(self.pair, piece)?, halves);
            let Some([low, high]) = made.patch.radius_bounds() else { return Ok(None) };
            let near = low >= self.radius - tolerance && high <= self.radius + tolerance;
            if !(near && made.patch.to_rational()?.has_positive_weights()) {
                return Ok(None);
            }
            radii = [radii[0].min(low), radii[1].max(high)];
            pieces.push(made);
        }
        Ok(Some((pieces, radii)))
    }
}

impl LoopPiece {
    fn new(pair: &SkewCylinders, patch: CanalPatch, [first, [c, s]]: [[Polynomial; 2]; 2]) -> Self {
        // The second pipe is seen from the first: from below, where its normals have the angle π.
        let second = [s, c];
        let upright = |[c, s]: [Polynomial; 2]| if c.value(0.5) < 0.0 { [&c * -1.0, &s * -1.0] } else { [c, s] };
        let [x, y, _, _] = &patch.center().0;
        let [way, _] = pair.second_axis();
        let along = [x.clone(), &(x * way.x) + &(y * way.y)];
        Self { patch: patch.with_even_ends(), halves: [upright(first), upright(second)], along }
    }

    pub(super) fn along_at(&self, pipe: usize, s: f64) -> f64 {
        self.along[pipe].value(s) / self.patch.center().weight().value(s)
    }

    /// The angle round a pipe.
    pub(super) fn angle_at(&self, pipe: usize, s: f64) -> f64 {
        let [cos, sin] = self.halves[pipe].each_ref().map(|p| p.value(s));
        2.0 * sin.atan2(cos)
    }

    /// The same half a turn about the common normal on.
    fn turned(&self) -> Self {
        let mut center = self.patch.center().clone();
        for axis in [0, 1] {
            center.0[axis] = &center.0[axis] * -1.0;
        }
        let turns = self.patch.turns().each_ref().map(|QuatPolynomial(parts)| {
            let signs = [1.0, -1.0, -1.0, 1.0];
            QuatPolynomial(std::array::from_fn(|k| &parts[k] * signs[k]))
        });
        let halves = self.halves.each_ref().map(|[cos, sin]| [cos.clone(), sin * -1.0]);
        let along = self.along.each_ref().map(|along| along * -1.0);
        Self { patch: CanalPatch::from_turns(center, self.patch.radius().clone(), turns), halves, along }
    }
}
