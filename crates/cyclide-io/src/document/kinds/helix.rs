//! A helix.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::spec::HelixSpec;
use crate::error::Result;

impl Kind for HelixSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        Ok(at.helix(self)?.into())
    }
}
