//! Laws of general bilinear patches of circles (`docs/math/bilinear-patches.md`) on random patches.
//!
//! Bounds are some hundred roundings of numbers of the size, times `max |D|²/min |D|²` where the quotient magnifies them.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    curve::Arc,
    surface::{CornerTwist, CyclidePatch, ImplicitForm, ParamSurface, QbPatch, QbPatchKind},
};
use proptest::prelude::*;

const PLACES: [(f64, f64); 7] = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (0.5, 0.5), (0.25, 0.75), (0.9, 0.1)];

/// What a patch is made of: corners near those of a square, directions near its sides, a twist.
#[derive(Debug, Clone, Copy)]
struct Data {
    corners: [Point3; 4],
    directions: [Vec3; 2],
    twist: f64,
}

impl Data {
    fn patch(&self) -> Option<QbPatch> {
        QbPatch::from_directions(self.corners, self.directions, CornerTwist::Twist(self.twist)).ok()
    }
}

fn data() -> impl Strategy<Value = Data> {
    let number = || -0.4..0.4_f64;
    let vector = move || (number(), number(), number()).prop_map(|(x, y, z)| Vec3::new(x, y, z));
    (prop::array::uniform4(vector()), prop::array::uniform2(vector()), number()).prop_map(|(moved, turned, twist)| {
        Data {
            corners: std::array::from_fn(|k| Point3::new((k & 1) as f64, (k >> 1) as f64, 0.0) + moved[k]),
            directions: [Vec3::X + turned[0], Vec3::Y + turned[1]],
            twist: 2.0 * twist,
        }
    })
}

/// How much the quotient magnifies rounding: the largest denominator over that at a place.
fn magnified(patch: &QbPatch, s: f64, t: f64) -> f64 {
    let largest = patch.weights().iter().map(|w| w.norm_squared()).fold(0.0, f64::max);
    // Outside the square the bilinear functions grow.
    (1.0 + s.abs().max(t.abs())).powi(4) * largest / patch.denominator(s, t).norm_squared()
}

proptest! {
    #[test]
    fn in_space_with_its_corners_and_directions(data in data()) {
        let Some(patch) = data.patch() else { return Ok(()) };
        for (s, t) in [(-1.0, 0.3), (0.2, 0.7), (0.5, 0.5), (1.5, -0.5), (2.0, 2.0)] {
            prop_assert!(patch.real_residual(s, t) <= 512.0 * f64::EPSILON * magnified(&patch, s, t) * patch.size());
        }
        for (k, corner) in data.corners.into_iter().enumerate() {
            prop_assert!(patch.point((k & 1) as f64, (k >> 1) as f64).distance(corner) <= 16.0 * f64::EPSILON * patch.size());
            prop_assert_eq!(patch.corners()[k], corner);
        }
        let jet = patch.jet(0.0, 0.0);
        for (got, (direction, end)) in [jet.ds, jet.dt].into_iter().zip(data.directions.into_iter().zip([1, 2])) {
            let want = direction.unit().unwrap() * data.corners[0].distance(data.corners[end]);
            prop_assert!((got - want).length() <= 64.0 * f64::EPSILON * patch.size());
        }
    }

    #[test]
    fn derivatives_are_limits_of_differences(data in data()) {
        let Some(patch) = data.patch() else { return Ok(()) };
        let h = 1e-5;
        for (s, t) in PLACES {
            let (jet, far) = (patch.jet(s, t), magnified(&patch, s, t).powi(3));
            let apart = |d: Vec3, exact: Vec3| (d - exact).length();
            let along_s = (patch.point(s + h, t) - patch.point(s - h, t)) / (2.0 * h);
            let along_t = (patch.point(s, t + h) - patch.point(s, t - h)) / (2.0 * h);
            prop_assert!(apart(along_s, jet.ds).max(apart(along_t, jet.dt)) <= 1e-8 * far);
            let [before, after] = [-h, h].map(|h| patch.jet(s + h, t));
            prop_assert!(apart((after.ds - before.ds) / (2.0 * h), jet.dss) <= 1e-7 * far);
            prop_assert!(apart((after.dt - before.dt) / (2.0 * h), jet.dst) <= 1e-7 * far);
            let [before, after] = [-h, h].map(|h| patch.jet(s, t + h));
            prop_assert!(apart((after.dt - before.dt) / (2.0 * h), jet.dtt) <= 1e-7 * far);
            prop_assert!(apart((after.ds - before.ds) / (2.0 * h), jet.dst) <= 1e-7 * far);
            if let (Some(normal), Some(want)) = (patch.normal(s, t), jet.normal())
                && jet.ds.unit().unwrap().cross(jet.dt.unit().unwrap()).length() > 1e-3 {
                    prop_assert!(apart(normal, want) <= 1e-11 * far);
                    let angle = jet.ds.cross(jet.dt).length().atan2(jet.ds.dot(jet.dt));
                    prop_assert!((patch.line_angle(s, t).unwrap() - angle).abs() <= 1e-11 * far);
            }
        }
    }

    #[test]
    fn exact_rational_form_and_parts(data in data(), from in 0.0..0.5_f64, to in 0.6..1.0_f64) {
        let Some(patch) = data.patch() else { return Ok(()) };
        let (rational, part) = (patch.to_rational(), patch.restricted([from, to], [0.0, to]).unwrap());
        for (s, t) in PLACES {
            let allowed = 256.0 * f64::EPSILON * magnified(&patch, s, t) * patch.size();
            prop_assert!(rational.point(s, t).distance(patch.point(s, t)) <= allowed);
            let (u, v) = (from + (to - from) * s, to * t);
            let allowed = 256.0 * f64::EPSILON * magnified(&patch, u, v).max(magnified(&part, s, t)) * patch.size();
            prop_assert!(part.point(s, t).distance(patch.point(u, v)) <= allowed);
        }
    }

    /// Exchanging the parameters turns the sign of the twist; neither it nor the weights depend on the unit of length or the place.
    #[test]
    fn symmetries_of_the_twist(data in data(), unit in 1e-6..1e6_f64) {
        let Some(patch) = data.patch() else { return Ok(()) };
        let [a0, a1, a2, a3] = data.corners;
        let [v1, v2] = data.directions;
        let exchanged = QbPatch::from_directions([a0, a2, a1, a3], [v2, v1], CornerTwist::Twist(-data.twist)).unwrap();
        for (s, t) in PLACES {
            let allowed = 1e-12 * magnified(&patch, s, t) * patch.size();
            prop_assert!(exchanged.point(t, s).distance(patch.point(s, t)) <= allowed);
        }
        let turn = Quat::from_axis_angle(Vec3::new(0.6, 0.0, 0.8), 1.0);
        let placed = data.corners.map(|p| Point3::ORIGIN + turn.rotate(p.to_vec()) * unit);
        let turned = data.directions.map(|v| turn.rotate(v));
        let similar = QbPatch::from_directions(placed, turned, CornerTwist::Twist(data.twist)).unwrap();
        for ((s, t), tolerance) in PLACES.into_iter().zip([1e-12; 7]) {
            let want = Point3::ORIGIN + turn.rotate(patch.point(s, t).to_vec()) * unit;
            prop_assert!(similar.point(s, t).distance(want) <= tolerance * magnified(&patch, s, t).powi(2) * unit);
        }
    }

    #[test]
    fn moebius_images(data in data(), (x, y, z) in (2.0..4.0_f64, -1.0..1.0_f64, 1.0..3.0_f64)) {
        let Some(patch) = data.patch() else { return Ok(()) };
        let inversion = Mobius::inversion(Point3::new(x, y, z), 2.0).unwrap();
        let mirror = Mobius::reflection(Point3::new(0.3, 0.1, 0.0), Vec3::new(1.0, 2.0, -2.0)).unwrap();
        for map in [inversion, mirror.after(&inversion)] {
            let Ok(image) = patch.transformed(&map) else { continue };
            for (s, t) in PLACES {
                let Some(want) = map.map_point(patch.point(s, t)) else { continue };
                let allowed = 1e-12 * magnified(&patch, s, t) * magnified(&image, s, t) * image.size();
                prop_assert!(image.point(s, t).distance(want) <= allowed);
            }
            let kinds = [patch.recognize(), image.recognize()];
            prop_assert!(kinds == [QbPatchKind::Darboux; 2], "{:?}", kinds);
        }
    }

    /// The quartic vanishes at points inside and outside the square, and nowhere beside the surface; the points have their parameters.
    #[test]
    fn implicit_equation_and_location(data in data(), s in -3.0..3.0_f64, t in -3.0..3.0_f64) {
        let Some(patch) = data.patch() else { return Ok(()) };
        let far = magnified(&patch, s, t);
        let p = patch.point(s, t);
        if far > 1e4 || p.to_vec().max_abs() > 20.0 {
            return Ok(());
        }
        let reach = 1.0 + (p - data.corners[0]).length() / patch.size();
        prop_assert!(patch.implicit_at(p).abs() <= 1e-12 * reach.powi(4));
        let Some(ImplicitForm::Quartic { coefficients, .. }) = patch.implicit_form() else { panic!("a quartic") };
        let form = ImplicitForm::Quartic { coefficients, degree: 4 };
        prop_assert!(form.value(p).abs() <= 1e-9 * (1.0 + p.to_vec().length()).powi(4));
        // As long as the two forms are one, up to a factor.
        let off = data.corners[0] + Vec3::new(0.3, -0.4, 0.7);
        let factor = patch.implicit_at(off) / form.value(off);
        let other = data.corners[3] + Vec3::new(-0.2, 0.5, 0.6);
        prop_assert!((patch.implicit_at(other) - factor * form.value(other)).abs() <= 1e-9 * factor.abs().max(1.0));
        let found = patch.locate(p);
        let size = patch.size() * (1.0 + p.to_vec().max_abs());
        prop_assert!(found.distance <= 1e-12 * far * size, "{:?}", found);
        let own = (found.s - s).abs() + (found.t - t).abs() <= 1e-6 * far;
        // Another place of the same point is right too.
        prop_assert!(own || found.point.distance(p) <= 1e-12 * far * size);
    }

    /// The foot of a perpendicular.
    #[test]
    fn locating_a_point_beside_the_surface(data in data(), s in 0.1..0.9_f64, t in 0.1..0.9_f64, height in -0.01..0.01_f64) {
        let Some(patch) = data.patch() else { return Ok(()) };
        let (Some(normal), far) = (patch.normal(s, t), magnified(&patch, s, t)) else { return Ok(()) };
        let curved = patch.jet(s, t).principal_curvatures().map_or(f64::INFINITY, |[a, b]| a.abs().max(b.abs()));
        if far > 1e2 || curved > 10.0 {
            return Ok(());
        }
        let found = patch.locate(patch.point(s, t) + normal * height);
        prop_assert!(found.distance <= height.abs() + 1e-12);
    }

    /// The four sides as arcs give the patch back.
    #[test]
    fn four_arcs_of_a_patch_rebuild_it(data in data()) {
        let Some(patch) = data.patch() else { return Ok(()) };
        let tangents = [patch.jet(0.0, 0.0).ds, patch.jet(0.0, 0.0).dt, patch.jet(1.0, 0.0).dt, patch.jet(0.0, 1.0).ds];
        let rebuilt = QbPatch::from_arcs(data.corners, tangents).unwrap();
        for (got, want) in rebuilt.weights().into_iter().zip(patch.weights()).take(3) {
            prop_assert!((got - want).norm() <= 1e-12);
        }
        // The last one follows from a small difference where the sides are nearly flat.
        for (s, t) in PLACES {
            prop_assert!(rebuilt.point(s, t).distance(patch.point(s, t)) <= 1e-9 * magnified(&patch, s, t));
        }
        // A side that leaves in another direction bounds no such patch.
        let mut turned = tangents;
        turned[3] += Vec3::new(0.0, 0.02, 0.05);
        let error = QbPatch::from_arcs(data.corners, turned).unwrap_err();
        prop_assert_eq!(error.reason(), "arcs-do-not-close");
        turned[3] = -tangents[3];
        prop_assert_eq!(QbPatch::from_arcs(data.corners, turned).unwrap_err().reason(), "arcs-need-complement");
    }

    /// Parameter lines are circles.
    #[test]
    fn parameter_lines_are_circles(data in data(), at in 0.0..1.0_f64) {
        let Some(patch) = data.patch() else { return Ok(()) };
        let point = |along_s: bool, x: f64| if along_s { patch.point(x, at) } else { patch.point(at, x) };
        for along_s in [true, false] {
            let Ok(arc) = Arc::from_three_points(point(along_s, 0.0), point(along_s, 0.4), point(along_s, 1.0)) else { continue };
            let Some((center, radius)) = arc.center().zip(arc.radius()) else { continue };
            let off = |x: f64| (point(along_s, x).distance(center) - radius).abs();
            prop_assert!(off(0.7).max(off(0.2)) <= 1e-9 * radius);
        }
    }
}

#[test]
fn the_default_twist_gives_the_dupin_patch_where_there_is_one() {
    let on_circle = |angle: f64| Point3::new(2.0 * angle.cos(), 2.0 * angle.sin(), 1.0);
    let corners = [0.0, 0.7, 5.5, 2.0].map(on_circle);
    let v1 = Vec3::new(-0.3, 0.9, 0.2).unit().unwrap();
    let v2 = v1.cross(Vec3::new(0.1, 0.3, 1.0)).unit().unwrap();
    let dupin = CyclidePatch::from_corners_and_frame(corners, v1, v2).unwrap();
    let patch = QbPatch::from_directions(corners, [v1, v2], CornerTwist::Default).unwrap();
    assert_eq!(patch.recognize(), QbPatchKind::Dupin);
    for (s, t) in PLACES {
        assert!(patch.point(s, t).distance(dupin.point(s, t)) < 1e-14);
        assert!((patch.line_angle(s, t).unwrap() - std::f64::consts::FRAC_PI_2).abs() < 1e-13);
    }
    let turned = QbPatch::from_directions(corners, [v1, v2], CornerTwist::Twist(0.2)).unwrap();
    assert_eq!(turned.recognize(), QbPatchKind::Darboux);
}

#[test]
fn on_one_sphere_two_numbers_are_free() {
    let on_sphere = |x: f64, y: f64| Point3::new(x, y, (4.0 - x * x - y * y).sqrt());
    let corners = [on_sphere(0.0, 0.0), on_sphere(1.0, 0.1), on_sphere(-0.1, 0.9), on_sphere(0.8, 1.1)];
    let directions = [Vec3::new(1.0, 0.2, 0.0), Vec3::new(-0.1, 1.0, 0.0)];
    let made = |twist| QbPatch::from_directions(corners, directions, twist);
    assert_eq!(made(CornerTwist::Default).unwrap_err().reason(), "twist-not-unique");
    assert_eq!(made(CornerTwist::Twist(0.1)).unwrap_err().reason(), "twist-not-unique");
    let mut middles = Vec::new();
    // In the tangent plane at the first corner, z = 2: a part across it is not free.
    for corner in [[0.4, 0.5, 0.0], [0.5, 0.4, 0.3], [0.6, 0.7, 0.0]] {
        let patch = made(CornerTwist::Corner(Vec3::from(corner))).unwrap();
        let QbPatchKind::Sphere { center, radius } = patch.recognize() else { panic!("{:?}", patch.recognize()) };
        assert!(center.distance(Point3::ORIGIN) < 1e-9 && (radius - 2.0).abs() < 1e-9);
        middles.push(patch.point(0.5, 0.5));
        assert!(matches!(patch.implicit_form(), Some(ImplicitForm::Sphere(_))));
    }
    assert!(middles.len() == 3 && middles[0].distance(middles[1]) > 1e-3 && middles[1].distance(middles[2]) > 1e-3);
}

#[test]
fn real_weights_give_a_quadric_and_its_images() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 1.0]].map(Point3::from);
    let flat = QbPatch::from_weights(corners, [1.0, 1.2, 0.7, 1.5].map(|w| Quat::ONE * w)).unwrap();
    let image = flat.transformed(&Mobius::inversion(Point3::new(2.0, 3.0, -1.0), 2.5).unwrap()).unwrap();
    for patch in [flat, image] {
        assert_eq!(patch.recognize(), QbPatchKind::InvertedQuadric);
        let form = patch.implicit_form().unwrap();
        for (s, t) in PLACES.into_iter().chain([(0.31, 0.62), (0.77, 0.18)]) {
            let p = patch.point(s, t);
            assert!(form.value(p).abs() < 1e-10, "{s} {t} {:e}", form.value(p));
            let found = patch.locate(p);
            assert!(found.distance < 1e-12, "{found:?}");
        }
        assert!(form.value(patch.point(0.5, 0.5) + Vec3::new(0.1, -0.1, 0.2)).abs() > 1e-4);
    }
    let tangents = [Vec3::X, Vec3::Y, Vec3::new(0.0, 1.0, 1.0), Vec3::new(1.0, 0.0, 1.0)];
    assert_eq!(QbPatch::from_arcs(corners, tangents).unwrap_err().reason(), "undetermined-weight");
}

#[test]
fn a_plane_is_one() {
    let corners = [[0.0, 0.0, 2.0], [1.0, 0.0, 2.0], [0.0, 1.0, 2.0], [1.5, 1.2, 2.0]].map(Point3::from);
    let twist = CornerTwist::Corner(Vec3::new(0.5, 0.4, 0.0));
    let patch = QbPatch::from_directions(corners, [Vec3::new(1.0, 0.2, 0.0), Vec3::Y], twist).unwrap();
    assert_eq!(patch.recognize(), QbPatchKind::Plane { normal: Vec3::Z });
    assert_eq!(patch.implicit_form(), Some(ImplicitForm::Sphere([0.0, 0.0, 0.0, -0.5, 1.0])));
}

#[test]
fn what_is_not_finite_is_refused() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.5]].map(Point3::from);
    let reason =
        |corners, directions, twist| QbPatch::from_directions(corners, directions, twist).unwrap_err().reason();
    let (x, y) = (Vec3::X + Vec3::Z * 0.1, Vec3::Y);
    assert_eq!(reason(corners, [x, y], CornerTwist::Twist(f64::NAN)), "not-finite");
    assert_eq!(reason(corners, [x * f64::INFINITY, y], CornerTwist::Default), "not-finite");
    let mut wild = corners;
    wild[2] = Point3::new(0.0, f64::NAN, 0.0);
    assert_eq!(reason(wild, [x, y], CornerTwist::Default), "not-finite");
    // What twists a corner by very much is no error.
    for twist in [1e3, 1e8, -1e15] {
        if let Ok(patch) = QbPatch::from_directions(corners, [x, y], CornerTwist::Twist(twist)) {
            assert!(patch.point(1.0, 1.0).distance(corners[3]) < 1e-12);
        }
    }
}
