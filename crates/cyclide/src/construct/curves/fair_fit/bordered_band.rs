//! Cholesky factors of banded matrices whose last rows may be full: the matrices of splines and smoothers on a line
//! of unknowns, and on a ring of them, where the last unknowns are neighbours of the first.

/// A symmetric positive definite matrix. Row `i` of the banded part holds the `N` columns up to the diagonal, so the
/// half bandwidth is `N - 1`; the rows of the border are full.
#[derive(Debug, Clone)]
pub(super) struct BorderedBand<const N: usize> {
    band: Vec<[f64; N]>,
    /// One row of `size` columns for each of the last unknowns.
    border: Vec<Vec<f64>>,
}

impl<const N: usize> BorderedBand<N> {
    /// The zero matrix of a line of unknowns, or of a ring.
    pub fn zero(size: usize, ring: bool) -> Self {
        let border = if ring { size.min(N - 1) } else { 0 };
        Self { band: vec![[0.0; N]; size - border], border: vec![vec![0.0; size]; border] }
    }

    /// Makes the matrix equal to another of the same shape without allocating.
    pub fn copy_from(&mut self, other: &Self) {
        self.band.clone_from(&other.band);
        self.border.clone_from(&other.border);
    }

    /// Multiplies all entries.
    pub fn scale(&mut self, factor: f64) {
        self.band.iter_mut().flatten().chain(self.border.iter_mut().flatten()).for_each(|x| *x *= factor);
    }

    /// The entry of two unknowns that are neighbours; each pair has one entry, in either order.
    pub fn entry(&mut self, i: usize, j: usize) -> &mut f64 {
        let (row, column) = if i < j { (j, i) } else { (i, j) };
        let inner = self.band.len();
        if row < inner { &mut self.band[row][column + N - 1 - row] } else { &mut self.border[row - inner][column] }
    }

    /// Adds the product with `x` to `sum`; not for a factor.
    pub fn multiply_add(&self, x: &[f64], sum: &mut [f64]) {
        let inner = self.band.len();
        for (i, row) in self.band.iter().enumerate() {
            let from = i.saturating_sub(N - 1);
            for (j, a) in (from..i).zip(&row[N - 1 - (i - from)..]) {
                sum[i] += a * x[j];
                sum[j] += a * x[i];
            }
            sum[i] += row[N - 1] * x[i];
        }
        for (b, row) in self.border.iter().enumerate() {
            let i = inner + b;
            for (j, a) in row[..i].iter().enumerate() {
                sum[i] += a * x[j];
                sum[j] += a * x[i];
            }
            sum[i] += row[i] * x[i];
        }
    }

    /// Replaces the matrix by its Cholesky factor; false if it is not positive definite.
    pub fn factor(&mut self) -> bool {
        let inner = self.band.len();
        for i in 0..inner {
            let (before, rest) = self.band.split_at_mut(i);
            let row = &mut rest[0];
            for c in (N - 1).saturating_sub(i)..N - 1 {
                let j = i + c + 1 - N;
                let other = &before[j];
                // Columns of row j start N - 1 - c places later than those of row i.
                let shift = N - 1 - c;
                let sum: f64 = (0..c).map(|k| row[k] * other[k + shift]).sum();
                row[c] = (row[c] - sum) * other[N - 1];
            }
            let pivot = row[N - 1] - row[..N - 1].iter().map(|x| x * x).sum::<f64>();
            if !(pivot > 0.0 && pivot.is_finite()) {
                return false;
            }
            // The reciprocal of the diagonal is what every use divides by.
            row[N - 1] = 1.0 / pivot.sqrt();
        }
        for b in 0..self.border.len() {
            let (before, rest) = self.border.split_at_mut(b);
            let row = &mut rest[0];
            for j in 0..inner {
                let from = j.saturating_sub(N - 1);
                let other = &self.band[j][N - 1 - (j - from)..N - 1];
                let sum: f64 = row[from..j].iter().zip(other).map(|(x, y)| x * y).sum();
                row[j] = (row[j] - sum) * self.band[j][N - 1];
            }
            for (a, other) in before.iter().enumerate() {
                let j = inner + a;
                let sum: f64 = row[..j].iter().zip(other).map(|(x, y)| x * y).sum();
                row[j] = (row[j] - sum) * other[j];
            }
            let i = inner + b;
            let pivot = row[i] - row[..i].iter().map(|x| x * x).sum::<f64>();
            if !(pivot > 0.0 && pivot.is_finite()) {
                return false;
            }
            row[i] = 1.0 / pivot.sqrt();
        }
        true
    }

    /// Solves with the factor, in place.
    pub fn solve(&self, x: &mut [f64]) {
        let inner = self.band.len();
        for i in 0..inner {
            let from = i.saturating_sub(N - 1);
            let row = &self.band[i];
            let sum: f64 = x[from..i].iter().zip(&row[N - 1 - (i - from)..N - 1]).map(|(x, y)| x * y).sum();
            x[i] = (x[i] - sum) * row[N - 1];
        }
        for (b, row) in self.border.iter().enumerate() {
            let i = inner + b;
            let sum: f64 = x[..i].iter().zip(row).map(|(x, y)| x * y).sum();
            x[i] = (x[i] - sum) * row[i];
        }
        for (b, row) in self.border.iter().enumerate().rev() {
            let i = inner + b;
            x[i] *= row[i];
            let value = x[i];
            for (x, y) in x[..i].iter_mut().zip(row) {
                *x -= value * y;
            }
        }
        for i in (0..inner).rev() {
            let from = i.saturating_sub(N - 1);
            let row = &self.band[i];
            x[i] *= row[N - 1];
            let value = x[i];
            for (x, y) in x[from..i].iter_mut().zip(&row[N - 1 - (i - from)..N - 1]) {
                *x -= value * y;
            }
        }
    }
}

#[cfg(test)]
#[allow(clippy::needless_range_loop, reason = "matrices are read as in books")]
mod tests {
    use super::*;

    /// A diagonally dominant matrix with couplings up to `N - 1`, round the ring if asked, and its product with x.
    fn example<const N: usize>(size: usize, ring: bool) -> (BorderedBand<N>, Vec<Vec<f64>>) {
        let mut matrix = BorderedBand::<N>::zero(size, ring);
        let mut full = vec![vec![0.0; size]; size];
        for i in 0..size {
            for j in 0..=i {
                let apart = if ring { (i - j).min(size - (i - j)) } else { i - j };
                if apart < N {
                    let value = if i == j { 3.0 * N as f64 } else { ((i * 7 + j * 3) % 5) as f64 - 2.0 };
                    *matrix.entry(j, i) += value;
                    full[i][j] = value;
                    full[j][i] = value;
                }
            }
        }
        (matrix, full)
    }

    fn residual<const N: usize>(size: usize, ring: bool) -> f64 {
        let (mut matrix, full) = example::<N>(size, ring);
        let b: Vec<f64> = (0..size).map(|i| (i as f64 * 0.7).sin()).collect();
        let mut x = b.clone();
        assert!(matrix.factor(), "size {size}");
        matrix.solve(&mut x);
        let product = |row: &Vec<f64>| row.iter().zip(&x).map(|(a, x)| a * x).sum::<f64>();
        full.iter().zip(&b).map(|(row, b)| (product(row) - b).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn lines_and_rings_of_every_size_are_solved() {
        for size in 1..20 {
            for ring in [false, true] {
                // Dominant by a factor of about 2: condition below 10, sums of at most 20 terms.
                assert!(residual::<4>(size, ring) < 1e-14, "{size} {ring}");
                assert!(residual::<8>(size, ring) < 1e-14, "{size} {ring}");
            }
        }
    }

    #[test]
    fn an_indefinite_matrix_is_refused() {
        for ring in [false, true] {
            let (mut matrix, _) = example::<4>(9, ring);
            *matrix.entry(8, 8) = -1.0;
            assert!(!matrix.factor());
            let (mut matrix, _) = example::<4>(9, ring);
            *matrix.entry(2, 2) = f64::NAN;
            assert!(!matrix.factor());
        }
    }
}
