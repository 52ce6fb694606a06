//! End faces of parts of turns: they cover the area between any contours once, exact along these.

use super::{chain, p, segment, whole};
use cyclide::{
    Point3, Vec3,
    construct::Revolution,
    curve::{Arc, ArcPath, ParamCurve as _},
    model::{CurveObject, SurfaceObject},
    rational::RationalBezier,
    surface::ParamSurface as _,
    topology::{Body, EdgeCurve, Shell, surface_joints},
};
use std::f64::consts::{FRAC_PI_2, TAU};

type Contours = Vec<(Vec<EdgeCurve>, bool)>;

fn circle(x: f64, z: f64, radius: f64) -> (Vec<EdgeCurve>, bool) {
    let half = |from, to| Arc::from_bulge(from, to, Vec3::Y, 1.0).unwrap().into();
    let [left, right] = [p(x - radius, z), p(x + radius, z)];
    (vec![half(left, right), half(right, left)], true)
}

fn arc(from: [f64; 2], through: [f64; 2], to: [f64; 2]) -> EdgeCurve {
    let [from, through, to] = [from, through, to].map(|[x, z]| p(x, z));
    Arc::from_three_points(from, through, to).unwrap().into()
}

fn cubic(rows: [[f64; 2]; 4]) -> EdgeCurve {
    RationalBezier::new(rows.map(|[x, z]| [x, 0.0, z, 1.0]).to_vec()).unwrap().into()
}

/// A ring of a part of a turn about (10, 0), from an angle over another, between two radii.
fn sector(radii: [f64; 2], angle: f64) -> (Vec<EdgeCurve>, bool) {
    let at = |r: f64, part: f64| [10.0 + r * (part * angle).cos(), r * (part * angle).sin()];
    let [inner, outer] = radii;
    let line = |from: [f64; 2], to: [f64; 2]| segment(p(from[0], from[1]), p(to[0], to[1]));
    let curves = vec![
        line(at(inner, 0.0), at(outer, 0.0)),
        arc(at(outer, 0.0), at(outer, 0.5), at(outer, 1.0)),
        line(at(outer, 1.0), at(inner, 1.0)),
        arc(at(inner, 1.0), at(inner, 0.5), at(inner, 0.0)),
    ];
    (curves, true)
}

fn backwards((curves, closed): (Vec<EdgeCurve>, bool)) -> (Vec<EdgeCurve>, bool) {
    (curves.iter().rev().map(EdgeCurve::reversed).collect(), closed)
}

/// Contours that no point sees whole, with how many solids they bound.
fn contours() -> Vec<(&'static str, Contours, usize)> {
    let polygon = |points: &[[f64; 2]]| (chain(points, true), true);
    let bent =
        polygon(&[[1.0, 0.0], [5.0, 0.0], [5.0, 5.0], [4.9, 5.0], [4.9, 0.1], [1.1, 0.1], [1.1, 5.0], [1.0, 5.0]]);
    let comb: Vec<[f64; 2]> = (0..12)
        .map(|k| [f64::from(k) + 1.0, if k % 2 == 0 { 9.0 } else { 0.2 }])
        .chain([[12.0, 0.0], [1.0, 0.0]])
        .collect();
    let square = |x: f64, size: f64| polygon(&[[x, -size], [x + 2.0 * size, -size], [x + 2.0 * size, size], [x, size]]);
    // Horns that end in points without an angle: two arcs that touch there.
    let crescent = vec![
        arc([10.0, 3.0], [13.0, 0.0], [10.0, -3.0]),
        arc([10.0, -3.0], [12.0, -1.0], [12.5, 0.0]),
        arc([12.5, 0.0], [12.0, 1.0], [10.0, 3.0]),
    ];
    let touching = |bulge: f64| {
        let outer = Arc::from_bulge(p(10.0, -3.0), p(10.0, 3.0), Vec3::Y, -1.0).unwrap();
        let inner = Arc::from_bulge(p(10.0, 3.0), p(10.0, 1.0), Vec3::Y, bulge).unwrap();
        (vec![outer.into(), inner.into(), segment(p(10.0, 1.0), p(10.0, -3.0))], true)
    };
    let wave = vec![
        cubic([[3.0, 0.0], [5.0, 3.0], [7.0, -3.0], [9.0, 0.0]]),
        segment(p(9.0, 0.0), p(9.0, 0.3)),
        cubic([[9.0, 0.3], [7.0, -2.7], [5.0, 3.3], [3.0, 0.3]]),
        segment(p(3.0, 0.3), p(3.0, 0.0)),
    ];
    let shell = |radius: f64| (vec![arc([0.0, -radius], [radius, 0.0], [0.0, radius])], false);
    vec![
        ("bent", vec![bent.clone()], 1),
        ("backwards", vec![backwards(bent)], 1),
        ("comb", vec![polygon(&comb)], 1),
        (
            "split sides",
            vec![polygon(&[
                [1.0, 0.0],
                [2.0, 0.0],
                [3.0, 0.0],
                [3.0, 1.0],
                [2.0, 1.0],
                [2.0, 3.0],
                [1.0, 3.0],
                [1.0, 1.0],
            ])],
            1,
        ),
        ("ring sector", vec![sector([4.0, 5.0], 2.0)], 1),
        ("thin ring sector", vec![sector([4.999, 5.0], 6.0)], 1),
        ("nearly closed ring", vec![sector([2.0, 5.0], 6.2)], 1),
        ("crescent", vec![(crescent, true)], 1),
        ("horn", vec![touching(1.0)], 1),
        ("inner horn", vec![touching(-1.0)], 1),
        ("wave", vec![(wave, true)], 1),
        ("tube", vec![circle(10.0, 0.0, 3.0), circle(10.0, 0.0, 2.7)], 1),
        ("thin tube", vec![circle(10.0, 0.0, 3.0), circle(10.0, 0.0, 2.997)], 1),
        ("eccentric", vec![circle(10.9, 0.0, 2.0), circle(10.0, 0.0, 3.0)], 1),
        ("both ways", vec![circle(10.0, 0.0, 3.0), backwards(circle(10.0, 0.0, 1.0))], 1),
        ("box", vec![square(8.0, 4.0), square(9.0, 3.0)], 1),
        (
            "holes",
            vec![
                square(8.0, 4.0),
                circle(10.0, 2.0, 0.9),
                circle(14.0, 2.0, 0.9),
                circle(12.0, -1.5, 2.0),
                square(9.0, 0.4),
            ],
            1,
        ),
        ("next to the wall", vec![circle(10.0, 0.0, 4.0), circle(13.5, 0.0, 0.49)], 1),
        (
            "islands",
            vec![circle(10.0, 0.0, 4.0), circle(10.0, 0.0, 3.0), circle(10.0, 0.5, 2.0), circle(30.0, 0.0, 2.0)],
            3,
        ),
        ("shell", vec![shell(3.0), shell(2.0)], 1),
        ("core", vec![shell(3.0), shell(2.0), shell(1.0)], 2),
        ("shell with a hole", vec![shell(3.0), shell(1.0), circle(2.0, 0.0, 0.5)], 1),
        ("tip on the axis", vec![(chain(&[[0.0, 0.0], [4.0, -1.0], [1.0, 0.0], [4.0, 1.0]], true), true)], 1),
    ]
}

fn volume(body: &Body) -> f64 {
    body.shells().map(|shell| shell.known_volume().unwrap()).sum()
}

/// Looks at the faces in the planes where a turn starts and ends: outside ahead, without a place where they fold.
fn check_ends(shell: &Shell, angle: f64, name: &str) -> usize {
    let normals = [0.0, angle].map(|at| Vec3::new(-f64::sin(at), f64::cos(at), 0.0));
    let end_of = |p: Point3| normals.iter().position(|n| p.to_vec().dot(*n).abs() < 1e-12 * p.to_vec().length());
    let mut found = 0;
    for face in shell.faces() {
        let places = [(0.3, 0.4), (0.7, 0.2), (0.5, 0.9)].map(|(s, t)| face.surface.point(s, t));
        let Some(end) = end_of(places[0]).filter(|end| places.iter().all(|p| end_of(*p) == Some(*end))) else {
            continue;
        };
        let ahead = normals[end] * if end == 0 { -angle.signum() } else { angle.signum() };
        let out = if face.same_sense { 1.0 } else { -1.0 };
        for k in 0..81 {
            let jet = face.surface.jet(f64::from(k % 9) * 0.123 + 0.008, f64::from(k / 9) * 0.123 + 0.008);
            let normal = jet.ds.cross(jet.dt).unit().unwrap() * out;
            // Rounding of coordinates of 10 over a chord of 0.01.
            assert!((normal - ahead).length() < 1e-11, "{name} {angle}: {normal:?}, not {ahead:?}");
        }
        found += 1;
    }
    found
}

/// The area that a profile goes round, by Green's theorem, Simpson's rule in 2,000 steps per piece.
fn area((curves, _): &(Vec<EdgeCurve>, bool)) -> f64 {
    let over = |curve: &EdgeCurve| -> f64 {
        let n = 2000;
        let term = |k: i32| {
            let jet = curve.piece_jet(0, f64::from(k) / f64::from(n));
            jet.point.x
                * jet.d1.z
                * if k == 0 || k == n {
                    1.0
                } else if k % 2 == 1 {
                    4.0
                } else {
                    2.0
                }
        };
        (0..=n).map(term).sum::<f64>() / f64::from(3 * n)
    };
    curves.iter().map(over).sum::<f64>().abs()
}

/// Whether a contour is around another one, by their extent.
fn is_around(outer: &(Vec<EdgeCurve>, bool), inner: &(Vec<EdgeCurve>, bool)) -> bool {
    let extent = |(curves, _): &(Vec<EdgeCurve>, bool)| {
        let places = curves.iter().flat_map(|curve| (0..=64).map(|k| curve.point(f64::from(k) / 64.0)));
        // Below, above, left and right; both may be on the axis.
        places.fold([f64::NEG_INFINITY; 4], |[low, high, left, right], p| {
            [low.max(-p.z), high.max(p.z), left.max(-p.x), right.max(p.x)]
        })
    };
    let [a, b] = [extent(outer), extent(inner)];
    a.iter().zip(b).all(|(a, b)| *a >= b) && a[0] > b[0]
}

#[test]
fn every_simple_contour_has_end_faces() {
    for (name, contours, solids) in contours() {
        let around_axis = whole().bodies(&contours).unwrap();
        let whole_volume: f64 = around_axis.iter().map(volume).sum();
        let whole_area: f64 = around_axis.iter().flat_map(Body::shells).map(|shell| shell.known_area().unwrap()).sum();
        for angle in [0.3, -2.0, 6.2] {
            let turn = Revolution::new(Point3::ORIGIN, Vec3::Z, angle).unwrap();
            let bodies = turn.bodies(&contours).unwrap();
            assert_eq!(bodies.len(), solids, "{name} {angle}");
            assert!(bodies.iter().all(|body| body.is_solid() && body.voids.is_empty()), "{name} {angle}");
            let found: f64 = bodies.iter().map(volume).sum();
            // Rounding of the two volumes, of which a wall is the difference.
            assert!((found / whole_volume * TAU / angle.abs() - 1.0).abs() < 1e-9, "{name} {angle}: {found}");
            assert_eq!(turn.warnings(&contours).unwrap(), [], "{name}");
            let faces: usize = bodies.iter().map(|body| check_ends(&body.outer, angle, name)).sum();
            assert!(faces > 0);
            let around = |k: usize| contours.iter().filter(|other| is_around(other, &contours[k])).count();
            let of_ends: f64 =
                (0..contours.len()).map(|k| area(&contours[k]) * if around(k) % 2 == 0 { 2.0 } else { -2.0 }).sum();
            let all: f64 = bodies.iter().map(|body| body.outer.known_area().unwrap()).sum();
            let walls = whole_area * angle.abs() / TAU;
            assert!(
                ((all - walls) / of_ends - 1.0).abs() < 1e-9 * (all / of_ends),
                "{name} {angle}: {} {of_ends}",
                all - walls
            );
        }
    }
}

#[test]
fn normals_of_end_faces_stand_across_also_at_corners_that_run_on_straight() {
    // The corners of the end faces of a rounded profile: two sides of one face run on into each other.
    let corners =
        [[20.0, 0.0], [60.0, 0.0], [60.0, 50.0], [50.0, 50.0], [50.0, 10.0], [30.0, 10.0], [30.0, 40.0], [20.0, 40.0]];
    let profile = ArcPath::rounded_polyline(&corners.map(|[x, z]| Point3::new(x, 0.0, z)), true, &[2.0; 8]).unwrap();
    let turn = Revolution::new(Point3::ORIGIN, Vec3::Z, 250_f64.to_radians()).unwrap();
    let part = SurfaceObject::revolved(&[CurveObject::ArcPath(profile)], &turn).unwrap();
    let joints = surface_joints(&part[0].to_bodies().unwrap()[0].outer);
    let rims: Vec<f64> = joints.iter().map(|joint| joint.angle).filter(|angle| *angle > 1e-6).collect();
    // Rounding of 60 over the flattest side of a face.
    assert!(rims.len() == 32 && rims.iter().all(|angle| (angle - FRAC_PI_2).abs() < 1e-9), "{rims:?}");
}
