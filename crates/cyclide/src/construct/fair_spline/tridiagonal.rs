//! Symmetric block-tridiagonal systems, open or cyclic, by block elimination with fill of the last column
//! (`docs/math/fair-splines.md#newtons-method`). Linear in the number of blocks; nothing is allocated by a solution.
//!
//! There is no pivoting: the matrices are positive definite for tame data, the damped ones have a positive definite
//! imaginary part, and a solution that rounding spoiled is refused by the residual it leaves.

use super::scalar::Scalar;

/// A square block: 1 × 1 in the plane, 2 × 2 in space.
pub(super) type Block<T, const R: usize> = [[T; R]; R];

/// A symmetric matrix of `n` diagonal blocks; block `i` is coupled to block `i + 1`, the last one of a cyclic matrix to
/// block 0.
pub(super) struct Tridiagonal<T, const R: usize> {
    /// The blocks `H(i, i)`, symmetric.
    pub(super) diagonal: Vec<Block<T, R>>,
    /// The blocks `H(i, i + 1)`; the last one is `H(n-1, 0)`, without meaning unless cyclic.
    pub(super) coupling: Vec<Block<T, R>>,
    pub(super) cyclic: bool,
}

/// Room for the elimination of one system.
pub(super) struct Elimination<T, const R: usize> {
    /// Inverses of the pivots.
    pivots: Vec<Block<T, R>>,
    /// The last column above the diagonal, of cyclic systems.
    fill: Vec<Block<T, R>>,
    /// Right side, then the solution.
    pub(super) solution: Vec<[T; R]>,
}

impl<T: Scalar, const R: usize> Tridiagonal<T, R> {
    /// The zero matrix.
    pub(super) fn new(n: usize, cyclic: bool) -> Self {
        let zero = vec![[[T::real(0.0); R]; R]; n];
        Self { diagonal: zero.clone(), coupling: zero, cyclic }
    }
}

impl<T: Scalar, const R: usize> Elimination<T, R> {
    pub(super) fn new(n: usize, cyclic: bool) -> Self {
        let zero = [[T::real(0.0); R]; R];
        let fill = if cyclic { n } else { 0 };
        Self { pivots: vec![zero; n], fill: vec![zero; fill], solution: vec![[T::real(0.0); R]; n] }
    }

    /// Replaces the right side in `solution` by the solution, of at least 3 blocks if cyclic. Not finite where a pivot
    /// vanishes.
    pub(super) fn solve(&mut self, matrix: &Tridiagonal<T, R>) {
        if matrix.cyclic { self.solve_cyclic(matrix) } else { self.solve_open(matrix) }
    }

    fn solve_open(&mut self, matrix: &Tridiagonal<T, R>) {
        let n = self.solution.len();
        let Some(mut pivot) = matrix.diagonal.first().map(inverse) else { return };
        let mut value = self.solution[0];
        self.pivots[0] = pivot;
        for i in 1..n {
            let factor = transposed_product(&matrix.coupling[i - 1], &pivot);
            pivot = inverse(&difference(&matrix.diagonal[i], &product(&factor, &matrix.coupling[i - 1])));
            value = minus(self.solution[i], applied(&factor, value));
            (self.pivots[i], self.solution[i]) = (pivot, value);
        }
        let mut next = applied(&self.pivots[n - 1], self.solution[n - 1]);
        self.solution[n - 1] = next;
        for i in (0..n - 1).rev() {
            next = applied(&self.pivots[i], minus(self.solution[i], applied(&matrix.coupling[i], next)));
            self.solution[i] = next;
        }
    }

    fn solve_cyclic(&mut self, matrix: &Tridiagonal<T, R>) {
        let n = self.solution.len();
        let last = n - 1;
        let mut pivot = inverse(&matrix.diagonal[0]);
        let mut value = self.solution[0];
        let mut fill = transposed(&matrix.coupling[last]);
        let (mut last_diagonal, mut last_value) = (matrix.diagonal[last], self.solution[last]);
        for i in 0..last {
            self.pivots[i] = pivot;
            self.fill[i] = fill;
            self.solution[i] = value;
            let closing = transposed_product(&fill, &pivot);
            last_diagonal = difference(&last_diagonal, &product(&closing, &fill));
            last_value = minus(last_value, applied(&closing, value));
            if i + 1 < last {
                let coupling = &matrix.coupling[i];
                let factor = transposed_product(coupling, &pivot);
                let spread = product(&factor, &fill);
                pivot = inverse(&difference(&matrix.diagonal[i + 1], &product(&factor, coupling)));
                value = minus(self.solution[i + 1], applied(&factor, value));
                // The block before the last meets it in its own coupling too.
                let own = if i + 2 == last { matrix.coupling[i + 1] } else { [[T::real(0.0); R]; R] };
                fill = difference(&own, &spread);
            }
        }
        let end = applied(&inverse(&last_diagonal), last_value);
        self.solution[last] = end;
        let mut next = end;
        for i in (0..last).rev() {
            let mut rest = minus(self.solution[i], applied(&self.fill[i], end));
            if i + 1 < last {
                rest = minus(rest, applied(&matrix.coupling[i], next));
            }
            next = applied(&self.pivots[i], rest);
            self.solution[i] = next;
        }
    }
}

fn transposed<T: Scalar, const R: usize>(a: &Block<T, R>) -> Block<T, R> {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

fn difference<T: Scalar, const R: usize>(a: &Block<T, R>, b: &Block<T, R>) -> Block<T, R> {
    std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] - b[i][j]))
}

fn product<T: Scalar, const R: usize>(a: &Block<T, R>, b: &Block<T, R>) -> Block<T, R> {
    std::array::from_fn(|i| std::array::from_fn(|j| sum::<T, R>(|k| a[i][k] * b[k][j])))
}

/// `aᵀ b`.
fn transposed_product<T: Scalar, const R: usize>(a: &Block<T, R>, b: &Block<T, R>) -> Block<T, R> {
    std::array::from_fn(|i| std::array::from_fn(|j| sum::<T, R>(|k| a[k][i] * b[k][j])))
}

fn applied<T: Scalar, const R: usize>(a: &Block<T, R>, v: [T; R]) -> [T; R] {
    std::array::from_fn(|i| sum::<T, R>(|k| a[i][k] * v[k]))
}

fn minus<T: Scalar, const R: usize>(a: [T; R], b: [T; R]) -> [T; R] {
    std::array::from_fn(|i| a[i] - b[i])
}

/// Sum over the indices of a block.
fn sum<T: Scalar, const R: usize>(term: impl Fn(usize) -> T) -> T {
    (1..R).fold(term(0), |sum, k| sum + term(k))
}

/// The inverse of a 1 × 1 or 2 × 2 block.
fn inverse<T: Scalar, const R: usize>(a: &Block<T, R>) -> Block<T, R> {
    if R == 1 {
        return [[a[0][0].reciprocal(); R]; R];
    }
    let scale = (a[0][0] * a[1][1] - a[0][1] * a[1][0]).reciprocal();
    let zero = T::real(0.0);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| if i == j { a[1 - i][1 - j] * scale } else { zero - a[i][j] * scale })
    })
}
