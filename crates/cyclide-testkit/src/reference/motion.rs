//! Displacements and motions: the constructs of `docs/math/reference-cases.md#motions`.

use super::Handler;
use super::arc::xyz;
use super::case::{Case, Fault};
use super::check::Check;
use cyclide::{
    Point3, Quat, Vec3,
    conformal::HPoint,
    curve::QbSpline,
    motion::{CubicMotions, DualQuat, Pose, RationalMotion, ScrewMotion, StudyPoint, TimedPose},
};
use serde_json::Value;

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "study-point" => study_point,
        "study-displacement" => |case, check| displacement(case, check, StudyPoint::new(dual_quat(case)?)?),
        "study-displacement-paper" => {
            |case, check| displacement(case, check, StudyPoint::from_paper(case.quat("p")?, case.quat("q")?)?)
        }
        "motion-conic-three-poses" => |case, check| {
            let motion = RationalMotion::conic(&poses(case)?)?;
            images(case, check, |t| motion.pose(t))
        },
        "motion-quartic-five-poses" => |case, check| {
            let motion = RationalMotion::quartic(&poses(case)?)?;
            images(case, check, |t| motion.pose(t))
        },
        "motion-spline-fibre" => |case, check| {
            let motion = RationalMotion::spline(&poses(case)?)?;
            images(case, check, |t| motion.pose(t))
        },
        "motion-sclerp" => |case, check| {
            let motion = ScrewMotion::new(&poses(case)?)?;
            images(case, check, |t| motion.pose(t))
        },
        "motion-cubic-cross-ratio" => cubic,
        "qb-as-motion" => qb_as_motion,
        _ => return None,
    })
}

/// `p + ε q`.
fn dual_quat(case: &Case) -> Result<DualQuat, Fault> {
    Ok(DualQuat { real: case.quat("p")?, dual: case.quat("q")? })
}

fn study_point(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let point = StudyPoint::from_quotient(case.quat("q")?, case.quat("p")?)?.quotient();
    check_point(case, check, point)
}

fn displacement(case: &Case, check: &mut Check, at: StudyPoint) -> Result<(), Fault> {
    check_point(case, check, at.displace(case.point("x")?))
}

fn check_point(case: &Case, check: &mut Check, point: Point3) -> Result<(), Fault> {
    let allowed = relative(case, check, "point", 0);
    check.vector("point", Some(&xyz(point)), &move |_| allowed);
    Ok(())
}

/// `rtol` times the largest entry of the expected field, but for parameters.
fn relative(case: &Case, check: &Check, field: &str, parameters: usize) -> f64 {
    case.rtol() * check.largest_expected(field, parameters)
}

/// Rows of a time and the places of the origin and of two unit points of the body.
fn images(case: &Case, check: &mut Check, at: impl Fn(f64) -> Pose) -> Result<(), Fault> {
    let body = [Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Point3::new(0.0, 1.0, 0.0)];
    let allowed = relative(case, check, "images", 1);
    let row = |t: f64| {
        let pose = at(t);
        body.into_iter().flat_map(|x| xyz(pose.apply(x))).collect()
    };
    check.samples("images", row, &move |_| allowed);
    Ok(())
}

/// A curve of pairs as a motion, by the paper's action at the parameter and by the motion along it.
fn qb_as_motion(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (curve, t, x) = (super::qb::curve(case)?, case.number("t")?, case.point("x")?);
    let at = |part: fn(&HPoint) -> Quat| {
        let mut row: Vec<Quat> = curve.pairs().iter().map(part).collect();
        while row.len() > 1 {
            row = row.windows(2).map(|w| w[0] * (1.0 - t) + w[1] * t).collect();
        }
        row[0]
    };
    let by_paper = StudyPoint::from_paper(at(|pair| pair.d), at(|pair| pair.n))?.displace(x);
    let motion = RationalMotion::along(&QbSpline::from_curve(curve.clone())?, curve.pairs()[0].d)?;
    for (field, point) in [("paper_action", by_paper), ("half_convention", motion.pose(t).apply(x))] {
        let allowed = relative(case, check, field, 0);
        check.vector(field, Some(&xyz(point)), &move |_| allowed);
    }
    Ok(())
}

fn cubic(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let poses: Vec<Pose> = poses(case)?.into_iter().map(|timed| timed.pose).collect();
    let cubics = CubicMotions::new(&poses)?;
    for (field, roots) in [("roots", cubics.cross_ratios().to_vec()), ("admissible", cubics.admissible())] {
        let allowed = relative(case, check, field, 0);
        check.vector(field, Some(&roots), &move |_| allowed);
    }
    Ok(())
}

/// The poses of a case, with any sign and length of the rotations.
fn poses(case: &Case) -> Result<Vec<TimedPose>, Fault> {
    let malformed = || Fault::Malformed("input `poses` is not of its type".into());
    let list = case.input("poses")?.as_array().ok_or_else(malformed)?;
    list.iter()
        .map(|row| {
            let rotation = numbers::<4>(&row["rotation"]).ok_or_else(malformed)?;
            let translation = numbers::<3>(&row["translation"]).ok_or_else(malformed)?;
            let time = number(&row["t"]).ok_or_else(malformed)?;
            Ok(TimedPose { time, pose: Pose::new(Quat::from(rotation), Vec3::from(translation))? })
        })
        .collect()
}

fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let numbers: Vec<f64> = value.as_array()?.iter().map(number).collect::<Option<_>>()?;
    numbers.try_into().ok()
}

/// A number, or the name of one that is not finite.
fn number(value: &Value) -> Option<f64> {
    match value.as_str() {
        Some("NaN") => Some(f64::NAN),
        Some("Infinity") => Some(f64::INFINITY),
        Some("-Infinity") => Some(f64::NEG_INFINITY),
        Some(_) => None,
        None => value.as_f64(),
    }
}
