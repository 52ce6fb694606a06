//! What every surface of a face gives: all that meshes, pictures, files, checks and reports of bodies ask for, whatever kind of
//! surface it is.

mod bends;
mod cells;
mod developable_cells;
mod patch;
mod patch_cells;
mod rational;
mod rational_cells;

pub use bends::LineBends;
pub use cells::CellDistances;

use super::EdgeCurve;
use crate::base::bounds::Aabb;
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;
use crate::rational::RationalBezierSurface;
use crate::surface::ParamSurface;

/// A surface on which a face may lie: four sides, of which one may be a point, over `[0, 1]²`. Object-safe; what has a default is
/// right for a surface whose parameter lines shrink to points at sides only.
///
/// A new kind of surface implements this and becomes a variant of [`FaceSurface`](crate::topology::FaceSurface), which hands on everything.
///
/// ```
/// use cyclide::{Point3, Vec3, surface::CyclidePatch, topology::{FaceGeometry, FaceSurface}};
/// // An eighth of the unit sphere, as a patch, as a rational surface and as the surface of a face.
/// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z)?;
/// let (rational, face) = (patch.to_rational(), FaceSurface::from(patch));
/// for surface in [&patch as &dyn FaceGeometry, &rational, &face] {
///     let proved = surface.cell_distance([0.0, 0.2], [0.0, 0.2]);
///     // The sagitta of 18 degrees of a great circle is 0.0123; of two of them the mesh is off by twice that at most.
///     assert!(proved > 0.012 && proved < 0.04, "{proved}");
///     assert_eq!(surface.corners()[0], corners[0]);
/// }
/// # Ok::<(), cyclide::Error>(())
/// ```
pub trait FaceGeometry: ParamSurface {
    /// The corners at (0,0), (1,0), (0,1), (1,1).
    fn corners(&self) -> [Point3; 4];

    /// The s-line at `t`, from 0 to 1, with the same parameter s.
    ///
    /// # Errors
    /// As [`CyclidePatch::s_line`](crate::surface::CyclidePatch::s_line).
    fn s_line(&self, t: f64) -> Result<EdgeCurve>;

    /// The t-line at `s`, from 0 to 1, with the same parameter t.
    ///
    /// # Errors
    /// As [`CyclidePatch::t_line`](crate::surface::CyclidePatch::t_line).
    fn t_line(&self, s: f64) -> Result<EdgeCurve>;

    /// A box around the surface: the smallest one to rounding of a patch, to 1e-9 of its size of a rational surface.
    fn bounds(&self) -> Aabb;

    /// The box around the surface and a known one, as near: what is inside that need not be found.
    fn bounds_with(&self, known: Aabb) -> Aabb {
        known.union(self.bounds())
    }

    /// The exact rational form.
    fn to_rational(&self) -> RationalBezierSurface;

    /// Unit normal, continuous over the surface, also at sides that are one point. Of patches it is the opposite of
    /// `f_s × f_t` where these are [flipped](crate::surface::CyclidePatch::is_flipped).
    fn unit_normal(&self, s: f64, t: f64) -> Vec3;

    /// How far the cells between cuts of s and of t are from the flat polygons over their corners, proved. Of a surface with
    /// [flat cells](Self::has_flat_cells) these are quads, of others two triangles, whichever diagonal they share. `tolerance`
    /// is what more cuts are to reach.
    ///
    /// The cuts ascend in `[0, 1]`; of others nothing is known, and the distance is infinite. Lines that are
    /// [one point](Self::singular_s) are cuts: over a cell that such a line crosses the polygon is crossed too, and is not the one
    /// that is meant here.
    fn cell_distances(&self, s: &[f64], t: &[f64], tolerance: f64) -> CellDistances;

    /// A proved bound of the distance between the part over `[s0, s1] × [t0, t1]` and the polygons over its corners, both ways;
    /// infinite where nothing is proved.
    fn cell_distance(&self, s: [f64; 2], t: [f64; 2]) -> f64 {
        let is_crossed = |[low, high]: [f64; 2], points: Vec<f64>| points.into_iter().any(|at| low < at && at < high);
        if is_crossed(s, self.singular_s()) || is_crossed(t, self.singular_t()) {
            return f64::INFINITY;
        }
        self.cell_distances(&s, &t, f64::INFINITY).distance
    }

    /// How its parameter lines bend at the places of a grid, s fastest: what cuts are planned by. Nothing is proved by samples.
    fn line_bends(&self, places: &[f64]) -> LineBends {
        LineBends::of_places(places, |s, t| self.jet(s, t))
    }

    /// Normal curvatures of the s-line and of the t-line against the [unit normal](Self::unit_normal), in 1/length: the principal
    /// ones where the lines are lines of curvature. Infinite or NaN where they do not exist.
    fn line_curvatures(&self, s: f64, t: f64) -> [f64; 2] {
        self.jet(s, t).normal_curvatures().unwrap_or([f64::NAN; 2])
    }

    /// True if the corners of every cell between parameter lines lie in a plane.
    fn has_flat_cells(&self) -> bool {
        false
    }

    /// True for a part of a plane whose parameter lines are straight: they say nothing about its shape.
    fn is_plane_quad(&self) -> bool {
        false
    }

    /// The places of s, inside, at which the t-line is one point, ascending.
    fn singular_s(&self) -> Vec<f64> {
        Vec::new()
    }

    /// The places of t, inside, at which the s-line is one point, ascending.
    fn singular_t(&self) -> Vec<f64> {
        Vec::new()
    }

    /// True if no parameter line inside is one point.
    fn is_regular(&self) -> bool {
        self.singular_s().is_empty() && self.singular_t().is_empty()
    }

    /// The side of the [unit normal](Self::unit_normal) on which `f_s × f_t` is: 1, or -1 where it is against it. It changes at
    /// singular lines only.
    fn side_of_normal(&self, _s: f64, _t: f64) -> f64 {
        1.0
    }
}
