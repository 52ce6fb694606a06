//! Gauss-Jordan elimination with full pivoting of small dense matrices.

/// A vector that the matrix takes to zero, its largest entry 1, and the smallest pivot over the largest: near zero there are more such
/// vectors. `None` if a pivot is zero or not finite. `C = R + 1`.
pub(crate) fn null_vector<const R: usize, const C: usize>(rows: [[f64; C]; R]) -> Option<([f64; C], f64)> {
    let mut work = rows;
    let (columns, ratio) = reduce(&mut work, C)?;
    let free = (0..C).find(|column| !columns.contains(column))?;
    let mut out = [0.0; C];
    out[free] = 1.0;
    for (row, column) in columns.into_iter().enumerate() {
        out[column] = -work[row][free];
    }
    let largest = out.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    Some((out.map(|x| x / largest), ratio))
}

/// The solution of `A x = b` from the rows `[A | b]`, `C = R + 1`. `None` if a pivot is zero or not finite.
pub(crate) fn solution<const R: usize, const C: usize>(rows: [[f64; C]; R]) -> Option<[f64; R]> {
    let mut work = rows;
    let (columns, _) = reduce(&mut work, R)?;
    let mut out = [0.0; R];
    for (row, column) in work.iter().zip(columns) {
        out[column] = row[R];
    }
    Some(out)
}

/// The number of rows that are independent, up to a part of their length.
pub(crate) fn rank<const R: usize, const C: usize>(rows: [[f64; C]; R], limit: f64) -> usize {
    let (mut work, mut used, mut found) = (rows, [false; C], 0);
    for step in 0..R {
        let open = (step..R).flat_map(|i| (0..C).map(move |j| (i, j))).filter(|(_, j)| !used[*j]);
        let largest = open.max_by(|a, b| work[a.0][a.1].abs().total_cmp(&work[b.0][b.1].abs()));
        let Some((i, j)) = largest.filter(|(i, j)| work[*i][*j].abs() > limit) else { break };
        work.swap(step, i);
        used[j] = true;
        found += 1;
        let head = work[step];
        for row in work.iter_mut().skip(step + 1) {
            let factor = row[j] / head[j];
            row.iter_mut().zip(head).for_each(|(x, h)| *x -= factor * h);
        }
    }
    found
}

/// Makes the columns of the pivots, which are among the first ones, unit columns; the column of the pivot of each row, and the smallest
/// pivot over the largest.
fn reduce<const R: usize, const C: usize>(work: &mut [[f64; C]; R], first: usize) -> Option<([usize; R], f64)> {
    let (mut columns, mut pivots) = ([C; R], [0.0; R]);
    for step in 0..R {
        let open =
            (step..R).flat_map(|i| (0..first).map(move |j| (i, j))).filter(|(_, j)| !columns[..step].contains(j));
        let (i, j) = open.max_by(|a, b| work[a.0][a.1].abs().total_cmp(&work[b.0][b.1].abs()))?;
        work.swap(step, i);
        let pivot = work[step][j];
        if !(pivot.is_finite() && pivot != 0.0) {
            return None;
        }
        (columns[step], pivots[step]) = (j, pivot.abs());
        work[step] = work[step].map(|x| x / pivot);
        for k in (0..R).filter(|k| *k != step) {
            let factor = work[k][j];
            work[k] = std::array::from_fn(|c| work[k][c] - factor * work[step][c]);
        }
    }
    let largest = pivots.iter().copied().fold(0.0, f64::max);
    Some((columns, pivots.iter().copied().fold(f64::INFINITY, f64::min) / largest))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn null_vectors() {
        let wide = [[1.0, 2.0, 3.0], [0.0, 1.0, -1.0]];
        let (v, _) = null_vector(wide).unwrap();
        for row in wide {
            assert!(row.iter().zip(v).map(|(a, b)| a * b).sum::<f64>().abs() < 1e-15);
        }
        assert!(null_vector([[1.0, 2.0, 3.0], [2.0, 4.0, 6.0]]).is_none_or(|(_, ratio)| ratio < 1e-15));
    }

    #[test]
    fn solutions() {
        // A large right side is no pivot.
        assert_eq!(solution([[0.0, 2.0, 4e9], [1.0, 1.0, 3e9]]), Some([1e9, 2e9]));
        assert_eq!(solution([[1.0, 2.0, 1.0], [2.0, 4.0, 0.0]]), None);
    }

    #[test]
    fn a_unit_of_length_changes_neither_the_direction_nor_how_well_it_is_known() {
        let rows = [[2.0, -1.0, 0.5, 3.0], [0.0, 4.0, 1.0, -2.0], [1.0, 1.0, -3.0, 0.25]];
        let (vector, ratio) = null_vector(rows).unwrap();
        for row in rows {
            let image: f64 = row.iter().zip(vector).map(|(a, x)| a * x).sum();
            assert!(image.abs() < 1e-15 * 8.0, "{image:e}"); // rounding of a sum of four terms below 4
        }
        assert!(ratio > 0.1 && ratio <= 1.0, "{ratio}");
        for unit in [1e-9, 1e9] {
            let (scaled, same) = null_vector(rows.map(|row| row.map(|a| a * unit))).unwrap();
            assert!(vector.iter().zip(scaled).all(|(a, b)| (a - b).abs() < 1e-14));
            assert!((same / ratio - 1.0).abs() < 1e-12, "{unit:e}: {same} {ratio}");
        }
        // Rows that are nearly one: another vector is nearly taken to zero too, whatever the unit.
        let [first, second, _] = rows;
        let nearly = |unit: f64| {
            let third: [f64; 4] = std::array::from_fn(|k| first[k] + second[k] + if k == 0 { 1e-7 } else { 0.0 });
            null_vector([first, second, third].map(|row| row.map(|a| a * unit))).unwrap().1
        };
        assert!([1e-6, 1.0, 1e6].into_iter().map(nearly).all(|ratio| ratio > 1e-9 && ratio < 1e-7));
    }
}
