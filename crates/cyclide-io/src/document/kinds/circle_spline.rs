//! A smooth curve through points, blended from circles.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::angle::Angle;
use crate::document::construct::Contour;
use crate::document::construct::circle_spline;
use crate::document::coordinates::PointSource;
use crate::document::objects::Builder;
use crate::document::objects::idle::Idle;
use crate::document::objects::idle::in_circle_spline;
use crate::document::objects::refuse::Blame;
use crate::document::objects::refuse::blame_ends;
use crate::document::objects::wavers::WaverData;
use crate::document::objects::wavers::WaverRule;
use crate::document::spec::CircleSplineSpec;
use crate::error::Result;
use cyclide::CurveObject;
use cyclide::WaverRemedy;

impl Kind for CircleSplineSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.each_contour(&self.points, self.closed, |at| circle_spline(self, at)).map(Shape::Curves)
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }

    fn corner_angle(&self) -> Option<Angle> {
        self.corner_angle
    }

    fn idle_fields(&self, at: &Contour<'_>, _: &CurveObject) -> Vec<Idle> {
        in_circle_spline(self, at)
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule { rounds_corners: true, ..WaverRule::of(WaverData::Nodes, WaverRemedy::FairSpline) })
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        blame_ends(error)
    }
}
