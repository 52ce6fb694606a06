//! The trait every surface patch implements.

use crate::base::surface_jet::SurfaceJet;
use crate::base::vector::{Point3, Vec3};

/// A smooth (analytic) parametric surface patch over `[0, 1]²`. Object-safe; one method is required.
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
