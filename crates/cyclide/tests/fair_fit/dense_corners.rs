//! Corners of walks whose points are nearer to each other than their noise is wide: they are found where the streets cross, and roads
//! that only bend have none (`docs/math/fair-fits.md#noise`).

use crate::data::*;
use cyclide::{
    Point3,
    construct::{FairFit, FairFitOptions, Heights, Noise},
    curve::closest_point,
};
use std::f64::consts::{FRAC_PI_2, PI};

/// Points along a polyline, so far apart, but for the last.
fn along(corners: &[Point3], closed: bool, step: f64) -> Vec<Point3> {
    let n = corners.len();
    let leg = |k: usize| {
        let (from, to) = (corners[k], corners[(k + 1) % n]);
        let count = (from.distance(to) / step).ceil();
        (0..count as usize).map(move |i| from.lerp(to, (i as f64 + 0.4) / count))
    };
    (0..if closed { n } else { n - 1 }).flat_map(leg).collect()
}

/// The root mean square and the largest distance of places from the fit.
fn off(fit: &FairFit, places: &[Point3]) -> (f64, f64) {
    let offs: Vec<f64> = places.iter().map(|p| closest_point(fit.spline(), *p).distance).collect();
    let squares: f64 = offs.iter().map(|off| off * off).sum();
    ((squares / offs.len() as f64).sqrt(), offs.into_iter().fold(0.0, f64::max))
}

fn by_noise(points: &[Point3], closed: bool) -> FairFit {
    FairFit::new(points, &FairFitOptions { closed, ..FairFitOptions::by_noise(Noise::Estimated) }).unwrap()
}

#[test]
fn streets_meet_in_corners() {
    let walk = [[0, 0], [110, 0], [110, 90], [20, 90], [20, 200], [130, 200], [130, 110], [220, 110]];
    let block = [[0, 0], [150, 0], [150, 70], [240, 70], [240, 180], [0, 180]];
    let corners = |list: &[[i32; 2]]| -> Vec<Point3> {
        list.iter().map(|[x, y]| Point3::new(f64::from(*x), f64::from(*y), 0.0)).collect()
    };
    for (seed, (sigma, step)) in [(3.0, 0.7), (1.5, 0.8), (2.0, 0.8), (1.0, 1.0)].into_iter().enumerate() {
        for (figure, closed) in [(corners(&walk), false), (corners(&block), true)] {
            let exact = along(&figure, closed, step);
            let fit = by_noise(&noisy(&exact, 40 + seed as u64, sigma, 2), closed);
            let count = figure.len() - if closed { 0 } else { 2 };
            let case = format!("{sigma} {step} {closed}: {:?}", fit.warnings());
            assert!(fit.warnings().iter().any(|w| w.reason() == "corners-inserted"), "{case}");
            assert!(
                fit.spline().kinks().len() + 1 >= count,
                "{} of {count} corners, {case}",
                fit.spline().kinks().len()
            );
            let noise = fit.certificate().noise.unwrap();
            assert!((0.9..1.1).contains(&(noise / sigma)), "noise {noise}, {case}");
            // A curve that rounds each corner off by a deviation, and wavers on both sides of it, has twice that.
            let (rms, most) = off(&fit, &exact);
            assert!(rms < 0.3 * sigma && most < 2.5 * sigma, "{rms} and {most} off, {case}");
        }
    }
}

#[test]
fn streets_that_climb_keep_their_heights() {
    let corners = [[0.0, 0.0], [110.0, 0.0], [110.0, 90.0], [20.0, 90.0], [20.0, 200.0], [130.0, 200.0]];
    let (sigma, sigma_z) = (1.5, 4.0);
    let mut exact = along(&corners.map(|[x, y]| Point3::new(x, y, 0.0)), false, 0.8);
    exact.iter_mut().enumerate().for_each(|(i, p)| p.z = 300.0 + 0.1 * i as f64);
    let mut points = noisy(&exact, 17, sigma, 2);
    let heights = deviates(18, points.len());
    points.iter_mut().zip(&exact).zip(heights).for_each(|((p, e), z)| p.z = e.z + sigma_z * z);
    let options = FairFitOptions { heights: Heights::ByNoise, ..FairFitOptions::by_noise(Noise::Estimated) };
    let fit = FairFit::new(&points, &options).unwrap();
    assert!(fit.spline().kinks().len() >= 3, "{:?}", fit.warnings());
    let (rms, most) = off(&fit, &exact);
    assert!(rms < 0.5 * sigma && most < 2.5 * sigma, "{rms} and {most} off: {:?}", fit.warnings());
}

#[test]
fn roads_that_bend_have_no_corners() {
    for (seed, (sigma, radius)) in [(3.0, 30.0), (1.5, 20.0), (1.0, 12.0), (0.5, 10.0)].into_iter().enumerate() {
        for turn in [FRAC_PI_2, PI] {
            // Straight roads with bends to the left and to the right between them.
            let (mut exact, mut at, mut heading) = (Vec::new(), Point3::ORIGIN, 0.0_f64);
            for k in 0..5 {
                let left = if k % 2 == 0 { 1.0 } else { -1.0 };
                for (length, curvature) in [(100.0, 0.0), (radius * turn, left / radius)] {
                    for _ in 0..length as usize {
                        heading += 0.5 * curvature;
                        at = Point3::new(at.x + heading.cos(), at.y + heading.sin(), 0.0);
                        heading += 0.5 * curvature;
                        exact.push(at);
                    }
                }
            }
            let fit = by_noise(&noisy(&exact, 60 + seed as u64, sigma, 2), false);
            assert!(fit.spline().kinks().is_empty(), "{sigma} {radius} {turn}: {:?}", fit.warnings());
        }
    }
}
