//! The tube about a curve of arcs and segments.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::spec::PipeSpec;
use crate::error::Result;

impl Kind for PipeSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.pipe(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn blame_otherwise(&self) -> Option<Blame> {
        Some(Blame::Field("of"))
    }
}
