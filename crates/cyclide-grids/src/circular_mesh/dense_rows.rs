//! A sparse system with a few rows that touch many vertices beside it: `(K + C^T C) x = b - C^T c` by solves with the
//! factor of K alone,
//!
//! ```text
//! mu = (I + C K^-1 C^T)^-1 (C K^-1 b + c),   x = K^-1 (b - C^T mu)
//! ```
//!
//! (`docs/math/circular-meshes.md#closed-grids`). In the pattern of K the rows would fill its factor.

use super::block::Block;
use super::normal_equations::Factored;
use cyclide::Vec3;
use faer::Mat;
use faer::prelude::Solve;

/// A row: vertices, some of them more than once, with their entries.
pub(super) type SparseRow = Vec<(usize, Vec3)>;

/// So many right sides are solved at once, which bounds the memory.
const AT_ONCE: usize = 32;

/// The solution for moves in the ranges of `projectors`, which K has been restricted to; not finite where rounding has
/// eaten the small system.
pub(super) fn solve(
    factored: &Factored<'_>,
    projectors: &[Block],
    rows: &[SparseRow],
    c: &[f64],
    b: &[Vec3],
) -> Vec<Vec3> {
    let mut first = restricted(projectors, b);
    factored.solve(&mut first);
    if rows.is_empty() {
        return vectors(&first);
    }
    let project = |row: &SparseRow| row.iter().map(|&(v, g)| (v, projectors[v].apply(g))).collect();
    let rows: Vec<SparseRow> = rows.iter().map(project).collect();
    let mut small = Mat::<f64>::identity(rows.len(), rows.len());
    for from in (0..rows.len()).step_by(AT_ONCE) {
        let group = &rows[from..rows.len().min(from + AT_ONCE)];
        let mut columns = vec![0.0; group.len() * first.len()];
        for (row, column) in group.iter().zip(columns.chunks_exact_mut(first.len())) {
            add(column, row, 1.0);
        }
        factored.solve(&mut columns);
        for (k, column) in columns.chunks_exact(first.len()).enumerate() {
            for (i, row) in rows.iter().enumerate() {
                small[(i, from + k)] += product(row, column);
            }
        }
    }
    let mut mu = Mat::from_fn(rows.len(), 1, |i, _| product(&rows[i], &first) + c[i]);
    small.partial_piv_lu().solve_in_place(&mut mu);
    let mut x = restricted(projectors, b);
    for (i, row) in rows.iter().enumerate() {
        add(&mut x, row, -mu[(i, 0)]);
    }
    factored.solve(&mut x);
    vectors(&x)
}

fn restricted(projectors: &[Block], b: &[Vec3]) -> Vec<f64> {
    b.iter().zip(projectors).flat_map(|(b, p)| p.apply(*b).to_array()).collect()
}

fn vectors(x: &[f64]) -> Vec<Vec3> {
    x.chunks_exact(3).map(|c| Vec3::new(c[0], c[1], c[2])).collect()
}

fn product(row: &SparseRow, x: &[f64]) -> f64 {
    row.iter().map(|&(v, g)| g.dot(Vec3::new(x[3 * v], x[3 * v + 1], x[3 * v + 2]))).sum()
}

fn add(x: &mut [f64], row: &SparseRow, factor: f64) {
    for &(v, g) in row {
        for k in 0..3 {
            x[3 * v + k] += factor * g[k];
        }
    }
}
