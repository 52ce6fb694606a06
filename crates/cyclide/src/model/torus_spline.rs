//! Splines on tori on their way out: exact rational splines, or G1 arcs.

use super::chain::{ChainPiece, CurveChain};
use super::lower::{Exactness, Lower, Lowered};
use crate::curve::{ArcPath, ParamCurve as _};
use crate::error::{Result, check_tolerance};
use crate::surface::{Spans, TorusSpline};

impl Lower for TorusSpline {
    /// One rational spline, exact, in spans so even that it can be written with C1 knots.
    fn lower_to_chain(&self, tolerance: f64) -> Result<Lowered<CurveChain>> {
        check_tolerance(tolerance)?;
        let (spline, correspondence) = self.to_nurbs_parts(Spans::Even)?;
        let form = CurveChain::new(vec![ChainPiece::Spline(spline)], self.is_closed(), 0.0)?;
        Ok(Lowered { form, exactness: Exactness::Exact, correspondence })
    }

    fn lower_to_arcs(&self, tolerance: f64) -> Result<Lowered<ArcPath>> {
        check_tolerance(tolerance)?;
        let (arcs, exact, correspondence) = self.g1_arcs(tolerance)?;
        let exactness = if exact { Exactness::Exact } else { Exactness::Sampled(tolerance) };
        Ok(Lowered { form: ArcPath::new(arcs, self.is_closed())?, exactness, correspondence })
    }
}
