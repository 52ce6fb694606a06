//! Curved PN triangles, to compare with (A. Vlachos, J. Peters, C. Boyd and J. Mitchell, *Curved PN triangles*, 2001): cubic
//! Bézier triangles from corners and their normals, whose edges agree and whose tangent planes do not.

use crate::base::vector::{Point3, Vec3};

/// A cubic Bézier triangle, as seen from its first corner.
pub(super) struct PnTriangle {
    origin: Point3,
    corners: [Vec3; 3],
    /// Of the two control points on the side from corner i to corner j, `beside[i][j]` is the one beside i.
    beside: [[Vec3; 3]; 3],
    middle: Vec3,
}

impl PnTriangle {
    /// The triangle over corners with unit normals.
    pub(super) fn new(corners: [Point3; 3], normals: [Vec3; 3]) -> Self {
        let origin = corners[0];
        let p = corners.map(|corner| corner - origin);
        let beside = [0, 1, 2].map(|i: usize| {
            [0, 1, 2].map(|j: usize| (p[i] * 2.0 + p[j] - normals[i] * (p[j] - p[i]).dot(normals[i])) / 3.0)
        });
        let sides = SIDES.iter().fold(Vec3::ZERO, |sum, &[i, j]| sum + beside[i][j] + beside[j][i]) / 6.0;
        let mean = (p[0] + p[1] + p[2]) / 3.0;
        Self { origin, corners: p, beside, middle: sides + (sides - mean) * 0.5 }
    }

    /// The point at barycentric coordinates of sum 1.
    pub(super) fn point(&self, l: [f64; 3]) -> Point3 {
        let mut sum = self.middle * (6.0 * l[0] * l[1] * l[2]);
        for (corner, l) in self.corners.iter().zip(l) {
            sum += *corner * (l * l * l);
        }
        for [i, j] in SIDES {
            sum += (self.beside[i][j] * l[i] + self.beside[j][i] * l[j]) * (3.0 * l[i] * l[j]);
        }
        self.origin + sum
    }

    /// The unit normal there; `None` where the derivatives have one direction.
    pub(super) fn normal(&self, l: [f64; 3]) -> Option<Vec3> {
        let [d0, d1, d2] = [0, 1, 2].map(|i: usize| {
            let [j, k] = [(i + 1) % 3, (i + 2) % 3];
            let side = |j: usize| (self.beside[i][j] * (2.0 * l[i]) + self.beside[j][i] * l[j]) * (3.0 * l[j]);
            self.corners[i] * (3.0 * l[i] * l[i]) + side(j) + side(k) + self.middle * (6.0 * l[j] * l[k])
        });
        (d0 - d2).cross(d1 - d2).unit()
    }
}

const SIDES: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];
