//! Gauss-Jordan elimination with full pivoting of small dense matrices.

/// The inverse of a matrix, and its smallest pivot over the largest; `None` if a pivot is zero or not finite.
pub(crate) fn inverse<const N: usize>(rows: [[f64; N]; N]) -> Option<([[f64; N]; N], f64)> {
    let mut work = rows;
    let mut right: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }));
    let (columns, ratio) = reduce(&mut work, &mut right)?;
    let mut out = right;
    for (row, column) in columns.into_iter().enumerate() {
        out[column] = right[row];
    }
    Some((out, ratio))
}

/// A vector that the matrix takes to zero, its largest entry 1, and the smallest pivot over the largest: near zero there are more such
/// vectors. `None` if a pivot is zero or not finite. `C = R + 1`.
pub(crate) fn null_vector<const R: usize, const C: usize>(rows: [[f64; C]; R]) -> Option<([f64; C], f64)> {
    let mut work = rows;
    let mut none = [[0.0; 0]; R];
    let (columns, ratio) = reduce(&mut work, &mut none)?;
    let free = (0..C).find(|column| !columns.contains(column))?;
    let mut out = [0.0; C];
    out[free] = 1.0;
    for (row, column) in columns.into_iter().enumerate() {
        out[column] = -work[row][free];
    }
    let largest = out.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    Some((out.map(|x| x / largest), ratio))
}

/// Makes the columns of the pivots unit columns; the column of the pivot of each row, and the smallest pivot over the largest.
fn reduce<const R: usize, const C: usize, const D: usize>(
    work: &mut [[f64; C]; R],
    right: &mut [[f64; D]; R],
) -> Option<([usize; R], f64)> {
    let (mut columns, mut pivots) = ([C; R], [0.0; R]);
    for step in 0..R {
        let open = (step..R).flat_map(|i| (0..C).map(move |j| (i, j))).filter(|(_, j)| !columns[..step].contains(j));
        let (i, j) = open.max_by(|a, b| work[a.0][a.1].abs().total_cmp(&work[b.0][b.1].abs()))?;
        work.swap(step, i);
        right.swap(step, i);
        let pivot = work[step][j];
        if !(pivot.is_finite() && pivot != 0.0) {
            return None;
        }
        (columns[step], pivots[step]) = (j, pivot.abs());
        work[step] = work[step].map(|x| x / pivot);
        right[step] = right[step].map(|x| x / pivot);
        for k in (0..R).filter(|k| *k != step) {
            let factor = work[k][j];
            work[k] = std::array::from_fn(|c| work[k][c] - factor * work[step][c]);
            right[k] = std::array::from_fn(|c| right[k][c] - factor * right[step][c]);
        }
    }
    let largest = pivots.iter().copied().fold(0.0, f64::max);
    Some((columns, pivots.iter().copied().fold(f64::INFINITY, f64::min) / largest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverses_and_null_vectors() {
        let m = [[0.0, 2.0, 1.0], [1.0, -1.0, 0.5], [3.0, 0.25, -2.0]];
        let (inverse, ratio) = inverse(m).unwrap();
        for (i, row) in m.iter().enumerate() {
            let product: [f64; 3] = std::array::from_fn(|j| row.iter().zip(inverse).map(|(a, b)| a * b[j]).sum());
            let off = product.iter().enumerate().map(|(j, x)| (x - f64::from(u8::from(i == j))).abs());
            assert!(off.fold(0.0, f64::max) < 1e-15);
        }
        assert!(ratio > 0.1);
        let wide = [[1.0, 2.0, 3.0], [0.0, 1.0, -1.0]];
        let (v, _) = null_vector(wide).unwrap();
        for row in wide {
            assert!(row.iter().zip(v).map(|(a, b)| a * b).sum::<f64>().abs() < 1e-15);
        }
        assert!(null_vector([[1.0, 2.0, 3.0], [2.0, 4.0, 6.0]]).is_none_or(|(_, ratio)| ratio < 1e-15));
    }
}
