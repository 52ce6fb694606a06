//! The frame that the section of a seam moves along with.

use crate::base::vector::{Point3, Vec3};
use crate::curve::ParamCurve as _;
use crate::error::{Error, PointError, Result};
use crate::surface::TorusSpline;

/// Speed of a corner along the curve, as part of the speed of the curve, below which the seam folds.
const SLOWEST: f64 = 0.05;

/// The frame at a place of a curve, and how it turns.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moving {
    pub(super) point: Point3,
    pub(super) velocity: Vec3,
    pub(super) tangent: Vec3,
    pub(super) normal: Vec3,
    pub(super) normal_rate: Vec3,
    /// Across the curve, along the torus.
    pub(super) across: Vec3,
    pub(super) across_rate: Vec3,
}

impl Moving {
    /// At a parameter of a piece.
    ///
    /// # Errors
    /// `zero-tangent`: the curve stops there.
    pub(super) fn at(spline: &TorusSpline, piece: usize, s: f64) -> Result<Self> {
        let torus = spline.torus();
        let (jet, lost) = (spline.piece_jet(piece, s), || Error::Point(PointError::ZeroTangent { index: piece }));
        let (speed, tangent) = (jet.d1.length(), jet.tangent().ok_or_else(lost)?);
        let (axis, from_axis) = (torus.frame().z(), jet.point - torus.frame().origin());
        let outward = (from_axis - axis * from_axis.dot(axis)).unit().ok_or_else(lost)?;
        let around = axis.cross(outward);
        let normal = ((from_axis - outward * torus.major_radius()) / torus.minor_radius()).unit().ok_or_else(lost)?;
        let longitude = 2.0 * spline.pieces()[piece].rate(s).x;
        let normal_rate = (jet.d1 - around * (torus.major_radius() * longitude)) / torus.minor_radius();
        let tangent_rate = (jet.d2 - tangent * tangent.dot(jet.d2)) / speed;
        let across_rate = normal_rate.cross(tangent) + normal.cross(tangent_rate);
        let across = normal.cross(tangent);
        Ok(Self { point: jet.point, velocity: jet.d1, tangent, normal, normal_rate, across, across_rate })
    }

    /// The heights between which the middle of the seam goes faster than the slowest.
    pub(super) fn heights(&self) -> [f64; 2] {
        let speed = self.velocity.length();
        let growth = self.normal_rate.dot(self.tangent) / speed;
        let end = (SLOWEST - 1.0) / growth;
        if growth > 0.0 {
            [end, f64::MAX]
        } else if growth < 0.0 {
            [f64::MIN, end]
        } else {
            [f64::MIN, f64::MAX]
        }
    }

    /// The largest width with which no corner between these heights falls below the slowest speed along the curve.
    pub(super) fn widest(&self, heights: [f64; 2]) -> f64 {
        let speed = self.velocity.length();
        let turn = 0.5 * self.across_rate.dot(self.tangent).abs() / speed;
        let slowest = heights.map(|height| (self.velocity + self.normal_rate * height).dot(self.tangent) / speed);
        let room = slowest[0].min(slowest[1]) - SLOWEST;
        if room <= 0.0 { 0.0 } else { room / turn }
    }
}
