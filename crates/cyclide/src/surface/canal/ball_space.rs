//! The space of balls, with center and radius for its four coordinates, and the maps of it that keep which balls touch
//! (`docs/math/canal-blends.md#cylinders-and-cones-in-any-position`).
//!
//! Two balls touch from one side where their difference has the Minkowski square `|dm|² - dR² = 0`. A motion `x -> o + x1 e1 + x2 e2 + x3 e3 + x4 g` along axes
//! that are orthonormal in this sense, g ahead in R, takes envelopes to envelopes. The differences `(n, 1)` from a contact to its ball are null vectors:
//! with `n = q k q⁻¹` and the rotation `p` and boost `g = (sinh η u, cosh η)` of the motion they go to those of
//! ```text
//! p q cosh(η/2) - u p q k sinh(η/2)
//! ```
//! which is linear over the numbers `a + b k` on the right, so that circles of normals stay circles in their parameter.

use super::{CanalPatch, RollingBall};
use crate::base::frame::Frame;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::rational::{Polynomial, PolynomialRow, QuatPolynomial};
use std::ops::{Add, Mul, Sub};

/// A ball, or a difference of balls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BallVector {
    pub(crate) center: Vec3,
    pub(crate) radius: f64,
}

impl BallVector {
    /// The Minkowski product.
    pub(crate) fn dot(self, other: Self) -> f64 {
        self.center.dot(other.center) - self.radius * other.radius
    }

    /// At length 1, if its square is positive.
    pub(super) fn spacelike_unit(self) -> Option<Self> {
        let square = self.dot(self);
        (square > 0.0 && square.is_finite()).then(|| self * (1.0 / square.sqrt()))
    }
}

impl Add for BallVector {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { center: self.center + o.center, radius: self.radius + o.radius }
    }
}

impl Sub for BallVector {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + o * -1.0
    }
}

impl Mul<f64> for BallVector {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { center: self.center * factor, radius: self.radius * factor }
    }
}

/// A motion of the space of balls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BallMotion {
    pub(super) origin: BallVector,
    pub(super) axes: [BallVector; 4],
    rotation: Quat,
    /// Hyperbolic cosine and sine of half the boost, the sine along it.
    boost: (f64, Vec3),
}

impl BallMotion {
    /// From the image of the origin and axes that are orthonormal, the last one timelike and ahead. The first one is turned about where
    /// the four are not right-handed.
    pub(super) fn new(origin: BallVector, mut axes: [BallVector; 4]) -> Self {
        // Back along the boost.
        let g = axes[3];
        let at_rest = |e: BallVector| e.center - g.center * (e.radius / (1.0 + g.radius));
        if at_rest(axes[0]).cross(at_rest(axes[1])).dot(at_rest(axes[2])) < 0.0 {
            axes[0] = axes[0] * -1.0;
        }
        let rotation = Frame::of_axes(Point3::ORIGIN, [axes[0], axes[1], axes[2]].map(at_rest)).rotation();
        let cosh = (0.5 * (1.0 + g.radius)).sqrt();
        Self { origin, axes, rotation, boost: (cosh, g.center * (0.5 / cosh)) }
    }

    fn vector(&self, v: BallVector) -> BallVector {
        let [e1, e2, e3, g] = self.axes;
        e1 * v.center.x + e2 * v.center.y + e3 * v.center.z + g * v.radius
    }

    /// The image of a ball that has this factor, with the factor for its weight.
    pub(super) fn weighted(&self, ball: BallVector, weight: f64) -> BallVector {
        self.vector(ball) + self.origin * weight
    }

    /// The image of a unit normal.
    pub(crate) fn normal(&self, n: Vec3) -> Vec3 {
        let null = self.vector(BallVector { center: n, radius: 1.0 });
        null.center.unit().unwrap_or(n)
    }

    /// The image of a ball with the normals of its contacts.
    pub(super) fn ball(&self, ball: &RollingBall) -> RollingBall {
        let image = self.origin + self.vector(BallVector { center: ball.center.to_vec(), radius: ball.radius });
        let (center, normals) = (Point3::ORIGIN + image.center, ball.normals.map(|n| self.normal(n)));
        RollingBall { center, radius: image.radius, contacts: normals.map(|n| center - n * image.radius), normals }
    }

    /// The image of a patch.
    pub(super) fn patch(&self, patch: &CanalPatch) -> CanalPatch {
        let ([x, y, z, w], r) = (&patch.center.0, &patch.radius);
        let coordinate = |of: fn(BallVector) -> f64| {
            let [e1, e2, e3, g] = self.axes.map(of);
            &(&(&(x * e1) + &(y * e2)) + &(&(z * e3) + &(r * g))) + &(w * of(self.origin))
        };
        let center = PolynomialRow([
            coordinate(|v| v.center.x),
            coordinate(|v| v.center.y),
            coordinate(|v| v.center.z),
            w.clone(),
        ]);
        let radius = coordinate(|v| v.radius);
        let constant = |q: Quat| QuatPolynomial::constant(q);
        let (cosh, sinh) = self.boost;
        let turns = patch.turns.each_ref().map(|q| {
            let turned = &constant(self.rotation) * q;
            let boosted =
                &(&constant(Quat::from_parts(0.0, -sinh)) * &turned) * &constant(Quat::new(0.0, 0.0, 0.0, 1.0));
            &(&turned * &Polynomial::constant(cosh)) + &boosted
        });
        let mut image = CanalPatch { center, radius, turns };
        image.take_minor_arc();
        image
    }
}
