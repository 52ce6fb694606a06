//! A raised or sunk seam along a curve of a torus.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::objects::torus::blame_seam;
use crate::document::spec::TorusSeamSpec;
use crate::error::Result;

impl Kind for TorusSeamSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.torus_seam(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        Some(blame_seam(error))
    }
}
