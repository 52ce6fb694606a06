//! Whether parts of faces make up these faces: each place is in one part, none is missing.

use cyclide::topology::{FacePart, Shell};

/// Parameters that differ by less are one: a cut has a parameter in each of two faces, rounded in either with each of the cuts
/// before it, of which there are some forty at most.
const SAME_PLACE: f64 = 256.0 * f64::EPSILON;

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

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "what cannot be made fails the test")]
mod tests {
    use super::*;
    use cyclide::{Point3, Vec3, surface::CyclidePatch};

    /// Whether these rectangles tile the face of a shell of one.
    fn tiled(parts: &[[f64; 4]]) -> bool {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]].map(Point3::from);
        let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::X, Vec3::Y).unwrap();
        let shell = Shell::from_surface(patch).unwrap();
        let part = |&[s0, s1, t0, t1]: &[f64; 4]| FacePart { face: 0, s: [s0, s1], t: [t0, t1] };
        tile_faces(&shell, parts.iter().map(part).collect::<Vec<_>>().iter())
    }

    #[test]
    fn every_place_is_in_one_part() {
        assert!(tiled(&[[0.0, 1.0, 0.0, 1.0]]));
        // Below a line the parts are others than above it, as at a singular line; around a middle there is no common line.
        assert!(tiled(&[[0.0, 0.3, 0.0, 0.5], [0.3, 1.0, 0.0, 0.5], [0.0, 0.7, 0.5, 1.0], [0.7, 1.0, 0.5, 1.0]]));
        let spiral = [
            [0.0, 0.6, 0.0, 0.4],
            [0.6, 1.0, 0.0, 0.6],
            [0.4, 1.0, 0.6, 1.0],
            [0.0, 0.4, 0.4, 1.0],
            [0.4, 0.6, 0.4, 0.6],
        ];
        assert!(tiled(&spiral));
        // A rounding apart.
        let at = 0.1 + 0.2;
        assert!(tiled(&[[0.0, 0.3, 0.0, 1.0], [at, 1.0, 0.0, 1.0]]) && (at - 0.3).abs() > 0.0);
        for left_out in 0..5 {
            let mut parts = spiral.to_vec();
            let doubled = parts.remove(left_out);
            assert!(!tiled(&parts), "without part {left_out}");
            parts.extend([doubled; 2]);
            assert!(!tiled(&parts), "with part {left_out} twice");
        }
    }

    #[test]
    fn gaps_overlaps_and_what_is_no_rectangle_inside_are_found() {
        assert!(!tiled(&[]));
        // The areas add up to 1.
        assert!(!tiled(&[[0.0, 0.5, 0.0, 1.0], [0.25, 0.75, 0.0, 1.0]]));
        assert!(!tiled(&[[0.0, 0.5, 0.0, 1.0], [0.0, 1.0, 0.0, 0.5]]));
        for gap in [1e-9, -1e-9] {
            assert!(!tiled(&[[0.0, 0.5, 0.0, 1.0], [0.5 + gap, 1.0, 0.0, 1.0]]));
            assert!(!tiled(&[[0.0, 1.0, 0.0, 0.5], [0.0, 1.0, 0.5 + gap, 1.0]]));
        }
        for outside in [[-0.5, 1.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.5], [1.0, 0.0, 0.0, 1.0], [0.0, f64::NAN, 0.0, 1.0]] {
            assert!(!tiled(&[outside]), "{outside:?}");
        }
    }
}
