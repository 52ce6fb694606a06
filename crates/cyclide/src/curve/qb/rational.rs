//! The exact real rational form of a QB curve (`docs/math/qb-curves.md#real-rational-form`).
//!
//! ```text
//! W = d conj(d),   W x = Im(n conj(d))
//! ```
//! of degree `2n`. The weight function is positive on the curve, its Bernstein coefficients need not be: the curve is halved,
//! in its pairs, until they are.

use super::{QbCurve, Row};
use crate::base::bernstein;
use crate::base::bounds::Aabb;
use crate::base::jet::CurveJet;
use crate::base::vector::Point3;
use crate::curve::arc::Arc;
use crate::curve::param_curve::ParamCurve;
use crate::curve::piece_form::PieceForm;
use crate::curve::piece_hull::PieceHull;
use crate::error::{CurveError, Result};
use crate::rational::{Polynomial, RationalBezier};

/// Halvings of a curve until its weights are positive; what is left then is next to infinity.
const HALVINGS: u32 = 50;

/// A part of a curve in rational form, and the parameters between which it runs.
#[derive(Debug, Clone)]
pub(crate) struct RationalPart {
    pub(crate) curve: RationalBezier,
    pub(crate) from: f64,
    pub(crate) to: f64,
}

impl QbCurve {
    /// The curve as one real rational Bézier curve of degree `2n` at the same parameters. Its weights may be zero or negative.
    #[must_use]
    pub fn to_bezier(&self) -> RationalBezier {
        self.bezier_of(&self.rows).with_ends(self.ends[0], self.ends[1])
    }

    /// The curve cut into rational Bézier curves of degree `2n` with positive weights: each with the parameters `from` and `to` of
    /// this curve between which it runs.
    ///
    /// # Errors
    /// `curve-through-infinity`.
    pub fn to_positive_beziers(&self) -> Result<Vec<(RationalBezier, f64, f64)>> {
        self.positive_parts().map(|parts| parts.into_iter().map(|p| (p.curve, p.from, p.to)).collect())
    }

    pub(crate) fn positive_parts(&self) -> Result<Vec<RationalPart>> {
        let mut parts = Vec::new();
        let mut ahead = vec![(self.rows.to_vec(), 0.0, 1.0, HALVINGS)];
        while let Some((rows, from, to, halvings)) = ahead.pop() {
            let curve = self.bezier_of(&rows);
            let weights: Vec<f64> = curve.rows().iter().map(|row| row[3]).collect();
            if bernstein::are_weights(&weights) {
                parts.push(RationalPart { curve, from, to });
                continue;
            }
            let middle: f64 = 0.5 * (from + to);
            let Some(halvings) = halvings.checked_sub(1) else {
                return Err(CurveError::ThroughInfinity { t: middle }.into());
            };
            let (left, right) = bernstein::split(&rows, 0.5);
            ahead.extend([(right, middle, to, halvings), (left, from, middle, halvings)]);
        }
        // Neighbors meet in the same doubles.
        for part in &mut parts {
            let ends = [part.from, part.to].map(|t| Some(self.point(t)));
            let RationalPart { curve, from, to } = part.clone();
            *part = RationalPart { curve: curve.with_ends(ends[0], ends[1]), from, to };
        }
        Ok(parts)
    }

    /// The rational form of pairs that have the origin of this curve; of degree 1 at least.
    fn bezier_of(&self, rows: &[Row]) -> RationalBezier {
        let part = Self { origin: self.origin, rows: rows.iter().copied().collect(), ends: [None; 2] };
        let (num, den) = part.polynomials();
        let (weight, product) = (den.dot(&den), &num * &den.conj());
        let degree = weight.degree().max(1);
        let [_, x, y, z] = &product.0;
        let [x, y, z, w] = [x, y, z, &weight].map(|p: &Polynomial| p.elevated(degree));
        let o = self.origin;
        let row = |i: usize| {
            let [x, y, z, w] = [&x, &y, &z, &w].map(|p| p.coefficients()[i]);
            [x + o.x * w, y + o.y * w, z + o.z * w, w]
        };
        RationalBezier::from_rows_unchecked((0..=degree).map(row).collect())
    }

    /// The arc that the curve is, at the same parameters, if its degree is 1.
    pub(crate) fn to_arc(&self) -> Option<Arc> {
        if self.degree() != 1 {
            return None;
        }
        let [start, end] = self.ends;
        Arc::from_start_tangent(start?, end?, self.jet(0.0).d1).ok()
    }
}

impl ParamCurve for QbCurve {
    fn piece_count(&self) -> usize {
        1
    }
    fn piece_jet(&self, _piece: usize, s: f64) -> CurveJet {
        self.jet(s)
    }
    fn piece_hull(&self, _piece: usize, _tolerance: f64) -> Result<PieceHull> {
        let mut hull = PieceHull::within(0.0);
        for part in self.positive_parts()? {
            hull.push(&part.curve, part.from, part.to);
        }
        Ok(hull)
    }
    /// Closed if start and end are the same point.
    fn is_closed(&self) -> bool {
        self.ends[0].is_some() && self.ends[0] == self.ends[1]
    }
    fn piece_point(&self, _piece: usize, s: f64) -> Point3 {
        self.point(s)
    }
    /// An arc if the degree is 1.
    fn piece_form(&self, _piece: usize) -> PieceForm {
        self.to_arc().map_or(PieceForm::Free, PieceForm::Arc)
    }
    /// The box of the control points of the parts with positive weights; of the whole line of a curve through infinity.
    fn piece_bounds(&self, _piece: usize) -> Aabb {
        match self.positive_parts() {
            Ok(parts) => {
                let start = Aabb::of_point(self.point(0.0)).including(self.point(1.0));
                parts.iter().fold(start, |b, part| b.union(part.curve.piece_bounds(0)))
            }
            Err(_) => self.to_bezier().piece_bounds(0),
        }
    }
}
