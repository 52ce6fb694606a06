//! Curves through points and derivatives: constructs of `docs/math/reference-cases.md#interpolation`.

use super::Handler;
use super::arc::{triple, xyz};
use super::case::{Case, Fault, array, malformed};
use super::check::Check;
use super::qb::{rational_rows, relative, samples};
use cyclide::{
    Error, Point3, Quat, Vec3,
    construct::{NodeParameters, QbInterpolation, QbNode},
    curve::{ParamCurve, QbCurve},
    error::PointError,
};

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "interpolate-points" => points,
        "interpolate-hermite" => hermite,
        "hermite-three-points-two-tangents" => three_points,
        "invariant-span" => invariant_span,
        _ => return None,
    })
}

const THREE_POINTS: &str = "hermite-three-points-two-tangents";

/// True of the constructs whose refusals the file names in its own words.
fn is_here(construct: &str) -> bool {
    handler(construct).is_some() || super::moebius_spline::handler(construct).is_some()
}

/// The word of the file for a refusal.
pub(super) fn reason(construct: &str, error: &Error) -> &'static str {
    match error.reason() {
        "not-finite" if is_here(construct) => "non-finite",
        "count-differs" if is_here(construct) => "length-mismatch",
        other => other,
    }
}

/// The index at fault as the file counts: of coincident points the first, of three points with tangents even ones.
pub(super) fn index(construct: &str, error: &Error) -> Option<usize> {
    if !is_here(construct) {
        return None;
    }
    match error {
        Error::Point(PointError::CoincidentPoints { first, .. }) => Some(*first),
        error if construct == THREE_POINTS => error.index().map(|k| 2 * k),
        error => error.index(),
    }
}

/// Fields that every curve has.
fn common(case: &Case, check: &mut Check, curve: &QbCurve) {
    samples(case, check, "samples", |t| xyz(curve.point(t)));
    samples(case, check, "d1", |t| triple(curve.jet(t).d1).to_vec());
    check.exact("degree", curve.degree());
    if let Some(value) = check.want_raw("rational_bezier") {
        let bezier = curve.to_bezier();
        check.nested("rational_bezier", "", value, |check| rational_rows(case, check, &bezier));
    }
}

/// The barycentric weights of the even nodes, the first one 1: `d(t_i)/product of (t_i - t_k)`.
fn weights(case: &Case, check: &mut Check, curve: &QbCurve, t: &[f64]) {
    let pairs = curve.pairs();
    let n = pairs.len() - 1;
    let denominator = |t: f64| {
        let (mut sum, mut choose) = (Quat::ZERO, 1.0);
        for (i, pair) in pairs.iter().enumerate() {
            let b = choose * t.powi(i as i32) * (1.0 - t).powi((n - i) as i32);
            sum += pair.d * b;
            choose = choose * (n - i) as f64 / (i + 1) as f64;
        }
        sum
    };
    let even: Vec<f64> = t.iter().copied().step_by(2).collect();
    let weight = |i: usize| {
        let others = even.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, t)| even[i] - t);
        denominator(even[i]) * (1.0 / others.product::<f64>())
    };
    let gauge = weight(0).inverse().unwrap_or(Quat::ZERO);
    let allowed = relative(case, check, "weights", 0);
    check.points("weights", (0..even.len()).map(|i| (weight(i) * gauge).to_array()), &allowed);
}

fn points(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let t = case.numbers("t")?;
    let found = QbInterpolation::through_points(&case.points("points")?, &NodeParameters::Given(t.clone()))?;
    let curve = found.curve();
    common(case, check, curve);
    weights(case, check, curve, &t);
    let pairs = curve.pairs();
    if let ([_, middle, _], Some(gauge)) = (pairs.as_slice(), pairs[0].d.inverse()) {
        for (field, q) in [("u1", middle.d * gauge), ("p1u1", middle.n * gauge)] {
            let allowed = relative(case, check, field, 0);
            check.vector(field, Some(&q.to_array()), &allowed);
        }
    }
    Ok(())
}

fn hermite(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let nodes = case.input("nodes")?.as_array().ok_or_else(|| malformed("nodes"))?;
    let node = |value: &serde_json::Value| {
        let vector = |v: &serde_json::Value| array::<3>(v).ok_or_else(|| malformed("nodes"));
        let derivatives = value["derivatives"].as_array().ok_or_else(|| malformed("nodes"))?;
        Ok::<_, Fault>(QbNode {
            parameter: value["t"].as_f64().ok_or_else(|| malformed("nodes"))?,
            point: Point3::from(vector(&value["point"])?),
            derivatives: derivatives.iter().map(|d| vector(d).map(Vec3::from)).collect::<Result<_, _>>()?,
        })
    };
    let nodes = nodes.iter().map(node).collect::<Result<Vec<_>, _>>()?;
    common(case, check, QbInterpolation::through_nodes(&nodes)?.curve());
    Ok(())
}

fn three_points(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let points = [case.point("a0")?, case.point("a2")?, case.point("a4")?];
    let tangents = [case.vector("v0")?, case.vector("v1")?];
    let found = QbInterpolation::three_points_two_tangents(points, tangents, case.number("t")?)?;
    common(case, check, found.curve());
    weights(case, check, found.curve(), &[0.0, 0.25, 0.5, 0.75, 1.0]);
    Ok(())
}

fn invariant_span(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let ends = [case.point("a0")?, case.point("a1")?];
    let span = QbCurve::invariant_span(ends, [case.vector("v0")?, case.vector("v1")?])?;
    common(case, check, &span);
    let allowed = relative(case, check, "midpoint", 0);
    check.vector("midpoint", Some(&xyz(ParamCurve::point(&span, 0.5))), &allowed);
    Ok(())
}
