//! Möbius-covariant splines through points: constructs of `docs/math/reference-cases.md#interpolation`.

use super::Handler;
use super::arc::{triple, xyz};
use super::case::{Case, Fault};
use super::check::Check;
use super::qb::{relative, samples};
use cyclide::{
    construct::{MoebiusSplineOptions, NodeParameters, circle_tangents},
    curve::{CircleSpline, CircleSplineOptions, ParamCurve, QbSpline},
};

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "circle-tangents" => tangents,
        "circle-tangent-spline" => spline,
        "g1-circle-spline" => g1_spline,
        "spline-nurbs" => nurbs,
        _ => return None,
    })
}

fn closed(case: &Case) -> Result<bool, Fault> {
    if case.input("closed").is_ok() { case.flag("closed") } else { Ok(false) }
}

fn cusps(check: &mut Check, spline: &QbSpline) {
    check.points("cusps", spline.kinks().iter().map(|k| [*k as f64]), &|_| 0.0);
}

fn tangents(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let tangents = circle_tangents(&case.points("points")?, &case.numbers("u")?, closed(case)?)?;
    let allowed = relative(case, check, "tangents", 0);
    check.points("tangents", tangents.into_iter().map(triple), &allowed);
    Ok(())
}

fn c1(case: &Case) -> Result<QbSpline, Fault> {
    let options = MoebiusSplineOptions {
        closed: closed(case)?,
        knots: NodeParameters::Given(case.numbers("u")?),
        ..Default::default()
    };
    Ok(QbSpline::through_points(&case.points("points")?, &options)?)
}

fn g1(case: &Case) -> Result<QbSpline, Fault> {
    let options = CircleSplineOptions { closed: closed(case)?, order: 1, ..Default::default() };
    let spline = CircleSpline::from_points(&case.points("points")?, &options)?;
    QbSpline::from_circle_spline(&spline).ok_or(Fault::Malformed("a spline of order 1 is a QB spline".into()))
}

fn spline(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let spline = c1(case)?;
    samples(case, check, "samples", |u| xyz(spline.jet_at_knot(u).point));
    cusps(check, &spline);
    Ok(())
}

fn g1_spline(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let spline = g1(case)?;
    let n = spline.piece_count();
    samples(case, check, "samples", |t| {
        let piece = (t as usize).min(n - 1);
        xyz(spline.piece_point(piece, t - piece as f64))
    });
    cusps(check, &spline);
    Ok(())
}

fn nurbs(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let spline = if case.input("u").is_ok() { c1(case)? } else { g1(case)? };
    let runs = spline.to_nurbs_runs()?;
    let [curve] = runs.as_slice() else { return Err(Fault::Malformed("the spline has corners".into())) };
    let curve = match case.flag("c1_knots")? {
        true => curve.with_c1_knots().ok_or(Fault::Malformed("no form with C1 knots".into()))?,
        false => curve.clone(),
    };
    check.exact("degree", curve.degree());
    // The file has the knots of the spline, the curve has them brought to [0, 1].
    let (first, last) = (spline.knots()[0], spline.knots()[spline.knots().len() - 1]);
    let allowed = relative(case, check, "knots", 0);
    check.points("knots", curve.knots().iter().map(|k| [first + k * (last - first)]), &allowed);
    let weight = curve.weights()[0];
    let allowed = relative(case, check, "weights", 0);
    check.points("weights", curve.weights().iter().map(|w| [w / weight]), &allowed);
    let rows = curve.control_points().iter().zip(curve.weights()).map(|(p, w)| triple(p.to_vec() * (w / weight)));
    let allowed = relative(case, check, "homogeneous", 0);
    check.points("homogeneous", rows, &allowed);
    Ok(())
}
