//! Area and volume of a smooth mesh by quadrature.

use super::{SmoothMesh, SmoothTriangle};
use crate::base::bounds::Aabb;
use crate::base::quadrature::{unit_rule2, unit_rule4};
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;
use crate::surface::barycentric::Barycentric;

/// Measures of a smooth mesh with the estimate of their errors: how much a rule with half as many nodes in each direction differs.
///
/// ```
/// use cyclide::{Point3, SmoothMesh, VertexNormals};
/// let corners = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]].map(Point3::from);
/// let faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
/// let measure = SmoothMesh::new(&corners, &faces, VertexNormals::AngleWeighted)?.measure()?;
/// assert!(measure.volume.is_some_and(|volume| volume > 8.0 / 3.0)); // rounder than the tetrahedron
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SmoothMeasure {
    /// Area.
    pub area: f64,
    /// Estimated error of it.
    pub area_error: f64,
    /// Volume enclosed by a closed mesh, positive if its triangles are counter-clockwise seen from outside; `None` for an open one.
    pub volume: Option<f64>,
    /// Estimated error of it; 0 for an open mesh.
    pub volume_error: f64,
}

/// Area, and volume over the apex.
type Sums = [f64; 2];

impl SmoothMesh {
    /// Area and volume. The patches are smooth in polar coordinates about their corners, so each is cut into six triangles with one corner of
    /// the patch each, and a Gauss-Legendre rule of 4 x 4 nodes is taken there in such coordinates.
    ///
    /// # Errors
    /// As [`SmoothTriangle::point`], with the number of the triangle.
    pub fn measure(&self) -> Result<SmoothMeasure> {
        let apex = self.middle();
        let (mut fine, mut coarse) = ([0.0; 2], [0.0; 2]);
        for index in 0..self.triangles().len() {
            let Some(triangle) = self.triangle(index) else { continue };
            for (sums, rule) in [(&mut fine, &unit_rule4()[..]), (&mut coarse, &unit_rule2()[..])] {
                let part = sums_over(&triangle, apex, rule).map_err(|e| e.in_triangle(index))?;
                sums[0] += part[0];
                sums[1] += part[1];
            }
        }
        let closed = self.is_closed();
        Ok(SmoothMeasure {
            area: fine[0],
            area_error: (fine[0] - coarse[0]).abs(),
            volume: closed.then_some(fine[1]),
            volume_error: if closed { (fine[1] - coarse[1]).abs() } else { 0.0 },
        })
    }

    /// The middle of the box of its vertices: seen from there no digits of the volume are lost.
    fn middle(&self) -> Point3 {
        let used = self.triangles().iter().flatten().map(|&v| self.positions()[v]);
        Aabb::of_points(used).map_or(Point3::ORIGIN, |b| b.min.midpoint(b.max))
    }
}

/// The middles of the sides and of the triangle, as barycentric coordinates from a corner on.
const CELLS: [[[f64; 3]; 2]; 2] = {
    let third = 1.0 / 3.0;
    [[[0.5, 0.5, 0.0], [third; 3]], [[third; 3], [0.5, 0.0, 0.5]]]
};

fn sums_over(triangle: &SmoothTriangle, apex: Point3, rule: &[(f64, f64)]) -> Result<Sums> {
    let mut sums = [0.0; 2];
    for corner in 0..3 {
        for [a, b] in CELLS {
            for &(radius, radius_weight) in rule {
                for &(turn, turn_weight) in rule {
                    let mut lambda = [0.0; 3];
                    for k in 0..3 {
                        let own = if k == 0 { 1.0 - radius } else { 0.0 };
                        lambda[(corner + k) % 3] = own + radius * ((1.0 - turn) * a[k] + turn * b[k]);
                    }
                    let jet = triangle.jet(&Barycentric::new(lambda)?)?;
                    let element: Vec3 = jet.derivatives[0].cross(jet.derivatives[1]);
                    // A cell is a sixth of the triangle, which is half of the unit square of its coordinates.
                    let weight = radius * radius_weight * turn_weight / 6.0;
                    sums[0] += weight * element.length();
                    sums[1] += weight * (jet.point - apex).dot(element) / 3.0;
                }
            }
        }
    }
    Ok(sums)
}
