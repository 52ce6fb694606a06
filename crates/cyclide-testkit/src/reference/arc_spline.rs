//! Biarcs and arc splines: the constructs `biarc` and `arc-spline` of
//! `docs/math/reference-cases.md#arcs-and-arc-splines`.

use super::Handler;
use super::arc::{Rules, triple, xyz};
use super::case::{Case, Fault};
use super::check::Check;
use cyclide::{
    construct::{ArcSplineOptions, Biarc, BiarcRule, estimate_tangents},
    curve::{Arc, ArcPath},
};

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "biarc" => biarc,
        "arc-spline" => arc_spline,
        _ => return None,
    })
}

fn rule(case: &Case) -> Result<BiarcRule, Fault> {
    match case.word("rule")? {
        "equal-d" => Ok(BiarcRule::EqualD),
        "equal-chord" => Ok(BiarcRule::EqualChord),
        "auto" => Ok(BiarcRule::Auto),
        other => Err(Fault::Malformed(format!("no biarc rule {other}"))),
    }
}

fn biarc(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let (p0, t0, p1, t1) = (case.point("p0")?, case.vector("t0")?, case.point("p1")?, case.vector("t1")?);
    let biarc = Biarc::new(p0, t0, p1, t1, rule(case)?)?;
    let each = |f: fn(&Arc) -> Option<f64>| biarc.arcs().iter().map(f).map(|v| v.map(|x| vec![x])).collect::<Vec<_>>();
    check.vector("J", Some(&biarc.joint().to_array()), &rules.point());
    check.vector("tangent_J", Some(&triple(biarc.joint_tangent())), &rules.unit());
    check.list("angles", &each(|a| Some(a.angle())), &rules.biarc_angle());
    check.list("lengths", &each(|a| Some(a.length())), &rules.point());
    check.list("radii", &each(Arc::radius), &rules.relative());
    Ok(())
}

fn arc_spline(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let rules = Rules::of(case)?;
    let (points, closed) = (case.points("points")?, case.flag("closed")?);
    let path = ArcPath::spline(&points, &ArcSplineOptions { closed, rule: rule(case)?, tangents: None })?;
    let tangents = estimate_tangents(&points, closed)?;
    check.points("tangents", tangents.into_iter().map(triple), &rules.unit());
    check.points("J", path.arcs().iter().step_by(2).map(|a| xyz(a.end())), &rules.point());
    check.number("length", Some(path.length()), &rules.point());
    check.exact("segments", path.arcs().len());
    Ok(())
}
