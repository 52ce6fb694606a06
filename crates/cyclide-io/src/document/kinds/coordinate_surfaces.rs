//! Surfaces inside blocks.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::objects::Builder;
use crate::document::spec::CoordinateSurfacesSpec;
use crate::error::Result;

impl Kind for CoordinateSurfacesSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.check_surfaces_differ(self)?;
        at.coordinate_surfaces(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }
}
