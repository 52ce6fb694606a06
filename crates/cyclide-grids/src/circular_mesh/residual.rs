//! How far the quads are from having their corners on one circle, and how that changes with the corners.
//!
//! With the unit edges `d_ij` from corner i to corner j, the corners lie on a circle or line exactly if
//! `d_01 d_13 d_32 d_20` is real: it is their cross-ratio divided by its length. The residual of a quad is the vector
//! part (three numbers of rank two), the real part is then -1 for an embedded quad and 1 for one whose sides cross
//! (`docs/math/circular-meshes.md#residual`).

use super::block::Block;
use cyclide::Quat;
use cyclide::surface::QuadGrid;
use cyclide::{Point3, Vec3};

/// The sides of a quad as pairs of its corners, in cyclic order.
const SIDES: [(usize, usize); 4] = [(0, 1), (1, 3), (3, 2), (2, 0)];

/// The corners of every quad of the grid, s fastest.
pub(super) fn quads(grid: &QuadGrid) -> Vec<[usize; 4]> {
    grid.all_quads().map(|[i, j]| grid.corners(i, j)).collect()
}

/// Unit sides and their lengths; `None` if a side has no direction.
fn unit_sides(points: &[Point3], quad: [usize; 4]) -> Option<[(Vec3, f64); 4]> {
    let mut sides = [(Vec3::ZERO, 0.0); 4];
    for (side, (i, j)) in sides.iter_mut().zip(SIDES) {
        let edge = points[quad[j]] - points[quad[i]];
        *side = (edge.unit()?, edge.length());
    }
    Some(sides)
}

/// The product of the unit sides; `None` if a side has no direction.
pub(super) fn side_product(points: &[Point3], quad: [usize; 4]) -> Option<Quat> {
    let [a, b, c, d] = unit_sides(points, quad)?.map(|side| Quat::from(side.0));
    Some(a * b * c * d)
}

/// Residuals of all quads; `None` if a side has no direction.
pub(super) fn residuals(points: &[Point3], quads: &[[usize; 4]]) -> Option<Vec<Vec3>> {
    quads.iter().map(|quad| side_product(points, *quad).map(Quat::vector)).collect()
}

/// Length of the largest residual.
pub(super) fn largest(residuals: &[Vec3]) -> f64 {
    residuals.iter().map(|r| r.length()).fold(0.0, f64::max)
}

/// Derivative of the residual by each corner: `d(d_ij) = (I - d_ij d_ij^T)/delta_ij (dx_j - dx_i)` inside the product
/// (`docs/math/circular-meshes.md#residual`).
pub(super) fn derivatives(points: &[Point3], quad: [usize; 4]) -> Option<[Block; 4]> {
    let sides = unit_sides(points, quad)?;
    let d = sides.map(|side| Quat::from(side.0));
    let around =
        [(Quat::ONE, d[1] * d[2] * d[3]), (d[0], d[2] * d[3]), (d[0] * d[1], d[3]), (d[0] * d[1] * d[2], Quat::ONE)];
    let mut by_corner = [Block::ZERO; 4];
    for (((i, j), (unit, length)), (before, after)) in SIDES.into_iter().zip(sides).zip(around) {
        let product = |axis: Vec3| (before * Quat::from(axis) * after).vector();
        let outer = Block::from_columns([Vec3::X, Vec3::Y, Vec3::Z].map(product));
        let by_edge = outer * (Block::IDENTITY - Block::square(unit)) * (1.0 / length);
        by_corner[j] += by_edge;
        by_corner[i] += by_edge * -1.0;
    }
    Some(by_corner)
}

#[cfg(test)]
mod tests {
    use super::*;

    const QUAD: [usize; 4] = [0, 1, 2, 3];

    fn corners() -> [Point3; 4] {
        [[0.1, 0.2, 0.0], [1.1, -0.1, 0.3], [-0.2, 0.9, -0.1], [1.3, 1.2, 0.6]].map(Point3::from)
    }

    #[test]
    fn real_part_tells_embedded_from_crossing() {
        let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
        assert_eq!(side_product(&square, QUAD), Some(Quat::new(-1.0, 0.0, 0.0, 0.0)));
        let product = side_product(&square, [0, 1, 3, 2]).unwrap();
        assert!((product - Quat::ONE).norm() < 1e-15); // rounding of the diagonals
    }

    #[test]
    fn derivatives_agree_with_central_differences() {
        let jacobian = derivatives(&corners(), QUAD).unwrap();
        let step = 1e-5;
        for (corner, block) in jacobian.into_iter().enumerate() {
            for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
                let at = |h: f64| {
                    let mut points = corners();
                    points[corner] += axis * h;
                    side_product(&points, QUAD).unwrap().vector()
                };
                let difference = (at(step) - at(-step)) / (2.0 * step);
                // Truncation step² and rounding 1e-16/step are both near 1e-10.
                assert!((difference - block.apply(axis)).length() < 1e-9);
            }
        }
    }
}
