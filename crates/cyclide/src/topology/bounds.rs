//! Boxes around shells and bodies.

use super::{Body, FaceGeometry as _, Shell};
use crate::base::bounds::Aabb;
use crate::base::vector::Point3;

impl Shell {
    /// The smallest box around the shell, to rounding or, where its faces are rational, to 1e-9 of its diagonal.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        // What all corners show first: most faces stay inside it.
        let corners = self.faces().iter().flat_map(|face| face.surface.corners());
        let known = corners.map(Aabb::of_point).reduce(Aabb::union);
        // A shell has a face; the origin stands for the box of nothing.
        let known = known.unwrap_or(Aabb::of_point(Point3::ORIGIN));
        self.faces().iter().fold(known, |known, face| face.surface.bounds_with(known))
    }
}

impl Body {
    /// The smallest box around the body, that of its outer [shell](Shell::bounds).
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        self.outer.bounds()
    }
}
