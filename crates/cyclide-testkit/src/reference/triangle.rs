//! Patches over triangles: the constructs of `docs/math/reference-cases.md#circle-blends`.

use super::Handler;
use super::arc::{triple, xyz};
use super::blend::Rules;
use super::case::{Case, Fault};
use super::check::Check;
use cyclide::{
    Error, Point3,
    surface::{SmoothTriangle, SphereBlend},
};

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "sphere-blend" => sphere_blend,
        "blend-patch" => blend_patch,
        _ => return None,
    })
}

/// Refusals may come with the place: the patch is asked on a grid, with the middle and those of the sides.
const GRID: u32 = 12;

fn places() -> impl Iterator<Item = [f64; 3]> {
    (0..=GRID).flat_map(|i| (0..=GRID - i).map(move |j| [i, j, GRID - i - j].map(f64::from)))
}

/// The third coordinate is what is left to 1, and not less than nothing.
fn lambda(s: f64, t: f64) -> [f64; 3] {
    [s, t, (1.0 - s - t).max(0.0)]
}

fn triangle(case: &Case, name: &str) -> Result<[Point3; 3], Fault> {
    case.points(name)?.try_into().map_err(|_| Fault::Malformed(format!("input `{name}` needs 3 points")))
}

/// The coordinates, none where the patch refuses the place.
fn numbers<T>(at: Result<T, Error>, coordinates: impl Fn(T) -> Vec<f64>) -> Vec<f64> {
    at.map(coordinates).unwrap_or_default()
}

fn sphere_blend(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (corners, control) = (triangle(case, "triangle")?, triangle(case, "control")?);
    let patch = SphereBlend::from_control_points(corners, control)?;
    places().try_for_each(|at| patch.point(at).map(drop))?;
    let rules = Rules::of(case, &[corners, control].concat());
    check.surface_samples("samples", |s, t| numbers(patch.point(lambda(s, t)), xyz), &rules.point());
    let normal = |s, t| numbers(patch.normal(lambda(s, t)), |n| triple(n).to_vec());
    check.surface_samples("normals", normal, &rules.absolute());
    Ok(())
}

fn blend_patch(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let corners = triangle(case, "triangle")?;
    let normals = triangle(case, "normals")?.map(Point3::to_vec);
    let patch = SmoothTriangle::new(corners, normals)?;
    places().try_for_each(|at| patch.point(at).map(drop))?;
    let rules = Rules::of(case, &corners);
    check.surface_samples("samples", |s, t| numbers(patch.point(lambda(s, t)), xyz), &rules.point());
    Ok(())
}
