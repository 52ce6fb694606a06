//! The equations of planar data: one unknown per node, the angle of its tangent
//! (`docs/math/fair-splines.md#newtons-method`).
//!
//! ```text
//! g_i += w (sin al + 2e s1),  g_j += w (-sin be + 2e s1),  w = 2/d,  s1 = sin((al-be)/2), co = cos((al-be)/2)
//! H_ii += w (cos al + e co),  H_jj += w (cos be + e co),  H_ij = w e co
//! ```
//! `al`, `be` are the angles of the tangents from the chord, each in `(-pi, pi]`. They are kept as unit vectors, and
//! their halves come from square roots: no angle is ever computed, and none has to be wrapped.

use super::newton::{Geometry, SegmentTerms};

/// Chords in the plane of the data.
pub(super) struct PlanarChords {
    /// Unit directions.
    pub(super) units: Vec<[f64; 2]>,
    /// Lengths, relative to the longest.
    pub(super) lengths: Vec<f64>,
}

/// Cosine and sine of the angle from `u` to `t`.
fn turn(u: [f64; 2], t: [f64; 2]) -> [f64; 2] {
    [u[0] * t[0] + u[1] * t[1], u[0] * t[1] - u[1] * t[0]]
}

/// Cosine and sine of half an angle in `(-pi, pi]`.
fn half([c, s]: [f64; 2]) -> [f64; 2] {
    if c >= 0.0 {
        let h = (0.5 + 0.5 * c).sqrt();
        [h, 0.5 * s / h]
    } else {
        let h = (0.5 - 0.5 * c).sqrt().copysign(s);
        [0.5 * s / h, h]
    }
}

fn unit([x, y]: [f64; 2]) -> [f64; 2] {
    let r = (x * x + y * y).sqrt();
    [x / r, y / r]
}

impl Geometry<1> for PlanarChords {
    type Node = [f64; 2];

    fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    fn chord(&self, i: usize) -> [f64; 2] {
        self.units[i]
    }

    fn between(&self, before: usize, after: usize) -> [f64; 2] {
        let (a, b) = (self.units[before], self.units[after]);
        let longest = self.lengths[before].max(self.lengths[after]);
        let (wa, wb) = (self.lengths[after] / longest, self.lengths[before] / longest);
        unit([a[0] * wa + b[0] * wb, a[1] * wa + b[1] * wb])
    }

    fn mirrored(&self, i: usize, t: &[f64; 2]) -> [f64; 2] {
        let u = self.units[i];
        let [c, s] = turn(u, *t);
        [u[0] * c + u[1] * s, u[1] * c - u[0] * s]
    }

    fn toward_chord(&self, i: usize, t: &[f64; 2]) -> [f64; 2] {
        let u = self.units[i];
        let sum = [u[0] + t[0], u[1] + t[1]];
        if sum[0].hypot(sum[1]) <= 1e-9 { u } else { unit(sum) }
    }

    fn cosine(&self, i: usize, t: &[f64; 2]) -> f64 {
        turn(self.units[i], *t)[0]
    }

    fn blend_angle(&self, i: usize, from: &[f64; 2], to: &[f64; 2]) -> f64 {
        let [c, s] = turn(*from, self.mirrored(i, to));
        s.abs().atan2(c)
    }

    fn segment(&self, i: usize, from: &[f64; 2], to: &[f64; 2], blend: f64) -> SegmentTerms<1> {
        let (u, w) = (self.units[i], 2.0 / self.lengths[i]);
        let [cos_al, sin_al] = turn(u, *from);
        // The angle at the far end is counted from the tangent to the chord.
        let [cos_be, minus_sin_be] = turn(u, *to);
        let ([ca, sa], [cb, sb]) = (half([cos_al, sin_al]), half([cos_be, -minus_sin_be]));
        let (s1, co) = (sa * cb - ca * sb, ca * cb + sa * sb);
        let (bend, stiff) = (2.0 * blend * s1, blend * co);
        SegmentTerms {
            gradient: [[w * (sin_al + bend)], [w * (minus_sin_be + bend)]],
            diagonal: [[[w * (cos_al + stiff)]], [[w * (cos_be + stiff)]]],
            coupling: [[w * stiff]],
        }
    }

    fn arc_segment(&self, i: usize, t: &[f64; 2]) -> ([f64; 1], f64) {
        let w = 2.0 / self.lengths[i];
        let [c, s] = turn(self.units[i], *t);
        ([w * s], w * c)
    }

    /// Rotation by `2 atan(y/2)`, which is `y` up to its third order, without trigonometry.
    fn turned(&self, t: &[f64; 2], [y]: [f64; 1]) -> [f64; 2] {
        let h = 0.5 * y;
        let (c, s) = (1.0 - h * h, 2.0 * h);
        unit([t[0] * c - t[1] * s, t[1] * c + t[0] * s])
    }
}
