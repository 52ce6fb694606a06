//! The distance between the bodies of a STEP file and those of the model, face by face, and their structure.
//!
//! A model's faces are cut until they are as the format wants them. The check knows nothing of how: it has the file, the
//! uncut model and, from the writer, which parts of which faces each face of the file is, and which sides of these its edges are ([`ShellPlan`]). These parts have
//! to tile the faces; each face of the file is measured against the uncut faces over its parts (`distance`), of which all sides that are no
//! edges have to meet each other inside it (`face`), and two faces have to share an edge exactly where their parts share borders (`border`). Readers repair wrong orientations and unshared edges
//! silently, so that both are checked here: each face looks to the model's outer side, loops run head to tail and
//! counter-clockwise against it, and solids have positive volume.

mod border;
mod distance;
mod face;
#[cfg(test)]
mod tests;

use crate::check::bodies::{FileBody, FileCurve, FileFace, FileShell};
use crate::check::deviation::larger;
use crate::check::made::Made;
use crate::check::read_error::ReadError;
use crate::check::tiles::tile_faces;
use crate::export::face_plan::ShellPlan;
use crate::export::parts::BodyOf;
use border::{Border, Line};
use cyclide::topology::{Body, Shell};
use face::FaceCheck;
use std::collections::HashMap;

/// The largest distance between surfaces, edges and vertices of each body of the file and of the model.
///
/// # Errors
/// [`ReadError::BodyCount`], [`ReadError::Body`].
pub(super) fn bodies_deviation(made: &Made<'_>, read: &[FileBody]) -> Result<Vec<f64>, ReadError> {
    let (expected, plans) = (&made.ready.bodies, &made.file.written.shells);
    if expected.len() != read.len() {
        return Err(ReadError::BodyCount { found: read.len(), expected: expected.len() });
    }
    let size = made.ready.bounds.diagonal();
    let one = |(index, (body, file)): (usize, (&BodyOf<'_>, &FileBody))| {
        let named = |Mismatch(detail)| ReadError::Body { body: index, detail };
        let faces = body.body.faces().ok_or(Mismatch("it has no faces")).map_err(named)?;
        let plans = plans.get(index).map_or(&[][..], Vec::as_slice);
        body_deviation(faces, plans, file, size).map_err(named)
    };
    expected.iter().zip(read).enumerate().map(one).collect()
}

/// Why a body is not the model's.
#[derive(Debug, PartialEq)]
struct Mismatch(&'static str);

fn require(holds: bool, detail: &'static str) -> Result<(), Mismatch> {
    if holds { Ok(()) } else { Err(Mismatch(detail)) }
}

fn body_deviation(body: &Body, plans: &[ShellPlan], file: &FileBody, size: f64) -> Result<f64, Mismatch> {
    let shells: Vec<&Shell> = body.shells().collect();
    require(file.shells.len() == plans.len(), "a different number of shells")?;
    require(plans.is_sorted_by_key(|plan| plan.shell), "its shells are in a different order")?;
    for (index, shell) in shells.iter().enumerate() {
        let parts = plans.iter().filter(|plan| plan.shell == index).flat_map(ShellPlan::parts);
        require(tile_faces(shell, parts), "its faces do not cover each face of the model once")?;
    }
    // Every shell has one at least.
    let solid = body.is_solid() && plans.len() == shells.len();
    require(file.solid == solid, "it is a solid only in the file or only in the model")?;
    let mut largest = 0.0_f64;
    for (plan, file) in plans.iter().zip(&file.shells) {
        let shell = shells.get(plan.shell).ok_or(Mismatch("there is no such shell"))?;
        let void = solid && plan.shell > 0;
        require(file.forward != void, "a shell has the wrong orientation")?;
        require(file.closed == shell.is_closed(), "a shell is closed only in the file or only in the model")?;
        largest = larger(largest, shell_deviation(shell, plan, void, file, size)?);
        // A hollow's faces look into it: away from the solid.
        require(!solid || (shell.volume() > 0.0) != void, "a solid is inside out")?;
    }
    Ok(largest)
}

/// An edge of the file: the borders that it is, in its own direction, and the faces that use it, with the directions in which they do.
struct Shared {
    borders: Vec<Border>,
    uses: Vec<(usize, bool)>,
}

/// Faces of one shell of the file; `flip` where it has the other sides.
fn shell_deviation(shell: &Shell, plan: &ShellPlan, flip: bool, file: &FileShell, size: f64) -> Result<f64, Mismatch> {
    require(file.faces.len() == plan.faces.len(), "a different number of faces")?;
    let mut largest = 0.0_f64;
    let mut edges: HashMap<u64, Shared> = HashMap::new();
    for (index, (plan, file)) in plan.faces.iter().zip(&file.faces).enumerate() {
        let face = FaceCheck::new(shell, plan, flip, size)?;
        largest = larger(largest, face.surface_deviation(file)?);
        largest = larger(largest, face.sides_deviation()?);
        require(file.loops().count() == plan.loops.len(), "a face has a different number of loops")?;
        for (own, plan) in file.loops().zip(&plan.loops) {
            require(own.len() == plan.len(), "a face has a different number of edges")?;
            for (i, (edge, sides)) in own.iter().zip(plan).enumerate() {
                let next = &own[(i + 1) % own.len()];
                require(edge.oriented()[1] == next.oriented()[0], "the edges of a loop are not consecutive")?;
                let (mut borders, off) = face.edge_deviation(file, edge, sides)?;
                largest = larger(largest, off);
                let shared =
                    edges.entry(edge.edge).or_insert_with(|| Shared { borders: borders.clone(), uses: Vec::new() });
                if matches!(edge.curve, FileCurve::Circle(_)) {
                    // The vertex of a whole circle may be inside a side, from which either face may begin.
                    let first = borders.iter().position(|own| shared.borders.first().is_some_and(|b| b.is_same(own)));
                    borders.rotate_left(first.unwrap_or(0));
                }
                let is_same = shared.borders.len() == borders.len()
                    && shared.borders.iter().zip(&borders).all(|(a, b)| a.is_same(b));
                require(is_same, "faces share an edge only in the file")?;
                shared.uses.push((index, edge.forward));
            }
        }
    }
    check_uses(shell, &edges)?;
    require(hang_together(&file.faces, &edges), "the faces of a shell are not connected")?;
    Ok(largest)
}

/// Each edge is used by as many faces as meet there in the model, and once in each direction by two.
fn check_uses(shell: &Shell, edges: &HashMap<u64, Shared>) -> Result<(), Mismatch> {
    let of_model = shell.edge_uses();
    for Shared { borders, uses } in edges.values() {
        let expected = |border: &Border| match border.line {
            Line::Edge(edge) => of_model.get(edge).copied().unwrap_or(0),
            Line::Inside { .. } => 2,
        };
        // A seam across faces has no border, and its face on both sides.
        let first = borders.first().map_or(2, expected);
        require(borders.iter().all(|border| expected(border) == first), "only a part of an edge is a border")?;
        let expected = first;
        require(uses.len() >= expected, "faces share an edge only in the model")?;
        let paired = matches!(uses[..], [(_, a), (_, b)] if a != b);
        require(uses.len() == expected && (paired || expected == 1), "an edge is not used once in each direction")?;
    }
    Ok(())
}

/// True if all faces can be reached from the first one over common edges.
fn hang_together(faces: &[FileFace], edges: &HashMap<u64, Shared>) -> bool {
    let mut is_reached = vec![false; faces.len()];
    let mut reached = vec![0];
    let mut next = 0;
    while let Some(face) = reached.get(next).and_then(|&index| faces.get(index)) {
        next += 1;
        let shared = face.loops().flatten().filter_map(|edge| edges.get(&edge.edge));
        let others = shared.flat_map(|shared| &shared.uses).map(|&(other, _)| other);
        reached.extend(others.filter(|&other| !std::mem::replace(&mut is_reached[other], true)));
    }
    is_reached.iter().all(|&is_reached| is_reached)
}
