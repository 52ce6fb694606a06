//! Single arcs and circles: the constructs of `docs/math/reference-cases.md#arcs-and-arc-splines`, up to
//! `circle-nurbs`.

use super::Handler;
use super::case::{Case, Fault};
use super::check::Check;
use cyclide::{
    Point3, Vec3,
    curve::{Arc, Arc4, Circle, ParamCurve},
    rational::NurbsCurve,
};
use serde_json::Value;

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "arc-three-points" => three_points,
        "arc-point-tangent" => point_tangent,
        "arc-weights" => weights,
        "arc-weights-4d" => weights_4d,
        "arc-complex" => complex,
        "arc-angle-parameter" => angle_parameter,
        "arc-split" => split,
        "arc-reverse" => reverse,
        "arc-bbox" => bounds,
        "arc-closest-point" => closest_point,
        "arc-subdivide" => subdivide,
        "arc-nurbs" => nurbs,
        "arc-bulge" => bulge,
        "circle-nurbs" => circle_nurbs,
        _ => return None,
    })
}

/// The comparison rules of `docs/math/reference-cases.md#arcs-and-arc-splines`: the error allowed, from the expected
/// numbers.
#[derive(Clone, Copy)]
pub(super) struct Rules {
    rtol: f64,
    scale: f64,
}

impl Rules {
    pub(super) fn of(case: &Case) -> Result<Self, Fault> {
        Ok(Self { rtol: case.rtol(), scale: case.scale()? })
    }

    /// Points, and the lengths of biarcs and splines.
    pub(super) fn point(self) -> impl Fn(&[f64]) -> f64 {
        move |_| self.rtol * self.scale
    }

    /// Unit vectors, angles, parameters, weights.
    pub(super) fn unit(self) -> impl Fn(&[f64]) -> f64 {
        move |_| self.rtol
    }

    /// Lengths, radii.
    pub(super) fn relative(self) -> impl Fn(&[f64]) -> f64 {
        move |want| self.rtol * norm(want)
    }

    /// The angles of biarcs.
    pub(super) fn biarc_angle(self) -> impl Fn(&[f64]) -> f64 {
        move |_| 10.0 * self.rtol
    }

    /// Derivatives.
    fn vector(self) -> impl Fn(&[f64]) -> f64 {
        move |want| self.rtol * norm(want).max(self.scale)
    }

    /// Curvature has no rule of its own; it is an inverse length, so the rule of vectors is taken with the stricter of
    /// the scale and its inverse.
    fn curvature(self) -> impl Fn(&[f64]) -> f64 {
        move |want| self.rtol * norm(want).max(self.scale.min(1.0 / self.scale))
    }

    /// A bulge, relative if above 1.
    fn bulge(self) -> impl Fn(&[f64]) -> f64 {
        move |want| self.rtol * norm(want).max(1.0)
    }

    /// Homogeneous rows, whose last number is the weight.
    pub(super) fn homogeneous(self) -> impl Fn(&[f64]) -> f64 {
        move |want| 10.0 * self.rtol * self.scale.max(1.0) * want.last().map_or(1.0, |w| w.abs().max(1.0))
    }

    /// Centers: of the radius's size if that is larger.
    fn center(self, radius: Option<f64>) -> impl Fn(&[f64]) -> f64 {
        move |_| self.rtol * self.scale.max(radius.unwrap_or(0.0))
    }
}

fn norm(v: &[f64]) -> f64 {
    v.iter().fold(0.0, |s: f64, x| s.hypot(*x))
}

pub(super) fn xyz(p: Point3) -> Vec<f64> {
    p.to_array().to_vec()
}

fn xy(p: Point3) -> Vec<f64> {
    vec![p.x, p.y]
}

pub(super) fn triple(v: Vec3) -> [f64; 3] {
    [v.x, v.y, v.z]
}

fn vector(check: &mut Check, field: &str, got: Option<Vec3>, allowed: &dyn Fn(&[f64]) -> f64) {
    check.vector(field, got.map(triple).as_ref().map(<[f64; 3]>::as_slice), allowed);
}

fn point(check: &mut Check, field: &str, got: Option<Point3>, allowed: &dyn Fn(&[f64]) -> f64) {
    check.vector(field, got.map(Point3::to_array).as_ref().map(<[f64; 3]>::as_slice), allowed);
}

/// The fields that every arc has.
fn common(arc: &Arc, rules: Rules, check: &mut Check) {
    check.samples("samples", |t| xyz(arc.point(t)), &rules.point());
    let radius = check.number_expected("radius");
    point(check, "center", arc.center(), &rules.center(radius));
    check.number("radius", arc.radius(), &rules.relative());
    check.number("angle", Some(arc.angle()), &rules.unit());
    vector(check, "normal", arc.normal(), &rules.unit());
}

/// The fields of arcs that are compared with classical geometry in full.
fn geometry(arc: &Arc, rules: Rules, check: &mut Check) {
    common(arc, rules, check);
    check.number("length", Some(arc.length()), &rules.relative());
    vector(check, "tangent_start", arc.start_tangent(), &rules.unit());
    vector(check, "tangent_end", arc.end_tangent(), &rules.unit());
    vector(check, "curvature_binormal", Some(arc.curvature_binormal()), &rules.curvature());
}

fn three_points(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let arc = Arc::from_three_points(case.point("a0")?, case.point("b")?, case.point("a1")?)?;
    geometry(&arc, rules, check);
    vector(check, "tangent_at_b", arc.jet(0.5).tangent(), &rules.unit());
    Ok(())
}

/// The arc of the many constructs that are given by ends and start derivative.
fn from_tangent(case: &Case) -> Result<Arc, Fault> {
    Ok(Arc::from_start_tangent(case.point("a0")?, case.point("a1")?, case.vector("v0")?)?)
}

fn point_tangent(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let arc = from_tangent(case)?;
    geometry(&arc, rules, check);
    vector(check, "v1", Some(arc.end_derivative()), &rules.vector());
    check.points("bezier_h", arc.bezier_rows(), &rules.homogeneous());
    check.number("bulge", Some(arc.bulge_vector().length()), &rules.bulge());
    Ok(())
}

fn weights(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let arc = Arc::from_weights(case.point("a0")?, case.point("a1")?, case.quat("w0")?, case.quat("w1")?)?;
    common(&arc, rules, check);
    check.points("bezier_h", arc.bezier_rows(), &rules.homogeneous());
    Ok(())
}

fn weights_4d(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let arc = Arc4::from_weights(case.quat("a0")?, case.quat("a1")?, case.quat("w0")?, case.quat("w1")?)?;
    check.samples("samples", |t| arc.point(t).to_array().to_vec(), &rules.point());
    let radius = check.number_expected("radius");
    let center = arc.center().map(cyclide::Quat::to_array);
    check.vector("center", center.as_ref().map(<[f64; 4]>::as_slice), &rules.center(radius));
    check.number("radius", arc.radius(), &rules.relative());
    check.number("angle", Some(arc.angle()), &rules.unit());
    Ok(())
}

/// Swept angle of a planar arc, counter-clockwise positive.
fn turn(arc: &Arc) -> f64 {
    arc.angle().copysign(arc.normal().map_or(1.0, |n| n.z))
}

fn complex(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let arc = Arc::from_complex(case.pair("a0")?, case.pair("a1")?, case.pair("w0")?, case.pair("w1")?)?;
    check.samples("samples", |t| xy(arc.point(t)), &rules.point());
    check.number("turn", Some(turn(&arc)), &rules.unit());
    let radius = check.number_expected("radius");
    check.vector("center", arc.center().map(xy).as_deref(), &rules.center(radius));
    check.number("radius", arc.radius(), &rules.relative());
    Ok(())
}

fn angle_parameter(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let arc = from_tangent(case)?;
    check.samples("t", |l| vec![arc.parameter_at_length(l)], &rules.unit());
    check.samples("samples", |l| xyz(arc.point_at_length(l)), &rules.point());
    Ok(())
}

/// Ends and start derivative of an arc, the members of `part` (or the fields of the case itself).
fn data(arc: &Arc, rules: Rules, check: &mut Check) {
    point(check, "a0", Some(arc.start()), &rules.point());
    point(check, "a1", Some(arc.end()), &rules.point());
    vector(check, "v0", Some(arc.start_derivative()), &rules.vector());
}

fn split(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let (left, right) = from_tangent(case)?.split(case.number("t")?)?;
    for (field, arc) in [("left", left), ("right", right)] {
        let value = check.want_raw(field).unwrap_or(&Value::Null);
        check.nested(field, "", value, |inner| data(&arc, rules, inner));
    }
    Ok(())
}

fn reverse(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    data(&from_tangent(case)?.reversed(), rules, check);
    Ok(())
}

fn bounds(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let bounds = from_tangent(case)?.bounds();
    point(check, "min", Some(bounds.min), &rules.point());
    point(check, "max", Some(bounds.max), &rules.point());
    Ok(())
}

fn closest_point(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let closest = from_tangent(case)?.closest_point(case.point("point")?);
    check.number("t", Some(closest.t), &rules.unit());
    point(check, "point", Some(closest.point), &rules.point());
    check.number("distance", Some(closest.distance), &rules.relative());
    Ok(())
}

fn subdivide(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let levels = u32::try_from(case.count("levels")?).unwrap_or(u32::MAX);
    let points = from_tangent(case)?.uniform_points(levels)?;
    check.points("points", points.into_iter().map(xyz), &rules.point());
    Ok(())
}

/// The fields of a rational B-spline.
fn spline(nurbs: &NurbsCurve, rules: Rules, check: &mut Check) {
    check.exact("degree", nurbs.degree());
    check.points("knots", nurbs.knots().iter().map(|k| [*k]), &rules.unit());
    check.points("control_points", nurbs.control_points().iter().map(|p| xyz(*p)), &rules.point());
    check.points("weights", nurbs.weights().iter().map(|w| [*w]), &rules.unit());
}

fn nurbs(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let nurbs = from_tangent(case)?.to_nurbs(case.number("max_angle")?)?;
    check.exact("pieces", nurbs.span_count());
    spline(&nurbs, rules, check);
    Ok(())
}

fn bulge(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let ([x0, y0], [x1, y1]) = (case.pair("p0")?, case.pair("p1")?);
    let (p0, p1) = (Point3::new(x0, y0, 0.0), Point3::new(x1, y1, 0.0));
    let arc = Arc::from_bulge(p0, p1, Vec3::Z, case.number("bulge")?)?;
    check.number("turn", Some(turn(&arc)), &rules.unit());
    check.samples("samples", |t| xy(arc.point(t)), &rules.point());
    check.number("radius", arc.radius(), &rules.relative());
    Ok(())
}

fn circle_nurbs(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let circle = Circle::from_center(case.point("center")?, case.vector("normal")?, case.point("start")?)?;
    spline(&circle.to_nurbs()?, rules, check);
    Ok(())
}
