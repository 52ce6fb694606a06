//! What is said and refused of surfaces between two curves: arcs that cross, kinks at smooth joints; bridges that nearly touch or cross.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]
#![allow(clippy::float_cmp, reason = "numbers handed through are the same")]

use cyclide::{
    Arc, Body, EdgeCurve, EllipseBridge, Error, FaceSurface, Point3, RailSurface, RationalBezier, Vec3, Warning,
    surface_joints,
};
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
            let Err(Error::ArcsCross { piece: 0, at: [s, t] }) = rails(second.clone()) else { panic!("{tangent:?}") };
            // Inside, about where the curves are nearest to each other; there the arcs are short and run fast at their ends.
            assert!((0.3..0.7).contains(&s) && (0.1..0.9).contains(&t), "{s} {t}");
            assert!(rails(second.reversed()).is_ok());
        }
    }
    // Arcs that lean over each other without meeting.
    let twisted = through([[-1.0, 0.5, 0.0], [0.3, 0.4, 1.0], [1.0, 0.5, 2.0]]);
    assert!(Body::circular([&[first], &[twisted]], &[Vec3::Z, Vec3::new(1.0, 0.0, 1.0)], false).is_ok());
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
                [Warning::KinksAtJoints { count: 1, joint: 1, angle: said, limit }] => {
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
    assert_eq!(warnings([2.0, 1.0], [1.0, 2.0]), [Warning::EllipsesCross { along_x: -1.0, along_y: 1.0 }]);
    assert_eq!(warnings([1.0, 2.0], [3.0, 2.5]), []);
    assert!(EllipseBridge::new([2.0, 1.0], [1.0, 2.0]).unwrap().body(None).is_ok());
    assert!(EllipseBridge::new([2.0, 1.0], [1.0, 2.0]).unwrap().body(Some(1.0)).is_err());
}
