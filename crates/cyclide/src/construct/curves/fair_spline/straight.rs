//! Straight runs beside a corner: where the blend must vanish so that a leg stays straight
//! (`docs/math/fair-splines.md#straight-runs`), and the further points of tight corners (D3).
//!
//! A curve with continuous curvature and an exactly straight leg needs `e = 0` there. With `t_i` the turn at a node (0 at
//! open ends), `M_i` the larger and `m_i` the smaller one of its neighbors' turns (not below `t_i`):
//!
//! ```text
//! f_i = 1 - ramp(M_i; 30°, 60°) (1 - ramp(m_i/M_i; 0.005, 0.02)),   ramp(x; a, b) = clamp((x-a)/(b-a), 0, 1)
//! ```
//! and the neighbor with the turn `M_i` takes the smaller of its own factor and `f_i`. Segments take the smaller factor
//! of their two nodes.

use crate::base::vector::Point3;
use crate::curve::Chord;

/// Turns of a corner beside which a straight run counts: from nothing to all, radians.
const CORNER_TURN: [f64; 2] = [std::f64::consts::FRAC_PI_6, std::f64::consts::FRAC_PI_3];
/// Ratio of the turns beside a straight node to that of its corner: from straight to curved.
const STRAIGHT_RATIO: [f64; 2] = [0.005, 0.02];
/// Factors up to this make a corner tight.
const TIGHT_FACTOR: f64 = 0.5;

fn ramp(x: f64, [a, b]: [f64; 2]) -> f64 {
    ((x - a) / (b - a)).clamp(0.0, 1.0)
}

/// The turns at the nodes of a run.
struct Turns<'a> {
    chords: &'a [Chord],
    closed: bool,
}

impl Turns<'_> {
    fn node_count(&self) -> usize {
        self.chords.len() + usize::from(!self.closed)
    }

    /// The nodes before and after a node that is no open end.
    fn neighbors(&self, node: usize) -> Option<[usize; 2]> {
        let n = self.node_count();
        match (self.closed, node) {
            (true, _) => Some([if node == 0 { n - 1 } else { node - 1 }, if node + 1 == n { 0 } else { node + 1 }]),
            (false, _) if node > 0 && node + 1 < n => Some([node - 1, node + 1]),
            _ => None,
        }
    }

    /// The turn at a node.
    fn at(&self, node: usize) -> f64 {
        self.neighbors(node).map_or(0.0, |[before, _]| self.chords[before].turn(&self.chords[node]))
    }

    /// True if the turn at a node is a corner of any degree: cheaper than the turn.
    fn is_corner(&self, node: usize) -> bool {
        let cosine = |[before, _]: [usize; 2]| self.chords[before].unit.dot(self.chords[node].unit);
        self.neighbors(node).is_some_and(|beside| cosine(beside) < CORNER_TURN[0].cos())
    }

    /// Calls with every node next to a corner, its own factor, and its neighbors with the largest turn.
    fn beside_corners(&self, mut found: impl FnMut(usize, f64, &[usize])) {
        for node in 0..self.node_count() {
            let Some(beside) = self.neighbors(node) else { continue };
            if !beside.iter().any(|j| self.is_corner(*j)) {
                continue;
            }
            let [before, after] = beside.map(|j| self.at(j));
            let largest = before.max(after);
            let smallest = self.at(node).max(before.min(after));
            let factor = 1.0 - ramp(largest, CORNER_TURN) * (1.0 - ramp(smallest / largest, STRAIGHT_RATIO));
            match (before >= largest, after >= largest) {
                (true, true) => found(node, factor, &beside),
                (true, false) => found(node, factor, &beside[..1]),
                _ => found(node, factor, &beside[1..]),
            }
        }
    }
}

/// The factors of the blends of the segments of a run; `None` where all are 1.
pub(super) fn straight_factors(chords: &[Chord], closed: bool) -> Option<Vec<f64>> {
    let turns = Turns { chords, closed };
    let mut factors: Option<Vec<f64>> = None;
    turns.beside_corners(|node, factor, corners| {
        if factor < 1.0 {
            let nodes = factors.get_or_insert_with(|| vec![1.0; turns.node_count()]);
            for &i in corners.iter().chain([&node]) {
                nodes[i] = nodes[i].min(factor);
            }
        }
    });
    let nodes = factors?;
    let next = |i: usize| nodes[if i + 1 == nodes.len() { 0 } else { i + 1 }];
    Some((0..chords.len()).map(|i| nodes[i].min(next(i))).collect())
}

/// The points with further ones beside the corners that end a straight run, at the part `tight` of the shorter leg, and
/// for each of them the index of the given point at or before it. `None` where there is no such corner.
pub(super) fn with_tight_corners(
    points: &[Point3],
    chords: &[Chord],
    closed: bool,
    cuts: &[usize],
    tight: f64,
) -> Option<(Vec<Point3>, Vec<usize>)> {
    let turns = Turns { chords, closed };
    let mut is_tight = vec![false; points.len()];
    turns.beside_corners(|_, factor, corners| {
        for &corner in corners {
            is_tight[corner] |= factor <= TIGHT_FACTOR && cuts.binary_search(&corner).is_err();
        }
    });
    if !is_tight.contains(&true) {
        return None;
    }
    let (mut out, mut source) = (Vec::new(), Vec::new());
    let mut before_first = None;
    for (i, p) in points.iter().enumerate() {
        let reach = turns.neighbors(i).filter(|_| is_tight[i]).map(|[before, _]| {
            let reach = tight * chords[before].length.min(chords[i].length);
            (*p - chords[before].unit * reach, *p + chords[i].unit * reach)
        });
        match reach {
            // The point before the first one of a closed curve is the last one of all.
            Some((before, _)) if i == 0 => before_first = Some((before, points.len() - 1)),
            Some((before, _)) => {
                out.push(before);
                source.push(i - 1);
            }
            None => {}
        }
        out.push(*p);
        source.push(i);
        if let Some((_, after)) = reach {
            out.push(after);
            source.push(i);
        }
    }
    if let Some((before, index)) = before_first {
        out.push(before);
        source.push(index);
    }
    Some((out, source))
}
