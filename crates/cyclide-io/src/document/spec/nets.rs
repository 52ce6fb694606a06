//! Nets and whole cyclides, field by field.

use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use crate::document::coordinates::Coordinates;

/// A whole Dupin cyclide by its three parameters: the points with
/// `(|p|^2 + b^2 - mu^2)^2 = 4 (a x - c mu)^2 + 4 b^2 y^2`, `b^2 = a^2 - c^2`. `c = 0` is the torus with radii a, mu.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CyclideSpec {
    /// The word `cyclide`.
    #[schemars(with = "String", extend("const" = "cyclide"))]
    pub r#type: TypeWord,
    /// Helper geometry: built and reported, not written to files.
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
    /// Patches round the hole and round the tube. Default `[4, 4]`.
    #[schemars(with = "Option<[std::num::NonZeroU32; 2]>")]
    pub segments: Option<[u32; 2]>,
}

/// A smooth surface of patches over a grid of points: neighbouring patches share their circular edge and their normals
/// along it. The four corners of every quad must be on one circle: `make_circular` sees to it.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CyclidicNetSpec {
    /// The word `cyclidic-net`.
    #[schemars(with = "String", extend("const" = "cyclidic-net"))]
    pub r#type: TypeWord,
    /// Helper geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The vertices.
    pub grid: GridSource,
    /// Whether the grid is closed along s (the last column joins the first) and along t (the last row joins the first).
    /// Do not repeat the first points. Default: open. For a grid inline only.
    pub closed: Option<[bool; 2]>,
    /// The frame from which all others follow: `"auto"`, or the directions of growing s and t at the first vertex.
    #[serde(default)]
    pub frame: FrameSpec,
    /// Move the vertices a little so that the corners of every quad are on one circle.
    #[serde(default)]
    pub make_circular: MakeCircularSpec,
}

/// Where the vertices of a net come from.
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Grid")]
pub enum GridSource {
    /// Rows of points: s grows along a row, t from row to row. All rows have equally many.
    Rows(#[schemars(length(min = 2))] Vec<Vec<Coordinates>>),
    /// A mesh of quads in a file of its own.
    File(MeshFile),
}

/// A mesh of quads in a file of its own.
#[derive(Debug, Clone, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshFile {
    /// Path of the Wavefront OBJ file, relative to the document: a regular grid of quads, open or closed.
    pub obj: String,
}

impl<'de> Deserialize<'de> for GridSource {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct GridVisitor;
        impl<'de> serde::de::Visitor<'de> for GridVisitor {
            type Value = GridSource;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("rows of points `[[[x, y, z], …], …]`, or `{\"obj\": \"FILE\"}`")
            }
            fn visit_seq<A: serde::de::SeqAccess<'de>>(self, seq: A) -> Result<GridSource, A::Error> {
                Vec::deserialize(serde::de::value::SeqAccessDeserializer::new(seq)).map(GridSource::Rows)
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<GridSource, A::Error> {
                MeshFile::deserialize(serde::de::value::MapAccessDeserializer::new(map)).map(GridSource::File)
            }
        }
        deserializer.deserialize_any(GridVisitor)
    }
}

/// The frame of a net: `auto`, or two directions.
#[derive(Debug, Clone, Copy, PartialEq, Default, JsonSchema)]
#[schemars(untagged, rename = "Frame")]
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

/// Whether the vertices of a net are moved so that every quad has a circle, and what its border may do.
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "MakeCircular")]
pub enum MakeCircularSpec {
    /// Yes with the usual options, or no (the default).
    Switch(bool),
    /// Yes, with these options.
    Options(MakeCircularOptions),
}

impl Default for MakeCircularSpec {
    fn default() -> Self {
        Self::Switch(false)
    }
}

/// How the vertices of a net are moved.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MakeCircularOptions {
    /// What the vertices on the border may do.
    #[serde(default)]
    pub border: BorderSpec,
    /// Steps after which the search is given up. Default: 500.
    #[schemars(range(min = 1))]
    pub max_steps: Option<u32>,
}

/// What the border of a net may do: a word, or curves to slide on.
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Border")]
pub enum BorderSpec {
    /// Every side alike.
    Word(BorderWord),
    /// Sides slide on curves of the model.
    Curves(BorderCurves),
}

impl Default for BorderSpec {
    fn default() -> Self {
        Self::Word(BorderWord::Free)
    }
}

/// What every side of a border may do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum BorderWord {
    /// Border vertices move like the others.
    #[default]
    Free,
    /// Border vertices stay where they are.
    Pinned,
}

/// Names of curves of the model on which the sides of a border slide; a side that is left out is free.
#[derive(Debug, Clone, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BorderCurves {
    /// Curve of the first row, t = 0.
    pub first_row: Option<String>,
    /// Curve of the last row, t = 1.
    pub last_row: Option<String>,
    /// Curve of the first column, s = 0.
    pub first_column: Option<String>,
    /// Curve of the last column, s = 1.
    pub last_column: Option<String>,
}

impl BorderCurves {
    /// The fields by name, in the kernel's order of sides: t = 0, t = 1, s = 0, s = 1.
    pub(in crate::document) fn sides(&self) -> [(&'static str, Option<&str>); 4] {
        [
            ("first_row", self.first_row.as_deref()),
            ("last_row", self.last_row.as_deref()),
            ("first_column", self.first_column.as_deref()),
            ("last_column", self.last_column.as_deref()),
        ]
    }
}

impl MakeCircularSpec {
    /// The options, if the vertices are to be moved.
    pub(in crate::document) fn options(&self) -> Option<MakeCircularOptions> {
        match self {
            Self::Switch(false) => None,
            Self::Switch(true) => Some(MakeCircularOptions::default()),
            Self::Options(options) => Some(options.clone()),
        }
    }

    /// The curves on which sides slide.
    pub(in crate::document) fn border_curves(&self) -> Option<&BorderCurves> {
        match self {
            Self::Options(MakeCircularOptions { border: BorderSpec::Curves(curves), .. }) => Some(curves),
            _ => None,
        }
    }
}

impl<'de> Deserialize<'de> for MakeCircularSpec {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct SwitchVisitor;
        impl<'de> serde::de::Visitor<'de> for SwitchVisitor {
            type Value = MakeCircularSpec;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("true, false or options `{\"border\": …}`")
            }
            fn visit_bool<E>(self, on: bool) -> Result<MakeCircularSpec, E> {
                Ok(MakeCircularSpec::Switch(on))
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<MakeCircularSpec, A::Error> {
                let map = serde::de::value::MapAccessDeserializer::new(map);
                MakeCircularOptions::deserialize(map).map(MakeCircularSpec::Options)
            }
        }
        deserializer.deserialize_any(SwitchVisitor)
    }
}

impl<'de> Deserialize<'de> for BorderSpec {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct BorderVisitor;
        impl<'de> serde::de::Visitor<'de> for BorderVisitor {
            type Value = BorderSpec;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("\"free\", \"pinned\" or curves by side `{\"first_row\": NAME, …}`")
            }
            fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<BorderSpec, E> {
                BorderWord::deserialize(serde::de::value::StrDeserializer::new(word)).map(BorderSpec::Word)
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<BorderSpec, A::Error> {
                let map = serde::de::value::MapAccessDeserializer::new(map);
                BorderCurves::deserialize(map).map(BorderSpec::Curves)
            }
        }
        deserializer.deserialize_any(BorderVisitor)
    }
}
