//! What is said and refused of surfaces between two curves: arcs that cross, kinks at smooth joints; bridges that nearly touch or cross.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]
#![allow(clippy::float_cmp, reason = "numbers handed through are the same")]

use cyclide::{
    Error, Point3, Vec3, Warning,
    construct::{Ellipse, EllipseBridge, RailSurface},
    curve::{Arc, Circle},
    error::BridgeError,
    rational::RationalBezier,
    surface::ParamSurface as _,
    topology::{Body, EdgeCurve, FaceSurface, surface_joints},
    warning::BodyWarning,
};
use proptest::prelude::*;
use std::f64::consts::PI;
use std::slice::from_ref;

fn through(points: [[f64; 3]; 3]) -> EdgeCurve {
    let [a, b, c] = points.map(Point3::from);
    Arc::from_three_points(a, b, c).unwrap().into()
}

#[test]
fn arcs_that_cross_are_refused() {
    let first = through([[-1.0, 0.0, 0.0], [0.0, 0.1, 0.0], [1.0, 0.0, 0.0]]);
    let second = through([[1.0, 0.5, 0.0], [0.0, 0.4, 0.0], [-1.0, 0.5, 0.0]]);
    let skew = through([[1.0, 0.5, 0.0], [0.2, 0.4, 0.1], [-0.8, 0.6, 0.0]]);
    for second in [&second, &skew] {
        for tangent in [Vec3::Z, Vec3::new(0.1, -0.2, 1.0)] {
            let rails = |second: EdgeCurve| Body::circular([from_ref(&first), &[second]], &[tangent], false);
            let Err(Error::Bridge(BridgeError::ArcsCross { piece: 0, at: [s, t] })) = rails(second.clone()) else {
                panic!("{tangent:?}")
            };
            // Inside, about where the curves are nearest to each other; there the arcs are short and run fast at their ends.
            assert!((0.3..0.7).contains(&s) && (0.1..0.9).contains(&t), "{s} {t}");
            assert!(rails(second.reversed()).is_ok());
        }
    }
    // Arcs that lean over each other without meeting.
    let twisted = through([[-1.0, 0.5, 0.0], [0.3, 0.4, 1.0], [1.0, 0.5, 2.0]]);
    assert!(Body::circular([&[first], &[twisted]], &[Vec3::Z, Vec3::new(1.0, 0.0, 1.0)], false).is_ok());
}

fn segment(from: [f64; 3], to: [f64; 3]) -> [EdgeCurve; 1] {
    [Arc::segment(from.into(), to.into()).unwrap().into()]
}

#[test]
fn arcs_that_fold_over_in_their_plane_are_refused() {
    // The arcs of a strip are one arc, moved along x: they cross where it runs back across y.
    for turned in [false, true] {
        let place = |x: f64, y: f64| if turned { [0.6 * x, y, 0.8 * x] } else { [x, y, 0.0] };
        let rails = [segment(place(0.0, 0.0), place(30.0, 0.0)), segment(place(0.0, 20.0), place(30.0, 20.0))];
        let strip = |x: f64, y: f64| Body::circular([&rails[0], &rails[1]], &[Vec3::from(place(x, y))], false);
        for (x, y) in [(0.0, 1.0), (1.0, 1.0), (1.0, 0.2), (1.0, 0.0), (-1.0, 0.0), (1.0, 1e-9)] {
            let area = strip(x, y).unwrap().outer.known_area().unwrap();
            assert!((area - 600.0).abs() < 1e-9, "{x} {y}: {area}");
        }
        for (x, y) in [(1.0, -1.0), (1.0, -0.2), (-1.0, -0.2), (1.0, -0.01), (0.1, -1.0)] {
            assert_eq!(strip(x, y).unwrap_err().reason(), "arcs-cross", "{x} {y}");
        }
    }
    // Both curves turn back on themselves at a joint, with it the surface.
    let there_and_back =
        |y: f64| [segment([0.0, y, 0.0], [9.0, y, 0.0]), segment([9.0, y, 0.0], [1.0, y, 0.0])].concat();
    let error = Body::circular([&there_and_back(0.0), &there_and_back(5.0)], &[Vec3::new(1.0, 3.0, 0.0)], false);
    assert!(matches!(error, Err(Error::Bridge(BridgeError::ArcsCross { piece: 1, at: [0.0, _] }))), "{error:?}");
    // Rails in the line of straight arcs: no surface at all.
    let line = [segment([0.0; 3], [1.0, 0.0, 0.0]), segment([5.0, 0.0, 0.0], [7.0, 0.0, 0.0])];
    assert_eq!(Body::circular([&line[0], &line[1]], &[Vec3::X], false).unwrap_err().reason(), "arcs-cross");
}

/// Rails in planes that hold all neighbors of the arc at 0, where both run along one direction: neighbors come through the cylinder
/// over it, and then through its plane.
#[test]
fn arcs_that_touch_their_neighbors_are_refused() {
    let rail = |y: f64, z: f64| cubic([[0.0, y, 0.0], [1.0, y, 0.0], [2.0, y, z], [3.0, y, 3.0 * z]]);
    let both = |tangent: Vec3| Body::circular([&[rail(0.0, 1.0)], &[rail(20.0, 1.0)]], &[tangent], false);
    assert!(both(Vec3::new(1.0, 1.0, 0.0)).is_ok());
    let Err(Error::Bridge(BridgeError::ArcsCross { at: [s, t], .. })) = both(Vec3::new(1.0, -1.0, 0.0)) else {
        panic!("folds at 0")
    };
    assert!(s < 0.05 && (0.05..0.5).contains(&t), "{s} {t}");
}

/// The arc at the end is most of a circle of radius .043, inside of which the surface folds: 3e-7 of its area.
#[test]
fn a_fold_at_a_tiny_arc_is_refused() {
    let first = segment([7.4967647188034965, 7.641847265299677, 0.0], [4.364105553578729, 8.88841963087286, 0.0]);
    let second = segment([0.0; 3], [4.286681055100368, 8.914430348602329, 0.0]);
    let tangents = [Vec3::new(9.346885943717318, -5.924099385808998, 0.0), Vec3::new(0.0, -6.623667447189068, 0.0)];
    let Err(Error::Bridge(BridgeError::ArcsCross { piece: 0, at: [s, _] })) =
        Body::circular([&first, &second], &tangents, false)
    else {
        panic!("folds at the end")
    };
    assert!(s > 0.99, "{s}");
}

fn circle(normal: Vec3) -> Circle {
    Circle::from_center(Point3::new(1.0, 2.0, 3.0), normal, Point3::new(21.0, 2.0, 3.0)).unwrap()
}

/// A closed polygon above the circle, its corners given from the middle of the circle.
fn polygon(corners: &[[f64; 2]]) -> Vec<EdgeCurve> {
    let at = |k: usize| {
        let [x, y] = corners[k % corners.len()];
        Point3::new(1.0 + x, 2.0 + y, 43.0)
    };
    (0..corners.len()).map(|k| Arc::segment(at(k), at(k + 1)).unwrap().into()).collect()
}

/// From round to oval each section is an ellipse, whose semi-axes are between those of both ends.
#[test]
fn a_circle_is_cut_as_the_ellipse_beside_it() {
    let oval = Ellipse::new(Point3::new(1.0, 2.0, 43.0), Vec3::Z, None, [25.0, 12.0]).unwrap();
    let oval: Vec<EdgeCurve> =
        oval.to_nurbs(0.0, 2.0 * PI).unwrap().to_beziers().into_iter().map(EdgeCurve::from).collect();
    let cut = RailSurface::cut_circle(&circle(Vec3::Z), &oval).unwrap();
    assert_eq!((cut.len(), cut[0].start()), (4, circle(Vec3::Z).start()));
    let duct = RailSurface::ruled([&cut, &oval], true).unwrap();
    assert!(duct.warnings().is_empty(), "{:?}", duct.warnings());
    for face in duct.body().outer.faces() {
        for k in 0..=8 {
            let p = face.surface.point(f64::from(k) / 8.0, 0.5);
            let on = ((p.x - 1.0) / 22.5).powi(2) + ((p.y - 2.0) / 16.0).powi(2);
            assert!((p.z - 23.0).abs() < 1e-13 && (on - 1.0).abs() < 1e-13, "{p:?}");
        }
    }
}

#[test]
fn a_circle_is_cut_where_the_corners_beside_it_are() {
    let corners = [[15.0, 10.0], [-15.0, 10.0], [-15.0, -10.0], [15.0, -10.0]];
    let moved = corners.map(|[x, y]| [x + 100.0, y - 30.0]);
    let clockwise = [corners[0], corners[3], corners[2], corners[1]];
    for (given, normal, sign) in
        [(corners, Vec3::Z, 1.0), (moved, Vec3::Z, 1.0), (clockwise, -Vec3::Z, 1.0), (clockwise, Vec3::Z, -1.0)]
    {
        let cut = RailSurface::cut_circle(&circle(normal), &polygon(&given)).unwrap();
        for (k, piece) in cut.iter().enumerate() {
            // Against the run of the polygon its corners come in reverse order, from the same first one.
            let [x, y] = if sign > 0.0 { given[k] } else { given[(4 - k) % 4] };
            let [x, y] = if given == moved { [x - 100.0, y + 30.0] } else { [x, y] };
            let expected = Vec3::new(x, y, 0.0) * (20.0 / x.hypot(y));
            let found = piece.start() - circle(normal).center();
            assert!((found - expected).length() < 1e-13, "{k}: {found:?} {expected:?}");
            let arc = piece.arc().unwrap();
            assert!((arc.radius().unwrap() / 20.0 - 1.0).abs() < 1e-14);
            assert!(arc.normal().unwrap().dot(normal) > 1.0 - 1e-14);
        }
        let turn: f64 = cut.iter().filter_map(EdgeCurve::arc).map(Arc::angle).sum();
        assert!((turn - 2.0 * PI).abs() < 1e-13);
    }
    // Across the axis no corner has a direction of its own: equal arcs from the start.
    let upright: Vec<EdgeCurve> = (0..4)
        .map(|k| {
            let at = |k: usize| {
                Point3::from([[30.0, 0.0, 0.0], [31.0, 0.0, 0.0], [31.0, 0.0, 1.0], [30.0, 0.0, 1.0]][k % 4])
            };
            Arc::segment(at(k), at(k + 1)).unwrap().into()
        })
        .collect();
    let cut = RailSurface::cut_circle(&circle(Vec3::Z), &upright).unwrap();
    assert_eq!(cut[0].start(), circle(Vec3::Z).start());
    assert!(cut.iter().all(|piece| (piece.arc().unwrap().angle() - 0.5 * PI).abs() < 1e-14));
    let one = RailSurface::cut_circle(&circle(Vec3::Z), &upright[..1]);
    assert_eq!(one.unwrap_err().reason(), "too-few-points");
}

/// Twice the area between an arc with this start tangent and its chord, positive left of it.
fn segment_area(chord: [f64; 2], tangent: [f64; 2]) -> f64 {
    let [dot, cross] = [chord[0] * tangent[0] + chord[1] * tangent[1], tangent[0] * chord[1] - tangent[1] * chord[0]];
    let half = cross.abs().atan2(dot);
    if half < 1e-9 {
        return 0.0;
    }
    let sector = (half - half.sin() * half.cos()) / half.sin().powi(2);
    // An arc that turns left leaves its chord to the right.
    cross.signum() * sector * 0.5 * (chord[0].powi(2) + chord[1].powi(2))
}

fn place() -> impl Strategy<Value = [f64; 2]> {
    prop::array::uniform2(-10.0..10.0_f64)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    /// In a plane a surface has the area inside its border, or is refused because its arcs run both ways.
    #[test]
    fn planar_surfaces_have_the_area_inside_their_border(
        ends in prop::array::uniform4(place()), tangents in prop::array::uniform2(place()),
        bulges in prop::array::uniform2(-0.57..0.57_f64), one in any::<bool>(), arcs in any::<bool>()
    ) {
        let tangents = if one { [tangents[0]; 2] } else { tangents };
        let bulges = if arcs { bulges } else { [0.0; 2] };
        let at = |[x, y]: [f64; 2]| Point3::new(x, y, 0.0);
        let arc = |k: usize| Arc::from_bulge(at(ends[2 * k]), at(ends[2 * k + 1]), Vec3::Z, bulges[k]);
        let (Ok(first), Ok(second)) = (arc(0), arc(1)) else { return Ok(()) };
        let chord = |k: usize| [ends[2 + k][0] - ends[k][0], ends[2 + k][1] - ends[k][1]];
        let vector = |[x, y]: [f64; 2]| Vec3::new(x, y, 0.0);
        // The border: the first rail, the arc at its end, the second rail and the arc at the start backwards.
        let way = |k: usize| [ends[2 * k + 1][0] - ends[2 * k][0], ends[2 * k + 1][1] - ends[2 * k][1]];
        let bulged = |k: usize, arc: &Arc| segment_area(way(k), [arc.start_derivative().x, arc.start_derivative().y]);
        let corners = [ends[0], ends[1], ends[3], ends[2]];
        let polygon: f64 = (0..4).map(|k| {
            let (p, q) = (corners[k], corners[(k + 1) % 4]);
            p[0] * q[1] - p[1] * q[0]
        }).sum();
        let border = polygon + bulged(0, &first) - bulged(1, &second) + segment_area(chord(1), tangents[1]) - segment_area(chord(0), tangents[0]);
        let rails = [EdgeCurve::from(first), second.into()];
        let tangents = tangents.map(vector);
        match Body::circular([&rails[..1], &rails[1..]], &tangents[..if one { 1 } else { 2 }], false) {
            Ok(body) => {
                let area = body.outer.known_area().unwrap();
                // Quadrature next to arcs of fifty chords' radius.
                prop_assert!((area - 0.5 * border.abs()).abs() <= 1e-7 * area, "{area} {}", 0.5 * border);
            }
            Err(Error::Bridge(BridgeError::ArcsCross { .. })) => {
                let [one, other] = [first, second].map(|rail| rail.evened().to_rational());
                let surface = cyclide::rational::RationalBezierSurface::circular(&one, &other, tangents).unwrap();
                // Somewhere on a grid that is finer near the ends.
                let grid = || (0..=200).map(|k| 0.5 - 0.5 * (PI * f64::from(k) / 200.0).cos());
                let sides = grid().flat_map(|s| grid().map(move |t| (s, t))).map(|(s, t)| {
                    let jet = surface.jet(s, t);
                    jet.ds.cross(jet.dt).z
                });
                let (least, most) = sides.fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
                prop_assert!(least < 0.0 && most > 0.0, "{least} {most}");
            }
            Err(_) => {}
        }
    }
}

/// A cubic through the plane of its points.
fn cubic(points: [[f64; 3]; 4]) -> EdgeCurve {
    RationalBezier::new(points.map(|[x, y, z]| [x, y, z, 1.0]).to_vec()).unwrap().into()
}

/// Two pieces of a line, the second so many times as fast.
fn straight(y: f64, faster: f64) -> [EdgeCurve; 2] {
    let line = |from: f64, to: f64| {
        let at = |k: f64| [from + (to - from) * k, y, 0.1 * y * (from + (to - from) * k)];
        cubic([at(0.0), at(1.0 / 3.0), at(2.0 / 3.0), at(1.0)])
    };
    [line(0.0, 1.0), line(1.0, 1.0 + faster)]
}

#[test]
fn kinks_at_smooth_joints_are_said() {
    for (first, second) in [(1.0, 1.0), (3.0, 3.0), (1.0, 1.5), (4.0, 1.0)] {
        let rails = [straight(0.0, first), straight(1.0, second)];
        let [a, b] = &rails;
        let ruled = RailSurface::ruled([a, b], false).unwrap();
        let circular = RailSurface::circular([a, b], &[Vec3::Z], false).unwrap();
        for made in [ruled, circular] {
            let angle = surface_joints(&made.body().outer).iter().map(|joint| joint.angle).fold(0.0, f64::max);
            match *made.warnings() {
                [] => assert!(first == second && angle < 1e-12, "{first} {second}: {angle}"),
                [Warning::Body(BodyWarning::KinksAtJoints { count: 1, joint: 1, angle: said, limit })] => {
                    assert!(said == angle && angle > limit && first != second)
                }
                ref other => panic!("{other:?}"),
            }
        }
    }
    // At a corner of a curve the surface has one too.
    let [a, _] = straight(0.0, 1.0);
    let turned = cubic([[1.0, 0.0, 0.0], [1.3, 0.1, 0.0], [1.6, 0.2, 0.0], [2.0, 0.3, 0.0]]);
    let made = RailSurface::ruled([&[a, turned], &straight(1.0, 3.0)], false).unwrap();
    assert!(made.warnings().is_empty() && made.body().outer.faces().len() == 2);
}

/// The bridge is a hundred thousand times as wide along y as along x.
#[test]
fn bridges_of_very_uneven_width_have_their_volume() {
    for gap in [1e-3, 1e-5, 1e-8] {
        let bridge = EllipseBridge::new([1.0, 1.0], [1.0 + gap, 2.0]).unwrap();
        let body = bridge.body(Some(1.0)).unwrap();
        assert!(body.is_solid() && body.outer.faces().len() < 600, "{gap}: {}", body.outer.faces().len());
        for face in body.outer.faces() {
            let FaceSurface::Rational(surface) = &face.surface else { continue };
            let weights = || surface.rows().iter().map(|row| row[3]);
            let (least, most) = (weights().fold(f64::MAX, f64::min), weights().fold(0.0, f64::max));
            assert!(most / least < 1e3, "{gap}: {least} {most}");
        }
        let base = PI * ((1.0 + gap) * 2.0 - 1.0);
        // Half circles over chords: the integral over the turn of π/8 c² times their middle's way across them.
        let n = 4000;
        let half_circles: f64 = (0..n)
            .map(|k| {
                let (sin, cos) = (2.0 * PI * (f64::from(k) + 0.5) / f64::from(n)).sin_cos();
                let chord = [gap * cos, sin];
                let way = [-(1.0 + 0.5 * gap) * sin, 1.5 * cos];
                PI / 8.0 * chord[0].hypot(chord[1]) * (chord[0] * way[1] - chord[1] * way[0])
            })
            .sum::<f64>()
            * 2.0
            * PI
            / f64::from(n);
        let volume = body.outer.known_volume().unwrap();
        // The sum has the digits of its step where the chord has a bend, at its shortest.
        assert!((volume / (base + half_circles) - 1.0).abs() < 1e-6, "{gap}: {volume} {base} {half_circles}");
    }
}

#[test]
fn bridges_that_cross_are_said() {
    let warnings = |first, second| EllipseBridge::new(first, second).unwrap().warnings();
    assert_eq!(
        warnings([2.0, 1.0], [1.0, 2.0]),
        [Warning::Body(BodyWarning::EllipsesCross { along_x: -1.0, along_y: 1.0 })]
    );
    assert_eq!(warnings([1.0, 2.0], [3.0, 2.5]), []);
    assert!(EllipseBridge::new([2.0, 1.0], [1.0, 2.0]).unwrap().body(None).is_ok());
    assert!(EllipseBridge::new([2.0, 1.0], [1.0, 2.0]).unwrap().body(Some(1.0)).is_err());
}
