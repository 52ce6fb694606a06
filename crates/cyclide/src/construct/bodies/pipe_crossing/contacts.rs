//! Where balls touch both pipes: one ball, and those of a piece.

use crate::rational::{Polynomial, QuatPolynomial};
use crate::surface::CanalPatch;

/// Where a ball touches both pipes: its place along each and the angle round it, counted from where the other pipe is nearest, and the rates of these by the angle
/// of the ball about the common normal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contacts {
    pub(super) at: [[f64; 2]; 2],
    pub(super) rates: [[f64; 2]; 2],
}

impl Contacts {
    /// Half a turn about the common normal on.
    pub(super) fn turned(&self) -> Self {
        let back = |pairs: [[f64; 2]; 2]| pairs.map(|pair| pair.map(|x| -x));
        Self { at: back(self.at), rates: back(self.rates) }
    }
}

/// Canal, half directions and places of a piece.
pub(super) struct PieceForms {
    pub(super) patch: CanalPatch,
    pub(super) halves: [[Polynomial; 2]; 2],
    pub(super) along: [Polynomial; 2],
}

impl PieceForms {
    /// Half a turn about the common normal on.
    pub(super) fn turned(&self) -> Self {
        let mut center = self.patch.center().clone();
        for axis in [0, 1] {
            center.0[axis] = &center.0[axis] * -1.0;
        }
        let turns = self
            .patch
            .turns()
            .each_ref()
            .map(|QuatPolynomial([w, x, y, z])| QuatPolynomial([w.clone(), x * -1.0, y * -1.0, z.clone()]));
        let halves = self.halves.each_ref().map(|[cos, sin]| [cos.clone(), sin * -1.0]);
        let along = self.along.each_ref().map(|along| along * -1.0);
        Self { patch: CanalPatch::from_turns(center, self.patch.radius().clone(), turns), halves, along }
    }
}
