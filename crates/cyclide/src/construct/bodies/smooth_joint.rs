//! Which joints of a spine are smooth.

use crate::curve::Arc;

/// Joints that turn by less are smooth.
const SMOOTH: f64 = 1e-10;
/// Directions of an arc are known to this many roundings of its coordinates over its chord.
const ROUNDINGS: f64 = 32.0;

/// The largest turn from one arc to the next that is none: a fixed one, and what the rounding of their coordinates turns them.
pub(super) fn largest_smooth_turn(before: &Arc, behind: &Arc) -> f64 {
    SMOOTH + [before, behind].map(rounding_of_direction).into_iter().sum::<f64>()
}

/// What rounding may turn the direction of an arc at its ends.
pub(super) fn rounding_of_direction(arc: &Arc) -> f64 {
    let ends = [arc.start(), arc.end()];
    let coordinate = ends.iter().flat_map(|p| p.to_array()).fold(0.0, |most: f64, x| most.max(x.abs()));
    ROUNDINGS * f64::EPSILON * coordinate / ends[0].distance(ends[1])
}
