//! Arc fitting: the constructs of `docs/math/reference-cases.md#arc-fits`, and `fit-arc-spline` of
//! `docs/math/reference-cases.md#arcs-and-arc-splines`. Splines are judged by a property, measured without the fit's
//! own certificate.

use super::Handler;
use super::case::{Case, Fault};
use super::check::Check;
use super::deviation::{largest_distance, largest_kink};
use cyclide::{
    Point2, Point3,
    construct::{ArcFit, ArcFitOptions, FitTarget, certify_arc, curvature_intervals, feasible_bulges},
    curve::ArcPath,
};
use serde_json::Value;

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "arc-fit-interval" => fit_interval,
        "arc-certify" => certify,
        "g1-arc-interval" => g1_interval,
        "g1-arc-spline" => g1_spline,
        "fit-arc-spline" => fit_spline,
        _ => return None,
    })
}

/// The comparison rule of `docs/math/reference-cases.md#arc-fits`: `rtol (1 + |value|)` per number.
fn allowed(case: &Case) -> impl Fn(&[f64]) -> f64 + use<> {
    let rtol = case.rtol();
    move |want| rtol * (1.0 + want.iter().fold(0.0, |m: f64, w| m.max(w.abs())))
}

/// The ends of an interval, each compared on its own.
fn interval(check: &mut Check, field: &str, place: &str, got: [f64; 2], want: &Value, allowed: &dyn Fn(&[f64]) -> f64) {
    match super::check::numbers(want).as_deref() {
        Some([lo, hi]) => {
            check.measure(field, place, (got[0] - lo).abs(), allowed(&[*lo]));
            check.measure(field, place, (got[1] - hi).abs(), allowed(&[*hi]));
        }
        _ => check.fail(field, format!("{place}expected {want}, got {got:?}")),
    }
}

fn fit_interval(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let allowed = allowed(case);
    let points = case.planar_points("points")?;
    let max_sweep = case.number("max_sweep_deg")?.to_radians();
    let bulges = feasible_bulges(&points, case.number("tolerance")?, case.flag("edges")?, max_sweep)?;
    for (field, got) in [("ccw", bulges.ccw), ("cw", bulges.cw)] {
        // Here null is a result: no arc of this orientation.
        match (check.want_raw(field), got) {
            (None, _) => {}
            (Some(Value::Null), None) => check.measure(field, "", 0.0, 1.0),
            (Some(Value::Null), Some(got)) => check.fail(field, format!("{got:?}, expected none")),
            (Some(want), None) => check.fail(field, format!("none, expected {want}")),
            (Some(want), Some(got)) => interval(check, field, "", got, want, &allowed),
        }
    }
    Ok(())
}

fn certify(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let allowed = allowed(case);
    let points = case.planar_points("points")?;
    let z = case.input("z")?;
    let heights = if z.is_null() { None } else { super::check::numbers(z) };
    let certificate = certify_arc(&points, case.number("bulge")?, heights.as_deref())?;
    check.number("vertex_deviation", Some(certificate.vertex_deviation), &allowed);
    check.number("deviation", Some(certificate.deviation), &allowed);
    check.exact("monotone", certificate.monotone);
    check.exact("extra_turns", certificate.extra_turns);
    check.number("radius", Some(certificate.radius), &allowed);
    check.number("length", Some(certificate.length), &allowed);
    check.number("z_deviation", certificate.z_deviation, &allowed);
    Ok(())
}

fn g1_interval(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let allowed = allowed(case);
    let (points, start) = (case.planar_points("points")?, Point2::from(case.pair("start")?));
    let got = curvature_intervals(&points, start, case.number("tangent_angle")?, case.number("tolerance")?)?;
    let Some(want) = check.want_raw("curvature") else { return Ok(()) };
    // Null ends the list: there the interval is empty.
    let want: Vec<&Value> = want.as_array().into_iter().flatten().take_while(|v| !v.is_null()).collect();
    if want.len() != got.len() {
        check.fail("curvature", format!("{} intervals, expected {}", got.len(), want.len()));
    }
    for (i, (want, got)) in want.into_iter().zip(got).enumerate() {
        interval(check, "curvature", &format!("vertex {}: ", i + 1), got, want, &allowed);
    }
    Ok(())
}

/// Kinks of `fit-arc-spline` up to this are rounding, radians: the file asks for G1 without a number.
const G1_LIMIT: f64 = 1e-9;

/// What both spline properties share: the fit ends in the data's ends, to the bit, and every vertex is near it.
fn near_the_data(check: &mut Check, path: &ArcPath, points: &[Point3]) {
    check.at_most("max_deviation", largest_distance(path, points));
    let ends = [path.arcs()[0].start(), path.arcs()[path.arcs().len() - 1].end()];
    if points.first().zip(points.last()) != Some((&ends[0], &ends[1])) {
        check.fail("property", format!("the fit ends in {ends:?}"));
    }
}

fn fit_spline(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let points = case.points("points")?;
    let fit = ArcFit::new(&points, &ArcFitOptions::new(case.number("tolerance")?))?;
    check.exact("property", "deviation-and-count");
    near_the_data(check, fit.path(), &points);
    check.measure("property", "kink: ", largest_kink(fit.path()), G1_LIMIT);
    check.at_most("max_segments", fit.path().arcs().len() as f64);
    Ok(())
}

fn g1_spline(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let points: Vec<Point3> = case.planar_points("points")?.into_iter().map(|p| Point3::new(p.x, p.y, 0.0)).collect();
    let target = if case.flag("edges")? { FitTarget::Polyline } else { FitTarget::Points };
    let options =
        ArcFitOptions { closed: case.flag("closed")?, target, ..ArcFitOptions::new(case.number("tolerance")?) };
    let fit = ArcFit::new(&points, &options)?;
    check.exact("property", "g1-deviation-and-count");
    near_the_data(check, fit.path(), &points);
    check.at_most("max_kink", largest_kink(fit.path()));
    check.at_most("max_arcs", fit.path().arcs().len() as f64);
    Ok(())
}
