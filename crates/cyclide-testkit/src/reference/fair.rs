//! Fair circle splines: the constructs of `docs/math/reference-cases.md#fair-splines`.

use super::Handler;
use super::arc::{triple, xyz};
use super::blend::{Rules, bezier_rows};
use super::case::{Case, Fault};
use super::check::Check;
use cyclide::{
    Point3, Vec3, Warning,
    construct::{FairEnd, FairSplineOptions},
    curve::{BlendLaw, BlendSegment, CircleSpline, ParamCurve},
};
use cyclide::{construct::blends_by_turn, warning::CurveWarning};

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "fair-spline" => curve,
        "fair-spline-bezier" => bezier,
        "fair-spline-residual" => residual,
        "blend-segment-ends" => segment_ends,
        "fair-spline-relaxation" => relaxation,
        _ => return None,
    })
}

fn tension(case: &Case) -> Result<f64, Fault> {
    if case.input("tension").is_ok() { case.number("tension") } else { Ok(0.0) }
}

/// The ends by their names; arcs where none are named.
fn ends(case: &Case) -> Result<[FairEnd; 2], Fault> {
    let Ok(named) = case.input("ends") else { return Ok([FairEnd::Arc; 2]) };
    let end = |index: usize, tangent: &str| match named[index].as_str() {
        Some("arc") => Ok(FairEnd::Arc),
        Some("free") => Ok(FairEnd::Free),
        Some("clamped") => case.vector(tangent).map(FairEnd::Clamped),
        _ => Err(Fault::Malformed(format!("no word in `ends` for end {index}"))),
    };
    Ok([end(0, "start_tangent")?, end(1, "end_tangent")?])
}

/// The spline of a case: all blends as they are asked for, and nothing cut.
fn spline(case: &Case) -> Result<(CircleSpline, Rules), Fault> {
    let points = case.points("points")?;
    let options = FairSplineOptions {
        closed: case.flag("closed")?,
        ends: ends(case)?,
        tension: tension(case)?,
        straight_runs: false,
        cut_sharp_turns: false,
        ..Default::default()
    };
    Ok((CircleSpline::fair(&points, &options)?, Rules::of(case, &points)))
}

fn blend(segment: &BlendSegment) -> f64 {
    if let BlendLaw::Fair { blend } = segment.law() { blend } else { f64::NAN }
}

fn shortest_chord(segments: &[BlendSegment]) -> f64 {
    segments.iter().map(BlendSegment::chord_length).fold(f64::INFINITY, f64::min)
}

/// Entries below this over the shortest chord are zero to the 50 digits of the reference.
const ZERO_OF_REFERENCE: f64 = 1e-40;

/// Vectors of a list: relative to its largest entry, or to the shortest chord where all vanish.
fn in_list(case: &Case, check: &Check, field: &str, chord: f64) -> impl Fn(&[f64]) -> f64 + use<> {
    let largest = check.largest_expected(field, 0);
    let allowed = case.rtol() * if largest * chord > ZERO_OF_REFERENCE { largest } else { 1.0 / chord };
    move |_| allowed
}

fn curve(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (spline, rules) = spline(case)?;
    let segments = spline.segments();
    let last = segments.last().filter(|_| !spline.is_closed());
    let tangents = segments.iter().map(BlendSegment::start_tangent).chain(last.map(BlendSegment::end_tangent));
    check.points("tangents", tangents.map(triple), &rules.absolute());
    check.points("blend", segments.iter().map(|s| [blend(s)]), &rules.absolute());
    check.points("theta", segments.iter().map(|s| [s.theta()]), &rules.absolute());
    let curvatures = segments.iter().map(|s| s.end_curvatures()[0]).chain(last.map(|s| s.end_curvatures()[1]));
    let allowed = in_list(case, check, "curvature", shortest_chord(segments));
    check.points("curvature", curvatures.map(triple), &allowed);
    check.exact("relaxed", spline.warnings().iter().any(|w| matches!(w, Warning::Curve(CurveWarning::Relaxed { .. }))));
    check.samples("samples", |t| xyz(spline.point(t)), &rules.point());
    Ok(())
}

fn bezier(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (spline, rules) = spline(case)?;
    let index = usize::try_from(case.count("segment")?).unwrap_or(usize::MAX);
    let segment = spline.segments().get(index).ok_or(Fault::Malformed("input `segment` is no segment".into()))?;
    bezier_rows(segment, check, rules)
}

/// Segments between given tangents, of the given tension.
fn residual(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (points, tangents) = (case.points("points")?, case.vectors("tangents")?);
    let (n, closed, blend) = (points.len(), case.flag("closed")?, 1.0 - tension(case)?);
    if tangents.len() != n {
        return Err(Fault::Malformed("input `tangents` needs one tangent per point".into()));
    }
    let segment = |i: usize| {
        let j = (i + 1) % n;
        BlendSegment::fair(points[i], tangents[i], points[j], tangents[j], blend)
    };
    let segments: Vec<BlendSegment> = (0..n - usize::from(!closed)).map(segment).collect::<Result<_, _>>()?;
    check.number(
        "energy",
        Some(segments.iter().map(BlendSegment::fair_energy).sum()),
        &Rules::of(case, &points).relative(),
    );
    let inner = if closed { 0..n } else { 1..n - 1 };
    let jump = |i: usize| -> Vec3 {
        let before = &segments[(i + n - 1) % n];
        before.end_curvatures()[1] - segments[i].end_curvatures()[0]
    };
    let allowed = in_list(case, check, "jumps", shortest_chord(&segments));
    check.points("jumps", inner.map(jump).map(triple), &allowed);
    check.flags("long_way", &segments.iter().map(BlendSegment::long_way).collect::<Vec<_>>());
    Ok(())
}

fn segment_ends(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (start, end) = (case.point("start")?, case.point("end")?);
    let tangents = [case.vector("start_tangent")?, case.vector("end_tangent")?];
    let segment = BlendSegment::fair(start, tangents[0], end, tangents[1], case.number("blend")?)?;
    let rules = Rules::of(case, &[start, end]);
    check.number("theta", Some(segment.theta()), &rules.absolute());
    check.exact("long_way", segment.long_way());
    let rows = [
        ("curvature_start", segment.end_curvatures()[0]),
        ("curvature_end", segment.end_curvatures()[1]),
        ("variation_start", segment.end_variations()[0]),
        ("variation_end", segment.end_variations()[1]),
    ];
    for (field, vector) in rows {
        let allowed = in_list(case, check, field, segment.chord_length());
        check.vector(field, Some(&triple(vector)), &allowed);
    }
    Ok(())
}

fn relaxation(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let points: Vec<Point3> = case.points("points")?;
    let blends = blends_by_turn(&points, case.flag("closed")?, tension(case)?)?;
    check.points("blend", blends.into_iter().map(|e| [e]), &Rules::of(case, &points).absolute());
    Ok(())
}
