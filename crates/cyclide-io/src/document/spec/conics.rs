//! Ellipses and helices, field by field.

use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;

/// An ellipse or an arc of one, exact: a rational curve of degree 2.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"e": {"type": "ellipse", "center": [0, 0], "semi_axes": [5, 3]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[0].item.curves()[0].as_curve().is_closed());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct EllipseSpec {
    /// The word `ellipse`.
    #[schemars(with = "String", extend("const" = "ellipse"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Center.
    pub center: Coordinates,
    /// Both semi-axes, that along `x_direction` first.
    pub semi_axes: [f64; 2],
    /// Axis about which it runs counter-clockwise, of any length. Default `[0, 0, 1]`.
    pub normal: Option<Coordinates>,
    /// Direction of the first semi-axis. Default `[1, 0, 0]`, as far as it is in the plane; `[0, 1, 0]` where that is its normal.
    pub x_direction: Option<Coordinates>,
    /// Where an arc starts, as an angle of the parameter (as in DXF): `center + cos(angle) a + sin(angle) b`. Default 0.
    pub start: Option<Angle>,
    /// How far it runs in this angle; negative clockwise. Default: a whole turn.
    pub sweep: Option<Angle>,
}

/// A helix: a spring, a thread, a coil. Two of `pitch`, `height` and `turns` say how it rises.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"h": {"type": "helix", "radius": 10, "pitch": 5, "turns": 4}}}"#.parse()?;
/// let built = document.build()?;
/// let end = built[0].item.curves()[0].as_curve().point(1.0);
/// assert!(end.distance(cyclide::Point3::new(10.0, 0.0, 20.0)) < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct HelixSpec {
    /// The word `helix`.
    #[schemars(with = "String", extend("const" = "helix"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The point of the axis at the height of the start. Default: the origin.
    pub center: Option<Coordinates>,
    /// The axis, of any length. Default `[0, 0, 1]`.
    pub axis: Option<Coordinates>,
    /// From the axis to the start. Default `[1, 0, 0]`, as far as it is across the axis; `[0, 1, 0]` where that is the axis.
    pub x_direction: Option<Coordinates>,
    /// Distance from the axis.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Rise along the axis over one turn.
    pub pitch: Option<f64>,
    /// Rise along the axis in all.
    pub height: Option<f64>,
    /// Number of turns, which need not be whole.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub turns: Option<f64>,
    /// Which way it turns.
    #[serde(default)]
    pub hand: Hand,
    /// Largest distance of the curve from the helix, which is not rational; it lies on the cylinder exactly. Default: a millionth of the radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
}

/// Which way a helix turns as it rises.
///
/// ```
/// use cyclide_io::Hand;
/// assert_eq!(Hand::default(), Hand::Right);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
pub enum Hand {
    /// As a common screw: counter-clockwise seen from above.
    #[default]
    Right,
    /// Clockwise seen from above.
    Left,
}
