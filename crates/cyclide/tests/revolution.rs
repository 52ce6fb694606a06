//! Surfaces of revolution: exact points, closed solids with the measures of Pappus, analytic faces of arcs.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::{
    Arc, Body, Circle, CurveObject, EdgeCurve, FaceSurface, ParamSurface as _, PatchKind, Point3, RationalBezier,
    Revolution, Shell, SurfaceObject, Vec3, surface_joints, tessellate,
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn p(x: f64, z: f64) -> Point3 {
    Point3::new(x, 0.0, z)
}

fn segment(from: Point3, to: Point3) -> EdgeCurve {
    Arc::segment(from, to).unwrap().into()
}

fn whole() -> Revolution {
    Revolution::new(Point3::ORIGIN, Vec3::Z, TAU).unwrap()
}

#[test]
fn the_exact_form_is_the_turned_profile() {
    let profile = RationalBezier::new(vec![[1.0, 0.2, -1.0, 1.0], [4.0, 0.0, 1.0, 2.0], [0.6, 0.3, 1.2, 0.6]]).unwrap();
    let (o, h) = (Point3::new(0.3, -0.2, 5.0), Vec3::new(1.0, 2.0, -0.5));
    for angle in [0.3, -1.2, FRAC_PI_2, PI, 5.0, -6.0] {
        let turn = Revolution::new(o, h, angle).unwrap();
        let surface = turn.surface(&profile).unwrap();
        for (s, t) in [(0.0, 0.0), (0.2, 0.4), (0.9, 0.5), (1.0, 1.0)] {
            // The angle at t is twice that of (1-t) + w t.
            let (sin, cos) = (0.5 * angle).sin_cos();
            let at = 2.0 * (t * sin).atan2(1.0 - t + t * cos);
            let want = turn.turned(profile.point(s), at);
            // Far from the pole of nearly whole turns: weights of both signs cancel to a tenth.
            assert!(surface.point(s, t).distance(want) < 1e-13, "{angle} {s} {t}");
        }
    }
    assert_eq!(Revolution::new(o, Vec3::ZERO, 1.0).unwrap_err().reason(), "zero-axis");
    assert_eq!(Revolution::new(o, h, 7.0).unwrap_err().reason(), "angle-out-of-range");
    assert_eq!(Revolution::new(o, h, TAU).unwrap().surface(&profile).unwrap_err().reason(), "angle-out-of-range");
    let none = Revolution::new(o, h, 0.0).unwrap();
    assert_eq!(none.body(&[EdgeCurve::Rational(profile)], false).unwrap_err().reason(), "angle-out-of-range");
}

/// Kinds of all faces of a body, each once.
fn kinds(body: &Body) -> Vec<&'static str> {
    let kind = |surface: &FaceSurface| match surface.patch().map(cyclide::CyclidePatch::recognise) {
        None => "rational",
        Some(PatchKind::Plane { .. }) => "plane",
        Some(PatchKind::Cylinder { .. }) => "cylinder",
        Some(PatchKind::Cone { .. }) => "cone",
        Some(PatchKind::Sphere { .. }) => "sphere",
        Some(PatchKind::Torus { .. }) => "torus",
        Some(PatchKind::Cyclide) => "cyclide",
    };
    let mut kinds: Vec<_> = body.outer.faces().iter().map(|face| kind(&face.surface)).collect();
    kinds.sort_unstable();
    kinds.dedup();
    kinds
}

#[test]
fn profiles_of_arcs_give_analytic_faces_and_solids() {
    // A turned part: disk, cylinder, fillet, cone, ball end.
    let fillet = Arc::from_bulge(p(3.0, 2.0), p(2.0, 3.0), Vec3::Y, -(PI / 8.0).tan()).unwrap();
    let ball = Arc::from_center(p(0.0, 5.0), Vec3::Y, p(1.0, 5.0), -FRAC_PI_2).unwrap();
    let profile = [
        segment(p(0.0, 0.0), p(3.0, 0.0)),
        segment(p(3.0, 0.0), p(3.0, 2.0)),
        fillet.into(),
        segment(p(2.0, 3.0), p(1.0, 5.0)),
        EdgeCurve::Arc(ball),
    ];
    let body = whole().body(&profile, false).unwrap();
    assert!(body.is_solid());
    assert_eq!(kinds(&body), ["cone", "cylinder", "plane", "sphere", "torus"]);
    // By disks; the fillet is a quarter of a disk of radius 1 about (2, 2), whose centre of area is 4/(3 pi) from there.
    let cylinder = PI * 9.0 * 2.0;
    let quarter = PI / 4.0 * TAU * (2.0 + 4.0 / (3.0 * PI)) + PI * 4.0;
    let cone = PI * 2.0 / 3.0 * (4.0 + 2.0 + 1.0);
    let half_ball = 2.0 / 3.0 * PI;
    let volume = body.outer.known_volume().unwrap();
    assert!((volume / (cylinder + quarter + cone + half_ball) - 1.0).abs() < 1e-12, "{volume}");
    let area = PI * 9.0 + TAU * 3.0 * 2.0 + PI / 2.0 * TAU * (2.0 + 2.0 / PI) + PI * 3.0 * 5.0_f64.sqrt() + TAU;
    assert!((body.outer.known_area().unwrap() / area - 1.0).abs() < 1e-12);
    for joint in surface_joints(&body.outer) {
        assert!(joint.gap < 1e-14, "{joint:?}");
    }
}

#[test]
fn a_circle_gives_a_torus_and_a_spline_rational_faces() {
    let circle = Circle::from_radius(p(5.0, 1.0), Vec3::Y, 2.0).unwrap();
    let SurfaceObject::Body(torus) = CurveObject::Circle(circle).revolved(&whole()).unwrap() else { panic!("a body") };
    assert!(torus.is_solid() && kinds(&torus) == ["torus"]);
    // Pappus.
    assert!((torus.outer.known_volume().unwrap() / (TAU * 5.0 * PI * 4.0) - 1.0).abs() < 1e-12);
    assert!((torus.outer.known_area().unwrap() / (TAU * 5.0 * TAU * 2.0) - 1.0).abs() < 1e-12);
    // A tilted circle is in no plane with the axis.
    let tilted = Circle::from_radius(p(5.0, 1.0), Vec3::new(0.3, 1.0, 0.2), 2.0).unwrap();
    let SurfaceObject::Body(body) = CurveObject::Circle(tilted).revolved(&whole()).unwrap() else { panic!("a body") };
    assert!(body.is_solid() && kinds(&body) == ["rational"]);
    let mesh = tessellate(&body, 1e-2).unwrap();
    assert!(mesh.bound <= 1e-2 && mesh.volume() > 0.0);
    // A part of a turn is open, whatever the profile is.
    let turn = Revolution::new(Point3::ORIGIN, Vec3::Z, -2.0).unwrap();
    let SurfaceObject::Body(part) = CurveObject::Circle(tilted).revolved(&turn).unwrap() else { panic!("a body") };
    assert!(!part.is_solid() && part.outer.faces().len() < body.outer.faces().len());
    // It begins at the same profile and ends where that has turned to.
    let first = |body: &Body, s: f64| body.outer.faces()[0].surface.point(s, 0.0);
    // Two sectors.
    let last = part.outer.faces().len() / 2;
    for s in [0.0, 0.3, 0.8, 1.0] {
        let start = first(&part, s);
        assert!(start.distance(first(&body, s)) < 1e-14);
        let end = part.outer.faces()[last].surface.point(s, 1.0);
        assert!(end.distance(turn.turned(start, -2.0)) < 1e-14);
    }
}

#[test]
fn profiles_that_meet_the_axis_otherwise_are_refused() {
    let refused = |profile: &[EdgeCurve], closed| whole().body(profile, closed).unwrap_err().reason();
    assert_eq!(refused(&[segment(p(-1.0, 0.0), p(2.0, 1.0))], false), "crosses-axis");
    assert_eq!(
        refused(&[segment(p(1.0, 0.0), p(0.0, 1.0)), segment(p(0.0, 1.0), p(-1.0, 2.0))], false),
        "crosses-axis"
    );
    assert_eq!(refused(&[segment(p(0.0, 0.0), p(0.0, 2.0))], false), "too-few-points");
    assert_eq!(refused(&[segment(p(1.0, 0.0), p(2.0, 2.0)), segment(p(2.0, 3.0), p(1.0, 4.0))], false), "disconnected");
    // Across the axis and back.
    let there_and_back = [segment(p(1.0, 2.0), p(3.0, 2.0)), segment(p(3.0, 2.0), p(2.0, 2.0))];
    assert_eq!(refused(&there_and_back, false), "folded-profile");
    assert!(whole().body(&there_and_back[..1], false).is_ok(), "a ring of a plane");
    // Along the axis a profile sweeps nothing: a triangle with a side there is a double cone.
    let cone =
        [segment(p(0.0, 0.0), p(1.0, 1.0)), segment(p(1.0, 1.0), p(0.0, 2.0)), segment(p(0.0, 2.0), p(0.0, 0.0))];
    let body = whole().body(&cone, true).unwrap();
    assert!(body.is_solid() && (body.outer.volume() / (PI * 2.0 / 3.0) - 1.0).abs() < 1e-12);
}

/// A rational curve that is a straight segment, whatever its parameters do, sweeps what the segment does.
#[test]
fn straight_rational_pieces_give_analytic_faces() {
    let straight = |a: [f64; 2], b: [f64; 2]| {
        let at = |x: f64, w: f64| [w * (a[0] + x * (b[0] - a[0])), 0.0, w * (a[1] + x * (b[1] - a[1])), w];
        EdgeCurve::Rational(RationalBezier::new(vec![at(0.0, 1.0), at(0.2, 3.0), at(0.9, 0.5), at(1.0, 1.0)]).unwrap())
    };
    let knob = [straight([0.0, 0.0], [3.0, 0.0]), straight([3.0, 0.0], [3.0, 2.0]), straight([3.0, 2.0], [0.0, 5.0])];
    let body = whole().body(&knob, false).unwrap();
    assert_eq!(kinds(&body), ["cone", "cylinder", "plane"]);
    assert!((body.outer.volume() / (PI * 9.0 * 3.0) - 1.0).abs() < 1e-12);
    // One that runs forth and back on its line is no segment.
    let back = [[1.0, 0.0, 0.0, 1.0], [5.0, 0.0, 4.0, 1.0], [2.0, 0.0, 1.0, 1.0]];
    let body = whole().body(&[EdgeCurve::Rational(RationalBezier::new(back.to_vec()).unwrap())], false).unwrap();
    assert_eq!(kinds(&body), ["rational"]);
}

fn chain(points: &[[f64; 2]], closed: bool) -> Vec<EdgeCurve> {
    let count = if closed { points.len() } else { points.len() - 1 };
    let at = |k: usize| p(points[k % points.len()][0], points[k % points.len()][1]);
    (0..count).map(|k| segment(at(k), at(k + 1))).collect()
}

#[test]
fn profiles_that_meet_themselves_are_no_solids() {
    let reason =
        |points: &[[f64; 2]], closed| whole().body(&chain(points, closed), closed).map_err(|e| e.reason()).err();
    let eight = [[10.0, 0.0], [30.0, 30.0], [30.0, 0.0], [10.0, 30.0]];
    assert_eq!(reason(&eight, true), Some("profile-meets-itself"));
    assert_eq!(reason(&[[0.0, 0.0], [20.0, 10.0], [20.0, 0.0], [0.0, 10.0]], false), Some("profile-meets-itself"));
    let spike = [[10.0, 0.0], [30.0, 0.0], [30.0, 30.0], [30.0, 0.0], [30.0, -20.0], [10.0, -20.0]];
    assert_eq!(reason(&spike, true), Some("profile-meets-itself"));
    let along =
        [[10.0, 0.0], [20.0, 0.0], [20.0, 20.0], [30.0, 20.0], [30.0, 10.0], [20.0, 10.0], [20.0, 30.0], [10.0, 30.0]];
    assert_eq!(reason(&along, true), Some("profile-meets-itself"));
    // A circle across a plane through the axis covers its meridian twice.
    let circle = Circle::from_radius(Point3::new(30.0, 0.0, 0.0), Vec3::X, 10.0).unwrap();
    let error = CurveObject::Circle(circle).revolved(&whole()).unwrap_err();
    assert_eq!(error.reason(), "profile-meets-itself");
    // Walls that are thinner than the sagittas of chords do not meet.
    let [inner, outer] =
        [10.0, 10.0 + 1e-5].map(|r| Arc::from_three_points(p(20.0 + r, 0.0), p(20.0, r), p(20.0 - r, 0.0)).unwrap());
    let ends = [segment(inner.end(), outer.end()), segment(outer.start(), inner.start())];
    let [back, forth] = ends;
    let shell = [inner.into(), back, outer.reversed().into(), forth];
    assert!(whole().body(&shell, true).unwrap().is_solid());
}

#[test]
fn crossings_of_the_axis_between_places_are_found() {
    for x in [0.9998, 0.999_999_99] {
        for start in [0.0_f64, 0.03, 0.05, 0.07] {
            let at = |u: f64| p(x + (start + u).cos(), (start + u).sin());
            let circle = Circle::through_points([at(0.0), at(2.0), at(4.0)]).unwrap();
            let error = CurveObject::Circle(circle).revolved(&whole()).unwrap_err();
            assert_eq!(error.reason(), "crosses-axis", "{x} {start}");
        }
    }
}

/// The profile is 4 m high, its place five thousand kilometres away.
#[test]
fn places_on_maps_are_no_heights() {
    let turn = Revolution::new(Point3::new(5e5, 5.4e6, 300.0), Vec3::Z, 2.0 * PI).unwrap();
    let at = |r: f64, z: f64| Point3::new(5e5 + r, 5.4e6, 300.0 + z);
    let corners = [at(2.0, 0.0), at(3.0, 0.0), at(3.0, 4.0), at(2.0, 4.0)];
    let profile: Vec<EdgeCurve> = (0..4).map(|k| segment(corners[k], corners[(k + 1) % 4])).collect();
    let body = turn.body(&profile, true).unwrap();
    assert!((body.outer.volume() / (PI * 5.0 * 4.0) - 1.0).abs() < 1e-8);
}

#[test]
fn a_contour_inside_another_is_a_hollow() {
    let circle = |x: f64, radius: f64| CurveObject::Circle(Circle::from_radius(p(x, 0.0), Vec3::Y, radius).unwrap());
    let bodies = |curves: &[CurveObject]| -> Vec<Body> {
        let made = SurfaceObject::revolved(curves, &whole()).unwrap();
        made.into_iter()
            .map(|surface| if let SurfaceObject::Body(body) = surface { body } else { panic!("a body") })
            .collect()
    };
    let torus = |a: f64, r: f64| 2.0 * PI * PI * a * r * r;
    // A ring in the hollow of a ring, and one beside them; in any order.
    let rings = [circle(10.0, 1.0), circle(10.5, 3.0), circle(10.0, 4.0), circle(20.0, 2.0), circle(10.4, 0.5)];
    let found = bodies(&rings);
    assert_eq!(found.iter().map(|body| body.voids.len()).collect::<Vec<_>>(), [1, 1, 0]);
    let volume = |body: &Body| body.shells().map(Shell::volume).sum::<f64>();
    let volumes: Vec<f64> = found.iter().map(volume).collect();
    let wanted = [torus(10.0, 1.0) - torus(10.4, 0.5), torus(10.0, 4.0) - torus(10.5, 3.0), torus(20.0, 2.0)];
    for (found, wanted) in volumes.iter().zip(wanted) {
        // Rounding of the sum of two volumes.
        assert!((found / wanted - 1.0).abs() < 1e-11, "{found} {wanted}");
    }
    let refused = SurfaceObject::revolved(&[circle(10.0, 1.0), circle(11.0, 1.0)], &whole()).unwrap_err();
    assert_eq!(refused.reason(), "profile-meets-itself");
    // A profile from the axis to the axis goes round one that the axis closes too.
    let half = |radius: f64| {
        let at = |z: f64| Point3::new(0.0, 0.0, z);
        CurveObject::Arc(Arc::from_three_points(at(-radius), Point3::new(radius, 0.0, 0.0), at(radius)).unwrap())
    };
    let [ball] = &bodies(&[half(2.0), half(1.0)])[..] else { panic!("one body") };
    assert!((volume(ball) / (28.0 / 3.0 * PI) - 1.0).abs() < 1e-12);
}
