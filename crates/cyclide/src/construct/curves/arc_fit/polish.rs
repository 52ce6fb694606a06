//! Fewer pieces and the least deviation, once a chain within the tolerance is known
//! (`docs/math/arc-fitting.md#least-deviation`).
//!
//! A search spends the tolerance wherever it likes. Afterwards two neighbours become one piece where least squares find such
//! a chain within the tolerance, and then all pieces are moved to the least squares of their points. Short chains are moved as
//! a whole; long ones in windows that keep their ends, each in the order of the chain.

use super::bends::{Bend, Bends, Ends, Matched, State};
use super::certificate::certify;
use super::options::{ArcFitOptions, ArcLimits, FitTarget};
use super::piece::{Piece, Place, Span, joined};
use super::trace::Trace;
use crate::base::frame::Frame;
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
/// Steps of least squares, of a whole chain, of a window, and of two pieces that are merged.
const WHOLE_STEPS: usize = 16;
const WINDOW_STEPS: usize = 4;
const MERGE_STEPS: usize = 7;
/// The curvature of a piece may become this many times the largest before.
const NO_TIGHTER: f64 = 2.0;
/// The power of the distances that stands for the largest of them.
const HIGH_POWER: i32 = 8;

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
        return polish.run(&pieces, true).unwrap_or(pieces);
    }
    starts.push(pieces.len());
    let runs = starts.windows(2).map(|w| &pieces[w[0]..w[1]]);
    runs.flat_map(|run| polish.run(run, false).unwrap_or_else(|| run.to_vec())).collect()
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
    /// A run between corners or all round; `None` if it has too few pieces.
    fn run(&self, pieces: &[Piece], is_loop: bool) -> Option<Vec<Piece>> {
        if pieces.len() < if is_loop { 3 } else { 2 } {
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
        let mut chain = Spanned { bends: self.bends(pieces, is_loop)?, spans };
        self.merge(&mut chain);
        self.refine(&mut chain);
        self.pieces(&chain, Some(pieces)).map(|found| found.0)
    }

    fn bends(&self, pieces: &[Piece], is_loop: bool) -> Option<Bends> {
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
            Bend { curvature: if straight { 0.0 } else { sweep / length }, length, straight, points }
        };
        let pieces: Vec<Bend> = pieces.iter().map(bend).collect();
        let turn = pieces.iter().map(|b| b.curvature * b.length).sum::<f64>();
        // What the search did not need is no gain: no piece becomes far tighter than the tightest.
        let tightest = pieces.iter().map(|b| b.curvature.abs()).fold(0.0, f64::max);
        let limits = self.options.limits();
        let limits = ArcLimits { curvature: limits.curvature.min(NO_TIGHTER * tightest), ..limits };
        let mut bends = Bends { start, pieces, ends: Ends::Loop { turn }, limits };
        if is_loop {
            // Smooth all round: a whole number of turns.
            let turn = std::f64::consts::TAU * (turn / std::f64::consts::TAU).round();
            bends.ends = Ends::Loop { turn };
        } else {
            let end = *bends.states().last()?;
            bends.ends = Ends::Held { start_angle: false, end, end_angle: false };
        }
        Some(bends)
    }

    /// Two neighbours become one where that stays within the tolerance.
    fn merge(&self, chain: &mut Spanned) {
        let fewest = if chain.is_loop() { 3 } else { 1 };
        let mut i = 0;
        while i + 1 < chain.spans.len() && chain.spans.len() > fewest {
            let whole = chain.spans.len() <= WHOLE / 2;
            let range = if whole {
                0..chain.spans.len()
            } else {
                i.saturating_sub(BESIDE)..(i + 2 + BESIDE).min(chain.spans.len())
            };
            let part = if whole { chain.clone() } else { chain.part(range.clone()) };
            match self.merged(&part, i - range.start) {
                Some(found) if whole => *chain = found,
                Some(found) => chain.put(range, found),
                None => {
                    i += 1;
                    continue;
                }
            }
            i = i.saturating_sub(1);
        }
    }

    /// The chain with two pieces as one, and the others moved with it.
    fn merged(&self, chain: &Spanned, at: usize) -> Option<Spanned> {
        let [a, b] = [&chain.bends.pieces[at], &chain.bends.pieces[at + 1]];
        let length = a.length + b.length;
        let curvature = (a.curvature * a.length + b.curvature * b.length) / length;
        let mut spans = chain.spans.clone();
        let second = spans.remove(at + 1);
        spans[at] = joined(spans[at], second, self.trace.points.len());
        let as_line: &[bool] = if a.straight || b.straight { &[true, false] } else { &[false] };
        as_line.iter().find_map(|straight| {
            let points = a.points.iter().chain(&b.points).copied().collect();
            let curvature = if *straight { 0.0 } else { curvature };
            let one = Bend { curvature, length, straight: *straight, points };
            let mut fewer = chain.bends.clone();
            fewer.pieces.splice(at..at + 2, [one]);
            let mut bends = fewer.closed()?.refined(2, MERGE_STEPS, f64::INFINITY);
            if bends.deviation() > self.tolerance {
                bends = bends.refined(HIGH_POWER, MERGE_STEPS, f64::INFINITY);
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
            let squares = part.bends.clone().refined(2, steps, limit);
            let raised = squares.deviation() > before;
            let bends = if raised { squares.refined(HIGH_POWER, steps, limit) } else { squares };
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
        } else if let Some([first, .., last]) = whole {
            points[0] = first.arc.start();
            points[count] = last.arc.end();
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

    /// A part that keeps its ends, but for those of an open chain, which turn.
    fn part(&self, range: std::ops::Range<usize>) -> Self {
        let states = self.bends.states();
        let turns = |at_end: bool| at_end && !self.is_loop();
        let ends = Ends::Held {
            start_angle: !turns(range.start == 0),
            end: states[range.end],
            end_angle: !turns(range.end == self.spans.len()),
        };
        let pieces = self.bends.pieces[range.clone()].to_vec();
        let bends = Bends { start: states[range.start], pieces, ends, limits: self.bends.limits };
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
