//! Rational Bézier curves and B-splines as curves: one piece, or one per knot span.

use super::param_curve::ParamCurve;
use super::piece_hull::PieceHull;
use crate::base::bernstein;
use crate::base::bounds::Aabb;
use crate::base::jet::CurveJet;
use crate::base::vector::Point3;
use crate::error::Result;
use crate::rational::{NurbsCurve, RationalBezier};

impl ParamCurve for RationalBezier {
    fn piece_count(&self) -> usize {
        1
    }
    fn piece_jet(&self, _piece: usize, s: f64) -> CurveJet {
        self.jet(s)
    }
    fn piece_hull(&self, _piece: usize, _tolerance: f64) -> Result<PieceHull> {
        Ok(PieceHull::exact(self))
    }
    /// Closed if start and end are the same point.
    fn is_closed(&self) -> bool {
        self.point(0.0) == self.point(1.0)
    }
    fn piece_point(&self, _piece: usize, s: f64) -> Point3 {
        self.point(s)
    }
    /// The box of the control points, if all weights are positive; else of the parts of the curve whose weights are.
    fn piece_bounds(&self, _piece: usize) -> Aabb {
        bounds_of_rows(self.rows(), HALVINGS)
    }
}

/// Halvings of a curve until its weights are positive: a piece that still has others is next to infinity.
const HALVINGS: u32 = 40;

/// A box around a rational curve by the hulls of its parts.
fn bounds_of_rows(rows: &[[f64; 4]], halvings: u32) -> Aabb {
    let point = |r: &[f64; 4]| Point3::new(r[0] / r[3], r[1] / r[3], r[2] / r[3]);
    let of_one_sign = rows.iter().all(|r| r[3] > 0.0) || rows.iter().all(|r| r[3] <= 0.0);
    if halvings == 0 || of_one_sign {
        let start = Aabb::of_point(point(&rows[0]));
        return rows.iter().filter(|r| r[3] != 0.0).fold(start, |b, r| b.including(point(r)));
    }
    let (left, right) = bernstein::split(rows, 0.5);
    bounds_of_rows(&left, halvings - 1).union(bounds_of_rows(&right, halvings - 1))
}

impl ParamCurve for NurbsCurve {
    fn piece_count(&self) -> usize {
        self.span_count()
    }
    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
        self.span_jet(piece, s)
    }
    fn piece_hull(&self, piece: usize, _tolerance: f64) -> Result<PieceHull> {
        Ok(PieceHull::exact(&RationalBezier::from_rows_unchecked(self.span_rows(piece).to_vec())))
    }
    /// Closed if start and end are the same point.
    fn is_closed(&self) -> bool {
        let points = self.control_points();
        points[0] == points[points.len() - 1]
    }
    fn piece_point(&self, piece: usize, s: f64) -> Point3 {
        self.span_point(piece, s)
    }
    fn piece_speed(&self, piece: usize, s: f64) -> f64 {
        self.span_velocity(piece, s).length()
    }
    /// The box of the span's control points: weights are positive, so the curve lies in their hull.
    fn piece_bounds(&self, piece: usize) -> Aabb {
        let start = Aabb::of_point(self.span_point(piece, 0.0));
        let rows = self.span_rows(piece);
        rows.iter()
            .filter(|r| r[3] > 0.0)
            .fold(start, |b, r| b.including(Point3::new(r[0] / r[3], r[1] / r[3], r[2] / r[3])))
    }
}
