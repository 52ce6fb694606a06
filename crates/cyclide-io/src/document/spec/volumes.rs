//! Volumes, field by field.

use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use super::grids::CellsSpec;
use super::nets::FrameSpec;
use crate::document::coordinates::Coordinates;

/// A block whose six faces are patches of Dupin cyclides, and so are all surfaces on which one of its three parameters is constant: they
/// cross at right angles everywhere.
///
/// ```
/// use cyclide_io::Document;
/// let corners = "[[0,0,0], [1,0.2,-0.1], [-0.2,1,0.1], [0.1,-0.1,0.9]]";
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"b": {{"type": "cyclide-volume", "corners": {corners}}}}}}}"#);
/// let built = text.parse::<Document>()?.build()?;
/// assert!(built[0].item.volumes().len() == 1 && built[0].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CyclideVolumeSpec {
    /// The word `cyclide-volume`.
    #[schemars(with = "String", extend("const" = "cyclide-volume"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Eight corners at (s, t, u) = 000, 100, 010, 110, 001, 101, 011, 111, of which the last may be left out, as it follows from the others: the
    /// four of each face on one circle. Or four: the first and its neighbours along s, t and u; the others are then found.
    #[schemars(length(min = 4, max = 8))]
    pub corners: Vec<Coordinates>,
    /// With four corners: where the last one is among the three neighbours of the first, as positive weights of these. Default: the squared lengths of the three
    /// sides, which give a cuboid where these are perpendicular.
    #[schemars(inner(range(min = 0.0)))]
    pub inside: Option<[f64; 3]>,
    /// With four corners: how far the corners between the neighbours are turned, from 0 to 1. Default 0.5.
    #[schemars(range(min = 0.0, max = 1.0))]
    pub turn: Option<f64>,
    /// The directions of growing s and t at the first corner, perpendicular and of any length; that of u is perpendicular to both, on the side of the
    /// third side. `"auto"`, the default, takes the frame nearest to the three sides, the more so the shorter they are, or one that makes more sides straight.
    #[serde(default)]
    pub frame: FrameSpec,
    /// How the block is divided into cells: for VTU of cells, `report` and `sample`.
    pub cells: Option<CellsSpec>,
}

/// Blocks in layers over a net: the spaces between its offsets, with lines across that are normal to all layers.
///
/// ```
/// use cyclide_io::Document;
/// let objects = r#""ring": {"type": "cyclide", "a": 3, "mu": 1}, "wall": {"type": "layers", "of": "ring", "distances": [-0.5, -0.1, 0]}"#;
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{objects}}}}}"#).parse::<Document>()?.build()?;
/// assert_eq!(built[1].item.volumes().len(), 32);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct LayersSpec {
    /// The word `layers`.
    #[schemars(with = "String", extend("const" = "layers"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of a patch, net or cyclide.
    pub of: String,
    /// Distances of the surfaces between layers along the normals, rising; 0 is the surface itself. Or `first`.
    #[schemars(length(min = 2))]
    pub distances: Option<Vec<f64>>,
    /// Height of the first layer, next to the surface; negative: layers on the other side. With `count`.
    pub first: Option<f64>,
    /// Each layer is so many times as high as the one before. Default 1.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub growth: Option<f64>,
    /// Number of layers.
    #[schemars(range(min = 1, max = 4096))]
    pub count: Option<u32>,
    /// How every block is divided into cells: for VTU of cells, `report` and `sample`.
    pub cells: Option<CellsSpec>,
}

/// Surfaces inside blocks on which one parameter is constant, as patches; or the outer boundary of all blocks as a solid.
///
/// ```
/// use cyclide_io::Document;
/// let block = r#""b": {"type": "cyclide-volume", "corners": [[0,0,0], [1,0.2,-0.1], [-0.2,1,0.1], [0.1,-0.1,0.9]]}"#;
/// let middle = r#""m": {"type": "coordinate-surfaces", "of": "b", "s": [0.5], "u": [0, 0.5]}"#;
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{block}, {middle}}}}}"#).parse::<Document>()?.build()?;
/// assert_eq!(built[1].item.surfaces().len(), 3);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CoordinateSurfacesSpec {
    /// The word `coordinate-surfaces`.
    #[schemars(with = "String", extend("const" = "coordinate-surfaces"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of an object of blocks.
    pub of: String,
    /// Values of s, from 0 to 1 in each block.
    #[serde(default)]
    #[schemars(inner(range(min = 0.0, max = 1.0)))]
    pub s: Vec<f64>,
    /// Values of t.
    #[serde(default)]
    #[schemars(inner(range(min = 0.0, max = 1.0)))]
    pub t: Vec<f64>,
    /// Values of u.
    #[serde(default)]
    #[schemars(inner(range(min = 0.0, max = 1.0)))]
    pub u: Vec<f64>,
    /// The outer boundary of all blocks, instead: the faces that belong to one block only, sewn to solids.
    #[serde(default)]
    pub outer: bool,
}
