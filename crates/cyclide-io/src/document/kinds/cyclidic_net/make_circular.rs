//! How the vertices of a net are moved so that every quad has a circle, field by field.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::document::forms::forms;

/// Whether the vertices of a net are moved so that the corners of every quad lie on one circle, and what its border may
/// do.
///
/// ```
/// use cyclide_io::document::kinds::MakeCircularSpec;
/// let read: MakeCircularSpec = serde_json::from_str(r#"true"#)?;
/// assert_eq!(read, MakeCircularSpec::Switch(true));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "MakeCircular")]
#[non_exhaustive]
pub enum MakeCircularSpec {
    /// Yes with the default options, or no (the default).
    Switch(bool),
    /// Yes, with these options.
    Options(MakeCircularOptions),
}

impl Default for MakeCircularSpec {
    fn default() -> Self {
        Self::Switch(false)
    }
}

/// How the vertices of a net are moved.
///
/// ```
/// use cyclide_io::document::kinds::{MakeCircularOptions, MakeCircularSpec};
/// let read: MakeCircularSpec = serde_json::from_str(r#"{"max_steps": 50}"#)?;
/// let expected = MakeCircularOptions { max_steps: Some(50), ..Default::default() };
/// assert_eq!(read, MakeCircularSpec::Options(expected));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MakeCircularOptions {
    /// How vertices on the border may move. Default `free`.
    #[serde(default)]
    pub border: BorderSpec,
    /// Number of steps after which the search is given up. Default: 500.
    #[schemars(range(min = 1))]
    pub max_steps: Option<u32>,
    /// Whether to continue with a net that has lost the shape of its grid. Default false: it is rejected.
    #[serde(default)]
    pub allow_shape_change: bool,
}

/// What the border of a net may do: a word, or curves to slide on.
///
/// ```
/// use cyclide_io::document::kinds::{BorderSpec, BorderWord, MakeCircularSpec};
/// let read: MakeCircularSpec = serde_json::from_str(r#"{"border": "pinned"}"#)?;
/// let MakeCircularSpec::Options(options) = read else { unreachable!("it has options") };
/// assert_eq!(options.border, BorderSpec::Word(BorderWord::Pinned));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Border")]
#[non_exhaustive]
pub enum BorderSpec {
    /// The same for all sides.
    Word(BorderWord),
    /// The sides slide along curves of the model.
    Curves(BorderCurves),
}

impl Default for BorderSpec {
    fn default() -> Self {
        Self::Word(BorderWord::Free)
    }
}

/// What every side of a border may do.
///
/// ```
/// use cyclide_io::document::kinds::BorderWord;
/// assert_eq!(serde_json::from_str::<BorderWord>(r#""pinned""#)?, BorderWord::Pinned);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum BorderWord {
    /// Border vertices move like the others.
    #[default]
    Free,
    /// Border vertices stay fixed.
    Pinned,
}

/// Names of curves of the model along which the sides of a border slide; an omitted side is free. Rows run along s and
/// columns along t; for a grid from a file see the field `frame` of the net.
///
/// ```
/// use cyclide_io::document::kinds::{BorderCurves, BorderSpec, MakeCircularSpec};
/// let read: MakeCircularSpec = serde_json::from_str(r#"{"border": {"first_row": "eaves"}}"#)?;
/// let MakeCircularSpec::Options(options) = read else { unreachable!("it has options") };
/// let curves = BorderCurves { first_row: Some("eaves".to_owned()), ..Default::default() };
/// assert_eq!(options.border, BorderSpec::Curves(curves));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BorderCurves {
    /// Name of the curve of the first row, t = 0.
    pub first_row: Option<String>,
    /// Name of the curve of the last row, t = 1.
    pub last_row: Option<String>,
    /// Name of the curve of the first column, s = 0.
    pub first_column: Option<String>,
    /// Name of the curve of the last column, s = 1.
    pub last_column: Option<String>,
}

impl BorderCurves {
    /// The fields by name, in the kernel's order of sides: t = 0, t = 1, s = 0, s = 1.
    pub(in crate::document) fn sides(&self) -> [(&'static str, Option<&str>); 4] {
        [
            ("first_row", self.first_row.as_deref()),
            ("last_row", self.last_row.as_deref()),
            ("first_column", self.first_column.as_deref()),
            ("last_column", self.last_column.as_deref()),
        ]
    }
}

impl MakeCircularSpec {
    /// The options, if the vertices are to be moved.
    pub(in crate::document) fn options(&self) -> Option<MakeCircularOptions> {
        match self {
            Self::Switch(false) => None,
            Self::Switch(true) => Some(MakeCircularOptions::default()),
            Self::Options(options) => Some(options.clone()),
        }
    }

    /// True if every vertex of the border may move anywhere.
    pub(in crate::document) fn border_is_free(&self) -> bool {
        match self {
            Self::Switch(_) => true,
            Self::Options(options) => options.border == BorderSpec::default(),
        }
    }

    /// True if the border stays where it is.
    pub(in crate::document) fn border_is_pinned(&self) -> bool {
        matches!(self, Self::Options(MakeCircularOptions { border: BorderSpec::Word(BorderWord::Pinned), .. }))
    }

    /// The curves on which sides slide.
    pub(in crate::document) fn border_curves(&self) -> Option<&BorderCurves> {
        match self {
            Self::Options(MakeCircularOptions { border: BorderSpec::Curves(curves), .. }) => Some(curves),
            _ => None,
        }
    }
}

forms! {
    MakeCircularSpec: "true, false or options `{\"border\": …}`";
    switch bool => MakeCircularSpec::Switch;
    object MakeCircularOptions => MakeCircularSpec::Options;
}

forms! {
    BorderSpec: "\"free\", \"pinned\" or curves by side `{\"first_row\": NAME, …}`";
    word BorderWord => BorderSpec::Word;
    object BorderCurves => BorderSpec::Curves;
}
