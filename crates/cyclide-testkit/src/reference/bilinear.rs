//! Bilinear patches of circles, blocks of them, maps by three points: constructs of `docs/math/reference-cases.md#closing-the-papers`.

use super::Handler;
use super::arc::{triple, xyz};
use super::case::{Case, Fault, array, malformed};
use super::check::Check;
use cyclide::{
    Point3, Vec3,
    conformal::{Conformal, Mobius},
    surface::{CornerTwist, ImplicitForm, ParamSurface, QbPatch, QbPatchKind},
    volume::{BlockBranch, ParamVolume, QbBlock},
};

pub(super) fn handler(construct: &str) -> Option<Handler> {
    Some(match construct {
        "qb-patch" => patch,
        "qb-patch-arcs" => arcs,
        "qb-patch-implicit" => implicit,
        "qb-patch-locate" => locate,
        "qb-patch-inversion" => inversion,
        "qb-block" => block,
        "moebius-three-points" => three_points,
        _ => return None,
    })
}

fn corners(case: &Case) -> Result<[Point3; 4], Fault> {
    Ok([case.point("a0")?, case.point("a1")?, case.point("a2")?, case.point("a3")?])
}

fn input_patch(case: &Case) -> Result<QbPatch, Fault> {
    let corner = || -> Result<CornerTwist, Fault> {
        let value = case.input("corner")?;
        Ok(CornerTwist::Corner(array::<3>(value).map(Vec3::from).ok_or_else(|| malformed("corner"))?))
    };
    let twist = match case.number("twist") {
        Ok(twist) => CornerTwist::Twist(twist),
        Err(_) => corner()?,
    };
    let directions = [case.vector("direction_s")?, case.vector("direction_t")?];
    Ok(QbPatch::from_directions(corners(case)?, directions, twist)?)
}

/// Parameters and weights: absolute.
fn absolute(case: &Case) -> impl Fn(&[f64]) -> f64 + use<> {
    let rtol = case.rtol();
    move |_| rtol
}

/// `rtol` times the largest entry of the field, or of the corners where that is larger.
fn relative(case: &Case, check: &Check, field: &str, parameters: usize, size: f64) -> impl Fn(&[f64]) -> f64 + use<> {
    let allowed = case.rtol() * check.largest_expected(field, parameters).max(size);
    move |_| allowed
}

fn largest_coordinate(patch: &QbPatch) -> f64 {
    patch.corners().iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max)
}

fn samples(case: &Case, check: &mut Check, patch: &QbPatch) {
    let allowed = relative(case, check, "samples", 2, largest_coordinate(patch));
    check.surface_samples("samples", |s, t| xyz(patch.point(s, t)), &allowed);
}

fn weights(case: &Case, check: &mut Check, patch: &QbPatch) {
    let rows: Vec<Vec<f64>> = patch.weights().iter().map(|w| w.to_array().to_vec()).collect();
    check.table("weights", &rows, &absolute(case));
}

fn patch(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let patch = input_patch(case)?;
    weights(case, check, &patch);
    samples(case, check, &patch);
    let none = vec![f64::NAN; 3];
    let normal = |s, t| patch.normal(s, t).map_or(none.clone(), |n| triple(n).to_vec());
    check.surface_samples("normals", normal, &absolute(case));
    let allowed = relative(case, check, "curvatures", 2, largest_coordinate(&patch));
    let curvatures =
        |s, t| patch.jet(s, t).principal_curvatures().map_or(vec![f64::NAN; 2], |[a, b]| vec![a * b, 0.5 * (a + b)]);
    check.surface_samples("curvatures", curvatures, &allowed);
    let rows: Vec<Vec<f64>> = patch.to_rational().rows().iter().map(|row| row.to_vec()).collect();
    let allowed = relative(case, check, "bezier_h", 0, largest_coordinate(&patch));
    check.table("bezier_h", &rows, &allowed);
    check.exact("principal", patch.recognize() == QbPatchKind::Dupin);
    Ok(())
}

fn arcs(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let tangents = [case.vector("t01")?, case.vector("t02")?, case.vector("t13")?, case.vector("t23")?];
    let made = QbPatch::from_arcs(corners(case)?, tangents);
    if let Err(cyclide::Error::Patch(error)) = &made {
        use cyclide::error::PatchError::{ArcsDoNotClose, ArcsNeedComplement};
        if let ArcsDoNotClose { holonomy, .. } | ArcsNeedComplement { holonomy } = error {
            check.number("holonomy", Some(*holonomy), &absolute(case));
        }
    }
    let patch = made?;
    weights(case, check, &patch);
    samples(case, check, &patch);
    Ok(())
}

fn implicit(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let coefficients = match input_patch(case)?.implicit_form() {
        Some(ImplicitForm::Quartic { coefficients, .. }) => coefficients.to_vec(),
        Some(ImplicitForm::Sphere(coefficients)) => coefficients.to_vec(),
        None => Vec::new(),
    };
    check.table("quartic", &[coefficients], &absolute(case));
    Ok(())
}

fn locate(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let patch = input_patch(case)?;
    let places = case.points("points")?.into_iter().map(|p| patch.locate(p));
    check.points("parameters", places.map(|place| [place.s, place.t]), &absolute(case));
    Ok(())
}

fn inversion(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let map = Mobius::inversion(case.point("inversion_centre")?, case.number("inversion_radius")?)?;
    let image = input_patch(case)?.transformed(&map)?;
    samples(case, check, &image);
    let allowed = relative(case, check, "corner_images", 0, 0.0);
    check.points("corner_images", image.corners().map(|p| p.to_array()), &allowed);
    Ok(())
}

fn block(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let mut corners = [Point3::ORIGIN; 7];
    for (corner, name) in corners.iter_mut().zip(["a0", "a1", "a2", "a12", "a3", "a13", "a23"]) {
        *corner = case.point(name)?;
    }
    let directions = [case.vector("v1")?, case.vector("v2")?, case.vector("v3")?];
    let twists = [case.number("twist12")?, case.number("twist13")?, case.number("twist23")?].map(CornerTwist::Twist);
    let size = corners.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    for (branch, name) in [(BlockBranch::Miquel, "miquel"), (BlockBranch::Other, "other")] {
        let block = QbBlock::new(corners, directions, twists, branch);
        let Some(want) = check.want_raw(name) else {
            block?;
            continue;
        };
        check.nested(name, "", want, |check| {
            let block = match block {
                Ok(block) => block,
                Err(error) => return check.fail("error", error.to_string()),
            };
            let allowed = relative(case, check, "a123", 0, size);
            check.vector("a123", Some(&xyz(block.corners()[7])), &allowed);
            let allowed = relative(case, check, "samples", 3, size);
            let at = |row: &[f64]| Some(xyz(block.point([row[0], row[1], row[2]])));
            check.rows("samples", 3, at, &allowed);
        });
    }
    Ok(())
}

fn three_points(case: &Case, check: &mut Check) -> Result<(), Fault> {
    let triple = |name: &str| -> Result<[Point3; 3], Fault> {
        <[Point3; 3]>::try_from(case.points(name)?).map_err(|_| malformed(name))
    };
    let (from, to) = (triple("from")?, triple("to")?);
    let normals = ["up_from", "up_to"].map(|name| case.vector(name).ok());
    let map = Mobius::from_three_points(from, to, case.number("turn").unwrap_or(0.0), normals)?;
    let images = case.points("points")?.into_iter().map(|p| map.map_point(p).map_or([f64::NAN; 3], Point3::to_array));
    let size = to.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
    let allowed = relative(case, check, "images", 0, size);
    check.points("images", images, &allowed);
    Ok(())
}
