//! Why a file of ours may not be readable, or is not what the model says.

use crate::text::place::quoted;
use cyclide::ShortNumber;

/// Why bytes could not be read back.
///
/// ```
/// use cyclide_io::{Format, formats::read_back};
/// let error = read_back(Format::Dxf, b"x\n").unwrap_err();
/// assert!(error.to_string().contains("line 1"));
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The format holds no geometry.
    #[error("{format} contains no geometry to read back")]
    NoGeometry {
        /// Name of the format.
        format: &'static str,
    },
    /// The text breaks the rules of its format.
    #[error("not readable at {place}: {detail}")]
    Syntax {
        /// Where: a line, a byte or an entity.
        place: String,
        /// What was wrong.
        detail: String,
    },
    /// Something that the writers of this crate never write.
    #[error("{what} at {place}: this program writes no such thing")]
    Unsupported {
        /// The thing.
        what: String,
        /// Where.
        place: String,
    },
    /// The numbers describe no curve.
    #[error("no curve at {place}: {source}")]
    Geometry {
        /// Where.
        place: String,
        /// What the kernel said.
        source: cyclide::Error,
    },
    /// The unit of the file differs from that of the model.
    #[error("{}", unit_message(*.found, *.expected))]
    Unit {
        /// Length of a unit of the file in millimeters; `None` if the file does not state it.
        found: Option<f64>,
        /// Length of a unit of the model in millimeters.
        expected: f64,
    },
    /// The name of a part differs from that in the model.
    #[error("{of} {number}{}", name_message(.found.as_deref(), .expected.as_deref()))]
    Name {
        /// What has the name.
        of: &'static str,
        /// Which of these, from 0.
        number: usize,
        /// The name in the file, if any.
        found: Option<String>,
        /// The name in the model, if any.
        expected: Option<String>,
    },
    /// The number of parts with a name differs from that in the model.
    #[error("{of} `{}` has {found} parts in the file, {expected} in the model", quoted(.name))]
    NameCount {
        /// What has the name.
        of: &'static str,
        /// The name.
        name: String,
        /// Parts in the file.
        found: usize,
        /// Parts in the model.
        expected: usize,
    },
    /// The number of connected curves differs from that in the model.
    #[error("{found} connected curves in the file, {expected} in the model")]
    CurveCount {
        /// In the file.
        found: usize,
        /// In the model.
        expected: usize,
    },
    /// A curve is closed in the model and open in the file, or vice versa.
    #[error("curve {curve} is {} in the file and {} in the model", openness(*.found), openness(!*.found))]
    Closedness {
        /// Which connected curve, from 0.
        curve: usize,
        /// Closed in the file.
        found: bool,
    },
    /// The number of pieces of a curve differs from the number written.
    #[error("curve {curve} has {found} pieces in the file, {expected} were made")]
    PieceCount {
        /// Which connected curve, from 0.
        curve: usize,
        /// In the file.
        found: usize,
        /// Made of the model.
        expected: usize,
    },
    /// A knot of a curve differs from the one written.
    #[error("a knot of curve {curve} is {} in the file, {} was made", number(*.found), number(*.expected))]
    Knot {
        /// Which connected curve, from 0.
        curve: usize,
        /// The knot in the file, if any.
        found: Option<f64>,
        /// The expected knot, if any.
        expected: Option<f64>,
    },
    /// A further column of a point in a table does not match the curve of the model.
    #[error("curve {curve}, point {point}: the {what} is {} in the file, {} in the model", number(*.found), number(*.expected))]
    Sample {
        /// Which connected curve, from 0.
        curve: usize,
        /// Which of its points, from 0.
        point: usize,
        /// The column.
        what: &'static str,
        /// The number in the file, if any.
        found: Option<f64>,
        /// The number in the model, if any.
        expected: Option<f64>,
    },
    /// The lines on a mesh are not the edges of its patches.
    #[error(
        "{} lines on the mesh of {object} are not edges of its patches, and {} edges have no line", .strange, .missing
    )]
    MeshEdges {
        /// The object.
        object: String,
        /// Lines that are not edges, or coincide with others.
        strange: usize,
        /// Edges without a line.
        missing: usize,
    },
    /// The pieces of a curve do not cover the whole curve, once and in order.
    #[error("the pieces of curve {curve} do not cover the whole curve")]
    CurveParts {
        /// Which connected curve, from 0.
        curve: usize,
    },
    /// The number of polygons differs from the number written.
    #[error("{found} polygons in the file, {expected} were made")]
    PolygonCount {
        /// In the file.
        found: usize,
        /// Made of the model.
        expected: usize,
    },
    /// The number of rational patches differs from that in the model.
    #[error("{found} patches in the file, {expected} in the model")]
    PatchCount {
        /// In the file.
        found: usize,
        /// In the model.
        expected: usize,
    },
    /// A rational patch of the file differs from that of the model.
    #[error("patch {patch}: {detail}")]
    Patch {
        /// Which patch, from 0.
        patch: usize,
        /// What differs.
        detail: &'static str,
    },
    /// A rational volume of the file differs from that of the model.
    #[error("volume {volume}: {detail}")]
    Volume {
        /// Which volume, from 0.
        volume: usize,
        /// What differs.
        detail: &'static str,
    },
    /// Polygons are missing, or a part of a face has several.
    #[error("face {face} of {object} is not covered exactly once by polygons")]
    NotCovered {
        /// The object.
        object: String,
        /// Which of its faces, numbered from 0 through all its shells.
        face: usize,
    },
    /// A body has no polygon at all.
    #[error("{object} has no polygon")]
    NoPolygons {
        /// The object.
        object: String,
    },
    /// A polygon is oriented to the inner side of its face.
    #[error("a polygon of face {face} of {object} has the wrong orientation")]
    WrongSide {
        /// The object.
        object: String,
        /// Which of its faces, numbered from 0 through all its shells.
        face: usize,
    },
    /// A vertex of a mesh is not at its location on the surface.
    #[error("a vertex of triangle {face} of {object} is displaced by {}, limit {}", ShortNumber(*.off), ShortNumber(*.limit))]
    Vertex {
        /// The object.
        object: String,
        /// Which of the triangles of the surface, from 0.
        face: usize,
        /// How far it is off.
        off: f64,
        /// What rounding accounts for.
        limit: f64,
    },
    /// A normal is not that of the surface, or in STL not that of its triangle.
    #[error("a normal of face {face} of {object} is off by {}, limit {}", ShortNumber(*.off), ShortNumber(*.limit))]
    Normal {
        /// The object.
        object: String,
        /// Which of its faces, numbered from 0 through all its shells.
        face: usize,
        /// Length of the difference.
        off: f64,
        /// The largest one accepted.
        limit: f64,
    },
    /// Polygons do not share the same sides as in the mesh that was written.
    #[error(
        "the polygons of {object} have {} free sides and {} used twice in the same direction; expected {} and {}",
        .free[0], .repeated[0], .free[1], .repeated[1]
    )]
    SideUse {
        /// The object.
        object: String,
        /// Sides of a single polygon: in the file, expected.
        free: [usize; 2],
        /// Repeated uses of a side in one direction: in the file, expected.
        repeated: [usize; 2],
    },
    /// The number of lines of surfaces differs from the number drawn.
    #[error("{found} lines of surfaces in the file, {expected} were drawn")]
    LineCount {
        /// In the file.
        found: usize,
        /// Drawn.
        expected: usize,
    },
    /// The lines of surfaces differ from those in the drawing of the model.
    #[error("the lines of surfaces: {detail}")]
    Lines {
        /// What is wrong.
        detail: &'static str,
    },
    /// The number of bodies differs from that in the model.
    #[error("{found} bodies in the file, {expected} in the model")]
    BodyCount {
        /// In the file.
        found: usize,
        /// In the model.
        expected: usize,
    },
    /// The structure of a body differs from that in the model.
    #[error("body {body}: {detail}")]
    Body {
        /// Which body, from 0.
        body: usize,
        /// What differs.
        detail: &'static str,
    },
}

fn unit_message(found: Option<f64>, expected: f64) -> String {
    let expected = ShortNumber(expected);
    match found {
        Some(found) => format!("the unit of the file is {} mm, that of the model {expected} mm", ShortNumber(found)),
        None => format!("the file does not state its unit; that of the model is {expected} mm"),
    }
}

/// The message behind what bears the name.
fn name_message(found: Option<&str>, expected: Option<&str>) -> String {
    match (found, expected) {
        (Some(found), Some(expected)) => {
            format!(" is `{}` in the file, `{}` in the model", quoted(found), quoted(expected))
        }
        (None, expected) => format!(", `{}`, is not in the file", quoted(expected.unwrap_or_default())),
        (Some(found), None) => format!(", `{}`, is only in the file", quoted(found)),
    }
}

/// A number, if there is one.
fn number(value: Option<f64>) -> String {
    value.map_or_else(|| "none".to_owned(), |value| ShortNumber(value).to_string())
}

fn openness(closed: bool) -> &'static str {
    if closed { "closed" } else { "open" }
}

impl ReadError {
    pub(crate) fn syntax(place: impl Into<String>, detail: impl Into<String>) -> Self {
        Self::Syntax { place: place.into(), detail: detail.into() }
    }
    pub(crate) fn unsupported(what: impl Into<String>, place: impl Into<String>) -> Self {
        Self::Unsupported { what: what.into(), place: place.into() }
    }
}
