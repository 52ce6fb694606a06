//! What the faces of a file stand for: told by who writes them, held against the file and the uncut model by the check.

use cyclide::topology::{FacePart, Side};

/// The faces of one shell of a file: parts of the faces of one shell of the model, which may have been cut for the format.
/// Places and counts, never geometry.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ShellPlan {
    /// Which shell of the body.
    pub(crate) shell: usize,
    /// What each face of the file is, in file order.
    pub(crate) faces: Vec<FacePlan>,
}

impl ShellPlan {
    /// Faces that are one part each, in files without loops.
    pub(crate) fn of_parts(shell: usize, parts: &[FacePart]) -> Self {
        let face = |&part: &FacePart| FacePlan { parts: vec![part], loops: Vec::new() };
        Self { shell, faces: parts.iter().map(face).collect() }
    }

    /// The parts of all faces.
    pub(crate) fn parts(&self) -> impl Iterator<Item = &FacePart> {
        self.faces.iter().flat_map(|face| &face.parts)
    }
}

/// One face of a file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FacePlan {
    /// The parts of faces of the shell that it is.
    pub(crate) parts: Vec<FacePart>,
    /// Its loops as the file has them, the outer one first: of each edge the sides that it is, in the order of the loop, each of one of
    /// the parts.
    pub(crate) loops: Vec<Vec<Vec<(usize, Side)>>>,
}
