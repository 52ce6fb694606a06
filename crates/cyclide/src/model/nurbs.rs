//! Rational B-splines on their way out: exact, cut at their kinks, or as arcs.

use super::chain::{ChainPiece, CurveChain};
use super::lower::{Exactness, Lower, Lowered};
use crate::curve::{ArcPath, Correspondence, ParamCurve as _, joints};
use crate::error::{Result, check_tolerance};
use crate::rational::NurbsCurve;

/// Turns of the tangent at a knot above this are kinks, where files begin another curve, radians.
const KINK: f64 = 1e-6;

impl Lower for NurbsCurve {
    /// The curve itself, knots and weights as they are, cut at kinks; a polygon as its segments.
    fn lower_to_chain(&self, tolerance: f64) -> Result<Lowered<CurveChain>> {
        check_tolerance(tolerance)?;
        if self.degree() == 1 {
            let (arcs, _, correspondence) = self.g1_arcs(tolerance)?;
            let form = ArcPath::new(arcs, self.is_closed())?.into();
            return Ok(Lowered { form, exactness: Exactness::Exact, correspondence });
        }
        let kinks = joints(self).into_iter().filter(|joint| joint.next > joint.piece && joint.angle > KINK);
        let cuts: Vec<f64> = kinks.map(|joint| self.breaks()[joint.next]).collect();
        let pieces = if cuts.is_empty() { vec![self.clone()] } else { self.cut_at_knots(&cuts)? };
        let pieces = pieces.into_iter().map(ChainPiece::Spline).collect();
        let correspondence = Correspondence::one_to_one(self.span_count());
        Ok(Lowered {
            form: CurveChain::new(pieces, self.is_closed(), 0.0)?,
            exactness: Exactness::Exact,
            correspondence,
        })
    }

    fn lower_to_arcs(&self, tolerance: f64) -> Result<Lowered<ArcPath>> {
        check_tolerance(tolerance)?;
        let (arcs, exact, correspondence) = self.g1_arcs(tolerance)?;
        let exactness = if exact { Exactness::Exact } else { Exactness::Sampled(tolerance) };
        Ok(Lowered { form: ArcPath::new(arcs, self.is_closed())?, exactness, correspondence })
    }
}
