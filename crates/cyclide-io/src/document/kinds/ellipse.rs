//! An ellipse or an elliptical arc.

use cyclide::{
    Vec3,
    construct::Ellipse,
    error::{NumberError, PointError},
    model::CurveObject,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::kind::{Kind, Shape};
use crate::error::{Error, Result};

/// Part of the radius that the tolerance of a helix is if none is given.
pub(in crate::document) const TOLERANCE: f64 = 1e-6;

/// An ellipse or an elliptical arc, exact: a rational curve of degree 2.
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
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Center.
    pub center: Coordinates,
    /// Both semi-axes; the first one is along `x_direction`.
    pub semi_axes: [f64; 2],
    /// Axis about which the ellipse runs counter-clockwise, of any length. Default `[0, 0, 1]`.
    pub normal: Option<Coordinates>,
    /// Direction of the first semi-axis. Default: `[1, 0, 0]`, projected onto the plane of the ellipse; `[0, 1, 0]` if
    /// that is the normal of the plane.
    pub x_direction: Option<Coordinates>,
    /// Start of an arc, as a parameter angle (as in DXF): `center + cos(angle) a + sin(angle) b`. Default 0.
    pub start: Option<Angle>,
    /// Range of the arc in this angle; negative values run clockwise. Default: a whole turn.
    pub sweep: Option<Angle>,
}

impl Kind for EllipseSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        Ok(at.ellipse(self)?.into())
    }
}

impl Builder<'_> {
    /// The ellipse, or an arc of it.
    pub(in crate::document) fn ellipse(&self, spec: &EllipseSpec) -> Result<CurveObject> {
        let normal = spec.normal.map_or(Vec3::Z, Coordinates::vector);
        let x = spec.x_direction.map(Coordinates::vector);
        let ellipse = Ellipse::new(spec.center.point(), normal, x, spec.semi_axes);
        let ellipse = ellipse.map_err(|e| self.refused_conic("semi_axes", "normal", &e))?;
        let sweep = spec.sweep.map_or(std::f64::consts::TAU, Angle::radians);
        let curve = ellipse.to_nurbs(spec.start.map_or(0.0, Angle::radians), sweep);
        curve.map(CurveObject::Nurbs).map_err(|e| self.refused_at(["sweep".into()], &e))
    }

    /// What the kernel refused, at the field it is about.
    pub(in crate::document) fn refused_conic(
        &self,
        size: &'static str,
        axis: &'static str,
        error: &cyclide::Error,
    ) -> Error {
        let field = match error {
            cyclide::Error::Number(NumberError::RadiusNotPositive { .. } | NumberError::NotFinite { .. }) => size,
            cyclide::Error::Point(PointError::ZeroAxis { index: 1, .. }) => "x_direction",
            cyclide::Error::Point(PointError::ZeroAxis { .. }) => axis,
            _ => "center",
        };
        self.refused_at([field.into()], error)
    }
}
