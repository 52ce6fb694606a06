//! Blocks: how many there may be, their bodies and frames.

use cyclide::{
    error::{NumberError, PatchError},
    topology::Body,
    volume::CyclideVolume,
};

use crate::document::kinds::fields::cells::CellsSpec;
use crate::document::kinds::fields::frame::{FrameSpec, frame_words};
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::Shape;
use crate::error::{Error, Result};

/// Most blocks of one object: with their faces they take ten kilobytes each, a gigabyte together.
const MOST_BLOCKS: usize = 100_000;

impl Builder<'_> {
    /// Refuses objects of more blocks than are made, at the field that says how many.
    pub(in crate::document) fn check_block_count(&self, count: f64, field: &str) -> Result<()> {
        if count <= MOST_BLOCKS as f64 {
            return Ok(());
        }
        let error = cyclide::Error::Number(NumberError::TooManyPieces {
            what: "the grid of blocks",
            segment: None,
            needed: count,
            cap: MOST_BLOCKS,
            remedy: "use fewer and larger blocks, and divide them with `cells`",
        });
        Err(self.refused_at([Step::from(field)], &error))
    }

    /// Blocks with the parameters of their cells. Of many blocks that fold one is enough to know, at a field.
    pub(in crate::document) fn divided(
        &mut self,
        volumes: Vec<CyclideVolume>,
        cells: Option<&CellsSpec>,
        field: &str,
    ) -> Result<Shape> {
        self.warn_of_folded_blocks(&volumes, field);
        let places = self.places(&volumes, cells)?;
        Ok(Shape::Blocks(volumes, places))
    }

    /// Warns of the first of some blocks that fold.
    pub(in crate::document) fn warn_of_folded_blocks(&mut self, volumes: &[CyclideVolume], field: &str) {
        if let Some(warning) = volumes.iter().find_map(|volume| volume.warnings().into_iter().next()) {
            self.warn_at(field, None, warning);
        }
    }

    /// What is wrong with the directions of a frame, if it is these.
    pub(in crate::document) fn refused_frame(&self, frame: FrameSpec, error: &cyclide::Error) -> Option<Error> {
        let (FrameSpec::First(given), cyclide::Error::Patch(PatchError::FrameNotOrthonormal { .. })) = (frame, error)
        else {
            return None;
        };
        Some(self.refused_in_words([Step::from("frame")], error.reason(), frame_words(given)))
    }

    /// The solids of blocks.
    pub(in crate::document) fn block_bodies(&self, volumes: &[CyclideVolume]) -> Result<Vec<Body>> {
        let body = |(index, volume): (usize, &CyclideVolume)| {
            volume.to_body().map_err(|e| {
                let which = if volumes.len() > 1 { format!("block {index}: ") } else { String::new() };
                let words =
                    format!("{which}{e}: the block is flat to rounding, or its corners are nearly on one circle");
                match e.reason() {
                    "not-a-shell" => self.refused_in_words([], e.reason(), words),
                    _ => self.refused(&e, None),
                }
            })
        };
        volumes.iter().enumerate().map(body).collect()
    }
}
