//! Laws of Möbius splines.

use crate::data::{PARAMETERS, outside_inversion};
use cyclide::{
    Point3, Vec3,
    conformal::Conformal,
    construct::{MoebiusSplineOptions, NodeParameters, QbInterpolation, QbNode},
    curve::{CircleSpline, CircleSplineOptions, ParamCurve, QbSpline, bounds, closest_point, joints},
    model::{CurveObject, Lower},
    rational::NurbsCurve,
};
use cyclide_testkit::generators::point;
use proptest::prelude::*;

fn points() -> impl Strategy<Value = Vec<Point3>> {
    (3_usize..9).prop_flat_map(|n| prop::collection::vec(point(), n))
}

fn options(closed: bool) -> MoebiusSplineOptions {
    MoebiusSplineOptions { closed, ..Default::default() }
}

/// No circle of the polygon's corners is so large that it takes digits: turns below 170 degrees, chords not all too uneven.
fn is_tame(points: &[Point3], closed: bool) -> bool {
    let n = points.len();
    let inner = if closed { 0..n } else { 1..n - 1 };
    let chord = |i: usize| points[(i + 1) % n] - points[i % n];
    let chords_well = (0..n).all(|i| chord(i).length() > 0.05);
    chords_well && inner.into_iter().all(|i| chord(i + n - 1).angle(chord(i)) < 2.96)
}

/// Not the long way, nor on the edge of it.
fn is_short(spline: &QbSpline) -> bool {
    !spline.warnings().iter().any(|w| matches!(w.reason(), "long-way" | "opposite-circles"))
        && bounds(spline).diagonal() < 30.0
}

proptest! {
    #[test]
    fn points_are_met_and_derivatives_continuous(points in points(), closed: bool) {
        if !is_tame(&points, closed) {
            return Ok(());
        }
        let spline = QbSpline::through_points(&points, &options(closed)).unwrap();
        let n = spline.piece_count();
        let size = bounds(&spline).diagonal();
        for (i, p) in points.iter().enumerate() {
            let t = if i == n { 1.0 } else { i as f64 / n as f64 };
            prop_assert_eq!(spline.locate(t).1.fract(), if i == n { 0.0 } else { spline.locate(t).1 });
            prop_assert_eq!(if i == n { spline.piece_point(n - 1, 1.0) } else { spline.piece_point(i, 0.0) }, *p);
        }
        prop_assert!(spline.kinks().is_empty());
        for joint in joints(&spline) {
            prop_assert!(joint.gap == 0.0 && joint.angle < 1e-9, "{joint:?}");
            let h = |i: usize| spline.knots()[i + 1] - spline.knots()[i];
            let (a, b) = (spline.piece_jet(joint.piece, 1.0).d1 / h(joint.piece), spline.piece_jet(joint.next, 0.0).d1 / h(joint.next));
            // Speeds by circles and by spans, of the size of the curve.
            prop_assert!((a - b).length() < 1e-9 * (a.length() + size), "{a:?} {b:?}");
        }
    }

    #[test]
    fn the_exact_form_is_the_curve(points in points(), closed: bool) {
        if !is_tame(&points, closed) {
            return Ok(());
        }
        let spline = QbSpline::through_points(&points, &options(closed)).unwrap();
        let runs = spline.to_nurbs_runs().unwrap();
        prop_assert_eq!(runs.len(), 1);
        // Ends are those of the spline to the bit: a closed curve closes.
        prop_assert_eq!(runs[0].control_points()[0], spline.point(0.0));
        prop_assert_eq!(runs[0].control_points().last().copied(), Some(spline.point(1.0)));
        let (first, last) = (spline.knots()[0], spline.knots()[spline.knots().len() - 1]);
        let size = bounds(&spline).diagonal();
        for i in 0..=60 {
            let k = f64::from(i) / 60.0;
            let want = spline.jet_at_knot(first + k * (last - first)).point;
            prop_assert!(runs[0].point_at_knot(k).distance(want) < 1e-10 * size);
        }
        for (i, p) in points.iter().enumerate().skip(1) {
            if i < spline.piece_count() {
                let k = (spline.knots()[i] - first) / (last - first);
                prop_assert!(runs[0].point_at_knot(k).distance(*p) < 1e-12 * size);
            }
        }
    }

    #[test]
    fn splines_of_images_are_images_of_splines(points in points(), closed: bool, map in outside_inversion()) {
        if !is_tame(&points, closed) {
            return Ok(());
        }
        let spline = QbSpline::through_points(&points, &options(closed)).unwrap();
        let images: Vec<Point3> = points.iter().map(|p| map.map_point(*p).unwrap()).collect();
        let knots = NodeParameters::Given(spline.knots().to_vec());
        let of_images = QbSpline::through_points(&images, &MoebiusSplineOptions { closed, knots, ..Default::default() }).unwrap();
        // The way round infinity is not kept: the center may be in the lune of a span.
        if !(is_short(&spline) && is_short(&of_images) && bounds(&spline).diagonal() < 4.0) {
            return Ok(());
        }
        let image = spline.transformed(&map).unwrap();
        prop_assert_eq!(image.knots(), of_images.knots());
        for i in 0..=60 {
            let t = f64::from(i) / 60.0;
            prop_assert!(image.point(t).distance(of_images.point(t)) < 1e-7, "{t}");
        }
    }

    #[test]
    fn points_on_a_circle_stay_on_it(mut angles in prop::collection::vec(0.0..6.2_f64, 4..9), closed: bool) {
        angles.sort_by(f64::total_cmp);
        if !(angles.windows(2).all(|w| w[1] - w[0] > 0.02)) {
            return Ok(());
        }
        let points: Vec<Point3> = angles.iter().map(|a| Point3::new(a.cos(), a.sin(), 0.5)).collect();
        for knots in [NodeParameters::Automatic, NodeParameters::Uniform, NodeParameters::Chord] {
            let spline = QbSpline::through_points(&points, &MoebiusSplineOptions { closed, knots, ..Default::default() }).unwrap();
            for i in 0..=60 {
                let p = spline.point(f64::from(i) / 60.0);
                prop_assert!((p.x.hypot(p.y) - 1.0).abs() < 1e-11 && (p.z - 0.5).abs() < 1e-11);
            }
        }
    }

    #[test]
    fn without_knots_it_is_the_circle_spline_of_order_one(points in points(), closed: bool) {
        let made = CircleSpline::from_points(&points, &CircleSplineOptions { closed, order: 1, ..Default::default() });
        let Ok(circles) = made else { return Ok(()) };
        let spline = QbSpline::from_circle_spline(&circles).unwrap();
        prop_assert_eq!(spline.kinks(), circles.kinks());
        for i in 0..=60 {
            let t = f64::from(i) / 60.0;
            let (a, b) = (spline.point(t), circles.point(t));
            // Far out digits go as the square of the distance.
            let far = 1.0 + b.to_vec().length();
            prop_assert!(a.distance(b) < 1e-13 * far * far, "{t}: {a:?} {b:?}");
        }
    }

    #[test]
    fn reversed_and_cut_chains_have_the_same_points(points in points(), closed: bool, t in 0.05..0.95_f64) {
        if !is_tame(&points, closed) {
            return Ok(());
        }
        let spline = QbSpline::through_points(&points, &options(closed)).unwrap();
        let size = bounds(&spline).diagonal();
        let back = spline.reversed();
        let (left, right) = spline.split(t).unwrap();
        prop_assert_eq!(left.point(1.0), right.point(0.0));
        for s in PARAMETERS {
            prop_assert!(back.point(1.0 - s).distance(spline.point(s)) < 1e-10 * size);
            let (a, b) = (spline.knots()[0], *left.knots().last().unwrap());
            let u = a + s * (b - a);
            prop_assert!(left.jet_at_knot(u).point.distance(spline.jet_at_knot(u).point) < 1e-9 * size);
        }
        prop_assert_eq!(left.knots().last(), right.knots().first());
    }

    /// A span depends on four points and their knots.
    #[test]
    fn far_points_change_nothing(points in prop::collection::vec(point(), 7), other in point()) {
        if !is_tame(&points, false) {
            return Ok(());
        }
        let knots = NodeParameters::Given((0..7).map(f64::from).collect());
        let options = MoebiusSplineOptions { knots, ..Default::default() };
        let spline = QbSpline::through_points(&points, &options).unwrap();
        let mut moved = points.clone();
        moved[6] = other;
        let Ok(changed) = QbSpline::through_points(&moved, &options) else { return Ok(()) };
        prop_assert_eq!(&spline.spans()[..4], &changed.spans()[..4]);
    }
}

#[test]
fn tangents_that_are_given_are_kept() {
    let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0], [1.0, 4.0, 0.0]].map(Point3::from);
    let v = Vec3::new(0.5, 1.0, 0.25);
    let options =
        MoebiusSplineOptions { tangents: vec![None, Some(v), None, None], closed: true, ..Default::default() };
    let spline = QbSpline::through_points(&points, &options).unwrap();
    let u = spline.knots()[1];
    assert!((spline.jet_at_knot(u).d1 - v).length() < 1e-14);
    let free = QbSpline::through_points(&points, &MoebiusSplineOptions { closed: true, ..Default::default() }).unwrap();
    assert_eq!(spline.spans()[2], free.spans()[2]);
}

#[test]
fn turning_right_back_is_a_corner() {
    let points = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
    let spline = QbSpline::through_points(&points, &MoebiusSplineOptions::default()).unwrap();
    assert_eq!(spline.kinks(), [1]);
    assert_eq!(spline.warnings()[0].reason(), "cusp");
    let runs = spline.to_nurbs_runs().unwrap();
    assert_eq!(runs.len(), 2);
    assert_eq!(runs[0].control_points().last(), runs[1].control_points().first());
}

#[test]
fn closed_splines_get_knots_and_weights_that_fit_at_the_seam() {
    let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0], [1.0, 4.0, 0.0]].map(Point3::from);
    let spline =
        QbSpline::through_points(&points, &MoebiusSplineOptions { closed: true, ..Default::default() }).unwrap();
    let smooth = spline.to_nurbs_runs().unwrap()[0].with_c1_knots().unwrap();
    assert_eq!(smooth.degree(), 7);
    let (n, w) = (smooth.weights().len(), smooth.weights());
    assert!((w[0] - w[n - 1]).abs() < 1e-14 * w[0]);
    let knots = smooth.breaks();
    let slopes = [
        (w[1] - w[0]) / (knots[1] - knots[0]),
        (w[n - 1] - w[n - 2]) / (knots[knots.len() - 1] - knots[knots.len() - 2]),
    ];
    assert!((slopes[0] - slopes[1]).abs() < 1e-12);
}

#[test]
fn both_sides_of_a_corner_are_splines_of_their_own() {
    let rows = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0], [5.0, 3.0, 0.0], [6.0, 1.0, 0.5]];
    let points = rows.map(Point3::from);
    let options = MoebiusSplineOptions { corners: vec![2], knots: NodeParameters::Chord, ..Default::default() };
    let cut = QbSpline::through_points(&points, &options).unwrap();
    assert_eq!(cut.kinks(), [2]);
    let knots = NodeParameters::Chord;
    let half = |points: &[Point3]| {
        QbSpline::through_points(points, &MoebiusSplineOptions { knots: knots.clone(), ..Default::default() }).unwrap()
    };
    for (part, first) in [(half(&points[..3]), 0), (half(&points[2..]), 2)] {
        for i in 0..2 {
            for t in PARAMETERS {
                assert!(part.spans()[i].point(t).distance(cut.spans()[first + i].point(t)) < 1e-14);
            }
        }
    }
    let bad = MoebiusSplineOptions { corners: vec![9], ..Default::default() };
    assert_eq!(QbSpline::through_points(&points, &bad).unwrap_err().reason(), "parameter-out-of-range");
}

#[test]
fn arcs_follow_a_curve_through_its_cusps() {
    let at = |x: f64, y: f64| Point3::new(x, y, 0.0);
    // At 1/2 and, cut unevenly, elsewhere: the control points of the cubic cross so that its velocity vanishes.
    let points = [at(0.0, 0.0), at(40.0, 40.0), at(0.0, 40.0), at(40.0, 0.0)];
    let cubic = NurbsCurve::new(3, [[0.0; 4], [1.0; 4]].concat(), points.to_vec(), vec![1.0; 4]).unwrap();
    let (part, _) = cubic.split(0.83).unwrap();
    let node = |point: Point3, derivatives: Vec<Vec3>, parameter: f64| QbNode { parameter, point, derivatives };
    let nodes = [
        node(at(0.0, 0.0), vec![], 0.0),
        node(at(20.0, 30.0), vec![Vec3::ZERO, Vec3::Y * -400.0], 0.5),
        node(at(40.0, 0.0), vec![], 1.0),
    ];
    let quotient = QbInterpolation::through_nodes(&nodes).unwrap().curve().clone();
    let curves = [CurveObject::from(cubic), CurveObject::from(part), QbSpline::from_curve(quotient).unwrap().into()];
    for curve in curves {
        for tolerance in [1e-1, 1e-3, 1e-4] {
            let arcs = curve.lower_to_arcs(tolerance).unwrap().form;
            assert!(arcs.arcs().len() < 400, "{}", arcs.arcs().len());
            for t in (0..=2000).map(|k| f64::from(k) / 2000.0) {
                let off = closest_point(&arcs, curve.as_curve().point(t)).distance;
                assert!(off <= tolerance, "{off} {tolerance} at {t}");
            }
            for t in (0..=2000).map(|k| f64::from(k) / 2000.0) {
                let off = closest_point(curve.as_curve(), arcs.point(t)).distance;
                assert!(off <= tolerance, "{off} {tolerance} of the arcs at {t}");
            }
        }
    }
}

#[test]
fn a_long_closed_chain_ends_with_the_weight_it_starts_with() {
    // Readers bend the end of a curve that is called closed and is not; and the scales of a thousand spans round differently.
    let place = |k: usize| {
        let a = std::f64::consts::TAU * k as f64 / 1000.0;
        let r = 700.0 + 150.0 * (3.0 * a).cos() + 20.0 * (17.0 * a).sin();
        Point3::new(r * a.cos(), r * a.sin(), 20.0 * a.sin() + 5.0 * (9.0 * a).cos())
    };
    let points: Vec<Point3> = (0..1000).map(place).collect();
    let spline = QbSpline::through_points(&points, &options(true)).unwrap();
    let runs = spline.to_nurbs_runs().unwrap();
    assert_eq!(runs.len(), 1);
    let smooth = runs[0].with_c1_knots().unwrap();
    for curve in [&runs[0], &smooth] {
        assert_eq!(curve.weights().first(), curve.weights().last());
        assert_eq!(curve.control_points().first(), curve.control_points().last());
    }
    assert!(smooth.knot_multiplicities()[1..1000].iter().all(|(_, m)| *m == smooth.degree() - 1));
}

/// An end that sums and quotients have left next to 0 or 1 is the end, whatever the number of spans; also of a part past the start.
#[test]
fn cuts_next_to_an_end_are_at_the_end() {
    let points: Vec<Point3> =
        (0..7).map(|k| Point3::new(f64::from(k).cos(), f64::from(k).sin(), 0.1 * f64::from(k))).collect();
    for closed in [false, true] {
        for n in 3..=7 {
            let spline = QbSpline::through_points(&points[..n], &options(closed)).unwrap();
            let arcs = cyclide::curve::ArcPath::spline(
                &points[..n],
                &cyclide::construct::ArcSplineOptions { closed, ..Default::default() },
            )
            .unwrap();
            let circles =
                CircleSpline::from_points(&points[..n], &CircleSplineOptions { closed, ..Default::default() }).unwrap();
            let nurbs = spline.to_nurbs_runs().unwrap().remove(0);
            for curve in [CurveObject::from(spline), arcs.into(), circles.into(), nurbs.into()] {
                let whole = curve.restricted(0.0, 1.0).unwrap();
                for ulps in 1..=4 {
                    let off = 0.5 * f64::from(ulps) * f64::EPSILON;
                    assert_eq!(curve.restricted(off, 1.0 - off).unwrap(), whole, "{closed} {n} {ulps}");
                    let (a, b) = (curve.restricted(0.3, 1.0 - off).unwrap(), curve.restricted(0.3, 1.0).unwrap());
                    assert_eq!(a, b);
                    if closed {
                        assert_eq!(curve.restricted(1.0 - off, 0.3).unwrap(), curve.restricted(0.0, 0.3).unwrap());
                        assert_eq!(curve.restricted(0.3, off).unwrap(), b);
                    }
                }
            }
        }
    }
}

/// Chords that are lost in the sum of those before them get knots of their own all the same.
#[test]
fn circle_splines_have_increasing_knots() {
    let points =
        [[0.0, 0.0, 0.0], [1e-4, 1e-4, 0.0], [2e-4, 0.0, 0.0], [1e13, 1.0, 0.0], [1e13, 1.01, 0.0], [1e13, 1.02, 0.0]];
    for closed in [false, true] {
        let made = CircleSpline::from_points(
            &points.map(Point3::from),
            &CircleSplineOptions { closed, order: 1, ..Default::default() },
        );
        let Ok(circles) = made else { continue };
        let spline = QbSpline::from_circle_spline(&circles).unwrap();
        assert!(spline.knots().windows(2).all(|w| w[0] < w[1]), "{:?}", spline.knots());
        assert_eq!(spline.spans().len(), circles.segments().len());
        for u in spline.knots() {
            assert!(spline.jet_at_knot(*u).point.is_finite());
        }
    }
    // A part of next to nothing at the end of a long curve.
    let circles = CircleSpline::from_points(
        &[[0.0, 0.0, 0.0], [4.0, 1.0, 0.0], [5.0, 4.0, 1.0], [1.0, 3.0, 2.0]].map(Point3::from),
        &CircleSplineOptions { order: 1, ..Default::default() },
    )
    .unwrap();
    let part = circles.restricted(0.0, (2.0 + 2e-15) / 3.0).unwrap();
    let spline = QbSpline::from_circle_spline(&part).unwrap();
    assert_eq!(spline.spans().len(), 3);
    assert!(spline.knots().windows(2).all(|w| w[0] < w[1]), "{:?}", spline.knots());
}
