//! Warnings about data that do not suit the tolerance or the target (`docs/math/arc-fitting.md#limits`).

use super::certificate::farthest_over_edge;
use super::corners::{sagitta_quantile, sagittas};
use super::options::{ArcFitOptions, FitTarget};
use super::piece::Piece;
use super::trace::Trace;
use crate::base::bounds::Aabb;
use crate::base::vector::Point3;
use crate::construct::curves::outline::{Outline, SAMPLE_SAGITTA};
use crate::warning::{FitWarning, NoiseWarning, Warning};

/// An arc over two vertices may leave their edge by this many tolerances, one to each side.
const SAGITTA_LIMIT: f64 = 2.0;
/// A curve through samples leaves their edges by the sagittas; by this many times the largest one and the tolerance it
/// turns where the points do not.
const SWING: f64 = 2.0;
/// Tolerances above this part of the diagonal of the figure's box are wide: a sixth of a square's side.
const WIDE: f64 = 0.12;
/// Spans of at most this many edges follow single points.
const SHORT_SPAN: usize = 2;
/// The fraction of short, alternating spans above which the fit follows the noise.
const NOISE_FRACTION: f64 = 0.5;
/// Fewer arcs than this say nothing about noise.
const MIN_ARCS: usize = 8;

/// What was fitted: how far it is from the polyline, and whether it lies in a plane.
pub(super) struct Fitted<'a> {
    pub pieces: &'a [Piece],
    pub trace: &'a Trace,
    pub distance: f64,
    pub is_planar: bool,
}

impl Fitted<'_> {
    /// All doubts, in the order in which they are told.
    pub fn doubts(&self, data: &[Point3], outline: &Outline, options: &ArcFitOptions) -> Vec<Warning> {
        let Self { pieces, trace, distance, is_planar } = *self;
        let swing = swing(data, &outline.corners, options, distance)
            .or_else(|| swing_over_edge(pieces, trace, options, is_planar))
            .or_else(|| {
                let is_read = options.target == FitTarget::Points;
                let curve = || outline.read_as_curve(data, options.closed, options.tolerance, distance, true);
                is_read.then(curve).flatten()
            });
        let others = [noise(pieces, trace, options.target), wide(data, options.tolerance)];
        coarse_samples(data, options).into_iter().chain(swing).chain(others.into_iter().flatten()).collect()
    }
}

/// The edges are meant, but their sagittas say that the points are samples of something smooth.
fn coarse_samples(points: &[Point3], options: &ArcFitOptions) -> Option<Warning> {
    if options.target != FitTarget::Polyline {
        return None;
    }
    let sagitta = sagitta_quantile(points, options.closed, 0.5);
    let limit = SAGITTA_LIMIT * options.tolerance;
    (sagitta > limit).then_some(Warning::Fit(FitWarning::SamplesTooCoarse { sagitta, limit }))
}

/// Points are meant, and between them the curve is farther from their polyline than their turns explain.
fn swing(points: &[Point3], corners: &[(usize, f64)], options: &ArcFitOptions, distance: f64) -> Option<Warning> {
    if options.target != FitTarget::Points {
        return None;
    }
    let is_corner = |i: usize| corners.binary_search_by_key(&i, |corner| corner.0).is_ok();
    let smooth = sagittas(points, options.closed).filter(|(i, _)| !is_corner(*i));
    let limit = SWING * (options.tolerance + smooth.map(|(_, sagitta)| sagitta).fold(0.0, f64::max));
    (distance > limit).then_some(Warning::Fit(FitWarning::SwingsOut {
        distance,
        limit,
        held: false,
        has_target: true,
        outliers: false,
    }))
}

/// The same edge by edge: no smooth curve leaves an edge by more than a part of its length.
fn swing_over_edge(pieces: &[Piece], trace: &Trace, options: &ArcFitOptions, planar: bool) -> Option<Warning> {
    if options.target != FitTarget::Points {
        return None;
    }
    let allowed = |edge: f64| options.tolerance + SAMPLE_SAGITTA * edge;
    let (distance, limit) = farthest_over_edge(pieces, trace, planar, allowed)?;
    Some(Warning::Fit(FitWarning::SwingsOut { distance, limit, held: false, has_target: true, outliers: false }))
}

/// A tolerance of the size of the figure's own bends keeps no shape.
fn wide(points: &[Point3], tolerance: f64) -> Option<Warning> {
    let size = Aabb::of_points(points.iter().copied()).map_or(0.0, Aabb::diagonal);
    (tolerance > WIDE * size).then_some(Warning::Fit(FitWarning::WideTolerance { tolerance, used: tolerance }))
}

/// Most arcs stand for one or two edges and turn the other way than their neighbor: they follow noise.
fn noise(pieces: &[Piece], trace: &Trace, target: FitTarget) -> Option<Warning> {
    // Edges that are meant themselves may well turn to and fro.
    if pieces.len() < MIN_ARCS || target == FitTarget::Polyline {
        return None;
    }
    let n = trace.points.len();
    let edges = |p: &Piece| 1 + p.span.inside().filter(|i| trace.vertex[i % n].is_some()).count();
    let follows = |i: &usize| {
        let (this, next) = (&pieces[*i], &pieces[(i + 1) % pieces.len()]);
        edges(this) <= SHORT_SPAN && this.arc.bulge_vector().dot(next.arc.bulge_vector()) < 0.0
    };
    let fraction = (0..pieces.len()).filter(follows).count() as f64 / pieces.len() as f64;
    (fraction > NOISE_FRACTION).then_some(Warning::Noise(NoiseWarning::ToleranceBelowNoise { fraction }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::warning::FitWarning;

    #[test]
    fn a_curve_far_from_edges_that_hardly_turn_swings_out() {
        // Edges of 1 that turn by 0.1, sagitta 1/80, and a corner that does not count.
        let mut points = vec![Point3::ORIGIN];
        for i in 0..20 {
            let (s, c) = (0.1 * f64::from(i) + if i < 10 { 0.0 } else { 1.5 }).sin_cos();
            points.push(Point3::new(points[i as usize].x + c, points[i as usize].y + s, 0.0));
        }
        let options = ArcFitOptions::new(0.001);
        let said = |distance: f64| swing(&points, &[(10, 1.6)], &options, distance);
        assert_eq!(said(0.026), None);
        let Some(Warning::Fit(FitWarning::SwingsOut {
            distance,
            limit,
            held: false,
            has_target: true,
            outliers: false,
        })) = said(0.03)
        else {
            panic!("nothing said")
        };
        assert!((distance - 0.03).abs() < 1e-15 && (limit - 2.0 * (0.001 + 0.0125)).abs() < 1e-9, "{limit}");
        // Without the corner its turn explains much.
        assert_eq!(swing(&points, &[], &options, 0.3), None);
    }
}
