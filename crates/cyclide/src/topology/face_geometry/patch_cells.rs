//! The certified distance between a cell of a patch and the planar quad over its corners.
//!
//! **Bound.** Take the cell `[s0, s1] × [t0, t1]` with `M(t) = ~D(s0,t) D(s1,t)`, `h = s1 - s0`. Its corners are concircular,
//! so they span a planar convex quad `Q` (a triangle where a side is one point). The s-arc at `t` turns by twice the
//! angle of `M`, has the diameter `|q1|/|m|`, and `Im M = h m(t)` exactly, so its sagitta is
//! `h² |q1| |m| / (2 |M| (|M| + Re M))` (`docs/math/tessellation.md#sagitta-of-a-line`). A point of the cell is
//! `f = g + u + v`:
//!
//! - `u`, at most the sagitta `a` of the s-arc through `f`, takes it from the foot on the chord of that arc;
//! - the chord's ends lie on the t-arcs of the sides `s0` and `s1`; `v`, a mean of two vectors of lengths at most the
//!   sagittas `b0`, `b1` of these, takes the foot from the same mean of feet on their chords;
//! - `g` is a mean of points of two opposite sides of `Q`, hence in `Q`.
//!
//! So `|f - g| <= |u + v|`. The square of the right-hand side is convex in the lengths and in the mean, so it is largest
//! at an extreme of them: with `c_k` at least the cosine between the directions of `u` and of `v` at side `k`,
//!
//! ```text
//! distance² <= max over k of max(a², b_k², a² + b_k² + 2 a b_k c_k)
//! ```
//!
//! This is `a + b` of `docs/math/tessellation.md#sagitta-of-a-line` where both circles bulge to one side of the
//! surface, and only the larger of the two on a saddle. The direction of a bulge has the component `∓m·V/|m|` along the
//! normal and the rest along the other tangent of the moving frame at the middle of its arc
//! (`docs/math/patches.md#speeds-and-moving-frame`); the product of the normal components is the cosine, up to the turn
//! of the frame between the two middles, which is at most `angle M + angle M*`.
//!
//! **Both ways.** `g` depends continuously on the place in the cell and runs along the sides of `Q` as the place runs along
//! the sides of the cell, each once round. A continuous map of a disk to a disk that has degree one on the boundary
//! is onto: every point of `Q` is the `g` of a point of the cell, so it too is within the bound.
//!
//! All maxima over `t` come from Bernstein coefficients on the cell. Arcs of a cell turn by at most 120 degrees, far below
//! the half turn up to which feet and sagittas behave.

use super::cells::{CellDistances, are_cuts};
use crate::base::quat::Quat;
use crate::base::vector::Vec3;
use crate::surface::CyclidePatch;
use std::f64::consts::FRAC_PI_2;

/// A direction whose sagitta is below this part of the other's is not cut for the deviation of a cell.
const SMALL_SAGITTA: f64 = 0.125;
/// Largest tangent of half the angle of an arc of a cell: that of 60 degrees.
const HALF_TURN_TANGENT: f64 = 1.732;

/// The quadratics of a patch that say how its parameter circles run: index 0 for the s-lines (functions of t), 1 for
/// the t-lines (functions of s).
pub(super) struct PatchSpeeds {
    q: [[f64; 3]; 2],
    m: [[Vec3; 3]; 2],
    /// The tangent across the line, with the sign that makes `m·across/|m|` the normal component of the bulge.
    across: [Vec3; 2],
}

/// One parameter line, or a bound of all lines between two.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    /// `|q|`.
    pub(super) q: f64,
    /// `|m|`.
    pub(super) m: f64,
    /// Component along the normal of the direction in which the circle bends.
    pub(super) normal: f64,
    /// How far that component may be off.
    spread: f64,
}

/// The blossom of a quadratic at `(x, y)`: its Bernstein coefficients on `[x, y]` are those at (x,x), (x,y), (y,y).
fn blossom(x: f64, y: f64) -> [f64; 3] {
    [(1.0 - x) * (1.0 - y), (1.0 - x) * y + x * (1.0 - y), x * y]
}

impl PatchSpeeds {
    pub(super) fn new(patch: &CyclidePatch) -> Self {
        let [v1, v2, _] = patch.frame();
        Self { q: [patch.q1(), patch.q2()], m: patch.bending(), across: [-v2, v1] }
    }

    fn q_blossom(&self, direction: usize, x: f64, y: f64) -> f64 {
        let (c, [a, b, e]) = (&self.q[direction], blossom(x, y));
        c[0] * a + c[1] * b + c[2] * e
    }

    fn m_blossom(&self, direction: usize, x: f64, y: f64) -> Vec3 {
        let (c, [a, b, e]) = (&self.m[direction], blossom(x, y));
        c[0] * a + c[1] * b + c[2] * e
    }

    /// Sign of the speed of the lines of the family in the middle between two places.
    fn sign(&self, direction: usize, x: f64, y: f64) -> f64 {
        let middle = 0.5 * (x + y);
        if self.q_blossom(direction, middle, middle) < 0.0 { -1.0 } else { 1.0 }
    }

    /// The line of the family at `x`.
    pub(super) fn line(&self, direction: usize, x: f64) -> Line {
        let (q, m) = (self.q_blossom(direction, x, x), self.m_blossom(direction, x, x));
        let length = m.length();
        let normal = if length > 0.0 { m.dot(self.across[direction]) / length } else { 1.0 };
        Line { q: q.abs(), m: length, normal: normal.copysign(normal * q), spread: 0.0 }
    }

    /// Bounds of all lines of the family from `x` to `y`.
    fn range(&self, direction: usize, x: f64, y: f64) -> Line {
        let pairs = [(x, x), (x, y), (y, y)];
        let q = pairs.map(|(x, y)| self.q_blossom(direction, x, y).abs()).into_iter().fold(0.0, f64::max);
        let bends = pairs.map(|(x, y)| self.m_blossom(direction, x, y));
        let middle = bends[0] + bends[1] * 2.0 + bends[2];
        let m = bends.map(Vec3::length).into_iter().fold(0.0, f64::max);
        let spread = bends.map(|b| b.angle(middle)).into_iter().fold(0.0, f64::max);
        let length = middle.length();
        let normal = if length > 0.0 { middle.dot(self.across[direction]) / length } else { 0.0 };
        // Every bend between is a positive mean of the three. The vectors within an angle of an axis are closed under such
        // means up to a right angle only; beyond it nothing is known, and two components differ by 2 at most.
        let known = spread <= FRAC_PI_2 && length > 0.0 && bends.iter().all(|b| b.max_abs() > 0.0);
        let spread = if known { spread } else { 2.0 };
        Line { q, m, normal: normal * self.sign(direction, x, y), spread }
    }
}

/// The denominators `D` at all pairs of parameters, s fastest.
pub(super) fn denominators(patch: &CyclidePatch, s: &[f64], t: &[f64]) -> Vec<Quat> {
    let w = patch.weights();
    let ends: Vec<[Quat; 2]> = s.iter().map(|&s| [w[0] * (1.0 - s) + w[1] * s, w[2] * (1.0 - s) + w[3] * s]).collect();
    let row = |t: f64| ends.iter().map(move |e| e[0] * (1.0 - t) + e[1] * t);
    t.iter().flat_map(|&t| row(t)).collect()
}

/// The t-arc of one side of a cell.
#[derive(Clone, Copy)]
struct Side {
    low: Quat,
    high: Quat,
    /// Least `|D|²`.
    least: f64,
    sagitta: f64,
    tangent: f64,
}

impl Side {
    fn new(low: Quat, high: Quat, step: f64, line: Line) -> Self {
        let (l, h, real) = (low.norm_squared(), high.norm_squared(), low.dot(high));
        let modulus = (l * h).sqrt();
        let bend = step * line.m;
        let sagitta = step * line.q * bend / (2.0 * modulus * (modulus + real));
        let tangent = if real > 0.0 { bend / real } else { f64::INFINITY };
        Self { low, high, least: l.min(h).min(real), sagitta, tangent }
    }
}

/// The certified distances between a patch cut at the given parameters and the quads over the corners of its cells.
pub(super) fn grid_distances(patch: &CyclidePatch, s: &[f64], t: &[f64], tolerance: f64) -> CellDistances {
    if !(are_cuts(s) && are_cuts(t)) {
        return CellDistances::unknown([s, t]);
    }
    let (speeds, d) = (PatchSpeeds::new(patch), denominators(patch, s, t));
    let lines: Vec<Line> = s.iter().map(|&s| speeds.line(1, s)).collect();
    let [mut columns, mut rows] = [vec![0.0_f64; s.len() - 1], vec![0.0_f64; t.len() - 1]];
    let mut worst = 0.0_f64;
    let [mut columns_turn, mut rows_turn] = [columns.clone(), rows.clone()];
    for (j, ends) in d.windows(2 * s.len()).step_by(s.len()).enumerate() {
        let (low, high) = ends.split_at(s.len());
        let (step, row) = (t[j + 1] - t[j], speeds.range(0, t[j], t[j + 1]));
        let mut left = Side::new(low[0], high[0], step, lines[0]);
        for i in 0..columns.len() {
            let right = Side::new(low[i + 1], high[i + 1], step, lines[i + 1]);
            let bend = (s[i + 1] - s[i]) * row.m;
            let across = 0.5 * (left.low.dot(right.high) + left.high.dot(right.low));
            let real = left.low.dot(right.low).min(left.high.dot(right.high)).min(across);
            let modulus = (left.least * right.least).sqrt();
            let a = (s[i + 1] - s[i]) * row.q * bend / (2.0 * modulus * (modulus + real));
            let tangent = if real > 0.0 { bend / real } else { f64::INFINITY };
            let mut square = 0.0_f64;
            for (side, line) in [(&left, lines[i]), (&right, lines[i + 1])] {
                let b = side.sagitta;
                // The angle of M is below its tangent.
                let c = row.normal * line.normal + row.spread * line.normal.abs() + tangent + side.tangent;
                square = square.max(bulge_squared(a, b, c.min(1.0)));
            }
            let turn = [tangent, left.tangent.max(right.tangent)].map(|tangent| tangent / HALF_TURN_TANGENT);
            columns_turn[i] = columns_turn[i].max(turn[0]);
            rows_turn[j] = rows_turn[j].max(turn[1]);
            // Sagittas mean nothing where an arc turns too far.
            if !(turn[0].max(turn[1]) <= 1.0) {
                worst = f64::INFINITY;
            } else {
                worst = worst.max(square);
                // The larger of the two at least.
                let b = left.sagitta.max(right.sagitta);
                if a >= SMALL_SAGITTA * b {
                    columns[i] = columns[i].max(square);
                }
                if b >= SMALL_SAGITTA * a {
                    rows[j] = rows[j].max(square);
                }
            }
            left = right;
        }
    }
    // Sagittas fall with the square of the number of cuts, turns with the number.
    let excess = |squares: &[f64], turns: &[f64]| -> Vec<f64> {
        squares.iter().zip(turns).map(|(square, turn)| (square.sqrt() / tolerance).sqrt().max(*turn)).collect()
    };
    CellDistances { distance: worst.sqrt(), excess: [excess(&columns, &columns_turn), excess(&rows, &rows_turn)] }
}

/// Largest square of a sum of two vectors of lengths at most `a`, `b` with cosine at most `c`.
fn bulge_squared(a: f64, b: f64, c: f64) -> f64 {
    (a * a).max(b * b).max(a * a + b * b + 2.0 * a * b * c)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bend_of_every_line_is_in_the_range() {
        // Three bends near one line there and back: all within 97 degrees of their middle, the lines between up to 177.
        let bends =
            [[-1.2637, -2.2805, -0.7330], [0.6735, 1.4030, 0.6418], [-0.1958, -0.5636, -0.4013]].map(Vec3::from);
        let across = (bends[0] + bends[1] * 2.0 + bends[2]).unit().unwrap();
        let speeds = PatchSpeeds { q: [[1.0; 3]; 2], m: [bends; 2], across: [across; 2] };
        let range = speeds.range(0, 0.0, 1.0);
        for k in 0..=100 {
            let off = (speeds.line(0, f64::from(k) / 100.0).normal - range.normal).abs();
            assert!(off <= range.spread, "{off} at {k} %, spread {}", range.spread);
        }
    }
}
