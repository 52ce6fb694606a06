//! Why a file could not be made.

use cyclide::ShortNumber;
use std::path::PathBuf;

/// Why a file could not be made.
///
/// ```
/// use cyclide_io::Format;
/// let error = Format::from_path("logo.iges".as_ref()).unwrap_err();
/// assert!(error.to_string().ends_with("; .step carries curves and surfaces to CAD"));
/// ```
#[derive(thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The suffix stands for no known format.
    #[error("{}: no format for this suffix; known are {known}{hint}", path.display())]
    UnknownSuffix {
        /// The file's path.
        path: PathBuf,
        /// The suffixes that are known.
        known: String,
        /// What to write in its place, as the end of the sentence; empty if there is no telling.
        hint: String,
    },
    /// The model has no curve and no surface.
    #[error("there is nothing to write")]
    Empty,
    /// The tolerance is not a positive number.
    #[error("the tolerance {} is not positive", ShortNumber(*.tolerance))]
    ToleranceNotPositive {
        /// The tolerance given.
        tolerance: f64,
    },
    /// Coordinates are too large for the formats' arithmetic.
    #[error("object {object}: coordinate {} is beyond {}", ShortNumber(*.value), ShortNumber(*.limit))]
    TooLarge {
        /// Name of the object.
        object: String,
        /// Largest coordinate found.
        value: f64,
        /// Largest one accepted.
        limit: f64,
    },
    /// An object is too small for the formats' arithmetic.
    #[error("object {object} is {} large, below {}: use smaller units", ShortNumber(*.size), ShortNumber(*.limit))]
    TooSmall {
        /// Name of the object.
        object: String,
        /// Diagonal of its box.
        size: f64,
        /// Smallest one accepted.
        limit: f64,
    },
    /// The curve has no form of the kind that the format needs.
    #[error("object {object}, contour {contour}: {source}")]
    Lowering {
        /// Name of the object.
        object: String,
        /// Which of its contours, from 0.
        contour: usize,
        /// What the kernel said.
        source: cyclide::Error,
    },
    /// A surface has no form of the kind that the format needs.
    #[error("object {object}, surface {surface}: {source}")]
    Surface {
        /// Name of the object.
        object: String,
        /// Which of its surfaces, from 0.
        surface: usize,
        /// What the kernel said.
        source: cyclide::Error,
    },
    /// The format cannot express this.
    #[error("object {object}: {format} cannot hold this: {detail}")]
    NotInFormat {
        /// Name of the object.
        object: String,
        /// Name of the format.
        format: &'static str,
        /// What cannot be expressed.
        detail: &'static str,
    },
    /// A surface has no exact form, and the format holds exact forms only. What an approximation by patches would be off could be
    /// sampled, not proved.
    #[error(
        "object {object}: {format} holds exact surfaces, and this one has no exact form: write GLB, OBJ, PLY or STL, which hold a mesh \
         within the tolerance, or lay a `principal-grid` on the mesh, whose `cyclidic-net` is exact; or leave the object out with `\"construction\": true`"
    )]
    NoExactForm {
        /// Name of the object.
        object: String,
        /// Name of the format.
        format: &'static str,
    },
    /// The format's numbers are rounded by more than the tolerance.
    #[error(
        "object {object}: {format} rounds coordinates of up to {} by {}, more than the tolerance {}: {hint}",
        ShortNumber(*.largest), ShortNumber(*.rounding), ShortNumber(*.tolerance)
    )]
    Rounding {
        /// Name of the object.
        object: String,
        /// Name of the format.
        format: &'static str,
        /// Largest coordinate.
        largest: f64,
        /// How far a vertex moves.
        rounding: f64,
        /// The tolerance.
        tolerance: f64,
        /// What to do instead.
        hint: &'static str,
    },
    /// A face has an edge that readers of the format take for a point.
    #[error(
        "object {object}: an edge is only {} mm long, and readers of {format} take points nearer than {} mm for one, which spoils the faces \
         there: make it longer, leave it out, or write another format",
        ShortNumber(*.length), ShortNumber(*.limit)
    )]
    EdgeTooShort {
        /// Name of the object.
        object: String,
        /// Name of the format.
        format: &'static str,
        /// Length of the edge in millimetres.
        length: f64,
        /// Shorter ones are refused.
        limit: f64,
    },
    /// A motion lasts longer or shorter than the numbers of the format tell.
    #[error(
        "object {object}: GLB has times and speeds of single precision, for motions of {} to {} seconds, and this one takes {}: give it another `duration`",
        ShortNumber(*.min), ShortNumber(*.max), ShortNumber(*.seconds)
    )]
    Duration {
        /// Name of the object.
        object: String,
        /// How long it lasts.
        seconds: f64,
        /// Shortest.
        min: f64,
        /// Longest.
        max: f64,
    },
    /// Keys of an animation do not keep the tolerance, however many: the motion is too fast for the times that the format has, or so fine that
    /// there would be too many.
    #[error(
        "object {object}: {keys} keys of the animation leave the body {} off at {} seconds, more than the tolerance {}: its motion is too fast there; {hint}, \
         or take a larger tolerance",
        ShortNumber(*.off), ShortNumber(*.seconds), ShortNumber(*.tolerance)
    )]
    Keyframes {
        /// Name of the object.
        object: String,
        /// How far a point of the body is off.
        off: f64,
        /// The tolerance.
        tolerance: f64,
        /// When.
        seconds: f64,
        /// How many keys there are.
        keys: usize,
        /// What to do instead.
        hint: &'static str,
    },
    /// The picture could not be encoded.
    #[error("the picture could not be encoded: {detail}")]
    Picture {
        /// What the encoder said.
        detail: String,
    },
}

/// The sentence and the reason: what a program prints whose `main` returns the error.
impl std::fmt::Debug for ExportError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self} [{}]", self.reason())
    }
}

impl ExportError {
    /// Stable kebab-case name of the reason; the kernel's own where a curve could not be lowered.
    #[must_use]
    pub fn reason(&self) -> &'static str {
        match self {
            Self::UnknownSuffix { .. } => "unknown-suffix",
            Self::Empty => "empty-model",
            Self::ToleranceNotPositive { .. } => "tolerance-not-positive",
            Self::TooLarge { .. } => "coordinate-too-large",
            Self::TooSmall { .. } => "object-too-small",
            Self::Lowering { source, .. } | Self::Surface { source, .. } => source.reason(),
            Self::NotInFormat { .. } => "not-in-format",
            Self::NoExactForm { .. } => "no-exact-form",
            Self::Rounding { .. } => "rounding-above-tolerance",
            Self::EdgeTooShort { .. } => "edge-too-short",
            Self::Duration { .. } => "duration-out-of-range",
            Self::Keyframes { .. } => "animation-above-tolerance",
            Self::Picture { .. } => "picture",
        }
    }
}
