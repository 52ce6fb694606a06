//! What *exact* means, as a trait: types without an exact rational form do not implement it, so the compiler keeps
//! them from being exported as exact.

/// Objects that are rational Bézier or B-spline objects as they stand, without any tolerance.
pub trait ExactRational {
    /// The rational form.
    type Form;

    /// The same points with the same parameter as a rational form.
    fn to_rational(&self) -> Self::Form;
}
