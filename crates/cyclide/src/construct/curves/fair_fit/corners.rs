//! Which points a fair fit keeps as corners (`docs/math/fair-fits.md#nodes`): those asked for, and with a corner angle
//! those of the rule of arc fits (`docs/math/arc-fitting.md#corners`) that are corners at the scale of the tolerance
//! too, and no bends. Without the second condition every dense noisy line would have corners.

use super::options::FairFitOptions;
use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::corners::corners as standing_out;
use crate::construct::curves::arc_fit::{ArcFitOptions, FitTarget};

/// Legs of a corner, in tolerances: points in the tolerance of a smooth curve turn its direction by less than a quarter
/// of a radian over them.
const LEGS: f64 = 8.0;
/// With legs half as long a corner keeps this part of its turn; a circle keeps half.
const SHARP: f64 = 0.75;

/// Corners in ascending order, with their turn. The ends of an open polyline are none.
///
/// `forced` are asked for by index, ascending.
pub(super) fn corners(points: &[Point3], forced: &[usize], options: &FairFitOptions) -> Vec<(usize, f64)> {
    let rule = ArcFitOptions {
        closed: options.closed,
        corner_angle: Some(options.corner_angle.unwrap_or(std::f64::consts::PI)),
        target: if options.edge_points > 0 { FitTarget::Polyline } else { FitTarget::Points },
        ..ArcFitOptions::new(options.tolerance)
    };
    let turn = |i: usize, length: f64| {
        let [before, after] = [false, true].map(|forward| leg(points, i, length, options.closed, forward));
        before.zip(after).map_or(0.0, |(before, after)| (points[i] - before).angle(after - points[i]))
    };
    let length = LEGS * options.tolerance;
    // The turn of a bend grows with the legs, that of a corner does not.
    let lasting = |i: usize| {
        let long = turn(i, length);
        options.corner_angle.is_some_and(|angle| long > angle) && turn(i, 0.5 * length) > SHARP * long
    };
    let found = standing_out(points, forced, &rule);
    found.into_iter().filter(|(i, _)| forced.binary_search(i).is_ok() || lasting(*i)).collect()
}

/// The nearest point along the polyline that is a leg's length away; without one, the last on that side.
fn leg(points: &[Point3], corner: usize, length: f64, closed: bool, forward: bool) -> Option<Point3> {
    let n = points.len();
    let far = |p: &Point3| p.distance(points[corner]) >= length;
    let steps = match (closed, forward) {
        (true, _) => n / 2,
        (false, true) => n - 1 - corner,
        (false, false) => corner,
    };
    let at = |k: usize| points[if forward { corner + k } else { corner + n - k } % n];
    (1..=steps).map(at).find(far).or_else(|| (steps > 0).then(|| at(steps)))
}
