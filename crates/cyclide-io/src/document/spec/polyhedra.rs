//! Polyhedra, field by field.

use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use super::polygon_mesh_file::PolygonMeshFile;
use crate::document::coordinates::{Coordinates, PointSource};

/// A convex polyhedron with all edges and corners rounded: the points within a distance of it. A solid of planes, cylinders and
/// parts of spheres. The polyhedron is a mesh in a file (`mesh`), the convex hull of points (`points`), or given by `vertices` and
/// `faces`.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "smooth-polyhedron", "radius": 1, "points": [[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0], [0, 0, 2], [2, 0, 2], [0, 2, 2], [2, 2, 2]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[0].bodies[0].outer.volume() - (32.0 + (6.0 + 4.0 / 3.0) * std::f64::consts::PI)).abs() < 1e-10);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    { "required": ["mesh"], "properties": { "points": false, "vertices": false, "faces": false } },
    { "required": ["points"], "properties": { "mesh": false, "vertices": false, "faces": false, "hull": false } },
    { "required": ["vertices", "faces"], "properties": { "mesh": false, "points": false } }
]))]
#[non_exhaustive]
pub struct SmoothPolyhedronSpec {
    /// The word `smooth-polyhedron`.
    #[schemars(with = "String", extend("const" = "smooth-polyhedron"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The radius of the rounding, by which the polyhedron grows; 0 for the polyhedron itself.
    #[schemars(range(min = 0.0))]
    pub radius: f64,
    /// A closed mesh of any planar polygons. Points that are equal are one; faces in one plane become one.
    pub mesh: Option<PolygonMeshFile>,
    /// Points whose convex hull it is.
    pub points: Option<PointSource>,
    /// The vertices.
    #[schemars(length(min = 4))]
    pub vertices: Option<Vec<Coordinates>>,
    /// The faces: lists of vertices by their number from 0, counter-clockwise from outside.
    #[schemars(length(min = 4), inner(length(min = 3)))]
    pub faces: Option<Vec<Vec<u32>>>,
    /// Take the convex hull of the vertices in place of the faces, which need not be convex then.
    #[serde(default)]
    pub hull: bool,
    /// Corners this near to a plane are in it: faces are planar, and those in one plane become one. Default: 1e-9 of the diameter,
    /// of an STL or GLB file the rounding of its numbers, 5e-7 of the largest coordinate.
    #[schemars(range(min = 0.0))]
    pub flatness: Option<f64>,
}
