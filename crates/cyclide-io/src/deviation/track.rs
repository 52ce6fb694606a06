//! A curve cut into tame windows, with the foot of a point on each.

use cyclide::{Arc, ParamCurve, PieceForm, Point3, Vec3};
use std::collections::BTreeMap;

/// Windows of a piece before the turn is looked at: one alone would take a circle for a point, two an S for a line.
const FIRST_WINDOWS: [usize; 2] = [2, 3];
/// Largest turn of the tangent in a window, as a cosine: one Newton step from the chord is then nearly exact.
const WINDOW_COSINE: f64 = 0.85;
/// Largest angle between the chord and the tangents at its ends, as a cosine.
const CHORD_COSINE: f64 = 0.92;
/// Largest quotient of the speeds at the ends of a window, and of the chord and the way at their mean speed.
const WINDOW_SPEEDS: f64 = 4.0;
const CHORD_SPEEDS: f64 = 1.5;
/// Windows below this part of their coordinates are not cut any further.
const UNSEEN: f64 = 1e-13;
/// Halvings of a window at most.
const WINDOW_DEPTH: u32 = 16;
/// Largest quotient of the weights of an arc whose own parameter is taken. Its speeds at the ends differ by the square:
/// an arc through a point near infinity is nearly all within a tiny range of its parameter.
const WEIGHT_RATIO: f64 = 16.0;
/// A foot is found when its parameter moves by less than this part of the window; what is left is quadratic in it.
const FOOT: f64 = 1e-9;
/// Windows that may be the start of a closed curve at most: passes of the curve through one point.
const START_CAP: usize = 4;

/// A point of a curve with its derivative.
#[derive(Clone, Copy)]
pub(super) struct Node {
    pub(super) s: f64,
    pub(super) point: Point3,
    d1: Vec3,
}

/// A part of a smooth piece on which the tangent turns little.
#[derive(Clone, Copy)]
pub(super) struct Window {
    pub(super) piece: usize,
    pub(super) start: Node,
    pub(super) end: Node,
    /// Length of the curve before it.
    pub(super) position: f64,
    /// Its own length, as of an arc with the same turn.
    pub(super) length: f64,
}

/// A curve cut into windows, in order.
pub(super) struct Track<'a> {
    curve: &'a dyn ParamCurve,
    /// Arcs with weights of equal size in place of the pieces that have weights of very different sizes.
    balanced: BTreeMap<usize, Arc>,
    plan: bool,
    pub(super) windows: Vec<Window>,
    pub(super) length: f64,
}

impl<'a> Track<'a> {
    /// The curve in space or in the plan view.
    pub(super) fn new(curve: &'a dyn ParamCurve, plan: bool) -> Self {
        let windows = Vec::with_capacity(FIRST_WINDOWS[0] * curve.piece_count());
        let balanced = (0..curve.piece_count()).filter_map(|piece| Some((piece, balanced(curve, piece)?))).collect();
        let mut track = Self { curve, balanced, plan, windows, length: 0.0 };
        for piece in 0..curve.piece_count() {
            let bent = matches!(curve.piece_form(piece), PieceForm::Free);
            let first = FIRST_WINDOWS[usize::from(bent)];
            let mut start = track.node(piece, 0.0);
            for k in 1..=first {
                let end = track.node(piece, k as f64 / first as f64);
                track.cut(piece, start, end, WINDOW_DEPTH);
                start = end;
            }
        }
        track.measure();
        track
    }

    /// The windows that start nearest to a point, all that are equally near, in order.
    pub(super) fn starts_near(&self, p: Point3) -> Vec<usize> {
        let distance = |w: &Window| w.start.point.distance(p);
        let nearest = self.windows.iter().map(distance).fold(f64::INFINITY, f64::min);
        let limit = nearest + 1e-9 * p.to_vec().max_abs();
        let near = self.windows.iter().enumerate().filter(|(_, w)| distance(w) <= limit);
        near.map(|(i, _)| i).take(START_CAP).collect()
    }

    /// Makes another window of a closed curve the first one.
    pub(super) fn rotate(&mut self, first: usize) {
        self.windows.rotate_left(first);
        self.measure();
    }

    fn measure(&mut self) {
        self.length = 0.0;
        for w in &mut self.windows {
            w.position = self.length;
            self.length += w.length;
        }
    }

    /// The point at a part of a window.
    pub(super) fn point(&self, w: &Window, part: f64) -> Point3 {
        let s = w.start.s + (w.end.s - w.start.s) * part;
        let mut point = match self.balanced.get(&w.piece) {
            Some(arc) => arc.point(s),
            None => self.curve.piece_point(w.piece, s),
        };
        if self.plan {
            point.z = 0.0;
        }
        point
    }

    /// The point of a window nearest to `p`.
    pub(super) fn foot(&self, w: &Window, p: Point3) -> Foot {
        let (a, b) = (&w.start, &w.end);
        let before = (p - a.point).dot(a.d1);
        let after = (p - b.point).dot(b.d1);
        if before <= 0.0 || after >= 0.0 {
            let (to_start, to_end) = (p.distance(a.point), p.distance(b.point));
            let at_end = if before <= 0.0 && after >= 0.0 { to_end < to_start } else { after >= 0.0 };
            return Foot {
                position: w.position + if at_end { w.length } else { 0.0 },
                distance: if at_end { to_end } else { to_start },
            };
        }
        let width = b.s - a.s;
        let mut s = a.s + width * (before / (before - after));
        let mut distance = f64::INFINITY;
        for _ in 0..12 {
            let here = self.node(w.piece, s);
            let offset = p - here.point;
            let speed2 = here.d1.length_squared();
            if speed2 == 0.0 {
                distance = offset.length();
                break;
            }
            let next = (s + offset.dot(here.d1) / speed2).clamp(a.s, b.s);
            let step = next - s;
            // The rest of a converged step moves the point along the tangent: the curve bends away only by its
            // square.
            distance = (offset - here.d1 * step).length();
            s = next;
            if step.abs() <= FOOT * width {
                break;
            }
        }
        Foot { position: w.position + w.length * ((s - a.s) / width), distance }
    }

    /// Adds a window, halved until it is tame.
    fn cut(&mut self, piece: usize, start: Node, end: Node, depth: u32) {
        if depth == 0 || is_tame(&start, &end) {
            let chord = start.point.distance(end.point);
            let half = 0.5 * start.d1.angle(end.d1).min(1.0);
            let length = if half > 1e-4 { chord * half / half.sin() } else { chord };
            self.windows.push(Window { piece, start, end, position: 0.0, length });
            return;
        }
        let middle = self.node(piece, 0.5 * (start.s + end.s));
        self.cut(piece, start, middle, depth - 1);
        self.cut(piece, middle, end, depth - 1);
    }

    fn node(&self, piece: usize, s: f64) -> Node {
        let jet = match self.balanced.get(&piece) {
            Some(arc) => arc.piece_jet(0, s),
            None => self.curve.piece_jet(piece, s),
        };
        let (mut point, mut d1) = (jet.point, jet.d1);
        if self.plan {
            point.z = 0.0;
            d1.z = 0.0;
        }
        Node { s, point, d1 }
    }
}

/// The points of an arc with weights of very different sizes, in the same order, at weights of equal size.
fn balanced(curve: &dyn ParamCurve, piece: usize) -> Option<Arc> {
    let PieceForm::Arc(arc) = curve.piece_form(piece) else { return None };
    let ratio = arc.weight_ratio();
    let size = ratio.norm();
    let tame = (1.0 / WEIGHT_RATIO..=WEIGHT_RATIO).contains(&size);
    // A positive factor of one weight moves the points along the arc.
    if tame { None } else { Arc::from_weight_ratio(arc.start(), arc.end(), ratio * (1.0 / size)).ok() }
}

/// True if the tangents at both ends and the chord agree in direction, and the speeds with each other and with the
/// chord. The tangents alone would take a loop for a straight stretch. What is too small to see is tame.
fn is_tame(start: &Node, end: &Node) -> bool {
    let (u, v) = (start.d1.length(), end.d1.length());
    let chord = end.point - start.point;
    let (straight, expected) = (chord.length(), 0.5 * (u + v) * (end.s - start.s));
    if straight.max(expected) <= UNSEEN * start.point.to_vec().max_abs() {
        return true;
    }
    let even = u <= WINDOW_SPEEDS * v && v <= WINDOW_SPEEDS * u;
    let along = |d1: Vec3, speed: f64| chord.dot(d1) >= CHORD_COSINE * straight * speed;
    even && start.d1.dot(end.d1) >= WINDOW_COSINE * u * v
        && along(start.d1, u)
        && along(end.d1, v)
        && straight <= CHORD_SPEEDS * expected
        && expected <= CHORD_SPEEDS * straight
}

/// The point of a window nearest to a sample: how far along the curve, and how far away.
#[derive(Clone, Copy)]
pub(super) struct Foot {
    pub(super) position: f64,
    pub(super) distance: f64,
}
