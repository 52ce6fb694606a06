//! Blocks in layers over a net.

use super::kind::Kind;
use super::kind::Reference;
use super::kind::Shape;
use super::kind::of;
use crate::document::objects::Builder;
use crate::document::spec::LayersSpec;
use crate::error::Result;

impl Kind for LayersSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let count = at.blocks_of_layers(self)?;
        at.check_block_count(count, if self.count.is_some() { "count" } else { "distances" })?;
        let volumes = at.layers(self)?;
        at.divided(volumes, self.cells.as_ref(), "of")
    }

    fn references(&self) -> Vec<Reference<'_>> {
        of(&self.of)
    }
}
