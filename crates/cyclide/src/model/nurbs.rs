//! Rational B-splines on their way out: as they are, or G1 arcs.

use super::chain::{ChainPiece, CurveChain};
use super::lower::{Exactness, Lower, Lowered};
use crate::curve::{ArcPath, Correspondence, ParamCurve as _};
use crate::error::{Result, check_tolerance};
use crate::rational::NurbsCurve;

impl Lower for NurbsCurve {
    /// Itself.
    fn lower_to_chain(&self, tolerance: f64) -> Result<Lowered<CurveChain>> {
        check_tolerance(tolerance)?;
        let correspondence = Correspondence::one_to_one(self.span_count());
        let form = CurveChain::new(vec![ChainPiece::Spline(self.clone())], self.is_closed(), 0.0)?;
        Ok(Lowered { form, exactness: Exactness::Exact, correspondence })
    }

    fn lower_to_arcs(&self, tolerance: f64) -> Result<Lowered<ArcPath>> {
        check_tolerance(tolerance)?;
        let (arcs, correspondence) = self.g1_arcs(tolerance)?;
        let form = ArcPath::new(arcs, self.is_closed())?;
        Ok(Lowered { form, exactness: Exactness::Sampled(tolerance), correspondence })
    }
}
