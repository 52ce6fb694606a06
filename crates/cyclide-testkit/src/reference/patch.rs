//! Arcs, patches and nets of Dupin cyclides: the constructs of `docs/math/reference-cases.md#patches-and-nets`, up to
//! volumes.

use super::Handler;
use super::arc::{triple, xyz};
use super::case::{Case, Fault};
use super::check::Check;
use cyclide::{
    Error, Point3, Quat, Vec3,
    conformal::{Conformal, Mobius},
    curve::Arc,
    error::PatchError,
    surface::{CyclidePatch, CyclidicNet, ImplicitForm, NetFrame, ParamSurface, QuadGrid},
};
use serde_json::Value;

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "qb-arc" => arc,
        "qb-arc-three-points" => arc_three_points,
        "cyclide-patch" => patch,
        "cyclide-offset" => offset,
        "cyclide-locate" => locate,
        "cyclide-implicit" => implicit,
        "cyclide-moebius" => moebius,
        "circular-net-frames" => net_frames,
        _ => return None,
    })
}

/// What the cases call the refusals of arcs (`docs/math/reference-cases.md#patches-and-nets`): the constructor of an
/// arc from a tangent has names which say what is wrong with the tangent. Numbers that are not finite have another name in the cases of motions.
pub(super) fn reason(construct: &str, error: &Error) -> &'static str {
    match error.reason() {
        "tangent-opposes-chord" | "pole-on-segment" if construct == "qb-arc" => "arc-through-infinity",
        "not-in-im-h" if construct == "qb-arc" => "not-in-space",
        "not-finite" if construct.starts_with("motion-") => "non-finite",
        other => other,
    }
}

/// The comparison rule of `docs/math/reference-cases.md#patches-and-nets`: `rtol` times the largest entry of the
/// expected field.
fn relative(case: &Case, check: &Check, field: &str, parameters: usize) -> f64 {
    case.rtol() * check.largest_expected(field, parameters)
}

/// Parameters: absolute.
fn absolute(case: &Case) -> impl Fn(&[f64]) -> f64 {
    let rtol = case.rtol();
    move |_| rtol
}

/// Rows that start with the parameters s, t.
fn surface_rows(case: &Case, check: &mut Check, field: &str, at: impl Fn(f64, f64) -> Vec<f64>) {
    let allowed = relative(case, check, field, 2);
    check.surface_samples(field, at, &move |_| allowed);
}

/// A field of numbers, rows or nested rows.
fn table(case: &Case, check: &mut Check, field: &str, got: &[Vec<f64>]) {
    let allowed = relative(case, check, field, 0);
    check.table(field, got, &move |_| allowed);
}

fn arc_fields(arc: &Arc, case: &Case, check: &mut Check) {
    let allowed = relative(case, check, "samples", 1);
    check.samples("samples", |t| xyz(arc.point(t)), &move |_| allowed);
    let rows = arc.bezier_rows();
    table(case, check, "weights", &[rows.iter().map(|r| r[3]).collect()]);
    let middle = rows[1];
    table(case, check, "control_point", &[middle[..3].iter().map(|x| x / middle[3]).collect()]);
    if check.number_expected("radius").is_none() {
        return check.exact("radius", if arc.radius().is_none() { "infinite" } else { "finite" });
    }
    table(case, check, "radius", &[arc.radius().into_iter().collect()]);
    table(case, check, "center", &[arc.center().map(xyz).unwrap_or_default()]);
    table(case, check, "axis", &[arc.normal().map(|n| triple(n).to_vec()).unwrap_or_default()]);
    table(case, check, "half_angle", &[vec![0.5 * arc.angle()]]);
}

fn arc(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let (a0, a1) = (case.point("a0")?, case.point("a1")?);
    // c'(0) = L rho T0.
    let derivative = case.vector("v")? * (case.number("rho")? * a0.distance(a1));
    arc_fields(&Arc::from_start_tangent(a0, a1, derivative)?, case, check);
    Ok(())
}

fn arc_three_points(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let arc = Arc::from_three_points(case.point("a0")?, case.point("p")?, case.point("a1")?)?;
    arc_fields(&arc, case, check);
    Ok(())
}

/// Lengths of a frame's vectors that differ from 1 by more are refused.
const UNIT_LIMIT: f64 = 1e-9;

/// The patch of the fields a0, a1, a2, a3, v1, v2.
fn input_patch(case: &Case) -> Result<CyclidePatch, Fault> {
    let corners = [case.point("a0")?, case.point("a1")?, case.point("a2")?, case.point("a3")?];
    let frame = [case.vector("v1")?, case.vector("v2")?];
    // The construct asks for unit vectors; the kernel takes any length.
    let measured = frame.map(|v| (v.length() - 1.0).abs()).into_iter().fold(0.0, f64::max);
    if measured > UNIT_LIMIT {
        return Err(Error::Patch(PatchError::FrameNotOrthonormal { measured, limit: UNIT_LIMIT }).into());
    }
    Ok(CyclidePatch::from_corners_and_frame(corners, frame[0], frame[1])?)
}

fn samples(patch: &CyclidePatch, case: &Case, check: &mut Check) {
    surface_rows(case, check, "samples", |s, t| xyz(patch.point(s, t)));
}

fn patch(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let patch = input_patch(case)?;
    samples(&patch, case, check);
    surface_rows(case, check, "normals", |s, t| triple(patch.unit_normal(s, t)).to_vec());
    surface_rows(case, check, "curvatures", |s, t| vec![patch.k1(t), patch.k2(s)]);
    table(case, check, "q1", &[patch.q1().to_vec()]);
    table(case, check, "q2", &[patch.q2().to_vec()]);
    check.points("singular_s", patch.singular_s().into_iter().map(|s| [s]), &absolute(case));
    check.points("singular_t", patch.singular_t().into_iter().map(|t| [t]), &absolute(case));
    let surface = patch.to_rational();
    let rows = surface.rows();
    table(case, check, "bezier_h", &rows.iter().map(|r| r.to_vec()).collect::<Vec<_>>());
    let points: Vec<Vec<f64>> = rows.iter().map(|[x, y, z, w]| vec![x / w, y / w, z / w]).collect();
    table(case, check, "bezier_points", &points);
    table(case, check, "bezier_weights", &patch.real_weights().map(|row| row.to_vec()));
    Ok(())
}

fn offset(case: &Case, check: &mut Check) -> Result<(), Fault> {
    samples(&input_patch(case)?.offset(case.number("h")?)?, case, check);
    Ok(())
}

fn locate(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let patch = input_patch(case)?;
    let places = case.points("points")?.into_iter().map(|p| patch.locate(p));
    check.points("parameters", places.map(|l| [l.s, l.t]), &absolute(case));
    Ok(())
}

fn implicit(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let quartic = match input_patch(case)?.implicit_form() {
        ImplicitForm::Quartic { coefficients, .. } => coefficients.to_vec(),
        ImplicitForm::Sphere(coefficients) => coefficients.to_vec(),
    };
    table(case, check, "quartic", &[quartic]);
    Ok(())
}

fn moebius(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let malformed = || Fault::Malformed("input `matrix` is no matrix of quaternions".into());
    let matrix = case.input("matrix")?;
    let entry = |i: usize, j: usize| -> Result<Quat, Fault> {
        let numbers = super::check::numbers(&matrix[i][j]).ok_or_else(malformed)?;
        <[f64; 4]>::try_from(numbers).map(Quat::from).map_err(|_| malformed())
    };
    let map = Mobius::from_matrix(entry(0, 0)?, entry(0, 1)?, entry(1, 0)?, entry(1, 1)?)?;
    samples(&input_patch(case)?.transformed(&map)?, case, check);
    Ok(())
}

fn net_frames(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let malformed = || Fault::Malformed("input `points` is no grid of points".into());
    let point = |v: &Value| {
        let numbers = super::check::numbers(v).ok_or_else(malformed)?;
        <[f64; 3]>::try_from(numbers).map(Point3::from).map_err(|_| malformed())
    };
    let columns = case.input("points")?.as_array().ok_or_else(malformed)?;
    let grid: Vec<Vec<Point3>> = columns
        .iter()
        .map(|column| column.as_array().ok_or_else(malformed)?.iter().map(point).collect())
        .collect::<Result<_, Fault>>()?;
    let (m, n) = (columns.len(), columns.first().and_then(Value::as_array).map_or(0, Vec::len));
    if grid.iter().any(|column| column.len() != n) {
        return Err(malformed());
    }
    let points = (0..m * n).map(|k| grid[k % m][k / m]).collect();
    let frame = NetFrame::First(case.vector("v1")?, case.vector("v2")?);
    let net = CyclidicNet::new(QuadGrid::new(points, [m, n], [false, false])?, frame)?;
    let frames: Vec<[Vec3; 3]> = (0..m * n).map(|k| net.vertex_frame(k / n, k % n)).collect();
    let rows = |axes: &[usize]| -> Vec<Vec<f64>> {
        frames.iter().flat_map(|f| axes.iter().map(|axis| triple(f[*axis]).to_vec())).collect()
    };
    table(case, check, "frames", &rows(&[0, 1]));
    table(case, check, "normals", &rows(&[2]));
    Ok(())
}
