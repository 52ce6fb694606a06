//! Why a file could not be made.

use cyclide::ShortNumber;
use std::path::PathBuf;

/// Why a file could not be made.
///
/// ```
/// use cyclide_io::Format;
/// let error = Format::from_path("logo.iges".as_ref()).unwrap_err();
/// assert!(error.to_string().ends_with("; .step transfers curves and surfaces to CAD"));
/// ```
#[derive(thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The suffix belongs to no known format.
    #[error("{}: no format with this suffix; known suffixes are {known}{hint}", path.display())]
    UnknownSuffix {
        /// The file's path.
        path: PathBuf,
        /// The suffixes that are known.
        known: String,
        /// What to write instead, as the end of the sentence; may be empty.
        hint: String,
    },
    /// The model has no curve and no surface.
    #[error("the model has nothing to write")]
    Empty,
    /// The tolerance is not a positive number.
    #[error("the tolerance {} is not positive", ShortNumber(*.tolerance))]
    ToleranceNotPositive {
        /// The tolerance given.
        tolerance: f64,
    },
    /// Coordinates are too large for the arithmetic of the formats.
    #[error("object {object}: coordinate {} exceeds {}", ShortNumber(*.value), ShortNumber(*.limit))]
    TooLarge {
        /// Name of the object.
        object: String,
        /// Largest coordinate found.
        value: f64,
        /// Largest one accepted.
        limit: f64,
    },
    /// An object is too small for the arithmetic of the formats.
    #[error("object {object}: size {} is below {}: use smaller units", ShortNumber(*.size), ShortNumber(*.limit))]
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
        /// The error of the kernel.
        source: cyclide::Error,
    },
    /// A surface has no form of the kind that the format needs.
    #[error("object {object}, surface {surface}: {source}")]
    Surface {
        /// Name of the object.
        object: String,
        /// Which of its surfaces, from 0.
        surface: usize,
        /// The error of the kernel.
        source: cyclide::Error,
    },
    /// The format cannot express this.
    #[error("object {object}: {format} cannot represent this: {detail}")]
    NotInFormat {
        /// Name of the object.
        object: String,
        /// Name of the format.
        format: &'static str,
        /// What cannot be expressed.
        detail: &'static str,
    },
    /// A surface has no exact form, and the format contains exact forms only. The deviation of an approximation by patches could
    /// be sampled, but not proved.
    #[error(
        "object {object}: {format} requires exact surfaces, and this one has no exact form: write GLB, OBJ, PLY or \
         STL, which contain a mesh within the tolerance, or compute a `principal-grid` on the mesh, whose \
         `cyclidic-net` is exact; or leave the object out with `\"construction\": true`"
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
    /// A face has an edge so short that readers of the format merge its ends.
    #[error(
        "object {object}: an edge is only {} mm long, and readers of {format} merge points closer than {} mm, which \
         corrupts the faces there: make the edge longer, remove it, or write another format",
        ShortNumber(*.length), ShortNumber(*.limit)
    )]
    EdgeTooShort {
        /// Name of the object.
        object: String,
        /// Name of the format.
        format: &'static str,
        /// Length of the edge in millimeters.
        length: f64,
        /// Shorter ones are refused.
        limit: f64,
    },
    /// The duration of a motion is outside the range of the format.
    #[error(
        "object {object}: GLB stores times in single precision, for motions of {} to {} seconds, and this one takes {}: set another `duration`",
        ShortNumber(*.min), ShortNumber(*.max), ShortNumber(*.seconds)
    )]
    Duration {
        /// Name of the object.
        object: String,
        /// Its duration.
        seconds: f64,
        /// Shortest.
        min: f64,
        /// Longest.
        max: f64,
    },
    /// No number of animation keys meets the tolerance: the motion is too fast for the time resolution of the format, or would need too
    /// many keys.
    #[error(
        "object {object}: with {keys} keys the animation deviates by {} at {} seconds, more than the tolerance {}: the \
         motion is too fast there; {hint}, or use a larger tolerance",
        ShortNumber(*.off), ShortNumber(*.seconds), ShortNumber(*.tolerance)
    )]
    Keyframes {
        /// Name of the object.
        object: String,
        /// Deviation of a point of the body.
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
        /// The error of the encoder.
        detail: String,
    },
}

/// The message and the reason, as printed by a program whose `main` returns the error.
impl std::fmt::Debug for ExportError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self} [{}]", self.reason())
    }
}

impl ExportError {
    /// Stable kebab-case name of the reason; that of the kernel if a curve could not be converted.
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
