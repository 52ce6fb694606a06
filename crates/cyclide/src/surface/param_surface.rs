//! The trait every surface patch implements.

use crate::base::surface_jet::SurfaceJet;
use crate::base::vector::{Point3, Vec3};
use crate::rational::RationalBezierSurface;

/// A smooth (analytic) parametric surface patch over `[0, 1]²`. Object-safe; one method is required.
///
/// ```
/// use cyclide::{Point3, Vec3, rational::RationalBezierSurface, surface::{CyclidePatch, ParamSurface}, topology::FaceSurface};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
/// let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y)?;
/// let (face, rational): (FaceSurface, RationalBezierSurface) = (patch.into(), patch.to_rational());
/// let surfaces: [&dyn ParamSurface; 3] = [&patch, &face, &rational];
/// assert!(surfaces.iter().all(|surface| surface.point(0.5, 0.5).distance(Point3::new(0.5, 0.5, 0.0)) < 1e-15));
/// # Ok::<(), cyclide::Error>(())
/// ```
pub trait ParamSurface: Send + Sync {
    /// Point and partial derivatives of orders 1 and 2 at `(s, t)`.
    fn jet(&self, s: f64, t: f64) -> SurfaceJet;

    /// The point at `(s, t)`; override where it is cheaper than a jet.
    fn point(&self, s: f64, t: f64) -> Point3 {
        self.jet(s, t).point
    }

    /// Unit normal at `(s, t)`, the direction of `f_s × f_t`; `None` where the surface has none.
    fn normal(&self, s: f64, t: f64) -> Option<Vec3> {
        self.jet(s, t).normal()
    }
}

impl ParamSurface for RationalBezierSurface {
    fn jet(&self, s: f64, t: f64) -> SurfaceJet {
        Self::jet(self, s, t)
    }

    fn point(&self, s: f64, t: f64) -> Point3 {
        Self::point(self, s, t)
    }

    fn normal(&self, s: f64, t: f64) -> Option<Vec3> {
        Some(self.unit_normal(s, t)).filter(|n| n.max_abs() > 0.0)
    }
}
