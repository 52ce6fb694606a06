//! Many points of one s-line at once, into the caller's buffers.

use super::{CyclidePatch, line};
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
/// s = 0, `K = ~D0 n1 + ~n0 D1` (less `2 Re(~D0 n0) = 0`), and `f_s = D K ~D/|D|^4`. By `20`, section 2,
/// `K = q1(t) V1` with one constant `V1` for all lines, and likewise `f_t = q2(s) D V2 ~D/|D|^4`. Hence the unit normal
/// is `(D V1 ~D)(D V2 ~D)/|D|^4 = D V1 V2 ~D/|D|² = D V3 ~D/|D|²`: with linear D, quadratics over `|D|²` once more, and
/// no square root.
///
/// # Accuracy
///
/// With `r = max |D|²/min |D|²` over the line, points are within `16 ε r` of the patch's size or, where the line bulges
/// farther, of its largest distance from the first corner, plus 2 units of the last place of the coordinates, of
/// [`point`](crate::ParamSurface::point), and normals within `16 ε r` of
/// [`unit_normal`](CyclidePatch::unit_normal): the quadratics are in powers of s, whose coefficients are up to four times
/// the largest value, and rounded three times. The results are the same on every machine.
#[derive(Debug, Clone, Copy)]
pub struct PatchRow {
    points: [[f64; 3]; 3],
    normals: [[f64; 3]; 3],
    denominator: [f64; 3],
    origin: [f64; 3],
}

/// Coefficients by powers of s of `a (1-s)² + b s(1-s) + c s²`.
fn powers(a: f64, b: f64, c: f64) -> [f64; 3] {
    [a, b - 2.0 * a, a - b + c]
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
