//! Which points of a polyline are corners, and which of its edges are straight sides: the reading of points that are
//! given without a word about what they are (`docs/math/arc-fitting.md#outlines`).
//!
//! Points are samples of a smooth curve wherever such a curve explains them. Nobody samples a curve with fewer than six
//! points to a full turn, and no sampling (equal steps, equal angles, equal sagittas) jumps in length and sagitta at
//! once from one edge to the next but where the curve turns into a straight line. So a point is a *corner* that turns
//! more than samples do, and an edge is a *straight side* that is much longer than the samples beside it and would be
//! left by much more than they are. Everything is measured in angles and in ratios of lengths; the tolerance only says
//! what noise may have caused.

mod decimals;
mod predicted;
mod straight_runs;

use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::arc_fit::input::diameter;
use crate::warning::{FitWarning, Warning};
pub(super) use decimals::decimal_step;
use predicted::unpredicted;
use std::collections::HashSet;
use std::f64::consts::PI;
use straight_runs::StraightRuns;

/// No smooth curve is farther than this part of it from the edge between two of its samples: an arc of 65 degrees, more than which
/// none has between two (`docs/math/arc-fitting.md#outlines`).
pub(super) const SAMPLE_SAGITTA: f64 = 0.146;
/// A finer reading of an outline has at most this many times the corners.
const MORE: usize = 2;
/// Where a curve leaves the edges, corners and sides are looked for that last over these parts of the tolerance: details of an
/// outline may be smaller than that, and its sides are not. With them the curve
pub(super) const FINER: [f64; 2] = [1.0 / 8.0, 1.0 / 64.0];
/// has to be within this many tolerances of all edges.
pub(super) const NEAR: f64 = 2.0;
/// Turns above this may be corners.
pub(super) const CORNER_ANGLE: f64 = PI / 6.0;
/// A turn above this is a reversal: no smooth curve turns so far from one sample to the next.
const CUSP_ANGLE: f64 = 150.0 * PI / 180.0;
/// No smooth curve is sampled with fewer points to a full turn than this angle gives; a hexagon turns by 60 degrees.
const LARGEST_SAMPLE_TURN: f64 = 65.0 * PI / 180.0;
/// A corner stands out if its turn is this many times those of its neighbors, and samples support a turn that
/// is at most this many times their own.
const PROMINENCE: f64 = 3.0;
/// Neighboring edges of samples differ in length by at most this factor, without a change of the curvature by a lot.
const STEP: f64 = 3.0;
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
/// With so few turning points between two corners or straight sides there is no curve.
const FEW: usize = 2;
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
/// Noise is told by pairs of neighbors that turn by more than this, up to a sample's largest turn,
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
/// Corners leave others without support; so often at most.
const MAX_PASSES: usize = 16;

/// Figures of fewer points than this are polygons as well as samples,
const FEW_POINTS: usize = 24;
/// if their points turn by more than this: a 24th of a full turn.
const LARGE_TURN: f64 = PI / 12.0;
/// Turns below this, a sixtieth of a degree, are none.
const SOME_TURN: f64 = PI / 10_800.0;
/// A curve through samples is farther from their polyline than this many tolerances.
const AWAY: f64 = 2.0;

/// What the points of a polyline are read as.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::construct) struct Outline {
    /// Corners in ascending order, with their turn in radians; the ends of an open polyline are none.
    pub corners: Vec<(usize, f64)>,
    /// Whether the edge that begins at each point is a straight side: the curve keeps to it, both ways. (The last entry of
    /// an open polyline means nothing.)
    pub straight: Vec<bool>,
    /// Whether the curve keeps to the edge that begins at each point: straight sides, and in an outline with corners or
    /// straight sides the edges between samples as far as arcs of several samples can keep to them.
    pub bound: Vec<bool>,
    /// Whether points that are not where their neighbors say were taken for noisy samples.
    pub has_noise: bool,
    /// Points where a straight run of others ends at an angle that no samples have: corners whatever noise may do.
    pub firm: Vec<usize>,
}

/// Without a tolerance noise may move points by this part of their size.
const EXACT: f64 = 1e-9;

/// What points are that are not where their neighbors say.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scattered {
    /// Vertices of an outline.
    Vertices,
    /// Measured, with noise.
    Noise,
}

impl Outline {
    /// Reads the points of a polyline; neighbors must differ.
    ///
    /// `angle`, in radians: turns above it are corners and nothing else is, but for the points `forced` (by index,
    /// ascending). `None`: turns above 30 degrees, where samples of a smooth curve do not explain them, and reversals, above
    /// 150 degrees. `tolerance`: how far noise may have moved the points. `scattered`: whether it may have moved them farther.
    pub fn read(
        points: &[Point3],
        closed: bool,
        tolerance: f64,
        angle: Option<f64>,
        forced: &[usize],
        scattered: Scattered,
    ) -> Self {
        let mut reader = Reader::new(points, closed, tolerance, scattered);
        let noisy = scattered == Scattered::Noise && reader.is_noisy();
        let limit = angle.unwrap_or(CORNER_ANGLE) * (1.0 + 1e-9);
        for i in 0..points.len() {
            let turn = reader.turn(i);
            let evident = turn > limit && (angle.is_some() || reader.is_evident_corner(i, noisy));
            let evident = evident || (angle.is_none() && reader.is_firm(i) && reader.lasts(i));
            // Points that noise moves past each other turn back too.
            let reversal = angle.is_none() && turn > CUSP_ANGLE && reader.lasts(i);
            reader.corner[i] = reader.is_inside(i) && (forced.binary_search(&i).is_ok() || reversal || evident);
        }
        if noisy {
            return reader.finished(false);
        }
        reader.find_straight_sides();
        if angle.is_none() {
            reader.zigzags().into_iter().for_each(|i| reader.corner[i] = true);
            for _ in 0..MAX_PASSES {
                let (turns, edges) = (reader.unsupported_turns(limit), reader.edges_between_scattered_points());
                if turns.is_empty() && edges.is_empty() {
                    break;
                }
                turns.into_iter().for_each(|i| reader.corner[i] = true);
                edges.into_iter().for_each(|edge| reader.held[edge] = true);
                reader.find_straight_sides();
            }
        }
        let has_sides = reader.corner.contains(&true) || reader.straight.contains(&true);
        reader.finished(has_sides)
    }

    /// The other reading, of a finer tolerance, is another one of the same figure: it has more details, where noise would have
    /// nothing else.
    pub fn is_coarser(&self, other: &Self) -> bool {
        self != other && other.corners.len() <= MORE * self.corners.len()
    }

    /// What is said where points of an outline, or of a figure of few points, that turn by a lot were read as samples, and that matters:
    /// the curve is `distance` from their polyline. `has_target`: the fit has a target `polyline` that keeps to all edges.
    pub fn read_as_curve(
        &self,
        points: &[Point3],
        closed: bool,
        tolerance: f64,
        distance: f64,
        has_target: bool,
    ) -> Option<Warning> {
        let n = points.len();
        let is_few = n < FEW_POINTS;
        if !(is_few || self.has_noise || self.bound.contains(&true)) || distance <= AWAY * tolerance {
            return None;
        }
        let is_sample = |i: &usize| {
            let corner = self.corners.binary_search_by_key(i, |corner| corner.0).is_ok();
            !corner && !self.straight[*i] && !self.straight[(i + n - 1) % n]
        };
        // Few points are a polygon as well whatever they turn by.
        let least = if is_few { SOME_TURN } else { LARGE_TURN };
        let turn = |i: usize| (points[i] - points[(i + n - 1) % n]).angle(points[(i + 1) % n] - points[i]);
        let inside = if closed { 0..n } else { 1..n - 1 };
        let (count, turn) = inside
            .filter(is_sample)
            .map(turn)
            .filter(|turn| *turn > least)
            .fold((0, 0.0_f64), |most, turn| (most.0 + 1, most.1.max(turn)));
        (count > 0).then_some(Warning::Fit(FitWarning::ReadAsCurve { count, turn, distance, has_target }))
    }
}

/// What the points of a polyline are if no curve is meant: the numbers of those that are corners, and of those where an edge begins
/// that is a straight side, both ascending. A polyline of samples of a smooth curve has neither (`docs/math/arc-fitting.md#outlines`).
///
/// Lengths may have any unit. Two equal neighbors, or fewer than three points, or numbers that are not finite: there are none.
///
/// ```
/// use cyclide::{Point3, construct::outline_corners};
/// let rectangle = [[0.0, 0.0], [60.0, 0.0], [60.0, 40.0], [0.0, 40.0]].map(|[x, y]| Point3::new(x, y, 0.0));
/// assert_eq!(outline_corners(&rectangle, true), (vec![0, 1, 2, 3], vec![]));
/// let circle: Vec<Point3> = (0..40).map(|k| f64::from(k) * 0.157).map(|a| Point3::new(a.cos(), a.sin(), 0.0)).collect();
/// assert_eq!(outline_corners(&circle, false), (vec![], vec![]));
/// ```
#[must_use]
pub fn outline_corners(points: &[Point3], closed: bool) -> (Vec<usize>, Vec<usize>) {
    let n = points.len();
    let edges = if closed { n } else { n.saturating_sub(1) };
    let edge = |i: usize| points[i].distance(points[(i + 1) % n]);
    let size = diameter(points);
    if n < 3 || !size.is_finite() || (0..edges).any(|i| !(edge(i) > EXACT * size)) {
        return (Vec::new(), Vec::new());
    }
    let outline = Outline::read(points, closed, EXACT * size, None, &[], Scattered::Vertices);
    let sides = (0..edges).filter(|i| outline.straight[*i]).collect();
    (outline.corners.into_iter().map(|corner| corner.0).collect(), sides)
}

/// What is said of corners that are kept, one line for all of them; `source` has the number of each point in the user's list.
pub(in crate::construct) fn kept_corners(corners: &[(usize, f64)], source: &[usize]) -> Option<Warning> {
    let (_, angle) = *corners.first()?;
    let angles = corners.iter().map(|corner| corner.1);
    let (least, most) = angles.fold((angle, angle), |(least, most), a| (least.min(a), most.max(a)));
    let vertex = corners.iter().map(|corner| source[corner.0]).min()?;
    Some(Warning::Fit(FitWarning::CornerKept { vertex, count: corners.len(), least, most }))
}

struct Reader<'a> {
    points: &'a [Point3],
    closed: bool,
    tolerance: f64,
    scattered: Scattered,
    /// Turn at each point about its axis; zero at the ends of open data.
    turns: Vec<Vec3>,
    /// Length of the edge that begins at each point.
    lengths: Vec<f64>,
    corner: Vec<bool>,
    straight: Vec<bool>,
    /// Edges between points that are no samples, whatever stands beside them.
    held: Vec<bool>,
    runs: StraightRuns,
}

impl<'a> Reader<'a> {
    fn new(points: &'a [Point3], closed: bool, tolerance: f64, scattered: Scattered) -> Self {
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

    fn finished(self, has_sides: bool) -> Outline {
        let n = self.n();
        let corners = (0..n).filter(|i| self.corner[*i]).map(|i| (i, self.turn(i))).collect();
        let low = |edge: usize| self.sagitta(edge) <= BOUND_SAGITTA * self.tolerance;
        let has_noise = self.scattered == Scattered::Noise && self.runs().iter().any(|run| !self.is_predicted(run));
        let bound = (0..n).map(|edge| has_sides && (self.straight[edge] || low(edge))).collect();
        let firm = (0..n).filter(|i| self.is_firm(*i)).collect();
        Outline { corners, straight: self.straight, bound, has_noise, firm }
    }

    /// Noise above the tolerance turns points to and fro by all sorts of angles.
    fn is_noisy(&self) -> bool {
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

    fn n(&self) -> usize {
        self.points.len()
    }

    /// No end of an open polyline.
    fn is_inside(&self, vertex: usize) -> bool {
        self.closed || (vertex > 0 && vertex + 1 < self.n())
    }

    fn turn(&self, vertex: usize) -> f64 {
        self.turns[vertex].length()
    }

    /// By more than the rounding of the coordinates.
    fn does_turn(&self, vertex: usize) -> bool {
        self.turn(vertex) > NO_TURN * CORNER_ANGLE && !self.runs.is_inside(vertex)
    }

    fn before(&self, index: usize) -> usize {
        (index + self.n() - 1) % self.n()
    }

    fn after(&self, index: usize) -> usize {
        (index + 1) % self.n()
    }

    /// A curve may run through the point: neither a corner nor an end.
    fn is_passed(&self, vertex: usize) -> bool {
        self.is_inside(vertex) && !self.corner[vertex]
    }

    /// Of a turn above the corner angle: it stands out, or is more than a sample's, and noise within the tolerance has not caused it.
    fn is_evident_corner(&self, vertex: usize, noisy: bool) -> bool {
        let turn = self.turn(vertex);
        let neighbors = self.turn(self.before(vertex)).max(self.turn(self.after(vertex)));
        let stands_out = turn > PROMINENCE * neighbors;
        (stands_out || (turn > LARGEST_SAMPLE_TURN && !noisy)) && self.lasts(vertex)
    }

    /// Whether a straight run of points ends there at an angle that no samples have: over the edge beyond a curve turns by twice the
    /// angle to the run, or by both angles if there is a run beyond too.
    fn is_firm(&self, vertex: usize) -> bool {
        let may_end = |i: usize| self.is_inside(i) && self.runs.may_end_at(i);
        let bends_with = |other: usize| {
            let is_bend = may_end(other) && self.turns[vertex].dot(self.turns[other]) > 0.0;
            is_bend && self.turn(vertex) + self.turn(other) > LARGEST_SAMPLE_TURN
        };
        let part = if self.runs.ends_at(vertex) { 0.5 } else { 1.0 };
        let is_sharp = self.turn(vertex) > part * LARGEST_SAMPLE_TURN;
        may_end(vertex) && (is_sharp || bends_with(self.before(vertex)) || bends_with(self.after(vertex)))
    }

    /// Whether noise within the tolerance explains no such turn. It turns an edge of length `l` by up to `2 tolerance/l`,
    /// so between short edges the turn must last over legs of some tolerances.
    fn lasts(&self, vertex: usize) -> bool {
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
    fn leg(&self, vertex: usize, length: f64, forward: bool) -> Point3 {
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
    fn share(&self, edge: usize, vertex: usize, neighbor: usize) -> Option<f64> {
        let length = self.lengths[edge];
        let beyond = if self.straight[neighbor] { 0.0 } else { self.lengths[neighbor] };
        self.is_passed(vertex).then(|| self.turn(vertex) * length / (length + beyond))
    }

    /// What a curve through the points turns over an edge: up to a corner or an end on as at the other end.
    fn edge_turn(&self, edge: usize) -> f64 {
        let next = self.after(edge);
        match (self.share(edge, edge, self.before(edge)), self.share(edge, next, next)) {
            (Some(a), Some(b)) => a + b,
            (Some(one), None) | (None, Some(one)) => 2.0 * one,
            (None, None) => 0.0,
        }
    }

    fn sagitta(&self, edge: usize) -> f64 {
        self.edge_turn(edge) * self.lengths[edge] / 8.0
    }

    fn find_straight_sides(&mut self) {
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

    /// Turns that no samples support: above the limit, a neighbor has to turn the same way by a third of it, over edges of
    /// comparable length, none of them a straight side; and the points of the run up to the next corners have to turn by less
    /// than the limit on average, and to be where their neighbors say, as samples of a curve are.
    fn unsupported_turns(&self, limit: f64) -> Vec<usize> {
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

    /// The edges that matter between points that are not where their neighbors say.
    fn edges_between_scattered_points(&self) -> Vec<usize> {
        let is_shape = self.scattered == Scattered::Vertices;
        let scattered = self.runs().into_iter().filter(|run| is_shape && !self.is_predicted(run));
        let edges = scattered.flat_map(|run| run.into_iter().flat_map(|i| [self.before(i), i]));
        edges.filter(|edge| self.sagitta(*edge) > MATTERS * self.tolerance).collect()
    }

    /// Whether the points of a run are where their neighbors say, as samples of a curve are.
    fn is_predicted(&self, run: &[usize]) -> bool {
        unpredicted(self.windows(run), self.tolerance) <= PREDICTED
    }

    /// Five points in a row each, of a run with the corners or ends beside it, without straight sides.
    fn windows<'b>(&'b self, run: &'b [usize]) -> impl Iterator<Item = [Point3; 5]> + 'b {
        let n = self.n();
        let first = run.first().copied().unwrap_or(0);
        let (from, count) = if run.len() == n { (first, n) } else { (self.before(first), run.len().saturating_sub(2)) };
        let is_curved = move |i: &usize| (0..4).all(|k| !self.straight[(i + k) % n]);
        let window = move |i: usize| [0, 1, 2, 3, 4].map(|k| self.points[(i + k) % n]);
        (from..from + count).filter(is_curved).map(window)
    }

    /// Points in runs of at most two that turn to one side by a lot each, between two such runs to the other side: a curve that
    /// turns to and fro has more samples to each bend.
    fn zigzags(&self) -> Vec<usize> {
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

    /// The points that curves pass between two corners, run by run.
    fn runs(&self) -> Vec<Vec<usize>> {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(points: &[[f64; 2]]) -> Vec<Point3> {
        points.iter().map(|p| Point3::new(p[0], p[1], 0.0)).collect()
    }

    fn polygon(n: usize, radius: f64) -> Vec<Point3> {
        let at = |i: usize| {
            let (s, c) = (2.0 * PI * i as f64 / n as f64).sin_cos();
            Point3::new(radius * c, radius * s, 0.0)
        };
        (0..n).map(at).collect()
    }

    fn read(points: &[Point3]) -> Outline {
        Outline::read(points, true, 0.02, None, &[], Scattered::Vertices)
    }

    #[test]
    fn regular_polygons_are_outlines_below_twelve_points() {
        for n in 3..=60 {
            let outline = read(&polygon(n, 30.0));
            assert_eq!(outline.corners.len(), if n < 12 { n } else { 0 }, "{n}");
            assert!(!outline.straight.contains(&true));
        }
    }

    #[test]
    fn a_slot_has_two_straight_sides_and_no_corner() {
        let end = |x: f64, from: f64| {
            (0..=25).map(move |i| {
                let (s, c) = (from + PI * f64::from(i) / 25.0).sin_cos();
                Point3::new(x + 4.0 * c, 4.0 * s, 0.0)
            })
        };
        let slot: Vec<_> = end(11.0, -0.5 * PI).chain(end(-11.0, 0.5 * PI)).collect();
        let outline = read(&slot);
        assert!(outline.corners.is_empty());
        let straight: Vec<_> = (0..slot.len()).filter(|i| outline.straight[*i]).collect();
        assert_eq!(straight, [25, 51]);
    }

    #[test]
    fn chamfers_and_bevels_are_outlines() {
        // A rectangle of 60 x 40 with chamfers of 3.
        let chamfered = flat(&[
            [3.0, 0.0],
            [57.0, 0.0],
            [60.0, 3.0],
            [60.0, 37.0],
            [57.0, 40.0],
            [3.0, 40.0],
            [0.0, 37.0],
            [0.0, 3.0],
        ]);
        assert_eq!(read(&chamfered).corners.len(), 8);
        // One long side is broken by 10 degrees: two straight sides.
        let broken = flat(&[[0.0, 0.0], [30.0, -2.6], [60.0, 0.0], [60.0, 40.0], [0.0, 40.0]]);
        let outline = read(&broken);
        assert_eq!(outline.corners.len(), 4);
        assert!(outline.straight[0] && outline.straight[1]);
    }

    #[test]
    fn dense_samples_of_smooth_curves_are_curves() {
        // Ellipses, by equal angles of the parameter: steps of length and of curvature.
        for (a, n) in [(1.0, 60), (3.0, 60), (10.0, 60), (10.0, 200), (30.0, 400)] {
            let at = |i: usize| {
                let (s, c) = (2.0 * PI * i as f64 / n as f64).sin_cos();
                Point3::new(a * c, s, 0.0)
            };
            let points: Vec<_> = (0..n).map(at).collect();
            let outline = Outline::read(&points, true, 1e-3, None, &[], Scattered::Vertices);
            assert!(!outline.bound.contains(&true), "{a}, {n}");
        }
    }

    #[test]
    fn uneven_samples_of_waves_are_curves_too() {
        // A fixed sequence in [-1/2, 1/2).
        let mut state = 7_u64;
        let mut random = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / (1_u64 << 31) as f64 - 0.5
        };
        for _ in 0..100 {
            let waves = [2.0, 3.0, 4.0, 5.0].map(|n| [n, 0.4 / n * random(), 2.0 * PI * random()]);
            let n = (150.0 + 100.0 * random()) as usize;
            let mut at = |i: usize| {
                let a = 2.0 * PI * (i as f64 + 0.6 * random()) / n as f64;
                let r = 50.0 * waves.iter().fold(1.0, |r, [n, depth, phase]| r + depth * (n * a + phase).cos());
                Point3::new(r * a.cos(), r * a.sin(), 0.0)
            };
            let points: Vec<_> = (0..n).map(&mut at).collect();
            for tolerance in [0.1, 0.01, 0.001] {
                let outline = Outline::read(&points, true, tolerance, None, &[], Scattered::Vertices);
                assert!(outline.corners.is_empty() && !outline.straight.contains(&true), "{n} points");
            }
        }
    }

    #[test]
    fn an_angle_that_is_given_is_obeyed() {
        let points = polygon(24, 10.0);
        let corners =
            |angle: f64| Outline::read(&points, true, 0.02, Some(angle), &[], Scattered::Vertices).corners.len();
        assert_eq!((corners(0.2), corners(0.3)), (24, 0));
        assert_eq!(Outline::read(&polygon(4, 1.0), true, 0.01, Some(2.0), &[2], Scattered::Vertices).corners.len(), 1);
    }
}
