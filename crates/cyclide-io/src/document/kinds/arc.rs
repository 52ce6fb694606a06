//! A circular arc or straight segment.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::spec::ArcSpec;
use crate::error::Result;
use cyclide::CurveObject;

impl Kind for ArcSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        Ok(CurveObject::Arc(at.arc(self)?).into())
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        use cyclide::{Error as E, ErrorItem as I};
        match error {
            E::NotFinite { what: I::Tangent, .. } | E::ZeroTangent { .. } | E::TangentOpposesChord { .. } => {
                Some(Blame::Field(if self.tangent.is_some() { "tangent" } else { "end_tangent" }))
            }
            E::NotInImH { .. } | E::PoleOnSegment { .. } if self.bulge.is_some() => Some(Blame::Field("bulge")),
            _ => None,
        }
    }
}
