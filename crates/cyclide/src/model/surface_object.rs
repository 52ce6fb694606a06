//! Any surface of the kernel, on its way to files.

use crate::error::Result;
use crate::surface::{Body, CyclidePatch, CyclidicNet, Shell};

/// Any surface of the kernel.
#[derive(Debug, Clone, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a model has few objects, and a patch is a plain value")]
pub enum SurfaceObject {
    /// One principal patch.
    Patch(CyclidePatch),
    /// Patches in a regular net, as one shell. A whole cyclide is one of its nets, or two: see
    /// [`DupinCyclide::nets`](crate::DupinCyclide::nets).
    Net(CyclidicNet),
    /// A solid between a net and its offset, made by [`CyclidicNet::thick`].
    Thick(Body),
}

impl SurfaceObject {
    /// The surface as patches that share edges: what every exporter reads.
    ///
    /// # Errors
    /// Only where an edge is beyond the range of the kernel's numbers.
    pub fn to_body(&self) -> Result<Body> {
        match self {
            Self::Patch(patch) => Ok(Body { outer: Shell::from_patch(*patch)?, voids: Vec::new() }),
            Self::Net(net) => Ok(Body { outer: net.to_shell()?, voids: Vec::new() }),
            Self::Thick(body) => Ok(body.clone()),
        }
    }
}
