//! What errors of spherical cubes and volumes say.

use super::Error;
use crate::short_number::ShortNumber;

/// The sentence of an error about volumes; empty for another.
pub(super) fn of_volume(error: &Error) -> String {
    match error {
        Error::ConcircularCube { measured, limit } => format!(
            "the first corner and its three neighbours are on one circle, so that the eighth corner is not determined: the triangle of \
             the neighbours, inverted at the first corner, has the area {}, limit {}",
            ShortNumber(*measured),
            ShortNumber(*limit)
        ),
        Error::CrossingFace { axis, at, speed, limit } => {
            let [name, first, second] = parameters(*axis);
            format!(
                "two faces cross themselves: their common side along {name} at {first} = {}, {second} = {} runs backwards (speed {}, \
                 limit {}); move the corners nearer to those of a box",
                ShortNumber(at[0]),
                ShortNumber(at[1]),
                ShortNumber(*speed),
                ShortNumber(*limit)
            )
        }
        Error::VolumeThroughInfinity { at: [s, t, u] } => format!(
            "the volume passes through infinity near s = {}, t = {}, u = {}: its sides are arcs of nearly whole circles there",
            ShortNumber(*s),
            ShortNumber(*t),
            ShortNumber(*u)
        ),
        Error::FoldedVolume { at: [s, t, u] } => format!(
            "lines run backwards near s = {}, t = {}, u = {}: what folds bounds no solid; take a frame nearer to the sides, or none",
            ShortNumber(*s),
            ShortNumber(*t),
            ShortNumber(*u)
        ),
        Error::InBlock { block, cause } => format!("block {block}: {cause}"),
        Error::InFaceOfVolume { axis, end, cause } => format!("the face at {} = {end}: {cause}", parameters(*axis)[0]),
        _ => String::new(),
    }
}

/// The parameter of a direction, and the other two in order.
const fn parameters(axis: usize) -> [char; 3] {
    match axis {
        0 => ['s', 't', 'u'],
        1 => ['t', 's', 'u'],
        _ => ['u', 's', 't'],
    }
}
