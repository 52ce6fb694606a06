//! Frames along curves, stations and tight places, against closed forms, independent sums and laws.

#![allow(clippy::float_cmp, reason = "values that must agree to the bit are compared as such")]

use cyclide::{
    Aabb, CurveJet, Error, Frame, Point2, Point3, Quat, Result, Vec3,
    conformal::{Conformal, Mobius},
    construct::FairSplineOptions,
    curve::{
        Arc, ArcLength, ArcPath, Circle, CircleSpline, CircleSplineOptions, ClosedTwist, CurveFrames, FrameRule,
        ParamCurve, PieceHull, bending_energy, length, plane_normal, tight_places,
    },
    error::CurveError,
    model::CurveObject,
    rational::NurbsCurve,
    surface::{Torus, TorusSpline},
};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// A right-handed helix of this radius, rise by radian, and turns, a piece for each.
#[derive(Debug)]
struct Helix {
    radius: f64,
    rise: f64,
    turns: usize,
}

impl ParamCurve for Helix {
    fn piece_count(&self) -> usize {
        self.turns
    }
    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
        let angle = TAU * (piece as f64 + s);
        let (sin, cos) = (TAU * s).sin_cos();
        let (r, k) = (self.radius, TAU);
        CurveJet {
            point: Point3::new(r * cos, r * sin, self.rise * angle),
            d1: Vec3::new(-r * k * sin, r * k * cos, self.rise * k),
            d2: Vec3::new(-r * k * k * cos, -r * k * k * sin, 0.0),
            d3: Vec3::new(r * k * k * k * sin, -r * k * k * k * cos, 0.0),
        }
    }
    fn piece_hull(&self, _piece: usize, _tolerance: f64) -> Result<PieceHull> {
        Ok(PieceHull::closed_form())
    }
    fn is_closed(&self) -> bool {
        false
    }
    fn piece_bounds(&self, piece: usize) -> Aabb {
        let (r, k) = (self.radius, TAU * self.rise);
        Aabb { min: Point3::new(-r, -r, k * piece as f64), max: Point3::new(r, r, k * (piece + 1) as f64) }
    }
}

fn minimizing(tolerance: f64, closed: ClosedTwist) -> FrameRule {
    FrameRule::RotationMinimizing { start: None, closed, tolerance }
}

/// An angle in (-pi, pi].
fn wrapped(angle: f64) -> f64 {
    let rest = angle.rem_euclid(TAU);
    if rest > PI { rest - TAU } else { rest }
}

#[test]
fn helix_has_its_frames_in_closed_form() {
    let helix = Helix { radius: 2.0, rise: 0.7, turns: 3 };
    let square: f64 = 2.0 * 2.0 + 0.7 * 0.7;
    let (curvature, torsion) = (2.0 / square, 0.7 / square);
    let lengths = ArcLength::new(&helix);
    let frenet = CurveFrames::new(&helix, &FrameRule::Frenet).unwrap();
    let rule = FrameRule::RotationMinimizing { start: Some(-Vec3::X), closed: ClosedTwist::Leave, tolerance: 1e-9 };
    let minimal = CurveFrames::new(&helix, &rule).unwrap();
    assert!(minimal.measured_error().unwrap() <= 1e-9 && minimal.holonomy().is_none());
    for i in 0..=60 {
        let t = f64::from(i) / 60.0;
        let (angle, jet) = (TAU * 3.0 * t, helix.jet(t));
        assert!((jet.curvature().unwrap() - curvature).abs() < 1e-14);
        assert!((jet.torsion().unwrap() - torsion).abs() < 1e-13);
        let station = angle * square.sqrt();
        assert!((lengths.station(t) - station).abs() < 1e-12 * (1.0 + station), "{t}");
        let (sin, cos) = angle.sin_cos();
        let normal = Vec3::new(-cos, -sin, 0.0);
        let binormal = Vec3::new(0.7 * sin, -0.7 * cos, 2.0) / square.sqrt();
        let frame = frenet.at(t).unwrap();
        assert!((frame.normal - normal).length() < 1e-13 && (frame.binormal - binormal).length() < 1e-13);
        // The carried frame falls behind Frenet's by the torsion: its normal is N cos(τ s) - B sin(τ s).
        let behind = torsion * station;
        let expected = normal * behind.cos() - binormal * behind.sin();
        let carried = minimal.at(t).unwrap();
        assert!((carried.normal - expected).length() < 1e-10, "{t} {}", (carried.normal - expected).length());
    }
}

#[test]
fn circle_has_one_frame_all_round() {
    let circle = Circle::from_radius(Point3::new(5.0, -1.0, 2.0), Vec3::new(1.0, 2.0, 3.0), 2.0).unwrap();
    let axis = Vec3::new(1.0, 2.0, 3.0).unit().unwrap();
    let rule = FrameRule::RotationMinimizing { start: Some(axis), closed: ClosedTwist::Spread, tolerance: 1e-9 };
    let frames = CurveFrames::new(&circle, &rule).unwrap();
    // In a plane double reflection is exact.
    assert!(frames.holonomy().unwrap().abs() < 1e-13);
    for i in 0..=32 {
        let t = f64::from(i) / 32.0;
        assert!((frames.at(t).unwrap().normal - axis).length() < 1e-13);
        let frenet = CurveFrames::new(&circle, &FrameRule::Frenet).unwrap().at(t).unwrap();
        assert!((frenet.binormal - axis).length() < 1e-13);
        let to_centre = CurveFrames::new(&circle, &FrameRule::Toward(circle.center())).unwrap().at(t).unwrap();
        assert!((to_centre.normal - frenet.normal).length() < 1e-13);
        assert!((frames.lengths().station(t) - 2.0 * TAU * t).abs() < 1e-13);
    }
}

/// Along a closed curve without straight places the frame falls behind Frenet's, which closes, by the total torsion and what
/// Frenet's normal jumps by at the joints.
#[test]
fn holonomy_of_a_torus_knot_is_its_total_torsion() {
    let torus = Torus::new(Frame::WORLD, 3.0, 1.0).unwrap();
    for turns in [[2, 3], [3, 2], [1, 2], [2, -5]] {
        let knot = TorusSpline::knot(&torus, turns, Point2::new(0.1, 0.4)).unwrap();
        let frames = CurveFrames::new(&knot, &minimizing(1e-11, ClosedTwist::Leave)).unwrap();
        // The midpoint rule on each analytic piece, thousands of places: better than 1e-8.
        let n = 4000;
        let mut torsion = 0.0;
        for piece in 0..knot.piece_count() {
            for i in 0..n {
                let jet = knot.piece_jet(piece, (f64::from(i) + 0.5) / f64::from(n));
                torsion += jet.torsion().unwrap() * jet.speed() / f64::from(n);
            }
        }
        for piece in 0..knot.piece_count() {
            let (before, after) = (knot.piece_jet(piece, 1.0), knot.piece_jet((piece + 1) % knot.piece_count(), 0.0));
            let [a, b] = [before, after].map(|jet| jet.curvature_vector().unwrap());
            torsion += after.tangent().unwrap().dot(a.cross(b)).atan2(a.dot(b));
        }
        let holonomy = frames.holonomy().unwrap();
        assert!(wrapped(holonomy + torsion).abs() < 2e-6, "{turns:?} {holonomy} {torsion}");
    }
}

/// The signed solid angle of a spherical triangle (Van Oosterom and Strackee, 1983).
fn solid_angle(a: Vec3, b: Vec3, c: Vec3) -> f64 {
    2.0 * a.dot(b.cross(c)).atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
}

/// The tangents of a closed polygon, rounded by arcs or not, run along a polygon of great circles: the frame comes back turned by
/// the area that this encloses (Gauss and Bonnet).
#[test]
fn holonomy_of_a_skew_polygon_is_the_area_of_its_tangents() {
    let points =
        [[0.0, 0.0, 0.0], [6.0, 0.0, 1.0], [7.0, 5.0, -1.0], [2.0, 6.0, 3.0], [-1.0, 3.0, 2.0]].map(Point3::from);
    let ways: Vec<Vec3> = (0..5).map(|i| (points[(i + 1) % 5] - points[i]).unit().unwrap()).collect();
    let area: f64 = (1..4).map(|i| solid_angle(ways[0], ways[i], ways[i + 1])).sum();
    assert!(wrapped(area).abs() > 0.1);
    for radius in [0.0, 0.5] {
        let path = ArcPath::rounded_polyline(&points, true, &[radius; 5]).unwrap();
        let frames = CurveFrames::new(&path, &FrameRule::rotation_minimizing()).unwrap();
        assert!((wrapped(frames.holonomy().unwrap() - area)).abs() < 1e-12, "{radius}");
        // Spread, the frames close, and turn evenly.
        let spread = CurveFrames::new(&path, &minimizing(1e-9, ClosedTwist::Spread)).unwrap();
        let (first, last) = (spread.at(0.0).unwrap(), spread.at(1.0).unwrap());
        let carried = frames.at(1.0).unwrap();
        let angle = last.tangent.dot(last.normal.cross(carried.normal)).atan2(last.normal.dot(carried.normal));
        assert!(wrapped(angle - area).abs() < 1e-12);
        if radius > 0.0 {
            assert!((first.normal - last.normal).length() < 1e-12);
        }
    }
}

#[test]
fn a_curve_on_a_sphere_comes_back_without_turning() {
    // The seam of a tennis ball: x = cos, y = sin of the longitude, all on the unit sphere; made of circles it is on it exactly.
    let on_sphere = |i: i32| {
        let u = TAU * f64::from(i) / 24.0;
        let height = 0.6 * (2.0 * u).sin();
        let across = (1.0 - height * height).sqrt();
        Point3::new(across * u.cos(), across * u.sin(), height)
    };
    let points: Vec<Point3> = (0..24).map(on_sphere).collect();
    let spline = CircleSpline::fair(&points, &FairSplineOptions { closed: true, ..Default::default() }).unwrap();
    let frames = CurveFrames::new(&spline, &minimizing(1e-10, ClosedTwist::Leave)).unwrap();
    assert!((0..100).all(|i| (spline.point(f64::from(i) / 100.0).to_vec().length() - 1.0).abs() < 1e-12));
    assert!(frames.holonomy().unwrap().abs() < 1e-10);
}

fn spline_of(points: &[[f64; 3]], closed: bool) -> Option<CircleSpline> {
    let points: Vec<Point3> = points.iter().map(|p| Point3::from(*p)).collect();
    CircleSpline::from_points(&points, &CircleSplineOptions { closed, ..Default::default() }).ok()
}

/// Points along a winding way, so that curves do not turn back.
fn points() -> impl Strategy<Value = Vec<[f64; 3]>> {
    prop::collection::vec([0.5..1.5_f64, -0.7..0.7_f64, -0.7..0.7_f64], 4..9).prop_map(|steps| {
        let mut at = [0.0; 3];
        steps
            .into_iter()
            .map(|step| {
                at = [0, 1, 2].map(|k| at[k] + step[k]);
                at
            })
            .collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Right-handed, of unit vectors, and not turning about the tangent: N' has no part along B.
    #[test]
    fn carried_frames_are_frames_that_do_not_turn(points in points()) {
        let Some(spline) = spline_of(&points, false) else { return Ok(()) };
        let frames = CurveFrames::new(&spline, &FrameRule::rotation_minimizing()).unwrap();
        prop_assert!(frames.measured_error().unwrap() <= 1e-9);
        let pieces = spline.piece_count() as f64;
        for i in 0..40 {
            let t = (f64::from(i) + 0.4) / 40.0;
            let frame = frames.at(t).unwrap();
            prop_assert!((frame.tangent.cross(frame.normal) - frame.binormal).length() < 1e-14);
            prop_assert!(frame.normal.dot(frame.tangent).abs() < 1e-14 && (frame.normal.length() - 1.0).abs() < 1e-14);
            // Differences over h miss the derivative by h² N'''/6, a part of a piece at a time; the tolerance is 1e-9 over 2 h.
            let h = 1e-3 / pieces;
            if (t - h) * pieces < (t * pieces).floor() || (t + h) * pieces > (t * pieces).ceil() { continue }
            let (before, after) = (frames.at(t - h).unwrap(), frames.at(t + h).unwrap());
            let turn = (after.normal - before.normal).dot(frame.binormal) / 2e-3;
            let bend = (after.tangent - before.tangent).length() / 2e-3;
            prop_assert!(turn.abs() <= 1e-4 * (1.0 + bend.powi(3)), "{} {} {}", t, turn, bend);
        }
        // A tolerance is kept.
        let coarse = CurveFrames::new(&spline, &minimizing(1e-3, ClosedTwist::Leave)).unwrap();
        prop_assert!((coarse.at(1.0).unwrap().normal - frames.at(1.0).unwrap().normal).length() <= 1e-3);
    }

    /// Rotated, scaled and moved curves have rotated frames; curves run backwards the same normals.
    #[test]
    fn frames_follow_similarities_and_reversal(
        points in points(),
        turn in [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0],
        scale in 0.01..100.0_f64,
    ) {
        let Some(spline) = spline_of(&points, false) else { return Ok(()) };
        let q = Quat::new(1.0, turn[0], turn[1], turn[2]);
        let unit = q * (1.0 / q.norm());
        let map = Mobius::similarity(q, scale, Vec3::new(3.0, -1.0, 2.0) * scale).unwrap();
        let image = CurveObject::from(spline.clone()).transformed(&map).unwrap();
        let start = Vec3::new(0.1, 0.3, 0.9);
        let rule = |start| FrameRule::RotationMinimizing { start: Some(start), closed: ClosedTwist::Leave, tolerance: 1e-10 };
        let frames = CurveFrames::new(&spline, &rule(start)).unwrap();
        let moved = CurveFrames::new(image.as_curve(), &rule(unit.rotate(start))).unwrap();
        let backward = spline.reversed();
        let back = CurveFrames::new(&backward, &rule(frames.at(1.0).unwrap().normal)).unwrap();
        for i in 0..=10 {
            let t = f64::from(i) / 10.0;
            let frame = frames.at(t).unwrap();
            prop_assert!((moved.at(t).unwrap().normal - unit.rotate(frame.normal)).length() < 1e-9);
            prop_assert!((back.at(1.0 - t).unwrap().normal - frame.normal).length() < 1e-9);
            prop_assert!((moved.lengths().station(t) - scale * frames.lengths().station(t)).abs() <= 1e-11 * moved.lengths().total());
        }
    }

    /// Stations are the inverse of the constant-speed parameter, and what a dense sum of chords tends to.
    #[test]
    fn stations_are_lengths(points in points(), closed in any::<bool>(), fraction in 0.0..1.0_f64) {
        let Some(spline) = spline_of(&points, closed) else { return Ok(()) };
        let lengths = ArcLength::new(&spline);
        let t = lengths.parameter_at(fraction);
        prop_assert!((lengths.station(t) - fraction * lengths.total()).abs() <= 1e-10 * lengths.total());
        if t > 0.0 && t < 1.0 {
            let part = length(&spline.restricted(0.0, t).unwrap());
            prop_assert!((lengths.station(t) - part).abs() <= 1e-10 * lengths.total());
        }
        prop_assert_eq!(lengths.station(0.0), 0.0);
        prop_assert_eq!(lengths.station(1.0), lengths.total());
    }
}

/// The first axis is at the target, the normal in its plane with up and on that side, at every place and distance.
#[test]
fn frames_look_at_a_point() {
    let helix = Helix { radius: 2.0, rise: 0.7, turns: 2 };
    for (target, up) in
        [([0.3, -0.2, 5.0], [0.0, 0.0, 2.0]), ([4e6, 1.0, -3e5], [0.0, 1.0, 0.0]), ([2.1, 0.1, 0.0], [1.0, 1.0, 1.0])]
    {
        let (target, up) = (Point3::from(target), Vec3::from(up));
        let frames = CurveFrames::new(&helix, &FrameRule::LookAt { target, up }).unwrap();
        for t in [0.0, 0.21, 0.5, 0.83, 1.0] {
            let frame = frames.at(t).unwrap();
            let way = target - frame.point;
            assert!((frame.axis * way.length() - way).length() <= 1e-15 * way.length());
            assert!((frame.axis.cross(frame.normal) - frame.binormal).length() < 1e-15);
            assert!(frame.normal.dot(frame.axis).abs() < 1e-15 && frame.binormal.dot(up).abs() < 1e-15 * up.length());
            assert!(frame.normal.dot(up) > 0.0);
            let tangent = helix.jet(t).tangent().unwrap();
            assert!((frame.tangent - tangent).length() < 1e-15, "that of the curve as ever");
        }
    }
}

#[test]
fn frames_that_do_not_exist_are_refused_by_name() {
    let line = Arc::segment(Point3::ORIGIN, Point3::new(0.0, 0.0, 4.0)).unwrap();
    let reason = |rule: &FrameRule| match CurveFrames::new(&line, rule).and_then(|frames| frames.at(0.25)) {
        Err(Error::Curve(CurveError::NoFrame { what, t, .. })) => (what, t),
        other => panic!("{other:?}"),
    };
    assert_eq!(reason(&FrameRule::Frenet), ("the curvature", 0.25));
    let sine = "the sine of the angle between the direction and the first axis of the frame";
    assert_eq!(reason(&FrameRule::Up(Vec3::Z)), (sine, 0.25));
    assert_eq!(reason(&FrameRule::Toward(Point3::new(0.0, 0.0, 9.0))), (sine, 0.25));
    let along = FrameRule::RotationMinimizing { start: Some(Vec3::Z), closed: ClosedTwist::Leave, tolerance: 1e-9 };
    assert_eq!(reason(&along), (sine, 0.0));
    // By default the start is z; where that is the tangent, any direction across it.
    assert!(
        CurveFrames::new(&line, &FrameRule::rotation_minimizing()).unwrap().at(1.0).unwrap().normal.z.abs() < 1e-15
    );
    let refused = |rule: &FrameRule| CurveFrames::new(&line, rule).unwrap_err().reason();
    assert_eq!(refused(&FrameRule::Up(Vec3::ZERO)), "zero-axis");
    assert_eq!(refused(&FrameRule::Up(Vec3::new(f64::NAN, 0.0, 0.0))), "not-finite");
    let look = |target: [f64; 3], up: [f64; 3]| FrameRule::LookAt { target: target.into(), up: up.into() };
    assert_eq!(refused(&look([0.0, f64::NAN, 0.0], [0.0, 0.0, 1.0])), "not-finite");
    assert_eq!(refused(&look([0.0; 3], [0.0; 3])), "zero-axis");
    assert_eq!(reason(&look([0.0, 0.0, 1.0], [1.0, 0.0, 0.0])), ("the distance from what is looked at", 0.25));
    assert_eq!(reason(&look([0.0, 0.0, 9.0], [0.0, 0.0, 1.0])), (sine, 0.25));
    assert_eq!(refused(&FrameRule::Toward(Point3::new(f64::INFINITY, 0.0, 0.0))), "not-finite");
    assert_eq!(refused(&minimizing(0.0, ClosedTwist::Leave)), "tolerance-not-positive");
    // There and back again.
    let there = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [1.0, 0.0, 0.0]].map(Point3::from);
    let path = ArcPath::rounded_polyline(&there, false, &[0.0; 3]).unwrap();
    let error = CurveFrames::new(&path, &FrameRule::rotation_minimizing()).unwrap_err();
    assert!(matches!(error, Error::Curve(CurveError::NoFrame { t, .. }) if t == 0.5), "{error:?}");
}

#[test]
fn tight_places_are_named_by_station() {
    // A rectangle of 10 by 6 with corners of radius 1, 2, 1 and none.
    let corners = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 6.0, 0.0], [0.0, 6.0, 0.0]].map(Point3::from);
    let path = ArcPath::rounded_polyline(&corners, true, &[1.0, 2.0, 1.0, 0.0]).unwrap();
    let total = length(&path);
    let places = tight_places(&path, 1.5).unwrap();
    let found: Vec<f64> = places.iter().map(|place| place.radius).collect();
    assert_eq!(found.len(), 3);
    assert!(
        (found[0] - 1.0).abs() < 1e-12 && found[1] == 0.0 && (found[2] - 1.0).abs() < 1e-12 || found.contains(&0.0)
    );
    let sharp = places.iter().find(|place| place.radius == 0.0).unwrap();
    assert!(sharp.point.distance(corners[3]) < 1e-12 && sharp.from == sharp.to);
    assert!(places.iter().all(|place| (0.0..=total).contains(&place.station)));
    // Arcs of just the radius are not tighter than it.
    assert_eq!(tight_places(&path, 1.0).unwrap().len(), 1);
    assert_eq!(tight_places(&path, 2.5).unwrap().len(), 4);
    assert_eq!(tight_places(&path, -1.0).unwrap_err().reason(), "radius-not-positive");
    // An ellipse-like closed curve is tight at its two ends, where it starts and half way round: one part passes the start.
    let around = |i: i32| {
        let (sin, cos) = (TAU * f64::from(i) / 40.0).sin_cos();
        Point3::new(4.0 * cos, sin, 0.0)
    };
    let points: Vec<Point3> = (0..40).map(around).collect();
    let oval = CircleSpline::fair(&points, &FairSplineOptions { closed: true, ..Default::default() }).unwrap();
    let places = tight_places(&oval, 1.0).unwrap();
    assert_eq!(places.len(), 2);
    let passes = places.iter().find(|place| place.from > place.to).unwrap();
    // The radius of an ellipse at its end is b²/a; the spline through 40 points is within a few per cent.
    assert!((passes.radius - 0.25).abs() < 0.02 && passes.point.distance(points[0]) < 1e-3);
    let all_round = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0).unwrap();
    let places = tight_places(&all_round, 2.0).unwrap();
    assert!(places.len() == 1 && places[0].from == 0.0 && (places[0].to - TAU).abs() < 1e-14);
}

#[test]
fn plane_normals_are_up_or_the_largest_coordinate_positive() {
    let circle = |normal: Vec3| Circle::from_radius(Point3::new(1.0, 2.0, 3.0), normal, 1.0).unwrap();
    for normal in [Vec3::Z, -Vec3::Z] {
        assert!((plane_normal(&circle(normal)).unwrap() - Vec3::Z).length() < 1e-12);
    }
    let tilted = Vec3::new(0.9, -0.3, 0.1).unit().unwrap();
    assert!((plane_normal(&circle(-tilted)).unwrap() - tilted).length() < 1e-12);
    let line = Arc::segment(Point3::ORIGIN, Point3::new(1.0, 1.0, 0.0)).unwrap();
    assert_eq!(plane_normal(&line), Some(Vec3::Z));
    assert_eq!(plane_normal(&Helix { radius: 1.0, rise: 1.0, turns: 1 }), None);
    // A curve that turns right has a negative curvature.
    let right = CurveObject::from(circle(-Vec3::Z));
    let jet = right.as_curve().jet(0.3);
    assert!((jet.signed_curvature(plane_normal(right.as_curve()).unwrap()).unwrap() + 1.0).abs() < 1e-12);
}

#[test]
fn bending_energy_is_curvature_squared_by_length() {
    let helix = Helix { radius: 2.0, rise: 0.7, turns: 3 };
    let square: f64 = 2.0 * 2.0 + 0.7 * 0.7;
    let expected = (2.0 / square).powi(2) * 3.0 * TAU * square.sqrt();
    assert!((bending_energy(&helix) / expected - 1.0).abs() < 1e-12);
    // A parabola y = x²/2 over [-1, 1]: ∫ (1 + x²)^(-5/2) dx = x (2 x² + 3)/(3 (1 + x²)^(3/2)).
    let points = [[-1.0, 0.5, 0.0], [0.0, -0.5, 0.0], [1.0, 0.5, 0.0]].map(Point3::from).to_vec();
    let parabola = NurbsCurve::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], points, vec![1.0; 3]).unwrap();
    assert!((bending_energy(&parabola) - 2.0 * 5.0 / (3.0 * 8.0_f64.sqrt())).abs() < 1e-12);
    // Half the size, twice the energy; corners are not counted, cusps have no bound.
    let half = parabola.transformed(&Mobius::similarity(Quat::ONE, 0.5, Vec3::ZERO).unwrap()).unwrap();
    assert!((bending_energy(&half) - 2.0 * bending_energy(&parabola)).abs() < 1e-12);
    let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
    let sharp = ArcPath::rounded_polyline(&corner, false, &[0.0; 3]).unwrap();
    assert_eq!(bending_energy(&sharp), 0.0);
    let cusp = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]].map(Point3::from).to_vec();
    let cusp = NurbsCurve::new(3, vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0], cusp, vec![1.0; 4]).unwrap();
    // Control points of a loop that has shrunk to a point: the velocity vanishes in the middle.
    assert_eq!(bending_energy(&cusp), f64::INFINITY);
}

/// A place that is one that was kept, to rounding, is no step: the chord between both has no direction.
#[test]
fn frames_do_not_turn_over_where_they_were_kept() {
    let points = [
        [0.5, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.709679388155657, 0.0, 0.17961477411890797],
        [2.3812294630917608, 0.5650413501529301, 0.6257053936322099],
        [2.8812294630917608, 0.5650413501529301, 0.6257053936322099],
        [3.418478663953235, 0.5650413501529301, 0.6257053936322099],
    ];
    let spline = spline_of(&points, false).unwrap();
    let frames = CurveFrames::new(&spline, &FrameRule::rotation_minimizing()).unwrap();
    // Fractions of 2 and of 10, of which many are kept, and their neighbors.
    for i in 0..=1280 {
        for t in [f64::from(i) / 1280.0, f64::from(i) / 1280.0 + 1e-15, f64::from(i) / 1280.0 - 1e-15] {
            let [frame, near] = [t, t - 1e-6].map(|t| frames.at(t).unwrap());
            // The curve turns by less than 20 in a unit of the parameter.
            assert!((frame.normal - near.normal).length() < 2e-5, "{t}");
        }
    }
}
