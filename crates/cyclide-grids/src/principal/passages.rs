//! What becomes of coordinates where a walk passes an edge at which the sheets on both sides have others.

use std::collections::HashMap;

use super::coordinates::Coordinates;
use super::sheet::Sheet;

/// How the coordinates on the other side of an edge are got: turned by half a turn or not, and moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Passage {
    pub(super) turned: bool,
    pub(super) shift: [f64; 2],
}

impl Passage {
    pub(super) fn place(&self, at: [f64; 2]) -> [f64; 2] {
        let sign = if self.turned { -1.0 } else { 1.0 };
        [0, 1].map(|d| sign * at[d] + self.shift[d])
    }
}

/// By the half edge that is passed from its own triangle.
#[derive(Default)]
pub(super) struct Passages(pub(super) HashMap<usize, Passage>);

impl Passages {
    /// Those over the seam of a surface that comes back to itself, whose corners on the left have a period more.
    pub(super) fn over_seam(sheet: &Sheet<'_>, left: &[bool], coordinates: &Coordinates) -> Self {
        let mut passages = Self::default();
        for half in sheet.table.inner_edges() {
            for half in [half, sheet.table.twin(half)] {
                let other = sheet.table.twin(half);
                // Both sides name the place where the half edge starts.
                let (here, there) = (left[half], left[3 * (other / 3) + (other + 1) % 3]);
                if here != there {
                    let turns = f64::from(i8::from(there) - i8::from(here));
                    let shift = coordinates.periods.map(|period| turns * period);
                    passages.0.insert(half, Passage { turned: false, shift });
                }
            }
        }
        passages
    }

    pub(super) fn over(&self, half: usize) -> Option<&Passage> {
        self.0.get(&half)
    }
}
