//! A surface fitted to a panel.

use super::bent_plane::BentPlane;

/// A surface fitted to a panel, in the panel's units.
#[derive(Debug, Clone, Copy)]
pub(super) struct PanelFit {
    pub(super) shape: BentPlane,
    /// Largest distance of the panel, in the units of the given patch.
    pub(super) max_distance: f64,
    pub(super) place: (f64, f64),
}
