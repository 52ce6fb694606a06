//! Any surface of the kernel, on its way to files.

use crate::error::Result;
use crate::surface::{Body, CyclidePatch, Shell};

/// Any surface of the kernel.
#[derive(Debug, Clone, PartialEq)]
pub enum SurfaceObject {
    /// One principal patch.
    Patch(CyclidePatch),
}

impl SurfaceObject {
    /// The surface as patches that share edges: what every exporter reads.
    ///
    /// # Errors
    /// Only where an edge is beyond the range of the kernel's numbers.
    pub fn to_body(&self) -> Result<Body> {
        match self {
            Self::Patch(patch) => Ok(Body { outer: Shell::from_patch(*patch)?, voids: Vec::new() }),
        }
    }
}
