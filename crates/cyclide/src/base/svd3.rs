//! Singular values of a 3×3 matrix and the nearest rotation to it, by one-sided Jacobi rotations.

use super::vector::Vec3;

/// Sweeps of rotations: convergence is quadratic, three or four are the rule.
const SWEEPS: usize = 30;

/// Singular values that differ by no more than this part of the largest tell no rotation from another.
pub(crate) const UNIQUE: f64 = 1e-12;

/// The rotation matrix (as its columns) that maximizes `tr(RᵀG)` for the matrix `G` with the given columns: with
/// `G = U S Vᵀ`, `R = U diag(1, 1, det(U Vᵀ)) Vᵀ`.
///
/// # Errors
/// If it is not unique, the figure that is not above [`UNIQUE`]: the second singular value relative to the largest (`G` of rank
/// below 2; 0 if it is not finite), or its difference to the third if `det G < 0`.
pub(crate) fn nearest_rotation(columns: [Vec3; 3]) -> Result<[Vec3; 3], f64> {
    let size = columns.iter().map(|c| c.max_abs()).fold(0.0, f64::max);
    if !(size > 0.0 && columns.iter().all(|c| c.is_finite())) {
        return Err(0.0);
    }
    let (a, v) = orthogonal_columns(columns.map(|c| c / size));
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| a[j].length_squared().total_cmp(&a[i].length_squared()));
    let [s0, s1, s2] = order.map(|i| a[i].length());
    if s1 <= UNIQUE * s0 {
        return Err(s1 / s0);
    }
    // The third column of U from the first two: it gives det U = 1 also where S has a zero, and with V made
    // right-handed the same way the product has determinant 1, as the factor det(U Vᵀ) demands.
    let (u0, u1) = (a[order[0]] / s0, a[order[1]] / s1);
    let (v0, v1) = (v[order[0]], v[order[1]]);
    let (u2, v2) = (u0.cross(u1), v0.cross(v1));
    let reversed = u2.dot(a[order[2]]) * v2.dot(v[order[2]]) < 0.0;
    if reversed && s1 - s2 <= UNIQUE * s0 {
        return Err((s1 - s2) / s0);
    }
    // Column k of U Vᵀ is the sum of u_i (v_i)_k.
    Ok([0, 1, 2].map(|k| u0 * v0[k] + u1 * v1[k] + u2 * v2[k]))
}

/// The singular values of the matrix with the given columns, largest first.
pub fn singular_values(columns: [Vec3; 3]) -> [f64; 3] {
    let size = columns.iter().map(|c| c.max_abs()).fold(0.0, f64::max);
    if !(size > 0.0 && columns.iter().all(|c| c.is_finite())) {
        return [size; 3];
    }
    let (a, _) = orthogonal_columns(columns.map(|c| c / size));
    let mut values = a.map(|c| size * c.length());
    values.sort_by(|x, y| y.total_cmp(x));
    values
}

/// Rotates the columns from the right until they are orthogonal, `A V = U S`: gives `A V` and `V`.
fn orthogonal_columns(columns: [Vec3; 3]) -> ([Vec3; 3], [Vec3; 3]) {
    let mut a = columns;
    let mut v = [Vec3::X, Vec3::Y, Vec3::Z];
    for _ in 0..SWEEPS {
        let mut off = 0.0_f64;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let (alpha, beta, gamma) = (a[p].dot(a[p]), a[q].dot(a[q]), a[p].dot(a[q]));
            if gamma.abs() <= f64::EPSILON * (alpha * beta).sqrt() {
                continue;
            }
            off = off.max(gamma.abs() / (alpha * beta).sqrt());
            let zeta = (beta - alpha) / (2.0 * gamma);
            let t = 1.0_f64.copysign(zeta) / (zeta.abs() + 1.0_f64.hypot(zeta));
            let c = 1.0 / 1.0_f64.hypot(t);
            let s = c * t;
            for m in [&mut a, &mut v] {
                (m[p], m[q]) = (m[p] * c - m[q] * s, m[p] * s + m[q] * c);
            }
        }
        if off == 0.0 {
            break;
        }
    }
    (a, v)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn determinant(m: [Vec3; 3]) -> f64 {
        m[0].dot(m[1].cross(m[2]))
    }

    #[test]
    fn a_rotation_times_a_positive_matrix_gives_the_rotation() {
        let r = [Vec3::new(2.0, -1.0, 2.0) / 3.0, Vec3::new(2.0, 2.0, -1.0) / 3.0, Vec3::new(-1.0, 2.0, 2.0) / 3.0];
        for (stretch, tolerance) in [([3.0, 1.0, 0.5], 1e-15), ([1.0, 1.0, 1.0], 1e-15), ([1e8, 1.0, 0.0], 1e-14)] {
            // G = R P with P = Q diag(stretch) Qᵀ symmetric, Q another rotation.
            let q = [r[2], r[0], r[1]];
            let p = |k: usize| {
                q[0] * (stretch[0] * q[0][k]) + q[1] * (stretch[1] * q[1][k]) + q[2] * (stretch[2] * q[2][k])
            };
            let times = |c: Vec3| r[0] * c.x + r[1] * c.y + r[2] * c.z;
            let g = [times(p(0)), times(p(1)), times(p(2))];
            let got = nearest_rotation(g).unwrap();
            for k in 0..3 {
                // Rounding of G is relative to its largest singular value.
                assert!((got[k] - r[k]).length() < tolerance * stretch[0].max(1.0), "{stretch:?} {got:?}");
            }
        }
    }

    #[test]
    fn the_result_is_a_rotation_and_a_maximum() {
        let g = [Vec3::new(0.3, 1.0, -2.0), Vec3::new(0.7, -0.4, 0.1), Vec3::new(-1.5, 0.2, 0.9)];
        for sign in [1.0, -1.0] {
            let g = g.map(|c| c * sign);
            let r = nearest_rotation(g).unwrap();
            assert!((determinant(r) - 1.0).abs() < 1e-14);
            let trace = |r: [Vec3; 3]| (0..3).map(|k| r[k].dot(g[k])).sum::<f64>();
            for axis in [Vec3::X, Vec3::Y, Vec3::Z, Vec3::new(0.6, 0.0, 0.8)] {
                for angle in [1e-3_f64, -1e-3, 1.0, -2.0, 3.0] {
                    let turned = r.map(|c| super::super::quat::Quat::from_axis_angle(axis, angle).rotate(c));
                    assert!(trace(turned) < trace(r), "{axis:?} {angle}");
                }
            }
        }
    }

    #[test]
    fn singular_values_of_a_stretched_rotation() {
        let r = [Vec3::new(2.0, -1.0, 2.0) / 3.0, Vec3::new(2.0, 2.0, -1.0) / 3.0, Vec3::new(-1.0, 2.0, 2.0) / 3.0];
        let values = singular_values([r[2] * 1e-6, r[0] * 3.0, r[1]]);
        for (value, expected) in values.into_iter().zip([3.0, 1.0, 1e-6]) {
            assert!((value - expected).abs() < 1e-15 * expected.max(1.0), "{values:?}"); // rounding of the largest
        }
        assert!(singular_values([Vec3::ZERO; 3]).iter().all(|value| value.abs() < f64::MIN_POSITIVE));
    }

    #[test]
    fn without_a_unique_answer_there_is_none() {
        assert_eq!(nearest_rotation([Vec3::ZERO; 3]), Err(0.0));
        assert!(nearest_rotation([Vec3::X, Vec3::X * 2.0, Vec3::ZERO]).is_err_and(|measured| measured <= UNIQUE));
        assert_eq!(nearest_rotation([Vec3::X, Vec3::Y, Vec3::new(f64::NAN, 0.0, 0.0)]), Err(0.0));
        assert!(nearest_rotation([-Vec3::X, -Vec3::Y, -Vec3::Z]).is_err_and(|measured| measured <= UNIQUE));
    }
}
