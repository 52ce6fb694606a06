//! A block whose coordinate surfaces are cyclides that cross at right angles.

use super::kind::Kind;
use super::kind::Shape;
use crate::document::objects::Builder;
use crate::document::spec::CyclideVolumeSpec;
use crate::error::Result;

impl Kind for CyclideVolumeSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        let volumes = vec![at.block(self)?];
        at.divided(volumes, self.cells.as_ref(), "frame")
    }
}
