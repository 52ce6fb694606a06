//! The loop of balls between two pipes that pass each other: pieces of the plane of the torus through balls of one radius, refined until the
//! radius is within its tolerance (`docs/math/pipe-crossings.md#the-loop`).
//!
//! Both planes through the common normal of the axes and one of them are planes of symmetry, so a quarter of the loop says all.

use crate::base::frame::Frame;
use crate::base::planar::{Point2, Vec2};
use crate::construct::curves::{TorusSplineOptions, TorusTangent};
use crate::error::{Error, Result};
use crate::rational::{Polynomial, PolynomialRow, QuatPolynomial};
use crate::surface::{CanalPatch, SkewCylinders, Torus, TorusSpline};
use std::f64::consts::FRAC_PI_2;

/// Pieces of a loop at most.
const MOST_PIECES: usize = 2048;
/// Steps in which a place is found between two others, and the step of differences there.
const STEPS: u32 = 60;
const DIFFERENCE: f64 = 1e-6;
/// Corners of the holes nearer to each other than this are one node.
const NEAR: f64 = 0.1;

/// The balls of a piece, with their contacts.
#[derive(Debug, Clone)]
pub(super) struct LoopPiece {
    /// The canal of the outer skin, with even arcs at both ends.
    pub(super) patch: CanalPatch,
    /// Half directions of the contacts round both pipes.
    pub(super) halves: [[Polynomial; 2]; 2],
}

/// The whole loop, once round the common normal.
pub(super) struct BallLoop {
    pub(super) pieces: Vec<LoopPiece>,
    /// In a quarter: pieces, and the numbers of the nodes that are corners of the holes of both pipes.
    pub(super) quarter: usize,
    pub(super) corners: [usize; 2],
    /// The least and the largest radius, proved.
    pub(super) radii: [f64; 2],
}

impl BallLoop {
    /// # Errors
    /// `too-many-pieces`; as [`CanalPatch::along`].
    pub(super) fn new(pair: &SkewCylinders, radius: f64, tolerance: f64) -> Result<Self> {
        let balls = Balls { pair, radius };
        let marks = balls.corners();
        let mut bounds = vec![0.0, marks[0].min(marks[1]), marks[0].max(marks[1]), FRAC_PI_2];
        let together = bounds[2] - bounds[1] < NEAR;
        if together {
            bounds.splice(1..3, [0.5 * (marks[0] + marks[1])]);
        }
        let mut quarter: Vec<LoopPiece> = Vec::new();
        let mut nodes = vec![0];
        let mut radii = [f64::INFINITY, f64::NEG_INFINITY];
        for ends in bounds.windows(2) {
            let mut left = vec![[ends[0], ends[1]]];
            while let Some([from, to]) = left.pop() {
                if let Some((pieces, [low, high])) = balls.span([from, to], tolerance)? {
                    quarter.extend(pieces);
                    radii = [radii[0].min(low), radii[1].max(high)];
                    continue;
                }
                let middle = 0.5 * (from + to);
                if 4 * (quarter.len() + 2 * left.len() + 4) > MOST_PIECES || !(from < middle && middle < to) {
                    return Err(Error::TooManyPieces {
                        what: "the blend",
                        segment: None,
                        needed: 2.0 * MOST_PIECES as f64,
                        cap: MOST_PIECES,
                        remedy: "use a larger tolerance",
                    });
                }
                left.extend([[middle, to], [from, middle]]);
            }
            nodes.push(quarter.len());
        }
        let corners = if together {
            [nodes[1]; 2]
        } else if marks[0] < marks[1] {
            [nodes[1], nodes[2]]
        } else {
            [nodes[2], nodes[1]]
        };
        let back = |mirror: Mirror| quarter.iter().rev().map(move |piece| piece.mirrored(mirror).reversed());
        let pieces = quarter
            .iter()
            .cloned()
            .chain(back(Mirror::Along))
            .chain(quarter.iter().map(|piece| piece.mirrored(Mirror::Along).mirrored(Mirror::Across)))
            .chain(back(Mirror::Across))
            .collect();
        Ok(Self { pieces, quarter: quarter.len(), corners, radii })
    }

    /// How far the contact with a pipe reaches along it.
    pub(super) fn reach(&self, pipe: usize) -> f64 {
        let places = self.pieces.iter().flat_map(|piece| (0..=16).map(|k| piece.along_at(pipe, f64::from(k) / 16.0)));
        places.fold(0.0, |most: f64, at| most.max(at.abs()))
    }
}

/// Balls of one radius, by an angle.
struct Balls<'a> {
    pair: &'a SkewCylinders,
    radius: f64,
}

impl Balls<'_> {
    fn place(&self, theta: f64) -> Result<Point2> {
        self.pair.place_of_radius(self.radius, theta)
    }

    /// The derivative of the place: of `sin A = a cos θ`, `cos B = -b sin θ`.
    fn rate(&self, place: Point2, theta: f64) -> Vec2 {
        let (sin, cos) = theta.sin_cos();
        let excess = self.radius - self.pair.smallest_radius();
        let [p, q] = self.pair.radii().map(|r| (excess / (r + self.radius)).sqrt());
        Vec2::new(-q * sin / place.x.cos(), p * cos / place.y.sin())
    }

    /// The angles at which the contact with either pipe runs at 45 degrees to it.
    fn corners(&self) -> [f64; 2] {
        let contacts = |theta: f64| {
            self.place(theta).and_then(|place| self.pair.ball(place)).map(|ball| (ball.center, ball.normals))
        };
        // How much more the contact runs along the pipe than round it.
        let lead = |pipe: usize, theta: f64| {
            let (Ok((m0, n0)), Ok((m1, n1))) = (contacts(theta - DIFFERENCE), contacts(theta + DIFFERENCE)) else {
                return 0.0;
            };
            let along = if pipe == 0 { (m1 - m0).x } else { (m1 - m0).y };
            along.abs() - self.pair.radii()[pipe] * (n1[pipe] - n0[pipe]).length()
        };
        [0, 1].map(|pipe: usize| {
            let (mut low, mut high) = (0.0, FRAC_PI_2);
            for _ in 0..STEPS {
                let middle = 0.5 * (low + high);
                // The first pipe is followed along its axis at 0, the second round it.
                if (lead(pipe, middle) > 0.0) == (pipe == 0) { low = middle } else { high = middle }
            }
            0.5 * (low + high)
        })
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
            let made =
                LoopPiece::new(CanalPatch::along(self.pair, piece)?, CanalPatch::half_directions(self.pair, piece)?);
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

/// A plane of symmetry: the one that the first axis is along, or across.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mirror {
    /// y to -y.
    Along,
    /// x to -x.
    Across,
}

impl LoopPiece {
    fn new(patch: CanalPatch, [first, [c, s]]: [[Polynomial; 2]; 2]) -> Self {
        // The second pipe is seen from the first: from below, where its normals have the angle π.
        let second = [s, c];
        let upright = |[c, s]: [Polynomial; 2]| if c.value(0.5) < 0.0 { [&c * -1.0, &s * -1.0] } else { [c, s] };
        Self { patch: patch.with_even_ends(), halves: [upright(first), upright(second)] }
    }

    /// The place of the contact along a pipe, times the weight.
    pub(super) fn along(&self, pipe: usize) -> &Polynomial {
        &self.patch.center().0[pipe]
    }

    pub(super) fn along_at(&self, pipe: usize, s: f64) -> f64 {
        self.along(pipe).value(s) / self.patch.center().weight().value(s)
    }

    fn mirrored(&self, mirror: Mirror) -> Self {
        let axis = usize::from(mirror == Mirror::Along);
        let mut center = self.patch.center().clone();
        center.0[axis] = &center.0[axis] * -1.0;
        // A rotation seen in a mirror turns the other way about what lies in it.
        let signs = if mirror == Mirror::Along { [1.0, -1.0, 1.0, -1.0] } else { [1.0, 1.0, -1.0, -1.0] };
        let turns = self
            .patch
            .turns()
            .each_ref()
            .map(|QuatPolynomial(parts)| QuatPolynomial(std::array::from_fn(|k| &parts[k] * signs[k])));
        let mut halves = self.halves.clone();
        // Round the first pipe angles go towards y, round the second towards x.
        let pipe = usize::from(mirror == Mirror::Across);
        halves[pipe][1] = &halves[pipe][1] * -1.0;
        Self { patch: CanalPatch::from_turns(center, self.patch.radius().clone(), turns), halves }
    }

    pub(super) fn reversed(&self) -> Self {
        let PolynomialRow(center) = self.patch.center();
        let turns = self
            .patch
            .turns()
            .each_ref()
            .map(|QuatPolynomial(parts)| QuatPolynomial(parts.each_ref().map(Polynomial::reversed)));
        let center = PolynomialRow(center.each_ref().map(Polynomial::reversed));
        Self {
            patch: CanalPatch::from_turns(center, self.patch.radius().reversed(), turns),
            halves: self.halves.each_ref().map(|half| half.each_ref().map(Polynomial::reversed)),
        }
    }
}
