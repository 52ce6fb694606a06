//! Laws of the radius of the ball round a branch, and the loops that follow them.

use super::blend::TeeBlend;
use super::canal::Canal;
use super::crossing::Crossing;
use super::equal;
use super::loop_piece::{Loop, LoopPiece};
use crate::construct::bodies::angle_law::{Law, SAME_ANGLE, check_radius};
use crate::construct::bodies::halving::Halving;
use crate::error::{Result, TeeError, check_tolerance};
use crate::rational::Polynomial;
use std::f64::consts::{FRAC_PI_4, TAU};

/// Pieces of a loop at most.
const HALVING: Halving =
    Halving { what: "the loop of the ball", cap: 2048, least: 0.0, remedy: "use a larger tolerance" };
/// What else helps where the radius changes; where the branch leaves less than this part of the width of the main pipe; and both.
const OF_LAW: &str = "use a larger tolerance, or a law that changes less";
const NEARLY_EQUAL: f64 = 0.01;
const OF_NEARLY_EQUAL: &str =
    "use a larger tolerance, or a thinner branch: this one is nearly as wide as the main pipe, which takes the pieces";
const OF_LAW_ON_NEARLY_EQUAL: &str = "use a larger tolerance, a law that changes less, or a thinner branch: this one is nearly as wide as the main pipe, which takes pieces";
/// A blend keeps to its law to this part of the radius where no tolerance is given.
const DEFAULT_TOLERANCE: f64 = 1e-3;
/// Places of a loop at which its least ball is looked for, and steps in which it is found.
const PLACES: u32 = 32;
const HALVINGS: u32 = 60;
/// Halvings of a piece for the proof that its balls have positive radii.
const PROOF_HALVINGS: u32 = 12;
/// Places of a piece at which its radius is compared with the law.
const PLACES_OF_PIECE: u32 = 8;
/// What is a rounding of a derivative, in parts of its two terms.
const ROUNDING: f64 = 1e-12;

impl TeeBlend {
    /// The loop that follows the law, from boosted angle 0 round to 2π.
    ///
    /// # Errors
    /// `radius-not-positive`, `not-finite`, `tolerance-not-positive`, `tee-blend-too-large`, `too-many-pieces`, `coincident-points`, `tee-law-on-equal-pipes`.
    pub(super) fn pieces(&self, crossing: &Crossing) -> Result<Loop> {
        if crossing.equal {
            return equal::pieces(crossing, self);
        }
        match self {
            Self::Radius { radius, tolerance } => along(crossing, &Law::new(&[[0.0, *radius]])?, *tolerance),
            Self::Angles { values, tolerance } => along(crossing, &Law::new(values)?, *tolerance),
            Self::Least(radius) => {
                check_radius(*radius, 0)?;
                quartic(crossing, *radius)
            }
        }
    }
}

/// One form all round, whose least ball has the radius. Balls shrink as the form grows.
fn quartic(crossing: &Crossing, radius: f64) -> Result<Loop> {
    let mut low = crossing.least_factor();
    let limit = least_of_form(crossing, low);
    if !(radius < limit) {
        return Err(TeeError::BlendTooLarge { branch: crossing.branch, radius, limit }.into());
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
    let mut pieces = Vec::new();
    for k in 0..8 {
        add_proved(crossing, LoopPiece::constant(at(k), at(k + 1), factor), PROOF_HALVINGS, &mut pieces);
    }
    Ok(Loop { pieces, deviation: 0.0 })
}

/// Adds a piece in parts of which each is proved to have positive radii.
fn add_proved(crossing: &Crossing, piece: LoopPiece, halvings: u32, to: &mut Vec<LoopPiece>) {
    if halvings == 0 || radii_of(crossing, &piece)[0] > 0.0 {
        to.push(piece);
        return;
    }
    let middle = 0.5 * (piece.from + piece.to);
    add_proved(crossing, piece.part(piece.from, middle), halvings - 1, to);
    add_proved(crossing, piece.part(middle, piece.to), halvings - 1, to);
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

/// A loop whose radius follows a law: spans are halved until it does within the tolerance.
fn along(crossing: &Crossing, law: &Law, tolerance: Option<f64>) -> Result<Loop> {
    if let Some(tolerance) = tolerance {
        check_tolerance(tolerance)?;
    }
    let follow = Follow { crossing, law, tolerance };
    let mut made = Loop { pieces: Vec::new(), deviation: 0.0 };
    let is_law = {
        let [least, most] = law.range();
        least < most
    };
    let remedy = match (is_law, crossing.unit < NEARLY_EQUAL * crossing.radii[1]) {
        (false, false) => HALVING.remedy,
        (true, false) => OF_LAW,
        (false, true) => OF_NEARLY_EQUAL,
        (true, true) => OF_LAW_ON_NEARLY_EQUAL,
    };
    let halving = Halving { remedy, ..HALVING };
    for span in follow.spans() {
        halving.extend(&mut made.pieces, span, |part| {
            let pieces = LoopPiece::hermite(part, part.map(|angle| follow.node(angle)));
            let Some(deviation) = follow.deviation(&pieces) else { return Ok(None) };
            made.deviation = made.deviation.max(deviation);
            Ok(Some(pieces.to_vec()))
        })?;
    }
    Ok(made)
}

/// A loop that is to follow a law.
struct Follow<'a> {
    crossing: &'a Crossing,
    law: &'a Law,
    tolerance: Option<f64>,
}

impl Follow<'_> {
    /// What the radius may be off one that is asked for.
    fn allowed(&self, radius: f64) -> f64 {
        self.tolerance.unwrap_or(DEFAULT_TOLERANCE * radius)
    }

    /// The spans that are looked at first: none across a value of the law.
    fn spans(&self) -> Vec<[f64; 2]> {
        let mut angles: Vec<f64> =
            self.law.angles().map(|angle| self.crossing.boosted_angle(angle).rem_euclid(TAU)).collect();
        angles.sort_by(f64::total_cmp);
        angles.push(angles[0] + TAU);
        let mut spans = Vec::new();
        for ends in angles.windows(2) {
            let count = ((ends[1] - ends[0]) / FRAC_PI_4 - SAME_ANGLE).ceil().max(1.0);
            let cut = |k: usize| ends[0] + (ends[1] - ends[0]) * k as f64 / count;
            spans.extend((0..count as usize).map(|k| [cut(k), cut(k + 1)]));
        }
        spans
    }

    /// The law at a boosted angle, with its derivative by that.
    fn at(&self, boosted: f64) -> [f64; 2] {
        let [radius, slope] = self.law.at(self.crossing.true_angle(boosted));
        [radius, slope * self.crossing.boosts[0].speed(boosted)]
    }

    /// Factor of the loop, and its derivative.
    fn node(&self, boosted: f64) -> [f64; 2] {
        let [radius, slope] = self.at(boosted);
        self.crossing.factor_of_radius(boosted, radius, slope)
    }

    /// How far the radius of a span is from the law, where that is within the tolerance and the radius rises and falls with it. That no radius leaves the
    /// values at its ends by more than the tolerance is proved; between them it is looked at in places close together.
    fn deviation(&self, pieces: &[LoopPiece; 2]) -> Option<f64> {
        let ends = [pieces[0].from, pieces[1].to].map(|angle| self.at(angle)[0]);
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let allowed = self.allowed(low);
        let mut most: f64 = 0.0;
        for piece in pieces {
            let [least, largest] = radii_of(self.crossing, piece);
            let beyond = (low - least).max(largest - high);
            if !(least > 0.0 && beyond <= allowed) {
                return None;
            }
            most = most.max(beyond);
            for k in 1..=PLACES_OF_PIECE {
                let angle = piece.angle(f64::from(k) / f64::from(PLACES_OF_PIECE));
                let radius = self.crossing.radius_of_factor(angle, piece.factor(angle));
                let asked = self.at(angle)[0];
                if !((radius - asked).abs() <= self.allowed(asked)) {
                    return None;
                }
                most = most.max((radius - asked).abs());
            }
        }
        let middle = self.crossing.true_angle(0.5 * (pieces[0].from + pieces[1].to));
        let (rise, radius) = self.law.rise(middle);
        let rises = rise.abs() > 2.0 * self.allowed(radius);
        if rises && !pieces.iter().all(|piece| self.is_monotone(piece, rise.signum())) {
            return None;
        }
        Some(most)
    }

    /// Whether the radius of a piece goes one way only, by the Bernstein coefficients of its derivative.
    fn is_monotone(&self, piece: &LoopPiece, sign: f64) -> bool {
        parts(piece).all(|part| {
            let canal = Canal::new(self.crossing, &part, 0.0);
            let (radius, weight) = (canal.radius(), &canal.forms.weight);
            let size = |p: &Polynomial| p.coefficients().iter().fold(0.0, |most: f64, c| most.max(c.abs()));
            let rounding = ROUNDING * size(radius) * size(weight);
            let (first, second) = (&derivative(radius) * weight, radius * &derivative(weight));
            first.coefficients().iter().zip(second.coefficients()).all(|(a, b)| (a - b) * sign >= -rounding)
        })
    }
}

fn derivative(p: &Polynomial) -> Polynomial {
    let n = p.degree() as f64;
    let steps: Vec<f64> = p.coefficients().windows(2).map(|pair| n * (pair[1] - pair[0])).collect();
    if steps.is_empty() { Polynomial::constant(0.0) } else { Polynomial::new(steps) }
}

/// A piece in parts, of which bounds are nearer.
fn parts(piece: &LoopPiece) -> impl Iterator<Item = LoopPiece> {
    const PARTS: usize = 4;
    let piece = *piece;
    let cut = move |k: usize| piece.from + (piece.to - piece.from) * k as f64 / PARTS as f64;
    (0..PARTS).map(move |k| piece.part(cut(k), cut(k + 1)))
}

/// The least and the largest radius on a piece, to a bound that is proved: quotients of Bernstein coefficients.
pub(super) fn radii_of(crossing: &Crossing, piece: &LoopPiece) -> [f64; 2] {
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    for part in parts(piece) {
        let canal = Canal::new(crossing, &part, 0.0);
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
