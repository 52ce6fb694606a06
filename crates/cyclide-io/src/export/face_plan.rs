//! What the faces of a file stand for: told by who writes them, held against the file and the uncut model by the check.

use cyclide::FacePart;

/// The faces of one shell of a file: parts of the faces of one shell of the model, which may have been cut for the format.
/// Places and counts, never geometry.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ShellPlan {
    /// Which shell of the body.
    pub(crate) shell: usize,
    /// The part of a face of that shell that each face of the file is, in file order.
    pub(crate) faces: Vec<FacePart>,
}
