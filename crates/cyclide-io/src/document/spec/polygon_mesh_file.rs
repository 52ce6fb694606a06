//! Meshes in files of their own.

use schemars::JsonSchema;
use serde::Deserialize;

/// A mesh in a file of its own.
#[derive(Debug, Clone, PartialEq, Eq, JsonSchema)]
pub enum PolygonMeshFile {
    /// Path of a Wavefront OBJ file, relative to the document.
    #[schemars(rename = "obj")]
    Obj(String),
    /// Path of an STL file, binary or text, relative to the document.
    #[schemars(rename = "stl")]
    Stl(String),
    /// Path of a PLY file, binary or text, relative to the document.
    #[schemars(rename = "ply")]
    Ply(String),
    /// Path of a binary glTF file, relative to the document: its scene, in metres, with the axis that is up there as third one.
    #[schemars(rename = "glb")]
    Glb(String),
}

impl PolygonMeshFile {
    /// The path.
    #[must_use]
    pub fn path(&self) -> &str {
        match self {
            Self::Obj(path) | Self::Stl(path) | Self::Ply(path) | Self::Glb(path) => path,
        }
    }

    /// The word of its format.
    pub(crate) const fn word(&self) -> &'static str {
        match self {
            Self::Obj(_) => "obj",
            Self::Stl(_) => "stl",
            Self::Ply(_) => "ply",
            Self::Glb(_) => "glb",
        }
    }
}

/// The words of the formats, for what is derived of reading.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Written {
    Obj(String),
    Stl(String),
    Ply(String),
    Glb(String),
}

impl<'de> Deserialize<'de> for PolygonMeshFile {
    /// As an object with one field. A path alone is answered with how it is written.
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct PolygonMeshFileVisitor;
        impl<'de> serde::de::Visitor<'de> for PolygonMeshFileVisitor {
            type Value = PolygonMeshFile;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a mesh file: `{\"obj\": FILE}`, or with `stl`, `ply` or `glb`")
            }
            fn visit_map<A: serde::de::MapAccess<'de>>(self, map: A) -> Result<PolygonMeshFile, A::Error> {
                Ok(match Written::deserialize(serde::de::value::MapAccessDeserializer::new(map))? {
                    Written::Obj(path) => PolygonMeshFile::Obj(path),
                    Written::Stl(path) => PolygonMeshFile::Stl(path),
                    Written::Ply(path) => PolygonMeshFile::Ply(path),
                    Written::Glb(path) => PolygonMeshFile::Glb(path),
                })
            }
        }
        deserializer.deserialize_any(PolygonMeshFileVisitor)
    }
}
