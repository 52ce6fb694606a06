//! All arcs from a given joint and tangent that stay within a tolerance of a polyline: one interval of signed
//! curvature per end vertex, nested, in constant time per vertex and edge
//! (`docs/math/arc-fitting.md#curvature-intervals`).
//!
//! Frame: origin at the joint, first axis along the tangent. Nothing cancels as the curvature goes to 0.

use super::bulge_interval::one_minus_and_plus;
use super::input;
use crate::base::planar::{Point2, Vec2};
use crate::error::{ErrorItem, NumberError, Result, check_tolerance};

/// Largest `|curvature| * tolerance` of an arc: below 1 the circle cannot hide inside the tube.
const MAX_CURVATURE_TOLERANCE: f64 = 0.98;

/// A joint of a tangent-continuous chain and its unit tangent; the origin and first axis of the frame used here.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct JointFrame {
    pub joint: Point2,
    pub tangent: Vec2,
}

impl JointFrame {
    pub fn local(&self, p: Point2) -> Vec2 {
        let v = p - self.joint;
        Vec2::new(self.tangent.dot(v), self.tangent.cross(v))
    }

    /// The joint at the end of the arc of signed curvature `kappa` over the vertex with frame coordinates `v`
    /// (`v.x > 0`): the point of the arc whose normal passes through the vertex. No trigonometry.
    pub fn end_over(&self, kappa: f64, v: Vec2) -> Self {
        let (a, b) = (kappa * v.x, 1.0 - kappa * v.y);
        let z = a.hypot(b);
        let forward = self.tangent * (v.x / z);
        // a x/(z (z+b)) with z + b = a²/(z-b) where it would cancel, near half a turn.
        let across = if b >= 0.0 { a * v.x / (z * (z + b)) } else { (z - b) / (z * kappa) };
        let aside = self.tangent.left() * across;
        Self { joint: self.joint + forward + aside, tangent: self.rotated(b, a) }
    }

    /// The joint turned by the angle of `(cosine, sine)`, which need not be normalized.
    fn rotated(&self, cosine: f64, sine: f64) -> Vec2 {
        let t = self.tangent * cosine + self.tangent.left() * sine;
        let l = t.length();
        Vec2::new(t.x / l, t.y / l)
    }

    /// Tangent at the end of the arc from this joint to the point with frame coordinates `v`.
    pub fn end_tangent_at(&self, v: Vec2) -> Vec2 {
        self.rotated((v.x - v.y) * (v.x + v.y), 2.0 * v.x * v.y)
    }
}

/// Curvature of the arc from the joint to the point with frame coordinates `v`.
pub(super) fn curvature_to(v: Vec2) -> f64 {
    2.0 * v.y / v.dot(v)
}

/// The interval so far while vertices are added one by one.
#[derive(Debug, Clone, Copy)]
pub(super) struct CurvatureSweep {
    pub lo: f64,
    pub hi: f64,
    last: Vec2,
}

impl CurvatureSweep {
    /// `start` is the vertex the joint belongs to, in frame coordinates.
    pub fn new(start: Vec2, tolerance: f64) -> Self {
        let limit = MAX_CURVATURE_TOLERANCE / tolerance;
        Self { lo: -limit, hi: limit, last: start }
    }

    /// Adds the next vertex, in frame coordinates, with its own tolerance, and that of the edge which ends there if it
    /// is bound too; false if no curvature is left.
    pub fn advance(&mut self, q: Vec2, tolerance: f64, edge: Option<f64>) -> bool {
        let p = std::mem::replace(&mut self.last, q);
        if !(q.x > 0.0) {
            return false; // sweeps stay below half a turn
        }
        self.vertex(q, tolerance);
        self.step(p, q);
        self.lo <= self.hi && edge.is_none_or(|t| self.edge(p, q, t))
    }

    fn vertex(&mut self, q: Vec2, t: f64) {
        let d = q.dot(q) - t * t;
        if d > 0.0 {
            self.lo = self.lo.max(2.0 * (q.y - t) / d);
            self.hi = self.hi.min(2.0 * (q.y + t) / d);
        }
    }

    /// M: `kappa (p x q) + (q_x - p_x) >= 0`.
    fn step(&mut self, p: Vec2, q: Vec2) {
        let (x, d) = (p.cross(q), q.x - p.x);
        if x > 0.0 {
            self.lo = self.lo.max(-d / x);
        } else if x < 0.0 {
            self.hi = self.hi.min(-d / x);
        } else if d < 0.0 {
            (self.lo, self.hi) = (1.0, -1.0);
        }
    }

    /// E: `|kappa| (tolerance + p x e) >= 1 - e_x` (mirrored for negative curvature) where the foot of the center is
    /// inside the edge. Where it leaves the edge the condition is that of a vertex, which holds already; so a bound
    /// of large curvature that breaks E leaves nothing.
    fn edge(&mut self, p: Vec2, q: Vec2, tolerance: f64) -> bool {
        let Some(e) = (q - p).unit() else { return true };
        let (from, to) = (e.dot(p), e.dot(q));
        let (minus, _) = one_minus_and_plus(e);
        let moment = p.cross(e);
        // The smallest |kappa| that satisfies E, if the foot is inside and E is broken at this curvature.
        let broken = |kappa: f64| {
            let foot = e.y / kappa;
            let room = tolerance + if kappa > 0.0 { moment } else { -moment };
            let inside = kappa != 0.0 && from <= foot && foot <= to;
            (inside && kappa.abs() * room < minus).then(|| if room > 0.0 { minus / room } else { f64::INFINITY })
        };
        match (broken(self.lo), broken(self.hi)) {
            (None, None) => {}
            (Some(least), None) if self.lo > 0.0 => self.lo = least,
            (None, Some(least)) if self.hi < 0.0 => self.hi = -least,
            (Some(least), Some(_)) if self.lo > 0.0 => self.lo = least,
            (Some(_), Some(least)) if self.hi < 0.0 => self.hi = -least,
            _ => return false,
        }
        self.lo <= self.hi
    }
}

/// For each end vertex from the second point on, the interval of signed curvature (left positive) of the arcs that
/// start in `start` in the direction `tangent_angle` (radians from the first axis), pass within `tolerance` of every
/// vertex up to that one (V) and run with every step (M). The list ends where no curvature is left.
///
/// The first point is the vertex that the joint `start` belongs to. Sweeps stay below half a turn.
///
/// ```
/// use cyclide::Point2;
/// // Tangent arcs from the origin that pass within 0.1 of a point straight ahead: the segment is one.
/// let found = cyclide::construct::curvature_intervals(&[Point2::new(0.0, 0.0), Point2::new(1.0, 0.0)], Point2::new(0.0, 0.0), 0.0, 0.1)?;
/// assert!(found.iter().any(|[from, to]| *from < 0.0 && *to > 0.0));
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// `tolerance-not-positive`, `too-few-points` (fewer than 2), `not-finite`.
pub fn curvature_intervals(
    points: &[Point2],
    start: Point2,
    tangent_angle: f64,
    tolerance: f64,
) -> Result<Vec<[f64; 2]>> {
    check_tolerance(tolerance)?;
    input::check_points(points, 2)?;
    if !start.is_finite() {
        return Err(NumberError::NotFinite { what: ErrorItem::Start, index: 0 }.into());
    }
    if !tangent_angle.is_finite() {
        return Err(NumberError::NotFinite { what: ErrorItem::Tangent, index: 0 }.into());
    }
    let (sine, cosine) = tangent_angle.sin_cos();
    let frame = JointFrame { joint: start, tangent: Vec2::new(cosine, sine) };
    let mut sweep = CurvatureSweep::new(frame.local(points[0]), tolerance);
    let ends = points[1..]
        .iter()
        .map_while(|p| sweep.advance(frame.local(*p), tolerance, None).then_some([sweep.lo, sweep.hi]));
    Ok(ends.collect())
}
