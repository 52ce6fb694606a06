//! Splines through points: what they reproduce, how many pieces they take, options.

use crate::data::{modulo, places, reach, tori};
use cyclide::{
    Point2, Vec2,
    construct::{TorusSplineOptions, TorusTangent, TorusWinding},
    curve::{ParamCurve, bounds, joints},
    mesh::flatten,
    model::{Exactness, Lower},
    surface::{SegmentMethod, Torus, TorusSpline},
};
use cyclide_testkit::attack::Random;
use cyclide_testkit::torus_splines::{faults, off_torus, winding};

#[test]
fn points_on_a_circle_give_that_circle() {
    for torus in tori() {
        for family in cyclide::surface::CircleFamily::ALL {
            let at = |k: f64| Point2::new(0.2, 0.5) + family.direction() * (0.4 * k);
            let circle = torus.circle(family, at(0.0)).unwrap();
            let places: Vec<Point2> = [0.0, 1.0, 2.5, 3.0].map(at).to_vec();
            let spline = TorusSpline::through_places(&torus, &places, &TorusSplineOptions::default()).unwrap();
            assert!(spline.segments().iter().all(|s| s.method == SegmentMethod::Direct));
            assert_eq!(spline.to_nurbs().unwrap().degree(), 2, "{family:?}");
            for k in 0..=30 {
                let p = spline.point(f64::from(k) / 30.0);
                assert!(circle.closest_point(p).distance < 1e-13 * reach(&torus));
            }
        }
    }
}

/// Smooth closed curves without tangents: few pieces, half of the segments directly.
#[test]
fn smooth_loops_take_few_pieces() {
    let (torus, mut r) = (&tori()[0], Random::new(30, 10));
    let (mut pieces, mut segments) = (0, 0);
    for _ in 0..100 {
        let (n, phase) = (8 + r.below(8), r.between(0.0, 6.0));
        let [w, h] = [r.between(0.4, 1.2), r.between(0.4, 1.2)];
        let at = |i: usize| {
            let u = std::f64::consts::TAU * i as f64 / n as f64 + phase;
            Point2::new(w * u.cos(), h * u.sin())
        };
        let places: Vec<Point2> = (0..n).map(at).collect();
        let options = TorusSplineOptions { closed: true, winding: TorusWinding::Total([0, 0]), ..Default::default() };
        let spline = TorusSpline::through_places(torus, &places, &options).unwrap();
        assert_eq!(faults(&spline), Vec::<String>::new());
        (pieces, segments) = (pieces + spline.piece_count(), segments + spline.segments().len());
    }
    // Two pieces where a segment has one type, four or more where it crosses a direction of a family: eight times round a loop.
    assert!(pieces < 6 * segments, "{pieces} pieces of {segments} segments");
}

#[test]
fn windings_of_a_closed_curve_are_those_asked_for() {
    let torus = &tori()[0];
    let places = [[0.1, 0.2], [1.3, 0.9], [0.4, -1.0]].map(Point2::from);
    for n in -3..=3 {
        for m in -3..=3 {
            let options =
                TorusSplineOptions { closed: true, winding: TorusWinding::Total([n, m]), ..Default::default() };
            let spline = TorusSpline::through_places(torus, &places, &options).unwrap();
            assert_eq!(winding(&spline), [i64::from(n), i64::from(m)]);
        }
    }
}

#[test]
fn half_turns_per_segment_are_those_asked_for() {
    let torus = &tori()[0];
    let list = vec![[1, 0], [0, -2]];
    let options = TorusSplineOptions { winding: TorusWinding::PerSegment(list), ..Default::default() };
    let places = [[0.0, 0.0], [0.5, 0.3], [1.0, 0.0]].map(Point2::from);
    let spline = TorusSpline::through_places(torus, &places, &options).unwrap();
    let end = spline.unrolled_place(spline.piece_count() - 1, 1.0);
    let pi = std::f64::consts::PI;
    assert!((end - Point2::new(1.0 + pi, -2.0 * pi)).length() < 1e-13);
}

/// One point closed with a winding is a knot; two equal points are refused, or looped if asked.
#[test]
fn loops_where_they_are_asked_for() {
    let torus = &tori()[0];
    let one = [Point2::new(0.2, 0.3)];
    let options = TorusSplineOptions { closed: true, winding: TorusWinding::Total([2, 1]), ..Default::default() };
    let spline = TorusSpline::through_places(torus, &one, &options).unwrap();
    assert_eq!((winding(&spline), faults(&spline)), ([2, 1], Vec::new()));
    let twice = [Point2::new(0.2, 0.3), Point2::new(0.2 + std::f64::consts::PI, 0.3)];
    let refused = TorusSpline::through_places(torus, &twice, &TorusSplineOptions::default());
    assert_eq!(refused.unwrap_err().reason(), "coincident-points");
    for direction in [0.0, 1.0, 2.0, 4.0_f64] {
        let rate = TorusTangent::Rate(Vec2::new(direction.cos(), direction.sin()));
        for tangents in [vec![], vec![rate, rate], vec![rate, TorusTangent::Rate(Vec2::new(0.3, 0.1))]] {
            let options = TorusSplineOptions { loops: true, tangents, ..Default::default() };
            let spline = TorusSpline::through_places(torus, &twice, &options).unwrap();
            assert_eq!(faults(&spline), Vec::<String>::new());
            assert!(bounds(&spline).diagonal() > 0.1);
        }
    }
    // Directions that differ by less than an arc that is worth making, by as much, and by more.
    for k in 0..60 {
        let turn = 1e-4 * 1.1_f64.powi(k);
        for sign in [1.0, -1.0] {
            let rates = [Vec2::new(1.0, sign * turn), Vec2::new(1.0, 0.0)].map(TorusTangent::Rate);
            let options = TorusSplineOptions { loops: true, tangents: rates.to_vec(), ..Default::default() };
            let spline = TorusSpline::through_places(torus, &twice, &options).unwrap();
            assert_eq!(faults(&spline), Vec::<String>::new(), "{turn}");
        }
    }
}

#[test]
fn points_in_space_and_velocities() {
    for torus in tori() {
        let near: Vec<_> = places().into_iter().take(6).collect();
        let lift = 1e-3 * torus.minor_radius();
        let points: Vec<_> = near.iter().map(|p| torus.point(*p) + torus.unit_normal(*p) * lift).collect();
        let velocities: Vec<_> = near.iter().map(|p| torus.tangent(*p, Vec2::new(0.3, -0.4))).collect();
        // What a velocity has across the torus is left out.
        let across = near.iter().zip(&velocities).map(|(p, v)| *v + torus.unit_normal(*p) * v.length());
        let tangents = across.map(TorusTangent::Velocity).collect();
        let options = TorusSplineOptions { tangents, ..Default::default() };
        let spline = TorusSpline::through_points(&torus, &points, 1.1 * lift, &options).unwrap();
        assert_eq!(faults(&spline), Vec::<String>::new());
        for (i, (p, v)) in points.iter().zip(velocities).enumerate() {
            let jet = spline.jet_at_knot(i as f64);
            assert!((jet.point.distance(*p) - lift).abs() < 1e-14 * 10.0 * reach(&torus));
            assert!((jet.d1 - v).length() < 1e-10 * v.length());
        }
        let refused = TorusSpline::through_points(&torus, &points, 0.9 * lift, &options);
        assert_eq!(refused.unwrap_err().reason(), "point-off-torus");
    }
}

/// Knots are kept to the bit, data are at theirs, and the curve is the same for knots moved and stretched.
#[test]
fn knots_are_the_parameter() {
    let (torus, places) = (&tori()[1], [[0.0, 0.0], [0.6, 0.5], [0.8, 1.5], [1.9, 1.2]].map(Point2::from));
    let spline = |knots: Vec<f64>| {
        TorusSpline::through_places(torus, &places, &TorusSplineOptions { knots, ..Default::default() }).unwrap()
    };
    let (one, other) = (spline(vec![0.0, 1.0, 1.7, 4.0]), spline(vec![10.0, 30.0, 44.0, 90.0]));
    for (u, v) in [(0.0, 10.0), (1.0, 30.0), (1.7, 44.0), (4.0, 90.0), (0.3, 16.0), (2.5, 60.0)] {
        let (p, q) = (one.jet_at_knot(u), other.jet_at_knot(v));
        assert!(p.point.distance(q.point) < 1e-13 && (p.d1 / 20.0 - q.d1).length() < 1e-13);
    }
    assert!(modulo(places[2], one.pieces()[one.segments()[2].pieces.start].start()) == 0.0);
    assert!(one.knots().contains(&1.7) && one.knots().windows(2).all(|k| k[0] < k[1]));
}

/// The curve as every other curve of the kernel: flattened within a tolerance, with a box, tangent at its joints.
#[test]
fn it_is_a_curve_of_the_kernel() {
    for torus in tori() {
        let places = [[0.1, 0.2], [1.3, 0.9], [0.4, -1.0], [-0.6, 0.1]].map(Point2::from);
        let options = TorusSplineOptions { closed: true, winding: TorusWinding::Total([1, 1]), ..Default::default() };
        let spline = TorusSpline::through_places(&torus, &places, &options).unwrap();
        let tolerance = 1e-4 * torus.major_radius();
        let polyline = flatten(&spline, tolerance).unwrap();
        assert!(polyline.iter().all(|(_, p)| off_torus(&torus, *p) < 2e-14 * reach(&torus)));
        let b = bounds(&spline);
        for k in 0..=500 {
            let p = spline.point(f64::from(k) / 500.0);
            assert!(b.min.x <= p.x + 1e-14 * reach(&torus) && p.z <= b.max.z + 1e-14 * reach(&torus));
        }
        assert!(joints(&spline).iter().all(|joint| joint.gap == 0.0 && joint.angle < 1e-10));
        let nurbs = spline.to_nurbs().unwrap();
        assert!(nurbs.is_closed() && nurbs.degree() == 4);
        let (first, last) = (spline.knots()[0], spline.knots()[spline.piece_count()]);
        for k in 0..=200 {
            let u = f64::from(k) / 200.0;
            let want = spline.jet_at_knot(first + u * (last - first)).point;
            assert!(nurbs.point_at_knot(u).distance(want) < 1e-12 * reach(&torus));
        }
        // C1 knots: what CAD systems ask for.
        let smooth = spline.to_c1_nurbs().unwrap();
        let inner = smooth.knot_multiplicities();
        assert!(smooth.degree() == 7 && inner[1..inner.len() - 1].iter().all(|(_, times)| *times == 6), "{torus:?}");
        for k in 0..=200 {
            let u = f64::from(k) / 200.0;
            assert!(smooth.point_at_knot(u).distance(nurbs.point_at_knot(u)) < 1e-12 * reach(&torus));
        }
    }
}

#[test]
fn frames_stand_on_the_torus() {
    let torus = Torus::new(cyclide::Frame::WORLD, 3.0, 1.0).unwrap();
    let knot = TorusSpline::knot(&torus, [2, 3], Point2::default()).unwrap();
    for k in 0..40 {
        let t = f64::from(k) / 40.0;
        let (frame, jet) = (knot.seam_frame(t).unwrap(), knot.jet(t));
        assert_eq!(frame.origin(), jet.point);
        assert!(frame.x().cross(jet.d1).length() < 1e-13 * jet.d1.length() && frame.x().dot(jet.d1) > 0.0);
        let lifted = frame.origin() + frame.z() * 0.1;
        assert!((off_torus(&torus, lifted) - 0.1).abs() < 1e-14);
        let (plane, z) = torus.frame().to_local(lifted);
        assert!((plane.x.hypot(plane.y) - 3.0).hypot(z) > 1.0, "outward");
    }
}

/// What leaves the kernel: one exact spline with its correspondence, and arcs within a tolerance, tangent at their joints.
#[test]
fn it_leaves_the_kernel_exactly_or_as_arcs() {
    for torus in tori() {
        let places = [[0.1, 0.2], [1.3, 0.9], [0.4, -1.0], [-0.6, 0.1]].map(Point2::from);
        for closed in [false, true] {
            let options = TorusSplineOptions { closed, ..Default::default() };
            let spline = TorusSpline::through_places(&torus, &places, &options).unwrap();
            let tolerance = 1e-3 * torus.major_radius();
            let chain = spline.lower_to_chain(tolerance).unwrap();
            assert_eq!((chain.exactness, chain.correspondence.spans.len()), (Exactness::Exact, spline.piece_count()));
            assert_eq!(chain.correspondence.piece_count(), chain.form.piece_count());
            assert!(joints(&chain.form).iter().all(|joint| joint.gap <= 1e-15 * reach(&torus)));
            let arcs = spline.lower_to_arcs(tolerance).unwrap();
            assert_eq!(arcs.correspondence.piece_count(), arcs.form.arcs().len());
            assert!(joints(&arcs.form).iter().all(|joint| joint.gap == 0.0 && joint.angle < 1e-6));
            for k in 0..=2000 {
                let p = spline.point(f64::from(k) / 2000.0);
                assert!(arcs.form.closest_point(p).distance <= tolerance);
            }
            let index = cyclide::curve::CurveIndex::new(&spline);
            for k in 0..=400 {
                let p = arcs.form.point(f64::from(k) / 400.0);
                assert!(index.closest_point(p).distance <= tolerance);
            }
        }
    }
    let circle = TorusSpline::knot(&tori()[0], [1, -1], Point2::default()).unwrap().lower_to_arcs(1e-3).unwrap();
    assert_eq!((circle.exactness, circle.form.is_closed()), (Exactness::Exact, true));
    let radius = |arc: &cyclide::curve::Arc| (arc.radius().unwrap() - 3.0).abs();
    assert!(circle.form.arcs().iter().all(|arc| radius(arc) < 1e-12));
}
