//! The fewest arcs near points, tangent-continuous.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::angle::Angle;
use crate::document::coordinates::PointSource;
use crate::document::objects::Builder;
use crate::document::objects::wavers::WaverData;
use crate::document::objects::wavers::WaverRule;
use crate::document::spec::ArcFitSpec;
use crate::error::Result;
use cyclide::WaverRemedy;

impl Kind for ArcFitSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.arc_fit(self).map(Shape::Curves)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.of.as_deref().map(of).unwrap_or_default()
    }

    fn points(&self) -> Option<&PointSource> {
        self.points.as_ref()
    }

    fn corner_angle(&self) -> Option<Angle> {
        self.corner_angle
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule::of(WaverData::Fitted, WaverRemedy::Tolerance))
    }

    fn tolerance(&self) -> Option<f64> {
        Some(self.tolerance)
    }
}
