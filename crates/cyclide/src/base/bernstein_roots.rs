//! Real roots of polynomials in Bernstein form, by signs of coefficients and halving.

use super::bernstein;
use super::roots::bracketed;

/// Coefficients up to this part of the largest are zero: rounding of what they were made from.
const ZERO: f64 = 1e-15;

/// Halvings of `[0, 1]`; what still has several changes of sign then is one root of higher order.
const HALVINGS: u32 = 45;

/// The roots in `[0, 1]`, in order. A root of even order is found where rounding leaves a change of sign, or none at all: then
/// it is where the halving ends. None of the zero polynomial.
pub(crate) fn roots(coefficients: &[f64]) -> Vec<f64> {
    let largest = coefficients.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
    if !(largest > 0.0) {
        return Vec::new();
    }
    let all: Vec<[f64; 1]> = coefficients.iter().map(|c| [*c]).collect();
    let zero = ZERO * largest;
    let mut found = Vec::new();
    let mut ahead = vec![(all.clone(), 0.0, 1.0, HALVINGS)];
    while let Some((row, from, to, halvings)) = ahead.pop() {
        let middle: f64 = 0.5 * (from + to);
        let signs = || row.iter().map(|[c]| *c).filter(|c| c.abs() > zero);
        let changes = signs().zip(signs().skip(1)).filter(|(a, b)| (*a < 0.0) != (*b < 0.0)).count();
        let (first, last) = (row[0][0], row[row.len() - 1][0]);
        if signs().next().is_none() {
            found.push(middle);
        } else if changes == 0 {
            found.extend([(first, from), (last, to)].iter().filter(|(c, _)| c.abs() <= zero).map(|(_, t)| *t));
        } else if changes == 1 && first * last < 0.0 {
            found.push(bracketed(|t| bernstein::eval(&all, t)[0], from, to, 0.0));
        } else if halvings == 0 {
            found.push(middle);
        } else {
            let (left, right) = bernstein::split(&row, 0.5);
            ahead.extend([(right, middle, to, halvings - 1), (left, from, middle, halvings - 1)]);
        }
    }
    found.dedup_by(|a, b| (*a - *b).abs() <= 4.0 * f64::EPSILON);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_roots(places: &[f64]) -> Vec<f64> {
        places.iter().fold(vec![1.0], |product, t| bernstein::product(&product, &[-t, 1.0 - t]))
    }

    #[test]
    fn simple_roots_are_found_to_rounding() {
        for places in [vec![0.25], vec![0.1, 0.5, 0.9], vec![0.3, 0.30001, 0.7], vec![-1.0, 0.2, 2.0]] {
            let want: Vec<f64> = places.iter().copied().filter(|t| (0.0..=1.0).contains(t)).collect();
            let got = roots(&with_roots(&places));
            assert_eq!(got.len(), want.len(), "{got:?}");
            // Roots 1e-5 apart are known to 1e-16/1e-5.
            assert!(got.iter().zip(&want).all(|(g, w)| (g - w).abs() < 1e-10), "{got:?}");
        }
    }

    #[test]
    fn roots_at_the_ends_and_none() {
        assert_eq!(roots(&with_roots(&[0.0, 1.0])), [0.0, 1.0]);
        assert!(roots(&[1.0, 0.5, 2.0]).is_empty() && roots(&[0.0, 0.0]).is_empty());
    }

    #[test]
    fn double_roots_are_near() {
        // Known to the root of rounding.
        let got = roots(&with_roots(&[0.4, 0.4]));
        assert!(!got.is_empty() && got.iter().all(|t| (t - 0.4).abs() < 1e-7), "{got:?}");
    }
}
