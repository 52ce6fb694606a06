//! Whether the cells of a face are its whole parameter square, each part of it once: without a tolerance.
//!
//! The function that counts how often a point of the plane is covered by some rectangles is known by its mixed second
//! derivative: at each corner of a rectangle, +1 at the lowest and the highest one, -1 at the others. The rectangles cover
//! the square once if and only if what adds up at each place is what the square has there, so that neither a gap nor an
//! overlap, nor one of each with equal areas, is passed over. Cells share the doubles of their cuts.

use cyclide::mesh::MeshSource;

/// A corner by the bits of its parameters, with what it adds.
type Corner = ([u64; 2], i32);

/// Looks at the cells of one face at a time.
#[derive(Default)]
pub(super) struct Cover {
    corners: Vec<Corner>,
}

impl Cover {
    /// True if the cells cover the unit square once.
    pub(super) fn is_whole<'a>(&mut self, cells: impl Iterator<Item = &'a MeshSource>) -> bool {
        self.corners.clear();
        for source in cells {
            // A cell that runs backwards would count negatively.
            if !(source.s[0] <= source.s[1] && source.t[0] <= source.t[1]) {
                return false;
            }
            self.add(source.s, source.t, 1);
        }
        self.add([0.0, 1.0], [0.0, 1.0], -1);
        self.corners.sort_unstable();
        let places = self.corners.chunk_by(|a, b| a.0 == b.0);
        places.map(|corners| corners.iter().map(|corner| corner.1).sum::<i32>()).all(|sum| sum == 0)
    }

    fn add(&mut self, s: [f64; 2], t: [f64; 2], times: i32) {
        for (i, s) in s.into_iter().enumerate() {
            for (j, t) in t.into_iter().enumerate() {
                let sign = if i == j { times } else { -times };
                // Of a zero both signs are one.
                self.corners.push(([s + 0.0, t + 0.0].map(f64::to_bits), sign));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_and_overlaps_are_found_whatever_their_areas() {
        let cell = |s: [f64; 2], t: [f64; 2]| MeshSource { shell: 0, face: 0, s, t };
        let whole = |cells: &[MeshSource]| Cover::default().is_whole(cells.iter());
        let third = 1.0 / 3.0;
        let mut cells = vec![
            cell([0.0, third], [0.0, 1.0]),
            cell([third, 1.0], [0.0, 0.25]),
            cell([third, 1.0 - 1e-12], [0.25, 1.0]),
            cell([1.0 - 1e-12, 1.0], [0.25, 1.0]),
        ];
        assert!(whole(&cells));
        assert!(!whole(&cells[..3]), "an area of 1e-12 is missing");
        let narrow = cells.pop().unwrap();
        // As much area as is missing, elsewhere a second time.
        assert!(!whole(&[&cells[..], &[cell([0.0, 1e-12], [0.25, 1.0])]].concat()));
        assert!(!whole(&[&cells[..], &[narrow, narrow]].concat()));
        assert!(!whole(&[cell([1.0, 0.0], [1.0, 0.0])]) && !whole(&[]));
        let nan = cell([0.0, f64::NAN], [0.0, 1.0]);
        assert!(!whole(&[nan]));
    }
}
