//! Why cells of a grid are inverted.

/// Why cells of a grid are inverted.
///
/// ```
/// use cyclide::warning::InvertedCause;
/// assert_ne!(InvertedCause::TooCoarse, InvertedCause::Rounding);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum InvertedCause {
    /// The block folds, or is flat.
    Fold,
    /// Sides of the cells are as short as the rounding of their coordinates, for example beside an axis.
    Rounding,
    /// Straight sides are too coarse for the arcs of the block.
    TooCoarse,
}

impl InvertedCause {
    pub(super) fn words(self) -> &'static str {
        match self {
            Self::Fold => "the block folds there, or is flat at best",
            Self::Rounding => {
                "their sides are as short as the rounding of their coordinates; use fewer cells, a thicker first cell, or a location closer to the origin"
            }
            Self::TooCoarse => "their straight sides are too coarse for its arcs; use more cells",
        }
    }
}
