//! Straight lines between two curves.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::rails;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::spec::RuledSpec;
use crate::error::Result;
use cyclide::ShortNumber;

impl Kind for RuledSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.ruled(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        rails(&self.rails)
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        use cyclide::{Error as E, ErrorItem as I};
        Some(match error {
            E::ParameterOutOfRange { name: name @ (I::Height | I::Thickness | I::Wall | I::Depth), .. } => {
                Blame::Field(name.word())
            }
            _ => Blame::Field("rails"),
        })
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        let cyclide::Error::CoincidentPoints { distance, limit, .. } = error else { return None };
        Some(format!(
            "a piece of one curve is that of the other, {} apart at most: there is no surface between what is no more than {} apart",
            ShortNumber(*distance),
            ShortNumber(*limit)
        ))
    }
}
