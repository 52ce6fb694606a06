//! The outer side of a face: that of `f_s × f_t`, or the other one.

use super::ShellFace;
use crate::base::vector::Vec3;
use crate::surface::ParamSurface as _;

impl ShellFace {
    /// What turns `f_s × f_t` to the outer side of the shell: 1, or -1.
    #[must_use]
    pub const fn outer_sign(&self) -> f64 {
        if self.same_sense { 1.0 } else { -1.0 }
    }

    /// Unit normal on the outer side of the shell; `None` where the surface has none.
    ///
    /// ```
    /// use cyclide::{surface::{DupinCyclide, ParamSurface}, topology::Body};
    /// let shell = DupinCyclide::new(3.0, 0.0, 1.0)?.to_shell()?;
    /// let face = &shell.faces()[0];
    /// // A point of a torus and the one at distance 0.1 outside.
    /// let (p, n) = (face.surface.point(0.3, 0.6), face.outer_normal(0.3, 0.6).unwrap_or_default());
    /// let from_circle = |p: cyclide::Point3| (p.x.hypot(p.y) - 3.0).hypot(p.z);
    /// assert!((from_circle(p + n * 0.1) - 1.1).abs() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn outer_normal(&self, s: f64, t: f64) -> Option<Vec3> {
        self.surface.normal(s, t).map(|normal| normal * self.outer_sign())
    }

    /// What turns the [unit normal](crate::topology::FaceGeometry::unit_normal) of the surface, which is continuous over all of it, and with it the signs of
    /// curvatures, to the outer side of the shell: 1, or -1. Beyond a singular line of the surface it is the inner side.
    #[must_use]
    pub fn outer_sign_of_unit_normal(&self) -> f64 {
        let flipped = self.surface.patch().is_some_and(crate::surface::CyclidePatch::is_flipped);
        if flipped == self.same_sense { -1.0 } else { 1.0 }
    }
}
