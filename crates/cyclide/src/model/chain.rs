//! The curve carrier: a connected chain of arcs, segments and rational splines.

use crate::base::bounds::Aabb;
use crate::base::cut::place_of_cut;
use crate::base::jet::CurveJet;
use crate::base::vector::Point3;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::curve::{Arc, ArcPath, ParamCurve, PieceForm, PieceHull};
use crate::error::{CurveError, PointError, Result};
use crate::rational::NurbsCurve;

/// One piece of a chain.
///
/// ```
/// use cyclide::{Point3, curve::Arc, model::ChainPiece};
/// let piece = ChainPiece::Arc(Arc::segment(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0))?);
/// assert_eq!(piece.reversed().start(), piece.end());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum ChainPiece {
    /// A circular arc or straight segment.
    Arc(Arc),
    /// A smooth rational B-spline.
    Spline(NurbsCurve),
}

impl ChainPiece {
    /// Start point.
    #[must_use]
    pub fn start(&self) -> Point3 {
        match self {
            Self::Arc(a) => a.start(),
            Self::Spline(c) => c.control_points()[0],
        }
    }

    /// End point.
    #[must_use]
    pub fn end(&self) -> Point3 {
        match self {
            Self::Arc(a) => a.end(),
            Self::Spline(c) => c.control_points()[c.control_points().len() - 1],
        }
    }

    /// The same points run backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        match self {
            Self::Arc(a) => Self::Arc(a.reversed()),
            Self::Spline(c) => Self::Spline(c.reversed()),
        }
    }

    /// The image under a similarity or a reflection.
    ///
    /// # Errors
    /// `not-a-similarity`, or as [`Arc::transformed`](crate::conformal::Conformal::transformed) and [`NurbsCurve::similar`].
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        match self {
            Self::Arc(a) => {
                map.check_similarity()?;
                Ok(Self::Arc(a.transformed(map)?))
            }
            Self::Spline(c) => Ok(Self::Spline(c.similar(map)?)),
        }
    }

    /// The two parts before and after a parameter of the piece in `(0, 1)`.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn split(&self, t: f64) -> Result<(Self, Self)> {
        Ok(match self {
            Self::Arc(a) => a.split(t).map(|(l, r)| (Self::Arc(l), Self::Arc(r)))?,
            Self::Spline(c) => c.split(t).map(|(l, r)| (Self::Spline(l), Self::Spline(r)))?,
        })
    }

    /// The piece as a curve.
    #[must_use]
    pub fn as_curve(&self) -> &dyn ParamCurve {
        match self {
            Self::Arc(a) => a,
            Self::Spline(c) => c,
        }
    }
}

/// A connected curve of arcs and rational splines, the form that exchange files carry. As a [`ParamCurve`] it has
/// one piece per arc and per knot span.
///
/// ```
/// use cyclide::{Point3, construct::FairSplineOptions, curve::CircleSpline, model::Lower};
/// let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0], [1.0, 4.0, 1.0]].map(Point3::from);
/// let (chain, _) = CircleSpline::fair(&points, &FairSplineOptions::default())?.to_chain(1e-6)?;
/// assert!(chain.weight_range().0 > 0.0 && !chain.pieces().is_empty());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CurveChain {
    pieces: Vec<ChainPiece>,
    closed: bool,
    /// Number of smooth pieces.
    count: usize,
    /// How many of them come before each chain piece; nothing where each chain piece is one, as in polylines, whose
    /// memory counts.
    starts: Vec<usize>,
}

impl CurveChain {
    /// Chain from pieces that meet: each starts within `gap_limit` of where the last one ended, and the end meets
    /// the start if closed. Kernel-made chains meet to the bit; files read back may carry rounding.
    ///
    /// # Errors
    /// `too-few-points` (no piece), `disconnected`.
    pub fn new(pieces: Vec<ChainPiece>, closed: bool, gap_limit: f64) -> Result<Self> {
        let n = pieces.len();
        if n == 0 {
            return Err(PointError::TooFewPoints { given: 0, needed: 1 }.into());
        }
        for next in usize::from(!closed)..n {
            let piece = (next + n - 1) % n;
            let gap = pieces[piece].end().distance(pieces[next].start());
            if gap > gap_limit {
                return Err(CurveError::Disconnected { piece, next, gap, limit: gap_limit }.into());
            }
        }
        Ok(Self::from_joined(pieces, closed))
    }

    /// Chain of pieces that are known to meet.
    fn from_joined(pieces: Vec<ChainPiece>, closed: bool) -> Self {
        let counts = || pieces.iter().map(|piece| piece.as_curve().piece_count());
        let count = counts().sum();
        let starts = counts().scan(0, |next, own| {
            *next += own;
            Some(*next - own)
        });
        let starts = if count == pieces.len() { Vec::new() } else { starts.collect() };
        Self { pieces, closed, count, starts }
    }

    /// The chain piece that a smooth piece belongs to, and which of its own pieces it is.
    fn place(&self, piece: usize) -> (usize, usize) {
        if self.starts.is_empty() {
            return (piece, 0);
        }
        let i = self.starts.partition_point(|start| *start <= piece) - 1;
        (i, piece - self.starts[i])
    }

    /// The same points run backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self::from_joined(self.pieces.iter().rev().map(ChainPiece::reversed).collect(), self.closed)
    }

    /// The image under a similarity or a reflection. Gaps between the pieces, if any, are scaled along.
    ///
    /// # Errors
    /// As [`ChainPiece::similar`], wrapped with the piece.
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        let pieces = self.pieces.iter().enumerate().map(|(i, p)| p.similar(map).map_err(|e| e.in_span(i)));
        Ok(Self::from_joined(pieces.collect::<Result<_>>()?, self.closed))
    }

    /// The two parts before and after a global parameter in `(0, 1)`, as open chains; exact.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn split(&self, t: f64) -> Result<(Self, Self)> {
        let (smooth, s) = place_of_cut(t, self.count)?;
        let (piece, own) = self.place(smooth);
        let (mut left, mut right) = (self.pieces[..piece].to_vec(), self.pieces[piece..].to_vec());
        if own > 0 || s > 0.0 {
            let cut = &self.pieces[piece];
            let (l, r) = cut.split((own as f64 + s) / cut.as_curve().piece_count() as f64)?;
            left.push(l);
            right[0] = r;
        }
        Ok((Self::from_joined(left, false), Self::from_joined(right, false)))
    }

    /// The pieces by themselves.
    #[must_use]
    pub fn into_pieces(self) -> Vec<ChainPiece> {
        self.pieces
    }

    /// The pieces.
    #[must_use]
    pub fn pieces(&self) -> &[ChainPiece] {
        &self.pieces
    }

    /// Smallest and largest weight of the rational splines (1 for arcs and segments as such).
    #[must_use]
    pub fn weight_range(&self) -> (f64, f64) {
        let weights = self.pieces.iter().flat_map(|p| match p {
            ChainPiece::Arc(_) => [1.0].to_vec(),
            ChainPiece::Spline(c) => c.weights().to_vec(),
        });
        weights.fold((f64::INFINITY, 0.0), |(lo, hi), w| (lo.min(w), hi.max(w)))
    }
}

impl From<ArcPath> for CurveChain {
    fn from(path: ArcPath) -> Self {
        Self::from(&path)
    }
}

impl From<&ArcPath> for CurveChain {
    fn from(path: &ArcPath) -> Self {
        Self::from_joined(path.arcs().iter().copied().map(ChainPiece::Arc).collect(), path.is_closed())
    }
}

impl ParamCurve for CurveChain {
    fn piece_count(&self) -> usize {
        self.count
    }
    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
        let (i, j) = self.place(piece);
        self.pieces[i].as_curve().piece_jet(j, s)
    }
    fn is_closed(&self) -> bool {
        self.closed
    }
    fn piece_point(&self, piece: usize, s: f64) -> Point3 {
        let (i, j) = self.place(piece);
        self.pieces[i].as_curve().piece_point(j, s)
    }
    fn piece_speed(&self, piece: usize, s: f64) -> f64 {
        let (i, j) = self.place(piece);
        self.pieces[i].as_curve().piece_speed(j, s)
    }
    fn piece_hull(&self, piece: usize, tolerance: f64) -> Result<PieceHull> {
        let (i, j) = self.place(piece);
        self.pieces[i].as_curve().piece_hull(j, tolerance)
    }
    fn piece_form(&self, piece: usize) -> PieceForm {
        let (i, j) = self.place(piece);
        self.pieces[i].as_curve().piece_form(j)
    }
    fn piece_length(&self, piece: usize, s0: f64, s1: f64) -> f64 {
        let (i, j) = self.place(piece);
        self.pieces[i].as_curve().piece_length(j, s0, s1)
    }
    fn piece_bounds(&self, piece: usize) -> Aabb {
        let (i, j) = self.place(piece);
        self.pieces[i].as_curve().piece_bounds(j)
    }
}
