//! The surfaces that faces lie on, and what every one of them gives.

use super::{CellDistances, EdgeCurve, FaceGeometry, LineBends};
use crate::base::bounds::Aabb;
use crate::base::surface_jet::SurfaceJet;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::error::Result;
use crate::rational::RationalBezierSurface;
use crate::surface::{CyclidePatch, ParamSurface};

/// The surface of a face, over `[0, 1]²`: any of the surfaces that have [`FaceGeometry`]. Match on it only where the kind itself
/// matters, as in files that know spheres and tori.
///
/// ```
/// use cyclide::{Point3, Vec3, surface::CyclidePatch, topology::{FaceGeometry as _, FaceSurface}};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
/// let face = FaceSurface::from(CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y)?);
/// assert!(face.is_regular() && face.to_rational().degrees() == [2, 2]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[allow(clippy::large_enum_variant, reason = "shells hold their faces in one list, most of them patches")]
#[derive(Debug, Clone, PartialEq)]
pub enum FaceSurface {
    /// A principal patch of a Dupin cyclide: every parameter line is a circle.
    Cyclide(CyclidePatch),
    /// A rational Bézier surface of any degrees with positive weights.
    Rational(RationalBezierSurface),
}

impl FaceSurface {
    /// The patch, if it is one.
    #[must_use]
    pub fn patch(&self) -> Option<&CyclidePatch> {
        match self {
            Self::Cyclide(patch) => Some(patch),
            Self::Rational(_) => None,
        }
    }

    /// What is asked of every surface of a face.
    fn geometry(&self) -> &dyn FaceGeometry {
        match self {
            Self::Cyclide(patch) => patch,
            Self::Rational(surface) => surface,
        }
    }

    /// The part over `[s0, s1] × [t0, t1]` with corners that are known better than by evaluation.
    pub(super) fn part_between(&self, s: [f64; 2], t: [f64; 2], corners: [Point3; 4]) -> Self {
        match self {
            Self::Cyclide(patch) => Self::Cyclide(patch.part_between(s, t, corners)),
            Self::Rational(surface) => Self::Rational(surface.part(s, t).with_corners(corners)),
        }
    }

    /// The image. Rational surfaces have images under similarities and reflections only.
    ///
    /// # Errors
    /// As `transformed` of patches; `not-a-similarity`, `not-finite`.
    pub(super) fn image(&self, map: &Mobius) -> Result<Self> {
        Ok(match self {
            Self::Cyclide(patch) => Self::Cyclide(patch.image(map)?),
            Self::Rational(surface) => Self::Rational(surface.similar(map)?),
        })
    }
}

impl From<CyclidePatch> for FaceSurface {
    fn from(patch: CyclidePatch) -> Self {
        Self::Cyclide(patch)
    }
}

impl From<RationalBezierSurface> for FaceSurface {
    fn from(surface: RationalBezierSurface) -> Self {
        Self::Rational(surface)
    }
}

impl ParamSurface for FaceSurface {
    fn jet(&self, s: f64, t: f64) -> SurfaceJet {
        match self {
            Self::Cyclide(patch) => patch.jet(s, t),
            Self::Rational(surface) => surface.jet(s, t),
        }
    }
    fn point(&self, s: f64, t: f64) -> Point3 {
        match self {
            Self::Cyclide(patch) => patch.point(s, t),
            Self::Rational(surface) => surface.point(s, t),
        }
    }
    fn normal(&self, s: f64, t: f64) -> Option<Vec3> {
        match self {
            Self::Cyclide(patch) => patch.normal(s, t),
            Self::Rational(surface) => surface.normal(s, t),
        }
    }
}

/// All of it is the surface's own, what has a default too.
impl FaceGeometry for FaceSurface {
    fn corners(&self) -> [Point3; 4] {
        self.geometry().corners()
    }
    fn s_line(&self, t: f64) -> Result<EdgeCurve> {
        self.geometry().s_line(t)
    }
    fn t_line(&self, s: f64) -> Result<EdgeCurve> {
        self.geometry().t_line(s)
    }
    fn bounds(&self) -> Aabb {
        self.geometry().bounds()
    }
    fn bounds_with(&self, known: Aabb) -> Aabb {
        self.geometry().bounds_with(known)
    }
    fn to_rational(&self) -> RationalBezierSurface {
        self.geometry().to_rational()
    }
    fn unit_normal(&self, s: f64, t: f64) -> Vec3 {
        self.geometry().unit_normal(s, t)
    }
    fn cell_distances(&self, s: &[f64], t: &[f64], tolerance: f64) -> CellDistances {
        self.geometry().cell_distances(s, t, tolerance)
    }
    fn cell_distance(&self, s: [f64; 2], t: [f64; 2]) -> f64 {
        self.geometry().cell_distance(s, t)
    }
    fn line_bends(&self, places: &[f64]) -> LineBends {
        self.geometry().line_bends(places)
    }
    fn line_curvatures(&self, s: f64, t: f64) -> [f64; 2] {
        self.geometry().line_curvatures(s, t)
    }
    fn has_flat_cells(&self) -> bool {
        self.geometry().has_flat_cells()
    }
    fn is_plane_quad(&self) -> bool {
        self.geometry().is_plane_quad()
    }
    fn singular_s(&self) -> Vec<f64> {
        self.geometry().singular_s()
    }
    fn singular_t(&self) -> Vec<f64> {
        self.geometry().singular_t()
    }
    fn is_regular(&self) -> bool {
        self.geometry().is_regular()
    }
    fn side_of_normal(&self, s: f64, t: f64) -> f64 {
        self.geometry().side_of_normal(s, t)
    }
}
