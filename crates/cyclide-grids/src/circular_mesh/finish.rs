//! The exact finish: fourth corners projected onto the circle of the other three, row by row.

use super::border::Holds;
use super::closing::Closing;
use super::search::Residuals;
use cyclide::surface::QuadGrid;
use cyclide::{Point3, Vec3};

/// Replaces the last corner of each quad by its projection onto the circle of the others
/// (`docs/math/patches.md#admissible-input`: the foot of `b3` on the line `b1 b2`, with `b_k = (a_k - a0)^-1`), in the
/// order of rows, so that the first three are final.
///
/// Each move is by the residual that the search has left, but moves add up along the rows, and the last quads of
/// closed directions and those at held borders have no corner left to move: the points are kept as they were unless
/// the largest residual falls, those of closed directions among them.
pub(super) fn sweep(
    points: &mut Vec<Point3>,
    grid: &QuadGrid,
    (quads, closing): (&[[usize; 4]], &Closing),
    holds: &Holds<'_>,
) {
    let mut swept = points.clone();
    let [m, n] = grid.size();
    for j in 0..n - 1 {
        for i in (0..m - 1).filter(|i| grid.has_quad(*i, j)) {
            let [a0, a1, a2, a3] = grid.corners(i, j);
            if let Some(corner) = projection([a0, a1, a2, a3].map(|k| swept[k])).filter(|_| holds.is_free(a3)) {
                swept[a3] = corner;
            }
        }
    }
    let measure = |points: &[Point3]| Residuals::of(points, quads, closing).map_or(f64::INFINITY, |r| r.largest());
    if measure(&swept) < measure(points) {
        *points = swept;
    }
}

/// The point nearest to `a3`, seen from `a0`, on the circle or line through the other corners.
fn projection([a0, a1, a2, a3]: [Point3; 4]) -> Option<Point3> {
    let inverse = |x: Vec3| x / -x.length_squared();
    let [b1, b2, b3] = [a1, a2, a3].map(|a| inverse(a - a0));
    let side = b2 - b1;
    let foot = b1 + side * ((b3 - b1).dot(side) / side.length_squared());
    let corner = a0 + inverse(foot);
    corner.is_finite().then_some(corner)
}
