//! Cholesky factors of banded matrices whose last rows may be full: the matrices of splines and smoothers on a line
//! of unknowns, and on a ring of them, where the last unknowns are neighbors of the first.

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

    /// The entry of two unknowns that are neighbors; each pair has one entry, in either order.
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

    /// The diagonal of the inverse, from the factor: inside the band by the recursion of Erisman and Tinney
    /// (`docs/math/fair-fits.md#noise`), corrected for the border.
    pub fn inverse_diagonal(&self) -> Vec<f64> {
        let (inner, b) = (self.band.len(), self.border.len());
        // Entries of the inverse of the band in the columns from the diagonal on.
        let mut inverse = vec![[0.0; N]; inner];
        for i in (0..inner).rev() {
            let last = (i + N - 1).min(inner - 1);
            let below: [f64; N] = std::array::from_fn(|k| {
                let row = i + k;
                if k == 0 || row > last { 0.0 } else { self.band[row][N - 1 - k] * self.band[i][N - 1] }
            });
            let entry = |inverse: &[[f64; N]], r: usize, c: usize| {
                let (r, c) = (r.min(c), r.max(c));
                if c - r < N { inverse[r][c - r] } else { 0.0 }
            };
            for j in (i..=last).rev() {
                let sum: f64 = (i + 1..=last).map(|k| below[k - i] * entry(&inverse, k, j)).sum();
                inverse[i][j - i] = if i == j { self.band[i][N - 1].powi(2) - sum } else { -sum };
            }
        }
        let mut diagonal: Vec<f64> = inverse.iter().map(|row| row[0]).collect();
        // The border: columns of the inverse that belong to it.
        let columns: Vec<Vec<f64>> = (0..b)
            .map(|k| {
                let mut x = vec![0.0; inner + b];
                x[inner + k] = 1.0;
                self.solve(&mut x);
                x
            })
            .collect();
        diagonal.extend((0..b).map(|k| columns[k][inner + k]));
        if b > 0 {
            // inverse = inverse of the band + X S X^T, and the columns are -X S: with S by Cholesky, X S X^T = C S^-1 C^T.
            let s = |i: usize, j: usize| columns[j][inner + i];
            let mut factor = vec![vec![0.0_f64; b]; b];
            for i in 0..b {
                for j in 0..=i {
                    let sum: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
                    factor[i][j] = if i == j { (s(i, i) - sum).sqrt() } else { (s(i, j) - sum) / factor[j][j] };
                }
            }
            for (r, d) in diagonal.iter_mut().take(inner).enumerate() {
                let mut y = vec![0.0; b];
                for i in 0..b {
                    let sum: f64 = (0..i).map(|k| factor[i][k] * y[k]).sum();
                    y[i] = (columns[i][r] - sum) / factor[i][i];
                }
                *d += y.iter().map(|y| y * y).sum::<f64>();
            }
        }
        diagonal
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

    #[test]
    fn the_diagonal_of_the_inverse_is_that_of_solving() {
        for (n, ring) in [(9, false), (9, true), (40, true), (1, false)] {
            let mut a = BorderedBand::<4>::zero(n, ring);
            for i in 0..n {
                *a.entry(i, i) += 5.0 + (i as f64).sin();
                for k in 1..4 {
                    if i + k < n || (ring && n > 7) {
                        *a.entry(i, (i + k) % n) += 0.7 * ((i * k) as f64).cos();
                    }
                }
            }
            assert!(a.factor());
            for (i, d) in a.inverse_diagonal().into_iter().enumerate() {
                let mut x = vec![0.0; n];
                x[i] = 1.0;
                a.solve(&mut x);
                assert!((x[i] - d).abs() < 1e-12, "{n} {ring} {i}: {} {d}", x[i]);
            }
        }
    }
}
