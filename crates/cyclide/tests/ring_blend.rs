//! Rings blended with plates and spheres about their axis: solids, the balls, volumes, similarity, what is refused.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use cyclide::{
    Error, Result,
    construct::{BlendRing, MadeContactBlend, RingBlend},
    error::PipeError,
    surface::ParamSurface as _,
    topology::{FaceSurface, surface_joints},
};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

fn ring(radius: f64, tube: f64, height: f64) -> BlendRing {
    BlendRing { radius, tube, height }
}

fn on_plate(ring: BlendRing, ball: f64) -> Result<MadeContactBlend> {
    RingBlend::on_plate(ring, 100.0, ball)?.with_thickness(7.0)?.made()
}

fn on_sphere(ring: BlendRing, radius: f64, ball: f64) -> Result<MadeContactBlend> {
    RingBlend::on_sphere(ring, radius, ball)?.made()
}

/// A solid of parts of tori, spheres, cylinders and planes, smooth but for the rims of a plate.
fn is_sound(made: &MadeContactBlend) {
    assert!(made.body.is_solid());
    assert!(made.body.outer.faces().iter().all(|face| matches!(face.surface, FaceSurface::Cyclide(_))));
    for joint in surface_joints(&made.body.outer) {
        let crease = (joint.angle - FRAC_PI_2).abs() < 1e-9;
        assert!(joint.gap < 1e-11 && (joint.angle < 1e-7 || crease), "{joint:?}");
    }
}

#[test]
fn rings_on_plates_and_spheres_are_solids_of_tori() {
    // Lying in the plate, on it, above it; sunk into the sphere, round it without touching, on one side of it.
    for (height, ball) in [(0.0, 3.0), (-5.0, 2.0), (8.0, 3.0), (9.0, 4.0)] {
        is_sound(&on_plate(ring(30.0, 8.0, height), ball).unwrap());
    }
    for (radius, tube, height, sphere, ball) in [
        (30.0, 8.0, 0.0, 30.0, 3.0),
        (30.0, 5.0, 0.0, 24.0, 2.0),
        (20.0, 6.0, 22.0, 30.0, 2.0),
        (20.0, 6.0, -22.0, 30.0, 2.0),
    ] {
        is_sound(&on_sphere(ring(radius, tube, height), sphere, ball).unwrap());
    }
    let open = RingBlend::on_plate(ring(30.0, 8.0, 2.0), 60.0, 3.0).and_then(|blend| blend.made()).unwrap();
    assert!(!open.body.is_solid());
}

/// By heights over the plate, of the circles that bound it.
#[test]
fn a_ring_on_a_plate_has_the_volume_of_its_profile() {
    let (a, b, h, r) = (30.0_f64, 8.0_f64, 2.0_f64, 3.0_f64);
    let half = ((b + r).powi(2) - (h - r).powi(2)).sqrt();
    let contact = half * b / (b + r);
    let over = |x: f64| {
        let off = (x - a).abs();
        if off >= half {
            0.0
        } else if off <= contact {
            h + (b * b - off * off).sqrt()
        } else {
            r - (r * r - (half - off).powi(2)).sqrt()
        }
    };
    let count = 400_000;
    let step = 2.0 * half / f64::from(count);
    let place = |k: i32| a - half + (f64::from(k) + 0.5) * step;
    let above: f64 = (0..count).map(|k| 2.0 * PI * place(k) * over(place(k)) * step).sum();
    let wanted = PI * 100.0 * 100.0 * 7.0 + above;
    // The rule of middles is good to the square of its step.
    assert!((on_plate(ring(a, b, h), r).unwrap().body.outer.volume() / wanted - 1.0).abs() < 1e-9);
}

/// In the half plane of the axis: a point on the skin with its normal leads to the center of a ball that touches both, or lies on one of both.
#[test]
fn every_point_is_on_the_ring_the_sphere_or_a_ball_that_touches_both() {
    let (a, b, h, sphere, ball) = (20.0_f64, 6.0_f64, 18.0_f64, 30.0_f64, 2.0_f64);
    let made = on_sphere(ring(a, b, h), sphere, ball).unwrap();
    let mut seen = [0; 3];
    for face in made.body.outer.faces() {
        let FaceSurface::Cyclide(patch) = &face.surface else { continue };
        for (s, t) in (0..=8).flat_map(|i| (0..=8).map(move |j| (f64::from(i) / 8.0, f64::from(j) / 8.0))) {
            let p = patch.point(s, t);
            let n = patch.unit_normal(s, t) * if face.same_sense { 1.0 } else { -1.0 };
            let to_ring = |x: f64, z: f64| (x - a).hypot(z - h) - b;
            let (x, z) = (p.x.hypot(p.y), p.z);
            let center = p + n * ball;
            let touches = to_ring(center.x.hypot(center.y), center.z) - ball;
            let off =
                [p.to_vec().length() - sphere, to_ring(x, z), touches.hypot(center.to_vec().length() - sphere - ball)];
            let nearest = (0..3).min_by(|&i, &j| off[i].abs().total_cmp(&off[j].abs())).unwrap();
            assert!(off[nearest].abs() < 1e-11, "{p:?} {off:?}");
            seen[nearest] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 100), "{seen:?}");
}

#[test]
fn blends_are_similar() {
    let volume = |scale: f64| {
        let ring = ring(20.0 * scale, 6.0 * scale, 18.0 * scale);
        on_sphere(ring, 30.0 * scale, 2.0 * scale).unwrap().body.outer.volume() / scale.powi(3)
    };
    for scale in [1e-9, 1e-3, 1e6] {
        assert!((volume(scale) / volume(1.0) - 1.0).abs() < 1e-10, "{scale}");
    }
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let reason = |made: Result<MadeContactBlend>| made.unwrap_err().reason();
    // Out of reach above the plate, below it, inside the sphere and around it.
    assert_eq!(reason(on_plate(ring(30.0, 8.0, 14.1), 3.0)), "contact-loop-open");
    assert_eq!(reason(on_plate(ring(30.0, 8.0, -8.1), 3.0)), "contact-loop-open");
    assert_eq!(reason(on_sphere(ring(30.0, 8.0, 0.0), 38.1, 3.0)), "contact-loop-open");
    assert_eq!(reason(on_sphere(ring(30.0, 8.0, 0.0), 15.9, 3.0)), "contact-loop-open");
    assert_eq!(reason(RingBlend::on_plate(ring(30.0, 8.0, 0.0), 39.0, 3.0).unwrap().made()), "plate-too-small");
    // The plate reaches a thousandth beyond the place where the ball that touches the ring from outside lies on it.
    let reach = 1.001 * (30.0 + (11.0_f64.powi(2) - 3.0_f64.powi(2)).sqrt());
    let plate = |part: f64| RingBlend::on_plate(ring(30.0, 8.0, 0.0), part * reach, 3.0).unwrap().made();
    assert_eq!(reason(plate(1.0 - 1e-9)), "plate-too-small");
    assert!(plate(1.0 + 1e-9).is_ok());
    assert_eq!(reason(on_plate(ring(30.0, 3.0, 40.0), 21.0)), "contact-blend-folds");
    assert_eq!(reason(RingBlend::on_plate(ring(8.0, 8.0, 0.0), 39.0, 3.0).map(|_| unreachable!())), "not-a-ring-torus");
    // The largest ball in the hole touches ring and base from the axis.
    for made in [&|ball| on_plate(ring(12.0, 4.0, 3.0), ball), &|ball| on_sphere(ring(20.0, 6.0, 30.0), 30.0, ball)]
        as [&dyn Fn(f64) -> Result<MadeContactBlend>; 2]
    {
        let Err(Error::Pipe(PipeError::BallDoesNotFit { limit, .. })) = made(90.0) else {
            unreachable!("such a ball does not fit")
        };
        is_sound(&made(limit * 0.999).unwrap());
        assert_eq!(reason(made(limit * 1.001)), "ball-does-not-fit");
    }
}

proptest! {
    #[test]
    fn any_ring_is_a_solid_or_refused_by_name(
        tube in 0.02..0.99_f64,
        height in -3.0..3.0_f64,
        ball in -3.0..1.0_f64,
        sphere in prop::option::of(0.05..4.0_f64),
    ) {
        let (ring, ball) = (ring(1.0, tube, height), 10.0_f64.powf(ball));
        let made = match sphere {
            Some(sphere) => on_sphere(ring, sphere, ball),
            None => on_plate(ring, ball),
        };
        match made {
            Ok(made) => {
                prop_assert!(made.body.is_solid() && made.body.outer.volume() > 0.0);
                for joint in surface_joints(&made.body.outer) {
                    let crease = (joint.angle - FRAC_PI_2).abs() < 1e-9;
                    prop_assert!(joint.gap < 1e-10 && (joint.angle < 1e-5 || crease), "{joint:?}");
                }
            }
            Err(error) => prop_assert!(
                ["contact-loop-open", "ball-does-not-fit", "contact-blend-folds", "plate-too-small"].contains(&error.reason()),
                "{error}"
            ),
        }
    }
}

#[test]
fn centres_are_two_circles() {
    let made = on_plate(ring(30.0, 8.0, 5.0), 4.0).unwrap();
    let [inner, outer] = made.centers.paths() else { unreachable!("two circles") };
    for k in 0..16 {
        for (path, side) in [(inner, -1.0), (outer, 1.0)] {
            let m = path.point_at_knot(f64::from(k) / 16.0);
            let out = m.x.hypot(m.y) - 30.0;
            assert!((m.z - 4.0).abs() < 1e-14 && out * side > 0.0 && (out.hypot(m.z - 5.0) - 12.0).abs() < 1e-13);
        }
    }
}
