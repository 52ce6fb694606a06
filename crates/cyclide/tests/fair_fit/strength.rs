//! How strong the smoothing of measured points is: of few points, of noise that has one direction or is given, beside ends that
//! stay, at corners that noise hides, and of heights (`docs/math/fair-fits.md#noise`).

use crate::data::*;
use cyclide::{
    Point3, Warning,
    construct::{FairFit, FairFitOptions, FairSplineOptions, Heights, Noise, Outliers},
    curve::{CircleSpline, ParamCurve, closest_point, extreme_curvature},
    warning::{FitWarning, NoiseWarning},
};
use std::f64::consts::TAU;

fn by_noise(closed: bool) -> FairFitOptions {
    FairFitOptions { closed, ..FairFitOptions::by_noise(Noise::Estimated) }
}

/// A closed curve of three waves, or of two and bent.
fn waves(count: usize, kind: usize) -> Vec<Point3> {
    let at = |i: usize| {
        let a = TAU * i as f64 / count as f64;
        let r = 50.0 + if kind == 0 { 10.0 * (3.0 * a).cos() } else { 8.0 * (2.0 * a).sin() };
        Point3::new(r * a.cos(), if kind == 0 { r } else { 0.7 * r } * a.sin(), 0.0)
    };
    (0..count).map(at).collect()
}

/// Root mean square of the distances of a curve from the true one, which is as good as its samples.
fn error(curve: &impl ParamCurve, kind: usize) -> f64 {
    let truth = waves(4000, kind);
    let nearest = |k: usize| {
        let p = curve.point(k as f64 / 300.0);
        truth.iter().map(|q| p.distance(*q)).fold(f64::INFINITY, f64::min)
    };
    ((0..300).map(|k| nearest(k).powi(2)).sum::<f64>() / 300.0).sqrt()
}

#[test]
fn the_shape_of_few_points_is_not_taken_for_noise() {
    for kind in [0, 1] {
        for (k, count) in [20, 24, 30, 40, 60, 100].into_iter().enumerate() {
            for sigma in [0.0, 0.2] {
                let points = noisy(&waves(count, kind), 11 + k as u64, sigma, 2);
                let fit = FairFit::new(&points, &by_noise(true)).unwrap();
                let spline =
                    CircleSpline::fair(&points, &FairSplineOptions { closed: true, ..Default::default() }).unwrap();
                let [own, through] = [error(fit.spline(), kind), error(&spline, kind)];
                // Samples of the truth are 0.1 apart. The curve through all points has all of their noise.
                assert!(own < 2.0 * through + 0.25, "{kind} {count} {sigma}: {own} {through}");
            }
        }
    }
}

#[test]
fn exact_points_are_run_through() {
    for count in [40, 60, 100] {
        let fit = FairFit::new(&waves(count, 0), &by_noise(true)).unwrap();
        // The sagitta of the largest bend between neighbors is above 0.2; the noise that is read falls with the fourth power of
        // their distance.
        let limit = 0.05 * (40.0 / count as f64).powi(4);
        assert!(fit.certificate().deviation < limit, "{count}: {:?}", fit.certificate());
    }
}

#[test]
fn noise_that_is_given_is_reached_or_contradicted() {
    let points = noisy(&waves(200, 0), 5, 1.0, 2);
    let said = |noise: f64| {
        let fit =
            FairFit::new(&points, &FairFitOptions { noise: Some(Noise::Known(noise)), ..by_noise(true) }).unwrap();
        fit.warnings().iter().find_map(|w| {
            if let Warning::Noise(NoiseWarning::Contradicted { given, found }) = w {
                Some((*given, *found))
            } else {
                None
            }
        })
    };
    assert_eq!(said(1.0), None);
    for given in [0.3, 4.0] {
        let (said, found) = said(given).unwrap();
        assert!((said - given).abs() < 1e-12 && (0.8..1.2).contains(&found), "{given}: {found}");
    }
}

#[test]
fn noise_in_a_plane_is_the_same_where_the_plane_is_not_quite_one() {
    let flat = noisy(&waves(1000, 0), 3, 0.1, 2);
    let noise = |points: &[Point3]| FairFit::new(points, &by_noise(true)).unwrap().certificate().noise.unwrap();
    let plain = noise(&flat);
    assert!((plain - 0.1).abs() < 0.01, "{plain}");
    let bent = |size: f64| -> Vec<Point3> {
        flat.iter().enumerate().map(|(i, p)| Point3::new(p.x, p.y, size * (0.01 * i as f64).sin())).collect()
    };
    for size in [1e-9, 1e-3, 5.0] {
        assert!((noise(&bent(size)) - plain).abs() < 0.02 * plain, "{size}: {}", noise(&bent(size)));
    }
}

#[test]
fn a_corner_that_noise_hides_is_kept() {
    let shapes: [&[[f64; 2]]; 3] = [
        &[[0.0, 0.0], [100.0, 0.0], [100.0, 80.0], [0.0, 80.0]],
        &[[0.0, 0.0], [90.0, 0.0], [40.0, 70.0]],
        &[[0.0, 0.0], [80.0, 0.0], [80.0, 40.0], [40.0, 40.0], [40.0, 90.0], [0.0, 90.0]],
    ];
    let mut cut = 0;
    for (k, shape) in shapes.iter().cycle().take(12).enumerate() {
        // A point every 2 along each side, noise of 0.16 to 0.2.
        let corner = |i: usize| Point3::new(shape[i % shape.len()][0], shape[i % shape.len()][1], 0.0);
        let side = |i: usize| {
            let steps = (corner(i).distance(corner(i + 1)) / 2.0).round() as usize;
            (0..steps).map(move |j| (i, j as f64 / steps as f64))
        };
        let truth: Vec<Point3> =
            (0..shape.len()).flat_map(side).map(|(i, t)| corner(i).lerp(corner(i + 1), t)).collect();
        let sigma = 0.16 + 0.01 * (k % 5) as f64;
        let fit = FairFit::new(&noisy(&truth, 40 + k as u64, sigma, 2), &by_noise(true)).unwrap();
        for i in 0..shape.len() {
            let off = closest_point(fit.spline(), corner(i)).distance;
            // A corner is where it was measured.
            cut += usize::from(off > 3.5 * sigma);
        }
        let kept = fit
            .warnings()
            .iter()
            .find_map(|w| if let Warning::Fit(FitWarning::CornerKept { count, .. }) = w { Some(*count) } else { None });
        // One that is cut by less than the limit need not be kept; nothing else is one.
        assert!(kept.is_none_or(|kept| kept <= shape.len()), "{k}: {:?}", fit.warnings());
    }
    // Of 52 corners: one that the noise itself moves by three deviations may be none.
    assert!(cut <= 1, "{cut}");
}

#[test]
fn ends_that_stay_bend_nothing_beside_them() {
    let count = 12_000;
    let truth: Vec<Point3> = (0..count)
        .map(|i| {
            let s = i as f64 / count as f64;
            Point3::new(60.0 * s, 8.0 * (TAU * s).sin(), 0.0)
        })
        .collect();
    let points = noisy(&truth, 9, 0.05, 2);
    let fit = FairFit::new(&points, &FairFitOptions { fix_ends: true, ..by_noise(false) }).unwrap();
    let curve = fit.spline();
    assert!(curve.point(0.0).distance(points[0]) < 1e-9 && curve.point(1.0).distance(points[count - 1]) < 1e-9);
    let most = extreme_curvature(curve).max;
    // The truth has 8 (2 pi / 60)², and noise at the end that is kept some more.
    assert!(most < 1.0, "{most}");
}

#[test]
fn a_wrong_height_is_named_and_left_out() {
    let truth: Vec<Point3> = (0..80)
        .map(|i| {
            let s = f64::from(i);
            Point3::new(s, 10.0 * (0.05 * s).sin(), 0.02 * s)
        })
        .collect();
    let mut points = noisy(&truth, 21, 0.01, 3);
    points[33].z += 1.0;
    let heights = Heights::ByNoise;
    for outliers in [Outliers::Keep, Outliers::Drop] {
        let fit = FairFit::new(&points, &FairFitOptions { heights, outliers, ..by_noise(false) }).unwrap();
        let named: Vec<usize> = fit
            .warnings()
            .iter()
            .filter_map(
                |w| if let Warning::Noise(NoiseWarning::Outlier { point, .. }) = w { Some(*point) } else { None },
            )
            .collect();
        assert_eq!(named, [33]);
        let noise = fit.certificate().noise_z.unwrap();
        assert!((0.005..0.02).contains(&noise), "{noise}");
        let far = truth.iter().map(|p| closest_point(fit.spline(), *p).distance).fold(0.0, f64::max);
        assert!(far < 0.05, "{far}");
    }
}

#[test]
fn a_shallow_turn_between_long_sides_is_a_corner() {
    for k in 0..12 {
        // Of a quadrilateral with one turn of 2 to 13 degrees, outside and in.
        let rise = 100.0 * (f64::from(k + 2)).to_radians().tan() * if k % 2 == 0 { 0.5 } else { -0.5 };
        let points = [[0.0, 0.0], [100.0, -rise], [200.0, 0.0], [120.0, 90.0]].map(|[x, y]| Point3::new(x, y, 0.0));
        let fit = FairFit::new(&points, &closed(0.02)).unwrap();
        assert!(fit.certificate().polyline_deviation <= 0.02, "{k}: {:?}", fit.certificate());
    }
}

#[test]
fn outliers_of_straight_runs_are_left_out_within_a_tolerance_too() {
    let at = |i: usize| Point3::new(i as f64, if i < 30 { 0.0 } else { 0.01 * ((i - 30) as f64).powi(2) }, 0.0);
    let mut points = noisy(&(0..60).map(at).collect::<Vec<_>>(), 2, 0.01, 2);
    points[12].y += 0.4;
    let options = FairFitOptions { outliers: Outliers::Drop, ..FairFitOptions::new(0.05) };
    let fit = FairFit::new(&points, &options).unwrap();
    let is_named = |w: &Warning| matches!(w, Warning::Noise(NoiseWarning::Outlier { point: 12, dropped: true, .. }));
    assert!(fit.warnings().iter().any(is_named), "{:?}", fit.warnings());
    assert!(closest_point(fit.spline(), at(12)).distance < 0.06);
}

#[test]
fn short_edges_of_exact_outlines_are_kept() {
    let outline = |points: &[[f64; 2]]| points.iter().map(|[x, y]| Point3::new(*x, *y, 0.0)).collect::<Vec<_>>();
    for k in 1..12 {
        let thin = 0.1 * f64::from(k);
        let strip = outline(&[[0.0, 0.0], [300.0, 0.0], [300.0, thin], [0.0, thin]]);
        // A plate with a slit that is as wide.
        let slit = outline(&[
            [0.0, 0.0],
            [120.0, 0.0],
            [120.0, 80.0],
            [60.0 + thin, 80.0],
            [60.0 + thin, 30.0],
            [60.0, 30.0],
            [60.0, 80.0],
            [0.0, 80.0],
        ]);
        for points in [strip, slit] {
            let options = FairFitOptions { closed: true, ..FairFitOptions::by_noise(Noise::Estimated) };
            let fit = FairFit::new(&points, &options).unwrap();
            assert!(fit.certificate().polyline_deviation < 1e-9, "{}", fit.certificate().polyline_deviation);
        }
    }
}
