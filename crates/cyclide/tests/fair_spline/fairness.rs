//! How fair the curves are: the figures of `docs/math/fair-splines.md#figures`.

use crate::data::{closed, p};
use cyclide::{
    Point3,
    curve::{CircleSpline, CircleSplineOptions, ParamCurve},
};

/// Signed curvature along a planar curve, 64 samples per segment, one of them its start.
fn curvatures(s: &CircleSpline) -> Vec<f64> {
    let signed = |piece: usize, i: i32| {
        let jet = s.piece_jet(piece, f64::from(i) / 64.0);
        jet.curvature().unwrap().copysign(jet.d1.cross(jet.d2).z)
    };
    (0..s.piece_count()).flat_map(|piece| (0..64).map(move |i| (piece, i))).map(|(piece, i)| signed(piece, i)).collect()
}

fn sign_changes(k: &[f64]) -> usize {
    let around = k.iter().zip(k.iter().cycle().skip(1));
    around.filter(|(a, b)| *a * *b < 0.0).count()
}

fn total_variation(k: &[f64]) -> f64 {
    k.iter().zip(k.iter().cycle().skip(1)).map(|(a, b)| (a - b).abs()).sum()
}

fn track() -> Vec<Point3> {
    let rows = include_str!("../../../../examples/track.csv").lines().skip(1);
    let numbers = |row: &str| row.split(',').map(|v| v.parse::<f64>().unwrap()).collect::<Vec<_>>();
    rows.filter(|row| !row.is_empty()).map(numbers).map(|v| p(v[0], v[1], 0.0)).collect()
}

#[test]
fn the_track_bends_as_often_as_its_points() {
    let fair = curvatures(&CircleSpline::fair(&track(), &closed()).unwrap());
    assert_eq!(sign_changes(&fair), 8);
    let largest = fair.iter().fold(0.0, |m: f64, k| m.max(k.abs()));
    // 0.0356 and 0.352 in the table, with the digits given there.
    assert!((largest - 0.0356).abs() < 5e-5, "{largest}");
    assert!((total_variation(&fair) - 0.352).abs() < 5e-4);
    let order2 = CircleSplineOptions { closed: true, ..Default::default() };
    let wavers = curvatures(&CircleSpline::from_points(&track(), &order2).unwrap());
    assert_eq!(sign_changes(&wavers), 38, "what the circle spline of order 2 does");
}

#[test]
fn the_star_has_no_needless_extrema() {
    let at = |i: i32| {
        let (r, a) = (if i % 2 == 0 { 1.0 } else { 0.35 }, std::f64::consts::TAU * f64::from(i) / 10.0);
        p(r * a.cos(), r * a.sin(), 0.0)
    };
    let points: Vec<Point3> = (0..10).map(at).collect();
    let k = curvatures(&CircleSpline::fair(&points, &closed()).unwrap());
    assert_eq!(sign_changes(&k), 10);
    assert!((total_variation(&k) - 131.0).abs() < 1.0, "{}", total_variation(&k));
}

#[test]
fn a_smooth_curve_is_met_to_fourth_order() {
    let error = |n: i32| {
        let at = |a: f64| p((2.0 + a.cos()) * a.cos(), (2.0 + a.cos()) * a.sin(), 0.0);
        let angle = |i: f64| std::f64::consts::TAU * i / f64::from(n);
        let points: Vec<Point3> = (0..n).map(|i| at(angle(f64::from(i)))).collect();
        let s = CircleSpline::fair(&points, &closed()).unwrap();
        let dense: Vec<Point3> = (0..4000).map(|i| at(std::f64::consts::TAU * f64::from(i) / 4000.0)).collect();
        let index = cyclide::curve::CurveIndex::new(&s);
        dense.iter().map(|q| index.closest_point(*q).distance).fold(0.0, f64::max)
    };
    let ratio = error(40) / error(80);
    assert!((14.0..18.5).contains(&ratio), "{ratio}");
}
