//! The loop of a branch cut for the faces of the main pipe round its hole.
//!
//! Unrolled, the main pipe is a rectangle and the contact a loop in it. Four points of the loop, where it runs at 45 degrees to the pipe, part it: the
//! sides towards the ends of the pipe are ruled to the ends, those along the pipe have arcs across, and the four corners between are rectangles
//! (`docs/math/pipe-tees.md#faces`).

use super::canal::Canal;
use super::crossing::Crossing;
use super::loop_piece::LoopPiece;
use crate::base::bernstein;
use crate::error::{Error, Result, TeeError};
use crate::rational::Polynomial;

/// Places of a piece at which directions are looked at.
const PLACES: usize = 16;
/// A node is a corner if it is nearer to one than this part of the piece.
const NEAR: f64 = 0.1;
/// Steps in which a place between two others is found.
const STEPS: u32 = 60;
/// Halvings of pieces whose weights are not all positive.
const HALVINGS: u32 = 12;

/// The loop from the corner at its end and low angles on, with the numbers of the pieces that start its four sides: towards the end of the main pipe, beside it, towards
/// its start, beside it on the other side; last that of all pieces.
#[derive(Debug, Clone)]
pub(super) struct Partition {
    pub(super) pieces: Vec<LoopPiece>,
    pub(super) sides: [usize; 5],
}

/// The direction of the loop in the unrolled main pipe at a parameter of a piece: along it, and round it.
fn direction(crossing: &Crossing, piece: &LoopPiece, t: f64) -> [f64; 2] {
    let forms = crossing.forms(piece);
    let both = |p: &Polynomial| -> [f64; 2] {
        let rows: Vec<[f64; 1]> = p.coefficients().iter().map(|&c| [c]).collect();
        let [[v], [d]] = bernstein::derivatives::<1, 2>(&rows, t);
        [v, d]
    };
    let ([h, dh], [w, dw]) = (both(&forms.along), both(&forms.weight));
    let ([c, dc], [s, ds]) = (both(&forms.on_main[0]), both(&forms.on_main[1]));
    [(dh * w - h * dw) / (w * w), crossing.radii[1] * 2.0 * (ds * c - s * dc) / (c * c + s * s)]
}

/// Which of the four quarters between corners a direction is in, from that towards the end of the pipe on.
fn quarter([along, round]: [f64; 2]) -> usize {
    match (along + round > 0.0, along - round < 0.0) {
        (true, true) => 0,
        (false, true) => 1,
        (false, false) => 2,
        (true, false) => 3,
    }
}

/// Whether a direction is well off along and across.
fn leans([along, round]: [f64; 2]) -> bool {
    along.abs() >= 0.25 * round.abs() && round.abs() >= 0.25 * along.abs()
}

impl Partition {
    /// # Errors
    /// `tee-hole-folds` if the loop does not turn once round through all directions.
    pub(super) fn new(crossing: &Crossing, pieces: &[LoopPiece]) -> Result<Self> {
        if crossing.equal {
            return Ok(Self::from_flank_to_flank(crossing, pieces));
        }
        // Nodes that are near enough to corners are taken for them, unless there are too few.
        let (mut cut, corners) =
            with_corners(crossing, pieces, NEAR).or_else(|_| with_corners(crossing, pieces, 0.0))?;
        // Every side again by itself, finer where weights ask for it.
        let count = cut.len();
        cut.rotate_left(corners[3]);
        let starts = [0, 1, 2].map(|k: usize| (corners[k] + count - corners[3]) % count);
        let bounds = [0, starts[0], starts[1], starts[2], count];
        let mut sides: Vec<Vec<LoopPiece>> = Vec::new();
        for pair in bounds.windows(2) {
            let mut side = Vec::new();
            for piece in cut.get(pair[0]..pair[1]).unwrap_or_default() {
                add_positive(crossing, *piece, HALVINGS, &mut side);
            }
            sides.push(side);
        }
        // The lines behind the pipe join the nodes of both sides one by one.
        let most = sides[1].len().max(sides[3].len());
        for k in [1, 3] {
            while sides[k].len() < most && !sides[k].is_empty() {
                halve_largest(&mut sides[k]);
            }
        }
        let mut starts = [0; 5];
        for (k, side) in sides.iter().enumerate() {
            starts[k + 1] = starts[k] + side.len();
        }
        Ok(Self { pieces: sides.concat(), sides: starts })
    }
}

impl Partition {
    /// The loop of equal pipes: nothing is beside the hole, which has its corners at the flanks.
    fn from_flank_to_flank(crossing: &Crossing, pieces: &[LoopPiece]) -> Self {
        let mut sides = [Vec::new(), Vec::new()];
        for piece in pieces {
            add_positive(crossing, *piece, HALVINGS, &mut sides[usize::from(!piece.is_ahead())]);
        }
        let (ahead, count) = (sides[0].len(), sides[0].len() + sides[1].len());
        Self { pieces: sides.concat(), sides: [0, ahead, ahead, count, count] }
    }
}

/// The pieces cut at the corners, and the numbers of those that start there: where the quarters 1, 2, 3 and 0 begin.
fn with_corners(crossing: &Crossing, pieces: &[LoopPiece], near: f64) -> Result<(Vec<LoopPiece>, [usize; 4])> {
    let mut cut: Vec<LoopPiece> = Vec::new();
    let mut corners = [None; 4];
    let at = |piece: &LoopPiece, t: f64| quarter(direction(crossing, piece, t));
    // A corner that is taken to be the start of the next piece.
    let mut waiting: Option<usize> = None;
    for piece in pieces {
        if let Some(kind) = waiting.take() {
            corners[kind] = Some(cut.len());
        }
        let mut rest = *piece;
        let mut before = at(piece, 0.0);
        for k in 1..=PLACES {
            let (low, high) = ((k - 1) as f64 / PLACES as f64, k as f64 / PLACES as f64);
            let now = at(piece, high);
            if now == before {
                continue;
            }
            let kind = (now + 3) % 4;
            if now != (before + 1) % 4 || corners[kind].is_some() || waiting.is_some() {
                return Err(TeeError::HoleFolds {
                    branch: crossing.branch,
                    angle: crossing.true_angle(piece.angle(high)),
                }
                .into());
            }
            let place = change(|t| at(piece, t) == before, [low, high]);
            before = now;
            let angle = piece.angle(place);
            let span = piece.to - piece.from;
            if angle - rest.from <= near * span && leans(direction(crossing, piece, 0.0)) {
                corners[kind] = Some(cut.len());
            } else if piece.to - angle <= near * span && leans(direction(crossing, piece, 1.0)) {
                waiting = Some(kind);
            } else {
                cut.push(rest.part(rest.from, angle));
                rest = rest.part(angle, rest.to);
                corners[kind] = Some(cut.len());
            }
        }
        cut.push(rest);
    }
    if let Some(kind) = waiting {
        corners[kind] = Some(0);
    }
    let fold = || Error::Tee(TeeError::HoleFolds { branch: crossing.branch, angle: 0.0 });
    let mut found = [0; 4];
    for (place, corner) in found.iter_mut().zip(corners) {
        *place = corner.ok_or_else(fold)?;
    }
    let distinct = (0..4).all(|i| (0..i).all(|j| found[i] != found[j]));
    if distinct { Ok((cut, found)) } else { Err(fold()) }
}

/// The place between two at which something ceases to hold.
fn change(holds: impl Fn(f64) -> bool, [mut low, mut high]: [f64; 2]) -> f64 {
    for _ in 0..STEPS {
        let middle = 0.5 * (low + high);
        if holds(middle) { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Adds a piece, in halves where a weight of its canal is not positive.
fn add_positive(crossing: &Crossing, piece: LoopPiece, halvings: u32, to: &mut Vec<LoopPiece>) {
    // Weights are those of all skins.
    if halvings == 0 || Canal::new(crossing, &piece, 0.0).surface().is_ok_and(|s| s.has_positive_weights()) {
        to.push(piece);
        return;
    }
    let middle = 0.5 * (piece.from + piece.to);
    add_positive(crossing, piece.part(piece.from, middle), halvings - 1, to);
    add_positive(crossing, piece.part(middle, piece.to), halvings - 1, to);
}

/// Halves the piece that turns farthest.
fn halve_largest(side: &mut Vec<LoopPiece>) {
    let span = |k: usize| side[k].to - side[k].from;
    let largest = (1..side.len()).fold(0, |best, k| if span(k) > span(best) { k } else { best });
    let piece = side[largest];
    let middle = 0.5 * (piece.from + piece.to);
    side[largest] = piece.part(piece.from, middle);
    side.insert(largest + 1, piece.part(middle, piece.to));
}
