//! Circles and spheres through points, and blends of circles: the constructs of `50`, section 10, about curves.

use super::Handler;
use super::arc::{triple, xyz};
use super::case::{Case, Fault};
use super::check::Check;
use cyclide::{Circle, Point3, Sphere};

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "circle-through-points" => circle_through_points,
        "sphere-through-points" => sphere_through_points,
        _ => return None,
    })
}

/// The comparison rules of `50`, section 10.
#[derive(Clone, Copy)]
struct Rules {
    rtol: f64,
    /// Largest absolute coordinate of the input points.
    size: f64,
}

impl Rules {
    fn of(case: &Case, points: &[Point3]) -> Self {
        Self { rtol: case.rtol(), size: points.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max) }
    }

    /// Points, centres, radii, homogeneous coordinates.
    fn point(self) -> impl Fn(&[f64]) -> f64 {
        move |_| self.rtol * self.size
    }

    /// Angles, weights, tangents.
    fn absolute(self) -> impl Fn(&[f64]) -> f64 {
        move |_| self.rtol
    }
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
