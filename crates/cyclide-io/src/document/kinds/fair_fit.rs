//! The fairest smooth curve near points.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::angle::Angle;
use crate::document::construct::Contour;
use crate::document::construct::fair_fit;
use crate::document::coordinates::PointSource;
use crate::document::objects::Builder;
use crate::document::objects::idle::Idle;
use crate::document::objects::idle::in_fair_fit;
use crate::document::objects::wavers::WaverData;
use crate::document::objects::wavers::WaverRule;
use crate::document::spec::FairFitSpec;
use crate::error::Result;
use cyclide::CurveObject;
use cyclide::WaverRemedy;

impl Kind for FairFitSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let auto = self.tolerance.within().is_none();
        let heights_auto = self.tolerance_z.is_some_and(|z| z.within().is_none());
        if self.noise.is_some() && !auto {
            return Err(
                at.unfit("`noise` goes with `\"tolerance\": \"auto\"`: with a number as tolerance that decides")
            );
        }
        if self.tolerance_z.is_some() && heights_auto != auto {
            return Err(at.unfit("`tolerance` and `tolerance_z` are two numbers, or both `\"auto\"`"));
        }
        at.each_contour(&self.points, self.closed, |at| fair_fit(self, at)).map(Shape::Curves)
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }

    fn corner_angle(&self) -> Option<Angle> {
        self.corner_angle
    }

    fn idle_fields(&self, at: &Contour<'_>, _: &CurveObject) -> Vec<Idle> {
        in_fair_fit(self, at)
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule::of(WaverData::Fitted, WaverRemedy::Tolerance))
    }

    fn tolerance(&self) -> Option<f64> {
        self.tolerance.within()
    }
}
