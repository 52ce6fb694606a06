//! What is refused of a crossing: blends that fold, holes that go too far round a pipe.

use super::ball_loop::BallLoop;
use super::balls::Balls;
use super::law_fold::LawFold;
use crate::construct::bodies::pierced::Node;
use crate::construct::bodies::tight_place::TightPlace;
use crate::error::{CrossingError, Result};
use std::f64::consts::TAU;

/// Places of a piece that are looked at.
const PLACES: u32 = 12;
/// Balls of a loop whose contacts are looked at first.
const ROUND: u32 = 64;
/// A part of a pipe beyond the blend is longer than this part of its radius.
pub(super) const LEAST_REST: f64 = 1e-3;
/// A hole reaches so far round its pipe, to either side, at most.
const FARTHEST: f64 = 2.6;

/// Refuses a blend that folds, by the larger balls of the inner skin.
///
/// # Errors
/// `crossing-folds`.
pub(super) fn check_folds(
    asked: &Balls<'_>,
    fold: Option<&LawFold>,
    balls: &BallLoop,
    depth: f64,
) -> Result<TightPlace> {
    let tightest = balls.pieces.iter().fold(TightPlace::NONE, |tightest, piece| {
        let canal = piece.patch.offset(depth);
        let angle = |s: f64| {
            let (center, _) = canal.ball(s);
            center.y.atan2(center.x).rem_euclid(TAU) % TAU
        };
        tightest.or_of_piece(|s| canal.least_jacobian(s), angle)
    });
    if tightest.left > 0.0 {
        Ok(tightest)
    } else {
        let remedy = LawFold::remedy(fold, asked, depth);
        Err(CrossingError::Folds { angle: tightest.angle, left: tightest.left, remedy, walled: depth > 0.0 }.into())
    }
}

/// Refuses holes that go too far round by their balls, before there is a loop, which would take too many pieces.
///
/// # Errors
/// `crossing-hole-too-wide`; as those of a place of the loop.
pub(super) fn check_reach_round(balls: &Balls<'_>) -> Result<()> {
    let mut farthest = [0.0_f64; 2];
    for k in 0..ROUND {
        let contacts = balls.contacts(TAU * f64::from(k) / f64::from(ROUND))?.at;
        farthest = [0, 1].map(|pipe: usize| farthest[pipe].max(contacts[pipe][1].abs()));
    }
    match farthest.iter().position(|angle| *angle > FARTHEST) {
        Some(pipe) => Err(CrossingError::HoleTooWide { pipe, angle: farthest[pipe], limit: FARTHEST }.into()),
        None => Ok(()),
    }
}

/// Refuses a hole that goes too far round, and one whose border turns back: parts of the pipe would overlap.
///
/// # Errors
/// `crossing-hole-too-wide`, `crossing-hole-turns-back`.
pub(super) fn check_hole(balls: &BallLoop, pipe: usize) -> Result<()> {
    check_width(balls, pipe)?;
    let order = balls.hole_order(pipe);
    let ahead = if order.ahead { 1.0 } else { -1.0 };
    // Towards both ends of the pipe by the angle, beside the hole by the place.
    for (side, sign) in [(0, ahead), (1, -ahead), (2, -ahead), (3, ahead)] {
        let pieces = &order.pieces[order.sides[side]..order.sides[side + 1]];
        let value = |k: usize, s: f64| {
            let piece = &balls.pieces[k];
            if side % 2 == 0 { piece.angle_at(pipe, s) } else { piece.along_at(pipe, s) }
        };
        let turns = |&k: &usize| {
            let back = |pair: &[f64]| !((value(k, pair[1]) - value(k, pair[0])) * sign > 0.0);
            let places: Vec<f64> = places().collect();
            places.windows(2).find(|pair| back(pair)).map(|pair| balls.pieces[k].along_at(pipe, pair[0]))
        };
        let missing = || pieces.is_empty().then(|| balls.pieces[order.pieces[0]].along_at(pipe, 0.0));
        if let Some(along) = pieces.iter().find_map(turns).or_else(missing) {
            return Err(CrossingError::HoleTurnsBack { pipe, along }.into());
        }
    }
    let [_, front, back, rear, count] = order.sides;
    if back - front != count - rear {
        return Err(CrossingError::HoleTurnsBack {
            pipe,
            along: balls.pieces[order.pieces[front]].along_at(pipe, 0.0),
        }
        .into());
    }
    Ok(())
}

fn check_width(balls: &BallLoop, pipe: usize) -> Result<()> {
    let angles = balls.pieces.iter().flat_map(|piece| places().map(move |s| piece.angle_at(pipe, s).abs()));
    let angle = angles.fold(0.0, f64::max);
    if angle <= FARTHEST { Ok(()) } else { Err(CrossingError::HoleTooWide { pipe, angle, limit: FARTHEST }.into()) }
}

/// Refuses a cap that is to be filled from a point in its middle and is not seen from there all round.
///
/// # Errors
/// `crossing-hole-too-wide`, `crossing-hole-turns-back`.
pub(super) fn check_cap(balls: &BallLoop, pipe: usize) -> Result<()> {
    check_width(balls, pipe)?;
    let order = balls.hole_order(pipe);
    let nodes = balls.pieces.iter().map(|piece| piece.node(pipe)).collect::<Vec<_>>();
    let middle = Node::between(&nodes);
    let ahead = if order.ahead { 1.0 } else { -1.0 };
    for piece in &balls.pieces {
        let border = piece.border(pipe);
        let overlaps = |s: &f64| border.turns_about(middle, *s).iter().any(|turn| !(ahead * turn > 0.0));
        if let Some(s) = places().find(overlaps) {
            return Err(CrossingError::HoleTurnsBack { pipe, along: piece.along_at(pipe, s) }.into());
        }
    }
    Ok(())
}

/// Places of a piece from its start to its end.
fn places() -> impl Iterator<Item = f64> {
    (0..=PLACES).map(|k| f64::from(k) / f64::from(PLACES))
}
