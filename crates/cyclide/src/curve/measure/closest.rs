//! The nearest point of a curve, globally, for one or many queries.
//!
//! The pieces are cut into parts once, and a binary tree of boxes is laid over the parts in their order along the
//! curve. A query walks the tree nearest box first and leaves out what is farther than the best point found.
//!
//! Arcs and circles are solved in closed form. A part of another piece, of length `L` between its ends `A` and `B`,
//! is judged by certificates:
//! - no point of it is nearer than `(|PA| + |PB| - L)/2` (triangle inequality), nor nearer than the chord by more than
//!   `sqrt(L² - |AB|²)/2` (it lies in the ellipse with foci `A`, `B`);
//! - with `k` the curvature vector, the second derivative of half the squared distance by arc length is
//!   `1 + (x - P)·k`: where it is positive throughout there is one minimum, found by a safeguarded Newton iteration;
//!   where it is negative throughout the minimum is at an end; else the part is halved.
//!
//! Lengths come from 8-point quadrature and the range of `k` from five places of the part with a margin.

use crate::base::bounds::Aabb;
use crate::base::jet::CurveJet;
use crate::base::quadrature::gauss8;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{ClosestPoint, ParamCurve, PieceForm};

/// Parts are cut until they turn by less than this, radians: then one Newton iteration serves nearby points.
const TURN: f64 = 0.6;
/// Halvings when parts are cut.
const CUT_DEPTH: u32 = 12;
/// Halvings of a part in one query.
const QUERY_DEPTH: u32 = 48;
/// Halvings in one query, all parts together. Only a spline nearly all of whose points are equally far needs more: its
/// distance is flat, and the ends of parts of length `h` miss the minimum by `k² h³` at most.
const QUERY_HALVINGS: u32 = 512;
/// Relative error of a length beyond which its quadrature has missed something.
const LENGTH_ERROR: f64 = 1e-6;
/// How much farther than measured the curvature vector of a part may stray from that of its middle.
const STRAY_MARGIN: f64 = 2.0;

/// The nearest point of the curve to `p`; the first along the curve of equally near ones.
///
/// For many queries on one curve make a [`CurveIndex`].
///
/// ```
/// use cyclide::{Point3, curve::Arc};
/// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let arc = Arc::from_three_points(a, b, c)?;
/// let found = cyclide::curve::closest_point(&arc, Point3::new(0.0, 3.0, 0.0));
/// assert!((found.distance - 2.0).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[must_use]
pub fn closest_point(curve: &dyn ParamCurve, p: Point3) -> ClosestPoint {
    CurveIndex::new(curve).closest_point(p)
}

/// A curve prepared for many closest-point queries.
///
/// ```
/// use cyclide::{Point3, curve::{CircleSpline, CircleSplineOptions, CurveIndex}};
/// let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0], [1.0, 4.0, 1.0]].map(Point3::from);
/// let spline = CircleSpline::from_points(&points, &CircleSplineOptions::default())?;
/// let index = CurveIndex::new(&spline); // for many points of one curve
/// assert!(points.iter().all(|p| index.closest_point(*p).distance < 1e-12));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug)]
pub struct CurveIndex<'a> {
    curve: &'a dyn ParamCurve,
    parts: Vec<Part>,
    /// Boxes of the tree over `parts`: a node over `n` parts is followed by the `2m - 1` nodes of its first
    /// `m = n/2` parts, then by those of the rest.
    boxes: Vec<Aabb>,
}

#[derive(Debug)]
enum Part {
    /// A whole piece with a closed form.
    Exact(usize),
    /// A part of a piece that has none. Boxed: paths of arcs alone should not pay for its size.
    Free(Box<FreePart>),
}

/// The part `[s0, s1]` of a piece.
#[derive(Debug)]
struct FreePart {
    piece: usize,
    s: [f64; 2],
    ends: [CurveJet; 2],
    length: f64,
    /// No point of the part is farther than this from the chord.
    sagitta: f64,
    middle: CurveJet,
    /// Curvature vector at the middle and how far the others stray from it; `None` if it is not finite everywhere.
    curvature: Option<(Vec3, f64)>,
    /// Too long for its chord to turn by less than [`TURN`].
    bent: bool,
}

/// What a query carries along.
struct Query {
    p: Point3,
    best: Candidate,
    halvings: u32,
}

#[derive(Clone, Copy)]
struct Candidate {
    piece: usize,
    s: f64,
    point: Point3,
    distance: f64,
}

impl Query {
    /// Keeps the nearer point, the earlier of equals.
    fn offer(&mut self, piece: usize, s: f64, point: Point3) {
        let distance = point.distance(self.p);
        let best = &self.best;
        let earlier = (piece, s) < (best.piece, best.s);
        if distance < best.distance || (distance <= best.distance && earlier) {
            self.best = Candidate { piece, s, point, distance };
        }
    }
}

impl<'a> CurveIndex<'a> {
    /// Cuts the curve into parts and lays the tree over them.
    #[must_use]
    pub fn new(curve: &'a dyn ParamCurve) -> Self {
        let mut parts = Vec::with_capacity(curve.piece_count());
        for piece in 0..curve.piece_count() {
            match curve.piece_form(piece) {
                PieceForm::Free => {
                    let ends = [curve.piece_jet(piece, 0.0), curve.piece_jet(piece, 1.0)];
                    cut(curve, piece, [0.0, 1.0], ends, CUT_DEPTH, &mut parts);
                }
                PieceForm::Arc(_) | PieceForm::Circle(_) => parts.push(Part::Exact(piece)),
            }
        }
        let leaves: Vec<Aabb> = parts.iter().map(|part| part.bounds(curve)).collect();
        let mut boxes = Vec::with_capacity(2 * leaves.len());
        build(&leaves, &mut boxes);
        Self { curve, parts, boxes }
    }

    /// The nearest point of the curve to `p`; the first along the curve of equally near ones.
    #[must_use]
    pub fn closest_point(&self, p: Point3) -> ClosestPoint {
        let Candidate { piece, s, point, distance } = self.nearest(p);
        ClosestPoint { t: (piece as f64 + s) / self.curve.piece_count() as f64, point, distance }
    }

    /// The ends of the piece that is nearest to `p`, if it is a segment.
    pub(super) fn segment_near(&self, p: Point3) -> Option<[Point3; 2]> {
        match self.curve.piece_form(self.nearest(p).piece) {
            PieceForm::Arc(arc) if arc.is_straight() => Some([arc.start(), arc.end()]),
            _ => None,
        }
    }

    fn nearest(&self, p: Point3) -> Candidate {
        let start = self.curve.piece_point(0, 0.0);
        let best = Candidate { piece: 0, s: 0.0, point: start, distance: start.distance(p) };
        let mut query = Query { p, best, halvings: QUERY_HALVINGS };
        self.visit(&mut query, 0, 0, self.parts.len());
        query.best
    }

    /// Walks the subtree of `node`, which covers the parts `from..to`.
    fn visit(&self, query: &mut Query, node: usize, from: usize, to: usize) {
        if to - from == 1 {
            self.parts[from].search(self.curve, query);
            return;
        }
        let middle = from + (to - from) / 2;
        let (left, right) = (node + 1, node + 2 * (middle - from));
        let (l, r) = (self.boxes[left].distance(query.p), self.boxes[right].distance(query.p));
        let left_first = l <= r;
        for is_left in [left_first, !left_first] {
            if is_left && l <= query.best.distance {
                self.visit(query, left, from, middle);
            } else if !is_left && r <= query.best.distance {
                self.visit(query, right, middle, to);
            }
        }
    }
}

/// Appends the boxes of the subtree over these leaves.
fn build(leaves: &[Aabb], boxes: &mut Vec<Aabb>) {
    let Some(first) = leaves.first() else { return };
    boxes.push(leaves.iter().fold(*first, |b, l| b.union(*l)));
    if leaves.len() > 1 {
        let (left, right) = leaves.split_at(leaves.len() / 2);
        build(left, boxes);
        build(right, boxes);
    }
}

/// Cuts a piece into parts of little turn.
fn cut(curve: &dyn ParamCurve, piece: usize, s: [f64; 2], ends: [CurveJet; 2], depth: u32, parts: &mut Vec<Part>) {
    let part = FreePart::new(curve, piece, s, ends);
    let turn = part.curvature.map_or(f64::INFINITY, |(k, stray)| (k.length() + stray) * part.length);
    if depth == 0 || (turn < TURN && !part.bent) || part.length == 0.0 {
        parts.push(Part::Free(Box::new(part)));
        return;
    }
    let m = 0.5 * (s[0] + s[1]);
    cut(curve, piece, [s[0], m], [ends[0], part.middle], depth - 1, parts);
    cut(curve, piece, [m, s[1]], [part.middle, ends[1]], depth - 1, parts);
}

impl Part {
    fn bounds(&self, curve: &dyn ParamCurve) -> Aabb {
        match self {
            Self::Exact(piece) => curve.piece_bounds(*piece),
            Self::Free(part) => {
                let e = Vec3::new(part.sagitta, part.sagitta, part.sagitta);
                let chord = Aabb::of_point(part.ends[0].point).including(part.ends[1].point);
                Aabb { min: chord.min - e, max: chord.max + e }
            }
        }
    }

    fn search(&self, curve: &dyn ParamCurve, query: &mut Query) {
        match self {
            Self::Exact(piece) => {
                let c = match curve.piece_form(*piece) {
                    PieceForm::Arc(arc) => arc.closest_point(query.p),
                    PieceForm::Circle(circle) => circle.closest_point(query.p),
                    // Free pieces are cut into parts.
                    PieceForm::Free => return,
                };
                query.offer(*piece, c.t, c.point);
            }
            Self::Free(part) => part.search(curve, query, QUERY_DEPTH),
        }
    }
}

impl FreePart {
    fn new(curve: &dyn ParamCurve, piece: usize, s: [f64; 2], ends: [CurveJet; 2]) -> Self {
        let length = gauss8(&mut |s| curve.piece_speed(piece, s), s[0], s[1]);
        let chord = ends[0].point.distance(ends[1].point);
        let sagitta = 0.5 * ((length - chord).max(0.0) * (length + chord)).sqrt();
        let middle = curve.piece_jet(piece, 0.5 * (s[0] + s[1]));
        let quarters = [0.75, 0.25].map(|w| curve.piece_jet(piece, w * s[0] + (1.0 - w) * s[1]));
        let stray = middle.curvature_vector().and_then(|m| {
            // The ends alone would miss the lobes of a part that is symmetric about its middle.
            let others = [ends[0], quarters[0], quarters[1], ends[1]];
            let from_middle = others.iter().map(|jet| Some((jet.curvature_vector()? - m).length()));
            let stray = STRAY_MARGIN * from_middle.collect::<Option<Vec<f64>>>()?.into_iter().fold(0.0, f64::max);
            stray.is_finite().then_some((m, stray))
        });
        // A curve whose inscribed polygon is longer than itself was measured wrongly.
        let places = [ends[0].point, quarters[0].point, middle.point, quarters[1].point, ends[1].point];
        let inscribed: f64 = places.windows(2).map(|w| w[0].distance(w[1])).sum();
        let rounding = 8.0 * f64::EPSILON * middle.point.to_vec().max_abs();
        let curvature = stray.filter(|_| inscribed <= length * (1.0 + LENGTH_ERROR) + rounding);
        // A curve that turns by less than TURN in all is no longer than its chord over cos(TURN/2) (A. Schur).
        let bent = length * (0.5 * TURN).cos() > chord + rounding;
        Self { piece, s, ends, length, sagitta, middle, curvature, bent }
    }

    /// A lower bound on the distance of the part.
    fn lower_bound(&self, p: Point3) -> f64 {
        let [a, b] = self.ends.map(|e| e.point);
        let c = b - a;
        let c2 = c.length_squared();
        let f = if c2 > 0.0 { ((p - a).dot(c) / c2).clamp(0.0, 1.0) } else { 0.0 };
        let tube = p.distance(a.lerp(b, f)) - self.sagitta;
        tube.max(0.5 * (p.distance(a) + p.distance(b) - self.length))
    }

    /// Lower and upper bound of `1 + (x - P)·k` over the part.
    fn second_derivative(&self, p: Point3) -> (f64, f64) {
        let Some((k, stray)) = self.curvature else { return (f64::NEG_INFINITY, f64::INFINITY) };
        let from = self.middle.point - p;
        // No point is farther from the middle than the length of the part.
        let slack = from.length() * stray + self.length * (k.length() + stray);
        let value = 1.0 + from.dot(k);
        (value - slack, value + slack)
    }

    fn search(&self, curve: &dyn ParamCurve, query: &mut Query, depth: u32) {
        if self.lower_bound(query.p) > query.best.distance {
            return;
        }
        let [a, b] = self.ends;
        let (low, high) = self.second_derivative(query.p);
        let m = 0.5 * (self.s[0] + self.s[1]);
        let ended = depth == 0 || query.halvings == 0 || m <= self.s[0] || m >= self.s[1] || self.length == 0.0;
        if low > 0.0 || high < 0.0 || ended {
            query.offer(self.piece, self.s[0], a.point);
            query.offer(self.piece, self.s[1], b.point);
            // A minimum inside: the distance falls at the start and rises at the end.
            if high >= 0.0 && (a.point - query.p).dot(a.d1) < 0.0 && (b.point - query.p).dot(b.d1) > 0.0 {
                let s = self.minimum(curve, query.p);
                query.offer(self.piece, s, curve.piece_point(self.piece, s));
            }
            return;
        }
        query.halvings -= 1;
        let left = Self::new(curve, self.piece, [self.s[0], m], [a, self.middle]);
        let right = Self::new(curve, self.piece, [m, self.s[1]], [self.middle, b]);
        if left.lower_bound(query.p) <= right.lower_bound(query.p) {
            left.search(curve, query, depth - 1);
            right.search(curve, query, depth - 1);
        } else {
            right.search(curve, query, depth - 1);
            left.search(curve, query, depth - 1);
        }
    }

    /// The zero of `(x - P)·x'` inside, by Newton steps kept in the bracket.
    fn minimum(&self, curve: &dyn ParamCurve, p: Point3) -> f64 {
        let [mut low, mut high] = self.s;
        let width = high - low;
        let [a, b] = self.ends.map(|e| e.point);
        let c = b - a;
        let f = (p - a).dot(c) / c.length_squared();
        let mut s = low + width * if f > 0.0 && f < 1.0 { f } else { 0.5 };
        // Newton converges quadratically; each step outside the bracket halves it.
        for _ in 0..64 {
            let jet = curve.piece_jet(self.piece, s);
            let from = jet.point - p;
            let g = from.dot(jet.d1);
            if g < 0.0 {
                low = s;
            } else {
                high = s;
            }
            let step = g / (jet.d1.length_squared() + from.dot(jet.d2));
            let next = s - step;
            let inside = next >= low && next <= high;
            let next = if inside { next } else { 0.5 * (low + high) };
            let moved = (next - s).abs();
            s = next;
            // The error after a Newton step is of the order of the square of the step.
            if moved <= 1e-9 * width || g == 0.0 {
                break;
            }
        }
        s
    }
}
