//! A pipe with several branches: tees one behind the other, which share the circles between them.

use super::body::body_of;
use super::law::RadiusLaw;
use super::skin::Stand;
use super::{PipeTee, SPANS, check_finite, too_many_pieces};
use crate::error::{Error, ErrorItem, Result};
use crate::surface::CrossingCylinders;
use crate::topology::Body;

/// A branch of a pipe, upwards.
///
/// ```
/// use cyclide::{Branch, PipeManifold};
/// let branch = |position| Branch { position, radius: 0.8, offset: 0.0, ball_radius: 0.3, height: 4.0 };
/// let manifold = PipeManifold::new(2.0, &[branch(0.0), branch(5.0)], 1e-3)?;
/// assert!(manifold.body([-4.0, 9.0], Some(0.1))?.is_solid());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Branch {
    /// Coordinate of its axis along the pipe.
    pub position: f64,
    /// Its radius.
    pub radius: f64,
    /// The way along y from the axis of the pipe to its own.
    pub offset: f64,
    /// Radius of the ball that rounds the corner.
    pub ball_radius: f64,
    /// Height of its end over the axis of the pipe.
    pub height: f64,
}

/// A pipe along x with branches along z, each blended as in a [`PipeTee`].
///
/// ```
/// use cyclide::{Branch, PipeManifold};
/// let branch = |position, radius| Branch { position, radius, offset: 0.0, ball_radius: 0.3, height: 4.0 };
/// let manifold = PipeManifold::new(2.0, &[branch(5.0, 1.2), branch(0.0, 0.8)], 1e-3)?; // in any order
/// assert!(manifold.deviation() <= 1e-3 && manifold.tees().len() == 2);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct PipeManifold {
    /// In order along the pipe.
    tees: Vec<(PipeTee, Branch)>,
}

impl PipeManifold {
    /// From the radius of the pipe and its branches, with balls whose radii are constant within the tolerance.
    ///
    /// # Errors
    /// `too-few-points` (no branch), and as [`PipeTee::new`].
    pub fn new(radius: f64, branches: &[Branch], tolerance: f64) -> Result<Self> {
        if !(tolerance > 0.0) {
            return Err(Error::ToleranceNotPositive { tolerance });
        }
        if branches.is_empty() {
            return Err(Error::TooFewPoints { given: 0, needed: 1 });
        }
        let mut parts = Vec::with_capacity(branches.len());
        for branch in branches {
            check_finite(ErrorItem::Distance, branch.position)?;
            let pair = CrossingCylinders::new([radius, branch.radius], -0.5 * branch.offset)?;
            parts.push((pair, RadiusLaw::new(&[[0.0, branch.ball_radius]])?, *branch));
        }
        parts.sort_by(|a, b| a.2.position.total_cmp(&b.2.position));
        let mut least = f64::INFINITY;
        // As many spans in all, so that they share circles.
        for spans in SPANS {
            let tees = parts.iter().map(|(pair, law, branch)| (PipeTee::with_spans(*pair, law, spans), *branch));
            let made = Self { tees: tees.collect() };
            least = least.min(made.deviation());
            if made.deviation() <= tolerance {
                made.tees.iter().try_for_each(|(tee, _)| tee.check_folds(0.0))?;
                return Ok(made);
            }
        }
        Err(too_many_pieces(least / tolerance))
    }

    /// The largest difference of a radius from what was asked for, over nine places of each patch.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.tees.iter().map(|(tee, _)| tee.deviation()).fold(0.0, f64::max)
    }

    /// The tees in order along the pipe, with their branches.
    #[must_use]
    pub fn tees(&self) -> &[(PipeTee, Branch)] {
        &self.tees
    }

    /// The solid between two coordinates along the pipe, with a wall of even thickness if one is given, its ends plane.
    ///
    /// # Errors
    /// As [`PipeTee::body`]; `parameter-out-of-range` too for branches whose blends reach into each other.
    pub fn body(&self, ends: [f64; 2], wall: Option<f64>) -> Result<Body> {
        ends.into_iter().try_for_each(|end| check_finite(ErrorItem::Reach, end))?;
        let stands: Vec<Stand> = self
            .tees
            .iter()
            .map(|(tee, branch)| Stand { tee, position: branch.position, height: branch.height })
            .collect();
        body_of(&stands, ends, wall)
    }
}
