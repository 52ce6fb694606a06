//! Seams of a given width along curves of a torus.

use crate::data::tori;
use cyclide::{
    Error, Frame, Point2, Point3,
    construct::{TorusSeam, TorusSplineOptions},
    curve::{ArcLength, ParamCurve, length},
    error::{ErrorItem, NumberError, TorusError},
    surface::{Torus, TorusSpline},
};
use std::f64::consts::PI;

/// Round the outer equator a seam is a tube of rectangular section, round the tube a ring of plates: volumes by Pappus. The tolerance moves
/// each side by as much at most.
#[test]
fn seams_along_circles_have_the_volume_of_their_turn() {
    for torus in &tori()[..3] {
        let (a, b) = (torus.major_radius(), torus.minor_radius());
        let (width, [low, high]) = (0.3 * b, [-0.1 * b, 0.04 * b]);
        let tolerance = 1e-6 * b;
        for (turns, radius) in [([1, 0], a + b), ([0, 1], b)] {
            let circle = TorusSpline::knot(torus, turns, Point2::default()).unwrap();
            let body = TorusSeam::new(width, [low, high]).unwrap().body(&circle, tolerance).unwrap();
            assert!(body.outer.is_closed() && body.voids.is_empty());
            let volume = PI * width * ((radius + high).powi(2) - (radius + low).powi(2));
            let surface = 2.0 * (width + high - low) * length(&circle) * (1.0 + high / radius);
            let error = (body.outer.volume() - volume).abs();
            assert!(error <= tolerance * surface, "{turns:?}: {error:e}");
        }
    }
}

/// What is too deep round the tube is the height, whatever the width.
#[test]
fn seams_that_fold_by_their_height_are_refused_for_it() {
    let torus = Torus::new(Frame::WORLD, 40.0, 15.0).unwrap();
    let round = TorusSpline::knot(&torus, [0, 1], Point2::default()).unwrap();
    let error = TorusSeam::new(3.0, [-14.9, 1.0]).unwrap().body(&round, 1e-2).unwrap_err();
    let Error::Number(NumberError::ParameterOutOfRange { name: ErrorItem::Height, value, min, max }) = error else {
        panic!("{error}")
    };
    // A twentieth of the speed of the curve is left at 0.95 of the radius.
    assert!((value + 14.9).abs() < 1e-15 && (min + 0.95 * 15.0).abs() < 1e-9 && max <= 25.0, "{min} {max}");
    assert!(TorusSeam::new(3.0, [min + 0.1, 1.0]).unwrap().body(&round, 1e-2).is_ok());
}

/// A seam that is high and thin has hundreds of sections within its own height; what meets it is found all the same: seams along two parallels, which come
/// nearer to each other below the torus.
#[test]
fn high_and_thin_seams_meet_others_where_they_do() {
    let torus = Torus::new(Frame::WORLD, 40.0, 15.0).unwrap();
    let parallels = [-0.01, 0.01].map(|up| TorusSpline::knot(&torus, [1, 0], Point2::new(0.0, up)).unwrap());
    let meets = |width: f64| TorusSeam::new(width, [-2.0, 2.0]).unwrap().first_meeting(&parallels, 1e-5).unwrap();
    // Their middles are this far apart 2 below the torus.
    let apart = parallels[0].point(0.0).distance(parallels[1].point(0.0)) * 13.0 / 15.0;
    assert!(meets(0.97 * apart).is_none());
    let (seams, place) = meets(1.03 * apart).unwrap();
    // They share what is below the place where they are the width apart, at 1.03 of this distance from the middle of the tube.
    let deep = torus.frame().origin().distance(place) - 40.0;
    assert!(seams == [0, 1] && deep > 12.99 && deep < 1.03 * 13.01, "{deep}");
}

/// The corners of a seam are half its width and its heights away from the curve, along the torus and its normal.
#[test]
fn edges_of_a_seam_are_where_they_should_be() {
    let torus = &tori()[1];
    let b = torus.minor_radius();
    let knot = TorusSpline::knot(torus, [2, 3], Point2::new(0.3, 0.1)).unwrap();
    let (width, heights, tolerance) = (0.2 * b, [-0.05 * b, 0.1 * b], 1e-4 * b);
    let body = TorusSeam::new(width, heights).unwrap().body(&knot, tolerance).unwrap();
    let frames: Vec<_> = (0..2000).map(|k| knot.seam_frame(f64::from(k) / 2000.0).unwrap()).collect();
    for edge in body.outer.edges() {
        for s in [0.0, 0.31, 0.5] {
            let p = edge.curve.point(s);
            let frame = frames.iter().min_by(|f, g| f.origin().distance(p).total_cmp(&g.origin().distance(p))).unwrap();
            let v = p - frame.origin();
            let (side, height) = (v.dot(frame.y()).abs(), v.dot(frame.z()));
            // Frames are a step along the curve apart: what they turn by over half of it moves a corner by less than a tenth of the width.
            let on_side = (side - 0.5 * width).abs() < 0.02 * width;
            let on_height = heights.iter().any(|h| (height - h).abs() < 0.02 * width);
            assert!((on_side || on_height) && side < 0.52 * width, "{side} {height}");
        }
    }
    assert!(body.outer.is_closed());
}

/// An open curve has plane ends: a closed solid too, whose volume is that of its section along it.
#[test]
fn seams_of_open_curves_are_solids() {
    let torus = &tori()[0];
    let places = [[0.0, 0.0], [0.4, 0.3], [0.9, 0.1]].map(Point2::from);
    let curve = TorusSpline::through_places(torus, &places, &TorusSplineOptions::default()).unwrap();
    let body = TorusSeam::new(0.02, [-0.01, 0.01]).unwrap().body(&curve, 1e-5).unwrap();
    assert!(body.outer.is_closed());
    // To first order the middle line has the volume; the section is 1 % of the radii.
    assert!((body.outer.volume() / (0.02 * 0.02 * length(&curve)) - 1.0).abs() < 1e-3);
}

#[test]
fn what_folds_or_leaves_the_tube_is_refused() {
    let torus = &tori()[0];
    let places = [[0.3, 0.1], [0.36, 0.0], [0.3, -0.1], [0.24, 0.0]].map(Point2::from);
    let options = TorusSplineOptions { closed: true, ..Default::default() };
    let ring = TorusSpline::through_places(torus, &places, &options).unwrap();
    let body = |width: f64, heights: [f64; 2]| TorusSeam::new(width, heights).and_then(|seam| seam.body(&ring, 1e-3));
    let Err(Error::Torus(TorusError::SeamTooWide { point, limit, piece, .. })) = body(2.0, [-0.1, 0.1]) else {
        unreachable!("wider than the ring")
    };
    // The width named is right at that place, where the seam folded first, and a little less will do.
    assert!(limit > 0.1 && limit < 2.0, "{limit}");
    assert!(body(0.999 * limit, [-0.1, 0.1]).is_ok());
    let off = (0..=128).map(|k| ring.piece_point(piece, f64::from(k) / 128.0).distance(Point3::from(point)));
    assert!(off.fold(f64::INFINITY, f64::min) < 1e-12 * torus.major_radius(), "the place is on the curve");
    let height = |width: f64, heights: [f64; 2]| match body(width, heights) {
        Err(Error::Number(NumberError::ParameterOutOfRange { name, .. })) => name,
        other => unreachable!("{other:?}"),
    };
    for heights in
        [[0.1, 0.1], [0.2, 0.1], [-1.0, 0.1], [0.0, 2.0], [f64::NAN, 0.1], [0.0, f64::NAN], [0.0, f64::INFINITY]]
    {
        assert_eq!(height(0.1, heights), ErrorItem::Height, "{heights:?}");
    }
    for width in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(height(width, [0.0, 0.1]), ErrorItem::Width);
    }
    let seam = TorusSeam::new(0.1, [0.0, 0.1]).unwrap();
    assert_eq!(seam.body(&ring, -1.0).unwrap_err().reason(), "tolerance-not-positive");
    assert_eq!(seam.body(&ring, 1e-30).unwrap_err().reason(), "too-many-pieces");
}

/// Turns that come nearer to each other than the width share space; a little less wide they do not. Flat seams meet where they are half
/// the distance of the turns away, but for the bend of the torus between.
#[test]
fn seams_that_run_through_themselves_are_refused() {
    let torus = Torus::new(Frame::WORLD, 40.0, 12.0).unwrap();
    for turns in [[1, 12], [2, 9], [9, 2], [-5, 3]] {
        let knot = TorusSpline::knot(&torus, turns, Point2::new(0.2, 0.1)).unwrap();
        let places = ArcLength::new(&knot).uniform(3000);
        // The last one is the first again.
        let points: Vec<Point3> = places.iter().skip(1).map(|t| knot.point(*t)).collect();
        let step = length(&knot) / 3000.0;
        let n = points.len() as f64;
        let mut nearest = f64::INFINITY;
        for (i, p) in points.iter().enumerate() {
            for (j, q) in points.iter().enumerate().skip(i + 1) {
                let apart = (j - i) as f64;
                if apart.min(n - apart) * step > 2.0 * p.distance(*q) {
                    nearest = nearest.min(p.distance(*q));
                }
            }
        }
        let body = |width: f64| TorusSeam::new(width, [-0.2, 0.2]).unwrap().body(&knot, 1e-3);
        assert!(body(0.9 * nearest).is_ok(), "{turns:?} {nearest}");
        let Err(Error::Torus(TorusError::SeamMeetsItself { point, distance, width, first, second })) =
            body(1.15 * nearest)
        else {
            panic!("{turns:?}: turns {nearest} apart")
        };
        assert!(first < second && distance <= width, "{first} {second} {distance}");
        // The point is inside both: as near as corners are to two places of the curve that are not neighbors.
        let point = Point3::from(point);
        let reach = 0.5 * width.hypot(0.4) + step;
        let near: Vec<f64> =
            (0..points.len()).filter(|&i| points[i].distance(point) < reach).map(|i| i as f64).collect();
        let apart = |i: &f64| (i - near[0]).abs().min(n - (i - near[0]).abs()) * step;
        assert!(near.iter().any(|i| apart(i) > 2.0 * reach), "{turns:?}: one part only");
    }
    // A curve that crosses itself has no seam of any width.
    let places = [[0.0, 0.0], [0.4, 0.4], [0.4, 0.0], [0.0, 0.4]].map(Point2::from);
    let options = TorusSplineOptions { closed: true, ..Default::default() };
    let eight = TorusSpline::through_places(&torus, &places, &options).unwrap();
    let error = TorusSeam::new(0.5, [0.0, 0.2]).unwrap().body(&eight, 1e-3).unwrap_err();
    assert_eq!(error.reason(), "seam-meets-itself");
}

/// However thin a seam is, that it crosses itself is seen, and one that does not is made: its parts are proved apart whatever their width.
#[test]
fn thin_seams_that_cross_themselves_are_refused() {
    let torus = Torus::new(Frame::WORLD, 40.0, 15.0).unwrap();
    let places = [[0.0, 0.5], [1.0, -0.5], [1.5, 0.0], [1.0, 0.5], [0.0, -0.5]].map(Point2::from);
    let eight = TorusSpline::through_places(&torus, &places, &TorusSplineOptions::default()).unwrap();
    let knot = TorusSpline::knot(&torus, [2, 3], Point2::default()).unwrap();
    for (width, heights, tolerance) in [
        (1e-3, [-1e-3, 1e-3], 1e-5),
        (1e-4, [-1e-4, 1e-4], 1.1e-6),
        (0.01, [-1.0, 1.0], 1e-4),
        (2.0, [0.0, 1e-6], 1e-2),
        (1e-6, [-0.5, 0.5], 1e-5),
    ] {
        let seam = TorusSeam::new(width, heights).unwrap();
        let error = seam.body(&eight, tolerance).unwrap_err();
        let Error::Torus(TorusError::SeamMeetsItself { point, distance, .. }) = error else {
            panic!("{width}: {error}")
        };
        // Places of the curve are 0.1 apart.
        let nearest = (0..4000).map(|k| eight.point(f64::from(k) / 4000.0).distance(point.into()));
        assert!(nearest.fold(f64::INFINITY, f64::min) < width.hypot(heights[1]) + 0.1, "{width}");
        // The middles of both parts are that of the curve to the tolerance.
        assert!(distance <= 2.0 * (width + tolerance), "{width}: {distance}");
        assert!(seam.body(&knot, tolerance).unwrap().outer.is_closed(), "{width}");
    }
}
