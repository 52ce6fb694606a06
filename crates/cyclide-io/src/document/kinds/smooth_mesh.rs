//! A smooth surface through the vertices of a triangle mesh.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::spec::SmoothMeshSpec;
use crate::error::Result;

impl Kind for SmoothMeshSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.smooth_mesh(self).map(Shape::Surfaces)
    }

    fn files(&self) -> Vec<&str> {
        self.mesh.iter().map(|file| file.path.as_str()).collect()
    }
}
