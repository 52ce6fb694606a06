//! Products of two bilinear or trilinear forms in Bernstein form: biquadratic, triquadratic.
//!
//! A form `sum a_k B_k` over the corners k of a square or a cube, binary order, first parameter fastest, with values in any algebra;
//! the product `sum a_k b_l B_k B_l` has at `[i][j]` (`[i][j][k]`) the products whose bits add up to these, over the binomials.

/// Binomials of degree 2.
const CHOOSE: [f64; 3] = [1.0, 2.0, 1.0];

/// The Bernstein coefficients `[i][j]`, i along s, of a biquadratic given by its sixteen products of corners.
pub(crate) fn biquadratic<const D: usize>(product: impl Fn(usize, usize) -> [f64; D]) -> [[[f64; D]; 3]; 3] {
    let mut sum = [[[0.0; D]; 3]; 3];
    for k in 0..4 {
        for l in 0..4 {
            let at = &mut sum[(k & 1) + (l & 1)][(k >> 1) + (l >> 1)];
            at.iter_mut().zip(product(k, l)).for_each(|(sum, value)| *sum += value);
        }
    }
    for (i, row) in sum.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            entry.iter_mut().for_each(|v| *v /= CHOOSE[i] * CHOOSE[j]);
        }
    }
    sum
}

/// The Bernstein coefficients, i along s, of a triquadratic given by its 64 products of corners: `[i][j][k]` at `9 i + 3 j + k`.
pub(crate) fn triquadratic<const D: usize>(product: impl Fn(usize, usize) -> [f64; D]) -> [[f64; D]; 27] {
    let mut sum = [[0.0; D]; 27];
    let bits = |k: usize| [k & 1, (k >> 1) & 1, k >> 2];
    let place = |[i, j, k]: [usize; 3]| 9 * i + 3 * j + k;
    for k in 0..8 {
        for l in 0..8 {
            let (a, b) = (bits(k), bits(l));
            let at = &mut sum[place([a[0] + b[0], a[1] + b[1], a[2] + b[2]])];
            at.iter_mut().zip(product(k, l)).for_each(|(sum, value)| *sum += value);
        }
    }
    for (at, entry) in sum.iter_mut().enumerate() {
        let divisor = CHOOSE[at / 9] * CHOOSE[at / 3 % 3] * CHOOSE[at % 3];
        entry.iter_mut().for_each(|v| *v /= divisor);
    }
    sum
}
