//! A fair spline piece by piece: between its cuts every piece is a spline of its own
//! (`docs/math/fair-splines.md#relaxation`).

use super::options::{FairEnd, FairSplineOptions};
use super::relaxation::{fair, relaxed};
use super::run::Run;
use super::straight::straight_factors;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Chord, SHARP_TURN};
use std::borrow::Cow;

/// What is known of every segment of the spline.
pub(super) struct Pieces<'a> {
    points: &'a [Point3],
    chords: &'a [Chord],
    options: &'a FairSplineOptions,
    /// Unit tangents at both ends of each segment.
    pub(super) tangents: Vec<[Vec3; 2]>,
    /// Blends.
    pub(super) blends: Vec<f64>,
    /// Segments with smaller blends than asked for.
    pub(super) relaxed: Vec<usize>,
    /// Nodes that were cut because the curve swings out there.
    pub(super) cut: Vec<usize>,
}

/// Segments in a row, by the first one and their number; they may pass the seam of a closed curve.
#[derive(Clone, Copy)]
struct Span {
    first: usize,
    count: usize,
}

impl<'a> Pieces<'a> {
    /// Solves the curve between the cuts (rising nodes, no ends of an open curve), with unit tangents in `ends`.
    pub(super) fn solve(
        points: &'a [Point3],
        chords: &'a [Chord],
        options: &'a FairSplineOptions,
        cuts: &[usize],
        ends: [FairEnd; 2],
    ) -> Self {
        let m = chords.len();
        let mut pieces = Self {
            points,
            chords,
            options,
            tangents: vec![[Vec3::ZERO; 2]; m],
            blends: vec![0.0; m],
            relaxed: Vec::new(),
            cut: Vec::new(),
        };
        let whole = Span { first: 0, count: m };
        if cuts.is_empty() {
            pieces.solve_span(whole, options.closed, ends);
        } else {
            pieces.solve_between(whole, options.closed, cuts, ends);
        }
        pieces.relaxed.sort_unstable();
        pieces.cut.sort_unstable();
        pieces
    }

    /// Solves the parts of a span between cuts inside it; ends at cuts are those of open curves by default.
    fn solve_between(&mut self, span: Span, closed: bool, cuts: &[usize], ends: [FairEnd; 2]) {
        let m = self.chords.len();
        let along = |node: usize| (node + m - span.first) % m;
        let mut places: Vec<usize> = cuts.iter().map(|c| along(*c)).collect();
        places.sort_unstable();
        if closed {
            for (k, &place) in places.iter().enumerate() {
                let next = places.get(k + 1).copied().unwrap_or(places[0] + m);
                let part = Span { first: (span.first + place) % m, count: next - place };
                self.solve_span(part, false, [FairEnd::Circle; 2]);
            }
            return;
        }
        let mut from = 0;
        for (k, to) in places.iter().copied().chain([span.count]).enumerate() {
            let start = if k == 0 { ends[0] } else { FairEnd::Circle };
            let end = if to == span.count { ends[1] } else { FairEnd::Circle };
            self.solve_span(Span { first: (span.first + from) % m, count: to - from }, false, [start, end]);
            from = to;
        }
    }

    fn solve_span(&mut self, span: Span, closed: bool, ends: [FairEnd; 2]) {
        let chords = in_a_row(self.chords, span.first, span.count);
        let node_count = if closed { span.count } else { span.count + 1 };
        let points = in_a_row(self.points, span.first, node_count);
        let run = Run::new(&points, &chords, closed, ends);
        let blends = self.blends_asked(&chords, closed);
        let solution = fair(&run, &blends);
        if solution.is_none() && self.options.cut_sharp_turns {
            let sharp = sharp_nodes(&chords, closed);
            if !sharp.is_empty() {
                let m = self.chords.len();
                let nodes: Vec<usize> = sharp.iter().map(|i| (span.first + i) % m).collect();
                self.solve_between(span, closed, &nodes, ends);
                self.cut.extend(nodes);
                return;
            }
        }
        let solution = solution.unwrap_or_else(|| relaxed(&run, &blends, self.options.tension));
        for i in 0..span.count {
            let segment =
                if span.first + i < self.chords.len() { span.first + i } else { span.first + i - self.chords.len() };
            let next = if i + 1 == node_count { 0 } else { i + 1 };
            self.tangents[segment] = [solution.tangents[i], solution.tangents[next]];
            self.blends[segment] = solution.blends[i];
            if solution.relaxed {
                self.relaxed.push(segment);
            }
        }
    }

    /// `1 - tension`, less at straight runs.
    fn blends_asked(&self, chords: &[Chord], closed: bool) -> Vec<f64> {
        let fairest = 1.0 - self.options.tension;
        let factors = if self.options.straight_runs { straight_factors(chords, closed) } else { None };
        factors.map_or_else(|| vec![fairest; chords.len()], |f| f.iter().map(|f| fairest * f).collect())
    }
}

/// `count` items from `first` on, beyond the last from the first again.
fn in_a_row<T: Clone>(items: &[T], first: usize, count: usize) -> Cow<'_, [T]> {
    match items.get(first..first + count) {
        Some(row) => Cow::Borrowed(row),
        None => Cow::Owned(items.iter().cycle().skip(first).take(count).cloned().collect()),
    }
}

/// The nodes of a run with a turn near half a turn, by their place in it.
fn sharp_nodes(chords: &[Chord], closed: bool) -> Vec<usize> {
    let m = chords.len();
    let is_sharp = |&i: &usize| {
        let (before, after) = (&chords[if i == 0 { m - 1 } else { i - 1 }], &chords[i]);
        before.unit.dot(after.unit) < -0.9 && before.turn(after) > SHARP_TURN
    };
    (usize::from(!closed)..m).filter(is_sharp).collect()
}
