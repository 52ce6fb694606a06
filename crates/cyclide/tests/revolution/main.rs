//! Surfaces of revolution: exact points, closed solids with the measures of Pappus, analytic faces of arcs.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]
#![allow(clippy::float_cmp, reason = "numbers handed through are the same")]

mod ends;

use cyclide::{
    Error, Point3, Vec3, Warning,
    construct::Revolution,
    curve::{Arc, Circle},
    error::ProfileError,
    mesh::tessellate,
    model::{CurveObject, SurfaceObject},
    rational::RationalBezier,
    surface::{ParamSurface as _, PatchKind},
    topology::{Body, EdgeCurve, FaceSurface, Shell, surface_joints},
    warning::BodyWarning,
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
    let kind = |surface: &FaceSurface| match surface.patch().map(cyclide::surface::CyclidePatch::recognize) {
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
    // By disks; the fillet is a quarter of a disk of radius 1 about (2, 2), whose center of area is 4/(3 pi) from there.
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
    assert_eq!(refused(&[segment(p(0.0, 0.0), p(0.0, 2.0))], false), "profile-on-axis");
    assert_eq!(refused(&[], false), "too-few-points");
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
    // Where the two lines cross.
    let Err(Error::Profile(ProfileError::MeetsItself { radius, height, .. })) =
        whole().body(&chain(&eight, true), true)
    else {
        panic!("it is no solid")
    };
    assert!((radius - 20.0).abs() < 1e-12 && (height - 15.0).abs() < 1e-12, "{radius} {height}");
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
fn profiles_that_touch_the_axis_between_their_ends_are_refused() {
    let half = Revolution::new(Point3::ORIGIN, Vec3::Z, PI).unwrap();
    let touching: [(&[[f64; 2]], usize); 4] = [
        (&[[0.0, 0.0], [10.0, 5.0], [0.0, 10.0], [10.0, 15.0], [0.0, 20.0]], 2),
        (&[[10.0, 0.0], [0.0, 5.0], [10.0, 10.0]], 1),
        // Along the axis for a while.
        (&[[10.0, 0.0], [0.0, 5.0], [0.0, 8.0], [10.0, 10.0]], 2),
        (&[[0.0, 0.0], [10.0, 5.0], [0.0, 10.0], [5.0, 5.0]], 2),
    ];
    for (points, touches) in touching {
        for turn in [whole(), half] {
            let profile = chain(points, false);
            let error = turn.body(&profile, false).unwrap_err();
            assert!(
                matches!(error, Error::Profile(ProfileError::CrossesAxis { piece, distance: 0.0, .. }) if piece == touches),
                "{error}"
            );
            let same = turn.warnings(&[(profile, false)]).unwrap_err();
            assert_eq!(same.reason(), "crosses-axis");
        }
    }
    // Closed along the axis it is cut into two there.
    assert_eq!(whole().body(&chain(touching[0].0, true), true).unwrap_err().reason(), "crosses-axis");
    // A closed profile that runs along the axis once, wherever it begins: a cylinder with two dents.
    let dents = [[10.0, 0.0], [0.0, 5.0], [0.0, 8.0], [10.0, 10.0]];
    for start in 0..4 {
        let mut points = dents;
        points.rotate_left(start);
        for (turn, part) in [(whole(), 1.0), (half, 0.5)] {
            let profile = chain(&points, true);
            let body = turn.body(&profile, true).unwrap();
            let wanted = part * PI * (1000.0 - 500.0 / 3.0 - 200.0 / 3.0);
            assert!(body.is_solid() && (body.outer.known_volume().unwrap() / wanted - 1.0).abs() < 1e-12, "{start}");
            assert_eq!(turn.warnings(&[(profile, true)]).unwrap(), []);
        }
    }
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

/// The profile is 4 m high, its place five thousand kilometers away.
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

/// The warnings of one profile about an axis.
fn warned(turn: &Revolution, profile: &[EdgeCurve], closed: bool) -> Vec<Warning> {
    turn.warnings(&[(profile.to_vec(), closed)]).unwrap().into_iter().map(|(_, warning)| warning).collect()
}

/// Coordinates with seven digits are off a tilted axis; a body is meant all the same.
#[test]
fn ends_next_to_the_axis_are_moved_onto_it_and_it_is_said() {
    let sweep = |gap: f64| {
        let profile = chain(&[[gap, 0.0], [30.0, 0.0], [30.0, 40.0], [-gap, 40.0]], false);
        let body = whole().body(&profile, false).unwrap();
        (body.is_solid(), body.outer.volume(), warned(&whole(), &profile, false))
    };
    // The profile is 50 in size.
    for gap in [1e-12, 1e-7, 4e-5] {
        let (solid, volume, warnings) = sweep(gap);
        assert!(solid && (volume / (PI * 900.0 * 40.0) - 1.0).abs() < 1e-11, "{gap}: {volume}");
        match warnings[..] {
            [] => assert!(gap < 1e-11),
            [Warning::Body(BodyWarning::MovedToAxis { distance, limit })] => {
                // The end on the other side makes the profile longer.
                assert!((distance - gap).abs() <= 1e-15 && (limit / (1e-6 * 50.0) - 1.0).abs() < 1e-5);
            }
            _ => panic!("{gap}: {warnings:?}"),
        }
    }
    let bowl = chain(&[[1e-3, 0.0], [30.0, 0.0], [30.0, 40.0]], false);
    assert!(!whole().body(&bowl, false).unwrap().is_solid());
    assert_eq!(warned(&whole(), &bowl, false), [Warning::Body(BodyWarning::OpenProfile { start: 1e-3, end: 30.0 })]);
    // Of a closed profile a side along the axis; a bore is kept.
    let washer = |bore: f64| chain(&[[bore, 0.0], [1.0, 0.0], [1.0, 1.0], [bore, 1.0]], true);
    assert!(matches!(warned(&whole(), &washer(1e-7), true)[..], [Warning::Body(BodyWarning::MovedToAxis { .. })]));
    assert_eq!(whole().body(&washer(1e-7), true).unwrap().outer.faces().len(), 12);
    assert_eq!(warned(&whole(), &washer(1e-3), true), []);
    assert_eq!(whole().body(&washer(1e-3), true).unwrap().outer.faces().len(), 16);
}

#[test]
fn the_point_of_the_axis_that_is_given_changes_nothing() {
    let at = |height: f64| Revolution::new(Point3::new(0.0, 0.0, height), Vec3::Z, TAU).unwrap();
    let profile = chain(&[[1e-3, 0.0], [1.0, 0.0], [1.0, 1.0], [1e-3, 1.0]], true);
    let body = at(0.0).body(&profile, true).unwrap();
    for height in [-3.0, 1e6, 1e9] {
        let other = at(height).body(&profile, true).unwrap();
        assert_eq!(other.outer.faces().len(), body.outer.faces().len(), "{height}");
        assert!((other.outer.volume() / body.outer.volume() - 1.0).abs() < 1e-12, "{height}");
    }
    // Heights in messages are from the point given.
    let eight = chain(&[[10.0, 0.0], [30.0, 30.0], [30.0, 0.0], [10.0, 30.0]], true);
    let Err(Error::Profile(ProfileError::MeetsItself { height: near, .. })) = at(0.0).body(&eight, true) else {
        panic!("an eight")
    };
    let Err(Error::Profile(ProfileError::MeetsItself { height: far, .. })) = at(1e6).body(&eight, true) else {
        panic!("an eight")
    };
    assert!((far + 1e6 - near).abs() < 1e-6, "{far} {near}");
    // About an axis in space, from a point a million times as far away as the bore is wide.
    let (h, d, axis) = (2f64.sqrt(), 1e-2, Vec3::new(0.0, 1.0, 1.0));
    let tilted = |r: f64, z: f64| Point3::new(r, z / h, z / h);
    let corners = [tilted(d, 0.0), tilted(1.0, 0.0), tilted(1.0, 1.0), tilted(d, 1.0)];
    let profile: Vec<EdgeCurve> = (0..4).map(|k| segment(corners[k], corners[(k + 1) % 4])).collect();
    for far in [0.0, 3.0, 3e4, 1e6] {
        let body = Revolution::new(Point3::new(0.0, far, far), axis, TAU).unwrap().body(&profile, true).unwrap();
        assert!((body.outer.volume() / (PI * (1.0 - d * d)) - 1.0).abs() < 1e-9, "{far}");
    }
}

#[test]
fn what_stays_open_is_said() {
    let square = chain(&[[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0]], true);
    let half = Revolution::new(Point3::ORIGIN, Vec3::Z, PI).unwrap();
    assert_eq!(warned(&whole(), &square, true), []);
    assert_eq!(warned(&half, &square, true), []);
    // No end faces: a profile that meets itself, and one in no plane with the axis.
    let eight = chain(&[[1.0, 0.0], [3.0, 3.0], [3.0, 0.0], [1.0, 3.0]], true);
    assert_eq!(warned(&half, &eight, true), [Warning::Body(BodyWarning::OpenPart { angle: PI })]);
    let mut tilted = square.clone();
    let off = Point3::new(2.0, 0.5, 1.0);
    tilted.splice(1..3, [segment(p(2.0, 0.0), off), segment(off, p(1.0, 1.0))]);
    assert_eq!(warned(&half, &tilted, true), [Warning::Body(BodyWarning::OpenPart { angle: PI })]);
    // A sheet is what it is.
    assert_eq!(warned(&half, &square[..2], false), []);
    assert_eq!(
        warned(&whole(), &square[..2], false),
        [Warning::Body(BodyWarning::OpenProfile { start: 1.0, end: 2.0 })]
    );
    // Pinched in a point of the axis, wherever the profile begins.
    for start in 0..5 {
        let mut points = [[1.0, -1.0], [2.0, -1.0], [2.0, 1.0], [1.0, 1.0], [0.0, 0.0]];
        points.rotate_left(start);
        let profile = chain(&points, true);
        assert_eq!(warned(&whole(), &profile, true), [Warning::Body(BodyWarning::Pinched { height: 0.0 })], "{start}");
        assert!(whole().body(&profile, true).unwrap().is_solid());
    }
    let twice = chain(&[[1.0, -2.0], [2.0, 0.0], [0.0, 1.0], [1.0, 0.0], [0.0, -1.0]], true);
    assert_eq!(whole().body(&twice, true).unwrap_err().reason(), "crosses-axis");
    // A part of a turn is a wedge all the same.
    assert!(half.body(&twice, true).unwrap().is_solid());
    // A ring of a plane.
    assert_eq!(warned(&whole(), &square[..1], false), [Warning::Body(BodyWarning::FlatRevolution)]);
    // Past the axis, or round it, a profile in a plane across it has places without a normal.
    let across = |points: &[[f64; 2]]| -> Vec<EdgeCurve> {
        let at = |k: usize| Point3::new(points[k][0], points[k][1], 5.0);
        (1..points.len()).map(|k| segment(at(k - 1), at(k))).collect()
    };
    for folded in
        [&[[20.0, 0.0], [20.0, 30.0]][..], &[[10.0, 0.0], [20.0, 0.0], [20.0, 30.0]], &[[-1.0, 2.0], [3.0, 2.0]]]
    {
        assert_eq!(whole().body(&across(folded), false).unwrap_err().reason(), "folded-profile", "{folded:?}");
    }
    let vase = across(&[[30.0, 0.0], [42.0, 25.0], [40.0, 55.0], [22.0, 90.0]]);
    assert_eq!(warned(&whole(), &vase, false), [Warning::Body(BodyWarning::FlatRevolution)]);
    let round = CurveObject::Circle(Circle::from_radius(Point3::ORIGIN, Vec3::Z, 10.0).unwrap());
    assert_eq!(round.revolved(&whole()).unwrap_err().reason(), "folded-profile");
}

#[test]
fn thin_disks_and_washers_are_solids() {
    for thickness in [9e-7, 1e-9] {
        let disk = chain(&[[0.0, 0.0], [1.0, 0.0], [1.0, thickness], [0.0, thickness]], false);
        let washer = chain(&[[0.5, 0.0], [1.0, 0.0], [1.0, thickness], [0.5, thickness]], true);
        for (profile, closed, area) in [(disk, false, PI), (washer, true, 0.75 * PI)] {
            let body = whole().body(&profile, closed).unwrap();
            assert!(body.is_solid() && (body.outer.volume() / (area * thickness) - 1.0).abs() < 1e-6, "{thickness}");
            assert_eq!(warned(&whole(), &profile, closed), []);
        }
    }
}

/// A fillet that reaches through a line by less than it leaves its chords.
#[test]
fn crossings_below_the_sagitta_are_found() {
    let notch = |reach: f64| {
        let (radius, sagitta) = (20.0, 20.0 * (1.0 - (PI / 96.0).cos()));
        let top = 60.0 + reach * sagitta;
        let round = Arc::from_bulge(p(top - radius, -radius), p(top - radius, radius), Vec3::Y, -1.0).unwrap();
        assert!((round.point(0.5).x - top).abs() < 1e-12);
        let line = |from: [f64; 2], to: [f64; 2]| segment(p(from[0], from[1]), p(to[0], to[1]));
        vec![
            line([10.0, -90.0], [60.0, -90.0]),
            line([60.0, -90.0], [60.0, 90.0]),
            line([60.0, 90.0], [10.0, 90.0]),
            line([10.0, 90.0], [top - radius, radius]),
            round.reversed().into(),
            line([top - radius, -radius], [10.0, -90.0]),
        ]
    };
    for reach in [0.9, 0.3, 0.01] {
        let error = whole().body(&notch(reach), true).unwrap_err();
        assert_eq!(error.reason(), "profile-meets-itself", "{reach}");
    }
    assert!(whole().body(&notch(-0.01), true).unwrap().is_solid());
}

/// The profile leaves its pole to one side and comes back through the axis next to it.
#[test]
fn crossings_of_the_axis_next_to_a_pole_are_found() {
    let profile = |lean: f64| {
        let rows = [[0.0, 0.0, 0.0, 1.0], [lean, 0.0, 10.0, 1.0], [30.0, 0.0, 20.0, 1.0], [0.0, 0.0, 60.0, 1.0]];
        EdgeCurve::Rational(RationalBezier::new(rows.to_vec()).unwrap())
    };
    for lean in [-0.01, -0.2] {
        for curve in [profile(lean), profile(lean).reversed()] {
            assert_eq!(whole().body(&[curve], false).unwrap_err().reason(), "crosses-axis", "{lean}");
        }
    }
    assert!(whole().body(&[profile(0.0)], false).unwrap().is_solid());
    assert!(whole().body(&[profile(0.01)], false).unwrap().is_solid());
}

/// A thin hollow next to the outside, between a curve and its chords.
#[test]
fn hollows_are_found_within_the_sagitta() {
    let circle = |r: f64| CurveObject::Circle(Circle::from_radius(p(20.0, 0.0), Vec3::Y, r).unwrap());
    for wall in [1e-2, 1e-4, 1e-6] {
        let made = SurfaceObject::revolved(&[circle(10.0 - wall), circle(10.0)], &whole()).unwrap();
        let [SurfaceObject::Body(body)] = &made[..] else { panic!("{wall}: {} bodies", made.len()) };
        assert_eq!(body.voids.len(), 1);
    }
}

/// The profile is a thousand million times smaller than its distance from the axis.
#[test]
fn thin_rings_far_from_the_axis_are_made() {
    for radius in [1.0, 1e-3] {
        let circle = CurveObject::Circle(Circle::from_radius(p(1e6, 0.0), Vec3::Y, radius).unwrap());
        let SurfaceObject::Body(ring) = circle.revolved(&whole()).unwrap() else { panic!("a body") };
        assert!(ring.is_solid());
        // The rounding of places, 1e-10, against the radius.
        let volume = ring.outer.volume() / (2.0 * PI * PI * radius * radius * 1e6) - 1.0;
        assert!(volume.abs() < 1e-9 / radius, "{radius}: {volume}");
    }
}

#[test]
fn parts_of_turns_have_end_faces() {
    let cubic = |rows: [[f64; 2]; 4]| -> EdgeCurve {
        RationalBezier::new(rows.map(|[x, z]| [x, 0.0, z, 1.0]).to_vec()).unwrap().into()
    };
    let square = chain(&[[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0]], true);
    let angled = chain(&[[1.0, 0.0], [3.0, 0.0], [3.0, 1.0], [2.0, 1.0], [2.0, 3.0], [1.0, 3.0]], true);
    let round: Vec<EdgeCurve> = {
        let half = |from, to| Arc::from_bulge(from, to, Vec3::Y, 1.0).unwrap().into();
        vec![half(p(2.0, 0.0), p(4.0, 0.0)), half(p(4.0, 0.0), p(2.0, 0.0))]
    };
    let drop = vec![cubic([[0.0, 0.0], [3.0, 0.0], [2.0, 4.0], [0.0, 4.0]])];
    let lens = vec![
        segment(p(0.0, 0.0), p(2.0, 0.0)),
        Arc::from_three_points(p(2.0, 0.0), p(1.5, 1.5), p(0.0, 2.0)).unwrap().into(),
        segment(p(0.0, 2.0), p(0.0, 0.0)),
    ];
    for (profile, closed, faces) in [
        (square, true, 4),
        (angled, true, 6),
        (round, true, 4),
        (drop, false, 2),
        (lens.clone(), true, 3),
        (lens[..2].to_vec(), false, 3),
    ] {
        let whole_volume = whole().body(&profile, closed).unwrap().outer.volume();
        for angle in [0.3, -1.0, PI, 5.0, 6.2] {
            let turn = Revolution::new(Point3::ORIGIN, Vec3::Z, angle).unwrap();
            let body = turn.body(&profile, closed).unwrap();
            assert!(body.is_solid(), "{angle}");
            let volume = body.outer.known_volume().unwrap();
            assert!((volume / whole_volume * TAU / angle.abs() - 1.0).abs() < 1e-11, "{angle}: {volume}");
            let flat = |face: &cyclide::topology::ShellFace| {
                let at = face.surface.point(0.3, 0.4);
                let normal = face.outer_normal(0.3, 0.4).unwrap();
                let ends = [0.0, angle].map(|at| Vec3::new(-f64::sin(at), f64::cos(at), 0.0) * angle.signum());
                // Outside is behind the start and ahead of the end.
                ends.iter().zip([-1.0, 1.0]).any(|(along, outside)| {
                    at.to_vec().dot(*along).abs() < 1e-13 && (normal - *along * outside).length() < 1e-9
                })
            };
            let found = body.outer.faces().iter().filter(|face| flat(face)).count();
            assert_eq!(found, 2 * faces, "{angle}");
            assert_eq!(warned(&turn, &profile, closed), []);
            let mesh = tessellate(&body, 1e-3).unwrap();
            assert!((mesh.volume() / volume - 1.0).abs() < 1e-2);
        }
    }
}
