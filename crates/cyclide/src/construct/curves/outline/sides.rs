//! Which edges are straight sides: by what the edges beside them say.

use super::reader::Reader;
use super::turns::FEW;
use super::{CORNER_ANGLE, LARGEST_SAMPLE_TURN, Scattered};

/// Neighboring edges of samples differ in length by at most this factor, without a change of the curvature by a lot.
pub(super) const STEP: f64 = 3.0;
/// Neighboring edges of samples differ in length by at most this factor in any case.
const LONGEST_STEP: f64 = 6.0;
/// Neighboring edges of samples differ in sagitta by at most this factor.
const SAGITTA_STEP: f64 = 3.0;
/// Beside a straight side the curvature falls below this part of that of the samples.
const CURVATURE_DROP: f64 = 0.5;
/// So many edges on, each comparable to an edge, explain it as a sample.
const COMPANIONS: usize = 3;
/// An edge between samples matters if it is left by more than this part of the tolerance.
const MATTERS: f64 = 0.5;

/// What the edges on one side of an edge say about it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    /// They are samples like it.
    Alike,
    /// They are samples, and it is none of them.
    Unlike,
    /// Nothing.
    Silent,
}

impl Reader<'_> {
    pub(super) fn find_straight_sides(&mut self) {
        let edges = if self.closed { self.n() } else { self.n() - 1 };
        self.straight.clone_from(&self.held);
        let straight = |edge: &usize| {
            let sides = [self.side(*edge, false), self.side(*edge, true)];
            self.sagitta(*edge) > MATTERS * self.tolerance
                && sides.contains(&Side::Unlike)
                && !sides.contains(&Side::Alike)
        };
        let found: Vec<usize> = (0..edges).filter(straight).collect();
        found.into_iter().for_each(|edge| self.straight[edge] = true);
        for edge in self.edges_without_curve() {
            self.straight[edge] = true;
        }
    }

    /// What the edges on one side of an edge say about it.
    fn side(&self, edge: usize, forward: bool) -> Side {
        // The k-th edge on, and the point where it begins from here.
        let n = self.n();
        let on = |k: usize| if forward { (edge + k) % n } else { (edge + n - k % n) % n };
        let point = |k: usize| if forward { on(k) } else { (on(k) + 1) % n };
        let is_curve = |k: usize| self.is_passed(point(k)) && self.turn(point(k)) <= CORNER_ANGLE;
        if n <= COMPANIONS + 1 || !self.is_passed(point(1)) {
            return Side::Silent;
        }
        let length = self.lengths[edge];
        let sagitta = self.sagitta(edge);
        let companion = |k: usize| is_curve(k) && length <= STEP * self.lengths[on(k)];
        if (1..=COMPANIONS).all(companion) {
            return Side::Alike;
        }
        // Samples there are at least one point that the curve passes beyond the first.
        if !self.is_passed(point(2)) || self.turn(point(2)) > LARGEST_SAMPLE_TURN {
            return Side::Silent;
        }
        let largest = self.sagitta(on(1)).max(self.sagitta(on(2)));
        let step = length / self.lengths[on(1)];
        let curvature = 2.0 * self.turn(point(2)) / (self.lengths[on(1)] + self.lengths[on(2)]);
        let drops = self.edge_turn(edge) < CURVATURE_DROP * curvature * length;
        let unlike = sagitta > SAGITTA_STEP * largest && (step > LONGEST_STEP || (step > STEP && drops));
        if unlike { Side::Unlike } else { Side::Silent }
    }

    /// The edges between two corners or straight sides with too few turning points between them for a curve.
    fn edges_without_curve(&self) -> Vec<usize> {
        let n = self.n();
        let edges = if self.closed { n } else { n - 1 };
        // Chains of edges that are not straight between points where curves end; the first begins at one of them.
        let ends_at =
            |vertex: usize| !self.is_passed(vertex) || self.straight[vertex] || self.straight[self.before(vertex)];
        let Some(first) = (0..n).find(|i| ends_at(*i)) else { return Vec::new() };
        let turns = |vertex: usize| self.is_passed(vertex) && self.does_turn(vertex);
        let mut found = Vec::new();
        let mut chain: Vec<usize> = Vec::new();
        for edge in (0..n).map(|k| (first + k) % n) {
            if edge >= edges || self.straight[edge] {
                chain.clear();
                continue;
            }
            chain.push(edge);
            let end = self.after(edge);
            if !ends_at(end) {
                continue;
            }
            let count = usize::from(turns(chain[0])) + chain.iter().filter(|e| turns(self.after(**e))).count();
            let held = |vertex: usize| self.is_inside(vertex);
            if count <= FEW && count > 0 && (held(chain[0]) || held(end)) {
                found.extend(chain.iter().filter(|e| self.sagitta(**e) > MATTERS * self.tolerance));
            }
            chain.clear();
        }
        found
    }

    /// The edges that matter between points that are not where their neighbors say.
    pub(super) fn edges_between_scattered_points(&self) -> Vec<usize> {
        let is_shape = self.scattered == Scattered::Vertices;
        let scattered = self.runs().into_iter().filter(|run| is_shape && !self.is_predicted(run));
        let edges = scattered.flat_map(|run| run.into_iter().flat_map(|i| [self.before(i), i]));
        edges.filter(|edge| self.sagitta(*edge) > MATTERS * self.tolerance).collect()
    }
}
