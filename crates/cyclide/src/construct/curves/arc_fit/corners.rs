//! Which vertices stay corners (`docs/math/arc-fitting.md#corners`).

use super::options::{ArcFitOptions, FitTarget};
use crate::base::vector::Point3;
use crate::construct::curves::outline::{CORNER_ANGLE, Outline, Scattered};

/// A corner stands out if its turn is this many times those of its neighbors.
const PROMINENCE: f64 = 3.0;
/// A turn above this is a reversal: no smooth curve turns so far from one sample to the next.
const CUSP_ANGLE: f64 = 150.0 * std::f64::consts::PI / 180.0;

/// Turn at every vertex, radians in `[0, pi]`; 0 at the ends of an open polyline. Neighboring points differ.
pub(super) fn turns(points: &[Point3], closed: bool) -> Vec<f64> {
    let n = points.len();
    let turn = |i: usize| {
        if !closed && (i == 0 || i == n - 1) {
            return 0.0;
        }
        let (before, at, after) = (points[(i + n - 1) % n], points[i], points[(i + 1) % n]);
        (at - before).angle(after - at)
    };
    (0..n).map(turn).collect()
}

/// Sagitta of the edges at the vertex that stands at `fraction` of all vertices by that measure, were the points
/// samples of something smooth: `h² kappa/8` with `h kappa` the turn; 0 if there is no turn at all.
pub(in crate::construct) fn sagitta_quantile(points: &[Point3], closed: bool, fraction: f64) -> f64 {
    let mut sagittas: Vec<f64> = sagittas(points, closed).map(|(_, sagitta)| sagitta).collect();
    sagittas.sort_by(f64::total_cmp);
    sagittas.get((sagittas.len() as f64 * fraction) as usize).copied().unwrap_or(0.0)
}

/// The vertices that have a sagitta, with it.
pub(super) fn sagittas(points: &[Point3], closed: bool) -> impl Iterator<Item = (usize, f64)> {
    let n = points.len();
    let turns = turns(points, closed);
    let sagitta = move |i: usize| {
        let (before, after) = (points[(i + n - 1) % n], points[(i + 1) % n]);
        (i, turns[i] * (points[i].distance(before) + points[i].distance(after)) / 16.0)
    };
    if closed { 0..n } else { 1..n - 1 }.map(sagitta)
}

/// How far from a vertex of the given turn an arc that stays within the tolerance of both legs can begin: the arc
/// of radius `tolerance cot²(turn/4)` is `2 tolerance cot(turn/4)` away.
pub(super) fn rounding_reach(turn: f64, tolerance: f64) -> f64 {
    2.0 * tolerance / (0.25 * turn).tan()
}

/// The reading of the points for a fit: corners by the angle that is given, else by the rule of the target. Edges that are
/// meant themselves need no reading. Noise may have moved the points by `noise`.
pub(super) fn outline(
    points: &[Point3],
    forced: &[usize],
    options: &ArcFitOptions,
    noise: f64,
    scattered: Scattered,
) -> Outline {
    let mut outline = Outline::read(points, options.closed, noise, options.corner_angle, forced, scattered);
    if options.target == FitTarget::Polyline {
        if options.corner_angle.is_none() {
            outline.corners = corners(points, forced, options);
        }
        outline.straight.fill(false);
        outline.bound.fill(false);
    }
    outline
}

/// Corners in ascending order, with their turn. The ends of an open polyline are none.
///
/// Asked for by index (ascending); or reversals; or turns above the angle limit that stand out from their neighbors. Edges that
/// are meant themselves (`Polyline`) also keep a corner whose rounding would be lost in its long legs.
pub(in crate::construct) fn corners(points: &[Point3], forced: &[usize], options: &ArcFitOptions) -> Vec<(usize, f64)> {
    let (n, closed) = (points.len(), options.closed);
    let angle = options.corner_angle.unwrap_or(CORNER_ANGLE);
    let turns = turns(points, closed);
    let stands_out = |i: usize| {
        let (before, after) = ((i + n - 1) % n, (i + 1) % n);
        let prominent = turns[i] > PROMINENCE * turns[before].max(turns[after]);
        let leg = points[i].distance(points[before]).min(points[i].distance(points[after]));
        let lost = options.target == FitTarget::Polyline && rounding_reach(turns[i], options.tolerance) < 0.5 * leg;
        prominent || lost
    };
    let is_corner =
        |i: usize| forced.binary_search(&i).is_ok() || turns[i] > CUSP_ANGLE || (turns[i] > angle && stands_out(i));
    let range = if closed { 0..n } else { 1..n - 1 };
    range.filter(|i| is_corner(*i)).map(|i| (i, turns[i])).collect()
}
