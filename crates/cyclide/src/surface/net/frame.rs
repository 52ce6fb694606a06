//! The frame at the first vertex that fits all edges of a net best (`docs/math/cyclides-and-nets.md#automatic-frame`).

use super::ways::Way;
use crate::base::svd3;
use crate::base::vector::Vec3;
use crate::error::{Error, PatchError, Result};
use crate::surface::quad_grid::QuadGrid;

/// The frame of a net at its vertex (0, 0), from which all others follow.
///
/// ```
/// use cyclide::{Point3, Vec3, surface::{CyclidicNet, NetFrame, QuadGrid}};
/// let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from).to_vec();
/// let grid = QuadGrid::new(square, [2, 2], [false; 2])?;
/// let fitted = CyclidicNet::new(grid.clone(), NetFrame::Auto)?; // a plane
/// let given = CyclidicNet::new(grid, NetFrame::First(Vec3::X, Vec3::Y))?;
/// assert!((fitted.frame()[2] - given.frame()[2]).length() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum NetFrame {
    /// The frame whose copies at all vertices are nearest to the directions of the edges.
    #[default]
    Auto,
    /// Unit directions of growing s and t at vertex (0, 0) (where quads are left out, at the first vertex that belongs to one),
    /// perpendicular to each other.
    First(Vec3, Vec3),
}

/// The unit vector along a chord of points that differ.
pub(super) fn unit(chord: Vec3) -> Vec3 {
    chord.unit().unwrap_or(Vec3::ZERO)
}

/// The frame at vertex (0, 0) by global least squares. At each vertex the target `t1, t2, N` is the symmetric
/// orthonormalization of the directions of its edges along s and t; the product `A` of the reflections along any path
/// from (0, 0) carries a frame `v` there as `(-1)^i A v1, (-1)^j A v2, A v3`, so that
/// `sum tr(target^T A v)` is largest for the rotation nearest to the sum of the targets carried back. In a net that
/// is closed with an odd number of edges only some frames come back: the best of these.
///
/// # Errors
/// `ambiguous-frame` if that rotation is not unique.
pub(super) fn fitted(grid: &QuadGrid) -> Result<(Vec3, Vec3)> {
    let back = carried_back(grid);
    let axes = [0, 1].map(|d| closing_axis(grid, &back, d));
    nearest(preferred(grid, &back), axes)
        .map_err(|measured| Error::Patch(PatchError::AmbiguousFrame { measured, limit: svd3::UNIQUE }))
}

/// `Aᵀ = A^-1` of each vertex, as the images of the axes.
pub(in crate::surface) fn carried_back(grid: &QuadGrid) -> Vec<[Vec3; 3]> {
    let mut back = vec![[Vec3::X, Vec3::Y, Vec3::Z]; grid.points().len()];
    for Way { before, to, .. } in Way::all(grid) {
        let d = unit(grid.points()[to] - grid.points()[before]);
        // The rows of A: A_new = R A_old, and (R A)ᵀ x = Aᵀ R x; the images of the axes under Aᵀ R.
        let old = back[before];
        back[to] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| apply(old, mirrored(axis, d)));
    }
    back
}

/// The first vertex of a quad, from which frames are carried.
pub(in crate::surface) fn first_vertex(grid: &QuadGrid) -> usize {
    grid.used_vertices().iter().position(|used| *used).unwrap_or(0)
}

/// The signs of `A v1, A v2, A v3` in the frame at a vertex, of a grid of so many columns whose first vertex is `first`.
pub(in crate::surface) fn signs(m: usize, first: usize, vertex: usize) -> [f64; 3] {
    let sign = |steps: usize| if steps.is_multiple_of(2) { 1.0 } else { -1.0 };
    [sign(vertex % m + first % m), sign(vertex / m + first / m), 1.0]
}

/// The sum of the targets of all vertices, carried back to the first one.
pub(in crate::surface) fn preferred(grid: &QuadGrid, back: &[[Vec3; 3]]) -> [Vec3; 3] {
    let m = grid.size()[0];
    let first = first_vertex(grid);
    let mut sum = [Vec3::ZERO; 3];
    for (index, _) in grid.used_vertices().iter().enumerate().filter(|(_, used)| **used) {
        let Some(target) = target(grid, [index % m, index / m]) else { continue };
        let signs = signs(m, first, index);
        for k in 0..3 {
            sum[k] += apply(back[index], target[k]) * signs[k];
        }
    }
    sum
}

/// Frames come back round a closed direction of an odd number of edges only if their vector along it is turned round
/// by the reflections on the way, which together must be one reflection: its axis. Round an even number every frame
/// comes back or none does; `None` stands for that, too.
fn closing_axis(grid: &QuadGrid, back: &[[Vec3; 3]], d: usize) -> Option<Vec3> {
    let size = grid.size()[d];
    if !grid.closed()[d] || size.is_multiple_of(2) {
        return None;
    }
    let last = if d == 0 { (size - 1, 0) } else { (0, size - 1) };
    let edge = unit(grid.point(0, 0) - grid.point(last.0, last.1));
    // I - Hᵀ = 2 d dᵀ for a reflection H: its largest column.
    let column = |axis: Vec3| axis - apply(back[grid.index(last.0, last.1)], mirrored(axis, edge));
    let columns = [Vec3::X, Vec3::Y, Vec3::Z].map(column);
    columns.into_iter().max_by(|x, y| x.length_squared().total_cmp(&y.length_squared())).and_then(Vec3::unit)
}

/// The frame that maximizes the sum of `v_k · sum_k`, of those with the given lines of `v1` and `v2`; what fails to tell it from
/// others, as [`svd3::nearest_rotation`].
fn nearest(sum: [Vec3; 3], axes: [Option<Vec3>; 2]) -> Result<(Vec3, Vec3), f64> {
    let [g1, g2, g3] = sum;
    let across = |x: Vec3, axis: Vec3| (x - axis * x.dot(axis)).unit();
    let both = [1.0, -1.0];
    let candidates: Vec<(Vec3, Vec3)> = match axes {
        [None, None] => return svd3::nearest_rotation(sum).map(|[v1, v2, _]| (v1, v2)),
        // v3·g3 = v2·(g3 × v1) = v1·(v2 × g3)
        [Some(x), None] => both.iter().filter_map(|&k| Some((x * k, across(g2 + g3.cross(x * k), x)?))).collect(),
        [None, Some(y)] => both.iter().filter_map(|&k| Some((across(g1 + (y * k).cross(g3), y)?, y * k))).collect(),
        [Some(x), Some(y)] => {
            let y = across(y, x).ok_or(0.0)?;
            both.iter().flat_map(|&k| both.map(|l| (x * k, y * l))).collect()
        }
    };
    let score = |(v1, v2): (Vec3, Vec3)| v1.dot(g1) + v2.dot(g2) + v1.cross(v2).dot(g3);
    // Without a candidate nothing stands out.
    candidates.into_iter().max_by(|a, b| score(*a).total_cmp(&score(*b))).ok_or(0.0)
}

/// The linear map with the given images of the axes.
pub(in crate::surface) fn apply(images: [Vec3; 3], x: Vec3) -> Vec3 {
    images[0] * x.x + images[1] * x.y + images[2] * x.z
}

/// Reflection in the plane across `d` (unit): `d x d` as quaternions.
fn mirrored(x: Vec3, d: Vec3) -> Vec3 {
    x - d * (2.0 * d.dot(x))
}

/// Orthonormal frame nearest to the directions of the edges at a vertex; `None` if these cancel or are parallel.
fn target(grid: &QuadGrid, [i, j]: [usize; 2]) -> Option<[Vec3; 3]> {
    let at = grid.point(i, j);
    let point = |[i, j]: [usize; 2]| grid.point(i, j);
    // The chord to the next vertex or the one before, and to the one after that.
    let onward = |from: [usize; 2], d: usize, forward: bool| -> Option<[usize; 2]> {
        let (size, mut to) = (grid.size()[d], from);
        let inside = if forward { from[d] + 1 < size } else { from[d] > 0 };
        if !inside && !grid.closed()[d] {
            return None;
        }
        to[d] = if forward { (from[d] + 1) % size } else { (from[d] + size - 1) % size };
        grid.has_edge(if forward { from } else { to }, d).then_some(to)
    };
    let along = |d: usize| {
        let [after, before] = [true, false].map(|forward| onward([i, j], d, forward));
        let reach = |to: [usize; 2]| point(to) - at;
        match (before, after) {
            // The tangent of the circle through three vertices, whatever the lengths of their edges.
            (Some(before), Some(after)) => (inverse(reach(after)) - inverse(reach(before))).unit(),
            (None, Some(next)) => at_end(reach(next), onward(next, d, true).map(reach)),
            (Some(next), None) => at_end(reach(next), onward(next, d, false).map(reach)).map(|tangent| -tangent),
            (None, None) => None,
        }
    };
    let (t1, t2) = (along(0)?, along(1)?);
    let (g, h) = ((t1 + t2).unit()?, (t1 - t2).unit()?);
    let (v1, v2) = ((g + h).unit()?, (g - h).unit()?);
    Some([v1, v2, v1.cross(v2)])
}

/// The point at the end of a chord from the center of inversion.
fn inverse(chord: Vec3) -> Vec3 {
    chord / chord.length_squared()
}

/// The direction at the end of a line towards its next vertex: of the circle through the two next ones, which inverted in the end is a
/// straight line; of the chord if there is one only.
fn at_end(next: Vec3, second: Option<Vec3>) -> Option<Vec3> {
    match second {
        Some(second) => (inverse(next) - inverse(second)).unit(),
        None => next.unit(),
    }
}
