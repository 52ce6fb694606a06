//! The tube of changing radius along a curve, or through balls.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::objects::refuse::blame_tube;
use crate::document::spec::TubeSpec;
use crate::error::Result;

impl Kind for TubeSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.tube(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.of.as_deref().map(of).unwrap_or_default()
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        Some(blame_tube(self, error))
    }
}
