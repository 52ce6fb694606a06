//! Fair fits of measured points: stops become one point, outliers are named, and the strength follows the noise
//! (`docs/math/fair-fits.md#noise`).

use super::doubts::Swing;
use super::edged::{Edged, in_plan};
use super::meeting_sides::Sharp;
use super::noise::{self, Denoised, Reading, Rounded, Stop, denoised};
use super::options::{Heights, Noise, Outliers};
use super::{FairFit, FairFitOptions, corners, whittaker};
use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::input::{Distinct, diameter};
use crate::error::{Error, ErrorItem, FitError, NumberError, PointError, Result};
use crate::warning::{FitWarning, NoiseWarning, PointWarning, Warning};

/// The curve keeps this near to the points without their noise, in deviations of these from what was measured,
const NEARNESS: f64 = 0.4;
/// and not nearer than this part of the size of the data.
pub(super) const NEAREST: f64 = 1e-7;
/// Where it cannot, this many times as near will do, so often, as long as that is at most so many deviations of the noise, or of
/// this many times the first.
const RELAXED: f64 = 2.0;
const RELAXATIONS: usize = 8;
const OF_DEVIATION: f64 = 2.0;
const OF_FIRST: f64 = 32.0;
/// Noise moves points by this many deviations.
pub(super) const OF_NOISE: f64 = 3.0;
/// Few points may be corners where their noise is above this part of what they are apart.
const OF_STEP: f64 = 0.1;
/// Noise does not have two points next to each other farther off the curve than so many deviations.
const OF_TWO: f64 = 4.0;
/// With more outliers than this each is not named any more.
pub(super) const NAMED: usize = 20;

/// What was done to measured points before their fit.
pub(super) struct Prepared {
    pub distinct: Distinct,
    pub warnings: Vec<Warning>,
}

/// Points as they were measured, where those that are fitted are without their noise.
#[derive(Clone, Copy)]
pub(super) struct Measured<'a> {
    pub points: &'a [Point3],
    /// Whether the edge that begins at each is a straight side.
    pub straight: &'a [bool],
}

/// Merges equal neighbors, and the points of stops.
pub(super) fn prepared(points: &[Point3], options: &FairFitOptions) -> Result<Prepared> {
    let merged = Distinct::new(points, options.closed, options.tolerance)?;
    let stops = if options.edge_points == 0 { noise::stops(&merged.points) } else { Vec::new() };
    let left = merged.points.len() - stops.iter().map(|s| s.last - s.first).sum::<usize>();
    if stops.is_empty() || left < 4 {
        return Ok(Prepared { distinct: merged, warnings: Vec::new() });
    }
    let (mut kept, mut source, mut next) = (Vec::new(), Vec::new(), 0);
    let mut warnings = Vec::new();
    for Stop { first, last, middle, radius } in stops {
        kept.extend_from_slice(&merged.points[next..first]);
        source.extend_from_slice(&merged.source[next..first]);
        kept.push(middle);
        source.push(merged.source[first]);
        next = last + 1;
        let range = [merged.source[first], merged.source[last]];
        let count = range[1] + 1 - range[0];
        warnings.push(Warning::Point(PointWarning::StopMerged {
            first: range[0],
            last: range[1],
            count,
            at: middle.to_vec().to_array(),
            radius,
        }));
    }
    kept.extend_from_slice(&merged.points[next..]);
    source.extend_from_slice(&merged.source[next..]);
    let moved = merged.moved;
    let mut distinct = Distinct::of(kept, source, merged.warnings);
    distinct.moved = moved;
    Ok(Prepared { distinct, warnings })
}

/// What the points say about their noise and about outliers among them; `None` of too few.
pub(super) fn read(distinct: &Distinct, options: &FairFitOptions, edged: &Edged) -> Option<Denoised> {
    denoised(&distinct.points, &edged.runs(options), reading(options))
}

/// How the points are read.
pub(super) fn reading(options: &FairFitOptions) -> Reading {
    let noise = match options.noise {
        Some(Noise::Known(noise)) => Some(noise),
        _ => None,
    };
    Reading {
        noise,
        common: None,
        heights: options.heights == Heights::ByNoise,
        drop: options.outliers == Outliers::Drop,
    }
}

/// The points that belong to the others alone.
pub(super) fn without_outliers(distinct: &Distinct, found: &Denoised) -> Distinct {
    let is_out = |i: usize| found.outliers.binary_search_by_key(&i, |o| o.0).is_ok();
    let kept: Vec<usize> = (0..distinct.points.len()).filter(|i| !is_out(*i)).collect();
    let points = kept.iter().map(|i| distinct.points[*i]).collect();
    let source = kept.iter().map(|i| distinct.source[*i]).collect();
    let mut left = Distinct::of(points, source, distinct.warnings.clone());
    left.moved = distinct.moved;
    left
}

/// The warnings about outliers.
pub(super) fn outliers_named(found: &Denoised, source: &[usize], dropped: bool) -> Vec<Warning> {
    let (noise, count) = (found.deviation, found.outliers.len());
    let outlier = |(i, distance): &(usize, f64)| {
        Warning::Noise(NoiseWarning::Outlier { point: source[*i], distance: *distance, noise, dropped, count })
    };
    found.outliers.iter().take(NAMED).map(outlier).collect()
}

/// Data whose heights are smoothed as far as their tolerance exceeds that across, and how far one was moved: within the
/// tolerance of these a curve is within both of the data.
pub(super) fn with_loose_heights(
    distinct: &Distinct,
    options: &FairFitOptions,
    edged: &Edged,
    within: f64,
) -> Result<(Distinct, f64)> {
    let (least, max) = (options.tolerance, f64::MAX);
    if !(within > least && within.is_finite()) {
        return Err(
            NumberError::ParameterOutOfRange { name: ErrorItem::ToleranceZ, value: within, min: least, max }.into()
        );
    }
    let mut points = distinct.points.clone();
    let mut moved = 0.0_f64;
    for run in edged.runs(options) {
        let own: Vec<Point3> = run.numbers.iter().map(|i| distinct.points[*i]).collect();
        let flat: Vec<Point3> = own.iter().map(|p| Point3::new(p.x, p.y, 0.0)).collect();
        let heights: Vec<Point3> = own.iter().map(|p| Point3::new(0.0, 0.0, p.z)).collect();
        let lengths = noise::lengths(&flat, run.closed);
        let smooth = whittaker::smooth(&heights, &lengths, run.closed, run.fixed, (within - least) / whittaker::ROOM);
        for (i, z) in run.numbers.iter().zip(&smooth.points) {
            moved = moved.max((points[*i].z - z.z).abs());
            points[*i].z = z.z;
        }
    }
    let mut loose = Distinct::of(points, distinct.source.clone(), distinct.warnings.clone());
    loose.moved = distinct.moved;
    Ok((loose, moved))
}

impl FairFit {
    /// What is said of edges that are far longer than those round them: those that are sides, and those that are not.
    fn long_edges(distinct: &Distinct, options: &FairFitOptions, straight: &[bool], kept: &[usize]) -> Vec<Warning> {
        let points: Vec<Point3> = kept.iter().map(|i| distinct.points[*i]).collect();
        let points = &*in_plan(&points, options);
        let bursts = noise::bursts(points, options.closed);
        let gaps = corners::gaps(points, options.closed);
        let gaps = corners::without_spikes(points, options.closed, &gaps, &bursts);
        let of = |held: bool| {
            let mut all = (0..gaps.len()).filter(|k| gaps[*k] && straight[*k] == held);
            let point = distinct.source[kept[all.next()?]];
            Some(Warning::Fit(FitWarning::LongEdges { point, count: 1 + all.count(), held }))
        };
        [true, false].into_iter().filter_map(of).collect()
    }

    /// The fit whose strength follows the noise.
    pub(super) fn by_noise(prepared: Prepared, options: &FairFitOptions) -> Result<Self> {
        let Prepared { distinct, mut warnings } = prepared;
        let size = diameter(&distinct.points);
        let sharp = match Edged::in_noise(&distinct, options, size) {
            Ok(sharp) => sharp,
            Err(edged) if edged.is_any() => return Self::as_outline(&distinct, options, &edged, warnings),
            Err(_) => {
                return Err(PointError::TooFewPoints { given: distinct.points.len(), needed: noise::FEWEST }.into());
            }
        };
        warnings.extend(sharp.inserted_corners());
        let Sharp { inserted, edged, found } = sharp;
        let distinct = inserted.unwrap_or(distinct);
        let dropped = options.outliers == Outliers::Drop;
        warnings.extend(outliers_named(&found, &distinct.source, dropped));
        warnings.extend(found.steps_named(&distinct.source));
        if let (Some(found), Some(Noise::Known(given))) = (found.contradicted, options.noise) {
            warnings.push(Warning::Noise(NoiseWarning::Contradicted { given, found }));
        }
        let points: Vec<Point3> = found.kept.iter().map(|i| distinct.points[*i]).collect();
        let source: Vec<usize> = found.kept.iter().map(|i| distinct.source[*i]).collect();
        // An edge over points that are left out is one if it has one in it.
        let n = edged.straight.len();
        let is_side = |k: usize| {
            let (from, to) = (found.kept[k], found.kept[(k + 1) % found.kept.len()]);
            (from..if to > from { to } else { to + n }).any(|i| edged.straight[i % n])
        };
        let straight: Vec<bool> = (0..found.kept.len()).map(is_side).collect();
        if found.deviation > NEAREST * size {
            warnings.extend(Self::long_edges(&distinct, options, &straight, &found.kept));
        }
        let task = FairFitOptions {
            tolerance: (NEARNESS * found.uncertainty).max(NEAREST * size),
            corners: edged.corners.iter().map(|i| distinct.source[*i]).collect(),
            corner_angle: None,
            centre: 0.0,
            ..options.clone()
        };
        let places = Distinct::of(found.places.clone(), source, distinct.warnings.clone());
        let mut fit = Self::near_places(&places, task, Measured { points: &points, straight: &straight }, &found)?;
        if fit.certificate.deviation > options.tolerance {
            let (deviation, tolerance) = (fit.certificate.deviation, options.tolerance);
            return Err(
                FitError::ToleranceNotReached { points: vec![fit.certificate.worst], deviation, tolerance }.into()
            );
        }
        warnings.extend(fit.corners_left(&found, &distinct, size, options.closed).map(Warning::Noise));
        let apart = noise::usual_length(&distinct.points);
        if places.points.len() < noise::FEW_POINTS && found.deviation > OF_STEP * apart {
            let (points, noise) = (places.points.len(), found.deviation);
            warnings.push(Warning::Noise(NoiseWarning::FewPoints { points, noise, apart }));
        }
        fit.certificate.noise = Some(found.deviation);
        fit.certificate.noise_z = found.heights;
        if !dropped && !found.outliers.is_empty() {
            fit.pulled_by_outliers();
        }
        warnings.append(&mut fit.warnings);
        fit.warnings = warnings;
        Ok(fit)
    }

    /// Of points whose runs between corners and sides are too few to tell noise: an outline, which is kept.
    fn as_outline(
        distinct: &Distinct,
        options: &FairFitOptions,
        edged: &Edged,
        mut warnings: Vec<Warning>,
    ) -> Result<Self> {
        // What neighbors were merged over counts.
        let tolerance = (NEAREST * diameter(&distinct.points) + distinct.moved).min(options.tolerance);
        let corners = edged.corners.iter().map(|i| distinct.source[*i]).collect();
        let outline =
            FairFitOptions { tolerance, corners, corner_angle: None, centre: 0.0, noise: None, ..options.clone() };
        let mut fit = Self::near(distinct, &outline, None)?;
        warnings.append(&mut fit.warnings);
        fit.warnings = warnings;
        Ok(fit)
    }

    /// The fit near the points without their noise, with as much room as it needs.
    fn near_places(
        places: &Distinct,
        mut task: FairFitOptions,
        measured: Measured<'_>,
        found: &Denoised,
    ) -> Result<Self> {
        // A curve that is lost may find its way with more; one that outliers pull away is said to.
        let is_free = task.outliers == Outliers::Drop || found.outliers.is_empty();
        let widest = (OF_DEVIATION * found.deviation).max(OF_FIRST * task.tolerance);
        let mut tries = 0;
        loop {
            let tolerance = task.tolerance;
            let failed = match Self::near(places, &task, Some(measured)) {
                Ok(Self { swing: Some(Swing { point, distance, is_lost: true, .. }), .. }) if is_free => {
                    FitError::CurveLost { point: places.source[point], distance, tolerance }
                }
                Err(Error::Fit(FitError::ToleranceNotReached { points, deviation, .. })) => {
                    FitError::NoiseNotSmoothed { points, deviation, noise: found.deviation }
                }
                other => return other,
            };
            task.tolerance = tolerance * RELAXED;
            if tries == RELAXATIONS || task.tolerance > widest {
                return Err(failed.into());
            }
            tries += 1;
        }
    }

    /// What is said of corners that the curve may have rounded off: points that are off it where it bends sharply, or two in a row that no noise
    /// has so far off.
    fn corners_left(&self, found: &Denoised, distinct: &Distinct, size: f64, closed: bool) -> Option<NoiseWarning> {
        let points: Vec<Point3> = found.kept.iter().map(|i| distinct.points[*i]).collect();
        if let Some(Rounded { point, distance, count, noise }) =
            noise::rounded(&points, &found.places, closed, found.directions)
        {
            let point = distinct.source[found.kept[point]];
            return Some(NoiseWarning::CornersRounded { point, distance, count, noise });
        }
        let (distance, point) = self.beside;
        let is_outlier = |out: &(usize, f64)| (point..=point + 1).contains(&distinct.source[out.0]);
        let noise = found.heights.unwrap_or(0.0).max(found.deviation);
        let leaves = distance > OF_TWO * noise.max(NEAREST * size) && !found.outliers.iter().any(is_outlier);
        leaves.then_some(NoiseWarning::PointsLeft { point, distance, noise })
    }
}
