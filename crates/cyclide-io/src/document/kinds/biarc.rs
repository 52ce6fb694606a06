//! Two arcs between two points with given directions.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::refuse::Blame;
use crate::document::spec::BiarcSpec;
use crate::error::Result;
use cyclide::Biarc;
use cyclide::CurveObject;

impl Kind for BiarcSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let (t0, t1) = (self.from_tangent.vector(), self.to_tangent.vector());
        let biarc = Biarc::new(self.from.point(), t0, self.to.point(), t1, self.rule);
        Ok(CurveObject::ArcPath(biarc.map_err(|e| at.refused(&e, None))?.to_path()).into())
    }

    fn blame(&self, error: &cyclide::Error) -> Option<Blame> {
        use cyclide::{Error as E, ErrorItem as I};
        let (E::NotFinite { what: I::Tangent, index }
        | E::ZeroTangent { index }
        | E::TangentOpposesChord { index, .. }) = *error
        else {
            return None;
        };
        Some(Blame::Field(if index == 0 { "from_tangent" } else { "to_tangent" }))
    }
}
