//! What is refused of a blend: balls that do not fit into the tube, blends that fold, tubes that end within them, contacts that turn back.

use super::ball_loop::BallLoop;
use super::setup::Setup;
use crate::base::quat::Quat;
use crate::base::vector::Vec3;
use crate::construct::bodies::tight_place::TightPlace;
use crate::error::{ContactError, Error, PipeError, Result};
use std::f64::consts::TAU;

/// Places of a piece that are looked at.
const PLACES: u32 = 12;
/// The part of the tube beyond the blend is longer than this part of its radius.
const LEAST_REST: f64 = 1e-3;

fn places() -> impl Iterator<Item = f64> + Clone {
    (0..=PLACES).map(|k| f64::from(k) / f64::from(PLACES))
}

/// Refuses a blend that folds, by the larger balls of its skins.
///
/// # Errors
/// `contact-blend-folds`.
pub(super) fn check_folds(setup: &Setup, balls: &BallLoop, depth: f64) -> Result<TightPlace> {
    let tightest = balls.pieces.iter().fold(TightPlace::NONE, |tightest, piece| {
        let canal = piece.canal.offset((setup.sigma * depth).max(0.0));
        tightest.or_of_piece(|s| canal.least_jacobian(s), |s| piece.angle_at(s).rem_euclid(TAU) % TAU)
    });
    if tightest.left > 0.0 {
        Ok(tightest)
    } else {
        Err(ContactError::BlendFolds { angle: tightest.angle, left: tightest.left }.into())
    }
}

/// Refuses a ball that does not fit into the tube, or whose contact is beyond the apex.
///
/// # Errors
/// `ball-does-not-fit`, `contact-loop-open` (no ball does), `radius-not-positive`.
pub(super) fn check_tube(setup: &Setup, balls: &BallLoop, depth: f64) -> Result<()> {
    for piece in &balls.pieces {
        for s in places() {
            let height = piece.height_at(setup, 0.0, s);
            let radius = setup.radius_at(0.0, height);
            let rest = setup.radius_at(depth, height);
            if !(radius > 0.0 && rest > 0.0) {
                return Err(setup.beyond_apex(depth.max(0.0), height));
            }
            // How far on this side of the axis the center is.
            let measured = radius - setup.ball * setup.cos;
            if setup.sigma < 0.0 && !(measured > 0.0) {
                return Err(match setup.ball_on_axis().filter(|limit| *limit > 0.0 && *limit <= setup.ball) {
                    Some(limit) => Error::Pipe(PipeError::BallDoesNotFit { radius: setup.ball, limit }),
                    None => Error::Contact(ContactError::LoopOpen {
                        ring: false,
                        angle: piece.angle_at(s).rem_euclid(TAU),
                        measured,
                    }),
                });
            }
        }
    }
    Ok(())
}

/// Refuses a tube that ends within the blend of a skin.
///
/// # Errors
/// `contact-tube-too-short`; `radius-not-positive` of a cone that has ended before.
pub(super) fn check_end(setup: &Setup, balls: &BallLoop, depth: f64, short: f64) -> Result<()> {
    let heights = balls.pieces.iter().flat_map(|piece| places().map(|s| piece.height_at(setup, depth, s)));
    let needed = heights.fold(f64::NEG_INFINITY, f64::max) + LEAST_REST * setup.rho.abs() + short;
    if !(setup.end > needed) {
        return Err(ContactError::TubeTooShort { end: setup.end - setup.shift, needed: needed - setup.shift }.into());
    }
    let last = setup.end - short;
    if setup.radius_at(depth, last) > 0.0 { Ok(()) } else { Err(setup.beyond_apex(depth, last)) }
}

/// Refuses contacts with a sphere that turn back seen from the pole to which the rest of it goes: great circles to it would cross.
///
/// # Errors
/// `contact-loop-turns-back`.
pub(super) fn check_turning(balls: &BallLoop, pole: Quat) -> Result<()> {
    let seen = |n: Vec3| pole.conj().rotate(n);
    let angle = |n: Vec3| n.y.atan2(n.x);
    let (mut sum, mut sign) = (0.0, 0.0);
    for piece in &balls.pieces {
        for (from, to) in places().zip(places().skip(1)) {
            let [a, b] = [from, to].map(|s| angle(seen(piece.second_normal(s))));
            let step = (b - a + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
            if sign == 0.0 {
                sign = step.signum();
            }
            sum += step;
            if !(step * sign > 0.0) {
                return Err(ContactError::LoopTurnsBack { angle: piece.angle_at(from).rem_euclid(TAU) }.into());
            }
        }
    }
    if (sum.abs() - TAU).abs() < 1.0 { Ok(()) } else { Err(ContactError::LoopTurnsBack { angle: 0.0 }.into()) }
}
