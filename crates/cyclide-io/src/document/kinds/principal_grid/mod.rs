//! Regular grids along the lines of curvature of a surface.

mod heights;
mod lay;
mod nurbs_surface;
mod surface_sources;

use cyclide_grids::{GridBorder, UmbilicRule};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::polygon_mesh_file::PolygonMeshFile;
use crate::document::objects::kind::{Kind, Shape};
use crate::document::objects::{Builder, BuiltObject};
use crate::error::Result;

pub use surface_sources::*;

/// Regular grids along the lines of curvature of a surface. A `cyclidic-net` with `make_circular` follows such a grid
/// without losing the shape; it takes a grid by name: `"grid": {"of": NAME}`. The object itself consists of the lines
/// of its grids.
///
/// The surface is a mesh in a file (`mesh`), or given by `vertices` and `faces`, a B-spline surface (`nurbs`), or a
/// grid of `heights`. It is one piece with a border: a roof, with or without holes, or a tube.
///
/// ```
/// let place = |k: usize| [0.5 * (k % 17) as f64, 0.5 * (k / 17) as f64];
/// let vertices: Vec<[f64; 3]> = (0..289).map(place).map(|[x, y]| [x, y, 0.05 * (x - 4.0) * (y - 4.0)]).collect();
/// let faces: Vec<[usize; 4]> = (0..256).map(|k| k / 16 * 17 + k % 16).map(|a| [a, a + 1, a + 18, a + 17]).collect();
/// let grid = format!(r#"{{"type": "principal-grid", "vertices": {vertices:?}, "faces": {faces:?}, "edge_length": 0.7}}"#);
/// let net = r#"{"type": "cyclidic-net", "grid": {"of": "g"}, "make_circular": true}"#;
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"g": {grid}, "n": {net}}}}}"#);
/// let built = text.parse::<cyclide_io::Document>()?.build()?;
/// assert!(built[0].item.grids().is_some_and(|laid| laid.grids().len() == 1) && built[1].bodies[0].outer.faces().len() > 20);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    { "required": ["mesh"], "properties": { "vertices": false, "faces": false, "nurbs": false, "heights": false } },
    { "required": ["vertices", "faces"], "properties": { "mesh": false, "nurbs": false, "heights": false } },
    { "required": ["nurbs"], "properties": { "mesh": false, "vertices": false, "faces": false, "heights": false } },
    { "required": ["heights"], "properties": { "mesh": false, "vertices": false, "faces": false, "nurbs": false } }
]))]
#[non_exhaustive]
pub struct PrincipalGridSpec {
    /// The word `principal-grid`.
    #[schemars(with = "String", extend("const" = "principal-grid"))]
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
    /// The faces: lists of vertex numbers from 0, counter-clockwise seen from one side.
    #[schemars(length(min = 1), inner(length(min = 3)))]
    pub faces: Option<Vec<Vec<u32>>>,
    /// A B-spline surface. The mesh over it has edges half as long as those of the grid.
    pub nurbs: Option<NurbsSurfaceSpec>,
    /// Heights over a grid in the plane z = 0.
    pub heights: Option<HeightsSpec>,
    /// Mean length of the edges of the grid; edges of the mesh should not be longer.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub edge_length: f64,
    /// What happens at umbilics, where the surface bends equally in all directions. Default: `pieces`; `joined` if that
    /// covers more and `pieces` less than 90 %, unless a `border` is given that does not run in steps.
    pub umbilics: Option<UmbilicRule>,
    /// How far the grid extends. Default: `inside`; `staircase` if that covers more and `inside` less than 90 %.
    pub border: Option<GridBorder>,
    /// Whether a tube gets a grid that is closed along s. Default: yes, unless its lines of curvature are spirals that
    /// return higher by more than an edge; `true`: even then.
    pub closed: Option<bool>,
    /// Number of columns of a closed grid. Default: from the edge length.
    #[schemars(range(min = 3, max = 10000))]
    pub columns: Option<u32>,
    /// Largest number of grids to lay, the largest first. Default: 1, or 4 if the surface is cut at umbilics.
    #[schemars(range(min = 1, max = 4))]
    pub most_pieces: Option<u32>,
    /// Whether noise of the vertices is smoothed first. Default: if it is more than a thousandth of an edge.
    pub denoise: Option<bool>,
}

impl PrincipalGridSpec {
    /// The file of the surface, as the document writes it.
    pub(in crate::document) fn file(&self) -> Option<&str> {
        let heights = || self.heights.as_ref().and_then(|heights| heights.csv.as_deref());
        self.mesh.as_ref().map(|file| file.path.as_str()).or_else(heights)
    }
}

impl Kind for PrincipalGridSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.principal_grid(self).map(|laid| Shape::Grids(Box::new(laid)))
    }

    fn files(&self) -> Vec<&str> {
        self.file().into_iter().collect()
    }

    fn has_panels(&self, _: Option<&BuiltObject>) -> bool {
        true
    }
}
