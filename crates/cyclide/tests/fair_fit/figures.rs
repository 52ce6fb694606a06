//! The acceptance figures of `docs/math/fair-fits.md#data-and-figures`, on the data given there.

use crate::data::*;
use cyclide::{
    Point3,
    construct::FairFitOptions,
    curve::{ParamCurve, closest_point},
};

/// Nodes and variation at most.
fn reaches(points: &[Point3], options: &FairFitOptions, nodes: usize, most: f64) -> usize {
    let fit = fitted(points, options);
    let (var, changes) = variation(fit.spline());
    assert!(fit.certificate().nodes <= nodes, "{} nodes", fit.certificate().nodes);
    assert!(var <= most, "variation {var}");
    changes
}

#[test]
fn noisy_outline_in_the_plane() {
    reaches(&noisy_outline(), &closed(0.4), 27, 1.62e5);
}

#[test]
fn cable_in_space() {
    reaches(&cable(), &FairFitOptions::new(0.1), 12, 400.0);
}

#[test]
fn gps_track() {
    let points = gps();
    reaches(&points, &FairFitOptions::new(8.0), 24, 2.05e4);
    // A few points are nearer to their neighbors than their noise: only one direction is bounded, and it is said.
    let fit = fitted(&points, &FairFitOptions::new(8.0));
    assert!(!fit.certificate().monotone);
    assert!(fit.warnings().iter().any(|w| w.reason() == "feet-not-monotone"));
}

#[test]
fn trefoil_in_space() {
    reaches(&trefoil(), &closed(0.01), 35, 5.3e4);
}

#[test]
fn circle_has_no_variation() {
    reaches(&circle(), &closed(0.05), 6, 1e-9);
}

#[test]
fn legs_meet_in_their_corner() {
    let options = FairFitOptions { corners: vec![100], fix_ends: true, ..FairFitOptions::new(0.08) };
    let points = legs();
    let fit = fitted(&points, &options);
    let spline = fit.spline();
    let [corner] = *spline.kinks() else { panic!("one corner") };
    // Pieces of at most 8 and 6 nodes that share one.
    assert!(corner < 8 && spline.segments().len() - corner < 6, "{corner} of {}", spline.segments().len());
    let ends = [spline.segments()[0].start(), spline.segments()[corner].start(), spline.point(1.0)];
    assert_eq!(ends, [points[0], points[100], points[200]], "to the bit");
}

#[test]
fn survey_of_the_examples() {
    // 301 points: no published figure. Few nodes, and fairer than the interpolating spline (0.64 of its variation).
    let points = example(include_str!("../../../../examples/survey.csv"));
    let fit = fitted(&points, &closed(0.2));
    let through = cyclide::construct::FairSplineOptions { closed: true, ..Default::default() };
    let through = cyclide::curve::CircleSpline::fair(&points, &through).unwrap();
    let (fair, all) = (variation(fit.spline()), variation(&through));
    assert!(fit.certificate().nodes < points.len() / 5, "{}", fit.certificate().nodes);
    assert!(fair.0 < 0.7 * all.0 && fair.1 <= all.1, "{fair:?} {all:?}");
}

#[test]
fn centre_comes_nearer_to_what_was_measured() {
    let points = noisy_outline();
    let truth = outline();
    let measure = |centre: f64| {
        let fit = fitted(&points, &FairFitOptions { centre, ..closed(0.4) });
        let squares: f64 = truth.iter().map(|p| closest_point(fit.spline(), *p).distance.powi(2)).sum();
        ((squares / truth.len() as f64).sqrt(), fit.certificate().rms, variation(fit.spline()).0, fit)
    };
    let (tube, middle) = (measure(0.0), measure(1.0));
    // 0.70 of the distance here (0.5 on race tracks: `docs/math/fair-fits.md#center`).
    assert!(middle.0 < 0.75 * tube.0, "{} {}", middle.0, tube.0);
    // As close to the points as their noise, 0.1, and no less fair than what was measured.
    assert!(middle.1 < tube.1 && middle.1 < 0.11, "{} {}", middle.1, tube.1);
    let through = cyclide::construct::FairSplineOptions { closed: true, ..Default::default() };
    let exact = variation(&cyclide::curve::CircleSpline::fair(&truth, &through).unwrap()).0;
    assert!(middle.2 < exact, "{} {exact}", middle.2);
    // Four standard deviations wide: the curve in the middle leans on nothing.
    assert!(middle.3.warnings().iter().all(|w| w.reason() != "leans-on-walls"));
}
