//! What is to be known of a net: singular patches, joints, weights, curvatures.

use super::CyclidicNet;
use crate::surface::ParamSurface as _;
use crate::surface::patch::CyclidePatch;

/// Parameters at which a patch is looked at: ends and quarters.
const PLACES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// A patch in which a parameter line shrinks to a point.
#[derive(Debug, Clone, PartialEq)]
pub struct SingularPatch {
    /// The quad, along s and along t.
    pub quad: [usize; 2],
    /// Parameters s of the lines along t that are one point.
    pub singular_s: Vec<f64>,
    /// Parameters t of the lines along s that are one point.
    pub singular_t: Vec<f64>,
}

/// Measures of a net, the largest of all patches or joints at 5 × 5 places of each patch and 5 of each edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NetQuality {
    /// Real part of the quotient of quaternions that should be a point, relative to the size of its patch.
    pub residual: f64,
    /// Cosine of the angle between the parameter lines.
    pub orthogonality: f64,
    /// Angle between the normals on the two sides of an edge, radians.
    pub kink: f64,
    /// Distance between the two sides of an edge at the same parameter, a length.
    pub gap: f64,
    /// Shortest and longest weight quaternion of the vertices.
    pub weights: [f64; 2],
    /// Smallest of the nine real weights of all patches; not positive where a patch is to be divided for files.
    pub smallest_real_weight: f64,
    /// Smallest and largest principal curvature against the normals, over whole patches; where a line is a node or
    /// singular, of the finite values as in [`CyclidePatch::k1_range`].
    pub curvatures: [f64; 2],
}

impl CyclidicNet {
    /// The patches inside which a parameter line shrinks to a point, with these parameters.
    #[must_use]
    pub fn singular_patches(&self) -> Vec<SingularPatch> {
        let singular = |(quad, patch): ([usize; 2], CyclidePatch)| {
            let found = SingularPatch { quad, singular_s: patch.singular_s(), singular_t: patch.singular_t() };
            (!found.singular_s.is_empty() || !found.singular_t.is_empty()).then_some(found)
        };
        self.quads().filter_map(singular).collect()
    }

    /// The quads whose `f_s × f_t` is against the normal at a corner: one family of their lines runs against the frame,
    /// as in an offset beyond a centre of curvature. None in a net made of a grid, nor in a whole cyclide.
    #[must_use]
    pub fn flipped_patches(&self) -> Vec<[usize; 2]> {
        let against = |patch: &CyclidePatch| {
            let (q1, q2) = (patch.q1(), patch.q2());
            [q1[0] * q2[0], q1[0] * q2[2], q1[2] * q2[0], q1[2] * q2[2]].iter().any(|q| *q < 0.0)
        };
        self.quads().filter(|(_, patch)| against(patch)).map(|(quad, _)| quad).collect()
    }

    /// Measures of patches and joints.
    #[must_use]
    pub fn quality(&self) -> NetQuality {
        let lengths = self.weights.iter().map(|w| w.norm());
        let mut quality = NetQuality {
            residual: 0.0,
            orthogonality: 0.0,
            kink: 0.0,
            gap: 0.0,
            weights: lengths.fold([f64::INFINITY, 0.0], |[lo, hi], w| [w.min(lo), w.max(hi)]),
            smallest_real_weight: f64::INFINITY,
            curvatures: [f64::INFINITY, f64::NEG_INFINITY],
        };
        let ([m, n], closed) = (self.size(), self.grid.closed());
        for ([i, j], patch) in self.quads() {
            quality.measure(&patch);
            if closed[0] || i + 1 < m {
                let next = self.patch((i + 1) % m, j);
                PLACES.iter().for_each(|&t| quality.join((&patch, 1.0, t), (&next, 0.0, t)));
            }
            if closed[1] || j + 1 < n {
                let next = self.patch(i, (j + 1) % n);
                PLACES.iter().for_each(|&s| quality.join((&patch, s, 1.0), (&next, s, 0.0)));
            }
        }
        quality
    }

    /// All quads with their patches.
    fn quads(&self) -> impl Iterator<Item = ([usize; 2], CyclidePatch)> {
        let [m, _] = self.size();
        self.patches().enumerate().map(move |(quad, patch)| ([quad % m, quad / m], patch))
    }
}

impl NetQuality {
    fn measure(&mut self, patch: &CyclidePatch) {
        for s in PLACES {
            for t in PLACES {
                self.residual = self.residual.max(patch.real_residual(s, t) / patch.size());
                let jet = patch.jet(s, t);
                if let (Some(a), Some(b)) = (jet.ds.unit(), jet.dt.unit()) {
                    self.orthogonality = self.orthogonality.max(a.dot(b).abs());
                }
            }
        }
        for [low, high] in [patch.k1_range(), patch.k2_range()] {
            self.curvatures = [self.curvatures[0].min(low), self.curvatures[1].max(high)];
        }
        for w in patch.real_weights().into_iter().flatten() {
            self.smallest_real_weight = self.smallest_real_weight.min(w);
        }
    }

    fn join(&mut self, (a, s0, t0): (&CyclidePatch, f64, f64), (b, s1, t1): (&CyclidePatch, f64, f64)) {
        self.kink = self.kink.max(a.unit_normal(s0, t0).angle(b.unit_normal(s1, t1)));
        self.gap = self.gap.max(a.point(s0, t0).distance(b.point(s1, t1)));
    }
}
