//! The distance between the bodies of a STEP file and those of the model, face by face, and their structure.
//!
//! A model's faces are cut until they are as the format wants them. The check knows nothing of how: it has the file, the
//! uncut model and, from the writer, which part of which face each face of the file is ([`ShellPlan`]). These parts have
//! to tile the faces; each face of the file is measured against the uncut face over its part (`distance`), and two of them
//! have to share an edge exactly where their parts share a border (`border`). Readers repair wrong orientations and unshared edges
//! silently, so that both are checked here: each face looks to the model's outer side, loops run head to tail and
//! counter-clockwise against it, and solids have positive volume.

mod border;
mod distance;
#[cfg(test)]
mod tests;

use crate::check::bodies::{FileBody, FileFace, FileShell, FileSurface};
use crate::check::deviation::larger;
use crate::check::file_content::ReadError;
use crate::check::made::Made;
use crate::check::tiles::tile_faces;
use crate::export::face_plan::ShellPlan;
use crate::export::parts::BodyOf;
use border::{Border, Line, sides_with_edges};
use cyclide::{Body, Shell};
use distance::{Piece, check_on_analytic, check_parameters};
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
    require(file.shells.len() == plans.len(), "another number of shells")?;
    require(plans.is_sorted_by_key(|plan| plan.shell), "its shells have another order")?;
    for (index, shell) in shells.iter().enumerate() {
        let parts = plans.iter().filter(|plan| plan.shell == index).flat_map(|plan| &plan.faces);
        require(tile_faces(shell, parts), "its faces are not those of the model, each part once")?;
    }
    // Every shell has one at least.
    let solid = body.is_solid() && plans.len() == shells.len();
    require(file.solid == solid, "it is a solid in one of file and model only")?;
    let mut largest = 0.0_f64;
    for (plan, file) in plans.iter().zip(&file.shells) {
        let shell = shells.get(plan.shell).ok_or(Mismatch("there is no such shell"))?;
        let void = solid && plan.shell > 0;
        require(file.forward != void, "a shell is used from the wrong side")?;
        require(file.closed == shell.is_closed(), "a shell is closed in one of file and model only")?;
        largest = larger(largest, shell_deviation(shell, plan, void, file, size)?);
        // A hollow's faces look into it: away from the solid.
        require(!solid || (shell.volume() > 0.0) != void, "a solid is inside out")?;
    }
    Ok(largest)
}

/// An edge of the file: the border that it is and the faces that use it, with the directions in which they do.
struct Shared {
    border: Border,
    uses: Vec<(usize, bool)>,
}

/// Faces of one shell of the file; `flip` where it has the other sides.
fn shell_deviation(shell: &Shell, plan: &ShellPlan, flip: bool, file: &FileShell, size: f64) -> Result<f64, Mismatch> {
    require(file.faces.len() == plan.faces.len(), "another number of faces")?;
    let mut largest = 0.0_f64;
    let mut edges: HashMap<u64, Shared> = HashMap::new();
    for (index, (part, file)) in plan.faces.iter().zip(&file.faces).enumerate() {
        let face = shell.faces().get(part.face).ok_or(Mismatch("there is no such face"))?;
        let outer_side = face.same_sense != flip;
        let piece = Piece { surface: &face.surface, part };
        largest = larger(largest, piece.surface_deviation(file, outer_side)?);
        let found = sides_with_edges(shell, &piece, (file.edges.len(), outer_side), size);
        let (sides, width) = found.ok_or(Mismatch("another number of edges round a face"))?;
        largest = larger(largest, width);
        for (i, ((side, border), edge)) in sides.into_iter().zip(&file.edges).enumerate() {
            let next = &file.edges[(i + 1) % file.edges.len()];
            require(edge.oriented()[1] == next.oriented()[0], "a loop does not run head to tail")?;
            let forward = border.runs_forward(side, outer_side);
            require(edge.forward == forward, "an edge runs the wrong way round a face")?;
            let shared = edges.entry(edge.edge).or_insert(Shared { border, uses: Vec::new() });
            require(shared.border.is_same(&border), "faces share an edge in the file only")?;
            shared.uses.push((index, forward));
            largest = larger(largest, piece.edge_deviation(side, border, edge));
            match &file.surface {
                FileSurface::Rational(surface) => check_parameters(surface, (side, border), edge, size)?,
                FileSurface::Analytic(kind) => check_on_analytic(kind, edge, size)?,
            }
        }
    }
    check_uses(shell, &edges)?;
    require(hang_together(&file.faces, &edges), "the faces of a shell do not hang together")?;
    Ok(largest)
}

/// Each edge is used by as many faces as meet there in the model, and once in each direction by two.
fn check_uses(shell: &Shell, edges: &HashMap<u64, Shared>) -> Result<(), Mismatch> {
    let of_model = shell.edge_uses();
    for Shared { border, uses } in edges.values() {
        let expected = match border.line {
            Line::Edge(edge) => of_model.get(edge).copied().unwrap_or(0),
            Line::Inside { .. } => 2,
        };
        require(uses.len() >= expected, "faces share an edge in the model only")?;
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
        let shared = face.edges.iter().filter_map(|edge| edges.get(&edge.edge));
        let others = shared.flat_map(|shared| &shared.uses).map(|&(other, _)| other);
        reached.extend(others.filter(|&other| !std::mem::replace(&mut is_reached[other], true)));
    }
    is_reached.iter().all(|&is_reached| is_reached)
}
