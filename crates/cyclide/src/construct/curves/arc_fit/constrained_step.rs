//! One step of least squares with damping and linear constraints, in unknowns of unlike sizes
//! (`docs/math/arc-fitting.md#least-deviation`).

/// Unknowns that matter less than this part of the others are held by the damping.
const FLAT: f64 = 1e-3;

/// The step that lowers the quadratic form, damped on its diagonal, and takes the misses to zero: each row has a miss and how
/// it changes. `units` say how far each unknown moves the curve; `None` if nothing determines the step.
pub(super) fn constrained_step(
    mut normal: Vec<Vec<f64>>,
    gradient: &[f64],
    rows: &[(f64, Vec<f64>)],
    units: &[f64],
    damping: f64,
) -> Option<Vec<f64>> {
    let columns = gradient.len();
    // Unit diagonal, but for unknowns that hardly matter: sliding a joint between arcs of one circle.
    let strength = |i: usize| normal[i][i].sqrt() / units[i];
    let floor = FLAT * (0..columns).map(strength).fold(0.0, f64::max);
    let scale: Vec<f64> = (0..columns).map(|i| units[i] * strength(i).max(floor).max(f64::MIN_POSITIVE)).collect();
    let size = columns + rows.len();
    let mut system = vec![vec![0.0; size + 1]; size];
    for i in 0..columns {
        for j in 0..columns {
            normal[i][j] /= scale[i] * scale[j];
        }
        system[i][..columns].copy_from_slice(&normal[i]);
        system[i][i] += damping + 1e-12;
        system[i][size] = -gradient[i] / scale[i];
    }
    for (k, (miss, row)) in rows.iter().enumerate() {
        let scaled: Vec<f64> = row.iter().zip(&scale).map(|(a, s)| a / s).collect();
        let norm = scaled.iter().map(|a| a * a).sum::<f64>().sqrt();
        if !(norm > 0.0) {
            return None;
        }
        for (j, a) in scaled.iter().enumerate() {
            system[columns + k][j] = a / norm;
            system[j][columns + k] = a / norm;
        }
        system[columns + k][size] = -miss / norm;
    }
    let solution = solved(system)?;
    Some(solution[..columns].iter().zip(&scale).map(|(x, s)| x / s).collect())
}

/// Gaussian elimination with partial pivoting; the last column is the right side.
fn solved(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs()))?;
        rows.swap(k, pivot);
        let (above, below) = rows.split_at_mut(k + 1);
        let top = &above[k];
        if !(top[k].abs() > f64::MIN_POSITIVE) {
            return None;
        }
        for row in below {
            let factor = row[k] / top[k];
            if factor != 0.0 {
                row[k..].iter_mut().zip(&top[k..]).for_each(|(a, b)| *a -= factor * b);
            }
        }
    }
    let mut x = vec![0.0; n];
    for k in (0..n).rev() {
        let sum: f64 = (k + 1..n).map(|j| rows[k][j] * x[j]).sum();
        x[k] = (rows[k][n] - sum) / rows[k][k];
    }
    x.iter().all(|v| v.is_finite()).then_some(x)
}
