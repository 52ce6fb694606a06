//! A main pipe with branches, blended by rolling balls.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::objects::refuse::blame_tee;
use crate::document::spec::PipeTeeSpec;
use crate::error::Result;

impl Kind for PipeTeeSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.pipe_tee(self).map(Shape::Surfaces)
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        Some(blame_tee(error))
    }
}
