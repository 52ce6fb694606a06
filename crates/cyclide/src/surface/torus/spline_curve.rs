//! Splines on a torus as curves of the kernel, and their exact rational form.

use super::rows::{RationalPart, Spans};
use super::spline::TorusSpline;
use crate::base::bounds::Aabb;
use crate::base::jet::CurveJet;
use crate::base::vector::Point3;
use crate::curve::{Correspondence, CurvePlace, ParamCurve, PieceHull, Span};
use crate::error::{CurveError, Error, NurbsError, Result};
use crate::rational::{NurbsCurve, RationalBezier};

impl TorusSpline {
    /// The exact rational B-spline: one span for each piece, or several where its weights would not be positive, over the knots
    /// brought to `[0, 1]`. Degree 4, or 2 if all pieces are arcs of circles. Points at knots are those of the spline, to the bit.
    ///
    /// # Errors
    /// `empty-interval` (a span so short in the parameter that its knots are one number, with the segment: knots or speeds that differ too much), `weight-not-positive`,
    /// `not-a-spline`, `disconnected` (a piece so uneven, or a torus whose radii are so nearly equal, that numbers have lost their digits).
    pub fn to_nurbs(&self) -> Result<NurbsCurve> {
        self.to_nurbs_parts(Spans::Positive).map(|(curve, _)| curve)
    }

    /// The same curve with C1 knots ([`NurbsCurve::with_c1_knots`]), which CAD systems want of a curve that they sweep or offset along:
    /// degree 7 (5 if all pieces are arcs of circles), in spans so even that such a form exists; as
    /// [`to_nurbs`](Self::to_nurbs) gives it where rounding leaves none.
    ///
    /// # Errors
    /// As [`to_nurbs`](Self::to_nurbs).
    pub fn to_c1_nurbs(&self) -> Result<NurbsCurve> {
        let (curve, _) = self.to_nurbs_parts(Spans::Even)?;
        Ok(curve.with_c1_knots().unwrap_or(curve))
    }

    /// The same, with the pieces that the spans stand for.
    pub(crate) fn to_nurbs_parts(&self, spans: Spans) -> Result<(NurbsCurve, Correspondence)> {
        let (mut curves, mut intervals) = (Vec::new(), Vec::new());
        let mut parts = Correspondence::from_start(Vec::with_capacity(self.pieces.len()));
        for i in 0..self.pieces.len() {
            let length = self.knots[i + 1] - self.knots[i];
            let before = curves.len();
            for (curve, from, to) in self.rational_parts(i, spans) {
                curves.push(curve);
                intervals.push(length * (to - from));
            }
            parts.spans.push(Span { pieces: curves.len() - before, end: CurvePlace::after(i) });
        }
        self.check_intervals(&intervals, &parts)?;
        let degree = curves.iter().map(RationalBezier::degree).max().unwrap_or(0);
        for curve in curves.iter_mut().filter(|c| c.degree() < degree) {
            let ends = [0.0, 1.0].map(|s| curve.point(s));
            *curve = curve.multiplied(&vec![1.0; degree - curve.degree() + 1]).with_ends(Some(ends[0]), Some(ends[1]));
        }
        // What rounding tears apart, the torus is too narrow for.
        let of_torus = |error: Error| match error {
            Error::Curve(CurveError::Disconnected { .. }) | Error::Nurbs(NurbsError::WeightNotPositive { .. }) => {
                error.in_field("torus")
            }
            other => other,
        };
        let curve = NurbsCurve::from_beziers(&curves, &intervals).map_err(of_torus)?;
        // A point times its weight and divided by it again is rounded: joints are put in as they are.
        let mut points = curve.control_points().to_vec();
        let mut span = 0;
        for (joint, pieces) in self.joints.iter().zip(parts.spans.iter().map(|s| s.pieces).chain([0])) {
            points[span * degree] = *joint;
            span += pieces;
        }
        // Its own parameter evaluates it, however uneven the weights are.
        let curve = NurbsCurve::with_any_weights(degree, curve.knots().to_vec(), points, curve.weights().to_vec())?;
        Ok((curve, parts))
    }

    /// Refuses spans whose knots are one number.
    fn check_intervals(&self, intervals: &[f64], parts: &Correspondence) -> Result<()> {
        let whole: f64 = intervals.iter().sum();
        let mut spans = intervals.iter();
        for (piece, part) in parts.spans.iter().enumerate() {
            let shortest = spans.by_ref().take(part.pieces).fold(f64::INFINITY, |least, h| least.min(*h));
            let limit = 2.0 * f64::EPSILON * whole;
            if !(shortest > limit) {
                let index = self.segments.iter().position(|segment| segment.pieces.contains(&piece)).unwrap_or(0);
                return Err(CurveError::EmptyInterval { index, length: shortest, limit }.into());
            }
        }
        Ok(())
    }

    /// The parts of a piece with positive weights, and the parameters between which each runs; the ends of the piece are its joints.
    fn rational_parts(&self, piece: usize, spans: Spans) -> Vec<(RationalBezier, f64, f64)> {
        let parts = self.torus.rational_parts(&self.pieces[piece], spans);
        let (last, joints) = (parts.len() - 1, [self.joints[piece], self.joints[piece + 1]]);
        let with_ends = |(k, part): (usize, RationalPart)| {
            let start = (k == 0).then_some(joints[0]);
            let end = (k == last).then_some(joints[1]);
            (part.curve.with_ends(start, end), part.from, part.to)
        };
        parts.into_iter().enumerate().map(with_ends).collect()
    }
}

impl ParamCurve for TorusSpline {
    fn piece_count(&self) -> usize {
        self.pieces.len()
    }

    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
        let p = &self.pieces[piece];
        let mut jet = self.torus.jet_at(&p.unit_pair(s), &p.rates(s));
        // The ends are the joints to the bit.
        if s <= 0.0 {
            jet.point = self.joints[piece];
        } else if s >= 1.0 {
            jet.point = self.joints[piece + 1];
        }
        jet
    }

    fn piece_hull(&self, piece: usize, _tolerance: f64) -> Result<PieceHull> {
        let mut hull = PieceHull::within(0.0);
        for (curve, from, to) in self.rational_parts(piece, Spans::Positive) {
            hull.push(&curve, from, to);
        }
        Ok(hull)
    }

    fn is_closed(&self) -> bool {
        self.closed
    }

    fn piece_point(&self, piece: usize, s: f64) -> Point3 {
        if s <= 0.0 {
            self.joints[piece]
        } else if s >= 1.0 {
            self.joints[piece + 1]
        } else {
            self.torus.world_point(self.torus.shape.point(&self.pieces[piece].unit_pair(s)))
        }
    }

    fn piece_speed(&self, piece: usize, s: f64) -> f64 {
        let p = &self.pieces[piece];
        self.torus.speed_at(&p.unit_pair(s), p.rate(s))
    }

    fn piece_bounds(&self, piece: usize) -> Aabb {
        let start = Aabb::of_point(self.joints[piece]).including(self.joints[piece + 1]);
        self.rational_parts(piece, Spans::Positive)
            .iter()
            .fold(start, |b, (curve, _, _)| b.union(curve.piece_bounds(0)))
    }
}
