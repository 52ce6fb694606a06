//! Smooth surfaces over triangles, field by field.

use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use super::polygon_mesh_file::PolygonMeshFile;
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;

/// A smooth surface through the vertices of a triangle mesh: its tangent plane is continuous, and neighbours share edges. The mesh
/// is in a file (`mesh`), or given by `vertices` and `triangles`. It has no exact form: GLB, OBJ and STL hold meshes of it within
/// the tolerance, STEP and JSON do not hold it.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "smooth-mesh", "vertices": [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], "triangles": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::ObjectReport::new(&built[0], None);
/// let cyclide_io::GeometryReport::Smooth(found) = report.geometry else { unreachable!("by its type") };
/// // Rounder than the octahedron, and within the ball.
/// assert!(found.volume.is_some_and(|volume| volume > 4.0 / 3.0 && volume < 4.2));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    { "required": ["mesh"], "properties": { "vertices": false, "triangles": false } },
    { "required": ["vertices", "triangles"], "properties": { "mesh": false } }
]))]
#[non_exhaustive]
pub struct SmoothMeshSpec {
    /// The word `smooth-mesh`.
    #[schemars(with = "String", extend("const" = "smooth-mesh"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// A mesh of polygons, which are cut into triangles. Points that are equal are one.
    pub mesh: Option<PolygonMeshFile>,
    /// The vertices.
    #[schemars(length(min = 3))]
    pub vertices: Option<Vec<Coordinates>>,
    /// The triangles: three vertices each by their number from 0, counter-clockwise from outside.
    #[schemars(length(min = 1))]
    pub triangles: Option<Vec<[u32; 3]>>,
    /// Where the normals at the vertices come from.
    #[serde(default)]
    pub normals: NormalsSpec,
    /// Edges at which triangles meet at a larger angle than this (between their normals, 0 to π) stay creases. Default: none; with
    /// normals from the file its own.
    pub crease_angle: Option<Angle>,
}

/// The normals at the vertices of a mesh.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "smooth-mesh", "normals": "sphere", "vertices": [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], "triangles": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::ObjectReport::new(&built[0], None);
/// let cyclide_io::GeometryReport::Smooth(found) = report.geometry else { unreachable!("by its type") };
/// assert_eq!(found.normals, Some("sphere"));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, JsonSchema)]
#[schemars(untagged, rename = "VertexNormals")]
#[non_exhaustive]
pub enum NormalsSpec {
    /// The mean of those of the triangles around a vertex, weighted by their angles.
    #[default]
    #[schemars(with = "NormalsWord")]
    Angle,
    /// The mean with weights that are exact where all vertices are on a sphere: better on meshes of smooth surfaces.
    #[schemars(skip)]
    Sphere,
    /// Those of the file; where a vertex has several, the edges between them are creases.
    #[schemars(skip)]
    File,
    /// One for each of `vertices`, of any length.
    Given(Vec<Coordinates>),
}

/// A rule for normals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[schemars(inline)]
enum NormalsWord {
    /// The mean of those of the triangles around a vertex, weighted by their angles.
    #[serde(rename = "angle")]
    Angle,
    /// The mean with weights that are exact where all vertices are on a sphere: better on meshes of smooth surfaces.
    #[serde(rename = "sphere")]
    Sphere,
    /// Those of the file; where a vertex has several, the edges between them are creases.
    #[serde(rename = "file")]
    File,
}

impl<'de> Deserialize<'de> for NormalsSpec {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NormalsVisitor;
        impl<'de> serde::de::Visitor<'de> for NormalsVisitor {
            type Value = NormalsSpec;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("\"angle\", \"sphere\", \"file\" or a list of directions `[[x, y, z], …]`")
            }
            fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<NormalsSpec, E> {
                let word = NormalsWord::deserialize(serde::de::value::StrDeserializer::new(word))?;
                Ok(match word {
                    NormalsWord::Angle => NormalsSpec::Angle,
                    NormalsWord::Sphere => NormalsSpec::Sphere,
                    NormalsWord::File => NormalsSpec::File,
                })
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, seq: A) -> Result<NormalsSpec, A::Error> {
                Vec::deserialize(serde::de::value::SeqAccessDeserializer::new(seq)).map(NormalsSpec::Given)
            }
        }
        deserializer.deserialize_any(NormalsVisitor)
    }
}

/// A smooth patch over one triangle, shaped at each corner by a sphere through the circle of the three corners: given by a point
/// of each sphere (`control`), or by the normals that the patch should have at the corners (`normals`). It has no exact form, as a
/// smooth mesh.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "sphere-blend", "corners": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "normals": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::ObjectReport::new(&built[0], None);
/// let cyclide_io::GeometryReport::Smooth(found) = report.geometry else { unreachable!("by its type") };
/// assert_eq!((found.triangles, found.vertices, found.closed), (1, 3, false));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    { "required": ["control"], "properties": { "normals": false } },
    { "required": ["normals"], "properties": { "control": false } }
]))]
#[non_exhaustive]
pub struct SphereBlendSpec {
    /// The word `sphere-blend`.
    #[schemars(with = "String", extend("const" = "sphere-blend"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The corners, counter-clockwise seen from outside.
    pub corners: [Coordinates; 3],
    /// A point of the sphere of each corner, off the circle of the corners. On the side of these points the patch bulges.
    pub control: Option<[Coordinates; 3]>,
    /// The normal at each corner, of any length; it is turned about the circle's tangent there as far as the sphere asks for.
    pub normals: Option<[Coordinates; 3]>,
}
