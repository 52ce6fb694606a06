//! A rational B-spline as arcs within a tolerance, for formats that know arcs only: [biarcs](super::biarc_cover) over each knot span.

use super::biarc_cover::{PieceOf, append_biarcs};
use crate::curve::{Arc, Correspondence, CurvePlace, ParamCurve as _, Span};
use crate::error::Result;
use crate::rational::NurbsCurve;

impl NurbsCurve {
    /// The curve as arcs, G1 where it is, within `tolerance` of it (sampled); true if it is a polygon: then they are its
    /// segments. Spans whose points are all one have no arc.
    pub(crate) fn g1_arcs(&self, tolerance: f64) -> Result<(Vec<Arc>, bool, Correspondence)> {
        let is_polygon = self.degree() == 1;
        let mut arcs = Vec::new();
        let mut parts = Correspondence::from_start(Vec::with_capacity(self.span_count()));
        for span in 0..self.span_count() {
            let before = arcs.len();
            if self.has_extent(span) {
                if is_polygon {
                    arcs.push(Arc::segment(self.piece_point(span, 0.0), self.piece_point(span, 1.0))?);
                } else {
                    append_biarcs(&PieceOf(self, span), span, [0.0, 1.0], tolerance, &mut arcs)?;
                }
            }
            parts.spans.push(Span { pieces: arcs.len() - before, end: CurvePlace::after(span) });
        }
        Ok((arcs, is_polygon, parts))
    }

    /// True unless all control points of a span are one.
    fn has_extent(&self, span: usize) -> bool {
        let rows = self.span_rows(span);
        let point = |r: &[f64; 4]| [r[0] / r[3], r[1] / r[3], r[2] / r[3]];
        let (first, scale) =
            (point(&rows[0]), rows[0].iter().take(3).fold(0.0_f64, |m, v| m.max((v / rows[0][3]).abs())));
        let apart = |r: &[f64; 4]| point(r).iter().zip(first).any(|(v, f)| (v - f).abs() > ONE_POINT * scale);
        rows[1..].iter().any(apart)
    }
}

/// Distance of control points that are one, relative to their coordinates.
const ONE_POINT: f64 = 8.0 * f64::EPSILON;
