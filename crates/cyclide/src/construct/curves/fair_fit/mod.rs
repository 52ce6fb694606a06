//! Fair fits: the fairest fair spline within a tolerance of given points, with few nodes and a proof sheet
//! (`docs/math/fair-fits.md`).
//!
//! The nodes are unknown, few, and no data points. For a fixed number of them
//!
//! ```text
//! J = sum d |V|² ~ int k'² ds,    V the derivative of curvature of a segment, d its chord
//! ```
//! is minimized while every point stays within the tolerance of the curve: a sequence of convex problems in the
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
mod dense_corners;
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
mod shape;
mod sides;
mod spline_basis;
mod tube_curve;
mod whittaker;
mod working_frame;

pub use options::{FairFitOptions, Heights, Noise, Outliers};

use crate::base::range;
use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::input::{Distinct, diameter};
use crate::construct::curves::canonical_start::runs_backwards;
use crate::construct::curves::outline::Outline;
use crate::curve::CircleSpline;
use crate::error::{Error, FitError, Result};
use crate::warning::{FitWarning, NoiseWarning, Warning};
use doubts::{LOST, Swing};
use edged::Edged;
use measured::{Measured, Prepared, outliers_named, prepared, read, with_loose_heights, without_outliers};
use noise::Denoised;
use parts::Parts;
use working_frame::WorkingFrame;

/// A tolerance up to this many standard deviations is there for the noise,
const OF_THE_ORDER: f64 = 8.0;
/// and a root mean square of the distances above this many is more than that; below this part of the tolerance it is not
/// looked at.
const MORE_THAN_NOISE: f64 = 1.1;
const LEAST_OF_TOLERANCE: f64 = 0.125;
/// There the points pull this many times as much, so often.
const STRONGER: f64 = 10.0;
const MOST_STRONGER: usize = 4;

/// A fair spline within a tolerance of points, with its certificate.
///
/// ```
/// use cyclide::{Point3, construct::{FairFit, FairFitOptions}};
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
    /// The largest distance that two points next to each other both have from it, and the first of them.
    beside: (f64, usize),
    /// Where corners smaller than the tolerance are kept: the positions of all among the distinct points, rising.
    corners: Vec<usize>,
}

/// What is proved about a fair fit, and how fair it is.
///
/// ```
/// use cyclide::{Point3, construct::{FairFit, FairFitOptions}};
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
    /// the edge; or, if that is less, twice the tolerance and 3/8 of the edge and the turn at its ends) swings out: nothing holds it there. It is fitted again with places on the edges, and a warning (`swings-out`)
    /// says so.
    ///
    /// ```
    /// use cyclide::{Point3, construct::{FairFit, FairFitOptions}};
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
                let sharp = Edged::in_noise(&distinct, &options, diameter(&distinct.points)).ok()?;
                Some(sharp.of_own(&distinct))
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

    /// Where it swings out, outliers that are kept may be why.
    fn pulled_by_outliers(&mut self) {
        for warning in &mut self.warnings {
            if let Warning::Fit(FitWarning::SwingsOut { outliers, .. }) = warning {
                *outliers = true;
            }
        }
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
