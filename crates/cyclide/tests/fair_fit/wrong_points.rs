//! Runs of wrong points among measured ones, and polygons that are given as measured points
//! (`docs/math/fair-fits.md#outliers`).

use crate::data::*;
use cyclide::{
    Point3, Vec3, Warning,
    construct::{FairFit, FairFitOptions, Heights, Noise, Outliers},
    curve::closest_point,
    warning::NoiseWarning,
};
use std::f64::consts::TAU;

fn by_noise(closed: bool) -> FairFitOptions {
    FairFitOptions { closed, ..FairFitOptions::by_noise(Noise::Estimated) }
}

fn of(points: &[Point3], options: &FairFitOptions) -> FairFit {
    FairFit::new(points, options).unwrap()
}

/// Numbers of the points that are named as outliers.
fn named(fit: &FairFit) -> Vec<usize> {
    let number =
        |w: &Warning| if let Warning::Noise(NoiseWarning::Outlier { point, .. }) = w { Some(*point) } else { None };
    fit.warnings().iter().filter_map(number).collect()
}

/// A closed walk of so many points, a step apart, with waves that a seed chooses.
fn walk(seed: u64, count: usize, step: f64) -> Vec<Point3> {
    let g = deviates(seed, 6);
    let radius = count as f64 * step / TAU;
    let at = |i: usize| {
        let a = TAU * i as f64 / count as f64;
        let r = radius * (1.0 + 0.08 * g[0] * (2.0 * a + g[1]).cos() + 0.05 * g[2] * (3.0 * a + g[3]).cos());
        Point3::new(r * a.cos(), 0.8 * r * a.sin(), 0.0)
    };
    (0..count).map(at).collect()
}

#[test]
fn runs_of_outliers_are_named_and_hold_nothing() {
    let mut innocent = 0;
    for seed in 0..24 {
        let length = 2 + seed as usize % 3;
        let (count, step) = ([120, 300, 600][seed as usize % 3], [1.0, 2.0, 4.0, 8.0][seed as usize % 4]);
        let truth = walk(seed, count, step);
        // Noise of 1 in steps of 1 to 8, runs 15 and 30 away.
        let mut points = noisy(&truth, 100 + seed, 1.0, 2);
        let mut wrong = Vec::new();
        for (from, far) in [(count / 4, 15.0), (2 * count / 3, 30.0)] {
            let across = (truth[from + 1] - truth[from - 1]).cross(Vec3::Z).unit().unwrap();
            points[from..from + length].iter_mut().for_each(|p| *p += across * far);
            wrong.extend(from..from + length);
        }
        let fit = of(&points, &by_noise(true));
        let found = named(&fit);
        assert!(wrong.iter().all(|i| found.contains(i)), "{seed}: {found:?} of {wrong:?}");
        innocent += found.len() - wrong.len();
        let left = FairFitOptions { outliers: Outliers::Drop, ..by_noise(true) };
        let fit = of(&points, &left);
        let off = |p: &Point3| closest_point(fit.spline(), *p).distance;
        let most = truth.iter().map(off).fold(0.0, f64::max);
        // A run of four points left out is a gap that the curve bridges.
        assert!(most < 4.0, "{seed}: {most}");
    }
    assert!(innocent <= 2, "{innocent}");
}

#[test]
fn a_right_point_between_two_wrong_ones_stays() {
    for seed in 0..16 {
        let (count, step) = ([120, 300][seed as usize % 2], [1.0, 3.0][seed as usize / 8]);
        let truth = walk(seed, count, step);
        let mut points = noisy(&truth, 700 + seed, 0.3 * step, 2);
        let from = count / 3;
        let across = (truth[from + 1] - truth[from - 1]).cross(Vec3::Z).unit().unwrap();
        for i in [from, from + 2] {
            points[i] += across * ([4.0, 8.0, 20.0][seed as usize % 3] * step);
        }
        assert_eq!(named(&of(&points, &by_noise(true))), [from, from + 2], "{seed}");
    }
}

#[test]
fn runs_of_wrong_heights_are_named() {
    let (mut missed, mut innocent) = (Vec::new(), 0);
    for seed in 0..16 {
        let (count, step, length) =
            ([120, 300][seed as usize % 2], [1.0, 5.0, 20.0][seed as usize % 3], 2 + seed as usize % 4);
        let mut points = noisy(&walk(seed, count, step), 400 + seed, 0.02, 3);
        points.truncate(count * 3 / 4);
        for (i, p) in points.iter_mut().enumerate() {
            p.z += 3.0 * (4.0 * i as f64 / count as f64).sin();
        }
        let wrong = count / 3..count / 3 + length;
        points[wrong.clone()].iter_mut().for_each(|p| p.z += 0.8);
        let options = FairFitOptions { heights: Heights::ByNoise, ..by_noise(false) };
        let fit = of(&points, &options);
        let found = named(&fit);
        missed.extend(wrong.clone().filter(|i| !found.contains(i)).map(|i| (seed, i)));
        // Also where the ground rises by as much from one point to the next: within the noise, and the bend over the run.
        for warning in fit.warnings() {
            if let Warning::Noise(NoiseWarning::Outlier { point, distance, .. }) = warning
                && wrong.contains(point)
            {
                assert!((distance - 0.8).abs() < 0.12, "{seed}, {point}: {distance}");
            }
        }
        innocent += found.iter().filter(|i| !wrong.contains(i)).count();
    }
    // Of 56.
    assert!(missed.len() <= 3 && innocent <= 1, "{missed:?} missed, {innocent} innocent");
}

/// Noise brings points together on the way, so that right heights beside wrong ones are as far from the others. And a wrong height is no
/// corner.
#[test]
fn wrong_heights_are_told_from_those_beside_them() {
    for seed in 0..24 {
        let (count, length) = ([150, 400, 500][seed as usize % 3], 1 + seed as usize % 3);
        let (closed, sigma) = (seed % 2 == 0, [1.5, 4.0][seed as usize / 2 % 2]);
        let mut points = noisy(&walk(seed, count, 2.6), 700 + seed, 1.5, 2);
        if !closed {
            points.truncate(count * 3 / 4);
        }
        let heights = deviates(800 + seed, points.len());
        for (i, p) in points.iter_mut().enumerate() {
            p.z = 20.0 * (2.0 * TAU * i as f64 / count as f64).sin() + sigma * heights[i];
        }
        let wrong: Vec<usize> = [20, count / 3, count / 2].into_iter().flat_map(|from| from..from + length).collect();
        wrong.iter().for_each(|i| points[*i].z += 20.0 * sigma);
        let options = FairFitOptions { heights: Heights::ByNoise, outliers: Outliers::Drop, ..by_noise(closed) };
        assert_eq!(named(&of(&points, &options)), wrong, "{seed}");
    }
}

#[test]
fn clean_walks_have_no_runs_of_outliers() {
    for seed in 0..24 {
        let (count, step) = ([60, 150, 400][seed as usize % 3], [1.0, 2.0, 4.0, 8.0][seed as usize % 4]);
        let points = noisy(&walk(seed, count, step), 200 + seed, 1.0, 2);
        let found = named(&of(&points, &by_noise(true)));
        assert!(found.len() <= 1, "{seed}: {found:?}");
    }
}

/// Samples of a walk at so many places, as far apart as chance has them, and the directions across there.
fn uneven_walk(seed: u64, count: usize) -> (Vec<Point3>, Vec<Vec3>) {
    let dense = walk(seed, 16 * count, 1.0 / 16.0);
    let mut at: Vec<usize> = deviates(900 + seed, 2 * count)
        .chunks(2)
        .map(|g| (16.0 * count as f64 * (-0.5 * (g[0] * g[0] + g[1] * g[1])).exp()) as usize)
        .collect();
    at.sort_unstable();
    at.dedup();
    let n = dense.len();
    let across = |i: &usize| (dense[(i + 1) % n] - dense[(i + n - 1) % n]).cross(Vec3::Z).unit().unwrap();
    (at.iter().map(|i| dense[*i]).collect(), at.iter().map(across).collect())
}

#[test]
fn points_that_are_unevenly_far_apart_are_no_outliers() {
    let (mut innocent, mut missed) = (0, 0);
    for seed in 0..40 {
        let (truth, across) = uneven_walk(seed, [80, 150, 300, 600][seed as usize % 4]);
        let noise = [0.01, 0.1, 0.3, 1.0][seed as usize / 4 % 4];
        let clean = noisy(&truth, 300 + seed, noise, 2);
        innocent += named(&of(&clean, &by_noise(true))).len();
        // One that is one.
        let mut points = clean;
        let wrong = truth.len() / 2;
        points[wrong] += across[wrong] * (12.0 * noise + 3.0);
        missed += usize::from(!named(&of(&points, &by_noise(true))).contains(&wrong));
    }
    assert!(innocent <= 3 && missed <= 4, "{innocent} innocent, {missed} missed");
}

#[test]
fn a_tooth_of_an_exact_outline_is_no_run_of_outliers() {
    // A circle of 100 points with a tooth of two.
    let mut points: Vec<Point3> = (0..100)
        .map(|i| TAU * f64::from(i) / 100.0)
        .map(|t| Point3::new(40.0 * t.cos(), 40.0 * t.sin(), 0.0))
        .collect();
    for p in &mut points[30..32] {
        *p = Point3::ORIGIN + p.to_vec() * 1.2;
    }
    let fit = of(&points, &by_noise(true));
    assert!(named(&fit).is_empty());
    assert!(points.iter().all(|p| closest_point(fit.spline(), *p).distance < 0.05));
}

#[test]
fn a_slit_in_a_measured_outline_is_no_run_of_outliers() {
    // A plate of 120 x 60 in steps of 2, with a slit 1 wide and 12 deep that has no samples on its flanks.
    let side = |from: [f64; 2], to: [f64; 2]| {
        let n = ((to[0] - from[0]).hypot(to[1] - from[1]) / 2.0).round();
        let at = move |k: usize| [0, 1].map(|c| from[c] + (to[c] - from[c]) * k as f64 / n);
        (0..n as usize).map(at)
    };
    let mut points: Vec<[f64; 2]> = side([0.0, 0.0], [60.0, 0.0]).collect();
    points.extend([[60.0, 0.0], [60.0, 12.0], [61.0, 12.0]]);
    points.extend(side([61.0, 0.0], [121.0, 0.0]).chain(side([121.0, 0.0], [121.0, 60.0])));
    points.extend(side([121.0, 60.0], [0.0, 60.0]).chain(side([0.0, 60.0], [0.0, 0.0])));
    let points: Vec<Point3> = points.into_iter().map(|[x, y]| Point3::new(x, y, 0.0)).collect();
    let fit = of(&noisy(&points, 3, 0.03, 2), &by_noise(true));
    assert!(named(&fit).is_empty(), "{:?}", fit.warnings());
    assert!(points.iter().all(|p| closest_point(fit.spline(), *p).distance < 0.3));
}

#[test]
fn exact_saws_and_stairs_are_kept_where_noise_is_looked_for() {
    let mut g = deviates(31, 2000).into_iter().map(|x| x.abs().min(2.0));
    let mut size = |low: f64, high: f64| low + (high - low) * g.next().unwrap() / 2.0;
    for k in 0..40 {
        let teeth = 4 + k % 15;
        let (mut points, mut x) = (Vec::new(), 0.0);
        for i in 0..2 * teeth {
            x += size(5.0, 12.0);
            points.push([x, if i % 2 == 1 { size(4.0, 9.0) } else { 0.0 }]);
        }
        if k % 2 == 0 {
            // Stairs: of each pair of points the second is above the first.
            let steps = points.clone();
            points = (0..steps.len() / 2)
                .flat_map(|i| [[8.0 * i as f64, 5.0 * i as f64], [8.0 * i as f64, 5.0 * (i + 1) as f64]])
                .collect();
            x = 8.0 * (steps.len() / 2 - 1) as f64;
        }
        points.extend([[x + 1.0, -20.0], [0.0, -20.0]]);
        let points: Vec<Point3> = points.into_iter().map(|[x, y]| Point3::new(x, y, 0.0)).collect();
        let fit = of(&points, &by_noise(true));
        assert!(fit.certificate().polyline_deviation < 1e-3, "{k}: {}", fit.certificate().polyline_deviation);
    }
}

#[test]
fn few_scattered_points_may_be_corners_and_that_is_said() {
    let g = deviates(77, 30);
    let at = |i: usize| {
        let (s, c) = (TAU * i as f64 / 30.0).sin_cos();
        let r = 50.0 + 2.0 * g[i];
        Point3::new(r * c, r * s, 0.0)
    };
    let points: Vec<Point3> = (0..30).map(at).collect();
    let fit = of(&points, &by_noise(true));
    assert!(fit.warnings().iter().any(|w| w.reason() == "few-for-noise"), "{:?}", fit.warnings());
}

/// A survey has its points far apart for its noise: its bends are larger than what a wrong point is off.
#[test]
fn wrong_points_among_points_far_apart_are_named() {
    for seed in 0..24 {
        let (count, off) = ([60, 90, 200][seed as usize % 3], [0.5, 0.8, 1.5, 5.0][seed as usize % 4]);
        let truth = walk(seed, count, 10.0);
        let mut points = noisy(&truth, 300 + seed, 0.01, 2);
        assert!(named(&of(&points, &by_noise(true))).is_empty(), "{seed}");
        let wrong = [count / 3, 3 * count / 4];
        for i in wrong {
            let across = (truth[i + 1] - truth[i - 1]).cross(Vec3::Z).unit().unwrap();
            points[i] += across * off;
        }
        assert_eq!(named(&of(&points, &by_noise(true))), wrong, "{seed}: {off} of {count}");
        let left = FairFitOptions { outliers: Outliers::Drop, ..by_noise(true) };
        let fit = of(&points, &left);
        let most = truth.iter().map(|p| closest_point(fit.spline(), *p).distance).fold(0.0, f64::max);
        assert!(most < 0.1, "{seed}: {most}");
    }
}
