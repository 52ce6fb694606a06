//! Balls inside one pipe and outside the other, for the edge of one less the other (`docs/math/pipe-crossings.md#mixed`).
//!
//! With the radius of the pipe that the balls are inside taken negative, the pair is of the kind of tees, and so are forms and canals: those of a branch whose
//! sideways offset is the distance of the axes. Neither contact goes round its pipe, so that no angle round one of them serves all the loop: spans run by
//! that round the pipe along whose contact it changes more, with either as the branch.

use super::contacts::{Contacts, PieceForms};
use crate::base::quat::Quat;
use crate::base::vector::Vec3;
use crate::construct::bodies::tee::{Canal, Crossing, LoopPiece};
use crate::error::{CrossingError, Result};
use crate::rational::{Polynomial, PolynomialRow, QuatPolynomial};
use crate::surface::{CanalPatch, SkewCylinders};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// How deep pipes are in each other at least, in parts of the sum of their radii: with less, digits are lost that the faces need.
const LEAST_DEPTH: f64 = 1e-3;

/// A pair of pipes, balls outside the first and inside the second.
#[derive(Debug, Clone, Copy)]
pub(super) struct MixedPair {
    pair: SkewCylinders,
    /// With the first pipe as the branch of the second, as it is before the half turn that exchanges their axes, and the other way round.
    frames: [Crossing; 2],
}

/// A piece of the loop, with which pipe is the branch.
#[derive(Debug, Clone, Copy)]
pub(super) struct MixedPiece {
    pair: MixedPair,
    branch: usize,
    /// Whether it is made half a turn about the common normal off its place.
    turned: bool,
    piece: LoopPiece,
}

impl MixedPair {
    /// # Errors
    /// `crossing-pipes-apart` unless the axes are nearer than the sum of the radii, less a thousandth.
    pub(super) fn new(pair: &SkewCylinders) -> Result<Self> {
        let ([first, second], distance) = (pair.radii(), 2.0 * pair.half_gap());
        let limit = (1.0 - LEAST_DEPTH) * (first + second);
        if distance >= limit {
            return Err(CrossingError::PipesApart { distance, limit }.into());
        }
        let frames =
            [[first, -second], [-second, first]].map(|radii| Crossing::passing(radii, distance, PI - pair.angle()));
        Ok(Self { pair: *pair, frames })
    }

    /// Half of the room between the first pipe and the far side of the second: no ball is larger.
    pub(super) fn largest_radius(&self) -> f64 {
        let [first, second] = self.pair.radii();
        self.pair.half_gap() + 0.5 * (second - first)
    }

    /// The contacts of the ball of a radius in a direction from the common normal, where the radius has this slope by the angle.
    ///
    /// With the distance d of the axes, `Y = sin φ`, `X = sin(w - φ)`, and the square t of how far the center is off the common normal, its height is z where
    /// `t Y² + z² = L1²`, `t X² + (d - z)² = L2²`: without t a quadratic in z.
    ///
    /// # Errors
    /// `crossing-ball-too-large`.
    pub(super) fn towards(&self, [radius, slope]: [f64; 2], angle: f64) -> Result<Contacts> {
        let limit = self.largest_radius();
        let (d, [r1, r2]) = (2.0 * self.pair.half_gap(), self.pair.radii());
        let [way, across] = self.pair.second_axis();
        let (sin, cos) = angle.sin_cos();
        let direction = Vec3::new(cos, sin, 0.0);
        let (x, y) = (direction.dot(across), sin);
        let ([l1, l2], [xx, yy]) = ([r1 + radius, r2 - radius], [x * x, y * y]);
        let (a, b, c) = (yy - xx, -2.0 * d * yy, l1 * l1 * xx - l2 * l2 * yy + d * d * yy);
        let discriminant = b * b - 4.0 * a * c;
        let q = 0.5 * (discriminant.max(0.0).sqrt() - b);
        // By the pipe that the direction is more across.
        let square = |z: f64| if yy > xx { (l1 * l1 - z * z) / yy } else { (l2 * l2 - (d - z) * (d - z)) / xx };
        let height =
            [c / q, q / a].into_iter().filter(|z| z.is_finite()).max_by(|p, q| square(*p).total_cmp(&square(*q)));
        let Some(z) = height.filter(|z| radius < limit && square(*z) > 0.0) else {
            return Err(CrossingError::BallTooLarge { radius, limit, works: None }.into());
        };
        let t = square(z);
        // Half the rate of t, and that of the height.
        let (x_rate, y_rate) = (across.y * cos - across.x * sin, cos);
        let first = [yy, z, l1 * slope - t * y * y_rate];
        let second = [xx, z - d, -l2 * slope - t * x * x_rate];
        let det = first[0] * second[1] - first[1] * second[0];
        let half_rate = (first[2] * second[1] - first[1] * second[2]) / det;
        let z_rate = (first[0] * second[2] - first[2] * second[0]) / det;
        let off = t.sqrt();
        let off_rate = half_rate / off;
        let motion = Vec3::new(-sin, cos, 0.0) * off + direction * off_rate;
        let place = direction * off;
        let round = |side: f64, side_rate: f64, up: f64, up_rate: f64| {
            [side.atan2(up), (side_rate * up - up_rate * side) / (side * side + up * up)]
        };
        let [f1, f1_rate] = round(place.y, motion.y, z, z_rate);
        let [f2, f2_rate] = round(place.dot(across), motion.dot(across), d - z, -z_rate);
        Ok(Contacts {
            at: [[place.x, f1], [place.dot(way), f2]],
            rates: [[motion.x, f1_rate], [motion.dot(way), f2_rate]],
        })
    }

    /// The two pieces between two balls, with their radii and the slopes of these by the direction; none where they would turn back.
    pub(super) fn span(&self, ends: &[Contacts; 2], radii: [[f64; 2]; 2]) -> Option<[MixedPiece; 2]> {
        let change = |pipe: usize| ends.iter().map(|end| self.boosted(end, pipe)[1].abs()).sum::<f64>();
        let branch = usize::from(change(1) > change(0));
        // Half a turn about the common normal takes both pipes to themselves, and the factor to the other one of its quadratic: the larger is that of a
        // contact with the main pipe which is nearer to the angle 0.
        let frame = &self.frames[branch];
        let main = |end: &Contacts| frame.boosts[1].boosted_angle(Self::main_angle(end, 1 - branch)).cos();
        let turned = main(&ends[0]) + main(&ends[1]) < 0.0;
        let ends = if turned { ends.each_ref().map(Contacts::turned) } else { *ends };
        let [from, to] = [0, 1].map(|k: usize| self.node(branch, &ends[k], radii[k]));
        let step = (to.angle - from.angle + PI).rem_euclid(TAU) - PI;
        let ahead = from.rate * step > 0.0 && to.rate * step > 0.0 && from.factor < 0.0 && to.factor < 0.0;
        if !(ahead && step.abs() < FRAC_PI_2) {
            return None;
        }
        let angles = [from.angle, from.angle + step];
        let pieces = LoopPiece::hermite(angles, [[from.factor, from.slope], [to.factor, to.slope]]);
        Some(pieces.map(|piece| MixedPiece { pair: *self, branch, turned, piece }))
    }

    /// The true angle of a normal round a pipe that is the branch, from the axes of tees; of the pipe that the ball is inside it is turned about.
    fn branch_angle(contacts: &Contacts, pipe: usize) -> f64 {
        contacts.at[pipe][1] - FRAC_PI_2 - if pipe == 1 { PI } else { 0.0 }
    }

    /// The same of a pipe that is the main one.
    fn main_angle(contacts: &Contacts, pipe: usize) -> f64 {
        contacts.at[pipe][1] + FRAC_PI_2 - if pipe == 1 { PI } else { 0.0 }
    }

    /// The boosted angle round a pipe that is the branch, and its rate.
    fn boosted(&self, contacts: &Contacts, pipe: usize) -> [f64; 2] {
        let boost = &self.frames[pipe].boosts[0];
        let angle = boost.boosted_angle(Self::branch_angle(contacts, pipe));
        [angle, contacts.rates[pipe][1] / boost.speed(angle)]
    }

    /// Where a ball is on the loop with a pipe as the branch: `k = sin φ/2 / tan(ψ/2)` of the boosted angles round branch and main pipe, and where both
    /// sines may vanish by its quadratic.
    fn node(&self, branch: usize, contacts: &Contacts, [radius, slope]: [f64; 2]) -> Node {
        let frame = &self.frames[branch];
        let [phi, rate] = self.boosted(contacts, branch);
        let main = 1 - branch;
        let psi = frame.boosts[1].boosted_angle(Self::main_angle(contacts, main));
        if psi.cos() > 0.5 {
            let [factor, slope] = frame.factor_of_radius(phi, radius, slope / rate);
            return Node { angle: phi, rate, factor, slope };
        }
        let main_rate = contacts.rates[main][1] / frame.boosts[1].speed(psi);
        let ((sin, cos), (s, c)) = (phi.sin_cos(), (0.5 * psi).sin_cos());
        let factor = 0.5 * sin * c / s;
        Node { angle: phi, rate, factor, slope: 0.5 * cos * c / s - 0.25 * sin / (s * s) * main_rate / rate }
    }

    /// Half a turn about the line that exchanges the axes.
    fn half_turned(&self, patch: CanalPatch) -> CanalPatch {
        let (sin, cos) = self.pair.angle().sin_cos();
        let (half_sin, half_cos) = (0.5 * self.pair.angle()).sin_cos();
        let [x, y, z, w] = &patch.center().0;
        let center = PolynomialRow([
            &(x * cos) + &(y * sin),
            &(x * sin) + &(y * -cos),
            &(w * (2.0 * self.pair.half_gap())) + &(z * -1.0),
            w.clone(),
        ]);
        let turn = QuatPolynomial::constant(Quat::new(0.0, half_cos, half_sin, 0.0));
        let turns = patch.turns().each_ref().map(|q| &turn * q);
        CanalPatch::from_turns(center, patch.radius().clone(), turns)
    }
}

impl MixedPiece {
    /// Canal, half directions and places.
    pub(super) fn forms(&self) -> PieceForms {
        let Self { pair, branch, turned, piece } = self;
        let canal = Canal::new(&pair.frames[*branch], piece, 0.0);
        let forms = &canal.forms;
        // Half angles from those of tees to those of pipes, from where the other pipe is; of the inner contact half a turn on.
        let rotated = |[c, s]: &[Polynomial; 2], angle: f64| {
            let (sin, cos) = (0.5 * angle).sin_cos();
            [&(c * cos) + &(s * -sin), &(s * cos) + &(c * sin)]
        };
        let turned_about = |pipe: usize| if pipe == 1 { PI } else { 0.0 };
        let on_main = rotated(&forms.on_main, turned_about(1 - *branch) - FRAC_PI_2);
        let on_branch = rotated(&forms.on_branch, turned_about(*branch) + FRAC_PI_2);
        let (along_main, along_branch) = (forms.along.clone(), &forms.height * -1.0);
        let down = -pair.pair.half_gap();
        let patch = canal.into_patch();
        let forms = if *branch == 1 {
            PieceForms { patch: patch.exchanged(), halves: [on_main, on_branch], along: [along_main, along_branch] }
        } else {
            PieceForms {
                patch: pair.half_turned(patch),
                halves: [on_branch, on_main],
                along: [along_branch, along_main],
            }
        };
        let forms = PieceForms { patch: forms.patch.moved(Vec3::Z * down), ..forms };
        if *turned { forms.turned() } else { forms }
    }

    /// The same in two parts.
    pub(super) fn halves(&self) -> [Self; 2] {
        let Self { piece, .. } = *self;
        let middle = piece.angle(0.5);
        [piece.part(piece.from, middle), piece.part(middle, piece.to)].map(|piece| Self { piece, ..*self })
    }

    /// How far it turns.
    pub(super) fn size(&self) -> f64 {
        (self.piece.to - self.piece.from).abs()
    }
}

/// Boosted angle round the branch with its rate along the loop, factor and its slope by the angle.
#[derive(Debug, Clone, Copy)]
struct Node {
    angle: f64,
    rate: f64,
    factor: f64,
    slope: f64,
}
