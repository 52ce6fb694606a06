//! A whole Dupin cyclide.

use cyclide::{
    error::PointError,
    model::SurfaceObject,
    surface::{DupinCyclide, Torus},
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::frame::frame_of_axes;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::error::Result;

/// Patches of a whole cyclide round the hole and round the tube.
pub(in crate::document) const SEGMENTS: [u32; 2] = [4, 4];

/// A whole Dupin cyclide, given by its three parameters: the points with `(|p|^2 + b^2 - mu^2)^2 = 4 (a x - c mu)^2 + 4
/// b^2 y^2`, where `b^2 = a^2 - c^2`. With `c = 0` it is the torus with the radii a and mu.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"r": {"type": "cyclide", "a": 3, "mu": 1}}}"#.parse()?;
/// let built = document.build()?;
/// assert!((built[0].bodies[0].outer.area() - 12.0 * std::f64::consts::PI.powi(2)).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CyclideSpec {
    /// The word `cyclide`.
    #[schemars(with = "String", extend("const" = "cyclide"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Half the long axis of the ellipse of centers.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub a: f64,
    /// Distance of the foci of that ellipse from its center, less than `a`. A ring has c < mu < a.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub c: f64,
    /// Mean radius of the tube.
    #[schemars(range(min = 0.0))]
    pub mu: f64,
    /// Position of the center. Default: the origin.
    pub center: Option<Coordinates>,
    /// Axis of the ring (z above), of any length. Default `[0, 0, 1]`.
    pub axis: Option<Coordinates>,
    /// Direction of the long axis (x above), perpendicular to `axis`, of any length. Default `[1, 0, 0]`, or for
    /// another `axis` the direction nearest to it.
    pub x_direction: Option<Coordinates>,
    /// Number of patches around the hole and around the tube; odd numbers are rounded up. Default `[4, 4]`.
    #[schemars(inner(range(min = 3, max = 4096)))]
    pub segments: Option<[u32; 2]>,
}

impl Kind for CyclideSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.cyclide(self).map(Shape::Surfaces)
    }

    fn torus(&self, at: &Builder<'_>, name: &str) -> Option<Result<Torus>> {
        if self.c != 0.0 {
            let c = self.c;
            return Some(Err(at.no_torus(format!("`{name}` is a `cyclide` with `c` = {c}: a torus requires `c` = 0"))));
        }
        let made = frame_of_axes(self.center, self.axis, self.x_direction)
            .and_then(|frame| Torus::new(frame, self.a, self.mu));
        Some(made.map_err(|e| at.refused_at([Step::from("torus")], &e)))
    }

    fn fields(&self) -> FieldNames {
        vec![("normal", "axis")]
    }

    fn words(&self, error: &cyclide::Error) -> Option<String> {
        // What is the normal of a frame to the kernel.
        matches!(error, cyclide::Error::Point(PointError::ZeroAxis { .. })).then(|| "the axis is zero".to_owned())
    }
}

impl<'a> Builder<'a> {
    /// A whole cyclide as one closed net, or as several that touch in the nodes.
    pub(in crate::document) fn cyclide(&self, spec: &CyclideSpec) -> Result<Vec<SurfaceObject>> {
        let made = || {
            let frame = frame_of_axes(spec.center, spec.axis, spec.x_direction)?;
            let segments = spec.segments.unwrap_or(SEGMENTS).map(|n| n as usize);
            DupinCyclide::new(spec.a, spec.c, spec.mu)?.placed(frame).nets(segments)
        };
        let nets = made().map_err(|e| self.refused(&e, None))?;
        Ok(nets.into_iter().map(SurfaceObject::Net).collect())
    }
}
