//! Fair fits: the fairest fair spline within a tolerance of given points, with few nodes and a proof sheet
//! (`docs/math/fair-fits.md`).
//!
//! The nodes are unknown, few, and no data points. For a fixed number of them
//!
//! ```text
//! J = sum d |V|² ~ int k'² ds,    V the derivative of curvature of a segment, d its chord
//! ```
//! is minimised while every point stays within the tolerance of the curve: a sequence of convex problems in the
//! displacements of the nodes, each solved by an interior point method with banded matrices; after each the exact spline
//! and the exact feet are found again. Then nodes are taken out in batches while `J` stays near the fairest seen. The
//! choice of nodes is greedy and the tube is not convex in the curve: nothing proves that `J` or the number of nodes is
//! the least. The certificate is proved.
//!
//! One subject per file: where closed data start, start curve, density, linear model, interior point, one fit, removal, the
//! run of a smooth piece, the frame it works in, the pieces put together, certificate, doubts; of measured points their noise,
//! and what of them are corners and sides.

mod along;
mod bordered_band;
mod certificate;
mod corners;
mod density;
mod doubts;
mod edged;
mod feet;
mod fit;
mod interior_point;
mod linear_model;
mod measured;
mod meeting_sides;
mod noise;
mod options;
mod parts;
mod places;
mod removal;
mod run;
mod spline_basis;
mod tube_curve;
mod whittaker;
mod working_frame;

pub use options::{FairFitOptions, Heights, Noise, Outliers};

use crate::base::range;
use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::input::{Distinct, diameter};
use crate::construct::curves::canonical_start::runs_backwards;
use crate::construct::curves::outline::{FINER, NEAR, Outline};
use crate::curve::CircleSpline;
use crate::error::{Error, FitError, Result};
use crate::warning::{FitWarning, NoiseWarning, Warning};
use doubts::{LOST, Swing};
use edged::Edged;
use measured::{Measured, OF_NOISE, Prepared, outliers_named, prepared, read, with_loose_heights, without_outliers};
use noise::Denoised;
use parts::Parts;
use working_frame::WorkingFrame;

/// Places on each edge that hold a curve which swings out between its points.
const HELD_EDGE_POINTS: usize = 3;
/// Tolerances above these parts of the size of the data bind little: a closed curve shrinks, a long one swings out, and
/// turns of a spiral fall together. There narrower ones are tried too.
const WIDE: [f64; 4] = [1.0 / 4.0, 1.0 / 8.0, 1.0 / 16.0, 1.0 / 32.0];
/// Where a curve loops between two points, these parts of the tolerance are tried.
const NARROW: [f64; 3] = [1.0 / 4.0, 1.0 / 16.0, 1.0 / 64.0];
/// They are below the noise where more than one point in this many is a corner.
const FEW_CORNERS: usize = 10;
/// A narrower tolerance is tried if it is below this part of the one asked for.
const NARROWER: f64 = 0.75;

/// A tolerance up to this many standard deviations is there for the noise,
const OF_THE_ORDER: f64 = 8.0;
/// and a root mean square of the distances above this many is more than that; below this part of the tolerance it is not
/// looked at.
const MORE_THAN_NOISE: f64 = 1.1;
const LEAST_OF_TOLERANCE: f64 = 0.125;
/// There the points pull this many times as much, so often.
const STRONGER: f64 = 10.0;
const MOST_STRONGER: usize = 4;

/// A narrower one is taken for a variation below this part, if that is any: `J` times the cubed size of the data.
const FAIRER: f64 = 0.9;
const NOTHING: f64 = 1e-9;

/// A fair spline within a tolerance of points, with its certificate.
///
/// ```
/// use cyclide::{FairFit, FairFitOptions, Point3};
/// let noisy = |k: i32| Point3::new(0.1 * f64::from(k), (0.1 * f64::from(k)).sin() + 0.01 * f64::from(k % 3), 0.0);
/// let fit = FairFit::new(&(0..60).map(noisy).collect::<Vec<_>>(), &FairFitOptions::new(0.05))?;
/// assert!(fit.certificate().deviation <= 0.05 && fit.certificate().nodes < 60);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct FairFit {
    spline: CircleSpline,
    certificate: FairFitCertificate,
    warnings: Vec<Warning>,
    /// Where it swings out between points.
    swing: Option<Swing>,
    /// Where corners smaller than the tolerance are kept: the positions of all among the distinct points, rising.
    corners: Vec<usize>,
}

/// What is proved about a fair fit, and how fair it is.
///
/// ```
/// use cyclide::{FairFit, FairFitOptions, Point3};
/// let points: Vec<Point3> = (0..40).map(|k| Point3::new(f64::from(k), (0.2 * f64::from(k)).sin(), 0.0)).collect();
/// let certificate = *FairFit::new(&points, &FairFitOptions::new(0.05))?.certificate();
/// assert!(certificate.rms <= certificate.deviation && certificate.deviation <= 0.05);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FairFitCertificate {
    /// Largest distance of a point from the curve, at most the tolerance.
    pub deviation: f64,
    /// Root mean square of the distances of the points from the curve.
    pub rms: f64,
    /// Where [`monotone`](Self::monotone): bound on the Fréchet distance of curve and polyline, hence on their distance
    /// both ways. Else: bound on the distance of the curve from the polyline.
    pub polyline_deviation: f64,
    /// The feet of the points advance with them along the curve.
    pub monotone: bool,
    /// The point (in the user's numbering) with the largest distance.
    pub worst: usize,
    /// Nodes of the spline.
    pub nodes: usize,
    /// Where heights have a tolerance of their own: bound on how far z of the curve is from that of the points. The deviation
    /// is then of points whose heights are smoothed.
    pub deviation_z: Option<f64>,
    /// Standard deviation of the noise of the points across the curve, in one direction, where the strength follows it: the
    /// one that was estimated, or the one given.
    pub noise: Option<f64>,
    /// That of their heights, where these have one of their own.
    pub noise_z: Option<f64>,
    /// `J`: the integral of the squared derivative of curvature by length, by one value per segment, over all smooth
    /// pieces; 1/length³.
    pub fairness: f64,
}

impl FairFit {
    /// Fits the fairest spline found within `options.tolerance` of all points; see [`FairFitOptions`].
    ///
    /// The curve is G2 with an exact rational form of degree 4, a [`CircleSpline`] of fair segments. Corners are kept
    /// exactly; each smooth piece between them is fitted on its own and ends in an arc. Linear in the number of points,
    /// in memory and about so in time.
    ///
    /// A closed curve does not depend on the point its list starts with. A tolerance wide against the figure, above 1/32 of
    /// the diagonal of its box, lets a curve swing out or get lost between turns: narrower ones are tried too, down to that
    /// part, and if one gives a better curve a warning (`wide-tolerance`) says so. Bends and loops that the tolerance
    /// takes are another (`shape-smoothed-away`).
    ///
    /// A curve that leaves an edge of its polyline by more than samples of a smooth curve explain (the tolerance and 0.146 of
    /// the edge) swings out: nothing holds it there. It is fitted again with places on the edges, and a warning (`swings-out`)
    /// says so.
    ///
    /// ```
    /// use cyclide::{FairFit, FairFitOptions, Point3};
    /// // A wave, measured to 0.01.
    /// let noise = |i: u32| 0.01 * (f64::from(i * i) * 0.7).sin();
    /// let points: Vec<Point3> = (0..200)
    ///     .map(|i| Point3::new(f64::from(i) * 0.05, (f64::from(i) * 0.05).sin() + noise(i), 0.0))
    ///     .collect();
    /// let fit = FairFit::new(&points, &FairFitOptions { centre: 1.0, ..FairFitOptions::new(0.04) })?;
    /// assert!(fit.certificate().deviation <= 0.04 && fit.certificate().nodes < 20);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `tolerance-not-positive`, `parameter-out-of-range` (an option, a corner index, a coordinate), `too-few-points`,
    /// `not-finite`, `coincident-points` (all points equal), `tolerance-not-reached` with the points that stay outside, `curve-lost`
    /// where the curve would loop far away between two points, and `noise-not-smoothed` where the strength follows the noise.
    pub fn new(points: &[Point3], options: &FairFitOptions) -> Result<Self> {
        options.check(points.len())?;
        for (index, p) in points.iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        let Prepared { mut distinct, warnings } = prepared(points, options)?;
        if options.noise.is_some() {
            return Self::by_noise(Prepared { distinct, warnings }, options);
        }
        let mut warnings = warnings;
        if options.outliers == Outliers::Drop {
            let edged = Edged::within(&distinct, options, options.tolerance);
            // Points of straight runs are sides to a tolerance, and outliers corners; to noise they are not.
            let by_noise = || {
                let options = FairFitOptions { noise: Some(Noise::Estimated), ..options.clone() };
                Edged::in_noise(&distinct, &options, diameter(&distinct.points)).1
            };
            let found = read(&distinct, options, &edged).filter(|found| !found.outliers.is_empty()).or_else(by_noise);
            if let Some(found) = found.filter(|found| !found.outliers.is_empty()) {
                warnings.extend(outliers_named(&found, &distinct.source, true));
                distinct = without_outliers(&distinct, &found);
            }
        }
        let mut loose = None;
        if let Heights::Within(within) = options.heights {
            let edged = Edged::within(&distinct, options, options.tolerance);
            let (points, moved) = with_loose_heights(&distinct, options, &edged, within)?;
            (distinct, loose) = (points, Some(moved));
        }
        let edged = Edged::within(&distinct, options, options.tolerance);
        let found = if options.edge_points == 0 { read(&distinct, options, &edged) } else { None };
        let fit = Self::near(&distinct, options, None)
            .map_err(|e| Self::because_of_outliers(e, found.as_ref(), &distinct, options))?;
        let mut fit = match &found {
            Some(found) => fit.with_noise_kept(found, &distinct, options)?,
            None => fit,
        };
        // Outliers that are kept may well throw the curve off, and are named.
        if let Some(Swing { point, distance, is_lost: true, .. }) = fit.swing
            && distance > LOST * options.tolerance
            && found.as_ref().is_none_or(|found| found.outliers.is_empty())
        {
            return Err(FitError::CurveLost { point, distance, tolerance: options.tolerance }.into());
        }
        if let Some(mut found) = found.filter(|_| options.outliers == Outliers::Keep) {
            // The curve has gone out of its way to reach these, and they are no corners of it.
            let is_corner = |i: &usize| fit.corners.binary_search(i).is_ok();
            found.outliers.retain(|(i, distance)| *distance > options.tolerance && !is_corner(i));
            if !found.outliers.is_empty() {
                fit.pulled_by_outliers();
            }
            fit.warnings.extend(outliers_named(&found, &distinct.source, false));
        }
        fit.certificate.deviation_z = loose.map(|moved| moved + fit.certificate.deviation);
        warnings.append(&mut fit.warnings);
        fit.warnings = warnings;
        Ok(fit)
    }

    /// The fit, or with a tolerance of the order of the noise, where it leaves out more than that, one that keeps closer to the
    /// points: of 1, `centre` is as much as their noise allows. The fairest curve (0) leans on its bounds, which a warning says.
    fn with_noise_kept(self, found: &Denoised, distinct: &Distinct, options: &FairFitOptions) -> Result<Self> {
        if options.centre == 0.0 || self.certificate.rms < LEAST_OF_TOLERANCE * options.tolerance {
            return Ok(self);
        }
        let noise = found.deviation;
        let most = MORE_THAN_NOISE * noise * (found.directions as f64).sqrt();
        if options.tolerance > OF_THE_ORDER * noise || self.certificate.rms <= most {
            return Ok(self);
        }
        let mut stronger = options.clone();
        let mut fit = self;
        for _ in 0..MOST_STRONGER {
            stronger.centre *= STRONGER;
            fit = Self::near(distinct, &stronger, None)?;
            fit.certificate.noise = Some(noise);
            if fit.certificate.rms <= most {
                return Ok(fit);
            }
        }
        fit.warnings.push(Warning::Noise(NoiseWarning::BeyondNoise { rms: fit.certificate.rms, noise }));
        Ok(fit)
    }

    /// What is told of a tolerance that is not reached: the outliers, where some are why.
    fn because_of_outliers(
        error: Error,
        found: Option<&Denoised>,
        distinct: &Distinct,
        options: &FairFitOptions,
    ) -> Error {
        let Error::Fit(FitError::ToleranceNotReached { tolerance, .. }) = error else { return error };
        let Some(found) = found else { return error };
        // The others have to be within it.
        let outside: Vec<(usize, f64)> = found.outliers.iter().copied().filter(|o| o.1 > tolerance).collect();
        if outside.is_empty() || options.outliers == Outliers::Drop {
            return error;
        }
        let points = outside.into_iter().map(|(i, distance)| (distinct.source[i], distance)).collect();
        Error::Fit(FitError::OutliersOutside { points, noise: found.deviation, tolerance })
    }

    /// The fit within the tolerance of points that differ. With `measured` these are points without their noise, and those
    /// are what is certified.
    fn near(distinct: &Distinct, options: &FairFitOptions, measured: Option<Measured<'_>>) -> Result<Self> {
        // What a merged point is away from the one that stands for it counts.
        let full = options.tolerance - distinct.moved;
        let best = Self::best_within(distinct, options, full, measured);
        let is_missed = matches!(best, Err(Error::Fit(FitError::ToleranceNotReached { .. })));
        let details =
            |tolerance: f64| if measured.is_none() { Self::with_details(distinct, options, tolerance) } else { None };
        let (mut fit, kept_to) = match best {
            Err(missed) => return if is_missed { details(full).ok_or(missed) } else { Err(missed) },
            Ok(best) => best,
        };
        if kept_to < full {
            fit.warnings.push(Warning::Fit(FitWarning::WideTolerance { tolerance: options.tolerance, used: kept_to }));
        }
        let mut held = None;
        if fit.swing.is_some() && options.edge_points == 0 {
            // The points alone do not hold the curve where a corner is thinner than they are dense.
            let options = FairFitOptions { edge_points: HELD_EDGE_POINTS, ..options.clone() };
            held = Self::within(distinct, &options, kept_to, measured).ok().filter(|held| held.swing.is_none());
        }
        if fit.is_left()
            && !held.as_ref().is_some_and(|held| held.is_near(kept_to))
            && let Some(details) = details(kept_to)
        {
            return Ok(details);
        }
        let Some(Swing { distance, limit, is_lost, .. }) = fit.swing else {
            return Ok(fit);
        };
        // Nothing of the figure is left there; a narrower tolerance leaves the curve no room for that.
        if is_lost && held.is_none() && measured.is_none() {
            for used in NARROW.map(|part| part * kept_to) {
                let outline = Self::outline(distinct, options, used, None);
                if outline.corners.len() * FEW_CORNERS > distinct.points.len() {
                    break;
                }
                let narrow = Self::of_outline(distinct, options, used, None, &outline).ok();
                if let Some(mut narrow) = narrow.filter(|narrow| narrow.swing.is_none()) {
                    let tolerance = options.tolerance;
                    narrow.warnings.push(Warning::Fit(FitWarning::WideTolerance { tolerance, used }));
                    return Ok(narrow);
                }
            }
        }
        let has_held = held.is_some();
        let mut fit = held.unwrap_or(fit);
        fit.warnings.push(Warning::Fit(FitWarning::SwingsOut {
            distance,
            limit,
            held: has_held,
            has_target: false,
            outliers: false,
        }));
        Ok(fit)
    }

    /// The fit that keeps corners and sides smaller than the tolerance too, where the points have them and that brings it near all
    /// edges: details of an outline may be smaller than the tolerance, its sides are not.
    fn with_details(distinct: &Distinct, options: &FairFitOptions, tolerance: f64) -> Option<Self> {
        if options.corner_angle.is_some() {
            return None;
        }
        let coarse = Self::outline(distinct, options, tolerance, None);
        let finer = FINER.into_iter().map(|part| Self::outline(distinct, options, part * tolerance, None));
        let finer = finer.filter(|finer| coarse.is_coarser(finer));
        // Of exact points all of them.
        let exact = || {
            let noise = Edged::of_exact(distinct, options, diameter(&distinct.points))?.1?.deviation;
            let lasting = OF_NOISE * noise;
            (lasting < FINER[0] * tolerance).then(|| Self::outline(distinct, options, lasting, None))
        };
        let fit = |outline: Outline| {
            let mut fit = Self::of_outline(distinct, options, tolerance, None, &outline).ok()?;
            fit.corners = outline.corners.iter().map(|corner| corner.0).collect();
            (!fit.is_left() && fit.is_near(tolerance)).then_some(fit)
        };
        finer.into_iter().find_map(fit).or_else(|| exact().and_then(fit))
    }

    /// Where it swings out, outliers that are kept may be why.
    fn pulled_by_outliers(&mut self) {
        for warning in &mut self.warnings {
            if let Warning::Fit(FitWarning::SwingsOut { outliers, .. }) = warning {
                *outliers = true;
            }
        }
    }

    /// The curve is near all edges.
    fn is_near(&self, tolerance: f64) -> bool {
        self.certificate.polyline_deviation <= NEAR * tolerance
    }

    /// The curve leaves the edges of the points, or is said to.
    fn is_left(&self) -> bool {
        let is_said = |w: &Warning| matches!(w, Warning::Fit(FitWarning::ReadAsCurve { .. }));
        self.swing.is_some() || self.warnings.iter().any(is_said)
    }

    /// The fit within a tolerance, or within less where it is wide: the fairest that keeps the shape. With what it keeps to.
    fn best_within(
        distinct: &Distinct,
        options: &FairFitOptions,
        full: f64,
        measured: Option<Measured<'_>>,
    ) -> Result<(Self, f64)> {
        let size = diameter(&distinct.points);
        let narrower = WIDE.map(|part| part * size).into_iter().filter(|t| *t < NARROWER * full);
        // Wider than the widest of these nothing is held at all; that is tried only if nothing else succeeds.
        let widest = (full <= WIDE[0] * size / NARROWER).then_some(full);
        let mut best: Option<(Self, f64)> = None;
        for tolerance in widest.into_iter().chain(narrower) {
            let found = match Self::within(distinct, options, tolerance, measured) {
                Ok(found) => found,
                // Nothing smaller than what does not suffice will do.
                Err(error) if best.is_none() && widest == Some(tolerance) => return Err(error),
                Err(_) => continue,
            };
            // Of those that lose the shape, the narrowest keeps most of it.
            let better = |other: &Self| {
                let gain = FAIRER * other.certificate.fairness - found.certificate.fairness;
                other.loses_shape() || (!found.loses_shape() && gain > NOTHING / size.powi(3))
            };
            if best.as_ref().is_none_or(|(other, _)| better(other)) {
                best = Some((found, tolerance));
            }
        }
        match best {
            Some(best) => Ok(best),
            None => Ok((Self::within(distinct, options, full, measured)?, full)),
        }
    }

    /// It swings out between the points, or bends of theirs are gone.
    fn loses_shape(&self) -> bool {
        self.swing.is_some()
            || self.warnings.iter().any(|w| matches!(w, Warning::Fit(FitWarning::ShapeSmoothedAway { .. })))
    }

    /// The corners and sides that last over a tolerance; of points without their noise those given alone.
    fn outline(
        distinct: &Distinct,
        options: &FairFitOptions,
        tolerance: f64,
        measured: Option<Measured<'_>>,
    ) -> Outline {
        let mut forced: Vec<usize> = options.corners.iter().map(|c| distinct.position(*c)).collect();
        forced.sort_unstable();
        let tolerance = if measured.is_some() { f64::INFINITY } else { tolerance };
        corners::outline(&distinct.points, &forced, options, tolerance)
    }

    /// The fit with these very options, within a tolerance.
    fn within(
        distinct: &Distinct,
        options: &FairFitOptions,
        tolerance: f64,
        measured: Option<Measured<'_>>,
    ) -> Result<Self> {
        let outline = Self::outline(distinct, options, tolerance, measured);
        Self::of_outline(distinct, options, tolerance, measured, &outline)
    }

    fn of_outline(
        distinct: &Distinct,
        options: &FairFitOptions,
        tolerance: f64,
        measured: Option<Measured<'_>>,
        outline: &Outline,
    ) -> Result<Self> {
        let data = &distinct.points;
        let straight = measured.map_or(&outline.straight[..], |measured| measured.straight);
        let on_edges = corners::places_on_edges(data, straight, options);
        let corners = &outline.corners;
        let cuts: Vec<usize> = corners.iter().map(|c| c.0).collect();

        let frame = WorkingFrame::new(data, tolerance);
        let backwards = runs_backwards(data, options.closed);
        let mut parts = Parts::new(data, tolerance, &frame, options, measured, on_edges);
        let mut pieces = runs(data.len(), options.closed, &cuts);
        if backwards {
            pieces.reverse();
        }
        for (from, to) in pieces {
            let mut numbers: Vec<usize> = (from..=to).map(|i| i % data.len()).collect();
            let whole = options.closed && cuts.is_empty();
            let numbers = if whole { &mut numbers[..data.len()] } else { &mut numbers[..] };
            if backwards {
                // Closed data keep their first point.
                numbers[usize::from(whole)..].reverse();
            }
            let ends = if backwards { [to, from] } else { [from, to] };
            let ends = ends.map(|i| options.fix_ends || cuts.binary_search(&(i % data.len())).is_ok());
            parts.add(numbers, whole, ends).map_err(|e| in_users_numbers(e, &distinct.source))?;
        }
        let mut fit = parts.finished(distinct, corners)?;
        if measured.is_none() && fit.swing.is_none() {
            let distance = fit.certificate.polyline_deviation;
            fit.warnings.extend(outline.read_as_curve(data, options.closed, tolerance, distance, false));
        }
        if backwards {
            fit.spline = fit.spline.reversed();
        }
        Ok(fit)
    }

    /// The curve.
    #[must_use]
    pub fn spline(&self) -> &CircleSpline {
        &self.spline
    }

    /// The curve alone.
    #[must_use]
    pub fn into_spline(self) -> CircleSpline {
        self.spline
    }

    /// What is proved about the curve.
    #[must_use]
    pub fn certificate(&self) -> &FairFitCertificate {
        &self.certificate
    }

    /// Corners kept, points merged, and doubts about the data.
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}

/// Index ranges between corners, ends included; those that pass the seam of a closed curve exceed its length.
fn runs(n: usize, closed: bool, corners: &[usize]) -> Vec<(usize, usize)> {
    let mut ends = corners.to_vec();
    match (closed, corners.first()) {
        (true, Some(first)) => ends.push(first + n),
        (true, None) => ends = vec![0, n],
        (false, _) => {
            ends.insert(0, 0);
            ends.push(n - 1);
        }
    }
    ends.windows(2).map(|w| (w[0], w[1])).collect()
}

fn in_users_numbers(error: Error, source: &[usize]) -> Error {
    match error {
        Error::Fit(FitError::ToleranceNotReached { points, deviation, tolerance }) => {
            Error::Fit(FitError::ToleranceNotReached {
                points: points.iter().map(|i| source[*i]).collect(),
                deviation,
                tolerance,
            })
        }
        other => other,
    }
}
