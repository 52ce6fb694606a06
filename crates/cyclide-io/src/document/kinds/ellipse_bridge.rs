//! Half circles between two ellipses.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::spec::EllipseBridgeSpec;
use crate::error::Result;
use cyclide::ShortNumber;

impl Kind for EllipseBridgeSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.ellipse_bridge(self).map(Shape::Surfaces)
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        use cyclide::{Error as E, ErrorItem as I};
        Some(match error {
            E::ParameterOutOfRange { name: name @ (I::Height | I::Thickness | I::Wall | I::Depth), .. } => {
                Blame::Field(name.word())
            }
            _ => Blame::Field("ellipses"),
        })
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        let cyclide::Error::CoincidentPoints { distance, limit, .. } = error else { return None };
        Some(format!(
            "the ellipses touch: their semi-axes of one direction differ by {}, more than {} is needed",
            ShortNumber(*distance),
            ShortNumber(*limit)
        ))
    }
}
