//! An object mapped.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::objects::Builder;
use crate::document::objects::BuiltObject;
use crate::document::spec::TransformSpec;
use crate::error::Result;
use cyclide::Body;
use cyclide::SurfaceObject;

impl Kind for TransformSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.image(self)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn is_image(&self) -> bool {
        true
    }

    fn skin(&self, source: Option<&BuiltObject>) -> Vec<SurfaceObject> {
        source.map_or_else(Vec::new, |source| source.provenance.skin.clone())
    }

    fn has_panels(&self, source: Option<&BuiltObject>) -> bool {
        source.is_some_and(|source| source.provenance.panels)
    }

    fn remark_on(&self, at: &mut Builder<'_>, _: &Shape, _: &[Body]) {
        at.warn_of_many_turns(self);
    }
}
