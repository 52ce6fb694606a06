//! The fit that keeps the shape: where a curve swings out, loops or leaves the edges, it is held there, kept to a narrower
//! tolerance, or to corners and sides that are smaller than the tolerance.

use super::doubts::Swing;
use super::edged::Edged;
use super::measured::{Measured, OF_NOISE};
use super::{FairFit, FairFitOptions};
use crate::construct::curves::arc_fit::input::{Distinct, diameter};
use crate::construct::curves::outline::{FINER, NEAR, Outline};
use crate::error::{Error, FitError, Result};
use crate::warning::{FitWarning, Warning};

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

/// A narrower one is taken for a variation below this part, if that is any: `J` times the cubed size of the data.
const FAIRER: f64 = 0.9;
const NOTHING: f64 = 1e-9;

impl FairFit {
    /// The fit within the tolerance of points that differ. With `measured` these are points without their noise, and those
    /// are what is certified.
    pub(super) fn near(distinct: &Distinct, options: &FairFitOptions, measured: Option<Measured<'_>>) -> Result<Self> {
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
}
