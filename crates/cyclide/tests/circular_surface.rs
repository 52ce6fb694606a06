//! Arcs and straight lines between two rails: bridges of ellipses, circular and ruled surfaces.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::{
    Error, Point3, Quat, Vec3, Warning,
    conformal::{Conformal as _, Mobius},
    construct::{EllipseBridge, RailSurface},
    curve::Arc,
    error::{ArcError, BridgeError},
    mesh::tessellate,
    rational::{RationalBezier, RationalBezierSurface},
    surface::{ParamSurface as _, PatchKind},
    topology::{Body, EdgeCurve, FaceGeometry as _, FaceSurface, surface_joints},
    warning::BodyWarning,
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn segment(from: Point3, to: Point3) -> EdgeCurve {
    Arc::segment(from, to).unwrap().into()
}

/// The angle at s of the quadratic with the weights 1, cos(π/4), 1 of a quarter from 0.
fn quarter_angle(s: f64) -> f64 {
    let half = 0.25 * PI;
    2.0 * (s * half.sin()).atan2(1.0 - s + s * half.cos())
}

const BRIDGES: [([f64; 2], [f64; 2]); 6] = [
    ([1.0, 2.0], [3.0, 2.5]),
    ([3.0, 2.5], [1.0, 2.0]),
    ([1.1, 2.2], [2.0, 3.1]),
    ([1.0, 1.0], [3.0, 3.0]),
    ([1.0, 3.0], [2.0, 1.5]),
    ([10.0, 10.0], [10.1, 20.0]),
];

#[test]
fn bridges_are_half_circles_upright_on_their_chords() {
    for (first, second) in BRIDGES {
        let bridge = EllipseBridge::new(first, second).unwrap();
        let surface = bridge.surface(0.0, FRAC_PI_2).unwrap();
        let [x, y] = [0, 1].map(|d: usize| (second[d] - first[d]).abs());
        let even = (x - y).abs() < 1e-12;
        assert_eq!(surface.degrees(), if even { [2, 2] } else { [6, 2] });
        for s in [0.0, 0.2, 0.5, 0.9, 1.0] {
            let (sin, cos) = quarter_angle(s).sin_cos();
            let q0 = p(first[0] * cos, first[1] * sin, 0.0);
            let q1 = p(second[0] * cos, second[1] * sin, 0.0);
            let (centre, radius) = (q0.midpoint(q1), 0.5 * q0.distance(q1));
            let arc = bridge.arc(quarter_angle(s)).unwrap();
            for t in [0.0, 0.25, 0.5, 0.8, 1.0] {
                let x = surface.point(s, t);
                assert!((x.distance(centre) - radius).abs() < 1e-14 * 3.0 && x.z > -1e-15);
                assert!((x - centre).dot((q1 - q0).cross(Vec3::Z)).abs() < 1e-14 * 9.0);
                assert!(x.distance(arc.point(t)) < 2e-14);
            }
            // Tangent to the cylinders below: upright at both ends.
            for t in [0.0, 1.0] {
                let normal = surface.unit_normal(s, t);
                let [a, b] = if t == 0.0 { first } else { second };
                let gradient = Vec3::new(cos / a, sin / b, 0.0).unit().unwrap();
                assert!(normal.cross(gradient).length() < 1e-13, "{first:?} {second:?} {s} {t}");
            }
        }
    }
}

#[test]
fn solid_bridges_have_known_volumes() {
    for (first, second) in BRIDGES {
        let bridge = EllipseBridge::new(first, second).unwrap();
        let open = bridge.body(None).unwrap();
        let free = open.outer.edge_uses().into_iter().enumerate().filter(|(_, n)| *n == 1).map(|(edge, _)| edge);
        let free: Vec<_> = free.map(|edge| &open.outer.edges()[edge].curve).collect();
        assert!(!open.is_solid() && free.len() >= 8 && free.iter().all(|curve| curve.point(0.3).z.abs() <= 1e-15));
        let crossing = (second[0] - first[0]) * (second[1] - first[1]) < 0.0;
        let solid = bridge.body(Some(1.5));
        if crossing {
            assert_eq!(solid.unwrap_err().reason(), "ellipses-cross");
            assert_eq!(bridge.whole_circles().unwrap_err().reason(), "ellipses-cross");
            continue;
        }
        let solid = solid.unwrap();
        assert!(solid.is_solid());
        for joint in surface_joints(&solid.outer) {
            assert!(joint.gap < 1e-14 * 3.0, "{joint:?}");
        }
        // Over the plan, between the ellipses (1-τ) q0 + τ q1 with the element |(da (1-τ)b + ...)|: the height is that of the half
        // circle, |q1 - q0| √(τ - τ²).
        let lerp = |d: usize, x: f64| first[d] + (second[d] - first[d]) * x;
        let [x, y] = [0, 1].map(|d| second[d] - first[d]);
        // The length of the chord is all but a cusp where one of its widths is small beside the other.
        let steps = 40_000;
        let mut arch = 0.0;
        for i in 0..steps {
            let (sin, cos) = (TAU * (f64::from(i) + 0.5) / f64::from(steps)).sin_cos();
            let chord = (x * cos).hypot(y * sin);
            // ∫ √(τ-τ²) (x cos² lerp_y(τ) + y sin² lerp_x(τ)) dτ: the middle of τ by symmetry, times π/8.
            arch += chord * PI / 8.0 * (x * cos * cos * lerp(1, 0.5) + y * sin * sin * lerp(0, 0.5));
        }
        arch *= TAU / f64::from(steps);
        let ring = PI * (second[0] * second[1] - first[0] * first[1]);
        let want = (arch + 1.5 * ring).abs();
        let found = solid.outer.known_volume().unwrap();
        assert!((found / want - 1.0).abs() < 1e-10, "{first:?} {second:?}: {found} {want}");
        // Whole circles: the same arch above and below.
        let whole = bridge.whole_circles().unwrap();
        assert!(whole.is_solid() && whole.outer.edge_uses().into_iter().all(|uses| uses == 2));
        let found = whole.outer.known_volume().unwrap();
        assert!((found / (2.0 * arch.abs()) - 1.0).abs() < 1e-10, "{first:?} {second:?}: {found} {arch}");
        for joint in surface_joints(&whole.outer) {
            assert!(joint.gap < 1e-14 * 3.0 && joint.angle < 1e-7, "{joint:?}");
        }
    }
}

#[test]
fn the_bridge_of_circles_is_analytic() {
    let body = EllipseBridge::new([3.0, 3.0], [1.0, 1.0]).unwrap().body(Some(2.0)).unwrap();
    let mut kinds: Vec<&str> = Vec::new();
    for face in body.outer.faces() {
        kinds.push(match face.surface.patch().map(cyclide::surface::CyclidePatch::recognize) {
            Some(PatchKind::Torus { .. }) => "torus",
            Some(PatchKind::Cylinder { .. }) => "cylinder",
            Some(PatchKind::Plane { .. }) => "plane",
            _ => "other",
        });
    }
    kinds.sort_unstable();
    kinds.dedup();
    assert_eq!(kinds, ["cylinder", "plane", "torus"]);
}

/// A ring a million times as wide as it is thick, level and tilted: half a torus on a tube, by Pappus.
#[test]
fn the_volume_of_a_thin_ring_keeps_its_digits() {
    let turn = Mobius::similarity(Quat::new(0.8, 0.3, -0.4, 0.2), 1.0, Vec3::ZERO).unwrap();
    for radius in [1.0, 1e3, 1e6] {
        let depth = 2.0;
        let body = EllipseBridge::new([radius; 2], [radius + 1.0; 2]).unwrap().body(Some(depth)).unwrap();
        let exact = TAU * (radius + 0.5) * (PI / 8.0 + depth);
        for body in [body.transformed(&turn).unwrap(), body] {
            // The rounding of points a radius away, over the thickness, and some of the quadrature.
            let bound = 1e-12 + 8.0 * f64::EPSILON * radius;
            assert!((body.outer.volume() / exact - 1.0).abs() < bound, "{radius}: {} {exact}", body.outer.volume());
        }
    }
}

#[test]
fn bridges_that_are_none_are_refused() {
    let refused = |first, second| EllipseBridge::new(first, second).unwrap_err().reason();
    assert_eq!(refused([1.0, 2.0], [1.0, 3.0]), "coincident-points");
    assert_eq!(refused([1.0, 2.0], [2.0, 2.0 + 1e-13]), "coincident-points");
    assert_eq!(refused([1.0, 0.0], [2.0, 3.0]), "radius-not-positive");
    assert_eq!(refused([1.0, 1.0], [f64::NAN, 3.0]), "not-finite");
    let narrow = EllipseBridge::new([1.0, 2.0], [1.0 + 1e-11, 2.5]).unwrap();
    assert_eq!(narrow.body(None).unwrap_err().reason(), "below-rounding-of-place");
    let bridge = EllipseBridge::new([1.0, 2.0], [2.0, 3.0]).unwrap();
    for (depth, reason) in [(0.0, "parameter-out-of-range"), (-1.0, "parameter-out-of-range"), (f64::NAN, "not-finite")]
    {
        assert_eq!(bridge.body(Some(depth)).unwrap_err().reason(), reason);
    }
}

#[test]
fn tangents_nearly_against_their_chords_are_refused() {
    let (low, high) =
        ([segment(p(0.0, 0.0, 0.0), p(10.0, 0.0, 0.0))], [segment(p(0.0, 0.0, 10.0), p(10.0, 0.0, 10.0))]);
    let made = |angle: f64| Body::circular([&low, &high], &[Vec3::new(0.0, angle.sin(), -angle.cos())], false);
    for off in [0.0, 1e-4, 1e-3, 9.9e-3] {
        let Error::Arc(ArcError::TangentOpposesChord { index: 0, angle, limit }) = made(off).unwrap_err() else {
            panic!("against the chord")
        };
        assert!((angle - off).abs() < 1e-12 && (limit - 1e-2).abs() < 1e-15);
    }
    // Just beyond: a cylinder of the radius that belongs to chord and tangent, in one piece with its mesh.
    let body = made(1.01e-2).unwrap();
    let radius = 5.0 / f64::sin(1.01e-2);
    let want = 10.0 * radius * 2.0 * (PI - 1.01e-2);
    assert!((body.outer.known_area().unwrap() / want - 1.0).abs() < 1e-10);
    assert!(surface_joints(&body.outer).iter().all(|joint| joint.gap < 1e-9 * radius && joint.angle < 1e-9));
    let mesh = tessellate(&body, 1e-2 * radius).unwrap();
    assert!(mesh.bound <= 1e-2 * radius);
}

#[test]
fn chords_of_different_lengths_have_arcs_to_the_same_limit() {
    // The chord and the tangent are at the same angle everywhere: arcs of one angle, on the circles of chords of 8 to 12 and of 8 to 80.
    for end in [12.0, 80.0] {
        let (first, second) =
            ([segment(p(0.0, 0.0, 0.0), p(20.0, 0.0, 0.0))], [segment(p(0.0, 8.0, 0.0), p(20.0, end, 0.0))]);
        for angle in [0.0101_f64, 0.02, 0.1, 0.3, 1.0] {
            let tangent = Vec3::new(0.0, -angle.cos(), angle.sin());
            let made = RailSurface::circular([&first, &second], &[tangent], false).unwrap();
            match made.warnings() {
                [] => assert!(angle >= 0.1),
                [Warning::Body(BodyWarning::NearlyFullArcs { piece: 0, angle: said, limit })] => {
                    assert!((said - angle).abs() < 1e-12 && angle < *limit);
                }
                other => panic!("{other:?}"),
            }
            let body = made.into_body();
            assert!(surface_joints(&body.outer).iter().all(|joint| joint.angle < 1e-7), "{end} {angle}");
            for face in body.outer.faces() {
                let FaceSurface::Rational(surface) = &face.surface else { panic!("a rational face") };
                assert!(surface.has_positive_weights());
                for (s, t) in [(0.0, 0.5), (0.3, 0.2), (0.7, 0.9)] {
                    let q = surface.point(s, t);
                    let chord = 8.0 + (end - 8.0) * q.x / 20.0;
                    // In the plane of its x, on the circle through both ends whose tangent leaves the chord at π - angle.
                    let (radius, up) = (0.5 * chord / angle.sin(), 0.5 * chord / angle.tan());
                    let off = (q - p(q.x, 0.5 * chord, up)).length() - radius;
                    assert!(off.abs() < 1e-9 * radius, "{end} {angle}: {off}");
                }
            }
        }
    }
}

/// Rails of all kinds: lines, arcs, a cubic with other weights, in space.
fn rails() -> Vec<[RationalBezier; 2]> {
    let line = |a: Point3, b: Point3| RationalBezier::new(vec![[a.x, a.y, a.z, 1.0], [b.x, b.y, b.z, 1.0]]).unwrap();
    let arc = |a: Point3, b: Point3, v: Vec3| {
        RationalBezier::new(Arc::from_start_tangent(a, b, v).unwrap().bezier_rows().to_vec()).unwrap()
    };
    let low = line(p(0.0, 0.0, 0.0), p(4.0, 1.0, 0.0));
    let bent = arc(p(0.0, 3.0, 1.0), p(5.0, 4.0, 0.0), Vec3::new(3.0, 3.0, 1.0));
    let other = arc(p(0.0, -3.0, 0.0), p(5.0, -4.0, 1.0), Vec3::new(4.0, 0.5, 0.0));
    let cubic = RationalBezier::new(vec![
        [0.0, 2.0, 0.0, 1.0],
        [2.0, 6.0, 2.0, 2.0],
        [1.5, 2.0, 0.0, 0.5],
        [9.0, 7.5, 0.0, 1.5],
    ])
    .unwrap();
    vec![
        [low.clone(), line(p(0.0, 2.0, 1.0), p(4.0, 3.0, 2.0))],
        [low.clone(), bent.clone()],
        [bent.clone(), other],
        [low, cubic.clone()],
        [bent, cubic],
    ]
}

#[test]
fn circular_surfaces_are_their_arcs() {
    for (k, [first, second]) in rails().into_iter().enumerate() {
        for tangent in [[Vec3::new(0.1, 0.2, 2.0); 2], [Vec3::new(0.5, 0.0, 2.0), Vec3::new(-0.3, 1.0, 1.0)]] {
            let surface = RationalBezierSurface::circular(&first, &second, tangent).unwrap();
            for s in [0.0, 0.3, 0.5, 0.85, 1.0] {
                let v = tangent[0] * (1.0 - s) + tangent[1] * s;
                let arc = Arc::from_start_tangent(first.point(s), second.point(s), v).unwrap();
                for t in [0.0, 0.2, 0.5, 0.9, 1.0] {
                    let (x, y) = (surface.point(s, t), arc.point(t));
                    // Products of rows of degree 15 lose some digits.
                    assert!(x.distance(y) < 1e-12, "{k} {s} {t}: {:e}", x.distance(y));
                }
                // The derivative at the first rail is the tangent.
                assert!((surface.jet(s, 0.0).dt - v).length() < 1e-11);
            }
        }
    }
    // Parallel lines and one direction: a cylinder, of degree 1 along it.
    let line = |y: f64, z: f64| RationalBezier::new(vec![[0.0, y, z, 1.0], [4.0, y + 1.0, z, 1.0]]).unwrap();
    let (first, second) = (line(0.0, 0.0), line(2.0, 1.0));
    let surface = RationalBezierSurface::circular(&first, &second, [Vec3::Z; 2]).unwrap();
    assert_eq!(surface.degrees(), [1, 2]);
}

#[test]
fn sewn_circular_surfaces_have_positive_weights_and_shared_edges() {
    let rail = |y: f64, z: f64| {
        vec![
            segment(p(0.0, y, z), p(2.0, y + 0.5, z)),
            Arc::from_start_tangent(p(2.0, y + 0.5, z), p(4.0, y, z + 1.0), Vec3::new(1.0, 0.25, 0.0)).unwrap().into(),
        ]
    };
    let (first, second) = (rail(0.0, 0.0), rail(3.0, 0.2));
    for tangents in [
        vec![Vec3::Z],
        vec![Vec3::new(0.0, 1.0, 0.2)],
        // Nearly round.
        vec![Vec3::new(0.0, -1.0, 0.3)],
        vec![Vec3::Z, Vec3::new(0.0, 1.0, 1.0), Vec3::new(0.0, 0.3, 1.0)],
    ] {
        let body = Body::circular([&first, &second], &tangents, false).unwrap();
        for face in body.outer.faces() {
            assert!(face.surface.to_rational().has_positive_weights());
        }
        for joint in surface_joints(&body.outer) {
            assert!(joint.gap < 1e-12, "{joint:?}");
        }
        // At the rails, and no other borders than those and the two ends.
        let mesh = tessellate(&body, 1e-2).unwrap();
        assert!(mesh.bound <= 1e-2);
        let scaled = |rail: &[EdgeCurve]| -> Vec<EdgeCurve> {
            rail.iter()
                .map(|c| {
                    EdgeCurve::Arc(
                        c.arc().unwrap().transformed(&Mobius::similarity(Quat::ONE, 1e3, Vec3::ZERO).unwrap()).unwrap(),
                    )
                })
                .collect()
        };
        let large = Body::circular([&scaled(&first), &scaled(&second)], &tangents, false).unwrap();
        assert_eq!(large.outer.faces().len(), body.outer.faces().len());
        for (a, b) in body.outer.faces().iter().zip(large.outer.faces()) {
            let (x, y) = (a.surface.point(0.3, 0.6), b.surface.point(0.3, 0.6));
            assert!((x.to_vec() * 1e3 - y.to_vec()).length() < 1e-9);
        }
    }
}

#[test]
fn ruled_surfaces_join_equal_parameters() {
    // A cone, a cylinder between tilted ellipses' planes, a hyperbolic paraboloid.
    let circle = |r: f64, z: f64| -> Vec<EdgeCurve> {
        let at = |k: u32| {
            let (sin, cos) = (TAU * f64::from(k) / 3.0).sin_cos();
            p(r * cos, r * sin, z)
        };
        (0..3).map(|k| Arc::from_center(p(0.0, 0.0, z), Vec3::Z, at(k), TAU / 3.0).unwrap().into()).collect()
    };
    let (low, high) = (circle(2.0, 0.0), circle(1.0, 3.0));
    let body = Body::ruled([&low, &high], true).unwrap();
    assert!(body.outer.faces().len() == 3 && body.outer.edges().len() == 9);
    let want = PI * 3.0 * 10.0_f64.sqrt();
    assert!((body.outer.known_area().unwrap() / want - 1.0).abs() < 1e-12);
    for joint in surface_joints(&body.outer) {
        assert!(joint.gap < 1e-14 && joint.angle < 1e-12, "{joint:?}");
    }
    let (a, b) = ([segment(p(0.0, 0.0, 0.0), p(1.0, 0.0, 1.0))], [segment(p(0.0, 1.0, 1.0), p(1.0, 1.0, 0.0))]);
    let saddle = Body::ruled([&a, &b], false).unwrap();
    let FaceSurface::Rational(face) = &saddle.outer.faces()[0].surface else { panic!("rational") };
    assert_eq!(face.degrees(), [1, 1]);
    for (s, t) in [(0.2, 0.7), (0.5, 0.5), (0.9, 0.1)] {
        let x = face.point(s, t);
        // z = s + t - 2 s t.
        assert!(x.distance(p(s, t, s + t - 2.0 * s * t)) < 1e-15);
    }
    // With one corner lifted: no plane, although the bilinear map of quaternions with weights of 1 is the same.
    let low = [segment(p(0.0, 0.0, 0.0), p(10.0, 0.0, 0.0))];
    let lifted = [segment(p(0.0, 10.0, 0.0), p(10.0, 10.0, 4.0))];
    let saddle = Body::ruled([&low, &lifted], false).unwrap();
    let surface = &saddle.outer.faces()[0].surface;
    assert!(matches!(surface, FaceSurface::Rational(_)));
    // The mean of 100 √(1 + 0.16 (s² + t²)) over the square.
    assert!((saddle.outer.known_area().unwrap() - 105.149_89).abs() < 1e-5);
    for (s, t) in [(0.0, 0.0), (0.3, 0.8), (1.0, 1.0)] {
        let want = Vec3::new(-0.4 * t, -0.4 * s, 1.0).unit().unwrap();
        assert!(surface.unit_normal(s, t).cross(want).length() < 1e-14);
    }
    // A plane is one still as a rectangle, and no patch as another parallelogram.
    for (shift, patch) in [(0.0, true), (3.0, false)] {
        let beside = [segment(p(shift, 10.0, 0.0), p(10.0 + shift, 10.0, 0.0))];
        let plane = Body::ruled([&low, &beside], false).unwrap();
        assert_eq!(plane.outer.faces()[0].surface.patch().is_some(), patch);
        assert!((plane.outer.known_area().unwrap() - 100.0).abs() < 1e-11);
    }
    // Rails from one point: three sides.
    let fan = Body::ruled([&a, &[segment(p(0.0, 0.0, 0.0), p(0.0, 2.0, 0.0))]], false).unwrap();
    assert!(fan.outer.vertices().len() == 3 && fan.outer.edges().len() == 3);
    // Weights that differ at the ends: the rulings there run evenly all the same.
    let uneven = RationalBezier::new(vec![[0.0, 0.0, 2.0, 1.0], [1.0, 1.0, 2.0, 1.0], [6.0, 0.0, 6.0, 3.0]]).unwrap();
    let body = Body::ruled([&a, &[EdgeCurve::Rational(uneven.clone())]], false).unwrap();
    let face = &body.outer.faces()[0].surface;
    for s in [0.0, 0.4, 1.0] {
        assert!(face.point(s, 1.0).distance(uneven.point(s)) < 1e-14);
        let (from, to, x) = (face.point(s, 0.0), face.point(s, 1.0), face.point(s, 0.5));
        assert!((x - from).cross(to - from).length() < 1e-14 * 10.0);
    }
    assert!(face.point(1.0, 0.5).distance(p(1.5, 0.0, 1.5)) < 1e-15);
}

#[test]
fn rails_that_do_not_fit_are_refused() {
    let a = [segment(p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0)), segment(p(1.0, 0.0, 0.0), p(2.0, 0.0, 0.0))];
    let b = [segment(p(0.0, 1.0, 0.0), p(1.0, 1.0, 0.0)), segment(p(1.0, 1.0, 0.0), p(2.0, 1.0, 0.0))];
    let ruled = |a: &[EdgeCurve], b: &[EdgeCurve], closed| Body::ruled([a, b], closed).unwrap_err();
    let error = ruled(&a, &b[..1], false);
    assert_eq!(error.reason(), "piece-counts-differ");
    assert!(error.to_string().contains("2 piece(s)") && error.to_string().contains('1'), "{error}");
    assert_eq!(ruled(&[], &[], false).reason(), "too-few-points");
    assert_eq!(ruled(&a, &b, true).reason(), "disconnected");
    let bad = RationalBezier::new(vec![[0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, -1.0], [2.0, 0.0, 0.0, 1.0]]).unwrap();
    assert_eq!(ruled(&a[..1], &[bad.into()], false).reason(), "weight-not-positive");
    assert_eq!(ruled(&a, &a, false).reason(), "coincident-points");
    let circular = |b: &[EdgeCurve], v: &[Vec3]| Body::circular([&a, b], v, false).unwrap_err().reason();
    assert_eq!(circular(&b, &[]), "count-differs");
    assert_eq!(circular(&b, &[Vec3::Z; 2]), "count-differs");
    assert_eq!(circular(&b, &[Vec3::ZERO]), "zero-tangent");
    assert_eq!(circular(&b, &[Vec3::new(f64::NAN, 0.0, 0.0)]), "not-finite");
    // Halfway between directions that oppose each other, of whatever lengths, there is none.
    let x = Vec3::X;
    for (tangents, first, second) in
        [([Vec3::Z, -Vec3::Z, x], 0, 1), ([x, Vec3::Z * 1e3, Vec3::new(0.0, 1e-9, -1.0)], 1, 2)]
    {
        let error = Body::circular([&a, &b], &tangents, false).unwrap_err();
        assert!(
            matches!(error, Error::Bridge(BridgeError::OppositeTangents { first: f, second: s, .. }) if [f, s] == [first, second]),
            "{error}"
        );
    }
    assert_eq!(circular(&a, &[Vec3::Z]), "coincident-points");
    // From one point on.
    let fan = [segment(p(0.0, 0.0, 0.0), p(0.0, 1.0, 0.0)), segment(p(0.0, 1.0, 0.0), p(0.0, 2.0, 0.0))];
    assert_eq!(circular(&fan, &[Vec3::Z]), "coincident-points");
    let high = RationalBezier::new((0..=12).map(|k| [f64::from(k), 1.0, 0.0, 1.0 + 0.1 * f64::from(k % 3)]).collect());
    let high = [EdgeCurve::Rational(high.unwrap())];
    let error = Body::circular([&a[..1], &high], &[Vec3::Z], false).unwrap_err();
    assert_eq!(error.reason(), "degree-too-high", "{error}");
}

#[test]
fn rulings_that_cross_are_refused() {
    let crossing = |a: &[EdgeCurve], b: &[EdgeCurve], closed| {
        let Error::Bridge(BridgeError::RulingsCross { piece: 0, at, normal, limit }) =
            Body::ruled([a, b], closed).unwrap_err()
        else {
            panic!("rulings cross")
        };
        assert!(normal <= limit);
        at
    };
    let at = |[x, y, z]: [f64; 3]| p(x, y, z);
    let line = |from: [f64; 3], to: [f64; 3]| [segment(at(from), at(to))];
    let low = line([0.0, 0.0, 0.0], [10.0, 0.0, 0.0]);
    // All in one point, half-way up.
    assert!((crossing(&low, &line([10.0, 0.0, 10.0], [0.0, 0.0, 10.0]), false)[1] - 0.5).abs() < 1e-15);
    // Both curves cross: at 1/2, and between the places that are looked at.
    for (end, s) in [(0.0, 0.5), (6.0, 1.0 / 1.4)] {
        let b = line([0.0, 10.0, 0.0], [10.0, end, 0.0]);
        let at = crossing(&line([0.0, 0.0, 0.0], [10.0, 10.0, 0.0]), &b, false);
        assert!((at[0] - s).abs() < 1e-9, "{at:?}");
    }
    // Both on one line.
    crossing(&low, &line([20.0, 0.0, 0.0], [35.0, 0.0, 0.0]), false);
    crossing(&low, &line([10.0, 0.0, 0.0], [35.0, 0.0, 0.0]), false);
    // Circles of opposite normals, wherever they begin: a ruling in a plane with the axis has no normal in its middle.
    for start in [0.0, 0.3, 2.0] {
        let circle = |z: f64, sign: f64| -> Vec<EdgeCurve> {
            let at = |k: u32| start + TAU * f64::from(k) / 3.0;
            let place = |angle: f64| p(5.0 * angle.cos(), 5.0 * sign * angle.sin(), z);
            let arc = |k| Arc::from_center(p(0.0, 0.0, z), Vec3::Z * sign, place(at(k)), TAU / 3.0).unwrap().into();
            (0..3).map(arc).collect()
        };
        assert!(Body::ruled([&circle(0.0, 1.0), &circle(7.0, 1.0)], true).is_ok());
        let error = Body::ruled([&circle(0.0, 1.0), &circle(7.0, -1.0)], true).unwrap_err();
        assert_eq!(error.reason(), "rulings-cross");
        assert!(error.to_string().contains("check the direction"), "{error}");
        let Error::Bridge(BridgeError::RulingsCross { at, .. }) = error else { panic!("{error}") };
        assert!((at[1] - 0.5).abs() < 1e-9, "{at:?}");
    }
    // Tips are none: curves that meet in an end, a curve that stops in one, and the tangents of a curve.
    assert!(Body::ruled([&low, &line([0.0, 0.0, 0.0], [10.0, 4.0, 3.0])], false).is_ok());
    assert!(Body::ruled([&low, &line([0.0, 5.0, 0.0], [10.0, 0.0, 0.0])], false).is_ok());
    let stops = RationalBezier::new(vec![[0.0, 5.0, 0.0, 1.0], [9.0, 5.0, 1.0, 1.0], [9.0, 5.0, 1.0, 1.0]]).unwrap();
    assert!(Body::ruled([&low, &[stops.into()]], false).is_ok());
    let rows = |rows: [[f64; 3]; 4]| RationalBezier::new(rows.map(|[x, y, z]| [x, y, z, 1.0]).to_vec()).unwrap();
    // (s, s², s³) and the ends of its derivatives.
    let edge = rows([[0.0, 0.0, 0.0], [1.0 / 3.0, 0.0, 0.0], [2.0 / 3.0, 1.0 / 3.0, 0.0], [1.0, 1.0, 1.0]]);
    let ends = rows([[1.0, 0.0, 0.0], [4.0 / 3.0, 2.0 / 3.0, 0.0], [5.0 / 3.0, 5.0 / 3.0, 1.0], [2.0, 3.0, 4.0]]);
    assert!(Body::ruled([&[edge.into()], &[ends.into()]], false).is_ok());
}

#[test]
fn rulings_are_judged_at_any_size() {
    // Products of three lengths leave the numbers at both ends of these.
    for size in [1e-130, 1e-100, 1e-60, 1.0, 1e60, 1e100, 1e130] {
        let line = |from: [f64; 3], to: [f64; 3]| {
            let at = |[x, y, z]: [f64; 3]| p(size * x, size * y, size * z);
            [segment(at(from), at(to))]
        };
        let low = line([0.0, 0.0, 0.0], [10.0, 0.0, 0.0]);
        assert!(Body::ruled([&low, &line([0.0, 3.0, 10.0], [10.0, -4.0, 12.0])], false).is_ok(), "{size:e}");
        let against = Body::ruled([&low, &line([10.0, 0.0, 10.0], [0.0, 0.0, 10.0])], false).unwrap_err();
        assert_eq!(against.reason(), "rulings-cross", "{size:e}");
    }
}

#[test]
fn rulings_that_cross_for_a_moment_are_refused() {
    // In a plane: the normals of both ends turn round within a 250th of the piece, where the second arc turns away from the first.
    for (start, turns) in [(0.0, 0.942), (-1.0, 0.939)] {
        let through = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
            let [a, b, c] = [a, b, c].map(|[x, y, z]| p(x, y, z));
            [EdgeCurve::from(Arc::from_three_points(a, b, c).unwrap())]
        };
        let first = through([0.0, 0.0, 0.0], [10.0, 2.0, 0.0], [20.0, 0.0, 0.0]);
        let second = through([0.0, start, 0.0], [10.0, -2.0, 0.0], [20.0, 1.0, 0.0]);
        let Error::Bridge(BridgeError::RulingsCross { at, .. }) = Body::ruled([&first, &second], false).unwrap_err()
        else {
            panic!("rulings cross")
        };
        assert!((at[0] - turns).abs() < 3e-3, "{at:?}");
    }
}
