//! A patch moved to the origin, in units of its size and with a parameter that does not depend on how it was made.

use crate::base::vector::{Point3, Vec3};
use crate::surface::{CyclidePatch, ParamSurface as _};

/// A patch whose first corner is at the origin and whose largest distance between corners is 1: fits and comparisons
/// lose nothing to a place far away. Its weights are evened by the factors `1, lam, mu, lam mu` so that the
/// denominators at opposite sides have the same product of lengths; then the parameter is the same whatever corner is
/// the first.
pub(super) struct UnitPatch {
    pub(super) patch: CyclidePatch,
    pub(super) origin: Point3,
    pub(super) size: f64,
    factors: [f64; 2],
}

impl UnitPatch {
    pub(super) fn new(patch: &CyclidePatch) -> Self {
        let ([origin, ..], size, w) = (patch.corners(), patch.size(), patch.weights());
        let n = w.map(|w| w.norm());
        let factors = [(n[0] / n[1] * (n[2] / n[3])).sqrt(), (n[0] / n[2] * (n[1] / n[3])).sqrt()];
        let corners = patch.corners().map(|p| Point3::ORIGIN + (p - origin) / size);
        let scale = 1.0 / n[0];
        let [lam, mu] = factors;
        let weights = [w[0] * scale, w[1] * (scale * lam), w[2] * (scale * mu), w[3] * (scale * lam * mu)];
        let [v1, v2, _] = patch.frame();
        Self { patch: CyclidePatch::from_weights_unchecked(corners, weights, v1, v2), origin, size, factors }
    }

    /// The point as a vector from the first corner.
    pub(super) fn at(&self, (s, t): (f64, f64)) -> Vec3 {
        self.patch.point(s, t).to_vec()
    }

    /// The parameters of a place in the patch that was given.
    pub(super) fn place(&self, (s, t): (f64, f64)) -> (f64, f64) {
        let back = |x: f64, factor: f64| factor * x / (1.0 - x + factor * x);
        (back(s, self.factors[0]), back(t, self.factors[1]))
    }

    /// A place of the given space.
    pub(super) fn to_world(&self, p: Vec3) -> Point3 {
        self.origin + p * self.size
    }

    /// `count` by `count` points at equal parameters from border to border, s fastest.
    pub(super) fn grid(&self, count: u32) -> impl Iterator<Item = (f64, f64)> + use<> {
        let step = 1.0 / f64::from(count - 1);
        (0..count * count).map(move |k| (f64::from(k % count) * step, f64::from(k / count) * step))
    }
}
