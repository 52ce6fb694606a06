use super::*;

fn flat(points: &[[f64; 2]]) -> Vec<Point3> {
    points.iter().map(|p| Point3::new(p[0], p[1], 0.0)).collect()
}

fn polygon(n: usize, radius: f64) -> Vec<Point3> {
    let at = |i: usize| {
        let (s, c) = (2.0 * PI * i as f64 / n as f64).sin_cos();
        Point3::new(radius * c, radius * s, 0.0)
    };
    (0..n).map(at).collect()
}

fn read(points: &[Point3]) -> Outline {
    Outline::read(points, true, 0.02, None, &[], Scattered::Vertices)
}

#[test]
fn regular_polygons_are_outlines_below_twelve_points() {
    for n in 3..=60 {
        let outline = read(&polygon(n, 30.0));
        assert_eq!(outline.corners.len(), if n < 12 { n } else { 0 }, "{n}");
        assert!(!outline.straight.contains(&true));
    }
}

#[test]
fn a_slot_has_two_straight_sides_and_no_corner() {
    let end = |x: f64, from: f64| {
        (0..=25).map(move |i| {
            let (s, c) = (from + PI * f64::from(i) / 25.0).sin_cos();
            Point3::new(x + 4.0 * c, 4.0 * s, 0.0)
        })
    };
    let slot: Vec<_> = end(11.0, -0.5 * PI).chain(end(-11.0, 0.5 * PI)).collect();
    let outline = read(&slot);
    assert!(outline.corners.is_empty());
    let straight: Vec<_> = (0..slot.len()).filter(|i| outline.straight[*i]).collect();
    assert_eq!(straight, [25, 51]);
}

#[test]
fn chamfers_and_bevels_are_outlines() {
    // A rectangle of 60 x 40 with chamfers of 3.
    let chamfered =
        flat(&[[3.0, 0.0], [57.0, 0.0], [60.0, 3.0], [60.0, 37.0], [57.0, 40.0], [3.0, 40.0], [0.0, 37.0], [0.0, 3.0]]);
    assert_eq!(read(&chamfered).corners.len(), 8);
    // One long side is broken by 10 degrees: two straight sides.
    let broken = flat(&[[0.0, 0.0], [30.0, -2.6], [60.0, 0.0], [60.0, 40.0], [0.0, 40.0]]);
    let outline = read(&broken);
    assert_eq!(outline.corners.len(), 4);
    assert!(outline.straight[0] && outline.straight[1]);
}

#[test]
fn dense_samples_of_smooth_curves_are_curves() {
    // Ellipses, by equal angles of the parameter: steps of length and of curvature.
    for (a, n) in [(1.0, 60), (3.0, 60), (10.0, 60), (10.0, 200), (30.0, 400)] {
        let at = |i: usize| {
            let (s, c) = (2.0 * PI * i as f64 / n as f64).sin_cos();
            Point3::new(a * c, s, 0.0)
        };
        let points: Vec<_> = (0..n).map(at).collect();
        let outline = Outline::read(&points, true, 1e-3, None, &[], Scattered::Vertices);
        assert!(!outline.bound.contains(&true), "{a}, {n}");
    }
}

#[test]
fn uneven_samples_of_waves_are_curves_too() {
    // A fixed sequence in [-1/2, 1/2).
    let mut state = 7_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1_u64 << 31) as f64 - 0.5
    };
    for _ in 0..100 {
        let waves = [2.0, 3.0, 4.0, 5.0].map(|n| [n, 0.4 / n * random(), 2.0 * PI * random()]);
        let n = (150.0 + 100.0 * random()) as usize;
        let mut at = |i: usize| {
            let a = 2.0 * PI * (i as f64 + 0.6 * random()) / n as f64;
            let r = 50.0 * waves.iter().fold(1.0, |r, [n, depth, phase]| r + depth * (n * a + phase).cos());
            Point3::new(r * a.cos(), r * a.sin(), 0.0)
        };
        let points: Vec<_> = (0..n).map(&mut at).collect();
        for tolerance in [0.1, 0.01, 0.001] {
            let outline = Outline::read(&points, true, tolerance, None, &[], Scattered::Vertices);
            assert!(outline.corners.is_empty() && !outline.straight.contains(&true), "{n} points");
        }
    }
}

#[test]
fn an_angle_that_is_given_is_obeyed() {
    let points = polygon(24, 10.0);
    let corners = |angle: f64| Outline::read(&points, true, 0.02, Some(angle), &[], Scattered::Vertices).corners.len();
    assert_eq!((corners(0.2), corners(0.3)), (24, 0));
    assert_eq!(Outline::read(&polygon(4, 1.0), true, 0.01, Some(2.0), &[2], Scattered::Vertices).corners.len(), 1);
}
