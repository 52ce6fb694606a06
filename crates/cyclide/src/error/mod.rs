//! The errors of the kernel, by subject.
//!
//! Every cause is an entry of the table of its subject (`subjects`): which item is at fault, what was measured, the limit it broke,
//! its stable kebab-case reason and the sentence about it. Reference data, reports and the documentation use the reasons.

mod fold_remedy;
mod grid_cell_fault;
mod item;
mod join_fault;
mod layout_fault;
mod path;
pub mod reasons;
mod subjects;
mod surface_fault;
mod words;

pub use fold_remedy::FoldRemedy;
pub use grid_cell_fault::GridCellFault;
pub use item::ErrorItem;
pub use join_fault::JoinFault;
pub use layout_fault::LayoutFault;
pub use path::FieldPath;
pub use subjects::*;
pub use surface_fault::SurfaceFault;

/// Result of a fallible kernel call.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::Arc};
/// let result: cyclide::Result<Arc> = Arc::from_start_tangent(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Vec3::ZERO);
/// assert_eq!(result.unwrap_err().reason(), "zero-tangent");
/// ```
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// The fault of the only axis or normal there is, which has no length at all.
    pub(crate) const fn zero_axis(what: ErrorItem) -> Self {
        Self::Point(PointError::ZeroAxis { what, index: 0, length: 0.0, limit: 0.0 })
    }

    /// The fault of something that goes to infinity itself.
    pub(crate) const fn at_infinity(what: ErrorItem, index: usize) -> Self {
        Self::Point(PointError::AtInfinity { what, index, distance: 0.0, limit: 0.0 })
    }
}

/// Refuses a tolerance that is not a positive number.
///
/// # Errors
/// `tolerance-not-positive` (also for NaN), `not-finite` (infinite).
pub(crate) fn check_tolerance(tolerance: f64) -> Result<()> {
    if tolerance.is_nan() || tolerance <= 0.0 {
        return Err(NumberError::ToleranceNotPositive { tolerance }.into());
    }
    if tolerance.is_finite() {
        Ok(())
    } else {
        Err(NumberError::NotFinite { what: ErrorItem::Tolerance, index: 0 }.into())
    }
}
