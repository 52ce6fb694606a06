//! Sections along paths, ellipses and helices: exact where they are called so, solids with the volume of Pappus, and within their bound elsewhere.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use cyclide::{
    Point3, Vec3,
    construct::{Ellipse, Helix, Sweep, SweepFrame, SweepOptions},
    curve::{Arc, ArcPath, Circle, ParamCurve as _, length},
    model::{CurveObject, Lower as _},
    topology::{Body, EdgeCurve, surface_joints},
};
use cyclide_testkit::attack::Random;
use std::f64::consts::{PI, TAU};

type Contour = (Vec<EdgeCurve>, bool);

fn polygon(corners: &[[f64; 2]], closed: bool) -> Contour {
    let n = corners.len();
    let point = |k: usize| Point3::new(corners[k % n][0], corners[k % n][1], 0.0);
    let sides = (0..if closed { n } else { n - 1 }).map(|k| Arc::segment(point(k), point(k + 1)).unwrap().into());
    (sides.collect(), closed)
}

fn bar() -> Contour {
    polygon(&[[-2.0, -3.0], [2.0, -3.0], [2.0, 3.0], [-2.0, 3.0]], true)
}

fn path(points: &[[f64; 3]], radius: f64, closed: bool) -> ArcPath {
    let points: Vec<Point3> = points.iter().copied().map(Point3::from).collect();
    let mut radii = vec![radius; points.len()];
    if !closed {
        (radii[0], radii[points.len() - 1]) = (0.0, 0.0);
    }
    ArcPath::rounded_polyline(&points, closed, &radii).unwrap()
}

fn solid(section: &[Contour], path: &ArcPath, options: &SweepOptions) -> Body {
    let mut bodies = Sweep::new(section, path, options).unwrap().into_bodies();
    assert_eq!(bodies.len(), 1);
    let body = bodies.remove(0);
    assert!(body.is_solid());
    for shell in body.shells() {
        assert!(surface_joints(shell).iter().all(|joint| joint.gap < 1e-9));
    }
    body
}

fn volume(body: &Body) -> f64 {
    body.outer.volume() + body.voids.iter().map(|void| void.volume()).sum::<f64>()
}

#[test]
fn straight_rounded_and_mitred_bars_have_area_times_length() {
    let options = SweepOptions::default();
    for (points, radius) in [
        (&[[0.0, 0.0, 0.0], [0.0, 0.0, 100.0]][..], 0.0),
        (&[[0.0, 0.0, 0.0], [50.0, 0.0, 0.0], [50.0, 40.0, 0.0], [50.0, 40.0, 60.0]], 0.0),
        (&[[0.0, 0.0, 0.0], [50.0, 0.0, 0.0], [50.0, 40.0, 0.0], [50.0, 40.0, 60.0]], 15.0),
    ] {
        let path = path(points, radius, false);
        // The middle of the section is on the path.
        let body = solid(&[bar()], &path, &options);
        assert!((volume(&body) / (24.0 * path.length()) - 1.0).abs() < 1e-12);
        // Both caps are plane, across the path, and as large as the section.
        let first = path.arcs()[0];
        let start = first.start_tangent().unwrap();
        let on_cap = body.outer.vertices().iter().filter(|p| (**p - first.start()).dot(start).abs() < 1e-9).count();
        assert!(on_cap >= 4);
        let twisted = solid(&[bar()], &path, &SweepOptions { twist: 1.0, ..options });
        assert!((volume(&twisted) / (24.0 * path.length()) - 1.0).abs() < 1e-9, "Cavalieri");
    }
}

/// A section off the path: its middle runs on a path of its own, and the volume is by Pappus area times the length of that.
#[test]
fn a_hundred_random_sweeps_have_the_volume_of_pappus() {
    let mut random = Random::new(38, 0);
    let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
    for case in 0..100 {
        let triangle = [[0.0, 0.0], [number(1.0, 5.0), number(-1.0, 1.0)], [number(-1.0, 1.0), number(1.0, 5.0)]];
        let [a, b, c] = triangle;
        let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
        let middle = [0, 1].map(|d: usize| (a[d] + b[d] + c[d]) / 3.0);
        let section = polygon(&triangle, true);
        // In the plane z = 0 with y up: a bend to the left by an angle makes the way of the middle shorter by x times it... to its right side longer.
        let (turn, radius) = (number(-2.0, 2.0), number(12.0, 30.0));
        let far = number(60.0, 90.0);
        let points = [[0.0, 0.0, 0.0], [far, 0.0, 0.0], [far + far * turn.cos(), far * turn.sin(), 0.0]];
        for rounded in [false, true] {
            let path = path(&points, if rounded { radius } else { 0.0 }, false);
            for frame in [SweepFrame::RotationMinimizing, SweepFrame::Up] {
                let options = SweepOptions { frame, ..SweepOptions::default() };
                let sweep = Sweep::new(std::slice::from_ref(&section), &path, &options).unwrap();
                assert!(sweep.bound() <= 0.0, "plane paths do not turn the section");
                let body = &sweep.bodies()[0];
                // x of the section is to the right of the path: up across along.
                let x_is_left = Vec3::Z.cross(Vec3::X).dot(Vec3::Y) > 0.0;
                let inwards = if x_is_left { middle[0] } else { -middle[0] };
                let way = if rounded {
                    path.length() - turn * inwards
                } else {
                    path.length() - 2.0 * (0.5 * turn).tan() * inwards
                };
                assert!(
                    body.is_solid() && (volume(body) / (area * way) - 1.0).abs() < 1e-11,
                    "{case} {}",
                    volume(body) / area - way
                );
            }
        }
    }
}

#[test]
fn holes_closed_paths_and_open_sections() {
    let options = SweepOptions::default();
    let square = |h: f64| polygon(&[[-h, -h], [h, -h], [h, h], [-h, h]], true);
    // The hole is drawn the same way round as the border.
    let tube = [square(4.0), square(2.0)];
    let bend = path(&[[0.0, 0.0, 0.0], [50.0, 0.0, 0.0], [50.0, 40.0, 30.0]], 15.0, false);
    assert!((volume(&solid(&tube, &bend, &options)) / (48.0 * bend.length()) - 1.0).abs() < 1e-12);
    for (z, radius) in [(0.0, 0.0), (0.0, 10.0), (25.0, 0.0), (25.0, 10.0)] {
        let ring = path(&[[0.0, 0.0, 0.0], [60.0, 0.0, z], [60.0, 40.0, 0.0], [0.0, 40.0, z]], radius, true);
        let body = solid(&tube, &ring, &options);
        assert_eq!(body.voids.len(), 1);
        assert!((volume(&body) / (48.0 * ring.length()) - 1.0).abs() < 1e-6, "{z} {radius}");
    }
    let line = path(&[[0.0, 0.0, 0.0], [0.0, 0.0, 10.0]], 0.0, false);
    let sheet = Sweep::new(&[polygon(&[[-3.0, 0.0], [3.0, 0.0]], false)], &line, &options).unwrap();
    assert!(!sheet.bodies()[0].is_solid() && (sheet.bodies()[0].outer.area() - 60.0).abs() < 1e-12);
    let open = Sweep::new(&[bar()], &line, &SweepOptions { capped: false, ..options }).unwrap();
    assert!(!open.bodies()[0].is_solid() && (open.bodies()[0].outer.area() - 200.0).abs() < 1e-11);
    let round = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 3.0).unwrap();
    let round = [CurveObject::from(round).exact_pieces().unwrap()];
    assert!((volume(&solid(&round, &bend, &options)) / (9.0 * PI * bend.length()) - 1.0).abs() < 1e-12);
}

/// Every section of a twisted bar is the section, turned in proportion to the length within the bound.
#[test]
fn a_twist_is_even_within_its_bound() {
    let line = path(&[[0.0, 0.0, 0.0], [0.0, 0.0, 100.0]], 0.0, false);
    let options = SweepOptions { twist: 3.0, tolerance: 1e-4, ..SweepOptions::default() };
    let sweep = Sweep::new(&[bar()], &line, &options).unwrap();
    assert!(sweep.bound() > 0.0 && sweep.bound() <= 1e-4);
    for p in sweep.bodies()[0].outer.vertices() {
        let (x, y) = (p.x, p.y);
        let angle = 3.0 * p.z / 100.0;
        let back = [x * angle.cos() + y * angle.sin(), y * angle.cos() - x * angle.sin()].map(f64::abs);
        let corner = (back[0] - 2.0).hypot(back[1] - 3.0);
        assert!(corner < 1e-9 || p.z <= 0.0 || p.z >= 100.0, "{p:?}");
    }
}

#[test]
fn what_cannot_be_swept_is_refused_and_what_meets_itself_is_known() {
    let bend = path(&[[0.0, 0.0, 0.0], [50.0, 0.0, 0.0], [50.0, 40.0, 0.0]], 5.0, false);
    let wide = polygon(&[[-20.0, -2.0], [20.0, -2.0], [20.0, 2.0], [-20.0, 2.0]], true);
    let refused = |section: &Contour, path: &ArcPath| {
        Sweep::new(std::slice::from_ref(section), path, &SweepOptions::default()).unwrap_err().reason()
    };
    assert_eq!(refused(&wide, &bend), "tube-folds");
    let hook = path(&[[0.0, 0.0, 0.0], [50.0, 0.0, 0.0], [50.0, 10.0, 0.0], [0.0, 10.0, 0.0]], 0.0, false);
    assert_eq!(refused(&wide, &hook), "mitre-does-not-fit");
    let cross = path(
        &[[0.0, 0.0, 0.0], [60.0, 0.0, 0.0], [60.0, 40.0, 0.0], [30.0, 40.0, 0.0], [30.0, -40.0, 0.0]],
        0.0,
        false,
    );
    let meeting = |path: &ArcPath| Sweep::new(&[bar()], path, &SweepOptions::default()).unwrap().meeting();
    let ([from, to], point) = meeting(&cross).unwrap();
    assert!((from - 30.0).abs() < 3.0 && (to - 170.0).abs() < 4.0 && point.distance(Point3::new(30.0, 0.0, 0.0)) < 4.0);
    assert_eq!(meeting(&hook), None);
    let coil = |pitch: f64| {
        let (curve, _) = Helix::new(Point3::ORIGIN, Vec3::Z, None, 20.0, pitch, 3.0).unwrap().to_nurbs(1e-6).unwrap();
        curve.lower_to_arcs(1e-3).unwrap().form
    };
    // Upright it is 6 high; else it turns about the coil, and is 7.2 across.
    let upright = |path: &ArcPath| {
        let options = SweepOptions { frame: SweepFrame::Up, ..SweepOptions::default() };
        Sweep::new(&[bar()], path, &options).unwrap().meeting()
    };
    assert!(upright(&coil(5.0)).is_some() && upright(&coil(6.5)).is_none());
}

/// At a mitre neither leg reaches beyond its plane, however sharp the corner is; a leg that comes back is met all the same.
#[test]
fn sharp_mitres_do_not_meet_themselves() {
    let square = polygon(&[[-5.0, -5.0], [5.0, -5.0], [5.0, 5.0], [-5.0, 5.0]], true);
    let tall = polygon(&[[-2.0, -9.0], [2.0, -9.0], [3.0, 9.0]], true);
    let meeting = |section: &Contour, path: &ArcPath| {
        Sweep::new(std::slice::from_ref(section), path, &SweepOptions::default()).unwrap().meeting()
    };
    for degrees in (10..=160).step_by(10) {
        let turn = f64::from(degrees).to_radians();
        for rise in [0.0, 30.0] {
            let end = [200.0 + 300.0 * turn.cos(), 300.0 * turn.sin(), rise];
            let corner = path(&[[0.0, 0.0, 0.0], [200.0, 0.0, 0.0], end], 0.0, false);
            for section in [&square, &tall] {
                assert_eq!(meeting(section, &corner), None, "{degrees} degrees, rise {rise}");
            }
        }
    }
    let back = path(&[[0.0, 0.0, 0.0], [200.0, 0.0, 0.0], [120.0, 60.0, 0.0], [120.0, -60.0, 0.0]], 0.0, false);
    assert!(meeting(&square, &back).is_some());
}

#[test]
fn ellipses_are_exact() {
    let mut random = Random::new(39, 0);
    let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
    for _ in 0..100 {
        let center = Point3::new(number(-50.0, 50.0), number(-50.0, 50.0), number(-5.0, 5.0));
        let normal = Vec3::new(number(-1.0, 1.0), number(-1.0, 1.0), number(0.2, 1.0));
        let [a, b] = [number(1.0, 50.0), number(1.0, 50.0)];
        let x = Vec3::new(number(0.1, 1.0), number(-1.0, 1.0), 0.0);
        let ellipse = Ellipse::new(center, normal, Some(x), [a, b]).unwrap();
        let (start, sweep) = (number(-7.0, 7.0), number(-TAU, TAU));
        let curve = ellipse.to_nurbs(start, sweep).unwrap();
        let z = normal.unit().unwrap();
        let u = (x - z * x.dot(z)).unit().unwrap();
        let v = z.cross(u);
        for k in 0..=40 {
            let way = curve.point(f64::from(k) / 40.0) - center;
            let (p, q) = (way.dot(u) / a, way.dot(v) / b);
            assert!((p * p + q * q - 1.0).abs() < 1e-12 && way.dot(z).abs() < 1e-12 * 50.0);
        }
        assert!(curve.point(0.0).distance(ellipse.point(start)) < 1e-12);
        assert!(curve.point(1.0).distance(ellipse.point(start + sweep)) < 1e-11);
        let whole = ellipse.to_nurbs(start, TAU).unwrap();
        assert!(whole.is_closed());
    }
    // Ramanujan's second formula is known to 1e-9 for such axes.
    let (a, b) = (5.0_f64, 3.0);
    let h = ((a - b) / (a + b)).powi(2);
    let ramanujan = PI * (a + b) * (1.0 + 3.0 * h / (10.0 + (4.0 - 3.0 * h).sqrt()));
    let whole = Ellipse::new(Point3::ORIGIN, Vec3::Z, None, [a, b]).unwrap().to_nurbs(0.0, TAU).unwrap();
    assert!((length(&whole) - ramanujan).abs() < 1e-5);
    let reason = |made: cyclide::Result<Ellipse>| made.unwrap_err().reason();
    assert_eq!(reason(Ellipse::new(Point3::ORIGIN, Vec3::Z, None, [1.0, 0.0])), "radius-not-positive");
    assert_eq!(reason(Ellipse::new(Point3::ORIGIN, Vec3::ZERO, None, [1.0, 2.0])), "zero-axis");
    assert_eq!(reason(Ellipse::new(Point3::ORIGIN, Vec3::Z, Some(Vec3::Z), [1.0, 2.0])), "zero-axis");
    let ellipse = Ellipse::new(Point3::ORIGIN, Vec3::X, None, [1.0, 2.0]).unwrap();
    assert_eq!(ellipse.to_nurbs(0.0, 7.0).unwrap_err().reason(), "angle-out-of-range");
}

/// On the cylinder exactly, at the height of its angle within the bound, with the length and the curvature of the formulas.
#[test]
fn helices_are_within_their_bound() {
    let mut random = Random::new(40, 0);
    let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
    for case in 0..100 {
        let (radius, pitch) = (number(1.0, 50.0), number(-30.0, 60.0));
        let turns = number(0.1, 8.0) * if case % 2 == 0 { 1.0 } else { -1.0 };
        let helix = Helix::new(Point3::ORIGIN, Vec3::Z, None, radius, pitch, turns).unwrap();
        let tolerance = radius * 10_f64.powf(-number(3.0, 9.0));
        let (curve, bound) = helix.to_nurbs(tolerance).unwrap();
        assert!(bound <= tolerance.max(1e-13 * radius));
        let mut before = 0.0;
        for k in 0..=400 {
            let p = curve.point(f64::from(k) / 400.0);
            assert!((p.x.hypot(p.y) - radius).abs() < 1e-12 * radius);
            // Its angle, counted on from that before.
            let angle = p.y.atan2(p.x) * turns.signum();
            let angle = angle + TAU * ((before - angle) / TAU).round();
            before = angle;
            let height = pitch * angle / TAU;
            assert!(
                (p.z - height).abs() <= bound + 1e-11 * (radius + pitch.abs() * turns.abs()),
                "{case}: {} {bound}",
                p.z - height
            );
        }
        assert!(curve.point(1.0).distance(helix.point(1.0)) < 1e-10 * (radius + helix.height().abs()));
        // Heights waver about those of the helix by the bound over each piece: their slopes count squared.
        let angle = TAU * turns.abs() / curve.piece_count() as f64;
        let slope = 16.0 * bound / (angle * radius);
        assert!((length(&curve) - helix.length()).abs() < (slope * slope + 1e-9) * helix.length());
        let jet = helix.derivative(0.3);
        assert!((jet.length() - helix.length()).abs() < 1e-9 * helix.length());
        assert_eq!(helix.torsion() > 0.0, (pitch > 0.0) == (turns > 0.0));
    }
    let helix = Helix::new(Point3::ORIGIN, Vec3::Z, None, 3.0, 4.0 * TAU, 1.0).unwrap();
    assert!((helix.curvature() - 0.12).abs() < 1e-15 && (helix.torsion() - 0.16).abs() < 1e-15);
}
