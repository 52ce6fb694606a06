//! Two pipes that pass each other, blended by a rolling ball.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::objects::refuse::blame_crossing;
use crate::document::spec::PipeCrossingSpec;
use crate::error::Result;

impl Kind for PipeCrossingSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.pipe_crossing(self).map(Shape::Surfaces)
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        Some(blame_crossing(self, error))
    }
}
