//! Faces in one plane made one: of a triangulated mesh, the sides of the polyhedron.

use super::faces::{FaceSide, Faces};
use super::plane::{self, area_vector};
use crate::base::vector::Point3;
use crate::error::{Error, ErrorItem, Result, ShellError};

/// The loops of faces that are in one plane each, by the number of it, and without vertices at which only two faces meet. What
/// needs no change stays as it is, in its order.
///
/// # Errors
/// `flat-polyhedron` (all in one plane), `not-convex`, `not-a-shell` (faces in one plane round a hole).
pub(super) fn merged(points: &[Point3], faces: &Faces, group: &[usize], within: f64) -> Result<Vec<Vec<usize>>> {
    let count = group.iter().map(|g| g + 1).max().unwrap_or(0);
    let outline = if count < 4 { None } else { outlines(points, faces, group, count)? };
    let outline = outline.ok_or_else(|| flat_within(points, faces, within))?;
    // Vertices inside a face are on no outline, those of two faces are on a straight edge of both.
    let fans = faces.fans(points.len())?;
    let is_corner = |vertex: usize| {
        let mut around: Vec<usize> = fans[vertex].iter().map(|at| group[at.face]).collect();
        around.sort_unstable();
        around.dedup();
        around.len() > 2
    };
    Ok(outline.into_iter().map(|corners| corners.into_iter().filter(|&v| is_corner(v)).collect()).collect())
}

/// What is to be said where hardly any planes are left, measured across the largest face.
fn flat_within(points: &[Point3], faces: &Faces, within: f64) -> Error {
    let areas = faces.loops().iter().map(|corners| area_vector(points, corners));
    let largest = areas.max_by(|a, b| a.length_squared().total_cmp(&b.length_squared())).unwrap_or_default();
    plane::flat(faces.loops().iter().flatten().map(|&v| points[v]), largest, within)
}

/// The outline of each group; none if one has no border.
fn outlines(points: &[Point3], faces: &Faces, group: &[usize], count: usize) -> Result<Option<Vec<Vec<usize>>>> {
    let mut border: Vec<Vec<FaceSide>> = vec![Vec::new(); count];
    for at in faces.sides() {
        if group[faces.across(at).face] != group[at.face] {
            border[group[at.face]].push(at);
        }
    }
    // Outlines are walked vertex by vertex; the marks are cleared for the next one.
    let mut leaving: Vec<Option<usize>> = vec![None; points.len()];
    let mut outlines = Vec::with_capacity(count);
    for sides in &border {
        let mut pinched = false;
        for &at in sides {
            let [from, to] = faces.ends(at);
            pinched |= leaving[from].replace(to).is_some();
        }
        let Some(&first) = sides.first() else { return Ok(None) };
        let start = faces.ends(first)[0];
        let mut outline = vec![start];
        while let Some(next) = leaving[outline[outline.len() - 1]].filter(|&next| next != start) {
            if outline.len() == sides.len() {
                break;
            }
            outline.push(next);
        }
        if pinched || outline.len() != sides.len() {
            let detail = "the faces in its plane have a hole, or touch at a point: the surface is not convex";
            return Err(super::convex::reflex_edge(points, faces, group)
                .unwrap_or(Error::Shell(ShellError::NotAShell { item: ErrorItem::Face, index: first.face, detail })));
        }
        for &at in sides {
            leaving[faces.ends(at)[0]] = None;
        }
        outlines.push(outline);
    }
    Ok(Some(outlines))
}
