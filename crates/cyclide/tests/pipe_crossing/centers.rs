//! The ways of the centers of balls, and the surface that they run on.

use super::{ANGLES, CASES, END, askew, crossing, made, off_axes};
use cyclide::{
    Point2, Point3, Vec3,
    construct::{CrossingPipe, CrossingSide, MadeCrossing, PipeCrossing},
    rational::NurbsCurve,
    surface::{NaturalQuadric, QuadricPair, SkewCylinders},
};
use std::f64::consts::{FRAC_PI_2, PI};

/// The parameter of an angle between two others on an arc with the weights of a patch of centers.
fn parameter(angle: f64, [from, to]: [f64; 2]) -> f64 {
    let [a, b] = [angle - from, to - angle].map(|x| (0.5 * x).sin());
    a / (a + b)
}

/// The balls of places are on the patch at their parameters: perpendicular or not, cylinders touched from inside, cones.
#[test]
fn patches_have_the_centres_of_places() {
    let ([u0, u1], [v0, v1]) = ([0.2, 2.9], [0.05, 2.4]);
    let grid = || (0..=6).flat_map(|i| (0..=6).map(move |j| [f64::from(i), f64::from(j)].map(|k| k / 6.0)));
    let places = || grid().map(|[i, j]| [u0 + i * (u1 - u0), v0 + j * (v1 - v0)]);
    for radii in [[1.0, 1.5], [2.0, 2.0], [1.0, -0.4]] {
        for angle in [FRAC_PI_2, 0.5, 2.2] {
            let pair = SkewCylinders::new(radii, 1.2).and_then(|pair| pair.with_angle(angle)).expect("a pair");
            let patch = pair.center_surface([u0, u1], [v0, v1]).expect("between 0 and pi");
            assert!(patch.has_positive_weights());
            for [u, v] in places() {
                let ball = pair.ball(Point2::new(0.5 * (v - u), 0.5 * (v + u))).expect("inside the diamond");
                let found = patch.point(parameter(u, [u0, u1]), parameter(v, [v0, v1]));
                // Balls grow without end towards the border of the square.
                assert!(found.distance(ball.center) <= 1e-13 * (1.0 + ball.radius.abs()), "{radii:?} {angle} {u} {v}");
            }
        }
    }
    let pipe = NaturalQuadric::cone(Point3::new(-9.0, 0.0, 0.0), Vec3::X, 0.1).expect("a cone");
    let cone = NaturalQuadric::cone(Point3::new(0.0, -4.0, 3.0), Vec3::new(0.3, 1.0, 0.1), 0.2).expect("a cone");
    let pair = QuadricPair::new([pipe, cone]).expect("a pair");
    let patch = pair.center_surface([u0, u1], [v0, v1]).expect("between 0 and pi");
    for [u, v] in places() {
        let ball = pair.ball(Point2::new(0.5 * (v - u), 0.5 * (v + u))).expect("inside the diamond");
        let found = patch.point(parameter(u, [u0, u1]), parameter(v, [v0, v1]));
        assert!(found.distance(ball.center) <= 1e-12 * (1.0 + ball.radius.abs()), "{u} {v}");
    }
}

#[test]
fn angles_of_patches_rise_between_0_and_pi() {
    let pair = SkewCylinders::new([1.0, 1.5], 2.0).expect("a pair");
    let reason = |u: [f64; 2], v: [f64; 2]| pair.center_surface(u, v).expect_err("no patch").reason();
    for bad in [[0.0, 1.0], [1.0, PI], [1.0, 1.0], [2.0, 1.0], [-1.0, 1.0]] {
        assert_eq!(reason(bad, [0.5, 1.0]), "parameter-out-of-range", "{bad:?}");
        assert_eq!(reason([0.5, 1.0], bad), "parameter-out-of-range", "{bad:?}");
    }
    assert_eq!(reason([f64::NAN, 1.0], [0.5, 1.0]), "not-finite");
}

/// Closed, with one velocity on both sides of every knot and of the seam: as long as that, to rounding of the pieces.
fn check_smooth(path: &NurbsCurve) {
    let (count, breaks) = (path.span_count(), path.breaks());
    let velocity = |span: usize, s: f64| path.span_jet(span, s).d1 * (1.0 / (breaks[span + 1] - breaks[span]));
    for span in 0..count {
        let next = (span + 1) % count;
        let [before, after] = [velocity(span, 1.0), velocity(next, 0.0)];
        assert!((before - after).length() <= 1e-8 * before.length(), "at {span}: {before:?} {after:?}");
        assert!(path.span_point(span, 1.0).distance(path.span_point(next, 0.0)) <= 1e-12 * before.length());
    }
}

fn places(path: &NurbsCurve) -> impl Iterator<Item = Point3> + '_ {
    (0..path.span_count()).flat_map(move |span| (0..8).map(move |k| path.span_point(span, f64::from(k) / 8.0)))
}

fn check_centers(made: &MadeCrossing, radii: [f64; 2], distance: f64, degrees: f64, signs: [f64; 2]) {
    let [path] = made.centers.paths() else { panic!("one path") };
    check_smooth(path);
    for m in places(path) {
        let [a, b] = off_axes(m, distance, degrees);
        let [first, second] = [(a - radii[0]) * signs[0], (b - radii[1]) * signs[1]];
        assert!((first - second).abs() < 1e-12, "one ball: {first} {second}");
        assert!(made.blend.radii[0] - 1e-12 <= first && first <= made.blend.radii[1] + 1e-12);
    }
}

/// Centers are as far from both pipes as the ball's radius, on a C1 curve of degree 4 that lies on the surface of all centers.
#[test]
fn centres_run_on_their_surface() {
    for (case, (radii, distance, blend)) in CASES.into_iter().enumerate() {
        for degrees in [ANGLES[case % ANGLES.len()], ANGLES[0]] {
            let made = made(radii, distance, blend, degrees);
            check_centers(&made, radii, distance, degrees, [1.0; 2]);
            let path = &made.centers.paths()[0];
            assert_eq!(path.degree(), 4);
            let pair = SkewCylinders::new(radii, 0.5 * distance).and_then(|p| p.with_angle(degrees.to_radians()));
            let pair = pair.expect("a pair");
            // The angles of a center, by the directions from both axes.
            let angles = |m: Point3| {
                let (sin, cos) = degrees.to_radians().sin_cos();
                let first = Vec3::new(0.0, m.y, m.z).unit().expect("off the axis");
                let across = Vec3::new(sin, -cos, 0.0);
                let second = across * m.to_vec().dot(across) + Vec3::Z * (m.z - distance);
                let place = pair.place_of_normals([first, second.unit().expect("off the axis")]);
                [place.y - place.x, place.y + place.x]
            };
            for margin in [0.0, 0.25, 0.9] {
                let surface = made.centers.surface(margin).expect("a surface");
                assert!(surface.has_positive_weights() && surface.degrees() == [2, 2]);
                let [start, end] = [surface.point(0.0, 0.0), surface.point(1.0, 1.0)].map(angles);
                let (u, v) = ([start[0], end[0]], [start[1], end[1]]);
                for m in places(path) {
                    let [s, t] = [(angles(m)[0], u), (angles(m)[1], v)].map(|(x, ends)| parameter(x, ends));
                    // Without a margin as far as the places that were looked at.
                    let inside = -5e-3..=1.005;
                    assert!(inside.contains(&s) && inside.contains(&t), "{s} {t} at {margin}");
                    // The corners of a wide margin are far away, and so are their digits.
                    let far = surface.rows().iter().map(|row| (row[0] / row[3]).abs()).fold(distance, f64::max);
                    let gap = surface.point(s, t).distance(m);
                    assert!(gap <= 1e-12 * far, "{gap} beside {far}");
                }
            }
        }
    }
}

#[test]
fn centres_inside_and_mixed() {
    let inside = askew([2.0, 2.0], 3.0, 0.2, 80.0).with_side(CrossingSide::Inside).made().expect("a lens");
    check_centers(&inside, [2.0, 2.0], 3.0, 80.0, [-1.0; 2]);
    assert!(inside.centers.surface(0.5).is_ok());
    let mixed = askew([2.0, 2.5], 3.0, 0.2, 80.0).with_side(CrossingSide::Mixed).made().expect("a notch");
    check_centers(&mixed, [2.0, 2.5], 3.0, 80.0, [1.0, -1.0]);
    assert_eq!(mixed.centers.surface(0.5).expect_err("none").reason(), "no-center-surface");
    let outside = crossing([2.0, 2.0], 3.0, 0.5).and_then(|c| c.made()).expect("a crossing");
    for margin in [-0.1, 1.0, f64::NAN] {
        assert_eq!(outside.centers.surface(margin).expect_err("none").reason(), "parameter-out-of-range");
    }
}

/// Pipes that are cones: the surface passes through the path, of which every point is one of a ball on it.
#[test]
fn centres_between_cones() {
    let pipe = |radius: f64, taper: f64| CrossingPipe { radius, taper, ends: [-END, END] };
    let made = PipeCrossing::new([pipe(2.0, 0.06), pipe(1.8, -0.04)], 3.0, 0.5).and_then(|c| c.made()).expect("cones");
    let [path] = made.centers.paths() else { panic!("one path") };
    check_smooth(path);
    // From a cone about an axis, thinner along it by the tangent of the taper.
    let off = |from: f64, along: f64, radius: f64, taper: f64| {
        from * taper.cos() + (along * taper.tan() - radius) * taper.cos()
    };
    let balls = |m: Point3| [off(m.y.hypot(m.z), m.x, 2.0, 0.06), off(m.x.hypot(m.z - 3.0), m.y, 1.8, -0.04)];
    for m in places(path) {
        let [first, second] = balls(m);
        assert!((first - second).abs() < 1e-12 && (first - 0.5).abs() < 6e-4, "{first} {second}");
    }
    let surface = made.centers.surface(0.3).expect("a surface");
    for (s, t) in [(0.0, 0.0), (0.3, 0.9), (0.5, 0.5), (1.0, 0.2)] {
        let [first, second] = balls(surface.point(s, t));
        assert!((first - second).abs() < 1e-11, "{first} {second}");
    }
}
