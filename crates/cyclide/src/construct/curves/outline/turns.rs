//! Which points are corners: by how they turn, and by what turns beside them.

use super::reader::Reader;
use super::sides::STEP;
use super::{LARGEST_SAMPLE_TURN, Scattered};
use std::collections::HashSet;
use std::f64::consts::PI;

/// A corner stands out if its turn is this many times those of its neighbors, and samples support a turn that
/// is at most this many times their own.
const PROMINENCE: f64 = 3.0;
/// A kink turns by more than this, six degrees,
const LEAST_KINK: f64 = PI / 30.0;
/// and by so many times what a smooth curve would: at the end of a straight run,
const RUN_KINK: f64 = 2.0;
/// and elsewhere: an edge that is a chord of a curve, as others are, makes twice as much of it.
const KINK: f64 = 3.0;
/// Points of an arc turn alike, over edges alike, to this factor.
const STEADY: f64 = 1.3;
/// It is as many times as far off as rounding explains.
const ROUNDINGS: f64 = 4.0;
/// With so few turning points between two corners or straight sides there is no curve.
pub(super) const FEW: usize = 2;
/// Noise is recognized by pairs of neighbors that turn by more than this, up to a sample's largest turn,
const ROUGH: f64 = 5.0 * PI / 180.0;
/// of which at least so many,
const ROUGH_PAIRS: u32 = 16;
/// and this part, turn to different sides
const ROUGH_PART: f64 = 0.25;
/// by angles that differ by this factor, and of all sorts: in whole degrees more than this part of them.
const ROUGH_RATIO: f64 = 1.5;
const ALL_SORTS: f64 = 0.25;
/// No samples turn to and fro at every second point or sooner by more than this.
const ZIGZAG: f64 = 15.0 * PI / 180.0;

impl Reader<'_> {
    /// Noise above the tolerance turns points to and fro by all sorts of angles.
    pub(super) fn is_noisy(&self) -> bool {
        let rough = |i: usize| (ROUGH..=LARGEST_SAMPLE_TURN).contains(&self.turn(i));
        let pairs = (0..self.n()).map(|i| (i, self.after(i))).filter(|(i, j)| rough(*i) && rough(*j));
        let (mut count, mut to_and_fro) = (0, 0);
        let mut degrees = HashSet::new();
        for (i, j) in pairs {
            let (a, b) = (self.turn(i), self.turn(j));
            count += 1;
            degrees.insert(a.to_degrees().round() as u32);
            to_and_fro += u32::from(self.turns[i].dot(self.turns[j]) < 0.0 && a.max(b) > ROUGH_RATIO * a.min(b));
        }
        let all_sorts = degrees.len() as f64 > ALL_SORTS * f64::from(count);
        count >= ROUGH_PAIRS && all_sorts && f64::from(to_and_fro) > ROUGH_PART * f64::from(count)
    }

    /// Of a turn above the corner angle: it stands out, or is more than a sample's, and noise within the tolerance has not caused it.
    pub(super) fn is_evident_corner(&self, vertex: usize, noisy: bool) -> bool {
        let turn = self.turn(vertex);
        let neighbors = self.turn(self.before(vertex)).max(self.turn(self.after(vertex)));
        let stands_out = turn > PROMINENCE * neighbors;
        (stands_out || (turn > LARGEST_SAMPLE_TURN && !noisy)) && self.lasts(vertex)
    }

    /// Whether a straight run of points ends there at an angle that no samples have: over the edge beyond a curve turns by twice the
    /// angle to the run, or by both angles if there is a run beyond too.
    pub(super) fn is_firm(&self, vertex: usize) -> bool {
        let may_end = |i: usize| self.is_inside(i) && self.runs.may_end_at(i);
        let bends_with = |other: usize| {
            let is_bend = may_end(other) && self.turns[vertex].dot(self.turns[other]) > 0.0;
            is_bend && self.turn(vertex) + self.turn(other) > LARGEST_SAMPLE_TURN
        };
        let part = if self.runs.ends_at(vertex) { 0.5 } else { 1.0 };
        let is_sharp = self.turn(vertex) > part * LARGEST_SAMPLE_TURN;
        let is_bent =
            may_end(vertex) && (is_sharp || bends_with(self.before(vertex)) || bends_with(self.after(vertex)));
        is_bent || (self.runs.ends_at(vertex) && self.is_beyond_rounding(vertex) && self.is_kink(vertex))
    }

    /// Whether an arc meets a straight side or another arc there: a turn far more than what a smooth curve makes of it by the curvature
    /// of the arcs, which is half of what they turn over their edges.
    pub(super) fn is_kink(&self, vertex: usize) -> bool {
        if !self.is_inside(vertex) {
            return false;
        }
        let sides = [false, true].map(|forward| self.bend_beside(vertex, forward));
        let [Some(before), Some(after)] = sides else { return false };
        let (smooth, times) = (before + after, if self.runs.ends_at(vertex) { RUN_KINK } else { KINK });
        self.turn(vertex) > LEAST_KINK && smooth > 0.0 && self.turn(vertex) > times * smooth
    }

    /// What an arc that begins at a vertex turns over half of its first edge, by the points beyond; 0 of a straight run or side, `None` of anything else.
    fn bend_beside(&self, vertex: usize, forward: bool) -> Option<f64> {
        let step = |i: usize| if forward { self.after(i) } else { self.before(i) };
        let edge = |i: usize| if forward { i } else { self.before(i) };
        let ahead = [step(vertex), step(step(vertex)), step(step(step(vertex)))];
        if self.straight[edge(vertex)] || self.runs.is_inside(ahead[0]) {
            return Some(0.0);
        }
        let is_near = |a: f64, b: f64| a.max(b) <= STEADY * a.min(b);
        let [one, two, three] = ahead.map(|i| self.turns[i]);
        let is_arc = ahead.iter().all(|i| self.is_inside(*i) && self.does_turn(*i))
            && one.dot(two) > 0.0
            && two.dot(three) > 0.0
            && is_near(one.length(), two.length())
            && is_near(two.length(), three.length());
        let lengths = [vertex, ahead[0], ahead[1]].map(|i| self.lengths[edge(i)]);
        let is_even = is_near(lengths[0], lengths[1]) && is_near(lengths[1], lengths[2]);
        (is_arc && is_even).then(|| self.turn(ahead[0]) * lengths[0] / (lengths[0] + lengths[1]))
    }

    /// Whether the rounding of coordinates is no reason for it.
    fn is_beyond_rounding(&self, vertex: usize) -> bool {
        let shorter = self.lengths[self.before(vertex)].min(self.lengths[vertex]);
        shorter * (0.5 * self.turn(vertex)).sin() > ROUNDINGS * self.runs.off()
    }

    /// The kinks that noise has not caused.
    pub(super) fn kinks(&self) -> Vec<usize> {
        let is_shape = self.scattered == Scattered::Vertices;
        (0..self.n()).filter(|i| is_shape && self.is_passed(*i) && self.is_kink(*i) && self.lasts(*i)).collect()
    }

    /// Turns that no samples support: above the limit, a neighbor has to turn the same way by a third of it, over edges of
    /// comparable length, none of them a straight side; and the points of the run up to the next corners have to turn by less
    /// than the limit on average, and to be where their neighbors say, as samples of a curve are.
    pub(super) fn unsupported_turns(&self, limit: f64) -> Vec<usize> {
        let n = self.n();
        let candidate = |i: usize| self.is_passed(i) && self.turn(i) > limit && self.lasts(i);
        let supports = |i: usize, j: usize| {
            self.is_passed(j) && self.turns[i].dot(self.turns[j]) > 0.0 && self.turn(i) <= PROMINENCE * self.turn(j)
        };
        let supported = |i: usize| {
            let (before, after) = (self.before(i), self.after(i));
            let (a, b) = (self.lengths[before], self.lengths[i]);
            (supports(i, before) || supports(i, after))
                && a.max(b) <= STEP * a.min(b)
                && !self.straight[before]
                && !self.straight[i]
        };
        let mut found: Vec<usize> = (0..n).filter(|i| candidate(*i) && !supported(*i)).collect();
        let is_shape = self.scattered == Scattered::Vertices;
        for run in self.runs() {
            let turning = run.iter().filter(|i| self.does_turn(**i)).map(|i| self.turn(*i));
            let (count, sum) = turning.fold((0, 0.0), |(count, sum), turn| (count + 1, sum + turn));
            if sum > limit * f64::from(count) || (is_shape && !self.is_predicted(&run)) {
                found.extend(run.iter().filter(|i| candidate(**i)));
            }
        }
        found
    }

    /// Points in runs of at most two that turn to one side by a lot each, between two such runs to the other side: a curve that
    /// turns to and fro has more samples to each bend.
    pub(super) fn zigzags(&self) -> Vec<usize> {
        let n = self.n();
        let turning: Vec<usize> = (0..n).filter(|i| self.is_inside(*i) && self.does_turn(*i)).collect();
        let same = |k: usize| {
            let (i, j) = (turning[k], turning[(k + 1) % turning.len()]);
            (self.closed || k + 1 < turning.len()) && self.turns[i].dot(self.turns[j]) > 0.0
        };
        // The last of open data changes to nothing.
        let changes = |k: &usize| !same(*k) && (self.closed || k + 1 == turning.len());
        let Some(first) = (0..turning.len()).find(changes) else { return Vec::new() };
        // From the first point behind a change of side.
        let mut bends: Vec<Vec<usize>> = vec![Vec::new()];
        for k in (1..=turning.len()).map(|k| (first + k) % turning.len()) {
            if let Some(bend) = bends.last_mut() {
                bend.push(turning[k]);
            }
            if !same(k) {
                bends.push(Vec::new());
            }
        }
        bends.retain(|bend| !bend.is_empty());
        let count = bends.len();
        let is_short =
            |bend: &Vec<usize>| bend.len() <= FEW && bend.iter().all(|i| self.turn(*i) > ZIGZAG && self.lasts(*i));
        let short: Vec<bool> = bends.iter().map(is_short).collect();
        let is_short_or_end = |k: usize, at_end: bool| short[k] || (at_end && !self.closed);
        let between = |k: &usize| {
            let (before, after) = ((k + count - 1) % count, (k + 1) % count);
            count > 2 && short[*k] && is_short_or_end(before, *k == 0) && is_short_or_end(after, after == 0)
        };
        (0..count).filter(between).flat_map(|k| bends[k].clone()).collect()
    }
}
