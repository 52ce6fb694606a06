//! A local smooth curve through points that Möbius maps keep.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::angle::Angle;
use crate::document::construct::Contour;
use crate::document::coordinates::PointSource;
use crate::document::interpolate::moebius_spline;
use crate::document::objects::Builder;
use crate::document::objects::idle::Idle;
use crate::document::objects::idle::in_moebius_spline;
use crate::document::objects::refuse::Blame;
use crate::document::objects::wavers::WaverData;
use crate::document::objects::wavers::WaverRule;
use crate::document::spec::MoebiusSplineSpec;
use crate::error::Result;
use cyclide::CurveObject;
use cyclide::WaverRemedy;

impl Kind for MoebiusSplineSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.each_contour(&self.points, self.closed, |at| moebius_spline(self, at)).map(Shape::Curves)
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }

    fn corner_angle(&self) -> Option<Angle> {
        self.corner_angle
    }

    fn idle_fields(&self, at: &Contour<'_>, _: &CurveObject) -> Vec<Idle> {
        in_moebius_spline(self, at)
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule::of(WaverData::Nodes, WaverRemedy::FairSpline))
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        use cyclide::{Error as E, ErrorItem as I};
        match *error {
            E::ParametersNotIncreasing { index, .. } | E::NotFinite { what: I::Knot, index } => {
                Some(Blame::Entry("knots", index))
            }
            E::CountDiffers { what: I::Knot | I::Parameter, .. } => Some(Blame::Field("knots")),
            _ => None,
        }
    }
}
