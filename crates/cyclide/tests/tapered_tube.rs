//! Tubes of circles across their spine: they end where it does, in planes across it, with the radii asked for.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use cyclide::{
    Error, Point3,
    construct::{PipeEnds, RadiusLaw, TaperedTube},
    curve::{ArcPath, ParamCurve as _},
    surface::ParamSurface as _,
    topology::{Body, surface_joints},
};
use cyclide_testkit::attack::Random;
use std::f64::consts::PI;

fn volume(body: &Body) -> f64 {
    body.outer.volume() + body.voids.iter().map(|void| void.volume()).sum::<f64>()
}

fn path(points: &[[f64; 3]], radius: f64, closed: bool) -> ArcPath {
    let points: Vec<Point3> = points.iter().copied().map(Point3::from).collect();
    let mut radii = vec![radius; points.len()];
    if !closed {
        (radii[0], radii[points.len() - 1]) = (0.0, 0.0);
    }
    ArcPath::rounded_polyline(&points, closed, &radii).unwrap()
}

fn law(radii: &[f64]) -> RadiusLaw {
    let steps = (radii.len() - 1) as f64;
    let values: Vec<[f64; 2]> = radii.iter().enumerate().map(|(k, r)| [k as f64 / steps, *r]).collect();
    RadiusLaw::new(&values).unwrap()
}

/// Area of the circles over the length: by Pappus the volume, as the middle of each circle is on the spine.
fn pappus(law: &RadiusLaw, length: f64, less: f64) -> f64 {
    let n = 4_000;
    let area = |k: usize| PI * (law.radius((k as f64 + 0.5) / n as f64) - less).powi(2);
    (0..n).map(area).sum::<f64>() * length / n as f64
}

#[test]
fn a_straight_tube_of_linear_radius_is_the_frustum() {
    let line = path(&[[3.0, -2.0, 0.0], [3.0, -2.0, 100.0]], 0.0, false);
    let tube = TaperedTube::along(&line, &law(&[60.0, 30.0]), 1e-3).unwrap();
    let frustum = |a: f64, b: f64| PI / 3.0 * 100.0 * (a * a + a * b + b * b);
    assert_eq!((tube.bound(), tube.radii()), (0.0, [30.0, 60.0]));
    let solid = tube.body().unwrap();
    assert!((volume(&solid) / frustum(60.0, 30.0) - 1.0).abs() < 1e-12);
    let hollow = tube.clone().with_wall(3.0).unwrap().body().unwrap();
    assert!((volume(&hollow) / (frustum(60.0, 30.0) - frustum(57.0, 27.0)) - 1.0).abs() < 1e-12);
    for body in [&solid, &hollow] {
        assert!(body.is_solid());
        let bounds = body.outer.bounds();
        assert!(bounds.min.z.abs() < 1e-12 && (bounds.max.z - 100.0).abs() < 1e-12, "{bounds:?}");
    }
    // However fast it changes: a funnel of 500 to 10 over 100.
    let funnel = TaperedTube::along(&line, &law(&[500.0, 10.0]), 1e-3).unwrap().body().unwrap();
    assert!((volume(&funnel) / frustum(500.0, 10.0) - 1.0).abs() < 1e-12);
    // A round end goes on with the slope, over the ball that touches the cone in its rim.
    let round = tube.with_ends(PipeEnds::Round).body().unwrap();
    assert!(surface_joints(&round.outer).iter().all(|joint| joint.angle < 1e-9));
}

#[test]
fn a_hundred_bent_tubes_end_in_planes_across_their_path() {
    let mut random = Random::new(37, 0);
    let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
    let mut made = 0;
    for case in 0..100 {
        let mut points = vec![[0.0, 0.0, 0.0]];
        for k in 0..3 {
            let [x, y, z] = points[k];
            points.push([x + number(30.0, 80.0), y + number(-60.0, 60.0), z + number(-40.0, 40.0)]);
        }
        let path = path(&points, number(8.0, 12.0), false);
        let radii: Vec<f64> = (0..2 + case % 3).map(|_| number(1.0, 7.5)).collect();
        let law = law(&radii);
        let tolerance = 1e-3;
        let tube = TaperedTube::along(&path, &law, tolerance).unwrap();
        assert!(tube.bound() <= tolerance);
        let wall = 0.4 * radii.iter().copied().fold(f64::INFINITY, f64::min);
        let hollow = tube.clone().with_wall(wall).unwrap();
        let (solid, hollow) = match (tube.body(), hollow.body()) {
            (Ok(solid), Ok(hollow)) => (solid, hollow),
            (Err(error), _) | (_, Err(error)) => {
                assert_eq!(error.reason(), "pipe-meets-itself", "{error}");
                continue;
            }
        };
        made += 1;
        let length = path.length();
        assert!(solid.is_solid());
        for (body, less) in [(&solid, 0.0), (&hollow, wall)] {
            assert!(body.is_solid());
            let wanted = pappus(&law, length, 0.0) - if less > 0.0 { pappus(&law, length, less) } else { 0.0 };
            // The area of the skins times the bound, and the sum's own error.
            let allowed = tolerance * body.outer.area() + 1e-6 * wanted;
            assert!((volume(body) - wanted).abs() < allowed, "{case}: {} {wanted}", volume(body));
        }
        // The circles at the ends, in planes across the path, with the radii asked for.
        let ends = [(path.arcs()[0].start(), path.arcs()[0].start_tangent().unwrap(), radii[0], -1.0), {
            let last = &path.arcs()[path.arcs().len() - 1];
            (last.end(), last.end_tangent().unwrap(), radii[radii.len() - 1], 1.0)
        }];
        for (center, axis, radius, side) in ends {
            let rim = solid.outer.vertices().iter().filter(|p| (**p - center).dot(axis).abs() < 1e-9);
            let rim: Vec<f64> = rim.map(|p| p.distance(center)).filter(|r| *r > 0.1).collect();
            assert!(
                rim.len() >= 4 && rim.iter().filter(|r| (**r - radius).abs() < 1e-9).count() == 4,
                "{case}: {rim:?}"
            );
            // Nothing beyond the plane near the end.
            for face in solid.outer.faces() {
                for (s, t) in [(0.0, 0.0), (0.5, 0.5), (0.3, 1.0), (1.0, 0.7)] {
                    let way = face.surface.point(s, t) - center;
                    assert!(way.length() > 8.0 || way.dot(axis) * side < 1e-9, "{case}");
                }
            }
        }
        // Points of the skin are the radius of the law away from the nearest point of the path.
        for face in solid.outer.faces().iter().take(4 * tube.piece_count()) {
            for (s, t) in [(0.2, 0.3), (0.7, 0.5), (0.5, 0.9)] {
                let p = face.surface.point(s, t);
                let nearest = path.closest_point(p);
                let at = length_before(&path, nearest.t) / length;
                if at > 0.0 && at < 1.0 && nearest.distance > 0.0 {
                    let off = nearest.distance - law.radius(at);
                    assert!(off < tolerance + 1e-9, "{case}: {off}");
                }
            }
        }
    }
    assert!(made > 60, "{made}");
}

fn length_before(path: &ArcPath, t: f64) -> f64 {
    let n = path.arcs().len() as f64;
    let piece = ((t * n).floor() as usize).min(path.arcs().len() - 1);
    path.arcs()[..piece].iter().map(|arc| arc.length()).sum::<f64>()
        + path.arcs()[piece].length_to(t * n - piece as f64)
}

#[test]
fn closed_tubes_come_round() {
    let knot = path(&[[0.0, 0.0, 0.0], [60.0, 0.0, 20.0], [60.0, 40.0, 0.0], [0.0, 40.0, 30.0]], 12.0, true);
    assert!(knot.is_closed());
    // Its slopes at both ends are 0, closed or not.
    let law = law(&[4.0, 4.0, 6.0, 6.0, 4.0, 4.0]);
    let tube = TaperedTube::along(&knot, &law, 1e-5).unwrap();
    let body = tube.clone().body().unwrap();
    assert!(body.is_solid() && (volume(&body) / pappus(&law, knot.length(), 0.0) - 1.0).abs() < 1e-5);
    // Where the curvature of the path jumps and the radius changes, faces meet in an angle (docs/math/tubes.md): arcs of 12, radii of up to 6.
    let slope =
        |k: i32| (law.radius(1e-3 * f64::from(k + 1)) - law.radius(1e-3 * f64::from(k))) / (1e-3 * knot.length());
    let steepest = (0..1000).map(slope).fold(0.0, f64::max);
    let crease = (steepest / (1.0 - 6.0 / 12.0)).atan() - steepest.atan();
    assert!(surface_joints(&body.outer).iter().all(|joint| joint.gap < 1e-10 && joint.angle < 1.01 * crease));
    // An even radius has none.
    let even =
        TaperedTube::along(&knot, &RadiusLaw::new(&[[0.0, 4.0], [1.0, 4.0]]).unwrap(), 1e-5).unwrap().body().unwrap();
    assert!(surface_joints(&even.outer).iter().all(|joint| joint.gap < 1e-10 && joint.angle < 1e-8));
    let hollow = tube.with_wall(1.0).unwrap().body().unwrap();
    assert_eq!(hollow.voids.len(), 1);
}

#[test]
fn what_folds_or_meets_itself_is_refused() {
    let bend = path(&[[0.0, 0.0, 0.0], [40.0, 0.0, 0.0], [40.0, 40.0, 0.0]], 8.0, false);
    let reason = |made: Result<Body, Error>| made.map(|_| ()).unwrap_err().reason();
    assert_eq!(
        reason(TaperedTube::along(&bend, &law(&[4.0, 12.0, 4.0]), 1e-3).and_then(|tube| tube.body())),
        "tube-folds"
    );
    // There and back with 12 between: the radii are 5 to 7.
    let hairpin = path(&[[0.0, 0.0, 0.0], [60.0, 0.0, 0.0], [60.0, 12.0, 0.0], [0.0, 12.0, 0.0]], 5.9, false);
    let made = |radii: &[f64]| TaperedTube::along(&hairpin, &law(radii), 1e-3).and_then(|tube| tube.body());
    assert!(made(&[5.0, 5.5, 5.0]).is_ok());
    assert_eq!(reason(made(&[7.0, 5.0, 7.0])), "pipe-meets-itself");
    // Touching cones, and such as cross by a hair.
    assert!(made(&[5.99, 5.0, 5.99]).is_ok());
    assert_eq!(reason(made(&[6.1, 5.0, 6.1])), "pipe-meets-itself");
}

/// Where the spine crosses itself no thinner tube helps, and that is said; the first disks that meet are somewhere else.
#[test]
fn a_spine_that_crosses_itself_is_to_be_moved_apart() {
    let spine = |up: f64| {
        let points = [[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [100.0, 50.0, 0.0], [40.0, 50.0, up], [60.0, -50.0, up]];
        path(&points, 8.0, false)
    };
    let body =
        |up: f64, wide: f64| TaperedTube::along(&spine(up), &law(&[wide, 0.5 * wide]), 1e-3).and_then(|t| t.body());
    for wide in [4.0, 0.1] {
        let error = body(0.0, wide).map(|_| ()).unwrap_err().to_string();
        assert!(error.contains("they cross: move the curve apart") && !error.contains("thinner"), "{error}");
    }
    assert!(body(20.0, 4.0).is_ok());
}
