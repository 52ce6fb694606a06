//! How blocks run over what they share: along a side from its corner that was met first, over a face so that its corners are in the least order.

/// A direction of a block, and whether it is taken from its other end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Way {
    pub(super) axis: usize,
    pub(super) back: bool,
}

impl Way {
    pub(super) fn number(self) -> usize {
        2 * self.axis + usize::from(self.back)
    }

    /// The block's own parameter.
    pub(super) fn parameter(self, x: f64) -> f64 {
        if self.back { 1.0 - x } else { x }
    }

    /// The block's own index of a node, of which the last is given.
    pub(super) fn index(self, k: usize, last: usize) -> usize {
        if self.back { last - k } else { k }
    }
}

/// What brings the two directions of a face in its common order to those of a block: they are exchanged, and taken from the other ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Turn {
    exchanged: bool,
    /// Of the block's own directions.
    back: [bool; 2],
}

impl Turn {
    /// That of a face with these corners, in binary order of the block, and its corners in the common order: the least one. Of equals it is the first, so
    /// that blocks that run over a face alike have the same one, also where corners coincide.
    pub(super) fn of(corners: [u32; 4]) -> (Self, [u32; 4]) {
        let all = (0..8).map(|k: usize| Self { exchanged: k & 4 > 0, back: [k & 1 > 0, k & 2 > 0] });
        let ordered = |turn: Self| {
            let corner = |k: usize| {
                let [x, y] = turn.exchanged([k & 1, k >> 1]);
                corners[(x ^ usize::from(turn.back[0])) + 2 * (y ^ usize::from(turn.back[1]))]
            };
            [0, 1, 2, 3].map(corner)
        };
        let first = Self { exchanged: false, back: [false; 2] };
        let least = all.fold(first, |best, turn| if ordered(turn) < ordered(best) { turn } else { best });
        (least, ordered(least))
    }

    /// One of the block's own two directions, which runs along this axis.
    pub(super) fn way(self, own: usize, axis: usize) -> Way {
        Way { axis, back: self.back[own] }
    }

    /// The ways of a block with these directions in the common order.
    pub(super) fn ways(self, axes: [usize; 2]) -> [Way; 2] {
        self.exchanged([self.way(0, axes[0]), self.way(1, axes[1])])
    }

    /// What belongs to the two directions of the block for those of the common order, or the other way round.
    pub(super) fn exchanged<T>(self, [a, b]: [T; 2]) -> [T; 2] {
        if self.exchanged { [b, a] } else { [a, b] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_ways_over_a_face_have_one_order() {
        let corners = [7, 3, 9, 4];
        // A block whose own directions are those of the first one turned in each way.
        for exchanged in [false, true] {
            for back in [[false, false], [true, false], [false, true], [true, true]] {
                let corner = |k: usize| {
                    let [x, y] = [(k & 1) ^ usize::from(back[0]), (k >> 1) ^ usize::from(back[1])];
                    corners[if exchanged { y + 2 * x } else { x + 2 * y }]
                };
                let (turn, order) = Turn::of([0, 1, 2, 3].map(corner));
                assert_eq!(order, [3, 4, 7, 9]);
                // Its own corner at the start of both ways is the least one.
                let [x, y] = turn.back.map(usize::from);
                assert_eq!(corner(x + 2 * y), 3);
            }
        }
    }

    #[test]
    fn coinciding_corners_keep_their_order() {
        assert_eq!(Turn::of([2, 2, 5, 5]).0, Turn { exchanged: false, back: [false; 2] });
    }
}
