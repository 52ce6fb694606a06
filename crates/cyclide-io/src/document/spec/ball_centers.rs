//! Where the centres of the balls of a blend are, field by field.

use schemars::JsonSchema;
use serde::Deserialize;

use super::TypeWord;
use super::comment::Comment;

/// The ways of the centres of the balls that make the blends of a tee, a crossing or a contact blend: closed, exact rational curves.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {
///     "c": {"type": "pipe-crossing", "pipes": [{"radius": 10, "ends": [-40, 40]}, {"radius": 8, "ends": [-35, 35]}], "distance": 12, "blend": 4},
///     "m": {"type": "ball-centers", "of": "c"}}}"#.parse()?;
/// let built = document.build()?;
/// // As far from the axis of the first pipe as its radius and the ball's.
/// let m = built[1].item.curves()[0].as_curve().point(0.2);
/// assert!((m.y.hypot(m.z) - 14.0).abs() < 4e-3);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallCentersSpec {
    /// The word `ball-centers`.
    #[schemars(with = "String", extend("const" = "ball-centers"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the `pipe-tee`, `pipe-crossing` or `contact-blend`; it may be construction geometry.
    pub of: String,
}

/// The surface of the centres of all balls that touch the two pipes of a crossing, round the way of those that make its blend: an exact patch of degree (2, 2).
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {
///     "c": {"type": "pipe-crossing", "pipes": [{"radius": 10, "ends": [-40, 40]}, {"radius": 8, "ends": [-35, 35]}], "distance": 12, "blend": 4},
///     "s": {"type": "center-surface", "of": "c", "margin": 0.5}}}"#.parse()?;
/// let built = document.build()?;
/// assert_eq!(built[1].bodies[0].outer.faces().len(), 1);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CenterSurfaceSpec {
    /// The word `center-surface`.
    #[schemars(with = "String", extend("const" = "center-surface"))]
    pub r#type: TypeWord,
    /// What the author remarks; read and left aside.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Name of the `pipe-crossing`, outside or inside both pipes; it may be construction geometry.
    pub of: String,
    /// How much more than the way of the centres it shows: the part of what is left to the balls without end, from 0 to below 1.
    #[serde(default = "quarter")]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub margin: f64,
}

fn quarter() -> f64 {
    0.25
}
