//! A rational curve of lowest degree through points.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::coordinates::PointSource;
use crate::document::interpolate::qb_interpolation;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::objects::wavers::WaverData;
use crate::document::objects::wavers::WaverRule;
use crate::document::spec::QbInterpolationSpec;
use crate::error::Result;
use cyclide::WaverRemedy;

impl Kind for QbInterpolationSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let made = at.each_contour(&self.points, false, |at| qb_interpolation(self, at))?;
        at.warn_of_cusps_in("points", &made);
        Ok(Shape::Curves(made))
    }

    fn points(&self) -> Option<&PointSource> {
        Some(&self.points)
    }

    fn keeps_repeated_points(&self) -> bool {
        true
    }

    fn keeps_corners(&self) -> bool {
        false
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule::of(WaverData::Points, WaverRemedy::FairSpline))
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        use cyclide::{Error as E, ErrorItem as I};
        match error {
            E::CountDiffers { what: I::Parameter, .. } => None,
            E::CountDiffers { .. } | E::NotFinite { what: I::Tangent, .. } => Some(Blame::Field("derivatives")),
            E::ParameterOutOfRange { name: I::Parameter, .. } => Some(Blame::Field("parameters")),
            _ => None,
        }
    }
}
