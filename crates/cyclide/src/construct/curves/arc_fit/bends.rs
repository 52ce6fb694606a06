//! A tangent-continuous chain of arcs and lines in the plane as curvatures and lengths, and its least squares against the
//! points that its pieces stand for (`docs/math/arc-fitting.md#least-deviation`).

use super::constrained_step::constrained_step;
use crate::base::planar::{Point2, Vec2};
use std::f64::consts::PI;

/// Largest sweep of a piece, radians.
const MAX_SWEEP: f64 = 340.0 / 180.0 * PI;
/// Sweeps below this take the series of the centroid.
const SMALL_SWEEP: f64 = 1e-2;
/// Damping at first, of the normal equations with unit diagonal, and the factor by which it changes.
const DAMPING: f64 = 1e-4;
const DAMPING_STEP: f64 = 10.0;
/// Dampings tried for one step.
const TRIES: usize = 5;
/// A step that gains less than this part ends the iteration.
const GAIN: f64 = 1e-5;
/// Newton steps onto the ends.
const CLOSING_STEPS: usize = 6;

/// A point that a piece stands for, and how much farther than the tolerance the curve may be from it. Places between samples bind
/// and are not fitted.
#[derive(Debug, Clone, Copy)]
pub(super) struct Matched {
    pub at: Point2,
    pub slack: f64,
    pub fitted: bool,
}

/// A piece of constant curvature (positive to the left) and the points that it stands for.
#[derive(Debug, Clone)]
pub(super) struct Bend {
    pub curvature: f64,
    pub length: f64,
    /// It is a line and stays one.
    pub straight: bool,
    pub points: Vec<Matched>,
    /// The largest curvature that it may take.
    pub tightest: f64,
}

/// A joint and the direction there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct State {
    pub at: Point2,
    pub angle: f64,
}

/// What holds one end of a chain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Hold {
    Place,
    PlaceAndAngle,
    /// The angle, and an axis of symmetry across it, along which the end slides.
    Axis,
}

/// What holds a chain at its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Ends {
    Held {
        start: Hold,
        end: Hold,
        target: State,
    },
    /// It closes smoothly after this turn.
    Loop {
        turn: f64,
    },
}

#[derive(Debug, Clone)]
pub(super) struct Bends {
    pub start: State,
    pub pieces: Vec<Bend>,
    pub ends: Ends,
    /// Least length of an arc.
    pub shortest: f64,
}

impl State {
    pub fn tangent(&self) -> Vec2 {
        let (s, c) = self.angle.sin_cos();
        Vec2::new(c, s)
    }

    /// After an arc.
    fn along(&self, curvature: f64, length: f64) -> Self {
        let half = 0.5 * curvature * length;
        let sinc = if half.abs() < 1e-4 { 1.0 - half * half / 6.0 } else { half.sin() / half };
        let (s, c) = (self.angle + half).sin_cos();
        Self { at: self.at + Vec2::new(c, s) * (length * sinc), angle: self.angle + 2.0 * half }
    }

    /// Centroid of the arc that begins here.
    fn centroid(&self, curvature: f64, length: f64) -> Point2 {
        let sweep = curvature * length;
        let (x, y) = if sweep.abs() < SMALL_SWEEP {
            (0.5 - sweep * sweep / 24.0, sweep / 6.0 - sweep * sweep * sweep / 120.0)
        } else {
            let half = (0.5 * sweep).sin();
            (2.0 * half * half / (sweep * sweep), (1.0 - sweep.sin() / sweep) / sweep)
        };
        let t = self.tangent();
        self.at + t * (length * x) + t.left() * (length * y)
    }
}

/// A point matched with the arc of a piece.
struct Foot {
    piece: usize,
    /// Length from the start of the piece.
    along: f64,
    state: State,
    /// Of the point, to the left of the curve.
    distance: f64,
    slack: f64,
    fitted: bool,
}

/// A sum of powers of distances; high powers stand for the largest.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sum {
    pub power: i32,
    pub of: Counted,
}

/// Whose distances a sum has.
#[derive(Debug, Clone, Copy)]
pub(super) enum Counted {
    /// Those of the points that are fitted.
    Fitted,
    /// All that the tolerance binds, by how much they exceed their slack.
    Bound,
}

impl Sum {
    pub const SQUARES: Self = Self { power: 2, of: Counted::Fitted };
}

impl Foot {
    /// The distance that the tolerance binds.
    fn bound(&self) -> f64 {
        self.distance.abs() - self.slack
    }

    /// What a sum counts of it.
    fn counted(&self, sum: Sum) -> Option<f64> {
        match sum.of {
            Counted::Fitted => self.fitted.then_some(self.distance),
            Counted::Bound => Some(self.bound().max(0.0).copysign(self.distance)),
        }
    }
}

impl Bends {
    /// The states at all joints, both ends included.
    pub fn states(&self) -> Vec<State> {
        let mut states = vec![self.start];
        for bend in &self.pieces {
            states.push(states[states.len() - 1].along(bend.curvature, bend.length));
        }
        states
    }

    /// What holds it where its ends are, and across axes of symmetry where they are said to be on one.
    pub fn held(&self, axes: [bool; 2]) -> Option<Ends> {
        let [start, end] = axes.map(|axis| if axis { Hold::Axis } else { Hold::Place });
        Some(Ends::Held { start, end, target: *self.states().last()? })
    }

    /// The point's foot on a piece continued beyond its ends.
    fn foot_on(&self, states: &[State], piece: usize, point: Matched) -> Foot {
        let (bend, state) = (&self.pieces[piece], states[piece]);
        let (t, v) = (state.tangent(), point.at - state.at);
        let (x, y, k) = (v.dot(t), t.cross(v), bend.curvature);
        let (a, b) = (k * x, 1.0 - k * y);
        let z = a.hypot(b);
        let distance = (2.0 * y - k * v.dot(v)) / (1.0 + z);
        let along = if k == 0.0 {
            x
        } else {
            // The turn nearest to the middle of the piece.
            let middle = 0.5 * k * bend.length;
            let turn = a.atan2(b);
            (turn + 2.0 * PI * ((middle - turn) / (2.0 * PI)).round()) / k
        };
        Foot { piece, along, state: state.along(k, along), distance, slack: point.slack, fitted: point.fitted }
    }

    /// The foot of a point, on a neighbor of its piece where it is beyond the end.
    fn foot(&self, states: &[State], piece: usize, point: Matched) -> Foot {
        let foot = self.foot_on(states, piece, point);
        let n = self.pieces.len();
        let is_loop = matches!(self.ends, Ends::Loop { .. });
        let other = if foot.along < 0.0 && (piece > 0 || is_loop) {
            (piece + n - 1) % n
        } else if foot.along > self.pieces[piece].length && (piece + 1 < n || is_loop) {
            (piece + 1) % n
        } else {
            return foot;
        };
        let beside = self.foot_on(states, other, point);
        let inside = (0.0..=self.pieces[other].length).contains(&beside.along);
        if inside || beside.distance.abs() < foot.distance.abs() { beside } else { foot }
    }

    fn feet(&self) -> Vec<Foot> {
        let states = self.states();
        let of = |(i, bend): (usize, &Bend)| bend.points.iter().map(|p| self.foot(&states, i, *p)).collect::<Vec<_>>();
        self.pieces.iter().enumerate().flat_map(of).collect()
    }

    /// The largest distance of a point, less its slack.
    pub fn deviation(&self) -> f64 {
        self.feet().iter().map(Foot::bound).fold(0.0, f64::max)
    }

    /// The distances of the points that are fitted, in order, to the left of the curve.
    pub fn distances(&self) -> Vec<f64> {
        self.feet().iter().filter(|foot| foot.fitted).map(|foot| foot.distance).collect()
    }

    /// The sum of their squares.
    pub fn squares(&self) -> f64 {
        self.distances().iter().map(|distance| distance * distance).sum()
    }

    /// Gives every point to the piece that its foot is on.
    pub fn reassign(&mut self) {
        let pieces: Vec<usize> = self.feet().iter().map(|f| f.piece).collect();
        let points: Vec<Matched> = self.pieces.iter_mut().flat_map(|b| std::mem::take(&mut b.points)).collect();
        points.into_iter().zip(pieces).for_each(|(point, piece)| self.pieces[piece].points.push(point));
    }

    fn is_valid(&self) -> bool {
        self.pieces.iter().all(|b| {
            let finite = b.length > 0.0 && b.length.is_finite() && b.curvature.is_finite();
            let kept = b.straight || (b.curvature.abs() <= b.tightest && b.length >= self.shortest);
            finite && kept && (b.curvature * b.length).abs() <= MAX_SWEEP
        })
    }

    /// The columns of the unknowns for a place `at` behind the joint with this index, whose curve continues to turn by
    /// `(piece, along)`: how the place moves along `direction`.
    fn motion(&self, states: &[State], foot: (usize, f64), at: Point2, direction: Vec2, row: &mut Vec<f64>) {
        row.clear();
        let is_loop = matches!(self.ends, Ends::Loop { .. });
        if is_loop {
            row.extend([direction.x, direction.y]);
        }
        if self.slides_at_start() {
            row.push(direction.dot(self.start.tangent().left()));
        }
        // Turning about a center moves the place by left(at - center).
        let turning = |center: Point2| direction.dot((at - center).left());
        if self.has_free_start_angle() {
            row.push(turning(self.start.at));
        }
        let (piece, along) = foot;
        for (j, bend) in self.pieces.iter().enumerate() {
            let state = &states[j];
            let length = if j < piece {
                bend.length
            } else if j == piece {
                along
            } else {
                0.0
            };
            if !bend.straight {
                row.push(if length == 0.0 { 0.0 } else { length * turning(state.centroid(bend.curvature, length)) });
            }
            let end = &states[j + 1];
            row.push(if j < piece { direction.dot(end.tangent()) + bend.curvature * turning(end.at) } else { 0.0 });
        }
    }

    fn has_free_start_angle(&self) -> bool {
        matches!(self.ends, Ends::Loop { .. } | Ends::Held { start: Hold::Place, .. })
    }

    fn slides_at_start(&self) -> bool {
        matches!(self.ends, Ends::Held { start: Hold::Axis, .. })
    }

    /// What the ends miss, and how that changes, row by row.
    fn misses(&self, states: &[State]) -> Vec<(f64, Vec<f64>)> {
        let n = self.pieces.len();
        let end = states[n];
        let (target, hold) = match self.ends {
            Ends::Held { end, target, .. } => (target, end),
            Ends::Loop { turn } => (State { at: self.start.at, angle: self.start.angle + turn }, Hold::PlaceAndAngle),
        };
        let is_loop = matches!(self.ends, Ends::Loop { .. });
        let held: &[Vec2] =
            if hold == Hold::Axis { &[target.tangent()] } else { &[Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)] };
        let mut rows = Vec::new();
        for &direction in held {
            let mut row = Vec::new();
            self.motion(states, (n, 0.0), end.at, direction, &mut row);
            if is_loop {
                // The target moves and turns with the start.
                row[..3].fill(0.0);
            }
            rows.push((direction.dot(end.at - target.at), row));
        }
        if hold != Hold::Place {
            let mut row = vec![0.0; rows[0].1.len()];
            let mut i = 2 * usize::from(is_loop) + usize::from(self.slides_at_start());
            if self.has_free_start_angle() {
                row[i] = if is_loop { 0.0 } else { 1.0 };
                i += 1;
            }
            for bend in &self.pieces {
                if !bend.straight {
                    row[i] = bend.length;
                    i += 1;
                }
                row[i] = bend.curvature;
                i += 1;
            }
            rows.push((end.angle - target.angle, row));
        }
        rows
    }

    fn moved(&self, step: &[f64]) -> Self {
        let mut moved = self.clone();
        let mut steps = step.iter();
        let mut next = || steps.next().copied().unwrap_or(0.0);
        if matches!(self.ends, Ends::Loop { .. }) {
            moved.start.at += Vec2::new(next(), next());
        }
        if self.slides_at_start() {
            moved.start.at += self.start.tangent().left() * next();
        }
        if self.has_free_start_angle() {
            moved.start.angle += next();
        }
        for bend in &mut moved.pieces {
            if !bend.straight {
                bend.curvature += next();
            }
            bend.length += next();
        }
        moved
    }

    /// How far the unknowns move the curve, roughly: what makes them comparable.
    fn units(&self) -> Vec<f64> {
        let mut units = Vec::new();
        if matches!(self.ends, Ends::Loop { .. }) {
            units.extend([1.0, 1.0]);
        }
        if self.slides_at_start() {
            units.push(1.0);
        }
        if self.has_free_start_angle() {
            units.push(self.pieces.iter().map(|b| b.length).sum());
        }
        for bend in &self.pieces {
            if !bend.straight {
                units.push(0.5 * bend.length * bend.length);
            }
            units.push(1.0);
        }
        units
    }

    /// Steps of least norm until the ends are met; `None` if they are not.
    pub fn closed(mut self) -> Option<Self> {
        // Places are rounded as lengths are, the angle as a sum of radians is.
        let length = self.pieces.iter().map(|b| b.length).sum::<f64>();
        let held = if matches!(self.ends, Ends::Held { end: Hold::Axis, .. }) { 1 } else { 2 };
        let sizes = std::iter::repeat_n(length, held).chain([self.pieces.len() as f64]);
        let largest = |rows: &[(f64, Vec<f64>)]| {
            rows.iter().zip(sizes.clone()).map(|(row, size)| row.0.abs() / size).fold(0.0, f64::max)
        };
        for _ in 0..CLOSING_STEPS {
            let rows = self.misses(&self.states());
            if largest(&rows) <= 4.0 * f64::EPSILON {
                break;
            }
            let units = self.units();
            let columns = units.len();
            let mut normal = vec![vec![0.0; columns]; columns];
            (0..columns).for_each(|j| normal[j][j] = units[j] * units[j]);
            self = self.moved(&constrained_step(normal, &vec![0.0; columns], &rows, &units, 0.0)?);
        }
        (largest(&self.misses(&self.states())) <= 1e-12 && self.is_valid()).then_some(self)
    }

    /// Lowers the sum of the `power`-th powers of the distances in at most `steps` steps, none of which takes a point
    /// beyond `limit`. The ends are met before as after.
    pub fn refined(mut self, sum_of: Sum, steps: usize, limit: f64) -> Self {
        let power = sum_of.power;
        let measure = |chain: &Self| {
            let feet = chain.feet();
            let largest = feet.iter().map(Foot::bound).fold(0.0, f64::max);
            let scale = if largest > 0.0 { largest } else { 1.0 };
            let counted = feet.iter().filter_map(|f| f.counted(sum_of));
            let sum = counted.map(|distance| (distance / scale).abs().powi(power)).sum::<f64>();
            (sum.powf(1.0 / f64::from(power)) * scale, largest)
        };
        let mut best = measure(&self).0;
        let mut damping = DAMPING;
        for _ in 0..steps {
            let states = self.states();
            let rows = self.misses(&states);
            let units = self.units();
            let (normal, gradient) = self.normal_equations(&states, units.len(), sum_of);
            let step = (0..TRIES).find_map(|_| {
                let step = constrained_step(normal.clone(), &gradient, &rows, &units, damping);
                let moved = step.and_then(|step| self.moved(&step).closed());
                let better = moved.filter(|m| {
                    let (sum, largest) = measure(m);
                    sum < best && largest <= limit
                });
                damping *= if better.is_some() { 1.0 / DAMPING_STEP } else { DAMPING_STEP };
                better
            });
            let Some(mut moved) = step else { break };
            moved.reassign();
            let sum = measure(&moved).0;
            let gain = best - sum;
            (self, best) = (moved, sum);
            if gain <= GAIN * best {
                break;
            }
        }
        self
    }

    fn normal_equations(&self, states: &[State], columns: usize, sum: Sum) -> (Vec<Vec<f64>>, Vec<f64>) {
        let power = sum.power;
        let feet = self.feet();
        let largest = feet.iter().map(Foot::bound).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
        let mut normal = vec![vec![0.0; columns]; columns];
        let mut gradient = vec![0.0; columns];
        let mut row = Vec::new();
        for (foot, distance) in feet.iter().filter_map(|f| Some((f, f.counted(sum)?))) {
            let weight = (distance / largest).abs().powi(power - 2);
            self.motion(states, (foot.piece, foot.along), foot.state.at, foot.state.tangent().left(), &mut row);
            for i in 0..columns {
                if row[i] == 0.0 {
                    continue;
                }
                // Moving the curve to the left takes from the distance.
                gradient[i] -= weight * row[i] * distance;
                for j in 0..=i {
                    // The second derivative of |d|^p/p is (p - 1) |d|^(p - 2).
                    normal[i][j] += f64::from(power - 1) * weight * row[i] * row[j];
                }
            }
        }
        for i in 1..columns {
            let (above, below) = normal.split_at_mut(i);
            for (row, value) in above.iter_mut().zip(&below[0]) {
                row[i] = *value;
            }
        }
        (normal, gradient)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bend(curvature: f64, length: f64) -> Bend {
        Bend { curvature, length, straight: curvature == 0.0, points: Vec::new(), tightest: 1e3 }
    }

    fn exact(at: Point2) -> Matched {
        Matched { at, slack: 0.0, fitted: true }
    }

    /// Line, arc, arc, line with points on them, and the place and direction at the end.
    fn road(shift: f64) -> Bends {
        let start = State { at: Point2::new(1.0, 2.0), angle: 0.3 };
        let pieces = vec![bend(0.0, 10.0), bend(0.2, 8.0), bend(-0.1, 12.0), bend(0.0, 9.0)];
        let ends = Ends::Held { start: Hold::Place, end: Hold::Place, target: start };
        let mut bends = Bends { start, pieces, ends, shortest: 0.0 };
        let states = bends.states();
        for (piece, state) in bends.pieces.iter_mut().zip(&states) {
            let Bend { curvature, length, .. } = *piece;
            piece.points = (0..20).map(|k| exact(state.along(curvature, length * f64::from(k) / 20.0).at)).collect();
        }
        bends.ends = Ends::Held { start: Hold::Place, end: Hold::Place, target: states[4] };
        // Off by a little, with the same ends.
        bends.start.angle += 0.1 * shift;
        bends.pieces[1].curvature *= 1.0 + shift;
        bends.pieces[2].length *= 1.0 - shift;
        bends
    }

    #[test]
    fn least_squares_find_the_arcs_that_points_were_taken_from() {
        let bends = road(0.1).closed().unwrap();
        assert!(bends.deviation() > 0.01);
        let mut refined = bends.refined(Sum::SQUARES, 20, f64::INFINITY);
        refined.reassign();
        assert!(refined.deviation() < 1e-9, "{}", refined.deviation());
        let found: Vec<_> = refined.pieces.iter().map(|b| (b.curvature, b.length)).collect();
        for (got, want) in found.iter().zip([(0.0, 10.0), (0.2, 8.0), (-0.1, 12.0), (0.0, 9.0)]) {
            assert!((got.0 - want.0).abs() < 1e-7 && (got.1 - want.1).abs() < 1e-5, "{found:?}");
        }
    }

    #[test]
    fn a_loop_closes_with_its_tangent() {
        // A circle of radius 5 as three bends that are none of it.
        let at = |i: usize| {
            let (s, c) = (2.0 * PI * i as f64 / 60.0).sin_cos();
            Point2::new(5.0 * c, 5.0 * s)
        };
        let piece = |k: usize, curvature: f64| Bend {
            points: (20 * k + 1..=20 * k + 20).map(|i| exact(at(i))).collect(),
            ..bend(curvature, 10.0 * PI / 3.0)
        };
        let start = State { at: at(0), angle: 0.5 * PI };
        let bends = Bends {
            start,
            pieces: vec![piece(0, 0.19), piece(1, 0.21), piece(2, 0.2)],
            ends: Ends::Loop { turn: 2.0 * PI },
            shortest: 0.0,
        };
        let refined = bends.closed().unwrap().refined(Sum::SQUARES, 20, f64::INFINITY);
        assert!(refined.deviation() < 1e-7, "{}", refined.deviation());
        assert!(refined.states()[3].at.distance(refined.start.at) < 1e-12);
    }
}
