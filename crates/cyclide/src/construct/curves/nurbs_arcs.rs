//! Rational B-splines as G1 arcs within a tolerance, for formats that know arcs only: [covered by biarcs](super::biarc_cover).

use super::biarc_cover::{SmoothPiece, append_biarcs};
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, Correspondence, CurvePlace, Span};
use crate::error::Result;
use crate::rational::NurbsCurve;

/// A knot span.
struct KnotSpan<'a>(&'a NurbsCurve, usize);

impl SmoothPiece for KnotSpan<'_> {
    fn point(&self, s: f64) -> Point3 {
        self.0.span_point(self.1, s)
    }

    fn moving(&self, s: f64) -> (Point3, Vec3) {
        let jet = self.0.span_jet(self.1, s);
        (jet.point, jet.d1)
    }
}

impl NurbsCurve {
    /// The curve as arcs, G1 where it is, within `tolerance` of it (sampled).
    pub(crate) fn g1_arcs(&self, tolerance: f64) -> Result<(Vec<Arc>, Correspondence)> {
        let mut arcs = Vec::new();
        let mut parts = Correspondence::from_start(Vec::new());
        for span in 0..self.span_count() {
            let before = arcs.len();
            append_biarcs(&KnotSpan(self, span), span, [0.0, 1.0], tolerance, &mut arcs)?;
            parts.spans.push(Span { pieces: arcs.len() - before, end: CurvePlace::after(span) });
        }
        Ok((arcs, parts))
    }
}
