//! A radius of the ball with which a crossing is made, named where the given one is beyond the bound of the ball itself.

use super::super::angle_law::Law;
use super::PipeCrossing;
use crate::error::{BallError, CrossingError, Error};

/// Radii that are tried differ by this factor,
const SMALLER: f64 = 0.8;
/// the first one from the bound by this power of it,
const BESIDE_BOUND: f64 = 5e-3;
/// and there are so many of them: down to a five-hundredth of the bound.
const RADII: u32 = 28;
/// Halvings of the last factor.
const HALVINGS: u32 = 4;

/// What the radii beside a bound gave.
enum Tried {
    /// One with which the crossing is made.
    Works(f64),
    /// With all of them the blend folds, or its hole goes too far round.
    NoneWorks,
    /// Something else is wrong, or the radius changes.
    Unknown,
}

impl PipeCrossing {
    /// The error of a ball beyond its bound, with a radius that works: the bound is that of the ball alone, where the blend may fold, or its hole go too
    /// far round.
    pub(super) fn with_working_radius(&self, error: Error) -> Error {
        let (radius, limit, factor) = match error {
            Error::Crossing(CrossingError::BallTooLarge { radius, limit, .. }) if limit > 0.0 => {
                (radius, limit, SMALLER)
            }
            Error::Ball(BallError::RadiusTooSmall { radius, limit, .. }) => (radius, limit, 1.0 / SMALLER),
            error => return error,
        };
        match (self.try_radii(limit, factor), error) {
            (Tried::NoneWorks, _) => CrossingError::NoBallWorks { radius, limit }.into(),
            (Tried::Works(works), Error::Crossing(_)) => {
                CrossingError::BallTooLarge { radius, limit, works: Some(works) }.into()
            }
            (Tried::Works(works), _) => BallError::RadiusTooSmall { radius, limit, works: Some(works) }.into(),
            (Tried::Unknown, error) => error,
        }
    }

    fn try_radii(&self, bound: f64, factor: f64) -> Tried {
        let [least, most] = self.law.range();
        if least < most {
            return Tried::Unknown;
        }
        let fault = |radius: f64| {
            let made = Law::new(&[[0.0, radius]]).and_then(|law| Self { law, ..self.clone() }.made_as_asked());
            made.err()
        };
        let is_of_blend = |error: &Error| {
            matches!(
                error,
                Error::Crossing(
                    CrossingError::Folds { .. }
                        | CrossingError::HoleTooWide { .. }
                        | CrossingError::HoleTurnsBack { .. }
                )
            )
        };
        let (mut fails, mut works) = (bound, bound * factor.powf(BESIDE_BOUND));
        let mut found = false;
        for _ in 0..RADII {
            match fault(works) {
                None => {
                    found = true;
                    break;
                }
                Some(error) if is_of_blend(&error) => (fails, works) = (works, works * factor),
                Some(_) => return Tried::Unknown,
            }
        }
        if !found {
            return Tried::NoneWorks;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (fails + works);
            if fault(middle).is_none() { works = middle } else { fails = middle }
        }
        Tried::Works(works)
    }
}
