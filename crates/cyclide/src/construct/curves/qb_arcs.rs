//! Chains of QB curves as G1 arcs within a tolerance, for formats that know arcs only. Spans of degree 1 are arcs; the others are
//! [covered by biarcs](super::biarc_cover).

use super::biarc_cover::{SmoothPiece, append_biarcs};
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, Correspondence, CurvePlace, ParamCurve as _, PieceForm, QbCurve, QbSpline, Span};
use crate::error::Result;

impl SmoothPiece for QbCurve {
    fn point(&self, s: f64) -> Point3 {
        Self::point(self, s)
    }

    fn moving(&self, s: f64) -> (Point3, Vec3) {
        let jet = self.jet(s);
        (jet.point, jet.d1)
    }
}

impl QbSpline {
    /// The curve as arcs, G1 where it is, within `tolerance` of it (sampled); true if all its spans are arcs: then they are exact.
    pub(crate) fn g1_arcs(&self, tolerance: f64) -> Result<(Vec<Arc>, bool, Correspondence)> {
        let (mut arcs, mut exact) = (Vec::new(), true);
        let mut parts = Correspondence::from_start(Vec::new());
        for (i, span) in self.spans().iter().enumerate() {
            let before = arcs.len();
            if let PieceForm::Arc(arc) = span.piece_form(0) {
                arcs.push(arc);
            } else {
                exact = false;
                append_biarcs(span, i, [0.0, 1.0], tolerance, &mut arcs)?;
            }
            parts.spans.push(Span { pieces: arcs.len() - before, end: CurvePlace::after(i) });
        }
        Ok((arcs, exact, parts))
    }
}
