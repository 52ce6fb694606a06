//! The smoother of measured points: Whittaker's, stiffer where the curve varies less, its strength chosen by generalized
//! cross-validation of the residuals across the curve (`docs/math/fair-fits.md#noise`).

use super::super::density::point_at;
use super::super::whittaker::Smoother;
use super::chords::{above_shortest, chords, robust_chords};
use super::residuals::{Residual, residuals, scale};
use crate::base::vector::{Point3, Vec3};
use std::ops::Range;

/// Fewer points than this are not smoothed: they say nothing about noise.
pub(super) const FEWEST: usize = 8;
/// Weight of a degree of freedom in the cross-validation: above 1 it does not take noise for shape by chance.
const CAUTION: f64 = 1.4;
/// The same where the noise is known from elsewhere.
const PRUDENCE: f64 = 4.0;
/// Part of the points that must be left to errors, beside that; where the noise is known, in all.
const LEFT: f64 = 0.05;
const LEFT_IF_KNOWN: f64 = 0.02;
/// Exponents of the strength, in fifth powers of the mean chord, and their step; the softest where the noise is known: there
/// the curve may run through the points.
const SOFTEST: f64 = -4.0;
const SOFTEST_IF_KNOWN: f64 = -8.0;
const STIFFEST: f64 = 12.0;
const STEP: f64 = 0.5;
const FINE_STEP: f64 = 0.1;
/// Exponents beside the last choice that are tried again.
const NEAR: f64 = 1.5;
/// Data that want more than this are averaged in pairs first.
const DENSE: f64 = 9.5;
/// Averaged data are not fewer than this.
const FEWEST_GROUPS: usize = 96;
/// Rounds, of which the first are robust.
const ROUNDS: usize = 7;
const ROBUST: usize = 3;
/// Residuals above this many deviations have no weight in the robust rounds; above the second they count as that.
const FAR: f64 = 5.0;
const CLIPPED: f64 = 3.0;
/// Weight of a point without any.
const NONE: f64 = 1e-6;
/// Weight of an end that stays.
const FIXED: f64 = 1e8;
/// How the stiffness follows what varies: even for bends all along, sharper for straight runs and corners. What cross-validation
/// prefers is taken.
const ADAPTIONS: [Adaption; 2] = [Adaption { calm: 1e2, reach: 1.0 }, Adaption { calm: 1e5, reach: 0.3 }];

/// Data of one smooth piece.
#[derive(Clone, Copy)]
pub(super) struct Series<'a> {
    pub points: &'a [Point3],
    pub closed: bool,
    pub fixed: [bool; 2],
    /// Directions across the curve: 1 in a plane and of heights, 2 in space.
    pub directions: usize,
    /// Lengths that are known; then the residuals have no part along the curve.
    pub chords: Option<&'a [f64]>,
    /// The deviation to reach, where it is known.
    pub noise: Option<f64>,
    /// The deviation that the errors have as all runs of the data say, which the strength is chosen by.
    pub common: Option<f64>,
    /// Weights of the points, 1 of most.
    pub weights: Option<&'a [f64]>,
}

/// Smoothed data.
pub(super) struct Smoothed {
    pub points: Vec<Point3>,
    /// Standard deviation of the errors across the curve, in one direction.
    pub deviation: f64,
    /// Degrees of freedom of the smoothed curve in one direction.
    pub freedom: f64,
    /// Robust deviations across and along the curve.
    pub across: f64,
    pub along: f64,
    pub residuals: Vec<Residual>,
}

/// How the stiffness follows what varies.
#[derive(Clone, Copy)]
struct Adaption {
    /// Its largest ratio between calm and lively places.
    calm: f64,
    /// It is looked at round about as far as this part of the smoother's length.
    reach: f64,
}

impl Adaption {
    /// Stiffness for each third difference: the less it varies round about, the stiffer. Their geometric mean is 1.
    fn stiffness(self, variations: &[f64], length: f64, closed: bool) -> Vec<f64> {
        let n = variations.len();
        let reach = ((self.reach * length) as usize).clamp(1, (n / 2).saturating_sub(1).max(1));
        let at = |k: isize| {
            let k = if closed { k.rem_euclid(n as isize) } else { k.clamp(0, n as isize - 1) };
            variations[k as usize]
        };
        let mut sum: f64 = (-(reach as isize)..=reach as isize).map(at).sum();
        let mut means = Vec::with_capacity(n);
        for k in 0..n as isize {
            means.push((sum / (2 * reach + 1) as f64).max(0.0));
            sum += at(k + 1 + reach as isize) - at(k - reach as isize);
        }
        let mean = means.iter().sum::<f64>() / n as f64;
        if !(mean > 0.0 && mean.is_finite()) {
            return vec![1.0; n];
        }
        let mut stiffness: Vec<f64> = means.iter().map(|m| mean / (m + mean / self.calm)).collect();
        let level = (stiffness.iter().map(|s| s.ln()).sum::<f64>() / n as f64).exp();
        stiffness.iter_mut().for_each(|s| *s /= level);
        stiffness
    }
}

/// One strength tried.
struct Choice {
    exponent: f64,
    points: Vec<Point3>,
    freedom: f64,
    squares: f64,
    residuals: Vec<Residual>,
}

impl Choice {
    /// What the choices for the same data are compared by, the less the better: generalized cross-validation, with distances that
    /// stand out clipped; where the noise is known all leave as much, and the least free is best.
    fn validation(&self, data: &Series<'_>) -> f64 {
        if data.noise.is_some() {
            return self.freedom;
        }
        let limit = CLIPPED * scale(self.residuals.iter().map(|r| r.across), data.directions);
        let given = |i: usize| data.weights.map_or(1.0, |w| w[i]);
        let squares: f64 = self.residuals.iter().enumerate().map(|(i, r)| given(i) * r.across.min(limit).powi(2)).sum();
        score(data, squares, self.freedom, self.points.len() as f64)
    }
}

/// Smooths the data as their noise asks; `None` where they are too few.
pub(super) fn smoothed(data: &Series<'_>) -> Option<Smoothed> {
    let n = data.points.len();
    let mut group = 1;
    loop {
        let groups = groups(data, group);
        let (points, weights) = averaged(data, &groups);
        let lengths = (group == 1).then_some(data.chords).flatten();
        let coarse = Series { points: &points, weights: Some(&weights), chords: lengths, ..*data };
        let choices = ADAPTIONS.iter().filter_map(|adaption| rounds(&coarse, *adaption));
        let choice = choices.min_by(|a, b| a.validation(&coarse).total_cmp(&b.validation(&coarse)))?;
        if choice.exponent > DENSE && n / (2 * group) >= FEWEST_GROUPS && data.chords.is_none() {
            group *= 2;
            continue;
        }
        return Some(finished(data, choice, &groups));
    }
}

/// So many neighbors each; an end that stays is alone, or the curve would bend to it from a mean beside it.
fn groups(data: &Series<'_>, size: usize) -> Vec<Range<usize>> {
    let n = data.points.len();
    let [first, last] = data.fixed.map(|fixed| usize::from(fixed && !data.closed && size > 1));
    let inner = (first..n - last).step_by(size).map(|from| from..(from + size).min(n - last));
    (0..first).map(|i| i..i + 1).chain(inner).chain((n - last..n).map(|i| i..i + 1)).collect()
}

/// Means of groups of neighbors.
fn averaged(data: &Series<'_>, groups: &[Range<usize>]) -> (Vec<Point3>, Vec<f64>) {
    let given: Vec<f64> = data.weights.map_or_else(|| vec![1.0; data.points.len()], <[f64]>::to_vec);
    if groups.len() == data.points.len() {
        return (data.points.to_vec(), given);
    }
    let first = data.points[0];
    let mean = |group: &Range<usize>| {
        let (points, weights) = (&data.points[group.clone()], &given[group.clone()]);
        let whole: f64 = weights.iter().sum();
        let sum = points.iter().zip(weights).fold(Vec3::ZERO, |sum, (p, w)| sum + (*p - first) * *w);
        (first + sum / whole, whole)
    };
    groups.iter().map(mean).unzip()
}

/// The data smoothed in rounds: each takes lengths, stiffness and weights from the one before.
fn rounds(data: &Series<'_>, adaption: Adaption) -> Option<Choice> {
    let (n, closed) = (data.points.len(), data.closed);
    if n < FEWEST {
        return None;
    }
    let mut lengths = data.chords.map_or_else(|| robust_chords(data.points, closed), <[f64]>::to_vec);
    let given: Vec<f64> = data.weights.map_or_else(|| vec![1.0; n], <[f64]>::to_vec);
    let mut weights = given.clone();
    let mut stiffness = vec![1.0; if closed { n } else { n - 3 }];
    let softest = if data.noise.is_some() { SOFTEST_IF_KNOWN } else { SOFTEST };
    let mut range = [softest, STIFFEST];
    let mut chosen: Option<Choice> = None;
    for round in 0..ROUNDS {
        let smoother = smoother(data, &lengths, &weights, &stiffness);
        let Some(choice) = choose(data, &smoother, &lengths, &weights, range, round < ROBUST) else { break };
        range = [choice.exponent - NEAR, choice.exponent + NEAR];
        if data.chords.is_none() {
            lengths = above_shortest(chords(&choice.points, closed));
        }
        stiffness = adaption.stiffness(&smoother.variations(&choice.points), n as f64 / choice.freedom, closed);
        weights.clone_from(&given);
        if round + 1 < ROBUST {
            for (w, far) in weights.iter_mut().zip(standing_out(&choice, data)) {
                let part = (far / FAR).min(1.0);
                *w = (*w * (1.0 - part * part).powi(2)).max(NONE);
            }
        }
        chosen = Some(choice);
    }
    chosen
}

fn smoother(data: &Series<'_>, lengths: &[f64], weights: &[f64], stiffness: &[f64]) -> Smoother {
    let mut weights = weights.to_vec();
    let last = weights.len() - 1;
    for (end, fixed) in [0, last].into_iter().zip(data.fixed) {
        if fixed && !data.closed {
            weights[end] = FIXED;
        }
    }
    Smoother::new(data.points, lengths, data.closed, weights, stiffness)
}

/// The strength with the least score of cross-validation, or with the noise that is known.
fn choose(
    data: &Series<'_>,
    smoother: &Smoother,
    lengths: &[f64],
    weights: &[f64],
    range: [f64; 2],
    robust: bool,
) -> Option<Choice> {
    let n = data.points.len() as f64;
    let h = lengths.iter().sum::<f64>() / lengths.len() as f64;
    let directions = data.directions as f64;
    let mut best: Option<(f64, Choice)> = None;
    // The noise that is given is to be reached, not only kept.
    let softest = if data.noise.is_some() { SOFTEST_IF_KNOWN } else { SOFTEST };
    let near = range[1] - range[0] < STIFFEST - softest;
    let step = if near && data.noise.is_some() { FINE_STEP } else { STEP };
    let steps = ((range[1] - range[0]) / step).round() as usize;
    for exponent in (0..=steps).map(|k| range[0] + step * k as f64).filter(|e| (softest..=STIFFEST).contains(e)) {
        let Some((rest, freedom)) = smoother.fitted(h.powi(5) * 10_f64.powf(exponent)) else { continue };
        let too_free =
            if data.noise.is_some() { n - freedom <= LEFT_IF_KNOWN * n } else { n - CAUTION * freedom <= LEFT * n };
        if too_free {
            continue;
        }
        let points: Vec<Point3> = data.points.iter().zip(rest).map(|(p, w)| *p - w).collect();
        let residuals = residuals(data.points, &points, data.closed, data.chords.is_some());
        let mut choice = Choice { exponent, points, freedom, squares: 0.0, residuals };
        let deviation = scale(choice.residuals.iter().map(|r| r.across), data.directions) * (n / (n - freedom)).sqrt();
        let clipped = |r: &Residual| {
            let (far, limit) = (r.alone[0].hypot(r.alone[1]), CLIPPED * deviation.max(r.around));
            if robust && far > limit { r.across * limit / far } else { r.across }
        };
        choice.squares = choice.residuals.iter().zip(weights).map(|(r, w)| w * clipped(r).powi(2)).sum();
        let score = match data.noise {
            // The stiffest that leaves no more than the noise, else the softest.
            Some(noise) => {
                let within = choice.squares <= noise * noise * (n - freedom) * directions;
                if within { STIFFEST - exponent } else { 2.0 * STIFFEST + exponent }
            }
            None => score(data, choice.squares, CAUTION * freedom, n),
        };
        if score.is_finite() && best.as_ref().is_none_or(|(least, _)| score < *least) {
            best = Some((score, choice));
        }
    }
    best.map(|(_, choice)| choice)
}

/// What errors to expect of new points: generalized cross-validation, or where the noise is known from elsewhere the estimate by Mallows.
fn score(data: &Series<'_>, squares: f64, freedom: f64, count: f64) -> f64 {
    match data.common {
        Some(noise) => squares + PRUDENCE * noise * noise * freedom * data.directions as f64,
        None => squares / (count - freedom).powi(2),
    }
}

/// By how many deviations each point stands out from its neighbors.
fn standing_out(choice: &Choice, data: &Series<'_>) -> Vec<f64> {
    let n = choice.points.len() as f64;
    let grown = (n / (n - choice.freedom)).sqrt();
    let across = scale(choice.residuals.iter().map(|r| r.across), data.directions) * grown;
    let along = (scale(choice.residuals.iter().map(|r| r.along), 1) * grown).max(across);
    let far = |r: &Residual| {
        let across = across.max(r.around);
        (r.alone[0] / across).hypot(r.alone[1] / along.max(across))
    };
    choice.residuals.iter().map(|r| if across > 0.0 { far(r) } else { 0.0 }).collect()
}

/// The places of all data on what was found for their groups.
fn finished(data: &Series<'_>, choice: Choice, groups: &[Range<usize>]) -> Smoothed {
    let (n, count) = (data.points.len(), choice.points.len());
    let points: Vec<Point3> = if groups.len() == n {
        choice.points
    } else {
        let at = |(g, i, size): (usize, usize, usize)| {
            let position = g as f64 + (i as f64 + 0.5) / size as f64 - 0.5;
            let position = if data.closed && position < 0.0 { position + count as f64 } else { position };
            point_at(&choice.points, data.closed, position)
        };
        groups
            .iter()
            .enumerate()
            .flat_map(|(g, group)| (0..group.len()).map(move |i| (g, i, group.len())))
            .map(at)
            .collect()
    };
    let mut points = points;
    for (end, fixed) in [0, n - 1].into_iter().zip(data.fixed) {
        if fixed && !data.closed {
            points[end] = data.points[end];
        }
    }
    let residuals = residuals(data.points, &points, data.closed, data.chords.is_some());
    let free = (n as f64 - choice.freedom).max(1.0);
    let given = |i: usize| data.weights.map_or(1.0, |w| w[i]);
    let squares: f64 = residuals.iter().enumerate().map(|(i, r)| given(i) * r.across * r.across).sum();
    let grown = (n as f64 / free).sqrt();
    let across = scale(residuals.iter().map(|r| r.across), data.directions) * grown;
    let along = (scale(residuals.iter().map(|r| r.along), 1) * grown).max(across);
    Smoothed {
        deviation: (squares / (free * data.directions as f64)).sqrt(),
        freedom: choice.freedom,
        across,
        along,
        points,
        residuals,
    }
}
