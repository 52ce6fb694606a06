//! A convex polyhedron with its edges and corners rounded.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::coordinates::PointSource;
use crate::document::objects::Builder;
use crate::document::spec::SmoothPolyhedronSpec;
use crate::error::Result;

impl Kind for SmoothPolyhedronSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.smooth_polyhedron(self).map(Shape::Surfaces)
    }

    fn points(&self) -> Option<&PointSource> {
        self.points.as_ref()
    }

    fn files(&self) -> Vec<&str> {
        match (&self.points, &self.mesh) {
            (Some(PointSource::File(file)), _) => vec![file.csv.as_str()],
            (_, Some(file)) => vec![file.path.as_str()],
            _ => Vec::new(),
        }
    }
}
