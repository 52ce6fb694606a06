//! Gauss–Legendre quadrature with error control by halving.

use std::collections::BinaryHeap;

/// Nodes and weights of the rules of 2, 4 and 8 points on [-1, 1] (positive half).
const NODES_2: [(f64, f64); 1] = [(0.577_350_269_189_625_8, 1.0)];
const NODES_4: [(f64, f64); 2] =
    [(0.339_981_043_584_856_26, 0.652_145_154_862_546_1), (0.861_136_311_594_052_6, 0.347_854_845_137_453_85)];
const NODES_8: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_27),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// Nodes and weights of the 4-point rule on `[0, 1]`.
#[must_use]
pub(crate) fn unit_rule4() -> [(f64, f64); 4] {
    let [(x0, w0), (x1, w1)] = NODES_4;
    [(-x1, w1), (-x0, w0), (x0, w0), (x1, w1)].map(|(x, w)| (0.5 * (1.0 + x), 0.5 * w))
}

/// Nodes and weights of the 2-point rule on `[0, 1]`.
#[must_use]
pub(crate) fn unit_rule2() -> [(f64, f64); 2] {
    let [(x, w)] = NODES_2;
    [(-x, w), (x, w)].map(|(x, w)| (0.5 * (1.0 + x), 0.5 * w))
}

/// Nodes and weights of the 8-point rule on `[0, 1]`.
#[must_use]
pub(crate) fn unit_rule8() -> [(f64, f64); 8] {
    std::array::from_fn(|k| {
        let ((x, w), sign) = (NODES_8[k / 2], if k % 2 == 0 { -1.0 } else { 1.0 });
        (0.5 * (1.0 + sign * x), 0.5 * w)
    })
}

/// The 8-point rule on one interval, exact for degree 15.
#[must_use]
pub(crate) fn gauss8(f: &mut impl FnMut(f64) -> f64, a: f64, b: f64) -> f64 {
    gauss(&NODES_8, f, a, b)
}

/// The 2-point rule, exact for degree 3.
#[must_use]
pub(crate) fn gauss2(f: &mut impl FnMut(f64) -> f64, a: f64, b: f64) -> f64 {
    gauss(&NODES_2, f, a, b)
}

/// The 4-point rule, exact for degree 7.
#[must_use]
pub(crate) fn gauss4(f: &mut impl FnMut(f64) -> f64, a: f64, b: f64) -> f64 {
    gauss(&NODES_4, f, a, b)
}

fn gauss<const N: usize>(nodes: &[(f64, f64); N], f: &mut impl FnMut(f64) -> f64, a: f64, b: f64) -> f64 {
    let (m, h) = (0.5 * (a + b), 0.5 * (b - a));
    h * nodes.iter().map(|&(x, w)| w * (f(m - h * x) + f(m + h * x))).sum::<f64>()
}

/// One quadrature and its two halves agree to this part of the integral: the rule is exact for degree 15, so the
/// halves are better by orders of magnitude.
const AGREEMENT: f64 = 1e-13;
/// Halvings of an interval: far above what a smooth function or an isolated singularity needs.
const HALVINGS: usize = 4096;

/// A part of an interval of integration on which one 8-point rule is good.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cell {
    /// Ends.
    pub(crate) a: f64,
    pub(crate) b: f64,
    /// The integral over it: the sum of the rules on its two halves.
    pub(crate) integral: f64,
    halves: [f64; 2],
    /// Disagreement of the rule with its halves.
    error: f64,
}

impl Cell {
    fn new(f: &mut impl FnMut(f64) -> f64, a: f64, b: f64, whole: f64) -> Self {
        let m = 0.5 * (a + b);
        let halves = [gauss8(f, a, m), gauss8(f, m, b)];
        let integral = halves[0] + halves[1];
        Self { a, b, integral, halves, error: (integral - whole).abs() }
    }
}

/// By error, for the heap.
impl Ord for Cell {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.error.total_cmp(&other.error)
    }
}
impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Cell {}

/// Cuts `[a, b]` into parts, in order, on each of which the 8-point rule agrees with its halves to 1e-13 of the whole
/// integral.
///
/// The worst part is halved first. So a function whose own rounding is above that, which would be halved for ever,
/// spends its 4096 halvings where they matter, and a peak that the first rule missed raises the integral and with it
/// what counts as good.
#[must_use]
pub(crate) fn cells(f: &mut impl FnMut(f64) -> f64, a: f64, b: f64) -> Vec<Cell> {
    let whole = gauss8(f, a, b);
    let first = Cell::new(f, a, b, whole);
    let mut sum = first.integral;
    let mut heap = BinaryHeap::from([first]);
    for _ in 0..HALVINGS {
        let Some(worst) = heap.pop() else { break };
        // Not `<=`: a NaN is not worth halving either.
        if !(worst.error > AGREEMENT * sum.abs()) {
            heap.push(worst);
            break;
        }
        let m = 0.5 * (worst.a + worst.b);
        if m <= worst.a || m >= worst.b {
            // Neighboring doubles.
            heap.push(Cell { error: 0.0, ..worst });
            continue;
        }
        let [l, r] = [(worst.a, m, 0), (m, worst.b, 1)].map(|(a, b, i)| Cell::new(f, a, b, worst.halves[i]));
        sum += l.integral + r.integral - worst.integral;
        heap.extend([l, r]);
    }
    let mut cells = heap.into_vec();
    cells.sort_unstable_by(|x, y| x.a.total_cmp(&y.a));
    cells
}

/// The place in `[a, b]` up to which the integral of a function that is not negative is `rest` of the whole: Newton steps kept in a
/// bracket. One 8-point rule must give the integral over the cell.
#[must_use]
pub(crate) fn invert(f: &mut impl FnMut(f64) -> f64, [a, b]: [f64; 2], whole: f64, rest: f64) -> f64 {
    invert_from(f, [a, b], rest, a + (b - a) * (rest / whole))
}

/// As [`invert`], from a place that is better than that by the part of the whole.
#[must_use]
pub(crate) fn invert_from(f: &mut impl FnMut(f64) -> f64, [a, b]: [f64; 2], rest: f64, start: f64) -> f64 {
    let (mut low, mut high) = (a, b);
    let mut s = start;
    for _ in 0..64 {
        let error = gauss8(f, a, s) - rest;
        if error < 0.0 {
            low = s;
        } else {
            high = s;
        }
        let next = s - error / f(s);
        let next = if next >= low && next <= high { next } else { 0.5 * (low + high) };
        let moved = (next - s).abs();
        s = next;
        // The error after a Newton step is of the order of the square of the step.
        if moved <= 1e-9 * (b - a) || error == 0.0 {
            break;
        }
    }
    s
}

/// Integral of `f` over `[a, b]` to about 1e-13 of itself (or to the rounding of `f`, whichever is larger).
#[must_use]
pub(crate) fn integrate(f: &mut impl FnMut(f64) -> f64, a: f64, b: f64) -> f64 {
    cells(f, a, b).iter().map(|cell| cell.integral).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integrates_to_tolerance() {
        let got = integrate(&mut f64::sqrt, 0.0, 1.0);
        assert!((got - 2.0 / 3.0).abs() < 1e-12);
        // Noise far above the tolerance must not halve for ever, and must not move the result by more than itself.
        let got = integrate(&mut |x: f64| 1.0 + 1e-9 * (1e9 * x).sin(), 0.0, 1.0);
        assert!((got - 1.0).abs() < 1e-9);
        let got = integrate(&mut |x: f64| x.powi(15), 0.0, 1.0);
        assert!((got - 1.0 / 16.0).abs() < 1e-16);
        // A peak a million times as high as the first rule sees, on noise: integral 2 atan(1/w)/w.
        let w = 1e-6;
        let got = integrate(&mut |x: f64| 1.0 / (x * x + w * w) * (1.0 + 1e-10 * (1e9 * x).sin()), -1.0, 1.0);
        assert!((got * w / 2.0 / (1.0_f64 / w).atan() - 1.0).abs() < 1e-9);
        assert!(integrate(&mut |_| f64::NAN, 0.0, 1.0).is_nan());
    }
}
