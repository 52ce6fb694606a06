//! Whether parts of faces make up these faces: each place is in one part, none is missing.

use cyclide::{FacePart, Shell};

/// Parameters that differ by less are one: the same cut has a parameter in each of two faces, rounded in either.
const SAME_PLACE: f64 = 64.0 * f64::EPSILON;

/// A part of a horizontal line in the parameters of a face, with how many more parts there are above it than below.
struct Step {
    t: f64,
    s: [f64; 2],
    parts: i32,
}

/// True if two parameters of a face or an edge are one.
pub(crate) fn same_place(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME_PLACE
}

/// True if the parts, which are of the faces of this shell, tile all its faces.
///
/// How many parts are above a place changes at their lower and upper sides only. The upper and lower sides of all parts, and
/// those of the square as sides of what is outside, cancel each other everywhere if and only if there is one part at each place.
pub(crate) fn tile_faces<'a>(shell: &Shell, parts: impl Iterator<Item = &'a FacePart>) -> bool {
    let square = || vec![Step { t: 0.0, s: [0.0, 1.0], parts: -1 }, Step { t: 1.0, s: [0.0, 1.0], parts: 1 }];
    let mut steps: Vec<Vec<Step>> = shell.faces().iter().map(|_| square()).collect();
    for part in parts {
        let Some(own) = steps.get_mut(part.face) else { return false };
        let is_range = |[from, to]: [f64; 2]| 0.0 <= from && from < to && to <= 1.0;
        if !(is_range(part.s) && is_range(part.t)) {
            return false;
        }
        own.extend([(part.t[0], 1), (part.t[1], -1)].map(|(t, parts)| Step { t, s: part.s, parts }));
    }
    steps.into_iter().all(|mut of_face| {
        of_face.sort_by(|a, b| a.t.total_cmp(&b.t));
        of_face.chunk_by(|a, b| same_place(a.t, b.t)).all(cancel)
    })
}

/// True if steps of one line add up to nothing at each of its places.
fn cancel(steps: &[Step]) -> bool {
    let ends = |step: &Step| [(step.s[0], step.parts), (step.s[1], -step.parts)];
    let mut ends: Vec<(f64, i32)> = steps.iter().flat_map(ends).collect();
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    ends.chunk_by(|a, b| same_place(a.0, b.0)).all(|here| here.iter().map(|(_, parts)| parts).sum::<i32>() == 0)
}
