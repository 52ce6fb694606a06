//! The fairest smooth curve through points.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::angle::Angle;
use crate::document::construct::Contour;
use crate::document::construct::fair_spline;
use crate::document::coordinates::PointSource;
use crate::document::objects::Builder;
use crate::document::objects::idle::Idle;
use crate::document::objects::idle::in_fair_spline;
use crate::document::objects::refuse::Blame;
use crate::document::objects::refuse::blame_ends;
use crate::document::objects::wavers::WaverData;
use crate::document::objects::wavers::WaverRule;
use crate::document::spec::FairSplineSpec;
use crate::error::Result;
use cyclide::CurveObject;
use cyclide::WaverRemedy;

impl Kind for FairSplineSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.each_contour(&self.points, self.closed, |at| fair_spline(self, at)).map(Shape::Curves)
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }

    fn corner_angle(&self) -> Option<Angle> {
        self.corner_angle
    }

    fn idle_fields(&self, at: &Contour<'_>, made: &CurveObject) -> Vec<Idle> {
        in_fair_spline(self, at, made)
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule { rounds_corners: true, ..WaverRule::of(WaverData::Nodes, WaverRemedy::Points) })
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        blame_ends(error)
    }
}
