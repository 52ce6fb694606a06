//! Surfaces: from fields to the kernel's patches.

use cyclide::{CyclidePatch, SurfaceObject, Vec3};

use super::Builder;
use crate::document::coordinates::Coordinates;
use crate::document::spec::{CyclidePatchSpec, ObjectSpec};
use crate::error::Result;

impl Builder<'_> {
    /// The surfaces of an object that has some.
    pub(super) fn surfaces(&mut self) -> Result<Vec<SurfaceObject>> {
        match self.spec {
            ObjectSpec::CyclidePatch(spec) => self.patch(spec),
            ObjectSpec::Cyclide(spec) => self.cyclide(spec),
            ObjectSpec::CyclidicNet(spec) => self.net(spec),
            ObjectSpec::SmoothPolyhedron(spec) => self.smooth_polyhedron(spec),
            ObjectSpec::SmoothMesh(spec) => self.smooth_mesh(spec),
            ObjectSpec::SphereBlend(spec) => self.sphere_blend(spec),
            ObjectSpec::Offset(_) if self.is_of_curves() => Ok(Vec::new()),
            ObjectSpec::Offset(spec) => self.offset(spec),
            ObjectSpec::Transform(spec) => self.mapped_surfaces(spec),
            ObjectSpec::Revolution(spec) => self.revolution(spec),
            ObjectSpec::Pipe(spec) => self.pipe(spec),
            ObjectSpec::Tube(spec) => self.tube(spec),
            ObjectSpec::Sweep(spec) => self.sweep(spec),
            ObjectSpec::PipeTee(spec) => self.pipe_tee(spec),
            ObjectSpec::ContactBlend(spec) => self.contact_blend(spec),
            ObjectSpec::PipeCrossing(spec) => self.pipe_crossing(spec),
            ObjectSpec::CenterSurface(spec) => self.center_surface(spec),
            ObjectSpec::PlateWithNeck(spec) => self.plate_with_neck(spec),
            ObjectSpec::EllipseBridge(spec) => self.ellipse_bridge(spec),
            ObjectSpec::CircularSurface(spec) => self.circular_surface(spec),
            ObjectSpec::Ruled(spec) => self.ruled(spec),
            ObjectSpec::TorusSeam(spec) => self.torus_seam(spec),
            ObjectSpec::SweptSurface(spec) => self.swept_surface(spec),
            ObjectSpec::CoordinateSurfaces(spec) => {
                self.check_surfaces_differ(spec)?;
                self.coordinate_surfaces(spec)
            }
            _ => Ok(Vec::new()),
        }
    }

    fn patch(&self, spec: &CyclidePatchSpec) -> Result<Vec<SurfaceObject>> {
        let [v1, v2] = spec.frame.map(direction);
        let corners = spec.corners.map(Coordinates::point);
        let patch = CyclidePatch::from_corners_and_frame_at(corners, spec.frame_corner as usize, v1, v2);
        patch.map(|patch| vec![SurfaceObject::Patch(patch)]).map_err(|e| self.refused(&e, None))
    }
}

/// A direction of any length as a unit vector; one that has none stays what it is, for the kernel to refuse.
pub(super) fn direction(given: Coordinates) -> Vec3 {
    let v = given.vector();
    v.unit().unwrap_or(v)
}
