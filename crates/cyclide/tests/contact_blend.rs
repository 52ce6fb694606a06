//! Blends of tubes with plates and spheres: the envelope, solids, tangency, similarity, what is refused.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::{
    Error, Point3, Vec3,
    construct::{BlendBase, BlendTube, ContactBlend, NeckSide, PlateShape, TeeEnds},
    error::{ContactError, PipeError},
    rational::{RationalBezier, RationalBezierSurface},
    surface::{CanalPatch, ContactPartner, RollingBall},
    topology::{Body, FaceSurface, surface_joints},
};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

const SPHERE: BlendBase = BlendBase::Sphere { radius: 5.0 };
const PLATE: BlendBase = BlendBase::Plane(PlateShape::Rectangle([30.0, 28.0]));
const DISK: BlendBase = BlendBase::Plane(PlateShape::Disk(15.0));

fn tube(through: [f64; 3], direction: [f64; 3], radius: f64, taper: f64) -> BlendTube {
    let [x, y, z] = through;
    let [u, v, w] = direction;
    BlendTube { through: Point3::new(x, y, z), direction: Vec3::new(u, v, w), radius, taper, length: 12.0 }
}

/// Every edge closed and smooth, or a crease at a right angle, more or less by the taper where the tube ends.
fn check(body: &Body, taper: f64) {
    for joint in body.shells().flat_map(surface_joints) {
        let crease = [FRAC_PI_2 - taper, FRAC_PI_2 + taper, FRAC_PI_2].iter().any(|a| (joint.angle - a).abs() < 1e-9);
        assert!(joint.gap < 1e-11 && (joint.angle < 1e-8 || crease), "{joint:?}");
    }
}

#[test]
fn struts_on_spheres_are_solids() {
    for (through, direction, taper) in [
        ([0.0, 1.5, 0.0], [0.0, 0.0, 1.0], 0.0),
        ([0.4, 1.5, 0.0], [0.3, 0.1, 1.0], 0.05),
        ([0.0, 2.0, 1.0], [0.0, 0.0, 1.0], -0.05),
        ([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], 0.05),
    ] {
        let strut = tube(through, direction, 1.0, taper);
        for side in [NeckSide::Outside, NeckSide::Inside] {
            for wall in [None, Some(0.2)] {
                for ends in [TeeEnds::Flat, TeeEnds::Closed, TeeEnds::Open] {
                    let blend = ContactBlend::new(strut, SPHERE, 0.5).unwrap().with_side(side).with_ends(ends);
                    let blend = wall.map_or(Ok(blend), |wall| blend.with_wall(wall)).unwrap();
                    let made = blend.made().unwrap_or_else(|e| panic!("{through:?} {side:?} {wall:?} {ends:?}: {e}"));
                    assert_eq!(made.body.is_solid(), ends != TeeEnds::Open);
                    check(&made.body, taper);
                }
            }
        }
    }
}

#[test]
fn tubes_on_plates_are_solids() {
    for base in [PLATE, DISK] {
        for (direction, taper) in
            [([0.0, 0.0, 1.0], 0.1), ([0.5, 0.3, 1.0], 0.1), ([0.0, -0.8, 1.0], -0.1), ([0.4, 0.0, 1.0], 0.0)]
        {
            let strut = tube([0.3, 0.2, 0.0], direction, 2.0, taper);
            for side in [NeckSide::Outside, NeckSide::Inside] {
                for wall in [None, Some(0.2)] {
                    for ends in [TeeEnds::Flat, TeeEnds::Closed, TeeEnds::Open] {
                        let blend = ContactBlend::new(strut, base, 0.6).unwrap().with_side(side).with_ends(ends);
                        let blend = blend.with_thickness(1.0).unwrap();
                        let blend = wall.map_or(Ok(blend), |wall| blend.with_wall(wall)).unwrap();
                        let made =
                            blend.made().unwrap_or_else(|e| panic!("{direction:?} {side:?} {wall:?} {ends:?}: {e}"));
                        assert_eq!(made.body.is_solid(), ends != TeeEnds::Open);
                        check(&made.body, taper);
                        assert!(made.blend.radii[1] - made.blend.radii[0] < 1e-13);
                    }
                }
            }
        }
    }
}

/// The canals: faces of degree 2 across whose normals meet in centers of balls.
fn canals(body: &Body, degree: usize) -> Vec<(&RationalBezierSurface, f64)> {
    let faces = body.outer.faces().iter();
    let rational = faces.filter_map(|face| match &face.surface {
        FaceSurface::Rational(surface) => Some((surface, if face.same_sense { 1.0 } else { -1.0 })),
        FaceSurface::Cyclide(_) => None,
    });
    rational.filter(|(surface, _)| surface.degrees()[1] == 2 && surface.degrees()[0] >= degree).collect()
}

/// Distance of a point from the axis of a tube, and its place along it.
fn off_axis(tube: &BlendTube, p: Point3) -> [f64; 2] {
    let axis = tube.direction.unit().unwrap();
    let along = (p - tube.through).dot(axis);
    [(p - tube.through - axis * along).length(), along]
}

/// How far a ball is from touching the tube.
fn gap(tube: &BlendTube, center: Point3, radius: f64) -> f64 {
    let [off, along] = off_axis(tube, center);
    (off - tube.radius) * tube.taper.cos() + along * tube.taper.sin() - radius
}

#[test]
fn ten_thousand_points_are_on_balls_that_touch_both() {
    let mut points = 0;
    for (tube, base, degree) in [
        (tube([0.0, 1.5, 0.0], [0.0, 0.0, 1.0], 1.0, 0.0), SPHERE, 12),
        (tube([0.4, 1.5, 0.0], [0.3, 0.1, 1.0], 1.0, 0.05), SPHERE, 12),
        (tube([0.3, 0.2, 0.0], [0.5, 0.3, 1.0], 2.0, 0.1), DISK, 8),
        (tube([0.3, 0.2, 0.0], [0.0, -0.8, 1.0], 2.0, -0.1), PLATE, 8),
    ] {
        let blend = ContactBlend::new(tube, base, 0.5).and_then(|blend| blend.with_thickness(1.0));
        let made = blend.and_then(|blend| blend.made()).unwrap();
        let [least, most] = made.blend.radii;
        let canals = canals(&made.body, degree);
        let mut contacts = 0;
        assert_eq!(canals.len() % made.blend.pieces, 0);
        for (surface, sense) in canals {
            for i in 0..=16 {
                let s = f64::from(i) / 16.0;
                // The envelope of balls that touch a plane or a sphere: the first normal gives center and radius.
                let at = |t: f64| (surface.point(s, t), surface.unit_normal(s, t) * sense);
                let (p, n) = at(0.0);
                let touches = |r: f64| match base {
                    BlendBase::Plane(_) => (p + n * r).z - r,
                    BlendBase::Sphere { radius } => (p + n * r).to_vec().length() - radius - r,
                };
                let (mut low, mut high) = (0.25, 1.0);
                for _ in 0..80 {
                    let middle = 0.5 * (low + high);
                    if (touches(middle) > 0.0) == (touches(0.25) > 0.0) { low = middle } else { high = middle }
                }
                let (radius, center) = (low, p + n * low);
                assert!(radius > least - 1e-10 && radius < most + 1e-10, "{radius} {least} {most}");
                assert!(gap(&tube, center, radius).abs() < 1e-10, "{}", gap(&tube, center, radius));
                for j in 0..=12 {
                    let (q, m) = at(f64::from(j) / 12.0);
                    points += 1;
                    assert!((q + m * radius).distance(center) < 1e-9 && (q.distance(center) - radius).abs() < 1e-10);
                }
                let (q, m) = at(1.0);
                // Arcs may be cut in two bands: the second ends at the contact.
                let (off, normal) = match base {
                    BlendBase::Sphere { radius } => (q.to_vec().length() - radius, q.to_vec().unit().unwrap()),
                    BlendBase::Plane(_) => (q.z, Vec3::Z),
                };
                if off.abs() < 1e-9 {
                    contacts += 1;
                    assert!(m.cross(normal).length() < 1e-9);
                }
            }
        }
        assert_eq!(contacts, 17 * made.blend.pieces);
    }
    assert!(points >= 10_000, "{points}");
}

#[test]
fn blends_are_similar_and_closer_with_the_tolerance() {
    let volume = |scale: f64, tolerance: f64| {
        let unit = tube([0.4, 1.5, 0.0], [0.3, 0.1, 1.0], 1.0, 0.05);
        let through = Point3::ORIGIN + unit.through.to_vec() * scale;
        let strut = BlendTube { through, radius: scale, length: 12.0 * scale, ..unit };
        let blend = ContactBlend::new(strut, BlendBase::Sphere { radius: 5.0 * scale }, 0.5 * scale).unwrap();
        let made = blend.with_tolerance(tolerance * scale).and_then(|blend| blend.made()).unwrap();
        let [low, high] = made.blend.radii.map(|radius| radius / scale);
        assert!(low >= 0.5 - tolerance && high <= 0.5 + tolerance);
        (made.body.outer.volume() / scale.powi(3), high - low)
    };
    let (one, widest) = volume(1.0, 1e-3);
    for scale in [1e-9, 1e-3, 1e3, 1e9] {
        assert!((volume(scale, 1e-3).0 / one - 1.0).abs() < 1e-9, "{scale}");
    }
    let (fine, nearer) = volume(1.0, 1e-5);
    let (_, nearest) = volume(1.0, 1e-7);
    assert!(nearer < widest && nearest < nearer);
    assert!((one - fine).abs() < 1e-2 * one);
}

#[test]
fn special_positions_are_tori() {
    let plate = BlendBase::Plane(PlateShape::Disk(9.0));
    for base in [SPHERE, plate] {
        let upright = tube([0.0; 3], [0.0, 0.0, 1.0], 1.0, 0.05);
        let made = ContactBlend::new(upright, base, 0.5).and_then(|blend| blend.made()).unwrap();
        assert!(made.blend.radii.iter().all(|radius| (radius - 0.5).abs() < 1e-15));
        for face in made.body.outer.faces() {
            assert!(matches!(face.surface, FaceSurface::Cyclide(_)), "{base:?}: {:?}", face.surface);
        }
    }
}

#[test]
fn an_upright_boss_has_the_volume_of_its_profile() {
    let (r, ball, height, thick) = (1.0, 0.5, 12.0, 1.0);
    let upright = tube([0.0; 3], [0.0, 0.0, 1.0], r, 0.0);
    let blend = ContactBlend::new(upright, DISK, ball).and_then(|blend| blend.with_thickness(thick)).unwrap();
    let corner = ball * ball * (1.0 - PI / 4.0);
    // Centroid of the corner from the tube: Pappus.
    let centroid = (ball * ball * 0.5 * ball - PI / 4.0 * ball * ball * (ball - 4.0 * ball / (3.0 * PI))) / corner;
    let wanted = PI * r * r * height + PI * 225.0 * thick + 2.0 * PI * (r + centroid) * corner;
    assert!((blend.made().unwrap().body.outer.volume() / wanted - 1.0).abs() < 1e-10);
}

/// Over a plane the centers are on an ellipse with the half axes `L/sin α` and L about the tube, L = r + R: it bends with the radius `L sin α` at its ends, where the arc
/// passes the direction towards the tube, between the places of any grid.
#[test]
fn balls_up_to_the_bend_of_their_way_are_accepted_and_others_fold() {
    let plate = BlendBase::Plane(PlateShape::Rectangle([4000.0, 4000.0]));
    for degrees in [25.0_f64, 35.0, 40.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let direction = Vec3::new(cos, 0.0, sin);
        let tube = BlendTube { through: Point3::ORIGIN, direction, radius: 10.0, taper: 0.0, length: 3000.0 };
        let limit = 10.0 * sin / (1.0 - sin);
        let made = |part: f64| {
            let ball = part * limit;
            let blend = ContactBlend::new(tube, plate, ball).and_then(|blend| blend.with_thickness(5.0)).unwrap();
            (blend.made(), 1.0 - ball / ((10.0 + ball) * sin))
        };
        for part in [0.5, 0.999] {
            let (made, left) = made(part);
            let facts = made.unwrap().blend;
            assert!((facts.tightest - left).abs() < 1e-9, "{degrees} {part}: {} {left}", facts.tightest);
        }
        let (made, left) = made(1.001);
        let Err(Error::Contact(ContactError::BlendFolds { left: found, .. })) = made else {
            panic!("{degrees}: it folds")
        };
        assert!((found - left).abs() < 1e-9 && found < 0.0, "{degrees}: {found} {left}");
    }
}

/// Cones with the ball inside, and the limit that is named: just below it the ball fits, unless something else is in its way.
#[test]
fn the_limit_of_a_ball_inside_a_cone_is_that_of_the_ball_that_touches_it_all_round() {
    let cone = |direction: [f64; 3], radius: f64, taper: f64| tube([0.0; 3], direction, radius, taper);
    let off_centre = tube([0.3, 0.0, 0.0], [0.0, 0.0, 1.0], 1.0, 0.2);
    // On a plane, at the height z on the axis: n z = R, n the rise of the axis.
    let on_plane = |radius: f64, taper: f64, rise: f64| rise * radius * taper.cos() / (rise + taper.sin());
    for (tube, base, ball, wanted) in [
        (BlendTube { length: 18.0, ..cone([0.0, 0.0, 1.0], 10.0, 0.45) }, PLATE, 12.0, Some(on_plane(10.0, 0.45, 1.0))),
        (
            BlendTube { length: 18.0, ..cone([0.0, 0.3, 1.0], 10.0, 0.3) },
            PLATE,
            12.0,
            Some(on_plane(10.0, 0.3, 1.0 / 1.09_f64.sqrt())),
        ),
        (cone([0.0, 0.4, 1.0], 2.0, 0.0), PLATE, 3.0, Some(2.0)),
        (BlendTube { length: 3.0, ..off_centre }, SPHERE, 2.2, None),
    ] {
        let made = |ball| ContactBlend::new(tube, base, ball).unwrap().with_side(NeckSide::Inside).made();
        let Err(Error::Pipe(PipeError::BallDoesNotFit { limit, radius })) = made(ball) else {
            panic!("{tube:?}: {:?}", made(ball).err())
        };
        assert!((radius - ball).abs() < 1e-15 && limit < ball);
        assert!(wanted.is_none_or(|wanted| (limit - wanted).abs() < 1e-12), "{limit} {wanted:?}");
        let refused = |part: f64| made(part * limit).map(|_| "made").unwrap_or_else(|error| error.reason());
        assert_eq!(refused(1.0 + 1e-6), "ball-does-not-fit", "{tube:?}: {limit}");
        assert_ne!(refused(1.0 - 1e-6), "ball-does-not-fit", "{tube:?}: {limit}");
    }
}

/// A quarter turn on the cylinder of radius 2 about the z axis, rising from 1 to 3: contacts and normals.
fn on_a_cylinder() -> [RationalBezier; 2] {
    let contacts = vec![[2.0, 0.0, 1.0, 1.0], [2.0, 2.0, 2.0, 1.0], [0.0, 4.0, 6.0, 2.0]];
    let normals = vec![[1.0, 0.0, 0.0, 1.0], [1.0, 1.0, 0.0, 1.0], [0.0, 2.0, 0.0, 2.0]];
    [contacts, normals].map(|rows| RationalBezier::new(rows).unwrap())
}

/// A quartic on the outer side of a torus, off the axis of all partners, that runs round both its circles at once.
fn on_a_torus() -> [RationalBezier; 2] {
    let (major, minor, place) = (4.0, 1.5, Vec3::new(-0.6, 0.3, 2.5));
    // Cosines, sines and weights of an angle between two others.
    let turning = |from: f64, to: f64| {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        [from.cos(), middle.cos(), to.cos(), from.sin(), middle.sin(), to.sin(), 1.0, half.cos(), 1.0]
    };
    let (round, across) = (turning(0.1, 1.2), turning(-0.7, 0.4));
    let part = |row: &[f64; 9], k: usize| [row[3 * k], row[3 * k + 1], row[3 * k + 2]];
    let product = |a: [f64; 3], b: [f64; 3]| {
        let middle = (a[0] * b[2] + 4.0 * a[1] * b[1] + a[2] * b[0]) / 6.0;
        [a[0] * b[0], 0.5 * (a[0] * b[1] + a[1] * b[0]), middle, 0.5 * (a[1] * b[2] + a[2] * b[1]), a[2] * b[2]]
    };
    let [cos, sin, weight] = [0, 1, 2].map(|k: usize| part(&round, k));
    let [out, up, other_weight] = [0, 1, 2].map(|k: usize| part(&across, k));
    let from_axis: [f64; 3] = std::array::from_fn(|i| major * other_weight[i] + minor * out[i]);
    let w = product(weight, other_weight);
    let rows = |x: [f64; 5], y: [f64; 5], z: [f64; 5], shift: Vec3| {
        let row = |i: usize| [x[i] + shift.x * w[i], y[i] + shift.y * w[i], z[i] + shift.z * w[i], w[i]];
        RationalBezier::new((0..5).map(row).collect()).unwrap()
    };
    let height = product(weight, up);
    [
        rows(product(cos, from_axis), product(sin, from_axis), height.map(|z| minor * z), place),
        rows(product(cos, out), product(sin, out), height, Vec3::ZERO),
    ]
}

/// The generic canal over a strip of contacts is that of the blend.
#[test]
fn the_canal_of_contacts_touches_both_surfaces() {
    assert_touches_both(&on_a_cylinder(), Point3::new(3.0, 4.0, -1.0));
    assert_touches_both(&on_a_torus(), Point3::new(6.5, 5.5, 1.5));
    let [contacts, normals] = on_a_cylinder();
    let long = RationalBezier::new(vec![[1.1, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0]]).unwrap();
    let floor = ContactPartner::Plane { normal: Vec3::Z, offset: -1.0 };
    assert_eq!(CanalPatch::at_contacts(&contacts, &long, floor).unwrap_err().reason(), "parameter-out-of-range");
    let below = ContactPartner::Plane { normal: Vec3::Z, offset: 9.0 };
    assert_eq!(CanalPatch::at_contacts(&contacts, &normals, below).unwrap_err().reason(), "no-positive-radius");
}

/// Over a plane below, and over a sphere of radius 2 about this center.
fn assert_touches_both([contacts, normals]: &[RationalBezier; 2], center: Point3) {
    for partner in [
        ContactPartner::Plane { normal: Vec3::new(0.2, -0.1, 3.0), offset: -1.0 },
        ContactPartner::Sphere { center, radius: 2.0 },
    ] {
        let patch = CanalPatch::at_contacts(contacts, normals, partner).unwrap();
        for part in patch.rational_parts().unwrap() {
            assert!(part.surface.has_positive_weights());
        }
        for k in 0..=20 {
            let s = f64::from(k) / 20.0;
            let ball = RollingBall::at_contact(contacts.point(s), normals.point(s).to_vec(), partner).unwrap();
            let (m, radius) = patch.ball(s);
            assert!(m.distance(ball.center) < 1e-11 && (radius - ball.radius).abs() < 1e-11);
            let step = 1e-5;
            let (ahead, behind) = (patch.ball(s + step), patch.ball(s - step));
            let (motion, growth) = ((ahead.0 - behind.0) / (2.0 * step), (ahead.1 - behind.1) / (2.0 * step));
            for (t, contact) in [(0.0, ball.contacts[0]), (1.0, ball.contacts[1])] {
                assert!(patch.point(s, t).distance(contact) < 1e-9);
            }
            // The least Jacobian is one of the arc, and no place of it is below: places are 1e-3 apart, least ones flat.
            let along_arc = (0..=1000).map(|j| patch.jacobian(s, f64::from(j) / 1000.0)).fold(f64::INFINITY, f64::min);
            let (least, scale) = (patch.least_jacobian(s), 1.0 + along_arc.abs());
            assert!(least <= along_arc + 1e-12 * scale && least > along_arc - 1e-4 * scale, "{least} {along_arc}");
            for t in [0.2, 0.5, 0.9] {
                // On the characteristic circle: n·m' = R'. Differences are good to 1e-8.
                assert!((patch.unit_normal(s, t).dot(motion) - growth).abs() < 1e-7 * motion.length());
            }
        }
    }
}

/// A tube whose wall comes near to the sphere on the far side of its center, with a small ball: the contacts are nearly one point, on nearly one plane.
#[test]
fn a_tube_that_all_but_touches_the_sphere_from_inside_is_blended() {
    let through = Point3::new(0.43022944031001903, 0.0, 0.0);
    let tube = BlendTube { through, direction: Vec3::Z, radius: 0.5697699655803016, taper: 0.0, length: 3.0 };
    let blend = ContactBlend::new(tube, BlendBase::Sphere { radius: 1.0 }, 0.00023244757840035736).unwrap();
    let made = blend.with_tolerance(2.3244757840035737e-05).and_then(|blend| blend.made()).unwrap();
    assert!(made.body.is_solid());
    check(&made.body, 0.0);
}

/// What may be refused of any blend of a tube with a sphere, all by name.
const REFUSALS: [&str; 8] = [
    "contact-loop-open",
    "contact-loop-turns-back",
    "contact-blend-folds",
    "contact-tube-too-short",
    "ball-does-not-fit",
    "radius-not-positive",
    "too-many-pieces",
    "parallel-contact",
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn tubes_near_the_wall_of_their_sphere_are_solids_or_refused_by_name(
        radius in 0.02..0.98_f64,
        gap in -9.0..-0.5_f64,
        ball in -7.0..-0.5_f64,
        tolerance in -3.0..-0.5_f64,
        cone in prop::option::of(-0.6..0.6_f64),
        inside: bool,
    ) {
        let away = 1.0 - radius - 10.0_f64.powf(gap);
        let ball = 10.0_f64.powf(ball);
        let taper = cone.unwrap_or(0.0);
        let tube = BlendTube { through: Point3::new(0.0, away, 0.0), direction: Vec3::Z, radius, taper, length: 3.0 };
        let side = if inside { NeckSide::Inside } else { NeckSide::Outside };
        let blend = ContactBlend::new(tube, BlendBase::Sphere { radius: 1.0 }, ball).unwrap().with_side(side);
        match blend.with_tolerance(ball * 10.0_f64.powf(tolerance)).unwrap().made() {
            Ok(made) => {
                prop_assert!(made.body.is_solid());
                for joint in made.body.shells().flat_map(surface_joints) {
                    prop_assert!(joint.gap < 1e-11, "{joint:?}");
                }
            }
            Err(error) => {
                prop_assert!(REFUSALS.contains(&error.reason()), "{error}");
                prop_assert!(cone.is_some() || error.reason() != "contact-loop-turns-back", "{error}");
            }
        }
    }
}

/// Centers are a ball's radius from the tube, and from the sphere or the plane.
#[test]
fn centres_are_a_path() {
    let strut = |through, direction: [f64; 3]| tube(through, direction, 1.0, 0.0);
    for (tube, base) in [
        (strut([0.0, 1.5, 0.0], [0.0, 0.0, 1.0]), SPHERE),
        (strut([0.4, 1.5, 0.0], [0.2, 0.1, 1.0]), PLATE),
        (strut([0.0; 3], [0.0, 0.0, 1.0]), SPHERE),
    ] {
        let made = ContactBlend::new(tube, base, 0.5).unwrap().made().unwrap();
        let [path] = made.centers.paths() else { panic!("one path") };
        let axis = tube.direction.unit().unwrap();
        for k in 0..40 {
            let m = path.point_at_knot(f64::from(k) / 40.0);
            let way = m - tube.through;
            let ball = (way - axis * way.dot(axis)).length() - 1.0;
            let other = if base == SPHERE { m.to_vec().length() - 5.0 } else { m.z };
            assert!((ball - other).abs() < 1e-12 && (ball - 0.5).abs() <= 5.1e-4, "{ball} {other}");
        }
        assert!(path.point_at_knot(0.0).distance(path.point_at_knot(1.0)) < 1e-13);
    }
}

/// A straight tube on a plate: the ball touches it at the height of its radius, beyond which a thousandth of the tube's radius must be left.
#[test]
fn tubes_reach_beyond_their_blend() {
    let (radius, ball) = (2.0, 0.6);
    let made = |length: f64| {
        let strut = BlendTube { length, ..tube([0.0; 3], [0.0, 0.0, 1.0], radius, 0.0) };
        ContactBlend::new(strut, PLATE, ball).and_then(|blend| blend.with_thickness(1.0)?.made())
    };
    let least = ball + 1e-3 * radius;
    let error = made(least - 1e-9).unwrap_err();
    let Error::Contact(ContactError::TubeTooShort { end, needed }) = error else { panic!("{error}") };
    assert!((end - least).abs() < 2e-9 && (needed - least).abs() < 1e-12, "{end} {needed}");
    check(&made(least + 1e-9).unwrap().body, 0.0);
}

/// A tube may be wider than the sphere that it goes round: a wall is thinner than both.
#[test]
fn walls_are_thinner_than_tube_and_sphere() {
    for (base, radius, limit) in [
        (BlendBase::Sphere { radius: 5.0 }, 1.0, 1.0),
        (BlendBase::Sphere { radius: 0.5 }, 1.0, 0.5),
        (PLATE, 1.0, 1.0),
    ] {
        let blend = ContactBlend::new(tube([0.0; 3], [0.0, 0.0, 1.0], radius, 0.0), base, 0.5).unwrap();
        assert!(blend.with_wall(limit * 0.999).is_ok(), "{base:?}");
        for wall in [limit, limit * 1.001, 0.0, -0.1, f64::NAN] {
            assert_eq!(blend.with_wall(wall).unwrap_err().reason(), "parameter-out-of-range", "{base:?} {wall}");
        }
    }
}
