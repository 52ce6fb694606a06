//! Meshes in files of their own.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Error as _, MapAccess, Unexpected, Visitor};
use serde::{Deserialize, Deserializer};

use crate::formats::MeshFormat;

/// A mesh in a file of its own: an object with one field, the word of its format.
///
/// ```
/// use cyclide_io::{Document, document::ObjectSpec, formats::MeshFormat};
/// let text = r#"{"cyclide": 1, "objects": {"m": {"type": "smooth-mesh", "mesh": {"stl": "scan.stl"}}}}"#;
/// let document = Document::parse("m.json", text.as_bytes())?;
/// let ObjectSpec::SmoothMesh(spec) = &document.objects[0].1 else { unreachable!("the type says so") };
/// let file = spec.mesh.as_ref().expect("it is given");
/// assert_eq!((file.format, file.path.as_str()), (MeshFormat::Stl, "scan.stl"));
/// # Ok::<(), Box<cyclide_io::text::Diagnostic>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PolygonMeshFile {
    /// The format.
    pub format: MeshFormat,
    /// The path, relative to the document.
    pub path: String,
}

impl<'de> Deserialize<'de> for MeshFormat {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let word = Cow::<str>::deserialize(deserializer)?;
        Self::of_word(&word).ok_or_else(|| D::Error::unknown_variant(&word, Self::WORDS))
    }
}

impl<'de> Deserialize<'de> for PolygonMeshFile {
    /// As an object with one field. A path alone is answered with how it is written.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct PolygonMeshFileVisitor;
        impl<'de> Visitor<'de> for PolygonMeshFileVisitor {
            type Value = PolygonMeshFile;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                let quoted: Vec<String> = MeshFormat::WORDS.iter().skip(1).map(|word| format!("`{word}`")).collect();
                let (last, others) =
                    quoted.split_last().map_or(("", &[][..]), |(last, others)| (last.as_str(), others));
                let first = MeshFormat::WORDS.first().copied().unwrap_or_default();
                write!(f, "a mesh file: `{{\"{first}\": FILE}}`, or with {} or {last}", others.join(", "))
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<PolygonMeshFile, A::Error> {
                let format = map.next_key()?.ok_or_else(|| A::Error::invalid_type(Unexpected::Map, &"enum"))?;
                Ok(PolygonMeshFile { format, path: map.next_value()? })
            }
        }
        deserializer.deserialize_any(PolygonMeshFileVisitor)
    }
}

impl JsonSchema for PolygonMeshFile {
    fn schema_name() -> Cow<'static, str> {
        "PolygonMeshFile".into()
    }
    fn json_schema(_generator: &mut SchemaGenerator) -> Schema {
        let field = |format: &MeshFormat| {
            let entry = format.entry();
            json_schema!({
                "type": "object",
                "properties": { (entry.word): { "type": "string" } },
                "required": [entry.word],
                "additionalProperties": false,
                "description": entry.field
            })
        };
        let fields: Vec<Schema> = MeshFormat::ALL.iter().map(field).collect();
        json_schema!({ "oneOf": fields, "description": "A mesh in a separate file." })
    }
}
