//! Meshes of surfaces over triangles: each triangle cut into N² by integer barycentric coordinates, the same N everywhere.
//!
//! Points of an edge are computed once, from its lower vertex, so neighbours share them to the bit. How far the mesh is from the
//! surface is measured at places on all edges and in all triangles of it: sampled, not proved.

mod blend;
mod deviation;
mod numbering;

use super::MOST_PIECES;
use super::surface_mesh::{MeshFace, MeshSource, SurfaceMesh};
use crate::error::{Error, ErrorItem, Result, check_tolerance};
use crate::surface::{SmoothMesh, TriangleSurface};
use numbering::Numbering;

/// Numbers of divisions grow by this more than the last deviation asks for, which saves most second tries.
const MORE: f64 = 1.03;
/// Fewer divisions tell little of the deviation of many.
const FEW: usize = 8;
/// What is kept for the places between those that are looked at: the bound is so many times the largest distance found.
const RESERVE: f64 = 1.25;

/// A mesh of a surface over triangles with what was measured of it.
///
/// ```
/// use cyclide::{Point3, SmoothMesh, VertexNormals};
/// let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.1], [0.0, 1.0, 0.2], [1.0, 1.0, -0.1]].map(Point3::from);
/// let smooth = SmoothMesh::new(&points, &[[0, 1, 2], [1, 3, 2]], VertexNormals::AngleWeighted)?;
/// let made = smooth.tessellate_within(0.01)?;
/// assert!(made.deviation <= 0.01 && made.mesh.faces.len() == 2 * made.divisions * made.divisions);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SmoothTessellation {
    /// The mesh: faces in the order of the triangles of the surface, N² each, whose sources have the number of their triangle as face
    /// and the ranges of its first two barycentric coordinates. Its `bound` is 1.25 times the deviation.
    pub mesh: SurfaceMesh,
    /// Parts N of every edge.
    pub divisions: usize,
    /// Largest distance of the surface from the mesh at places on its edges and in its triangles: sampled, not proved.
    pub deviation: f64,
}

impl SmoothMesh {
    /// A mesh whose edges are those of the surface in `divisions` parts each. Not measured: its `bound` is infinite.
    ///
    /// # Errors
    /// `parameter-out-of-range` (no division), `too-many-pieces` (above [`MOST_PIECES`]), as
    /// [`SmoothTriangle::point`](crate::SmoothTriangle::point) with the number of the triangle.
    pub fn tessellate(&self, divisions: usize) -> Result<SurfaceMesh> {
        check_divisions(self.triangles().len(), divisions, MOST_PIECES)?;
        let numbering = Numbering::new(self, divisions);
        let (positions, normals) = numbering.places()?;
        let count = self.triangles().len() * divisions * divisions;
        let (mut faces, mut sources) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for triangle in 0..self.triangles().len() {
            for cell in cells(divisions) {
                faces.push(MeshFace::Triangle(cell.map(|at| numbering.corner(triangle, at))));
                sources.push(source(triangle, cell, divisions));
            }
        }
        Ok(SurfaceMesh { positions, normals, faces, sources, lost: Vec::new(), bound: f64::INFINITY, gap: 0.0 })
    }

    /// A mesh that is within a tolerance of the surface where it is measured, with a reserve for what lies between.
    ///
    /// # Errors
    /// `tolerance-not-positive`, `not-finite`, and as [`tessellate`](Self::tessellate); `too-many-pieces` with the number of the triangle that asks
    /// for so many: all are cut alike.
    pub fn tessellate_within(&self, tolerance: f64) -> Result<SmoothTessellation> {
        within(self, tolerance, MOST_PIECES)
    }

    /// The largest distance of the surface from its mesh with these divisions, at places on the edges and in the triangles of the mesh.
    ///
    /// # Errors
    /// As [`tessellate`](Self::tessellate).
    pub fn sampled_deviation(&self, divisions: usize) -> Result<f64> {
        check_divisions(self.triangles().len(), divisions, MOST_PIECES)?;
        Divided::deviation(self, divisions).map(|(deviation, _)| deviation)
    }
}

impl TriangleSurface {
    /// A mesh of at most `most` triangles, as [`SmoothMesh::tessellate_within`].
    ///
    /// # Errors
    /// As [`SmoothMesh::tessellate_within`].
    pub fn tessellate_within(&self, tolerance: f64, most: usize) -> Result<SmoothTessellation> {
        match self {
            Self::Mesh(mesh) => within(mesh, tolerance, most),
            Self::Blend(blend) => within(blend, tolerance, most),
        }
    }
}

/// What is cut into parts.
trait Divided {
    fn triangle_count(&self) -> usize;
    /// The largest one, and the triangle that has it.
    fn deviation(&self, divisions: usize) -> Result<(f64, usize)>;
    fn mesh(&self, divisions: usize) -> Result<SurfaceMesh>;
}

impl Divided for SmoothMesh {
    fn triangle_count(&self) -> usize {
        self.triangles().len()
    }

    fn deviation(&self, divisions: usize) -> Result<(f64, usize)> {
        let mut largest = (0.0, 0);
        for index in 0..self.triangles().len() {
            let Some(triangle) = self.triangle(index) else { continue };
            let own = deviation::of_patch(divisions, |at| triangle.point(at));
            let own = own.map_err(|e| e.in_triangle(index))?;
            if own > largest.0 {
                largest = (own, index);
            }
        }
        Ok(largest)
    }

    fn mesh(&self, divisions: usize) -> Result<SurfaceMesh> {
        self.tessellate(divisions)
    }
}

fn within(surface: &impl Divided, tolerance: f64, most: usize) -> Result<SmoothTessellation> {
    check_tolerance(tolerance)?;
    let (count, mut divisions) = (surface.triangle_count(), 1);
    check_count(count, 1.0, most)?;
    loop {
        let (deviation, worst) = surface.deviation(divisions)?;
        let bound = RESERVE * deviation;
        if bound <= tolerance {
            let mesh = SurfaceMesh { bound, ..surface.mesh(divisions)? };
            return Ok(SmoothTessellation { mesh, divisions, deviation });
        }
        // Deviations fall with the square of the divisions, once there are a few.
        let wanted = (divisions as f64 * (bound / tolerance).sqrt() * MORE).ceil();
        let wanted = if divisions < FEW { wanted.min(FEW as f64) } else { wanted };
        // All triangles are cut alike: the worst one decides.
        check_count(count, wanted, most).map_err(|e| e.in_triangle(worst))?;
        divisions = (divisions + 1).max(wanted as usize);
    }
}

fn check_divisions(triangles: usize, divisions: usize, most: usize) -> Result<()> {
    if divisions == 0 {
        return Err(Error::ParameterOutOfRange { name: ErrorItem::Divisions, value: 0.0, min: 1.0, max: f64::MAX });
    }
    check_count(triangles, divisions as f64, most)
}

/// Refuses more triangles than are made.
fn check_count(triangles: usize, divisions: f64, most: usize) -> Result<()> {
    let needed = triangles as f64 * divisions * divisions;
    if needed <= most as f64 {
        return Ok(());
    }
    Err(Error::TooManyPieces {
        what: "the mesh",
        segment: None,
        needed,
        cap: most,
        remedy: "use a larger tolerance or fewer triangles",
    })
}

/// Integer barycentric coordinates of a vertex of the mesh.
type Place = [usize; 3];

/// The parts of a triangle, corners counter-clockwise: row by row, those that point like it and those between them.
fn cells(divisions: usize) -> impl Iterator<Item = [Place; 3]> {
    (0..divisions).flat_map(move |i| {
        (0..divisions - i).flat_map(move |j| {
            let k = divisions - 1 - i - j;
            let upright = [[i + 1, j, k], [i, j + 1, k], [i, j, k + 1]];
            let between = (k > 0).then(|| [[i, j + 1, k], [i + 1, j, k], [i + 1, j + 1, k - 1]]);
            std::iter::once(upright).chain(between)
        })
    })
}

fn source(triangle: usize, cell: [Place; 3], divisions: usize) -> MeshSource {
    let range = |c: usize| {
        let values = cell.map(|at| at[c]);
        let [low, high] = [values.into_iter().min(), values.into_iter().max()];
        [low, high].map(|v| v.unwrap_or(0) as f64 / divisions as f64)
    };
    MeshSource { shell: 0, face: triangle, s: range(0), t: range(1) }
}

/// Coordinates as a triangle takes them.
fn lambda(at: Place) -> [f64; 3] {
    at.map(|v| v as f64)
}
