//! The envelope of the balls of a piece of the loop, between their contacts: exact, of degree (12, 2)
//! (`docs/math/pipe-tees.md#canal`).

use super::crossing::{Crossing, PieceForms};
use super::loop_piece::LoopPiece;
use crate::base::bernstein;
use crate::base::quat::Quat;
use crate::error::Result;
use crate::rational::{Polynomial, PolynomialRow, RationalBezier, RationalBezierSurface};

/// Four polynomials as a quaternion in the axes of the branch.
type QuatForm = [Polynomial; 4];

/// The canal of a piece: its balls, and the quaternions that turn the direction of the branch into the normals at both contacts.
pub(super) struct Canal<'a> {
    crossing: &'a Crossing,
    /// How far below the outer skin: radii of pipes are smaller by that, radii of balls larger.
    depth: f64,
    pub(super) forms: PieceForms,
    ends: [QuatForm; 2],
}

impl<'a> Canal<'a> {
    pub(super) fn new(crossing: &'a Crossing, piece: &LoopPiece, depth: f64) -> Self {
        let forms = crossing.forms(piece);
        let (lean_sin, lean_cos) = crossing.half_lean().sin_cos();
        let [c, s] = &forms.on_branch;
        let [k0, k3] = &forms.factor;
        let minus = |p: &Polynomial| p * -1.0;
        // (c - s e1 + c e2 + s e3)(k0 - k3 e3)
        let first = [
            &(c * k0) + &(s * k3),
            &minus(&(s * k0)) + &minus(&(c * k3)),
            &(c * k0) + &minus(&(s * k3)),
            &(s * k0) + &minus(&(c * k3)),
        ];
        let [c, s] = &forms.on_main;
        let second = [c * lean_cos, s * -lean_cos, c * lean_sin, s * lean_sin];
        let size = |q: &QuatForm, end: usize| {
            let at = |p: &Polynomial| *p.coefficients().get(if end == 0 { 0 } else { p.degree() }).unwrap_or(&0.0);
            q.iter().map(|p| at(p) * at(p)).sum::<f64>().sqrt()
        };
        // Both contacts weigh as much at the ends, and the shorter arc is meant.
        let sign = if dot(&first, &second).coefficients().iter().sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
        let even = Polynomial::new([0, 1].map(|end| sign * size(&first, end) / size(&second, end)).to_vec());
        let second = second.map(|p| &p * &even);
        Self { crossing, depth, forms, ends: [first, second] }
    }

    /// The surface: s along the loop, t from the branch to the main pipe.
    pub(super) fn surface(&self) -> Result<RationalBezierSurface> {
        let forms = &self.forms;
        let radius = self.radius();
        let centre = [&forms.across[0], &forms.across[1], &forms.height];
        let row = |a: &QuatForm, b: &QuatForm| {
            let norm = dot(a, b);
            let way = turned(a, b);
            let at = |d: usize| &(centre[d] * &norm) + &(&(&radius * &way[d]) * -1.0);
            self.placed([at(0), at(1), at(2)], &forms.weight * &norm)
        };
        let [a, b] = &self.ends;
        RationalBezierSurface::from_polynomial_rows(&[row(a, a), row(a, b), row(b, b)])
    }

    /// The radius of the balls times the weight.
    pub(super) fn radius(&self) -> Polynomial {
        &self.forms.reach + &(&self.forms.weight * (self.depth - self.crossing.radii[0]))
    }

    /// The ratio of the weights of the arc between the contacts at an end of the piece.
    pub(super) fn arc_ratio(&self, end: f64) -> Option<Quat> {
        let [a, b] = self.ends.each_ref().map(|q| {
            let [w, x, y, z] = q.each_ref().map(|p| value(p, end));
            let [ex, ey, ez] = self.crossing.axes;
            Quat::from_parts(w, ex * x + ey * y + ez * z)
        });
        a.inverse().map(|inverse| b * inverse)
    }

    /// The contact with the branch, of degree 6.
    pub(super) fn on_branch(&self) -> PolynomialRow {
        let forms = &self.forms;
        let [c, s] = &forms.on_branch;
        let radius = self.crossing.radii[0] - self.depth;
        let norm = &(c * c) + &(s * s);
        let across = [&(c * c) + &(&(s * s) * -1.0), &(c * s) * 2.0].map(|p| &(&p * &forms.weight) * radius);
        let [x, y] = across;
        self.placed([x, y, &forms.height * &norm], &forms.weight * &norm)
    }

    /// A circle of the branch at a place along it, below the contact, with its parameter and its weights.
    pub(super) fn beside_branch(&self, height: f64) -> PolynomialRow {
        let forms = &self.forms;
        let [c, s] = &forms.on_branch;
        let radius = self.crossing.radii[0] - self.depth;
        let norm = &(&(c * c) + &(s * s)) * &forms.weight;
        let across = [&(c * c) + &(&(s * s) * -1.0), &(c * s) * 2.0].map(|p| &(&p * &forms.weight) * radius);
        let [x, y] = across;
        self.placed([x, y, &norm * height], norm)
    }

    /// A row in the axes of the branch, from its foot.
    fn placed(&self, [x, y, z]: [Polynomial; 3], weight: Polynomial) -> PolynomialRow {
        let (foot, [ex, ey, ez]) = (self.crossing.foot.to_vec(), self.crossing.axes);
        let along =
            |ex: f64, ey: f64, ez: f64, foot: f64| &(&(&x * ex) + &(&y * ey)) + &(&(&z * ez) + &(&weight * foot));
        let rows = [along(ex.x, ey.x, ez.x, foot.x), along(ex.y, ey.y, ez.y, foot.y), along(ex.z, ey.z, ez.z, foot.z)];
        let [x, y, z] = rows;
        PolynomialRow([x, y, z, weight])
    }

    /// The centres of the balls.
    pub(super) fn centres(&self) -> RationalBezier {
        let forms = &self.forms;
        curve(
            &self
                .placed([forms.across[0].clone(), forms.across[1].clone(), forms.height.clone()], forms.weight.clone()),
        )
    }

    /// The radii of the balls as a curve along x.
    pub(super) fn radii(&self) -> RationalBezier {
        let zero = Polynomial::constant(0.0);
        curve(&PolynomialRow([self.radius(), zero.clone(), zero, self.forms.weight.clone()]))
    }
}

/// The curve of a row of polynomials.
pub(super) fn curve(row: &PolynomialRow) -> RationalBezier {
    let degree = row.0.iter().map(Polynomial::degree).max().unwrap_or(0).max(1);
    let one = Polynomial::new(vec![0.0; degree + 1]);
    let entries = row.0.each_ref().map(|p| p + &one);
    let rows = (0..=degree).map(|i| entries.each_ref().map(|p| p.coefficients()[i])).collect();
    RationalBezier::from_rows_unchecked(rows)
}

/// The value of a polynomial.
pub(super) fn value(p: &Polynomial, t: f64) -> f64 {
    let rows: Vec<[f64; 1]> = p.coefficients().iter().map(|&c| [c]).collect();
    bernstein::eval(&rows, t)[0]
}

fn dot(a: &QuatForm, b: &QuatForm) -> Polynomial {
    let [p, q, r, s] = [0, 1, 2, 3].map(|k: usize| &a[k] * &b[k]);
    &(&p + &q) + &(&r + &s)
}

/// The vector part of `(a e3 b* + b e3 a*)/2`.
fn turned(a: &QuatForm, b: &QuatForm) -> [Polynomial; 3] {
    let pair = |i: usize, j: usize| &(&a[i] * &b[j]) + &(&a[j] * &b[i]);
    let sum = |p: Polynomial, q: Polynomial, sign: f64| &p + &(&q * sign);
    // a e3 = (-a3, a2, -a1, a0).
    [
        sum(pair(0, 2), pair(1, 3), 1.0),
        sum(pair(2, 3), pair(0, 1), -1.0),
        sum(&(&a[0] * &b[0]) + &(&a[3] * &b[3]), &(&a[1] * &b[1]) + &(&a[2] * &b[2]), -1.0),
    ]
}
