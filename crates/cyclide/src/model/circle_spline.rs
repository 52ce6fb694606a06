//! Circle splines on their way out: exact or certified rational splines, or G1 arcs.

use super::chain::{ChainPiece, CurveChain};
use super::lower::{Exactness, Lower, Lowered};
use crate::construct::RationalRun;
use crate::curve::{ArcPath, CircleSpline, ParamCurve};
use crate::error::{Result, check_tolerance};

impl Lower for CircleSpline {
    /// One rational spline per smooth run, exact for the rational variant; runs of arcs as arcs. A closed curve with
    /// corners starts at its first corner.
    fn lower_to_chain(&self, tolerance: f64) -> Result<Lowered<CurveChain>> {
        check_tolerance(tolerance)?;
        let (runs, bound, correspondence) = self.rational_runs(tolerance)?;
        let pieces = runs.into_iter().flat_map(|run| match run {
            RationalRun::Arcs(arcs) => arcs.into_iter().map(ChainPiece::Arc).collect(),
            RationalRun::Spline(spline) => vec![ChainPiece::Spline(spline)],
        });
        let exactness = if bound > 0.0 { Exactness::Proved(bound) } else { Exactness::Exact };
        let form = CurveChain::new(pieces.collect(), self.is_closed(), 0.0)?;
        Ok(Lowered { form, exactness, correspondence })
    }

    fn lower_to_arcs(&self, tolerance: f64) -> Result<Lowered<ArcPath>> {
        check_tolerance(tolerance)?;
        let (arcs, exact, correspondence) = self.g1_arcs(tolerance)?;
        let exactness = if exact { Exactness::Exact } else { Exactness::Sampled(tolerance) };
        Ok(Lowered { form: ArcPath::new(arcs, self.is_closed())?, exactness, correspondence })
    }
}
