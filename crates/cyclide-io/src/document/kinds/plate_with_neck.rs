//! A pipe on a plate with a rounded neck.

use cyclide::{
    construct::{NeckBlend, NeckBody, NeckSide, NeckVariant, PlateShape},
    model::SurfaceObject,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::forms::forms;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::objects::Builder;
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::error::Result;

/// A pipe on a plate with a rounded neck between them, made by a ball that rolls around the pipe; an open surface, or
/// with a `thickness` a solid. The upper side of the plate is the plane z = 0, and the axis of the pipe meets it at the
/// origin.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "plate-with-neck", "pipe_radius": 15, "ball_radius": 8, "height": 50, "plate": [90, 90]}}}"#.parse()?;
/// let built = document.build()?;
/// assert!(built[0].bodies[0].outer.area() > 90.0 * 90.0 && !built[0].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    extend("dependentRequired" = {"wall": ["thickness"]}),
    extend("if" = {"properties": {"side": {"const": "inside"}}, "required": ["side"]}),
    extend("then" = {"properties": {"plate": false}}),
    extend("else" = {"required": ["plate"]})
)]
#[non_exhaustive]
pub struct PlateWithNeckSpec {
    /// The word `plate-with-neck`.
    #[schemars(with = "String", extend("const" = "plate-with-neck"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Radius of the pipe on the side of the ball: its outer radius, or with the side `inside` its inner radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub pipe_radius: f64,
    /// Radius of the ball, which rounds the corner. Inside a pipe it is smaller than that of the pipe.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub ball_radius: f64,
    /// Angle between the axis of the pipe and the normal of the plate; the pipe leans towards y. Default 0.
    pub slope: Option<Angle>,
    /// Distance of the end of the pipe from the plate, along the axis.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub height: f64,
    /// The plate around the axis. A pipe with the neck inside has no plate, only its floor.
    pub plate: Option<PlateSpec>,
    /// Whether the ball rolls outside or inside the pipe.
    #[serde(default)]
    pub side: NeckSide,
    /// The arcs of the neck.
    #[serde(default)]
    pub variant: NeckVariant,
    /// Thickness of the plate, or of the floor inside a pipe, downwards; makes a solid.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub thickness: Option<f64>,
    /// Wall thickness of the pipe in a solid. Default: with the neck outside the pipe is filled (with a wall it has a
    /// bore through the plate); with the neck inside the wall is as thick as the floor.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub wall: Option<f64>,
}

/// The outline of a plate: the sides of a rectangle along x and y, or the radius of a disk.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "plate-with-neck", "pipe_radius": 15, "ball_radius": 8, "height": 50, "plate": [90, 90]}}}"#.parse()?;
/// let built = document.build()?;
/// let bounds = built[0].bodies[0].bounds();
/// assert!((bounds.max.x - bounds.min.x - 90.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, JsonSchema)]
#[schemars(untagged, rename = "Plate")]
#[non_exhaustive]
pub enum PlateSpec {
    /// Sides along x and y.
    #[schemars(extend("items" = {"type": "number", "exclusiveMinimum": 0}))]
    Rectangle([f64; 2]),
    /// A disk.
    Disk(DiskSpec),
}

impl PlateSpec {
    /// What the kernel calls it.
    pub(in crate::document) fn shape(self) -> PlateShape {
        match self {
            Self::Rectangle(sides) => PlateShape::Rectangle(sides),
            Self::Disk(disk) => PlateShape::Disk(disk.radius),
        }
    }
}

/// A disk.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "plate-with-neck", "pipe_radius": 15, "ball_radius": 8, "height": 50, "plate": {"radius": 40}}}}"#.parse()?;
/// let built = document.build()?;
/// let bounds = built[0].bodies[0].bounds();
/// assert!((bounds.max.x - bounds.min.x - 80.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Disk")]
#[non_exhaustive]
pub struct DiskSpec {
    /// Its radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
}

forms! {
    PlateSpec: "two sides `[80, 60]` or `{\"radius\": …}`";
    list [f64; 2] => PlateSpec::Rectangle;
    object DiskSpec => PlateSpec::Disk;
}

impl Kind for PlateWithNeckSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.plate_with_neck(self).map(Shape::Surfaces)
    }

    fn fields(&self) -> FieldNames {
        vec![("blend", "ball_radius")]
    }
}

impl Builder<'_> {
    /// A pipe on a plate, or with a floor.
    pub(in crate::document) fn plate_with_neck(&mut self, spec: &PlateWithNeckSpec) -> Result<Vec<SurfaceObject>> {
        let side = spec.side;
        if side == NeckSide::Inside && spec.plate.is_some() {
            return Err(self.unfit("a neck inside a pipe uses the floor of the pipe as its plate: remove `plate`"));
        }
        if side == NeckSide::Outside && spec.plate.is_none() {
            return Err(self.unfit("a neck outside a pipe requires a `plate`: `[80, 60]` or `{\"radius\": 40}`"));
        }
        if spec.wall.is_some() && spec.thickness.is_none() {
            return Err(self.unfit("`wall` requires `thickness`, which makes a solid"));
        }
        let slope = spec.slope.map_or(0.0, Angle::radians);
        let neck = NeckBlend::new(spec.pipe_radius, spec.ball_radius, slope, side, spec.variant);
        let neck = neck.map_err(|e| self.refused(&e, None))?;
        let mut made = NeckBody::new(spec.height);
        (made.plate, made.thickness, made.wall) = (spec.plate.map(PlateSpec::shape), spec.thickness, spec.wall);
        let body = neck.body(&made).map_err(|e| self.refused(&e, None))?;
        for warning in neck.warnings() {
            self.warn_at("ball_radius", None, warning);
        }
        Ok(vec![SurfaceObject::Body(body)])
    }
}
