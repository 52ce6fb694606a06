//! Grids of blocks, and the cells that blocks are divided into, field by field.

use cyclide::FineEnd;
use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use super::nets::FrameSpec;
use crate::document::coordinates::Coordinates;

/// Blocks in a grid, neighbours of which share faces, vertices and parameters: from points on three coordinate planes, or between parallel Dupin cyclides,
/// closed in both directions.
///
/// ```
/// use cyclide_io::Document;
/// let tube = r#""tube": {"type": "cyclide-grid", "whole": {"a": 4, "c": 1, "mu": [1.5, 1.8, 2], "segments": [8, 6]}, "cells": 4}"#;
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{tube}}}}}"#).parse::<Document>()?.build()?;
/// assert_eq!(built[0].item.volumes().len(), 8 * 6 * 2);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CyclideGridSpec {
    /// The word `cyclide-grid`.
    #[schemars(with = "String", extend("const" = "cyclide-grid"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Points on three coordinate planes. Or `whole`.
    pub planes: Option<CoordinatePlanesSpec>,
    /// With `planes`: the directions of growing s and t at the first vertex, perpendicular and of any length; that of u is perpendicular to both, on the
    /// side of the third side. `"auto"`, the
    /// default, takes the frame of a `cyclide-volume` there.
    pub frame: Option<FrameSpec>,
    /// The space between parallel cyclides.
    pub whole: Option<WholeCyclideSpec>,
    /// How every block is divided into cells: for VTU of cells, `report` and `sample`.
    pub cells: Option<CellsSpec>,
}

/// Points on the three planes on which one of the indices along s, t, u is 0: every quad has its corners on one circle. All other points follow.
///
/// ```
/// use cyclide_io::Document;
/// let planes = r#"{"st": [[[0,0,0], [1,0,0], [3,0,0]], [[0,1,0], [1,1,0], [3,1,0]]],
///     "su": [[[0,0,0], [1,0,0], [3,0,0]], [[0,0,2], [1,0,2], [3,0,2]]], "tu": [[[0,0,0], [0,1,0]], [[0,0,2], [0,1,2]]]}"#;
/// let built = format!(r#"{{"cyclide": 1, "objects": {{"g": {{"type": "cyclide-grid", "planes": {planes}}}}}}}"#).parse::<Document>()?.build()?;
/// assert_eq!(built[0].item.volumes().len(), 2);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CoordinatePlanesSpec {
    /// Rows of points of the plane u = 0: s grows along a row, t from row to row.
    #[schemars(length(min = 2))]
    pub st: Vec<Vec<Coordinates>>,
    /// Rows of points of the plane t = 0: s grows along a row, u from row to row. Its first row is that of `st`.
    #[schemars(length(min = 2))]
    pub su: Vec<Vec<Coordinates>>,
    /// Rows of points of the plane s = 0: t grows along a row, u from row to row. Its first row is the first column of `st`, its first column that of `su`.
    #[schemars(length(min = 2))]
    pub tu: Vec<Vec<Coordinates>>,
}

/// A whole Dupin cyclide and its parallels, as of a [`CyclideSpec`](super::CyclideSpec).
///
/// ```
/// use cyclide_io::Document;
/// let wall = r#""w": {"type": "cyclide-grid", "whole": {"a": 3, "mu": [0.5, 1]}}"#;
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{wall}}}}}"#).parse::<Document>()?.build()?;
/// let volume: f64 = built[0].item.volumes().iter().map(|block| block.measure().volume).sum();
/// assert!((volume - 1.5 * std::f64::consts::PI.powi(2) * 3.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct WholeCyclideSpec {
    /// Half the long axis of the ellipse of centres.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub a: f64,
    /// Distance of its foci from the centre, less than `a`. Default 0: tori.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub c: f64,
    /// Mean radii of the tubes between which there are blocks, rising: u grows outwards. A ring has c < mu < a. Where the last one is a spindle (mu > a), or the first
    /// one a horn (mu < c), blocks lie along its outer part, from node to node.
    #[schemars(length(min = 2), inner(range(min = 0.0)))]
    pub mu: Vec<f64>,
    /// Where the centre is. Default: the origin.
    pub center: Option<Coordinates>,
    /// Direction across the ring, of any length. Default `[0, 0, 1]`.
    pub axis: Option<Coordinates>,
    /// Direction of the long axis, perpendicular to `axis`, of any length. Default `[1, 0, 0]`, or for another axis the direction nearest to it.
    pub x_direction: Option<Coordinates>,
    /// Blocks round the hole and round the tube, odd numbers rounded up. Default `[4, 4]`.
    #[schemars(inner(range(min = 3, max = 4096)))]
    pub segments: Option<[u32; 2]>,
}

/// How blocks are divided into cells: a number for all three directions, or numbers or laws along s, t and u.
///
/// ```
/// use cyclide_io::{Document, GeometryReport, ObjectReport};
/// let cells = r#"[4, 2, {"count": 10, "first": 0.01, "fine": "end"}]"#;
/// let wall = format!(r#""w": {{"type": "cyclide-grid", "whole": {{"a": 3, "mu": [0.5, 1]}}, "cells": {cells}}}"#);
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{wall}}}}}"#).parse::<Document>()?.build()?;
/// let GeometryReport::Volume(report) = ObjectReport::new(&built[0], None).geometry else { unreachable!("by its type") };
/// let cells = report.cells.ok_or("it has cells")?;
/// assert!(cells.divisions == [4, 2, 10] && (cells.shortest_side - 0.01).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Cells")]
#[non_exhaustive]
pub enum CellsSpec {
    /// So many equal cells along s, t and u.
    Count(#[schemars(range(min = 1, max = 4096))] u32),
    /// Those along s, along t and along u.
    Along(Box<[CellsAlongSpec; 3]>),
}

impl<'de> Deserialize<'de> for CellsSpec {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct CellsVisitor;
        impl<'de> serde::de::Visitor<'de> for CellsVisitor {
            type Value = CellsSpec;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number of cells, or three, each a number or `{\"count\": N, …}`")
            }
            fn visit_u64<E: serde::de::Error>(self, count: u64) -> Result<CellsSpec, E> {
                count_of(count).map(CellsSpec::Count)
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, _: A) -> Result<CellsSpec, A::Error> {
                Err(serde::de::Error::custom(
                    "one law alone: `cells` along s, t and u are a list of three, as in [8, 8, {\"count\": 20, \"first\": 0.01}]",
                ))
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, seq: A) -> Result<CellsSpec, A::Error> {
                let seq = serde::de::value::SeqAccessDeserializer::new(seq);
                <[CellsAlongSpec; 3]>::deserialize(seq).map(|along| CellsSpec::Along(Box::new(along)))
            }
        }
        deserializer.deserialize_any(CellsVisitor)
    }
}

/// The cells along one direction: a number, or a number and a law.
///
/// ```
/// use cyclide_io::Document;
/// let wall = r#""w": {"type": "cyclide-grid", "whole": {"a": 3, "mu": [0.5, 1]}, "cells": [4, 2, {"count": 4, "ratio": 1.5}]}"#;
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{wall}}}}}"#).parse::<Document>()?.build()?;
/// let places = built[0].provenance.places.as_ref().ok_or("it has cells")?;
/// assert!((places[2][1] - 1.0 / (1.0 + 1.5 + 2.25 + 3.375)).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "CellsAlong")]
#[non_exhaustive]
pub enum CellsAlongSpec {
    /// So many equal cells.
    Count(#[schemars(range(min = 1, max = 4096))] u32),
    /// Cells of different lengths.
    Graded(GradedCellsSpec),
}

impl<'de> Deserialize<'de> for CellsAlongSpec {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct AlongVisitor;
        impl<'de> serde::de::Visitor<'de> for AlongVisitor {
            type Value = CellsAlongSpec;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number of cells, or `{\"count\": N, …}`")
            }
            fn visit_u64<E: serde::de::Error>(self, count: u64) -> Result<CellsAlongSpec, E> {
                count_of(count).map(CellsAlongSpec::Count)
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<CellsAlongSpec, A::Error> {
                let map = serde::de::value::MapAccessDeserializer::new(map);
                GradedCellsSpec::deserialize(map).map(CellsAlongSpec::Graded)
            }
        }
        deserializer.deserialize_any(AlongVisitor)
    }
}

fn count_of<E: serde::de::Error>(count: u64) -> Result<u32, E> {
    u32::try_from(count).map_err(|_| E::custom(format!("{count} cells are too many")))
}

/// Cells of different lengths along one direction: one of `ratio`, `stretch` and `first`.
///
/// ```
/// use cyclide_io::{CellLaw, Document};
/// let law = r#"{"count": 12, "law": "tanh", "first": 0.01, "fine": "both"}"#;
/// let wall = format!(r#""w": {{"type": "cyclide-grid", "whole": {{"a": 3, "mu": [0.5, 1]}}, "cells": [4, 2, {law}]}}"#);
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{wall}}}}}"#).parse::<Document>()?.build()?;
/// let places = built[0].provenance.places.as_ref().ok_or("it has cells")?;
/// assert!((places[2][1] - 0.02).abs() < 1e-9 && (places[2][11] - 0.98).abs() < 1e-9); // of half a unit
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct GradedCellsSpec {
    /// How many cells.
    #[schemars(range(min = 1, max = 4096))]
    pub count: u32,
    /// Law of their lengths. Default: `geometric` with `ratio` or `first`, `tanh` with `stretch`, `uniform` with none of these.
    pub law: Option<CellLaw>,
    /// Of `geometric`: the length of a cell over that of the one before, counted from the fine end. 0.001 to 1000.
    #[schemars(range(min = 0.001, max = 1000.0))]
    pub ratio: Option<f64>,
    /// Of `tanh`: how uneven cells are, 0 to 20.
    #[schemars(range(min = 0.0, max = 20.0))]
    pub stretch: Option<f64>,
    /// Length of the cell at the fine end: no side of a block is longer there. Ratio or stretch follow.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub first: Option<f64>,
    /// At which end of the direction cells are fine: `start` (default), `end` or `both`.
    #[serde(default)]
    pub fine: FineEnd,
}

/// Laws of the lengths of cells.
///
/// ```
/// use cyclide_io::CellLaw;
/// let law: CellLaw = serde_json::from_str(r#""tanh""#)?;
/// assert_eq!(law, CellLaw::Tanh);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum CellLaw {
    /// Equal cells.
    Uniform,
    /// By a constant ratio of neighbours.
    Geometric,
    /// By hyperbolic tangents: the ratio of neighbours changes slowly.
    Tanh,
}
