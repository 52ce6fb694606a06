//! Objects from objects, whatever their kind: images under maps, parallel surfaces, solids between them.

use super::object::CurveObject;
use super::surface_object::SurfaceObject;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::Result;

impl Conformal for CurveObject {
    /// The image: of arcs and chains of arcs under any map, of circles and circle splines under similarities and
    /// reflections.
    ///
    /// # Errors
    /// As the curve's own `transformed` or `similar`; `not-a-similarity`.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        match self {
            Self::Arc(c) => c.transformed(map).map(Self::Arc),
            Self::Circle(c) => c.similar(map).map(Self::Circle),
            Self::ArcPath(c) => c.transformed(map).map(Self::ArcPath),
            Self::CircleSpline(c) => c.similar(map).map(Self::CircleSpline),
        }
    }
}

impl Conformal for SurfaceObject {
    /// The image under any map that keeps the surface finite.
    ///
    /// # Errors
    /// As the surface's own `transformed`.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        match self {
            Self::Patch(patch) => patch.transformed(map).map(Self::Patch),
        }
    }
}

impl SurfaceObject {
    /// The parallel surface at a signed distance along the unit normal, exact.
    ///
    /// # Errors
    /// As the surface's own `offset`.
    pub fn offset(&self, distance: f64) -> Result<Self> {
        match self {
            Self::Patch(patch) => patch.offset(distance).map(Self::Patch),
        }
    }
}
