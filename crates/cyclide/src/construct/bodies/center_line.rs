//! Whether the center line of a tube crosses itself: then every tube about it meets itself, however thin.

use crate::base::bounds::Aabb;
use crate::base::box_tree::BoxTree;
use crate::base::segments::nearest_of_segments;
use crate::base::vector::Point3;

/// Pairs of parts that are looked at, at most.
const MOST_PAIRS: usize = 200_000;
/// Pieces that come nearer than this part of the width of the tube cross.
const CROSSING: f64 = 1e-7;

/// Pieces of a line, one after the other.
pub(super) struct CenterLine<'a> {
    pub(super) count: usize,
    pub(super) closed: bool,
    /// The point of a piece at a parameter, 0 to 1.
    pub(super) point: &'a dyn Fn(usize, f64) -> Point3,
    /// No point of a piece between two parameters is farther than this from the chord.
    pub(super) sagitta: &'a dyn Fn(usize, [f64; 2]) -> f64,
}

/// Where two pieces cross.
pub(super) struct Crossing {
    pub(super) pieces: [usize; 2],
    pub(super) point: Point3,
    pub(super) distance: f64,
}

#[derive(Clone, Copy)]
struct Part {
    piece: usize,
    range: [f64; 2],
    chord: [Point3; 2],
    sagitta: f64,
}

impl CenterLine<'_> {
    /// The first pieces that cross, of those that do not follow each other, about which tubes may be so far from each other.
    pub(super) fn crossing(&self, limit: f64) -> Option<Crossing> {
        let least = CROSSING * limit;
        let parts: Vec<Part> = (0..self.count).map(|piece| self.part(piece, [0.0, 1.0])).collect();
        let hull = |part: &Part| Aabb::of_point(part.chord[0]).including(part.chord[1]).grown(part.sagitta + least);
        let tree = BoxTree::new(&parts.iter().map(hull).collect::<Vec<_>>());
        let mut left = MOST_PAIRS;
        tree.find_within(
            |_, _| false,
            |i, j| {
                let follows = j <= i + 1 || (self.closed && i == 0 && j + 1 == self.count);
                if follows { None } else { self.crossing_of([parts[i], parts[j]], least, &mut left) }
            },
        )
    }

    fn part(&self, piece: usize, range: [f64; 2]) -> Part {
        let chord = range.map(|t| (self.point)(piece, t));
        Part { piece, range, chord, sagitta: (self.sagitta)(piece, range) }
    }

    /// Halves parts until they are farther apart than they may bend, or places of them are one.
    fn crossing_of(&self, pair: [Part; 2], least: f64, left: &mut usize) -> Option<Crossing> {
        let mut waiting = vec![pair];
        while let Some([a, b]) = waiting.pop() {
            let (apart, at) = nearest_of_segments([a.chord, b.chord]);
            if apart > a.sagitta + b.sagitta + least || *left == 0 {
                continue;
            }
            *left -= 1;
            let [p, q] = [(a, at[0]), (b, at[1])]
                .map(|(part, s)| (self.point)(part.piece, part.range[0] + (part.range[1] - part.range[0]) * s));
            if p.distance(q) <= least {
                return Some(Crossing { pieces: [a.piece, b.piece], point: p.midpoint(q), distance: p.distance(q) });
            }
            let halves = |part: Part| {
                let [from, to] = part.range;
                let middle = 0.5 * (from + to);
                [[from, middle], [middle, to]].map(|range| self.part(part.piece, range))
            };
            if a.sagitta > b.sagitta {
                waiting.extend(halves(a).map(|half| [half, b]));
            } else if b.sagitta > 0.0 {
                waiting.extend(halves(b).map(|half| [a, half]));
            }
        }
        None
    }
}
