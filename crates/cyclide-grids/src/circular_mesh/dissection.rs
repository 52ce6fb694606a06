//! The order in which the vertices of a grid are eliminated: nested dissection by the indices
//! (`docs/math/circular-meshes.md#factor`).
//!
//! Two neighboring lines part a set of vertices in two that no equation couples. They are eliminated last, the two
//! parts before them in the same way. What couples are vertices at most two steps along grid lines apart, so lines along
//! the diagonals part as well as grid lines do, and a part with four of each has less border than a rectangle as large:
//! half the products that grid lines alone, or an approximate minimum degree, come to.

use cyclide::surface::QuadGrid;

/// Neighboring lines that no equation reaches across: second differences reach two vertices far, and so do, along the
/// diagonals, the diagonals of quads.
const WIDTH: usize = 2;
/// So few vertices are not parted.
const LEAF: usize = 8;
/// What the parts cost against what the lines between them cost, by trial: from 20 to 33 it makes a hundredth of difference.
const PARTS: f64 = 25.0;

/// A vertex by its indices.
type Vertex = [usize; 2];

/// All vertices of the grid in the order of elimination.
pub(super) fn elimination_order(grid: &QuadGrid) -> Vec<usize> {
    let [m, n] = grid.size();
    let mut vertices: Vec<Vertex> = (0..n).flat_map(|j| (0..m).map(move |i| [i, j])).collect();
    // A closed direction is cut open first, by any of its lines.
    let mut cuts = Vec::new();
    for direction in (0..2).filter(|d| grid.closed()[*d]) {
        let (cut, open) = vertices.into_iter().partition(|v| v[direction] < WIDTH);
        cuts.push(cut);
        vertices = open;
    }
    let mut order = Vec::with_capacity(m * n);
    dissect(vertices, &mut order);
    order.extend(cuts.into_iter().rev().flat_map(|cut: Vec<Vertex>| cut));
    order.into_iter().map(|[i, j]| grid.index(i, j)).collect()
}

/// Which line of a family a vertex is on: grid lines in both directions, and both diagonals.
fn line(family: usize, [i, j]: Vertex, size: usize) -> usize {
    match family {
        0 => i,
        1 => j,
        2 => i + j,
        _ => i + size - j,
    }
}

fn dissect(vertices: Vec<Vertex>, order: &mut Vec<Vertex>) {
    let size = vertices.iter().map(|v| v[1]).max().unwrap_or(0);
    let parting = if vertices.len() <= LEAF { None } else { parting(&vertices, size) };
    let Some((family, first)) = parting else { return order.extend(vertices) };
    let (before, rest): (Vec<Vertex>, _) = vertices.into_iter().partition(|v| line(family, *v, size) < first);
    let (between, after): (Vec<Vertex>, _) = rest.into_iter().partition(|v| line(family, *v, size) < first + WIDTH);
    dissect(before, order);
    dissect(after, order);
    order.extend(between);
}

/// The family and the first of the lines that part the vertices at the least cost: the cube of the number of vertices
/// between, which is what it takes to eliminate them, and of both parts the power 3/2 of theirs.
fn parting(vertices: &[Vertex], size: usize) -> Option<(usize, usize)> {
    let mut least = (f64::INFINITY, None);
    for family in 0..4 {
        let lines = || vertices.iter().map(|v| line(family, *v, size));
        let (Some(first), Some(last)) = (lines().min(), lines().max()) else { continue };
        let mut counts = vec![0; last - first + 1];
        lines().for_each(|line| counts[line - first] += 1);
        let mut before = 0;
        for (k, pair) in counts.windows(WIDTH).enumerate() {
            let between: usize = pair.iter().sum();
            let after = vertices.len() - before - between;
            if before > 0 && after > 0 {
                let [a, b, c] = [before, between, after].map(|count| count as f64);
                let cost = b * b * b + PARTS * (a * a.sqrt() + c * c.sqrt());
                if cost < least.0 {
                    least = (cost, Some((family, first + k)));
                }
            }
            before += counts[k];
        }
    }
    least.1
}

#[cfg(test)]
mod tests {
    use super::*;
    use cyclide::Point3;

    /// The numbers in the factor of a matrix with one unknown for each vertex, by elimination as it is written.
    fn filled(grid: &QuadGrid, order: &[usize]) -> usize {
        let [m, n] = grid.size();
        let mut coupled = vec![std::collections::BTreeSet::new(); m * n];
        let reach: [[usize; 2]; 6] = [[1, 0], [2, 0], [0, 1], [0, 2], [1, 1], [1, m * n - 1]];
        for (i, j) in (0..n).flat_map(|j| (0..m).map(move |i| (i, j))) {
            for [di, dj] in reach {
                // m n - 1 places on are one back where the direction is closed; where it is open that is written out.
                let back = dj > n;
                let (k, l) = (i + di, if back { j.wrapping_sub(1) } else { j + dj });
                let inside = |d: usize, at: usize| at < grid.size()[d] || grid.closed()[d];
                if inside(0, k) && inside(1, l) {
                    let l = if l == usize::MAX { n - 1 } else { l };
                    let (a, b) = (grid.index(i, j), grid.index(k % m, l % n));
                    coupled[a].insert(b);
                    coupled[b].insert(a);
                }
            }
        }
        let mut count = 0;
        for &v in order {
            let later = std::mem::take(&mut coupled[v]);
            count += 1 + later.len();
            for &a in &later {
                coupled[a].remove(&v);
                coupled[a].extend(later.iter().filter(|b| **b != a));
            }
        }
        count
    }

    fn grid(size: [usize; 2], closed: [bool; 2]) -> QuadGrid {
        let points = (0..size[0] * size[1]).map(|k| Point3::new((k % size[0]) as f64, (k / size[0]) as f64, 0.0));
        QuadGrid::new(points.collect(), size, closed).unwrap()
    }

    #[test]
    fn every_vertex_is_eliminated_once() {
        for (size, closed) in [
            ([2, 2], [false; 2]),
            ([3, 4], [true; 2]),
            ([4, 3], [true, false]),
            ([31, 2], [false; 2]),
            ([17, 23], [false, true]),
        ] {
            let mut order = elimination_order(&grid(size, closed));
            order.sort_unstable();
            assert_eq!(order, (0..size[0] * size[1]).collect::<Vec<_>>(), "{size:?} {closed:?}");
        }
    }

    #[test]
    fn factors_stay_sparse() {
        // Row by row each vertex couples two rows: 80 numbers. By dissection it is 31 n log2 n / 4 of it at 40 by 40, where
        // lines along the grid alone come to half as much again; closed directions cost their cuts.
        for (closed, limit) in [([false; 2], 45), ([true, false], 60), ([true; 2], 80)] {
            let grid = grid([40, 40], closed);
            let rows: Vec<usize> = (0..1600).collect();
            let (dissected, by_rows) = (filled(&grid, &elimination_order(&grid)), filled(&grid, &rows));
            assert!(dissected < limit * 1600 && dissected < by_rows, "{closed:?}: {dissected}, {by_rows} by rows");
        }
    }
}
