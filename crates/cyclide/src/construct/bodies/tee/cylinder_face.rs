//! Four-sided faces of a cylinder between two curves on it, exact and without poles
//! (`docs/math/canal-blends.md#faces-of-the-partners`).
//!
//! A curve on a cylinder has a half-angle vector `v` and a height. Between two of them run `(1-t) v1 + t v2`, whose square is the direction about the axis,
//! and in t quadratic heights.

use crate::error::Result;
use crate::rational::{Polynomial, PolynomialRow, RationalBezier, RationalBezierSurface};

/// A curve on a cylinder, rational over `[0, 1]`.
#[derive(Debug, Clone)]
pub(super) struct CylinderCurve {
    /// Half-angle vector `[cos, sin]`, of length 1 at both ends.
    half: [Polynomial; 2],
    /// Height along the axis times the weight, and the weight.
    height: Polynomial,
    weight: Polynomial,
}

/// An end of such a curve: half-angle vector of length 1 and height.
type End = ([f64; 2], f64);

/// Which cylinder: its axes as rows `[direction at angle 0, at a right angle, axis]`, the place of its axis, its radius.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placed {
    pub(super) columns: [[f64; 3]; 3],
    pub(super) origin: [f64; 3],
    pub(super) radius: f64,
}

impl CylinderCurve {
    /// From a half-angle vector of any length; it is turned round so that its sine is positive in the middle.
    pub(super) fn new(half: &[Polynomial; 2], height: &Polynomial, weight: &Polynomial) -> Self {
        let sign = half[1].value(0.5).signum();
        let inverse = |s: f64| sign / half[0].value(s).hypot(half[1].value(s));
        let factor = Polynomial::new(vec![inverse(0.0), inverse(1.0)]);
        Self { half: half.each_ref().map(|entry| entry * &factor), height: height.clone(), weight: weight.clone() }
    }

    /// The arc at a height from an angle to another one.
    pub(super) fn arc(angles: [f64; 2], height: f64) -> Self {
        let [(s0, c0), (s1, c1)] = angles.map(|angle| (0.5 * angle).sin_cos());
        let half = [Polynomial::new(vec![c0, c1]), Polynomial::new(vec![s0, s1])];
        Self { half, height: Polynomial::constant(height), weight: Polynomial::constant(1.0) }
    }

    /// The same points run backwards.
    pub(super) fn reversed(&self) -> Self {
        let back = |p: &Polynomial| Polynomial::new(p.coefficients().iter().rev().copied().collect());
        Self { half: self.half.each_ref().map(back), height: back(&self.height), weight: back(&self.weight) }
    }

    /// The end at the parameter 0 or 1.
    pub(super) fn end(&self, s: f64) -> End {
        (self.half.each_ref().map(|entry| entry.value(s)), self.height.value(s) / self.weight.value(s))
    }

    /// Its rational form on a cylinder.
    pub(super) fn curve(&self, on: &Placed) -> Result<RationalBezier> {
        let circle = squares(&self.half, &self.half);
        let row = on.row(&circle, &(&self.height * &circle[2]), &self.weight);
        let degree = row.0.iter().map(Polynomial::degree).max().unwrap_or(0);
        let entries = row.0.each_ref().map(|entry| entry.elevated(degree));
        RationalBezier::new((0..=degree).map(|i| entries.each_ref().map(|entry| entry.coefficients()[i])).collect())
    }
}

impl Placed {
    /// A homogeneous row from `[cos, sin, 1]` of a direction times some factor, the height times that factor and the weight, and the weight.
    fn row(&self, circle: &[Polynomial; 3], height: &Polynomial, weight: &Polynomial) -> PolynomialRow {
        let [x, y, one] = circle.each_ref().map(|entry| entry * weight);
        let [u, v, axis] = self.columns;
        let entry = |k: usize| {
            let across = &(&x * (u[k] * self.radius)) + &(&y * (v[k] * self.radius));
            &(&across + &(height * axis[k])) + &(&one * self.origin[k])
        };
        PolynomialRow([entry(0), entry(1), entry(2), one.clone()])
    }

    /// The face from one curve to another; in t heights have gone the part `bias` of their way in the middle coefficient.
    pub(super) fn face(&self, [first, second]: [&CylinderCurve; 2], bias: f64) -> Result<RationalBezierSurface> {
        let weight = &first.weight * &second.weight;
        let heights = [&first.height * &second.weight, &second.height * &first.weight];
        let row = |p: &[Polynomial; 2], q: &[Polynomial; 2], height: &Polynomial| {
            let circle = squares(p, q);
            self.row(&circle, &(height * &circle[2]), &weight)
        };
        let middle = &(&heights[0] * (1.0 - bias)) + &(&heights[1] * bias);
        RationalBezierSurface::from_polynomial_rows(&[
            row(&first.half, &first.half, &heights[0]),
            row(&first.half, &second.half, &middle),
            row(&second.half, &second.half, &heights[1]),
        ])
    }

    /// The ruled face along the axis between two curves with the same directions.
    pub(super) fn ruled_face(&self, [first, second]: [&CylinderCurve; 2]) -> Result<RationalBezierSurface> {
        let weight = &first.weight * &second.weight;
        let row = |curve: &CylinderCurve, height: &Polynomial| {
            let circle = squares(&curve.half, &curve.half);
            self.row(&circle, &(height * &circle[2]), &weight)
        };
        RationalBezierSurface::from_polynomial_rows(&[
            row(first, &(&first.height * &second.weight)),
            row(second, &(&second.height * &first.weight)),
        ])
    }

    /// The side of such faces between two ends.
    pub(super) fn side(&self, [(p, from), (q, to)]: [End; 2], bias: f64) -> Result<RationalBezier> {
        let constant = |end: [f64; 2]| end.map(Polynomial::constant);
        let row = |p: [f64; 2], q: [f64; 2], height: f64| {
            let circle = squares(&constant(p), &constant(q));
            let row = self.row(&circle, &(&circle[2] * height), &Polynomial::constant(1.0));
            row.0.each_ref().map(|entry| entry.value(0.0))
        };
        RationalBezier::new(vec![row(p, p, from), row(p, q, from + bias * (to - from)), row(q, q, to)])
    }
}

/// `[cos, sin, 1]` of twice the angle, from two half-angle vectors.
fn squares([a, b]: &[Polynomial; 2], [c, d]: &[Polynomial; 2]) -> [Polynomial; 3] {
    let (ac, bd) = (a * c, b * d);
    [&ac - &bd, &(a * d) + &(b * c), &ac + &bd]
}
