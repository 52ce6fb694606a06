//! The curves that edges run along.

use crate::base::bounds::Aabb;
use crate::base::jet::CurveJet;
use crate::base::vector::Point3;
use crate::conformal::mobius::{Conformal as _, Mobius};
use crate::curve::{Arc, ParamCurve, PieceForm, PieceHull};
use crate::error::Result;
use crate::rational::RationalBezier;

/// The curve of an edge or of a parameter line of a face, over `[0, 1]`. As a [`ParamCurve`] it is one piece.
///
/// ```
/// use cyclide::{Point3, curve::Arc, topology::EdgeCurve};
/// let edge = EdgeCurve::from(Arc::segment(Point3::ORIGIN, Point3::new(2.0, 0.0, 0.0))?);
/// assert_eq!((edge.length(), edge.reversed().start()), (2.0, edge.end()));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum EdgeCurve {
    /// A circular arc or straight segment.
    Arc(Arc),
    /// A rational Bézier curve with positive weights.
    Rational(RationalBezier),
}

impl EdgeCurve {
    /// Start point.
    #[must_use]
    pub fn start(&self) -> Point3 {
        match self {
            Self::Arc(arc) => arc.start(),
            Self::Rational(curve) => curve.point(0.0),
        }
    }

    /// End point.
    #[must_use]
    pub fn end(&self) -> Point3 {
        match self {
            Self::Arc(arc) => arc.end(),
            Self::Rational(curve) => curve.point(1.0),
        }
    }

    /// The point at a parameter in `[0, 1]`.
    #[must_use]
    pub fn point(&self, x: f64) -> Point3 {
        match self {
            Self::Arc(arc) => arc.point(x),
            Self::Rational(curve) => curve.point(x),
        }
    }

    /// Arc length.
    #[must_use]
    pub fn length(&self) -> f64 {
        match self {
            Self::Arc(arc) => arc.length(),
            Self::Rational(curve) => curve.piece_length(0, 0.0, 1.0),
        }
    }

    /// The arc, if it is one.
    #[must_use]
    pub fn arc(&self) -> Option<&Arc> {
        match self {
            Self::Arc(arc) => Some(arc),
            Self::Rational(_) => None,
        }
    }

    /// The same points run backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        match self {
            Self::Arc(arc) => Self::Arc(arc.reversed()),
            Self::Rational(curve) => Self::Rational(curve.reversed()),
        }
    }

    /// The parts before and after a parameter in `(0, 1)`, exact.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn split(&self, x: f64) -> Result<(Self, Self)> {
        Ok(match self {
            Self::Arc(arc) => arc.split(x).map(|(l, r)| (Self::Arc(l), Self::Arc(r)))?,
            Self::Rational(curve) => curve.split(x).map(|(l, r)| (Self::Rational(l), Self::Rational(r)))?,
        })
    }

    /// The image with ends that are known better than by the map: the vertices. Rational curves have images under
    /// similarities and reflections only.
    ///
    /// # Errors
    /// As `transformed` of arcs; `not-a-similarity`, `not-finite`.
    pub(crate) fn image(&self, map: &Mobius, start: Point3, end: Point3) -> Result<Self> {
        Ok(match self {
            Self::Arc(arc) => Self::Arc(Arc::from_ratio_across(start, end, arc.transformed(map)?.weight_ratio())?),
            Self::Rational(curve) => Self::Rational(curve.similar(map)?).with_ends(Some(start), Some(end)),
        })
    }

    /// The curve with ends moved by rounding.
    pub(crate) fn with_ends(self, start: Option<Point3>, end: Option<Point3>) -> Self {
        match self {
            Self::Arc(mut arc) => {
                arc = start.map_or(arc, |p| arc.with_start(p));
                Self::Arc(end.map_or(arc, |p| arc.with_end(p)))
            }
            Self::Rational(curve) => Self::Rational(curve.with_ends(start, end)),
        }
    }

    /// The homogeneous rows of its exact rational form, with the same parameter.
    pub(crate) fn bezier_rows(&self) -> Vec<[f64; 4]> {
        match self {
            Self::Arc(arc) => arc.bezier_rows().to_vec(),
            Self::Rational(curve) => curve.rows().to_vec(),
        }
    }

    /// The curve behind the name.
    #[must_use]
    pub fn as_curve(&self) -> &dyn ParamCurve {
        match self {
            Self::Arc(arc) => arc,
            Self::Rational(curve) => curve,
        }
    }
}

impl From<Arc> for EdgeCurve {
    fn from(arc: Arc) -> Self {
        Self::Arc(arc)
    }
}

impl From<RationalBezier> for EdgeCurve {
    fn from(curve: RationalBezier) -> Self {
        Self::Rational(curve)
    }
}

impl ParamCurve for EdgeCurve {
    fn piece_count(&self) -> usize {
        1
    }
    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
        self.as_curve().piece_jet(piece, s)
    }
    fn piece_hull(&self, piece: usize, tolerance: f64) -> Result<PieceHull> {
        self.as_curve().piece_hull(piece, tolerance)
    }
    fn is_closed(&self) -> bool {
        self.as_curve().is_closed()
    }
    fn piece_point(&self, _piece: usize, s: f64) -> Point3 {
        self.point(s)
    }
    fn piece_form(&self, piece: usize) -> PieceForm {
        self.as_curve().piece_form(piece)
    }
    fn piece_length(&self, piece: usize, s0: f64, s1: f64) -> f64 {
        self.as_curve().piece_length(piece, s0, s1)
    }
    fn piece_bounds(&self, piece: usize) -> Aabb {
        self.as_curve().piece_bounds(piece)
    }
}
