//! Surfaces over triangles, whose places are a triangle and barycentric coordinates.

use super::{SmoothMesh, SmoothTriangle, SphereBlend};
use crate::base::bounds::Aabb;
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;

/// Steps from corner to corner of a triangle at whose places the box is taken.
const STEPS: usize = 4;

/// A surface over triangles. It has no exact rational form, so it is never a face of a shell: files hold meshes of it.
///
/// ```
/// use cyclide::{Point3, surface::{SphereBlend, TriangleSurface}};
/// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let sail = SphereBlend::from_normals(corners, corners.map(Point3::to_vec))?;
/// let surface = TriangleSurface::from(sail);
/// assert_eq!((surface.triangle_count(), surface.free_sides(), surface.is_closed()), (1, 3, false));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum TriangleSurface {
    /// Over the triangles of a mesh.
    Mesh(SmoothMesh),
    /// Over one triangle.
    Blend(SphereBlend),
}

/// The patch over one triangle of such a surface.
#[derive(Debug, Clone, Copy)]
#[expect(clippy::large_enum_variant, reason = "a plain value, made once for many places")]
enum Patch {
    Smooth(SmoothTriangle),
    Blend(SphereBlend),
}

impl TriangleSurface {
    /// How many triangles it has.
    #[must_use]
    pub fn triangle_count(&self) -> usize {
        match self {
            Self::Mesh(mesh) => mesh.triangles().len(),
            Self::Blend(_) => 1,
        }
    }

    /// The patch over a triangle, to be asked for many places; `None` beyond the last one.
    #[must_use]
    pub fn patch(&self, triangle: usize) -> Option<TrianglePatch> {
        match self {
            Self::Mesh(mesh) => mesh.triangle(triangle).map(|patch| TrianglePatch(Patch::Smooth(patch))),
            Self::Blend(blend) => (triangle == 0).then_some(TrianglePatch(Patch::Blend(*blend))),
        }
    }

    /// Whether no side of a triangle is free.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.free_sides() == 0
    }

    /// How many sides of triangles are free.
    #[must_use]
    pub fn free_sides(&self) -> usize {
        match self {
            Self::Mesh(mesh) => mesh.edges().iter().filter(|edge| edge.triangles().1.is_none()).count(),
            Self::Blend(_) => 3,
        }
    }

    /// For each side of a triangle, opposite to the corner of its place, whether it is drawn as a line: it is free, or a crease.
    #[must_use]
    pub fn lines(&self, triangle: usize) -> [SideLine; 3] {
        match self {
            Self::Mesh(mesh) => mesh.triangle_edges().get(triangle).map_or([SideLine::Free; 3], |edges| {
                edges.map(|edge| {
                    let edge = &mesh.edges()[edge];
                    match edge.triangles().1 {
                        None => SideLine::Free,
                        Some(_) if edge.is_sharp() => SideLine::Crease,
                        Some(_) => SideLine::Smooth,
                    }
                })
            }),
            Self::Blend(_) => [SideLine::Free; 3],
        }
    }

    /// The box of some places of every triangle, its corners among them: sampled, so the surface may stand out of it by a little.
    ///
    /// # Errors
    /// As [`TrianglePatch::point`], with the number of the triangle.
    pub fn sampled_bounds(&self) -> Result<Aabb> {
        let mut bounds: Option<Aabb> = None;
        for triangle in 0..self.triangle_count() {
            let Some(patch) = self.patch(triangle) else { continue };
            for i in 0..=STEPS {
                for j in 0..=STEPS - i {
                    let at = [i, j, STEPS - i - j].map(|v| v as f64);
                    let p = patch.point(at).map_err(|e| e.in_triangle(triangle))?;
                    bounds = Some(bounds.map_or(Aabb::of_point(p), |b| b.including(p)));
                }
            }
        }
        // There is a triangle.
        Ok(bounds.unwrap_or(Aabb::of_point(Point3::ORIGIN)))
    }
}

/// What a side of a triangle is to the surface.
///
/// ```
/// use cyclide::{Point3, surface::{SideLine, SphereBlend, TriangleSurface}};
/// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let sail = SphereBlend::from_normals(corners, corners.map(Point3::to_vec))?;
/// assert_eq!(TriangleSurface::from(sail).lines(0), [SideLine::Free; 3]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SideLine {
    /// The surface goes on smoothly.
    Smooth,
    /// The surface has a crease there.
    Crease,
    /// The surface ends there.
    Free,
}

/// The patch over one triangle of a surface.
///
/// ```
/// use cyclide::{Point3, surface::{SphereBlend, TriangleSurface}};
/// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
/// let sail = SphereBlend::from_normals(corners, corners.map(Point3::to_vec))?;
/// let surface = TriangleSurface::from(sail);
/// let patch = surface.patch(0).expect("it has one");
/// let (point, normal) = patch.point_and_normal([1.0, 2.0, 1.0])?;
/// assert!((point.to_vec() - normal).length() < 1e-14); // a piece of the unit sphere
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct TrianglePatch(Patch);

impl TrianglePatch {
    /// Corners, counter-clockwise seen from the outer side.
    #[must_use]
    pub fn corners(&self) -> [Point3; 3] {
        match &self.0 {
            Patch::Smooth(triangle) => triangle.corners(),
            Patch::Blend(blend) => blend.corners(),
        }
    }

    /// The point at barycentric coordinates, not negative, in any scale.
    ///
    /// # Errors
    /// As [`SmoothTriangle::point`] and [`SphereBlend::point`].
    pub fn point(&self, lambda: [f64; 3]) -> Result<Point3> {
        match &self.0 {
            Patch::Smooth(triangle) => triangle.point(lambda),
            Patch::Blend(blend) => blend.point(lambda),
        }
    }

    /// Point and unit normal on the outer side.
    ///
    /// # Errors
    /// As [`point`](Self::point) and [`SphereBlend::normal`].
    pub fn point_and_normal(&self, lambda: [f64; 3]) -> Result<(Point3, Vec3)> {
        match &self.0 {
            Patch::Smooth(triangle) => triangle.point_and_normal(lambda),
            Patch::Blend(blend) => Ok((blend.point(lambda)?, blend.normal(lambda)?)),
        }
    }
}

impl From<SmoothMesh> for TriangleSurface {
    fn from(mesh: SmoothMesh) -> Self {
        Self::Mesh(mesh)
    }
}

impl From<SphereBlend> for TriangleSurface {
    fn from(blend: SphereBlend) -> Self {
        Self::Blend(blend)
    }
}
