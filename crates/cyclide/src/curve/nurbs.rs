//! Rational B-splines as curves: one piece per knot span.

use super::param_curve::ParamCurve;
use super::piece_hull::PieceHull;
use crate::base::bounds::Aabb;
use crate::base::jet::CurveJet;
use crate::base::vector::Point3;
use crate::error::Result;
use crate::rational::{NurbsCurve, RationalBezier};

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
