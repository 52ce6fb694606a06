//! Rational pieces of either variant: exact for the rational one, certified for the trigonometric one.

use super::angle_law::smooth_step;
use super::rational_form::{LawFactors, RationalArcOfTangents};
use super::segment::BlendSegment;
use crate::base::bernstein;
use crate::base::roots::bracketed;
use crate::base::vector::Vec3;
use crate::curve::PieceHull;
use crate::error::{NumberError, Result};
use crate::rational::RationalBezier;

/// Most rational pieces made of one segment.
const PIECE_CAP: usize = 4096;
/// Deepest halving of a piece until its weights are positive. One halving suffices for all but circles that pass
/// next to infinity (`docs/math/circle-blends.md#rational-form`), and those come within 1e-9 of it at most: 2^-30.
const HALVING_CAP: u32 = 40;

/// One rational piece and the length of its parameter interval, in chord lengths: with knots that far apart the
/// pieces of a whole spline join C1.
pub(crate) struct RationalPiece {
    pub(crate) bezier: RationalBezier,
    pub(crate) interval: f64,
}

impl BlendSegment {
    /// The segment in rational Bézier pieces with positive weights, and a bound on their distance from it: 0 for the
    /// rational laws (degree `2k + 2`, fair 4 or 6), at most `tolerance` for the trigonometric one (degree `4k`).
    ///
    /// # Errors
    /// `too-many-pieces` if the tolerance asks for more than 4096, `arc-through-infinity`.
    pub(crate) fn rational_pieces(&self, tolerance: f64, segment: usize) -> Result<(Vec<RationalPiece>, f64)> {
        self.check_finite(segment)?;
        let mut pieces = Vec::new();
        let mut add = |factors, arc: &RationalArcOfTangents, range| {
            if let Some((factors, range)) = self.cut_to_range(factors, range) {
                self.halve_until_positive(&factors, arc, range, HALVING_CAP, &mut pieces);
            }
        };
        if let Some((factors, arc)) = self.rational_law() {
            add(factors, &arc, [0.0, 1.0]);
            return Ok((pieces, 0.0));
        }
        let n = self.parts_within(tolerance, segment)?;
        let mut from = 0.0;
        for i in 0..n {
            let to = if i + 1 == n { 1.0 } else { self.parameter_of_step((i + 1) as f64 / n as f64) };
            let (factors, arc) = self.part_of_law(i, n, [from, to]);
            add(factors, &arc, [from, to]);
            from = to;
        }
        Ok((pieces, self.part_error(n)))
    }

    /// The rational pieces at equal parameters, as a proof of distances; in closed form where the segment is an arc.
    ///
    /// # Errors
    /// As [`rational_pieces`](Self::rational_pieces).
    pub(crate) fn hull(&self, tolerance: f64, segment: usize) -> Result<PieceHull> {
        if self.to_arc().is_some() {
            return Ok(PieceHull::closed_form());
        }
        let (pieces, bound) = self.rational_pieces(tolerance, segment)?;
        let mut hull = PieceHull::within(bound);
        // Their intervals are in chord lengths of the whole segment and follow one another.
        let scale = self.length * (self.range[1] - self.range[0]);
        let mut from = 0.0;
        for (i, piece) in pieces.iter().enumerate() {
            let to = if i + 1 == pieces.len() { 1.0 } else { from + piece.interval / scale };
            hull.push(&piece.bezier, from, to);
            from = to;
        }
        Ok(hull)
    }

    /// Bound on the distance between the trigonometric segment and its `n` rational parts
    /// (`docs/math/circle-blends.md#rational-form`): the angle is off by at most `E(theta/n)`, and
    /// `|dx/dphi| <= |d|/|u+t|²`.
    fn part_error(&self, n: usize) -> f64 {
        self.length * angle_error(self.law.theta / n as f64) / self.distance_from_infinity_squared()
    }

    /// Fewest parts, each of at most 3 radians, whose error bound is within the tolerance.
    fn parts_within(&self, tolerance: f64, segment: usize) -> Result<usize> {
        let theta = self.law.theta;
        // E(Delta) <= 0.0046 Delta^3 for Delta <= 3.
        let size = self.length / (tolerance * self.distance_from_infinity_squared());
        let needed = (theta * (0.0046 * size).cbrt()).max(theta / 3.0).ceil().max(1.0);
        if needed > PIECE_CAP as f64 {
            return Err(NumberError::TooManyPieces {
                what: "segment",
                segment: Some(segment),
                needed,
                cap: PIECE_CAP,
                remedy: "use the rational variant or a larger tolerance",
            }
            .into());
        }
        let mut n = needed as usize;
        while n > 1 && theta <= 3.0 * (n - 1) as f64 && self.part_error(n - 1) <= tolerance {
            n -= 1;
        }
        Ok(n)
    }

    /// The parameter at which the smooth step has the given value.
    fn parameter_of_step(&self, value: f64) -> f64 {
        bracketed(|l| smooth_step(self.law.law.order(), l) - value, 0.0, 1.0, 0.0)
    }

    /// The law of part `i` of `n` over `[l0, l1] = f^-1([i/n, (i+1)/n])`: the rational law with `B = n f(l) - i`,
    /// `A = 1 - B`. Equal slopes at both ends of every part make the inner joints C1.
    fn part_of_law(&self, i: usize, n: usize, range: [f64; 2]) -> (LawFactors, RationalArcOfTangents) {
        let k = self.law.law.order() as usize;
        // f_k has the Bernstein coefficients 0 (k times), 1 (k times).
        let mut step: Vec<[f64; 1]> = (0..2 * k).map(|j| [if j < k { 0.0 } else { 1.0 }]).collect();
        if range[1] < 1.0 {
            step = bernstein::split(&step, range[1]).0;
        }
        if range[0] > 0.0 {
            step = bernstein::split(&step, range[0] / range[1]).1;
        }
        let mut b: Vec<f64> = step.iter().map(|f| n as f64 * f[0] - i as f64).collect();
        (b[0], b[2 * k - 1]) = (0.0, 1.0);
        let a: Vec<f64> = b.iter().map(|b| 1.0 - b).collect();
        let delta = self.law.theta / n as f64;
        let tangent = |parts: f64| -> Vec3 {
            let (s, c) = (parts * delta).sin_cos();
            self.t1 * c + self.b * s
        };
        let (s, c) = (0.5 * delta).sin_cos();
        let tangents = [0.0, 0.5, 1.0].map(|part| tangent(i as f64 + part));
        (LawFactors { a, b }, RationalArcOfTangents::new(self.u, tangents, [c, s]))
    }

    /// Appends the part of the segment, halved where weights are not positive. The rows are made anew for each half:
    /// those of the whole have lost the digits of weights that are far below 1.
    fn halve_until_positive(
        &self,
        factors: &LawFactors,
        arc: &RationalArcOfTangents,
        [from, to]: [f64; 2],
        depth: u32,
        pieces: &mut Vec<RationalPiece>,
    ) {
        let bezier = self.bezier_of(factors, arc, [from, to]);
        let middle = 0.5 * (from + to);
        if depth == 0 || bezier.has_positive_weights() || !(from < middle && middle < to) {
            pieces.push(RationalPiece { bezier, interval: (to - from) * self.length });
            return;
        }
        let (left, right) = factors.split(0.5);
        self.halve_until_positive(&left, arc, [from, middle], depth - 1, pieces);
        self.halve_until_positive(&right, arc, [middle, to], depth - 1, pieces);
    }
}

/// `E(Delta)`: the largest difference between the rational and the uniform angle over an arc of `Delta`
/// (`docs/math/circle-blends.md#rational-form`).
fn angle_error(delta: f64) -> f64 {
    if delta < 1e-2 {
        return 0.00401 * delta * delta * delta;
    }
    let t = (0.25 * delta).tan();
    let z = (4.0 * t / delta - 1.0).sqrt() / t;
    (2.0 * (z * t).atan() - 0.5 * z * delta).abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angle_error_is_the_largest_difference_and_joins_its_series() {
        for delta in [0.011_f64, 0.3, 1.0, 3.0] {
            let t = (0.25 * delta).tan();
            let difference = |z: f64| (2.0 * (z * t).atan() - 0.5 * z * delta).abs();
            let sampled = (0..=1000).map(|i| difference(f64::from(i) / 1000.0)).fold(0.0, f64::max);
            let bound = angle_error(delta);
            // A maximum is met to the square of the step; rounding of the difference of angles near 1e-9.
            assert!(sampled <= bound * (1.0 + 1e-12) + 1e-16 && sampled >= bound * (1.0 - 1e-5), "{delta}");
            assert!(bound <= 0.0046 * delta.powi(3));
        }
        assert!((angle_error(0.010_000_1) / angle_error(0.009_999_9) - 1.0).abs() < 3e-3);
    }
}
