//! Surfaces: from fields to the kernel's patches.

use cyclide::{CyclidePatch, SurfaceObject, Vec3};

use super::Builder;
use crate::document::coordinates::Coordinates;
use crate::document::spec::CyclidePatchSpec;
use crate::error::Result;

impl Builder<'_> {
    /// The patch.
    pub(in crate::document) fn patch(&self, spec: &CyclidePatchSpec) -> Result<Vec<SurfaceObject>> {
        let [v1, v2] = spec.frame.map(direction);
        let corners = spec.corners.map(Coordinates::point);
        let patch = CyclidePatch::from_corners_and_frame_at(corners, spec.frame_corner as usize, v1, v2);
        patch.map(|patch| vec![SurfaceObject::Patch(patch)]).map_err(|e| self.refused(&e, None))
    }
}

/// A direction of any length as a unit vector; one that has none stays what it is, for the kernel to refuse.
pub(in crate::document) fn direction(given: Coordinates) -> Vec3 {
    let v = given.vector();
    v.unit().unwrap_or(v)
}
