//! The distance between the curves of a file and the curves of the model, walked along both.
//!
//! Nearest points alone would forgive a file whose pieces are swapped or doubled. Here each curve is sampled in
//! order, and the foot of every sample on the other curve is looked for from the last foot onwards only: a monotone
//! matching, hence an upper bound of the distance of the point sets and close to the Fréchet distance.

use crate::export::contours;
use crate::read_back::ReadError;
use cyclide::{CurveChain, Model, ParamCurve, Point3, Vec3};

/// Windows of one smooth piece before the turn is looked at; two alone would miss an S.
const FIRST_WINDOWS: usize = 2;
/// Largest turn of the tangent in a window, as a cosine: one Newton step from the chord is then nearly exact.
const WINDOW_COSINE: f64 = 0.85;
/// Largest quotient of the speeds at the ends of a window.
const WINDOW_SPEEDS: f64 = 4.0;
/// Halvings of a window at most.
const WINDOW_DEPTH: u32 = 16;
/// Inner samples of a window, as parameters in it.
const SAMPLES: [f64; 3] = [0.25, 0.5, 0.75];
/// A foot is found when its parameter moves by less than this part of the window; what is left is quadratic in it.
const FOOT: f64 = 1e-9;

/// The largest distance between the curves read from a file and the model's curves, both ways, in the model's
/// order: 0 up to rounding for an exact file.
///
/// # Errors
/// [`ReadError::CurveCount`], [`ReadError::Closedness`].
pub fn deviation(model: &Model, read: &[CurveChain]) -> Result<f64, ReadError> {
    deviation_within(model, read, View::Space)
}

/// How much of the curves a format holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum View {
    /// All of it.
    Space,
    /// What is seen along the third axis.
    Plan,
    /// The points only: whether a curve is closed is told by its ends alone.
    Points,
}

/// As [`deviation`], of what the format holds.
pub(crate) fn deviation_within(model: &Model, read: &[CurveChain], view: View) -> Result<f64, ReadError> {
    let expected = contours(model).count();
    if expected != read.len() {
        return Err(ReadError::CurveCount { found: read.len(), expected });
    }
    let mut largest = 0.0_f64;
    let plan = view == View::Plan;
    for (curve, (contour, chain)) in contours(model).zip(read).enumerate() {
        let object = contour.curve.as_curve();
        if view != View::Points && object.is_closed() != chain.is_closed() {
            return Err(ReadError::Closedness { curve, found: chain.is_closed() });
        }
        let (mut a, b) = (Track::new(object, plan), Track::new(chain, plan));
        // A closed curve may start elsewhere in the file (at a corner).
        let starts = if object.is_closed() { a.starts_near(b.windows[0].start.point) } else { vec![0] };
        let mut best = f64::INFINITY;
        let mut rotated = 0;
        for start in starts {
            a.windows.rotate_left(start - rotated);
            rotated = start;
            best = best.min(one_way(&a, &b).max(one_way(&b, &a)));
        }
        largest = largest.max(best);
    }
    Ok(largest)
}

/// Windows that may be the start of a closed curve at most: passes of the curve through one point.
const START_CAP: usize = 4;

/// A point of a curve with its derivative.
#[derive(Clone, Copy)]
struct Node {
    s: f64,
    point: Point3,
    d1: Vec3,
}

/// A part of a smooth piece on which the tangent turns little.
#[derive(Clone, Copy)]
struct Window {
    piece: usize,
    start: Node,
    end: Node,
}

/// A curve cut into windows, in order.
struct Track<'a> {
    curve: &'a dyn ParamCurve,
    plan: bool,
    windows: Vec<Window>,
}

impl<'a> Track<'a> {
    fn new(curve: &'a dyn ParamCurve, plan: bool) -> Self {
        let mut track = Self { curve, plan, windows: Vec::with_capacity(FIRST_WINDOWS * curve.piece_count()) };
        for piece in 0..curve.piece_count() {
            let mut start = track.node(piece, 0.0);
            for k in 1..=FIRST_WINDOWS {
                let end = track.node(piece, k as f64 / FIRST_WINDOWS as f64);
                track.cut(Window { piece, start, end }, WINDOW_DEPTH);
                start = end;
            }
        }
        track
    }

    /// The windows that start nearest to a point, all that are equally near, in order.
    fn starts_near(&self, p: Point3) -> Vec<usize> {
        let distance = |w: &Window| w.start.point.distance(p);
        let nearest = self.windows.iter().map(distance).fold(f64::INFINITY, f64::min);
        let limit = nearest + 1e-9 * p.to_vec().max_abs();
        let near = self.windows.iter().enumerate().filter(|(_, w)| distance(w) <= limit);
        near.map(|(i, _)| i).take(START_CAP).collect()
    }

    /// Adds a window, halved until it is tame.
    fn cut(&mut self, window: Window, depth: u32) {
        let Window { piece, start, end } = window;
        let (u, v) = (start.d1.length(), end.d1.length());
        let even = u <= WINDOW_SPEEDS * v && v <= WINDOW_SPEEDS * u;
        if depth == 0 || (even && start.d1.dot(end.d1) >= WINDOW_COSINE * u * v) {
            self.windows.push(window);
            return;
        }
        let middle = self.node(piece, 0.5 * (start.s + end.s));
        self.cut(Window { piece, start, end: middle }, depth - 1);
        self.cut(Window { piece, start: middle, end }, depth - 1);
    }

    fn node(&self, piece: usize, s: f64) -> Node {
        let jet = self.curve.piece_jet(piece, s);
        let (mut point, mut d1) = (jet.point, jet.d1);
        if self.plan {
            point.z = 0.0;
            d1.z = 0.0;
        }
        Node { s, point, d1 }
    }

    /// The point at a part of a window.
    fn part(&self, w: &Window, part: f64) -> Point3 {
        let mut point = self.curve.piece_point(w.piece, w.start.s + (w.end.s - w.start.s) * part);
        if self.plan {
            point.z = 0.0;
        }
        point
    }

    /// The foot of `p` in a window, not before parameter `from`: parameter and distance.
    fn foot(&self, window: &Window, p: Point3, from: f64) -> (f64, f64) {
        let (a, b) = (&window.start, &window.end);
        let lower = from.max(a.s);
        let before = (p - a.point).dot(a.d1);
        let after = (p - b.point).dot(b.d1);
        if before <= 0.0 && lower <= a.s {
            return (a.s, p.distance(a.point));
        }
        if after >= 0.0 {
            return (b.s, p.distance(b.point));
        }
        let width = b.s - a.s;
        let guess = if before > 0.0 { a.s + width * (before / (before - after)) } else { lower };
        let mut s = guess.max(lower);
        let mut distance = f64::INFINITY;
        for _ in 0..12 {
            let here = self.node(window.piece, s);
            let offset = p - here.point;
            let speed2 = here.d1.length_squared();
            if speed2 == 0.0 {
                return (s, offset.length());
            }
            let wanted = s + offset.dot(here.d1) / speed2;
            let next = wanted.clamp(lower, b.s);
            let step = next - s;
            // The rest of a converged step moves the point along the tangent: the curve bends away only by its
            // square.
            distance = (offset - here.d1 * step).length();
            s = next;
            if step.abs() <= FOOT * width {
                break;
            }
        }
        (s, distance)
    }
}

/// Walks the feet of one curve's samples along the other.
#[derive(Clone)]
struct Walker<'a> {
    on: &'a Track<'a>,
    window: usize,
    s: f64,
    /// The last sample and the distance of its foot.
    last: Option<(Point3, f64)>,
}

impl<'a> Walker<'a> {
    fn new(on: &'a Track<'a>) -> Self {
        Self { on, window: 0, s: on.windows[0].start.s, last: None }
    }

    /// Distance from `p` to its foot, from the last foot onwards.
    fn distance(&mut self, p: Point3) -> f64 {
        let windows = &self.on.windows;
        loop {
            let here = &windows[self.window];
            let next = windows.get(self.window + 1);
            if let Some(next) = next.filter(|_| (p - here.end.point).dot(here.end.d1) > 0.0) {
                self.window += 1;
                self.s = next.start.s;
                continue;
            }
            let (s, distance) = self.on.foot(here, p, self.s);
            let stuck = distance > 0.0 && (s <= self.s || s >= here.end.s);
            let ahead = if stuck { self.ahead(p, distance) } else { None };
            if let Some((window, s)) = ahead {
                (self.window, self.s) = (window, s);
                continue;
            }
            self.s = s;
            self.last = Some((p, distance));
            return distance;
        }
    }

    /// A place further on that is nearer to `p`. At a corner sharper than a right angle, a cusp, or where the view
    /// shows a whole piece as a point, the curve leads back past the end of a window, so that `p` never gets beyond
    /// it. How far to look: the foot may move twice as far as the sample did, not over a loop.
    fn ahead(&self, p: Point3, distance: f64) -> Option<(usize, f64)> {
        let (last, last_distance) = self.last?;
        let mut budget = 2.0 * (p.distance(last) + last_distance);
        let mut best = (distance, None);
        for (i, window) in self.on.windows.iter().enumerate().skip(self.window + 1) {
            if budget < 0.0 {
                break;
            }
            let (s, d) = self.on.foot(window, p, window.start.s);
            if d < best.0 {
                best = (d, Some((i, s)));
            }
            budget -= window.start.point.distance(window.end.point);
        }
        best.1
    }
}

/// Largest distance from the points of `a` to their feet on `b`: of samples, then refined at the largest one.
fn one_way(a: &Track<'_>, b: &Track<'_>) -> f64 {
    let mut walker = Walker::new(b);
    let mut largest = 0.0_f64;
    // Window, part of it, and the walk as it was before the largest sample.
    let mut place = None;
    for w in &a.windows {
        largest = largest.max(walker.distance(w.start.point));
        for f in SAMPLES {
            let before = walker.clone();
            let distance = walker.distance(a.part(w, f));
            if distance > largest {
                largest = distance;
                place = Some((w, f, before));
            }
        }
    }
    if let Some(last) = a.windows.last() {
        largest = largest.max(walker.distance(last.end.point));
    }
    let refined = place.map_or(0.0, |(w, f, before)| top(|f| before.clone().distance(a.part(w, f)), f));
    largest.max(refined)
}

/// Largest value of a function with one hump between the neighbours of sample `f`, by golden section.
fn top(value: impl Fn(f64) -> f64, f: f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_895;
    let (mut a, mut b) = (f - SAMPLES[0], f + SAMPLES[0]);
    let (mut c, mut d) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
    let (mut at_c, mut at_d) = (value(c), value(d));
    for _ in 0..24 {
        if at_c > at_d {
            (b, d, at_d) = (d, c, at_c);
            c = b - GOLDEN * (b - a);
            at_c = value(c);
        } else {
            (a, c, at_c) = (c, d, at_d);
            d = a + GOLDEN * (b - a);
            at_d = value(d);
        }
    }
    at_c.max(at_d)
}
