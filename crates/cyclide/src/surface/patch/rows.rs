//! Many points of one s-line at once, into the caller's buffers.

use super::{CyclidePatch, line};
use crate::base::quadratic::powers;
use crate::base::quat::Quat;
use crate::batch;

/// Parameters handled together: the lanes of a block with its parameters stay in the first-level cache.
const BLOCK: usize = 256;

/// One s-line of a patch in the form that is fastest for many points: real quadratics over one common denominator.
///
/// # Why the point and the normal are quadratics over the same denominator
///
/// On the line, numerator and denominator are linear, `n = n0 (1-s) + n1 s`, `D = D0 (1-s) + D1 s`, and
/// `f = n D^-1 = n ~D/|D|²`: each coordinate is a quadratic over the quadratic `|D|²`.
///
/// For the normal, differentiate `n = f D` and use `~f = -f` (the point is imaginary):
/// `~D n_s + ~n D_s = ~D f_s D + ~D f D_s - ~D f D_s = ~D f_s D`. On the left s occurs only in `2s Re(~D_s n_s)`; that is
/// the s² coefficient of `Re(~D n)`, which vanishes since `~D n = ~D f D` is imaginary. So the left side is its value at
/// s = 0, `K(t) = ~D0 n1 + ~n0 D1` (less `2 Re(~D0 n0) = 0`), and `f_s = D K ~D/|D|^4`.
///
/// `K(t)` has one direction for all lines: `K(t) = q1(t) V1` with a constant unit vector `V1` and a real `q1`. In terms of
/// the corners, since `~a = -a`,
/// ```text
/// K(t) = K_01 (1-t)² + (K_03 + ~K_12) t(1-t) + K_23 t²,   K_ij = ~w_i n_j + ~n_i w_j = ~w_i (a_j - a_i) w_j = ~K_ji
/// ```
/// A translation changes no `K_ij`; a common factor `w -> w c` makes `~c K_ij c` of it, and `c^-1 V c` of `V`; factors
/// `1, lam, mu, lam mu` of the weights multiply `K_03` and `K_12` by the same number. So let `a_0 = 0` and, by form C of
/// `docs/math/patches.md#weights`, with the orthonormal frame `V1, V2, V3 = V1 V2`, `b_i = a_i^-1` and `e = b_1 - b_2`,
/// ```text
/// w_0 = 1,   w_1 = b_1 V1,   w_2 = b_2 V2,   w_3 = b_3 e V3,   e = e1 V1 + e2 V2 + e3 V3
/// ```
/// The corners are concircular, so the inverses are collinear: `b_3 = (1-x) b_1 + x b_2`, `b_1 - b_3 = x e`,
/// `b_2 - b_3 = (x-1) e`. With `e² = -|e|²`, `b_i (a_j - a_i) b_j = b_i - b_j` and `~(b V) = V b`:
/// ```text
/// K_01 = V1,   K_23 = V2 (b_2 - b_3) e V3 = (1-x) |e|² V1,   K_03 = e V3    =  e2 V1 - e1 V2 - e3,
/// K_02 = V2,   K_13 = V1 (b_1 - b_3) e V3 =   x   |e|² V2,   K_12 = V1 e V2 = -e2 V1 - e1 V2 + e3
/// ```
/// Hence `K_03 + ~K_12 = 2 e2 V1`, and `q1 = (1, e2, (1-x) |e|²)` in Bernstein form. For the t-lines, with
/// `K_03 + K_12 = -2 e1 V2` in the middle, likewise `f_t = q2(s) D V2 ~D/|D|^4`, `q2 = (1, -e1, x |e|²)`. (That `e3` cancels
/// is also why the point is imaginary: `Re(~D n)` is the sum of `B_i B_j Re K_ij` over `i < j`, and `B_0 B_3 = B_1 B_2`.)
/// The weights of a net are those of (C) on each quad, up to the factors above. A Möbius map multiplies all `K_ij` by one
/// real number, and an offset keeps D and, as a parallel surface, the normal.
///
/// So the unit normal is `(D V1 ~D)(D V2 ~D)/|D|^4 = D V1 V2 ~D/|D|² = D V3 ~D/|D|²` (that of `f_s × f_t` up to the sign of
/// `q1 q2`): with linear D, quadratics over `|D|²` once more, and no square root.
///
/// # Accuracy
///
/// With `r = max |D|²/min |D|²` over the line, points are within `32 ε r` of the patch's size or, where the line bulges
/// farther, of its largest distance from the first corner, plus 2 units of the last place of the coordinates, of
/// [`point`](crate::surface::ParamSurface::point), and normals within `32 ε r` of
/// [`unit_normal`](CyclidePatch::unit_normal). `|D|` is largest, M, at an end, so the coefficients in powers of s, products
/// of the ends of two linear forms and of their differences, are at most `4 M²` times that distance; the products of
/// quaternions, the change to powers and the Horner scheme round numerator and denominator by `16 ε M²` at most each, and
/// the quotient divides by `|D|²`. To first order, with corner weights no longer than M, that is `32 ε r` if no two roundings
/// cancel; 40 000 random patches needed a third of it. The results are the same on every machine.
#[derive(Debug, Clone, Copy)]
pub struct PatchRow {
    points: [[f64; 3]; 3],
    normals: [[f64; 3]; 3],
    denominator: [f64; 3],
    origin: [f64; 3],
}

impl CyclidePatch {
    /// The s-line at `t`, set up for many points.
    #[must_use]
    pub fn row(&self, t: f64) -> PatchRow {
        let ends = |q: &[Quat; 4]| [line(&[q[0], q[2]], t), line(&[q[1], q[3]], t)];
        let ([n0, n1], [d0, d1]) = (ends(&self.n), ends(&self.weights));
        let v3 = Quat::from(self.v[2]);
        // Im(p ~D) for a linear p.
        let over = |p0: Quat, p1: Quat, scale: f64| {
            let a = (p0 * d0.conj()).vector() * scale;
            let b = (p0 * d1.conj() + p1 * d0.conj()).vector() * scale;
            let c = (p1 * d1.conj()).vector() * scale;
            [powers(a.x, b.x, c.x), powers(a.y, b.y, c.y), powers(a.z, b.z, c.z)]
        };
        PatchRow {
            points: over(n0, n1, self.scale),
            normals: over(d0 * v3, d1 * v3, 1.0),
            denominator: powers(d0.norm_squared(), 2.0 * d0.dot(d1), d1.norm_squared()),
            origin: self.corners[0].to_array(),
        }
    }
}

impl PatchRow {
    /// The points at the parameters `s`, coordinate by coordinate. As many as the shortest slice holds; nothing is
    /// allocated.
    pub fn points(&self, s: &[f64], out: [&mut [f64]; 3]) {
        batch::points(&self.points, self.denominator, self.origin, s, out);
    }

    /// The points and the unit normals `D V3 D^-1` at the parameters `s`; as [`points`](Self::points).
    pub fn points_and_normals(&self, s: &[f64], points: [&mut [f64]; 3], normals: [&mut [f64]; 3]) {
        let (mut points, mut normals) = (points, normals);
        let numerators = [self.points, self.normals];
        let n = points.iter().chain(&normals).map(|lane| lane.len()).fold(s.len(), usize::min);
        for start in (0..n).step_by(BLOCK) {
            let block = start..n.min(start + BLOCK);
            let (points, normals) = (
                points.each_mut().map(|lane| &mut lane[block.clone()]),
                normals.each_mut().map(|lane| &mut lane[block.clone()]),
            );
            batch::points_and_directions(&numerators, self.denominator, self.origin, &s[block], points, normals);
        }
    }
}
