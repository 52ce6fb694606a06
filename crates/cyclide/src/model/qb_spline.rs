//! QB splines on their way out: exact rational splines, or G1 arcs.

use super::chain::{ChainPiece, CurveChain};
use super::lower::{Exactness, Lower, Lowered};
use crate::curve::{Arc, ArcPath, CurvePlace, ParamCurve as _, PieceForm, QbSpline, Span};
use crate::error::{Result, check_tolerance};

impl Lower for QbSpline {
    /// One rational spline per smooth run, exact; runs of arcs as arcs. A closed curve with corners starts at its first corner.
    fn lower_to_chain(&self, tolerance: f64) -> Result<Lowered<CurveChain>> {
        check_tolerance(tolerance)?;
        let mut correspondence = self.correspondence_start();
        let n = self.spans().len();
        let mut pieces = Vec::new();
        let arc = |i: usize| match self.piece_form(i % n) {
            PieceForm::Arc(arc) => Some(arc),
            _ => None,
        };
        for run in self.smooth_runs() {
            if let Some(arcs) = run.clone().map(arc).collect::<Option<Vec<Arc>>>() {
                pieces.extend(arcs.into_iter().map(ChainPiece::Arc));
                correspondence.spans.extend(run.map(|i| Span { pieces: 1, end: CurvePlace::after(i) }));
            } else {
                pieces.push(ChainPiece::Spline(self.nurbs_of_run(run, &mut correspondence.spans)?));
            }
        }
        let form = CurveChain::new(pieces, self.is_closed(), 0.0)?;
        Ok(Lowered { form, exactness: Exactness::Exact, correspondence })
    }

    fn lower_to_arcs(&self, tolerance: f64) -> Result<Lowered<ArcPath>> {
        check_tolerance(tolerance)?;
        let (arcs, exact, correspondence) = self.g1_arcs(tolerance)?;
        let exactness = if exact { Exactness::Exact } else { Exactness::Sampled(tolerance) };
        Ok(Lowered { form: ArcPath::new(arcs, self.is_closed())?, exactness, correspondence })
    }
}
