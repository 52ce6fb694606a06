//! Sparse Cholesky factorisation in blocks of three by three.
//!
//! The pattern of the factor is found once, column by column: a column has the rows of the matrix and those of the
//! columns whose first row below the diagonal it is (its children in the elimination tree; Davis, Direct Methods for
//! Sparse Linear Systems, chapter 4). Each numeric factorisation is right-looking: a finished column updates the
//! columns of its rows.

use super::block::Block;
use crate::base::vector::Vec3;

/// Where the factor is not zero: the rows of each column, ascending, the diagonal first.
pub(super) struct FactorPattern {
    first: Vec<usize>,
    row: Vec<usize>,
}

/// A lower triangular factor.
pub(super) struct Factor<'a> {
    pattern: &'a FactorPattern,
    blocks: Vec<Block>,
}

impl FactorPattern {
    /// From the rows of each column of the lower triangle of the matrix, diagonal included.
    pub(super) fn new(mut columns: Vec<Vec<usize>>) -> Self {
        let (mut first, mut row) = (vec![0], Vec::new());
        for k in 0..columns.len() {
            let mut rows = std::mem::take(&mut columns[k]);
            rows.sort_unstable();
            rows.dedup();
            if let Some(&parent) = rows.get(1) {
                columns[parent].extend(&rows[1..]);
            }
            row.extend(rows);
            first.push(row.len());
        }
        Self { first, row }
    }

    /// Number of blocks of the factor.
    pub(super) fn len(&self) -> usize {
        self.row.len()
    }

    /// Place of a block of the lower triangle among the blocks.
    pub(super) fn position(&self, row: usize, column: usize) -> Option<usize> {
        let (from, to) = (self.first[column], self.first[column + 1]);
        self.row[from..to].binary_search(&row).ok().map(|k| from + k)
    }

    /// Place, row and column of each block, in their order.
    pub(super) fn places(&self) -> impl Iterator<Item = (usize, usize, usize)> {
        let columns = self.first.windows(2).enumerate();
        columns.flat_map(move |(column, range)| (range[0]..range[1]).map(move |k| (k, self.row[k], column)))
    }

    /// Factor of a symmetric matrix given by the blocks of its lower triangle (zeros where only the factor has
    /// blocks); `None` if it is not positive definite in doubles.
    pub(super) fn factor(&self, mut blocks: Vec<Block>) -> Option<Factor<'_>> {
        for k in 0..self.first.len() - 1 {
            let (from, to) = (self.first[k], self.first[k + 1]);
            let diagonal = blocks[from].cholesky()?;
            blocks[from] = diagonal;
            let (column, later) = blocks.split_at_mut(to);
            let column = &mut column[from..];
            for block in &mut column[1..] {
                *block = block.solved_right(diagonal);
            }
            let rows = &self.row[from..to];
            for (j, &target) in rows.iter().enumerate().skip(1) {
                let transposed = column[j].transposed();
                let mut place = self.first[target];
                for (i, &row) in rows.iter().enumerate().skip(j) {
                    // The rows of this column are among those of the target column, in the same order.
                    while self.row[place] != row {
                        place += 1;
                    }
                    later[place - to].subtract_product(&column[i], &transposed);
                }
            }
        }
        Some(Factor { pattern: self, blocks })
    }
}

impl Factor<'_> {
    /// Solves `L L^T x = y` in place.
    pub(super) fn solve(&self, x: &mut [Vec3]) {
        let FactorPattern { first, row } = self.pattern;
        for k in 0..x.len() {
            x[k] = self.blocks[first[k]].solved_lower(x[k]);
            for place in first[k] + 1..first[k + 1] {
                let update = self.blocks[place].apply(x[k]);
                x[row[place]] -= update;
            }
        }
        for k in (0..x.len()).rev() {
            for place in first[k] + 1..first[k + 1] {
                let update = self.blocks[place].transposed().apply(x[row[place]]);
                x[k] -= update;
            }
            x[k] = self.blocks[first[k]].solved_upper(x[k]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_a_matrix_that_fills_in() {
        // A ring of six vertices with a chord: eliminating any of them couples its neighbours.
        let pairs = [(1, 0), (2, 1), (3, 2), (4, 3), (5, 4), (5, 0), (4, 1)];
        let mut columns: Vec<Vec<usize>> = (0..6).map(|k| vec![k]).collect();
        pairs.iter().for_each(|(row, column)| columns[*column].push(*row));
        let pattern = FactorPattern::new(columns);
        assert!(pattern.len() > 13, "{}", pattern.len());
        let off =
            Block::from_columns([Vec3::new(1.0, -0.5, 0.25), Vec3::new(0.0, 0.5, 1.0), Vec3::new(-1.0, 0.25, 0.5)]);
        let diagonal = Block::IDENTITY * 8.0 + Block::square(Vec3::new(1.0, 2.0, -1.0));
        let mut blocks = vec![Block::ZERO; pattern.len()];
        (0..6).for_each(|k| blocks[pattern.position(k, k).unwrap()] = diagonal);
        pairs.iter().for_each(|(row, column)| blocks[pattern.position(*row, *column).unwrap()] = off);
        let x: Vec<Vec3> = (0..6).map(|k| Vec3::new(k as f64, 1.0, -2.0 * k as f64)).collect();
        let mut y: Vec<Vec3> = x.iter().map(|x| diagonal.apply(*x)).collect();
        for (row, column) in pairs {
            y[row] += off.apply(x[column]);
            y[column] += off.transposed().apply(x[row]);
        }
        pattern.factor(blocks.clone()).unwrap().solve(&mut y);
        // Condition below 10, values up to 10.
        assert!(x.iter().zip(&y).all(|(x, y)| (*x - *y).length() < 1e-13));
        blocks[pattern.position(3, 3).unwrap()] = diagonal * -1.0;
        assert!(pattern.factor(blocks).is_none());
    }
}
