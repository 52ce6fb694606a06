//! Lowering: from an object to the carriers that exchange formats know, with the exactness that was kept.

use super::chain::CurveChain;
use crate::curve::{Arc, ArcPath, Circle, ParamCurve};
use crate::error::Result;

/// How a carrier relates to the object it stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Exactness {
    /// The same point set, up to the rounding of the numbers.
    Exact,
    /// No point farther away than this: it follows from the shapes of the pieces, between all places looked at too.
    Proved(f64),
    /// No point farther away than this at many places, with a reserve between them: no proof.
    Sampled(f64),
}

impl Exactness {
    /// The bound on the distance; 0 if exact.
    #[must_use]
    pub fn bound(self) -> f64 {
        match self {
            Self::Exact => 0.0,
            Self::Proved(bound) | Self::Sampled(bound) => bound,
        }
    }
}

/// A curve that can leave the kernel. Exporters know the two carriers only, so a new curve changes no exporter.
pub trait Lower {
    /// The curve as arcs and rational splines: exact where it has such a form, else within `tolerance`.
    ///
    /// # Errors
    /// `tolerance-not-positive`, `too-many-pieces`.
    fn to_chain(&self, tolerance: f64) -> Result<(CurveChain, Exactness)>;

    /// The curve as G1 arcs and segments only, for formats without rational splines, exact where it consists of
    /// arcs, else within `tolerance`.
    ///
    /// # Errors
    /// `tolerance-not-positive`, `too-many-pieces`.
    fn to_arcs(&self, tolerance: f64) -> Result<(ArcPath, Exactness)>;
}

impl Lower for ArcPath {
    fn to_chain(&self, _tolerance: f64) -> Result<(CurveChain, Exactness)> {
        Ok((self.clone().into(), Exactness::Exact))
    }
    fn to_arcs(&self, _tolerance: f64) -> Result<(ArcPath, Exactness)> {
        Ok((self.clone(), Exactness::Exact))
    }
}

impl Lower for Arc {
    fn to_chain(&self, tolerance: f64) -> Result<(CurveChain, Exactness)> {
        ArcPath::new(vec![*self], self.is_closed())?.to_chain(tolerance)
    }
    fn to_arcs(&self, tolerance: f64) -> Result<(ArcPath, Exactness)> {
        ArcPath::new(vec![*self], self.is_closed())?.to_arcs(tolerance)
    }
}

impl Lower for Circle {
    fn to_chain(&self, tolerance: f64) -> Result<(CurveChain, Exactness)> {
        ArcPath::new(self.to_arcs().to_vec(), true)?.to_chain(tolerance)
    }
    fn to_arcs(&self, tolerance: f64) -> Result<(ArcPath, Exactness)> {
        ArcPath::new(self.to_arcs().to_vec(), true)?.to_arcs(tolerance)
    }
}
