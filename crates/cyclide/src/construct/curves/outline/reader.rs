//! The points of a polyline while they are read: how each turns, how far an edge is left by a curve through its ends, and the runs
//! between corners.

use super::predicted::unpredicted;
use super::straight_runs::StraightRuns;
use super::{CORNER_ANGLE, Outline, Scattered};
use crate::base::vector::{Point3, Vec3};

/// Beside corners and straight sides the edges between samples are bound too, up to this sagitta in tolerances: an arc within
/// the tolerance of two samples and of their edge exists up to 2.
const BOUND_SAGITTA: f64 = 1.5;
/// Turns below this part of the corner angle are none.
const NO_TURN: f64 = 1e-3;
/// Legs over which a corner lasts where noise may have caused the turn, in tolerances.
const LEGS: f64 = 8.0;
/// With legs half as long a corner keeps this part of its turn; a bend keeps half.
const SHARP: f64 = 0.75;
/// Samples are off from where two neighbors on either side say by at most this part of what they are from where one says.
const PREDICTED: f64 = 0.6;

/// The points of a polyline with what is known of each so far.
pub(super) struct Reader<'a> {
    pub(super) points: &'a [Point3],
    pub(super) closed: bool,
    pub(super) tolerance: f64,
    pub(super) scattered: Scattered,
    /// Turn at each point about its axis; zero at the ends of open data.
    pub(super) turns: Vec<Vec3>,
    /// Length of the edge that begins at each point.
    pub(super) lengths: Vec<f64>,
    pub(super) corner: Vec<bool>,
    pub(super) straight: Vec<bool>,
    /// Edges between points that are no samples, whatever is beside them.
    pub(super) held: Vec<bool>,
    pub(super) runs: StraightRuns,
}

impl<'a> Reader<'a> {
    pub(super) fn new(points: &'a [Point3], closed: bool, tolerance: f64, scattered: Scattered) -> Self {
        let n = points.len();
        let lengths = (0..n).map(|i| points[i].distance(points[(i + 1) % n])).collect();
        let mut reader = Self {
            points,
            closed,
            tolerance,
            scattered,
            turns: vec![Vec3::ZERO; n],
            lengths,
            corner: vec![false; n],
            straight: vec![false; n],
            held: vec![false; n],
            runs: StraightRuns::default(),
        };
        for i in (0..n).filter(|i| reader.is_inside(*i)).collect::<Vec<_>>() {
            let (u, v) = (points[i] - points[(i + n - 1) % n], points[(i + 1) % n] - points[i]);
            // A reversal has no axis, and needs none.
            let axis = u.cross(v).unit().or_else(|| u.unit().map(Vec3::any_perpendicular)).unwrap_or(Vec3::Z);
            reader.turns[i] = axis * u.angle(v);
        }
        let sharpest = (0..n).max_by(|i, j| reader.turn(*i).total_cmp(&reader.turn(*j))).unwrap_or(0);
        reader.runs = StraightRuns::of(points, if closed { Some(sharpest) } else { None });
        reader
    }

    pub(super) fn finished(self, has_sides: bool) -> Outline {
        let n = self.n();
        let corners = (0..n).filter(|i| self.corner[*i]).map(|i| (i, self.turn(i))).collect();
        let low = |edge: usize| self.sagitta(edge) <= BOUND_SAGITTA * self.tolerance;
        let has_noise = self.scattered == Scattered::Noise && self.runs().iter().any(|run| !self.is_predicted(run));
        let bound = (0..n).map(|edge| has_sides && (self.straight[edge] || low(edge))).collect();
        let firm = (0..n).filter(|i| self.is_firm(*i)).collect();
        Outline { corners, straight: self.straight, bound, has_noise, firm }
    }

    pub(super) fn n(&self) -> usize {
        self.points.len()
    }

    /// No end of an open polyline.
    pub(super) fn is_inside(&self, vertex: usize) -> bool {
        self.closed || (vertex > 0 && vertex + 1 < self.n())
    }

    pub(super) fn turn(&self, vertex: usize) -> f64 {
        self.turns[vertex].length()
    }

    /// By more than the rounding of the coordinates.
    pub(super) fn does_turn(&self, vertex: usize) -> bool {
        self.turn(vertex) > NO_TURN * CORNER_ANGLE && !self.runs.is_inside(vertex)
    }

    pub(super) fn before(&self, index: usize) -> usize {
        (index + self.n() - 1) % self.n()
    }

    pub(super) fn after(&self, index: usize) -> usize {
        (index + 1) % self.n()
    }

    /// A curve may run through the point: neither a corner nor an end.
    pub(super) fn is_passed(&self, vertex: usize) -> bool {
        self.is_inside(vertex) && !self.corner[vertex]
    }

    /// Whether noise within the tolerance explains no such turn. It turns an edge of length `l` by up to `2 tolerance/l`,
    /// so between short edges the turn must last over legs of some tolerances.
    pub(super) fn lasts(&self, vertex: usize) -> bool {
        let turn = self.turn(vertex);
        let shorter = self.lengths[self.before(vertex)].min(self.lengths[vertex]);
        if shorter * (0.5 * turn).sin() > 2.0 * self.tolerance {
            return true;
        }
        let over = |length: f64| {
            let (before, at, after) =
                (self.leg(vertex, length, false), self.points[vertex], self.leg(vertex, length, true));
            (at - before).angle(after - at)
        };
        let long = over(LEGS * self.tolerance);
        long > CORNER_ANGLE && over(0.5 * LEGS * self.tolerance) > SHARP * long
    }

    /// The nearest point along the polyline that is a length away, or the last on that side.
    pub(super) fn leg(&self, vertex: usize, length: f64, forward: bool) -> Point3 {
        let n = self.n();
        let steps = match (self.closed, forward) {
            (true, _) => n / 2,
            (false, true) => n - 1 - vertex,
            (false, false) => vertex,
        };
        let at = |k: usize| self.points[if forward { vertex + k } else { vertex + n - k } % n];
        let far = |p: &Point3| p.distance(self.points[vertex]) >= length;
        (1..=steps).map(at).find(far).unwrap_or_else(|| at(steps.max(1)))
    }

    /// The part of the turn at one end of an edge that falls to the edge; `None` at corners and ends. A straight side takes none.
    pub(super) fn share(&self, edge: usize, vertex: usize, neighbor: usize) -> Option<f64> {
        let length = self.lengths[edge];
        let beyond = if self.straight[neighbor] { 0.0 } else { self.lengths[neighbor] };
        self.is_passed(vertex).then(|| self.turn(vertex) * length / (length + beyond))
    }

    /// What a curve through the points turns over an edge: up to a corner or an end on as at the other end.
    pub(super) fn edge_turn(&self, edge: usize) -> f64 {
        let next = self.after(edge);
        match (self.share(edge, edge, self.before(edge)), self.share(edge, next, next)) {
            (Some(a), Some(b)) => a + b,
            (Some(one), None) | (None, Some(one)) => 2.0 * one,
            (None, None) => 0.0,
        }
    }

    pub(super) fn sagitta(&self, edge: usize) -> f64 {
        self.edge_turn(edge) * self.lengths[edge] / 8.0
    }

    /// Whether the points of a run are where their neighbors say, as samples of a curve are.
    pub(super) fn is_predicted(&self, run: &[usize]) -> bool {
        unpredicted(self.windows(run), self.tolerance) <= PREDICTED
    }

    /// Five points in a row each, of a run with the corners or ends beside it, without straight sides.
    pub(super) fn windows<'b>(&'b self, run: &'b [usize]) -> impl Iterator<Item = [Point3; 5]> + 'b {
        let n = self.n();
        let first = run.first().copied().unwrap_or(0);
        let (from, count) = if run.len() == n { (first, n) } else { (self.before(first), run.len().saturating_sub(2)) };
        let is_curved = move |i: &usize| (0..4).all(|k| !self.straight[(i + k) % n]);
        let window = move |i: usize| [0, 1, 2, 3, 4].map(|k| self.points[(i + k) % n]);
        (from..from + count).filter(is_curved).map(window)
    }

    /// The points that curves pass between two corners, run by run.
    pub(super) fn runs(&self) -> Vec<Vec<usize>> {
        let n = self.n();
        let first = (0..n).find(|i| !self.is_passed(*i)).unwrap_or(0);
        let mut runs = vec![Vec::new()];
        for i in (0..n).map(|k| (first + k) % n) {
            if self.is_passed(i) {
                if let Some(run) = runs.last_mut() {
                    run.push(i);
                }
            } else {
                runs.push(Vec::new());
            }
        }
        runs
    }
}
