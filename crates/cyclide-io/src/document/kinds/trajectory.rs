//! The path of a point of a moving body.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::objects::Builder;
use crate::document::spec::TrajectorySpec;
use crate::error::Result;

impl Kind for TrajectorySpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let path = at.trajectory(self)?;
        at.warn_of_cusps("of", None, path.as_curve());
        Ok(path.into())
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }
}
