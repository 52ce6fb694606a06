//! Warnings about blocks and their cells.

use crate::short_number::ShortNumber;
use crate::table::table;
use crate::warning::InvertedCause;

table! {
    /// Warnings about blocks and their cells.
    ///
    /// ```
    /// use cyclide::{Warning, warning::VolumeWarning};
    /// let warning: Warning = VolumeWarning::Folds { at: [1.0, 2.0, 0.0] }.into();
    /// assert_eq!(warning.reason(), "volume-folds");
    /// ```
    pub enum VolumeWarning {
        /// A block folds: the parameter lines of one direction run backwards in a part of it.
        Folds {
            /// A location in that part: s, t, u.
            at: [f64; 3],
        }
        reason "volume-folds";
        says "the block folds near s = {}, t = {}, u = {}: its parameter lines run backwards there, and cells have a \
            negative volume; use a frame closer to its sides, or corners closer to those of a box",
            ShortNumber(at[0]),
            ShortNumber(at[1]),
            ShortNumber(at[2]);

        /// Whether a block folds is not proved: parameter lines of one direction stop at a location, or nearly so.
        FoldUndecided {
            /// The location: s, t, u.
            at: [f64; 3],
            /// How often squares of parameters about it were quartered.
            depth: u32,
        }
        reason "volume-fold-undecided";
        says "it is undecided whether the block folds near s = {}, t = {}, u = {} after {depth} quarterings: cells \
            are flat there, or inverted", ShortNumber(at[0]), ShortNumber(at[1]), ShortNumber(at[2]);

        /// Cells of a grid are inverted: the hexahedra with straight sides, or those of the block itself where it folds.
        CellsInverted {
            /// How many.
            count: usize,
            /// The number of all cells.
            cells: usize,
            /// The block of the first one, from 0.
            block: usize,
            /// Its position in the block along s, t and u, from 0.
            at: [usize; 3],
            /// Why.
            cause: InvertedCause,
        }
        reason "cells-inverted";
        says "{count} of {cells} cells are inverted, the first is cell {}, {}, {} of block {block}: {}",
            at[0],
            at[1],
            at[2],
            cause.words();
    }
}
