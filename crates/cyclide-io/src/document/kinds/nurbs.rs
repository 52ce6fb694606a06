//! A rational B-spline curve.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::nurbs::blame_nurbs;
use crate::document::objects::nurbs::knots_words;
use crate::document::objects::refuse::Blame;
use crate::document::objects::wavers::WaverData;
use crate::document::objects::wavers::WaverRule;
use crate::document::spec::NurbsSpec;
use crate::error::Result;
use cyclide::WaverRemedy;

impl Kind for NurbsSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let curve = at.nurbs(self)?;
        at.warn_of_wavers("control_points", &curve);
        at.warn_of_cusps("control_points", None, curve.as_curve());
        Ok(curve.into())
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule::of(WaverData::ControlPoints, WaverRemedy::Source))
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        Some(blame_nurbs(error))
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        knots_words(error)
    }
}
