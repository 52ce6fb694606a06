//! The curve a fair fit works on: the fair spline through its nodes, in a form made for many feet
//! (`docs/math/fair-splines.md#law-and-end-curvature`, blend 1).

use crate::base::vector::{Point3, Vec3};
use crate::construct::fair_spline::{TangentLimits, fair_tangents};

/// No trial needs more Newton steps, nor a tangent so far from its chord (`docs/math/fair-fits.md#one-fit`).
const LIMITS: TangentLimits = TangentLimits { steps: 12, least_cosine: -0.8 };

/// A fair spline in the working frame.
#[derive(Debug, Clone)]
pub(super) struct TubeCurve {
    pub closed: bool,
    pub nodes: Vec<Point3>,
    pub tangents: Vec<Vec3>,
    pub segments: Vec<Segment>,
}

/// One segment: the quartic of `docs/math/circle-blends.md#rational-form`, in rising powers of its parameter, and what
/// is needed of its ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Segment {
    pub chord: f64,
    start: Point3,
    /// Numerator relative to the start, and weight.
    numerator: [Vec3; 5],
    weight: [f64; 5],
    /// Curvature vectors at the ends (`docs/math/fair-splines.md#law-and-end-curvature`).
    pub curvature: [Vec3; 2],
    /// Normal parts of their derivatives by length (`docs/math/fair-splines.md#law-and-end-curvature`).
    pub variation: [Vec3; 2],
}

/// A point of a segment with its derivatives by the parameter.
#[derive(Debug, Clone, Copy)]
pub(super) struct SegmentPoint {
    pub point: Point3,
    pub d1: Vec3,
    pub d2: Vec3,
}

impl TubeCurve {
    /// The fair spline through the nodes; `None` if there is none that the fit may use
    /// (`docs/math/fair-fits.md#one-fit`: no fallback inside a fit). `start` are tangents near the solution.
    pub fn new(nodes: Vec<Point3>, closed: bool, start: Option<&[Vec3]>) -> Option<Self> {
        let tangents = fair_tangents(&nodes, closed, start, LIMITS)?;
        let n = nodes.len();
        let count = if closed { n } else { n - 1 };
        let segments = (0..count)
            .map(|i| Segment::new(nodes[i], nodes[(i + 1) % n], tangents[i], tangents[(i + 1) % n]))
            .collect::<Option<Vec<_>>>()?;
        Some(Self { closed, nodes, tangents, segments })
    }

    /// `J = sum d |V|²` (`docs/math/fair-fits.md#variation`).
    pub fn fairness(&self) -> f64 {
        self.segments.iter().map(|s| s.chord * s.variation[0].length_squared()).sum()
    }

    /// Jump of the derivative of curvature at each node; 0 at open ends.
    pub fn jumps(&self) -> Vec<f64> {
        let (n, m) = (self.nodes.len(), self.segments.len());
        let jump = |i: usize| {
            if !self.closed && (i == 0 || i == n - 1) {
                return 0.0;
            }
            let (before, after) = (&self.segments[(i + m - 1) % m], &self.segments[i]);
            (after.variation[0] - before.variation[1]).length()
        };
        (0..n).map(jump).collect()
    }
}

impl Segment {
    /// Blend with e = 1 of the two arcs over a chord; `None` where it has no quartic the fit could use.
    fn new(x1: Point3, x2: Point3, t1: Vec3, te: Vec3) -> Option<Self> {
        let chord = (x2 - x1).length_squared().sqrt();
        if !(chord > 0.0 && chord.is_finite()) {
            return None;
        }
        let d = chord;
        let u = (x2 - x1) / d;
        let t2 = te.reflect(u);
        let back = t1.reflect(u);
        let sum = t1 + t2;
        let s = sum.length_squared().sqrt();
        // The fit keeps to chord angles below a right angle and a half: the short way.
        if !(s > 1e-6) {
            return None;
        }
        let (c1, c2, c) = (u.dot(t1), u.dot(te), 0.5 * s);
        let h = sum / s;
        let w = [1.0, 0.5 * (c + c1), (1.0 + 2.0 * u.dot(h)) / 3.0, 0.5 * (c + c2), 1.0];
        if w.iter().any(|w| !(*w > 0.0)) {
            return None;
        }
        let p = [Vec3::ZERO, t1 * (0.25 * d), u * (d / 6.0) + h * (d / 3.0), u * (w[3] * d) - te * (0.25 * d), u * d];
        let (p1, pe) = (t2 - t1 * t1.dot(t2), back - te * te.dot(back));
        Some(Self {
            chord,
            start: x1,
            numerator: [
                p[0],
                p[1] * 4.0,
                (p[2] - p[1] * 2.0) * 6.0,
                (p[3] - p[2] * 3.0 + p[1] * 3.0) * 4.0,
                p[4] - p[3] * 4.0 + p[2] * 6.0 - p[1] * 4.0,
            ],
            weight: [
                w[0],
                4.0 * (w[1] - w[0]),
                6.0 * (w[2] - 2.0 * w[1] + w[0]),
                4.0 * (w[3] - 3.0 * w[2] + 3.0 * w[1] - w[0]),
                w[4] - 4.0 * w[3] + 6.0 * w[2] - 4.0 * w[1] + w[0],
            ],
            curvature: [(u - t1 * c1 + p1 * (2.0 / s)) * (2.0 / d), (u - te * c2 + pe * (2.0 / s)) * (-2.0 / d)],
            variation: [p1 * (-6.0 / (d * d)), pe * (-6.0 / (d * d))],
        })
    }

    pub fn point(&self, u: f64) -> SegmentPoint {
        let (n, w) = (&self.numerator, &self.weight);
        let horner = |c: [f64; 4]| ((c[3] * u + c[2]) * u + c[1]) * u + c[0];
        let position = (((n[4] * u + n[3]) * u + n[2]) * u + n[1]) * u;
        let slope = ((n[4] * (4.0 * u) + n[3] * 3.0) * u + n[2] * 2.0) * u + n[1];
        let bend = (n[4] * (12.0 * u) + n[3] * 6.0) * u + n[2] * 2.0;
        let weight = horner([w[0], w[1], w[2], w[3] + w[4] * u]);
        let weight1 = horner([w[1], 2.0 * w[2], 3.0 * w[3], 4.0 * w[4]]);
        let weight2 = (12.0 * w[4] * u + 6.0 * w[3]) * u + 2.0 * w[2];
        let q = 1.0 / weight;
        let x = position * q;
        let d1 = (slope - x * weight1) * q;
        let d2 = (bend - d1 * (2.0 * weight1) - x * weight2) * q;
        SegmentPoint { point: self.start + x, d1, d2 }
    }
}
