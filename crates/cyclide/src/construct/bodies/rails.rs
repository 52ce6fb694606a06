//! Two curves as rails, piece by piece: what ruled and circular surfaces are made between.

use super::LARGEST_ARC;
use super::input_chain::{check_connected, check_weights};
use crate::curve::Arc;
use crate::error::{BridgeError, PointError, Result};
use crate::rational::RationalBezier;
use crate::topology::EdgeCurve;

/// A piece of both rails, with the part of the piece as given that it is.
#[derive(Debug, Clone)]
pub(super) struct RailPiece {
    pub(super) curves: [EdgeCurve; 2],
    /// The piece as given, from 0.
    pub(super) piece: usize,
    /// Its place in that piece.
    pub(super) part: [f64; 2],
}

/// The pieces of two rails, the first with the first. Arcs run at equal speeds at both ends, and are cut, with the piece on the
/// other rail, to a third of a turn; a closed pair has two pieces at least.
///
/// # Errors
/// `too-few-points` (no piece), `piece-counts-differ`, `disconnected`, `weight-not-positive`.
pub(super) fn rail_pieces(rails: [&[EdgeCurve]; 2], closed: bool) -> Result<Vec<RailPiece>> {
    let [first, second] = rails.map(<[EdgeCurve]>::len);
    if first != second {
        return Err(BridgeError::PieceCountsDiffer { first, second }.into());
    }
    if first == 0 {
        return Err(PointError::TooFewPoints { given: 0, needed: 1 }.into());
    }
    for rail in rails {
        check_rail(rail, closed)?;
    }
    let pairs = rails[0].iter().zip(rails[1]).enumerate();
    let mut pieces = Vec::new();
    for (piece, (first, second)) in pairs {
        let curves = [first, second].map(evened);
        let widest = curves.iter().filter_map(EdgeCurve::arc).map(Arc::angle).fold(0.0, f64::max);
        let halvings = if widest <= LARGEST_ARC { 0 } else { (widest / LARGEST_ARC).log2().ceil() as u32 };
        let halvings = halvings.max(u32::from(closed && rails[0].len() == 1));
        let mut parts = vec![RailPiece { curves, piece, part: [0.0, 1.0] }];
        for _ in 0..halvings {
            let halves = parts.iter().map(RailPiece::halved).collect::<Result<Vec<_>>>()?;
            parts = halves.into_iter().flatten().map(RailPiece::evened).collect();
        }
        pieces.extend(parts);
    }
    Ok(pieces)
}

impl RailPiece {
    /// Both halves, with the parameter of the whole.
    pub(super) fn halved(&self) -> Result<[Self; 2]> {
        let [(a, b), (c, d)] = [self.curves[0].split(0.5)?, self.curves[1].split(0.5)?];
        let [from, to] = self.part;
        let half = |curves: [EdgeCurve; 2], part| Self { curves, piece: self.piece, part };
        let middle = 0.5 * (from + to);
        Ok([half([a, c], [from, middle]), half([b, d], [middle, to])])
    }

    /// The joint of the curves as given that it starts from.
    pub(super) fn joint(&self) -> Option<usize> {
        (self.part[0] == 0.0).then_some(self.piece)
    }

    fn evened(mut self) -> Self {
        self.curves = self.curves.map(|curve| evened(&curve));
        self
    }
}

fn check_rail(rail: &[EdgeCurve], closed: bool) -> Result<()> {
    let size = rail.iter().map(|piece| piece.start().to_vec().max_abs()).fold(0.0, f64::max);
    check_connected(rail, closed, 1e-12 * size)?;
    rail.iter().enumerate().try_for_each(|(index, piece)| check_weights(piece, index))
}

/// The curve with weights of 1 at both ends: arcs with another parameter, rational curves with a linear factor.
pub(super) fn evened(curve: &EdgeCurve) -> EdgeCurve {
    match curve {
        EdgeCurve::Arc(arc) => EdgeCurve::Arc(arc.evened()),
        EdgeCurve::Rational(curve) => EdgeCurve::Rational(with_unit_ends(curve)),
    }
}

fn with_unit_ends(curve: &RationalBezier) -> RationalBezier {
    let rows = curve.rows();
    let [first, last] = [rows[0][3], rows[rows.len() - 1][3]];
    if first - last == 0.0 { curve.multiplied(&[1.0 / first]) } else { curve.multiplied(&[1.0 / first, 1.0 / last]) }
}
