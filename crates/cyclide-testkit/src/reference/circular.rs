//! Necks of pipes and bridges of ellipses: the circular surfaces of `docs/math/reference-cases.md#surfaces-of-arcs`.

use super::Handler;
use super::arc::{Rules, xyz};
use super::case::{Case, Fault};
use super::check::Check;
use cyclide::{
    Point3,
    construct::{EllipseBridge, NeckBlend, NeckSide, NeckVariant},
    curve::Arc,
};
use serde_json::Value;

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "neck-blend" => neck,
        "ellipse-bridge" => bridge,
        _ => return None,
    })
}

fn neck(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let side = match case.word("side")? {
        "outside" => NeckSide::Outside,
        "inside" => NeckSide::Inside,
        other => return Err(Fault::Malformed(format!("side {other}"))),
    };
    let variant = match case.word("variant")? {
        "pipe" => NeckVariant::Pipe,
        "vertical" => NeckVariant::Vertical,
        other => return Err(Fault::Malformed(format!("variant {other}"))),
    };
    let slope = case.number("slope")?.atan();
    let neck = NeckBlend::new(case.number("cylinder_radius")?, case.number("ball_radius")?, slope, side, variant)?;
    // The cases have the pipe upright.
    let (sin, cos) = slope.sin_cos();
    let upright = |p: Point3| Point3::new(p.x, p.y * cos - p.z * sin, p.y * sin + p.z * cos);
    let rules = Rules::of(case)?;
    for row in check.want_raw("rows").and_then(Value::as_array).into_iter().flatten() {
        let theta = row["theta"].as_f64().ok_or_else(|| Fault::Malformed("a row has an angle".into()))?;
        check.nested("rows", &format!("at {theta}: "), row, |inner| {
            inner.agree("theta");
            let points = [
                ("center", neck.center(theta)),
                ("q0", neck.contact_on_pipe(theta)),
                ("q1", neck.contact_on_plate(theta)),
            ];
            for (field, point) in points {
                inner.vector(field, Some(&upright(point).to_array()), &rules.point());
            }
        });
    }
    sampled(check, |theta| neck.arc(theta), upright, &rules);
    Ok(())
}

fn bridge(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let [a, b, c, d] = ["a", "b", "c", "d"].map(|name| case.number(name));
    let bridge = EllipseBridge::new([a?, b?], [c?, d?])?;
    sampled(check, |theta| bridge.arc(theta), |p| p, &Rules::of(case)?);
    Ok(())
}

/// Samples `[theta, t, x, y, z]` on arcs with weights of equal lengths.
fn sampled(
    check: &mut Check,
    arc: impl Fn(f64) -> cyclide::Result<Arc>,
    place: impl Fn(Point3) -> Point3,
    rules: &Rules,
) {
    let nowhere = vec![f64::NAN; 3];
    let at = |theta: f64, t: f64| arc(theta).map_or(nowhere.clone(), |arc| xyz(place(arc.evened().point(t))));
    check.surface_samples("samples", at, &rules.point());
}
