//! A smooth surface through the vertices of a triangle mesh.

use cyclide::{
    Error as KernelError, ShortNumber, Warning,
    error::{ErrorItem, MeshError, NumberError, PartError},
    model::SurfaceObject,
    surface::{NormalWeights, SmoothMesh, VertexNormals},
    warning::MeshWarning,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::forms::forms;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::polygon_mesh_file::PolygonMeshFile;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::facts::{Facts, SmoothChoice};
use crate::document::objects::kind::{Kind, Shape};
use crate::document::objects::remark::Remark;
use crate::error::{Error, Result};
use crate::input::polygon_mesh::PolygonMesh;
use crate::input::triangle_mesh::{BadPolygons, TriangleMesh};

/// A smooth surface through the vertices of a triangle mesh: its tangent plane is continuous, and neighbors share
/// edges. The mesh is in a file (`mesh`), or given by `vertices` and `triangles`.
///
/// The surface has no exact form: GLB, OBJ and STL contain meshes of it within the tolerance, STEP and JSON cannot
/// contain it.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "smooth-mesh", "vertices": [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], "triangles": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Smooth(found) = report.geometry else { unreachable!("by its type") };
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
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// A mesh of polygons, which are cut into triangles. Equal points are merged.
    pub mesh: Option<PolygonMeshFile>,
    /// The vertices.
    #[schemars(length(min = 3))]
    pub vertices: Option<Vec<Coordinates>>,
    /// The triangles: three vertex numbers each, from 0, counter-clockwise seen from outside.
    #[schemars(length(min = 1))]
    pub triangles: Option<Vec<[u32; 3]>>,
    /// Where the normals at the vertices come from.
    #[serde(default)]
    pub normals: NormalsSpec,
    /// Edges stay creases if their triangles meet at a larger angle than this (between the normals, 0 to π). Default:
    /// no creases; with normals from the file, those of the file.
    pub crease_angle: Option<Angle>,
}

/// The normals at the vertices of a mesh.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"m": {"type": "smooth-mesh", "normals": "sphere", "vertices": [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], "triangles": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Smooth(found) = report.geometry else { unreachable!("by its type") };
/// assert_eq!(found.normals, Some("sphere"));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, JsonSchema)]
#[schemars(untagged, rename = "VertexNormals")]
#[non_exhaustive]
pub enum NormalsSpec {
    /// The mean of the normals of the triangles around a vertex, weighted by their angles.
    #[default]
    #[schemars(with = "NormalsWord")]
    Angle,
    /// The mean with weights that are exact if all vertices are on a sphere: better on meshes of smooth surfaces.
    #[schemars(skip)]
    Sphere,
    /// The normals of the file; where a vertex has several, the edges between them are creases.
    #[schemars(skip)]
    File,
    /// One for each of `vertices`, of any length.
    Given(Vec<Coordinates>),
}

/// A rule for normals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[schemars(inline)]
enum NormalsWord {
    /// The mean of the normals of the triangles around a vertex, weighted by their angles.
    #[serde(rename = "angle")]
    Angle,
    /// The mean with weights that are exact if all vertices are on a sphere: better on meshes of smooth surfaces.
    #[serde(rename = "sphere")]
    Sphere,
    /// The normals of the file; where a vertex has several, the edges between them are creases.
    #[serde(rename = "file")]
    File,
}

forms! {
    NormalsSpec: "\"angle\", \"sphere\", \"file\" or a list of directions `[[x, y, z], …]`";
    word NormalsWord => |word| match word {
        NormalsWord::Angle => NormalsSpec::Angle,
        NormalsWord::Sphere => NormalsSpec::Sphere,
        NormalsWord::File => NormalsSpec::File,
    };
    list Vec<Coordinates> => NormalsSpec::Given;
}

/// Polygons as they are given.
pub(in crate::document) struct Given {
    pub(in crate::document) mesh: PolygonMesh,
    /// The file.
    pub(in crate::document) file: Option<String>,
    /// The field of the document that has the polygons.
    pub(in crate::document) field: &'static str,
    /// Whether triangles share vertices there by their numbers.
    pub(in crate::document) shared: bool,
    /// Whether normals are listed beside the vertices.
    pub(in crate::document) lists_normals: bool,
}

impl Kind for SmoothMeshSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.smooth_mesh(self).map(Shape::Surfaces)
    }

    fn files(&self) -> Vec<&str> {
        self.mesh.iter().map(|file| file.path.as_str()).collect()
    }
}

impl Builder<'_> {
    /// The smooth surface through the vertices of a mesh.
    pub(in crate::document) fn smooth_mesh(&mut self, spec: &SmoothMeshSpec) -> Result<Vec<SurfaceObject>> {
        let given = self.polygons(spec)?;
        let mesh = TriangleMesh::new(&given.mesh).map_err(|bad| self.bad_polygons(&given, bad))?;
        self.remark_on_mesh(&given, &mesh);
        let crease_angle = spec.crease_angle.map(Angle::radians);
        let weighted = |weights, plain| match crease_angle {
            Some(angle) => VertexNormals::Creased { angle, weights },
            None => plain,
        };
        let (normals, word) = match &spec.normals {
            NormalsSpec::Angle => (weighted(NormalWeights::Angle, VertexNormals::AngleWeighted), "angle"),
            NormalsSpec::Sphere => (weighted(NormalWeights::Sphere, VertexNormals::SphereWeighted), "sphere"),
            NormalsSpec::File | NormalsSpec::Given(_) => {
                if crease_angle.is_some() {
                    return Err(self.unfit(
                        "`crease_angle` requires the normals \"angle\" or \"sphere\": given normals define creases where a vertex has several",
                    ));
                }
                let word = if spec.normals == NormalsSpec::File { "file" } else { "given" };
                (VertexNormals::GivenAtCorners(mesh.normals.as_deref().unwrap_or_default()), word)
            }
        };
        let surface = SmoothMesh::new(&mesh.points, &mesh.triangles, normals);
        let surface = surface.map_err(|e| self.refused_smooth(&given, &mesh, &e))?;
        if is_inside_out(&mesh) && surface.is_closed() {
            let message = "the triangles are clockwise seen from outside, so the surface is inside out".to_owned();
            self.remark("inside-out", None, None, given.file.clone(), message);
        }
        let warnings = surface.warnings().into_iter().map(|warning| in_given_numbers_warning(&mesh, warning));
        self.remarks.extend(warnings.map(|warning| Remark { place: given.file.clone(), ..warning.into() }));
        let polygons = given.mesh.faces.len();
        self.facts = Facts::SmoothMesh(SmoothChoice { normals: word, crease_angle, polygons });
        Ok(vec![surface.into()])
    }

    fn polygons(&mut self, spec: &SmoothMeshSpec) -> Result<Given> {
        let mut given = match (&spec.mesh, &spec.vertices, &spec.triangles) {
            (Some(file), None, None) => self.polygon_file(file)?,
            (None, Some(vertices), Some(triangles)) => self.listed_polygons(vertices, triangles, "triangles")?,
            _ => {
                return Err(self.unfit("a mesh requires either `mesh` (a file), or `vertices` with `triangles`"));
            }
        };
        match (&spec.normals, &spec.mesh) {
            (NormalsSpec::Given(_), Some(_)) => {
                return Err(
                    self.unfit("a list of `normals` requires `vertices`: for the normals of a file use \"file\"")
                );
            }
            (NormalsSpec::Given(normals), None) => {
                let (given_count, needed) = (normals.len(), given.mesh.points.len());
                if given_count != needed {
                    let error = KernelError::Number(NumberError::CountDiffers {
                        what: ErrorItem::Normal,
                        given: given_count,
                        needed,
                    });
                    return Err(self.refused_at(["normals".into()], &error));
                }
                given.mesh.normals = normals.iter().map(|n| n.vector()).collect();
                given.mesh.corner_normals.clone_from(&given.mesh.faces);
                given.lists_normals = true;
            }
            (NormalsSpec::File, file) if given.mesh.corner_normals.is_empty() => {
                let why = match file {
                    None => "there is no file: list a normal for each of `vertices`, or use \"angle\" or \"sphere\"",
                    Some(file) => file.format.entry().without_normals,
                };
                return Err(Error::Input(self.diagnostic(["normals".into()], why)));
            }
            _ => {}
        }
        Ok(given)
    }

    pub(in crate::document) fn polygon_file(&mut self, file: &PolygonMeshFile) -> Result<Given> {
        let (name, mesh) = self.mesh_of_file(file)?;
        let shared = file.format.entry().shares_vertices;
        Ok(Given { mesh, file: Some(name), field: "mesh", shared, lists_normals: false })
    }

    /// Polygons by the numbers of their vertices in a field.
    pub(in crate::document) fn listed_polygons(
        &self,
        vertices: &[Coordinates],
        faces: &[impl AsRef<[u32]>],
        field: &'static str,
    ) -> Result<Given> {
        let count = vertices.len();
        let numbers = |face: &[u32]| face.iter().map(|v| *v as usize).collect();
        let faces: Vec<Vec<usize>> = faces.iter().map(|face| numbers(face.as_ref())).collect();
        for (index, face) in faces.iter().enumerate() {
            if let Some(place) = face.iter().position(|v| *v >= count) {
                let error = KernelError::Mesh(MeshError::NoSuchVertex { triangle: index, vertex: face[place], count });
                return Err(self.refused_at([field.into(), index.into(), place.into()], &error));
            }
        }
        let mesh =
            PolygonMesh { points: vertices.iter().map(|p| p.point()).collect(), faces, ..PolygonMesh::default() };
        Ok(Given { mesh, file: None, field, shared: true, lists_normals: false })
    }

    /// Says what was changed between the file and the triangles.
    pub(in crate::document) fn remark_on_mesh(&mut self, given: &Given, mesh: &TriangleMesh) {
        let place = given.file.clone();
        let (cut, collapsed) = (mesh.cut, mesh.collapsed);
        if cut.count > 0 {
            let message = format!("{} polygons with more than three corners are divided into triangles", cut.count);
            self.remark("polygons-cut", None, Some(cut.first), place.clone(), message);
        }
        if collapsed.count > 0 {
            let message = format!("{} polygons are ignored: they have at most two distinct corners", collapsed.count);
            self.remark("polygons-without-area", None, Some(collapsed.first), place.clone(), message);
        }
        if mesh.turned.count > 0 {
            let first = mesh.turned.first;
            let number = || format!("number {first}");
            let line = given.mesh.lines.get(first).map_or_else(number, |line| format!("in line {line}"));
            let message = turned_faces(mesh.turned.count, &line);
            self.remark("faces-turned", None, Some(mesh.turned.first), place.clone(), message);
        }
        // In STL and GLB vertices stand once for every triangle, or for every normal.
        if mesh.merged > 0 && given.shared {
            self.remark("vertices-merged", None, None, place.clone(), merged_vertices(mesh.merged));
        }
        if mesh.unused > 0 {
            let message = format!("{} vertices belong to no triangle and are ignored", mesh.unused);
            self.remark("vertices-unused", None, None, place, message);
        }
    }

    /// The message for polygons that do not make a mesh.
    pub(in crate::document) fn bad_polygons(&self, given: &Given, bad: BadPolygons) -> Error {
        let (reason, polygon, message) = match bad {
            BadPolygons::Uncut { polygon, corners } => {
                let message = format!(
                    "polygon {polygon} with {corners} corners cannot be divided into triangles: it intersects itself, is not nearly plane, or has more than 256 corners"
                );
                ("polygon-not-simple", polygon, message)
            }
            BadPolygons::Doubled(doubled) => {
                let [first, second] = doubled.faces;
                let name = |face: usize| match given.mesh.lines.get(face) {
                    Some(line) => format!("the face in line {line}"),
                    None => format!("face {face}"),
                };
                let message = format!("{} has the same vertices as {}{}", name(second), name(first), doubled.remedy());
                ("doubled-face", second, message)
            }
        };
        match &given.file {
            Some(file) => self.refused_in_words([given.field.into()], reason, format!("{message} (of {file})")),
            None => self.refused_in_words([given.field.into(), polygon.into()], reason, message),
        }
    }

    /// The message for what the kernel said about the mesh, in the numbers of the file.
    fn refused_smooth(&self, given: &Given, mesh: &TriangleMesh, error: &KernelError) -> Error {
        let (error, triangle, vertices) = in_given_numbers(mesh, error.clone());
        let field = match (&error, &given.file) {
            (KernelError::Number(NumberError::AngleOutOfRange { .. }), _) => "crease_angle",
            (KernelError::Number(NumberError::NotFinite { what: ErrorItem::Normal, .. }), _) => "normals",
            (KernelError::Mesh(MeshError::UndefinedNormal { .. }), None) if given.lists_normals => "normals",
            _ => given.field,
        };
        let mut words = error.to_string();
        if field == "mesh" {
            let at = |k: &usize| mesh.points[*k].to_array().map(|x| ShortNumber(x).to_string()).join(", ");
            let places: Vec<String> = vertices.iter().map(|k| format!("({})", at(k))).collect();
            let of = given.file.as_deref().unwrap_or_default();
            words += &if places.is_empty() {
                format!(" (of {of})")
            } else {
                format!(" (of {of}, at {})", places.join(" and "))
            };
        }
        let mut steps: Vec<Step> = vec![field.into()];
        match (triangle, &error) {
            (Some(triangle), _) if field == "triangles" => steps.push(triangle.into()),
            (_, &KernelError::Mesh(MeshError::UndefinedNormal { vertex, .. })) if field == "normals" => {
                steps.push(vertex.into())
            }
            _ => {}
        }
        if self.document.text.is_empty() {
            return self.refused_at(steps, &error);
        }
        self.refused_in_words(steps, error.reason(), words)
    }
}

/// What is said of vertices that became one with another.
pub(in crate::document) fn merged_vertices(count: usize) -> String {
    format!("{count} vertices coincide with another and were merged")
}

/// What is said of faces that were turned over.
pub(in crate::document) fn turned_faces(count: usize, first: &str) -> String {
    format!(
        "{count} face(s) have the opposite orientation to most of their neighbors and were reversed; the first is {first}"
    )
}

/// Whether the triangles enclose a negative volume.
fn is_inside_out(mesh: &TriangleMesh) -> bool {
    let Some(&apex) = mesh.points.first() else { return false };
    let corners = mesh.triangles.iter().map(|t| t.map(|v| mesh.points[v] - apex));
    corners.map(|[a, b, c]| a.dot(b.cross(c))).sum::<f64>() < 0.0
}

/// The error in the numbers of the polygons and vertices as given, with the polygon and the kernel's vertices that it names.
fn in_given_numbers(mesh: &TriangleMesh, error: KernelError) -> (KernelError, Option<usize>, Vec<usize>) {
    use KernelError as E;
    let polygon = |triangle: usize| mesh.polygons.get(triangle).copied().unwrap_or(triangle);
    let given = |vertex: usize| mesh.vertices.get(vertex).copied().unwrap_or(vertex);
    let corners = |triangle: usize| mesh.triangles.get(triangle).map_or(Vec::new(), |t| t.to_vec());
    match error {
        E::Part(PartError::InTriangle { triangle, cause }) => (
            E::Part(PartError::InTriangle { triangle: polygon(triangle), cause }),
            Some(polygon(triangle)),
            corners(triangle),
        ),
        E::Mesh(MeshError::NonManifoldEdge { vertices, triangle, count }) => {
            let error = E::Mesh(MeshError::NonManifoldEdge {
                vertices: vertices.map(given),
                triangle: polygon(triangle),
                count,
            });
            (error, Some(polygon(triangle)), vertices.to_vec())
        }
        E::Mesh(MeshError::InconsistentOrientation { vertices, triangles }) => {
            let error = E::Mesh(MeshError::InconsistentOrientation {
                vertices: vertices.map(given),
                triangles: triangles.map(polygon),
            });
            (error, Some(polygon(triangles[1])), vertices.to_vec())
        }
        E::Mesh(MeshError::UndefinedNormal { vertex, length, limit }) => {
            (E::Mesh(MeshError::UndefinedNormal { vertex: given(vertex), length, limit }), None, vec![vertex])
        }
        other => (other, None, Vec::new()),
    }
}

/// The warning in the numbers of the polygons and vertices as given.
fn in_given_numbers_warning(mesh: &TriangleMesh, warning: Warning) -> Warning {
    let given = |vertex: usize| mesh.vertices.get(vertex).copied().unwrap_or(vertex);
    match warning {
        Warning::Mesh(MeshWarning::NormalFacesBackward { triangle, vertex, count }) => {
            Warning::Mesh(MeshWarning::NormalFacesBackward {
                triangle: mesh.polygons[triangle],
                vertex: mesh.vertices[vertex],
                count,
            })
        }
        Warning::Mesh(MeshWarning::FoldsBack { vertices, triangle, angle, count }) => {
            Warning::Mesh(MeshWarning::FoldsBack {
                vertices: vertices.map(given),
                triangle: mesh.polygons[triangle],
                angle,
                count,
            })
        }
        Warning::Mesh(MeshWarning::SharpEdgesSmoothed { vertices, angle, count, limit }) => {
            Warning::Mesh(MeshWarning::SharpEdgesSmoothed { vertices: vertices.map(given), angle, count, limit })
        }
        Warning::Mesh(MeshWarning::LooseBorders { vertices, count, borders, gap }) => {
            Warning::Mesh(MeshWarning::LooseBorders { vertices: vertices.map(given), count, borders, gap })
        }
        other => other,
    }
}
