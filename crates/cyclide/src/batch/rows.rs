//! Rows of quotients of real quadratics over one common denominator.

use multiversion::multiversion;

/// Coefficients of a real quadratic, constant first.
type Quadratic = [f64; 3];

fn trimmed<const N: usize>(s: &[f64], out: &[&mut [f64]; N]) -> usize {
    out.iter().map(|lane| lane.len()).fold(s.len(), usize::min)
}

/// `origin + numerator/denominator` at every parameter, one lane per coordinate. As many as the shortest slice holds.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq+fma", "x86_64+avx2+fma"))]
pub(crate) fn points(
    numerators: &[Quadratic; 3],
    denominator: Quadratic,
    origin: [f64; 3],
    s: &[f64],
    out: [&mut [f64]; 3],
) {
    let n = trimmed(s, &out);
    // Slices of one length: the loop has no bounds to check.
    let [x, y, z] = out.map(|lane| &mut lane[..n]);
    for (((s, x), y), z) in s[..n].iter().zip(x).zip(y).zip(z) {
        let at = |c: Quadratic| c[0] + s * (c[1] + s * c[2]);
        let inverse = 1.0 / at(denominator);
        *x = origin[0] + at(numerators[0]) * inverse;
        *y = origin[1] + at(numerators[1]) * inverse;
        *z = origin[2] + at(numerators[2]) * inverse;
    }
}

/// As [`points`], with three more quotients over the same denominator that are not shifted by the origin.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq+fma", "x86_64+avx2+fma"))]
pub(crate) fn points_and_directions(
    numerators: &[[Quadratic; 3]; 2],
    denominator: Quadratic,
    origin: [f64; 3],
    s: &[f64],
    points: [&mut [f64]; 3],
    directions: [&mut [f64]; 3],
) {
    let n = trimmed(s, &points).min(trimmed(s, &directions));
    let ([x, y, z], [u, v, w]) = (points.map(|lane| &mut lane[..n]), directions.map(|lane| &mut lane[..n]));
    let [position, direction] = numerators;
    for ((((((s, x), y), z), u), v), w) in s[..n].iter().zip(x).zip(y).zip(z).zip(u).zip(v).zip(w) {
        let at = |c: Quadratic| c[0] + s * (c[1] + s * c[2]);
        let inverse = 1.0 / at(denominator);
        *x = origin[0] + at(position[0]) * inverse;
        *y = origin[1] + at(position[1]) * inverse;
        *z = origin[2] + at(position[2]) * inverse;
        *u = at(direction[0]) * inverse;
        *v = at(direction[1]) * inverse;
        *w = at(direction[2]) * inverse;
    }
}

/// As [`points`], with the product of two more quadratics and a factor over the third power of the denominator.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq+fma", "x86_64+avx2+fma"))]
pub(crate) fn points_and_products(
    numerators: &[Quadratic; 3],
    (factor, factors): (f64, [Quadratic; 2]),
    denominator: Quadratic,
    origin: [f64; 3],
    s: &[f64],
    points: [&mut [f64]; 3],
    products: &mut [f64],
) {
    let n = trimmed(s, &points).min(products.len());
    let ([x, y, z], products) = (points.map(|lane| &mut lane[..n]), &mut products[..n]);
    for ((((s, x), y), z), product) in s[..n].iter().zip(x).zip(y).zip(z).zip(products) {
        let at = |c: Quadratic| c[0] + s * (c[1] + s * c[2]);
        let inverse = 1.0 / at(denominator);
        *x = origin[0] + at(numerators[0]) * inverse;
        *y = origin[1] + at(numerators[1]) * inverse;
        *z = origin[2] + at(numerators[2]) * inverse;
        *product = (factor * inverse) * (at(factors[0]) * inverse) * (at(factors[1]) * inverse);
    }
}
