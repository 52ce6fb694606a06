//! Segments through points, corners rounded by arcs.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::construct::polyline;
use crate::document::coordinates::PointSource;
use crate::document::objects::Builder;
use crate::document::spec::PolylineSpec;
use crate::error::Result;

impl Kind for PolylineSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.each_contour(&self.points, self.closed, |at| polyline(self, at)).map(Shape::Curves)
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }
}
