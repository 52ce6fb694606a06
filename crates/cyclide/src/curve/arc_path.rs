//! A connected chain of arcs and segments: arc splines, biarcs, fitted contours.

use super::arc::Arc;
use super::arc::measure::ClosestPoint;
use super::measure;
use super::param_curve::ParamCurve;
use super::piece_form::PieceForm;
use super::piece_hull::PieceHull;
use crate::base::bounds::Aabb;
use crate::base::cut::{check_past_start, interval, place_of_cut};
use crate::base::jet::CurveJet;
use crate::base::vector::Point3;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::{CurveError, Error, PointError, Result};

/// Arcs and straight segments joined end to end; piece `i` of `n` covers `t` in `[i/n, (i+1)/n]`.
///
/// Consecutive ends are the *same* doubles, and the last end is the first start when the path is closed: readers
/// treat any gap as open.
///
/// ```
/// use cyclide::{Point3, curve::ArcPath};
/// let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0]].map(Point3::from);
/// let path = ArcPath::rounded_polyline(&corner, false, &[0.0, 1.0, 0.0])?;
/// assert!((path.length() - (6.0 + std::f64::consts::FRAC_PI_2)).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ArcPath {
    arcs: Vec<Arc>,
    closed: bool,
}

impl ArcPath {
    /// Path from arcs that meet: the start of each must equal the end of the one before, to the bit.
    ///
    /// # Errors
    /// `too-few-points` (no arc), `disconnected`.
    pub fn new(arcs: Vec<Arc>, closed: bool) -> Result<Self> {
        if arcs.is_empty() {
            return Err(PointError::TooFewPoints { given: 0, needed: 1 }.into());
        }
        let joint = |piece: usize, next: usize| {
            let (a, b) = (arcs[piece].end(), arcs[next].start());
            if a == b {
                Ok(())
            } else {
                Err(Error::Curve(CurveError::Disconnected { piece, next, gap: a.distance(b), limit: 0.0 }))
            }
        };
        for i in 1..arcs.len() {
            joint(i - 1, i)?;
        }
        if closed {
            joint(arcs.len() - 1, 0)?;
        }
        Ok(Self { arcs, closed })
    }

    /// Path from arcs that share their end points by construction (at least one).
    pub(crate) fn from_joined(arcs: Vec<Arc>, closed: bool) -> Self {
        debug_assert!(Self::new(arcs.clone(), closed).is_ok(), "arcs do not share their ends");
        Self { arcs, closed }
    }

    /// The arcs.
    #[must_use]
    pub fn arcs(&self) -> &[Arc] {
        &self.arcs
    }

    /// Total length.
    #[must_use]
    pub fn length(&self) -> f64 {
        measure::length(self)
    }

    /// The smallest box around the path.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        measure::bounds(self)
    }

    /// The point of the path nearest to `p`, exact per arc; the first of equals.
    #[must_use]
    pub fn closest_point(&self, p: Point3) -> ClosestPoint {
        measure::closest_point(self, p)
    }

    /// The part between two global parameters, `0 <= t0 < t1 <= 1`, as an open path; the arcs that are cut keep
    /// their shape. Parameters within rounding of a joint cut there.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn restricted(&self, t0: f64, t1: f64) -> Result<Self> {
        let [t0, t1] = interval(t0, t1)?;
        let n = self.arcs.len();
        let (first, s0) = if t0 > 0.0 { place_of_cut(t0, n)? } else { (0, 0.0) };
        let (end, s1) = if t1 < 1.0 { place_of_cut(t1, n)? } else { (n, 0.0) };
        let mut arcs = self.arcs[first..end].to_vec();
        if s1 > 0.0 {
            arcs.push(self.arcs[end].split(s1)?.0);
        }
        if let Some(arc) = arcs.first_mut().filter(|_| s0 > 0.0) {
            // Within one arc, s0 is the fraction s0/s1 of what is left of it.
            let inside = if first == end { s0 / s1 } else { s0 };
            *arc = arc.split(inside)?.1.with_start(self.arcs[first].point(s0));
        }
        Self::new(arcs, false)
    }

    /// The part of a closed path from a global parameter past its start to a smaller one, `0 < t1 < t0 < 1`, as an open path.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn restricted_past_start(&self, t0: f64, t1: f64) -> Result<Self> {
        check_past_start(self.closed, t0, t1)?;
        let (mut before, after) = (self.restricted(t0, 1.0)?, self.restricted(0.0, t1)?);
        before.arcs.extend(after.arcs);
        Ok(before)
    }

    /// The two parts before and after a global parameter in `(0, 1)`, as open paths that meet in the same doubles.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn split(&self, t: f64) -> Result<(Self, Self)> {
        Ok((self.restricted(0.0, t)?, self.restricted(t, 1.0)?))
    }

    /// The same points run backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { arcs: self.arcs.iter().rev().map(Arc::reversed).collect(), closed: self.closed }
    }
}

impl Conformal for ArcPath {
    /// The image under a Möbius map, arc by arc with the same parameters.
    ///
    /// # Errors
    /// As [`Arc::transformed`], wrapped with the index of the arc.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let arcs = self.arcs.iter().enumerate().map(|(i, a)| a.transformed(map).map_err(|e| e.in_span(i)));
        // Joints map to the same bits: both sides apply the same operations to the same point with weight 1, or
        // with a weight that cancels up to rounding. Tie them.
        let mut arcs = arcs.collect::<Result<Vec<_>>>()?;
        for i in 1..arcs.len() {
            arcs[i] = arcs[i].with_start(arcs[i - 1].end());
        }
        if self.closed {
            let end = arcs[0].start();
            if let Some(last) = arcs.last_mut() {
                *last = last.with_end(end);
            }
        }
        Self::new(arcs, self.closed)
    }
}

impl ParamCurve for ArcPath {
    fn piece_count(&self) -> usize {
        self.arcs.len()
    }
    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
        self.arcs[piece].piece_jet(0, s)
    }
    fn is_closed(&self) -> bool {
        self.closed
    }
    fn piece_point(&self, piece: usize, s: f64) -> Point3 {
        self.arcs[piece].point(s)
    }
    fn piece_speed(&self, piece: usize, s: f64) -> f64 {
        self.arcs[piece].piece_speed(0, s)
    }
    fn piece_hull(&self, _piece: usize, _tolerance: f64) -> Result<PieceHull> {
        Ok(PieceHull::closed_form())
    }
    fn piece_form(&self, piece: usize) -> PieceForm {
        PieceForm::Arc(self.arcs[piece])
    }
    fn piece_length(&self, piece: usize, s0: f64, s1: f64) -> f64 {
        self.arcs[piece].piece_length(0, s0, s1)
    }
    fn piece_bounds(&self, piece: usize) -> Aabb {
        self.arcs[piece].bounds()
    }
}
