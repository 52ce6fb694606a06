//! Roots: the projective quadratic of arcs and a bracketed scalar solver.

/// The roots `[t, sigma]` (parameter `t/(t+sigma)`, both non-negative) of `A sigma² + 2 B sigma t + C t² = 0`
/// whose discriminant `B² - AC` is given as `root²` by a form without cancellation.
///
/// Roots at infinity of one coordinate are kept as `[0, 1]`, `[1, 0]`; `0:0` and sign-mixed pairs are dropped.
#[must_use]
pub(crate) fn projective_quadratic(a: f64, b: f64, c: f64, root: f64) -> [Option<f64>; 2] {
    let q = -(b + if b < 0.0 { -root } else { root });
    let parameter = |t: f64, sigma: f64| {
        let sum = t + sigma;
        // Signs, not their product: it underflows to a zero of either sign.
        let mixed = (t < 0.0 && sigma > 0.0) || (t > 0.0 && sigma < 0.0);
        (!mixed && (t != 0.0 || sigma != 0.0)).then(|| t / sum).filter(|t| t.is_finite())
    };
    [parameter(q, c), parameter(a, q)]
}

/// A zero of the function in `[a, b]`, whose ends must have values of opposite sign (or zero), by the
/// Illinois variant of false position with bisection as a safeguard; stops when the bracket is `width` or smaller.
#[must_use]
pub(crate) fn bracketed(mut f: impl FnMut(f64) -> f64, mut a: f64, mut b: f64, width: f64) -> f64 {
    let (mut fa, mut fb) = (f(a), f(b));
    if fa == 0.0 {
        return a;
    }
    if fb == 0.0 {
        return b;
    }
    for step in 0..200 {
        if (b - a).abs() <= width {
            break;
        }
        let secant = (a * fb - b * fa) / (fb - fa);
        let inside = secant > a.min(b) && secant < a.max(b);
        // Every third step halves the bracket, so 200 steps always suffice.
        let m = if inside && step % 3 != 2 { secant } else { 0.5 * (a + b) };
        if m <= a.min(b) || m >= a.max(b) {
            break;
        }
        let fm = f(m);
        if fm == 0.0 {
            return m;
        }
        if (fm < 0.0) == (fb < 0.0) {
            b = m;
            fb = fm;
            fa *= 0.5;
        } else {
            a = m;
            fa = fm;
            fb *= 0.5;
        }
    }
    0.5 * (a + b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quadratic_finds_both_roots_in_the_unit_interval() {
        // (t - sigma)(t - 3 sigma) = t² - 4 t sigma + 3 sigma²: parameters 1/2 and 3/4.
        let r = projective_quadratic(3.0, -2.0, 1.0, 1.0);
        let mut got: Vec<f64> = r.into_iter().flatten().collect();
        got.sort_by(f64::total_cmp);
        assert_eq!(got, [0.5, 0.75]);
        assert_eq!(projective_quadratic(0.0, 0.0, 0.0, 0.0), [None, None]);
        // Signs of tiny coefficients: t² = sigma² has one root with both positive.
        assert_eq!(projective_quadratic(-1e-170, 0.0, 1e-170, 1e-170).into_iter().flatten().collect::<Vec<_>>(), [0.5]);
    }

    #[test]
    fn bracketed_reaches_rounding() {
        let x = bracketed(|x| x * x - 2.0, 0.0, 2.0, 0.0);
        assert!((x - std::f64::consts::SQRT_2).abs() < 1e-15);
    }
}
