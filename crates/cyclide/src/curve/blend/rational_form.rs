//! The exact rational Bézier form of the rational variant.

use super::angle_law::BlendLaw;
use super::segment::BlendSegment;
use crate::base::bernstein;
use crate::base::vector::{Point3, Vec3};
use crate::rational::RationalBezier;

impl BlendSegment {
    /// The segment as a rational Bézier curve in the same parameter (`docs/math/circle-blends.md#rational-form`), of
    /// degree `2k + 2`, of a fair segment 4 where its blend is 1 and else 6; `None` for the trigonometric variant,
    /// which has no rational form. Ends as given, to the bit; a whole segment has weight 1 at both ends. Weights
    /// between may be zero or negative (always somewhere for order 4), although the weight function is positive: split
    /// at the middle until they are.
    #[must_use]
    pub fn to_bezier(&self) -> Option<RationalBezier> {
        let (factors, arc) = self.rational_law()?;
        let (factors, range) = self.cut_to_range(factors, [0.0, 1.0])?;
        Some(self.bezier_of(&factors, &arc, range))
    }

    /// The factors over the whole segment and the arc of its tangents; `None` for the trigonometric law.
    pub(super) fn rational_law(&self) -> Option<(LawFactors, RationalArcOfTangents)> {
        let factors = self.law_factors()?;
        let ([ch, sh], [cf, sf]) = (self.law.half, self.law.full());
        let (h, t2) = (self.t1 * ch + self.b * sh, self.t1 * cf + self.b * sf);
        Some((factors, RationalArcOfTangents::new(self.u, [self.t1, h, t2], self.law.half)))
    }

    /// `A` and `B` of the angle law in Bernstein form.
    fn law_factors(&self) -> Option<LawFactors> {
        let powers = |k: usize| {
            let (mut a, mut b) = (vec![0.0; k + 1], vec![0.0; k + 1]);
            (a[0], b[k]) = (1.0, 1.0);
            LawFactors { a, b }
        };
        match self.law.law {
            BlendLaw::Trigonometric { .. } => None,
            BlendLaw::Rational { order } => Some(powers(order as usize)),
            BlendLaw::Fair { blend } if blend >= 1.0 => Some(powers(1)),
            BlendLaw::Fair { blend } => {
                Some(LawFactors { a: vec![1.0, 0.5 * blend, 0.0], b: vec![0.0, 0.5 * blend, 1.0] })
            }
        }
    }

    /// The part of factors over the range `[l0, l1]` of the whole segment that lies in this segment's own range, with
    /// that part; `None` if there is none.
    pub(super) fn cut_to_range(&self, mut factors: LawFactors, [l0, l1]: [f64; 2]) -> Option<(LawFactors, [f64; 2])> {
        let (from, to) = (l0.max(self.range[0]), l1.min(self.range[1]));
        if !(from < to) {
            return None;
        }
        if to < l1 {
            factors = factors.split((to - l0) / (l1 - l0)).0;
        }
        if from > l0 {
            factors = factors.split((from - l0) / (to - l0)).1;
        }
        Some((factors, [from, to]))
    }

    /// The curve over a part of the whole segment, by the factors over that part. The ends are points of the segment:
    /// the same doubles as evaluation gives.
    pub(super) fn bezier_of(
        &self,
        factors: &LawFactors,
        arc: &RationalArcOfTangents,
        [from, to]: [f64; 2],
    ) -> RationalBezier {
        let mut rows = self.blend_rows(factors, arc, [from, to]);
        let last = rows.len() - 1;
        rows[0] = row(self.point_of_whole(from), rows[0][3]);
        rows[last] = row(self.point_of_whole(to), rows[last][3]);
        RationalBezier::from_rows_unchecked(rows)
    }

    /// Homogeneous rows of `x1 + |d| l N/|N|²` over the parameter range `[l0, l1]`, where the tangent moves by the
    /// rational law `(A² from + 2AB middle + B² to)/(A² + 2AB cos + B²)`.
    ///
    /// ```text
    /// q = A² + 2AB cos + B²,  T = q t,  P = T + q u,  p = u·P
    /// W = q (m² + l²) + 2 l m u·T = q (m-l)² + 2 l m p
    /// W x = W x1 + |d| l (l q u + m T) = W x1 + |d| l (m P - q (m-l) u)
    /// ```
    ///
    /// The second forms lose no digits where the circles come near infinity (`t` near `-u`), if the range does not
    /// contain `l = 1/2` inside.
    fn blend_rows(&self, factors: &LawFactors, arc: &RationalArcOfTangents, [l0, l1]: [f64; 2]) -> Vec<[f64; 4]> {
        let LawFactors { a, b } = factors;
        let squares = [bernstein::product(a, a), bernstein::product(a, b), bernstein::product(b, b)];
        let difference: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
        let differences = bernstein::product(&difference, &difference);
        let combined = |[x, y, z]: [f64; 3]| -> Vec<f64> {
            (0..squares[0].len()).map(|i| x * squares[0][i] + 2.0 * y * squares[1][i] + z * squares[2][i]).collect()
        };
        let (l, m, e) = ([l0, l1], [1.0 - l0, 1.0 - l1], [1.0 - 2.0 * l0, 1.0 - 2.0 * l1]);
        let (lm, ee, le) = (bernstein::product(&l, &m), bernstein::product(&e, &e), bernstein::product(&l, &e));
        // Beyond half a turn of the tangents A² + B² and 2AB cos cancel: (A-B)² + 2AB (1 + cos) do not.
        let q: Vec<f64> = match arc.cos_half {
            cos if cos < 0.0 => {
                (0..squares[1].len()).map(|i| differences[i] + 2.0 * arc.versine * squares[1][i]).collect()
            }
            cos => combined([1.0, cos, 1.0]),
        };
        let (qe, pl) = (bernstein::product(&q, &ee), bernstein::product(&combined(arc.along), &lm));
        let ql = bernstein::product(&q, &le);
        let toward = [0, 1, 2].map(|i| bernstein::product(&combined(arc.from_infinity.map(|v| v[i])), &lm));
        (0..qe.len())
            .map(|i| {
                let w = qe[i] + 2.0 * pl[i];
                let v = (Vec3::new(toward[0][i], toward[1][i], toward[2][i]) - self.u * ql[i]) * self.length;
                [w * self.x1.x + v.x, w * self.x1.y + v.y, w * self.x1.z + v.z, w]
            })
            .collect()
    }
}

/// The Bernstein coefficients of `A` and `B` of a rational angle law over a part of a segment.
pub(super) struct LawFactors {
    pub(super) a: Vec<f64>,
    pub(super) b: Vec<f64>,
}

impl LawFactors {
    /// Over both parts of the range.
    pub(super) fn split(&self, t: f64) -> (Self, Self) {
        let both = |f: &[f64]| {
            let rows: Vec<[f64; 1]> = f.iter().map(|v| [*v]).collect();
            let (left, right) = bernstein::split(&rows, t);
            [left, right].map(|rows| rows.iter().map(|r| r[0]).collect::<Vec<f64>>())
        };
        let ([a0, a1], [b0, b1]) = (both(&self.a), both(&self.b));
        (Self { a: a0, b: b0 }, Self { a: a1, b: b1 })
    }
}

/// Three tangents on a great circle, the middle one halfway, measured from `-u`, the direction to infinity.
pub(super) struct RationalArcOfTangents {
    /// Cosine of half the angle between the outer two.
    cos_half: f64,
    /// `1 - |cos|`.
    versine: f64,
    /// `t + u` of the outer tangents, `t + cos u` of the middle one.
    from_infinity: [Vec3; 3],
    /// `u` times these.
    along: [f64; 3],
}

impl RationalArcOfTangents {
    /// From the unit chord, the tangents, and cosine and sine of half the angle between the outer two.
    pub(super) fn new(u: Vec3, [from, middle, to]: [Vec3; 3], [cos_half, sin_half]: [f64; 2]) -> Self {
        let versine = sin_half * sin_half / (1.0 + cos_half.abs());
        let sign = 1.0_f64.copysign(cos_half);
        let (first, last, across) = (from + u, to + u, middle * sign + u);
        // u·(t + u) = |t + u|²/2 of unit vectors.
        let half = |sum: Vec3| 0.5 * sum.length_squared();
        Self {
            cos_half,
            versine,
            from_infinity: [first, (across - u * versine) * sign, last],
            along: [half(first), (half(across) - versine) * sign, half(last)],
        }
    }
}

/// Homogeneous row of a point with a weight.
fn row(p: Point3, w: f64) -> [f64; 4] {
    [p.x * w, p.y * w, p.z * w, w]
}
