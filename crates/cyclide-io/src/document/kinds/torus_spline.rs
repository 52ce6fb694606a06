//! A smooth curve on a torus through points.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use crate::document::construct::Contour;
use crate::document::coordinates::PointSource;
use crate::document::objects::Builder;
use crate::document::objects::idle::Idle;
use crate::document::objects::idle::in_torus_spline;
use crate::document::objects::refuse::Blame;
use crate::document::objects::torus::TorusFields;
use crate::document::objects::torus::blame_on_torus;
use crate::document::objects::torus::is_given;
use crate::document::objects::wavers::WaverData;
use crate::document::objects::wavers::WaverRule;
use crate::document::spec::TorusSplineSpec;
use crate::error::Result;
use cyclide::CurveObject;
use cyclide::WaverRemedy;

impl Kind for TorusSplineSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let made = at.torus_spline(self)?;
        at.warn_of_wavers_in("type", &made);
        Ok(Shape::Curves(made))
    }

    fn references(&self) -> Vec<Reference<'_>> {
        self.torus.reference()
    }

    fn points(&self) -> Option<&PointSource> {
        self.points.as_ref()
    }

    fn keeps_repeated_points(&self) -> bool {
        self.loops
    }

    fn keeps_corners(&self) -> bool {
        false
    }

    fn idle_fields(&self, at: &Contour<'_>, _: &CurveObject) -> Vec<Idle> {
        in_torus_spline(self, at)
    }

    fn wavers(&self) -> Option<WaverRule> {
        Some(WaverRule { through: false, ..WaverRule::of(WaverData::Nodes, WaverRemedy::Points) })
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        let directions = if self.rates.is_some() { "rates" } else { "tangents" };
        Some(blame_on_torus(&TorusFields { directions, knots: self.knots.is_some(), ..TorusFields::SPLINE }, error))
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        match error {
            cyclide::Error::ZeroTangent { index } if is_given(self, *index) => {
                Some(format!("tangent {index} is normal to the torus there: nothing of it runs along the torus"))
            }
            // Angles a whole turn apart are one place.
            cyclide::Error::CoincidentPoints { .. }
                if !self.closed && self.winding.is_none() && self.angles.is_some() =>
            {
                Some(format!(
                    "{error}; from a place once round to the same place leads a `winding`, as `[[1, 0]]`, or `closed`"
                ))
            }
            _ => None,
        }
    }
}
