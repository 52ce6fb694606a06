//! Spheres, planes, circles and lines: constructs of `docs/math/reference-cases.md#closing-the-papers`.

use super::Handler;
use super::arc::{triple, xyz};
use super::case::{Case, Fault, array, malformed};
use super::check::Check;
use cyclide::{
    Point3, Vec3,
    conformal::{Line, Plane, Sphere},
    curve::{Circle, CircleOrLine, CurveMeeting, SphereOrPlane, SurfaceMeeting},
};
use serde_json::Value;

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "surface-intersect" => surfaces,
        "circle-surface-intersect" => curve_and_surface,
        "circle-angle" => angle,
        "point-distance" => distance,
        _ => return None,
    })
}

/// One of the two kinds of object, with the size of its numbers.
enum Object {
    Surface(SphereOrPlane),
    Curve(CircleOrLine),
}

fn object(case: &Case, name: &str) -> Result<(Object, f64), Fault> {
    let value = case.input(name)?;
    let numbers = |field: &str| array::<3>(&value[field]).ok_or_else(|| malformed(name));
    let point = |field: &str| numbers(field).map(Point3::from);
    let vector = |field: &str| numbers(field).map(Vec3::from);
    let radius = || value["radius"].as_f64().ok_or_else(|| malformed(name));
    let made = match value["kind"].as_str() {
        Some("sphere") => Object::Surface(SphereOrPlane::Sphere(Sphere::new(point("centre")?, radius()?)?)),
        Some("plane") => Object::Surface(SphereOrPlane::Plane(Plane::new(point("point")?, vector("normal")?)?)),
        Some("circle") => {
            Object::Curve(CircleOrLine::Circle(Circle::from_radius(point("centre")?, vector("normal")?, radius()?)?))
        }
        Some("line") => Object::Curve(CircleOrLine::Line(Line::new(point("point")?, vector("direction")?)?)),
        _ => return Err(malformed(name)),
    };
    let largest = |value: &Value| array::<3>(value).map_or(0.0, |p| p.iter().fold(0.0, |m: f64, x| m.max(x.abs())));
    let size = largest(&value["centre"]).max(largest(&value["point"])).max(value["radius"].as_f64().unwrap_or(0.0));
    Ok((made, size))
}

fn surface(case: &Case, name: &str) -> Result<(SphereOrPlane, f64), Fault> {
    match object(case, name)? {
        (Object::Surface(surface), size) => Ok((surface, size)),
        (Object::Curve(_), _) => Err(malformed(name)),
    }
}

fn curve(case: &Case, name: &str) -> Result<(CircleOrLine, f64), Fault> {
    match object(case, name)? {
        (Object::Curve(curve), size) => Ok((curve, size)),
        (Object::Surface(_), _) => Err(malformed(name)),
    }
}

/// Lengths by the largest entry of the field, or of the input; directions absolute.
fn length(case: &Case, check: &Check, field: &str, size: f64) -> impl Fn(&[f64]) -> f64 + use<> {
    let allowed = case.rtol() * check.largest_expected(field, 0).max(size);
    move |_| allowed
}

fn surfaces(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let ((first, a), (second, b)) = (surface(case, "first")?, surface(case, "second")?);
    let size = a.max(b);
    let rtol = case.rtol();
    match first.meet(&second)? {
        SurfaceMeeting::Curve(CircleOrLine::Circle(circle)) => {
            check.exact("kind", "circle");
            let allowed = length(case, check, "centre", size);
            check.vector("centre", Some(&xyz(circle.center())), &allowed);
            let allowed = length(case, check, "radius", size);
            check.number("radius", Some(circle.radius()), &allowed);
            check.vector("normal", Some(&triple(circle.normal())), &|_| rtol);
        }
        SurfaceMeeting::Curve(CircleOrLine::Line(line)) => {
            check.exact("kind", "line");
            let allowed = length(case, check, "point", size);
            check.vector("point", Some(&xyz(line.point())), &allowed);
            check.vector("direction", Some(&triple(line.direction())), &|_| rtol);
        }
        SurfaceMeeting::Point(point) => {
            check.exact("kind", "point");
            let allowed = length(case, check, "point", size);
            check.vector("point", Some(&xyz(point)), &allowed);
        }
        _ => check.exact("kind", "none"),
    }
    Ok(())
}

fn curve_and_surface(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let ((curve, a), (surface, b)) = (curve(case, "circle")?, surface(case, "surface")?);
    let (kind, points) = match curve.meet(&surface)? {
        CurveMeeting::Two(points) => ("two", points.to_vec()),
        CurveMeeting::One(point) => ("one", vec![point]),
        CurveMeeting::Tangent(point) => ("tangent", vec![point]),
        _ => ("none", Vec::new()),
    };
    check.exact("kind", kind);
    let allowed = length(case, check, "points", a.max(b));
    check.points("points", points.into_iter().map(xyz), &allowed);
    Ok(())
}

fn angle(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let ((first, _), (second, _)) = (curve(case, "first")?, curve(case, "second")?);
    let found = first.angle_with(&second);
    let allowed = length(case, check, "cosine", 1.0);
    check.number("cosine", Some(found.cosine), &allowed);
    check.exact("cospherical", found.cospherical);
    check.exact("same_circle", found.same);
    let rtol = case.rtol();
    check.number("angle", found.angle, &|_| rtol);
    Ok(())
}

fn distance(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let point = case.point("point")?;
    let (object, size) = object(case, "object")?;
    let found = match object {
        Object::Surface(surface) => surface.nearest(point)?,
        Object::Curve(curve) => curve.nearest(point)?,
    };
    let size = size.max(point.to_vec().max_abs());
    let allowed = length(case, check, "nearest", size);
    check.vector("nearest", Some(&xyz(found.point)), &allowed);
    check.vector("farthest", found.farthest.map(xyz).as_deref(), &allowed);
    check.number("distance", Some(found.distance), &allowed);
    check.number("signed", found.signed, &allowed);
    check.number("farthest_distance", found.farthest.map(|p| p.distance(point)), &allowed);
    Ok(())
}
