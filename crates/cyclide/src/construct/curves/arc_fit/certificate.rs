//! The proof sheet of a fit: measured on the finished arcs, sharing no code with the search
//! (`docs/math/arc-fitting.md#proof-sheet`).
//!
//! Distances are nearest points on each arc, tangents come from the arcs as they are stored, and the closing joint
//! is a joint like the others. Each arc is compared with the run of the polyline it stands for, in order: the feet
//! of consecutive vertices must advance along the path, and every edge must run with the arc under it (conditions M
//! and W of `docs/math/arc-fitting.md#certificate-of-one-arc`), so the distances are Fréchet distances and not merely
//! those of two point sets.

use super::options::FitTarget;
use super::piece::{Piece, Place, Span};
use super::trace::Trace;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, ClosestPoint, ParamCurve, PieceForm, joints};
use std::f64::consts::PI;

/// Feet may step back by this much of an arc's parameter: rounding at joints.
const FOOT_SLACK: f64 = 1e-9;

/// What is proved about a fitted path.
///
/// ```
/// use cyclide::{Point3, construct::{ArcFit, ArcFitOptions}};
/// let points: Vec<Point3> = (0..20).map(|k| Point3::new(f64::from(k), 0.1 * f64::from(k * k), 0.0)).collect();
/// let fit = ArcFit::new(&points, &ArcFitOptions::new(0.05))?;
/// let certificate = fit.certificate();
/// assert!(certificate.vertex_deviation <= 0.05 && certificate.arcs + certificate.lines == fit.path().arcs().len());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FitCertificate {
    /// The deviation the tolerance binds: of the points for [`FitTarget::Points`], and both ways of the edges that are
    /// straight sides; both ways between curve and polyline for [`FitTarget::Polyline`].
    pub deviation: f64,
    /// Largest distance of a point from the part of the path that stands for it.
    pub vertex_deviation: f64,
    /// Largest distance between path and polyline, both ways: their Hausdorff distance for planar data, a bound of it
    /// in space. Proved where [`monotone`](Self::monotone) holds.
    pub polyline_deviation: f64,
    /// True if points and path advance together (M and W): [`polyline_deviation`](Self::polyline_deviation) is then
    /// the Fréchet distance of planar data, and bounds it in space.
    pub monotone: bool,
    /// Largest angle between the tangents at a joint, corners excepted, radians.
    pub max_kink: f64,
    /// Total turning of the path, radians: the sweeps of its arcs and the angles at its corners.
    pub turning: f64,
    /// The most that the data turn within the tolerance, radians: what the smooth curve through them turns and what
    /// the tolerance adds per piece.
    pub turning_limit: f64,
    /// Circular arcs in the path.
    pub arcs: usize,
    /// Straight segments in the path.
    pub lines: usize,
    /// The point (in the user's numbering) with the largest deviation of the kind that the tolerance binds.
    pub worst: usize,
}

impl FitCertificate {
    /// That of a curve of arcs and segments, or of a circle, which stands for itself: it is off by nothing. `None` of any other.
    ///
    /// ```
    /// use cyclide::{Point3, construct::FitCertificate, curve::Arc};
    /// let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
    /// let sheet = FitCertificate::of_itself(&Arc::from_three_points(a, b, c)?).expect("it is an arc");
    /// assert!(sheet.deviation == 0.0 && sheet.arcs == 1 && (sheet.turning - std::f64::consts::PI).abs() < 1e-12);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn of_itself(curve: &dyn ParamCurve) -> Option<Self> {
        let (mut arcs, mut lines, mut turning) = (0, 0, 0.0);
        for piece in 0..curve.piece_count() {
            match curve.piece_form(piece) {
                PieceForm::Arc(arc) if arc.is_straight() => lines += 1,
                PieceForm::Arc(arc) => {
                    arcs += 1;
                    turning += arc.curvature() * curve.piece_length(piece, 0.0, 1.0);
                }
                PieceForm::Circle(_) => {
                    arcs += 1;
                    turning += 2.0 * PI;
                }
                PieceForm::Free => return None,
            }
        }
        let max_kink = joints(curve).iter().map(|joint| joint.angle).fold(0.0, f64::max);
        Some(Self {
            deviation: 0.0,
            vertex_deviation: 0.0,
            polyline_deviation: 0.0,
            monotone: true,
            max_kink,
            turning,
            turning_limit: turning,
            arcs,
            lines,
            worst: 0,
        })
    }

    /// Turning over its limit; negative within it.
    pub(super) fn excess_turning(&self) -> f64 {
        self.turning - self.turning_limit
    }
}

/// Certifies the pieces against the trace they stand for. `planar`: the edges are in the plane of their arc.
pub(super) fn certify(pieces: &[Piece], trace: &Trace, target: FitTarget, planar: bool) -> FitCertificate {
    let mut sheet = Sheet::new();
    for piece in pieces {
        sheet.add(piece, trace, planar);
    }
    let kink = |i: usize| {
        let before = if i > 0 { &pieces[i - 1] } else { pieces.last()? };
        Some(before.arc.end_tangent()?.angle(pieces[i].arc.start_tangent()?))
    };
    let joints = (0..pieces.len()).filter(|i| pieces[*i].smooth);
    let max_kink = joints.filter_map(kink).fold(0.0, f64::max);
    let lines = pieces.iter().filter(|p| p.arc.is_straight()).count();
    let (deviation, worst) = sheet.bound(target);
    FitCertificate {
        deviation,
        vertex_deviation: sheet.vertex.0,
        polyline_deviation: sheet.polyline.0,
        monotone: sheet.monotone,
        max_kink,
        turning: 0.0,
        turning_limit: f64::INFINITY,
        arcs: pieces.len() - lines,
        lines,
        worst,
    }
}

/// The largest distance over an edge of the trace beyond what is allowed for one of its length: that distance, and what is allowed.
pub(super) fn farthest_over_edge(
    pieces: &[Piece],
    trace: &Trace,
    planar: bool,
    allowed: impl Fn(f64) -> f64,
) -> Option<(f64, f64)> {
    let mut sheet = Sheet { over_edges: Some(Vec::new()), ..Sheet::new() };
    pieces.iter().for_each(|piece| sheet.add(piece, trace, planar));
    let over =
        sheet.over_edges.into_iter().flatten().map(|(index, distance)| (distance, allowed(trace.edge_at(index))));
    over.filter(|(distance, limit)| distance > limit).max_by(|a, b| (a.0 - a.1).total_cmp(&(b.0 - b.1)))
}

/// The deviation of one planar piece; `None` if it does not run with its part of the trace.
pub(super) fn deviation_of(piece: &Piece, trace: &Trace, target: FitTarget) -> Option<f64> {
    let mut sheet = Sheet::new();
    sheet.add(piece, trace, true);
    sheet.monotone.then_some(sheet.bound(target).0)
}

/// Largest deviations so far, each with the vertex where it was found.
struct Sheet {
    vertex: (f64, usize),
    /// Of the vertices, and both ways of the edges that are bound.
    bound: (f64, usize),
    polyline: (f64, usize),
    monotone: bool,
    /// The distance over each edge of the trace, with the place where it begins, if that is asked for.
    over_edges: Option<Vec<(usize, f64)>>,
}

fn raise(largest: &mut (f64, usize), value: f64, vertex: usize) {
    if value > largest.0 {
        *largest = (value, vertex);
    }
}

impl Sheet {
    fn new() -> Self {
        Self { vertex: (0.0, 0), bound: (0.0, 0), polyline: (0.0, 0), monotone: true, over_edges: None }
    }

    /// The deviation the tolerance binds, and where.
    fn bound(&self, target: FitTarget) -> (f64, usize) {
        match target {
            FitTarget::Points => self.bound,
            FitTarget::Polyline => self.polyline,
        }
    }

    fn add(&mut self, piece: &Piece, trace: &Trace, planar: bool) {
        let (n, arc, Span { from, to }) = (trace.points.len(), &piece.arc, piece.span);
        // The ends of the span are matched with the ends of the arc: the pieces must join up.
        let end = |place: Place, t: f64, point: Point3| {
            let p = place.point(trace);
            (place, p, ClosestPoint { t, point, distance: point.distance(p) })
        };
        let inside = piece.span.inside().map(|index| {
            let p = trace.point(index);
            (Place::over(index), p, arc.closest_point(p))
        });
        let matched = [end(from, 0.0, arc.start())].into_iter().chain(inside).chain([end(to, 1.0, arc.end())]);
        let mut before: Option<(Point3, f64, f64)> = None;
        let mut begins = from.index;
        // Whether the edge up to the next place is bound.
        let mut bound = false;
        for (place, p, foot) in matched {
            let vertex = trace.vertex_before(place.index % n);
            if place.fraction == 0.0 && trace.vertex[place.index % n].is_some() {
                raise(&mut self.vertex, foot.distance, vertex);
                raise(&mut self.bound, foot.distance, vertex);
            }
            raise(&mut self.polyline, foot.distance, vertex);
            if let Some((q, t, distance)) = before {
                let (length, turn) = part(arc, t, foot.t);
                // W: seen from the center an edge spans less than half a turn, and so does the arc over it.
                let short = turn < PI;
                self.monotone &= foot.t >= t - FOOT_SLACK && short && runs_along(arc, t, foot.t, p - q);
                let largest = distance.max(foot.distance);
                let edge = if !short {
                    largest + length
                } else if planar {
                    apex_height(arc, t, foot.t, q, p - q)
                } else {
                    largest + 0.5 * length * (0.25 * turn).tan()
                };
                raise(&mut self.polyline, edge.max(largest), vertex);
                if let Some(all) = &mut self.over_edges {
                    all.push((begins % n, edge.max(largest)));
                }
                if bound {
                    raise(&mut self.bound, edge.max(largest), vertex);
                }
            }
            before = Some((p, foot.t, foot.distance));
            bound = trace.bound[place.index % n];
            begins = place.index;
        }
    }
}

/// Length and turn of an arc between two parameters.
fn part(arc: &Arc, t0: f64, t1: f64) -> (f64, f64) {
    (arc.length_to(t1) - arc.length_to(t0), arc.angle_to(t1) - arc.angle_to(t0))
}

/// The edge runs with the arc at the feet of both its ends.
fn runs_along(arc: &Arc, t0: f64, t1: f64, edge: Vec3) -> bool {
    let along = |t: f64| arc.piece_jet(0, t).d1.unit().is_none_or(|d| d.dot(edge) >= -FOOT_SLACK * edge.length());
    along(t0) && along(t1)
}

/// Height over the line of the edge of the point between the two feet where arc and edge are parallel, found by
/// bisection; 0 if there is none (the extremes are then the ends).
fn apex_height(arc: &Arc, t0: f64, t1: f64, from: Point3, edge: Vec3) -> f64 {
    let (Some(normal), Some(along)) = (arc.normal(), edge.unit()) else { return 0.0 };
    let across = normal.cross(along);
    let rising = |t: f64| arc.piece_jet(0, t).d1.dot(across);
    let (mut lo, mut hi) = (t0, t1);
    let sign = rising(lo) > 0.0;
    if (rising(hi) > 0.0) == sign {
        return 0.0;
    }
    while hi - lo > 1e-12 {
        let middle = 0.5 * (lo + hi);
        if (rising(middle) > 0.0) == sign {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    (arc.point(0.5 * (lo + hi)) - from).dot(across).abs()
}
