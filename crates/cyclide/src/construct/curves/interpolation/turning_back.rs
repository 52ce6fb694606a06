//! Where a curve through points turns right back between two of them, as one does whose points are nearly on a curve of lower degree.

use crate::base::vector::{Point3, Vec3};
use crate::curve::QbCurve;

/// Even parts between two neighboring points whose tangents are compared.
const PARTS: u32 = 12;
/// Turns by more than this, in radians, are turns right back if they stay so on a hundredth of the spacing of the points: a smooth turn gets less with its
/// length, and half of a hairpin is a right angle.
const BACK: f64 = 2.0;
/// What is halved is a turn by more than this, in radians: on the whole of it a turn right back is spread with what the curve turns besides.
const SUSPECT: f64 = 1.2;
/// Halvings until a place is known to rounding.
const HALVINGS: u32 = 50;
/// Points whose polygon turns by more than this, as the cosine of the angle, ask for a turn back.
const ASKED: f64 = -0.9;

/// A place where a curve turns right back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TurnBack {
    /// Its parameter.
    pub(super) t: f64,
    /// How long the curve is on which it turns at most.
    pub(super) within: f64,
    /// The spacing of the points that the length is small against.
    pub(super) spacing: f64,
    /// How many such places there are.
    pub(super) count: usize,
}

/// The largest part of the spacing of the points on which a turn is a turn right back.
pub(super) const SHARP: f64 = 0.01;

/// The first place between points at these parameters where the curve turns right back, but beside points that do so themselves.
pub(super) fn turn_back(curve: &QbCurve, parameters: &[f64]) -> Option<TurnBack> {
    let mut nodes = parameters.to_vec();
    nodes.sort_by(f64::total_cmp);
    let points: Vec<Point3> = nodes.iter().map(|t| curve.point(*t)).collect();
    let mut chords: Vec<f64> = points.windows(2).map(|pair| pair[0].distance(pair[1])).collect();
    chords.sort_by(f64::total_cmp);
    let spacing = chords.get(chords.len() / 2).copied().filter(|spacing| *spacing > 0.0)?;
    let turns_at = |i: usize| {
        let Some(&[a, b, c]) = i.checked_sub(1).and_then(|first| points.get(first..i + 2)?.first_chunk::<3>()) else {
            return false;
        };
        let (before, after) = (b - a, c - b);
        !(before.dot(after) > ASKED * before.length() * after.length())
    };
    let mut found: Option<TurnBack> = None;
    for (_, pair) in nodes.windows(2).enumerate().filter(|(i, _)| ![*i, i + 1].into_iter().any(turns_at)) {
        let at = |k: u32| pair[0] + (pair[1] - pair[0]) * (f64::from(k) / f64::from(PARTS));
        let places: Vec<(f64, Vec3)> = (0..=PARTS).map(|k| direction(curve, at(k))).collect();
        for ends in places.windows(2) {
            if let Some((t, within)) = sharpest(curve, [ends[0], ends[1]], SHARP * spacing) {
                let count = found.map_or(0, |found| found.count) + 1;
                found = Some(TurnBack { count, ..found.unwrap_or(TurnBack { t, within, spacing, count }) });
            }
        }
    }
    found
}

/// Where the curve turns back between two places, if it does so on a length up to `short`: halved on the side that turns more.
fn sharpest(curve: &QbCurve, [mut from, mut to]: [(f64, Vec3); 2], short: f64) -> Option<(f64, f64)> {
    let mut found = None;
    for _ in 0..HALVINGS {
        let turn = from.1.angle(to.1);
        // Once it is one, it is followed to where it is sharpest.
        if !(turn > if found.is_some() { BACK } else { SUSPECT }) {
            return found;
        }
        let middle = direction(curve, 0.5 * (from.0 + to.0));
        let [a, b, c] = [from.0, middle.0, to.0].map(|t| curve.point(t));
        let length = a.distance(b) + b.distance(c);
        if length <= short {
            if !(turn > BACK) {
                return found;
            }
            found = Some((middle.0, length));
        }
        if from.1.angle(middle.1) > middle.1.angle(to.1) {
            to = middle;
        } else {
            from = middle;
        }
    }
    found
}

/// A parameter and the direction of the curve there.
fn direction(curve: &QbCurve, t: f64) -> (f64, Vec3) {
    (t, curve.jet(t).d1)
}
