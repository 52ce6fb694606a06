//! Which start and direction of a curve make a ruled surface without a twist.

use cyclide::{ShortNumber, construct::RailSurface, topology::EdgeCurve};

use crate::document::kinds::ruled::rotated;
use crate::document::kinds::ruled::sense::Rulings;
use crate::document::objects::Builder;

/// Points of a run, and pieces of a rail, that are tried at most.
pub(in crate::document) const MOST_TRIED: usize = 400;

impl Builder<'_> {
    /// Where the second of two closed rails is to start, if that makes the surface between them.
    pub(in crate::document) fn start_of_rail(&self, rails: [&[EdgeCurve]; 2], shift: usize) -> Option<String> {
        let [first, second] = rails;
        let n = second.len();
        if first.len() != n || n > MOST_TRIED {
            return None;
        }
        let reversed: Vec<EdgeCurve> = second.iter().rev().map(EdgeCurve::reversed).collect();
        // What it starts with already is left out for the shift that would be written.
        let far =
            |other: &[EdgeCurve]| first.iter().zip(other).map(|(a, b)| a.start().distance(b.start())).sum::<f64>();
        let best = |curves: &[EdgeCurve]| {
            let mut all: Vec<(usize, Vec<EdgeCurve>)> = (0..n).map(|by| (by, rotated(curves, by))).collect();
            all.sort_by(|a, b| far(&a.1).total_cmp(&far(&b.1)));
            // The nearest ones only: each is made.
            let is_good = |other: &[EdgeCurve]| {
                RailSurface::ruled([first, other], true).is_ok() && !Rulings::of([first, other], true).cross()
            };
            all.into_iter().take(8).find(|(_, other)| is_good(other))
        };
        let as_drawn = if Rulings::of(rails, true).opposite() { None } else { best(second) };
        if let Some((by, other)) = as_drawn {
            let [x, y, z] = other[0].start().to_array().map(ShortNumber);
            let total = (by + shift) % n;
            return Some(format!(
                "the second curve begins at another corner: it should begin {by} of its {n} pieces later, at ({x}, {y}, {z}); write `\"shift\": {total}`"
            ));
        }
        let (by, other) = best(&reversed)?;
        let [x, y, z] = other[0].start().to_array().map(ShortNumber);
        // Reversed, it starts at the corner it was drawn from, before its pieces are shifted.
        let total = (by + n - shift % n) % n;
        let start = match total {
            0 if shift > 0 => ", and remove `shift`".to_owned(),
            0 => String::new(),
            total => format!(", and write `\"shift\": {total}`"),
        };
        Some(format!(
            "the second curve runs the other way: use a `transform` of it with the steps `[\"reverse\"]`{start}, so that it begins at ({x}, {y}, {z})"
        ))
    }

    /// What is to be done with a rail that runs against the other one, if the surface between them goes through itself and does not the other way round.
    pub(in crate::document) fn rail_to_reverse(&self, rails: [&[EdgeCurve]; 2], shift: usize) -> Option<String> {
        let rulings = Rulings::of(rails, true);
        if !rulings.opposite() || !rulings.cross() { None } else { self.start_of_rail(rails, shift) }
    }
}
