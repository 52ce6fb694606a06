//! How large the ball is that blends a branch with its main pipe.

/// The radius of the ball that blends a branch with its main pipe.
///
/// Angles are counted round the branch, counter-clockwise seen from its end: 0 is the side of the end of the main pipe, +x, and π/2 the side that a positive offset is to, +y for
/// a branch that goes up. So the crotches of a branch are at 0 and π, its flanks at π/2 and -π/2. Every loop is exact: the ball touches both pipes everywhere.
///
/// ```
/// use cyclide::construct::{PipeTee, TeeBlend, TeeBranch, TeeMain};
/// let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-12.0, 12.0] };
/// let tee = |blend| PipeTee::new(main, vec![TeeBranch { blend, ..TeeBranch::upright(1.0, 10.0, 0.5) }]);
/// let [least, most] = tee(TeeBlend::Radius { radius: 0.5, tolerance: Some(1e-4) })?.made()?.blends[0].radii;
/// assert!(least >= 0.4999 && most <= 0.5001);
/// let [least, most] = tee(TeeBlend::Least(0.5))?.made()?.blends[0].radii;
/// assert!((least - 0.5).abs() < 1e-12 && most > 0.6);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum TeeBlend {
    /// A ball of one radius: as nearly as this tolerance says, a thousandth of the radius by default. A loop of one radius is not rational.
    Radius {
        /// The radius.
        radius: f64,
        /// Largest difference from it.
        tolerance: Option<f64>,
    },
    /// The ball has these radii at these angles, in any order, and changes smoothly between them, from one to the next without passing either.
    Angles {
        /// Pairs of an angle and the radius there.
        values: Vec<[f64; 2]>,
        /// Largest difference from the law between its values, a thousandth of the radius by default.
        tolerance: Option<f64>,
    },
    /// The plainest loop, one quartic all round: this radius at the flank where it is least, and the larger ones in the crotches that follow from it.
    Least(f64),
}
