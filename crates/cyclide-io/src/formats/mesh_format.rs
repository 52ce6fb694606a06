//! The formats of meshes that are read: one entry in one list for each.
//!
//! Its word is the suffix of its files and the name of the field of documents; what documents allow, what is said of files that are no
//! such mesh, and how they are told by their first bytes is all derived of the list.

use super::mesh_entry::MeshEntry;
use super::{glb, obj, ply, stl};

/// The list: each format with its module, which holds its entry.
macro_rules! mesh_formats {
    ($($(#[$doc:meta])* $format:ident: $module:ident,)*) => {
        /// A mesh format that can be read.
        ///
        /// ```
        /// use cyclide_io::formats::MeshFormat;
        /// let words: Vec<&str> = MeshFormat::ALL.iter().map(|format| format.word()).collect();
        /// assert_eq!(words, ["obj", "stl", "ply", "glb"]);
        /// ```
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum MeshFormat {
            $($(#[$doc])* $format,)*
        }

        impl MeshFormat {
            /// Every format.
            pub const ALL: &'static [Self] = &[$(Self::$format),*];

            /// Their words.
            pub(crate) const WORDS: &'static [&'static str] = &[$($module::MESH_ENTRY.word),*];

            /// What there is to know of it.
            pub(crate) const fn entry(self) -> &'static MeshEntry {
                match self {
                    $(Self::$format => &$module::MESH_ENTRY,)*
                }
            }
        }
    };
}

mesh_formats! {
    /// Wavefront OBJ.
    Obj: obj,
    /// STL, binary or text.
    Stl: stl,
    /// PLY, binary or text.
    Ply: ply,
    /// Binary glTF.
    Glb: glb,
}

impl MeshFormat {
    /// The suffix of its files, which is also their field in documents.
    #[must_use]
    pub const fn word(self) -> &'static str {
        self.entry().word
    }

    /// The format with this word.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|format| format.word() == word)
    }

    /// The format of a file that starts so.
    pub(crate) fn of_start(text: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|format| (format.entry().is_start)(text))
    }
}
