//! Whether seams run into themselves or each other: pairs of their parts, halved until a plane parts them, or until both are smaller than the tolerance
//! (`docs/math/torus-splines.md#seams`).

use super::cell::{Cell, are_free};
use super::{Span, TorusSeam};
use crate::base::box_tree::BoxTree;
use crate::base::vector::Point3;
use crate::error::{Result, TorusError};

/// Pairs of parts that are looked at before seams are given up as too near to tell.
const MOST_PAIRS: usize = 4_000_000;
/// Parts that follow each other are halved so often at most: the derivatives of a seam that does not fold hardly change over less.
const MOST_HALVINGS: u32 = 24;

/// The spans of a seam, less a margin.
pub(super) struct Strip<'a> {
    spans: &'a [Span],
    cells: Vec<Cell>,
    tree: BoxTree,
    margin: f64,
    /// Part of the height at which the curve is.
    low: f64,
}

/// A point inside two seams, or inside one at two places of its curve.
pub(super) struct Meeting {
    pieces: [usize; 2],
    pub(super) point: Point3,
    /// From curve to curve there.
    distance: f64,
}

/// Refuses a seam of which parts that are no neighbors share space.
///
/// # Errors
/// `seam-meets-itself`.
pub(super) fn check(seam: &TorusSeam, spans: &[Span], closed: bool, tolerance: f64) -> Result<()> {
    let strip = Strip::new(seam, spans, tolerance);
    let mut left = MOST_PAIRS;
    let last = spans.len() - 1;
    let found = strip.tree.find_within(
        |_, _| false,
        |i, j| match j - i {
            0 => strip.meets_itself(i, &mut left),
            1 => strip.meets_next(i, j, &mut left),
            _ if closed && i == 0 && j == last => strip.meets_next(j, i, &mut left),
            _ => strip.meets(&strip, [i, j], [strip.cells[i], strip.cells[j]], &mut left),
        },
    );
    found.map_or(Ok(()), |Meeting { pieces: [first, second], point, distance }| {
        Err(TorusError::SeamMeetsItself {
            first: first.min(second),
            second: first.max(second),
            point: point.to_array(),
            distance,
            width: seam.width,
        }
        .into())
    })
}

impl<'a> Strip<'a> {
    pub(super) fn new(seam: &TorusSeam, spans: &'a [Span], tolerance: f64) -> Self {
        let [low, high] = seam.heights;
        let margin = tolerance.min(0.125 * (high - low)).min(0.125 * seam.width);
        let parts = [margin / seam.width, margin / (high - low)];
        let cells: Vec<Cell> = spans.iter().map(|span| Cell::inside(&span.cubics, parts)).collect();
        let boxes: Vec<_> = cells.iter().map(Cell::hull).collect();
        Self { spans, tree: BoxTree::new(&boxes), cells, margin, low: -low / (high - low) }
    }

    /// The first meeting with another seam.
    pub(super) fn first_meeting(&self, other: &Self) -> Option<Meeting> {
        let mut left = MOST_PAIRS;
        self.tree
            .find_between(&other.tree, |i, j| self.meets(other, [i, j], [self.cells[i], other.cells[j]], &mut left))
    }

    fn meets_itself(&self, span: usize, left: &mut usize) -> Option<Meeting> {
        let mut waiting = vec![self.cells[span]];
        while let Some(cell) = waiting.pop() {
            if are_free(&[&cell]) {
                continue;
            }
            let [a, b] = cell.halves(0);
            let found = self.meets_behind([span, span], [a, b], left);
            if found.is_some() {
                return found;
            }
            waiting.extend([b, a]);
        }
        None
    }

    fn meets_next(&self, span: usize, next: usize, left: &mut usize) -> Option<Meeting> {
        self.meets_behind([span, next], [self.cells[span], self.cells[next]], left)
    }

    /// The meeting of two cells, one behind the other.
    fn meets_behind(&self, spans: [usize; 2], cells: [Cell; 2], left: &mut usize) -> Option<Meeting> {
        let [mut a, mut b] = cells;
        while !are_free(&[&a, &b]) {
            if a.halvings.max(b.halvings) >= MOST_HALVINGS {
                return Some(self.meeting(self, spans, [&a, &b]));
            }
            let ([first, before], [behind, last]) = (a.halves(0), b.halves(0));
            let pairs = [[first, behind], [first, last], [before, last]];
            let found = pairs.into_iter().find_map(|pair| self.meets(self, spans, pair, left));
            if found.is_some() {
                return found;
            }
            (a, b) = (before, behind);
        }
        None
    }

    /// The meeting of two cells that do not touch along the curve.
    fn meets(&self, other: &Self, spans: [usize; 2], cells: [Cell; 2], left: &mut usize) -> Option<Meeting> {
        let mut waiting = vec![cells];
        while let Some([a, b]) = waiting.pop() {
            if a.is_apart(&b) {
                continue;
            }
            let sizes = [a, b].map(|cell| cell.sizes());
            *left = left.saturating_sub(1);
            if sizes.as_flattened().iter().sum::<f64>() <= self.margin.min(other.margin) || *left == 0 {
                return Some(self.meeting(other, spans, [&a, &b]));
            }
            let longest = sizes.map(|size| (0..3).fold(0, |most, k| if size[k] > size[most] { k } else { most }));
            if sizes[0][longest[0]] >= sizes[1][longest[1]] {
                waiting.extend(a.halves(longest[0]).map(|half| [half, b]));
            } else {
                waiting.extend(b.halves(longest[1]).map(|half| [a, half]));
            }
        }
        None
    }

    fn meeting(&self, other: &Self, spans: [usize; 2], [a, b]: [&Cell; 2]) -> Meeting {
        let point = a.middle().midpoint(b.middle());
        let (one, another) = (&self.spans[spans[0]], &other.spans[spans[1]]);
        let near = [one.curve_near(point, self.low), another.curve_near(point, other.low)];
        Meeting { pieces: [one.piece, another.piece], point, distance: near[0].distance(near[1]) }
    }
}
