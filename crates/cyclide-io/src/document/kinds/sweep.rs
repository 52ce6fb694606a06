//! A plane section along a path.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::spec::SweepSpec;
use crate::error::Result;

impl Kind for SweepSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.sweep(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        vec![(vec![Step::from("of")], &self.of), (vec![Step::from("section")], &self.section)]
    }
}
