//! Arcs through points, tangent-continuous.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::construct::Contour;
use crate::document::construct::arc_spline;
use crate::document::coordinates::PointSource;
use crate::document::objects::Builder;
use crate::document::objects::idle::Idle;
use crate::document::objects::idle::in_arc_spline;
use crate::document::objects::wavers::WaverData;
use crate::document::objects::wavers::WaverRule;
use crate::document::spec::ArcSplineSpec;
use crate::error::Result;
use cyclide::CurveObject;
use cyclide::WaverRemedy;

impl Kind for ArcSplineSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.each_contour(&self.points, self.closed, |at| arc_spline(self, at)).map(Shape::Curves)
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }

    fn keeps_corners(&self) -> bool {
        false
    }

    fn idle_fields(&self, at: &Contour<'_>, made: &CurveObject) -> Vec<Idle> {
        in_arc_spline(self, at, made)
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule::of(WaverData::Points, WaverRemedy::FairSpline))
    }
}
