//! The exact rational Bézier form of the rational variant.

use super::angle_law::BlendLaw;
use super::segment::BlendSegment;
use crate::base::bernstein;
use crate::base::vector::{Point3, Vec3};
use crate::rational::RationalBezier;

impl BlendSegment {
    /// The segment as a rational Bézier curve in the same parameter, of degree `2k + 2` (`50`, section 5), of a fair
    /// segment 4 where its blend is 1 and else 6 (`65`, section 6); `None` for the trigonometric variant, which has no
    /// rational form. Ends as given, to the bit; a whole segment has
    /// weight 1 at both ends. Weights between may be zero or negative (always somewhere for order 4), although
    /// the weight function is positive: split at the middle until they are.
    #[must_use]
    pub fn to_bezier(&self) -> Option<RationalBezier> {
        let (a, b) = self.law_factors()?;
        let ([ch, sh], [cf, sf]) = (self.law.half, self.law.full());
        let (h, t2) = (self.t1 * ch + self.b * sh, self.t1 * cf + self.b * sf);
        let arc = RationalArcOfTangents { from: self.t1, middle: h, to: t2, cos_half: ch };
        let rows = self.blend_rows(&a, &b, &arc, [0.0, 1.0]);
        self.cut_to_range(rows, [0.0, 1.0]).map(|(bezier, _)| bezier)
    }

    /// `A` and `B` of the angle law in Bernstein form.
    fn law_factors(&self) -> Option<(Vec<f64>, Vec<f64>)> {
        let powers = |k: usize| {
            let (mut a, mut b) = (vec![0.0; k + 1], vec![0.0; k + 1]);
            (a[0], b[k]) = (1.0, 1.0);
            (a, b)
        };
        match self.law.law {
            BlendLaw::Trigonometric { .. } => None,
            BlendLaw::Rational { order } => Some(powers(order as usize)),
            BlendLaw::Fair { blend } if blend >= 1.0 => Some(powers(1)),
            BlendLaw::Fair { blend } => Some((vec![1.0, 0.5 * blend, 0.0], vec![0.0, 0.5 * blend, 1.0])),
        }
    }

    /// The part of rows over the range `[l0, l1]` of the whole segment that lies in this segment's own range, with
    /// its length in the parameter of the whole; `None` if there is none. The ends are points of the curve: the same
    /// doubles as evaluation gives.
    pub(super) fn cut_to_range(&self, mut rows: Vec<[f64; 4]>, [l0, l1]: [f64; 2]) -> Option<(RationalBezier, f64)> {
        let (from, to) = (l0.max(self.range[0]), l1.min(self.range[1]));
        if !(from < to) {
            return None;
        }
        if to < l1 {
            rows = bernstein::split(&rows, (to - l0) / (l1 - l0)).0;
        }
        if from > l0 {
            rows = bernstein::split(&rows, (from - l0) / (to - l0)).1;
        }
        let last = rows.len() - 1;
        rows[0] = row(self.point_of_whole(from), rows[0][3]);
        rows[last] = row(self.point_of_whole(to), rows[last][3]);
        Some((RationalBezier::from_rows_unchecked(rows), to - from))
    }

    /// Homogeneous rows of `x1 + |d| l N/|N|²` over the parameter range `[l0, l1]`, where the tangent moves by the
    /// rational law `(A² from + 2AB middle + B² to)/(A² + 2AB cos + B²)`; `a`, `b` are the Bernstein coefficients
    /// of `A` and `B` over that range.
    ///
    /// ```text
    /// q = A² + 2AB cos + B²,  T = q t,  W = q (m² + l²) + 2 l m u·T,  W x = W x1 + |d| (l² q u + l m T)
    /// ```
    pub(super) fn blend_rows(
        &self,
        a: &[f64],
        b: &[f64],
        arc: &RationalArcOfTangents,
        [l0, l1]: [f64; 2],
    ) -> Vec<[f64; 4]> {
        let (aa, ab, bb) = (bernstein::product(a, a), bernstein::product(a, b), bernstein::product(b, b));
        let combined = |x: f64, y: f64, z: f64| -> Vec<f64> {
            (0..aa.len()).map(|i| x * aa[i] + 2.0 * y * ab[i] + z * bb[i]).collect()
        };
        let q = combined(1.0, arc.cos_half, 1.0);
        let along = combined(self.u.dot(arc.from), self.u.dot(arc.middle), self.u.dot(arc.to));
        let t = [0, 1, 2].map(|i| combined(arc.from[i], arc.middle[i], arc.to[i]));
        let (l, m) = ([l0, l1], [1.0 - l0, 1.0 - l1]);
        let (ll, lm, mm) = (bernstein::product(&l, &l), bernstein::product(&l, &m), bernstein::product(&m, &m));
        let squares: Vec<f64> = ll.iter().zip(&mm).map(|(x, y)| x + y).collect();
        let (qs, al) = (bernstein::product(&q, &squares), bernstein::product(&along, &lm));
        let (ql, tl) = (bernstein::product(&q, &ll), t.map(|c| bernstein::product(&c, &lm)));
        (0..qs.len())
            .map(|i| {
                let w = qs[i] + 2.0 * al[i];
                let v = (self.u * ql[i] + Vec3::new(tl[0][i], tl[1][i], tl[2][i])) * self.length;
                [w * self.x1.x + v.x, w * self.x1.y + v.y, w * self.x1.z + v.z, w]
            })
            .collect()
    }
}

/// Three tangents on a great circle, the middle one halfway, and the cosine of half the angle between the outer two.
pub(super) struct RationalArcOfTangents {
    pub(super) from: Vec3,
    pub(super) middle: Vec3,
    pub(super) to: Vec3,
    pub(super) cos_half: f64,
}

/// Homogeneous row of a point with a weight.
fn row(p: Point3, w: f64) -> [f64; 4] {
    [p.x * w, p.y * w, p.z * w, w]
}
