//! The cone of revolution that comes nearest to points with normals (`docs/math/patches.md#rational-surfaces`).

use crate::base::elimination::solution;
use crate::base::frame::Frame;
use crate::base::vector::{Point3, Vec3};

/// Normals are at one angle to the axis to this, a right one of cylinders; it only keeps other surfaces from the proof.
pub(super) const ACROSS: f64 = 1e-8;
/// Steps towards the nearest cone. What normals suggest is right to some digits, and each step squares what is left.
const STEPS: usize = 4;
/// Normals that span no more than this part of the sphere have no axis.
const SMALLEST_SPAN: f64 = 1e-10;

/// A cone of revolution: about the third axis of its frame, away from the tip, with a radius at the origin and the tangent of half its angle.
pub(super) struct ConeFit {
    pub(super) frame: Frame,
    pub(super) radius: f64,
    pub(super) slope: f64,
}

impl ConeFit {
    /// From the normals, refined on the points; the origin is as high as the point `middle`.
    pub(super) fn of(points: &[Point3], normals: &[Vec3], middle: usize) -> Option<Self> {
        let mut fit = Self::from_normals(points, normals, middle)?;
        for _ in 0..STEPS {
            fit = fit.refined(points)?;
        }
        (fit.radius > 0.0 && fit.slope > 0.0).then_some(fit)
    }

    /// All normals are at one angle to the axis, and all tangent planes pass through the tip: by three that are far apart.
    fn from_normals(points: &[Point3], normals: &[Vec3], middle: usize) -> Option<Self> {
        let farthest = |measure: &dyn Fn(Vec3) -> f64| {
            (0..normals.len()).max_by(|a, b| measure(normals[*a]).total_cmp(&measure(normals[*b])))
        };
        let a = farthest(&|n| (n - normals[middle]).length())?;
        let b = farthest(&|n| (n - normals[a]).length())?;
        let c = farthest(&|n| (n - normals[a]).cross(n - normals[b]).length())?;
        let [u, v, w] = [a, b, c].map(|k| normals[k]);
        let across = (v - u).cross(w - u);
        // Not `<`: what is no number is refused too.
        if !(across.length() >= SMALLEST_SPAN) {
            return None;
        }
        let axis = across.unit()?;
        let height = u.dot(axis);
        if !normals.iter().all(|n| (n.dot(axis) - height).abs() <= ACROSS) {
            return None;
        }
        let volume = u.dot(v.cross(w));
        let from = points[middle];
        let [p, q, r] = [a, b, c].map(|k| normals[k].dot(points[k] - from));
        let tip = from + (v.cross(w) * p + w.cross(u) * q + u.cross(v) * r) / volume;
        let along = (from - tip).dot(axis);
        let axis = if along < 0.0 { -axis } else { axis };
        let origin = tip + axis * along.abs();
        let frame = Frame::from_normal(origin, axis, from - origin).ok()?;
        let radius = from.distance(origin);
        let slope = radius / along.abs();
        (radius.is_finite() && slope.is_finite()).then_some(Self { frame, radius, slope })
    }

    /// One step of least squares: how far the axis moves and leans, and radius and slope change. On a narrow strip, whose middle is on the
    /// first axis, moves and changes of the radius are nearly the same, and so are leaning and the slope: their sums are found, and what is
    /// left of the moves.
    fn refined(&self, points: &[Point3]) -> Option<Self> {
        let unit = self.radius;
        let mut normal = [[0.0; 7]; 6];
        for p in points {
            let (flat, height) = self.frame.to_local(*p);
            let distance = flat.x.hypot(flat.y);
            let (cos, sin, z) = (flat.x / distance, flat.y / distance, height / unit);
            let rest = -sin * sin / (1.0 + cos);
            let off = (distance - self.radius - self.slope * height) / unit;
            // Where the axis leans, heights change too.
            let lean = z * (1.0 + self.slope * self.slope) + self.slope;
            let row = [rest, sin, rest * lean, sin * lean, 1.0, z, off];
            for (i, line) in normal.iter_mut().enumerate() {
                for (sum, entry) in line.iter_mut().zip(row) {
                    *sum += row[i] * entry;
                }
            }
        }
        let [x, y, lean_x, lean_y, wider, steeper] = solution(normal)?;
        let wider = wider - x - self.slope * lean_x;
        let steeper = steeper - (1.0 + self.slope * self.slope) * lean_x;
        let [e1, e2, e3] = [self.frame.x(), self.frame.y(), self.frame.z()];
        let origin = self.frame.origin() + (e1 * x + e2 * y) * unit;
        let frame = Frame::from_normal(origin, e3 + e1 * lean_x + e2 * lean_y, e1).ok()?;
        Some(Self { frame, radius: self.radius + wider * unit, slope: self.slope + steeper })
    }
}
