//! Measures of shapes whose values are known.

use crate::curves::{point, stadium};
use cyclide::{
    Point3, Vec3,
    curve::{
        Arc, ArcPath, Circle, CircleSpline, CircleSplineOptions, CurveIndex, ParamCurve, bounds, curvature_comb,
        extreme_curvature, farthest_point, joints, length,
    },
    rational::NurbsCurve,
};

/// The parabola `(x, x²)` over `[-1, 2]` as one Bézier piece.
fn parabola() -> NurbsCurve {
    let points = vec![point(-1.0, 1.0, 0.0), point(0.5, -2.0, 0.0), point(2.0, 4.0, 0.0)];
    NurbsCurve::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], points, vec![1.0; 3]).unwrap()
}

#[test]
fn parabola_has_its_curvature_length_box_and_nearest_points() {
    let c = parabola();
    let e = extreme_curvature(&c);
    // k = 2/(1 + 4x²)^(3/2): 2 at the vertex, t = 1/3.
    assert!((e.max - 2.0).abs() < 1e-14 && (e.t - 1.0 / 3.0).abs() < 1e-9, "{e:?}");
    // x²' = 2x: F(x) = x sqrt(1+4x²)/2 + asinh(2x)/4
    let f = |x: f64| 0.5 * x * (1.0 + 4.0 * x * x).sqrt() + 0.25 * (2.0 * x).asinh();
    let want = f(2.0) - f(-1.0);
    assert!((length(&c) - want).abs() < 1e-13 * want);
    let b = bounds(&c);
    assert!(b.min.distance(point(-1.0, 0.0, 0.0)) < 1e-15 && b.max.distance(point(2.0, 4.0, 0.0)) < 1e-15, "{b:?}");
    // The nearest point to (0, 1/2) is the vertex; all of its neighbors are equally far to fourth order (evolute).
    let near = CurveIndex::new(&c).closest_point(point(0.0, 0.5, 0.0));
    assert!((near.distance - 0.5).abs() < 1e-15, "{near:?}");
    // From (0, 2) both (±sqrt(3/2), 3/2) are sqrt(7)/2 away, but x stops at -1: the right one is nearest.
    let near = CurveIndex::new(&c).closest_point(point(0.0, 2.0, 0.0));
    assert!(near.point.distance(point(1.5_f64.sqrt(), 1.5, 0.0)) < 1e-14, "{near:?}");
    // Left of the start the end is nearest.
    let near = CurveIndex::new(&c).closest_point(point(-3.0, 2.0, 0.0));
    assert_eq!((near.t, near.point), (0.0, point(-1.0, 1.0, 0.0)));
}

#[test]
fn curvature_has_the_sign_of_the_turn() {
    for (bulge, sign) in [(0.5, 1.0), (-0.5, -1.0)] {
        let arc = Arc::from_bulge(point(0.0, 0.0, 0.0), point(2.0, 0.0, 0.0), Vec3::Z, bulge).unwrap();
        // Radius (c/4)(b + 1/b) = 1.25.
        for i in 0..=8 {
            let k = arc.jet(f64::from(i) / 8.0).signed_curvature(Vec3::Z).unwrap();
            assert!((k - sign / 1.25).abs() < 1e-14, "{k}");
        }
    }
}

#[test]
fn helix_like_cubic_has_torsion_of_its_handedness() {
    // The twisted cubic (t, t², t³): torsion 3 at t = 0 (12/4), positive throughout: right-handed.
    let points =
        vec![point(0.0, 0.0, 0.0), point(1.0 / 3.0, 0.0, 0.0), point(2.0 / 3.0, 1.0 / 3.0, 0.0), point(1.0, 1.0, 1.0)];
    let c = NurbsCurve::new(3, [[0.0; 4], [1.0; 4]].concat(), points, vec![1.0; 4]).unwrap();
    assert!((c.jet(0.0).torsion().unwrap() - 3.0).abs() < 1e-14);
    assert!(c.jet(0.9).torsion().unwrap() > 0.0);
    assert!(c.reversed().jet(0.1).torsion().unwrap() > 0.0, "reversal keeps the hand");
}

#[test]
fn stadium_has_jumps_of_curvature_but_no_kinks() {
    let c = stadium(1.0);
    let list = joints(&c);
    assert_eq!(list.len(), 4);
    // Straights at the distance sqrt(2² + 1²), joined by half circles.
    let curvature = 2.0 / 5.0_f64.sqrt();
    for (i, joint) in list.iter().enumerate() {
        assert_eq!((joint.piece, joint.next), (i, (i + 1) % 4));
        assert!(joint.gap == 0.0 && joint.angle < 1e-15, "{joint:?}");
        assert!((joint.curvature_jump - curvature).abs() < 1e-15, "{joint:?}");
    }
    let e = extreme_curvature(&c);
    assert!((e.max - curvature).abs() < 1e-15 && e.t == 0.25, "{e:?}");
    let want = 8.0 + 5.0_f64.sqrt() * std::f64::consts::PI;
    assert!((length(&c) - want).abs() < 1e-14 * want);
}

#[test]
fn kinks_and_small_angles_are_measured() {
    // Two segments that turn by 1e-9: an arc cosine would see nothing.
    for turn in [1e-9, 0.3, std::f64::consts::FRAC_PI_2] {
        let end = point(1.0 + f64::cos(turn), f64::sin(turn), 0.0);
        let (a, b) = (point(0.0, 0.0, 0.0), point(1.0, 0.0, 0.0));
        let path = ArcPath::new(vec![Arc::segment(a, b).unwrap(), Arc::segment(b, end).unwrap()], false).unwrap();
        let [joint] = joints(&path)[..] else { panic!("one joint") };
        // Rounding of the second chord: 1e-16 of its length.
        assert!((joint.angle - turn).abs() < 1e-15 && joint.curvature_jump == 0.0, "{joint:?}");
    }
}

#[test]
fn joints_look_past_pieces_without_extent() {
    let (a, b, c) = (point(0.0, 0.0, 0.0), point(1.0, 0.0, 0.0), point(1.0, 2.0, 0.0));
    let arcs = vec![Arc::segment(a, b).unwrap(), Arc::segment(b, b).unwrap(), Arc::segment(b, c).unwrap()];
    let path = ArcPath::new(arcs, false).unwrap();
    let [joint] = joints(&path)[..] else { panic!("one joint") };
    assert_eq!((joint.piece, joint.next), (0, 2));
    assert!((joint.angle - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    assert!((length(&path) - 3.0).abs() < 1e-15);
    let near = cyclide::curve::closest_point(&path, point(2.0, 0.0, 0.0));
    // The joint: the end of the first piece comes first.
    assert_eq!((near.point, near.t), (b, 1.0 / 3.0));
    let table = cyclide::curve::ArcLength::new(&path);
    assert!((table.parameter_at(2.0 / 3.0) - 5.0 / 6.0).abs() < 1e-15);
}

#[test]
fn equally_near_points_give_the_first() {
    let circle = Circle::from_radius(point(1.0, 2.0, 0.0), Vec3::Z, 2.0).unwrap();
    let near = cyclide::curve::closest_point(&circle, point(1.0, 2.0, 5.0));
    assert_eq!(near.t, 0.0);
    // A square: its center is equally far from the middles of all sides.
    let corners = [point(1.0, 1.0, 0.0), point(-1.0, 1.0, 0.0), point(-1.0, -1.0, 0.0), point(1.0, -1.0, 0.0)];
    let sides = (0..4).map(|i| Arc::segment(corners[i], corners[(i + 1) % 4]).unwrap()).collect();
    let square = ArcPath::new(sides, true).unwrap();
    assert_eq!(cyclide::curve::closest_point(&square, Point3::ORIGIN).t, 0.125);
    // Seen from below the ends of a half circle are equally near, and nearer than all between.
    let [a, b, c] = [point(1.0, 0.0, 0.0), point(0.0, 1.0, 0.0), point(-1.0, 0.0, 0.0)];
    let half = Arc::from_three_points(a, b, c).unwrap();
    let below = point(0.0, -3.0, 0.0);
    assert_eq!((half.closest_point(below).t, cyclide::curve::closest_point(&half, below).t), (0.0, 0.0));
}

#[test]
fn arcs_are_written_in_pieces_of_at_most_the_angle_asked_for() {
    let [a, b, c] = [point(1.0, 0.0, 0.0), point(0.0, 1.0, 0.0), point(-1.0, 0.0, 0.0)];
    let half = Arc::from_three_points(a, b, c).unwrap();
    for (angle, pieces) in [(3.1, 2), (1.6, 2), (1.5, 3), (0.1, 32), (0.001_001, 3139)] {
        assert_eq!(half.to_nurbs(angle).unwrap().span_count(), pieces, "{angle}");
    }
    for angle in [std::f64::consts::PI, 4.0, 0.001, 1e-9, 0.0, -1.0, f64::NAN] {
        assert_eq!(half.to_nurbs(angle).unwrap_err().reason(), "parameter-out-of-range", "{angle}");
    }
}

/// The last point of these polygons is at the distance 1 from the origin and so is the middle of one side before it, while boxes round the last two
/// sides contain the origin.
#[test]
fn the_first_of_equally_near_points_is_found_behind_boxes_that_are_farther() {
    for (start, end, t) in
        [([[-1.0, 1.0], [1.0, 1.0]], [2.0, 1.5], 0.125), ([[-1.0, 3.0], [-1.0, 1.0]], [1.0, 1.0], 0.375)]
    {
        let corners = [start[0], start[1], end, [2.0, -2.0], [0.0, -1.0]].map(|[x, y]| point(x, y, 0.0));
        let sides = corners.windows(2).map(|w| Arc::segment(w[0], w[1]).unwrap()).collect();
        let found = cyclide::curve::closest_point(&ArcPath::new(sides, false).unwrap(), Point3::ORIGIN);
        assert_eq!((found.t, found.point, found.distance), (t, point(0.0, 1.0, 0.0), 1.0));
    }
}

#[test]
fn comb_of_a_circle_is_a_larger_circle() {
    let circle = Circle::from_radius(point(1.0, 2.0, 3.0), Vec3::new(0.2, 0.3, 1.0), 2.0).unwrap();
    let comb = curvature_comb(&circle, 12, 0.5);
    assert_eq!(comb.len(), 13);
    for (foot, tip) in comb {
        // Outside, by scale times curvature: 2 + 0.5/2.
        assert!((tip.distance(point(1.0, 2.0, 3.0)) - 2.25).abs() < 1e-14);
        assert!((foot.distance(tip) - 0.25).abs() < 1e-14);
    }
}

#[test]
fn a_cusp_is_measured_like_any_other_place() {
    // (x, y) = (t², t³), t from -1 to 1: a cusp in the middle.
    let third = 1.0 / 3.0;
    let points = vec![point(1.0, -1.0, 0.0), point(-third, 1.0, 0.0), point(-third, -1.0, 0.0), point(1.0, 1.0, 0.0)];
    let c = NurbsCurve::new(3, [[0.0; 4], [1.0; 4]].concat(), points, vec![1.0; 4]).unwrap();
    let want = 2.0 * (13.0_f64.powf(1.5) - 8.0) / 27.0;
    assert!((length(&c) - want).abs() < 1e-12 * want);
    let e = extreme_curvature(&c);
    assert!(e.max.is_infinite() && e.t == 0.5, "{e:?}");
    let near = cyclide::curve::closest_point(&c, point(-1.0, 0.0, 0.0));
    assert!(near.distance - 1.0 < 1e-15 && (near.t - 0.5).abs() < 1e-7, "{near:?}");
    let b = bounds(&c);
    assert!(b.min.distance(point(0.0, -1.0, 0.0)) < 1e-15 && b.max.distance(point(1.0, 1.0, 0.0)) < 1e-15, "{b:?}");
    let half = cyclide::curve::ArcLength::new(&c).parameter_at(0.5);
    // Length runs with the square of the parameter here: half of its digits are left.
    assert!((half - 0.5).abs() < 1e-6, "{half}");
    let polyline = cyclide::mesh::flatten(&c, 1e-4).unwrap();
    for w in polyline.windows(2) {
        let (a, b) = (w[0].1, w[1].1);
        for i in 0..=8 {
            let p = c.point(w[0].0 + (w[1].0 - w[0].0) * f64::from(i) / 8.0);
            let f = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            assert!(p.distance(a.lerp(b, f)) <= 1e-4, "{w:?}");
        }
    }
}

#[test]
fn a_spline_of_one_point_is_measured_without_trouble() {
    let p = point(1.0, 2.0, 3.0);
    let c = NurbsCurve::new(2, [[0.0; 3], [1.0; 3]].concat(), vec![p; 3], vec![1.0, 2.0, 1.0]).unwrap();
    assert!(length(&c) < 1e-15);
    assert_eq!(extreme_curvature(&c).point, p);
    assert!(joints(&c).is_empty());
    assert!(bounds(&c).diagonal() < 1e-15);
    assert!((cyclide::curve::closest_point(&c, point(1.0, 2.0, 5.0)).distance - 2.0).abs() < 1e-15);
    assert_eq!(cyclide::mesh::flatten(&c, 1.0).unwrap().len(), 2);
    let ts = cyclide::curve::ArcLength::new(&c).uniform(5);
    assert!(ts.windows(2).all(|w| w[0] <= w[1]) && ts[4] == 1.0, "{ts:?}");
}

#[test]
fn the_farthest_point_is_where_the_distance_stops_to_grow() {
    // From the chord y = x + 2 of y = x² over [-1, 2] the parabola is farthest where its slope is 1: x = 1/2, by (2.5 - 0.25)/√2.
    let chord = Arc::segment(point(-1.0, 1.0, 0.0), point(2.0, 4.0, 0.0)).unwrap();
    let found = farthest_point(&parabola(), &chord);
    assert!((found.distance - 2.25 / 2.0_f64.sqrt()).abs() < 1e-15 && (found.t - 0.5).abs() < 1e-12, "{found:?}");
    // From a short chord at its start it is farthest at its other end, to which the start of the chord is nearest.
    let short = Arc::segment(point(-1.0, 1.0, 0.0), point(-0.5, 0.25, 0.0)).unwrap();
    let found = farthest_point(&parabola(), &short);
    assert!((found.distance - 18.0_f64.sqrt()).abs() < 1e-14 && found.t == 1.0, "{found:?}");
    // Between two sides the distance has a corner, where both are equally near: at x = 0, a third of the way.
    let sides =
        ArcPath::rounded_polyline(&[point(-2.0, 2.0, 0.0), Point3::ORIGIN, point(4.0, 4.0, 0.0)], false, &[0.0; 3]);
    let across = Arc::segment(point(-1.0, 1.0, 0.0), point(2.0, 2.0, 0.0)).unwrap();
    let found = farthest_point(&across, &sides.unwrap());
    assert!((found.distance - 8.0_f64.sqrt() / 3.0).abs() < 1e-13 && (found.t - 1.0 / 3.0).abs() < 1e-12, "{found:?}");
    // A curve on the other one is at no distance from it.
    let part = Arc::segment(point(0.0, 2.0, 0.0), point(1.0, 3.0, 0.0)).unwrap();
    assert_eq!(farthest_point(&part, &chord).distance, 0.0);
    // Of many pieces those that cannot be the farthest are left out: samples of all of them are no farther, and the nearest of these all but as far.
    let wave: Vec<Point3> = (0..60).map(f64::from).map(|x| point(x, (x * x * 0.07).sin() * 3.0, 0.0)).collect();
    let spline = CircleSpline::from_points(&wave, &CircleSplineOptions::default()).unwrap();
    let polygon = ArcPath::rounded_polyline(&wave, false, &[0.0; 60]).unwrap();
    let found = farthest_point(&spline, &polygon);
    let index = CurveIndex::new(&polygon);
    let n = 64 * spline.piece_count();
    let distances = (0..=n).map(|i| index.closest_point(spline.point(i as f64 / n as f64)).distance);
    let sampled = distances.fold(0.0, f64::max);
    // Beside a smooth maximum samples fall by the square of their distance; at a corner of the polygon by the distance.
    assert!(found.distance >= sampled - 1e-14 && found.distance < 1.02 * sampled, "{found:?} {sampled}");
    // However large or small all of it is.
    for size in [1e-140, 1e140] {
        let scaled = |p: [f64; 2]| point(p[0] * size, p[1] * size, 0.0);
        let [a, b, c] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]].map(scaled);
        let arc = Arc::from_three_points(a, b, c).unwrap();
        let found = farthest_point(&arc, &Arc::segment(a, c).unwrap());
        assert!((found.distance / size - 1.0).abs() < 1e-15, "{found:?}");
    }
}
