//! Null vectors of quaternion matrices by elimination with complete pivoting.
//!
//! Unknowns stand to the right of the entries, `sum A_kj x_j = 0`: rows are combined with factors on the **left**, and a null vector may
//! be multiplied on the right by any quaternion.

use crate::base::quat::Quat;

/// A pivot up to this part of the first one is zero.
const RANK_LIMIT: f64 = 1e-12;

/// A vector that a matrix takes to zero.
#[derive(Debug, Clone)]
pub(super) struct NullVector {
    pub(super) entries: Vec<Quat>,
    /// Independent rows found.
    pub(super) rank: usize,
}

/// A null vector of a matrix with more columns than rows, all rows of one length. If there are several, a general one: none of its
/// entries vanishes that need not.
pub(super) fn null_vector(mut rows: Vec<Vec<Quat>>, columns: usize) -> NullVector {
    let mut order: Vec<usize> = (0..columns).collect();
    let rank = eliminate(&mut rows, &mut order);
    let mut entries = vec![Quat::ZERO; columns];
    for (k, &column) in order[rank..].iter().enumerate() {
        entries[column] = unit(k);
    }
    for k in (0..rank).rev() {
        let sum = order[k + 1..].iter().fold(Quat::ZERO, |sum, &j| sum + rows[k][j] * entries[j]);
        let inverse = rows[k][order[k]].inverse().unwrap_or(Quat::ZERO);
        entries[order[k]] = -(inverse * sum);
    }
    NullVector { entries, rank }
}

/// Brings the rows to triangular form, the pivot of row `k` in column `order[k]`; the number of pivots.
fn eliminate(rows: &mut [Vec<Quat>], order: &mut [usize]) -> usize {
    let mut first = 0.0;
    for step in 0..rows.len().min(order.len()) {
        let open = (step..rows.len()).flat_map(|i| (step..order.len()).map(move |j| (i, j)));
        let size = |&(i, j): &(usize, usize)| rows[i][order[j]].norm();
        let Some((i, j)) = open.max_by(|a, b| size(a).total_cmp(&size(b))) else { return step };
        let pivot = size(&(i, j));
        if step == 0 {
            first = pivot;
        }
        if pivot <= RANK_LIMIT * first {
            return step;
        }
        rows.swap(step, i);
        order.swap(step, j);
        let (above, below) = rows.split_at_mut(step + 1);
        let top = &above[step];
        let inverse = top[order[step]].inverse().unwrap_or(Quat::ZERO);
        for row in below {
            let factor = row[order[step]] * inverse;
            for &column in &order[step..] {
                row[column] -= factor * top[column];
            }
        }
    }
    rows.len().min(order.len())
}

/// Different unit quaternions, the first one 1: zeros or equal values would single out a null vector.
fn unit(k: usize) -> Quat {
    let (s, c) = (k as f64).sin_cos();
    Quat::new(c, 0.6 * s, 0.48 * s, 0.64 * s)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(i: usize, j: usize) -> Quat {
        let x = |k: usize| ((31 * i + 7 * j + 13 * k + 11 * i * j + 5 * j * k + 1) as f64 * 1.618).sin();
        Quat::new(x(0), x(1), x(2), x(3))
    }

    #[test]
    fn null_vectors_solve_from_the_right() {
        let rows: Vec<Vec<Quat>> = (0..3).map(|i| (0..4).map(|j| entry(i, j)).collect()).collect();
        let found = null_vector(rows.clone(), 4);
        assert_eq!(found.rank, 3);
        for row in rows {
            let sum = row.iter().zip(&found.entries).fold(Quat::ZERO, |sum, (a, x)| sum + *a * *x);
            assert!(sum.norm() < 1e-14);
        }
    }

    #[test]
    fn dependent_rows_lower_the_rank() {
        let first: Vec<Quat> = (0..4).map(|j| entry(0, j)).collect();
        let factor = entry(7, 7);
        let rows = vec![first.clone(), first.iter().map(|q| factor * *q).collect(), vec![Quat::ZERO; 4]];
        let found = null_vector(rows, 4);
        assert_eq!(found.rank, 1);
        assert!(found.entries.iter().all(|q| q.norm() > 0.1));
        assert_eq!(null_vector(vec![vec![Quat::ZERO; 3]; 2], 3).rank, 0);
    }
}
