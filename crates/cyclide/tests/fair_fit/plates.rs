//! Outlines that mix corners and sampled arcs, with details smaller than the tolerance: what is left of them is within the tolerance
//! both ways, smoothed or as arcs (`docs/math/fair-fits.md#nodes`, `docs/math/arc-fitting.md#outlines`).

use crate::data::*;
use cyclide::{
    Point3, Vec3, Warning,
    construct::{ArcFit, ArcFitOptions, FairFit, FairFitOptions, Noise},
    curve::{ParamCurve, closest_point},
    warning::NoiseWarning,
};
use std::f64::consts::PI;

/// Sagitta of the sampled arcs, of at least eight chords.
const SAGITTA: f64 = 0.03;
/// A curve leaves the chords of the coarsest arcs, of radius 6, by 0.12, and about twice that where an arc ends at a corner.
const COARSE: f64 = 0.3;

/// A plate of 100 x 70 whose sides have notches and lugs, slanted ones and semicircles, from far smaller than the tolerance of
/// some fits to a tenth of the plate; coordinates to micrometers, as drawings have them.
fn plate(seed: u64, least: f64) -> Vec<Point3> {
    let mut g = deviates(seed, 400).into_iter().map(|x| 0.25 * x.abs().min(4.0));
    let mut between = |low: f64, high: f64| low + (high - low) * g.next().unwrap();
    let corners = [[0.0, 0.0], [100.0, 0.0], [100.0, 70.0], [0.0, 70.0]];
    let mut points = Vec::new();
    for k in 0..4 {
        let (from, to): ([f64; 2], [f64; 2]) = (corners[k], corners[(k + 1) % 4]);
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        let ahead = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
        let mut at = 0.0;
        let mut place = |x: f64, y: f64| {
            let p = [0, 1].map(|c| from[c] + ahead[c] * x + [-ahead[1], ahead[0]][c] * y);
            points.push(Point3::new((p[0] * 1e3).round() / 1e3, (p[1] * 1e3).round() / 1e3, 0.0));
        };
        place(0.0, 0.0);
        loop {
            at += between(least, 40.0);
            let (width, depth) = (between(least, 12.0), between(-6.0, 6.0));
            let depth = depth.abs().max(least).copysign(depth);
            if at + width > length - least {
                break;
            }
            match between(0.0, 8.0) as u32 {
                0 => [[0.0, 0.0], [0.0, depth], [width, depth], [width, 0.0]].map(|[x, y]| place(at + x, y)).len(),
                1 => {
                    let lean = between(0.1, 0.9) * width;
                    [[0.0, 0.0], [lean, depth], [width, 0.0]].map(|[x, y]| place(at + x, y)).len()
                }
                _ => {
                    let radius = 0.5 * width;
                    let n = (PI / (8.0 * SAGITTA / radius).sqrt()).ceil().max(8.0) as usize;
                    let round = |i: usize| (PI * i as f64 / n as f64).sin_cos();
                    (0..=n).map(round).map(|(s, c)| place(at + radius * (1.0 - c), radius * s * depth.signum())).count()
                }
            };
            at += width;
        }
    }
    points
}

/// Largest distance between a curve and a closed polygon, both ways, by sampling.
fn both_ways(curve: &[Point3], points: &[Point3], nearest: impl Fn(Point3) -> f64) -> f64 {
    let n = points.len();
    let from_edge = |p: &Point3| {
        let to = |i: usize| {
            let (a, v) = (points[i], points[(i + 1) % n] - points[i]);
            let t = ((*p - a).dot(v) / v.length_squared()).clamp(0.0, 1.0);
            p.distance(a + v * t)
        };
        (0..n).map(to).fold(f64::INFINITY, f64::min)
    };
    let of_curve = curve.iter().map(from_edge).fold(0.0, f64::max);
    let places = (0..n).flat_map(|i| (0..4).map(move |k| points[i].lerp(points[(i + 1) % n], f64::from(k) / 4.0)));
    places.map(nearest).fold(of_curve, f64::max)
}

#[test]
fn plates_keep_their_corners_when_smoothed() {
    for seed in 0..40 {
        let points = plate(seed, [0.5, 2.0][seed as usize % 2]);
        for tolerance in [None, Some(0.05), Some(0.5)] {
            let options = tolerance.map_or(FairFitOptions::by_noise(Noise::Estimated), FairFitOptions::new);
            let fit = FairFit::new(&points, &FairFitOptions { closed: true, ..options }).unwrap();
            let curve: Vec<Point3> = (0..4000).map(|i| fit.spline().point(f64::from(i) / 4000.0)).collect();
            let off = both_ways(&curve, &points, |p| closest_point(fit.spline(), p).distance);
            let most = 1.5 * tolerance.unwrap_or(0.0) + COARSE;
            assert!(off < most, "{seed}, {tolerance:?}: {off} of {}; {:?}", points.len(), fit.warnings());
        }
    }
}

#[test]
fn plates_keep_their_sides_as_arcs() {
    let mut said = Vec::new();
    for seed in 0..40 {
        let points = plate(seed, [0.5, 2.0][seed as usize % 2]);
        for tolerance in [0.02, 0.5] {
            let options = ArcFitOptions { closed: true, ..ArcFitOptions::new(tolerance) };
            let fit = ArcFit::new(&points, &options).unwrap();
            let curve: Vec<Point3> = (0..4000).map(|i| fit.path().point(f64::from(i) / 4000.0)).collect();
            let off = both_ways(&curve, &points, |p| fit.path().closest_point(p).distance);
            if fit.warnings().iter().any(|w| w.reason() == "swings-out") {
                said.push((seed, tolerance, off));
                continue;
            }
            assert!(off < 1.5 * tolerance + COARSE, "{seed}, {tolerance}: {off}; {:?}", fit.warnings());
        }
    }
    // Of 80: where the details take far more pieces than a path that swings out, it may not be known from noise.
    assert!(said.len() <= 2, "{said:?}");
}

/// A hook: two long sides, of which one runs smoothly into a sampled curve. Only the curve's samples hold it there, and they are few.
#[test]
fn a_side_that_runs_into_a_curve_stays_straight() {
    let [from, to] = [[15.4476, 0.0], [20.795, 2.3714]];
    for k in 0..60 {
        let tolerance = [0.02, 0.05, 0.08, 0.15][k % 4];
        // From the side round, with a bend to either side.
        let bend = |t: f64| 0.4 * (3.0 * t).sin() * t * (1.0 - t) * (1.0 + 0.2 * k as f64);
        let samples = 6 + k % 16;
        let curve = (0..=samples).map(|i| i as f64 / samples as f64);
        let arc = curve.map(|t| [from[0] + (to[0] - from[0]) * t, to[1] * t * t - bend(t) * t]);
        let corners = [[23.1977, 0.1951], [30.9043, -6.2417], [0.0, -6.2417]];
        let points: Vec<Point3> =
            [[0.0, 0.0]].into_iter().chain(arc).chain(corners).map(|[x, y]| Point3::new(x, y, 0.0)).collect();
        let fit = FairFit::new(&points, &FairFitOptions { closed: true, ..FairFitOptions::new(tolerance) }).unwrap();
        // The first side and the long ones behind the curve.
        let n = points.len();
        let off = [0, n - 3, n - 2, n - 1]
            .into_iter()
            .flat_map(|i| (0..=40).map(move |j| (i, f64::from(j) / 40.0)))
            .map(|(i, t)| closest_point(fit.spline(), points[i].lerp(points[(i + 1) % n], t)).distance)
            .fold(0.0, f64::max);
        assert!(off < 2.5 * tolerance, "{k}, {tolerance}: {off}; {:?}", fit.warnings());
    }
}

/// A gear with square teeth, their sides sampled, with noise of a tenth of the spacing: a smooth curve cuts every corner by more, so
/// much that it takes the teeth for noise.
#[test]
fn corners_of_noisy_gears_are_kept() {
    // At the lesser noise a smooth curve bends in every corner, and is off none of the points.
    let gears = [[40.0, 24.0, 26.0, 0.3], [20.0, 24.0, 28.0, 0.4], [60.0, 40.0, 42.0, 0.3], [12.0, 20.0, 26.0, 0.5]];
    let of_noises = |gear| [0.06, 0.1].map(|noise| (gear, noise));
    for (seed, ([teeth, inner, outer, spacing], noise)) in gears.into_iter().flat_map(of_noises).enumerate() {
        let n = 4 * teeth as usize;
        let corner = |k: usize| {
            let angle = PI * (k / 2 + k % 2) as f64 / teeth;
            let radius = if k % 4 < 2 { inner } else { outer };
            Point3::new(radius * angle.cos(), radius * angle.sin(), 0.0)
        };
        let side = |k: usize| {
            let [from, to] = [k, k + 1].map(|k| corner(k % n));
            let count = (from.distance(to) / spacing).ceil();
            (0..count as usize).map(move |j| from.lerp(to, j as f64 / count))
        };
        let exact: Vec<Point3> = (0..n).flat_map(side).collect();
        let sigma = noise * spacing;
        let noise = deviates(500 + seed as u64, 2 * exact.len());
        let moved = |(p, e): (&Point3, &[f64])| *p + Vec3::new(e[0], e[1], 0.0) * sigma;
        let points: Vec<Point3> = exact.iter().zip(noise.chunks(2)).map(moved).collect();
        let options = FairFitOptions { closed: true, ..FairFitOptions::by_noise(Noise::Estimated) };
        let fit = FairFit::new(&points, &options).unwrap();
        let read = fit.certificate().noise.unwrap();
        assert!((0.9..1.15).contains(&(read / sigma)), "{seed}: noise {read} of {sigma}");
        let off = exact.iter().map(|p| closest_point(fit.spline(), *p).distance).fold(0.0, f64::max);
        assert!(off < 4.0 * sigma, "{seed}: {off} for noise of {sigma}; {:?}", fit.warnings());
    }
}

/// Scanned outlines, whose points lie anywhere on the sides and none on a corner: it is where the sides meet.
#[test]
fn corners_between_points_are_found() {
    let plus: Vec<Point3> =
        [(2, 0), (4, 0), (4, 2), (6, 2), (6, 4), (4, 4), (4, 6), (2, 6), (2, 4), (0, 4), (0, 2), (2, 2)]
            .map(|(x, y)| Point3::new(10.0 * f64::from(x), 10.0 * f64::from(y), 0.0))
            .to_vec();
    let rectangle = [(0.0, 0.0), (60.0, 0.0), (60.0, 40.0), (0.0, 40.0)].map(|(x, y)| Point3::new(x, y, 0.0)).to_vec();
    let noises = [0.04, 0.07, 0.1];
    let figures = [plus, rectangle];
    for (seed, (figure, sigma)) in figures.iter().flat_map(|figure| noises.map(|noise| (figure, noise))).enumerate() {
        let n = figure.len();
        // At 1/3 past each whole number along the outline, whose sides are 20, 40 and 60 long.
        let side = |k: usize| {
            let (from, to) = (figure[k], figure[(k + 1) % n]);
            let length = from.distance(to);
            (0..length as usize).map(move |j| from.lerp(to, (j as f64 + 1.0 / 3.0) / length))
        };
        let exact: Vec<Point3> = (0..n).flat_map(side).collect();
        let noise = deviates(700 + seed as u64, 2 * exact.len());
        let moved = |(p, e): (&Point3, &[f64])| *p + Vec3::new(e[0], e[1], 0.0) * sigma;
        let points: Vec<Point3> = exact.iter().zip(noise.chunks(2)).map(moved).collect();
        let options = FairFitOptions { closed: true, ..FairFitOptions::by_noise(Noise::Estimated) };
        let fit = FairFit::new(&points, &options).unwrap();
        assert!(fit.warnings().iter().any(|w| w.reason() == "corners-inserted"), "{seed}: {:?}", fit.warnings());
        let off = figure.iter().map(|p| closest_point(fit.spline(), *p).distance).fold(0.0, f64::max);
        assert!(off < 4.0 * sigma, "{seed}: {off} for noise of {sigma}; {:?}", fit.warnings());
        let read = fit.certificate().noise.unwrap();
        assert!((0.85..1.15).contains(&(read / sigma)), "{seed}: noise {read} of {sigma}");
    }
}

#[test]
fn corners_of_turned_outlines_that_are_rounded_stay() {
    // Sides of a stair of two to ten samples, turned, to hundredths.
    let stair = [[0, 0], [60, 0], [60, 26], [40, 26], [40, 30], [22, 30], [22, 44], [0, 44]];
    for turn in [0.3_f64, 1.1, 1.47] {
        let (sin, cos) = turn.sin_cos();
        let hundredths = |x: f64| (100.0 * x).round() / 100.0;
        let mut points = Vec::new();
        for (k, from) in stair.iter().enumerate() {
            let (from, to) = (from.map(f64::from), stair[(k + 1) % stair.len()].map(f64::from));
            for i in 0..10 * ((to[0] - from[0]).abs() + (to[1] - from[1]).abs()) as u32 / 20 {
                let part = 2.0 * f64::from(i) / ((to[0] - from[0]).abs() + (to[1] - from[1]).abs());
                let [x, y] = [0, 1].map(|c| from[c] + (to[c] - from[c]) * part);
                points.push(Point3::new(hundredths(cos * x - sin * y), hundredths(sin * x + cos * y), 0.0));
            }
        }
        let fit = fitted(&points, &FairFitOptions { closed: true, ..FairFitOptions::by_noise(Noise::Estimated) });
        assert_eq!(fit.spline().kinks().len(), stair.len(), "turned by {turn}: {:?}", fit.warnings());
        assert!(fit.certificate().deviation < 0.02, "turned by {turn}: {}", fit.certificate().deviation);
    }
}

#[test]
fn chamfers_of_rounded_outlines_are_not_cut() {
    // Chamfers of one to three samples on a turned rectangle, to hundredths: smoothed by the noise, and within 1.
    for (seed, chamfer) in [2.0_f64, 2.5, 3.0, 4.0, 5.0, 8.0].into_iter().enumerate() {
        let (c, step): (f64, f64) = (chamfer, 4.0);
        let corners: [[f64; 2]; 8] = [
            [c, 0.0],
            [60.0 - c, 0.0],
            [60.0, c],
            [60.0, 40.0 - c],
            [60.0 - c, 40.0],
            [c, 40.0],
            [0.0, 40.0 - c],
            [0.0, c],
        ];
        let (sin, cos) = (0.3 + 0.2 * seed as f64).sin_cos();
        let hundredths = |x: f64| (100.0 * x).round() / 100.0;
        let mut points = Vec::new();
        for (k, a) in corners.iter().enumerate() {
            let b = corners[(k + 1) % 8];
            let count = ((b[0] - a[0]).hypot(b[1] - a[1]) / step).round().max(1.0);
            for i in 0..count as u32 {
                let [x, y] = [0, 1].map(|d| a[d] + (b[d] - a[d]) * f64::from(i) / count);
                points.push(Point3::new(hundredths(cos * x - sin * y), hundredths(sin * x + cos * y), 0.0));
            }
        }
        let automatic = FairFitOptions::by_noise(Noise::Estimated);
        for (options, most) in [(automatic, 0.02), (FairFitOptions::new(0.02), 0.03), (FairFitOptions::new(1.0), 1.02)]
        {
            let fit = fitted(&points, &FairFitOptions { closed: true, ..options });
            let off = fit.certificate().polyline_deviation;
            assert!(off < most, "chamfers of {chamfer}: {off}; {:?}", fit.warnings());
            let kept = fit.spline().kinks().len();
            assert!(kept == 8, "chamfers of {chamfer}: {kept} corners");
        }
    }
}

/// Teeth of a saw, 6 high and long, measured every 3 with a noise of 0.18, on a plate.
fn saw(seed: u64) -> Vec<Point3> {
    let teeth = (0..15).flat_map(|k| [0.0, 6.0].map(|y| [6.0 * f64::from(k), y]));
    let outline: Vec<[f64; 2]> = teeth.chain([[90.0, 0.0], [90.0, -26.0], [0.0, -26.0]]).collect();
    let mut noise = deviates(seed, 400).into_iter().map(|x| 0.18 * x);
    let mut at = 1.0;
    let mut points = Vec::new();
    for (k, from) in outline.iter().enumerate() {
        let to = outline[(k + 1) % outline.len()];
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        while at < length {
            let [x, y] = [0, 1].map(|c| from[c] + (to[c] - from[c]) * at / length + noise.next().unwrap());
            points.push(Point3::new(x, y, 0.0));
            at += 3.0;
        }
        at -= length;
    }
    points
}

#[test]
fn teeth_of_a_few_points_are_no_noise() {
    for seed in 0..8 {
        let points = saw(seed);
        let fit = fitted(&points, &FairFitOptions { closed: true, ..FairFitOptions::by_noise(Noise::Estimated) });
        let noise = fit.certificate().noise.unwrap();
        // Smoothed away they would be noise of 1.6.
        assert!((0.05..0.6).contains(&noise), "seed {seed}: {noise}");
        // A tip that is taken for a wrong point is named.
        let named = |i: usize| {
            let is = |w: &Warning| matches!(w, Warning::Noise(NoiseWarning::Outlier { point, .. }) if *point == i);
            fit.warnings().iter().any(is)
        };
        for (i, p) in points.iter().enumerate() {
            let off = closest_point(fit.spline(), *p).distance;
            assert!(off < 1.5 || named(i), "seed {seed}, point {i}: {off}");
        }
    }
}
