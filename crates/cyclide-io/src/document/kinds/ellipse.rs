//! An ellipse or an arc of one.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::spec::EllipseSpec;
use crate::error::Result;

impl Kind for EllipseSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        Ok(at.ellipse(self)?.into())
    }
}
