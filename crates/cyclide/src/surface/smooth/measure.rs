//! Area and volume of a smooth mesh by quadrature.

use super::SmoothMesh;
use super::triangle::Jet;
use crate::base::bounds::Aabb;
use crate::base::quadrature::{unit_rule2, unit_rule4};
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;
use crate::surface::SphereBlend;
use crate::surface::barycentric::Barycentric;

/// Measures of a surface over triangles with the estimate of their errors: how much a rule with half as many nodes in each direction differs.
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
    /// the patch each, and a Gauss-Legendre rule of 4 x 4 nodes is taken there in such coordinates;
    /// of few triangles each of these parts is cut into up to 64.
    ///
    /// # Errors
    /// As [`SmoothTriangle::point`](crate::SmoothTriangle::point), with the number of the triangle.
    pub fn measure(&self) -> Result<SmoothMeasure> {
        let apex = self.middle();
        let panels = panels(self.triangles().len());
        let mut sums = [[0.0; 2]; 2];
        for index in 0..self.triangles().len() {
            let patch = self.patch(index);
            add_patch(&mut sums, apex, panels, |at| patch.jet(at)).map_err(|e| e.in_triangle(index))?;
        }
        Ok(SmoothMeasure::of_sums(sums, self.is_closed()))
    }

    /// The middle of the box of its vertices: seen from there no digits of the volume are lost.
    fn middle(&self) -> Point3 {
        let used = self.triangles().iter().flatten().map(|&v| self.positions()[v]);
        Aabb::of_points(used).map_or(Point3::ORIGIN, |b| b.min.midpoint(b.max))
    }
}

impl SphereBlend {
    /// Area, as [`SmoothMesh::measure`].
    ///
    /// # Errors
    /// As [`SphereBlend::point`].
    pub fn measure(&self) -> Result<SmoothMeasure> {
        let mut sums = [[0.0; 2]; 2];
        add_patch(&mut sums, self.corners()[0], panels(1), |at| self.jet(at))?;
        Ok(SmoothMeasure::of_sums(sums, false))
    }
}

impl SmoothMeasure {
    /// From the sums of the fine rule and of the coarse one.
    fn of_sums([fine, coarse]: [Sums; 2], closed: bool) -> Self {
        Self {
            area: fine[0],
            area_error: (fine[0] - coarse[0]).abs(),
            volume: closed.then_some(fine[1]),
            volume_error: if closed { (fine[1] - coarse[1]).abs() } else { 0.0 },
        }
    }
}

/// Into how many parts of each coordinate the cells of a triangle are cut: some thousand places are looked at in any mesh.
fn panels(triangles: usize) -> usize {
    ((ENOUGH / triangles.max(1)) as f64).sqrt().clamp(1.0, MOST_PANELS) as usize
}

/// Triangles from which on their cells are not cut, and the most parts of each coordinate of a cell.
const ENOUGH: usize = 512;
const MOST_PANELS: f64 = 8.0;

/// Adds the sums of a patch by the fine rule and by the coarse one.
fn add_patch(
    sums: &mut [Sums; 2],
    apex: Point3,
    panels: usize,
    jet: impl Fn(&Barycentric) -> Result<Jet>,
) -> Result<()> {
    for (sums, rule) in sums.iter_mut().zip([&unit_rule4()[..], &unit_rule2()[..]]) {
        let part = sums_over(&jet, apex, panels, rule)?;
        sums[0] += part[0];
        sums[1] += part[1];
    }
    Ok(())
}

/// The middles of the sides and of the triangle, as barycentric coordinates from a corner on.
const CELLS: [[[f64; 3]; 2]; 2] = {
    let third = 1.0 / 3.0;
    [[[0.5, 0.5, 0.0], [third; 3]], [[third; 3], [0.5, 0.0, 0.5]]]
};

fn sums_over(
    jet: impl Fn(&Barycentric) -> Result<Jet>,
    apex: Point3,
    panels: usize,
    rule: &[(f64, f64)],
) -> Result<Sums> {
    let mut sums = [0.0; 2];
    // The rule on each of the equal parts of [0, 1].
    let part = |k: usize| rule.iter().map(move |(x, w)| ((k as f64 + x) / panels as f64, w / panels as f64));
    for corner in 0..3 {
        for [a, b] in CELLS {
            for (radius, radius_weight) in (0..panels).flat_map(part) {
                for (turn, turn_weight) in (0..panels).flat_map(part) {
                    let mut lambda = [0.0; 3];
                    for k in 0..3 {
                        let own = if k == 0 { 1.0 - radius } else { 0.0 };
                        lambda[(corner + k) % 3] = own + radius * ((1.0 - turn) * a[k] + turn * b[k]);
                    }
                    let jet = jet(&Barycentric::new(lambda)?)?;
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
