//! Sparse symmetric positive definite systems of scalars: one Cholesky factor (faer), any number of right sides. On one
//! thread in a fixed order, so that the same system has the same solution in every run.

use faer::prelude::Solve;
use faer::sparse::linalg::solvers::{Llt, SymbolicLlt};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::{MatMut, Side};

/// A symmetric matrix as a sum of entries: each pair once, in any order.
#[derive(Debug, Default)]
pub(super) struct SymmetricSum {
    size: usize,
    /// Column, row (at or below the diagonal), value.
    entries: Vec<(usize, usize, f64)>,
}

/// Its Cholesky factor.
pub(super) struct SparseFactor {
    size: usize,
    factor: Llt<usize, f64>,
}

impl SymmetricSum {
    pub(super) fn new(size: usize) -> Self {
        Self { size, entries: Vec::new() }
    }

    /// Adds to an entry and its mirror image.
    pub(super) fn add(&mut self, u: usize, v: usize, value: f64) {
        self.entries.push((u.min(v), u.max(v), value));
    }

    /// The mean of the diagonal.
    pub(super) fn mean_diagonal(&self) -> f64 {
        let diagonal = self.entries.iter().filter(|(u, v, _)| u == v);
        diagonal.map(|(_, _, value)| value).sum::<f64>() / self.size.max(1) as f64
    }

    /// Adds the square of a weighted sum of unknowns.
    pub(super) fn add_square(&mut self, terms: &[(usize, f64)], weight: f64) {
        for (k, (u, a)) in terms.iter().enumerate() {
            for (l, (v, b)) in terms[..=k].iter().enumerate() {
                // A pair of different terms stands twice in the square, and so it does in the matrix, unless both name the same
                // unknown.
                let twice = if u == v && k != l { 2.0 } else { 1.0 };
                self.add(*u, *v, weight * twice * a * b);
            }
        }
    }

    /// The factor; `None` if the matrix is not positive definite in doubles, or there is no memory.
    pub(super) fn factor(mut self) -> Option<SparseFactor> {
        // Stable: sums are taken in the order in which they were given.
        self.entries.sort_by_key(|(column, row, _)| (*column, *row));
        let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::<f64>::new());
        let mut entries = self.entries.iter().peekable();
        for column in 0..self.size {
            let from = rows.len();
            while let Some((_, row, value)) = entries.next_if(|(c, _, _)| *c == column) {
                match values.last_mut() {
                    Some(last) if rows.len() > from && rows.last() == Some(row) => *last += value,
                    _ => {
                        rows.push(*row);
                        values.push(*value);
                    }
                }
            }
            starts.push(rows.len());
        }
        let pattern = SymbolicSparseColMat::new_checked(self.size, self.size, starts, None, rows);
        let symbolic = SymbolicLlt::try_new(pattern.as_ref(), Side::Lower).ok()?;
        let matrix = SparseColMatRef::new(pattern.as_ref(), &values);
        let factor = Llt::try_new_with_symbolic(symbolic, matrix, Side::Lower).ok()?;
        Some(SparseFactor { size: self.size, factor })
    }
}

impl SparseFactor {
    /// Solves for several right sides, one after the other in `columns`; `None` if a result is not finite.
    pub(super) fn solve(&self, columns: &mut [f64]) -> Option<()> {
        let count = columns.len().checked_div(self.size).unwrap_or(0);
        self.factor.solve_in_place(MatMut::from_column_major_slice_mut(columns, self.size, count));
        columns.iter().all(|x| x.is_finite()).then_some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_are_summed_and_solved() {
        // (x - y)^2 + (2 y - x - x)^2 + (y + z)^2 + z^2 at x = 1, y = 2, z = -1, with an unknown that stands twice.
        let terms =
            [vec![(0, 1.0), (1, -1.0)], vec![(1, 2.0), (0, -1.0), (0, -1.0)], vec![(1, 1.0), (2, 1.0)], vec![(2, 1.0)]];
        let wanted = [1.0, 2.0, -1.0];
        let mut sum = SymmetricSum::new(3);
        let mut right = [0.0; 3];
        for terms in &terms {
            sum.add_square(terms, 0.5);
            let value: f64 = terms.iter().map(|(k, a)| a * wanted[*k]).sum();
            terms.iter().for_each(|(k, a)| right[*k] += 0.5 * a * value);
        }
        sum.add(0, 0, 1.0);
        right[0] += wanted[0];
        let factor = sum.factor().unwrap();
        factor.solve(&mut right).unwrap();
        // Condition below 100.
        assert!(right.iter().zip(wanted).all(|(x, y)| (x - y).abs() < 1e-13), "{right:?}");
        let mut negative = SymmetricSum::new(1);
        negative.add(0, 0, -1.0);
        assert!(negative.factor().is_none());
    }
}
