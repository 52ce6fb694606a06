//! Whether the cells of a structured grid can be told apart where they are, and what should be known of them.

use super::super::cyclide_volume::CyclideVolume;
use super::super::fold::FoldVerdict;
use super::super::param_volume::ParamVolume as _;
use super::{GridQuality, StructuredGrid};
use crate::base::range;
use crate::error::{ErrorItem, Result};
use crate::warning::{InvertedCause, VolumeWarning, Warning};

/// Roundings of the largest coordinate that a cell is long at least: its ends are off by a few of them, and its directions by a tenth then.
const SHORTEST: f64 = 64.0 * f64::EPSILON;

impl StructuredGrid {
    /// Refuses parameters along a direction (0, 1, 2 for s, t, u) between which sides of blocks are so short that the rounding of their place is most of them.
    /// Sides of one point are none of them.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, volume::{CyclideVolume, FineEnd, Grading, SphericalCube, StructuredGrid, VolumeFrame}};
    /// let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z])?;
    /// let blocks = [CyclideVolume::new(&cube, VolumeFrame::Auto)?];
    /// let of = |ratio: f64| Grading::Geometric { ratio, fine: FineEnd::Start }.places(20);
    /// assert!(StructuredGrid::check_lengths(&blocks, 2, &of(4.0)?).is_ok());
    /// let error = StructuredGrid::check_lengths(&blocks, 2, &of(10.0)?).unwrap_err(); // the first one is 1e-19 long
    /// assert_eq!(error.reason(), "below-rounding-of-place");
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `below-rounding-of-place`, with the block.
    ///
    /// # Panics
    /// If `axis` is above 2.
    pub fn check_lengths(blocks: &[CyclideVolume], axis: usize, places: &[f64]) -> Result<()> {
        let shortest = places.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
        for (index, block) in blocks.iter().enumerate() {
            let place = block.corners().iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
            let has_extent = block.sides(axis).map(|side| side.is_some());
            for (k, _) in has_extent.iter().enumerate().filter(|(_, extent)| **extent) {
                let at = |x: f64| {
                    // Bits of the two other directions, in order.
                    let mut at = [[0, 0, 1], [0, 0, 1], [0, 1, 0]][axis].map(|bit| (k >> bit & 1) as f64);
                    at[axis] = x;
                    at
                };
                // Lines are slowest at an end.
                let slowest = [0.0, 1.0].map(|x| block.metric(at(x)).first[axis].length());
                if slowest[0].min(slowest[1]) * shortest > SHORTEST * place {
                    continue;
                }
                let lengths = places.windows(2).map(|pair| block.point(at(pair[0])).distance(block.point(at(pair[1]))));
                let least = lengths.fold(f64::INFINITY, f64::min);
                range::check_size_in_place(ErrorItem::Cells, least, place, SHORTEST).map_err(|e| e.in_block(index))?;
            }
        }
        Ok(())
    }

    /// What should be known of a grid of this [quality](Self::quality): `cells-inverted`.
    #[must_use]
    pub fn warnings(&self, quality: &GridQuality) -> Vec<Warning> {
        let Some(first) = quality.first_inverted else { return Vec::new() };
        let (block, at) = self.cell_place(first);
        let cause = if self.blocks()[block].folds() != FoldVerdict::Regular {
            InvertedCause::Fold
        } else if self.has_rounded_side(first) {
            InvertedCause::Rounding
        } else {
            InvertedCause::TooCoarse
        };
        vec![Warning::Volume(VolumeWarning::CellsInverted {
            count: quality.inverted,
            cells: self.cell_count(),
            block,
            at,
            cause,
        })]
    }

    /// Whether a side of a cell that is no point is as short as the rounding of its ends.
    fn has_rounded_side(&self, cell: usize) -> bool {
        let nodes = self.cell(cell);
        let corners = nodes.map(|node| self.nodes()[node]);
        let place = corners.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let sides = (0..3).flat_map(|axis| (0..8).filter(move |k| k >> axis & 1 == 0).map(move |k| (k, k | 1 << axis)));
        // A side of one point is one node.
        let mut sides = sides.filter(|(from, to)| nodes[*from] != nodes[*to]);
        sides.any(|(from, to)| corners[from].distance(corners[to]) <= SHORTEST * place)
    }
}
