//! The one error type of the kernel.
//!
//! Every variant says which item is at fault, what was measured and the limit it broke (`kinds.rs`). [`Error::reason`] gives
//! the stable kebab-case name that the reference data, the reports and the documentation use.

mod fold_remedy;
mod grid_cell_fault;
mod item;
mod join_fault;
mod kinds;
mod layout_fault;
mod message;
mod motion_message;
mod reason;
pub mod reasons;
mod surface_fault;
mod volume_message;
mod words;

pub use fold_remedy::FoldRemedy;
pub use grid_cell_fault::GridCellFault;
pub use item::ErrorItem;
pub use join_fault::JoinFault;
pub use kinds::Error;
pub use layout_fault::LayoutFault;
pub use surface_fault::SurfaceFault;

/// Result of a fallible kernel call.
///
/// ```
/// use cyclide::{Arc, Point3, Vec3};
/// let result: cyclide::Result<Arc> = Arc::from_start_tangent(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Vec3::ZERO);
/// assert_eq!(result.unwrap_err().reason(), "zero-tangent");
/// ```
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::InQuad { cause, .. }
            | Self::InBlock { cause, .. }
            | Self::InFaceOfVolume { cause, .. }
            | Self::InBranch { cause, .. }
            | Self::InTriangle { cause, .. }
            | Self::InSpan { cause, .. } => Some(cause.as_ref()),
            _ => None,
        }
    }
}

impl Error {
    /// The fault of the only axis or normal there is, which has no length at all.
    pub(crate) const fn zero_axis(what: ErrorItem) -> Self {
        Self::ZeroAxis { what, index: 0, length: 0.0, limit: 0.0 }
    }

    /// The fault of something that goes to infinity itself.
    pub(crate) const fn at_infinity(what: ErrorItem, index: usize) -> Self {
        Self::PointAtInfinity { what, index, distance: 0.0, limit: 0.0 }
    }
}

/// Refuses a tolerance that is not a positive number.
///
/// # Errors
/// `tolerance-not-positive` (also for NaN), `not-finite` (infinite).
pub(crate) fn check_tolerance(tolerance: f64) -> Result<()> {
    if tolerance.is_nan() || tolerance <= 0.0 {
        return Err(Error::ToleranceNotPositive { tolerance });
    }
    if tolerance.is_finite() { Ok(()) } else { Err(Error::NotFinite { what: ErrorItem::Tolerance, index: 0 }) }
}
