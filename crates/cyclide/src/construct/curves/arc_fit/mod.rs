//! Certified arc fitting: few tangent-continuous arcs and lines within a tolerance of given points, with a proof
//! sheet (`docs/math/arc-fitting.md`; points in space by `docs/math/arc-fitting.md#space`).

mod arc_certificate;
mod beam;
mod bends;
mod bulge_interval;
mod certificate;
mod chord;
mod closing;
mod constrained_step;
pub(super) mod corners;
mod curvature_interval;
mod doubts;
pub(super) mod input;
mod options;
mod piece;
mod planar;
mod polish;
mod single;
mod space;
mod space_tangents;
mod straighten;
mod symmetric;
mod trace;
mod turning;
mod way_round;

pub use arc_certificate::{ArcCertificate, certify_arc};
pub use bulge_interval::{BulgeIntervals, feasible_bulges};
pub use certificate::FitCertificate;
pub use curvature_interval::curvature_intervals;
use options::ArcLimits;
pub use options::{ArcFitOptions, Effort, FitTarget};

use crate::base::bounds::Aabb;
use crate::base::frame::Frame;
use crate::base::planar::Point2;
use crate::base::vector::Point3;
use crate::construct::curves::outline::{FINER, NEAR, Outline, Scattered, kept_corners};
use crate::curve::{Arc, ArcPath};
use crate::error::{Error, ErrorItem, FitError, PointError, Result};
use crate::warning::{FitWarning, Warning};
use beam::ChainJoint;
use certificate::certify;
use input::{Distinct, Seam};
use piece::{Piece, Place, Span};
use symmetric::Symmetric;
use trace::{Chain, Trace};
use way_round::WayRound;

/// Part of the tolerance kept for rounding between the search and the certificate.
const ROUNDING_MARGIN: f64 = 1e-9;

/// A tolerance above this part of the figure's size is tried again with it where the search dies.
const WIDE_TUBE: f64 = 0.05;

/// A finer reading of an outline may take this many times as many pieces, and some more.
const MORE_PIECES: f64 = 1.15;
const FEW_PIECES: f64 = 8.0;

/// With the limits of a machine a path that is outside the tolerance of its polyline may be this many times as far from it as without.
const FARTHER: f64 = 1.5;

/// A fitted chain of arcs and lines with its certificate.
///
/// ```
/// use cyclide::{Point3, construct::{ArcFit, ArcFitOptions}};
/// let points: Vec<Point3> = (0..20).map(|k| Point3::new(f64::from(k), 0.1 * f64::from(k * k), 0.0)).collect();
/// let path = ArcFit::new(&points, &ArcFitOptions::new(0.05))?.into_path();
/// assert!(path.arcs().len() < 10);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ArcFit {
    path: ArcPath,
    certificate: FitCertificate,
    warnings: Vec<Warning>,
}

impl ArcFit {
    /// Fits tangent-continuous arcs and lines to points within `options.tolerance`; see [`ArcFitOptions`].
    ///
    /// Joints are free inside the tolerance tube. The first and last point of open data and the corners are kept
    /// exactly; a closed curve without corners is tangent-continuous at its seam too. The number of arcs is near the
    /// minimum, which is an observation and no theorem; everything in the certificate is measured on the result.
    ///
    /// # Errors
    /// `tolerance-not-positive`, `parameter-out-of-range` (corner angle or index, limits of arcs), `too-few-points`, `not-finite`,
    /// `coincident-points` (all points equal), `no-g1-spline-in-tube` with the point where the search died,
    /// `arc-limit-not-kept` with the point where it is.
    pub fn new(points: &[Point3], options: &ArcFitOptions) -> Result<Self> {
        options.check(points.len())?;
        let limits = options.limits();
        match Self::in_any_tube(points, options) {
            Err(died @ Error::Fit(FitError::NoG1SplineInTube { .. }))
                if options.min_radius.or(options.min_arc_length).is_some() =>
            {
                // What would do without them keeps them all the same, or says where they are missed.
                let free = ArcFitOptions { min_radius: None, min_arc_length: None, ..options.clone() };
                let fit = Self::in_any_tube(points, &free).map_err(|_| died)?;
                fit.missed(points, limits).map_or(Ok(fit), Err)
            }
            Ok(fit) if options.min_radius.or(options.min_arc_length).is_some() => fit.if_near(points, options),
            fit => fit,
        }
    }

    /// It, unless without the limits of a machine the path keeps to the polyline where this one leaves it: then the place where it
    /// misses them.
    fn if_near(self, points: &[Point3], options: &ArcFitOptions) -> Result<Self> {
        let distance = self.certificate.polyline_deviation;
        if distance <= options.tolerance {
            return Ok(self);
        }
        let free = ArcFitOptions { min_radius: None, min_arc_length: None, ..options.clone() };
        let Ok(free) = Self::in_any_tube(points, &free) else { return Ok(self) };
        if distance <= FARTHER * free.certificate.polyline_deviation {
            return Ok(self);
        }
        free.missed(points, options.limits()).map_or(Ok(free), Err)
    }

    /// The arc that misses a limit by most, as an error with the point nearest to its middle.
    fn missed(&self, points: &[Point3], limits: ArcLimits) -> Option<Error> {
        let of = |arc: &Arc| {
            let radius = arc.curvature() / limits.curvature;
            let length = limits.length / arc.length();
            let miss = if radius >= length {
                (radius, ErrorItem::MinRadius, 1.0 / arc.curvature(), 1.0 / limits.curvature)
            } else {
                (length, ErrorItem::MinArcLength, arc.length(), limits.length)
            };
            (!limits.allow(arc)).then_some((arc.midpoint(), miss))
        };
        let (at, (_, name, value, limit)) =
            self.path.arcs().iter().filter_map(of).max_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
        let nearest = |a: &&usize, b: &&usize| points[**a].distance(at).total_cmp(&points[**b].distance(at));
        let indices: Vec<usize> = (0..points.len()).collect();
        let vertex = *indices.iter().min_by(nearest)?;
        let arcs = || self.path.arcs().iter().filter(|arc| !limits.allow(arc));
        let (other, least, other_limit) = if name == ErrorItem::MinRadius {
            (ErrorItem::MinArcLength, arcs().map(Arc::length).fold(f64::INFINITY, f64::min), limits.length)
        } else {
            let radii = arcs().map(|arc| 1.0 / arc.curvature());
            (ErrorItem::MinRadius, radii.fold(f64::INFINITY, f64::min), 1.0 / limits.curvature)
        };
        let also = (least < other_limit).then_some((other, least));
        Some(Error::Fit(FitError::ArcLimitNotKept { vertex, name, value, limit, also }))
    }

    /// The fit to all points; to those of a closed outline without last points that nearly repeat the first, unless that takes more
    /// pieces and the other one keeps to the edges.
    fn in_any_tube(points: &[Point3], options: &ArcFitOptions) -> Result<Self> {
        let fit = Self::with_closing(points, options, Seam::Repeated);
        let count = |seam| {
            let list = Distinct::with_seam(points, options.closed, options.tolerance, seam);
            list.map_or(0, |list| list.points.len())
        };
        if !options.closed || count(Seam::Near) == count(Seam::Repeated) {
            return fit;
        }
        let Ok(near) = Self::with_closing(points, options, Seam::Near) else { return fit };
        match fit {
            Ok(fit) if fit.path.arcs().len() < near.path.arcs().len() && (near.is_left() || !fit.is_left()) => Ok(fit),
            _ => Ok(near),
        }
    }

    fn with_closing(points: &[Point3], options: &ArcFitOptions, seam: Seam) -> Result<Self> {
        let fit = Self::within_tube(points, options, seam);
        // A tube as wide as the figure gives the search no hold; a fit within less is within the tolerance too.
        let size = Aabb::of_points(points.iter().copied()).map_or(0.0, Aabb::diagonal);
        let tolerance = WIDE_TUBE * size;
        match fit {
            Err(died @ Error::Fit(FitError::NoG1SplineInTube { .. }))
                if tolerance > 0.0 && options.tolerance > tolerance =>
            {
                Self::within_tube(points, &ArcFitOptions { tolerance, ..options.clone() }, seam).map_err(|_| died)
            }
            fit => fit,
        }
    }

    /// The fit with the effort asked for; with more where the search dies or turns more than its data.
    fn within_tube(points: &[Point3], options: &ArcFitOptions, seam: Seam) -> Result<Self> {
        let mut best: Option<Self> = None;
        let mut died = None;
        for effort in options.effort.and_above() {
            match Self::with_effort(points, options, *effort, seam) {
                Ok(fit) if fit.turns_as_data() => return Ok(fit.or_shorter(points, options, *effort, seam)),
                Ok(fit) => {
                    if best.as_ref().is_none_or(|b| fit.certificate.excess_turning() < b.certificate.excess_turning()) {
                        best = Some(fit);
                    }
                }
                // More effort finds more ways between samples; edges that are meant leave none.
                Err(error @ Error::Fit(FitError::NoG1SplineInTube { .. })) if options.target == FitTarget::Points => {
                    died = Some(error);
                }
                Err(error) => return best.ok_or(error),
            }
        }
        let Some(mut fit) = best else {
            return Err(died.unwrap_or(Error::Point(PointError::TooFewPoints { given: 0, needed: 2 })));
        };
        let FitCertificate { turning, turning_limit: limit, .. } = fit.certificate;
        fit.warnings.push(Warning::Fit(FitWarning::TurnsMoreThanData { turning, limit }));
        Ok(fit)
    }

    /// Whether it turns no more than its data.
    fn turns_as_data(&self) -> bool {
        self.certificate.turning <= self.certificate.turning_limit
    }

    /// It, or one of fewer arcs by one of the efforts beside that.
    fn or_shorter(self, points: &[Point3], options: &ArcFitOptions, effort: Effort, seam: Seam) -> Self {
        let others = effort.beside().iter().filter_map(|effort| Self::with_effort(points, options, *effort, seam).ok());
        others
            .filter(Self::turns_as_data)
            .fold(self, |best, other| if other.path.arcs().len() < best.path.arcs().len() { other } else { best })
    }

    fn with_effort(points: &[Point3], options: &ArcFitOptions, effort: Effort, seam: Seam) -> Result<Self> {
        let list = Distinct::with_seam(points, options.closed, options.tolerance, seam)?;
        let way = WayRound::of(&list.points, options.closed);
        match Self::one_way(&list, &way, options, effort) {
            // What ends in a dead end from one side may not from the other.
            Err(died @ Error::Fit(FitError::NoG1SplineInTube { .. })) => {
                Self::one_way(&list, &way.turned(), options, effort).map_err(|_| died)
            }
            found => found,
        }
    }

    fn one_way(list: &Distinct, way: &WayRound, options: &ArcFitOptions, effort: Effort) -> Result<Self> {
        let forced: Vec<usize> = options.corners.iter().map(|c| list.position(*c)).collect();
        let (distinct, forced) = way.taken(list, &forced);
        let read = |lasting: f64, scattered: Scattered| {
            corners::outline(&distinct.points, &forced, options, lasting * options.tolerance, scattered)
        };
        let outline = read(1.0, Scattered::Vertices);
        match Self::of_outline(&distinct, &outline, way, options, effort) {
            // Points that noise has moved past each other are vertices of no outline.
            Err(error @ Error::Fit(FitError::NoG1SplineInTube { .. })) => {
                let other = read(1.0, Scattered::Noise);
                if other == outline { Err(error) } else { Self::of_outline(&distinct, &other, way, options, effort) }
            }
            // Details of an outline may be smaller than the tolerance, its sides are not.
            Ok(fit) if fit.is_left() && options.corner_angle.is_none() => {
                let pieces = fit.path.arcs().len();
                let finer = FINER.into_iter().filter_map(|part| {
                    let finer = read(part, Scattered::Noise);
                    let fit = outline
                        .is_coarser(&finer)
                        .then(|| Self::of_outline(&distinct, &finer, way, options, effort))?
                        .ok()?;
                    let is_near = fit.certificate.polyline_deviation <= NEAR * options.tolerance;
                    // Corners of noise take more pieces than the curve through it.
                    let is_short = fit.path.arcs().len() as f64 <= MORE_PIECES * pieces as f64 + FEW_PIECES;
                    (!fit.is_left() && is_near && is_short).then_some(fit)
                });
                Ok({ finer }.next().unwrap_or(fit))
            }
            found => found,
        }
    }

    /// The curve leaves the edges of the points, as is said.
    fn is_left(&self) -> bool {
        let is_said =
            |w: &Warning| matches!(w, Warning::Fit(FitWarning::ReadAsCurve { .. } | FitWarning::SwingsOut { .. }));
        self.warnings.iter().any(is_said)
    }

    fn of_outline(
        distinct: &Distinct,
        outline: &Outline,
        way: &WayRound,
        options: &ArcFitOptions,
        effort: Effort,
    ) -> Result<Self> {
        let (data, tolerance) = (&distinct.points, options.tolerance);
        let corners = &outline.corners;
        let indices: Vec<usize> = corners.iter().map(|c| c.0).collect();
        let died =
            |vertex: usize| Error::Fit(FitError::NoG1SplineInTube { vertex: distinct.source[vertex], tolerance });

        let largest = data.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let rounding = (ROUNDING_MARGIN * tolerance).max(8.0 * f64::EPSILON * largest).min(0.5 * tolerance);
        let room = tolerance - distinct.moved - rounding;
        let plane = input::plane(data, tolerance);
        let (trace, pieces) = match &plane {
            Some(frame) => {
                match planar::fit(data, outline, frame, room, options, effort) {
                    Ok((trace, chains)) => {
                        let pieces = planar_pieces(&trace, &chains, frame)?;
                        let corners = trace.positions_of(&indices);
                        let reader = Symmetric { trace: &trace, corners, frame, tolerance: room, options, effort };
                        let pieces = Self::finished(pieces, distinct, outline, &reader);
                        (trace, pieces)
                    }
                    // Wild samples: biarcs through the points take more arcs but nearly always exist.
                    Err(vertex) if options.target == FitTarget::Points && effort == Effort::Best => {
                        space::fit(data, &indices, room, options).map_err(|_| died(vertex))?
                    }
                    Err(vertex) => return Err(died(vertex)),
                }
            }
            None => space::fit(data, &indices, room, options).map_err(died)?,
        };

        let (arcs, place_in_path) = way.back(pieces.iter().map(|p| p.arc).collect());
        let path = ArcPath::new(arcs, options.closed)?;
        let mut certificate = certify(&pieces, &trace, options.target, plane.is_some());
        let proved = certificate.monotone || options.target == FitTarget::Points;
        if certificate.deviation > tolerance || !proved || !options.limits_kept(&pieces) {
            return Err(died(certificate.worst));
        }
        certificate.worst = distinct.source[certificate.worst];
        // The points that others stand for are that much farther away.
        for distance in
            [&mut certificate.deviation, &mut certificate.vertex_deviation, &mut certificate.polyline_deviation]
        {
            *distance += distinct.moved;
        }
        let judged = turning::Data::new(data, outline, options);
        certificate.turning = turning::of_pieces(&pieces, options.closed);
        certificate.turning_limit = judged.limit(&pieces, &trace);
        let mut warnings = distinct.warnings.clone();
        warnings.extend(kept_corners(corners, &distinct.source));
        let distance = certificate.polyline_deviation;
        let fitted = doubts::Fitted { pieces: &pieces, trace: &trace, distance, is_planar: plane.is_some() };
        warnings.extend(fitted.doubts(data, outline, options));
        let mut tight = judged.tight_arcs(&pieces, &trace, &distinct.source);
        if let Some(Warning::Fit(FitWarning::TightArc { piece, .. })) = &mut tight {
            *piece = place_in_path(*piece);
        }
        warnings.extend(tight);
        Ok(Self { path, certificate, warnings })
    }

    /// The least pieces of a plane outline with straight sides straight, the deviation as small as it can be and symmetric data
    /// symmetric: each as long as it keeps to the tolerance, the limits and the turns.
    fn finished(
        mut found: Vec<Piece>,
        distinct: &Distinct,
        outline: &Outline,
        symmetric: &Symmetric<'_>,
    ) -> Vec<Piece> {
        let Symmetric { trace, frame, tolerance: room, options, .. } = *symmetric;
        let mut straight = found.clone();
        straighten::straighten(&mut straight, trace, frame.z(), room, options.target);
        let pieces = if options.limits_kept(&straight) {
            straight
        } else {
            straighten::sides_only(&mut found, trace, room);
            found
        };
        let judged = turning::Data::new(&distinct.points, outline, options);
        let does = |found: &[Piece], instead_of: &[Piece]| {
            let sheet = certify(found, trace, options.target, true);
            let turning = turning::of_pieces(found, options.closed);
            let turns_on =
                turning <= judged.limit(found, trace) || turning <= turning::of_pieces(instead_of, options.closed);
            sheet.deviation <= options.tolerance && sheet.monotone && turns_on && options.limits_kept(found)
        };
        let polished = polish::polished(pieces.clone(), trace, frame, room, options);
        let pieces = if does(&polished, &pieces) { polished } else { pieces };
        symmetric.path(&pieces, |found| does(found, &pieces)).unwrap_or(pieces)
    }

    /// The arcs and lines.
    #[must_use]
    pub fn path(&self) -> &ArcPath {
        &self.path
    }

    /// The path alone.
    #[must_use]
    pub fn into_path(self) -> ArcPath {
        self.path
    }

    /// What is proved about the path.
    #[must_use]
    pub fn certificate(&self) -> &FitCertificate {
        &self.certificate
    }

    /// Corners kept, points merged, and doubts about the data.
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}

fn planar_pieces(trace: &Trace, chains: &[Chain], frame: &Frame) -> Result<Vec<Piece>> {
    let mut pieces = Vec::new();
    for chain in chains {
        let joints = &chain.joints;
        let loops = trace.closed && chains.len() == 1 && joints[0].frame == joints[joints.len() - 1].frame;
        let place = |i: usize| {
            let at_end = i == 0 || i == joints.len() - 1;
            if loops {
                frame.to_world(joints[if at_end { 0 } else { i }].frame.joint)
            } else if at_end {
                trace.point(chain.first + joints[i].vertex)
            } else {
                frame.to_world(joints[i].frame.joint)
            }
        };
        for i in 1..joints.len() {
            let (from, to) = (&joints[i - 1], &joints[i]);
            let arc = Arc::from_bulge(place(i - 1), place(i), frame.z(), chain_bulge(from, to))?;
            let over = |joint: &ChainJoint| Place::over(chain.first + joint.vertex);
            pieces.push(Piece { arc, span: Span { from: over(from), to: over(to) }, smooth: i > 1 || loops });
        }
    }
    Ok(pieces)
}

/// Bulge of the arc between two joints, by the angle from its start tangent to the chord: `tan(sweep/4)`.
fn chain_bulge(from: &ChainJoint, to: &ChainJoint) -> f64 {
    if to.straight {
        return 0.0;
    }
    let chord = chord_direction(from.frame.joint, to.frame.joint);
    let (sine, cosine) = (from.frame.tangent.cross(chord), from.frame.tangent.dot(chord));
    if cosine >= 0.0 { sine / (1.0 + cosine) } else { (1.0 - cosine) / sine }
}

fn chord_direction(from: Point2, to: Point2) -> crate::base::planar::Vec2 {
    let chord = to - from;
    chord * (1.0 / chord.length())
}
