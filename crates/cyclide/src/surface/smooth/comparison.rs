//! A smooth mesh beside the flat triangles it was made from and beside curved PN triangles: jumps of the normal across edges, and
//! distances.

use super::pn_triangle::PnTriangle;
use super::{SmoothEdge, SmoothMesh, SmoothTriangle};
use crate::base::vector::Vec3;
use crate::error::Result;
use crate::surface::barycentric::Barycentric;

/// Places of an edge at which the normals of its two triangles are compared: those of the table of `docs/math/triangle-surfaces.md#comparison-with-pn-triangles`.
const ALONG: [f64; 5] = [0.02, 0.1, 0.3, 0.5, 0.8];
/// Steps from corner to corner at which distances are measured: middles of sides and of triangles are among their places.
const STEPS: usize = 12;

/// Normals and distances of a smooth mesh beside other surfaces of the same vertices and normals, largest values over all of the
/// places looked at: sampled, not proved.
///
/// ```
/// use cyclide::{Point3, surface::{SmoothMesh, VertexNormals}};
/// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
/// let triangles = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [1, 0, 5], [2, 1, 5], [3, 2, 5], [0, 3, 5]];
/// let mesh = SmoothMesh::new(&corners.map(Point3::from), &triangles, VertexNormals::AngleWeighted)?;
/// let ball = mesh.comparison()?; // the corners and normals of a ball
/// assert!(ball.jump < 1e-9 && ball.flat_jump > 1.0 && ball.pn_jump > 0.01);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct SmoothComparison {
    /// Jump of the normal across edges that are no creases, radians: between the normals that the derivatives of both triangles give.
    pub jump: f64,
    /// The same jump of flat triangles.
    pub flat_jump: f64,
    /// The same jump of curved PN triangles.
    pub pn_jump: f64,
    /// Distance from the flat triangles: of a place from the plane of its own.
    pub from_flat: f64,
    /// Distance from the PN triangles, between places with the same barycentric coordinates.
    pub from_pn: f64,
}

impl SmoothMesh {
    /// Compares the surface with flat and with curved PN triangles.
    ///
    /// # Errors
    /// As [`SmoothTriangle::point`], with the number of the triangle.
    pub fn comparison(&self) -> Result<SmoothComparison> {
        let mut largest = SmoothComparison::default();
        for edge in self.edges.iter().filter(|edge| !edge.sharp) {
            self.compare_across(edge, &mut largest)?;
        }
        for index in 0..self.triangles.len() {
            let Some(triangle) = self.triangle(index) else { continue };
            compare_places(&triangle, &mut largest).map_err(|e| e.in_triangle(index))?;
        }
        Ok(largest)
    }

    fn compare_across(&self, edge: &SmoothEdge, largest: &mut SmoothComparison) -> Result<()> {
        let Some(second) = edge.second else { return Ok(()) };
        let sides = [edge.first, second];
        let [Some(a), Some(b)] = sides.map(|side| self.triangle(side.triangle)) else { return Ok(()) };
        let triangles = [a, b];
        let [first, other] = triangles.map(|t| flat_normal(&t));
        largest.flat_jump = largest.flat_jump.max(first.angle(other));
        let curved = triangles.map(|t| PnTriangle::new(t.corners(), t.normals()));
        for mu in ALONG {
            let places = sides.map(|side| {
                let [from, to] = side.ends();
                let vertices = self.triangles[side.triangle];
                let upwards = vertices[from] < vertices[to];
                let mut at = [0.0; 3];
                (at[from], at[to]) = if upwards { (1.0 - mu, mu) } else { (mu, 1.0 - mu) };
                at
            });
            let mut own = [Vec3::ZERO; 2];
            for k in 0..2 {
                let jet = Barycentric::new(places[k]).and_then(|at| triangles[k].jet(&at));
                let [d1, d2] = jet.map_err(|e| e.in_triangle(sides[k].triangle))?.derivatives;
                own[k] = d1.cross(d2);
            }
            // Where a normal is not defined nothing can be compared.
            if let (Some(a), Some(b)) = (own[0].unit(), own[1].unit()) {
                largest.jump = largest.jump.max(a.angle(b));
            }
            if let (Some(a), Some(b)) = (curved[0].normal(places[0]), curved[1].normal(places[1])) {
                largest.pn_jump = largest.pn_jump.max(a.angle(b));
            }
        }
        Ok(())
    }
}

fn flat_normal(triangle: &SmoothTriangle) -> Vec3 {
    let [a, b, c] = triangle.corners();
    let directions = (b - a).unit().zip((c - a).unit());
    directions.and_then(|(u, v)| u.cross(v).unit()).unwrap_or(Vec3::ZERO)
}

fn compare_places(triangle: &SmoothTriangle, largest: &mut SmoothComparison) -> Result<()> {
    let (flat, curved) = (flat_normal(triangle), PnTriangle::new(triangle.corners(), triangle.normals()));
    let corner = triangle.corners()[0];
    for i in 0..=STEPS {
        for j in 0..=STEPS - i {
            let at = [i, j, STEPS - i - j].map(|v| v as f64 / STEPS as f64);
            let point = triangle.point(at)?;
            largest.from_flat = largest.from_flat.max((point - corner).dot(flat).abs());
            largest.from_pn = largest.from_pn.max(point.distance(curved.point(at)));
        }
    }
    Ok(())
}
