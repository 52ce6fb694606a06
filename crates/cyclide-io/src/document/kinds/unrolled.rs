//! A curve of a torus laid flat.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::objects::torus::TorusFields;
use crate::document::objects::torus::blame_on_torus;
use crate::document::spec::UnrolledSpec;
use crate::error::Result;

impl Kind for UnrolledSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.unrolled(self).map(Shape::plain)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        Some(blame_on_torus(&TorusFields { angles: "seam", turns: "tolerance", ..TorusFields::SPLINE }, error))
    }
}
