//! The exact rational form of a piece (`docs/math/torus-splines.md#quartic-pieces`).
//!
//! ```text
//! W = z0 z1 z2,  V = z1 conj(z2) z3,  n_i = |z_i|²
//! x + i y = c² n3 W²,  z = 2 b c n0 Re V Im V,  w = n0 ((a-b) Re² V + (a+b) Im² V)
//! ```
//! in Bernstein form, coefficient by coefficient. The weight function is a sum of squares, hence positive; its coefficients become
//! so when the piece is halved often enough.

use super::Torus;
use super::coordinates::Shape;
use super::family::CircleFamily;
use super::piece::TorusPiece;
use crate::base::bernstein::product as real_product;
use crate::base::complex::Complex;
use crate::base::vector::Vec3;
use crate::rational::RationalBezier;

/// Halvings of a piece until its weights are positive. In random pieces of all types three are enough; a piece that still has others
/// has lost its digits, and whoever needs positive weights refuses it.
const HALVINGS: u32 = 24;

/// A part `[from, to]` of a piece in its exact rational form.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RationalPart {
    pub(super) curve: RationalBezier,
    pub(super) from: f64,
    pub(super) to: f64,
}

impl Torus {
    /// The exact rational form of a piece on this torus: one Bézier curve of degree 4 (2 for arcs of circles) at the parameter of the
    /// piece, largest weight 1. Weights may be zero or negative where the piece turns far.
    #[must_use]
    pub fn piece_to_rational(&self, piece: &TorusPiece) -> RationalBezier {
        let rows = local_rows(&self.shape, piece);
        let largest = rows.iter().fold(0.0, |m: f64, r| m.max(r[3].abs()));
        let origin = self.frame().origin().to_vec();
        let placed = |[x, y, z, w]: [f64; 4]| {
            let v = self.world_vector(Vec3::new(x, y, z) / largest) + origin * (w / largest);
            [v.x, v.y, v.z, w / largest]
        };
        RationalBezier::from_rows_unchecked(rows.into_iter().map(placed).collect())
    }

    /// The same in parts as they are asked for: the piece is halved until they are so.
    pub(super) fn rational_parts(&self, piece: &TorusPiece, spans: Spans) -> Vec<RationalPart> {
        let (mut parts, mut ahead) = (Vec::new(), vec![([0.0, 1.0], HALVINGS)]);
        while let Some(([from, to], halvings)) = ahead.pop() {
            let whole = from <= 0.0 && to >= 1.0;
            let curve = self.piece_to_rational(&if whole { *piece } else { piece.part(from, to) });
            if halvings == 0 || spans.accept(&curve) {
                parts.push(RationalPart { curve, from, to });
            } else {
                let middle = 0.5 * (from + to);
                ahead.extend([([middle, to], halvings - 1), ([from, middle], halvings - 1)]);
            }
        }
        parts
    }
}

/// What is asked of the parts of a rational form.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Spans {
    /// Positive weights.
    Positive,
    /// Positive weights that start and end with a logarithmic slope of at most [`EVEN_SLOPE`] by the parameter of the part.
    Even,
}

/// With slopes up to this the factor that joins the weights of two spans smoothly is positive: it changes a slope by less
/// than 3 (`docs/math/torus-splines.md#c1-knots`).
const EVEN_SLOPE: f64 = 1.4;

impl Spans {
    fn accept(self, curve: &RationalBezier) -> bool {
        if !curve.has_positive_weights() || self == Self::Positive {
            return curve.has_positive_weights();
        }
        let (rows, n) = (curve.rows(), curve.degree());
        let slope = |end: usize, next: usize| (rows[next][3] / rows[end][3] - 1.0).abs() * n as f64;
        slope(0, 1) <= EVEN_SLOPE && slope(n, n - 1) <= EVEN_SLOPE
    }
}

/// Rows `[wx, wy, wz, w]` in units of the major radius.
fn local_rows(shape: &Shape, piece: &TorusPiece) -> Vec<[f64; 4]> {
    let mut z: [Vec<Complex>; 4] = std::array::from_fn(|_| vec![Complex::ONE]);
    for (i, family) in piece.quartic_type().families().into_iter().enumerate() {
        let (unit, course) = piece.course(i);
        let coordinate = if course.is_still() { vec![unit] } else { vec![unit, unit * course.ratio] };
        z[family.index()] = coordinate;
    }
    let of = |family: CircleFamily| z[family.index()].as_slice();
    let (z0, z1) = (of(CircleFamily::Parallel), of(CircleFamily::Villarceau));
    let (z2, z3) = (of(CircleFamily::MirrorVillarceau), of(CircleFamily::Meridian));
    let (w, v) = (product(&product(z0, z1), z2), product(&product(z1, &conj(z2)), z3));
    let xy = product(&square_norm(z3), &product(&w, &w));
    let (re, im): (Vec<f64>, Vec<f64>) = v.iter().map(|v| (v.re, v.im)).unzip();
    let n0: Vec<f64> = square_norm(z0).iter().map(|n| n.re).collect();
    let times_n0 = |a: &[f64], b: &[f64]| real_product(&n0, &real_product(a, b));
    let (height, re2, im2) = (times_n0(&re, &im), times_n0(&re, &re), times_n0(&im, &im));
    let plane = shape.thin * shape.wide;
    let row = |k: usize| {
        let weight = shape.thin * re2[k] + shape.wide * im2[k];
        [plane * xy[k].re, plane * xy[k].im, 2.0 * shape.tube * shape.root * height[k], weight]
    };
    (0..xy.len()).map(row).collect()
}

/// The conjugate polynomial.
pub(in crate::surface) fn conj(p: &[Complex]) -> Vec<Complex> {
    p.iter().map(|z| z.conj()).collect()
}

/// `p conj(p)`.
pub(in crate::surface) fn square_norm(p: &[Complex]) -> Vec<Complex> {
    product(p, &conj(p))
}

/// The product of two complex polynomials in Bernstein form.
pub(in crate::surface) fn product(p: &[Complex], q: &[Complex]) -> Vec<Complex> {
    let part = |p: &[Complex], of: fn(&Complex) -> f64| p.iter().map(of).collect::<Vec<f64>>();
    let (pr, pi, qr, qi) = (part(p, |z| z.re), part(p, |z| z.im), part(q, |z| z.re), part(q, |z| z.im));
    let (rr, ii) = (real_product(&pr, &qr), real_product(&pi, &qi));
    let (ri, ir) = (real_product(&pr, &qi), real_product(&pi, &qr));
    (0..rr.len()).map(|k| Complex::new(rr[k] - ii[k], ri[k] + ir[k])).collect()
}
