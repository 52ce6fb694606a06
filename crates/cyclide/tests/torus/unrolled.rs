//! Curves of a torus laid flat: what is drawn is the curve, where it is cut, and what the maps keep.

use crate::data::{reach, tori};
use cyclide::{
    Frame, Point2, Point3,
    construct::{TorusMap, TorusSplineOptions, UnrollOptions},
    curve::{ArcPath, ParamCurve, closest_point, length},
    surface::{Torus, TorusSpline},
};
use std::f64::consts::{PI, TAU};

fn trefoil(torus: &Torus, start: [f64; 2]) -> TorusSpline {
    TorusSpline::knot(torus, [2, 3], torus.place_of_angles(start[0], start[1])).unwrap()
}

/// The point of the torus that a point of its belt stands for.
fn wound(torus: &Torus, p: Point3) -> Point3 {
    torus.point(torus.place_of_angles(p.x / torus.major_radius(), p.y / torus.minor_radius()))
}

fn samples(line: &ArcPath) -> impl Iterator<Item = Point3> + '_ {
    (0..=60).map(|k| line.point(f64::from(k) / 60.0))
}

/// Wound onto the torus again, the lines are the curve, within the tolerance times what the belt shrinks lengths by: up to
/// `(a + b)/a` on the outer side.
#[test]
fn a_belt_wound_up_is_the_curve() {
    for torus in &tori()[..3] {
        let (a, b) = (torus.major_radius(), torus.minor_radius());
        let (knot, tolerance) = (trefoil(torus, [0.7, 0.4]), 1e-4 * b);
        let flat = knot.unroll(&UnrollOptions::new(tolerance)).unwrap();
        for p in flat.lines.iter().flat_map(samples) {
            let distance = closest_point(&knot, wound(torus, p)).distance;
            assert!(distance <= tolerance * (a + b) / a + 1e-13 * reach(torus), "{distance:e}");
            let inside = |x: f64, from: f64, to: f64| x >= from - tolerance && x <= to + tolerance;
            assert!(inside(p.x, 0.0, 2.0 * PI * a) && inside(p.y, -PI * b, PI * b), "{p:?}");
        }
        assert!((flat.lengths[0] / length(&knot) - 1.0).abs() < 1e-12);
        let drawn: f64 = flat.lines.iter().map(ArcPath::length).sum();
        assert!((flat.lengths[1] / drawn - 1.0).abs() < 1e-12);
        // The factor is a/radius, between that of the outer and that of the inner side, both of which the knot passes.
        let [least, most] = flat.stretch;
        assert!((least * (a + b) / a - 1.0).abs() < 0.05 && (most * (a - b) / a - 1.0).abs() < 0.2, "{least} {most}");
    }
}

/// A (2, 3) knot crosses a meridian twice and a parallel three times; one that starts on a cut is cut there. Lines end on the border and
/// go on at the same place of the other side.
#[test]
fn cuts_are_counted_and_lines_end_on_the_border() {
    let torus = &tori()[0];
    let [width, height] = TorusMap::Belt.size(torus);
    for (start, cuts) in [([0.7, 0.4], 5), ([0.0, 0.0], 4), ([0.0, PI], 4), ([3.0, PI], 5)] {
        let flat = trefoil(torus, start).unroll(&UnrollOptions::new(1e-4)).unwrap();
        assert_eq!((flat.cuts, flat.lines.len()), (cuts, cuts), "{start:?}");
        for (i, line) in flat.lines.iter().enumerate() {
            let next = &flat.lines[(i + 1) % flat.lines.len()];
            let (end, begin) = (line.point(1.0), next.point(0.0));
            let border = (end.x / width).abs().min((end.x / width - 1.0).abs());
            let border = border.min((end.y / height - 0.5).abs().min((end.y / height + 0.5).abs()));
            assert!(border < 1e-9, "{start:?}: {end:?}");
            assert!(wound(torus, end).distance(wound(torus, begin)) < 1e-8, "{start:?}: {end:?} {begin:?}");
            assert!(!line.is_closed());
        }
    }
}

/// What crosses no cut stays in one piece: closed where the curve is, whatever the copy of the plane; what runs along a cut is not cut to
/// pieces.
#[test]
fn curves_between_the_cuts_stay_whole() {
    let torus = &tori()[0];
    let ring = |shift: f64| {
        let places =
            [[0.6, 0.4], [1.0, 0.0], [0.6, -0.4], [0.3, 0.0]].map(|[a, b]| Point2::new(a + shift, b + 2.0 * shift));
        let options = TorusSplineOptions { closed: true, ..Default::default() };
        TorusSpline::through_places(torus, &places, &options).unwrap().unroll(&UnrollOptions::new(1e-5)).unwrap()
    };
    let (here, far) = (ring(0.0), ring(5.0 * PI));
    assert!(here.cuts == 0 && here.lines.len() == 1 && here.lines[0].is_closed());
    for k in 0..=20 {
        let [p, q] = [&here, &far].map(|flat| flat.lines[0].point(f64::from(k) / 20.0));
        assert!(p.distance(q) < 1e-11, "whole turns are left out: {p:?} {q:?}");
    }
    for (turns, start) in [([1, 0], [0.0, PI]), ([1, 0], [1.0, PI]), ([0, 1], [0.0, 0.5])] {
        let circle = TorusSpline::knot(torus, turns, torus.place_of_angles(start[0], start[1])).unwrap();
        let flat = circle.unroll(&UnrollOptions::new(1e-5)).unwrap();
        assert_eq!((flat.cuts, flat.lines.len()), (1, 1), "{turns:?} {start:?}");
        let size = TorusMap::Belt.size(torus)[usize::from(turns[0] == 0)];
        assert!((flat.lengths[1] / size - 1.0).abs() < 1e-12, "{turns:?}: along a side of the plane");
    }
}

/// In the conformal map all circles of the four families are straight, and angles are those in space.
#[test]
fn the_conformal_map_keeps_angles() {
    for torus in &tori()[..3] {
        let options = UnrollOptions { map: TorusMap::Conformal, ..UnrollOptions::new(1e-6 * torus.minor_radius()) };
        for turns in [[1, 0], [0, 1], [1, 1], [1, -1]] {
            let circle = TorusSpline::knot(torus, turns, Point2::new(0.4, 0.2)).unwrap();
            for line in circle.unroll(&options).unwrap().lines {
                let (start, end) = (line.point(0.0), line.point(1.0));
                assert!((line.length() / start.distance(end) - 1.0).abs() < 1e-9, "{turns:?}");
            }
        }
        let at = torus.place_of_angles(0.3, 2.0);
        let p = TorusMap::Conformal.point(torus, at);
        let moved = |x: f64, y: f64| {
            let h = 1e-6;
            let place = Point2::new(at.x + h * x, at.y + h * y);
            (TorusMap::Conformal.point(torus, place) - p, torus.point(place) - torus.point(at))
        };
        let ((u, v), (flat_u, flat_v)) = {
            let (a, b) = (moved(1.0, 0.2), moved(-0.3, 1.0));
            ((a.1, b.1), (a.0, b.0))
        };
        let flat = (flat_u.dot(flat_v) / (flat_u.length() * flat_v.length())).acos();
        assert!((flat - u.angle(v)).abs() < 1e-4, "{flat} {}", u.angle(v));
    }
}

#[test]
fn what_is_refused() {
    let knot = trefoil(&tori()[0], [0.0, 0.0]);
    let reason = |options: UnrollOptions| knot.unroll(&options).unwrap_err().reason();
    assert_eq!(reason(UnrollOptions::new(0.0)), "tolerance-not-positive");
    assert_eq!(reason(UnrollOptions::new(f64::NAN)), "tolerance-not-positive");
    assert_eq!(reason(UnrollOptions { seam: [f64::NAN, 0.0], ..UnrollOptions::new(0.1) }), "not-finite");
    assert_eq!(reason(UnrollOptions { seam: [1e9, 0.0], ..UnrollOptions::new(0.1) }), "parameter-out-of-range");
    assert_eq!(reason(UnrollOptions::new(1e-30)), "too-many-pieces");
}

/// The height of the conformal plane keeps its digits where the hole closes: `a - b` is exact for such radii.
#[test]
fn conformal_heights_of_closing_holes() {
    for exponent in [4, 20, 40] {
        let hole = f64::from(exponent).exp2().recip();
        let torus = Torus::new(Frame::WORLD, 1.0, 1.0 - hole).unwrap();
        let [_, height] = TorusMap::Conformal.size(&torus);
        let exact = TAU * (1.0 - hole) / (hole * (2.0 - hole)).sqrt();
        assert!((height / exact - 1.0).abs() < 1e-15, "{exponent}: {height} {exact}");
        let far = Torus::new(Frame::WORLD, 3.7, 3.7 * (1.0 - 1e-9)).unwrap();
        let (a, b) = (far.major_radius(), far.minor_radius());
        let exact = TAU * a * b / ((a - b).sqrt() * (a + b).sqrt());
        assert!((TorusMap::Conformal.size(&far)[1] / exact - 1.0).abs() < 1e-15);
    }
}
