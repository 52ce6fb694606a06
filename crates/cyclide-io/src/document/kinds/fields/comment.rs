//! Remarks of the author: JSON has no comments of its own, and files with others in their place are no JSON to scripts.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::{Deserializer, SeqAccess, Visitor};

/// A text, or a list of texts, one per line. It is checked and left aside.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"c": {"type": "circle", "comment": ["a hole", "for a bolt"], "center": [0, 0], "radius": 2}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built.len(), 1);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Comment;

impl<'de> Deserialize<'de> for Comment {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct CommentVisitor;
        impl<'de> Visitor<'de> for CommentVisitor {
            type Value = Comment;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a string or a list of strings `[\"…\", …]`")
            }
            fn visit_str<E>(self, _text: &str) -> Result<Comment, E> {
                Ok(Comment)
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Comment, A::Error> {
                while seq.next_element::<Cow<'de, str>>()?.is_some() {}
                Ok(Comment)
            }
        }
        deserializer.deserialize_any(CommentVisitor)
    }
}

impl JsonSchema for Comment {
    fn schema_name() -> Cow<'static, str> {
        "Comment".into()
    }
    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A comment: a string, or a list of strings, one per line.",
            "anyOf": [{ "type": "string" }, { "type": "array", "items": { "type": "string" } }]
        })
    }
}
