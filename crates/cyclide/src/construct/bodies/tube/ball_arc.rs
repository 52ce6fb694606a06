//! Arcs of balls: conics that are circles in the space of center and radius. Their envelope is a part of a Dupin cyclide
//! (`docs/math/tubes.md#arcs-of-balls`).

use super::ball::{Ball, Way};
use crate::base::vector::Point3;

/// Places of an arc at which it is looked at for folds.
const PLACES: usize = 32;
/// Below this an arc turns too far: its tangents are a third of a turn apart, or two boosts.
const LEAST_COSINE: f64 = -0.5;

/// An arc of balls of less than half a turn, with unit tangents.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BallArc {
    pub(super) ends: [Ball; 2],
    pub(super) tangents: [Way; 2],
    /// From an end along its tangent to the middle control ball.
    reach: f64,
    /// Which piece of the spine, or which pair of balls, it is of.
    pub(super) source: usize,
}

/// A ball of an arc with the tangent there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Station {
    pub(super) ball: Ball,
    pub(super) tangent: Way,
}

impl BallArc {
    /// The arc from a ball along a unit tangent, by the length of its control way.
    pub(super) fn new(ends: [Ball; 2], tangents: [Way; 2], reach: f64, source: usize) -> Self {
        Self { ends, tangents, reach, source }
    }

    /// The straight way between two balls; none where one holds the other.
    pub(super) fn straight(ends: [Ball; 2], source: usize) -> Option<Self> {
        let way = ends[0].to(ends[1]);
        let tangent = way.unit()?;
        Some(Self { ends, tangents: [tangent; 2], reach: 0.5 * way.square().sqrt(), source })
    }

    /// The biarc with these ends and tangents, or one arc where they have one: with equal control ways `d` on all four legs,
    /// `d² (2c - 2) - 2 d <D, S> + <D, D> = 0`. None where there is none.
    pub(super) fn biarc(ends: [Ball; 2], tangents: [Way; 2], source: usize) -> Option<[Self; 2]> {
        let (chord, sum) = (ends[0].to(ends[1]), tangents[0] + tangents[1]);
        let (along, square) = (chord.dot(sum), chord.square());
        // 2 - 2c = <T1 - T0, T1 - T0>
        let root = along * along + square * (tangents[1] - tangents[0]).square();
        if !(square > 0.0 && along > 0.0 && root >= 0.0) {
            return None;
        }
        let reach = square / (along + root.sqrt());
        let first = ends[0].moved(tangents[0] * reach);
        let middle = first.to(ends[1].moved(tangents[1] * -reach));
        let tangent = middle.unit()?;
        let joint = first.moved(middle * 0.5);
        let first = Self::new([ends[0], joint], [tangents[0], tangent], reach, source);
        let second = Self::new([joint, ends[1]], [tangent, tangents[1]], reach, source);
        [&first, &second].into_iter().all(|arc| arc.cosine() > LEAST_COSINE).then_some([first, second])
    }

    fn cosine(&self) -> f64 {
        self.tangents[0].dot(self.tangents[1])
    }

    /// Control balls and weights `1, w, 1`, `w² = (1 + c)/2`.
    fn control(&self) -> ([Ball; 3], [f64; 3]) {
        let middle = self.ends[0].moved(self.tangents[0] * self.reach);
        ([self.ends[0], middle, self.ends[1]], [1.0, (0.5 * (1.0 + self.cosine())).sqrt(), 1.0])
    }

    /// The polar form at two parameters, with its weight: on the diagonal the ball.
    fn polar(&self, [s, t]: [f64; 2]) -> (Ball, f64) {
        let (balls, weights) = self.control();
        let parts = [(1.0 - s) * (1.0 - t), s * (1.0 - t) + t * (1.0 - s), s * t];
        let weighted = [0, 1, 2].map(|i| parts[i] * weights[i]);
        let sum: f64 = weighted.iter().sum();
        // From the first ball: far from the origin digits are kept.
        let way = balls[0].to(balls[1]) * (weighted[1] / sum) + balls[0].to(balls[2]) * (weighted[2] / sum);
        (balls[0].moved(way), sum)
    }

    pub(super) fn ball(&self, s: f64) -> Ball {
        if s >= 1.0 { self.ends[1] } else { self.polar([s, s]).0 }
    }

    pub(super) fn station(&self, s: f64) -> Station {
        let tangent = match s {
            0.0 => self.tangents[0],
            1.0 => self.tangents[1],
            _ => self.polar([0.0, s]).0.to(self.polar([s, 1.0]).0).unit().unwrap_or(self.tangents[0]),
        };
        Station { ball: self.ball(s), tangent }
    }

    /// The conformal length between two parameters, in order: that of the balls as points of the Lorentzian sphere, the integral of the length over the radius. The length grows by
    /// `2 w d/q` over a parameter, with the denominator `q`, and the radius is `(a, b, c)/q`, so that it is elementary.
    pub(super) fn conformal_length(&self, [s, t]: [f64; 2]) -> f64 {
        let ([first, middle, last], [_, w, _]) = self.control();
        let [a, b, c] = [first.radius, middle.radius * w, last.radius];
        let form = a * (1.0 - s) * (1.0 - t) + b * (s * (1.0 - t) + t * (1.0 - s)) + c * s * t;
        let (step, square) = (t - s, b * b - a * c);
        let root = square.abs().sqrt();
        let quotient = if square * step * step < -1e-12 * form * form {
            (root * step).atan2(form) / root
        } else if square * step * step > 1e-12 * form * form {
            (root * step / form).atanh() / root
        } else {
            step / form
        };
        2.0 * w * self.reach * quotient
    }

    /// No ball between two parameters is farther than this from those of the same part of the straight way.
    pub(super) fn sagitta(&self, [s, t]: [f64; 2]) -> f64 {
        let ([a, b], (middle, weight)) = ([s, t].map(|v| self.polar([v, v])), self.polar([s, t]));
        let w = weight / (a.1 * b.1).sqrt();
        let between = Ball::new(a.0.center.midpoint(b.0.center), 0.5 * (a.0.radius + b.0.radius));
        w / (1.0 + w) * middle.distance(between)
    }

    /// The least and the largest radius of its balls: at its ends, or where the derivative of a quotient of quadratics is zero.
    pub(super) fn radii(&self) -> [f64; 2] {
        let ([first, middle, last], [_, w, _]) = self.control();
        let [r0, r1, r2] = [first.radius, middle.radius * w, last.radius];
        let ends = [r0.min(r2), r0.max(r2)];
        // With x = s/(1 - s): c x² + 2 b x + a = 0.
        let [a, b, c] = [r1 - w * r0, 0.5 * (r2 - r0), w * r2 - r1];
        let square = b * b - a * c;
        if !(square >= 0.0) {
            return ends;
        }
        let sum = -b - square.sqrt().copysign(b);
        let roots = [sum / c, a / sum];
        let inside = roots.into_iter().filter(|x| *x > 0.0 && x.is_finite()).map(|x| self.ball(x / (1.0 + x)).radius);
        inside.fold(ends, |[low, high], r| [low.min(r), high.max(r)])
    }

    /// How much of its width the envelope has left where least is, and the place: 1 where it is straight, 0 where it folds. With the outward
    /// normal `a` and the bend `K` across the tangent it is `1 - R (a·K_v + K_r)`.
    pub(super) fn left(&self) -> (f64, f64) {
        let c = self.cosine();
        let bend = (self.tangents[1] - self.tangents[0] * c) * (1.0 / (self.reach * (1.0 + c)));
        let at = |s: f64| {
            let Station { ball, tangent } = self.station(s);
            let bend = bend.carried([self.tangents[0], tangent]);
            let (along, size) = (tangent.v.unit().unwrap_or(tangent.v), tangent.v.length());
            let across = bend.v - along * bend.v.dot(along);
            let most = -tangent.r / size * bend.v.dot(along) + across.length() / size + bend.r;
            (1.0 - ball.radius * most, s)
        };
        (0..=PLACES)
            .map(|k| at(k as f64 / PLACES as f64))
            .fold((f64::INFINITY, 0.0), |least, one| if one.0 < least.0 { one } else { least })
    }

    /// Largest coordinate or radius: what rounding is relative to.
    pub(super) fn centers(&self) -> [Point3; 2] {
        self.ends.map(|ball| ball.center)
    }
}
