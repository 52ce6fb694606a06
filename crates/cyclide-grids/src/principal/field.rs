//! The directions that grids follow, for pictures of them.

use super::cross_field::CrossField;
use super::jets::VertexJet;
use super::mesh_table::MeshTable;
use cyclide::{Point3, Vec3};

/// The surface as it was given, with its normals and the directions that the grids follow.
///
/// ```
/// use cyclide::Point3;
/// use cyclide_grids::{PrincipalGridOptions, principal_grids};
/// // A gutter of radius 2 along y: along y it does not bend.
/// let at = |k: usize| (0.1 * (k % 25) as f64 - 1.2, 0.25 * (k / 25) as f64);
/// let point = |(a, y): (f64, f64)| Point3::new(2.0 * a.sin(), y, -2.0 * a.cos());
/// let points: Vec<Point3> = (0..625).map(at).map(point).collect();
/// let quads = (0..24).flat_map(|j| (0..24).map(move |i| 25 * j + i));
/// let triangles: Vec<[usize; 3]> = quads.flat_map(|a| [[a, a + 1, a + 26], [a, a + 26, a + 25]]).collect();
/// let field = principal_grids(&points, &triangles, &PrincipalGridOptions::new(0.5))?.field;
/// // Fits at the border see one side: cubics miss the circle by its fourth order there.
/// assert!(field.along.iter().all(|d| d.y.abs() < 1e-3 || d.y.abs() > 1.0 - 1e-6));
/// assert!(field.normals.iter().all(|n| n.y.abs() < 1e-3));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct PrincipalField {
    /// The vertices.
    pub points: Vec<Point3>,
    /// Vertices of the triangles, counter-clockwise about the normals.
    pub triangles: Vec<[usize; 3]>,
    /// Unit normals at the vertices, of the fits that curvatures were taken from.
    pub normals: Vec<Vec3>,
    /// A unit vector in each triangle, of the smoothed field; its sign means nothing. The other direction is across it.
    pub along: Vec<Vec3>,
}

impl PrincipalField {
    pub(super) fn new(given: &MeshTable, fits: &[VertexJet], field: &CrossField) -> Self {
        let normals = fits.iter().map(VertexJet::normal).collect();
        Self { points: given.points.clone(), triangles: given.triangles.clone(), normals, along: field.along.clone() }
    }
}
