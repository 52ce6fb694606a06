//! A full circle.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::spec::CircleSpec;
use crate::error::Result;
use cyclide::CurveObject;

impl Kind for CircleSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        Ok(CurveObject::Circle(at.circle(self)?).into())
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        matches!(error, cyclide::Error::DegenerateCircle { .. }).then_some(Blame::Field("through"))
    }
}
