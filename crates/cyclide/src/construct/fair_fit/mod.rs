//! Fair fits: the fairest fair spline within a tolerance of given points, with few nodes and a proof sheet (`66`).
//!
//! The nodes are unknown, few, and no data points. For a fixed number of them
//!
//! ```text
//! J = sum d |V|² ~ int k'² ds,    V the derivative of curvature of a segment (65, (4)), d its chord         (66, (1))
//! ```
//! is minimised while every point stays within the tolerance of the curve: a sequence of convex problems in the
//! displacements of the nodes, each solved by an interior point method with banded matrices; after each the exact spline
//! and the exact feet are found again. Then nodes are taken out in batches while `J` stays near the fairest seen. The
//! choice of nodes is greedy and the tube is not convex in the curve: nothing proves that `J` or the number of nodes is
//! the least. The certificate is proved.
//!
//! One subject per file: start, density, linear model, interior point, one fit, removal, the run of a smooth piece, the
//! frame it works in, certificate.

mod bordered_band;
mod certificate;
mod corners;
mod density;
mod feet;
mod fit;
mod interior_point;
mod linear_model;
mod options;
mod places;
mod removal;
mod run;
mod spline_basis;
mod tube_curve;
mod whittaker;
mod working_frame;

pub use options::FairFitOptions;

use crate::base::range;
use crate::base::vector::Point3;
use crate::construct::arc_fit::corners::sagitta_quantile;
use crate::construct::arc_fit::input::Distinct;
use crate::curve::{BlendSegment, CircleSpline};
use crate::error::{Error, Result};
use crate::rational::RationalBezier;
use crate::warning::Warning;
use certificate::{PieceSheet, certify};
use removal::RemovalLimits;
use run::{Outcome, Piece, run};
use working_frame::WorkingFrame;

/// Above this part of the tolerance the root mean square of the distances says that the curve leans on its bounds.
const LEANING: f64 = 0.55;
/// More nodes than this part of the points follow their noise.
const NOISY: f64 = 1.0 / 3.0;
/// Places on each edge that hold a curve which swings out between its points.
const HELD_EDGE_POINTS: usize = 3;
/// Fewer points than this say nothing about noise.
const FEW_POINTS: usize = 24;

/// A fair spline within a tolerance of points, with its certificate.
#[derive(Debug, Clone, PartialEq)]
pub struct FairFit {
    spline: CircleSpline,
    certificate: FairFitCertificate,
    warnings: Vec<Warning>,
    /// How far the curve is from the polyline, and the limit, where it swings out between points.
    swing: Option<(f64, f64)>,
}

/// What is proved about a fair fit, and how fair it is.
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
    /// A curve that leaves its polyline by more than half the longest edge and the tolerance swings out: where a corner is
    /// thinner than its points are dense, nothing holds it. It is fitted again with places on the edges, and a warning
    /// (`swings-out`) says so.
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
    /// `not-finite`, `coincident-points` (all points equal), `tolerance-not-reached` with the points that stay outside.
    pub fn new(points: &[Point3], options: &FairFitOptions) -> Result<Self> {
        let fit = Self::of_points(points, options)?;
        let Some((distance, limit)) = fit.swing else {
            return Ok(fit);
        };
        // The points alone do not hold the curve where a corner is thinner than they are dense.
        let held = FairFitOptions { edge_points: HELD_EDGE_POINTS, ..options.clone() };
        let held = if options.edge_points == 0 { Self::of_points(points, &held).ok() } else { None };
        let (mut fit, held) = match held {
            Some(held) if held.swing.is_none() => (held, true),
            _ => (fit, false),
        };
        fit.warnings.push(Warning::SwingsOut { distance, limit, held });
        Ok(fit)
    }

    /// The fit with these very options.
    fn of_points(points: &[Point3], options: &FairFitOptions) -> Result<Self> {
        options.check(points.len())?;
        for (index, p) in points.iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        let distinct = Distinct::new(points, options.closed)?;
        let data = &distinct.points;
        let mut forced: Vec<usize> = options.corners.iter().map(|c| distinct.position(*c)).collect();
        forced.sort_unstable();
        let corners = corners::corners(data, &forced, options);
        let cuts: Vec<usize> = corners.iter().map(|c| c.0).collect();

        let mut parts = Parts { spline: Vec::new(), kinks: Vec::new(), sheets: Vec::new(), fairness: 0.0 };
        let frame = WorkingFrame::new(data, options.tolerance);
        for (from, to) in runs(data.len(), options.closed, &cuts) {
            let numbers: Vec<usize> = (from..=to).map(|i| i % data.len()).collect();
            let whole = options.closed && cuts.is_empty();
            let numbers = if whole { &numbers[..data.len()] } else { &numbers[..] };
            let ends = [from, to].map(|i| options.fix_ends || cuts.binary_search(&(i % data.len())).is_ok());
            parts
                .add(data, numbers, whole, ends, &frame, options)
                .map_err(|e| in_users_numbers(e, &distinct.source))?;
        }
        parts.finished(&distinct, &corners, options)
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
        Error::ToleranceNotReached { points, deviation, tolerance } => {
            Error::ToleranceNotReached { points: points.iter().map(|i| source[*i]).collect(), deviation, tolerance }
        }
        other => other,
    }
}

/// The smooth pieces of a fit so far.
struct Parts {
    spline: Vec<BlendSegment>,
    kinks: Vec<usize>,
    /// Per piece, with the number of each of its points among the distinct ones.
    sheets: Vec<(PieceSheet, Vec<usize>)>,
    fairness: f64,
}

impl Parts {
    /// Fits one smooth piece: the points with these numbers, closed or with ends that may be fixed.
    fn add(
        &mut self,
        data: &[Point3],
        numbers: &[usize],
        closed: bool,
        fixed: [bool; 2],
        frame: &WorkingFrame,
        options: &FairFitOptions,
    ) -> Result<()> {
        let points: Vec<Point3> = numbers.iter().map(|i| data[*i]).collect();
        let (bound, stride) = with_edge_points(&points, closed, options.edge_points);
        let local: Vec<Point3> = bound.iter().map(|p| frame.to_local(*p)).collect();
        let piece = Piece {
            points: &local,
            closed,
            planar: frame.planar(),
            fixed: if closed { [false; 2] } else { fixed },
            tolerance: frame.length(options.tolerance),
            centre: options.centre,
        };
        let limits =
            RemovalLimits { fits: options.max_fits, nodes: options.nodes.unwrap_or(0), budget: options.budget };
        let fit = match run(&piece, &limits) {
            Outcome::Reached(fit) => fit,
            Outcome::Missed { outside, farthest } => {
                let mut points: Vec<usize> = outside.iter().map(|i| numbers[i / stride]).collect();
                points.dedup();
                let deviation = farthest / frame.length(1.0);
                return Err(Error::ToleranceNotReached { points, deviation, tolerance: options.tolerance });
            }
        };
        let nodes = &fit.curve.nodes;
        let ends = [(0, 0), (nodes.len() - 1, points.len() - 1)];
        let mut world: Vec<Point3> = nodes.iter().map(|x| frame.to_world(*x)).collect();
        for (fixed, (node, point)) in piece.fixed.into_iter().zip(ends) {
            if fixed {
                world[node] = points[point];
            }
        }
        let tangents: Vec<_> = fit.curve.tangents.iter().map(|t| frame.direction_to_world(*t)).collect();
        if !self.spline.is_empty() || (options.closed && !closed) {
            self.kinks.push(self.spline.len());
        }
        let first = self.spline.len();
        for i in 0..fit.curve.segments.len() {
            let j = (i + 1) % nodes.len();
            self.spline.push(BlendSegment::fair(world[i], tangents[i], world[j], tangents[j], 1.0)?);
        }
        let feet: Vec<f64> = fit.feet.iter().step_by(stride).map(|f| f.place.position()).collect();
        let quartics: Vec<RationalBezier> = self.spline[first..].iter().filter_map(BlendSegment::to_bezier).collect();
        self.fairness += fit.fairness * frame.length(1.0).powi(3);
        self.sheets.push((certify(&quartics, closed, &points, &feet), numbers.to_vec()));
        Ok(())
    }

    /// The whole curve with its certificate and warnings.
    fn finished(self, distinct: &Distinct, corners: &[(usize, f64)], options: &FairFitOptions) -> Result<FairFit> {
        let (tolerance, source, count) = (options.tolerance, &distinct.source, distinct.points.len());
        let mut sheet = FairFitCertificate {
            deviation: 0.0,
            rms: 0.0,
            polyline_deviation: 0.0,
            monotone: true,
            worst: 0,
            nodes: self.spline.len() + usize::from(!options.closed),
            fairness: self.fairness,
        };
        let (mut squares, mut back) = (0.0, None);
        for (piece, numbers) in &self.sheets {
            if piece.vertex.0 > sheet.deviation {
                sheet.deviation = piece.vertex.0;
                sheet.worst = source[numbers[piece.vertex.1]];
            }
            squares += piece.squares;
            sheet.polyline_deviation = sheet.polyline_deviation.max(piece.polyline);
            if let Some((point, times)) = piece.back {
                let (first, sum) = back.unwrap_or((source[numbers[point]], 0));
                back = Some((first, sum + times));
            }
        }
        sheet.rms = (squares / count as f64).sqrt();
        sheet.monotone = back.is_none();
        if sheet.deviation > tolerance {
            // Only the rounding of coordinates far larger than the tolerance can do that.
            let points = vec![sheet.worst];
            return Err(Error::ToleranceNotReached { points, deviation: sheet.deviation, tolerance });
        }
        let kept = |(i, angle): &(usize, f64)| Warning::CornerKept { vertex: source[*i], angle: *angle };
        let mut warnings: Vec<Warning> = distinct.warning.clone().into_iter().collect();
        warnings.extend(corners.iter().map(kept));
        if let Some((point, count)) = back {
            warnings.push(Warning::FeetNotMonotone { point, count });
        }
        if options.edge_points > 0 {
            let sagitta = sagitta_quantile(&distinct.points, options.closed, 0.5);
            if sagitta > tolerance {
                warnings.push(Warning::SamplesTooCoarse { sagitta, limit: tolerance });
            }
        }
        if count >= FEW_POINTS && sheet.nodes as f64 > NOISY * count as f64 {
            warnings.push(Warning::NodesFollowNoise { nodes: sheet.nodes, points: count });
        }
        if options.centre == 0.0 && sheet.rms > LEANING * tolerance {
            warnings.push(Warning::LeansOnWalls { rms: sheet.rms, limit: LEANING * tolerance });
        }
        let limit = tolerance + 0.5 * longest_edge(&distinct.points, options.closed);
        let swing = (sheet.polyline_deviation > limit).then_some((sheet.polyline_deviation, limit));
        let spline = CircleSpline::from_segments(self.spline, options.closed, self.kinks, Vec::new());
        Ok(FairFit { spline, certificate: sheet, warnings, swing })
    }
}

/// The longest edge of the polyline: a curve that is farther from it than half of this turns by more than half a circle
/// over an edge, and so holds to nothing that was given.
fn longest_edge(points: &[Point3], closed: bool) -> f64 {
    let last = points.last().zip(points.first()).filter(|_| closed).map(|(a, b)| a.distance(*b));
    points.windows(2).map(|w| w[0].distance(w[1])).chain(last).fold(0.0, f64::max)
}

/// The points with places on the edges between them, and how many of these there are to a point.
fn with_edge_points(points: &[Point3], closed: bool, on_edge: usize) -> (Vec<Point3>, usize) {
    let (n, stride) = (points.len(), on_edge + 1);
    let mut all = Vec::with_capacity(n * stride);
    for (i, p) in points.iter().enumerate() {
        all.push(*p);
        if closed || i + 1 < n {
            let next = points[(i + 1) % n];
            all.extend((1..stride).map(|k| p.lerp(next, k as f64 / stride as f64)));
        }
    }
    (all, stride)
}
