//! Where a blend comes nearest to folding, over the pieces of its loop of balls (`docs/math/canal-blends.md#the-canal-patch`).

use crate::base::golden_section::GoldenSection;

/// Places of a piece at which folds are looked for first.
const PLACES: u32 = 24;
/// Sections of the two intervals beside the least value: to 1e-9 of the piece.
const SECTIONS: u32 = 40;

/// Where a blend comes nearest to folding.
#[derive(Debug, Clone, Copy)]
pub(super) struct TightPlace {
    /// What is left there: 1 where the way of the ball is straight, 0 where the blend folds.
    pub(super) left: f64,
    /// The angle there.
    pub(super) angle: f64,
}

impl TightPlace {
    /// Before any piece has been looked at.
    pub(super) const NONE: Self = Self { left: f64::INFINITY, angle: 0.0 };

    /// This one, or that of a piece where less is left at a place of it.
    pub(super) fn or_of_piece(self, left: impl Fn(f64) -> f64, angle: impl FnOnce(f64) -> f64) -> Self {
        let (s, least) = least_below(self.left, left);
        if least < self.left { Self { left: least, angle: angle(s) } } else { self }
    }
}

/// The place of the least value over `[0, 1]` and that value, if it is below a known one: from places close together, and by sections in the golden ratio beside those that are lower than their
/// neighbors.
fn least_below(known: f64, value: impl Fn(f64) -> f64) -> (f64, f64) {
    let at = |k: u32| f64::from(k) / f64::from(PLACES);
    let values: Vec<f64> = (0..=PLACES).map(|k| value(at(k))).collect();
    let mut least = (0.0, known);
    let mut improve = |s: f64, value: f64| {
        if value < least.1 {
            least = (s, value);
        }
        least.1
    };
    for (k, middle) in (0..=PLACES).zip(&values) {
        let best = improve(at(k), *middle);
        let index = k as usize;
        let (before, after) = (index.checked_sub(1).map(|i| values[i]), values.get(index + 1).copied());
        let beside = before.into_iter().chain(after).fold(f64::NEG_INFINITY, f64::max);
        let lowest = before.into_iter().chain(after).all(|other| *middle <= other);
        // A convex function goes no lower between three places; one end has no neighbor to tell.
        let within_reach = before.is_none() || after.is_none() || 2.0 * middle - beside < best;
        if lowest && within_reach {
            let s = GoldenSection::lowest(&value, [at(k.saturating_sub(1)), at((k + 1).min(PLACES))], SECTIONS);
            improve(s, value(s));
        }
    }
    least
}
