//! Data that nobody wants: named errors, no panic, no runaway.

use crate::data::*;
use cyclide::{
    Error, Point3,
    construct::{FairFit, FairFitOptions},
    error::FitError,
    warning::FitWarning,
};

fn reason(points: &[[f64; 3]], options: &FairFitOptions) -> &'static str {
    let points: Vec<Point3> = points.iter().map(|p| Point3::from(*p)).collect();
    FairFit::new(&points, options).unwrap_err().reason()
}

#[test]
fn bad_input_is_named() {
    let open = FairFitOptions::new(0.1);
    let line = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
    for tolerance in [0.0, -1.0, f64::NAN] {
        assert_eq!(reason(&line, &FairFitOptions { tolerance, ..open.clone() }), "tolerance-not-positive");
    }
    assert_eq!(reason(&line, &FairFitOptions { tolerance: f64::INFINITY, ..open.clone() }), "not-finite");
    assert_eq!(reason(&[[0.0; 3]], &open), "too-few-points");
    assert_eq!(reason(&[], &open), "too-few-points");
    assert_eq!(reason(&line[..2], &FairFitOptions { closed: true, ..open.clone() }), "too-few-points");
    assert_eq!(reason(&[[1.0; 3]; 5], &open), "coincident-points");
    assert_eq!(reason(&[[0.0; 3], [f64::NAN, 0.0, 0.0], [1.0; 3]], &open), "not-finite");
    assert_eq!(reason(&[[0.0; 3], [1e200, 0.0, 0.0]], &open), "parameter-out-of-range");
    for options in [
        FairFitOptions { centre: -1.0, ..open.clone() },
        FairFitOptions { centre: f64::NAN, ..open.clone() },
        FairFitOptions { centre: 2e6, ..open.clone() },
        FairFitOptions { budget: -0.1, ..open.clone() },
        FairFitOptions { budget: f64::INFINITY, ..open.clone() },
        FairFitOptions { nodes: Some(1), ..open.clone() },
        FairFitOptions { edge_points: 101, ..open.clone() },
        FairFitOptions { corner_angle: Some(0.0), ..open.clone() },
        FairFitOptions { corner_angle: Some(4.0), ..open.clone() },
        FairFitOptions { corners: vec![3], ..open.clone() },
    ] {
        assert_eq!(reason(&line, &options), "parameter-out-of-range", "{options:?}");
    }
}

#[test]
fn lines_have_no_variation() {
    for n in [2, 3, 4, 5, 50] {
        let points: Vec<Point3> = (0..n).map(|i| Point3::new(i as f64, 2.0 * i as f64, -0.5 * i as f64)).collect();
        for fix_ends in [false, true] {
            let fit = fitted(&points, &FairFitOptions { fix_ends, ..FairFitOptions::new(0.1) });
            assert_eq!(fit.certificate().nodes, 2);
            // Rounding of the coordinates, 100 at most, which the stiffest smoother magnifies.
            let (fairness, deviation) = (fit.certificate().fairness, fit.certificate().deviation);
            assert!(fairness < 1e-20 && deviation < 1e-11, "{n} {fix_ends}: {fairness} {deviation}");
        }
    }
    // Noisy: still straight.
    let g = deviates(11, 200);
    let points: Vec<Point3> = (0..200).map(|i| Point3::new(i as f64, 0.1 * g[i], 0.0)).collect();
    let fit = fitted(&points, &FairFitOptions::new(0.5));
    let (var, _) = variation(fit.spline());
    assert!(var < 1e-6 && fit.certificate().nodes <= 4, "{var} {}", fit.certificate().nodes);
}

#[test]
fn few_points_have_a_curve() {
    let corner =
        |n: usize| [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 2.0, 0.0], [0.0, 2.0, 1.0], [1.0, 1.0, 3.0]][..n].to_vec();
    for n in 3..=5 {
        let points: Vec<Point3> = corner(n).into_iter().map(Point3::from).collect();
        for closed in [false, true] {
            for tolerance in [1e-3, 0.1, 1.0, 100.0] {
                fitted(&points, &FairFitOptions { closed, ..FairFitOptions::new(tolerance) });
            }
        }
    }
}

#[test]
fn scale_and_place_change_nothing_but_rounding() {
    let points = noisy_outline();
    let plain = fitted(&points, &closed(0.4));
    for scale in [1e-120, 1e-9, 1e9, 1e120] {
        let scaled: Vec<Point3> = points.iter().map(|p| Point3::new(p.x * scale, p.y * scale, 0.0)).collect();
        let fit = FairFit::new(&scaled, &closed(0.4 * scale)).unwrap();
        assert_eq!(fit.certificate().nodes, plain.certificate().nodes, "{scale}");
        assert!((fit.certificate().deviation / (0.4 * scale) - plain.certificate().deviation / 0.4).abs() < 1e-6);
    }
    let far: Vec<Point3> = points.iter().map(|p| Point3::new(p.x + 1e7, p.y - 1e7, 1e7)).collect();
    let fit = FairFit::new(&far, &closed(0.4)).unwrap();
    // The coordinates are rounded to 2e-9 there, the curvature changes by that over the square of a chord.
    assert!(fit.certificate().nodes.abs_diff(plain.certificate().nodes) <= 3);
    // A tolerance below the rounding of the coordinates cannot be kept, and is not claimed.
    match FairFit::new(&far, &closed(1e-12)) {
        Ok(fit) => assert!(fit.certificate().deviation <= 1e-12),
        Err(error) => assert_eq!(error.reason(), "tolerance-not-reached"),
    }
}

#[test]
fn wild_data_end_in_a_curve_or_a_named_error() {
    let g = deviates(3, 4000);
    let cloud: Vec<Point3> = (0..300).map(|i| Point3::new(g[3 * i], g[3 * i + 1], 0.0)).collect();
    let cloud3: Vec<Point3> = (0..200).map(|i| Point3::new(g[3 * i], g[3 * i + 1], g[3 * i + 2])).collect();
    let hairpin: Vec<Point3> = (0..200)
        .map(|i| {
            let s = f64::from(i) / 100.0;
            if i < 100 { Point3::new(s, 0.0, 0.0) } else { Point3::new(2.0 - s, 0.01, 0.0) }
        })
        .collect();
    let there_and_back: Vec<Point3> =
        (0..41).map(|i| Point3::new(f64::from(20 - i32::abs(i - 20)), 0.0, 0.0)).collect();
    let zigzag: Vec<Point3> = (0..100).map(|i| Point3::new(f64::from(i) * 0.1, f64::from(i % 2), 0.0)).collect();
    let twice: Vec<Point3> = circle().into_iter().chain(circle()).collect();
    let clumped: Vec<Point3> =
        (0..200).map(|i| Point3::new(f64::from(i / 10) + 1e-6 * f64::from(i % 10), g[i as usize / 10], 0.0)).collect();
    for points in [cloud, cloud3, hairpin, there_and_back, zigzag, twice, clumped] {
        for closed in [false, true] {
            for tolerance in [1e-3, 0.02, 0.3, 50.0] {
                let options = FairFitOptions { closed, max_fits: 3, ..FairFitOptions::new(tolerance) };
                match FairFit::new(&points, &options) {
                    Ok(fit) => assert!(fit.certificate().deviation <= tolerance),
                    Err(Error::Fit(FitError::ToleranceNotReached { points: outside, deviation, .. })) => {
                        assert!(!outside.is_empty() && outside.iter().all(|i| *i < points.len()));
                        // Measured, not "infinite": no farther than the data are large, or a curve that swings out.
                        assert!(deviation > tolerance && deviation < 1e3);
                    }
                    Err(error) => panic!("{error}"),
                }
            }
        }
    }
}

#[test]
fn no_tolerance_swallows_the_figure() {
    // Closed curves shrank to a point, spirals to a line, as soon as the tolerance was as wide as the figure.
    let ring = |n: usize, at: &dyn Fn(f64) -> [f64; 2]| -> Vec<Point3> {
        let angle = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
        (0..n).map(|i| at(angle(i))).map(|[x, y]| Point3::new(x, y, 0.0)).collect()
    };
    let eight = ring(200, &|t| [10.0 * t.sin(), 6.0 * (2.0 * t).sin()]);
    let thin = ring(200, &|t| [20.0 * t.cos(), t.sin()]);
    let spiral = ring(600, &|t| [t * (10.0 * t).cos(), t * (10.0 * t).sin()]);
    let survey = example(include_str!("../../../../examples/survey.csv"));
    for (points, closed) in
        [(eight, true), (thin, true), (spiral, false), (survey.clone(), true), (survey, false), (outline(), true)]
    {
        let edges = points.windows(2).map(|w| w[0].distance(w[1])).sum::<f64>();
        let bounds = cyclide::Aabb::of_points(points.iter().copied()).unwrap();
        for exponent in -12..=2 {
            let tolerance = bounds.diagonal() * 10_f64.powf(0.5 * f64::from(exponent));
            let fit = FairFit::new(&points, &FairFitOptions { closed, ..FairFitOptions::new(tolerance) }).unwrap();
            assert!(fit.certificate().deviation <= tolerance);
            let reasons: Vec<&str> = fit.warnings().iter().map(cyclide::Warning::reason).collect();
            let length = cyclide::curve::length(fit.spline());
            assert!(length > 0.5 * edges && length < 2.0 * edges, "{tolerance}: {length} of {edges} {reasons:?}");
            let kept = length > 0.75 * edges && length < 1.5 * edges;
            let said = ["shape-smoothed-away", "swings-out", "wide-tolerance"].iter().any(|r| reasons.contains(r));
            assert!(kept || said, "{tolerance}: {length} of {edges} {reasons:?}");
        }
    }
}

#[test]
fn nodes_never_outnumber_the_points() {
    // Stairs need a node or more for each of their points, and a cloud has no curve at all: both were slow beyond bounds.
    let stairs: Vec<Point3> = (0..2000).map(|i| Point3::new(f64::from(i / 2), f64::from((i + 1) / 2), 0.0)).collect();
    let g = deviates(5, 4000);
    let cloud: Vec<Point3> = (0..2000).map(|i| Point3::new(g[2 * i], g[2 * i + 1], 0.0)).collect();
    // An edge of the cloud that is kept to without a corner at either end takes nodes of its own: a few in a hundred have none.
    for (points, tolerance, most) in [(stairs, 0.01, 2000), (cloud, 0.05, 2020)] {
        match FairFit::new(&points, &FairFitOptions::new(tolerance)) {
            Ok(fit) => assert!(fit.certificate().nodes <= most, "{}", fit.certificate().nodes),
            Err(error) => {
                assert_eq!(error.reason(), "tolerance-not-reached");
                assert!(!error.to_string().contains("infinite"), "{error}");
            }
        }
    }
}

#[test]
fn doubts_are_named() {
    let reasons = |points: &[Point3], options: &FairFitOptions| -> Vec<&'static str> {
        fitted(points, options).warnings().iter().map(cyclide::Warning::reason).collect()
    };
    // Below the noise a node or more is needed for three points.
    let g = deviates(21, 400);
    let line: Vec<Point3> = (0..200).map(|i| Point3::new(i as f64, 0.5 * g[i], 0.0)).collect();
    assert!(reasons(&line, &FairFitOptions::new(0.05)).contains(&"tolerance-below-noise"));
    // The fairest curve of dense noisy data leans on its bounds, one in their middle does not.
    let wave: Vec<Point3> =
        (0..200).map(|i| Point3::new(i as f64, 20.0 * (i as f64 * 0.05).sin() + 0.5 * g[i], 0.0)).collect();
    assert!(!reasons(&wave, &FairFitOptions { centre: 1.0, ..FairFitOptions::new(2.0) }).contains(&"leans-on-walls"));
    // Repeated points are merged, and the indices of errors and warnings are those of the list as given.
    let mut repeated = line.clone();
    repeated.insert(5, line[5]);
    assert!(reasons(&repeated, &FairFitOptions::new(3.0)).contains(&"points-merged"));
}

#[test]
fn a_hundred_thousand_points_are_no_trouble() {
    let n = 100_000;
    let g = deviates(17, 2 * n);
    let points: Vec<Point3> = (0..n)
        .map(|i| {
            let a = std::f64::consts::TAU * i as f64 / n as f64;
            let r = 100.0 + 10.0 * (7.0 * a).cos() + 2.0 * (23.0 * a).sin();
            Point3::new(r * a.cos() + 0.02 * g[2 * i], r * a.sin() + 0.02 * g[2 * i + 1], 0.0)
        })
        .collect();
    // Points 0.01 apart with noise of 0.02. A tenth of them needs 114 nodes.
    let fit = FairFit::new(&points, &closed(0.12)).unwrap();
    assert!(fit.certificate().deviation <= 0.12);
    assert!(fit.certificate().nodes < 200, "{}", fit.certificate().nodes);
}

#[test]
fn a_star_does_not_swing_out_in_silence() {
    // Ten straight sides with twenty points each and sharp tips: smooth, the points alone do not hold the curve there.
    let corner = |k: usize| {
        let (radius, angle) = (if k.is_multiple_of(2) { 50.0 } else { 20.0 }, std::f64::consts::PI * k as f64 / 5.0);
        [radius * angle.sin(), radius * angle.cos()]
    };
    let (tolerance, mut kept) = (0.2, 0);
    for seed in 100..106 {
        let g = deviates(seed, 400);
        let points: Vec<Point3> = (0..200)
            .map(|i| {
                let ([a, b], t) = ([corner(i / 20), corner((i / 20 + 1) % 10)], (i % 20) as f64 / 20.0);
                let at = |d: usize| a[d] + t * (b[d] - a[d]) + 0.05 * g[2 * i + d];
                Point3::new(at(0), at(1), 0.0)
            })
            .collect();
        let longest = (0..200).map(|i| points[i].distance(points[(i + 1) % 200])).fold(0.0, f64::max);
        let fit = fitted(&points, &FairFitOptions { closed: true, centre: 1.0, ..FairFitOptions::new(tolerance) });
        let within = fit.certificate().polyline_deviation <= tolerance + 0.5 * longest;
        let warned = fit.warnings().iter().find_map(|w| match w {
            cyclide::Warning::Fit(FitWarning::SwingsOut { held, .. }) => Some(*held),
            _ => None,
        });
        assert!(within || warned == Some(false), "{seed}: {:?}", fit.certificate());
        kept += usize::from(fit.spline().kinks().len() >= 5);
    }
    // The five tips turn by 128 degrees between straight sides: corners of an outline, whatever the noise.
    assert_eq!(kept, 6);
}
