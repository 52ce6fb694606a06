//! Curves on a torus made of quartic pieces: what they hold, and how they are put together.

use super::Torus;
use super::piece::TorusPiece;
use crate::base::frame::Frame;
use crate::base::jet::CurveJet;
use crate::base::planar::{Point2, Vec2};
use crate::base::vector::Point3;
use crate::curve::ParamCurve as _;
use std::f64::consts::PI;
use std::ops::Range;

/// How a segment between two points was joined.
///
/// ```
/// use cyclide::{Frame, Point2, construct::TorusSplineOptions, surface::{SegmentMethod, Torus, TorusSpline}};
/// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
/// let places = [Point2::new(0.0, 0.0), Point2::new(0.5, 0.3)];
/// let spline = TorusSpline::through_places(&torus, &places, &TorusSplineOptions::default())?;
/// assert_eq!(spline.segments()[0].method, SegmentMethod::Direct);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SegmentMethod {
    /// By two pieces of one type.
    Direct,
    /// Cut in halves along the cubic through its data until each part had a type.
    Halved,
    /// By a way of arcs and lines in the plane of the torus, as its data turn back or aside.
    Detour,
    /// By two pieces of two types.
    TwoTypes,
}

/// One segment of a spline, from one given point to the next.
///
/// ```
/// use cyclide::{Frame, surface::{Torus, TorusSpline}};
/// let trefoil = TorusSpline::knot(&Torus::new(Frame::WORLD, 3.0, 1.0)?, [2, 3], Default::default())?;
/// assert!(trefoil.segments().iter().all(|segment| segment.pieces.len() == 1 && segment.quality > 0.25));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TorusSegment {
    /// Its pieces.
    pub pieces: Range<usize>,
    /// How it was joined.
    pub method: SegmentMethod,
    /// The smallest part of the speed that a running coordinate has at an end of a span or on average over it: near 0 the curve
    /// comes nearly to a stop, 1 is an arc of a circle at constant speed.
    pub quality: f64,
}

/// A curve on a torus, parametrically C1, made of rational quartics that lie exactly on it.
///
/// As a [`ParamCurve`](crate::curve::ParamCurve) its pieces are the quartics, each over an equal part of `[0, 1]`. The parameter in which the
/// curve is C1 is that of its [`knots`](Self::knots): [`jet_at_knot`](Self::jet_at_knot).
///
/// ```
/// use cyclide::{Frame, Point3, construct::TorusSplineOptions, curve::ParamCurve, surface::{Torus, TorusSpline}};
/// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
/// let seam = [[4.0, 0.0, 0.0], [0.0, 3.0, 1.0], [-2.0, 0.0, 0.0], [0.0, -3.0, -1.0]].map(Point3::from);
/// let options = TorusSplineOptions { closed: true, ..Default::default() };
/// let spline = TorusSpline::through_points(&torus, &seam, 1e-9, &options)?;
/// assert!(spline.is_closed() && spline.winding() == Some([1, 1]));
/// let nurbs = spline.to_nurbs()?; // exact, positive weights
/// assert!(nurbs.point_at_knot(0.3).distance(spline.jet_at_knot(0.3 * 4.0).point) < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TorusSpline {
    pub(super) torus: Torus,
    pub(super) pieces: Vec<TorusPiece>,
    /// One more than pieces, increasing.
    pub(super) knots: Vec<f64>,
    /// Points at the knots; of a closed curve the last is the first.
    pub(super) joints: Vec<Point3>,
    /// Places at the knots without leaps.
    pub(super) unrolled: Vec<Point2>,
    pub(super) closed: bool,
    pub(super) segments: Vec<TorusSegment>,
}

/// A spline that is being put together, piece by piece.
#[derive(Debug)]
pub(crate) struct TorusChain {
    pieces: Vec<TorusPiece>,
    knots: Vec<f64>,
    segments: Vec<TorusSegment>,
}

impl TorusChain {
    pub(crate) fn starting_at(knot: f64) -> Self {
        Self { pieces: Vec::new(), knots: vec![knot], segments: Vec::new() }
    }

    /// Adds a piece that ends at a knot.
    pub(crate) fn push(&mut self, piece: TorusPiece, knot: f64) {
        self.pieces.push(piece);
        self.knots.push(knot);
    }

    /// Ends a segment with all pieces since the last one.
    pub(crate) fn end_segment(&mut self, method: SegmentMethod, quality: f64) {
        let start = self.segments.last().map_or(0, |segment| segment.pieces.end);
        self.segments.push(TorusSegment { pieces: start..self.pieces.len(), method, quality });
    }

    /// The spline; `end` is the given place at the end of an open one.
    pub(crate) fn into_spline(self, torus: &Torus, closed: bool, end: Point2) -> TorusSpline {
        let mut joints: Vec<Point3> = self.pieces.iter().map(|piece| torus.point(piece.start())).collect();
        let first = joints.first().copied();
        joints.push(first.filter(|_| closed).unwrap_or_else(|| torus.point(end)));
        let mut unrolled = vec![self.pieces.first().map_or(end, TorusPiece::start)];
        for (i, piece) in self.pieces.iter().enumerate() {
            unrolled.push(unrolled[i] + piece.step());
        }
        let Self { pieces, knots, segments } = self;
        TorusSpline { torus: *torus, pieces, knots, joints, unrolled, closed, segments }
    }
}

impl TorusSpline {
    /// The torus.
    #[must_use]
    pub fn torus(&self) -> &Torus {
        &self.torus
    }

    /// The quartic pieces in order.
    #[must_use]
    pub fn pieces(&self) -> &[TorusPiece] {
        &self.pieces
    }

    /// The parameters at which pieces meet, one more than pieces, increasing: those given for the points, or 0, 1, 2, ..., and
    /// those between.
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The segments between the given points, with the pieces of each and how it was joined.
    #[must_use]
    pub fn segments(&self) -> &[TorusSegment] {
        &self.segments
    }

    /// Half turns of the two angles round a closed curve, `[n, m]`: it runs `n` times round the axis and `m` times round the tube.
    /// `None` if it is open.
    #[must_use]
    pub fn winding(&self) -> Option<[i64; 2]> {
        let (first, last) = (self.unrolled.first()?, self.unrolled.last()?);
        let turns = *last - *first;
        self.closed.then(|| [turns.x, turns.y].map(|x| (x / PI).round() as i64))
    }

    /// The piece and its own parameter at a knot-domain parameter (clamped); at a knot the piece that starts there.
    #[must_use]
    pub fn locate_knot(&self, u: f64) -> (usize, f64) {
        let last = self.pieces.len() - 1;
        let u = u.clamp(self.knots[0], self.knots[last + 1]);
        let piece = self.knots.partition_point(|k| *k <= u).saturating_sub(1).min(last);
        let (a, b) = (self.knots[piece], self.knots[piece + 1]);
        (piece, (u - a) / (b - a))
    }

    /// Point and derivatives at a knot-domain parameter (clamped), derivatives by it. The first one is continuous.
    #[must_use]
    pub fn jet_at_knot(&self, u: f64) -> CurveJet {
        let (piece, s) = self.locate_knot(u);
        self.piece_jet(piece, s).scaled(1.0 / (self.knots[piece + 1] - self.knots[piece]))
    }

    /// The place at a piece and its own parameter in the unrolled plane of the torus: it runs on without leaps, half turns counted,
    /// from the first place.
    ///
    /// # Panics
    /// If there is no such piece.
    #[must_use]
    pub fn unrolled_place(&self, piece: usize, s: f64) -> Point2 {
        self.unrolled[piece] + self.pieces[piece].moved(s)
    }

    /// The speed of the place by the knot-domain parameter, at a piece and its own parameter.
    ///
    /// # Panics
    /// If there is no such piece.
    #[must_use]
    pub fn unrolled_rate(&self, piece: usize, s: f64) -> Vec2 {
        self.pieces[piece].rate(s) * (1.0 / (self.knots[piece + 1] - self.knots[piece]))
    }

    /// The frame along the seam at a parameter in `[0, 1]` of the curve: origin on the curve, first axis along it, third axis the
    /// outward normal of the torus. `None` where rounding leaves no direction.
    ///
    /// ```
    /// use cyclide::{Frame, surface::{Torus, TorusSpline}};
    /// let knot = TorusSpline::knot(&Torus::new(Frame::WORLD, 3.0, 1.0)?, [2, 3], Default::default())?;
    /// let frame = knot.seam_frame(0.2).expect("it moves");
    /// assert!((knot.torus().locate(frame.origin() + frame.z() * 0.5, 0.51)? - knot.torus().locate(frame.origin(), 1e-9)?).length() < 1e-14);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn seam_frame(&self, t: f64) -> Option<Frame> {
        let (piece, s) = self.locate(t);
        let (jet, at) = (self.piece_jet(piece, s), self.pieces[piece].unit_pair(s));
        let tangent = jet.tangent()?;
        Frame::from_normal(jet.point, self.torus.normal_at(&at), tangent).ok()
    }
}
