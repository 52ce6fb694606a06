//! Rational volumes of a file against the blocks that they stand for.

use crate::check::bodies::FileVolume;
use crate::check::deviation::larger;
use crate::check::read_error::ReadError;
use cyclide::volume::{CyclideVolume, ParamVolume as _};
use std::collections::HashMap;

/// Places per parameter at which volumes are compared.
const PLACES: u32 = 5;

/// A part of a block: the ranges of its three parameters.
pub(crate) type VolumePart = [[f64; 2]; 3];

/// The largest distance at equal parameters between the hexahedra read, from `first` on, and the parts of a block that they stand for, which have to be
/// all of it.
///
/// # Errors
/// [`ReadError::Volume`].
pub(crate) fn volume_deviation(
    block: &CyclideVolume,
    parts: &[VolumePart],
    read: &[FileVolume],
    first: usize,
) -> Result<f64, ReadError> {
    let wrong = |detail| ReadError::Volume { volume: first, detail };
    if parts.len() != read.len() {
        return Err(wrong("the number of parts of its block differs"));
    }
    let mut deviation = 0.0;
    for (part, found) in parts.iter().zip(read) {
        let at = |i: u32| f64::from(i) / f64::from(PLACES - 1);
        for k in 0..PLACES.pow(3) {
            let own = [at(k % PLACES), at(k / PLACES % PLACES), at(k / PLACES / PLACES)];
            let place = std::array::from_fn(|axis| part[axis][0] + (part[axis][1] - part[axis][0]) * own[axis]);
            deviation = larger(deviation, found.volume.point(own).distance(block.point(place)));
        }
    }
    if tile(parts) { Ok(deviation) } else { Err(wrong("its parts do not cover its block once")) }
}

/// True if each place of the block is in one part. With a sign for each corner of a box, how many boxes there are at a place is the sum of the corners
/// below it: so the corners of all parts and those of the block cancel each other if and only if there is one part everywhere.
fn tile(parts: &[VolumePart]) -> bool {
    let block = [[0.0, 1.0]; 3];
    let mut corners: HashMap<[u64; 3], i32> = HashMap::new();
    for (part, sign) in parts.iter().map(|part| (part, 1)).chain([(&block, -1)]) {
        if !part.iter().all(|[a, b]| 0.0 <= *a && a < b && *b <= 1.0) {
            return false;
        }
        for corner in 0..8_usize {
            // A zero has one sign: parameters that are equal have the same bits.
            let place = std::array::from_fn(|axis| (part[axis][corner >> axis & 1] + 0.0).to_bits());
            *corners.entry(place).or_default() += if corner.count_ones() % 2 == 0 { sign } else { -sign };
        }
    }
    corners.values().all(|sum| *sum == 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_the_block_each_once() {
        let range = [[0.0, 0.3], [0.3, 1.0]];
        let octants: Vec<VolumePart> = (0..8_usize).map(|k| [range[k & 1], range[k >> 1 & 1], range[k >> 2]]).collect();
        assert!(tile(&octants) && tile(&[[[0.0, 1.0]; 3]]));
        // One of them in halves, beside neighbors that are whole.
        let [s, t, u] = octants[5];
        let halves = [[[s[0], 0.6], t, u], [[0.6, s[1]], t, u]];
        let with = |other: &[VolumePart]| [&octants[..5], &octants[6..], other].concat();
        assert!(tile(&with(&halves)));
        assert!(!tile(&with(&halves[..1])) && !tile(&with(&[halves[0]; 2])) && !tile(&with(&[])));
        assert!(!tile(&with(&[octants[5], halves[0]])) && !tile(&with(&[octants[4]])));
        assert!(!tile(&[[[0.0, 1.5], [0.0, 1.0], [0.0, 1.0]]]) && !tile(&[]));
    }
}
