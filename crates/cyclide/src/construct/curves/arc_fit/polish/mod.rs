//! Fewer pieces and the least deviation, once a chain within the tolerance is known
//! (`docs/math/arc-fitting.md#least-deviation`).
//!
//! A search spends the tolerance wherever it likes. Afterwards two neighbors become one piece where least squares find such
//! a chain within the tolerance, and then all pieces are moved to the least squares of their points. Short chains are moved as
//! a whole; long ones in windows that keep their ends, each in the order of the chain.

mod lines;

use crate::base::frame::Frame;
use crate::construct::curves::arc_fit::bends::{Bend, Bends, Counted, Ends, Hold, Matched, State, Sum};
use crate::construct::curves::arc_fit::certificate::certify;
use crate::construct::curves::arc_fit::options::{ArcFitOptions, FitTarget};
use crate::construct::curves::arc_fit::piece::{Piece, Place, Span, joined};
use crate::construct::curves::arc_fit::trace::Trace;
use crate::curve::Arc;

/// Chains of at most this many pieces are moved as a whole.
const WHOLE: usize = 14;
/// Pieces of a window, and by how many the next one is further on.
const WINDOW: usize = 8;
const WINDOW_STEP: usize = 4;
/// How often the windows go along a chain.
const PASSES: usize = 2;
/// Pieces on both sides of two that are merged which move with them.
const BESIDE: usize = 3;
/// Rounds of merging and moving.
const ROUNDS: usize = 3;
/// Pieces of a bend between lines that are tried as one.
const MOST_OF_BEND: usize = 6;
/// Steps of least squares, of a whole chain, of a window, and of two pieces that are merged.
const WHOLE_STEPS: usize = 16;
const WINDOW_STEPS: usize = 4;
const MERGE_STEPS: usize = 7;
/// The curvature of a piece may become this many times the largest of the search there: of the piece and its neighbors.
const NO_TIGHTER: f64 = 1.75;
/// A power of the distances that stands for the largest of them: of the points that are fitted, and of all places that bind.
const LARGEST_FITTED: Sum = Sum { power: 8, of: Counted::Fitted };
const LARGEST_BOUND: Sum = Sum { power: 8, of: Counted::Bound };
/// Least squares whose largest distance is this many tolerances are not brought within it.
const HOPELESS: f64 = 2.0;
/// Chains of at most this many pieces are merged from both ends.
const BOTH_ENDS: usize = 48;

/// The pieces polished, as far as the certificate holds with it.
pub(super) fn polished(
    pieces: Vec<Piece>,
    trace: &Trace,
    frame: &Frame,
    tolerance: f64,
    options: &ArcFitOptions,
) -> Vec<Piece> {
    let polish = Polish { trace, frame, tolerance, options };
    let mut starts: Vec<usize> = (0..pieces.len()).filter(|i| !pieces[*i].smooth).collect();
    if starts.is_empty() {
        return polish.round(&pieces).unwrap_or(pieces);
    }
    starts.push(pieces.len());
    let runs = starts.windows(2).map(|w| &pieces[w[0]..w[1]]);
    runs.flat_map(|run| polish.run(run, Between::Places).unwrap_or_else(|| run.to_vec())).collect()
}

/// The same of pieces between two axes of symmetry (or a place that is none, as `axes` says), at which they slide.
pub(super) fn polished_between(
    pieces: Vec<Piece>,
    axes: [bool; 2],
    trace: &Trace,
    frame: &Frame,
    tolerance: f64,
    options: &ArcFitOptions,
) -> Vec<Piece> {
    let polish = Polish { trace, frame, tolerance, options };
    polish.run(&pieces, Between::Axes(axes)).unwrap_or(pieces)
}

/// What a run is between.
#[derive(Clone, Copy, PartialEq)]
enum Between {
    Places,
    /// Where it says so an axis of symmetry, else a place.
    Axes([bool; 2]),
    /// Its own seam.
    Seam,
}

struct Polish<'a> {
    trace: &'a Trace,
    frame: &'a Frame,
    tolerance: f64,
    options: &'a ArcFitOptions,
}

/// A chain, or a part of it, with the parts of the trace that its pieces stand for.
#[derive(Clone)]
struct Spanned {
    bends: Bends,
    spans: Vec<Span>,
}

impl Polish<'_> {
    /// A loop: from a line on, if it has one, so that no bend is in two parts; it starts where it did, or beside that.
    fn round(&self, pieces: &[Piece]) -> Option<Vec<Piece>> {
        let start = pieces[0].arc.start();
        let mut turned = pieces.to_vec();
        turned.rotate_left(pieces.iter().position(|piece| piece.arc.is_straight()).unwrap_or(0));
        let mut found = self.run(&turned, Between::Seam)?;
        let away = |piece: &Piece| piece.arc.start().distance(start);
        let first = (0..found.len()).min_by(|a, b| away(&found[*a]).total_cmp(&away(&found[*b])))?;
        found.rotate_left(first);
        Some(found)
    }

    /// A run between corners or all round; `None` if it has too few pieces.
    fn run(&self, pieces: &[Piece], between: Between) -> Option<Vec<Piece>> {
        if pieces.len() < if between == Between::Seam { 3 } else { 2 } {
            return None;
        }
        // One after the other, each in the lap of the one before it or the next.
        let mut spans: Vec<Span> = vec![pieces[0].span];
        for piece in &pieces[1..] {
            let both = joined(spans[spans.len() - 1], piece.span, self.trace.points.len());
            let laps = both.to.index - piece.span.to.index;
            let from = Place { index: piece.span.from.index + laps, ..piece.span.from };
            spans.push(Span { from, to: both.to });
        }
        let mut chain = Spanned { bends: self.bends(pieces, between)?, spans };
        // What has moved may let others become one.
        for _ in 0..ROUNDS {
            let before = chain.spans.len();
            // Greedily, from both ends: the shorter one.
            let mut back = (before <= BOTH_ENDS).then(|| chain.clone());
            self.merge(&mut chain, false);
            if let Some(back) = &mut back {
                self.merge(back, true);
            }
            chain = back.filter(|back| back.spans.len() < chain.spans.len()).unwrap_or(chain);
            self.refine(&mut chain);
            if chain.spans.len() == before {
                break;
            }
        }
        self.straighten(&mut chain);
        self.pieces(&chain, Some(pieces)).map(|found| found.0)
    }

    fn bends(&self, pieces: &[Piece], between: Between) -> Option<Bends> {
        let is_loop = between == Between::Seam;
        let first = &pieces[0].arc;
        let tangent = self.frame.vector_to_local(first.start_tangent()?);
        let start = State { at: self.frame.to_local(first.start()).0, angle: tangent.y.atan2(tangent.x) };
        let n = self.trace.points.len();
        let bend = |piece: &Piece| {
            let length = piece.arc.length_to(1.0);
            let straight = piece.arc.is_straight();
            let sweep = piece.arc.angle().copysign(piece.arc.bulge_vector().dot(self.frame.z()));
            // Both ends of a chain are where they are; every other joint is behind the points before it.
            let (from, to) = (piece.span.from, piece.span.to);
            let matched = |i: usize| {
                let at = self.frame.to_local(self.trace.point(i)).0;
                let fitted = self.options.target == FitTarget::Polyline || self.trace.vertex[i % n].is_some();
                Matched { at, slack: self.trace.slack[i % n], fitted }
            };
            let points = (from.index + 1..=to.index).map(matched).collect();
            let curvature = if straight { 0.0 } else { sweep / length };
            Bend { curvature, length, straight, points, tightest: 0.0 }
        };
        let mut pieces: Vec<Bend> = pieces.iter().map(bend).collect();
        let turn = pieces.iter().map(|b| b.curvature * b.length).sum::<f64>();
        // What the search did not need is no gain: no piece becomes far tighter than those there.
        let limits = self.options.limits();
        let count = pieces.len();
        let curvatures: Vec<f64> = pieces.iter().map(|b| b.curvature.abs()).collect();
        for (i, piece) in pieces.iter_mut().enumerate() {
            let beside = [
                (is_loop || i > 0).then_some((i + count - 1) % count),
                Some(i),
                (is_loop || i + 1 < count).then_some((i + 1) % count),
            ];
            let tightest = beside.into_iter().flatten().map(|k| curvatures[k]).fold(0.0, f64::max);
            piece.tightest = limits.curvature.min(NO_TIGHTER * tightest);
        }
        let mut bends = Bends { start, pieces, ends: Ends::Loop { turn }, shortest: limits.length };
        bends.ends = match between {
            // Smooth all round: a whole number of turns.
            Between::Seam => Ends::Loop { turn: std::f64::consts::TAU * (turn / std::f64::consts::TAU).round() },
            Between::Places => bends.held([false; 2])?,
            Between::Axes(axes) => bends.held(axes)?,
        };
        Some(bends)
    }

    /// Two neighbors become one where that stays within the tolerance, and the pieces of a bend between lines one arc.
    fn merge(&self, chain: &mut Spanned, back: bool) {
        let fewest = if chain.is_loop() { 3 } else { 1 };
        // Pieces that were tried, from the end where it begins.
        let mut tried = 0;
        while tried + 1 < chain.spans.len() && chain.spans.len() > fewest {
            let i = if back { chain.spans.len() - 2 - tried } else { tried };
            let bend = chain.bend_between_lines(i).filter(|count| chain.spans.len() + 1 >= fewest + count);
            let found = bend.into_iter().chain([2]).any(|count| self.merge_at(chain, i, count));
            tried = if found { tried.saturating_sub(1) } else { tried + 1 };
        }
    }

    /// Makes so many pieces from one on one piece; false if that does not stay within the tolerance.
    fn merge_at(&self, chain: &mut Spanned, at: usize, count: usize) -> bool {
        let whole = chain.spans.len() <= WHOLE / 2;
        let range = if whole {
            0..chain.spans.len()
        } else {
            at.saturating_sub(BESIDE)..(at + count + BESIDE).min(chain.spans.len())
        };
        let part = if whole { chain.clone() } else { chain.part(range.clone()) };
        let at = at - range.start;
        match self.merged(&part, at..at + count) {
            Some(found) if whole => *chain = found,
            Some(found) => chain.put(range, found),
            None => return false,
        }
        true
    }

    /// The chain with two pieces or more as one, and the others moved with it.
    fn merged(&self, chain: &Spanned, range: std::ops::Range<usize>) -> Option<Spanned> {
        let pieces = &chain.bends.pieces[range.clone()];
        let [a, .., b] = pieces else { return None };
        let length = pieces.iter().map(|piece| piece.length).sum::<f64>();
        let curvature = pieces.iter().map(|piece| piece.curvature * piece.length).sum::<f64>() / length;
        let mut spans = chain.spans.clone();
        let whole = joined(spans[range.start], spans[range.end - 1], self.trace.points.len());
        spans.splice(range.clone(), [whole]);
        // A straight run stays straight, except for a short end of a bend.
        let as_line: &[bool] = match (a.straight, b.straight) {
            (true, true) => &[true],
            (true, false) if a.length >= b.length => &[true],
            (false, true) if b.length >= a.length => &[true],
            (false, false) => &[false],
            _ => &[true, false],
        };
        as_line.iter().find_map(|straight| {
            let points = pieces.iter().flat_map(|piece| &piece.points).copied().collect();
            let curvature = if *straight { 0.0 } else { curvature };
            let tightest = pieces.iter().map(|piece| piece.tightest).fold(0.0, f64::max);
            let one = Bend { curvature, length, straight: *straight, points, tightest };
            let mut fewer = chain.bends.clone();
            fewer.pieces.splice(range.clone(), [one]);
            let mut bends = fewer.closed()?.refined(Sum::SQUARES, MERGE_STEPS, f64::INFINITY);
            if (self.tolerance..HOPELESS * self.tolerance).contains(&bends.deviation()) {
                bends = bends.refined(LARGEST_BOUND, WHOLE_STEPS, f64::INFINITY);
            }
            self.certified(Spanned { bends, spans: spans.clone() })
        })
    }

    /// Moves a chain to the least squares within the tolerance, as a whole or window by window; where they raise the largest
    /// distance, to the least of a high power.
    fn refine(&self, chain: &mut Spanned) {
        let lower = |part: &Spanned, steps: usize| {
            let before = part.bends.deviation();
            let limit = self.tolerance.max(before);
            let squares = part.bends.clone().refined(Sum::SQUARES, steps, limit);
            let raised = squares.deviation() > before;
            let bends = if raised { squares.refined(LARGEST_FITTED, steps, limit) } else { squares };
            self.certified(Spanned { bends, spans: part.spans.clone() })
        };
        let count = chain.spans.len();
        if count <= WHOLE {
            if let Some(found) = lower(chain, WHOLE_STEPS) {
                *chain = found;
            }
            return;
        }
        for _ in 0..PASSES {
            for from in (0..count - WINDOW_STEP).step_by(WINDOW_STEP) {
                let range = from..(from + WINDOW).min(count);
                if let Some(found) = lower(&chain.part(range.clone()), WINDOW_STEPS) {
                    chain.put(range, found);
                }
            }
        }
    }

    /// The chain with its new spans, if its points and the proof sheet are within the tolerance.
    fn certified(&self, chain: Spanned) -> Option<Spanned> {
        if chain.bends.deviation() > self.tolerance {
            return None;
        }
        let (pieces, spans) = self.pieces(&chain, None)?;
        let sheet = certify(&pieces, self.trace, self.options.target, true);
        (sheet.deviation <= self.tolerance && sheet.monotone).then_some(Spanned { bends: chain.bends, spans })
    }

    /// The pieces of a chain, and the parts of the trace that they stand for now; of a whole run with the very ends that it
    /// had.
    fn pieces(&self, chain: &Spanned, whole: Option<&[Piece]>) -> Option<(Vec<Piece>, Vec<Span>)> {
        let Spanned { bends, spans } = chain;
        let (states, count) = (bends.states(), spans.len());
        let wraps = self.trace.points.len();
        let mut points: Vec<_> = states.iter().map(|s| self.frame.to_world(s.at)).collect();
        if chain.is_loop() {
            points[count] = points[0];
        } else if let (Some([first, .., last]), Ends::Held { start, end, .. }) = (whole, bends.ends) {
            if start == Hold::Place {
                points[0] = first.arc.start();
            }
            if end == Hold::Place {
                points[count] = last.arc.end();
            }
        }
        let mut places: Vec<Place> = vec![spans[0].from];
        for i in 1..count {
            places.push(Place::nearest(self.trace, points[i], joined(spans[i - 1], spans[i], wraps)));
        }
        places.push(spans[count - 1].to);
        if chain.is_loop() {
            let seam = Place::nearest(self.trace, points[0], joined(spans[count - 1], spans[0], wraps));
            places[count] = seam;
            places[0] = seam;
            if seam.index >= wraps {
                places[0].index -= wraps;
            } else {
                places[1..].iter_mut().for_each(|place| place.index += wraps);
            }
        }
        let piece = |i: usize| {
            let bend = &bends.pieces[i];
            let bulge = if bend.straight { 0.0 } else { (0.25 * bend.curvature * bend.length).tan() };
            let arc = Arc::from_bulge(points[i], points[i + 1], self.frame.z(), bulge).ok()?;
            let span = Span { from: places[i], to: places[i + 1] };
            let ordered = span.from.along() <= span.to.along();
            ordered.then_some(Piece { arc, span, smooth: chain.is_loop() || i > 0 })
        };
        let pieces: Vec<Piece> = (0..count).map(piece).collect::<Option<_>>()?;
        let spans = pieces.iter().map(|p| p.span).collect();
        Some((pieces, spans))
    }
}

impl Spanned {
    fn is_loop(&self) -> bool {
        matches!(self.bends.ends, Ends::Loop { .. })
    }

    /// How many pieces from one on are a bend to one side between two lines, or a line and an end; `None` if that is less than three.
    fn bend_between_lines(&self, from: usize) -> Option<usize> {
        let pieces = &self.bends.pieces;
        let is_line = |i: usize| pieces.get(i).is_none_or(|piece| piece.straight);
        let side = pieces[from].curvature;
        let count = pieces[from..].iter().take_while(|piece| !piece.straight && piece.curvature * side > 0.0).count();
        let bounded = (from == 0 || is_line(from - 1)) && is_line(from + count);
        (count > 2 && count <= MOST_OF_BEND && bounded).then_some(count)
    }

    /// A part that keeps its ends, but for those of an open chain, which turn.
    fn part(&self, range: std::ops::Range<usize>) -> Self {
        let states = self.bends.states();
        let (mut start, mut end) = (Hold::PlaceAndAngle, Hold::PlaceAndAngle);
        if let Ends::Held { start: first, end: last, .. } = self.bends.ends {
            start = if range.start == 0 { first } else { start };
            end = if range.end == self.spans.len() { last } else { end };
        }
        let ends = Ends::Held { start, end, target: states[range.end] };
        let pieces = self.bends.pieces[range.clone()].to_vec();
        let bends = Bends { start: states[range.start], pieces, ends, shortest: self.bends.shortest };
        Self { bends, spans: self.spans[range].to_vec() }
    }

    fn put(&mut self, range: std::ops::Range<usize>, part: Self) {
        if range.start == 0 {
            self.bends.start = part.bends.start;
        }
        self.bends.pieces.splice(range.clone(), part.bends.pieces);
        self.spans.splice(range, part.spans);
    }
}
