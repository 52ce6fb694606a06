//! Polynomials in Bernstein form: products, de Casteljau, degree elevation.

/// Weights are above this part of the smaller one at the ends.
const LEAST_WEIGHT: f64 = 1e-3;

/// Whether the coefficients of a positive polynomial will do as the weights of a rational curve: next to zero they would put control points
/// far out, and cost the digits between.
#[must_use]
pub(crate) fn are_weights(coefficients: &[f64]) -> bool {
    let ends = coefficients[0].min(coefficients[coefficients.len() - 1]);
    ends > 0.0 && coefficients.iter().all(|w| *w > LEAST_WEIGHT * ends)
}

/// The binomial coefficients `C(n, 0..=n)` as floats (exact up to `n = 57`).
fn binomials(n: usize) -> impl Iterator<Item = f64> {
    let mut value = 1.0;
    (0..=n).map(move |i| {
        value = if i == 0 { 1.0 } else { next_binomial(value, n, i) };
        value
    })
}

/// The Bernstein coefficients of the product of two polynomials (degrees add).
#[must_use]
pub(crate) fn product(a: &[f64], b: &[f64]) -> Vec<f64> {
    let (n, m) = (a.len() - 1, b.len() - 1);
    // In the basis t^i (1-t)^(n-i), without binomials, products are convolutions.
    let scaled: Vec<f64> = b.iter().zip(binomials(m)).map(|(b, c)| b * c).collect();
    let mut out = vec![0.0; n + m + 1];
    for (i, (a, c)) in a.iter().zip(binomials(n)).enumerate() {
        let a = a * c;
        for (out, b) in out[i..].iter_mut().zip(&scaled) {
            *out += a * b;
        }
    }
    for (out, c) in out.iter_mut().zip(binomials(n + m)) {
        *out /= c;
    }
    out
}

/// The Bernstein coefficients of the product of two polynomials in two parameters, the second one fastest (degrees add).
#[must_use]
pub(crate) fn product_of_two(
    (a, [p, q]): (&[f64], [usize; 2]),
    (b, [r, u]): (&[f64], [usize; 2]),
) -> (Vec<f64>, [usize; 2]) {
    let grid = |[p, q]: [usize; 2]| binomials(p).flat_map(move |a| binomials(q).map(move |b| a * b));
    let scaled = |row: &[f64], degrees| row.iter().zip(grid(degrees)).map(|(a, c)| a * c).collect::<Vec<_>>();
    let (a, b) = (scaled(a, [p, q]), scaled(b, [r, u]));
    let mut out = vec![0.0; (p + r + 1) * (q + u + 1)];
    for (i, row) in a.chunks(q + 1).enumerate() {
        for (k, other) in b.chunks(u + 1).enumerate() {
            for (j, a) in row.iter().enumerate() {
                for (out, b) in out[(i + k) * (q + u + 1) + j..].iter_mut().zip(other) {
                    *out += a * b;
                }
            }
        }
    }
    for (out, c) in out.iter_mut().zip(grid([p + r, q + u])) {
        *out /= c;
    }
    (out, [p + r, q + u])
}

/// The quotient by the linear factor `t - root` of a row of which `root` in `[0, 1]` is a root: of one degree less. Run from
/// the end that is farther from the root, where errors shrink. `None` of constants.
pub(crate) fn divided<const D: usize>(row: &[[f64; D]], root: f64) -> Option<Vec<[f64; D]>> {
    let n = row.len().checked_sub(2)? + 1;
    let (all, fewer): (Vec<f64>, Vec<f64>) = (binomials(n).collect(), binomials(n - 1).collect());
    let scaled = |i: usize| row[i].map(|c| c * all[i]);
    // In the basis without binomials: c_i = (1 - root) q_(i-1) - root q_i.
    let mut out = vec![[0.0; D]; n];
    if root > 0.5 {
        let mut before = [0.0; D];
        for (i, out) in out.iter_mut().enumerate() {
            let own = scaled(i);
            before = std::array::from_fn(|d| ((1.0 - root) * before[d] - own[d]) / root);
            *out = before.map(|q| q / fewer[i]);
        }
    } else {
        let mut after = [0.0; D];
        for (i, out) in out.iter_mut().enumerate().rev() {
            let own = scaled(i + 1);
            after = std::array::from_fn(|d| (own[d] + root * after[d]) / (1.0 - root));
            *out = after.map(|q| q / fewer[i]);
        }
    }
    Some(out)
}

/// Splits at `t` in place of the row: returns the coefficients of the left and of the right part.
#[must_use]
pub(crate) fn split<const D: usize>(row: &[[f64; D]], t: f64) -> (Vec<[f64; D]>, Vec<[f64; D]>) {
    let n = row.len();
    let mut work = row.to_vec();
    let mut left = Vec::with_capacity(n);
    let mut right = vec![[0.0; D]; n];
    for level in 0..n {
        left.push(work[0]);
        right[n - 1 - level] = work[n - 1 - level];
        for i in 0..n - 1 - level {
            work[i] = mix(&work[i], &work[i + 1], t);
        }
    }
    (left, right)
}

/// Replaces the row by that of the part `[a, b]` of its interval, `0 <= a < b <= 1`.
pub(crate) fn restrict<const D: usize>(row: &mut [[f64; D]], [a, b]: [f64; 2]) {
    let n = row.len();
    if b < 1.0 {
        for r in 1..n {
            for i in (r..n).rev() {
                row[i] = mix(&row[i - 1], &row[i], b);
            }
        }
    }
    if a > 0.0 {
        let t = a / b;
        for r in 1..n {
            for i in 0..n - r {
                row[i] = mix(&row[i], &row[i + 1], t);
            }
        }
    }
}

/// Value at `t` by nested multiplication (Farin's form of Horner's scheme): exact at both ends, no allocation.
#[must_use]
pub(crate) fn eval<const D: usize>(row: &[[f64; D]], t: f64) -> [f64; D] {
    nested(row.len() - 1, t, |i| row[i])
}

/// First derivative at `t`.
#[must_use]
pub(crate) fn first_derivative<const D: usize>(row: &[[f64; D]], t: f64) -> [f64; D] {
    let n = row.len() - 1;
    if n == 0 { [0.0; D] } else { nested(n - 1, t, |i| minus(&row[i + 1], &row[i])).map(|v| v * n as f64) }
}

/// Value and the derivatives of the next orders, `K` of 1 to 4 in all, at `t`, from the differences of the coefficients; zero
/// above the degree.
#[must_use]
pub(crate) fn derivatives<const D: usize, const K: usize>(row: &[[f64; D]], t: f64) -> [[f64; D]; K] {
    let n = row.len() - 1;
    let first = |i: usize| minus(&row[i + 1], &row[i]);
    let second = |i: usize| minus(&first(i + 1), &first(i));
    let third = |i: usize| minus(&second(i + 1), &second(i));
    let mut out = [[0.0; D]; K];
    out[0] = eval(row, t);
    if K > 1 {
        out[1] = first_derivative(row, t);
    }
    let mut factor = n as f64;
    if K > 2 && n >= 2 {
        factor *= (n - 1) as f64;
        out[2] = nested(n - 2, t, second).map(|v| v * factor);
    }
    if K > 3 && n >= 3 {
        factor *= (n - 2) as f64;
        out[3] = nested(n - 3, t, third).map(|v| v * factor);
    }
    out
}

/// The polynomial of degree `n` with Bernstein coefficients `coefficient(0..=n)` at `t`.
fn nested<const D: usize>(n: usize, t: f64, coefficient: impl Fn(usize) -> [f64; D]) -> [f64; D] {
    if n == 0 {
        return coefficient(0);
    }
    let s = 1.0 - t;
    let mut sum = coefficient(0).map(|v| v * s);
    let (mut power, mut choose) = (1.0, 1.0);
    for i in 1..n {
        power *= t;
        choose = next_binomial(choose, n, i);
        let (c, f) = (coefficient(i), power * choose);
        sum = std::array::from_fn(|d| (sum[d] + f * c[d]) * s);
    }
    let (c, f) = (coefficient(n), power * t);
    std::array::from_fn(|d| sum[d] + f * c[d])
}

/// `C(n, i)` from `C(n, i-1)`; a table up to degree 16 saves the divisions.
fn next_binomial(before: f64, n: usize, i: usize) -> f64 {
    if n < BINOMIALS.len() { BINOMIALS[n][i] } else { before * (n - i + 1) as f64 / i as f64 }
}

/// Pascal's triangle.
const BINOMIALS: [[f64; 17]; 17] = {
    let mut table = [[0.0; 17]; 17];
    let mut n = 0;
    while n < 17 {
        table[n][0] = 1.0;
        let mut i = 1;
        while i <= n {
            table[n][i] = table[n - 1][i - 1] + if i < n { table[n - 1][i] } else { 0.0 };
            i += 1;
        }
        n += 1;
    }
    table
};

fn minus<const D: usize>(a: &[f64; D], b: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|d| a[d] - b[d])
}

fn mix<const D: usize>(a: &[f64; D], b: &[f64; D], t: f64) -> [f64; D] {
    std::array::from_fn(|d| (1.0 - t) * a[d] + t * b[d])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn product_agrees_with_values() {
        let (a, b) = (vec![1.0, -2.0, 0.5], vec![0.25, 3.0, -1.0, 2.0]);
        let c = product(&a, &b);
        for t in [0.0, 0.25, 0.7, 1.0] {
            let value = |r: &[f64]| eval(&r.iter().map(|&v| [v]).collect::<Vec<_>>(), t)[0];
            assert!((value(&c) - value(&a) * value(&b)).abs() < 1e-15);
        }
    }

    #[test]
    fn derivatives_of_a_cube_at_any_degree() {
        // t³ has the coefficients C(i,3)/C(n,3); 20 is above the table of binomials.
        for n in [3, 5, 20] {
            let choose = |i: usize| if i < 3 { 0.0 } else { (i * (i - 1) * (i - 2) / 6) as f64 };
            let row: Vec<[f64; 1]> = (0..=n).map(|i| [choose(i) / choose(n)]).collect();
            for t in [0.0_f64, 0.3, 0.5, 1.0] {
                let got: [[f64; 1]; 4] = derivatives(&row, t);
                for (k, want) in [t * t * t, 3.0 * t * t, 6.0 * t, 6.0].into_iter().enumerate() {
                    // Third differences of rounded coefficients, times n(n-1)(n-2).
                    assert!((got[k][0] - want).abs() < 1e-15 * (n as f64).powi(k as i32), "{n} {t} {k}");
                }
            }
        }
        assert_eq!(derivatives::<1, 4>(&[[1.0], [3.0]], 0.25), [[1.5], [2.0], [0.0], [0.0]]);
    }

    #[test]
    fn division_undoes_the_product_with_a_linear_factor() {
        let quotient = [1.0, -2.0, 0.5, 3.0];
        for root in [0.0, 0.25, 0.6, 1.0] {
            let row: Vec<[f64; 1]> = product(&quotient, &[-root, 1.0 - root]).into_iter().map(|c| [c]).collect();
            let got = divided(&row, root).unwrap();
            assert!(got.iter().zip(quotient).all(|([g], w)| (g - w).abs() < 1e-14), "{root}: {got:?}");
        }
        assert!(divided(&[[1.0]], 0.5).is_none());
    }

    #[test]
    fn split_restricts() {
        let row = [[1.0, 0.0], [2.0, 5.0], [-1.0, 3.0], [0.5, 0.5]];
        let (l, r) = split(&row, 0.3);
        for s in [0.0, 0.4, 1.0] {
            let (a, b) = (eval(&l, s), eval(&row, 0.3 * s));
            let (c, d) = (eval(&r, s), eval(&row, 0.3 + 0.7 * s));
            for i in 0..2 {
                assert!((a[i] - b[i]).abs() < 1e-15 && (c[i] - d[i]).abs() < 1e-15);
            }
        }
    }
}
