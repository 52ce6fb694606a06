//! What the user can ask of an arc fit.

use super::beam::BeamSize;
use super::piece::Piece;
use crate::curve::Arc;
use crate::error::{ErrorItem, NumberError, Result, check_tolerance};
use std::f64::consts::PI;

/// What the points are; never mixed silently.
///
/// The straight edges between samples differ from the curve by their sagitta besides. That every point of every edge is within the
/// tolerance, and every point of the arcs, is the Fréchet distance of both.
///
/// ```
/// use cyclide::{Point3, construct::{ArcFit, ArcFitOptions, FitTarget}};
/// let corner = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.2, 0.0]].map(Point3::from);
/// let options = ArcFitOptions { target: FitTarget::Polyline, ..ArcFitOptions::new(0.1) };
/// assert!(ArcFit::new(&corner, &options)?.certificate().polyline_deviation <= 0.1);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "Target", description = "What the points of an arc fit represent.")
)]
pub enum FitTarget {
    /// The points are samples of a smooth curve, the corners and straight sides of an outline, or both. Points are
    /// within the tolerance of the arcs; so are edges that no smooth curve through such samples explains, and the arcs
    /// along such edges are within the tolerance of them.
    #[default]
    Points,
    /// The edges between the points are the target: every point of every edge is within the tolerance, and so is every
    /// point of the arcs. Rejected, with the location, if no smooth chain of arcs exists.
    Polyline,
}

/// How long to search for fewer arcs.
///
/// The quick search takes about a quarter of the time of the usual one on closed curves, two thirds on open ones, for at most 15 % more
/// arcs on every curve of our set, 2 % on average. The slow one takes three to eight times the time for up to 6 % fewer arcs, and
/// never more: the others are tried beside it.
///
/// ```
/// use cyclide::{Point3, construct::{ArcFit, ArcFitOptions, Effort}};
/// let wave: Vec<Point3> = (0..60).map(|k| 0.1 * f64::from(k)).map(|x| Point3::new(x, x.sin(), 0.0)).collect();
/// let arcs = |effort| ArcFit::new(&wave, &ArcFitOptions { effort, ..ArcFitOptions::new(0.01) }).map(|fit| fit.path().arcs().len());
/// assert!(arcs(Effort::Best)? <= arcs(Effort::Fast)?);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(rename = "Effort", description = "How hard an arc fit searches.")
)]
pub enum Effort {
    /// Quick; a few per cent more arcs.
    Fast,
    /// The usual search.
    #[default]
    Default,
    /// Slow; sometimes fewer arcs.
    Best,
}

impl Effort {
    /// Those below it that are tried beside it: more states of a beam need not end in fewer arcs.
    pub(super) fn beside(self) -> &'static [Self] {
        match self {
            Self::Best => &[Self::Default, Self::Fast],
            Self::Default | Self::Fast => &[],
        }
    }

    /// This effort and those above it, in rising order.
    pub(super) fn and_above(self) -> &'static [Self] {
        match self {
            Self::Fast => &[Self::Fast, Self::Default, Self::Best],
            Self::Default => &[Self::Default, Self::Best],
            Self::Best => &[Self::Best],
        }
    }

    /// Samples and cells of the planar beam (`docs/math/arc-fitting.md#tube-beam`). Fast saves seams rather than cells:
    /// with 60 cells the count was up to twice that of the default.
    pub(super) fn beam(self) -> BeamSize {
        match self {
            Self::Fast => BeamSize { samples: 4, cells: 200 },
            Self::Default => BeamSize { samples: 5, cells: 300 },
            Self::Best => BeamSize { samples: 7, cells: 1500 },
        }
    }

    /// Places for joints tried first on each edge between coarse samples.
    pub(super) fn extra_points(self) -> usize {
        match self {
            Self::Fast | Self::Default => 1,
            Self::Best => 2,
        }
    }

    /// Where along an open run of a closed curve seams are tried.
    pub(super) fn seams(self) -> &'static [f64] {
        match self {
            Self::Fast => &[5.0 / 6.0],
            Self::Default | Self::Best => &[1.0 / 6.0, 0.5, 5.0 / 6.0],
        }
    }

    /// States kept by the beam of biarcs in space (`docs/math/arc-fitting.md#space`).
    pub(super) fn space_states(self) -> usize {
        match self {
            Self::Fast => 2,
            Self::Default => 5,
            Self::Best => 10,
        }
    }
}

/// Options of [`ArcFit::new`](super::ArcFit::new).
///
/// ```
/// use cyclide::construct::ArcFitOptions;
/// let options = ArcFitOptions { closed: true, ..ArcFitOptions::new(0.01) };
/// assert!(options.tolerance == 0.01 && options.corners.is_empty());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ArcFitOptions {
    /// The last point joins the first.
    pub closed: bool,
    /// Largest distance of the curve from the target, in the unit of the points; positive.
    pub tolerance: f64,
    /// What the points represent.
    pub target: FitTarget,
    /// How long to search.
    pub effort: Effort,
    /// Turns above this angle (radians, in `(0, pi]`) are corners and no others are, but for reversals; `pi`: only those.
    /// `None`: turns above 30 degrees, of samples where no smooth curve explains them
    /// (`docs/math/arc-fitting.md#outlines`), of a polyline where they stand out.
    pub corner_angle: Option<f64>,
    /// Indices of points that are corners in any case.
    pub corners: Vec<usize>,
    /// Least radius of an arc, in the unit of the points; positive. `None`: any.
    pub min_radius: Option<f64>,
    /// Least length of an arc, in the unit of the points; positive. `None`: any. Straight segments may be shorter.
    pub min_arc_length: Option<f64>,
}

/// What the arcs of a fit keep to.
#[derive(Debug, Clone, Copy)]
pub(super) struct ArcLimits {
    /// Largest curvature.
    pub curvature: f64,
    /// Least length.
    pub length: f64,
}

impl ArcLimits {
    /// Whether the arc keeps them; lines do.
    pub fn allow(&self, arc: &Arc) -> bool {
        arc.is_straight() || (arc.curvature() <= self.curvature && arc.length() >= self.length)
    }
}

impl ArcFitOptions {
    /// Open, target points, default effort, corners above 30 degrees where the points say so.
    #[must_use]
    pub fn new(tolerance: f64) -> Self {
        Self {
            closed: false,
            tolerance,
            target: FitTarget::default(),
            effort: Effort::default(),
            corner_angle: None,
            corners: Vec::new(),
            min_radius: None,
            min_arc_length: None,
        }
    }

    /// Whether all arcs keep the limits.
    pub(super) fn limits_kept(&self, pieces: &[Piece]) -> bool {
        pieces.iter().all(|piece| self.limits().allow(&piece.arc))
    }

    /// The limits of the machine.
    pub(super) fn limits(&self) -> ArcLimits {
        let curvature = self.min_radius.map_or(f64::INFINITY, |radius| 1.0 / radius);
        ArcLimits { curvature, length: self.min_arc_length.unwrap_or(0.0) }
    }

    /// # Errors
    /// `tolerance-not-positive`, `not-finite`, `parameter-out-of-range` (corner angle, limits of arcs, corner index).
    pub(super) fn check(&self, points: usize) -> Result<()> {
        check_tolerance(self.tolerance)?;
        if let Some(value) = self.corner_angle
            && !(value > 0.0 && value <= PI)
        {
            return Err(
                NumberError::ParameterOutOfRange { name: ErrorItem::CornerAngle, value, min: 0.0, max: PI }.into()
            );
        }
        let limits = [(ErrorItem::MinRadius, self.min_radius), (ErrorItem::MinArcLength, self.min_arc_length)];
        for (name, value) in limits.into_iter().filter_map(|(name, value)| Some((name, value?))) {
            if !(value > 0.0 && value.is_finite()) {
                return Err(NumberError::ParameterOutOfRange { name, value, min: 0.0, max: f64::INFINITY }.into());
            }
        }
        if let Some(corner) = self.corners.iter().find(|c| **c >= points) {
            let max = points.saturating_sub(1) as f64;
            return Err(NumberError::ParameterOutOfRange {
                name: ErrorItem::Corner,
                value: *corner as f64,
                min: 0.0,
                max,
            }
            .into());
        }
        Ok(())
    }
}
