//! Curves of quaternions as motions.

use cyclide::{
    Point3, Quat, Vec3,
    construct::{ArcSplineOptions, MoebiusSplineOptions},
    curve::{Arc, ArcPath, ParamCurve, QbCurve, QbSpline, bounds},
    model::CurveObject,
    motion::RationalMotion,
};
use cyclide_testkit::generators::point;
use proptest::prelude::*;

/// Points of which each is well away from the next, and no turn is nearly back: the chain does not swing out.
fn points() -> impl Strategy<Value = Vec<Point3>> {
    prop::collection::vec(point(), 3..8).prop_filter("even steps", |points| {
        let steps: Vec<Vec3> = points.windows(2).map(|w| w[1] - w[0]).collect();
        let longest = steps.iter().map(|s| s.length()).fold(0.0, f64::max);
        steps.iter().all(|s| s.length() > 0.1 * longest) && steps.windows(2).all(|w| w[0].angle(w[1]) < 2.6)
    })
}

fn rotation() -> impl Strategy<Value = Quat> {
    prop::array::uniform4(-1.0..1.0_f64).prop_map(Quat::from).prop_filter("a rotation", |q| q.norm() > 0.1)
}

fn polyline(points: &[Point3]) -> ArcPath {
    ArcPath::new(points.windows(2).map(|w| Arc::segment(w[0], w[1]).unwrap()).collect(), false).unwrap()
}

/// A time within a span.
fn time(chain: &QbSpline, span: usize, s: f64) -> f64 {
    let [a, b] = [chain.knots()[span], chain.knots()[span + 1]];
    a + (b - a) * s
}

fn splines(points: &[Point3]) -> Vec<QbSpline> {
    let moebius = QbSpline::through_points(points, &MoebiusSplineOptions::default());
    let arcs = ArcPath::spline(points, &ArcSplineOptions::default()).map(|path| QbSpline::from_arcs(&path));
    let chains = [moebius, arcs].into_iter().flatten();
    let size = bounds(&QbSpline::from_arcs(&polyline(points))).diagonal();
    chains.filter(|chain| bounds(chain).diagonal() < 10.0 * size).collect()
}

proptest! {
    #[test]
    fn the_origin_runs_on_the_curve_and_the_body_does_not_jump(points in points(), start in rotation()) {
        for chain in splines(&points) {
            let motion = RationalMotion::along(&chain, start).unwrap();
            let size = bounds(&chain).including(Point3::ORIGIN).diagonal();
            let first = start * (1.0 / start.norm());
            prop_assert!((motion.pose(chain.knots()[0]).rotation() * first.conj()).vector().length() < 1e-14);
            for span in 0..chain.spans().len() {
                for s in [0.0, 0.1, 0.4, 0.7, 0.95] {
                    let pose = motion.pose(time(&chain, span, s));
                    // What rounding costs where a denominator is small between its ends.
                    let gap = (pose.translation() - chain.spans()[span].point(s).to_vec()).length();
                    prop_assert!(gap < 1e-11 * size, "{gap} of {size}");
                }
                // A millionth before the joint and at it.
                if span > 0 {
                    let step = chain.knots()[span] - time(&chain, span - 1, 1.0 - 1e-9);
                    let [a, b] = [chain.knots()[span] - step, chain.knots()[span]].map(|t| motion.jet(t, Point3::ORIGIN));
                    let turn = a.pose.angle_to(b.pose);
                    prop_assert!(turn < 2.0 * step * a.angular_velocity.length() + 1e-7, "{turn}");
                }
            }
        }
    }

    #[test]
    fn the_start_turns_the_body_first(points in points(), start in rotation()) {
        for chain in splines(&points) {
            let motions = [Quat::ONE, start].map(|start| RationalMotion::along(&chain, start).unwrap());
            for span in 0..chain.spans().len() {
                let t = time(&chain, span, 0.37);
                let [plain, turned] = motions.each_ref().map(|motion| motion.pose(t).rotation());
                let other = plain * start * (1.0 / start.norm());
                let by = (turned.conj() * other).vector().length();
                prop_assert!(by < 1e-12, "{by}");
            }
        }
    }

    #[test]
    fn along_arcs_the_tangent_stays_in_the_body_and_nothing_turns_about_it(points in points(), start in rotation()) {
        let Ok(path) = ArcPath::spline(&points, &ArcSplineOptions::default()) else { return Ok(()) };
        let chain = QbSpline::from_arcs(&path);
        let motion = RationalMotion::along(&chain, start).unwrap();
        let tangent = |t: f64| motion.pose(t).rotation().conj().rotate(motion.jet(t, Point3::ORIGIN).point.d1.unit().unwrap());
        let first = tangent(0.0);
        for span in 0..chain.spans().len() {
            for s in [0.05, 0.5, 0.95] {
                let t = time(&chain, span, s);
                // Arcs of a spline meet smoothly to 1e-9 or so.
                prop_assert!(tangent(t).angle(first) < 1e-7 * (1 + span) as f64, "{}", tangent(t).angle(first));
                let jet = motion.jet(t, Point3::ORIGIN);
                let about = jet.angular_velocity.dot(jet.point.d1.unit().unwrap()).abs();
                prop_assert!(about <= 1e-9 * (jet.angular_velocity.length() + jet.point.d1.length()), "{about}");
            }
        }
    }

    #[test]
    fn paths_of_points_are_exact(points in points(), start in rotation(), x in prop::array::uniform3(-2.0..2.0_f64)) {
        for chain in splines(&points) {
            let motion = RationalMotion::along(&chain, start).unwrap();
            let path = motion.trajectory(Point3::from(x)).unwrap();
            prop_assert_eq!(path.degree(), 2 * chain.degree());
            let [first, last] = [motion.times()[0], motion.times()[chain.spans().len()]];
            let size = bounds(&chain).including(Point3::ORIGIN).diagonal() + Vec3::from(x).length();
            for k in 0..=60 {
                let part = f64::from(k) / 60.0;
                let jet = motion.jet(first + (last - first) * part, Point3::from(x));
                let allowed = 1e-10 * size + 1e-14 * jet.point.speed() * (last - first);
                let gap = path.point_at_knot(part).distance(jet.point.point);
                prop_assert!(gap < allowed, "{gap} {allowed}");
            }
        }
    }
}

#[test]
fn which_curves_are_chains_of_quaternions() {
    let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
    let polyline = CurveObject::from(polyline(&corners)).to_qb_spline().unwrap();
    assert_eq!((polyline.degree(), polyline.kinks()), (1, &[1][..]));
    assert_eq!(polyline.knots(), [0.0, 4.0, 8.0]);
    // Along segments the body does not turn.
    let motion = RationalMotion::along(&polyline, Quat::ONE).unwrap();
    assert_eq!(motion.pose(6.0).rotation(), Quat::ONE);
    let circle = cyclide::curve::Circle::from_radius(Point3::ORIGIN, Vec3::Z, 2.0).unwrap();
    let circle = CurveObject::from(circle).to_qb_spline().unwrap();
    assert!(circle.is_closed() && circle.kinks().is_empty());
    // Once around, the body has turned once.
    let motion = RationalMotion::along(&circle, Quat::ONE).unwrap();
    let [first, last] = [motion.times()[0], motion.times()[motion.times().len() - 1]];
    assert!(motion.pose(first).angle_to(motion.pose(last)) < 1e-14);
    let half = motion.pose(0.5 * (first + last));
    assert!((half.rotation().rotate(Vec3::X) + Vec3::X).length() < 1e-14);
    // A parabola has no such form.
    let nurbs =
        cyclide::rational::NurbsCurve::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], corners.to_vec(), vec![1.0; 3])
            .unwrap();
    assert!(CurveObject::from(nurbs).to_qb_spline().is_none());
}

#[test]
fn a_rotation_that_is_none_is_refused() {
    let path = polyline(&[Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)]);
    let reason = |start: Quat| RationalMotion::along(&QbSpline::from_arcs(&path), start).unwrap_err().reason();
    assert_eq!(reason(Quat::ZERO), "zero-rotation");
    assert_eq!(reason(Quat::new(f64::NAN, 0.0, 0.0, 0.0)), "not-finite");
}

/// Weights that fall by many orders along a span are no place at infinity, nor one where nothing is left.
#[test]
fn uneven_weights_are_taken() {
    let ends = [Point3::new(1.0, 2.0, 0.5), Point3::new(3.0, 3.0, 1.0)];
    let span = QbCurve::invariant_span(ends, [Vec3::new(1.0, 0.5, 0.3), Vec3::new(0.2, 1.0, -0.4)]).unwrap();
    let plain = RationalMotion::along(&QbSpline::from_curve(span.clone()).unwrap(), Quat::ONE).unwrap();
    for c in [1e-10, 1e-5, 0.1, 1e5, 1e10] {
        let chain = QbSpline::from_curve(span.reparametrized(c).unwrap()).unwrap();
        let motion = RationalMotion::along(&chain, Quat::ONE).unwrap();
        for k in 0..=20 {
            let s = 0.05 * f64::from(k);
            // What is at s is where t/(1 − t) is s/(1 − s) over c.
            let t = s / (s + c * (1.0 - s));
            let [a, b] = [motion.pose(t), plain.pose(s)];
            // t is rounded, and s moves with it.
            let moved = if t > 0.0 && t < 1.0 { 4.0 * f64::EPSILON * s * (1.0 - s) / (t * (1.0 - t)) } else { 0.0 };
            let limit = 1e-13 + moved;
            assert!((a.translation() - b.translation()).length() < 4.0 * limit, "{c:e} {s}");
            assert!(a.angle_to(b) < 4.0 * limit, "{c:e} {s}: {:e}", a.angle_to(b));
        }
    }
}

/// A frame that comes back says by how much it does not close.
#[test]
fn closed_curves_say_by_which_angle_the_body_does_not_close() {
    // On a plane curve the body turns about the normal, by whole turns.
    let ring = [[4.0, 0.0, 0.0], [0.0, 3.0, 0.0], [-4.0, 1.0, 0.0], [0.0, -3.0, 0.0]].map(Point3::from);
    let options = MoebiusSplineOptions { closed: true, ..Default::default() };
    let arcs = ArcSplineOptions { closed: true, ..Default::default() };
    let turn = |chain: &QbSpline| {
        cyclide::motion::Motion::from(RationalMotion::along(chain, Quat::ONE).unwrap()).closing_turn()
    };
    let plane = turn(&QbSpline::from_arcs(&ArcPath::spline(&ring, &arcs).unwrap())).unwrap();
    assert!(plane < 1e-9, "{plane}");
    // Along arcs the frame turns no more than the tangent: the angle is the holonomy of the frame with the least rotation.
    // (Five points: through four it is on a sphere, and closes.)
    let lifted =
        [[4.0, 0.0, 0.0], [2.0, 3.0, 2.0], [-2.0, 3.0, -1.0], [-4.0, 1.0, 0.5], [0.0, -3.0, 1.5]].map(Point3::from);
    let path = ArcPath::spline(&lifted, &arcs).unwrap();
    let found = turn(&QbSpline::from_arcs(&path)).unwrap();
    let closed = cyclide::curve::ClosedTwist::Leave;
    let rule = cyclide::curve::FrameRule::RotationMinimizing { start: None, closed, tolerance: 1e-9 };
    let frames = cyclide::curve::CurveFrames::new(&path, &rule).unwrap();
    let holonomy = frames.holonomy().unwrap().abs();
    assert!(found > 0.01 && (found - holonomy).abs() < 1e-7, "{found} {holonomy}");
    // An open curve, and a body that only turns, have none.
    assert!(turn(&QbSpline::through_points(&lifted, &MoebiusSplineOptions::default()).unwrap()).is_none());
    assert!(turn(&QbSpline::through_points(&lifted, &options).unwrap()).is_some());
}
