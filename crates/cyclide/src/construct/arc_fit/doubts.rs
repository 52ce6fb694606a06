//! Warnings about data that do not suit the tolerance or the target (`60`, sections 3 and 4).

use super::certificate::Span;
use super::corners::sagitta_quantile;
use super::options::{ArcFitOptions, FitTarget};
use super::trace::Trace;
use crate::base::vector::Point3;
use crate::curve::ArcPath;
use crate::warning::Warning;

/// An arc over two vertices may leave their edge by this many tolerances, one to each side.
const SAGITTA_LIMIT: f64 = 2.0;
/// Spans of at most this many edges follow single points.
const SHORT_SPAN: usize = 2;
/// The fraction of short, alternating spans above which the fit follows the noise.
const NOISE_FRACTION: f64 = 0.5;
/// Fewer arcs than this say nothing about noise.
const MIN_ARCS: usize = 8;

/// The edges are meant, but their sagittas say that the points are samples of something smooth.
pub(super) fn coarse_samples(points: &[Point3], options: &ArcFitOptions) -> Option<Warning> {
    if options.target != FitTarget::Polyline {
        return None;
    }
    let sagitta = sagitta_quantile(points, options.closed, 0.5);
    let limit = SAGITTA_LIMIT * options.tolerance;
    (sagitta > limit).then_some(Warning::SamplesTooCoarse { sagitta, limit })
}

/// Most arcs stand for one or two edges and turn the other way than their neighbour: they follow noise.
pub(super) fn noise(path: &ArcPath, spans: &[Span], trace: &Trace, target: FitTarget) -> Option<Warning> {
    let arcs = path.arcs();
    // Edges that are meant themselves may well turn to and fro.
    if arcs.len() < MIN_ARCS || target == FitTarget::Polyline {
        return None;
    }
    let n = trace.points.len();
    let edges = |s: &Span| (s.from + 1..=s.to).filter(|i| trace.vertex[i % n].is_some()).count();
    let follows = |i: &usize| {
        let next = (i + 1) % arcs.len();
        edges(&spans[*i]) <= SHORT_SPAN && arcs[*i].bulge_vector().dot(arcs[next].bulge_vector()) < 0.0
    };
    let fraction = (0..arcs.len()).filter(follows).count() as f64 / arcs.len() as f64;
    (fraction > NOISE_FRACTION).then_some(Warning::ToleranceBelowNoise { fraction })
}
