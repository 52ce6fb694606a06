//! Tubes and rings blended with a plate or a sphere.

use cyclide::{
    BlendBase, BlendRing, BlendTube, ContactBlend, NeckSide, PlateShape, RingBlend, SurfaceObject, TeeEnds, Vec3,
};

use super::Builder;
use crate::document::angle::Angle;
use crate::document::coordinates::Coordinates;
use crate::document::spec::{BlendRingSpec, BlendTubeSpec, ContactBlendSpec, PlateSpec};
use crate::error::Result;

impl Builder<'_> {
    /// A tube or a ring with its blend.
    pub(in crate::document) fn contact_blend(&mut self, spec: &ContactBlendSpec) -> Result<Vec<SurfaceObject>> {
        self.check_contact_blend(spec)?;
        let made = match (spec.tube, spec.ring) {
            (Some(tube), None) => tube_blend(spec, tube).and_then(|blend| blend.made()),
            (None, Some(ring)) => self.ring_blend(spec, ring)?.made(),
            _ => return Err(self.unfit("what is blended is a `tube` or a `ring`: give one of them")),
        };
        let made = made.map_err(|e| self.refused(&e, None))?;
        self.tee_blends = vec![made.blend];
        self.ball_centers = Some(Box::new(made.centers));
        Ok(vec![SurfaceObject::Body(made.body)])
    }

    /// Fields that have no meaning together.
    fn check_contact_blend(&self, spec: &ContactBlendSpec) -> Result<()> {
        let inside = spec.side == NeckSide::Inside;
        let of_tubes = inside || spec.ends != TeeEnds::Flat || spec.wall.is_some() || spec.tolerance.is_some();
        let refusal = if spec.ring.is_some() && of_tubes {
            "a `ring` is filled, and its ball outside and of one radius: leave out `side`, `ends`, `wall` and `tolerance`"
        } else if spec.wall.is_some() && spec.ends == TeeEnds::Open {
            "a `wall` makes a solid: its ends are `flat`, with a ring round the bore, or `closed`"
        } else if spec.sphere.is_some() && (spec.plate.is_some() || spec.thickness.is_some()) {
            "the tube is blended with a `sphere`, or with a `plate` of a `thickness`: leave out one of them"
        } else if inside && (spec.plate.is_some() || spec.thickness.is_some()) {
            "a blend inside ends the tube at the plane: leave out `plate` and `thickness`"
        } else if !inside && spec.sphere.is_none() && spec.plate.is_none() {
            "a blend outside needs a `sphere`, or a `plate` round the tube"
        } else if spec.wall.is_some() && spec.thickness.is_some() {
            "with a `wall` the plate is as thick as that: leave out `thickness`"
        } else if spec.thickness.is_some() && spec.ends == TeeEnds::Open {
            "a `thickness` makes a solid: its end is `flat`"
        } else {
            return Ok(());
        };
        Err(self.unfit(refusal))
    }

    fn ring_blend(&self, spec: &ContactBlendSpec, ring: BlendRingSpec) -> Result<RingBlend> {
        let BlendRingSpec { radius, tube, height } = ring;
        let ring = BlendRing { radius, tube, height };
        let blend = match (spec.sphere, spec.plate) {
            (Some(radius), _) => RingBlend::on_sphere(ring, radius, spec.blend),
            (None, Some(PlateSpec::Disk(disk))) => RingBlend::on_plate(ring, disk.radius, spec.blend),
            (None, _) => {
                return Err(self.unfit("a `ring` stands on a `sphere`, or on a round `plate` such as {\"radius\": 60}"));
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
    let base = match (spec.sphere, spec.plate) {
        (Some(radius), _) => BlendBase::Sphere { radius },
        (None, Some(PlateSpec::Rectangle(sides))) => BlendBase::Plane(PlateShape::Rectangle(sides)),
        (None, Some(PlateSpec::Disk(disk))) => BlendBase::Plane(PlateShape::Disk(disk.radius)),
        // Inside the tube has what it cuts out of the plane.
        (None, None) => BlendBase::Plane(PlateShape::Disk(radius)),
    };
    let blend = ContactBlend::new(tube, base, spec.blend)?.with_side(spec.side).with_ends(spec.ends);
    let blend = spec.tolerance.map_or(Ok(blend), |tolerance| blend.with_tolerance(tolerance))?;
    let blend = spec.thickness.map_or(Ok(blend), |thickness| blend.with_thickness(thickness))?;
    spec.wall.map_or(Ok(blend), |wall| blend.with_wall(wall))
}
