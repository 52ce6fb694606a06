//! Whether a planar ruled face keeps its sense everywhere.
//!
//! Between the curves `a(s)` and `b(s)` in homogeneous coordinates of the plane the face is `F = (1-t) a + t b`, and its Jacobian
//! `det(F, F_s, F_t) / w³` with
//!
//! ```text
//! det(F, F_s, F_t) = (1-t) det(a, a', b) + t det(a, b', b)
//! ```
//!
//! so that two polynomials of s decide. They are positive where their Bernstein coefficients are, on parts of the interval.

use crate::base::bernstein;

/// Coefficients of faces that bend are above this part of their size squared: normals lose no more than half of their digits.
const LEAST: f64 = 1e-7;
/// Those of straight faces are above their rounding.
const LEAST_STRAIGHT: f64 = 1e-14;
/// Halvings of the interval.
const HALVINGS: u32 = 5;

type Row = [f64; 3];

/// True if the ruled face between two rows with the same weights at their ends has a positive Jacobian, but at points which are sides.
pub(super) fn keeps_sense(a: &[Row], b: &[Row]) -> bool {
    let Some(&[x, y, w]) = a.first() else { return false };
    let origin = [x / w, y / w];
    let [a, b] = [a, b].map(|rows| rows.iter().map(|&row| moved(row, origin)).collect::<Vec<Row>>());
    let size = a.iter().chain(&b).map(|&[x, y, w]| (x / w).hypot(y / w)).fold(0.0, f64::max);
    let straight = a.len() <= 2 && b.len() <= 2;
    let limit = size * size * if straight { LEAST_STRAIGHT } else { LEAST };
    // Not `<=`: nothing is known where it is no number.
    if !(limit > 0.0) {
        return false;
    }
    let ends = [0, 1].map(|end: usize| {
        let [p, q] = [&a, &b].map(|rows| if end == 0 { rows[0] } else { rows[rows.len() - 1] });
        (p[0] / p[2] - q[0] / q[2]).hypot(p[1] / p[2] - q[1] / q[2]) <= LEAST_STRAIGHT * size
    });
    let [point_a, point_b] = [&a, &b].map(|rows| is_point(rows, size));
    let first = || determinant([&a, &derivative(&a), &b]);
    let second = || determinant([&a, &derivative(&b), &b]);
    let positive = |coefficients: Vec<f64>| is_positive(&coefficients, limit, ends, HALVINGS);
    (point_a || positive(first())) && (point_b || positive(second()))
}

fn moved([x, y, w]: Row, [u, v]: [f64; 2]) -> Row {
    [x - u * w, y - v * w, w]
}

/// Whether all places of a row are one.
fn is_point(rows: &[Row], size: f64) -> bool {
    let [x, y, w] = rows[0];
    rows.iter().all(|&[u, v, g]| (u / g - x / w).hypot(v / g - y / w) <= LEAST_STRAIGHT * size)
}

fn derivative(rows: &[Row]) -> Vec<Row> {
    let n = (rows.len() - 1) as f64;
    rows.windows(2).map(|pair| [0, 1, 2].map(|d: usize| n * (pair[1][d] - pair[0][d]))).collect()
}

/// The Bernstein coefficients of the determinant of three rows.
fn determinant(rows: [&[Row]; 3]) -> Vec<f64> {
    let [a, b, c] = rows.map(|row| [0, 1, 2].map(|d: usize| row.iter().map(|r| r[d]).collect::<Vec<f64>>()));
    let minor = |i: usize, j: usize| {
        let [plus, minus] = [bernstein::product(&b[i], &c[j]), bernstein::product(&b[j], &c[i])];
        plus.iter().zip(&minus).map(|(p, m)| p - m).collect::<Vec<f64>>()
    };
    let [x, y, w] = [(0, 1, 2), (1, 2, 0), (2, 0, 1)].map(|(d, i, j)| bernstein::product(&a[d], &minor(i, j)));
    x.iter().zip(&y).zip(&w).map(|((x, y), w)| x + y + w).collect()
}

/// Whether a polynomial is above a limit. At ends where the curves meet it vanishes, once or in a cusp twice, and grows from there: all
/// else is compared with its largest coefficient.
fn is_positive(coefficients: &[f64], limit: f64, meet: [bool; 2], halvings: u32) -> bool {
    let count = coefficients.len();
    let largest = coefficients.iter().map(|value| value.abs()).fold(0.0, f64::max);
    let [least, rounding] =
        if meet.contains(&true) { [LEAST * largest, LEAST_STRAIGHT * largest] } else { [limit, 0.0] };
    let at_end = |k: usize| (meet[0] && k < 2) || (meet[1] && k + 2 >= count);
    if largest > 0.0 && (0..count).all(|k| coefficients[k] > if at_end(k) { -rounding } else { least }) {
        return true;
    }
    if halvings == 0 || coefficients.iter().all(|&value| value <= least) {
        return false;
    }
    let rows: Vec<[f64; 1]> = coefficients.iter().map(|&value| [value]).collect();
    let (left, right) = bernstein::split(&rows, 0.5);
    let [left, right] = [left, right].map(|rows| rows.into_iter().map(|[value]| value).collect::<Vec<f64>>());
    is_positive(&left, limit, [meet[0], false], halvings - 1)
        && is_positive(&right, limit * if meet[0] || meet[1] { LEAST } else { 1.0 }, [false, meet[1]], halvings - 1)
}
