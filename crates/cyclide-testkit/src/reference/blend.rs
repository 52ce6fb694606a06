//! Circles and spheres through points, and blends of circles: the constructs of
//! `docs/math/reference-cases.md#circle-blends`, about curves.

use super::Handler;
use super::arc::{triple, xyz};
use super::case::{Case, Fault};
use super::check::Check;
use cyclide::{
    Point3,
    conformal::Sphere,
    curve::{BlendSegment, BlendVariant, Circle, CircleSpline, CircleSplineOptions, ParamCurve},
};
use serde_json::Value;

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "circle-through-points" => circle_through_points,
        "sphere-through-points" => sphere_through_points,
        "blend-angle" => blend_angle,
        "circle-blend-curve" => |case, check| curve(case, check, BlendVariant::Trigonometric),
        "rational-circle-blend-curve" => |case, check| curve(case, check, BlendVariant::Rational),
        "circle-blend-derivatives" => derivatives,
        "rational-circle-blend-bezier" => bezier,
        "circle-blend-hermite" => hermite,
        _ => return None,
    })
}

/// The comparison rules of `docs/math/reference-cases.md#circle-blends`.
#[derive(Clone, Copy)]
pub(super) struct Rules {
    rtol: f64,
    /// Largest absolute coordinate of the input points.
    size: f64,
}

impl Rules {
    pub(super) fn of(case: &Case, points: &[Point3]) -> Self {
        Self { rtol: case.rtol(), size: points.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max) }
    }

    /// Points, centers, radii, homogeneous coordinates.
    pub(super) fn point(self) -> impl Fn(&[f64]) -> f64 {
        move |_| self.rtol * self.size
    }

    /// Angles, weights, tangents.
    pub(super) fn absolute(self) -> impl Fn(&[f64]) -> f64 {
        move |_| self.rtol
    }

    /// Curvature and torsion.
    pub(super) fn relative(self) -> impl Fn(&[f64]) -> f64 {
        move |want| self.rtol * largest(want)
    }
}

fn largest(v: &[f64]) -> f64 {
    v.iter().fold(0.0, |m: f64, x| m.max(x.abs()))
}

/// A fixed number of input points.
fn points<const N: usize>(case: &Case) -> Result<[Point3; N], Fault> {
    case.points("points")?.try_into().map_err(|_| Fault::Malformed(format!("input `points` needs {N} points")))
}

fn circle_through_points(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let points = points::<3>(case)?;
    let rules = Rules::of(case, &points);
    let circle = Circle::through_points(points)?;
    check.vector("centre", Some(&xyz(circle.center())), &rules.point());
    check.number("radius", Some(circle.radius()), &rules.point());
    let tangent = circle.tangent_at(points[1]).map(triple);
    check.vector("tangent_at_second", tangent.as_ref().map(<[f64; 3]>::as_slice), &rules.absolute());
    Ok(())
}

fn sphere_through_points(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let points = points::<4>(case)?;
    let rules = Rules::of(case, &points);
    let sphere = Sphere::through_points(points)?;
    check.vector("centre", Some(&xyz(sphere.center())), &rules.point());
    check.number("radius", Some(sphere.radius()), &rules.point());
    Ok(())
}

fn order(case: &Case) -> Result<u32, Fault> {
    Ok(u32::try_from(case.count("order")?).unwrap_or(u32::MAX))
}

fn blend_angle(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let points = points::<4>(case)?;
    let rules = Rules::of(case, &points);
    // The angle belongs to the circles alone: order and variant have no part in it.
    let segment = BlendSegment::from_points(points, 1, BlendVariant::Trigonometric)?;
    check.number("theta", Some(segment.theta()), &rules.absolute());
    check.exact("long_way", segment.long_way());
    Ok(())
}

fn spline(case: &Case, closed: bool, variant: BlendVariant) -> Result<(CircleSpline, Rules), Fault> {
    let points = case.points("points")?;
    let options = CircleSplineOptions { closed, order: order(case)?, variant, ..Default::default() };
    Ok((CircleSpline::from_points(&points, &options)?, Rules::of(case, &points)))
}

fn curve(case: &Case, check: &mut Check, variant: BlendVariant) -> Result<(), Fault> {
    let (spline, rules) = spline(case, case.flag("closed")?, variant)?;
    check.samples("samples", |t| xyz(spline.point(t)), &rules.point());
    check.points("theta", spline.segments().iter().map(|s| [s.theta()]), &rules.absolute());
    Ok(())
}

/// The segment that the input names.
fn segment(case: &Case, variant: BlendVariant) -> Result<(BlendSegment, Rules), Fault> {
    let (spline, rules) = spline(case, false, variant)?;
    let index = usize::try_from(case.count("segment")?).unwrap_or(usize::MAX);
    let segment = spline.segments().get(index).ok_or(Fault::Malformed("input `segment` is no segment".into()))?;
    Ok((*segment, rules))
}

fn derivatives(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (segment, rules) = segment(case, BlendVariant::Trigonometric)?;
    let places = check.want_raw("at").and_then(Value::as_array);
    for (i, place) in places.into_iter().flatten().enumerate() {
        let l = place["lambda"].as_f64().ok_or(Fault::Malformed("no `lambda`".into()))?;
        let jet = segment.jet(l);
        check.nested("at", &format!("element {i}: "), place, |check| {
            check.number("lambda", Some(l), &rules.absolute());
            check.vector("point", Some(&xyz(jet.point)), &rules.point());
            for (field, d) in [("d1", jet.d1), ("d2", jet.d2), ("d3", jet.d3)] {
                check.vector(field, Some(&triple(d)), &rules.relative());
            }
            check.number("curvature", jet.curvature(), &rules.relative());
            check.number("torsion", jet.torsion(), &rules.relative());
        });
    }
    Ok(())
}

fn bezier(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (segment, rules) = segment(case, BlendVariant::Rational)?;
    bezier_rows(&segment, check, rules)
}

/// Degree and homogeneous rows of a segment.
pub(super) fn bezier_rows(segment: &BlendSegment, check: &mut Check, rules: Rules) -> Result<(), Fault> {
    let bezier = segment.to_bezier().ok_or(Fault::Malformed("the segment has no rational form".into()))?;
    check.exact("degree", bezier.degree());
    let rows = check.want_raw("homogeneous").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    if rows.len() != bezier.rows().len() {
        check.fail("homogeneous", format!("{} rows, expected {}", bezier.rows().len(), rows.len()));
    }
    for (i, (want, got)) in rows.iter().zip(bezier.rows()).enumerate() {
        let place = format!("row {i}: ");
        match super::check::numbers(want).as_deref() {
            Some([x, y, z, w]) => {
                let error = (got[0] - x).hypot(got[1] - y).hypot(got[2] - z);
                check.measure("homogeneous", &place, error, rules.point()(&[]));
                check.measure("homogeneous", &place, (got[3] - w).abs(), rules.absolute()(&[]));
            }
            _ => check.fail("homogeneous", format!("{place}the expected value is no row of four")),
        }
    }
    Ok(())
}

fn hermite(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let ends = [case.point("start")?, case.point("end")?];
    let tangents = [case.vector("start_tangent")?, case.vector("end_tangent")?];
    let rules = Rules::of(case, &ends);
    let variant = BlendVariant::Trigonometric;
    let segment = BlendSegment::hermite(ends[0], tangents[0], ends[1], tangents[1], order(case)?, variant)?;
    check.samples("samples", |l| xyz(segment.point(l)), &rules.point());
    check.number("theta", Some(segment.theta()), &rules.absolute());
    check.exact("long_way", segment.long_way());
    Ok(())
}
