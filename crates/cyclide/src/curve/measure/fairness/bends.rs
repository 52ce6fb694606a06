//! Bends: runs of a curve that turn to one side, and how far they do.
//!
//! A place of a curve has an axis, the product of tangent and curvature vector, with the length of the curvature; times the
//! length of the curve about the place it is a turn. Turns are one bend as long as each is within a right angle of the one
//! before. In a plane bends are what lies between two changes of the sign of the curvature, and the sum of their turns is
//! the angle by which the tangent turns.

use super::CORNER_ANGLE;
use super::piece::ROUNDING;
use crate::base::vector::Vec3;
use crate::curve::ParamCurve;
use crate::curve::measure::continuity::joints;

/// Turns below this part of a neighbor's are straight on.
pub(super) const STRAIGHT: f64 = 0.02;
/// Bends that turn by less, in radians, do not count.
pub(super) const LEAST_TURN: f64 = 5e-4;
/// Places of each piece that are looked at, for those of few pieces more.
const PLACES: usize = 10;
const LEAST_PLACES: usize = 400;

/// How often the turns change sides, by bends that count: those that turn by more than the largest of the limits of their
/// turns. The turns of the others become `None`.
pub(super) fn changes(turns: &mut [Option<Vec3>], limit: impl Fn(usize) -> f64, closed: bool) -> usize {
    let mut bends: Vec<Bend> = Vec::new();
    let mut before: Option<Vec3> = None;
    for (i, turn) in turns.iter().enumerate() {
        let Some(turn) = *turn else { continue };
        let on = before.is_some_and(|before| before.dot(turn) >= 0.0);
        before = Some(turn);
        match bends.last_mut().filter(|_| on) {
            Some(bend) => bend.add(i, turn, limit(i)),
            None => bends.push(Bend { first: i, last: i, turn: turn.length(), limit: limit(i) }),
        }
    }
    // Round the start of a closed curve a bend goes on.
    if let (true, [first, .., last]) = (closed, bends.as_mut_slice())
        && turns[first.first].zip(turns[last.last]).is_some_and(|(a, b)| a.dot(b) >= 0.0)
    {
        let (turn, limit) = (first.turn + last.turn, first.limit.max(last.limit));
        for bend in [first, last] {
            (bend.turn, bend.limit) = (turn, limit);
        }
    }
    for bend in bends.iter().filter(|bend| !bend.counts()) {
        turns[bend.first..=bend.last].fill(None);
    }
    let mut sides: Vec<[Vec3; 2]> = bends.iter().filter(|bend| bend.counts()).map(|bend| bend.sides(turns)).collect();
    if closed {
        sides.extend(sides.first().copied());
    }
    sides.windows(2).filter(|pair| pair[0][1].dot(pair[1][0]) < 0.0).count()
}

/// Neighboring turns to one side, each within a right angle of the one before.
struct Bend {
    first: usize,
    last: usize,
    /// The sum of their angles.
    turn: f64,
    limit: f64,
}

impl Bend {
    fn add(&mut self, index: usize, turn: Vec3, limit: f64) {
        self.last = index;
        self.turn += turn.length();
        self.limit = self.limit.max(limit);
    }

    fn counts(&self) -> bool {
        self.turn > self.limit
    }

    /// The first and the last turn of it that is no rest of its ends.
    fn sides(&self, turns: &[Option<Vec3>]) -> [Vec3; 2] {
        let own = || turns[self.first..=self.last].iter().copied().flatten();
        let least = STRAIGHT * own().map(Vec3::length).fold(0.0, f64::max);
        let is_clear = |turn: &Vec3| turn.length() >= least;
        [own().find(is_clear), own().rfind(is_clear)].map(Option::unwrap_or_default)
    }
}

/// How often a curve changes sides between its corners, by bends that count; `beside` are the turns of its data at each piece.
pub(super) fn curve_changes(curve: &dyn ParamCurve, beside: &[f64]) -> usize {
    let n = curve.piece_count();
    let mut cuts = vec![false; n];
    joints(curve).into_iter().filter(|joint| joint.angle > CORNER_ANGLE).for_each(|joint| cuts[joint.next] = true);
    // A closed curve with corners starts at one of them.
    let start = cuts.iter().position(|cut| *cut).filter(|_| curve.is_closed());
    let closed = curve.is_closed() && start.is_none();
    let places = PLACES.max(LEAST_PLACES / n);
    let (mut count, mut turns, mut limits) = (0, Vec::new(), Vec::new());
    for step in 0..n {
        let piece = (start.unwrap_or(0) + step) % n;
        if step > 0 && cuts[piece] {
            count += changes(&mut turns, |i| limits[i / places], false);
            turns.clear();
            limits.clear();
        }
        turns.extend((0..places).map(|i| turn_at(curve, piece, [i, places])));
        limits.push(limit(curve, piece, beside));
    }
    count + changes(&mut turns, |i| limits[i / places], closed)
}

/// The turn of one of so many equal parts of a piece.
fn turn_at(curve: &dyn ParamCurve, piece: usize, [i, places]: [usize; 2]) -> Option<Vec3> {
    let jet = curve.piece_jet(piece, (i as f64 + 0.5) / places as f64);
    let axis = jet.d1.unit().zip(jet.curvature_vector()).map(|(tangent, k)| tangent.cross(k));
    axis.map(|axis| axis * (jet.speed() / places as f64)).filter(|turn| turn.is_finite())
}

/// The turn above which a bend in this piece counts.
fn limit(curve: &dyn ParamCurve, piece: usize, beside: &[f64]) -> f64 {
    let n = beside.len();
    let near = [(piece + n - 1) % n, piece, (piece + 1) % n].map(|i| beside[i]);
    let from = curve.piece_point(piece, 0.0);
    let chord = from.distance(curve.piece_point(piece, 1.0)).max(from.distance(curve.piece_point(piece, 0.5)));
    let rounding = ROUNDING * (1.0 + from.to_vec().max_abs() / chord);
    (STRAIGHT * near.into_iter().fold(0.0, f64::max)).max(LEAST_TURN).max(rounding)
}
