//! Laws of the radius of the ball round a branch, and the loops that follow them.

use super::canal::Canal;
use super::crossing::Crossing;
use super::loop_piece::LoopPiece;
use crate::error::{Error, ErrorItem, Result};
use crate::rational::Polynomial;
use std::f64::consts::{FRAC_PI_4, TAU};

/// Pieces of a loop at most.
const MOST_PIECES: usize = 2048;
/// Angles nearer to each other than this are one.
const SAME_ANGLE: f64 = 1e-9;
/// A blend of one radius keeps it to this part of it where no tolerance is given.
const DEFAULT_TOLERANCE: f64 = 1e-3;
/// Places of a loop at which its least ball is looked for, and steps in which it is found.
const PLACES: u32 = 32;
const HALVINGS: u32 = 60;

/// The radius of the ball that blends a branch with its main pipe.
///
/// Angles are counted round the branch, from the side of the end of the main pipe towards its `sideways` direction, so that the crotches of a branch are at
/// 0 and π, its flanks at π/2 and -π/2. Every loop is exact: the ball touches both pipes everywhere.
///
/// ```
/// use cyclide::{PipeTee, TeeBlend, TeeBranch, TeeMain};
/// let main = TeeMain { radius: 3.0, ends: [-12.0, 12.0] };
/// let tee = |blend| PipeTee::new(main, vec![TeeBranch { blend, ..TeeBranch::upright(1.0, 10.0, 0.5) }]);
/// let [least, most] = tee(TeeBlend::Radius { radius: 0.5, tolerance: Some(1e-4) })?.made()?.blends[0].radii;
/// assert!(least >= 0.4999 && most <= 0.5001);
/// let [least, most] = tee(TeeBlend::Least(0.5))?.made()?.blends[0].radii;
/// assert!((least - 0.5).abs() < 1e-12 && most > 0.6);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum TeeBlend {
    /// A ball of one radius: as nearly as this tolerance says, a thousandth of the radius by default. A loop of one radius is not rational.
    Radius {
        /// The radius.
        radius: f64,
        /// Largest difference from it.
        tolerance: Option<f64>,
    },
    /// The ball has these radii at these angles, in any order, and changes smoothly between them, from one to the next without passing either.
    Angles(Vec<[f64; 2]>),
    /// The plainest loop, one quartic all round: this radius at the flank where it is least, and the larger ones in the crotches that follow from it.
    Least(f64),
}

impl TeeBlend {
    /// The loop that follows the law, from boosted angle 0 round to 2π.
    ///
    /// # Errors
    /// `radius-not-positive`, `not-finite`, `tolerance-not-positive`, `tee-blend-too-large`, `not-within-tolerance`, `coincident-points`.
    pub(super) fn pieces(&self, crossing: &Crossing) -> Result<Vec<LoopPiece>> {
        match self {
            Self::Radius { radius, tolerance } => {
                check_radius(*radius, 0)?;
                let tolerance = tolerance.unwrap_or(DEFAULT_TOLERANCE * radius);
                if !(tolerance > 0.0) {
                    return Err(Error::ToleranceNotPositive { tolerance });
                }
                near(crossing, *radius, tolerance)
            }
            Self::Angles(values) => along(crossing, &Law::new(values)?),
            Self::Least(radius) => {
                check_radius(*radius, 0)?;
                quartic(crossing, *radius)
            }
        }
    }
}

fn check_radius(radius: f64, index: usize) -> Result<()> {
    if !radius.is_finite() {
        return Err(Error::NotFinite { what: ErrorItem::Radius, index });
    }
    if radius <= 0.0 {
        return Err(Error::RadiusNotPositive { radius });
    }
    Ok(())
}

/// One form all round, whose least ball has the radius. Balls shrink as the form grows.
fn quartic(crossing: &Crossing, radius: f64) -> Result<Vec<LoopPiece>> {
    let mut low = crossing.least_factor();
    let limit = least_of_form(crossing, low);
    if !(radius < limit) {
        return Err(Error::TeeBlendTooLarge { branch: crossing.branch, radius, limit });
    }
    let mut high = 2.0 * low;
    while least_of_form(crossing, high) > radius && high.is_finite() {
        high *= 2.0;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if least_of_form(crossing, middle) > radius { low = middle } else { high = middle }
    }
    let factor = 0.5 * (low + high);
    let at = |k: u32| f64::from(k) * FRAC_PI_4;
    Ok((0..8).map(|k| LoopPiece::constant(at(k), at(k + 1), factor)).collect())
}

/// The least radius of the balls of a loop with one form.
fn least_of_form(crossing: &Crossing, factor: f64) -> f64 {
    let radius = |angle: f64| crossing.radius_of_factor(angle, factor);
    let step = TAU / f64::from(PLACES);
    let least = (0..PLACES).map(|k| f64::from(k) * step).min_by(|a, b| radius(*a).total_cmp(&radius(*b)));
    // The least of a smooth function between three places, by thirds.
    let (mut low, mut high) = least.map_or((0.0, 0.0), |at| (at - step, at + step));
    for _ in 0..HALVINGS {
        let third = (high - low) / 3.0;
        if radius(low + third) < radius(high - third) { high -= third } else { low += third }
    }
    radius(0.5 * (low + high))
}

/// A ball of one radius within a tolerance: spans are halved until the bound is proved.
fn near(crossing: &Crossing, radius: f64, tolerance: f64) -> Result<Vec<LoopPiece>> {
    let node = |angle: f64| crossing.factor_of_radius(angle, radius, 0.0);
    let mut left: Vec<[f64; 2]> =
        (0..8).rev().map(|k| [f64::from(k) * FRAC_PI_4, f64::from(k + 1) * FRAC_PI_4]).collect();
    let mut pieces: Vec<LoopPiece> = Vec::new();
    while let Some([from, to]) = left.pop() {
        let span = LoopPiece::hermite([from, to], [node(from), node(to)]);
        let off =
            span.iter().map(|piece| radii_of(crossing, piece)).map(|[low, high]| (radius - low).max(high - radius));
        let off = off.fold(0.0, f64::max);
        if off <= tolerance {
            pieces.extend(span);
            continue;
        }
        let middle = 0.5 * (from + to);
        if pieces.len() + 2 * left.len() + 4 > MOST_PIECES || !(from < middle && middle < to) {
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
    Ok(pieces)
}

/// A ball whose radius follows a law through its values.
fn along(crossing: &Crossing, law: &Law) -> Result<Vec<LoopPiece>> {
    let mut angles: Vec<f64> =
        law.values.iter().map(|[angle, _, _]| crossing.boosted_angle(*angle).rem_euclid(TAU)).collect();
    angles.sort_by(f64::total_cmp);
    let first = angles[0];
    angles.push(first + TAU);
    let node = |angle: f64| {
        let at = crossing.true_angle(angle);
        let [radius, slope] = law.at(at);
        crossing.factor_of_radius(angle, radius, slope * crossing.boosts[0].speed(angle))
    };
    let mut pieces = Vec::new();
    for ends in angles.windows(2) {
        let count = ((ends[1] - ends[0]) / FRAC_PI_4 - SAME_ANGLE).ceil().max(1.0);
        let cut = |k: f64| ends[0] + (ends[1] - ends[0]) * k / count;
        for k in 0..count as usize {
            let [from, to] = [cut(k as f64), cut((k + 1) as f64)];
            pieces.extend(LoopPiece::hermite([from, to], [node(from), node(to)]));
        }
    }
    Ok(pieces)
}

/// The least and the largest radius on a piece, to a bound that is proved: quotients of Bernstein coefficients.
pub(super) fn radii_of(crossing: &Crossing, piece: &LoopPiece) -> [f64; 2] {
    const PARTS: usize = 4;
    let cut = |k: usize| piece.from + (piece.to - piece.from) * k as f64 / PARTS as f64;
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    for k in 0..PARTS {
        let canal = Canal::new(crossing, &piece.part(cut(k), cut(k + 1)), 0.0);
        let (radius, weight) = (canal.radius(), &canal.forms.weight);
        for (r, w) in paired(radius, weight) {
            let value = if w > 0.0 { r / w } else { f64::NAN };
            if !value.is_finite() {
                return [f64::NEG_INFINITY, f64::INFINITY];
            }
            range = [range[0].min(value), range[1].max(value)];
        }
    }
    range
}

fn paired<'a>(a: &'a Polynomial, b: &'a Polynomial) -> impl Iterator<Item = (f64, f64)> + 'a {
    a.coefficients().iter().copied().zip(b.coefficients().iter().copied())
}

/// A law through values at angles: cubic between them, flat at least and largest values, so that it passes none of them.
struct Law {
    /// Angle in `[0, 2π)`, radius, slope; ascending.
    values: Vec<[f64; 3]>,
}

impl Law {
    fn new(given: &[[f64; 2]]) -> Result<Self> {
        if given.is_empty() {
            return Err(Error::TooFewPoints { given: 0, needed: 1 });
        }
        for (index, [angle, radius]) in given.iter().enumerate() {
            if !angle.is_finite() {
                return Err(Error::NotFinite { what: ErrorItem::Angle, index });
            }
            check_radius(*radius, index)?;
        }
        let mut order: Vec<usize> = (0..given.len()).collect();
        let turned = |k: usize| given[k][0].rem_euclid(TAU);
        order.sort_by(|&a, &b| turned(a).total_cmp(&turned(b)));
        let count = order.len();
        let gap = |k: usize| {
            let (from, to) = (turned(order[k]), turned(order[(k + 1) % count]));
            if k + 1 == count { to + TAU - from } else { to - from }
        };
        for k in 0..count {
            if count > 1 && gap(k) <= SAME_ANGLE {
                let (first, second) = (order[k], order[(k + 1) % count]);
                let (first, second) = (first.min(second), first.max(second));
                return Err(Error::CoincidentPoints { first, second, distance: gap(k), limit: SAME_ANGLE });
            }
        }
        let chord = |k: usize| (given[order[(k + 1) % count]][1] - given[order[k]][1]) / gap(k);
        let slope = |k: usize| {
            let before = (k + count - 1) % count;
            let (left, right) = (chord(before), chord(k));
            if left * right <= 0.0 {
                return 0.0;
            }
            // The weighted harmonic mean, which keeps cubics between their ends.
            let (a, b) = (2.0 * gap(k) + gap(before), gap(k) + 2.0 * gap(before));
            (a + b) / (a / left + b / right)
        };
        Ok(Self { values: (0..count).map(|k| [turned(order[k]), given[order[k]][1], slope(k)]).collect() })
    }

    /// Radius and slope at an angle.
    fn at(&self, angle: f64) -> [f64; 2] {
        let count = self.values.len();
        let angle = angle.rem_euclid(TAU);
        let next = self.values.iter().position(|[a, _, _]| *a > angle).unwrap_or(0);
        let [a1, r1, s1] = self.values[next];
        let [a0, r0, s0] = self.values[(next + count - 1) % count];
        let mut gap = (a1 - a0).rem_euclid(TAU);
        if gap == 0.0 {
            gap = TAU;
        }
        let x = (angle - a0).rem_euclid(TAU) / gap;
        let (d, y) = (r1 - r0, 1.0 - x);
        let radius = r0 + d * x * x * (3.0 - 2.0 * x) + gap * x * y * (s0 * y - s1 * x);
        let slope = (6.0 * d * x * y) / gap + s0 * y * (1.0 - 3.0 * x) + s1 * x * (1.0 - 3.0 * y);
        [radius, slope]
    }
}
