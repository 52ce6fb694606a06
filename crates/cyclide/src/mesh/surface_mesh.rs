//! A polygon mesh of surfaces, with shared vertices.

use crate::base::vector::{Point3, Vec3};

/// A corner of a polygon: indices of its position and of its normal. Positions are shared by all polygons around a
/// vertex (watertight); normals differ where the surface has an edge.
///
/// ```
/// use cyclide::{mesh::tessellate, surface::DupinCyclide};
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.to_bodies([4, 4])?;
/// let mesh = tessellate(&torus[0], 0.05)?;
/// let corner = mesh.faces[0].corners()[0];
/// assert!((mesh.normals[corner.normal].length() - 1.0).abs() < 1e-12 && mesh.positions[corner.position].is_finite());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct MeshCorner {
    /// Index into the positions.
    pub position: usize,
    /// Index into the normals.
    pub normal: usize,
}

/// A planar quad or a triangle (at the pole of a patch, and on rational faces), counter-clockwise seen from the outer side.
///
/// ```
/// use cyclide::{mesh::{MeshFace, tessellate}, surface::DupinCyclide};
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.to_bodies([4, 4])?;
/// let mesh = tessellate(&torus[0], 0.05)?;
/// assert!(mesh.faces.iter().any(|face| matches!(face, MeshFace::Quad(_))));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MeshFace {
    /// Three corners.
    Triangle([MeshCorner; 3]),
    /// Four corners in one plane.
    Quad([MeshCorner; 4]),
}

impl MeshFace {
    /// The corners.
    #[must_use]
    pub fn corners(&self) -> &[MeshCorner] {
        match self {
            Self::Triangle(c) => c,
            Self::Quad(c) => c,
        }
    }

    pub(super) fn corners_mut(&mut self) -> &mut [MeshCorner] {
        match self {
            Self::Triangle(c) => c,
            Self::Quad(c) => c,
        }
    }
}

/// The part of a body that a polygon of its mesh stands for.
///
/// ```
/// use cyclide::{mesh::tessellate, surface::{DupinCyclide, ParamSurface}};
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.to_bodies([4, 4])?;
/// let mesh = tessellate(&torus[0], 0.05)?;
/// let (source, corner) = (mesh.sources[0], mesh.faces[0].corners()[0]);
/// let surface = &torus[0].outer.faces()[source.face].surface;
/// assert!(surface.point(source.s[0], source.t[0]).distance(mesh.positions[corner.position]) < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshSource {
    /// Index of the shell, the outer one first.
    pub shell: usize,
    /// Index of the face in its shell.
    pub face: usize,
    /// First parameters of the cell, ascending.
    pub s: [f64; 2],
    /// Second parameters of the cell, ascending.
    pub t: [f64; 2],
}

/// A mesh of one body with the certified distance to it.
///
/// ```
/// use cyclide::{mesh::tessellate, surface::DupinCyclide};
/// let torus = DupinCyclide::new(3.0, 0.0, 1.0)?.to_bodies([4, 4])?;
/// let mesh = tessellate(&torus[0], 0.01)?;
/// assert!(mesh.bound <= 0.01 && (mesh.volume() - torus[0].outer.volume()).abs() < 0.01 * mesh.area());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SurfaceMesh {
    /// Positions of the vertices.
    pub positions: Vec<Point3>,
    /// Unit normals.
    pub normals: Vec<Vec3>,
    /// Quads and triangles.
    pub faces: Vec<MeshFace>,
    /// What each of [`faces`](Self::faces) stands for: two that follow each other, if a cell is two triangles.
    pub sources: Vec<MeshSource>,
    /// The cells that no polygon stands for: between points that are one but for rounding.
    pub lost: Vec<MeshSource>,
    /// No point of the surface is farther from the mesh than this, nor the other way. Proved for bodies; of a
    /// [`SmoothMesh`](crate::surface::SmoothMesh) only sampled, or infinite if it was not measured.
    pub bound: f64,
    /// How far a vertex that faces share is from the place of it on any of them, at most: rounding, but for the points of
    /// nearly singular lines, which are one vertex.
    pub gap: f64,
}

impl SurfaceMesh {
    /// Number of triangles when quads are cut in two.
    #[must_use]
    pub fn triangle_count(&self) -> usize {
        self.faces.iter().map(|f| f.corners().len() - 2).sum()
    }

    /// Area of all polygons.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.triangles().map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum()
    }

    /// Volume enclosed by a closed mesh, positive if its outer side is outside. For an open mesh, the volume between it and
    /// its first vertex.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let Some(&apex) = self.positions.first() else { return 0.0 };
        self.triangles().map(|[a, b, c]| (a - apex).dot((b - apex).cross(c - apex)) / 6.0).sum()
    }

    /// All polygons, quads cut in two.
    fn triangles(&self) -> impl Iterator<Item = [Point3; 3]> + '_ {
        self.faces.iter().flat_map(|face| {
            let c = face.corners();
            let at = |k: usize| self.positions[c[k].position];
            (1..c.len() - 1).map(move |k| [at(0), at(k), at(k + 1)])
        })
    }
}
