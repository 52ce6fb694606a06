//! A pipe on a plate with a rounded neck.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::spec::PlateWithNeckSpec;
use crate::error::Result;

impl Kind for PlateWithNeckSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.plate_with_neck(self).map(Shape::Surfaces)
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        use cyclide::{Error as E, ErrorItem as I};
        Some(match error {
            E::ParameterOutOfRange { name: name @ (I::Height | I::Thickness | I::Wall | I::Depth), .. } => {
                Blame::Field(name.word())
            }
            E::RadiusNotPositive { .. } if self.pipe_radius <= 0.0 => Blame::Field("pipe_radius"),
            E::RadiusNotPositive { .. } | E::BallDoesNotFit { .. } | E::NeckFolds { .. } => Blame::Field("ball_radius"),
            E::AngleOutOfRange { .. } => Blame::Field("slope"),
            E::PlateTooSmall { .. } => Blame::Field("plate"),
            _ => Blame::Object,
        })
    }
}
