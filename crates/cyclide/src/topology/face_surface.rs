//! The surfaces that faces lie on, and what every one of them gives.

use super::EdgeCurve;
use crate::base::bounds::Aabb;
use crate::base::surface_jet::SurfaceJet;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::mobius::Mobius;
use crate::error::Result;
use crate::rational::RationalBezierSurface;
use crate::surface::{CyclidePatch, ParamSurface};

/// The surface of a face, over `[0, 1]²`.
///
/// ```
/// use cyclide::{CyclidePatch, FaceSurface, Point3, Vec3};
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

    /// The corners at (0,0), (1,0), (0,1), (1,1).
    #[must_use]
    pub fn corners(&self) -> [Point3; 4] {
        match self {
            Self::Cyclide(patch) => patch.corners(),
            Self::Rational(surface) => surface.corners(),
        }
    }

    /// The s-line at `t`, with the same parameter s.
    ///
    /// # Errors
    /// As [`CyclidePatch::s_line`].
    pub fn s_line(&self, t: f64) -> Result<EdgeCurve> {
        Ok(match self {
            Self::Cyclide(patch) => patch.s_line(t)?.into(),
            Self::Rational(surface) => surface.s_line(t).into(),
        })
    }

    /// The t-line at `s`, with the same parameter t.
    ///
    /// # Errors
    /// As [`CyclidePatch::t_line`].
    pub fn t_line(&self, s: f64) -> Result<EdgeCurve> {
        Ok(match self {
            Self::Cyclide(patch) => patch.t_line(s)?.into(),
            Self::Rational(surface) => surface.t_line(s).into(),
        })
    }

    /// A box around the surface: the smallest one to rounding of a patch, to 1e-9 of its size of a rational surface.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        match self {
            Self::Cyclide(patch) => patch.bounds(),
            Self::Rational(surface) => surface.bounds(),
        }
    }

    /// The exact rational form.
    #[must_use]
    pub fn to_rational(&self) -> RationalBezierSurface {
        match self {
            Self::Cyclide(patch) => patch.to_rational(),
            Self::Rational(surface) => surface.clone(),
        }
    }

    /// The places of s, inside, at which the t-line is one point; of rational surfaces such lines are sides only.
    #[must_use]
    pub fn singular_s(&self) -> Vec<f64> {
        self.patch().map_or_else(Vec::new, CyclidePatch::singular_s)
    }

    /// The places of t, inside, at which the s-line is one point.
    #[must_use]
    pub fn singular_t(&self) -> Vec<f64> {
        self.patch().map_or_else(Vec::new, CyclidePatch::singular_t)
    }

    /// True if no parameter line inside is one point.
    #[must_use]
    pub fn is_regular(&self) -> bool {
        self.patch().is_none_or(CyclidePatch::is_regular)
    }

    /// Unit normal, continuous over the surface, also at sides that are one point. Of patches it is the opposite of
    /// `f_s × f_t` where these are [flipped](CyclidePatch::is_flipped).
    #[must_use]
    pub fn unit_normal(&self, s: f64, t: f64) -> Vec3 {
        match self {
            Self::Cyclide(patch) => patch.unit_normal(s, t),
            Self::Rational(surface) => surface.unit_normal(s, t),
        }
    }

    /// The side of the [unit normal](Self::unit_normal) on which `f_s × f_t` is: 1, or -1 where it is against it, as on patches
    /// that are [flipped](CyclidePatch::is_flipped).
    #[must_use]
    pub fn side_of_normal(&self, s: f64, t: f64) -> f64 {
        self.patch().map_or(1.0, |patch| patch.side_of_normal(s, t))
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
