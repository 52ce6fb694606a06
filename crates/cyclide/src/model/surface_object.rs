//! Any surface of the kernel, on its way to files.

use crate::error::Result;
use crate::surface::{CyclidePatch, CyclidicNet, NetLayout, TriangleSurface};
use crate::topology::{Body, Shell};

/// Any surface of the kernel.
///
/// ```
/// use cyclide::{model::SurfaceObject, surface::DupinCyclide};
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.nets([4, 4])?.remove(0);
/// assert!(SurfaceObject::from(torus).to_bodies()?[0].is_solid());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a model has few objects, and a patch is a plain value")]
pub enum SurfaceObject {
    /// One principal patch.
    Patch(CyclidePatch),
    /// Patches in a regular net. A whole cyclide is one of its nets, or two: see
    /// [`DupinCyclide::nets`](crate::surface::DupinCyclide::nets).
    Net(CyclidicNet),
    /// Nets that join round extraordinary vertices.
    Layout(NetLayout),
    /// Faces of any kind as they are sewn: a solid between a net and its offset, made by [`CyclidicNet::thick`], or what has no
    /// shorter name.
    Body(Body),
    /// A surface over triangles, which has no exact form and no faces.
    Triangles(TriangleSurface),
}

impl SurfaceObject {
    /// The net, if it is one.
    #[must_use]
    pub fn as_net(&self) -> Option<&CyclidicNet> {
        if let Self::Net(net) = self { Some(net) } else { None }
    }

    /// The nets of patches that it is, one or several; none of other surfaces.
    #[must_use]
    pub fn nets(&self) -> &[CyclidicNet] {
        match self {
            Self::Net(net) => std::slice::from_ref(net),
            Self::Layout(layout) => layout.nets(),
            Self::Patch(_) | Self::Body(_) | Self::Triangles(_) => &[],
        }
    }

    /// The surface over triangles, if it is one.
    #[must_use]
    pub fn as_triangles(&self) -> Option<&TriangleSurface> {
        if let Self::Triangles(surface) = self { Some(surface) } else { None }
    }

    /// The surface as patches that share edges: one body, or the lobes of a net that hangs together in nodes only, as
    /// [`CyclidicNet::to_shells`]; none of a surface over triangles, see [`as_triangles`](Self::as_triangles).
    ///
    /// # Errors
    /// Only where an edge is beyond the range of the kernel's numbers.
    pub fn to_bodies(&self) -> Result<Vec<Body>> {
        let alone = |outer| Body { outer, voids: Vec::new() };
        match self {
            Self::Patch(patch) => Ok(vec![alone(Shell::from_surface(*patch)?)]),
            Self::Net(net) => Ok(net.to_shells()?.into_iter().map(alone).collect()),
            Self::Layout(layout) => Ok(vec![alone(layout.to_shell()?)]),
            Self::Body(body) => Ok(vec![body.clone()]),
            Self::Triangles(_) => Ok(Vec::new()),
        }
    }
}
