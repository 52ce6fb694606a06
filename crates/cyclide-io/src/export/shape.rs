//! What the surfaces of a model are to writers: faces that share edges, or triangles of a surface without exact form.

use cyclide::{
    Aabb,
    surface::TriangleSurface,
    topology::{Body, Shell},
};

/// A surface as writers take it.
pub(crate) enum Shape<'a> {
    /// Faces.
    Faces(Body),
    /// A surface over triangles, with the box that was found for it by sampling.
    Triangles(&'a TriangleSurface, Aabb),
}

impl<'a> Shape<'a> {
    /// A surface over triangles.
    ///
    /// # Errors
    /// As [`TriangleSurface::sampled_bounds`].
    pub(crate) fn of_triangles(surface: &'a TriangleSurface) -> cyclide::Result<Self> {
        Ok(Self::Triangles(surface, surface.sampled_bounds()?))
    }

    /// The faces; `None` of a surface over triangles.
    pub(crate) fn faces(&self) -> Option<&Body> {
        if let Self::Faces(body) = self { Some(body) } else { None }
    }

    /// The surface over triangles; `None` of faces.
    pub(crate) fn triangles(&self) -> Option<&'a TriangleSurface> {
        if let Self::Triangles(surface, _) = self { Some(surface) } else { None }
    }

    /// Shells of faces; none of a surface over triangles.
    pub(crate) fn shells(&self) -> impl Iterator<Item = &Shell> {
        self.faces().into_iter().flat_map(Body::shells)
    }

    pub(crate) fn bounds(&self) -> Aabb {
        match self {
            Self::Faces(body) => body.bounds(),
            Self::Triangles(_, bounds) => *bounds,
        }
    }

    /// How many faces or triangles it has.
    pub(crate) fn part_count(&self) -> usize {
        match self {
            Self::Faces(body) => body.shells().map(|shell| shell.faces().len()).sum(),
            Self::Triangles(surface, _) => surface.triangle_count(),
        }
    }

    pub(crate) fn is_solid(&self) -> bool {
        match self {
            Self::Faces(body) => body.is_solid(),
            Self::Triangles(surface, _) => surface.is_closed(),
        }
    }
}

impl From<Body> for Shape<'_> {
    fn from(body: Body) -> Self {
        Self::Faces(body)
    }
}
