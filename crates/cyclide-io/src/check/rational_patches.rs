//! Rational patches of a file against the faces that they stand for.

use crate::check::bodies::FilePatch;
use crate::check::deviation::larger;
use crate::check::read_error::ReadError;
use crate::check::tiles::tile_faces;
use crate::export::face_plan::ShellPlan;
use crate::export::parts::BodyOf;
use cyclide::{
    surface::ParamSurface as _,
    topology::{FacePart, Shell},
};

/// Places per parameter at which surfaces are compared.
const PLACES: u32 = 9;

/// The largest distance at equal parameters between the patches read and the parts of each body's faces that they stand for,
/// all of which they have to be.
///
/// # Errors
/// [`ReadError::BodyCount`], [`ReadError::PatchCount`], [`ReadError::Patch`], [`ReadError::Body`].
pub(crate) fn patches_deviation(
    bodies: &[&BodyOf<'_>],
    plans: &[Vec<ShellPlan>],
    read: &[FilePatch],
) -> Result<Vec<f64>, ReadError> {
    let count = read.iter().map(|patch| patch.body + 1).max().unwrap_or(0);
    if count != bodies.len() {
        return Err(ReadError::BodyCount { found: count, expected: bodies.len() });
    }
    let mut expected: Vec<(usize, usize, FacePart)> = Vec::new();
    for index in 0..bodies.len() {
        let of_body = plans.get(index).into_iter().flatten();
        expected.extend(of_body.flat_map(|plan| plan.parts().map(move |part| (index, plan.shell, *part))));
    }
    if expected.len() != read.len() {
        return Err(ReadError::PatchCount { found: read.len(), expected: expected.len() });
    }
    let mut deviations = vec![0.0; bodies.len()];
    for (number, (&(body, shell, part), found)) in expected.iter().zip(read).enumerate() {
        let wrong = |detail| ReadError::Patch { patch: number, detail };
        let own = bodies[body].body.shells().nth(shell).and_then(|shell| shell.faces().get(part.face));
        let face = own.ok_or_else(|| wrong("the face does not exist"))?;
        if (found.body, found.shell) != (body, shell) {
            return Err(wrong("it belongs to another body or shell"));
        }
        if found.outward != face.same_sense {
            return Err(wrong("its outer side is reversed"));
        }
        for k in 0..PLACES * PLACES {
            let at = |i: u32| f64::from(i) / f64::from(PLACES - 1);
            let (x, y) = (at(k % PLACES), at(k / PLACES));
            let (s, t) = part.place(x, y);
            deviations[body] = larger(deviations[body], found.surface.point(x, y).distance(face.surface.point(s, t)));
        }
    }
    for (index, body) in bodies.iter().enumerate() {
        check_complete(index, body, plans.get(index).map_or(&[], Vec::as_slice))?;
    }
    Ok(deviations)
}

/// Every face of the body is there, each part of it once.
fn check_complete(index: usize, body: &BodyOf<'_>, plans: &[ShellPlan]) -> Result<(), ReadError> {
    let is_tiled = |(number, shell): (usize, &Shell)| {
        tile_faces(shell, plans.iter().filter(|plan| plan.shell == number).flat_map(ShellPlan::parts))
    };
    match body.body.shells().enumerate().all(is_tiled) {
        true => Ok(()),
        false => Err(ReadError::Body { body: index, detail: "its patches do not cover each part of its faces once" }),
    }
}
