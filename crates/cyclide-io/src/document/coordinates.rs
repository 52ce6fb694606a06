//! Points and vectors of a document: `[x, y]` or `[x, y, z]`, lists of them, and references to a file of points.

use std::borrow::Cow;
use std::fmt;

use cyclide::{Point3, Vec3};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserializer, Error as _, MapAccess, SeqAccess, Visitor};

use crate::input::points::MOST_POINTS;

/// A point or vector with two or three coordinates; the third is 0 if left out.
///
/// ```
/// use cyclide_io::document::Coordinates;
/// assert_eq!(Coordinates([1.0, 2.0, 0.0]).point().distance(cyclide::Point3::new(1.0, 0.0, 0.0)), 2.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Coordinates(pub [f64; 3]);

impl Coordinates {
    /// As a point.
    #[must_use]
    pub fn point(self) -> Point3 {
        Point3::new(self.0[0], self.0[1], self.0[2])
    }

    /// As a vector.
    #[must_use]
    pub fn vector(self) -> Vec3 {
        Vec3::new(self.0[0], self.0[1], self.0[2])
    }
}

/// One list of points, or several (one per contour).
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "polyline", "closed": true, "points": [[[0, 0], [9, 0], [0, 9]], [[1, 1], [3, 1], [1, 3]]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[0].item.curves().len(), 2);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Lists {
    /// The lists.
    pub lists: Vec<Vec<Coordinates>>,
    /// True if the document gives a list of lists, even if it holds just one.
    pub nested: bool,
}

/// One direction, or a list of them.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"a": {"type": "polyline", "points": [[0, 0], [5, 0]]}, "b": {"type": "polyline", "points": [[0, 2], [5, 2]]}, "s": {"type": "circular-surface", "rails": ["a", "b"], "tangent": [[0, 0, 1], [0, 0, 1]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[2].bodies[0].outer.area() - 5.0 * std::f64::consts::PI).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Directions(pub Vec<Coordinates>);

/// Where the points of a construction come from.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "polyline", "points": [[0, 0], [3, 4]]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((cyclide::curve::length(built[0].item.curves()[0].as_curve()) - 5.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum PointSource {
    /// The document itself.
    Inline(Lists),
    /// A point list in a file of its own.
    File(PointFile),
}

/// A file of points: delimited text with one point per line. Contours are separated by blank lines or identified by a
/// column.
///
/// ```
/// use cyclide_io::{Document, ModelBuilder};
/// use std::path::Path;
/// let text = r#"{"cyclide": 1, "objects": {"p": {"type": "polyline", "points": {"csv": "two.csv"}}}}"#;
/// let document: Document = text.parse()?;
/// let read = |_: &Path| Ok(b"x,y\n0,0\n3,4\n".to_vec());
/// let built = ModelBuilder::new(&document, Path::new(""), &read)?.build(0, &mut |_| ())?;
/// assert!((cyclide::curve::length(built.item.curves()[0].as_curve()) - 5.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointFile {
    /// Path of the file, relative to the document.
    pub csv: String,
    /// Names (or numbers from 1) of the two or three coordinate columns. Default: the columns named x, y (and z) or
    /// easting and northing; else the only two or three numbers of a line; if there are more and no header, the first
    /// two.
    #[schemars(length(min = 2, max = 3))]
    pub columns: Option<Vec<String>>,
    /// Name (or number) of the column that identifies the contour of a point. Default: the column `contour` if there is
    /// one; else blank lines separate contours.
    pub contour: Option<String>,
}

/// What can stand in a list of points: a point, or a contour's list of points.
enum Row {
    Point(Coordinates),
    Contour(Vec<Coordinates>),
}

/// What can stand in a row: a coordinate, or a point.
enum Cell {
    Number(f64),
    Point(Coordinates),
}

/// Reads the rest of a point whose first coordinates are given.
fn rest_of_point<'de, A: SeqAccess<'de>>(first: Option<f64>, seq: &mut A) -> Result<Coordinates, A::Error> {
    let mut values = [0.0; 3];
    let mut count = 0;
    if let Some(x) = first {
        values[0] = x;
        count = 1;
    }
    while let Some(value) = seq.next_element::<f64>()? {
        if count == 3 {
            return Err(A::Error::custom("a point or vector has at most 3 coordinates"));
        }
        values[count] = value;
        count += 1;
    }
    if count < 2 {
        return Err(A::Error::custom("a point or vector needs 2 or 3 coordinates"));
    }
    Ok(Coordinates(values))
}

impl<'de> Deserialize<'de> for Coordinates {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct PointVisitor;
        impl<'de> Visitor<'de> for PointVisitor {
            type Value = Coordinates;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("two or three coordinates `[x, y]` or `[x, y, z]`")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Self::Value, A::Error> {
                rest_of_point(None, &mut seq)
            }
        }
        deserializer.deserialize_seq(PointVisitor)
    }
}

impl<'de> Deserialize<'de> for Cell {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct CellVisitor;
        #[expect(clippy::cast_precision_loss, reason = "JSON integers are coordinates; f64 is what they become")]
        impl<'de> Visitor<'de> for CellVisitor {
            type Value = Cell;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a coordinate or a point `[x, y]` or `[x, y, z]`")
            }
            fn visit_f64<E>(self, value: f64) -> Result<Cell, E> {
                Ok(Cell::Number(value))
            }
            fn visit_u64<E>(self, value: u64) -> Result<Cell, E> {
                Ok(Cell::Number(value as f64))
            }
            fn visit_i64<E>(self, value: i64) -> Result<Cell, E> {
                Ok(Cell::Number(value as f64))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Cell, A::Error> {
                rest_of_point(None, &mut seq).map(Cell::Point)
            }
        }
        deserializer.deserialize_any(CellVisitor)
    }
}

impl<'de> Deserialize<'de> for Row {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct RowVisitor;
        impl<'de> Visitor<'de> for RowVisitor {
            type Value = Row;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a point `[x, y]` or `[x, y, z]`, or a contour `[[x, y], …]`")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Row, A::Error> {
                match seq.next_element()? {
                    None => Err(A::Error::custom("a point needs 2 or 3 coordinates, a contour needs points")),
                    Some(Cell::Number(x)) => rest_of_point(Some(x), &mut seq).map(Row::Point),
                    Some(Cell::Point(first)) => {
                        let mut points = vec![first];
                        while let Some(next) = seq.next_element()? {
                            points.push(next);
                        }
                        Ok(Row::Contour(points))
                    }
                }
            }
        }
        deserializer.deserialize_seq(RowVisitor)
    }
}

impl<'de> Deserialize<'de> for Directions {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Row::deserialize(deserializer).map(|row| match row {
            Row::Point(one) => Self(vec![one]),
            Row::Contour(list) => Self(list),
        })
    }
}

impl Lists {
    fn from_rows<'de, A: SeqAccess<'de>>(mut seq: A) -> Result<Self, A::Error> {
        let mut lists: Vec<Vec<Coordinates>> = Vec::new();
        let (mut nested, mut count) = (None, 0);
        while let Some(row) = seq.next_element::<Row>()? {
            count += if let Row::Contour(points) = &row { points.len() } else { 1 };
            if count > MOST_POINTS {
                return Err(A::Error::custom(format!("the list has more than {MOST_POINTS} points")));
            }
            let contour = matches!(row, Row::Contour(_));
            if nested.is_some_and(|n| n != contour) {
                return Err(A::Error::custom("points and contours are mixed: use one list, or one list per contour"));
            }
            match row {
                Row::Contour(points) => lists.push(points),
                Row::Point(point) => match lists.first_mut() {
                    Some(list) => list.push(point),
                    None => lists.push(vec![point]),
                },
            }
            nested = Some(contour);
        }
        Ok(Self { lists, nested: nested.unwrap_or(false) })
    }
}

/// Accepts a list, and a reference to a file where `file` says so.
struct SourceVisitor {
    file: bool,
}

impl<'de> Visitor<'de> for SourceVisitor {
    type Value = PointSource;
    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list `[[x, y], …]`, a list of such lists")?;
        if self.file { f.write_str(", or `{\"csv\": \"FILE\"}`") } else { Ok(()) }
    }
    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<PointSource, A::Error> {
        Lists::from_rows(seq).map(PointSource::Inline)
    }
    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<PointSource, A::Error> {
        if !self.file {
            return Err(A::Error::invalid_type(serde::de::Unexpected::Map, &self));
        }
        PointFile::deserialize(MapAccessDeserializer::new(map)).map(PointSource::File)
    }
}

impl<'de> Deserialize<'de> for PointSource {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(SourceVisitor { file: true })
    }
}

impl<'de> Deserialize<'de> for Lists {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match deserializer.deserialize_any(SourceVisitor { file: false })? {
            PointSource::Inline(lists) => Ok(lists),
            PointSource::File(_) => Err(D::Error::custom("a list of vectors is needed")),
        }
    }
}

impl JsonSchema for Coordinates {
    fn schema_name() -> Cow<'static, str> {
        "Coordinates".into()
    }
    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "title": "[x, y, z]",
            "description": "A point or vector: x, y and, if not 0, z.",
            "type": "array",
            "items": { "type": "number" },
            "minItems": 2,
            "maxItems": 3
        })
    }
}

impl JsonSchema for Directions {
    fn schema_name() -> Cow<'static, str> {
        "Directions".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let one = generator.subschema_for::<Coordinates>();
        json_schema!({
            "description": "One direction of any length, or a list of them.",
            "anyOf": [one, { "type": "array", "items": one, "minItems": 1 }]
        })
    }
}

impl JsonSchema for Lists {
    fn schema_name() -> Cow<'static, str> {
        "Lists".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let one = generator.subschema_for::<Coordinates>();
        json_schema!({
            "description": "One list of points (or vectors), or a list of such lists, one per contour.",
            "anyOf": [
                { "type": "array", "items": one, "minItems": 1 },
                { "type": "array", "items": { "type": "array", "items": one, "minItems": 1 }, "minItems": 1 }
            ]
        })
    }
}

impl JsonSchema for PointSource {
    fn schema_name() -> Cow<'static, str> {
        "Points".into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let (lists, file) = (generator.subschema_for::<Lists>(), generator.subschema_for::<PointFile>());
        json_schema!({
            "description": "The points: in the document, or in a separate file.",
            "anyOf": [lists, file]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<PointSource, String> {
        serde_json::from_str(text).map_err(|e| e.to_string())
    }

    #[test]
    fn points_in_two_and_three_dimensions_and_contours() {
        let PointSource::Inline(one) = parse("[[0,1],[2.5,-3,4]]").unwrap() else { panic!("inline") };
        assert_eq!(one.lists, [[Coordinates([0.0, 1.0, 0.0]), Coordinates([2.5, -3.0, 4.0])]]);
        assert!(!one.nested);
        let PointSource::Inline(two) = parse("[[[0,1],[2,3]],[[4,5]]]").unwrap() else { panic!("inline") };
        assert_eq!(two.lists.iter().map(Vec::len).collect::<Vec<_>>(), [2, 1]);
        assert!(two.nested);
        let PointSource::Inline(single) = parse("[[[0,1],[2,3]]]").unwrap() else { panic!("inline") };
        assert!(single.nested);
        let file = PointFile { csv: "a.csv".into(), columns: Some(vec!["x_m".into(), "y_m".into()]), contour: None };
        assert_eq!(parse(r#"{"csv":"a.csv","columns":["x_m","y_m"]}"#).unwrap(), PointSource::File(file));
    }

    #[test]
    fn refusals_say_what_is_needed_and_where() {
        for (text, message) in [
            ("[[0]]", "a point or vector needs 2 or 3 coordinates at line 1 column 4"),
            ("[[0,1,2,3]]", "a point or vector has at most 3 coordinates at line 1 column 10"),
            ("[[]]", "a point needs 2 or 3 coordinates, a contour needs points at line 1 column 3"),
            ("[[0,1],\n[[2,3]]]", "points and contours are mixed: use one list, or one list per contour at line 2"),
            ("[[0,\"1\"]]", "invalid type: string \"1\", expected f64 at line 1 column 7"),
            ("[[0,1e999]]", "number out of range at line 1 column"),
            ("[1,2]", "invalid type: integer `1`, expected a point `[x, y]` or `[x, y, z]`, or a contour"),
            ("7", "invalid type: integer `7`, expected a list `[[x, y], …]`, a list of such lists, or `{\"csv\""),
            (r#"{"csv":"a","colums":["x"]}"#, "unknown field `colums`, expected one of `csv`, `columns`, `contour`"),
            ("{}", "missing field `csv`"),
        ] {
            let error = parse(text).unwrap_err();
            assert!(error.starts_with(message), "{text}: {error}");
        }
    }
}
