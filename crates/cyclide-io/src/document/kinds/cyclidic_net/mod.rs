//! A smooth surface of patches over a grid of points.

pub(in crate::document) mod build;
mod circular;
mod hints;
mod layouts;
mod make_circular;

use cyclide::topology::Body;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::frame::FrameSpec;
use crate::document::locate::Step;
use crate::document::objects::kind::{Kind, Reference, Shape};
use crate::document::objects::{Builder, BuiltObject};
use crate::error::Result;

pub use make_circular::*;

/// A smooth surface of patches over a grid of points. Neighboring patches share their circular edge and the normals
/// along it. The four corners of every quad must lie on one circle; `make_circular` moves the vertices so that they do.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": [[[0, 1, 0], [1, 1, 0], [3, 1, 0]], [[0, 0, 1], [1, 0, 1], [3, 0, 1]]]}}}"#.parse()?;
/// let built = document.build()?;
/// let shell = &built[0].bodies[0].outer;
/// assert!(shell.faces().len() == 2 && cyclide::topology::surface_joints(shell).iter().all(|joint| joint.angle < 1e-12));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CyclidicNetSpec {
    /// The word `cyclidic-net`.
    #[schemars(with = "String", extend("const" = "cyclidic-net"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The vertices.
    pub grid: GridSource,
    /// Quads that stay open, as pairs of column and row from 0 (s first), for open grids only. Their corners are part
    /// of the net, which continues smoothly around them, but they have no patch.
    #[serde(default)]
    pub openings: Vec<[u32; 2]>,
    /// Whether the grid is closed along s (the last column joins the first) and along t (the last row joins the first),
    /// for inline grids only; do not repeat the first points. Default: open.
    pub closed: Option<[bool; 2]>,
    /// The frame that determines all others: `"auto"` (default), or the directions of increasing s and t at the first
    /// vertex. In a grid from a file s runs from the first to the second corner of the first face and t from the first
    /// to the fourth; the first vertex is reached from the first corner back along s, then back along t.
    #[serde(default)]
    pub frame: FrameSpec,
    /// Move the vertices so that the corners of every quad lie on one circle and closed directions close. Default
    /// `false`.
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
/// assert!(shell.faces().len() == 2 && cyclide::topology::surface_joints(shell).iter().all(|joint| joint.angle < 1e-12));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Grid")]
pub enum GridSource {
    /// Rows of points: s increases along a row, t from row to row, and all rows have the same length. `null` marks a
    /// missing point: the border of an open grid may run in steps.
    Rows(#[schemars(length(min = 2))] Vec<Vec<Option<Coordinates>>>),
    /// A mesh of quads in a separate file.
    File(MeshFile),
    /// A grid that another object lays along the lines of curvature of a surface.
    Laid(LaidGrid),
}

/// A grid of a `principal-grid`.
///
/// ```
/// use cyclide_io::{Document, document::{ObjectSpec, kinds::{GridSource, LaidGrid}}};
/// let text = r#"{"cyclide": 1, "objects": {"n": {"type": "cyclidic-net", "grid": {"of": "lattice", "piece": 1}}}}"#;
/// let document = Document::parse("n.json", text.as_bytes())?;
/// let ObjectSpec::CyclidicNet(net) = &document.objects[0].1 else { unreachable!("the type says so") };
/// assert_eq!(net.grid, GridSource::Laid(LaidGrid { of: "lattice".to_owned(), piece: Some(1) }));
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LaidGrid {
    /// Name of a `principal-grid`.
    pub of: String,
    /// Number of one of its grids, from 0. Default: the first one, which is the largest; if grids are `joined` around
    /// umbilics, all of them together.
    pub piece: Option<u32>,
}

/// A mesh of quads in a separate file.
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
    /// Path of the Wavefront OBJ file, relative to the document: a grid of quads, open or closed, with a straight or
    /// stepped border, regular except at extraordinary vertices.
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
                        "a grid is `{\"obj\": \"FILE\"}` or `{\"of\": \"NAME\"}`, the latter optionally with `piece`",
                    )),
                }
            }
        }
        deserializer.deserialize_any(GridVisitor)
    }
}

impl Kind for CyclidicNetSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.net(self).map(Shape::Surfaces)
    }

    fn references(&self) -> Vec<Reference<'_>> {
        let sides = self.make_circular.border_curves().map(BorderCurves::sides).into_iter().flatten();
        let path = |field| vec![Step::from("make_circular"), Step::from("border"), Step::from(field)];
        let sides = sides.filter_map(|(field, name)| name.map(|name| (path(field), name)));
        // After the curves of the sides, which are counted.
        let grid = match &self.grid {
            GridSource::Laid(laid) => Some((vec![Step::from("grid"), Step::from("of")], laid.of.as_str())),
            _ => None,
        };
        sides.chain(grid).collect()
    }

    fn files(&self) -> Vec<&str> {
        if let GridSource::File(file) = &self.grid { vec![file.obj.as_str()] } else { Vec::new() }
    }

    fn has_panels(&self, _: Option<&BuiltObject>) -> bool {
        true
    }

    fn remark_on(&self, at: &mut Builder<'_>, shape: &Shape, bodies: &[Body]) {
        if let Shape::Surfaces(surfaces) = shape {
            at.warn_of_folds(self, surfaces, bodies);
            at.warn_of_seams(surfaces);
        }
    }
}
