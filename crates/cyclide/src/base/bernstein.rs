//! Polynomials in Bernstein form: products, de Casteljau, degree elevation.

/// Binomial coefficient as a float (exact up to `n = 60`).
#[must_use]
pub(crate) fn binomial(n: usize, k: usize) -> f64 {
    let k = k.min(n - k.min(n));
    (0..k).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64).round()
}

/// The Bernstein coefficients of the product of two polynomials (degrees add).
#[must_use]
pub(crate) fn product(a: &[f64], b: &[f64]) -> Vec<f64> {
    let (n, m) = (a.len() - 1, b.len() - 1);
    let mut out = vec![0.0; n + m + 1];
    for (i, &ai) in a.iter().enumerate() {
        for (j, &bj) in b.iter().enumerate() {
            out[i + j] += ai * bj * binomial(n, i) * binomial(m, j) / binomial(n + m, i + j);
        }
    }
    out
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

/// Value at `t` by nested multiplication (Farin's form of Horner's scheme): exact at both ends, no allocation.
#[must_use]
pub(crate) fn eval<const D: usize>(row: &[[f64; D]], t: f64) -> [f64; D] {
    derivative(row, 0, t)
}

/// The `k`-th derivative at `t` from the `k`-th differences of the coefficients; zero above the degree.
#[must_use]
pub(crate) fn derivative<const D: usize>(row: &[[f64; D]], k: usize, t: f64) -> [f64; D] {
    let n = row.len() - 1;
    if k > n {
        return [0.0; D];
    }
    let degree = n - k;
    // Coefficient i of the derivative: n!/(n-k)! times the k-th difference at i.
    let factor = (0..k).fold(1.0, |f, j| f * (n - j) as f64);
    let difference = |i: usize, d: usize| {
        (0..=k)
            .map(|j| {
                if (k - j).is_multiple_of(2) { binomial(k, j) * row[i + j][d] } else { -binomial(k, j) * row[i + j][d] }
            })
            .sum::<f64>()
    };
    let s = 1.0 - t;
    std::array::from_fn(|d| {
        if degree == 0 {
            return factor * difference(0, d);
        }
        let (mut power, mut choose) = (1.0, 1.0);
        let mut sum = difference(0, d) * s;
        for i in 1..degree {
            power *= t;
            choose *= (degree - i + 1) as f64 / i as f64;
            sum = (sum + power * choose * difference(i, d)) * s;
        }
        factor * (sum + power * t * difference(degree, d))
    })
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
