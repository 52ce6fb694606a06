//! Spherical cubes and volumes of cyclides: the constructs of `docs/math/reference-cases.md#volumes`.

use super::Handler;
use super::arc::xyz;
use super::case::{Case, Fault};
use super::check::Check;
use cyclide::{
    Point3,
    volume::{CyclideVolume, ParamVolume, SphericalCube, VolumeFrame, miquel_point},
};

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "miquel-point" => miquel,
        "spherical-cube" => spherical_cube,
        "cyclide-volume" => volume,
        _ => return None,
    })
}

/// The seven points of the cases, in binary order.
fn seven(case: &Case) -> Result<[Point3; 7], Fault> {
    let mut points = [Point3::ORIGIN; 7];
    for (point, name) in points.iter_mut().zip(["a0", "a1", "a2", "a12", "a3", "a13", "a23"]) {
        *point = case.point(name)?;
    }
    Ok(points)
}

/// `rtol` times the largest entry of the expected field.
fn relative(case: &Case, check: &Check, field: &str, parameters: usize) -> f64 {
    case.rtol() * check.largest_expected(field, parameters)
}

fn point(case: &Case, check: &mut Check, field: &str, got: Point3) {
    let allowed = relative(case, check, field, 0);
    check.vector(field, Some(&xyz(got)), &move |_| allowed);
}

fn table(case: &Case, check: &mut Check, field: &str, got: &[Vec<f64>]) {
    let allowed = relative(case, check, field, 0);
    check.table(field, got, &move |_| allowed);
}

fn miquel(case: &Case, check: &mut Check) -> Result<(), Fault> {
    point(case, check, "a123", miquel_point(seven(case)?)?);
    Ok(())
}

fn spherical_cube(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let corners = [case.point("a0")?, case.point("a1")?, case.point("a2")?, case.point("a3")?];
    let positions = [case.number("x12")?, case.number("x13")?, case.number("x23")?];
    let cube = SphericalCube::from_positions(corners, positions)?;
    for (k, name) in [(3, "a12"), (5, "a13"), (6, "a23"), (7, "a123")] {
        point(case, check, name, cube.corners()[k]);
    }
    check.exact("embedded", cube.is_embedded());
    Ok(())
}

fn volume(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let cube = SphericalCube::new(seven(case)?)?;
    // Some of the cases pass through infinity between their samples.
    let block = CyclideVolume::unbounded(&cube, VolumeFrame::First(case.vector("v1")?, case.vector("v2")?))?;
    point(case, check, "a123", cube.corners()[7]);
    let allowed = relative(case, check, "samples", 3);
    check.rows("samples", 3, |at| Some(xyz(block.point([at[0], at[1], at[2]]))), &move |_| allowed);
    for (name, speed) in ["q1", "q2", "q3"].into_iter().zip(block.speeds()) {
        table(case, check, name, &speed.map(|row| row.to_vec()));
    }
    let rows = block.to_rational().rows().iter().map(|row| row.to_vec()).collect::<Vec<_>>();
    table(case, check, "bezier_h", &rows);
    Ok(())
}
