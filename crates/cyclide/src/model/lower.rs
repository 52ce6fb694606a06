//! Lowering: from an object to the carriers that exchange formats know, with the exactness that was kept.

use super::chain::CurveChain;
use crate::curve::{Arc, ArcPath, Circle, Correspondence, CurvePlace, ParamCurve, Span};
use crate::error::Result;

/// How a carrier relates to the object it stands for.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::Circle, model::{Exactness, Lower}};
/// let circle = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?;
/// assert_eq!(circle.to_chain(1e-6)?.1, Exactness::Exact);
/// assert_eq!(Exactness::Proved(1e-3).bound(), 1e-3);
/// # Ok::<(), cyclide::Error>(())
/// ```
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

/// A form of a curve, how far it is from it, and which part of the curve each of its smooth pieces stands for.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::Circle, model::Lower};
/// let lowered = Circle::from_radius(Point3::ORIGIN, Vec3::Z, 1.0)?.lower_to_arcs(1e-6)?;
/// assert_eq!(lowered.correspondence.piece_count(), lowered.form.arcs().len());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Lowered<C> {
    /// The form.
    pub form: C,
    /// How it relates to the curve.
    pub exactness: Exactness,
    /// Which parts of the curve its pieces stand for.
    pub correspondence: Correspondence,
}

/// A curve that can leave the kernel. Exporters know the two carriers only, so a new curve changes no exporter.
///
/// ```
/// use cyclide::{Point3, construct::FairSplineOptions, curve::CircleSpline, model::Lower};
/// let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0], [1.0, 4.0, 1.0]].map(Point3::from);
/// let spline = CircleSpline::fair(&points, &FairSplineOptions::default())?;
/// let (arcs, exactness) = spline.to_arcs(1e-3)?; // for machines that know arcs only
/// assert!(exactness.bound() <= 1e-3 && arcs.arcs().len() > 3);
/// # Ok::<(), cyclide::Error>(())
/// ```
pub trait Lower {
    /// As [`to_chain`](Self::to_chain), with the parts of the curve that the pieces stand for.
    ///
    /// # Errors
    /// As [`to_chain`](Self::to_chain).
    fn lower_to_chain(&self, tolerance: f64) -> Result<Lowered<CurveChain>>;

    /// As [`to_arcs`](Self::to_arcs), with the parts of the curve that the arcs stand for.
    ///
    /// # Errors
    /// As [`to_arcs`](Self::to_arcs).
    fn lower_to_arcs(&self, tolerance: f64) -> Result<Lowered<ArcPath>>;

    /// The curve as arcs and rational splines: exact where it has such a form, else within `tolerance`.
    ///
    /// # Errors
    /// `tolerance-not-positive`, `too-many-pieces`.
    fn to_chain(&self, tolerance: f64) -> Result<(CurveChain, Exactness)> {
        self.lower_to_chain(tolerance).map(|lowered| (lowered.form, lowered.exactness))
    }

    /// The curve as G1 arcs and segments only, for formats without rational splines, exact where it consists of
    /// arcs, else within `tolerance`.
    ///
    /// # Errors
    /// `tolerance-not-positive`, `too-many-pieces`.
    fn to_arcs(&self, tolerance: f64) -> Result<(ArcPath, Exactness)> {
        self.lower_to_arcs(tolerance).map(|lowered| (lowered.form, lowered.exactness))
    }
}

impl<C> Lowered<C> {
    /// A form that is the curve itself, piece for piece.
    fn exact(form: C, pieces: usize) -> Self {
        Self { form, exactness: Exactness::Exact, correspondence: Correspondence::one_to_one(pieces) }
    }
}

impl Lower for ArcPath {
    fn lower_to_chain(&self, _tolerance: f64) -> Result<Lowered<CurveChain>> {
        Ok(Lowered::exact(self.into(), self.arcs().len()))
    }
    fn lower_to_arcs(&self, _tolerance: f64) -> Result<Lowered<Self>> {
        Ok(Lowered::exact(self.clone(), self.arcs().len()))
    }
}

impl Lower for Arc {
    fn lower_to_chain(&self, tolerance: f64) -> Result<Lowered<CurveChain>> {
        ArcPath::new(vec![*self], self.is_closed())?.lower_to_chain(tolerance)
    }
    fn lower_to_arcs(&self, tolerance: f64) -> Result<Lowered<ArcPath>> {
        ArcPath::new(vec![*self], self.is_closed())?.lower_to_arcs(tolerance)
    }
}

impl Lower for Circle {
    fn lower_to_chain(&self, _tolerance: f64) -> Result<Lowered<CurveChain>> {
        let halves = ArcPath::new(self.to_arcs().to_vec(), true)?;
        Ok(Lowered { form: halves.into(), exactness: Exactness::Exact, correspondence: of_halves() })
    }
    fn lower_to_arcs(&self, _tolerance: f64) -> Result<Lowered<ArcPath>> {
        let halves = ArcPath::new(self.to_arcs().to_vec(), true)?;
        Ok(Lowered { form: halves, exactness: Exactness::Exact, correspondence: of_halves() })
    }
}

/// A full circle, one piece, as two half turns.
fn of_halves() -> Correspondence {
    let half = |s| Span { pieces: 1, end: CurvePlace::new(0, s) };
    Correspondence::from_start(vec![half(0.5), half(1.0)])
}
