//! What holds of every fit (`docs/math/fair-fits.md#data-and-figures`, properties).

use crate::data::*;
use cyclide::{
    Point3, Warning,
    construct::{FairFit, FairFitOptions},
    curve::ParamCurve,
    warning::{CurveWarning, FitWarning, NoiseWarning},
};
use std::f64::consts::TAU;

/// Nodes and variation of a fit.
fn figures(points: &[Point3], options: &FairFitOptions) -> (usize, f64) {
    let fit = fitted(points, options);
    (fit.certificate().nodes, variation(fit.spline()).0)
}

/// Equal nodes, and variation to 1e-6: what rounding makes of the choices of a greedy search.
fn same(a: (usize, f64), b: (usize, f64)) {
    assert_eq!(a.0, b.0);
    assert!((a.1 - b.1).abs() <= 1e-6 * a.1, "{} {}", a.1, b.1);
}

#[test]
fn similarities_and_reversal_change_nothing() {
    let (s, c) = 0.7_f64.sin_cos();
    let map =
        |p: &Point3| Point3::new(1e-3 * (c * p.x - s * p.y) + 5.0, 1e-3 * (s * p.x + c * p.y) - 3.0, 1e-3 * p.z + 1.0);
    for (points, closed, tolerance) in
        [(noisy_outline(), true, 0.4), (gps(), false, 8.0), (cable(), false, 0.1), (trefoil(), true, 0.01)]
    {
        let with = |tolerance| FairFitOptions { closed, ..FairFitOptions::new(tolerance) };
        let plain = figures(&points, &with(tolerance));
        let mapped: Vec<Point3> = points.iter().map(map).collect();
        same(plain, figures(&mapped, &with(1e-3 * tolerance)));
        let mut back: Vec<Point3> = points.iter().rev().copied().collect();
        if closed {
            // The same first point.
            back.rotate_right(1);
        }
        same(plain, figures(&back, &with(tolerance)));
    }
}

#[test]
fn another_start_of_a_closed_curve_changes_nothing() {
    // Nodes within 10 % and variation within 5 % would do: on tracks the counts of a search that starts at
    // the first point of the list spread by 10 to 30 %. Closed data choose their start themselves.
    let circuits = cyclide_testkit::circuits::circuits();
    let mut data = vec![(noisy_outline(), 0.4), (trefoil(), 0.01)];
    data.extend(circuits.iter().step_by(circuits.len() / 4).map(|circuit| (circuit.points.clone(), 0.05)));
    for (points, tolerance) in data {
        let n = points.len();
        let plain = fitted(&points, &closed(tolerance));
        // The curve starts beside the first point: no farther along it than half a segment and the tolerance.
        let (spline, shortest) = (plain.spline(), plain.spline().segments()[0].chord_length());
        let before = spline.segments()[spline.segments().len() - 1].chord_length();
        assert!(spline.point(0.0).distance(points[0]) <= 0.75 * shortest.max(before) + tolerance);
        let plain = (plain.certificate().nodes, variation(spline).0);
        for start in [1, n / 5, n / 2, 2 * n / 3, n - 1] {
            let mut moved = points.clone();
            moved.rotate_left(start);
            if start == n / 2 || start == 1 {
                moved.reverse();
            }
            same(plain, figures(&moved, &closed(tolerance)));
        }
    }
}

#[test]
fn a_larger_tolerance_is_no_less_fair() {
    // Before nodes are taken out, within 1 % (each fit stops 0.2 % from its optimum, on nodes of its own).
    let mut last = f64::INFINITY;
    for tolerance in [0.25, 0.4, 0.6, 1.0] {
        let fit = fitted(&noisy_outline(), &FairFitOptions { max_fits: 0, ..closed(tolerance) });
        let fairness = fit.certificate().fairness;
        assert!(fairness <= 1.01 * last, "{tolerance}: {fairness} {last}");
        last = fairness;
    }
}

#[test]
fn options_do_what_they_say() {
    let points = noisy_outline();
    let plain = fitted(&points, &closed(0.4));
    let centered = fitted(&points, &FairFitOptions { centre: 10.0, ..closed(0.4) });
    assert!(centered.certificate().rms < plain.certificate().rms);
    assert!(centered.certificate().fairness > plain.certificate().fairness);
    let dense = fitted(&points, &FairFitOptions { max_fits: 0, ..closed(0.4) });
    assert!(dense.certificate().nodes > plain.certificate().nodes);
    let stopped = fitted(&points, &FairFitOptions { nodes: Some(30), ..closed(0.4) });
    assert!((30..=dense.certificate().nodes).contains(&stopped.certificate().nodes));
    let generous = fitted(&points, &FairFitOptions { budget: 1.0, ..closed(0.4) });
    assert!(generous.certificate().nodes <= plain.certificate().nodes);
    let open = fitted(&points, &FairFitOptions { fix_ends: true, ..FairFitOptions::new(0.4) });
    assert_eq!((open.spline().point(0.0), open.spline().point(1.0)), (points[0], points[399]));
    // The whole range.
    for options in [
        FairFitOptions { centre: 1e6, ..closed(0.4) },
        FairFitOptions { budget: 0.0, ..closed(0.4) },
        FairFitOptions { budget: 1e3, ..closed(0.4) },
        FairFitOptions { nodes: Some(usize::MAX), ..closed(0.4) },
        FairFitOptions { max_fits: usize::MAX, ..closed(0.4) },
        FairFitOptions { edge_points: 100, max_fits: 1, ..closed(0.4) },
    ] {
        fitted(&points, &options);
    }
}

#[test]
fn what_has_no_effect_or_is_not_reached_is_said() {
    let points = noisy_outline();
    let said = |options: &FairFitOptions| fitted(&points, options).warnings().to_vec();
    let nodes = |options: &FairFitOptions| {
        said(options).into_iter().find_map(|w| match w {
            Warning::Fit(FitWarning::NodesNotReached { asked, reached, why }) => Some((asked, reached, why)),
            _ => None,
        })
    };
    let plain = closed(0.4);
    assert_eq!(nodes(&plain), None);
    let (asked, reached, why) = nodes(&FairFitOptions { nodes: Some(5), ..plain.clone() }).unwrap();
    assert!(asked == 5 && reached > 15 && ["tolerance", "budget", "max-fits"].contains(&why), "{reached} {why}");
    assert_eq!(nodes(&FairFitOptions { nodes: Some(5), max_fits: 1, ..plain.clone() }).unwrap().2, "max-fits");
    assert_eq!(nodes(&FairFitOptions { nodes: Some(5), max_fits: 0, ..plain.clone() }).unwrap().2, "max-fits");
    assert_eq!(nodes(&FairFitOptions { nodes: Some(300), ..plain.clone() }).unwrap().2, "first-fit");
    let ring = FairFit::new(&circle(), &FairFitOptions { nodes: Some(2), ..closed(0.05) }).unwrap();
    assert!(
        ring.warnings()
            .iter()
            .any(|w| matches!(w, Warning::Fit(FitWarning::NodesNotReached { reached: 4, why: "fewest", .. })))
    );

    let fixed = FairFitOptions { fix_ends: true, ..plain };
    assert!(said(&fixed).contains(&Warning::Curve(CurveWarning::EndsWithoutEffect)));
    assert!(
        !said(&FairFitOptions { closed: false, ..fixed }).contains(&Warning::Curve(CurveWarning::EndsWithoutEffect))
    );
}

#[test]
fn doubts_tell_noise_from_exact_points() {
    let said = |points: &[Point3], tolerance: f64, closed: bool| {
        fitted(points, &FairFitOptions { closed, ..FairFitOptions::new(tolerance) }).warnings().to_vec()
    };
    let scatter = |warnings: Vec<Warning>| {
        let found = warnings.into_iter().find(|w| matches!(w, Warning::Noise(NoiseWarning::LeansOnWalls { .. })));
        let Some(Warning::Noise(NoiseWarning::LeansOnWalls { scatter, .. })) = found else {
            panic!("the fairest curve leans")
        };
        (scatter, found.unwrap().to_string())
    };
    // Noise of 0.1 in both coordinates moves a point by 0.1 across the curve; fourth differences of 400 of them know that
    // to a tenth.
    let (noise, text) = scatter(said(&noisy_outline(), 0.6, true));
    assert!((noise.unwrap() - 0.1).abs() < 0.02 && text.contains("if that is noise"), "{noise:?}: {text}");
    // Exact points: what fourth differences make of a smooth distance.
    let (none, text) = scatter(said(&outline(), 0.4, true));
    assert!(none.unwrap() < 0.01 && !text.contains("noise"), "{none:?}: {text}");
    // A tolerance so small that few points are left to a node.
    let ellipse: Vec<Point3> =
        (0..400).map(|i| TAU * f64::from(i) / 400.0).map(|a| Point3::new(2.0 * a.cos(), a.sin(), 0.0)).collect();
    for warning in said(&ellipse, 1e-6, true) {
        let text = warning.to_string();
        assert!(!text.contains("noise") && !text.contains("scatter by"), "{text}");
    }

    let reasons = |warnings: Vec<Warning>| warnings.iter().map(Warning::reason).collect::<Vec<_>>();
    let tight = reasons(said(&outline(), 1e-6, true));
    assert!(tight.contains(&"many-nodes") && !tight.contains(&"tolerance-below-noise"), "{tight:?}");
    assert!(reasons(said(&noisy_outline(), 0.03, true)).contains(&"tolerance-below-noise"));
}

#[test]
fn the_polyline_is_bound_where_it_is_meant() {
    // Eighteen edges round a circle of radius 10, sagitta 0.15.
    let points: Vec<Point3> = circle().into_iter().step_by(5).collect();
    let samples = fitted(&points, &closed(0.05));
    assert!(samples.certificate().polyline_deviation > 0.1);
    let options = FairFitOptions { edge_points: 9, ..closed(0.1) };
    let edges = fitted(&points, &options);
    // Between ten places on an edge of 3.5 the curve and the edge part by a tenth of it squared at most.
    assert!(edges.certificate().polyline_deviation <= 0.1 + 0.02, "{}", edges.certificate().polyline_deviation);
    // Below the sagitta the points are called samples.
    let coarse = FairFitOptions { edge_points: 3, ..closed(0.08) };
    let warned = |w: &Warning| w.reason() == "samples-too-coarse";
    assert!(!edges.warnings().iter().any(warned) || edges.certificate().polyline_deviation < 0.16);
    let fit = fitted(&points, &coarse);
    let warning = fit.warnings().iter().find(|w| warned(w)).unwrap().to_string();
    // A fair fit has no target; without the places on the edges, or with a larger tolerance, nothing is said.
    assert!(!warning.contains("target") && warning.contains("leave `polyline` out"), "{warning}");
    assert!(!samples.warnings().iter().any(warned));
    let wider = FairFitOptions { edge_points: 3, ..closed(0.2) };
    assert!(!fitted(&points, &wider).warnings().iter().any(warned));
}

#[test]
fn the_bound_on_both_distances_holds_and_is_close() {
    for (points, closed, tolerance) in [(noisy_outline(), true, 0.4), (cable(), false, 0.1), (trefoil(), true, 0.01)] {
        let fit = fitted(&points, &FairFitOptions { closed, ..FairFitOptions::new(tolerance) });
        assert!(fit.certificate().monotone);
        let sampled = sampled_distance_from_polyline(fit.spline(), &points, closed);
        let larger = sampled.max(fit.certificate().deviation);
        let bound = fit.certificate().polyline_deviation;
        // Refined until within 2 %; between samples a hundredth more.
        assert!(bound >= sampled && bound <= 1.04 * larger, "{bound} {larger}");
    }
}

#[test]
fn corners_are_found_by_their_angle_and_noise_makes_none() {
    let points = legs();
    let found = fitted(&points, &FairFitOptions { corner_angle: Some(0.8), ..FairFitOptions::new(0.08) });
    assert_eq!(found.spline().kinks().len(), 1);
    assert!(found.warnings().iter().any(|w| w.reason() == "corner-kept" && w.index() == Some(100)));
    // Noisy points without corners; their bends turn by 0.8 over eight tolerances.
    let none = fitted(&gps(), &FairFitOptions { corner_angle: Some(1.2), ..FairFitOptions::new(8.0) });
    assert!(none.spline().kinks().is_empty());
    // A closed square keeps its four corners and its straight sides.
    let side = |a: [f64; 2], b: [f64; 2]| {
        (0..25).map(move |i| {
            let s = f64::from(i) / 25.0;
            Point3::new(a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), 0.0)
        })
    };
    let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
    // Started in the middle of a side.
    let mut square: Vec<Point3> = (0..4).flat_map(|i| side(corners[i], corners[(i + 1) % 4])).collect();
    square.rotate_left(12);
    let fit = fitted(&square, &FairFitOptions { corner_angle: Some(1.0), ..closed(0.01) });
    assert_eq!((fit.spline().kinks().len(), fit.certificate().nodes), (4, 4));
    assert!(fit.certificate().deviation < 1e-14 && fit.certificate().polyline_deviation < 1e-14);
}
