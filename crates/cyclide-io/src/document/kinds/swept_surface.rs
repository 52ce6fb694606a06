//! What a curve of a moving body runs over.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::spec::SweptSurfaceSpec;
use crate::error::Result;

impl Kind for SweptSurfaceSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.swept_surface(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        vec![(vec![Step::from("of")], &self.of), (vec![Step::from("profile")], &self.profile)]
    }
}
