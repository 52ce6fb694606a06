//! Laws of what is swept and spanned on random, near-degenerate and badly scaled input: revolutions, pipes, necks, bridges,
//! surfaces between curves. Pappus, images under similarities, and the same data the other way round.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]
#![allow(clippy::float_cmp, reason = "places at the ends are these numbers")]

use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal as _, Mobius},
    construct::{EllipseBridge, NeckBlend, NeckSide, NeckVariant, Pipe, Revolution},
    curve::{Arc, ArcPath},
    surface::ParamSurface as _,
    topology::{Body, EdgeCurve},
};
use cyclide_testkit::generators::{direction, point};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// Bodies are measured: a few dozen cases take a second.
const CASES: u32 = 48;
/// Places on a face.
const PLACES: [(f64, f64); 5] = [(0.0, 0.0), (0.3, 0.8), (0.5, 0.5), (0.9, 0.1), (1.0, 1.0)];

/// Sizes whose cubes are numbers.
fn scale() -> impl Strategy<Value = f64> {
    (-9.0..9.0_f64).prop_map(|power| 10.0_f64.powf(power))
}

/// A contour about (2, 0), distance from the axis and height: spikes as thin as a hundredth. The gaps between the directions of its
/// corners are below half a turn, so that it does not meet itself.
fn contour() -> impl Strategy<Value = Vec<[f64; 2]>> {
    prop::collection::vec((0.01..1.0_f64, 0.0..0.9_f64), 4..10).prop_map(|corners| {
        let count = corners.len() as f64;
        let corner = |(k, (reach, shift)): (usize, (f64, f64))| {
            let (sin, cos) = (TAU * (k as f64 + shift) / count).sin_cos();
            [2.0 + reach * cos, reach * sin]
        };
        corners.into_iter().enumerate().map(corner).collect()
    })
}

/// A turn, an amount and a shift of a similarity.
fn similarity() -> impl Strategy<Value = (Vec3, f64, f64, Vec3)> {
    (direction(), -3.0..3.0_f64, scale(), direction())
        .prop_map(|(axis, angle, scale, shift)| (axis, angle, scale, shift))
}

fn map_of((axis, angle, scale, shift): (Vec3, f64, f64, Vec3)) -> Mobius {
    Mobius::similarity(Quat::from_axis_angle(axis, angle), scale, shift * scale).unwrap()
}

/// Twice the area of a polygon, and six times the integral of the distance from the axis over it.
fn moments(contour: &[[f64; 2]]) -> [f64; 2] {
    let sides = (0..contour.len()).map(|k| (contour[k], contour[(k + 1) % contour.len()]));
    sides.fold([0.0, 0.0], |[area, moment], (p, q)| {
        let cross = p[0] * q[1] - p[1] * q[0];
        [area + cross, moment + cross * (p[0] + q[0])]
    })
}

fn polygon(contour: &[[f64; 2]], place: impl Fn([f64; 2]) -> Point3) -> Vec<EdgeCurve> {
    let at = |k: usize| place(contour[k % contour.len()]);
    (0..contour.len()).map(|k| Arc::segment(at(k), at(k + 1)).unwrap().into()).collect()
}

fn backwards(curves: &[EdgeCurve]) -> Vec<EdgeCurve> {
    curves.iter().rev().map(EdgeCurve::reversed).collect()
}

fn close(a: Point3, b: Point3, limit: f64, what: &str) -> Result<(), TestCaseError> {
    prop_assert!(a.distance(b) <= limit, "{what}: {:e} > {limit:e}", a.distance(b));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: CASES, failure_persistence: None, ..ProptestConfig::default() })]

    /// Parts of turns are solids with the volume of Pappus, wherever and however large, whichever way the profile runs.
    #[test]
    fn parts_of_turns_have_the_measures_of_pappus(contour in contour(), angle in 1e-3..6.2_f64, other in any::<bool>(), similar in similarity()) {
        let map = map_of(similar);
        let place = |[r, z]: [f64; 2]| map.map_point(Point3::new(r, 0.0, z)).unwrap();
        let axis = place([0.0, 1.0]) - place([0.0, 0.0]);
        let angle = if other { -angle } else { angle };
        let turn = Revolution::new(place([0.0, 0.0]), axis, angle).unwrap();
        let curves = polygon(&contour, place);
        let [area, moment] = moments(&contour);
        let size = similar.2;
        let sides: f64 = (0..contour.len()).map(|k| {
            let (p, q) = (contour[k], contour[(k + 1) % contour.len()]);
            (p[0] - q[0]).hypot(p[1] - q[1]) * 0.5 * (p[0] + q[0])
        }).sum();
        for curves in [curves.clone(), backwards(&curves)] {
            let body = turn.body(&curves, true).unwrap();
            prop_assert!(body.is_solid());
            prop_assert_eq!(turn.warnings(&[(curves, true)]).unwrap(), []);
            let volume = body.outer.known_volume().unwrap() / size.powi(3);
            let wanted = angle.abs() * moment / 6.0;
            // Rounding of products of coordinates up to 4, far from the origin by as much as the size.
            prop_assert!((volume - wanted).abs() <= 1e-12 * (1.0 + angle.abs()), "{volume} {wanted}");
            let found = body.outer.known_area().unwrap() / (size * size);
            let wanted = angle.abs() * sides + area;
            prop_assert!((found - wanted).abs() <= 1e-11 * (1.0 + wanted), "{found} {wanted}");
        }
    }

    /// A pipe about an arc of less than half a turn, down to nearly straight ones.
    #[test]
    fn pipes_have_the_measures_of_pappus(from in point(), way in direction(), up in direction(), bulge in -12.0..-0.05_f64, part in 0.01..0.6_f64, similar in similarity()) {
        prop_assume!(way.cross(up).length() > 0.1);
        let normal = way.cross(up).unit().unwrap();
        let size = from.to_vec().max_abs().max(1e-9) + 1.0;
        let arc = Arc::from_bulge(from, from + way * size, normal, 10_f64.powf(bulge)).unwrap();
        let bend = arc.radius().unwrap_or(f64::INFINITY);
        let radius = part * bend.min(size);
        let spine = |arc: Arc| ArcPath::new(vec![arc], false).unwrap();
        let pipe = |arc: Arc, radius: f64| Pipe::new(radius).unwrap().body(&spine(arc)).unwrap();
        let wanted = PI * radius * radius * arc.length();
        let body = pipe(arc, radius);
        prop_assert!(body.is_solid());
        let volumes = [body.outer.known_volume().unwrap(), pipe(arc.reversed(), radius).outer.known_volume().unwrap()];
        for volume in volumes {
            prop_assert!((volume / wanted - 1.0).abs() <= 1e-10, "{volume} {wanted}");
        }
        let map = map_of((similar.0, similar.1, similar.2, Vec3::ZERO));
        let image = pipe(arc.transformed(&map).unwrap(), radius * similar.2);
        let volume = image.outer.known_volume().unwrap() / similar.2.powi(3);
        prop_assert!((volume / wanted - 1.0).abs() <= 1e-10, "{volume} {wanted}");
    }

    /// Necks of any slope: the arcs touch the ball, similar data give similar arcs, and the mirror image is that of the other slope.
    #[test]
    fn necks_are_similar_and_mirrored(pipe in 0.5..5.0_f64, part in 1e-6..0.9_f64, slope in -1.55..1.55_f64, inside in any::<bool>(), upright in any::<bool>(), scale in scale(), angle in 0.0..TAU) {
        let side = if inside { NeckSide::Inside } else { NeckSide::Outside };
        let variant = if upright { NeckVariant::Vertical } else { NeckVariant::Pipe };
        let ball = part * pipe;
        let neck = |scale: f64, slope: f64| NeckBlend::new(scale * pipe, scale * ball, slope, side, variant).unwrap();
        let (one, other, mirrored) = (neck(1.0, slope), neck(scale, slope), neck(1.0, -slope));
        // Coordinates grow with the slope; the chord of the arc shrinks with it, and with it the digits of the arc.
        let limit = 1e-13 * pipe / slope.cos().powi(2);
        let arcs = [one.arc(angle).unwrap(), other.arc(angle).unwrap(), mirrored.arc(-angle).unwrap()];
        for t in [0.0, 0.2, 0.5, 0.9, 1.0] {
            let [p, q, r] = arcs.map(|arc| arc.point_at_length(t));
            close(Point3::ORIGIN + q.to_vec() / scale, p, limit, "similar")?;
            close(Point3::new(r.x, -r.y, r.z), p, limit, "mirrored")?;
            // Both kinds of arcs lie on the ball.
            prop_assert!((p.distance(one.center(angle)) - ball).abs() <= limit);
        }
    }

    /// Bridges are half circles over the chord, and the same from either ellipse.
    #[test]
    fn bridges_are_the_same_both_ways(a in 0.1..5.0_f64, b in 0.1..5.0_f64, apart in prop::array::uniform2(-9.0..0.5_f64), angle in 0.0..TAU, scale in scale()) {
        let second = [a + 10_f64.powf(apart[0]), b + 10_f64.powf(apart[1])];
        let there = EllipseBridge::new([a, b], second).unwrap().arc(angle).unwrap();
        let back = EllipseBridge::new(second, [a, b]).unwrap().arc(angle).unwrap();
        let large = EllipseBridge::new([scale * a, scale * b], second.map(|x| scale * x)).unwrap().arc(angle).unwrap();
        let middle = there.start().midpoint(there.end());
        // Rounding of the coordinates, and of parameters that run a hundred times faster at one end than at the other.
        let limit = 1e-12 * (second[0] + second[1]);
        for t in [0.0, 0.3, 0.5, 1.0] {
            let p = there.point_at_length(t);
            close(back.point_at_length(1.0 - t), p, limit, "back")?;
            close(Point3::ORIGIN + large.point_at_length(t).to_vec() / scale, p, limit, "similar")?;
            prop_assert!((p.distance(middle) - 0.5 * there.chord().length()).abs() <= limit && p.z >= -limit);
        }
    }

    /// Ruled and circular surfaces: lines and arcs between equal parameters; images of the data give the image, and the rails the other
    /// way round the same points.
    #[test]
    fn surfaces_between_curves_keep_to_both(ends in prop::array::uniform4(point()), bulges in prop::array::uniform2(-1.0..1.0_f64), up in direction(), similar in similarity()) {
        let size = ends.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let [a, b, c, d] = ends;
        let far = [(a, b), (c, d), (a, c), (b, d)].iter().all(|(p, q)| p.distance(*q) > 1e-3 * size);
        let [n, m] = [b - a, d - c].map(|chord| chord.cross(up).unit());
        prop_assume!(far && n.is_some() && m.is_some());
        let arc = |from, to, normal: Option<Vec3>, bulge| Arc::from_bulge(from, to, normal.unwrap_or(up), bulge);
        let (Ok(first), Ok(second)) = (arc(a, b, n, bulges[0]), arc(c, d, m, bulges[1])) else { return Ok(()) };
        let rails = [EdgeCurve::from(first), second.into()];
        let ruled = |rails: &[EdgeCurve; 2]| Body::ruled([&rails[..1], &rails[1..]], false);
        // Rulings that cross are refused.
        let Ok(body) = ruled(&rails) else { return Ok(()) };
        let limit = 1e-12 * size;
        let turned = ruled(&[rails[1].clone(), rails[0].clone()]).unwrap();
        let back = ruled(&[rails[0].reversed(), rails[1].reversed()]).unwrap();
        let map = map_of(similar);
        let moved = ruled(&[first.transformed(&map).unwrap().into(), second.transformed(&map).unwrap().into()]).unwrap();
        let faces = [&body, &turned, &back, &moved].map(|body| body.outer.faces());
        prop_assume!(faces[0].len() == 1 && faces.iter().all(|faces| faces.len() == 1));
        for (s, t) in PLACES {
            let [p, q, r, image] = faces.map(|faces| &faces[0].surface);
            let on = |t: f64| if t == 0.0 { first.point_at_length(s) } else { second.point_at_length(s) };
            if s == 0.0 || s == 1.0 {
                close(p.point(s, t), Point3::ORIGIN + on(0.0).to_vec() * (1.0 - t) + on(1.0).to_vec() * t, limit, "ruling")?;
            }
            let p = p.point(s, t);
            close(q.point(s, 1.0 - t), p, limit, "turned")?;
            close(r.point(1.0 - s, t), p, limit, "back")?;
            let far = similar.2 * (size + 1.0);
            close(image.point(s, t), map.map_point(p).unwrap(), 1e-12 * far, "image")?;
        }
        let Ok(arcs) = Body::circular([&rails[..1], &rails[1..]], &[up], false) else { return Ok(()) };
        for face in arcs.outer.faces() {
            // Parameter lines along t are circles in the plane of the direction and the chord.
            let [p, m, q] = [0.0, 0.4, 1.0].map(|t| face.surface.point(0.3, t));
            let normal = (q - p).cross(up);
            prop_assert!((m - p).dot(normal).abs() <= 1e-9 * size * normal.length(), "off the plane");
        }
    }
}
