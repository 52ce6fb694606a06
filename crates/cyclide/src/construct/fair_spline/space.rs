//! The equations of data in space: two unknowns per node, a small turn of its tangent
//! (`docs/math/fair-splines.md#energy`).
//!
//! ```text
//! w = 2/d, c = t1·t2, gp = -2e/S, gpp = 2e/S³, S = s |t1 + t2|, t2 = R te;  v1 = Bᵢᵀ t2,  v2 = (R Bⱼ)ᵀ t1
//! g_i += w (gp v1 - Bᵢᵀ u),   H_ii += w ((c1 - gp c) I + gpp v1 v1ᵀ),   H_ij += w (gpp v1 v2ᵀ + gp Bᵢᵀ R Bⱼ)
//! g_j += w (gp v2 - Bⱼᵀ u),   H_jj += w ((c2 - gp c) I + gpp v2 v2ᵀ)
//! ```
//! `B` are two orthonormal vectors across the tangent; `s` is -1 where the blend takes the long way round.

use super::newton::{Geometry, SegmentTerms};
use crate::base::vector::Vec3;
use crate::curve::Chord;

/// Chords in space.
pub(super) struct SpaceChords {
    /// Unit directions.
    pub(super) units: Vec<Vec3>,
    /// Lengths, relative to the longest.
    pub(super) lengths: Vec<f64>,
}

/// A tangent and two unit vectors across it.
#[derive(Clone, Copy)]
pub(super) struct SpaceNode {
    pub(super) tangent: Vec3,
    across: [Vec3; 2],
}

impl SpaceNode {
    /// The basis without branches of T. Duff et al., "Building an orthonormal basis, revisited", 2017.
    pub(super) fn new(t: Vec3) -> Self {
        let sign = 1.0_f64.copysign(t.z);
        let a = -1.0 / (sign + t.z);
        let b = t.x * t.y * a;
        let first = Vec3::new(1.0 + sign * t.x * t.x * a, sign * b, -sign * t.x);
        Self { tangent: t, across: [first, Vec3::new(b, sign + t.y * t.y * a, -t.y)] }
    }
}

fn unit(v: Vec3) -> Vec3 {
    v / v.length_squared().sqrt()
}

impl Geometry<2> for SpaceChords {
    type Node = SpaceNode;

    fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    fn chord(&self, i: usize) -> SpaceNode {
        SpaceNode::new(self.units[i])
    }

    fn between(&self, before: usize, after: usize) -> SpaceNode {
        let chord = |i: usize| Chord { unit: self.units[i], length: self.lengths[i] };
        SpaceNode::new(chord(before).tangent_to(&chord(after)).unwrap_or(self.units[after]))
    }

    fn mirrored(&self, i: usize, node: &SpaceNode) -> SpaceNode {
        SpaceNode::new(unit(node.tangent.reflect(self.units[i])))
    }

    fn toward_chord(&self, i: usize, node: &SpaceNode) -> SpaceNode {
        let u = self.units[i];
        let sum = u + node.tangent;
        SpaceNode::new(if sum.length() <= 1e-9 { u } else { unit(sum) })
    }

    fn cosine(&self, i: usize, node: &SpaceNode) -> f64 {
        self.units[i].dot(node.tangent)
    }

    fn blend_angle(&self, i: usize, from: &SpaceNode, to: &SpaceNode) -> f64 {
        from.tangent.angle(to.tangent.reflect(self.units[i]))
    }

    fn segment(&self, i: usize, from: &SpaceNode, to: &SpaceNode, blend: f64) -> SegmentTerms<2> {
        let (u, w) = (self.units[i], 2.0 / self.lengths[i]);
        let (t1, t2) = (from.tangent, to.tangent.reflect(u));
        let mirrored = to.across.map(|v| v.reflect(u));
        let long_way = (u + t1).dot(u + t2) < 0.0;
        // Not finite for opposite circles, whose energy has a cone there: such a step is refused.
        let inverse = (t1 + t2).length_squared().sqrt().copysign(if long_way { -1.0 } else { 1.0 }).recip();
        let (gp, gpp) =
            if blend > 0.0 { (-2.0 * blend * inverse, 2.0 * blend * inverse * inverse * inverse) } else { (0.0, 0.0) };
        let (v1, v2) = (from.across.map(|v| v.dot(t2)), mirrored.map(|v| v.dot(t1)));
        let middle = gp * t1.dot(t2);
        let diagonal = |cosine: f64, v: [f64; 2]| -> [[f64; 2]; 2] {
            std::array::from_fn(|r| {
                std::array::from_fn(|s| w * (gpp * v[r] * v[s] + if r == s { cosine - middle } else { 0.0 }))
            })
        };
        let gradient = |across: &[Vec3; 2], v: [f64; 2]| [0, 1].map(|r| w * (gp * v[r] - across[r].dot(u)));
        SegmentTerms {
            gradient: [gradient(&from.across, v1), gradient(&to.across, v2)],
            diagonal: [diagonal(u.dot(t1), v1), diagonal(u.dot(to.tangent), v2)],
            coupling: [0, 1].map(|r| [0, 1].map(|s| w * (gpp * v1[r] * v2[s] + gp * from.across[r].dot(mirrored[s])))),
        }
    }

    fn arc_segment(&self, i: usize, node: &SpaceNode) -> ([f64; 2], f64) {
        let (u, w) = (self.units[i], 2.0 / self.lengths[i]);
        (node.across.map(|v| -w * v.dot(u)), w * u.dot(node.tangent))
    }

    fn turned(&self, node: &SpaceNode, [y, z]: [f64; 2]) -> SpaceNode {
        let angle = y.hypot(z);
        if angle == 0.0 {
            return *node;
        }
        let (s, c) = angle.sin_cos();
        let across = (node.across[0] * y + node.across[1] * z) / angle;
        SpaceNode::new(unit(node.tangent * c + across * s))
    }
}
