//! Cubic splines through values at times, and the smoothing spline of C. H. Reinsch (*Smoothing by spline functions*, Numer. Math. 10 (1967), 177-183):
//! of all curves the one with the least `Σ w_i |y_i − x_i|² + λ ∫|x″|²`, by a banded system in its second derivatives, in linear time.

/// Values of the natural cubic spline that smooths others with a strength λ, of which the weights are those of the single values.
pub(super) fn smoothed<const D: usize>(
    values: &[[f64; D]],
    steps: &[f64],
    weights: &[f64],
    strength: f64,
) -> Vec<[f64; D]> {
    let count = values.len() - 2;
    let own = |i: usize| strength / weights[i];
    // Of knot j + 1: the second difference is a y_j − (a + b) y_{j+1} + b y_{j+2}.
    let inverse = |j: usize| [1.0 / steps[j], 1.0 / steps[j + 1]];
    let differences = |row: &[[f64; D]], j: usize| -> [f64; D] {
        let [a, b] = inverse(j);
        std::array::from_fn(|d| a * (row[j][d] - row[j + 1][d]) + b * (row[j + 2][d] - row[j + 1][d]))
    };
    // L D Lᵀ of R + λ Qᵀ W⁻¹ Q, row by row.
    let mut diagonal = vec![0.0; count];
    let mut first = vec![0.0; count];
    let mut second = vec![0.0; count];
    let mut right: Vec<[f64; D]> = (0..count).map(|j| differences(values, j)).collect();
    for j in 0..count {
        let [a, b] = inverse(j);
        let mut d =
            (steps[j] + steps[j + 1]) / 3.0 + own(j) * a * a + own(j + 1) * (a + b) * (a + b) + own(j + 2) * b * b;
        let (mut e, mut f) = (0.0, 0.0);
        if j + 1 < count {
            let [next, after] = inverse(j + 1);
            e = steps[j + 1] / 6.0 - own(j + 1) * (a + b) * next - own(j + 2) * b * (next + after);
        }
        if j + 2 < count {
            f = own(j + 2) * b * inverse(j + 2)[0];
        }
        if j > 0 {
            d -= first[j - 1] * first[j - 1] * diagonal[j - 1];
            e -= first[j - 1] * second[j - 1] * diagonal[j - 1];
            right[j] = std::array::from_fn(|k| right[j][k] - first[j - 1] * right[j - 1][k]);
        }
        if j > 1 {
            d -= second[j - 2] * second[j - 2] * diagonal[j - 2];
            right[j] = std::array::from_fn(|k| right[j][k] - second[j - 2] * right[j - 2][k]);
        }
        (diagonal[j], first[j], second[j]) = (d, e / d, f / d);
    }
    for j in (0..count).rev() {
        let one = if j + 1 < count { right[j + 1] } else { [0.0; D] };
        let two = if j + 2 < count { right[j + 2] } else { [0.0; D] };
        right[j] = std::array::from_fn(|k| right[j][k] / diagonal[j] - first[j] * one[k] - second[j] * two[k]);
    }
    // x = y − λ W⁻¹ Q γ.
    let bend = |j: usize| right.get(j).copied().unwrap_or([0.0; D]);
    (0..values.len())
        .map(|i| {
            let mut x = values[i];
            let mut less = |j: usize, factor: f64| {
                let gamma = bend(j);
                x = std::array::from_fn(|k| x[k] - own(i) * factor * gamma[k]);
            };
            if i < count {
                less(i, inverse(i)[0]);
            }
            if i > 0 && i <= count {
                let [a, b] = inverse(i - 1);
                less(i - 1, -(a + b));
            }
            if i > 1 {
                less(i - 2, inverse(i - 2)[1]);
            }
            x
        })
        .collect()
}

/// The derivatives at its values of the natural cubic spline through them, by time.
pub(super) fn natural_derivatives<const D: usize>(values: &[[f64; D]], steps: &[f64]) -> Vec<[f64; D]> {
    let last = steps.len();
    let slope = |i: usize| -> [f64; D] { std::array::from_fn(|k| (values[i + 1][k] - values[i][k]) / steps[i]) };
    if last == 1 {
        return vec![slope(0); 2];
    }
    // a d_{i−1} + b d_i + c d_{i+1} = r, diagonally dominant.
    let row = |i: usize| -> ([f64; 3], [f64; D]) {
        match i {
            0 => ([0.0, 2.0, 1.0], slope(0).map(|v| 3.0 * v)),
            i if i == last => ([1.0, 2.0, 0.0], slope(last - 1).map(|v| 3.0 * v)),
            i => {
                let [before, after] = [1.0 / steps[i - 1], 1.0 / steps[i]];
                let ([s, t], both) = ([slope(i - 1), slope(i)], 2.0 * (before + after));
                ([before, both, after], std::array::from_fn(|k| 3.0 * (before * s[k] + after * t[k])))
            }
        }
    };
    let (mut above, mut right) = (vec![0.0; last + 1], vec![[0.0; D]; last + 1]);
    for i in 0..=last {
        let ([a, b, c], r) = row(i);
        let (from, before) = if i > 0 { (above[i - 1], right[i - 1]) } else { (0.0, [0.0; D]) };
        let pivot = b - a * from;
        above[i] = c / pivot;
        right[i] = std::array::from_fn(|k| (r[k] - a * before[k]) / pivot);
    }
    for i in (0..last).rev() {
        right[i] = std::array::from_fn(|k| right[i][k] - above[i] * right[i + 1][k]);
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The values minimize what is said: no change of one makes it less, by the integral of the spline through the values.
    #[test]
    fn no_value_is_better_elsewhere() {
        let steps = [1.0, 0.5, 2.0, 1.0, 0.7, 1.3];
        let values = [[0.0], [1.0], [-0.5], [2.0], [0.3], [1.0], [0.9]];
        let (weights, strength) = ([1.0, 2.0, 1.0, 0.5, 1.0, 1.0, 3.0], 0.3);
        let cost = |x: &[[f64; 1]]| {
            let d = natural_derivatives(x, &steps);
            let bends = (0..steps.len()).map(|i| {
                let h = steps[i];
                let s = (x[i + 1][0] - x[i][0]) / h;
                let ends = [6.0 * s - 4.0 * d[i][0] - 2.0 * d[i + 1][0], 2.0 * d[i][0] + 4.0 * d[i + 1][0] - 6.0 * s];
                let [a, b] = ends.map(|v| v / h);
                h * (a * a + a * b + b * b) / 3.0
            });
            let off = x.iter().zip(&values).zip(&weights).map(|((x, y), w)| w * (x[0] - y[0]).powi(2));
            off.sum::<f64>() + strength * bends.sum::<f64>()
        };
        let best = smoothed(&values, &steps, &weights, strength);
        for i in 0..values.len() {
            for step in [1e-3, -1e-3] {
                let mut other = best.clone();
                other[i][0] += step;
                assert!(cost(&other) > cost(&best), "{i}");
            }
        }
    }
}
