//! Circle splines: smooth curves through points whose joints are circles.
//!
//! At every node the curve touches the circle through the node and its two neighbors to the blend order `k`, so
//! joints are G^k; between two nodes it is a [`BlendSegment`] (`docs/math/circle-blends.md`; source: `004`). Points on
//! a circle, a line, a sphere or a plane give a curve on it. A segment depends on four points only.
//!
//! Circle splines commute with similarities and reversal, but not with Möbius maps
//! (`docs/math/circle-blends.md#splines`). They are not continuous in the data where neighboring circles run in
//! opposite directions or the blend changes to the long way round: those segments carry a warning.

mod build;
mod modify;

pub use build::corners_by_angle;
pub(crate) use build::{SHARP_TURN, chords_between, corner_nodes, inspect_node, rounded_directions};
pub(super) use modify::{kinks_past_start, renumbered, warnings_past_start};

use super::blend::{BlendLaw, BlendSegment, BlendVariant};
use super::param_curve::ParamCurve;
use super::piece_form::PieceForm;
use super::piece_hull::PieceHull;
use super::smooth_runs::smooth_runs;
use crate::base::bounds::Aabb;
use crate::base::jet::CurveJet;
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;
use crate::warning::Warning;
use std::ops::Range;

/// How an open circle spline (and each run between two corners) ends.
///
/// ```
/// use cyclide::{Point3, Vec3, curve::{CircleSpline, CircleSplineOptions, SplineEnds}};
/// let points = [[0.0, 0.0, 0.0], [1.0, 0.5, 0.0], [2.0, 0.0, 0.5]].map(Point3::from);
/// let ends = SplineEnds::Clamped { start: Some(Vec3::Y), end: None };
/// let spline = CircleSpline::from_points(&points, &CircleSplineOptions { ends, ..Default::default() })?;
/// assert!((spline.segments()[0].start_tangent() - Vec3::Y).length() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum SplineEnds {
    /// The end circle is the circle of the first (last) three points: the end segment is an exact arc.
    #[default]
    Natural,
    /// Given tangents, of any length but zero, in the direction of travel; `None` is a natural end.
    Clamped {
        /// Tangent at the first point.
        start: Option<Vec3>,
        /// Tangent at the last point.
        end: Option<Vec3>,
    },
}

/// How [`CircleSpline::from_points`] makes its curve.
///
/// ```
/// use cyclide::{Point3, curve::{CircleSpline, CircleSplineOptions, ParamCurve}};
/// let points = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [3.0, 3.0, 1.0], [1.0, 4.0, 1.0]].map(Point3::from);
/// let spline = CircleSpline::from_points(&points, &CircleSplineOptions { closed: true, order: 3, ..Default::default() })?;
/// assert!(spline.is_closed() && spline.piece_count() == 4);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CircleSplineOptions {
    /// Closed curve through all points; the first point is not repeated at the end.
    pub closed: bool,
    /// Blend order `k`, 1 to 4: joints are G^k. Default 2.
    pub order: u32,
    /// The angle law. Default rational: an exact rational curve.
    pub variant: BlendVariant,
    /// Ends of an open curve; without effect on a closed one, which a warning says.
    pub ends: SplineEnds,
    /// Indices of points that stay corners: the curve is cut there and each run ends naturally. The ends of an open
    /// curve may be listed without effect.
    pub corners: Vec<usize>,
}

impl Default for CircleSplineOptions {
    fn default() -> Self {
        Self {
            closed: false,
            order: 2,
            variant: BlendVariant::default(),
            ends: SplineEnds::default(),
            corners: Vec::new(),
        }
    }
}

/// A smooth curve through points, made of one blend of two circles per pair of neighbors.
///
/// Segment `i` of `n` covers `t` in `[i/n, (i+1)/n]`. With a parameter step of the chord length per segment the
/// curve is C1; its joints are G^k, except at corners and cusps, where it is only connected.
///
/// ```
/// use cyclide::{Point3, curve::{CircleSpline, CircleSplineOptions, ParamCurve}};
/// let points = [[0.0, 0.0, 0.0], [4.0, 1.0, 0.0], [5.0, 4.0, 1.0], [1.0, 3.0, 2.0]].map(Point3::from);
/// let spline = CircleSpline::from_points(&points, &CircleSplineOptions { closed: true, ..Default::default() })?;
/// assert_eq!(spline.point(0.25), points[1]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CircleSpline {
    /// Never empty; each starts where the one before ends, to the bit.
    segments: Vec<BlendSegment>,
    closed: bool,
    /// Indices of the segments at whose start the tangent jumps (corners and cusps), rising. 0 only if closed.
    kinks: Vec<usize>,
    warnings: Vec<Warning>,
}

impl CircleSpline {
    /// A spline of segments that were made elsewhere, each starting where the one before ends, to the bit; at least one.
    pub(crate) fn from_segments(
        segments: Vec<BlendSegment>,
        closed: bool,
        kinks: Vec<usize>,
        warnings: Vec<Warning>,
    ) -> Self {
        Self { segments, closed, kinks, warnings }
    }

    /// The segments, one per pair of neighboring points.
    #[must_use]
    pub fn segments(&self) -> &[BlendSegment] {
        &self.segments
    }

    /// Refuses a curve that no file can hold: a segment comes so near infinity that its points lose their digits. Documents
    /// refuse it; in Rust all that is asked of it has an answer, to the digits that are left.
    ///
    /// # Errors
    /// `arc-through-infinity`: a segment's tangents come within 5e-7 of the reversed chord.
    pub fn check_finite(&self) -> Result<()> {
        // Arcs are written as arcs, whatever their blend says.
        let mut blends = self.segments.iter().enumerate().filter(|(_, segment)| segment.to_arc().is_none());
        blends.try_for_each(|(i, segment)| segment.check_finite(i))
    }

    /// What the user should know: cusps, sharp turns, uneven spacing (by node), long ways and opposite circles (by
    /// segment).
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// The order `k` of its joints, which are G^k except at [kinks](Self::kinks): the blend order, 2 of a fair spline. (The
    /// laws of the segments: [`BlendSegment::law`].)
    #[must_use]
    pub fn order(&self) -> u32 {
        match self.segments[0].law() {
            BlendLaw::Fair { .. } => 2,
            law => law.order(),
        }
    }

    /// The nodes where the curve is only connected (corners and cusps): indices of the segments that start there.
    #[must_use]
    pub fn kinks(&self) -> &[usize] {
        &self.kinks
    }

    /// The smooth runs between kinks as ranges of segments, in order. In a closed curve with kinks the first run
    /// starts at the first kink and the last one passes the seam: indices are to be taken modulo the number of
    /// segments. Without kinks there is one run.
    #[must_use]
    pub fn smooth_runs(&self) -> Vec<Range<usize>> {
        smooth_runs(self.segments.len(), self.closed, &self.kinks)
    }
}

impl ParamCurve for CircleSpline {
    fn piece_count(&self) -> usize {
        self.segments.len()
    }
    fn piece_jet(&self, piece: usize, s: f64) -> CurveJet {
        self.segments[piece].jet(s)
    }
    fn is_closed(&self) -> bool {
        self.closed
    }
    fn piece_point(&self, piece: usize, s: f64) -> Point3 {
        self.segments[piece].point(s)
    }
    fn piece_hull(&self, piece: usize, tolerance: f64) -> Result<PieceHull> {
        self.segments[piece].hull(tolerance, piece)
    }
    fn piece_form(&self, piece: usize) -> PieceForm {
        self.segments[piece].piece_form(0)
    }
    fn piece_speed(&self, piece: usize, s: f64) -> f64 {
        self.segments[piece].speed(s)
    }
    fn piece_bounds(&self, piece: usize) -> Aabb {
        self.segments[piece].bounds()
    }
}

impl ParamCurve for BlendSegment {
    fn piece_count(&self) -> usize {
        1
    }
    fn piece_jet(&self, _piece: usize, s: f64) -> CurveJet {
        self.jet(s)
    }
    fn is_closed(&self) -> bool {
        false
    }
    fn piece_point(&self, _piece: usize, s: f64) -> Point3 {
        self.point(s)
    }
    fn piece_hull(&self, _piece: usize, tolerance: f64) -> Result<PieceHull> {
        self.hull(tolerance, 0)
    }
    /// An arc where the two circles are one.
    fn piece_form(&self, _piece: usize) -> PieceForm {
        self.to_arc().map_or(PieceForm::Free, PieceForm::Arc)
    }
    fn piece_speed(&self, _piece: usize, s: f64) -> f64 {
        self.speed(s)
    }
    fn piece_bounds(&self, _piece: usize) -> Aabb {
        self.bounds()
    }
}
