//! Which surface a bilinear patch lies on (`docs/math/bilinear-patches.md#which-surface`).

use super::QbPatch;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::Sphere;
use crate::surface::ParamSurface as _;

/// What vanishes up to this part of its terms is zero.
const LIMIT: f64 = 1e-9;
/// Places along each parameter at which a sphere is tried.
const PLACES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// What surface a bilinear patch lies on.
///
/// ```no_run
/// use cyclide::{Point3, Vec3, surface::{CornerTwist, QbPatch, QbPatchKind}};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.5]].map(Point3::from);
/// let patch = QbPatch::from_directions(corners, [Vec3::new(1.0, 0.0, 0.2), Vec3::Y], CornerTwist::Default)?;
/// assert_eq!(patch.recognize(), QbPatchKind::Darboux);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum QbPatchKind {
    /// A principal patch of a Dupin cyclide: its parameter lines are lines of curvature.
    Dupin,
    /// A Darboux cyclide, a quartic.
    Darboux,
    /// A sphere.
    Sphere {
        /// Its center.
        center: Point3,
        /// Its radius.
        radius: f64,
    },
    /// A plane through the first corner.
    Plane {
        /// Unit normal, the direction of `f_s × f_t` in the middle.
        normal: Vec3,
    },
    /// A hyperboloid or hyperbolic paraboloid, or the image of one under an inversion: all parameter circles pass through one point.
    InvertedQuadric,
}

impl QbPatch {
    /// What surface the patch lies on, to 1e-9: of its terms where equations decide, of its size where a sphere does.
    #[must_use]
    pub fn recognize(&self) -> QbPatchKind {
        if let Some(round) = self.sphere_or_plane() {
            return round;
        }
        let [x1, x2, x3] = [1, 2, 3].map(|k| (self.corners[k] - self.corners[0]) / self.scale);
        // In the gauge of the first weight 1: P1, P2 and Q = S + q.
        let gauge = self.weights[0].inverse().unwrap_or(Quat::ONE);
        let [p1, p2, last] = [1, 2, 3].map(|k| self.n[k] * gauge);
        if last.w.abs() <= LIMIT * last.norm() {
            return QbPatchKind::InvertedQuadric;
        }
        let inverse = |x: Vec3| x / -x.length_squared();
        let [b1, b2, b3] = [x1, x2, x3].map(inverse);
        let d = b1 - b2;
        let off = (Quat::from(d) * p1 * p2 - last).norm() / last.norm();
        let [v1, v2] = [p1, p2].map(|p| p.vector().unit().unwrap_or_default());
        let beside = (b3 - b1).cross(d).length() / d.length_squared();
        let is_dupin = v1.dot(v2).abs() <= LIMIT && off <= LIMIT && beside <= LIMIT;
        if is_dupin { QbPatchKind::Dupin } else { QbPatchKind::Darboux }
    }

    /// The sphere or plane on which all points lie.
    fn sphere_or_plane(&self) -> Option<QbPatchKind> {
        let points = || PLACES.into_iter().flat_map(|s| PLACES.map(|t| self.point(s, t)));
        let (origin, limit) = (self.corners[0], LIMIT * self.scale);
        if let Some(normal) = self.normal(0.5, 0.5)
            && points().all(|p| (p - origin).dot(normal).abs() <= limit)
        {
            return Some(QbPatchKind::Plane { normal });
        }
        // Four points that are far from a plane: the corners of a Dupin patch are in one.
        let choices =
            [[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.5, 0.5)], [(1.0, 1.0), (1.0, 0.0), (0.0, 1.0), (0.5, 0.5)]];
        let spheres = choices.map(|places| Sphere::through_points(places.map(|(s, t)| self.point(s, t))));
        let sphere = spheres.into_iter().flatten().min_by(|a, b| a.radius().total_cmp(&b.radius()))?;
        let (center, radius) = (sphere.center(), sphere.radius());
        let is_on = |p: Point3| (p.distance(center) - radius).abs() <= limit;
        points().all(is_on).then_some(QbPatchKind::Sphere { center, radius })
    }
}
