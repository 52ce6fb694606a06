//! The distance between the polygons of a file and the cells of the patches that they stand for, both ways.
//!
//! Every polygon is held against its own cell, not against the nearest part of the surface: swapped, missing and
//! doubled polygons are found out. From the cell 5 × 5 points are taken to the polygon, from the polygon its corners,
//! the middles of its sides and its centre to the cell; the middle of a cell, where the distance is largest, is among
//! them.

use super::triangle::to_triangle;
use crate::job::BodyOf;
use crate::read_back::ReadError;
use cyclide::{CyclidePatch, MeshSource, ParamSurface as _, Point3, SurfaceMesh};

/// Points of a cell in each direction.
const GRID: usize = 5;
/// Steps to the foot of a point on a patch.
const STEPS: usize = 3;
/// The cells of a face cover its parameters up to the rounding of their sum.
const COVER: f64 = 1e-9;

/// A cell of a patch and the number of polygons that the file has for it, one after the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    /// Index of the body in the model.
    pub(crate) body: usize,
    pub(crate) source: MeshSource,
    pub(crate) polygons: usize,
}

/// The largest distance between meshes read and the bodies, both ways.
///
/// # Errors
/// [`ReadError::PolygonCount`], [`ReadError::NotCovered`].
pub(crate) fn mesh_deviation(bodies: &[BodyOf<'_>], meshes: &[SurfaceMesh], cells: &[Cell]) -> Result<f64, ReadError> {
    check_cover(bodies, cells)?;
    let expected = cells.iter().map(|cell| cell.polygons).sum();
    let found = meshes.iter().map(|mesh| mesh.faces.len()).sum();
    if found != expected {
        return Err(ReadError::PolygonCount { found, expected });
    }
    let mut polygons = meshes.iter().flat_map(|mesh| mesh.faces.iter().map(move |face| (mesh, face)));
    let mut triangles: Vec<[Point3; 3]> = Vec::new();
    let mut largest = 0.0_f64;
    for cell in cells {
        triangles.clear();
        for (mesh, face) in polygons.by_ref().take(cell.polygons) {
            let at = |i: usize| mesh.positions[face.corners()[i].position];
            triangles.extend(crate::mesh::triangles(face).iter().map(|t| t.map(at)));
        }
        // A cell that rounding has left nothing of has none.
        if let Some(patch) = patch(bodies, cell).filter(|_| !triangles.is_empty()) {
            largest = largest.max(cell_deviation(patch, &cell.source, &triangles));
        }
    }
    Ok(largest)
}

fn patch<'a>(bodies: &'a [BodyOf<'_>], cell: &Cell) -> Option<&'a CyclidePatch> {
    let shell = bodies.get(cell.body)?.body.shells().nth(cell.source.shell)?;
    Some(&shell.faces().get(cell.source.face)?.patch)
}

/// Every face of every body is covered by its cells once.
fn check_cover(bodies: &[BodyOf<'_>], cells: &[Cell]) -> Result<(), ReadError> {
    for (index, body) in bodies.iter().enumerate() {
        let mut covered: Vec<Vec<f64>> = body.body.shells().map(|shell| vec![0.0; shell.faces().len()]).collect();
        for Cell { source, .. } in cells.iter().filter(|cell| cell.body == index) {
            let [s, t] = [source.s, source.t].map(|[from, to]| to - from);
            if let Some(sum) = covered.get_mut(source.shell).and_then(|shell| shell.get_mut(source.face)) {
                *sum += s * t;
            }
        }
        let wrong = covered.iter().flatten().position(|sum| !((sum - 1.0).abs() <= COVER));
        if let Some(face) = wrong {
            return Err(ReadError::NotCovered { object: body.label(), face });
        }
    }
    Ok(())
}

fn cell_deviation(patch: &CyclidePatch, source: &MeshSource, triangles: &[[Point3; 3]]) -> f64 {
    let within = |[from, to]: [f64; 2], i: usize| from + (to - from) * (i as f64 / (GRID - 1) as f64);
    let mut samples = [(0.0, 0.0, Point3::ORIGIN); GRID * GRID];
    for (k, sample) in samples.iter_mut().enumerate() {
        let (s, t) = (within(source.s, k % GRID), within(source.t, k / GRID));
        *sample = (s, t, patch.point(s, t));
    }
    let to_polygon = |p: Point3| triangles.iter().map(|t| to_triangle(p, t)).fold(f64::INFINITY, f64::min);
    let outward = samples.iter().map(|(_, _, p)| to_polygon(*p)).fold(0.0, f64::max);
    let back = triangles.iter().flat_map(|&[a, b, c]| {
        let center = Point3::ORIGIN + (a.to_vec() + b.to_vec() + c.to_vec()) / 3.0;
        [a, b, c, a.midpoint(b), b.midpoint(c), c.midpoint(a), center]
    });
    back.map(|p| to_cell(patch, source, &samples, p)).fold(outward, f64::max)
}

/// Distance of a point from the cell: from the nearest sample a few steps along the parameter circles, which are
/// orthogonal, so that each step is two projections.
fn to_cell(patch: &CyclidePatch, source: &MeshSource, samples: &[(f64, f64, Point3)], p: Point3) -> f64 {
    let nearest = samples.iter().map(|&(s, t, q)| (s, t, q.distance(p))).min_by(|a, b| a.2.total_cmp(&b.2));
    let (mut s, mut t, mut best) = nearest.unwrap_or((source.s[0], source.t[0], f64::INFINITY));
    for _ in 0..STEPS {
        let jet = patch.jet(s, t);
        let offset = p - jet.point;
        best = best.min(offset.length());
        let along = |d: cyclide::Vec3| if d.length_squared() > 0.0 { offset.dot(d) / d.length_squared() } else { 0.0 };
        s = (s + along(jet.ds)).clamp(source.s[0], source.s[1]);
        t = (t + along(jet.dt)).clamp(source.t[0], source.t[1]);
    }
    best.min(patch.point(s, t).distance(p))
}
