//! The patch of balls between two skew cylinders along a quartic of the plane of the torus, in its lowest degree
//! (`docs/math/canal-blends.md#patches-between-two-skew-cylinders`; source: `002`, section 4, for axes at right angles).
//!
//! With linear complex `z_i`, `c_i = Im(conj z_i z_i')`, `n_i = |z_i|²`, `w = z0 z1 z2`, `v = z1 conj(z2) z3`:
//! ```text
//! q1 = k- Re w - k+ Im w i,   q2 = k- Re v + k+ Im v j                      (roots of 2h ∓ d)
//! U1 = c0 n1 n3 + 2 c1 n0 n3 + c3 n0 n1,   I1 = Im(conj z0 conj(z2)² z3)
//! U2 = c0 n2 n3 + 2 c2 n0 n3 - c3 n0 n2,   I2 = Im(z0 z1² z3)
//! kappa = (U1 I1 + U2 I2) + (U2 I2 - U1 I1) k
//! ```
//! where the axes are at right angles. At a right angle and `2 l` more, `q2` has the factor `cos l + k sin l` on the left, and in `kappa` the products
//! `U1 I1` have the factor `cos l + sin l`, `U2 I2` the factor `cos l - sin l`;
//! the circles go from `q1` to `q2 kappa`, or for types with `z3` but not `z0` from `q1 conj(kappa)` to `q2`, which has a lower degree.

use super::{CanalPatch, SkewCylinders};
use crate::base::complex::Complex;
use crate::error::{ErrorItem, NumberError, PointError, Result, TorusError};
use crate::rational::{Polynomial, PolynomialRow, QuatPolynomial};
use crate::surface::torus::rows::{conj, product, square_norm};
use crate::surface::{QuarticType, TorusPiece};

impl CanalPatch {
    /// The patch between two skew cylinders along a piece of a spline in the plane of their balls, inside the diamond.
    ///
    /// # Errors
    /// As [`between_skew_cylinders`](Self::between_skew_cylinders).
    pub fn along(pair: &SkewCylinders, piece: &TorusPiece) -> Result<Self> {
        Self::between_skew_cylinders(pair, piece.quartic_type(), piece.linear_coordinates())
    }

    /// The half directions `(cos, sin)` of the angles of both contacts about their axes from the third axis, up to factors, along a piece.
    ///
    /// # Errors
    /// As [`between_skew_cylinders`](Self::between_skew_cylinders).
    pub(crate) fn half_directions(pair: &SkewCylinders, piece: &TorusPiece) -> Result<[[Polynomial; 2]; 2]> {
        let (classes, [plus, minus]) =
            (Rows::new(piece.quartic_type(), piece.linear_coordinates())?.classes(), pair.sides().map(f64::sqrt));
        Ok(classes.map(|class| [&real(&class) * minus, &imaginary(&class) * plus]))
    }

    /// The patch along a quartic of a type, given by the complex numbers `[re, im]` of its two coordinates at the start and at the end. The arc is
    /// the shorter one in the middle of the patch.
    ///
    /// # Errors
    /// `not-finite`, `zero-coordinate`, `coincident-points` (no coordinate turns: there is one ball).
    pub fn between_skew_cylinders(
        pair: &SkewCylinders,
        kind: QuarticType,
        coordinates: [[[f64; 2]; 2]; 2],
    ) -> Result<Self> {
        let rows = Rows::new(kind, coordinates)?;
        let (center, radius) = rows.balls(pair);
        let [q1, q2, kappa] = rows.turns(pair);
        let [first, last] = kind.families().map(|family| family.index());
        let turns = if first != 0 && last == 3 { [&q1 * &kappa.conj(), q2] } else { [q1, &q2 * &kappa] };
        let mut patch = Self { center, radius, turns };
        patch.take_minor_arc();
        Ok(patch)
    }

    /// Takes the shorter arc in the middle of the patch.
    pub(super) fn take_minor_arc(&mut self) {
        let [a, b] = self.turns.each_ref().map(|turn| turn.value(0.5));
        if a.dot(b) < 0.0 {
            self.turns[1] = &self.turns[1] * &Polynomial::constant(-1.0);
        }
    }
}

fn check(index: usize, z: Complex) -> Result<()> {
    if !(z.re.is_finite() && z.im.is_finite()) {
        Err(NumberError::NotFinite { what: ErrorItem::Coordinate, index }.into())
    } else if z.norm() == 0.0 {
        Err(TorusError::ZeroCoordinate { index }.into())
    } else {
        Ok(())
    }
}

/// The four complex coordinates in Bernstein form, and `c_i`.
struct Rows {
    z: [Vec<Complex>; 4],
    turns: [f64; 4],
}

impl Rows {
    fn new(kind: QuarticType, coordinates: [[[f64; 2]; 2]; 2]) -> Result<Self> {
        let mut z: [Vec<Complex>; 4] = std::array::from_fn(|_| vec![Complex::ONE]);
        let mut turns = [0.0; 4];
        for (i, family) in kind.families().into_iter().enumerate() {
            let [start, end] = coordinates[i].map(|[re, im]| Complex::new(re, im));
            check(i, start)?;
            check(i, end)?;
            let turn = (start.conj() * end).im;
            turns[family.index()] = turn;
            z[family.index()] = if turn == 0.0 { vec![start] } else { vec![start, end] };
        }
        if turns.iter().all(|turn| *turn == 0.0) {
            return Err(PointError::CoincidentPoints { first: 0, second: 1, distance: 0.0, limit: 0.0 }.into());
        }
        Ok(Self { z, turns })
    }

    fn norms(&self) -> [Polynomial; 4] {
        self.z.each_ref().map(|z| real(&square_norm(z)))
    }

    /// `w`, `v`.
    fn classes(&self) -> [Vec<Complex>; 2] {
        let [z0, z1, z2, z3] = &self.z;
        [product(&product(z0, z1), z2), product(&product(z1, &conj(z2)), z3)]
    }

    /// `[W m, W]` and `W R`.
    fn balls(&self, pair: &SkewCylinders) -> (PolynomialRow, Polynomial) {
        let ([z0, _, _, z3], [w, v]) = (&self.z, self.classes());
        let [n0, n1, n2, n3] = self.norms();
        let y0 = &(&n0 * &n1) * &(&n2 * &n3);
        let [first, second] = [(z3, w), (z0, v)].map(|(z, class)| product(&square_norm(z), &product(&class, &class)));
        let ([y1, y2], [y3, y4]) = ([real(&first), imaginary(&first)], [real(&second), imaginary(&second)]);
        let (h, d, [plus, minus]) = (pair.half_gap(), pair.difference(), pair.sides());
        let root = (plus * minus).sqrt();
        let weight = &y1 - &y3;
        let height = &(&(&y1 * (2.0 * h)) - &(&y0 * d)) - &(&weight * h);
        let from_axis = &(&y0 * (2.0 * h)) - &(&y1 * d);
        let radius = &from_axis - &(&weight * pair.radii()[0]);
        let [_, across] = pair.second_axis();
        let (first, second) = (&y2 * root, &y4 * root);
        // A right angle leaves no terms that only add rounding.
        let x = if across.y == 0.0 { second } else { &(&second - &(&first * across.y)) * (1.0 / across.x) };
        (PolynomialRow([x, first, height, weight]), radius)
    }

    /// `q1`, `q2`, `kappa`.
    fn turns(&self, pair: &SkewCylinders) -> [QuatPolynomial; 3] {
        let ([w, v], [plus, minus]) = (self.classes(), pair.sides().map(f64::sqrt));
        let zero = || Polynomial::constant(0.0);
        let q1 = QuatPolynomial([&real(&w) * minus, &imaginary(&w) * -plus, zero(), zero()]);
        let [cos, sin] = pair.half_lean();
        let (upright, turned) = (&real(&v) * minus, &imaginary(&v) * plus);
        let q2 = QuatPolynomial([&upright * cos, &turned * -sin, &turned * cos, &upright * sin]);
        let ([n0, n1, n2, n3], [c0, c1, c2, c3]) = (self.norms(), self.turns);
        let u1 = sum([(c0, &n1, &n3), (2.0 * c1, &n0, &n3), (c3, &n0, &n1)]);
        let u2 = sum([(c0, &n2, &n3), (2.0 * c2, &n0, &n3), (-c3, &n0, &n2)]);
        let [z0, z1, z2, z3] = &self.z;
        let i1 = imaginary(&product(&product(&conj(z0), &product(&conj(z2), &conj(z2))), z3));
        let i2 = imaginary(&product(&product(z0, &product(z1, z1)), z3));
        let (one, other) = (&(&u1 * &i1) * (cos + sin), &(&u2 * &i2) * (cos - sin));
        [q1, q2, QuatPolynomial([&one + &other, zero(), zero(), &other - &one])]
    }
}

fn real(p: &[Complex]) -> Polynomial {
    Polynomial::new(p.iter().map(|z| z.re).collect())
}

fn imaginary(p: &[Complex]) -> Polynomial {
    Polynomial::new(p.iter().map(|z| z.im).collect())
}

/// The sum of products; a factor zero, of a constant coordinate, leaves its term out, which would raise the degree.
fn sum(terms: [(f64, &Polynomial, &Polynomial); 3]) -> Polynomial {
    let used = terms.into_iter().filter(|(factor, _, _)| *factor != 0.0);
    used.map(|(factor, a, b)| &(a * b) * factor)
        .reduce(|sum, term| &sum + &term)
        .unwrap_or_else(|| Polynomial::constant(0.0))
}
