//! Meshes of surfaces over triangles: each triangle cut into N² by integer barycentric coordinates, the same N everywhere.
//!
//! Points of an edge are computed once, from its lower vertex, so neighbors share them to the bit. How far the mesh is from the
//! surface is measured at places on all edges and in all triangles of it: sampled, not proved.

mod blend;
mod deviation;
mod numbering;

use super::MOST_PIECES;
use super::surface_mesh::{MeshFace, MeshSource, SurfaceMesh};
use crate::error::{ErrorItem, NumberError, Result, check_tolerance};
use crate::surface::{SmoothMesh, TriangleSurface};
use deviation::Farthest;
use numbering::Numbering;

/// Numbers of divisions grow by this more than the last deviation asks for, which saves most second tries.
const MORE: f64 = 1.03;
/// Fewer divisions tell little of the deviation of many.
const FEW: usize = 8;
/// What is kept for the places between those that are looked at: the bound is so many times the largest distance found.
const RESERVE: f64 = 1.25;

/// A mesh of a surface over triangles with what was measured of it.
///
/// ```
/// use cyclide::{Point3, surface::{SmoothMesh, VertexNormals}};
/// let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.1], [0.0, 1.0, 0.2], [1.0, 1.0, -0.1]].map(Point3::from);
/// let smooth = SmoothMesh::new(&points, &[[0, 1, 2], [1, 3, 2]], VertexNormals::AngleWeighted)?;
/// let made = smooth.tessellate_within(0.01)?;
/// assert!(made.deviation <= 0.01 && made.mesh.faces.len() == 2 * made.divisions * made.divisions);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SmoothTessellation {
    /// The mesh: faces in the order of the triangles of the surface, N² each, whose sources have the number of their triangle as face
    /// and the ranges of its first two barycentric coordinates. Its `bound` is 1.25 times the deviation.
    pub mesh: SurfaceMesh,
    /// Parts N of every edge.
    pub divisions: usize,
    /// Largest distance of the surface from the mesh at places on its edges and in its triangles: sampled, not proved.
    pub deviation: f64,
}

impl SmoothMesh {
    /// A mesh whose edges are those of the surface in `divisions` parts each. Not measured: its `bound` is infinite.
    ///
    /// # Errors
    /// `parameter-out-of-range` (no division), `too-many-pieces` (above [`MOST_PIECES`]), as
    /// [`SmoothTriangle::point`](crate::surface::SmoothTriangle::point) with the number of the triangle.
    pub fn tessellate(&self, divisions: usize) -> Result<SurfaceMesh> {
        check_divisions(self.triangles().len(), divisions, MOST_PIECES)?;
        let numbering = Numbering::new(self, divisions);
        let (positions, normals) = numbering.places()?;
        let count = self.triangles().len() * divisions * divisions;
        let (mut faces, mut sources) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for triangle in 0..self.triangles().len() {
            for cell in cells(divisions) {
                faces.push(MeshFace::Triangle(cell.map(|at| numbering.corner(triangle, at))));
                sources.push(source(triangle, cell, divisions));
            }
        }
        Ok(SurfaceMesh { positions, normals, faces, sources, lost: Vec::new(), bound: f64::INFINITY, gap: 0.0 })
    }

    /// A mesh that is within a tolerance of the surface where it is measured, with a reserve for what lies between.
    ///
    /// # Errors
    /// `tolerance-not-positive`, `not-finite`, and as [`tessellate`](Self::tessellate); `too-many-pieces` with the number of the triangle that asks
    /// for so many: all are cut alike.
    pub fn tessellate_within(&self, tolerance: f64) -> Result<SmoothTessellation> {
        within(self, tolerance, MOST_PIECES)
    }

    /// The largest distance of the surface from its mesh with these divisions, at places on the edges and in the triangles of the mesh.
    ///
    /// # Errors
    /// As [`tessellate`](Self::tessellate).
    pub fn sampled_deviation(&self, divisions: usize) -> Result<f64> {
        check_divisions(self.triangles().len(), divisions, MOST_PIECES)?;
        Divided::deviation(self, divisions, Worst::default(), f64::INFINITY).map(|worst| worst.farthest.distance)
    }
}

impl SmoothMesh {
    /// For each side of a triangle whether the surface ends there, or has a crease.
    fn borders(&self, triangle: usize) -> [bool; 3] {
        self.triangle_edges()[triangle].map(|edge| {
            let edge = &self.edges()[edge];
            edge.triangles().1.is_none() || edge.is_sharp()
        })
    }
}

impl TriangleSurface {
    /// A mesh of at most `most` triangles, as [`SmoothMesh::tessellate_within`].
    ///
    /// # Errors
    /// As [`SmoothMesh::tessellate_within`].
    pub fn tessellate_within(&self, tolerance: f64, most: usize) -> Result<SmoothTessellation> {
        match self {
            Self::Mesh(mesh) => within(mesh, tolerance, most),
            Self::Blend(blend) => within(blend, tolerance, most),
        }
    }
}

/// The triangle of the surface whose mesh is farthest from it, and the place.
#[derive(Debug, Clone, Copy, Default)]
struct Worst {
    triangle: usize,
    farthest: Farthest,
}

/// What is cut into parts.
trait Divided {
    fn triangle_count(&self) -> usize;
    /// Where the mesh is farthest; the rest is not looked at once it is farther than `enough`. What was the worst triangle of
    /// another mesh comes first.
    fn deviation(&self, divisions: usize, before: Worst, enough: f64) -> Result<Worst>;
    /// Where that with twice as many divisions is, next to that place.
    fn halved(&self, worst: Worst) -> Result<Worst>;
    fn mesh(&self, divisions: usize) -> Result<SurfaceMesh>;
}

impl Divided for SmoothMesh {
    fn triangle_count(&self) -> usize {
        self.triangles().len()
    }

    fn deviation(&self, divisions: usize, before: Worst, enough: f64) -> Result<Worst> {
        let mut worst = Worst::default();
        for triangle in (before.triangle..self.triangle_count()).chain(0..before.triangle) {
            let Some(patch) = self.triangle(triangle) else { continue };
            let farthest = deviation::of_patch(divisions, self.borders(triangle), |at| patch.point(at));
            let farthest = farthest.map_err(|e| e.in_triangle(triangle))?;
            if farthest.distance > worst.farthest.distance {
                worst = Worst { triangle, farthest };
            }
            if worst.farthest.distance > enough {
                break;
            }
        }
        Ok(worst)
    }

    fn halved(&self, Worst { triangle, farthest }: Worst) -> Result<Worst> {
        let Some(patch) = self.triangle(triangle) else { return Ok(Worst { triangle, farthest }) };
        let farthest = deviation::of_halves(farthest, self.borders(triangle), |at| patch.point(at));
        let farthest = farthest.map_err(|e| e.in_triangle(triangle))?;
        Ok(Worst { triangle, farthest })
    }

    fn mesh(&self, divisions: usize) -> Result<SurfaceMesh> {
        self.tessellate(divisions)
    }
}

fn within(surface: &impl Divided, tolerance: f64, most: usize) -> Result<SmoothTessellation> {
    check_tolerance(tolerance)?;
    let (count, mut divisions, mut worst) = (surface.triangle_count(), 1, Worst::default());
    check_count(count, 1.0, most)?;
    let finest = (most as f64 / count.max(1) as f64).sqrt();
    loop {
        // Deviations fall with the square of the divisions at best: a larger one than this is too large for the finest mesh.
        let enough = tolerance / RESERVE * (finest / divisions as f64).powi(2);
        worst = surface.deviation(divisions, worst, enough)?;
        let deviation = worst.farthest.distance;
        let bound = RESERVE * deviation;
        if bound <= tolerance {
            let mesh = SurfaceMesh { bound, ..surface.mesh(divisions)? };
            return Ok(SmoothTessellation { mesh, divisions, deviation });
        }
        let wanted = wanted(surface, worst, divisions, tolerance, finest)?;
        // All triangles are cut alike: the worst one decides.
        check_count(count, wanted, most).map_err(|e| e.in_triangle(worst.triangle))?;
        divisions = (divisions + 1).max(wanted as usize);
    }
}

/// The divisions that the worst triangle asks for. Where the surface folds or has a cusp its deviation falls slowly, or not at
/// all: so its worst place is halved until it is near enough, and costly meshes are not tried in vain.
fn wanted(surface: &impl Divided, mut worst: Worst, divisions: usize, tolerance: f64, finest: f64) -> Result<f64> {
    let times_off = |worst: Worst| RESERVE * worst.farthest.distance / tolerance;
    let least = (divisions as f64 * times_off(worst).sqrt() * MORE).ceil();
    if divisions < FEW {
        return Ok(least.min(FEW as f64));
    }
    let mut n = divisions as f64;
    while 2.0 * n <= finest {
        let halved = surface.halved(worst)?;
        if times_off(halved) <= 1.0 {
            // Between the two it falls with a power of the divisions.
            let order = (times_off(worst) / times_off(halved)).log2();
            return Ok((n * times_off(worst).powf(order.recip()) * MORE).ceil().min(2.0 * n).max(least));
        }
        (worst, n) = (halved, 2.0 * n);
    }
    Ok((n * times_off(worst).sqrt() * MORE).ceil().max(least))
}

fn check_divisions(triangles: usize, divisions: usize, most: usize) -> Result<()> {
    if divisions == 0 {
        return Err(NumberError::ParameterOutOfRange {
            name: ErrorItem::Divisions,
            value: 0.0,
            min: 1.0,
            max: f64::MAX,
        }
        .into());
    }
    check_count(triangles, divisions as f64, most)
}

/// Refuses more triangles than are made.
fn check_count(triangles: usize, divisions: f64, most: usize) -> Result<()> {
    let needed = triangles as f64 * divisions * divisions;
    if needed <= most as f64 {
        return Ok(());
    }
    Err(NumberError::TooManyPieces {
        what: "the mesh",
        segment: None,
        needed,
        cap: most,
        remedy: "use a larger tolerance or fewer triangles",
    }
    .into())
}

/// Integer barycentric coordinates of a vertex of the mesh.
type Place = [usize; 3];

/// The parts of a triangle, corners counter-clockwise: row by row, those that point like it and those between them.
fn cells(divisions: usize) -> impl Iterator<Item = [Place; 3]> {
    (0..divisions).flat_map(move |i| {
        (0..divisions - i).flat_map(move |j| {
            let k = divisions - 1 - i - j;
            let upright = [[i + 1, j, k], [i, j + 1, k], [i, j, k + 1]];
            let between = (k > 0).then(|| [[i, j + 1, k], [i + 1, j, k], [i + 1, j + 1, k - 1]]);
            std::iter::once(upright).chain(between)
        })
    })
}

fn source(triangle: usize, cell: [Place; 3], divisions: usize) -> MeshSource {
    let range = |c: usize| {
        let values = cell.map(|at| at[c]);
        let [low, high] = [values.into_iter().min(), values.into_iter().max()];
        [low, high].map(|v| v.unwrap_or(0) as f64 / divisions as f64)
    };
    MeshSource { shell: 0, face: triangle, s: range(0), t: range(1) }
}

/// Coordinates as a triangle takes them.
fn lambda(at: Place) -> [f64; 3] {
    at.map(|v| v as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;

    /// Eight triangles whose deviation is so much for so many divisions, with the meshes that were measured whole.
    struct Law(fn(f64) -> f64, RefCell<Vec<usize>>);

    impl Divided for Law {
        fn triangle_count(&self) -> usize {
            8
        }

        fn deviation(&self, divisions: usize, _: Worst, _: f64) -> Result<Worst> {
            self.1.borrow_mut().push(divisions);
            let farthest = Farthest { distance: self.0(divisions as f64), divisions, ..Farthest::default() };
            Ok(Worst { triangle: 3, farthest })
        }

        fn halved(&self, Worst { triangle, farthest }: Worst) -> Result<Worst> {
            let divisions = 2 * farthest.divisions;
            Ok(Worst { triangle, farthest: Farthest { distance: self.0(divisions as f64), divisions, ..farthest } })
        }

        fn mesh(&self, _: usize) -> Result<SurfaceMesh> {
            Ok(SurfaceMesh::default())
        }
    }

    /// A fold that stays as large in the finest mesh is refused before any mesh of many triangles was measured; a cusp that grows
    /// smaller slowly, and a surface that is smooth, are not.
    #[test]
    fn folds_are_refused_before_they_cost_much() {
        let of = |law: fn(f64) -> f64, tolerance: f64| {
            let law = Law(law, RefCell::default());
            let made = within(&law, tolerance, 8 * 400 * 400).map(|made| made.divisions);
            (made, law.1.into_inner())
        };
        for tolerance in [0.5, 0.05, 5e-4, 5e-8] {
            let (refused, measured) = of(|_| 1.0, tolerance);
            let error = refused.unwrap_err();
            assert_eq!((error.reason(), error.index()), ("too-many-pieces", Some(3)));
            assert!(measured.iter().all(|&n| n <= FEW), "{tolerance}: {measured:?}");
        }
        for (law, tolerance, needed) in [
            ((|n| n.powi(-2)) as fn(f64) -> f64, 1e-4, 112),
            (|n| n.recip(), 5e-3, 250),
            (|n| n.sqrt().recip(), 0.1, 157),
        ] {
            let (made, measured) = of(law, tolerance);
            let made = made.unwrap();
            assert!(made >= needed && made <= needed * 11 / 10 && measured.len() <= 6, "{made} {measured:?}");
        }
    }
}
