//! Rolling balls and canal surfaces: every ball touches what it should, every patch is the envelope of its balls.

use cyclide::{
    Frame, Point2, Point3, Vec3,
    construct::TorusSplineOptions,
    surface::{
        CanalPatch, CircleFamily, NaturalQuadric, QuadricPair, QuarticType, RollingBall, SkewCylinders, Torus,
        TorusSpline,
    },
};
use cyclide_testkit::attack::Random;

/// Distance of a point from a line through a point along a unit vector.
fn off_axis(p: Point3, origin: Point3, axis: Vec3) -> f64 {
    let way = p - origin;
    (way - axis * way.dot(axis)).length()
}

/// How far a ball is from touching two cylinders of these radii, with axes at this angle, from outside, and its contacts from lying on both.
fn faults(ball: &RollingBall, [r1, r2]: [f64; 2], h: f64, angle: f64) -> f64 {
    let second = Vec3::new(angle.cos(), angle.sin(), 0.0);
    let axes = [(Point3::new(0.0, 0.0, -h), Vec3::X, r1), (Point3::new(0.0, 0.0, h), second, r2)];
    let fault = |i: usize| {
        let (origin, axis, r) = axes[i];
        let apart = (off_axis(ball.center, origin, axis) - (r + ball.radius)).abs();
        let off = (off_axis(ball.contacts[i], origin, axis) - r.abs()).abs();
        let across = ball.contacts[i].distance(ball.center - ball.normals[i] * ball.radius);
        apart.max(off).max(across)
    };
    fault(0).max(fault(1))
}

#[test]
fn balls_touch_both_cylinders() {
    let mut rng = Random::new(7, 0);
    for _ in 0..500 {
        let (r1, r2) = (rng.between(0.2, 2.0), rng.between(0.2, 2.0));
        let h = 0.5 * (r1 - r2).abs() + rng.between(0.01, 2.0);
        let upright = SkewCylinders::new([r1, r2], h).unwrap();
        let angle = if rng.chance(0.3) { upright.angle() } else { rng.between(0.2, 2.9) };
        let pair = upright.with_angle(angle).unwrap();
        let a = rng.between(-1.4, 1.4);
        let b = a.abs() + rng.between(0.05, 0.95) * (std::f64::consts::PI - 2.0 * a.abs());
        let ball = pair.ball(Point2::new(a, b)).unwrap();
        let size = 1.0 + ball.center.to_vec().length() + ball.radius.abs();
        assert!(faults(&ball, [r1, r2], h, angle) < 1e-13 * size / angle.sin(), "{r1} {r2} {h} {angle} {a} {b}");
        // The normals lead back to the place.
        let back = pair.place_of_normals(ball.normals);
        assert!((back - Point2::new(a, b)).length() < 1e-12, "{a} {b} {back:?}");
        // Exchange of the cylinders: (A, B) becomes (pi/2 - B, pi/2 - A).
        let half = std::f64::consts::FRAC_PI_2;
        let swapped = SkewCylinders::new([r2, r1], h).unwrap().with_angle(angle).unwrap();
        let other = swapped.ball(Point2::new(half - b, half - a)).unwrap();
        assert!((other.radius - ball.radius).abs() < 1e-12 * size);
        // A half turn about the common normal: A becomes -A, B becomes pi - B. The radius is that of either mirror too.
        let turned = pair.ball(Point2::new(-a, 2.0 * half - b)).unwrap();
        let Point3 { x, y, z } = ball.center;
        assert!(turned.center.distance(Point3::new(-x, -y, z)) < 1e-12 * size / angle.sin());
        let mirrored = pair.ball(Point2::new(-a, b)).unwrap();
        assert!((mirrored.radius - ball.radius).abs() < 1e-12 * size);
    }
}

/// The envelope condition `(x - m)·m' + R R' = 0`, relative to the speed, by differences of the ball.
fn off_envelope(patch: &CanalPatch, s: f64, t: f64) -> f64 {
    let step = 1e-5;
    let ([m0, m1], [r0, r1]) = {
        let [a, b] = [patch.ball(s - step), patch.ball(s + step)];
        ([a.0, b.0], [a.1, b.1])
    };
    let (m, r) = patch.ball(s);
    let (motion, growth) = ((m1 - m0) / (2.0 * step), (r1 - r0) / (2.0 * step));
    ((patch.point(s, t) - m).dot(motion) + r * growth).abs() / (motion.length() * r.abs())
}

#[test]
fn patches_of_all_types_are_envelopes() {
    let mut rng = Random::new(11, 0);
    let mut parts = 0;
    for kind in QuarticType::ALL {
        for _ in 0..10 {
            let (r1, r2) = (rng.between(0.4, 1.5), rng.between(0.4, 1.5));
            let h = 0.5 * (r1 + r2) + rng.between(0.1, 1.0);
            let upright = SkewCylinders::new([r1, r2], h).unwrap();
            let angle = if rng.chance(0.3) { upright.angle() } else { rng.between(0.3, 2.8) };
            let pair = upright.with_angle(angle).unwrap();
            // About the middle of the diamond.
            let center = kind.local(cyclide::Vec2::new(rng.between(-0.2, 0.2), 1.57 + rng.between(-0.2, 0.2)));
            let ends = center.map(|x| {
                let d = rng.between(0.05, 0.25);
                [x - d, x + d].map(|x| [x.cos(), x.sin()])
            });
            let patch = CanalPatch::between_skew_cylinders(&pair, kind, ends).unwrap();
            for k in 1..8 {
                let s = f64::from(k) / 8.0;
                for t in [0.0, 0.3, 1.0] {
                    assert!(off_envelope(&patch, s, t) < 1e-8, "{kind:?} {angle}");
                }
            }
            let families = kind.families().map(CircleFamily::index);
            let degree = patch.to_rational().unwrap().degrees();
            assert_eq!(degree, [if families == [0, 3] { 14 } else { 12 }, 2]);
            for cyclide::surface::CanalPart { surface, s, t } in patch.rational_parts().unwrap() {
                assert!(surface.has_positive_weights());
                parts += 1;
                let (x, y) = (0.37, 0.61);
                let p = patch.point(s[0] + x * (s[1] - s[0]), t[0] + y * (t[1] - t[0]));
                assert!(surface.point(x, y).distance(p) < 1e-11 * (1.0 + p.to_vec().length()));
            }
        }
    }
    assert!(parts < 4 * 60);
}

#[test]
fn patches_along_a_spline_join_smoothly() {
    let pair = SkewCylinders::new([1.0, 1.5], 1.6).unwrap();
    // The plane of any torus serves: places are all that counts.
    let torus = Torus::new(Frame::WORLD, 2.0, 1.0).unwrap();
    let places: Vec<Point2> = (0..8).map(|k| pair.place_of_radius(0.8, 0.785 * f64::from(k)).unwrap()).collect();
    let spline =
        TorusSpline::through_places(&torus, &places, &TorusSplineOptions { closed: true, ..Default::default() });
    let spline = spline.unwrap();
    let patches: Vec<CanalPatch> =
        spline.pieces().iter().map(|piece| CanalPatch::along(&pair, piece).unwrap()).collect();
    for (patch, next) in patches.iter().zip(patches.iter().cycle().skip(1)) {
        let (end, start) = (patch.characteristic_circle(1.0), next.characteristic_circle(0.0));
        assert!(end.center.distance(start.center) < 1e-12 && (end.axis - start.axis).length() < 1e-11);
        assert!(end.contacts[0].distance(start.contacts[0]) < 1e-12);
    }
}

#[test]
fn balls_touch_cylinders_and_cones_in_any_position() {
    let mut rng = Random::new(3, 0);
    let direction =
        |rng: &mut Random| Vec3::new(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0), rng.between(-1.0, 1.0));
    let (mut timelike, mut touched) = (0, 0);
    for case in 0..200 {
        let mut surface = || {
            let origin = Point3::ORIGIN + direction(&mut rng) * 2.0;
            let axis = direction(&mut rng);
            if rng.between(0.0, 1.0) < 0.5 {
                NaturalQuadric::cylinder(origin, axis, rng.between(0.2, 1.0)).unwrap()
            } else {
                NaturalQuadric::cone(origin, axis, rng.between(0.1, 1.2)).unwrap()
            }
        };
        let pair = QuadricPair::new([surface(), surface()]).unwrap();
        for k in 0..8 {
            let place = Point2::new(0.3 + 0.7 * f64::from(k), 1.0 + 1.3 * f64::from(k));
            match pair.ball(place) {
                Ok(ball) => {
                    touched += 1;
                    for (i, surface) in pair.surfaces().iter().enumerate() {
                        let p = ball.contacts[i];
                        let (height, off) =
                            ((p - surface.origin()).dot(surface.axis()), off_axis(p, surface.origin(), surface.axis()));
                        let want = surface.radius() + (height * surface.half_angle().tan()).abs();
                        let size = 1.0 + ball.center.to_vec().length() + ball.radius.abs();
                        // The inverse of the forms of a random pair loses some digits.
                        assert!((off - want).abs() < 1e-9 * size, "{case} {k}: {off} {want}");
                    }
                }
                Err(error) => {
                    assert!(["wrong-side", "not-timelike-pair", "sphere-at-infinity"].contains(&error.reason()))
                }
            }
        }
        timelike += usize::from(pair.kind() == cyclide::surface::PairKind::Timelike);
    }
    assert!(timelike > 40 && touched > 100, "{timelike} {touched}");
}

#[test]
fn perpendicular_cylinders_are_a_pair() {
    let (r1, r2, h) = (0.8, 1.3, 1.5);
    let pair = QuadricPair::new([
        NaturalQuadric::cylinder(Point3::new(5.0, 0.0, -h), Vec3::X, r1).unwrap(),
        NaturalQuadric::cylinder(Point3::new(0.0, -7.0, h), Vec3::Y, r2).unwrap(),
    ])
    .unwrap();
    let ball = pair.ball(Point2::new(0.2, 1.3)).unwrap();
    assert!(faults(&ball, [r1, r2], h, std::f64::consts::FRAC_PI_2) < 1e-12);
}

/// How far a point is outside a cylinder, or a nappe of a cone, and the outer normal of that beside it.
fn outside(surface: &NaturalQuadric, p: Point3) -> (f64, Vec3) {
    let (way, (sin, cos)) = (p - surface.origin(), surface.half_angle().sin_cos());
    let height = way.dot(surface.axis());
    let across = way - surface.axis() * height;
    let normal = across.unit().unwrap_or_default() * cos - surface.axis() * sin;
    ((across.length() - surface.radius()) * cos - height * sin, normal)
}

#[test]
fn strips_between_cylinders_and_cones_are_envelopes_of_balls_that_touch_both() {
    let mut rng = Random::new(5, 0);
    let direction =
        |rng: &mut Random| Vec3::new(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0), rng.between(-1.0, 1.0));
    let torus = Torus::new(Frame::WORLD, 2.0, 1.0).unwrap();
    let options = TorusSplineOptions { closed: true, ..Default::default() };
    let (mut strips, mut cones, mut patches, mut inside) = (0, 0, 0, 0);
    // In parts of the size: balls off both surfaces, contacts, normals, points off their circle, joints.
    let mut worst = [0.0_f64; 5];
    for _ in 0..450 {
        let mut surface = |part: f64| {
            let (origin, axis) = (Point3::ORIGIN + direction(&mut rng) * 2.0, direction(&mut rng));
            if rng.chance(part) {
                NaturalQuadric::cone(origin, axis, rng.between(0.05, 0.6)).unwrap()
            } else {
                NaturalQuadric::cylinder(origin, axis, rng.between(0.2, 1.0)).unwrap()
            }
        };
        let pair = QuadricPair::new([surface(0.5), surface(0.8)]).unwrap();
        // Spacelike pairs, and cones that overlap without end.
        let least = match pair.smallest_radius() {
            Ok(least) => least,
            Err(error) => {
                let timelike = pair.kind() == cyclide::surface::PairKind::Timelike;
                assert_eq!(error.reason(), if timelike { "sphere-at-infinity" } else { "not-timelike-pair" });
                continue;
            }
        };
        let radius = least + rng.between(0.05, 1.0);
        let Ok(places) =
            (0..24).map(|k| pair.place_of_radius(radius, 0.2618 * f64::from(k))).collect::<Result<Vec<_>, _>>()
        else {
            continue;
        };
        // Balls of large radius touch beyond the apex, where the other nappe is; loops of nearly parallel lines go far out.
        let on_nappe = |place: &Point2| {
            let ball = pair.ball(*place).unwrap();
            if ball.center.to_vec().length() > 50.0 {
                return false;
            }
            let height = |k: usize| (ball.contacts[k] - pair.surfaces()[k].origin()).dot(pair.surfaces()[k].axis());
            (0..2).all(|k| pair.surfaces()[k].half_angle() == 0.0 || height(k) > 0.1)
        };
        if !places.iter().all(on_nappe) {
            continue;
        }
        strips += 1;
        inside += usize::from(radius < 0.0);
        cones += pair.surfaces().iter().filter(|surface| surface.half_angle() > 0.0).count();
        let spline = TorusSpline::through_places(&torus, &places, &options).unwrap();
        let strip: Vec<CanalPatch> =
            spline.pieces().iter().map(|piece| CanalPatch::between_quadrics(&pair, piece).unwrap()).collect();
        for (patch, next) in strip.iter().zip(strip.iter().cycle().skip(1)) {
            patches += 1;
            let size = 1.0 + patch.ball(0.5).0.to_vec().length() + patch.ball(0.5).1.abs();
            for s in [0.0, 0.3, 0.8] {
                let ((center, r), circle) = (patch.ball(s), patch.characteristic_circle(s));
                for (k, surface) in pair.surfaces().iter().enumerate() {
                    let (off, normal) = outside(surface, center);
                    worst[0] = worst[0].max((off - r).abs() / size);
                    let contact = patch.point(s, k as f64);
                    worst[1] = worst[1].max(outside(surface, contact).0.abs() / size);
                    worst[2] = worst[2].max((patch.unit_normal(s, k as f64) - normal).length());
                }
                for t in [0.25, 0.6, 1.0] {
                    let way = patch.point(s, t) - circle.center;
                    worst[3] =
                        worst[3].max((way.length() - circle.radius).abs().max(way.dot(circle.axis).abs()) / size);
                }
            }
            let (end, start) = (patch.characteristic_circle(1.0), next.characteristic_circle(0.0));
            worst[4] = worst[4].max(end.center.distance(start.center) / size).max((end.axis - start.axis).length());
            let rational = patch.rational_parts().unwrap();
            assert!(rational.iter().all(|part| part.surface.has_positive_weights()));
            assert!(rational.iter().all(|part| part.surface.degrees()[0] <= 14));
        }
    }
    assert!(strips > 60 && cones > 60 && inside > 3 && patches < 80 * strips, "{strips} {cones} {inside} {patches}");
    // Some hundred roundings; the way that a ball takes at a joint is known as well as the length of its piece.
    assert!(worst[..4].iter().all(|off| *off < 1e-12) && worst[4] < 1e-10, "{worst:?}");
}

#[test]
fn kinds_without_a_strip_have_their_names() {
    let pipe = NaturalQuadric::cylinder(Point3::ORIGIN, Vec3::X, 2.0).unwrap();
    // A cone that enters the pipe.
    let branch = NaturalQuadric::cone(Point3::new(0.0, 0.0, 9.0), -Vec3::Z, 0.1).unwrap();
    let pair = QuadricPair::new([pipe, branch]).unwrap();
    assert_eq!(pair.kind(), cyclide::surface::PairKind::Spacelike);
    let reasons = [pair.smallest_radius().map(|_| ()), pair.place_of_radius(0.5, 0.0).map(|_| ())];
    assert!(reasons.iter().all(|result| result.as_ref().unwrap_err().reason() == "not-timelike-pair"));
    // Axes that meet, with a ball that is in both.
    let degenerate = NaturalQuadric::cylinder(Point3::ORIGIN, Vec3::Y, 2.0).unwrap();
    assert_eq!(QuadricPair::new([pipe, degenerate]).unwrap_err().reason(), "degenerate-pair");
    let above = NaturalQuadric::cone(Point3::new(0.0, -9.0, 5.0), Vec3::Y, 0.1).unwrap();
    let pair = QuadricPair::new([pipe, above]).unwrap();
    let least = pair.smallest_radius().unwrap();
    assert_eq!(pair.place_of_radius(0.9 * least, 0.0).unwrap_err().reason(), "radius-too-small");
    assert_eq!(pair.place_of_radius(f64::NAN, 0.0).unwrap_err().reason(), "not-finite");
    // The smallest ball is that of the smallest gap.
    for theta in [0.0, 2.0, 4.0] {
        let ball = pair.ball(pair.place_of_radius(least, theta).unwrap()).unwrap();
        assert!((ball.normals[0] + ball.normals[1]).length() < 1e-6 && (ball.radius - least).abs() < 1e-12);
    }
}
