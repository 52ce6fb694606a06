//! What helps against a blend that self-intersects.

/// What helps against a blend that self-intersects.
///
/// ```
/// use cyclide::{Error, construct::{CrossingPipe, PipeCrossing}, error::{CrossingError, FoldRemedy}};
/// let pipe = CrossingPipe { radius: 2.0, taper: 0.0, ends: [-9.0, 9.0] };
/// // A bridge over a gap of 1: the ball hardly fits through, and turns round on the spot.
/// let Err(Error::Crossing(CrossingError::Folds { remedy, .. })) = PipeCrossing::new([pipe, pipe], 5.0, 0.51)?.made() else {
///     panic!("it folds")
/// };
/// assert_eq!(remedy, FoldRemedy::LargerBall);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FoldRemedy {
    /// A larger ball turns less sharply.
    LargerBall,
    /// A smaller ball needs less space.
    SmallerBall,
    /// The exact blend does not self-intersect, only its approximation within the tolerance.
    FinerTolerance,
}

impl FoldRemedy {
    /// The advice in words.
    pub(super) fn advice(self, walled: bool) -> &'static str {
        match (self, walled) {
            (Self::LargerBall, true) => "use a larger ball or a thinner wall, or move the axes",
            (Self::SmallerBall, true) => "use a smaller ball or a thinner wall, or move the axes",
            (Self::LargerBall, false) => "use a larger ball, or move the axes",
            (Self::SmallerBall, false) => "use a smaller ball, or move the axes",
            (Self::FinerTolerance, _) => "the exact blend does not self-intersect: use a smaller tolerance",
        }
    }
}
