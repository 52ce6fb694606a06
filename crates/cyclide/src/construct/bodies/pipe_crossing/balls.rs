//! Balls between two pipes that pass each other, by the law of their radius.

use super::CrossingSide;
use super::contacts::Contacts;
use super::mixed::MixedPair;
use super::torus_pair::TorusPair;
use crate::construct::bodies::angle_law::Law;
use crate::construct::bodies::pierced::Mantle;
use crate::error::Result;

/// A blend keeps to its law to this part of the radius where no tolerance is given.
const DEFAULT_TOLERANCE: f64 = 1e-3;
/// The size of a loop is as the root of what its radius is off that at which it shrinks to a point: within this part of that it keeps its shape.
const PART_OF_ROOM: f64 = 0.1;

/// Balls whose radius follows a law, by the angle of their direction from the common normal of the axes; of cones, which have one radius, by the angle of their
/// loop.
pub(super) struct Balls<'a> {
    pub(super) pair: TorusPair,
    /// Both pipes.
    pub(super) mantles: [Mantle; 2],
    pub(super) mixed: Option<MixedPair>,
    pub(super) law: &'a Law,
    pub(super) tolerance: Option<f64>,
    pub(super) side: CrossingSide,
    /// The radius at which the loop shrinks to a point.
    pub(super) limit: f64,
}

impl Balls<'_> {
    /// Where the ball in a direction touches both pipes.
    pub(super) fn contacts(&self, angle: f64) -> Result<Contacts> {
        self.contacts_of(self.law.at(angle), angle)
    }

    /// The same of the ball with this radius and slope.
    pub(super) fn contacts_of(&self, asked: [f64; 2], angle: f64) -> Result<Contacts> {
        if let Some(mixed) = &self.mixed {
            return mixed.towards(asked, angle);
        }
        self.pair.contacts(asked.map(|x| self.side.sign() * x), angle)
    }

    /// What the radius may be off one that is asked for.
    pub(super) fn allowed(&self, radius: f64) -> f64 {
        let tolerance = self.tolerance.unwrap_or(DEFAULT_TOLERANCE * radius);
        tolerance.min(PART_OF_ROOM * (radius - self.limit).abs())
    }
}
