//! Laws that every curve obeys, on one list of every implementor of [`ParamCurve`].
//!
//! Lengths in the laws are measured against the curve's own size; each bound states where it comes from.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "values that must agree to the bit are compared as such")]

mod curves;
mod edits;
mod flattening;
mod invariance;
mod known_shapes;
mod parts;

use curves::{Case, cases};
use cyclide::{
    CurveJet, Point3, Vec3,
    curve::{
        ArcLength, Circle, CurveIndex, ParamCurve, bounds, closest_point, extreme_curvature, farthest_point, joints,
        length, resample,
    },
    mesh::flatten,
};

/// Runs a law on every curve of the list.
fn each(law: impl Fn(&Case, &dyn ParamCurve)) {
    for case in cases() {
        law(&case, case.curve.as_ref());
    }
}

/// Distance from a point to a segment.
fn segment_distance(p: Point3, a: Point3, b: Point3) -> f64 {
    let c = b - a;
    let l2 = c.length_squared();
    let t = if l2 > 0.0 { ((p - a).dot(c) / l2).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(a.lerp(b, t))
}

#[test]
fn pieces_meet_at_their_joints() {
    each(|case, curve| {
        let n = curve.piece_count();
        for joint in joints(curve) {
            assert!(joint.gap <= 4.0 * f64::EPSILON * case.reach, "{}: {joint:?}", case.name);
            assert!(joint.piece < n && joint.next < n);
        }
        let want = if curve.is_closed() { n } else { n - 1 };
        assert_eq!(joints(curve).len(), want, "{}", case.name);
    });
}

#[test]
fn flattening_stays_within_the_tolerance() {
    each(|case, curve| {
        for relative in [1e-1, 1e-3, 1e-5] {
            let tolerance = relative * case.size;
            let polyline = flatten(curve, tolerance).unwrap();
            assert_eq!(polyline[0], (0.0, curve.point(0.0)));
            assert_eq!(polyline[polyline.len() - 1].0, 1.0);
            for w in polyline.windows(2) {
                let ((t0, a), (t1, b)) = (w[0], w[1]);
                assert!(t1 > t0, "{}: {t0} {t1}", case.name);
                for j in 1..16 {
                    let p = curve.point(t0 + (t1 - t0) * f64::from(j) / 16.0);
                    let d = segment_distance(p, a, b);
                    assert!(
                        d <= tolerance * (1.0 + 1e-9) + 8.0 * f64::EPSILON * case.reach,
                        "{} at tolerance {tolerance:e}: {d:e}",
                        case.name
                    );
                }
            }
        }
    });
}

#[test]
fn flattening_makes_few_vertices() {
    each(|case, curve| {
        for relative in [1e-3, 1e-5, 1e-7] {
            let tolerance = relative * case.size;
            let got = flatten(curve, tolerance).unwrap().len() - 1;
            // A chord over curvature k is off by k l²/8, so the ideal density by arc length is sqrt(k/(8 tolerance)).
            let of_piece = |piece: usize| {
                let steps = dense_places(curve, piece);
                let step = |w: &[f64]| {
                    let (a, b) = (curve.piece_jet(piece, w[0]), curve.piece_jet(piece, w[1]));
                    let turn = a.tangent().unwrap().angle(b.tangent().unwrap());
                    (turn * a.point.distance(b.point) / (8.0 * tolerance)).sqrt()
                };
                steps.windows(2).map(step).sum::<f64>().ceil().max(1.0)
            };
            let ideal: f64 = (0..curve.piece_count()).map(of_piece).sum();
            // Chords without proof are halved, and numbers are whole per piece.
            assert!(got as f64 <= 1.2 * ideal, "{} {relative:e}: {got} vertices, ideal {ideal}", case.name);
        }
    });
}

#[test]
fn flattening_refuses_tolerances_that_make_no_sense() {
    let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0).unwrap();
    for tolerance in [0.0, -1.0, f64::NAN] {
        assert_eq!(flatten(&circle, tolerance).unwrap_err().reason(), "tolerance-not-positive");
    }
    assert_eq!(flatten(&circle, f64::INFINITY).unwrap_err().reason(), "not-finite");
    // 2 pi/sqrt(8 tolerance) chords are above 10^7; the spline is refused like the circle.
    assert_eq!(flatten(&circle, 1e-16).unwrap_err().reason(), "too-many-pieces");
    assert_eq!(flatten(&circle.to_nurbs().unwrap(), 1e-17).unwrap_err().reason(), "too-many-pieces");
    // As few as a closed curve can have.
    assert_eq!(flatten(&circle, 10.0).unwrap().len(), 4);
}

/// Parameters of a piece so dense that the tangent turns by less than 0.01 between neighbors.
fn dense_places(curve: &dyn ParamCurve, piece: usize) -> Vec<f64> {
    fn fill(curve: &dyn ParamCurve, piece: usize, a: f64, b: f64, places: &mut Vec<f64>) {
        let m = 0.5 * (a + b);
        let tangent = |s: f64| curve.piece_jet(piece, s).tangent().unwrap();
        let turn = tangent(a).angle(tangent(m)) + tangent(m).angle(tangent(b));
        if turn < 0.01 && b - a < 0.1 {
            places.push(b);
        } else {
            fill(curve, piece, a, m, places);
            fill(curve, piece, m, b, places);
        }
    }
    let mut places = vec![0.0];
    fill(curve, piece, 0.0, 1.0, &mut places);
    places
}

/// Points of the whole curve at these places.
fn dense_points(curve: &dyn ParamCurve) -> Vec<Point3> {
    let on_piece = |piece: usize| dense_places(curve, piece).into_iter().map(move |s| curve.piece_point(piece, s));
    (0..curve.piece_count()).flat_map(on_piece).collect()
}

#[test]
fn length_is_that_of_a_dense_polyline() {
    each(|case, curve| {
        let points = dense_points(curve);
        let chords: f64 = points.windows(2).map(|w| w[0].distance(w[1])).sum();
        let got = length(curve);
        // A chord is short of its arc by (turn)²/24 of itself.
        let rounding = 1e-12 * got + points.len() as f64 * f64::EPSILON * case.reach;
        assert!(got >= chords - rounding, "{}: {got} {chords}", case.name);
        assert!(got <= chords * (1.0 + 0.01_f64.powi(2) / 24.0 * 1.01) + rounding, "{}: {got} {chords}", case.name);
    });
}

#[test]
fn bounds_contain_the_curve_and_touch_it() {
    each(|case, curve| {
        let b = bounds(curve);
        let n = 1000 * curve.piece_count();
        let points: Vec<Point3> = (0..=n).map(|i| curve.point(i as f64 / n as f64)).collect();
        let sampled = cyclide::Aabb::of_points(points.iter().copied()).unwrap();
        let rounding = 1e-12 * case.size + 4.0 * f64::EPSILON * case.reach;
        for axis in 0..3 {
            assert!(b.min[axis] <= sampled.min[axis] + rounding, "{} axis {axis}", case.name);
            assert!(b.max[axis] >= sampled.max[axis] - rounding, "{} axis {axis}", case.name);
            // Samples miss an extreme by at most the sagitta of one step, below (step)² times curvature.
            let step = points.windows(2).map(|w| w[0].distance(w[1])).fold(0.0, f64::max);
            let sagitta = step * (step * extreme_curvature(curve).max).min(1.0);
            assert!(b.min[axis] >= sampled.min[axis] - sagitta - rounding, "{} axis {axis}", case.name);
            assert!(b.max[axis] <= sampled.max[axis] + sagitta + rounding, "{} axis {axis}", case.name);
        }
    });
}

#[test]
fn no_sample_is_farther_than_the_farthest_point() {
    each(|case, curve| {
        let b = bounds(curve);
        let across = cyclide::curve::Arc::segment(b.min, b.max).unwrap();
        let found = farthest_point(curve, &across);
        let n = 200 * curve.piece_count();
        let distance = |p: Point3| closest_point(&across, p).distance;
        let sampled = (0..=n).map(|i| distance(curve.point(i as f64 / n as f64))).fold(0.0, f64::max);
        let rounding = 1e-12 * case.size + 4.0 * f64::EPSILON * case.reach;
        assert!(found.distance >= sampled - rounding, "{}: {found:?} {sampled}", case.name);
        assert!((distance(curve.point(found.t)) - found.distance).abs() <= rounding, "{}: {found:?}", case.name);
        // The parameter is rounded, and some curves run fast.
        let moved = rounding + 4.0 * f64::EPSILON * curve.jet(found.t).speed();
        assert!(curve.point(found.t).distance(found.point) <= moved, "{}: {found:?}", case.name);
    });
}

#[test]
fn largest_curvature_is_not_exceeded_by_samples() {
    each(|case, curve| {
        let e = extreme_curvature(curve);
        let n = 1000 * curve.piece_count();
        let samples = (0..=n).filter_map(|i| curve.jet(i as f64 / n as f64).curvature());
        let sampled = samples.fold(0.0, f64::max);
        // Curvature by derivatives loses the digits that the position spends on the distance from the origin.
        let rounding = 1e-9 * e.max + 1e-9 / case.size;
        assert!(e.max >= sampled - rounding, "{}: {} {sampled}", case.name, e.max);
        // At a joint it is the curvature of one of the two sides.
        let (piece, s) = curve.locate(e.t);
        let mut sides = vec![(piece, s)];
        if s == 0.0 && piece > 0 {
            sides.push((piece - 1, 1.0));
        }
        if e.t == 1.0 {
            sides.push((piece, 1.0));
        }
        let reached = |&(piece, s): &(usize, f64)| {
            let there = curve.piece_jet(piece, s);
            (there.curvature().unwrap_or(0.0) - e.max).abs() <= rounding
                && there.point.distance(e.point) <= case.rounding
        };
        assert!(sides.iter().any(reached), "{}: {e:?}", case.name);
    });
}

#[test]
fn points_of_jets_and_slices_are_the_points() {
    each(|case, curve| {
        let ts: Vec<f64> = (0..=97).map(|i| f64::from(i) / 97.0).collect();
        let mut points = vec![Point3::ORIGIN; ts.len()];
        let mut jets = vec![CurveJet::default(); ts.len()];
        curve.points_into(&ts, &mut points);
        curve.jets_into(&ts, &mut jets);
        for ((t, p), j) in ts.iter().zip(&points).zip(&jets) {
            assert_eq!(*p, curve.point(*t), "{} at {t}", case.name);
            assert_eq!(*j, curve.jet(*t), "{} at {t}", case.name);
            // Both are quotients of sums of at most ten products of the size of the coordinates.
            assert!(p.distance(j.point) <= 16.0 * f64::EPSILON * case.reach, "{} at {t}", case.name);
        }
    });
}

#[test]
fn speed_is_the_length_of_the_derivative() {
    each(|case, curve| {
        for piece in 0..curve.piece_count() {
            for i in 0..=40 {
                let s = f64::from(i) / 40.0;
                let (speed, jet) = (curve.piece_speed(piece, s), curve.piece_jet(piece, s));
                // The derivative of a quotient: rounding of the coordinates times about the degree.
                let rounding = 1e-13 * speed + 16.0 * case.rounding;
                assert!((speed - jet.speed()).abs() <= rounding, "{} at {s}: {speed} {}", case.name, jet.speed());
            }
        }
    });
}

#[test]
fn derivatives_are_limits_of_differences() {
    let h = 1e-4;
    each(|case, curve| {
        for piece in 0..curve.piece_count() {
            for i in 0..12 {
                let s = 0.03 + 0.94 * f64::from(i) / 11.0;
                let order = |s: f64, k: usize| -> Vec3 {
                    let j = curve.piece_jet(piece, s);
                    [j.point.to_vec(), j.d1, j.d2, j.d3][k]
                };
                for k in 1..=3 {
                    let difference = |h: f64| (order(s + h, k - 1) - order(s - h, k - 1)) / (2.0 * h);
                    let (coarse, fine) = (difference(h), difference(0.5 * h));
                    // The error of a central difference falls by 4 when the step is halved. Rounding of the
                    // derivative below: that of coordinates, times about the degree for each order.
                    let below = order(s, k - 1).length() + 10.0_f64.powi(k as i32 - 1) * case.reach;
                    let bound = (coarse - fine).length() + 64.0 * f64::EPSILON * below / h;
                    let error = (order(s, k) - fine).length();
                    assert!(error <= bound, "{} piece {piece} at {s}, order {k}: {error:e} > {bound:e}", case.name);
                    // The law must be able to fail: the bound is far below what it judges.
                    let typical = order(s, k).length().max(case.size);
                    assert!(bound <= 1e-2 * typical, "{} piece {piece} at {s}, order {k}: {bound:e}", case.name);
                }
            }
        }
    });
}

/// Points around a curve: on it, near it, far from it.
fn probes(case: &Case, curve: &dyn ParamCurve) -> Vec<Point3> {
    // A fixed sequence of directions (multiples of irrational steps), so failures repeat.
    let direction = |i: u32| {
        let x = f64::from(i);
        Vec3::new((x * 0.754_877).fract() - 0.5, (x * 0.569_840).fract() - 0.5, (x * 0.430_159_7).fract() - 0.5)
    };
    let mut probes = Vec::new();
    for i in 1..30 {
        let t = (f64::from(i) * 0.618_034).fract();
        for size in [0.0, 1e-9, 1e-3, 0.1, 1.0, 10.0] {
            probes.push(curve.point(t) + direction(i) * (size * case.size));
        }
        // The center of curvature: the hardest place, where the distance is flat.
        if let Some(k) = curve.jet(t).curvature_vector() {
            let k2 = k.length_squared();
            if k2 * case.size * case.size > 1e-6 {
                probes.push(curve.point(t) + k / k2);
            }
        }
    }
    probes
}

#[test]
fn closest_point_is_never_beaten_by_a_dense_search() {
    each(|case, curve| {
        let index = CurveIndex::new(curve);
        let dense = dense_points(curve);
        for p in probes(case, curve) {
            let c = index.closest_point(p);
            let rounding = case.rounding + 4.0 * f64::EPSILON * p.to_vec().max_abs();
            // It is a point of the curve, at that distance.
            assert!(c.point.distance(curve.point(c.t)) <= 1e-9 * case.size, "{} {p:?} {c:?}", case.name);
            assert!((c.distance - c.point.distance(p)).abs() <= rounding, "{} {p:?} {c:?}", case.name);
            let best = dense.iter().map(|q| q.distance(p)).fold(f64::INFINITY, f64::min);
            assert!(c.distance <= best + rounding, "{} {p:?}: {c:?}, dense search finds {best}", case.name);
        }
        let p = Point3::new(0.3, 0.2, 0.1) + curve.point(0.7).to_vec();
        assert_eq!(index.closest_point(p), closest_point(curve, p), "{}", case.name);
    });
}

#[test]
fn points_of_the_curve_are_their_own_closest_points() {
    each(|case, curve| {
        let index = CurveIndex::new(curve);
        for i in 0..=200 {
            let p = curve.point(f64::from(i) / 200.0);
            let c = index.closest_point(p);
            assert!(c.distance <= case.rounding, "{}: {c:?}", case.name);
        }
    });
}

#[test]
fn constant_speed_parameter_inverts_the_length() {
    each(|case, curve| {
        let table = ArcLength::new(curve);
        let total = length(curve);
        assert!((table.total() - total).abs() <= 1e-12 * total, "{}: {} {total}", case.name, table.total());
        let ts = table.uniform(41);
        assert_eq!((ts[0], ts[40]), (0.0, 1.0));
        assert!(ts.windows(2).all(|w| w[0] < w[1]), "{}: not monotone", case.name);
        for (i, t) in ts.iter().enumerate() {
            let (piece, s) = curve.locate(*t);
            let before: f64 = (0..piece).map(|j| curve.piece_length(j, 0.0, 1.0)).sum();
            let got = before + curve.piece_length(piece, 0.0, s);
            let want = total * i as f64 / 40.0;
            // The parameter itself is rounded: eps times the speed (the nearly full arc has speed 2000 its length).
            let speed = curve.jet(*t).speed();
            assert!((got - want).abs() <= 1e-12 * total + f64::EPSILON * speed, "{} {t}: {got} {want}", case.name);
        }
        for (t, p) in resample(curve, 7) {
            assert_eq!(p, curve.point(t));
        }
    });
}

#[test]
fn length_adds_up() {
    each(|case, curve| {
        for piece in 0..curve.piece_count() {
            let whole = curve.piece_length(piece, 0.0, 1.0);
            for s in [0.1, 0.5, 0.77] {
                let sum = curve.piece_length(piece, 0.0, s) + curve.piece_length(piece, s, 1.0);
                assert!((sum - whole).abs() <= 2e-12 * whole, "{}: {sum} {whole}", case.name);
            }
        }
    });
}
