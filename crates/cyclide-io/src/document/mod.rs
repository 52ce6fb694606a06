//! The model document: JSON with a version, units and named objects, each a construction with its data.
//!
//! ```text
//! { "cyclide": 1, "units": "mm", "objects": { "NAME": { "type": "…", … } } }
//! ```
//! Parsing goes object by object on the raw text, so that every message can show its place: the type word first,
//! then the fields of that type; unknown fields and repeated names are errors. [`ModelBuilder`] runs the
//! constructions; what the kernel refuses is reported at the point or field at fault.

mod angle;
mod coordinates;
mod forms;
pub mod kinds;
mod limits;
mod locate;
mod matrix;
mod objects;
mod plain_words;
mod schema;

use std::borrow::Cow;

use cyclide::model::Units;
use kinds::fields::comment::Comment;
use locate::{Entries, Step, offset_in, path_text, value_at};
use plain_words::{in_plain_words, other_word_for, syntax_in_plain_words, wrong_count};
use serde::Deserialize;
use serde_json::value::RawValue;

use crate::text::place::{Diagnostic, Source, decode, quoted};
use crate::text::suggest::did_you_mean;

pub use angle::Angle;
pub use coordinates::{Coordinates, Directions, Lists, PointFile, PointSource};
pub use kinds::ObjectSpec;
pub use objects::contours::{ContourFacts, Fitted};
pub use objects::facts::{
    BlendFacts, CellFacts, Facts, InterpolationFacts, NetFacts, RoundedPolyhedron, SmoothChoice, TubeFacts,
    UnrolledPlane,
};
pub use objects::idle::NO_EFFECT;
pub(crate) use objects::kind::OfPanels;
pub use objects::remark::Remark;
pub use objects::{BuiltObject, ModelBuilder};
pub use schema::document_schema;

/// The document version this crate reads.
///
/// ```
/// use cyclide_io::{Document, document::DOCUMENT_VERSION};
/// let text = format!("{{\"cyclide\": {DOCUMENT_VERSION}, \"objects\": {{}}}}");
/// assert!(text.parse::<Document>().is_ok());
/// ```
pub const DOCUMENT_VERSION: u64 = 1;

/// A parsed model document.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "units": "m", "objects": {"c": {"type": "circle", "center": [0, 0], "radius": 2}}}"#.parse()?;
/// assert_eq!((document.units, document.objects[0].0.as_str()), (cyclide::model::Units::Metre, "c"));
/// let circle = &document.build()?[0];
/// assert!((cyclide::curve::length(circle.item.curves()[0].as_curve()) - 4.0 * std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    /// Unit of all coordinates.
    pub units: Units,
    /// The objects with their names, in the document's order.
    pub objects: Vec<(String, ObjectSpec)>,
    /// True if nobody said the units: they are the default, or what a file says.
    units_assumed: bool,
    name: String,
    /// Empty if the document was not made from a text.
    text: String,
}

/// The outer fields.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Root<'a> {
    #[serde(rename = "$schema")]
    _schema: Option<String>,
    #[serde(rename = "comment", default)]
    _comment: Comment,
    #[serde(rename = "cyclide")]
    _version: serde::de::IgnoredAny,
    units: Option<Units>,
    #[serde(borrow)]
    objects: Entries<'a>,
}

impl Document {
    /// Document of objects made by a program instead of a text; `name` is what messages call it.
    #[must_use]
    pub fn from_objects(name: &str, units: Units, objects: Vec<(String, ObjectSpec)>) -> Self {
        Self { units, objects, units_assumed: false, name: name.to_owned(), text: String::new() }
    }

    /// The same with assumed units: files of points whose coordinates suggest another unit cause a warning.
    #[must_use]
    pub fn assuming_units(self) -> Self {
        Self { units_assumed: true, ..self }
    }

    /// Parses a document from the bytes of a file; `name` is what messages call it.
    ///
    /// # Errors
    /// A message with file, line, column, path and the text at that place: not UTF-8, empty, not JSON, another version, an
    /// unknown type or field, a missing field, a value of the wrong kind, a repeated name, a number or string that is too
    /// long.
    pub fn parse(name: &str, bytes: &[u8]) -> Result<Self, Box<Diagnostic>> {
        let text = decode(name, bytes)?;
        let source = Source { name, text };
        if text.trim().is_empty() {
            return Err(source.diagnostic(0..0, "", "the file is empty"));
        }
        limits::check_limits(source)?;
        check_version(source)?;
        let root: Root<'_> = serde_json::from_str(text).map_err(|e| refused(source, &[], text, &e))?;
        let objects = root.objects.0.into_iter().map(|(name, raw)| Ok((object_name(source, &name)?, raw)));
        let objects = objects
            .map(|entry| entry.and_then(|(name, raw)| parse_object(source, &name, raw).map(|spec| (name, spec))))
            .collect::<Result<Vec<_>, _>>()?;
        check_no_null(source)?;
        Ok(Self {
            units: root.units.unwrap_or_default(),
            objects,
            units_assumed: root.units.is_none(),
            name: name.to_owned(),
            text: text.to_owned(),
        })
    }

    fn source(&self) -> Source<'_> {
        Source { name: &self.name, text: &self.text }
    }
}

/// Refuses what is no cyclide document of our version, before anything else is looked at.
fn check_version(source: Source<'_>) -> Result<(), Box<Diagnostic>> {
    let Entries(entries) = serde_json::from_str(source.text).map_err(|e| refused(source, &[], source.text, &e))?;
    let Some((_, raw)) = entries.iter().find(|(key, _)| key == "cyclide") else {
        let message = "not a cyclide document: the field `cyclide` with the version is missing (`\"cyclide\": 1`)";
        return Err(source.diagnostic(0..1, "", message));
    };
    let text = raw.get();
    if text.parse() == Ok(DOCUMENT_VERSION) {
        return Ok(());
    }
    let start = offset_in(source.text, text);
    let text = quoted(text);
    let message = format!("unknown document version {text}: this program reads version {DOCUMENT_VERSION}");
    Err(source.diagnostic(start..start + text.len(), "cyclide", message))
}

/// Refuses fields that are `null`, which the parser takes for fields left out. Of entries of lists it knows which ones may be null.
fn check_no_null(source: Source<'_>) -> Result<(), Box<Diagnostic>> {
    let (mut quoted, mut escaped) = (false, false);
    // Whether the value of a field comes next.
    let mut field = false;
    for (at, byte) in source.text.bytes().enumerate() {
        match byte {
            b'"' if !escaped => quoted = !quoted,
            b'n' if !quoted && field && source.text[at..].starts_with("null") => {
                let (steps, span) = value_at(source.text, &[], at);
                let message = "null is not allowed here: remove the field";
                return Err(source.diagnostic(span, &path_text(&steps), message));
            }
            _ => {}
        }
        escaped = quoted && byte == b'\\' && !escaped;
        field = !quoted && (byte == b':' || field && byte.is_ascii_whitespace());
    }
    Ok(())
}

/// Longest name of an object, in bytes; names of files have as many.
const LONGEST_NAME: usize = 255;

/// Refuses names that could not be shown or found again.
fn object_name(source: Source<'_>, name: &str) -> Result<String, Box<Diagnostic>> {
    if !name.trim().is_empty() && !name.chars().any(char::is_control) && name.len() <= LONGEST_NAME {
        return Ok(name.to_owned());
    }
    let steps = [Step::from("objects"), Step::from(name)];
    let span = locate::span_of(source.text, &steps).unwrap_or(0..0);
    let message = if name.len() > LONGEST_NAME {
        format!("the name of an object has {} bytes, more than {LONGEST_NAME}", name.len())
    } else {
        "the name of an object must not be empty or contain control characters".to_owned()
    };
    Err(source.diagnostic(span, &path_text(&steps), message))
}

/// The word of the `type` field.
#[derive(Deserialize)]
struct TypeField<'a>(#[serde(borrow)] Cow<'a, str>);

fn parse_object(source: Source<'_>, name: &str, raw: &RawValue) -> Result<ObjectSpec, Box<Diagnostic>> {
    let path = [Step::from("objects"), Step::from(name)];
    let refuse = |error: &serde_json::Error| refused(source, &path, raw.get(), error);
    let Entries(entries) = serde_json::from_str(raw.get()).map_err(|e| refuse(&e))?;
    let known = ObjectSpec::TYPES.join("`, `");
    let start = offset_in(source.text, raw.get());
    let Some((_, word)) = entries.iter().find(|(key, _)| key == "type") else {
        let message = format!("missing field `type`: one of `{known}`");
        return Err(source.diagnostic(start..start + 1, &path_text(&path), message));
    };
    let at = [path[0].clone(), path[1].clone(), Step::from("type")];
    let TypeField(kind) = serde_json::from_str(word.get()).map_err(|e| refused(source, &at, word.get(), &e))?;
    ObjectSpec::parse(&kind, raw.get())
        .ok_or_else(|| {
            let start = offset_in(source.text, word.get());
            // What other programs call it is meant before words that look like it.
            let hint = Some(other_word_for(&kind)).filter(|hint| !hint.is_empty());
            let hint = hint.unwrap_or_else(|| did_you_mean(&kind, ObjectSpec::TYPES.iter().copied()));
            let message = format!("unknown type `{}`, expected one of `{known}`{hint}", quoted(&kind));
            source.diagnostic(start..start + word.get().len(), &path_text(&at), message)
        })?
        .map_err(|e| refuse(&e))
}

/// The message for what the JSON parser said about `part`, the text of the value at `path`.
fn refused(source: Source<'_>, path: &[Step], part: &str, error: &serde_json::Error) -> Box<Diagnostic> {
    let line_start = match error.line() {
        0 | 1 => 0,
        line => part.match_indices('\n').nth(line - 2).map_or(part.len(), |(at, _)| at + 1),
    };
    // The parser counts bytes of the line, and stands behind what it read.
    let offset = offset_in(source.text, part) + (line_start + error.column()).min(part.len());
    let message = error.to_string();
    let message = message.rfind(" at line ").map_or(message.as_str(), |at| &message[..at]);
    if !error.is_data() {
        let at = source.character_before(offset);
        let syntax = || source.diagnostic(at.clone(), "", syntax_in_plain_words(source.text, at.start, message));
        return one_value_too_many(source, path, offset, message).unwrap_or_else(syntax);
    }
    let message = in_plain_words(message);
    let (steps, span) = value_at(source.text, path, offset);
    let is_leaf = !matches!(source.text.as_bytes().get(span.start), Some(b'{' | b'['));
    let about_name = message.contains("field `") || message.contains("name `");
    let place = if let Some(key) = quoted_name_before(source.text, offset).filter(|_| about_name) {
        key
    } else if is_leaf {
        span
    } else {
        span.start..span.start + 1
    };
    source.diagnostic(place, &path_text(&steps), message)
}

/// A list with more values than its type holds, or a choice with more than one name: the parser takes the next comma for
/// a fault of the syntax. `None` if the syntax is at fault indeed.
fn one_value_too_many(source: Source<'_>, path: &[Step], offset: usize, message: &str) -> Option<Box<Diagnostic>> {
    // The syntax of an object was found sound before its fields are read.
    if path.is_empty() || !matches!(message, "trailing characters" | "expected value") {
        return None;
    }
    let list = locate::members_around(source.text, path, offset)?;
    let message = if list.is_list {
        wrong_count(list.count, list.before)
    } else if list.count == 1 {
        "a string, or an object with one name, `{\"name\": …}`, is expected after this name".to_owned()
    } else {
        "one name is expected here: put each into its own braces `{…}`".to_owned()
    };
    Some(source.diagnostic(list.span.start..list.span.start + 1, &path_text(&list.steps), message))
}

/// The range of the quoted name that ends at a byte offset, if one does.
fn quoted_name_before(text: &str, offset: usize) -> Option<std::ops::Range<usize>> {
    let before = text.get(..offset)?.strip_suffix('"')?;
    before.rfind('"').map(|start| start..offset)
}

impl std::str::FromStr for Document {
    type Err = crate::error::Error;

    /// Reads a text, which messages call `document`: see [`Document::parse`].
    fn from_str(text: &str) -> crate::error::Result<Self> {
        Ok(Self::parse("document", text.as_bytes())?)
    }
}

#[cfg(test)]
mod tests;
