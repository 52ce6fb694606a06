//! In which part of the input something was refused, and why.

use crate::error::words::parameters;
use crate::error::{Error, ErrorItem};
use crate::table::table;

table! {
    /// In which part of the input something was refused, and why.
    ///
    /// ```
    /// use cyclide::{Error, error::ArcError};
    /// let error = Error::from(ArcError::ZeroWeight { index: 0 }).in_quad(7);
    /// assert_eq!((error.reason(), error.index()), ("zero-weight", Some(7)));
    /// assert_eq!(error.to_string(), "quad 7: weight 0 is zero");
    /// ```
    pub enum PartError {
        /// One block of a grid failed; the cause says why.
        InBlock {
            /// Which block, from 0, s fastest, then t.
            block: usize,
            /// What went wrong in it.
            cause: Box<Error>,
        }
        of cause;
        at *block;
        says "block {block}: {cause}";

        /// One face of a volume failed; the cause says why.
        InFaceOfVolume {
            /// The direction across the face: 0, 1, 2 for s, t, u.
            axis: usize,
            /// Its position in this direction: 0 or 1.
            end: usize,
            /// What went wrong in it.
            cause: Box<Error>,
        }
        of cause;
        says "the face at {} = {end}: {cause}", parameters(*axis)[0];

        /// One quad of a net failed; the cause says why.
        InQuad {
            /// Which quad, from 0, s fastest.
            quad: usize,
            /// What went wrong in it.
            cause: Box<Error>,
        }
        of cause;
        at *quad;
        says "quad {quad}: {cause}";

        /// A number of one branch of a tee failed; the cause says why.
        InBranch {
            /// Which branch, from 0.
            branch: usize,
            /// Which of its numbers.
            what: ErrorItem,
            /// What went wrong with it.
            cause: Box<Error>,
        }
        of cause;
        at *branch;
        says "branch {branch}, {what}: {cause}";

        /// A field of the input failed; the cause says why.
        InField {
            /// Which one.
            field: &'static str,
            /// What went wrong with it.
            cause: Box<Error>,
        }
        of cause;
        at cause.index();
        entry *field;
        says "{cause}";

        /// One triangle of a mesh failed; the cause says why.
        InTriangle {
            /// Which triangle, from 0.
            triangle: usize,
            /// What went wrong in it.
            cause: Box<Error>,
        }
        of cause;
        at *triangle;
        says "triangle {triangle}: {cause}";

        /// One span of a chain failed; the cause says why.
        InSpan {
            /// Which span, from 0.
            span: usize,
            /// What went wrong in it.
            cause: Box<Error>,
        }
        of cause;
        at *span;
        says "span {span}: {cause}";
    }
}

impl std::error::Error for PartError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::InBlock { cause, .. }
            | Self::InFaceOfVolume { cause, .. }
            | Self::InQuad { cause, .. }
            | Self::InBranch { cause, .. }
            | Self::InField { cause, .. }
            | Self::InTriangle { cause, .. }
            | Self::InSpan { cause, .. } => Some(cause.as_ref()),
        }
    }
}

impl Error {
    /// Wraps the error as the failure of one quad of a net.
    #[must_use]
    pub fn in_quad(self, quad: usize) -> Self {
        PartError::InQuad { quad, cause: Box::new(self) }.into()
    }

    /// Wraps the error as the failure of one block of a grid.
    pub(crate) fn in_block(self, block: usize) -> Self {
        PartError::InBlock { block, cause: Box::new(self) }.into()
    }

    /// Wraps the error as the failure of one face of a volume.
    pub(crate) fn in_face_of_volume(self, axis: usize, end: usize) -> Self {
        PartError::InFaceOfVolume { axis, end, cause: Box::new(self) }.into()
    }

    /// Wraps the error as the failure of a number of one branch of a tee.
    #[must_use]
    pub fn in_branch(self, branch: usize, what: ErrorItem) -> Self {
        PartError::InBranch { branch, what, cause: Box::new(self) }.into()
    }

    /// Wraps the error as that of a field of the input, which its cause does not know.
    #[must_use]
    pub fn in_field(self, field: &'static str) -> Self {
        PartError::InField { field, cause: Box::new(self) }.into()
    }

    /// Wraps the error as the failure of one triangle of a mesh.
    #[must_use]
    pub fn in_triangle(self, triangle: usize) -> Self {
        PartError::InTriangle { triangle, cause: Box::new(self) }.into()
    }

    /// Wraps the error as the failure of one span of a chain.
    #[must_use]
    pub fn in_span(self, span: usize) -> Self {
        PartError::InSpan { span, cause: Box::new(self) }.into()
    }
}
