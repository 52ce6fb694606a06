//! What is refused of a crossing: blends that fold, holes that go too far round a pipe.

use super::ball_loop::BallLoop;
use crate::error::{Error, Result};
use std::f64::consts::TAU;

/// Places of a piece at which folds are looked for.
const PLACES: u32 = 12;
/// A part of a pipe beyond the blend is longer than this part of its radius.
pub(super) const LEAST_REST: f64 = 1e-3;
/// A hole reaches so far round its pipe, to either side, at most.
const FARTHEST: f64 = 2.6;

/// Where a blend comes nearest to folding.
#[derive(Debug, Clone, Copy)]
pub(super) struct TightPlace {
    /// What is left there: 1 where the way of the ball is straight, 0 where the blend folds.
    pub(super) left: f64,
    /// The angle of the ball about the common normal.
    pub(super) angle: f64,
}

/// Refuses a blend that folds, by the larger balls of the inner skin.
///
/// # Errors
/// `crossing-folds`.
pub(super) fn check_folds(balls: &BallLoop, depth: f64) -> Result<TightPlace> {
    let mut tightest = TightPlace { left: f64::INFINITY, angle: 0.0 };
    for piece in &balls.pieces {
        let canal = piece.patch.offset(depth);
        for k in 0..=PLACES {
            let s = f64::from(k) / f64::from(PLACES);
            let across = (0..=PLACES).map(|j| canal.jacobian(s, f64::from(j) / f64::from(PLACES)));
            let left = across.fold(f64::INFINITY, f64::min);
            if left < tightest.left {
                let (center, _) = canal.ball(s);
                tightest = TightPlace { left, angle: center.y.atan2(center.x).rem_euclid(TAU) % TAU };
            }
        }
    }
    if tightest.left > 0.0 {
        Ok(tightest)
    } else {
        Err(Error::CrossingFolds { angle: tightest.angle, left: tightest.left })
    }
}

/// Refuses holes that go too far round.
///
/// # Errors
/// `crossing-hole-too-wide`.
pub(super) fn check_holes(balls: &BallLoop) -> Result<()> {
    for pipe in 0..2 {
        let half = |s: f64, halves: &[crate::rational::Polynomial; 2]| {
            let [c, s] = halves.each_ref().map(|p| p.value(s));
            2.0 * s.atan2(c)
        };
        let angles = balls.pieces.iter().flat_map(|piece| {
            (0..=PLACES).map(move |k| half(f64::from(k) / f64::from(PLACES), &piece.halves[pipe]).abs())
        });
        let angle = angles.fold(0.0, f64::max);
        if !(angle <= FARTHEST) {
            return Err(Error::CrossingHoleTooWide { pipe, angle, limit: FARTHEST });
        }
    }
    Ok(())
}
