//! A radius of the ball with which a crossing is made, named where the given one is beyond the bound of the ball itself.

use super::super::angle_law::Law;
use super::PipeCrossing;

/// Radii that are tried differ by this factor,
pub(super) const SMALLER: f64 = 0.8;
/// the first one from the bound by this power of it,
const BESIDE_BOUND: f64 = 5e-3;
/// and there are so many of them: down to a five-hundredth of the bound.
const RADII: u32 = 28;
/// Halvings of the last factor.
const HALVINGS: u32 = 4;

impl PipeCrossing {
    /// A radius beside a bound with which the crossing is made: the bound is that of the ball alone, where the blend may fold, or its hole go too far
    /// round. `None` if there is none, and of a radius that changes.
    pub(super) fn working_radius(&self, bound: f64, factor: f64) -> Option<f64> {
        let [least, most] = self.law.range();
        let is_made = |radius: f64| {
            let law = Law::new(&[[0.0, radius]]);
            law.is_ok_and(|law| Self { law, ..self.clone() }.made_as_asked().is_ok())
        };
        if least < most {
            return None;
        }
        let (mut fails, mut works) = (bound, bound * factor.powf(BESIDE_BOUND));
        let mut tries = 0;
        while !is_made(works) {
            (fails, works) = (works, works * factor);
            tries += 1;
            if tries == RADII {
                return None;
            }
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (fails + works);
            if is_made(middle) { works = middle } else { fails = middle }
        }
        Some(works)
    }
}
