//! Rational volumes of a file against the blocks that they stand for.

use crate::check::bodies::FileVolume;
use crate::check::deviation::larger;
use crate::check::file_content::ReadError;
use cyclide::{CyclideVolume, ParamVolume as _};

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
        return Err(wrong("its block has another number of parts"));
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
    // Parts are halves of halves: their sizes are exact, and those that overlap leave others out.
    let size = |part: &VolumePart| part.iter().map(|[a, b]| b - a).product::<f64>();
    let apart =
        |p: &VolumePart, q: &VolumePart| (0..3).any(|axis| p[axis][1] <= q[axis][0] || q[axis][1] <= p[axis][0]);
    let disjoint = parts.iter().enumerate().all(|(k, p)| parts[..k].iter().all(|q| apart(p, q)));
    let whole = parts.iter().map(size).sum::<f64>();
    if disjoint && whole >= 1.0 && whole <= 1.0 {
        Ok(deviation)
    } else {
        Err(wrong("its parts are not its block, each once"))
    }
}
