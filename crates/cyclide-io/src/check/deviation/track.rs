//! A part of a curve cut into tame windows, with the foot of a point on each.

use cyclide::{
    Point3, Vec3,
    curve::{Arc, CurvePlace, ParamCurve, PieceForm, PieceHull},
};

/// Windows of a whole piece before the turn is looked at: of an arc one would be taken for a point where it is a
/// circle, of anything else two for a line where it is an S.
const FIRST_WINDOWS: [usize; 2] = [2, 3];
/// A part of a piece that is shorter than this starts with one window.
const SHORT_PART: f64 = 0.25;
/// Largest turn of the tangent in a window, as a cosine: one Newton step from the chord is then nearly exact.
const WINDOW_COSINE: f64 = 0.85;
/// Largest angle between the chord and the tangents at its ends, as a cosine.
const CHORD_COSINE: f64 = 0.92;
/// Largest quotient of the speeds at the ends of a window, and of the chord and the way at their mean speed.
const WINDOW_SPEEDS: f64 = 4.0;
const CHORD_SPEEDS: f64 = 1.5;
/// Where the hull of a piece is an approximation, it is within this part of the distance of its ends.
const HULL_TOLERANCE: f64 = 1e-3;
/// Windows below this part of the coordinates of their piece are not cut any further: at the origin, too, where a curve with a stop
/// says nothing of its direction, however near.
const UNSEEN: f64 = 1e-13;
/// Halvings of a window at most, and windows of a part. An arc that passes near infinity runs nearly all of its way in a
/// tiny range of its parameter.
const WINDOW_DEPTH: u32 = 52;
const WINDOW_CAP: usize = 1 << 14;
/// Largest quotient of the weights of an arc whose own parameter is taken. Its speeds at the ends differ by the square:
/// an arc through a point near infinity is nearly all within a tiny range of its parameter.
const WEIGHT_RATIO: f64 = 16.0;
/// A foot is found when its parameter moves by less than this part of the window; what is left is quadratic in it.
const FOOT: f64 = 1e-9;
/// Newton steps to a foot; a window where they do not suffice is searched in equal steps, each narrowed by halves.
const NEWTON_STEPS: u32 = 12;
const SEARCH_STEPS: u32 = 8;
const SEARCH_HALVINGS: u32 = 40;

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
    piece: usize,
    /// Index of the arc that has the points of the piece at even speed.
    balanced: Option<usize>,
    pub(super) start: Node,
    pub(super) end: Node,
    /// No point of it is farther from its start.
    reach: f64,
}

impl Window {
    /// True if it may have a point within `distance` of `p`.
    pub(super) fn may_be_within(&self, distance: f64, p: Point3) -> bool {
        let far = distance + self.reach;
        (p - self.start.point).length_squared() <= far * far
    }
}

/// A curve of which one part at a time is cut into windows.
pub(super) struct Track<'a> {
    curve: &'a dyn ParamCurve,
    plan: bool,
    /// Arcs with weights of equal size in place of the pieces of the part that have weights of very different sizes.
    balanced: Vec<Arc>,
    /// What proves that windows of a piece have no loop: number of the piece, and its hull, if there is one.
    hull: Option<(usize, PieceHull)>,
    /// The windows of the part, in order; never empty once there is a part.
    pub(super) windows: Vec<Window>,
    /// The length below which nothing is seen of the piece that is being cut.
    unseen: f64,
}

impl<'a> Track<'a> {
    /// The curve in space or in the plan view.
    pub(super) fn new(curve: &'a dyn ParamCurve, plan: bool) -> Self {
        Self { curve, plan, balanced: Vec::new(), hull: None, windows: Vec::new(), unseen: 0.0 }
    }

    /// Takes the part between two places, which may be one.
    pub(super) fn set_part(&mut self, from: CurvePlace, to: CurvePlace) {
        self.windows.clear();
        self.balanced.clear();
        let (mut piece, mut s) = (from.piece, from.s);
        while piece < to.piece || (piece == to.piece && s < to.s) {
            let end = if piece == to.piece { to.s } else { 1.0 };
            if s < end {
                self.add_piece(piece % self.curve.piece_count(), s, end);
            }
            (piece, s) = (piece + 1, 0.0);
        }
        if self.windows.is_empty() {
            let (piece, s) = self.within(from);
            let node = self.node(piece, None, s);
            self.windows.push(Window { piece, balanced: None, start: node, end: node, reach: 0.0 });
        }
    }

    /// The place on a piece that exists: behind the last one of an open curve its end.
    fn within(&self, place: CurvePlace) -> (usize, f64) {
        let n = self.curve.piece_count();
        if place.piece >= n && !self.curve.is_closed() { (n - 1, 1.0) } else { (place.piece % n, place.s) }
    }

    pub(super) fn start(&self) -> Option<Point3> {
        self.windows.first().map(|w| w.start.point)
    }

    pub(super) fn end(&self) -> Option<Point3> {
        self.windows.last().map(|w| w.end.point)
    }

    fn add_piece(&mut self, piece: usize, from: f64, to: f64) {
        let form = self.curve.piece_form(piece);
        let (mut range, mut balanced) = ([from, to], None);
        let mut first = FIRST_WINDOWS[1];
        if let PieceForm::Arc(arc) = form {
            first = if arc.is_straight() { 1 } else { FIRST_WINDOWS[0] };
            if let Some((even, size)) = with_even_weights(&arc) {
                // Equal points of both: the quotient of the parts of the parameter is `size` times as large.
                range = range.map(|t| size * t / ((1.0 - t) + size * t));
                balanced = Some(self.balanced.len());
                self.balanced.push(even);
            }
        } else if let PieceForm::Circle(_) = form {
            first = 2 * FIRST_WINDOWS[0];
        } else {
            self.take_hull(piece);
        }
        if range[1] - range[0] < SHORT_PART {
            first = 1;
        }
        let place =
            |k: usize| if k == first { range[1] } else { range[0] + (range[1] - range[0]) * (k as f64 / first as f64) };
        let nodes: Vec<Node> = (0..=first).map(|k| self.node(piece, balanced, place(k))).collect();
        self.unseen = UNSEEN * nodes.iter().map(|node| node.point.to_vec().max_abs()).fold(0.0, f64::max);
        for ends in nodes.windows(2) {
            self.cut(piece, balanced, ends[0], ends[1], WINDOW_DEPTH);
        }
    }

    /// The point at a part of a window.
    pub(super) fn point(&self, w: &Window, part: f64) -> Point3 {
        let s = w.start.s + (w.end.s - w.start.s) * part;
        let mut point = match w.balanced.and_then(|i| self.balanced.get(i)) {
            Some(arc) => arc.point(s),
            None => self.curve.piece_point(w.piece, s),
        };
        if self.plan {
            point.z = 0.0;
        }
        point
    }

    /// Distance of `p` from the nearest point of a window.
    pub(super) fn distance(&self, w: &Window, p: Point3) -> f64 {
        let (a, b) = (&w.start, &w.end);
        let before = (p - a.point).dot(a.d1);
        let after = (p - b.point).dot(b.d1);
        let ends = p.distance(a.point).min(p.distance(b.point));
        if before <= 0.0 || after >= 0.0 {
            return ends;
        }
        let width = b.s - a.s;
        let mut s = a.s + width * (before / (before - after));
        for _ in 0..NEWTON_STEPS {
            let here = self.node(w.piece, w.balanced, s);
            let offset = p - here.point;
            let speed2 = here.d1.length_squared();
            if speed2 == 0.0 {
                return ends.min(offset.length());
            }
            let next = (s + offset.dot(here.d1) / speed2).clamp(a.s, b.s);
            let step = next - s;
            if step.abs() <= FOOT * width {
                // The rest of a converged step moves the point along the tangent: the curve bends away only by its
                // square.
                return ends.min((offset - here.d1 * step).length());
            }
            s = next;
        }
        ends.min(self.searched(w, p))
    }

    /// The distance in a window where Newton's steps run in circles: at the lowest of some places, and from there by
    /// halved steps.
    fn searched(&self, w: &Window, p: Point3) -> f64 {
        let distance = |part: f64| self.point(w, part).distance(p);
        let at = |i: u32| f64::from(i) / f64::from(SEARCH_STEPS);
        let places = (0..=SEARCH_STEPS).map(|i| (at(i), distance(at(i))));
        let (mut part, mut best) = places.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0.0, f64::INFINITY));
        let mut step = at(1);
        for _ in 0..SEARCH_HALVINGS {
            step *= 0.5;
            for next in [part - step, part + step] {
                if (0.0..=1.0).contains(&next) && distance(next) < best {
                    (part, best) = (next, distance(next));
                }
            }
        }
        best
    }

    /// Adds a window, halved until it is tame.
    fn cut(&mut self, piece: usize, balanced: Option<usize>, start: Node, end: Node, depth: u32) {
        let tame = self.is_unseen(&start, &end) || (is_tame(&start, &end) && self.advances(piece, &start, &end));
        let middle = 0.5 * (start.s + end.s);
        let last = depth == 0 || self.windows.len() >= WINDOW_CAP || !(start.s < middle && middle < end.s);
        if tame || last {
            let chord = start.point.distance(end.point);
            let way = start.d1.length().max(end.d1.length()) * (end.s - start.s);
            // A tame one is no longer than an arc that turns by its limit; what is not tame runs anywhere it can.
            let reach = if tame { 1.1 * chord } else { chord + 2.0 * way };
            self.windows.push(Window { piece, balanced, start, end, reach });
            return;
        }
        let middle = self.node(piece, balanced, middle);
        self.cut(piece, balanced, start, middle, depth - 1);
        self.cut(piece, balanced, middle, end, depth - 1);
    }

    /// True if a window is too small to see, and to be cut.
    fn is_unseen(&self, start: &Node, end: &Node) -> bool {
        let way = 0.5 * (start.d1.length() + end.d1.length()) * (end.s - start.s);
        way.max(start.point.distance(end.point)) <= self.unseen.max(UNSEEN * start.point.to_vec().max_abs())
    }

    /// Makes the hull of a piece without a closed form; parts of one piece follow each other.
    fn take_hull(&mut self, piece: usize) {
        if self.hull.as_ref().is_none_or(|(of, _)| *of != piece) {
            let [a, b] = [0.0, 1.0].map(|s| self.curve.piece_point(piece, s));
            self.hull = self.curve.piece_hull(piece, HULL_TOLERANCE * a.distance(b)).ok().map(|hull| (piece, hull));
        }
    }

    /// True if a window runs along its chord all the time, as far as that can be proved: both ends may lie before and behind a loop
    /// that is run through in a tiny range of the parameter.
    fn advances(&mut self, piece: usize, start: &Node, end: &Node) -> bool {
        match &mut self.hull {
            Some((of, hull)) if *of == piece => hull.advances([start.s, end.s], end.point - start.point),
            _ => true,
        }
    }

    fn node(&self, piece: usize, balanced: Option<usize>, s: f64) -> Node {
        let jet = match balanced.and_then(|i| self.balanced.get(i)) {
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

/// The points of an arc with weights of very different sizes, in the same order, at weights of equal size, and the
/// quotient of the sizes.
fn with_even_weights(arc: &Arc) -> Option<(Arc, f64)> {
    let ratio = arc.weight_ratio();
    let size = ratio.norm();
    let tame = (1.0 / WEIGHT_RATIO..=WEIGHT_RATIO).contains(&size);
    // A positive factor of one weight moves the points along the arc.
    if tame { None } else { Some((Arc::from_weight_ratio(arc.start(), arc.end(), ratio * (1.0 / size)).ok()?, size)) }
}

/// True if the tangents at both ends and the chord agree in direction, and the speeds with each other and with the
/// chord. The tangents alone would take a loop for a straight stretch.
fn is_tame(start: &Node, end: &Node) -> bool {
    let (u, v) = (start.d1.length(), end.d1.length());
    let chord = end.point - start.point;
    let (straight, expected) = (chord.length(), 0.5 * (u + v) * (end.s - start.s));
    let even = u <= WINDOW_SPEEDS * v && v <= WINDOW_SPEEDS * u;
    let along = |d1: Vec3, speed: f64| chord.dot(d1) >= CHORD_COSINE * straight * speed;
    even && start.d1.dot(end.d1) >= WINDOW_COSINE * u * v
        && along(start.d1, u)
        && along(end.d1, v)
        && straight <= CHORD_SPEEDS * expected
        && expected <= CHORD_SPEEDS * straight
}
