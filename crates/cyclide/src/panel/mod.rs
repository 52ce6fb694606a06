//! What a workshop must know of a panel, a patch of a net: its measures, the simple surfaces near it, which panels one
//! mould makes, which are congruent, and the flat pattern of those that are bent from a flat sheet
//! (`docs/math/panels.md`).

mod bent_plane;
mod congruence;
mod flat_pattern;
mod least_maximum;
mod measures;
mod mould_shape;
mod moulds;
mod nearest;
mod panel_fit;
mod peaks;
mod unit_patch;

pub use congruence::{CongruenceClass, Congruences, CongruentPanel};
pub use flat_pattern::FlatPattern;
pub use measures::{CurvatureExtreme, PanelMeasures, PanelSide, PanelSideForm};
pub use mould_shape::MouldShape;
pub use moulds::{Mould, MouldMember, Moulds};
pub use nearest::{NearSurface, NearestSurfaces};
