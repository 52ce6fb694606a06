//! Does an interpolating curve bend to and fro more often than its data do?
//!
//! The data are the nodes at which the pieces of the curve meet, cut at its corners; the polygon through them turns left
//! or right at each, or not at all. A turn counts as none if rounding can make it, or if it is below a fiftieth of one
//! beside it. What the data account for are the polygon's own changes of side, and one more for every passage
//! between straight on and a turn: beside a corner of straight runs an interpolating curve must swing out a little.
//!
//! *The curve wavers* if it changes sides more than 1.25 times as often, and two times more. *The data waver* if there
//! are 16 nodes or more, those that turn do so gently (by less than 30 degrees in the median; stairs do not), and they
//! change sides at more than every third: then they carry noise, and a curve through all of them has to show it.

use super::piece::ROUNDING;
use super::plane::plane_of;
use super::{CORNER_ANGLE, Fairness};
use crate::base::vector::Vec3;
use crate::curve::ParamCurve;
use crate::curve::measure::continuity::joints;

/// Turns below this part of a neighbour's are straight on.
const STRAIGHT: f64 = 0.02;
/// The curve wavers beyond this many times what the data account for, and this many more.
const TIMES: f64 = 1.25;
const MORE: f64 = 2.0;
/// Data that waver are at least so many and turn in the median by less than this.
const MANY: usize = 16;
const GENTLE: f64 = std::f64::consts::FRAC_PI_6;

/// An interpolating curve against its data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Wavering {
    /// Changes of the curve between turning left and turning right.
    pub curve: usize,
    /// Those of its data.
    pub data: usize,
    /// Those that its data account for: their own, and one at each end of a straight run.
    pub explained: usize,
    /// Nodes of the data, corners excepted.
    pub nodes: usize,
    /// The curve changes sides far more often than its data account for.
    pub curve_wavers: bool,
    /// The data themselves change sides as noise does.
    pub data_waver: bool,
}

/// Compares a planar curve with the polygon of the nodes between its pieces; `None` in space.
#[must_use]
pub fn wavering(curve: &dyn ParamCurve, fairness: &Fairness) -> Option<Wavering> {
    let changes = fairness.sign_changes?;
    let runs = turns(curve, plane_of(curve)?);
    let (mut data, mut passages, mut turning) = (0, 0, Vec::new());
    for run in &runs {
        let sides = run.sides();
        turning.extend(run.turns.iter().zip(&sides).filter(|(_, side)| **side != 0).map(|(turn, _)| turn.angle.abs()));
        data += run.changes(sides.iter().copied().filter(|s| *s != 0));
        passages += run.changes(sides.iter().map(|s| i8::from(*s != 0)));
    }
    turning.sort_by(f64::total_cmp);
    let median = turning.get(turning.len() / 2).copied().unwrap_or(0.0);
    let nodes = runs.iter().map(|run| run.turns.len()).sum();
    let explained = data + passages;
    Some(Wavering {
        curve: changes,
        data,
        explained,
        nodes,
        curve_wavers: changes as f64 > TIMES * explained as f64 + MORE,
        data_waver: nodes >= MANY && median < GENTLE && 3 * data > nodes,
    })
}

/// The turn of the polygon at a node, and what rounding can make of it.
struct Turn {
    angle: f64,
    rounding: f64,
}

/// The nodes of a smooth run.
struct Turns {
    turns: Vec<Turn>,
    closed: bool,
}

impl Turns {
    /// 1 for left, -1 for right, 0 for straight on.
    fn sides(&self) -> Vec<i8> {
        let n = self.turns.len();
        let size = |i: Option<usize>| i.and_then(|i| self.turns.get(i)).map_or(0.0, |t| t.angle.abs());
        let side = |i: usize| {
            let before = if i > 0 { Some(i - 1) } else { self.closed.then_some(n - 1) };
            let after = if i + 1 < n { Some(i + 1) } else { self.closed.then_some(0) };
            let turn = &self.turns[i];
            let straight = turn.rounding.max(STRAIGHT * size(before).max(size(after)));
            match turn.angle {
                a if a > straight => 1,
                a if a < -straight => -1,
                _ => 0,
            }
        };
        (0..n).map(side).collect()
    }

    /// How often neighbouring values differ, round a closed run.
    fn changes(&self, values: impl Iterator<Item = i8>) -> usize {
        let mut values: Vec<i8> = values.collect();
        if self.closed {
            values.extend(values.first().copied());
        }
        values.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }
}

/// The turns at the nodes inside of every smooth run.
fn turns(curve: &dyn ParamCurve, normal: Vec3) -> Vec<Turns> {
    let mut runs = vec![Turns { turns: Vec::new(), closed: curve.is_closed() }];
    for joint in joints(curve) {
        let (from, at) = (curve.piece_point(joint.piece, 0.0), curve.piece_point(joint.next, 0.0));
        if joint.angle > CORNER_ANGLE {
            runs.push(Turns { turns: Vec::new(), closed: false });
            continue;
        }
        let (a, b) = (at - from, curve.piece_point(joint.next, 1.0) - at);
        let rounding = ROUNDING * (1.0 + at.to_vec().max_abs() / a.length().min(b.length()));
        let turn = Turn { angle: a.cross(b).dot(normal).atan2(a.dot(b)), rounding };
        if let Some(run) = runs.last_mut() {
            run.turns.push(turn);
        }
    }
    // A closed curve with corners: what is behind the last corner goes on before the first one.
    if runs.len() > 1 && curve.is_closed() {
        let first = runs.remove(0);
        if let Some(last) = runs.last_mut() {
            last.turns.extend(first.turns);
        }
    }
    runs
}
