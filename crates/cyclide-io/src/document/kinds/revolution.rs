//! What a curve sweeps when it turns about an axis.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::spec::RevolutionSpec;
use crate::error::Result;

impl Kind for RevolutionSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.revolution(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        match error {
            cyclide::Error::ZeroAxis { .. } => Some(Blame::Field("axis")),
            cyclide::Error::AngleOutOfRange { .. } => Some(Blame::Field("angle")),
            _ => None,
        }
    }

    fn blame_otherwise(&self) -> Option<Blame> {
        Some(Blame::Field("of"))
    }
}
