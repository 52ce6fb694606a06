//! Rational surfaces on planes, cylinders and cones are found, however they are placed, and what is near one only is not.
#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal as _, Mobius},
    construct::{BlendBase, BlendTube, ContactBlend, PipeTee, TeeBranch, TeeMain},
    rational::RationalBezierSurface,
    surface::PatchKind,
    topology::{FaceSurface, Shell},
};

/// The shell of a tee: canals of degree (12, 2), planes, and parts of both cylinders of all degrees.
fn tee() -> Shell {
    let branch = TeeBranch { angle: 1.2, offset: 0.6, ..TeeBranch::upright(2.0, 12.0, 0.5) };
    let main = TeeMain { radius: 3.0, taper: 0.0, ends: [-14.0, 16.0] };
    PipeTee::new(main, vec![branch]).and_then(|tee| tee.made()).expect("a tee").body.outer
}

fn rational(shell: &Shell) -> impl Iterator<Item = &RationalBezierSurface> {
    shell.faces().iter().filter_map(|face| match &face.surface {
        FaceSurface::Rational(surface) => Some(surface),
        FaceSurface::Cyclide(_) => None,
    })
}

/// A strip of height 3 over half a turn about z less a bit, with half axes `a` and `b` and the radius at the top `top` times that
/// at the bottom.
fn strip(a: f64, b: f64, top: f64, angle: f64) -> RationalBezierSurface {
    let (sin, cos) = (0.5 * angle).sin_cos();
    let (end_sin, end_cos) = angle.sin_cos();
    let across = [[a, 0.0, 1.0], [a * cos, b * sin, cos], [a * end_cos, b * end_sin, 1.0]];
    let rows = across.iter().flat_map(|&[x, y, w]| [[x, y, 0.0, w], [top * x, top * y, 3.0 * w, w]]).collect();
    RationalBezierSurface::new([2, 1], rows).expect("a strip")
}

fn is_cylinder(surface: &RationalBezierSurface) -> bool {
    matches!(surface.recognize(), PatchKind::Cylinder { .. })
}

#[test]
fn parts_of_the_pipes_of_a_tee_are_cylinders_wherever_they_are() {
    let tee = tee();
    let turn = Quat::new(1.0, 2.0, -1.0, 0.5);
    let mirror = Mobius::reflection(Point3::new(0.5, 1.0, -2.0), Vec3::new(1.0, 2.0, 2.0)).expect("a mirror");
    let map = |scale, by| Mobius::similarity(turn, scale, by).expect("a similarity");
    let far = map(1.0, Vec3::new(1e4, -2e4, 5e3));
    // The radius of a face that turns by some hundredths is its height over a chord: it loses the square of that of the digits
    // of the coordinates, all of them relative to the radius.
    let near = 1e-9;
    for (map, scale, digits) in [
        (Mobius::IDENTITY, 1.0, near),
        (map(1e-9, Vec3::ZERO), 1e-9, near),
        (map(1e9, Vec3::ZERO), 1e9, near),
        (mirror, 1.0, near),
        (far, 1.0, 1e4 * near),
    ] {
        let placed = tee.transformed(&map).expect("an image");
        let mut found = [0, 0];
        for surface in rational(&placed) {
            let kind = surface.recognize();
            let PatchKind::Cylinder { frame, radius, outward } = kind else {
                assert!(matches!(kind, PatchKind::Plane { .. }) || surface.degrees() == [12, 2], "{kind:?}");
                continue;
            };
            assert!([2.0, 3.0].iter().any(|r| (radius / (r * scale) - 1.0).abs() < digits), "{radius}");
            found[usize::from(surface.degrees()[0] > 2)] += 1;
            for k in 0..=100 {
                let (s, t) = (0.1 * f64::from(k % 11), 0.1 * f64::from(k / 11));
                let p = surface.point(s, t);
                // What is promised: 1e-13 of the size of a face, which is below 40, and the rounding of coordinates and radius.
                let limit = 4e-12 * scale + 64.0 * f64::EPSILON * (p.to_vec().max_abs() + radius + 40.0 * scale);
                assert!(kind.distance(p).is_some_and(|off| off <= limit), "{kind:?}");
                let v = p - frame.origin();
                let away = v - frame.z() * v.dot(frame.z());
                assert_eq!(surface.unit_normal(s, t).dot(away) > 0.0, outward);
                // The seam is far from the face.
                assert!(frame.to_local(p).0.x < 0.9 * radius);
            }
        }
        assert!(found[0] >= 4 && found[1] >= 30, "{found:?}");
    }
}

#[test]
fn what_is_near_a_cylinder_only_is_none() {
    assert!(is_cylinder(&strip(2.0, 2.0, 1.0, 2.5)));
    for off in [1e-9, 1e-6, 0.1] {
        assert!(!is_cylinder(&strip(2.0, 2.0 * (1.0 + off), 1.0, 2.5)), "an ellipse, {off}");
        assert!(!is_cylinder(&strip(2.0, 2.0, 1.0 + off, 2.5)), "a cone, {off}");
    }
    // The axis of a strip that hardly turns is not determined.
    assert!(!is_cylinder(&strip(2.0, 2.0, 1.0, 5e-4)));
    assert!(is_cylinder(&strip(2.0, 2.0, 1.0, 0.05)));
}

#[test]
fn planes_are_planes_and_weights_have_to_be_positive() {
    let flat = RationalBezierSurface::new(
        [1, 1],
        vec![[0.0, 0.0, 2.0, 1.0], [0.0, 2.0, 4.0, 2.0], [1.0, 0.0, 2.0, 1.0], [1.0, 1.0, 2.0, 1.0]],
    )
    .expect("a surface");
    assert!(matches!(flat.recognize(), PatchKind::Plane { .. }));
    // More than half a turn: the middle weight is negative.
    assert_eq!(strip(2.0, 2.0, 1.0, 3.5).recognize(), PatchKind::Cyclide);
}

/// A conical strut on a ball: parts of a cone between a contact of high degree and a circle, and canals.
fn strut(taper: f64) -> Shell {
    let tube = BlendTube { through: Point3::new(0.0, 5.0, 0.0), direction: Vec3::Z, radius: 8.0, taper, length: 40.0 };
    let made = ContactBlend::new(tube, BlendBase::Sphere { radius: 20.0 }, 4.0).and_then(|blend| blend.made());
    made.expect("a strut").body.outer
}

#[test]
fn parts_of_cones_are_cones_wherever_they_are() {
    let turn = Quat::new(1.0, 2.0, -1.0, 0.5);
    let map = |scale, by| Mobius::similarity(turn, scale, by).expect("a similarity");
    for taper in [0.15, 0.03, -0.4] {
        let shell = strut(taper);
        let turned = (turn * (1.0 / turn.norm())).rotate(Vec3::Z);
        for (map, scale, up) in [
            (Mobius::IDENTITY, 1.0, Vec3::Z),
            (map(1e-9, Vec3::ZERO), 1e-9, turned),
            (map(1e9, Vec3::ZERO), 1e9, turned),
            (map(1.0, Vec3::new(1e4, -2e4, 5e3)), 1.0, turned),
        ] {
            let placed = shell.transformed(&map).expect("an image");
            let mut found = 0;
            for surface in rational(&placed).filter(|surface| surface.degrees()[1] == 1) {
                let kind = surface.recognize();
                let PatchKind::Cone { frame, radius, half_angle, outward } = kind else { continue };
                found += 1;
                // Angles of strips that turn by tenths lose the square of that of the digits of their coordinates.
                assert!((half_angle - taper.abs()).abs() < 1e-7, "{half_angle}");
                assert!((frame.z().dot(up) + taper.signum()).abs() < 1e-9, "away from the tip");
                for k in 0..=100 {
                    let (s, t) = (0.1 * f64::from(k % 11), 0.1 * f64::from(k / 11));
                    let p = surface.point(s, t);
                    // What is promised: 1e-13 of the size of a face, which is below 70, and the rounding of coordinates and radius.
                    let limit = 7e-12 * scale + 64.0 * f64::EPSILON * (p.to_vec().max_abs() + radius);
                    assert!(kind.distance(p).is_some_and(|off| off <= limit), "{kind:?}");
                    let v = p - frame.origin();
                    let away = v - frame.z() * v.dot(frame.z());
                    assert_eq!(surface.unit_normal(s, t).dot(away) > 0.0, outward);
                    assert!(frame.to_local(p).0.x < 0.0, "the seam is far from the face");
                }
            }
            assert!(found >= 16, "{taper} {scale}: {found}");
        }
    }
}

#[test]
fn what_is_near_a_cone_only_is_none() {
    let is_cone = |surface: &RationalBezierSurface| matches!(surface.recognize(), PatchKind::Cone { .. });
    assert!(is_cone(&strip(2.0, 2.0, 1.5, 2.5)) && is_cone(&strip(2.0, 2.0, 0.5, 2.5)));
    for off in [1e-9, 1e-6, 0.1] {
        assert!(!is_cone(&strip(2.0, 2.0 * (1.0 + off), 1.5, 2.5)), "elliptic, {off}");
    }
    // As far as the tip, and beyond.
    assert!(!is_cone(&strip(2.0, 2.0, 0.0, 2.5)) && !is_cone(&strip(2.0, 2.0, -0.5, 2.5)));
    // Its axis is not determined.
    assert!(!is_cone(&strip(2.0, 2.0, 1.5, 5e-4)));
}
