//! The pair of pipes whose balls, all outside both or all inside both, are those of a torus: their contacts, and canals along pieces of its plane.

use super::CrossingPipe;
use super::cones::ConePair;
use super::contacts::{Contacts, PieceForms};
use crate::base::planar::{Point2, Vec2};
use crate::construct::bodies::ball_centers::CenterPair;
use crate::construct::bodies::pierced::Mantle;
use crate::error::{CrossingError, Result};
use crate::rational::Polynomial;
use crate::surface::{CanalPatch, SkewCylinders, TorusPiece};

/// Two cylinders, or cones, one at least.
#[derive(Debug, Clone)]
pub(super) enum TorusPair {
    Cylinders(SkewCylinders),
    Cones(Box<ConePair>),
}

impl TorusPair {
    /// Pipes about two axes.
    ///
    /// # Errors
    /// `crossing-axes-too-near`; of cones `angle-out-of-range`.
    pub(super) fn new(pipes: &[CrossingPipe; 2], axes: &SkewCylinders, mantles: &[Mantle; 2]) -> Result<Self> {
        if pipes.iter().any(|pipe| pipe.taper != 0.0) {
            return ConePair::new(axes, mantles).map(|pair| Self::Cones(Box::new(pair)));
        }
        let radii = pipes.map(|pipe| pipe.radius);
        let (distance, limit) = (2.0 * axes.half_gap(), (radii[0] - radii[1]).abs());
        if distance <= limit {
            return Err(CrossingError::AxesTooNear { distance, limit }.into());
        }
        Ok(Self::Cylinders(axes.with_radii(radii)?))
    }

    /// Both, for the surface of the centers.
    pub(super) fn of_centers(&self) -> CenterPair {
        match self {
            Self::Cylinders(pair) => CenterPair::Cylinders(*pair),
            Self::Cones(pair) => CenterPair::Cones(Box::new(*pair.moved())),
        }
    }

    /// The radius of the smallest ball outside both; negative where they overlap.
    pub(super) fn smallest_radius(&self) -> f64 {
        match self {
            Self::Cylinders(pair) => pair.smallest_radius(),
            Self::Cones(pair) => pair.smallest_radius(),
        }
    }

    /// Where the ball at an angle of the loop touches both pipes, by its radius, negative inside, with the slope of that by the angle. Of cylinders it is the angle
    /// about the common normal.
    ///
    /// # Errors
    /// `radius-too-small`, `wrong-side`.
    pub(super) fn contacts(&self, asked: [f64; 2], angle: f64) -> Result<Contacts> {
        match self {
            Self::Cylinders(pair) => {
                let ball = pair.towards(asked, angle)?;
                Ok(Contacts { at: ball.contacts, rates: ball.contact_rates })
            }
            Self::Cones(pair) => pair.contacts(asked[0], angle),
        }
    }

    /// The place of that ball in the plane of the torus, with its rate.
    ///
    /// # Errors
    /// As [`contacts`](Self::contacts).
    pub(super) fn place(&self, asked: [f64; 2], angle: f64) -> Result<(Point2, Vec2)> {
        match self {
            Self::Cylinders(pair) => pair.towards(asked, angle).map(|ball| (ball.place, ball.rate)),
            Self::Cones(pair) => pair.place(asked[0], angle),
        }
    }

    /// Canal, half directions and places along a piece.
    ///
    /// # Errors
    /// As [`CanalPatch::along`].
    pub(super) fn forms(&self, piece: &TorusPiece) -> Result<PieceForms> {
        match self {
            Self::Cylinders(pair) => cylinder_forms(pair, piece),
            Self::Cones(pair) => pair.forms(piece),
        }
    }
}

fn cylinder_forms(pair: &SkewCylinders, piece: &TorusPiece) -> Result<PieceForms> {
    let patch = CanalPatch::along(pair, piece)?;
    let [first, [c, s]] = CanalPatch::half_directions(pair, piece)?;
    let [x, y, _, _] = &patch.center().0;
    let [direction, _] = pair.second_axis();
    let along: [Polynomial; 2] = [x.clone(), &(x * direction.x) + &(y * direction.y)];
    // The second pipe is seen from the first: from below, where its normals have the angle π.
    Ok(PieceForms { patch: patch.with_even_ends(), halves: [first, [s, c]], along })
}
