//! Tessellation: the polygon mesh of few cells within a chordal tolerance of patches that share edges.
//!
//! Faces are cut along parameter lines, so every cell of a patch has concircular corners and is a *planar* quad, or a
//! triangle at a point to which a parameter line shrinks; a cell of a rational face is two triangles. A cut runs through the whole strip of faces across whose common edges it
//! goes ([`strips`]), and each edge is sampled once: neighbors share vertices, without cracks or T-joints.

mod assemble;
mod cuts;
mod density;
mod strips;
mod vertices;

use super::MOST_PIECES;
use super::surface_mesh::SurfaceMesh;
use crate::error::{ErrorItem, NumberError, Result, check_tolerance};
use crate::topology::{Body, Shell};
use assemble::assemble;
use cuts::{Cap, Cuts};
use strips::Strips;

/// Rounding of positions, in units of the largest coordinate: some tens of operations, each rounded once.
const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Part of the tolerance that is left to the rounding of cuts and edges.
const RESERVE: f64 = 1e-3;

/// A watertight mesh of planar quads (triangles at poles, and on rational faces) within `tolerance` of the body, in both directions: no point of
/// the surface is farther than [`SurfaceMesh::bound`] from the mesh, and none of the mesh from the surface.
///
/// Vertices lie on the surface, those on edges on the edge's arc, those of the shells are taken over to the bit. Every cell is
/// certified: by the sagittas of its arcs in closed form (`docs/math/tessellation.md#distance-of-a-cell`, sharpened
/// where the two families bulge to different sides), on rational faces by the hulls of second derivatives; the bound
/// holds the largest of the cells, the rounding of positions, and what the shell's edges are off their faces. Quads are
/// counter-clockwise seen from the outer side of the shell, and so point the unit normals; faces that meet without a
/// kink (to 1e-6 radians) share them, others have their own.
///
/// ```
/// use cyclide::{Point3, Vec3, mesh::tessellate, surface::CyclidePatch, topology::{Body, Shell}};
/// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let octant = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z)?;
/// let mesh = tessellate(&Body { outer: Shell::from_surface(octant)?, voids: Vec::new() }, 1e-3)?;
/// assert!(mesh.bound <= 1e-3 && mesh.positions.iter().all(|p| (p.to_vec().length() - 1.0).abs() < 1e-15));
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// `tolerance-not-positive`, `not-finite` (infinite tolerance); `parameter-out-of-range` if the tolerance is below the
/// rounding of the coordinates; `too-many-pieces` if more than [`MOST_PIECES`] cells would be needed.
pub fn tessellate(body: &Body, tolerance: f64) -> Result<SurfaceMesh> {
    tessellate_all([body], tolerance)
}

/// One mesh of several bodies, as [`tessellate`]; the shells of all bodies are counted through.
///
/// ```
/// use cyclide::{surface::DupinCyclide, topology::Body};
/// let ring = Body { outer: DupinCyclide::new(3.0, 0.0, 1.0)?.to_shell()?, voids: Vec::new() };
/// let mesh = cyclide::mesh::tessellate_all([&ring, &ring], 0.1)?;
/// assert_eq!(mesh.faces.len(), 2 * cyclide::mesh::tessellate_all([&ring], 0.1)?.faces.len());
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// As [`tessellate`].
pub fn tessellate_all<'a>(bodies: impl IntoIterator<Item = &'a Body>, tolerance: f64) -> Result<SurfaceMesh> {
    tessellate_within(bodies, tolerance, MOST_PIECES)
}

/// As [`tessellate_all`], with `most` cells at most.
///
/// ```
/// use cyclide::{surface::DupinCyclide, topology::Body};
/// let ring = Body { outer: DupinCyclide::new(3.0, 0.0, 1.0)?.to_shell()?, voids: Vec::new() };
/// assert_eq!(cyclide::mesh::tessellate_within([&ring], 1e-6, 1000).unwrap_err().reason(), "too-many-pieces");
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// As [`tessellate`].
pub fn tessellate_within<'a>(
    bodies: impl IntoIterator<Item = &'a Body>,
    tolerance: f64,
    most: usize,
) -> Result<SurfaceMesh> {
    check_tolerance(tolerance)?;
    let mut mesh = SurfaceMesh::default();
    for (index, shell) in bodies.into_iter().flat_map(Body::shells).enumerate() {
        append(shell, index, tolerance, most, &mut mesh)?;
    }
    Ok(mesh)
}

/// Appends the mesh of one shell.
fn append(shell: &Shell, index: usize, tolerance: f64, most: usize, mesh: &mut SurfaceMesh) -> Result<()> {
    let bounds = shell.bounds();
    let rounding = ROUNDING * bounds.max_abs();
    // Beyond its size a tolerance asks for nothing more.
    let allowed = (1.0 - RESERVE) * tolerance.min(bounds.diagonal()) - rounding;
    if !(allowed > 0.0) {
        let min = rounding / (1.0 - RESERVE);
        return Err(NumberError::ParameterOutOfRange {
            name: ErrorItem::Tolerance,
            value: tolerance,
            min,
            max: f64::MAX,
        }
        .into());
    }
    let strips = Strips::new(shell);
    let cuts = Cuts::new(shell, &strips, allowed, Cap { most, before: mesh.faces.len() })?;
    let gap = assemble(shell, index, &strips, &cuts, mesh);
    mesh.bound = mesh.bound.max(cuts.distance + gap + rounding);
    mesh.gap = mesh.gap.max(gap);
    Ok(())
}
