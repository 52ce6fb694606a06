//! How near the blend of a law comes to folding, by the balls of the law itself, and how near to that its loop has to come
//! (`docs/math/pipe-crossings.md#folds`).
//!
//! The pieces of a loop have the places and directions of the law at their ends. They bend as it does less closely than they keep to its radius, and what
//! bends too much folds: the radius alone tells nothing of that.

use super::balls::Balls;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::tight_place::TightPlace;
use crate::error::FoldRemedy;
use std::f64::consts::TAU;

/// Step by the angle for second differences of axes at right angles: truncation and rounding are below 1e-6 of them. Of axes that are nearly parallel the blend is long, and
/// all that happens at its ends happens within as small an angle as they are apart.
const STEP: f64 = 1e-4;
/// Parts of a turn over which the law's least width is looked for.
const PARTS: u32 = 24;
/// Places of a span, beside its start, at which a loop is held against the law.
const PLACES: u32 = 8;
/// The least width of a loop is that of its law to this part of it; with a tolerance that is asked for the loop is not to fold where the law does not.
const CLOSE: f64 = 0.05;
const NOT_FOLDED: f64 = 0.9;
/// Less than this counts for nothing, in parts of the width on a straight way.
const FINEST: f64 = 1e-3;
/// Spans that are shorter, in radians, are not halved for their width.
const SHORTEST: f64 = 2e-3;
/// Radii are changed by this part of them to see which way is the better one.
const CHANGE: f64 = 0.02;

/// What the width of a loop has to be near to.
#[derive(Debug, Clone, Copy)]
pub(super) struct LawFold {
    /// How much larger the balls are than those of the loop.
    depth: f64,
    /// The least width of the blend of the law.
    pub(super) left: f64,
    /// What the loop's may be off it.
    allowed: f64,
}

/// A ball of the law, radius negative inside both pipes.
struct LawBall {
    center: Vec3,
    radius: f64,
    /// From both contacts to the center, over the radius.
    normals: [Vec3; 2],
}

impl LawFold {
    /// By the law of balls that are to be larger by a depth; none if the law folds, or has no balls in places.
    pub(super) fn new(balls: &Balls<'_>, depth: f64) -> Option<Self> {
        let left = least(balls, 1.0, depth);
        let close = if balls.tolerance.is_some() { NOT_FOLDED } else { CLOSE };
        let allowed = (close * left).max(FINEST.min(NOT_FOLDED * left));
        (left > 0.0).then_some(Self { depth, left, allowed })
    }

    /// Whether the least width of a loop over a span is near enough to that of the law there, if it is `left` there.
    pub(super) fn is_met(&self, balls: &Balls<'_>, [from, to]: [f64; 2], left: f64) -> bool {
        if to - from < SHORTEST {
            return true;
        }
        let places = (0..=PLACES).map(|k| from + (to - from) * f64::from(k) / f64::from(PLACES));
        let of_law = places.filter_map(|angle| width(balls, 1.0, self.depth, angle)).fold(f64::INFINITY, f64::min);
        // Where there is more than the least width it does not matter how much.
        let most = self.left + self.allowed;
        (left.min(most) - of_law.min(most)).abs() <= self.allowed
    }

    /// The least width of a piece, at the places where the law is looked at.
    pub(super) fn of_piece(&self, patch: &crate::surface::CanalPatch) -> f64 {
        let canal = patch.offset(self.depth);
        (0..=PLACES).map(|k| canal.least_jacobian(f64::from(k) / f64::from(PLACES))).fold(f64::INFINITY, f64::min)
    }

    /// What helps against a fold: of balls a little larger and a little smaller those that have more room; where the law does not fold, keeping closer to it.
    pub(super) fn remedy(of_law: Option<&Self>, balls: &Balls<'_>, depth: f64) -> FoldRemedy {
        if of_law.is_some() {
            return FoldRemedy::FinerTolerance;
        }
        let [larger, smaller] = [1.0 + CHANGE, 1.0 - CHANGE].map(|scale| least(balls, scale, depth));
        if larger > smaller { FoldRemedy::LargerBall } else { FoldRemedy::SmallerBall }
    }
}

/// The least width once round, of radii this many times as large; without end below zero where there is no ball.
fn least(balls: &Balls<'_>, scale: f64, depth: f64) -> f64 {
    let (part, half) = (TAU / f64::from(PARTS), 0.5 * balls.axes_angle());
    let all = (0..PARTS).fold(TightPlace::NONE, |least, k| {
        // Even parts seen along the axes as if these were at right angles.
        let angle = |s: f64| {
            let (sin, cos) = (part * (f64::from(k) + s)).sin_cos();
            half + (half.tan() * sin).atan2(cos)
        };
        least.or_of_piece(|s| width(balls, scale, depth, angle(s)).unwrap_or(f64::NEG_INFINITY), angle)
    });
    all.left
}

/// The least Jacobian of the canal over the characteristic arc of the ball at an angle: `1 - (R'² + R R'' - R n·m'')/|m'|²` with the normals n from contact to contact.
fn width(balls: &Balls<'_>, scale: f64, depth: f64, angle: f64) -> Option<f64> {
    let step = STEP * balls.axes_angle().sin();
    let [before, at, behind] = [-step, 0.0, step].map(|step| balls.law_ball(scale, angle + step));
    let (before, at, behind) = (before?, at?, behind?);
    let (motion, slope) =
        ((behind.center - before.center) / (2.0 * step), (behind.radius - before.radius) / (2.0 * step));
    let second = |a: f64, b: f64, c: f64| ((c - b) - (b - a)) / (step * step);
    let bend = ((behind.center - at.center) - (at.center - before.center)) / (step * step);
    let (square, radius) = (motion.length_squared(), at.radius + depth);
    let along = motion.unit()?;
    // The normals from the first on, about the way of the center: the way round to the second is the shorter one.
    let [first, last] = at.normals.map(|normal| normal - along * normal.dot(along));
    let (start, aside) = (first.unit()?, along.cross(first.unit()?));
    let sweep = last.dot(aside).atan2(last.dot(start));
    let [p, q] = [start, aside].map(|side| first.length() * side.dot(bend) * radius);
    let value = |turn: f64| p * turn.cos() + q * turn.sin();
    let lowest = (-q).atan2(-p);
    let inside = lowest * sweep > 0.0 && lowest.abs() < sweep.abs();
    let least = if inside { value(lowest) } else { value(0.0).min(value(sweep)) };
    let fixed = radius * at.normals[0].dot(along) * along.dot(bend);
    let growth = second(before.radius, at.radius, behind.radius);
    Some(1.0 - (slope * slope + radius * growth - fixed - least) / square)
}

impl Balls<'_> {
    /// From the first axis to the second.
    fn axes_angle(&self) -> f64 {
        let [first, second] = self.mantles.map(|mantle| mantle.along);
        first.cross(second).length().atan2(first.dot(second))
    }

    /// The ball at an angle.
    fn law_ball(&self, scale: f64, angle: f64) -> Option<LawBall> {
        let [asked, slope] = self.law.at(angle).map(|x| scale * x);
        let touching = self.contacts_of([asked, slope], angle).ok()?.at;
        let radius = if self.mixed.is_some() { asked } else { self.side.sign() * asked };
        let contacts: [(Point3, Vec3); 2] = [0, 1].map(|pipe: usize| {
            let ([along, turn], mantle) = (touching[pipe], &self.mantles[pipe]);
            let ((s, c), (sin, cos)) = ((0.5 * turn).sin_cos(), mantle.taper.sin_cos());
            let outwards = mantle.direction([c, s]) * cos + mantle.along * sin;
            (mantle.point([c, s], along), outwards)
        });
        let [(first, outwards), (second, _)] = contacts;
        let center = first + outwards * radius;
        Some(LawBall { center: center.to_vec(), radius, normals: [outwards, (center - second) / radius] })
    }
}
