//! Planes, spheres, cylinders, cones and tori are found, with their placement; other cyclides are none of them.

use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    surface::{CyclidePatch, ParamSurface, PatchKind},
};

/// Part of a surface of revolution about z: a meridian from `(r0, z0)` to `(r1, z1)` that starts in direction
/// `(dr, dz)`, turned from angle `u0` to `u1` (`docs/math/revolution-and-pipes.md#patches-of-revolution`).
fn revolved([r0, z0]: [f64; 2], [r1, z1]: [f64; 2], [dr, dz]: [f64; 2], [u0, u1]: [f64; 2]) -> CyclidePatch {
    let at = |r: f64, z: f64, u: f64| Point3::new(r * u.cos(), r * u.sin(), z);
    let corners = [at(r0, z0, u0), at(r0, z0, u1), at(r1, z1, u0), at(r1, z1, u1)];
    let v1 = Vec3::new(-u0.sin(), u0.cos(), 0.0);
    let v2 = Vec3::new(dr * u0.cos(), dr * u0.sin(), dz).unit().unwrap();
    CyclidePatch::from_corners_and_frame(corners, v1, v2).unwrap()
}

/// Ways to place one surface: as it is, the two families of lines exchanged, moved, scaled, mirrored.
fn placed(patch: &CyclidePatch) -> Vec<CyclidePatch> {
    let [a0, a1, a2, a3] = patch.corners();
    let [v1, v2, _] = patch.moving_frame(0.0, 0.0);
    let exchanged = CyclidePatch::from_corners_and_frame([a0, a2, a1, a3], v2, v1).unwrap();
    let turn = Mobius::similarity(Quat::new(1.0, 2.0, -1.0, 0.5), 1.0, Vec3::new(10.0, -20.0, 5.0)).unwrap();
    let small = Mobius::similarity(Quat::ONE, 1e-6, Vec3::ZERO).unwrap();
    let large = Mobius::similarity(Quat::new(0.3, 0.0, -1.0, 0.5), 1e6, Vec3::ZERO).unwrap();
    let mirror = Mobius::reflection(Point3::new(0.5, 1.0, -2.0), Vec3::new(1.0, 2.0, 2.0)).unwrap();
    let maps = [Mobius::IDENTITY, turn, small, large, mirror, turn.after(&mirror)];
    maps.iter().flat_map(|m| [patch.transformed(m).unwrap(), exchanged.transformed(m).unwrap()]).collect()
}

/// The placement is right: all points are on the surface, to rounding of the coordinates and radii.
fn check_points(patch: &CyclidePatch, kind: &PatchKind, reach: f64) {
    for i in 0..=10 {
        for j in 0..=10 {
            let p = patch.point(0.1 * f64::from(i), 0.1 * f64::from(j));
            let distance = kind.distance(p).unwrap();
            // Rounding of the quotient and of the placement, some units of the last place of the largest number.
            assert!(distance <= 1e-14 * (reach + p.to_vec().max_abs()), "{kind:?}: {distance:e}");
        }
    }
}

/// The normal points away from `from(point)` if `outward`.
fn check_side(patch: &CyclidePatch, outward: bool, from: impl Fn(Point3) -> Point3) {
    let p = patch.point(0.4, 0.7);
    assert_eq!(patch.normal(0.4, 0.7).unwrap().dot(p - from(p)) > 0.0, outward);
}

#[test]
fn planes() {
    let annulus = revolved([1.0, 3.0], [2.5, 3.0], [1.0, 0.0], [0.3, 4.0]);
    let quad = [(0.0, 0.0), (2.0, 0.0), (0.0, 1.0), (2.0, 1.0)].map(|(x, y)| Point3::new(x, y, 7.0));
    let turned = Vec3::new(0.8, 0.6, 0.0);
    let curved = CyclidePatch::from_corners_and_frame(quad, turned, Vec3::Z.cross(turned)).unwrap();
    for patch in placed(&annulus).iter().chain(&placed(&curved)) {
        let kind = patch.recognize();
        let PatchKind::Plane { frame } = kind else { panic!("{kind:?}") };
        assert!((frame.z() - patch.normal(0.5, 0.5).unwrap()).length() < 1e-14);
        assert_eq!(frame.origin(), patch.corners()[0]);
        check_points(patch, &kind, patch.size());
    }
}

#[test]
fn spheres() {
    let zone = revolved([3.0, 0.0], [1.0, 8f64.sqrt()], [0.0, 1.0], [0.0, 5.5]);
    let inner = revolved([3.0, 0.0], [0.0, -3.0], [0.0, -1.0], [0.0, 1.5]);
    for patch in placed(&zone).iter().chain(&placed(&inner)) {
        let kind = patch.recognize();
        let PatchKind::Sphere { frame, radius, outward } = kind else { panic!("{kind:?}") };
        check_points(patch, &kind, radius);
        check_side(patch, outward, |_| frame.origin());
        assert!((patch.corners()[0].distance(frame.origin()) - radius).abs() < 1e-14 * (radius + 30.0));
    }
}

#[test]
fn cylinders() {
    let cylinder = revolved([2.0, -1.0], [2.0, 4.0], [0.0, 1.0], [1.0, 5.0]);
    for patch in placed(&cylinder) {
        let kind = patch.recognize();
        let PatchKind::Cylinder { frame, radius, outward } = kind else { panic!("{kind:?}") };
        check_points(&patch, &kind, radius);
        check_side(&patch, outward, |p| frame.origin() + frame.z() * (p - frame.origin()).dot(frame.z()));
        // The seam at angle 0 is opposite to the patch.
        let (middle, _) = frame.to_local(patch.point(0.5, 0.5));
        assert!((middle.x + radius).abs() < 1e-13 * radius.max(30.0));
    }
}

#[test]
fn cones() {
    let steep = revolved([2.0, 0.0], [0.5, 6.0], [-1.5, 6.0], [0.0, 2.0]);
    let flat = revolved([2.0, 0.0], [3.0, 0.1], [1.0, 0.1], [0.0, 6.0]);
    let tip = revolved([2.0, 0.0], [0.0, 1.0], [-2.0, 1.0], [0.0, 2.0]);
    for (cone, want) in [(steep, 0.25f64.atan()), (flat, 10f64.atan()), (tip, 2f64.atan())] {
        for patch in placed(&cone) {
            let kind = patch.recognize();
            let PatchKind::Cone { frame, radius, half_angle, outward } = kind else { panic!("{kind:?}") };
            assert!((half_angle - want).abs() < 1e-12, "{half_angle} {want}");
            check_points(&patch, &kind, radius + patch.size());
            let apex = frame.origin() - frame.z() * (radius / half_angle.tan());
            let on_axis = |p: Point3| apex + frame.z() * (p - apex).dot(frame.z());
            check_side(&patch, outward, on_axis);
            assert!((patch.point(0.3, 0.4) - apex).dot(frame.z()) > 0.0, "the patch is on the axis' side of the apex");
        }
    }
}

#[test]
fn tori() {
    let ring = revolved([3.0, 0.0], [2.0, 1.0], [0.0, 1.0], [0.0, 4.0]);
    // The tube's center circle of radius 1/2, tube 1: the outer part of a spindle.
    let spindle = revolved([1.5, 0.0], [0.5, 1.0], [0.0, 1.0], [0.0, 4.0]);
    // The inner part: from the inner equator up, still off the axis.
    let (sin, cos) = 0.5f64.sin_cos();
    let lemon = revolved([0.5, 0.0], [cos - 0.5, sin], [0.0, 1.0], [0.0, 4.0]);
    for (torus, major, minor) in [(ring, 2.0, 1.0), (spindle, 0.5, 1.0), (lemon, 0.5, 1.0)] {
        for patch in placed(&torus) {
            let kind = patch.recognize();
            let PatchKind::Torus { frame, major_radius, minor_radius, outward } = kind else { panic!("{kind:?}") };
            let scale = patch.size() / torus.size();
            assert!((major_radius / (scale * major) - 1.0).abs() < 1e-13);
            assert!((minor_radius / (scale * minor) - 1.0).abs() < 1e-13);
            check_points(&patch, &kind, major_radius + minor_radius);
            if major > minor {
                check_side(&patch, outward, |p| {
                    let v = p - frame.origin();
                    let flat = v - frame.z() * v.dot(frame.z());
                    frame.origin() + flat.unit().unwrap() * major_radius
                });
            }
        }
    }
}

#[test]
fn a_torus_inverted_off_its_axis_is_none_of_them() {
    let torus = revolved([3.0, 0.0], [2.0, 1.0], [0.0, 1.0], [0.0, 4.0]);
    let off_axis = Mobius::inversion(Point3::new(0.5, -1.0, 4.0), 2.0).unwrap();
    assert_eq!(torus.transformed(&off_axis).unwrap().recognize(), PatchKind::Cyclide);
    // About a point of the axis the image is a surface of revolution again.
    let on_axis = Mobius::inversion(Point3::new(0.0, 0.0, 4.0), 2.0).unwrap();
    assert!(matches!(torus.transformed(&on_axis).unwrap().recognize(), PatchKind::Torus { .. }));
}

#[test]
fn a_distortion_above_the_limit_is_seen() {
    let torus = revolved([3.0, 0.0], [2.0, 1.0], [0.0, 1.0], [0.0, 4.0]);
    // An inversion far away is nearly a reflection: it bends by about size/distance.
    let far = |distance: f64| Mobius::inversion(Point3::new(distance, 0.0, 0.0), distance).unwrap();
    assert_eq!(torus.transformed(&far(1e6)).unwrap().recognize(), PatchKind::Cyclide);
}
