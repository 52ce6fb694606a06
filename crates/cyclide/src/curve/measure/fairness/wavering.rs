//! Does a curve bend to and fro more often than its data do?
//!
//! The data are the nodes at which the pieces of the curve meet, cut at its corners, or points that are given; the polygon
//! through them turns left or right at each, or not at all. A turn counts as none if rounding can make it, or if it is below
//! a fiftieth of one beside it. What the data account for are the polygon's own changes of side, and three more for every
//! passage between a straight run and a turn: there an interpolating curve without a jump of curvature swings out, and
//! dies down by a factor of 2 - sqrt 3 from node to node. A run is two nodes or more: a single node without a turn is where
//! the curve changes sides, or where it bends least.
//!
//! What counts is the *amplitude*, of the curve and of its data alike, and of every kind of curve: the curve is divided into
//! [bends](super::bends), runs that turn to one side, and a bend counts if the curve turns in it by more than 5e-4 radians
//! and a fiftieth of the turns of the polygon beside it. In a bend of one chord that is 6e-5 of the chord off a straight line. In space turns are one bend as long as each axis is within a right angle of the one before;
//! the axis of a curve that winds turns slowly, and changes nothing.
//!
//! A node that turns by 30 degrees or more between two that go straight on looks like a corner. Where the curve leaves the
//! edges beside it by more than a twentieth of them, it goes round a corner that was not marked.
//!
//! *The curve wavers* if it changes sides more than 1.25 times as often, and two times more. *The data waver* if there
//! are 16 nodes or more, those that turn do so gently (by less than 30 degrees in the median; stairs do not), and they
//! change sides at more than every third: then they carry noise, and a curve through all of them has to show it.

use super::CORNER_ANGLE;
use super::bends::{LEAST_TURN, STRAIGHT, changes, curve_changes};
use super::piece::ROUNDING;
use crate::base::vector::{Point3, Vec3};
use crate::curve::ParamCurve;
use crate::curve::measure::continuity::joints;

/// A turn between straight runs from here on looks like a corner, if the curve leaves its edges by this part of them.
const SHARP: f64 = std::f64::consts::FRAC_PI_6;
const SWING: f64 = 0.05;
/// The curve wavers beyond this many times what the data account for, and this many more.
const TIMES: f64 = 1.25;
const MORE: f64 = 2.0;
/// Changes of side that the end of a straight run accounts for.
const AT_PASSAGE: usize = 3;
/// Data that waver are at least so many and turn in the median by less than this.
const MANY: usize = 16;
const GENTLE: f64 = std::f64::consts::FRAC_PI_6;

/// A curve against its data.
///
/// ```
/// use cyclide::{Point3, construct::FairSplineOptions, curve::{CircleSpline, wavering}};
/// let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [4.0, 1.5, 0.0], [6.0, 1.0, 0.0]].map(Point3::from);
/// let spline = CircleSpline::fair(&points, &FairSplineOptions::default())?;
/// assert!(!wavering(&spline).curve_wavers);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Wavering {
    /// Changes of the curve between turning left and turning right, by bends that count.
    pub curve: usize,
    /// Those of its data.
    pub data: usize,
    /// Those that its data account for: their own, and three at each end of a straight run.
    pub explained: usize,
    /// Nodes of the data, corners excepted.
    pub nodes: usize,
    /// The curve changes sides far more often than its data account for.
    pub curve_wavers: bool,
    /// The data themselves change sides as noise does.
    pub data_waver: bool,
    /// Turns that look like corners, which the curve goes round.
    pub rounded: Option<RoundedTurns>,
}

/// Nodes at which the polygon turns sharply between straight runs, and which the curve passes smoothly.
///
/// ```
/// use cyclide::{Point3, construct::FairSplineOptions, curve::{CircleSpline, RoundedTurns, wavering}};
/// let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [4.0, 1.5, 0.0], [6.0, 1.0, 0.0]].map(Point3::from);
/// let spline = CircleSpline::fair(&points, &FairSplineOptions::default())?;
/// let rounded: Option<RoundedTurns> = wavering(&spline).rounded;
/// assert!(rounded.is_none()); // no sharp turn between straight runs
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct RoundedTurns {
    /// The first of them, from 0.
    pub first: usize,
    /// How many there are.
    pub count: usize,
    /// Their largest turn, radians.
    pub angle: f64,
    /// How far the curve leaves the edges beside them.
    pub distance: f64,
}

/// Compares a curve with the polygon of the nodes between its pieces.
///
/// ```
/// use cyclide::{Point3, construct::FairSplineOptions, curve::CircleSpline};
/// let points = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]].map(Point3::from);
/// let spline = CircleSpline::fair(&points, &FairSplineOptions { closed: true, ..Default::default() })?;
/// assert!(!cyclide::curve::wavering(&spline).curve_wavers);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn wavering(curve: &dyn ParamCurve) -> Wavering {
    let runs = turns(curve);
    // The largest turn at the ends of each piece: what a bend of the piece is held against.
    let mut beside = vec![0.0_f64; curve.piece_count()];
    for turn in runs.iter().flat_map(|run| &run.turns) {
        turn.pieces.into_iter().for_each(|piece| beside[piece] = beside[piece].max(turn.axis.length()));
    }
    let mut found = of_data(&runs, curve_changes(curve, &beside));
    for run in &runs {
        run.add_rounded(curve, &run.axes(), &mut found.rounded);
    }
    found
}

/// Compares a curve with the polygon of points through or near which it was laid, or of points of it.
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let points = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(points[0], points[1], points[2])?;
/// assert!(!cyclide::curve::wavering_against(&arc, &points).curve_wavers);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn wavering_against(curve: &dyn ParamCurve, points: &[Point3]) -> Wavering {
    let (n, closed) = (points.len(), curve.is_closed());
    let inner = if closed { 0..n } else { 1..n.saturating_sub(1).max(1) };
    let turns: Vec<Turn> =
        inner.map(|i| Turn::new([points[(i + n - 1) % n], points[i], points[(i + 1) % n]], [0; 2])).collect();
    of_data(&[Turns { turns, closed }], curve_changes(curve, &vec![0.0; curve.piece_count()]))
}

/// The figures of the data, and what they say of a curve that changes sides so often.
fn of_data(runs: &[Turns], curve: usize) -> Wavering {
    let (mut data, mut passages, mut turning) = (0, 0, Vec::new());
    for run in runs {
        let mut axes = run.axes();
        turning.extend(axes.iter().flatten().map(|axis| axis.length()));
        data += changes(&mut axes, |_| LEAST_TURN, run.closed);
        passages += run.passages(&axes);
    }
    turning.sort_by(f64::total_cmp);
    let median = turning.get(turning.len() / 2).copied().unwrap_or(0.0);
    let nodes = runs.iter().map(|run| run.turns.len()).sum();
    let explained = data + AT_PASSAGE * passages;
    Wavering {
        curve,
        data,
        explained,
        nodes,
        curve_wavers: curve as f64 > TIMES * explained as f64 + MORE,
        data_waver: nodes >= MANY && median < GENTLE && 3 * data > nodes,
        rounded: None,
    }
}

/// The chord of a piece, and how far the piece leaves it, looked at in three places.
fn swing(curve: &dyn ParamCurve, piece: usize) -> [f64; 2] {
    let [from, to] = [0.0, 1.0].map(|s| curve.piece_point(piece, s));
    let along = (to - from).unit().unwrap_or(Vec3::ZERO);
    let off = |s: f64| (curve.piece_point(piece, s) - from).cross(along).length();
    [from.distance(to), [0.25, 0.5, 0.75].map(off).into_iter().fold(0.0, f64::max)]
}

/// The turn of the polygon at a node as its axis times its angle, and what rounding can make of it.
struct Turn {
    axis: Vec3,
    rounding: f64,
    /// The pieces of the curve that end and begin there.
    pieces: [usize; 2],
}

impl Turn {
    /// At the middle one of three nodes.
    fn new([before, at, after]: [Point3; 3], pieces: [usize; 2]) -> Self {
        let (a, b) = (at - before, after - at);
        let rounding = ROUNDING * (1.0 + at.to_vec().max_abs() / a.length().min(b.length()));
        let axis = a.cross(b).unit().map_or(Vec3::ZERO, |axis| axis * a.angle(b));
        Self { axis, rounding, pieces }
    }
}

/// The nodes of a smooth run.
struct Turns {
    turns: Vec<Turn>,
    closed: bool,
}

impl Turns {
    /// The axes of the turns, `None` where the polygon goes straight on.
    fn axes(&self) -> Vec<Option<Vec3>> {
        let size = |i: Option<usize>| i.and_then(|i| self.turns.get(i)).map_or(0.0, |t| t.axis.length());
        let axis = |(i, turn): (usize, &Turn)| {
            let [before, after] = self.beside(i);
            let straight = turn.rounding.max(STRAIGHT * size(before).max(size(after)));
            (turn.axis.length() > straight).then_some(turn.axis)
        };
        self.turns.iter().enumerate().map(axis).collect()
    }

    /// The nodes before and after one.
    fn beside(&self, i: usize) -> [Option<usize>; 2] {
        let n = self.turns.len();
        let before = if i > 0 { Some(i - 1) } else { self.closed.then_some(n - 1) };
        let after = if i + 1 < n { Some(i + 1) } else { self.closed.then_some(0) };
        [before, after]
    }

    /// Adds the turns between straight edges that the curve swings round.
    fn add_rounded(&self, curve: &dyn ParamCurve, axes: &[Option<Vec3>], found: &mut Option<RoundedTurns>) {
        let is_straight = |i: Option<usize>| i.is_some_and(|i| axes[i].is_none());
        for (i, turn) in self.turns.iter().enumerate() {
            let angle = turn.axis.length();
            if angle < SHARP || axes[i].is_none() || !self.beside(i).into_iter().all(is_straight) {
                continue;
            }
            let [chord, distance] = turn
                .pieces
                .map(|piece| swing(curve, piece))
                .into_iter()
                .fold([f64::INFINITY, 0.0], |[chord, distance], [c, d]| [chord.min(c), f64::max(distance, d)]);
            if distance > SWING * chord {
                let first = found.map_or(turn.pieces[1], |f| f.first.min(turn.pieces[1]));
                let before = found.unwrap_or(RoundedTurns { first, count: 0, angle: 0.0, distance: 0.0 });
                *found = Some(RoundedTurns {
                    first,
                    count: before.count + 1,
                    angle: angle.max(before.angle),
                    distance: distance.max(before.distance),
                });
            }
        }
    }

    /// How often a straight run begins or ends.
    fn passages(&self, axes: &[Option<Vec3>]) -> usize {
        let straight = |i: Option<usize>| i.is_none_or(|i| axes[i].is_none());
        let in_run = |i: usize| axes[i].is_none() && self.beside(i).into_iter().any(straight);
        let mut runs: Vec<bool> = (0..axes.len()).map(in_run).collect();
        if self.closed {
            runs.extend(runs.first().copied());
        }
        runs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }
}

/// The turns at the nodes inside of every smooth run.
fn turns(curve: &dyn ParamCurve) -> Vec<Turns> {
    let mut runs = vec![Turns { turns: Vec::new(), closed: curve.is_closed() }];
    for joint in joints(curve) {
        let [from, at, to] =
            [(joint.piece, 0.0), (joint.next, 0.0), (joint.next, 1.0)].map(|(i, s)| curve.piece_point(i, s));
        if joint.angle > CORNER_ANGLE {
            runs.push(Turns { turns: Vec::new(), closed: false });
            continue;
        }
        let turn = Turn::new([from, at, to], [joint.piece, joint.next]);
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
