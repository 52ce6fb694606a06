//! A smooth patch over one triangle, shaped by three spheres.

use cyclide::{
    Error as KernelError,
    error::{ErrorItem, MeshError, NumberError, PartError, PatchError, TriangleError},
    model::SurfaceObject,
    surface::{SphereBlend, TriangleSurface},
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::{Kind, Shape};
use crate::error::{Error, Result};

/// A smooth patch over one triangle, shaped at each corner by a sphere through the circle of the three corners. The
/// spheres are given by a point of each (`control`), or by the normals that the patch should have at the corners
/// (`normals`). Like a smooth mesh, the patch has no exact form.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"s": {"type": "sphere-blend", "corners": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "normals": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}}}"#.parse()?;
/// let built = document.build()?;
/// let report = cyclide_io::report::ObjectReport::new(&built[0], None);
/// let cyclide_io::report::GeometryReport::Smooth(found) = report.geometry else { unreachable!("by its type") };
/// assert_eq!((found.triangles, found.vertices, found.closed), (1, 3, false));
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("oneOf" = [
    { "required": ["control"], "properties": { "normals": false } },
    { "required": ["normals"], "properties": { "control": false } }
]))]
#[non_exhaustive]
pub struct SphereBlendSpec {
    /// The word `sphere-blend`.
    #[schemars(with = "String", extend("const" = "sphere-blend"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The corners, counter-clockwise seen from outside.
    pub corners: [Coordinates; 3],
    /// A point on the sphere of each corner, off the circle of the corners. The patch bulges to the side of these
    /// points.
    pub control: Option<[Coordinates; 3]>,
    /// The normal at each corner, of any length; its component along the circle's tangent there has no effect.
    pub normals: Option<[Coordinates; 3]>,
}

impl Kind for SphereBlendSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.sphere_blend(self).map(Shape::Surfaces)
    }
}

impl Builder<'_> {
    /// The patch over one triangle.
    pub(in crate::document) fn sphere_blend(&mut self, spec: &SphereBlendSpec) -> Result<Vec<SurfaceObject>> {
        let corners = spec.corners.map(Coordinates::point);
        let (blend, shape) = match (spec.control, spec.normals) {
            (Some(points), None) => {
                (SphereBlend::from_control_points(corners, points.map(Coordinates::point)), "control")
            }
            (None, Some(normals)) => (SphereBlend::from_normals(corners, normals.map(Coordinates::vector)), "normals"),
            _ => {
                let needed = "a sphere blend requires exactly one of `control` (a point of each sphere) and `normals`";
                return Err(self.unfit(needed));
            }
        };
        let blend = blend.and_then(SphereBlend::whole).map_err(|e| self.refused_blend(shape, &e))?;
        for warning in blend.warnings() {
            self.warn_at(shape, None, warning);
        }
        Ok(vec![TriangleSurface::from(blend).into()])
    }

    /// What the kernel refused; `shape` is the field that gives the spheres.
    fn refused_blend(&self, shape: &'static str, error: &KernelError) -> Error {
        let error = if let KernelError::Part(PartError::InTriangle { cause, .. }) = error { cause } else { error };
        let steps: Vec<Step> = match *error {
            KernelError::Triangle(TriangleError::ControlPointOnCircumcircle { corner, .. }) => {
                vec!["control".into(), corner.into()]
            }
            KernelError::Mesh(MeshError::UndefinedNormal { vertex, .. }) if shape == "normals" => {
                vec!["normals".into(), vertex.into()]
            }
            KernelError::Number(NumberError::NotFinite { what: ErrorItem::Normal, index }) => {
                vec!["normals".into(), index.into()]
            }
            KernelError::Triangle(TriangleError::OppositeSpheres { .. })
            | KernelError::Patch(PatchError::ThroughInfinity { .. }) => vec![shape.into()],
            _ => vec!["corners".into()],
        };
        self.refused_at(steps, error)
    }
}
