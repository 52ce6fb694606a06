//! The ways of the centres of the balls of blends.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::objects::Builder;
use crate::document::spec::BallCentersSpec;
use crate::error::Result;

impl Kind for BallCentersSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.ball_centers().map(Shape::plain)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }
}
