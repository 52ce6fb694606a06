//! Surfaces of revolution: the first constructs of `docs/math/reference-cases.md#surfaces-of-arcs`.

use super::Handler;
use super::arc::{Rules, xyz};
use super::case::{Case, Fault};
use super::check::{Check, numbers};
use cyclide::{construct::Revolution, rational::RationalBezier};

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "revolution" => surface,
        "revolution-angle" => angle,
        _ => return None,
    })
}

fn turn(case: &Case) -> Result<Revolution, Fault> {
    Ok(Revolution::new(case.point("axis_point")?, case.vector("axis_dir")?, case.number("angle")?)?)
}

fn surface(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let points = case.points("profile")?;
    let weights = numbers(case.input("weights")?).ok_or_else(|| Fault::Malformed("weights are numbers".into()))?;
    let rows = points.iter().zip(weights).map(|(p, w)| [p.x * w, p.y * w, p.z * w, w]);
    let surface = turn(case)?.surface(&RationalBezier::new(rows.collect())?)?;
    check.surface_samples("samples", |s, t| xyz(surface.point(s, t)), &rules.point());
    let rows: Vec<Vec<f64>> = surface.rows().iter().map(|row| row.to_vec()).collect();
    check.table("net_h", &rows, &rules.homogeneous());
    Ok(())
}

fn angle(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (turn, point) = (turn(case)?, case.point("point")?);
    check.samples("samples_angle", |angle| xyz(turn.turned(point, angle)), &Rules::of(case)?.point());
    Ok(())
}
