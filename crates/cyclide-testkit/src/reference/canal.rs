//! Rolling balls and canal surfaces: the constructs of `docs/math/reference-cases.md#canal-surfaces`.

use super::Handler;
use super::arc::{triple, xyz};
use super::case::{Case, Fault};
use super::check::{Check, numbers, rows};
use super::torus::{allowed, kind, malformed};
use cyclide::{
    Point2, Point3, Vec3,
    surface::{CanalPatch, ContactPartner, NaturalQuadric, PairKind, QuadricPair, RollingBall, SkewCylinders},
};
use serde_json::Value;

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "perp-cylinder-sphere" => ball,
        "canal-patch" => patch,
        "contact-ball" => contact,
        "constant-radius-curve" => constant_radius,
        "quadric-pair-kind" => pair_kind,
        _ => return None,
    })
}

fn cylinders(case: &Case) -> Result<SkewCylinders, Fault> {
    Ok(SkewCylinders::new([case.number("r1")?, case.number("r2")?], case.number("h")?)?)
}

fn ball(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let ball = cylinders(case)?.ball(Point2::new(case.number("A")?, case.number("B")?))?;
    let allowed = allowed(case, check);
    check.vector("centre", Some(&xyz(ball.center)), &allowed);
    check.number("radius", Some(ball.radius), &allowed);
    check.vector("contact1", Some(&xyz(ball.contacts[0])), &allowed);
    check.vector("contact2", Some(&xyz(ball.contacts[1])), &allowed);
    Ok(())
}

fn patch(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let linear = case.input("z_linear")?.as_array().ok_or_else(|| malformed("z_linear"))?;
    let ends = |i: usize| {
        let ends = linear.get(i).and_then(rows::<2>).ok_or_else(|| malformed("z_linear"))?;
        <[[f64; 2]; 2]>::try_from(ends).map_err(|_| malformed("z_linear"))
    };
    let patch =
        CanalPatch::between_skew_cylinders(&cylinders(case)?, kind(case.input("type")?)?, [ends(0)?, ends(1)?])?;
    let allowed = allowed(case, check);
    let samples = check.want_raw("samples").and_then(Value::as_array).cloned().unwrap_or_default();
    for (i, sample) in samples.iter().enumerate() {
        compare_circle(check, &patch, i, sample, &allowed);
    }
    Ok(())
}

fn compare_circle(check: &mut Check, patch: &CanalPatch, i: usize, sample: &Value, allowed: &dyn Fn(&[f64]) -> f64) {
    let t = sample["t"].as_f64().unwrap_or(f64::NAN);
    let ((center, radius), circle) = (patch.ball(t), patch.characteristic_circle(t));
    let want_axis = numbers(&sample["axis_up_to_sign"]).unwrap_or_default();
    let axis = triple(circle.axis);
    let same_side = axis.iter().zip(&want_axis).map(|(a, b)| a * b).sum::<f64>() >= 0.0;
    let got = [
        ("t", vec![t]),
        ("centre", xyz(center).to_vec()),
        ("radius", vec![radius]),
        ("circle_centre", xyz(circle.center).to_vec()),
        ("circle_radius", vec![circle.radius]),
        ("axis_up_to_sign", axis.map(|x| if same_side { x } else { -x }).to_vec()),
        ("contact1", xyz(circle.contacts[0]).to_vec()),
        ("contact2", xyz(circle.contacts[1]).to_vec()),
        ("minor_arc_midpoint", xyz(circle.minor_arc_midpoint).to_vec()),
    ];
    let place = format!("sample {i}: ");
    let known = sample.as_object().map_or(0, serde_json::Map::len);
    if known != got.len() {
        check.fail("samples", format!("{place}{known} fields, {} are compared", got.len()));
    }
    for (field, got) in got {
        let want = numbers(&sample[field]).unwrap_or_default();
        let error = got.iter().zip(&want).fold(0.0, |sum: f64, (g, w)| sum.hypot(g - w));
        let error = if got.len() == want.len() { error } else { f64::INFINITY };
        check.measure("samples", &format!("{place}{field}: "), error, allowed(&want));
    }
    check_circle(check, patch, t, &place);
}

/// The patch runs along the circle: both ends, and the middle of the even arc on one of its two sides.
fn check_circle(check: &mut Check, patch: &CanalPatch, s: f64, place: &str) {
    let (circle, (center, _)) = (patch.characteristic_circle(s), patch.ball(s));
    let size = 1.0 + xyz(center).iter().fold(circle.radius, |m: f64, x| m.max(x.abs()));
    for k in 0..=4 {
        let p = patch.point(s, 0.25 * f64::from(k));
        let off = ((p - circle.center).length() - circle.radius).abs() + (p - circle.center).dot(circle.axis).abs();
        check.measure("samples", &format!("{place}off the circle "), off, 1e-12 * size);
    }
}

fn contact(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let partner = match case.word("second")? {
        "plane" => ContactPartner::Plane { normal: case.vector("plane_normal")?, offset: case.number("plane_offset")? },
        "sphere" => ContactPartner::Sphere { center: case.point("centre")?, radius: case.number("radius")? },
        _ => return Err(malformed("second")),
    };
    let ball = RollingBall::at_contact(case.point("point")?, case.vector("normal")?, partner)?;
    let allowed = allowed(case, check);
    check.number("radius", Some(ball.radius), &allowed);
    check.vector("centre", Some(&xyz(ball.center)), &allowed);
    Ok(())
}

fn constant_radius(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let pair = cylinders(case)?;
    let place = pair.place_of_radius(case.number("R")?, case.number("theta")?)?;
    let allowed = allowed(case, check);
    check.number("A", Some(place.x), &allowed);
    check.number("B", Some(place.y), &allowed);
    check.vector("centre", Some(&xyz(pair.ball(place)?.center)), &allowed);
    Ok(())
}

fn pair_kind(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let surfaces = case.input("surfaces")?;
    let surface = |k: usize| -> Result<NaturalQuadric, Fault> {
        let value = &surfaces[k];
        let triple = |name: &str| {
            let row = numbers(&value[name]).and_then(|row| <[f64; 3]>::try_from(row).ok());
            row.ok_or_else(|| malformed("surfaces"))
        };
        let number = |name: &str| value[name].as_f64().ok_or_else(|| malformed("surfaces"));
        let axis = Vec3::from(triple("axis")?);
        Ok(match value["kind"].as_str() {
            Some("cylinder") => NaturalQuadric::cylinder(Point3::from(triple("point")?), axis, number("radius")?)?,
            Some("cone") => NaturalQuadric::cone(Point3::from(triple("apex")?), axis, number("half_angle")?)?,
            _ => return Err(malformed("surfaces")),
        })
    };
    let pair = QuadricPair::new([surface(0)?, surface(1)?])?;
    let kind = match pair.kind() {
        PairKind::Timelike => "timelike",
        PairKind::Spacelike => "spacelike",
    };
    check.exact("kind", kind);
    let allowed = allowed(case, check);
    check.number("norm_ratio", Some(pair.norm_ratio()), &allowed);
    Ok(())
}
