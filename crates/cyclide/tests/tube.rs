//! Tubes of changing radius: exact where they are called so, within their bound elsewhere, solids in all their forms.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use cyclide::{
    Error, Frame, Point2, Point3, Vec3,
    construct::{Ball, FairSplineOptions, Pipe, PipeEnds, RadiusLaw, Tube},
    curve::{ArcLength, ArcPath, Circle, CircleSpline, CircleSplineOptions},
    error::{PipeError, PointError},
    model::{CurveObject, Lower as _},
    surface::{ParamSurface as _, Torus, TorusSpline},
    topology::{Body, surface_joints},
};
use cyclide_testkit::attack::Random;
use std::f64::consts::{PI, TAU};

fn ball([x, y, z, r]: [f64; 4]) -> Ball {
    Ball::new(Point3::new(x, y, z), r)
}

fn volume(body: &Body) -> f64 {
    body.outer.volume() + body.voids.iter().map(|void| void.volume()).sum::<f64>()
}

/// Neighbors share their edges with the parameter, and tangent planes but at the rims of plane ends.
fn is_sewn(body: &Body, gap: f64) -> bool {
    let sewn =
        |shell| surface_joints(shell).iter().all(|joint| joint.gap < gap && (joint.angle < 1e-9 || joint.angle > 0.5));
    body.shells().all(sewn)
}

fn run() -> ArcPath {
    let points = [[0.0, 0.0, 0.0], [20.0, 0.0, 0.0], [20.0, 20.0, 5.0], [0.0, 30.0, 12.0]].map(Point3::from);
    ArcPath::rounded_polyline(&points, false, &[0.0, 6.0, 8.0, 0.0]).unwrap()
}

/// Balls at even fractions of the length of a spine, with the radii of a law.
fn balls_of_law(spine: &ArcPath, law: &RadiusLaw, count: usize) -> Vec<Ball> {
    let (length, arcs) = (spine.length(), spine.arcs());
    let ball = |k: usize| {
        let at = k as f64 / count as f64;
        let mut left = at * length;
        let mut point = arcs[arcs.len() - 1].end();
        for arc in arcs {
            if left <= arc.length() {
                point = arc.point_at_length(left / arc.length());
                break;
            }
            left -= arc.length();
        }
        Ball::new(point, law.radius(at))
    };
    (0..=count).map(ball).collect()
}

/// How far the points of all faces are from the envelope: on the ball of the chain nearest to them, within it of no other.
fn off_law(body: &Body, spine: &ArcPath, law: &RadiusLaw) -> f64 {
    let balls = balls_of_law(spine, law, 20_000);
    let mut worst = 0.0_f64;
    for face in body.outer.faces() {
        for (s, t) in [(0.2, 0.3), (0.7, 0.5), (0.5, 0.9), (0.9, 0.1)] {
            let p = face.surface.point(s, t);
            let depth = balls.iter().map(|b| p.distance(b.center) - b.radius).fold(f64::INFINITY, f64::min);
            worst = worst.max(depth.abs());
        }
    }
    worst
}

#[test]
fn tubes_far_from_the_origin_are_made() {
    for place in [0.0, 1e5, 1e6, 1e7, 1e8] {
        let balls = [[0.0, 0.0, 1.0], [5.0, 0.0, 2.0], [9.0, 3.0, 1.0]].map(|[x, y, r]| ball([place + x, y, 0.0, r]));
        assert!(Tube::through(&balls, false).unwrap().body().unwrap().is_solid(), "{place}");
    }
}

#[test]
fn cones_cylinders_and_round_ends_are_exact() {
    let cone = Tube::through(&[ball([0.0, 0.0, 0.0, 3.0]), ball([10.0, 0.0, 0.0, 1.0])], false).unwrap();
    // Rims at the contacts: sin of the half angle is 2/10.
    let (sin, cos) = (0.2_f64, (1.0_f64 - 0.04).sqrt());
    let frustum = |r0: f64, r1: f64| {
        let (a, b, h) = (r0 * cos, r1 * cos, 10.0 + (r1 - r0) * sin);
        PI * h / 3.0 * (a * a + a * b + b * b)
    };
    let cap = |r: f64, height: f64| PI * height * height * (r - height / 3.0);
    let flat = cone.body().unwrap();
    assert!(flat.is_solid() && (volume(&flat) / frustum(3.0, 1.0) - 1.0).abs() < 1e-12);
    let round = cone.clone().with_ends(PipeEnds::Round).body().unwrap();
    let caps = cap(3.0, 3.0 + 3.0 * sin) + cap(1.0, 1.0 - sin);
    assert!((volume(&round) / (frustum(3.0, 1.0) + caps) - 1.0).abs() < 1e-12);
    let open = cone.clone().with_ends(PipeEnds::Open).body().unwrap();
    assert!(!open.outer.is_closed());
    // With a wall: the difference of two cones with the same normals, and rings of cones at the ends.
    let hollow = cone.clone().with_wall(0.5).unwrap().body().unwrap();
    assert!(hollow.is_solid() && hollow.voids.is_empty());
    let closed = cone.with_wall(0.5).unwrap().with_ends(PipeEnds::Round).body().unwrap();
    assert_eq!(closed.voids.len(), 1);
    let inner = frustum(2.5, 0.5) + cap(2.5, 2.5 + 2.5 * sin) + cap(0.5, 0.5 - 0.5 * sin);
    assert!((volume(&closed) - (volume(&round) - inner)).abs() < 1e-10);
}

#[test]
fn one_radius_is_the_pipe() {
    let (spine, law) = (run(), RadiusLaw::constant(2.0).unwrap());
    let tube = Tube::along(&spine, &law, 1e-3).unwrap();
    assert!(tube.bound() <= 0.0);
    let (body, pipe) = (tube.body().unwrap(), Pipe::new(2.0).unwrap().body(&spine).unwrap());
    assert!((volume(&body) / volume(&pipe) - 1.0).abs() < 1e-12, "{} {}", volume(&body), volume(&pipe));
    let hollow = tube.with_wall(0.3).unwrap().body().unwrap();
    let pipe = Pipe::new(2.0).unwrap().with_wall(0.3).unwrap().body(&spine).unwrap();
    assert!((volume(&hollow) / volume(&pipe) - 1.0).abs() < 1e-12);
}

#[test]
fn laws_are_kept_within_the_bound() {
    let spine = run();
    let law = RadiusLaw::new(&[[0.0, 1.0], [0.4, 2.5], [1.0, 1.5]]).unwrap();
    let mut arcs = 0;
    for tolerance in [0.1, 1e-2, 1e-3, 1e-4] {
        let tube = Tube::along(&spine, &law, tolerance).unwrap();
        assert!(tube.bound() <= tolerance && tube.bound() > 0.0 && tube.arc_count() >= arcs);
        arcs = tube.arc_count();
        let body = tube.body().unwrap();
        // The samples of the law are 2.6e-3 apart.
        let off = off_law(&tube.clone().with_ends(PipeEnds::Open).body().unwrap(), &spine, &law);
        assert!(off <= tube.bound() + 1e-6, "{tolerance}: {off} {}", tube.bound());
        assert!(body.is_solid() && is_sewn(&body, 1e-12));
    }
    assert!(arcs < 400, "{arcs}");
}

#[test]
fn closed_tubes_in_space_come_round() {
    let torus = Torus::new(Frame::WORLD, 12.0, 5.0).unwrap();
    let knot = TorusSpline::knot(&torus, [2, 3], Point2::default()).unwrap();
    let (spine, _) = knot.to_arcs(1e-3).unwrap();
    let law = RadiusLaw::new(&[[0.0, 1.0], [0.3, 1.6], [0.6, 0.8], [1.0, 1.0]]).unwrap();
    let tube = Tube::along(&spine, &law, 1e-2).unwrap();
    let body = tube.body().unwrap();
    assert!(body.is_solid() && is_sewn(&body, 1e-11));
    let rope = Tube::along(&spine, &RadiusLaw::constant(1.2).unwrap(), 1e-2).unwrap().body().unwrap();
    assert!((volume(&rope) / (PI * 1.44 * spine.length()) - 1.0).abs() < 1e-9); // Pappus
}

#[test]
fn a_ring_of_balls_is_a_whole_cyclide() {
    // Four balls of a Dupin ring: centers on a circle here, radii linear in x, is a circle of balls.
    let place = |angle: f64| {
        let (x, y) = (5.0 * angle.cos(), 4.0 * angle.sin());
        ball([x, y, 0.0, 1.5 + 0.6 * angle.cos()])
    };
    // On the ellipse with half axes a, b the radius d + c x/a, c² = a² - b², keeps to one cyclide: a = 5, b = sqrt(25 - 0.36).
    let b = (25.0_f64 - 0.36).sqrt();
    let balls: Vec<Ball> = (0..8)
        .map(|k| {
            let one = place(f64::from(k) * TAU / 8.0);
            Ball::new(Point3::new(one.center.x, one.center.y * b / 4.0, 0.0), one.radius)
        })
        .collect();
    let body = Tube::through(&balls, true).unwrap().body().unwrap();
    assert!(body.is_solid());
    for face in body.outer.faces() {
        let p = face.surface.point(0.3, 0.6);
        // (x² + y² + z² - d² + b²)² = 4 (a x - c d)² + 4 b² y², the ring cyclide.
        let (a, c, d) = (5.0, 0.6, 1.5);
        let left = (p.to_vec().length_squared() - d * d + b * b).powi(2);
        let right = 4.0 * (a * p.x - c * d).powi(2) + 4.0 * b * b * p.y * p.y;
        let mirrored = 4.0 * (a * p.x + c * d).powi(2) + 4.0 * b * b * p.y * p.y;
        let off = ((left - right) / left).abs().min(((left - mirrored) / left).abs());
        assert!(off < 1e-12, "{off}");
    }
}

#[test]
fn tubes_are_similar_and_reversible() {
    let balls = [[0.0, 0.0, 0.0, 1.0], [6.0, 1.0, 0.0, 1.5], [9.0, 6.0, 3.0, 0.8], [6.0, 11.0, 4.0, 1.2]].map(ball);
    let of = |balls: &[Ball]| volume(&Tube::through(balls, false).unwrap().body().unwrap());
    let own = of(&balls);
    let reversed: Vec<Ball> = balls.iter().rev().copied().collect();
    assert!((of(&reversed) / own - 1.0).abs() < 1e-12);
    // Radii are told with those between the balls: none of the points of faces is on a larger or smaller one.
    let tube = Tube::through(&balls, false).unwrap();
    let [low, high] = tube.radii();
    assert!(low <= 0.8 && high >= 1.5 && low > 0.7 && high < 1.7, "{low} {high}");
    for scale in [1e-9, 1e9] {
        let scaled = balls.map(|b| Ball::new(Point3::ORIGIN + b.center.to_vec() * scale, b.radius * scale));
        assert!((of(&scaled) / scale.powi(3) / own - 1.0).abs() < 1e-11);
    }
}

#[test]
fn a_horn_along_a_coil_spreads_its_places() {
    // Lines of curvature of a growing coil crowd.
    let balls: Vec<Ball> = (0..60)
        .map(|k| {
            let (angle, size) = (f64::from(k) * 0.35, (f64::from(k) * 0.035).exp());
            ball([4.0 * size * angle.cos(), 4.0 * size * angle.sin(), 7.0 * size, 1.2 * size])
        })
        .collect();
    let body = Tube::through(&balls, false).unwrap().body().unwrap();
    assert!(body.is_solid() && is_sewn(&body, 1e-9));
}

#[test]
fn what_folds_meets_itself_or_swallows_is_refused() {
    let spine =
        ArcPath::new(Circle::from_radius(Point3::ORIGIN, Vec3::Z, 3.0).unwrap().to_arcs().to_vec(), true).unwrap();
    let wide = Tube::along(&spine, &RadiusLaw::constant(3.5).unwrap(), 1e-3).unwrap();
    assert_eq!(wide.body().unwrap_err().reason(), "tube-folds");
    let hairpin = [
        [0.0, 0.0, 0.0, 1.0],
        [10.0, 0.0, 0.0, 1.0],
        [13.0, 0.8, 0.0, 1.0],
        [10.0, 1.6, 0.0, 1.0],
        [0.0, 1.6, 0.0, 1.0],
    ];
    let error = Tube::through(&hairpin.map(ball), false).unwrap().body().unwrap_err();
    assert!(["pipe-meets-itself", "tube-folds"].contains(&error.reason()), "{error}");
    let corner =
        ArcPath::rounded_polyline(&[[0.0; 3], [5.0, 0.0, 0.0], [5.0, 5.0, 0.0]].map(Point3::from), false, &[0.0; 3]);
    let law = RadiusLaw::constant(0.5).unwrap();
    assert_eq!(Tube::along(&corner.unwrap(), &law, 1e-3).unwrap_err().reason(), "corner-not-mitred");
    assert_eq!(Tube::along(&spine, &law, 0.0).unwrap_err().reason(), "parameter-out-of-range");
    assert!(Tube::through(&[ball([0.0, 0.0, 0.0, f64::NAN]), ball([1.0, 0.0, 0.0, 1.0])], false).is_err());
    assert!(RadiusLaw::new(&[[0.5, 1.0], [0.5, 2.0]]).is_err() && RadiusLaw::new(&[]).is_err());
    let tube = Tube::along(&spine, &law, 1e-3).unwrap();
    assert_eq!(tube.with_wall(0.6).unwrap_err().reason(), "parameter-out-of-range");
}

/// Tubes along curves that are not of arcs are within their bound of the balls of the law along the curve itself, by its own length:
/// every point of the skin is on the envelope of these balls, but for what is between two of 40,000.
#[test]
fn tubes_along_splines_are_within_their_bound() {
    let points = [[0.0, 0.0, 0.0], [60.0, 0.0, 0.0], [95.0, 35.0, 10.0], [70.0, 75.0, 30.0], [20.0, 70.0, 45.0]];
    let points = points.map(Point3::from);
    let torus = Torus::new(Frame::WORLD, 60.0, 25.0).unwrap();
    // Flat at both ends: so it is the same along closed curves.
    let swing = RadiusLaw::new(&[[0.0, 3.0], [0.1, 3.0], [0.5, 6.0], [0.9, 3.0], [1.0, 3.0]]).unwrap();
    let curves: [CurveObject; 3] = [
        CircleSpline::fair(&points, &FairSplineOptions::default()).unwrap().into(),
        CircleSpline::from_points(&points, &CircleSplineOptions::default()).unwrap().into(),
        TorusSpline::knot(&torus, [2, 3], Point2::new(0.2, 0.1)).unwrap().into(),
    ];
    for (number, curve) in curves.iter().enumerate() {
        for (law, tolerance) in [(&swing, 0.05), (&swing, 2e-3), (&RadiusLaw::constant(3.0).unwrap(), 5e-3)] {
            let arcs = curve.lower_to_arcs(0.2 * tolerance).unwrap();
            let made = Tube::along_curve(curve.as_curve(), (&arcs.form, &arcs.correspondence), law, tolerance);
            let tube = made.unwrap_or_else(|e| panic!("{number} {tolerance}: {e}"));
            assert!(tube.bound() > 0.0 && tube.bound() <= tolerance, "{number}: {}", tube.bound());
            let places = ArcLength::new(curve.as_curve()).uniform(40_000);
            let last = places.len() - 1;
            let ball =
                |(k, t): (usize, &f64)| Ball::new(curve.as_curve().point(*t), law.radius(k as f64 / last as f64));
            let balls: Vec<Ball> = places.iter().enumerate().map(ball).collect();
            let body = tube.body().unwrap();
            for face in body.outer.faces().iter().step_by(7) {
                let p = face.surface.point(0.4, 0.6);
                let depth = balls.iter().map(|b| p.distance(b.center) - b.radius).fold(f64::INFINITY, f64::min);
                assert!(depth.abs() <= tube.bound() + 2e-5 || is_end(p, &balls), "{number} {tolerance}: {depth:e}");
            }
        }
        // Arcs that are too far off are refused, not taken for the curve.
        let coarse = curve.lower_to_arcs(0.5).unwrap();
        let parts = (&coarse.form, &coarse.correspondence);
        let error = Tube::along_curve(curve.as_curve(), parts, &swing, 1e-3).unwrap_err();
        assert_eq!(error.reason(), "not-within-tolerance");
    }
}

/// On the plane end of a tube: nearer to the first or the last center than to the skin.
fn is_end(p: Point3, balls: &[Ball]) -> bool {
    [balls.first(), balls.last()].into_iter().flatten().any(|b| p.distance(b.center) < 0.99 * b.radius)
}

/// A tube ends with a disk where its ends are not round: another part may pass the end nearer than the ball there would reach. Here the last
/// segment ends 3 away from the first one, whose radius is 2; a radius of 2 fits, with round ends it does not, and 3.1 does not at all.
#[test]
fn flat_ends_reach_as_far_as_their_disks() {
    let hook = [[0.0, 0.0, 0.0], [40.0, 0.0, 0.0], [40.0, 30.0, 0.0], [10.0, 30.0, 0.0], [10.0, 3.0, 0.0]];
    let spine = ArcPath::rounded_polyline(&hook.map(Point3::from), false, &[0.0, 5.0, 5.0, 5.0, 0.0]).unwrap();
    let body = |radius: f64, ends: PipeEnds| {
        Tube::along(&spine, &RadiusLaw::constant(radius).unwrap(), 1e-3).unwrap().with_ends(ends).body()
    };
    assert!(body(2.0, PipeEnds::Flat).unwrap().is_solid() && body(2.9, PipeEnds::Open).is_ok());
    assert_eq!(body(2.0, PipeEnds::Round).unwrap_err().reason(), "pipe-meets-itself");
    assert_eq!(body(3.1, PipeEnds::Flat).unwrap_err().reason(), "pipe-meets-itself");
    // A ring cut open: its ends face each other across a gap far below the radius.
    let ring = |gap: f64| {
        let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 20.0).unwrap();
        let angles = [0.0, 0.5, 1.0].map(|k| gap / 40.0 + k * (TAU - gap / 20.0));
        let [a, b, c] = angles.map(|angle| circle.center() + Vec3::new(angle.cos(), angle.sin(), 0.0) * 20.0);
        let spine = ArcPath::new(vec![cyclide::curve::Arc::from_three_points(a, b, c).unwrap()], false).unwrap();
        Tube::along(&spine, &RadiusLaw::constant(4.0).unwrap(), 1e-3).unwrap().body()
    };
    assert!(ring(0.5).unwrap().is_solid());
}

/// However thin a tube is, that it crosses itself is seen: its parts are proved apart or halved down to its balls. Without the crossing it is made.
#[test]
fn long_thin_tubes_that_cross_themselves_are_refused() {
    let way = |up: f64| {
        let points = [[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [100.0, 50.3, 0.0], [51.7, 50.3, up], [51.7, -50.0, up]];
        ArcPath::rounded_polyline(&points.map(Point3::from), false, &[0.0, 5.0, 5.0, 5.0, 0.0]).unwrap()
    };
    let body = |radius: f64, up: f64| {
        Tube::along(&way(up), &RadiusLaw::constant(radius).unwrap(), 1e-3 * radius).unwrap().body()
    };
    for radius in [0.5, 0.01, 2e-3, 1e-5] {
        assert_eq!(body(radius, 0.0).unwrap_err().reason(), "pipe-meets-itself", "{radius}");
        assert_eq!(body(radius, 1.9 * radius).unwrap_err().reason(), "pipe-meets-itself", "{radius}");
        assert!(body(radius, 3.0 * radius).unwrap().is_solid(), "{radius}");
    }
    // The same of two.
    let rod = |up: f64, turned: bool| {
        let points = [[-90.0, 0.0, up], [70.0, 0.0, up]];
        let points = points.map(|[x, y, z]| if turned { [y, x, z] } else { [x, y, z] });
        Tube::through(&points.map(|[x, y, z]| ball([x, y, z, 1e-5])), false).unwrap()
    };
    assert!(Tube::first_meeting(&[rod(0.0, false), rod(1.99e-5, true)]).is_some());
    assert!(Tube::first_meeting(&[rod(0.0, false), rod(2.01e-5, true)]).is_none());
}

/// Neighbors are told by the radii between: a thin end that comes back to a thick one is none, and balls of a steep cone, which overlap, are.
/// A way that crosses itself has the distance 0 from itself, however thin the tube.
#[test]
fn tubes_that_cross_themselves_are_told_where() {
    let legs = [[10.0, 0.0, 0.0], [10.0, 30.0, 0.0], [-30.0, 30.0, 0.0], [-30.0, 3.0, 0.0], [40.0, 3.0, 0.0]];
    let spine = ArcPath::rounded_polyline(&legs.map(Point3::from), false, &[0.0, 8.0, 8.0, 8.0, 0.0]).unwrap();
    for radius in [2.0, 0.1, 1e-4] {
        let tube = Tube::along(&spine, &RadiusLaw::constant(radius).unwrap(), 1e-3).unwrap();
        let error = tube.body().unwrap_err();
        let Error::Pipe(PipeError::MeetsItself { point, distance, limit, .. }) = error else { panic!("{error}") };
        assert!(distance < 1e-9 * limit && (limit - 2.0 * radius).abs() < 1e-12 * radius, "{error}");
        // The last leg crosses the first one at (10, 3, 0): steps end a billionth of a radius apart.
        assert!(Point3::from(point).distance(Point3::new(10.0, 3.0, 0.0)) < 1e-9 * radius.max(1e-3), "{error}");
    }
}

#[test]
fn thin_parts_that_run_into_thick_ones_are_refused() {
    let balls = |y: f64| {
        let back = [[25.5, 1.5], [24.0, 3.0], [20.0, y]].map(|[x, y]| [x, y, 0.0, 0.8]);
        let way = [[-20.0, 10.0], [0.0, 10.0], [10.0, 10.0], [21.0, 0.8], [24.0, 0.8]].map(|[x, r]| [x, 0.0, 0.0, r]);
        way.into_iter().chain(back).map(ball).collect::<Vec<_>>()
    };
    let error = Tube::through(&balls(3.0), false).unwrap().body().unwrap_err();
    assert_eq!(error.reason(), "pipe-meets-itself", "{error}");
    assert!(Tube::through(&balls(12.0), false).unwrap().body().is_ok());
    let cone = Tube::through(&[ball([0.0, 0.0, 0.0, 10.0]), ball([9.9, 0.0, 0.0, 0.2])], false).unwrap();
    assert!(cone.body().is_ok() && cone.with_ends(PipeEnds::Round).body().is_ok());
}

/// Random tubes with round ends against pairs of 500 balls: those that overlap meet if the integral of the length over the radius between them, the length measured with
/// the change of the radius, is more than half a turn.
#[test]
fn random_tubes_are_refused_where_their_balls_meet() {
    let mut r = Random::new(12, 1);
    let mut seen = [0; 2];
    for case in 0..60 {
        let points: Vec<Point3> =
            (0..6).map(|_| Point3::new(r.between(0.0, 12.0), r.between(0.0, 12.0), r.between(0.0, 6.0))).collect();
        let Ok(spine) = ArcPath::rounded_polyline(&points, false, &[0.0, 1.0, 1.0, 1.0, 1.0, 0.0]) else { continue };
        let size = r.pick(&[0.15, 0.4, 0.8]);
        let radii = [0.0, 0.3, 0.6, 1.0].map(|at| [at, size * r.between(0.3, 1.0)]);
        let law = RadiusLaw::new(&radii).unwrap();
        let Ok(tube) = Tube::along(&spine, &law, 1e-3 * size) else { continue };
        let balls = balls_of_law(&spine, &law, 500);
        let mut before = vec![0.0];
        for pair in balls.windows(2) {
            let (way, change) = (pair[0].center.distance(pair[1].center), pair[1].radius - pair[0].radius);
            let step = (way * way - change * change).sqrt() * 2.0 / (pair[0].radius + pair[1].radius);
            before.push(before[before.len() - 1] + step);
        }
        // How deep balls are in each other that are this far apart along the tube, as part of their radii.
        let deepest = |apart: f64| {
            let mut deepest = f64::NEG_INFINITY;
            for i in 0..balls.len() {
                for j in (0..i).filter(|j| before[i] - before[*j] > apart) {
                    let sum = balls[i].radius + balls[j].radius;
                    deepest = deepest.max(1.0 - balls[i].center.distance(balls[j].center) / sum);
                }
            }
            deepest
        };
        match tube.with_ends(PipeEnds::Round).body() {
            Ok(_) => assert!(deepest(1.03 * PI) < 2e-3, "{case}: {}", deepest(1.03 * PI)),
            Err(error) if error.reason() == "pipe-meets-itself" => {
                assert!(deepest(0.97 * PI) > -0.05, "{case}: {}", deepest(0.97 * PI));
                seen[0] += 1;
                continue;
            }
            Err(error) => assert_eq!(error.reason(), "tube-folds", "{case}: {error}"),
        }
        seen[1] += 1;
    }
    assert!(seen[0] > 5 && seen[1] > 5, "{seen:?}");
}

/// Bends that leave a tube no width are refused as such, however little they miss.
#[test]
fn bends_of_the_radius_fold() {
    let bend = [[0.0, 0.0, 0.0], [20.0, 0.0, 0.0], [20.0, 20.0, 0.0]].map(Point3::from);
    let spine = ArcPath::rounded_polyline(&bend, false, &[0.0, 5.0, 0.0]).unwrap();
    let body = |radius: f64| Tube::along(&spine, &RadiusLaw::constant(radius).unwrap(), 1e-3).unwrap().body();
    for less in [0.0, 1e-12, 1e-8] {
        assert_eq!(body(5.0 * (1.0 - less)).unwrap_err().reason(), "tube-folds", "{less}");
    }
    assert!(body(5.0 * (1.0 - 1e-4)).is_ok());
}

/// A way of 1e-8 between balls is known to as many digits as its length has beyond rounding, and their circles, as far from it as they are large, to fewer: the skin between cannot be
/// sewn, and that is what is said.
#[test]
fn balls_too_near_to_be_told_apart_are_refused_as_such() {
    let balls = [
        ball([1.7317368563446265, 2.4497117096461842, 0.061535154442694084, 0.0023592777798586437]),
        ball([1.8658253375525313, 2.349190458380712, 0.06712199898988698, 0.0023592777798586437]),
        ball([1.8658253630720556, 2.3491904381120388, 0.06712200007619842, 0.0023592777798586437]),
    ];
    let error = Tube::through(&balls, false).and_then(|tube| tube.body()).unwrap_err();
    let named = |error: &Error| match error {
        Error::Point(PointError::CoincidentPoints { first: 1, second: 2, distance, limit }) => {
            *distance < 4e-8 && distance < limit
        }
        _ => false,
    };
    assert!(named(&error), "{error}");
    let apart = [balls[0], balls[1], ball([1.87, 2.346, 0.0673, 0.0023592777798586437])];
    assert!(Tube::through(&apart, false).and_then(|tube| tube.body()).is_ok());
}

/// A knot on a torus that nearly touches its axis runs through the hole in a tiny part of its parameter: places beside which the arcs are are added there. The balls of the tube are
/// within its bound of the curve.
#[test]
fn tubes_along_curves_of_uneven_parameter_are_made() {
    let torus = Torus::new(Frame::WORLD, 40.0, 39.9).unwrap();
    let knot: CurveObject = TorusSpline::knot(&torus, [2, 3], Point2::default()).unwrap().into();
    let tolerance = 2e-4;
    let arcs = knot.lower_to_arcs(0.1 * tolerance).unwrap();
    let law = RadiusLaw::constant(0.01).unwrap();
    let tube = Tube::along_curve(knot.as_curve(), (&arcs.form, &arcs.correspondence), &law, tolerance).unwrap();
    assert!(tube.bound() > 0.0 && tube.bound() <= 0.5 * tolerance, "{}", tube.bound());
    let body = tube.body().unwrap();
    let off = |face: &cyclide::topology::ShellFace| {
        let p = face.surface.point(0.4, 0.6);
        (cyclide::curve::closest_point(knot.as_curve(), p).distance - 0.01).abs()
    };
    let worst = body.outer.faces().iter().step_by(23).map(off).fold(0.0, f64::max);
    assert!(worst <= tube.bound() + 1e-9, "{worst:e} {:e}", tube.bound());
    // The feet are right where the tolerance is a hundredth of that as well.
    let fine = knot.lower_to_arcs(1e-7).unwrap();
    assert!(Tube::along_curve(knot.as_curve(), (&fine.form, &fine.correspondence), &law, 2e-6).is_ok());
}

/// A tube that is so thin for where it is that its shape is the rounding of its coordinates is refused with what helps; moved to the origin or thicker it is made.
#[test]
fn tubes_thinner_than_the_rounding_of_their_place_are_refused_as_such() {
    let tube = |lift: f64, radius: f64| {
        let points = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 10.0, 5.0], [0.0, 20.0, 9.0]];
        let points = points.map(|[x, y, z]| Point3::new(x, y, z + lift));
        let spine = ArcPath::rounded_polyline(&points, false, &[0.0, 2.0, 2.0, 0.0]).unwrap();
        Tube::along(&spine, &RadiusLaw::constant(radius).unwrap(), 1e-3 * radius).and_then(|tube| tube.body())
    };
    let error = tube(1000.0, 1e-5).unwrap_err();
    let Error::Point(PointError::BelowRoundingOfPlace { size, place, limit, .. }) = error else { panic!("{error}") };
    assert!((size - 1e-5).abs() < 1e-18 && place > 1000.0 && limit > size, "{error}");
    assert!(tube(0.0, 1e-5).is_ok() && tube(1000.0, 1.001 * limit).is_ok());
    for (lift, radius) in [(0.0, 1e-7), (100.0, 1e-6), (1e4, 1e-4), (1e4, 1e-7)] {
        assert_eq!(tube(lift, radius).unwrap_err().reason(), "below-rounding-of-place", "{lift} {radius}");
    }
}
