//! Arcs between two curves.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::rails;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::spec::CircularSurfaceSpec;
use crate::error::Result;
use cyclide::ShortNumber;

impl Kind for CircularSurfaceSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.circular_surface(self).map(Shape::Surfaces)
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
            E::ZeroTangent { index } if self.tangent.0.len() > 1 => Blame::Entry("tangent", *index),
            E::ZeroTangent { .. }
            | E::OppositeTangents { .. }
            | E::TangentOpposesChord { .. }
            | E::CountDiffers { .. } => Blame::Field("tangent"),
            _ => Blame::Field("rails"),
        })
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        let cyclide::Error::CoincidentPoints { distance, limit, .. } = error else { return None };
        Some(format!(
            "the curves meet, or are {} apart in one place, and an arc joins points that are more than {} apart",
            ShortNumber(*distance),
            ShortNumber(*limit)
        ))
    }
}
