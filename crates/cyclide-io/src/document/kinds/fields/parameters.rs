//! Parameters and vectors of curves through points.

use cyclide::{Vec3, construct::NodeParameters};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::document::coordinates::Coordinates;
use crate::document::forms::forms;
use crate::document::objects::contours::Contour;

/// Parameters by a rule, or one by one.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"q": {"type": "qb-interpolation", "parameters": [0, 0.2, 1], "points": [[0, 0], [1, 1], [3, 0]]}}}"#.parse()?;
/// let curve = document.build()?;
/// assert!((curve[0].item.curves()[0].as_curve().point(0.2).x - 1.0).abs() < 1e-14);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Parameters")]
pub enum ParametersSpec {
    /// By a rule.
    Rule(ParameterRule),
    /// The given numbers; for a `qb-interpolation` in `[0, 1]` and in any order.
    Each(Vec<f64>),
}

/// How parameters follow from points.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"q": {"type": "qb-interpolation", "parameters": "uniform", "points": [[0, 0], [1, 1], [3, 0]]}}}"#.parse()?;
/// assert!((document.build()?[0].item.curves()[0].as_curve().point(0.5).x - 1.0).abs() < 1e-14);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ParameterRule {
    /// `centripetal` for points in one plane, else `chord`.
    #[default]
    Auto,
    /// In proportion to the distances between the points.
    Chord,
    /// In proportion to the square roots of these distances.
    Centripetal,
    /// Evenly spaced.
    Uniform,
}

impl Default for ParametersSpec {
    fn default() -> Self {
        Self::Rule(ParameterRule::default())
    }
}

forms! {
    ParametersSpec: "`auto`, `chord`, `centripetal`, `uniform`, or a list of numbers";
    word ParameterRule => ParametersSpec::Rule;
    list Vec<f64> => ParametersSpec::Each;
}

/// Those given go with the points as given; `more` follow them.
pub(in crate::document) fn node_parameters(spec: &ParametersSpec, at: &Contour<'_>, more: usize) -> NodeParameters {
    match spec {
        ParametersSpec::Rule(ParameterRule::Auto) => NodeParameters::Automatic,
        ParametersSpec::Rule(ParameterRule::Chord) => NodeParameters::Chord,
        ParametersSpec::Rule(ParameterRule::Centripetal) => NodeParameters::Centripetal,
        ParametersSpec::Rule(ParameterRule::Uniform) => NodeParameters::Uniform,
        ParametersSpec::Each(given) => {
            let points = given_count(at);
            if given.len() != points + more {
                return NodeParameters::Given(given.clone());
            }
            let own = at.kept.iter().filter_map(|&i| given.get(i)).copied();
            NodeParameters::Given(own.chain(given[points..].iter().copied()).collect())
        }
    }
}

/// Points of the list as given, up to the last one that was kept.
pub(in crate::document) fn given_count(at: &Contour<'_>) -> usize {
    at.kept.last().map_or(0, |last| last + 1)
}

pub(in crate::document) fn vectors(list: &[Coordinates]) -> Vec<Vec3> {
    list.iter().map(|v| v.vector()).collect()
}
