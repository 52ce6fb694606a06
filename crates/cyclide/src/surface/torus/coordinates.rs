//! Coordinates of a torus with major radius 1: its point, normal and the derivatives of curves on it, from the sines and cosines of
//! its two angles. Nothing cancels, however thin the hole is.

use super::class::UnitPair;
use crate::base::planar::Vec2;
use crate::base::vector::Vec3;
use std::f64::consts::PI;

/// The numbers that a torus of major radius 1 is known by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shape {
    /// Minor over major radius `b/a`.
    pub(super) tube: f64,
    /// `1 - b/a`, with all its digits where the radii are nearly equal.
    pub(super) thin: f64,
    /// `1 + b/a`.
    pub(super) wide: f64,
    /// `c/a`, the root of their product.
    pub(super) root: f64,
}

/// First to third derivative of both angles by one parameter.
#[derive(Debug, Clone, Copy)]
pub(super) struct Jet3 {
    pub(super) a: [f64; 3],
    pub(super) b: [f64; 3],
}

impl Jet3 {
    /// Of angles that run at constant speed.
    pub(super) const fn linear(rate: Vec2) -> Self {
        Self { a: [rate.x, 0.0, 0.0], b: [rate.y, 0.0, 0.0] }
    }
}

/// Distance from the axis, the same less 1, and height.
struct Meridian {
    radius: f64,
    out: f64,
    height: f64,
}

impl Shape {
    pub(super) fn new(major: f64, minor: f64) -> Self {
        let (thin, wide) = ((major - minor) / major, 1.0 + minor / major);
        Self { tube: minor / major, thin, wide, root: (thin * wide).sqrt() }
    }

    /// `radius - 1 = (b/a)(cos 2B - b/a)/q`, written as `thin - 2 sin² B` above.
    fn meridian(&self, at: &UnitPair) -> Meridian {
        let (sin2, sin_cos) = at.tube_squares();
        let q = self.thin + 2.0 * self.tube * sin2;
        Meridian {
            radius: self.thin * self.wide / q,
            out: self.tube * (self.thin - 2.0 * sin2) / q,
            height: 2.0 * self.tube * self.root * sin_cos / q,
        }
    }

    pub(super) fn point(&self, at: &UnitPair) -> Vec3 {
        let (m, e) = (self.meridian(at), at.longitude());
        Vec3::new(m.radius * e.re, m.radius * e.im, m.height)
    }

    pub(super) fn normal(&self, at: &UnitPair) -> Vec3 {
        let (m, e) = (self.meridian(at), at.longitude());
        let n = Vec3::new(m.out * e.re, m.out * e.im, m.height);
        n.unit().unwrap_or(Vec3::Z)
    }

    /// Distance from the axis at a place.
    pub(super) fn radius(&self, at: &UnitPair) -> f64 {
        self.meridian(at).radius
    }

    /// Point and three derivatives. The tube is run through at `phi' = k radius B'`, `k = 2/c`, which is differentiated along with
    /// `radius' = -height phi'`, `height' = out phi'`; then the turn about the axis.
    pub(super) fn jet(&self, at: &UnitPair, rates: &Jet3) -> [Vec3; 4] {
        let (m, k) = (self.meridian(at), 2.0 / self.root);
        let ([b1, b2, b3], Meridian { radius: r, out: o, height: z }) = (rates.b, m);
        let f1 = k * r * b1;
        let (r1, z1) = (-z * f1, o * f1);
        let f2 = k * (r1 * b1 + r * b2);
        let (r2, z2) = (-z1 * f1 - z * f2, r1 * f1 + o * f2);
        let f3 = k * (r2 * b1 + 2.0 * r1 * b2 + r * b3);
        let (r3, z3) = (-z2 * f1 - 2.0 * z1 * f2 - z * f3, r2 * f1 + 2.0 * r1 * f2 + o * f3);
        // e^(2iA) times 1, then times (along, across) for each derivative.
        let [t1, t2, t3] = rates.a.map(|x| 2.0 * x);
        let turn = [[1.0, 0.0], [0.0, t1], [-t1 * t1, t2], [-3.0 * t1 * t2, t3 - t1 * t1 * t1]];
        let e = at.longitude();
        let row = |weights: [f64; 4], height: f64| {
            let along: f64 = (0..4).map(|j| weights[j] * turn[j][0]).sum();
            let across: f64 = (0..4).map(|j| weights[j] * turn[j][1]).sum();
            Vec3::new(along * e.re - across * e.im, along * e.im + across * e.re, height)
        };
        [
            row([r, 0.0, 0.0, 0.0], z),
            row([r1, r, 0.0, 0.0], z1),
            row([r2, 2.0 * r1, r, 0.0], z2),
            row([r3, 3.0 * r2, 3.0 * r1, r], z3),
        ]
    }

    /// The angle `B` of half a meridian angle, whole half turns kept.
    pub(super) fn tube_angle(&self, half: f64) -> f64 {
        scaled_tangent(half, self.thin.sqrt(), self.wide.sqrt())
    }

    /// Half the meridian angle of `B`.
    pub(super) fn half_meridian(&self, b: f64) -> f64 {
        scaled_tangent(b, self.wide.sqrt(), self.thin.sqrt())
    }
}

/// The angle whose tangent is that of another one times `up/down`, in the same half turn.
fn scaled_tangent(angle: f64, up: f64, down: f64) -> f64 {
    let halves = (angle / PI).round();
    let (sin, cos) = (angle - PI * halves).sin_cos();
    PI * halves + (up * sin).atan2(down * cos)
}
