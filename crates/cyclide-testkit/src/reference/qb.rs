//! Quaternionic Bézier curves as such: constructs of `docs/math/reference-cases.md#interpolation`.

use super::Handler;
use super::arc::{triple, xyz};
use super::case::{Case, Fault, array, malformed};
use super::check::Check;
use cyclide::{
    Point3, Quat, Vec3,
    conformal::{Conformal, HPoint, Mobius},
    curve::QbCurve,
    rational::RationalBezier,
};
use serde_json::Value;

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "qb-evaluate" => evaluate,
        "qb-to-rational-bezier" => rational,
        "qb-elevate" => elevate,
        "qb-subdivide" => subdivide,
        "qb-moebius" => moebius,
        "pole-report" => pole_report,
        _ => return None,
    })
}

/// `rtol` times the largest entry of the expected field, without its parameters.
pub(super) fn relative(case: &Case, check: &Check, field: &str, parameters: usize) -> impl Fn(&[f64]) -> f64 + use<> {
    let allowed = case.rtol() * check.largest_expected(field, parameters);
    move |_| allowed
}

pub(super) fn curve(case: &Case) -> Result<QbCurve, Fault> {
    let (num, den) = (case.quats("Q")?, case.quats("P")?);
    let pairs: Vec<HPoint> = num.into_iter().zip(den).map(|(n, d)| HPoint { n, d }).collect();
    Ok(QbCurve::new(&pairs)?)
}

pub(super) fn samples(case: &Case, check: &mut Check, field: &str, at: impl Fn(f64) -> Vec<f64>) {
    let allowed = relative(case, check, field, 1);
    check.samples(field, at, &allowed);
}

fn evaluate(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let curve = curve(case)?;
    samples(case, check, "samples", |t| xyz(curve.point(t)));
    samples(case, check, "d1", |t| triple(curve.jet(t).d1).to_vec());
    samples(case, check, "d2", |t| triple(curve.derivatives(t, 2)[1]).to_vec());
    Ok(())
}

/// Weights and homogeneous rows, the first weight 1.
pub(super) fn rational_rows(case: &Case, check: &mut Check, bezier: &RationalBezier) {
    let first = bezier.rows()[0][3];
    let rows = || bezier.rows().iter().map(|row| row.map(|x| x / first));
    let allowed = relative(case, check, "weights", 0);
    check.points("weights", rows().map(|row| [row[3]]), &allowed);
    let allowed = relative(case, check, "homogeneous", 0);
    check.points("homogeneous", rows().map(|[x, y, z, _]| [x, y, z]), &allowed);
}

fn rational(case: &Case, check: &mut Check) -> Result<(), Fault> {
    rational_rows(case, check, &curve(case)?.to_bezier());
    Ok(())
}

/// The pairs of a curve.
fn pairs(case: &Case, check: &mut Check, curve: &QbCurve) {
    let pairs = curve.pairs();
    let allowed = relative(case, check, "Q", 0);
    check.points("Q", pairs.iter().map(|pair| pair.n.to_array()), &allowed);
    let allowed = relative(case, check, "P", 0);
    check.points("P", pairs.iter().map(|pair| pair.d.to_array()), &allowed);
}

fn elevate(case: &Case, check: &mut Check) -> Result<(), Fault> {
    pairs(case, check, &curve(case)?.elevated());
    Ok(())
}

fn subdivide(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (left, right) = curve(case)?.split(case.number("t")?)?;
    for (field, part) in [("left", left), ("right", right)] {
        if let Some(value) = check.want_raw(field) {
            check.nested(field, "", value, |check| pairs(case, check, &part));
        }
    }
    Ok(())
}

fn map_of(op: &Value) -> Result<Mobius, Fault> {
    let vector = |name: &str| array::<3>(&op[name]).map(Vec3::from).ok_or_else(|| malformed("ops"));
    Ok(match op["op"].as_str() {
        Some("translate") => Mobius::translation(vector("by")?)?,
        Some("rotate") => {
            let q = array::<4>(&op["quaternion"]).map(Quat::from).ok_or_else(|| malformed("ops"))?;
            Mobius::similarity(q, 1.0, Vec3::ZERO)?
        }
        Some("scale") => Mobius::similarity(Quat::ONE, op["by"].as_f64().ok_or_else(|| malformed("ops"))?, Vec3::ZERO)?,
        Some("reflect") => Mobius::reflection(Point3::ORIGIN, vector("normal")?)?,
        Some("invert") => Mobius::inversion(Point3::ORIGIN, 1.0)?,
        _ => return Err(malformed("ops")),
    })
}

fn moebius(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let ops = case.input("ops")?.as_array().ok_or_else(|| malformed("ops"))?;
    let image = ops.iter().try_fold(curve(case)?, |curve, op| Ok::<_, Fault>(curve.transformed(&map_of(op)?)?))?;
    samples(case, check, "samples", |t| xyz(image.point(t)));
    Ok(())
}

fn pole_report(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let reach = curve(case)?.reach(case.point("centre")?);
    // Parameters: absolute.
    let absolute = |_: &[f64]| case.rtol();
    check.points("poles", reach.poles.iter().map(|t| [*t]), &absolute);
    check.points("base_points", reach.base_points.iter().map(|t| [*t]), &absolute);
    let distance = reach.farthest.map(|(distance, _)| distance);
    match check.want_raw("max_distance") {
        Some(Value::Null) if distance.is_some() => check.fail("max_distance", "finite, expected a pole".into()),
        _ => {
            let allowed = relative(case, check, "max_distance", 0);
            check.number("max_distance", distance, &allowed);
        }
    }
    Ok(())
}
