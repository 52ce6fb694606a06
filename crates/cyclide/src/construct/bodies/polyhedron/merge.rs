//! Faces in one plane made one: of a triangulated mesh, the sides of the polyhedron.

use super::faces::{FaceSide, Faces};
use super::plane::{Plane, area_vector};
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, Result};

/// The loops of faces that are in one plane each within a distance, and without vertices at which only two faces meet. What
/// needs no change stays as it is, in its order.
///
/// # Errors
/// `flat-polyhedron` (all in one plane), `not-convex`, `not-a-shell` (faces in one plane round a hole).
pub(super) fn merged(points: &[Point3], faces: &Faces, within: f64) -> Result<Vec<Vec<usize>>> {
    let group = groups(points, faces, within);
    let count = group.iter().map(|g| g + 1).max().unwrap_or(0);
    if count < 4 {
        return Err(Error::FlatPolyhedron { thickness: within, limit: within });
    }
    let outline = outlines(points, faces, &group, count)?;
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

/// The number of the plane of each face, counted in the order of their first faces.
fn groups(points: &[Point3], faces: &Faces, within: f64) -> Vec<usize> {
    let loops = faces.loops();
    let areas: Vec<Vec3> = loops.iter().map(|corners| area_vector(points, corners)).collect();
    let mut largest_first: Vec<usize> = (0..loops.len()).collect();
    largest_first.sort_by(|&a, &b| areas[b].length_squared().total_cmp(&areas[a].length_squared()).then(a.cmp(&b)));
    let mut group: Vec<Option<usize>> = vec![None; loops.len()];
    for seed in largest_first {
        if group[seed].is_some() {
            continue;
        }
        // The plane of one triangle is known less well than that of all that are found with it.
        let found = Plane::of_loop(points, &loops[seed]).map_or(vec![seed], |plane| {
            let first = flood(points, faces, &areas, &group, seed, &plane, within);
            if first.len() == 1 {
                return first;
            }
            let all = first.iter().flat_map(|&f| loops[f].iter().map(|&v| points[v]));
            let normal = first.iter().fold(Vec3::ZERO, |sum, &f| sum + areas[f]);
            let better = Plane::through_middle(all, normal);
            better.map_or(first, |plane| flood(points, faces, &areas, &group, seed, &plane, within))
        });
        for face in found {
            group[face] = Some(seed);
        }
    }
    in_order(&group)
}

/// The faces that hang together with one and are in a plane, of those that are in none yet.
fn flood(
    points: &[Point3],
    faces: &Faces,
    areas: &[Vec3],
    group: &[Option<usize>],
    seed: usize,
    plane: &Plane,
    within: f64,
) -> Vec<usize> {
    let loops = faces.loops();
    let belongs = |face: usize| {
        let near = loops[face].iter().all(|&v| plane.distance(points[v]).abs() <= within);
        // A needle whose height is rounding has no normal of its own.
        near && (areas[face].dot(plane.normal) > 0.0 || is_needle(points, &loops[face], areas[face], within))
    };
    let mut found = vec![seed];
    let mut seen: std::collections::HashSet<usize> = [seed].into();
    let mut next = 0;
    while let Some(&face) = found.get(next) {
        next += 1;
        for side in 0..loops[face].len() {
            let beside = faces.across(FaceSide { face, side }).face;
            if group[beside].is_none() && belongs(beside) && seen.insert(beside) {
                found.push(beside);
            }
        }
    }
    found
}

/// True for a face that is no higher than a distance above its longest side.
fn is_needle(points: &[Point3], corners: &[usize], area: Vec3, within: f64) -> bool {
    let sides = (0..corners.len()).map(|k| points[corners[k]].distance(points[corners[(k + 1) % corners.len()]]));
    let longest = sides.fold(0.0, f64::max);
    area.length() <= within * longest
}

/// Numbers from 0 in the order of the first faces.
fn in_order(group: &[Option<usize>]) -> Vec<usize> {
    let mut number: Vec<Option<usize>> = vec![None; group.len()];
    let mut next = 0;
    let numbered = group.iter().enumerate().map(|(face, seed)| {
        *number[seed.unwrap_or(face)].get_or_insert_with(|| {
            next += 1;
            next - 1
        })
    });
    numbered.collect()
}

/// The outline of each group.
fn outlines(points: &[Point3], faces: &Faces, group: &[usize], count: usize) -> Result<Vec<Vec<usize>>> {
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
        let Some(&first) = sides.first() else {
            return Err(Error::FlatPolyhedron { thickness: 0.0, limit: 0.0 });
        };
        let start = faces.ends(first)[0];
        let mut outline = vec![start];
        while let Some(next) = leaving[outline[outline.len() - 1]].filter(|&next| next != start) {
            if outline.len() == sides.len() {
                break;
            }
            outline.push(next);
        }
        if pinched || outline.len() != sides.len() {
            let detail = "the faces in its plane have a hole, or touch in a point: the surface is not convex";
            return Err(super::convex::reflex_edge(points, faces, group).unwrap_or(Error::NotAShell {
                item: ErrorItem::Face,
                index: first.face,
                detail,
            }));
        }
        for &at in sides {
            leaving[faces.ends(at)[0]] = None;
        }
        outlines.push(outline);
    }
    Ok(outlines)
}
