//! A cylinder or cone joined to a sphere or a plate by a rolling-ball fillet.

use cyclide::{
    Vec3,
    construct::{BlendBase, BlendRing, BlendTube, ContactBlend, NeckSide, PlateShape, RingBlend, TeeEnds},
    model::SurfaceObject,
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::plate_with_neck::PlateSpec;
use crate::document::objects::Builder;
use crate::document::objects::facts::{BlendFacts, Facts};
use crate::document::objects::kind::{FieldNames, Kind, Shape};
use crate::error::Result;

/// A cylinder or cone joined by a rolling-ball fillet to a `sphere` about the origin, or to a `plate` whose upper side
/// is z = 0: a strut on a node, a nozzle on a tank, a boss. Alternatively a `ring`, a torus about the z axis, with
/// fillets in the corner around it and in the corner of its hole.
///
/// With the side `inside` the ball rolls in the rim of a tube that ends at the sphere or plane: a rod with a domed end
/// or, with a `wall`, a dished head.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "contact-blend", "tube": {"through": [0, 12], "radius": 10, "length": 90}, "sphere": 40, "blend": 6}}}"#.parse()?;
/// assert!(document.build()?[0].bodies[0].is_solid());
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    extend("allOf" = [
        {"if": {"properties": {"ends": {"const": "open"}}, "required": ["ends"]}, "then": {"properties": {"wall": false, "thickness": false}}},
        {"oneOf": [{"required": ["tube"]}, {"required": ["ring"]}]},
        {"if": {"required": ["ring"]}, "then": {"properties": {"side": {"const": "outside"}, "ends": {"const": "flat"}, "wall": false, "tolerance": false, "plate": {"type": "object"}}}},
        {"if": {"required": ["sphere"]}, "then": {"properties": {"plate": false, "thickness": false}}},
        {"if": {"required": ["wall"]}, "then": {"properties": {"thickness": false}}},
        {"if": {"properties": {"side": {"const": "inside"}}, "required": ["side"]},
         "then": {"properties": {"plate": false, "thickness": false}},
         "else": {"anyOf": [{"required": ["sphere"]}, {"required": ["plate"]}]}}
    ])
)]
#[non_exhaustive]
pub struct ContactBlendSpec {
    /// The word `contact-blend`.
    #[schemars(with = "String", extend("const" = "contact-blend"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// The tube; alternatively a `ring`.
    pub tube: Option<BlendTubeSpec>,
    /// A torus about the z axis, on a sphere or a round plate. The radius of its ball is exact.
    pub ring: Option<BlendRingSpec>,
    /// Radius of the sphere about the origin. Without it the blend is with the plane z = 0.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub sphere: Option<f64>,
    /// Outline of the plate about the origin from which the tube rises. With the side `inside` there is no plate: the
    /// tube ends at the plane.
    pub plate: Option<PlateSpec>,
    /// Thickness of the plate below a filled tube; makes a solid. With a `wall` the plate is as thick as the wall.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub thickness: Option<f64>,
    /// The radius of the ball.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub blend: f64,
    /// Whether the ball rolls outside or inside the tube.
    #[serde(default)]
    pub side: NeckSide,
    /// Largest deviation from the radius of the ball, which no rational blend with a sphere off the axis keeps exactly.
    /// Default: a thousandth of the radius.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tolerance: Option<f64>,
    /// Thickness of all walls: of the tube, the sphere or plate, and the blend between them. Default: filled.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub wall: Option<f64>,
    /// How the tube ends. `open` leaves a surface, without a wall.
    #[serde(default)]
    pub ends: TeeEnds,
}

/// A cylinder, or with a taper a cone.
///
/// ```
/// use cyclide_io::{Document, document::ObjectSpec};
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "contact-blend", "tube": {"radius": 10, "taper": {"degrees": 5}, "length": 90}, "sphere": 40, "blend": 6}}}"#.parse()?;
/// let ObjectSpec::ContactBlend(spec) = &document.objects[0].1 else { panic!("it is one") };
/// let tube = spec.tube.as_ref().expect("it has one");
/// assert!(tube.radius == 10.0 && tube.direction.is_none());
/// assert!((tube.taper.expect("a cone").radians() - 5.0_f64.to_radians()).abs() < 1e-15);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "BlendTube")]
#[non_exhaustive]
pub struct BlendTubeSpec {
    /// A point on its axis. Default: the origin.
    #[serde(default)]
    pub through: Coordinates,
    /// Direction of its axis, towards its end. Default: up, along z.
    pub direction: Option<Coordinates>,
    /// Its outer radius; for a cone, the radius at the point `through`.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Half the cone angle: positive narrows towards the end, negative widens. Default 0, a cylinder.
    pub taper: Option<Angle>,
    /// Position of its end: distance from the point along the axis.
    pub length: f64,
}

/// A torus about the z axis.
///
/// ```
/// use cyclide_io::Document;
/// let document: Document = r#"{"cyclide": 1, "objects": {"n": {"type": "contact-blend", "ring": {"radius": 30, "tube": 8, "height": 5}, "plate": {"radius": 60}, "thickness": 4, "blend": 3}}}"#.parse()?;
/// let built = document.build()?;
/// // From below the plate to the top of the tube.
/// let bounds = built[0].bodies[0].bounds();
/// assert!((bounds.max.z - 13.0).abs() < 1e-9 && (bounds.min.z + 4.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "BlendRing")]
#[non_exhaustive]
pub struct BlendRingSpec {
    /// Radius of the center circle of its tube.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// Radius of its tube, smaller than `radius`.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub tube: f64,
    /// Height of the center circle above the origin. Default 0.
    #[serde(default)]
    pub height: f64,
}

impl ContactBlendSpec {
    /// What it stands on; `None` of the plane at which a tube ends.
    fn base(&self) -> Option<BlendBase> {
        let sphere = self.sphere.map(|radius| BlendBase::Sphere { radius });
        sphere.or_else(|| self.plate.map(|plate| BlendBase::Plane(plate.shape())))
    }
}

impl Kind for ContactBlendSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.contact_blend(self).map(Shape::Surfaces)
    }

    fn fields(&self) -> FieldNames {
        let solid = if self.ring.is_some() { "ring" } else { "tube" };
        vec![("[]", solid), ("pipes[]", solid), ("knots[]", solid)]
    }
}

impl Builder<'_> {
    /// A tube or a ring with its blend.
    pub(in crate::document) fn contact_blend(&mut self, spec: &ContactBlendSpec) -> Result<Vec<SurfaceObject>> {
        self.check_contact_blend(spec)?;
        let made = match (spec.tube, spec.ring) {
            (Some(tube), None) => tube_blend(spec, tube).and_then(|blend| blend.made()),
            (None, Some(ring)) => self.ring_blend(spec, ring)?.made(),
            _ => return Err(self.unfit("a contact-blend requires either a `tube` or a `ring`")),
        };
        let made = made.map_err(|e| self.refused(&e, None))?;
        let centers = Some(Box::new(made.centers));
        self.facts = Facts::Blends(BlendFacts { blends: vec![made.blend], centers });
        Ok(vec![SurfaceObject::Body(made.body)])
    }

    /// Fields that have no meaning together.
    fn check_contact_blend(&self, spec: &ContactBlendSpec) -> Result<()> {
        let inside = spec.side == NeckSide::Inside;
        let of_tubes = inside || spec.ends != TeeEnds::Flat || spec.wall.is_some() || spec.tolerance.is_some();
        let refusal = if spec.ring.is_some() && of_tubes {
            "a `ring` is solid, with a ball of constant radius outside: remove `side`, `ends`, `wall` and `tolerance`"
        } else if spec.wall.is_some() && spec.ends == TeeEnds::Open {
            "a `wall` makes a solid, whose ends are `flat`, with a ring around the bore, or `closed`"
        } else if spec.sphere.is_some() && (spec.plate.is_some() || spec.thickness.is_some()) {
            "the tube is blended either with a `sphere` or with a `plate` that has a `thickness`: remove one of them"
        } else if inside && (spec.plate.is_some() || spec.thickness.is_some()) {
            "a blend inside ends the tube at the plane: remove `plate` and `thickness`"
        } else if !inside && spec.sphere.is_none() && spec.plate.is_none() {
            "a blend outside requires a `sphere` or a `plate` around the tube"
        } else if spec.wall.is_some() && spec.thickness.is_some() {
            "the thickness of the plate equals the `wall`: remove `thickness`"
        } else if spec.thickness.is_some() && spec.ends == TeeEnds::Open {
            "a `thickness` makes a solid, whose end is `flat`"
        } else {
            return Ok(());
        };
        Err(self.unfit(refusal))
    }

    fn ring_blend(&self, spec: &ContactBlendSpec, ring: BlendRingSpec) -> Result<RingBlend> {
        let BlendRingSpec { radius, tube, height } = ring;
        let ring = BlendRing { radius, tube, height };
        let blend = match spec.base() {
            Some(BlendBase::Sphere { radius }) => RingBlend::on_sphere(ring, radius, spec.blend),
            Some(BlendBase::Plane(PlateShape::Disk(radius))) => RingBlend::on_plate(ring, radius, spec.blend),
            _ => {
                return Err(self.unfit("a `ring` requires a `sphere` or a round `plate` such as {\"radius\": 60}"));
            }
        };
        let blend =
            blend.and_then(|blend| spec.thickness.map_or(Ok(blend), |thickness| blend.with_thickness(thickness)));
        blend.map_err(|e| self.refused(&e, None))
    }
}

fn tube_blend(spec: &ContactBlendSpec, tube: BlendTubeSpec) -> cyclide::Result<ContactBlend> {
    let BlendTubeSpec { through, direction, radius, taper, length } = tube;
    let direction = direction.map_or(Vec3::Z, Coordinates::vector);
    let taper = taper.map_or(0.0, Angle::radians);
    let tube = BlendTube { through: through.point(), direction, radius, taper, length };
    // Inside the tube has what it cuts out of the plane.
    let base = spec.base().unwrap_or(BlendBase::Plane(PlateShape::Disk(radius)));
    let blend = ContactBlend::new(tube, base, spec.blend)?.with_side(spec.side).with_ends(spec.ends);
    let blend = spec.tolerance.map_or(Ok(blend), |tolerance| blend.with_tolerance(tolerance))?;
    let blend = spec.thickness.map_or(Ok(blend), |thickness| blend.with_thickness(thickness))?;
    spec.wall.map_or(Ok(blend), |wall| blend.with_wall(wall))
}
