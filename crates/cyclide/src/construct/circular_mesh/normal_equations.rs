//! The damped normal equations `(J^T J + lambda M) dx = -J^T r` in blocks of one vertex by another, and their
//! restriction to the moves that border vertices may make.
//!
//! The pattern never changes, so it is ordered and analysed once. Everything runs on one thread in a fixed order.

use super::block::Block;
use super::cholesky::FactorPattern;
use super::dissection;
use crate::base::vector::Vec3;
use crate::surface::QuadGrid;

/// A symmetric matrix of blocks: its lower triangle in the order of elimination, at the places of the factor.
pub(super) struct BlockMatrix {
    blocks: Vec<Block>,
}

/// Where the blocks are not zero, and the order of elimination.
pub(super) struct Pattern {
    factor: FactorPattern,
    /// Place of each vertex in the order.
    place: Vec<usize>,
}

impl Pattern {
    /// Pattern of a sum of squares whose terms each couple a few vertices of the grid.
    pub(super) fn new<'a>(grid: &QuadGrid, terms: impl Iterator<Item = &'a [usize]>) -> Self {
        let order = dissection::order(grid);
        let mut place = vec![0; order.len()];
        order.iter().enumerate().for_each(|(k, &v)| place[v] = k);
        let mut columns: Vec<Vec<usize>> = (0..order.len()).map(|k| vec![k]).collect();
        for term in terms {
            for k in term.iter().map(|v| place[*v]) {
                columns[k].extend(term.iter().map(|v| place[*v]).filter(|row| *row > k));
            }
        }
        Self { factor: FactorPattern::new(columns), place }
    }

    pub(super) fn zero(&self) -> BlockMatrix {
        BlockMatrix { blocks: vec![Block::ZERO; self.factor.len()] }
    }

    /// Adds a block and, if it is not on the diagonal, its transpose at the mirrored place.
    pub(super) fn add(&self, matrix: &mut BlockMatrix, u: usize, v: usize, block: Block) {
        let (row, column) = (self.place[u], self.place[v]);
        let (row, column, block) = if row >= column { (row, column, block) } else { (column, row, block.transposed()) };
        if let Some(k) = self.factor.position(row, column) {
            matrix.blocks[k] += block;
        }
    }

    /// Solves `(a + lambda b) x = y` for x in the product of the ranges of `projectors` (one for each vertex); `None`
    /// if the matrix is not positive definite in doubles.
    ///
    /// The matrix solved is `P (a + lambda b) P + (I - P)` times the size of the diagonal: it keeps the pattern.
    pub(super) fn solve(
        &self,
        (a, b, lambda): (&BlockMatrix, &BlockMatrix, f64),
        projectors: &[Block],
        y: &[Vec3],
    ) -> Option<Vec<Vec3>> {
        let mut right = vec![Vec3::ZERO; y.len()];
        let mut ordered = vec![Block::IDENTITY; y.len()];
        for (v, &k) in self.place.iter().enumerate() {
            right[k] = projectors[v].apply(y[v]);
            ordered[k] = projectors[v];
        }
        let restricted = |(k, row, column): (usize, usize, usize)| {
            let block = a.blocks[k] + b.blocks[k] * lambda;
            let (p, q) = (ordered[row], ordered[column]);
            if p == Block::IDENTITY && q == Block::IDENTITY {
                return block;
            }
            let held = if row == column { (Block::IDENTITY - p) * block.trace() } else { Block::ZERO };
            p * block * q + held
        };
        self.factor.factor(self.factor.places().map(restricted).collect())?.solve(&mut right);
        Some(self.place.iter().map(|&k| right[k]).collect())
    }
}
