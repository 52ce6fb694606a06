//! Boxes around shells and bodies.

use super::{Body, FaceGeometry as _, Shell};
use crate::base::bounds::Aabb;
use crate::base::vector::Point3;

impl Shell {
    /// The smallest box around the shell, to rounding.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        let faces = self.faces().iter().map(|face| face.surface.bounds()).reduce(Aabb::union);
        // A shell has a face; the origin stands for the box of nothing.
        faces.unwrap_or(Aabb::of_point(Point3::ORIGIN))
    }
}

impl Body {
    /// The smallest box around the body, to rounding; that of its outer shell.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        self.outer.bounds()
    }
}
