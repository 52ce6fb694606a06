//! Nets and whole cyclides, field by field.

use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::circular::MakeCircularSpec;
use super::comment::Comment;
use crate::document::coordinates::Coordinates;

/// A whole Dupin cyclide by its three parameters: the points with
/// `(|p|^2 + b^2 - mu^2)^2 = 4 (a x - c mu)^2 + 4 b^2 y^2`, `b^2 = a^2 - c^2`. `c = 0` is the torus with radii a, mu.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"r": {"type": "cyclide", "a": 3, "mu": 1}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[0].bodies[0].outer.area() - 12.0 * std::f64::consts::PI.powi(2)).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CyclideSpec {
    /// The word `cyclide`.
    #[schemars(with = "String", extend("const" = "cyclide"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Half the long axis of the ellipse of centres.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub a: f64,
    /// Distance of its foci from the centre, less than `a`. A ring has c < mu < a.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub c: f64,
    /// The mean radius of the tube.
    #[schemars(range(min = 0.0))]
    pub mu: f64,
    /// Where the centre is. Default: the origin.
    pub center: Option<Coordinates>,
    /// Direction across the ring (of z above), of any length. Default `[0, 0, 1]`.
    pub axis: Option<Coordinates>,
    /// Direction of the long axis (of x above), perpendicular to `axis`, of any length. Default `[1, 0, 0]`, or for
    /// another axis the direction nearest to it.
    pub x_direction: Option<Coordinates>,
    /// Patches round the hole and round the tube, odd numbers rounded up. Default `[4, 4]`.
    #[schemars(inner(range(min = 3, max = 4096)))]
    pub segments: Option<[u32; 2]>,
}

/// A smooth surface of patches over a grid of points: neighbouring patches share their circular edge and their normals
/// along it. The four corners of every quad must be on one circle: `make_circular` sees to it.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": [[[0, 1, 0], [1, 1, 0], [3, 1, 0]], [[0, 0, 1], [1, 0, 1], [3, 0, 1]]]}}}"#.parse()?;
/// let built = document.build()?;
/// let shell = &built[0].bodies[0].outer;
/// assert!(shell.faces().len() == 2 && cyclide::surface_joints(shell).iter().all(|joint| joint.angle < 1e-12));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CyclidicNetSpec {
    /// The word `cyclidic-net`.
    #[schemars(with = "String", extend("const" = "cyclidic-net"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The vertices.
    pub grid: GridSource,
    /// Quads that stay open, as pairs of column and row from 0 (s first): their corners are part of the net, which runs on smoothly
    /// round them, but they have no patch. Of an open grid.
    #[serde(default)]
    pub openings: Vec<[u32; 2]>,
    /// Whether the grid is closed along s (the last column joins the first) and along t (the last row joins the first). Do not
    /// repeat the first points. Default: open. For a grid inline only.
    pub closed: Option<[bool; 2]>,
    /// The frame from which all others follow: `"auto"`, or the directions of growing s and t at the first vertex. In a
    /// grid from a file s runs from the first to the second corner of the first face and t from the first to the fourth;
    /// the first vertex is reached from the first corner back along s, then back along t.
    #[serde(default)]
    pub frame: FrameSpec,
    /// Move the vertices so that the corners of every quad are on one circle, and closed directions close.
    #[serde(default)]
    pub make_circular: MakeCircularSpec,
}

/// Where the vertices of a net come from.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": [[[0, 1, 0], [1, 1, 0], [3, 1, 0]], [[0, 0, 1], [1, 0, 1], [3, 0, 1]]]}}}"#.parse()?;
/// let built = document.build()?;
/// let shell = &built[0].bodies[0].outer;
/// assert!(shell.faces().len() == 2 && cyclide::surface_joints(shell).iter().all(|joint| joint.angle < 1e-12));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Grid")]
pub enum GridSource {
    /// Rows of points: s grows along a row, t from row to row. All rows have equally many. `null` stands where there is no point:
    /// the border of an open grid may run in steps.
    Rows(#[schemars(length(min = 2))] Vec<Vec<Option<Coordinates>>>),
    /// A mesh of quads in a file of its own.
    File(MeshFile),
    /// A grid that another object lays along the lines of curvature of a mesh.
    Laid(LaidGrid),
}

/// A grid of a `principal-grid`.
///
/// ```
/// use cyclide_io::{Document, GridSource, LaidGrid, ObjectSpec};
/// let text = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": {"of": "lattice", "piece": 1}}}}"#;
/// let document = Document::parse("n.json", text.as_bytes())?;
/// let ObjectSpec::CyclidicNet(net) = &document.objects[0].1 else { unreachable!("the type says so") };
/// assert_eq!(net.grid, GridSource::Laid(LaidGrid { of: "lattice".to_owned(), piece: Some(1) }));
/// # Ok::<(), Box<cyclide_io::Diagnostic>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LaidGrid {
    /// The name of a `principal-grid`.
    pub of: String,
    /// Which of its grids, from 0. Default: the first one, the largest; of grids that are `joined` round umbilics all together.
    pub piece: Option<u32>,
}

/// A mesh of quads in a file of its own.
///
/// ```
/// use cyclide_io::{Document, ModelBuilder};
/// use std::path::Path;
/// let text = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": {"obj": "roof.obj"}}}}"#;
/// let document: Document = text.parse()?;
/// let quads = b"v 0 1 0\nv 1 1 0\nv 1 0 1\nv 0 0 1\nf 1 2 3 4\n";
/// let built = ModelBuilder::new(&document, Path::new(""), &|_| Ok(quads.to_vec()))?.build(0, &mut |_| ())?;
/// assert_eq!(built.bodies[0].outer.faces().len(), 1);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshFile {
    /// Path of the Wavefront OBJ file, relative to the document: a regular grid of quads, open or closed, with a border in steps or
    /// straight.
    pub obj: String,
}

/// The fields of both kinds of grid that are no rows.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct GridFields {
    obj: Option<String>,
    of: Option<String>,
    piece: Option<u32>,
}

impl<'de> Deserialize<'de> for GridSource {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct GridVisitor;
        impl<'de> serde::de::Visitor<'de> for GridVisitor {
            type Value = GridSource;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("rows of points `[[[x, y, z], …], …]` (`null` where there is none), `{\"obj\": \"FILE\"}` or `{\"of\": \"NAME\"}`")
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, seq: A) -> Result<GridSource, A::Error> {
                Vec::deserialize(serde::de::value::SeqAccessDeserializer::new(seq)).map(GridSource::Rows)
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<GridSource, A::Error> {
                let fields = GridFields::deserialize(serde::de::value::MapAccessDeserializer::new(map))?;
                match fields {
                    GridFields { obj: Some(obj), of: None, piece: None } => Ok(GridSource::File(MeshFile { obj })),
                    GridFields { obj: None, of: Some(of), piece } => Ok(GridSource::Laid(LaidGrid { of, piece })),
                    _ => Err(serde::de::Error::custom(
                        "a grid is `{\"obj\": \"FILE\"}` or `{\"of\": \"NAME\"}`, the latter with `piece` or without",
                    )),
                }
            }
        }
        deserializer.deserialize_any(GridVisitor)
    }
}

/// The frame of a net: `auto`, or two directions.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": [[[0, 1, 0], [1, 1, 0], [3, 1, 0]], [[0, 0, 1], [1, 0, 1], [3, 0, 1]]], "frame": "auto"}}}"#.parse()?;
/// let built = document.build()?;
/// let shell = &built[0].bodies[0].outer;
/// assert!(shell.faces().len() == 2 && cyclide::surface_joints(shell).iter().all(|joint| joint.angle < 1e-12));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, JsonSchema)]
#[schemars(untagged, rename = "Frame")]
#[non_exhaustive]
pub enum FrameSpec {
    /// The frame that follows the edges of the whole net best.
    #[default]
    #[schemars(with = "AutoWord")]
    Auto,
    /// Directions of growing s and t at the first vertex: perpendicular, of any length.
    First([Coordinates; 2]),
}

/// The word for a frame that is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[schemars(inline)]
enum AutoWord {
    /// The frame that follows the edges of the whole net best.
    #[serde(rename = "auto")]
    Auto,
}

impl<'de> Deserialize<'de> for FrameSpec {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct FrameVisitor;
        impl<'de> serde::de::Visitor<'de> for FrameVisitor {
            type Value = FrameSpec;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("\"auto\" or two directions `[[x, y, z], [x, y, z]]`")
            }
            fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<FrameSpec, E> {
                AutoWord::deserialize(serde::de::value::StrDeserializer::new(word)).map(|_| FrameSpec::Auto)
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, seq: A) -> Result<FrameSpec, A::Error> {
                let seq = serde::de::value::SeqAccessDeserializer::new(seq);
                <[Coordinates; 2]>::deserialize(seq).map(FrameSpec::First)
            }
        }
        deserializer.deserialize_any(FrameVisitor)
    }
}
