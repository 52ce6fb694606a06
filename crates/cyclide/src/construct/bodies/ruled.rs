//! Ruled surfaces: straight lines between two curves, exact.
//!
//! Between rational curves of degrees m and n the surface has the degree (max(m, n), 1): the one of lower degree is raised, and each
//! keeps its weights. With weights of 1 at both ends of all pieces the rulings there run at uniform speed, so that neighbors share
//! their edges.

use super::bands::Bands;
use super::kinks::kinks;
use super::rail_surface::RailSurface;
use super::rails::{RailPiece, rail_pieces};
use super::rulings::check_rulings;
use crate::error::{PointError, Result};
use crate::topology::{Body, EdgeCurve};

/// Pieces nearer to each other than this part of their coordinates are one.
const SAME: f64 = 1e-12;
/// Places of a piece at which that is looked at.
const PLACES: u32 = 8;

impl Body {
    /// The surface of straight lines between two rails, open or (`closed`) round: piece by piece, at equal parameters. Where the rails meet, a
    /// face has three sides. Arcs run at the same speed at both ends, and those of more than a third of a turn are cut.
    ///
    /// # Errors
    /// `piece-counts-differ`, `too-few-points` (no piece), `disconnected`, `weight-not-positive`; `coincident-points` (a piece of one rail is that of the other); `rulings-cross`.
    pub fn ruled(rails: [&[EdgeCurve]; 2], closed: bool) -> Result<Self> {
        RailSurface::ruled(rails, closed).map(RailSurface::into_body)
    }
}

impl RailSurface {
    /// The surface of straight lines between two rails: see [`Body::ruled`].
    ///
    /// # Errors
    /// As [`Body::ruled`].
    pub fn ruled(rails: [&[EdgeCurve]; 2], closed: bool) -> Result<Self> {
        let pieces = rail_pieces(rails, closed)?;
        check_apart(&pieces)?;
        let rail = |k: usize| pieces.iter().map(|piece| piece.curves[k].clone()).collect::<Vec<_>>();
        let mut bands = Bands::default();
        let first = bands.ring(rail(0), closed);
        let second = bands.ring_beside(rail(1), closed, &first);
        bands.ruled([&first, &second])?;
        let body = bands.finish()?;
        let starts: Vec<Option<usize>> = pieces.iter().map(RailPiece::joint).collect();
        let warnings = kinks(rails, closed, &body, &starts).into_iter().collect();
        Ok(Self { body, warnings })
    }
}

/// Refuses pieces between which there is no surface.
fn check_apart(pieces: &[RailPiece]) -> Result<()> {
    for piece in pieces {
        let [first, second] = &piece.curves;
        let places = || (0..=PLACES).map(|k| f64::from(k) / f64::from(PLACES));
        let distance = places().map(|s| first.point(s).distance(second.point(s))).fold(0.0, f64::max);
        let limit = SAME * places().map(|s| first.point(s).to_vec().max_abs()).fold(0.0, f64::max);
        if distance <= limit {
            return Err(PointError::CoincidentPoints { first: 0, second: 1, distance, limit }.into());
        }
        check_rulings(piece)?;
    }
    Ok(())
}
