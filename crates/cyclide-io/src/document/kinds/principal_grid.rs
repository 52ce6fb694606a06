//! Regular grids along the lines of curvature of a mesh.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::BuiltObject;
use crate::document::spec::PrincipalGridSpec;
use crate::error::Result;

impl Kind for PrincipalGridSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.principal_grid(self).map(Shape::plain)
    }

    fn files(&self) -> Vec<&str> {
        self.file().into_iter().collect()
    }

    fn has_panels(&self, _: Option<&BuiltObject>) -> bool {
        true
    }
}
