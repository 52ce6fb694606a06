//! The edges of a surface as arcs.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::objects::Builder;
use crate::document::spec::SupportStructureSpec;
use crate::error::Result;

impl Kind for SupportStructureSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.support_structure().map(Shape::plain)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }
}
