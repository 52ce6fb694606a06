//! A spline on a torus as G1 arcs within a tolerance, for formats that know arcs only.
//!
//! Pieces that are arcs of circles stay as they are. The others are [covered by biarcs](crate::construct::curves::biarc_cover).

use crate::construct::curves::biarc_cover::{PieceOf, append_biarcs};
use crate::curve::{Arc, Correspondence, CurvePlace, ParamCurve as _, Span};
use crate::error::Result;
use crate::surface::TorusSpline;

impl TorusSpline {
    /// The curve as arcs, G1 where it is, within `tolerance` of it (sampled); true if all its pieces are arcs: then they are exact.
    pub(crate) fn g1_arcs(&self, tolerance: f64) -> Result<(Vec<Arc>, bool, Correspondence)> {
        let (mut arcs, mut exact) = (Vec::new(), true);
        let mut parts = Correspondence::from_start(Vec::new());
        for piece in 0..self.pieces().len() {
            let before = arcs.len();
            if self.pieces()[piece].degree() == 2 {
                let (start, end) = (self.piece_jet(piece, 0.0), self.piece_point(piece, 1.0));
                arcs.push(Arc::from_start_tangent(start.point, end, start.d1)?);
            } else {
                exact = false;
                append_biarcs(&PieceOf(self, piece), piece, [0.0, 1.0], tolerance, &mut arcs)?;
            }
            parts.spans.push(Span { pieces: arcs.len() - before, end: CurvePlace::after(piece) });
        }
        Ok((arcs, exact, parts))
    }
}
