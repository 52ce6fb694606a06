//! Blocks in a grid.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::objects::block_checks::blocks_of_grid;
use crate::document::spec::CyclideGridSpec;
use crate::error::Result;

impl Kind for CyclideGridSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.check_block_count(blocks_of_grid(self), if self.whole.is_some() { "whole" } else { "planes" })?;
        let volumes = at.cyclide_grid(self)?;
        at.divided(volumes, self.cells.as_ref(), "type")
    }
}
