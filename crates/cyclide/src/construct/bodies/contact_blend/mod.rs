//! Blends of a tube with a plate or a sphere, told by the contacts of their balls with the tube: exact (`docs/math/contact-blends.md`).
//!
//! The tube is a cylinder or, with a taper, a cone. Of a ball that touches it at an angle θ round its axis, and the plane or the sphere besides, the center
//! follows from the height of the contact, so that every closed curve of contacts round the tube that is rational makes a rational canal. Over a plane the contacts of a
//! ball of one radius are rational themselves: its centers lie on a cone, in a plane. Over a sphere off the axis they are not, and pieces
//! `h = a + b cos θ + c sin θ` take their place, tangent to each other, with radii within a tolerance. Where the axis meets the plane at a right angle or passes through
//! the center of the sphere, blends are tori.

mod ball_loop;
mod check;
mod piece;
mod plate;
mod setup;
mod skin;

use super::ball_centers::{BallCenters, closed_path};
use super::tee::{TeeBlendFacts, TeeEnds};
use super::{NeckSide, PlateShape};
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::bands::{Bands, Ring};
use crate::error::{Error, ErrorItem, NumberError, Result};
use crate::topology::{Body, EdgeCurve};
use ball_loop::BallLoop;
use plate::PlateNodes;
use setup::{Base, Setup};
use skin::{Skin, SkinRings};

/// A blend of one radius keeps it to this part of it where no tolerance is given.
const DEFAULT_TOLERANCE: f64 = 1e-3;
/// The steepest taper, in radians: short of a plane.
const LARGEST_TAPER: f64 = std::f64::consts::FRAC_PI_2 - 0.05;

/// A round tube, a cylinder or a cone.
///
/// ```
/// use cyclide::{Point3, Vec3, construct::BlendTube};
/// let strut = BlendTube { through: Point3::new(0.0, 5.0, 0.0), direction: Vec3::Z, radius: 8.0, taper: 0.0, length: 60.0 };
/// assert!(strut.taper == 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BlendTube {
    /// A point of its axis.
    pub through: Point3,
    /// Along its axis towards its end, of any length.
    pub direction: Vec3,
    /// Its outer radius, of a cone that at the point.
    pub radius: f64,
    /// Half the angle of the cone that it is: above zero it grows thinner towards its end, below wider, 0 is a cylinder.
    pub taper: f64,
    /// Where it ends: distance from the point along the axis.
    pub length: f64,
}

/// What a tube is blended with.
///
/// ```
/// use cyclide::construct::{BlendBase, PlateShape};
/// let plate = BlendBase::Plane(PlateShape::Disk(60.0));
/// assert_ne!(plate, BlendBase::Sphere { radius: 60.0 });
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BlendBase {
    /// The plane z = 0 as a plate about the origin; the tube goes up from it.
    Plane(PlateShape),
    /// The sphere of this radius about the origin.
    Sphere {
        /// Its outer radius.
        radius: f64,
    },
}

/// A tube blended with a plate or a sphere by a ball of one radius.
///
/// Outside, the ball rolls in the corner round the tube: a strut on a node, a nozzle on a tank, a boss on a plate. Inside, it rolls in the rim of a tube that ends at
/// the plane or, as at a dome, at the sphere: a rod or, with a wall, a dished head with its knuckle.
/// All faces are exact and tangent along the contacts; source: `002`, section 4, and `docs/math/contact-blends.md`.
///
/// ```
/// use cyclide::{Point3, Vec3, construct::{BlendBase, BlendTube, ContactBlend}};
/// let strut = BlendTube { through: Point3::new(0.0, 12.0, 0.0), direction: Vec3::Z, radius: 10.0, taper: 0.0, length: 90.0 };
/// let node = ContactBlend::new(strut, BlendBase::Sphere { radius: 40.0 }, 6.0)?.with_wall(2.5)?;
/// let made = node.made()?;
/// assert!(made.body.is_solid());
/// assert!(made.blend.radii[0] >= 5.994 && made.blend.radii[1] <= 6.006);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactBlend {
    tube: BlendTube,
    base: BlendBase,
    ball: f64,
    side: NeckSide,
    tolerance: f64,
    wall: Option<f64>,
    thickness: Option<f64>,
    ends: TeeEnds,
}

/// A blend as it was made.
///
/// ```
/// use cyclide::{Point3, Vec3, construct::{BlendBase, BlendTube, ContactBlend}};
/// let strut = BlendTube { through: Point3::ORIGIN, direction: Vec3::Z, radius: 1.0, taper: 0.1, length: 9.0 };
/// let made = ContactBlend::new(strut, BlendBase::Sphere { radius: 4.0 }, 0.5)?.made()?;
/// // Through the centre: a torus, and a ball of one radius.
/// assert!((made.blend.radii[1] - made.blend.radii[0]).abs() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MadeContactBlend {
    /// The body.
    pub body: Body,
    /// What is known of the blend; angles are those round the tube, from the side on which the plane rises towards it or the center of the sphere lies.
    pub blend: TeeBlendFacts,
    /// Where the centers of its balls are; round a ring in two circles, that in its hole first.
    pub centers: BallCenters,
}

impl ContactBlend {
    /// A solid with a blend by a ball of this radius outside, to a thousandth of it: the tube and the sphere, or the tube on a plate, which needs a
    /// [thickness](Self::with_thickness) or a [wall](Self::with_wall) to be one.
    ///
    /// # Errors
    /// `not-finite`, `radius-not-positive`, `zero-axis`, `parameter-out-of-range`.
    pub fn new(tube: BlendTube, base: BlendBase, ball: f64) -> Result<Self> {
        let [first, second] = match base {
            BlendBase::Sphere { radius } => [(ErrorItem::Sphere, radius); 2],
            BlendBase::Plane(PlateShape::Disk(radius)) => [(ErrorItem::Plate, radius); 2],
            BlendBase::Plane(PlateShape::Rectangle(sides)) => sides.map(|side| (ErrorItem::Plate, side)),
        };
        for (what, radius) in [(ErrorItem::Tube, tube.radius), (ErrorItem::Blend, ball), first, second] {
            range::check_radius(what, 0, radius)?;
        }
        if !(tube.direction.is_finite() && tube.length.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Direction, index: 0 }.into());
        }
        range::check_point(0, tube.through.to_vec())?;
        let (value, max) = (tube.taper, LARGEST_TAPER);
        if !(value.abs() <= max) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Angle, value, min: -max, max }.into());
        }
        tube.direction.unit().ok_or(Error::zero_axis(ErrorItem::Direction))?;
        let tolerance = DEFAULT_TOLERANCE * ball;
        let side = NeckSide::Outside;
        Ok(Self { tube, base, ball, side, tolerance, wall: None, thickness: None, ends: TeeEnds::Flat })
    }

    /// The same with the ball on a side of the tube. Inside, the tube ends at the plane or the sphere.
    #[must_use]
    pub fn with_side(self, side: NeckSide) -> Self {
        Self { side, ..self }
    }

    /// The same with another tolerance of the radius.
    ///
    /// # Errors
    /// `tolerance-not-positive`.
    pub fn with_tolerance(self, tolerance: f64) -> Result<Self> {
        if !(tolerance > 0.0) {
            return Err(NumberError::ToleranceNotPositive { tolerance }.into());
        }
        Ok(Self { tolerance, ..self })
    }

    /// The same hollow, with a wall of this thickness everywhere: tube, blend, and sphere or plate.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless the wall is thinner than tube and sphere, and inside than the radius of the ball.
    pub fn with_wall(self, wall: f64) -> Result<Self> {
        let sphere = if let BlendBase::Sphere { radius } = self.base { radius } else { f64::INFINITY };
        let max = self.tube.radius.min(sphere);
        if !(wall > 0.0 && wall < max) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Wall, value: wall, min: 0.0, max }.into());
        }
        Ok(Self { wall: Some(wall), ..self })
    }

    /// The same with a plate of this thickness below a solid tube; of a blend without plate, or with a wall, it changes nothing.
    ///
    /// # Errors
    /// `parameter-out-of-range`, `not-finite`.
    pub fn with_thickness(self, thickness: f64) -> Result<Self> {
        range::check_thickness(thickness)?;
        Ok(Self { thickness: Some(thickness), ..self })
    }

    /// The same with another end of the tube.
    #[must_use]
    pub fn with_ends(self, ends: TeeEnds) -> Self {
        Self { ends, ..self }
    }

    /// The body, with what is known of its blend. A tube on a plate that has neither thickness nor wall is an open surface.
    ///
    /// # Errors
    /// `parallel-contact`, `contact-loop-open` (at some angle no such ball touches both); `too-many-pieces` (the tolerance); `ball-does-not-fit`, `contact-blend-folds`,
    /// `contact-loop-turns-back`, `contact-tube-too-short`; `plate-too-small`, `rulings-cross`; `parameter-out-of-range` (inside, a wall as thick as the radius of the ball).
    pub fn made(&self) -> Result<MadeContactBlend> {
        let sigma = if self.side == NeckSide::Outside { 1.0 } else { -1.0 };
        let setup = Setup::new(&self.tube, &self.base, sigma, self.ball)?;
        let depth = self.wall.unwrap_or(0.0);
        if let Some(value) = self.wall.filter(|wall| sigma < 0.0 && !(*wall < self.ball)) {
            return Err(
                NumberError::ParameterOutOfRange { name: ErrorItem::Wall, value, min: 0.0, max: self.ball }.into()
            );
        }
        let plate = match (self.base, self.side) {
            (BlendBase::Plane(shape), NeckSide::Outside) => Some((shape, PlateNodes::new(&setup, shape)?)),
            _ => None,
        };
        let angles = plate.as_ref().map_or_else(
            || plate::equal_angles(if setup.is_level() { 4 } else { 8 }),
            |(_, nodes)| nodes.angles.clone(),
        );
        let balls = BallLoop::new(&setup, &angles, self.tolerance)?;
        check::check_tube(&setup, &balls, depth)?;
        let short = if self.ends == TeeEnds::Closed { depth } else { 0.0 };
        check::check_end(&setup, &balls, 0.0, 0.0)?;
        check::check_end(&setup, &balls, depth, short)?;
        let tight = check::check_folds(&setup, &balls, depth)?;
        let making = Making { blend: self, setup, balls, plate };
        let body = making.body()?;
        let balls = &making.balls;
        let off = balls.radii.map(|radius| (radius - self.ball).abs());
        let blend = TeeBlendFacts {
            radii: balls.radii,
            deviation: off[0].max(off[1]),
            pieces: balls.pieces.len(),
            tightest: tight.left,
            tightest_at: tight.angle,
        };
        let path = closed_path(balls.pieces.iter().map(|piece| piece.canal.center()))?;
        Ok(MadeContactBlend { body, blend, centers: BallCenters::new(vec![path], None) })
    }
}

/// A blend with its loop, on its way to a body.
struct Making<'a> {
    blend: &'a ContactBlend,
    setup: Setup,
    balls: BallLoop,
    plate: Option<(PlateShape, PlateNodes)>,
}

impl Making<'_> {
    fn skin(&self, depth: f64, back: bool) -> Skin<'_> {
        Skin { setup: &self.setup, balls: &self.balls, depth, back }
    }

    fn body(&self) -> Result<Body> {
        let ends = self.blend.ends;
        let mut bands = Bands::default();
        let outer = self.skin(0.0, false);
        let rings = outer.rings(&mut bands, self.setup.end)?;
        let wall = self.blend.wall.filter(|_| ends != TeeEnds::Open);
        let solid = self.plate.is_none() || wall.is_some() || self.blend.thickness.is_some();
        if ends != TeeEnds::Open && solid && (wall.is_none() || ends == TeeEnds::Closed) {
            self.cap(&mut bands, &rings, self.setup.end, false)?;
        }
        outer.tube_and_blend(&mut bands, &rings)?;
        let Some(wall) = wall else {
            self.rest(&mut bands, &outer, &rings, ends != TeeEnds::Open)?;
            return bands.finish();
        };
        let inner = self.skin(wall, true);
        if ends == TeeEnds::Closed && self.plate.is_none() {
            self.rest(&mut bands, &outer, &rings, false)?;
            let mut inside = Bands::default();
            let inner = self.skin(wall, false);
            let height = self.setup.end - wall;
            let rings = inner.rings(&mut inside, height)?;
            self.cap(&mut inside, &rings, height, false)?;
            inner.tube_and_blend(&mut inside, &rings)?;
            self.rest(&mut inside, &inner, &rings, false)?;
            let (outer, hollow) = (bands.finish()?, inside.finish()?);
            return Ok(Body { outer: outer.outer, voids: vec![hollow.outer.flipped()] });
        }
        let height = if ends == TeeEnds::Closed { self.setup.end - wall } else { self.setup.end };
        let inside = inner.rings(&mut bands, height)?;
        match &self.plate {
            Some((shape, nodes)) => {
                let border = self.border(&mut bands, *shape, nodes, 0.0)?;
                bands.ruled([&rings.on_base, &border])?;
                let lower = self.border(&mut bands, *shape, nodes, wall)?;
                bands.ruled([&border, &lower])?;
                bands.ruled([&lower, &inside.on_base])?;
            }
            None => {
                self.rest(&mut bands, &outer, &rings, false)?;
                self.rest(&mut bands, &inner, &inside, false)?;
            }
        }
        inner.tube_and_blend(&mut bands, &inside)?;
        if ends == TeeEnds::Closed {
            self.cap(&mut bands, &inside, height, true)?;
        } else {
            bands.ruled([&inside.end, &rings.end])?;
        }
        bands.finish()
    }

    /// The flat end of the tube.
    fn cap(&self, bands: &mut Bands, rings: &SkinRings, height: f64, back: bool) -> Result<()> {
        let middle = bands.pole(self.setup.point([0.0, 0.0, height]), &rings.end);
        bands.ruled(if back { [&rings.end, &middle] } else { [&middle, &rings.end] })
    }

    /// What is left of the sphere or the plane beyond the contact, a plate with its lower side where it is thick.
    fn rest(&self, bands: &mut Bands, skin: &Skin<'_>, rings: &SkinRings, closed: bool) -> Result<()> {
        match (self.setup.base, &self.plate) {
            (Base::Sphere { e, r }, _) => {
                let pole = pole_turn(self.balls.mean_normal() * -self.setup.sigma);
                check::check_turning(&self.balls, pole)?;
                skin.to_pole(bands, &rings.on_base, [e, r], pole)
            }
            (Base::Plane(_), Some((shape, nodes))) => {
                let border = self.border(bands, *shape, nodes, 0.0)?;
                bands.ruled([&rings.on_base, &border])?;
                let Some(thickness) = self.blend.thickness.filter(|_| closed) else { return Ok(()) };
                let lower = self.border(bands, *shape, nodes, thickness)?;
                bands.ruled([&border, &lower])?;
                let foot = bands.pole(Point3::new(0.0, 0.0, -thickness), &lower);
                bands.ruled([&lower, &foot])
            }
            (Base::Plane(_), None) => {
                let [a, b] = [0.0, std::f64::consts::PI].map(|angle| plate::contact(&self.setup, angle));
                let middle = a?.midpoint(b?) + Vec3::Z * skin.depth;
                skin.to_middle(bands, &rings.on_base, middle)
            }
        }
    }

    /// The border of the plate at a depth.
    fn border(&self, bands: &mut Bands, shape: PlateShape, nodes: &PlateNodes, depth: f64) -> Result<Ring> {
        let contacts = self.skin(0.0, false).on_base()?;
        let points: Vec<Point3> = contacts.iter().map(EdgeCurve::start).collect();
        let curves = nodes.border(&self.setup, shape, &points, &self.balls.starts, -depth)?;
        for (k, (contact, border)) in contacts.iter().zip(&curves).enumerate() {
            plate::check_lines(k, contact, border)?;
        }
        Ok(bands.ring(curves, true))
    }
}

/// A turn of the third axis to a direction.
fn pole_turn(direction: Vec3) -> Quat {
    let turn = Quat::new(1.0 + direction.z, -direction.y, direction.x, 0.0);
    let length = turn.norm();
    if length > 1e-8 { turn * (1.0 / length) } else { Quat::new(0.0, 1.0, 0.0, 0.0) }
}
