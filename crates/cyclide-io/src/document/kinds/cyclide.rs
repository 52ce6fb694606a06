//! A whole Dupin cyclide.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::spec::CyclideSpec;
use crate::error::Result;

impl Kind for CyclideSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.cyclide(self).map(Shape::Surfaces)
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        matches!(error, cyclide::Error::ZeroAxis { .. }).then_some(Blame::Field("axis"))
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        // What is the normal of a frame to the kernel.
        matches!(error, cyclide::Error::ZeroAxis { .. }).then(|| "the axis is zero".to_owned())
    }
}
