//! The damped normal equations `(J^T J + lambda M) dx = -J^T r` in blocks of one vertex by another, and their
//! restriction to the moves that border vertices may make.
//!
//! The pattern never changes, so faer analyses it once, in an order of elimination that it is given; each step is one sparse
//! Cholesky factorization into the memory of the last one. Everything runs on one thread in a fixed order.

use super::block::Block;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::perm::PermRef;
use faer::sparse::linalg::cholesky::{LltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::{Conj, MatMut, Par, Side};

/// A symmetric matrix of blocks: its lower triangle, column by column.
pub(super) struct BlockMatrix {
    blocks: Vec<Block>,
}

/// Where the blocks are not zero, and what is known of the factor from that alone.
pub(super) struct Pattern {
    /// Blocks of the column of vertex `v`: `first[v]..first[v + 1]`.
    first: Vec<usize>,
    /// The vertex of each block's row, ascending in its column; the first is the diagonal.
    row: Vec<usize>,
    /// The lower triangle by coordinates: 3 rows and 3 columns for each vertex.
    coordinates: SymbolicSparseColMat<usize>,
    factor: SymbolicCholesky<usize>,
}

/// Memory of a factor and of what it takes to make it, used again from step to step: of large grids half a gigabyte,
/// which takes as long to get as a tenth of the factorization.
pub(super) struct Workspace {
    values: Vec<f64>,
    factor: Vec<f64>,
    scratch: MemBuffer,
}

impl Pattern {
    /// Pattern of a sum of squares whose terms each couple a few vertices, which are eliminated in an order that has each of
    /// them once (faer's approximate minimum degree if there is none); `None` if there is no memory for its factor.
    pub(super) fn new<'a>(
        vertices: usize,
        elimination: Option<&[usize]>,
        terms: impl Iterator<Item = &'a [usize]>,
    ) -> Option<Self> {
        let mut columns: Vec<Vec<usize>> = (0..vertices).map(|v| vec![v]).collect();
        for term in terms {
            for &v in term {
                columns[v].extend(term.iter().filter(|row| **row > v));
            }
        }
        let (mut first, mut row) = (vec![0], Vec::new());
        let (mut starts, mut indices) = (vec![0], Vec::new());
        for rows in &mut columns {
            rows.sort_unstable();
            rows.dedup();
            for coordinate in 0..3 {
                let entries = rows.iter().flat_map(|v| (0..3).map(move |k| 3 * v + k));
                indices.extend(entries.skip(coordinate));
                starts.push(indices.len());
            }
            row.append(rows);
            first.push(row.len());
        }
        let size = 3 * vertices;
        let coordinates = SymbolicSparseColMat::new_checked(size, size, starts, None, indices);
        let coordinates_of = |v: &usize| [3 * v, 3 * v + 1, 3 * v + 2];
        let eliminated: Vec<usize> = elimination.unwrap_or_default().iter().flat_map(coordinates_of).collect();
        let mut places = vec![0; eliminated.len()];
        eliminated.iter().enumerate().for_each(|(place, coordinate)| places[*coordinate] = place);
        let order = match elimination {
            Some(_) => SymmetricOrdering::Custom(PermRef::new_checked(&eliminated, &places, size)),
            None => SymmetricOrdering::Amd,
        };
        let factor = factorize_symbolic_cholesky(coordinates.as_ref(), Side::Lower, order, Default::default()).ok()?;
        Some(Self { first, row, coordinates, factor })
    }

    /// `None` if there is no memory for it.
    pub(super) fn workspace(&self) -> Option<Workspace> {
        let mut factor = Vec::new();
        factor.try_reserve_exact(self.factor.len_val()).ok()?;
        factor.resize(self.factor.len_val(), 0.0);
        let needed = self.factor.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        Some(Workspace { values: Vec::new(), factor, scratch: MemBuffer::try_new(needed).ok()? })
    }

    pub(super) fn zero(&self) -> BlockMatrix {
        BlockMatrix { blocks: vec![Block::ZERO; self.row.len()] }
    }

    /// Adds a block and, if it is not on the diagonal, its transpose at the mirrored place.
    pub(super) fn add(&self, matrix: &mut BlockMatrix, u: usize, v: usize, block: Block) {
        let (row, column, block) = if u >= v { (u, v, block) } else { (v, u, block.transposed()) };
        let (from, to) = (self.first[column], self.first[column + 1]);
        if let Ok(k) = self.row[from..to].binary_search(&row) {
            matrix.blocks[from + k] += block;
        }
    }

    /// The factor of `a + lambda b` restricted to moves in the ranges of `projectors` (one for each vertex); `None` if
    /// the matrix is not positive definite in doubles.
    ///
    /// It is that of `P (a + lambda b) P + (I - P)` times the size of the diagonal, which keeps the pattern: right
    /// sides in the ranges have their solutions there.
    pub(super) fn factored<'a>(
        &'a self,
        workspace: &'a mut Workspace,
        (a, b, lambda): (&BlockMatrix, &BlockMatrix, f64),
        projectors: &[Block],
    ) -> Option<Factored<'a>> {
        let restricted = |k: usize, column: usize| {
            let block = a.blocks[k] + b.blocks[k] * lambda;
            let (row, q) = (self.row[k], projectors[column]);
            let held = if row == column { (Block::IDENTITY - q) * block.trace() } else { Block::ZERO };
            projectors[row] * block * q + held
        };
        let Workspace { values, factor, scratch } = workspace;
        values.clear();
        values.reserve(self.coordinates.row_idx().len());
        let mut blocks = Vec::new();
        for v in 0..projectors.len() {
            blocks.clear();
            blocks.extend((self.first[v]..self.first[v + 1]).map(|k| restricted(k, v)));
            for column in 0..3 {
                values.extend(blocks.iter().flat_map(|block| block.column(column)).skip(column));
            }
        }
        let matrix = SparseColMatRef::new(self.coordinates.as_ref(), values);
        let (regularization, stack) = (Default::default(), MemStack::new(scratch));
        self.factor
            .factorize_numeric_llt(factor, matrix, Side::Lower, regularization, Par::Seq, stack, Default::default())
            .ok()?;
        Some(Factored { factor: LltRef::new(&self.factor, factor), size: 3 * projectors.len() })
    }
}

/// A matrix that can be solved with.
pub(super) struct Factored<'a> {
    factor: LltRef<'a, usize, f64>,
    size: usize,
}

impl Factored<'_> {
    /// Replaces right sides, one after the other, by their solutions.
    pub(super) fn solve(&self, columns: &mut [f64]) {
        let count = columns.len() / self.size;
        let mut scratch = MemBuffer::new(self.factor.symbolic().solve_in_place_scratch::<f64>(count, Par::Seq));
        let columns = MatMut::from_column_major_slice_mut(columns, self.size, count);
        self.factor.solve_in_place_with_conj(Conj::No, columns, Par::Seq, MemStack::new(&mut scratch));
    }
}

#[cfg(test)]
mod tests {
    use super::super::dense_rows::{SparseRow, solve};
    use super::*;
    use cyclide::Vec3;

    /// A ring of six vertices with a chord: eliminating any of them couples its neighbors.
    const PAIRS: [[usize; 2]; 7] = [[1, 0], [2, 1], [3, 2], [4, 3], [5, 4], [0, 5], [4, 1]];

    fn off_diagonal() -> Block {
        Block::from_columns([Vec3::new(1.0, -0.5, 0.25), Vec3::new(0.0, 0.5, 1.0), Vec3::new(-1.0, 0.25, 0.5)])
    }

    fn diagonal() -> Block {
        Block::IDENTITY * 8.0 + Block::square(Vec3::new(1.0, 2.0, -1.0))
    }

    fn product(x: &[Vec3]) -> Vec<Vec3> {
        let mut y: Vec<Vec3> = x.iter().map(|x| diagonal().apply(*x)).collect();
        for [row, column] in PAIRS {
            y[row] += off_diagonal().apply(x[column]);
            y[column] += off_diagonal().transposed().apply(x[row]);
        }
        y
    }

    /// The solution with one matrix alone.
    fn solved(pattern: &Pattern, a: &BlockMatrix, projectors: &[Block], y: &[Vec3]) -> Vec<Vec3> {
        with_rows(pattern, a, projectors, (&[], &[]), y)
    }

    fn with_rows(
        pattern: &Pattern,
        a: &BlockMatrix,
        projectors: &[Block],
        (rows, c): (&[SparseRow], &[f64]),
        y: &[Vec3],
    ) -> Vec<Vec3> {
        let mut workspace = pattern.workspace().unwrap();
        let factored = pattern.factored(&mut workspace, (a, &pattern.zero(), 0.0), projectors).unwrap();
        solve(&factored, projectors, rows, c, y)
    }

    fn matrix(pattern: &Pattern) -> BlockMatrix {
        let mut matrix = pattern.zero();
        (0..6).for_each(|v| pattern.add(&mut matrix, v, v, diagonal()));
        PAIRS.iter().for_each(|[row, column]| pattern.add(&mut matrix, *row, *column, off_diagonal()));
        matrix
    }

    #[test]
    fn solves_a_matrix_that_fills_in() {
        let pattern = Pattern::new(6, Some(&[3, 0, 5, 1, 4, 2]), PAIRS.iter().map(|p| &p[..])).unwrap();
        let x: Vec<Vec3> = (0..6).map(|k| Vec3::new(k as f64, 1.0, -2.0 * k as f64)).collect();
        let a = matrix(&pattern);
        let solved = solved(&pattern, &a, &[Block::IDENTITY; 6], &product(&x));
        // Condition below 10, values up to 10.
        assert!(x.iter().zip(&solved).all(|(x, y)| (*x - *y).length() < 1e-13));
        let mut b = pattern.zero();
        pattern.add(&mut b, 3, 3, diagonal() * -1.0);
        let mut workspace = pattern.workspace().unwrap();
        assert!(pattern.factored(&mut workspace, (&a, &b, 2.0), &[Block::IDENTITY; 6]).is_none());
    }

    #[test]
    fn moves_stay_in_the_ranges_of_the_projectors() {
        let pattern = Pattern::new(6, Some(&[3, 0, 5, 1, 4, 2]), PAIRS.iter().map(|p| &p[..])).unwrap();
        let along = Vec3::new(0.6, 0.0, 0.8);
        let mut projectors = [Block::IDENTITY; 6];
        (projectors[0], projectors[3]) = (Block::ZERO, Block::square(along));
        let y: Vec<Vec3> = (0..6).map(|k| Vec3::new(1.0, k as f64, -1.0)).collect();
        let a = matrix(&pattern);
        let x = solved(&pattern, &a, &projectors, &y);
        // Values up to 1, condition below 10.
        assert!(x[0].length() < 1e-14 && x[3].cross(along).length() < 1e-14);
        // What is left of the equations is perpendicular to every move that is allowed.
        let left = product(&x).into_iter().zip(&y).zip(projectors).map(|((p, y), q)| q.apply(p - *y).length());
        assert!(left.fold(0.0, f64::max) < 1e-13);
    }
    #[test]
    fn dense_rows_add_their_squares() {
        let pattern = Pattern::new(6, Some(&[3, 0, 5, 1, 4, 2]), PAIRS.iter().map(|p| &p[..])).unwrap();
        let a = matrix(&pattern);
        // More rows than are solved at once; the last one names a vertex twice.
        let row = |k: usize| (0..6).map(|v| (v, Vec3::new((k + v) as f64 % 5.0, (k * v) as f64 % 3.0, 1.0))).collect();
        let mut rows: Vec<SparseRow> = (0..20).map(row).collect();
        rows.push(vec![(2, Vec3::X), (2, Vec3::Y), (5, Vec3::Z)]);
        let along = Vec3::new(0.6, 0.0, 0.8);
        let mut projectors = [Block::IDENTITY; 6];
        (projectors[1], projectors[4]) = (Block::ZERO, Block::square(along));
        let c: Vec<f64> = (0..21).map(|k| 0.3 * k as f64 - 2.0).collect();
        let b: Vec<Vec3> = (0..6).map(|k| Vec3::new(1.0, k as f64, -1.0)).collect();
        let x = with_rows(&pattern, &a, &projectors, (&rows, &c), &b);
        assert!(x[1].length() < 1e-14 && x[4].cross(along).length() < 1e-14);
        // K x + C^T (C x + c) - b, of which nothing is left along the moves that are allowed.
        let mut left: Vec<Vec3> = product(&x).into_iter().zip(&b).map(|(p, b)| p - *b).collect();
        for (row, c) in rows.iter().zip(&c) {
            let value = c + row.iter().map(|&(v, g)| g.dot(x[v])).sum::<f64>();
            row.iter().for_each(|&(v, g)| left[v] += g * value);
        }
        let left = left.into_iter().zip(projectors).map(|(l, q)| q.apply(l).length());
        // Sums of 21 products up to 100, condition below 1000.
        assert!(left.fold(0.0, f64::max) < 1e-11);
    }
}
