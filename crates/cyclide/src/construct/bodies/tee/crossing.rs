//! A branch that stands inside the breadth of its main pipe, and the balls that touch both from outside
//! (`docs/math/pipe-tees.md#balls`).

use super::loop_piece::LoopPiece;
use crate::base::frame::Frame;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::rational::{Polynomial, PolynomialRow};

/// Two cylinders in their place: the main pipe about the x axis, the branch thinner than it, its axis passing that of the main pipe nearer than
/// their radii differ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crossing {
    /// Which branch, from 0, for what is refused of it.
    pub(super) branch: usize,
    /// Radii of branch and main pipe.
    pub(super) radii: [f64; 2],
    /// Difference of the radii.
    pub(super) delta: f64,
    /// Distance of the axes as part of that, with its sign.
    pub(super) tau: f64,
    /// `√(1 - τ²)`.
    pub(super) root: f64,
    /// `((1 + τ)/(1 - τ))^¼`.
    pub(super) boost: f64,
    /// Sine and cosine of the angle between the axes.
    pub(super) sin: f64,
    pub(super) cos: f64,
    /// The foot on the axis of the main pipe, as its place along it.
    pub(super) at: f64,
    /// The foot on the axis of the branch.
    pub(super) foot: Point3,
    /// Across the main pipe: sideways and towards the branch.
    pub(super) sideways: Vec3,
    pub(super) up: Vec3,
    /// Across the branch, the first nearest to the direction of the main pipe; its own direction last.
    pub(super) axes: [Vec3; 3],
}

/// A ball at an angle round the branch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ball {
    /// Cosine and sine of half the angle of its contact round the branch, of length 1.
    pub(super) on_branch: [f64; 2],
    /// The same round the main pipe, from `up` towards `sideways`.
    pub(super) on_main: [f64; 2],
    /// Place of the contact along the branch, from its foot.
    pub(super) height: f64,
    /// Place of the contact along the main pipe.
    pub(super) along: f64,
}

/// What a piece of the loop says about its balls, as polynomials over it.
pub(super) struct PieceForms {
    /// Weight, and times it: coordinates of the centre across the branch, along the branch from the foot, along the main pipe from the foot, and the radius
    /// of the balls with that of the branch.
    pub(super) weight: Polynomial,
    pub(super) across: [Polynomial; 2],
    pub(super) height: Polynomial,
    pub(super) along: Polynomial,
    pub(super) reach: Polynomial,
    /// Cosine and sine of half the angles of the contacts, up to a factor.
    pub(super) on_branch: [Polynomial; 2],
    pub(super) on_main: [Polynomial; 2],
    /// First and last component of the factor that takes one contact to the other.
    pub(super) factor: [Polynomial; 2],
}

impl Crossing {
    /// A row in the axes of the branch, from its foot.
    pub(super) fn placed(&self, [x, y, z]: [Polynomial; 3], weight: Polynomial) -> PolynomialRow {
        let (foot, [ex, ey, ez]) = (self.foot.to_vec(), self.axes);
        let along =
            |ex: f64, ey: f64, ez: f64, foot: f64| &(&(&x * ex) + &(&y * ey)) + &(&(&z * ez) + &(&weight * foot));
        let rows = [along(ex.x, ey.x, ez.x, foot.x), along(ex.y, ey.y, ez.y, foot.y), along(ex.z, ey.z, ez.z, foot.z)];
        let [x, y, z] = rows;
        PolynomialRow([x, y, z, weight])
    }

    /// The rotation from the axes of space to those of the branch.
    pub(super) fn turn(&self) -> Quat {
        Frame::of_axes(self.foot, self.axes).rotation()
    }

    /// The true half angle of a boosted one, up to a positive factor.
    fn unboosted(&self, [c, s]: [f64; 2]) -> [f64; 2] {
        let (sum, difference) = ((c + s) / self.boost, (c - s) * self.boost);
        [0.5 * (sum + difference), 0.5 * (sum - difference)]
    }

    fn unboosted_forms(&self, [c, s]: [&Polynomial; 2]) -> [Polynomial; 2] {
        let (sum, difference) = (&(c + s) * (0.5 / self.boost), &(c + &(s * -1.0)) * (0.5 * self.boost));
        [&sum + &difference, &sum + &(&difference * -1.0)]
    }

    /// The boosted angle of a contact round the branch at the true angle.
    pub(super) fn boosted_angle(&self, angle: f64) -> f64 {
        let (s, c) = (0.5 * angle).sin_cos();
        let (sum, difference) = ((c + s) * self.boost, (c - s) / self.boost);
        2.0 * (0.5 * (sum - difference)).atan2(0.5 * (sum + difference))
    }

    /// The true angle of a boosted one round the branch.
    pub(super) fn true_angle(&self, boosted: f64) -> f64 {
        let (s, c) = (0.5 * boosted).sin_cos();
        let [c, s] = self.unboosted([c, s]);
        2.0 * s.atan2(c)
    }

    /// The factor k of the loop at a boosted angle for a ball of this radius, with its derivative.
    pub(super) fn factor_of_radius(&self, boosted: f64, radius: f64, derivative: f64) -> [f64; 2] {
        let (sin, cos) = boosted.sin_cos();
        let reach = radius + self.radii[0];
        let ratio = self.delta * (1.0 - self.tau * sin) / reach;
        let by_angle = -(self.delta * self.tau * cos + ratio * derivative) / reach;
        let root = (ratio * (2.0 + ratio) + cos * cos).sqrt();
        let factor = 0.5 * (1.0 + ratio + root);
        [factor, 0.5 * (by_angle + ((1.0 + ratio) * by_angle - sin * cos) / root)]
    }

    /// The radius of the ball at a boosted angle of a loop with this factor.
    pub(super) fn radius_of_factor(&self, boosted: f64, factor: f64) -> f64 {
        let (sin, cos) = boosted.sin_cos();
        // k² - k + sin²/4 without the difference of nearly equal numbers.
        let below = (factor - 0.5) * (factor - 0.5) - 0.25 * cos * cos;
        self.delta * factor * (1.0 - self.tau * sin) / below - self.radii[0]
    }

    /// The ball at a boosted angle where the form of the loop has this value.
    pub(super) fn ball(&self, boosted: f64, q: f64) -> Ball {
        let (s, c) = (0.5 * boosted).sin_cos();
        let weight = (q - s * s) * (q - c * c) / (2.0 * self.delta * self.root);
        let m = 0.5 * (c - s) * (c + s) * q;
        let across = 0.5 * (q - s * c) * (q + s * c);
        let unit = |[c, s]: [f64; 2]| {
            let length = c.hypot(s);
            [c / length, s / length]
        };
        Ball {
            on_branch: unit(self.unboosted([c, s])),
            on_main: unit(self.unboosted([q, s * c])),
            height: (across + m * self.cos) / (self.sin * weight),
            along: self.at + (m + across * self.cos) / (self.sin * weight),
        }
    }

    /// The point of the branch at a half angle and a place along it.
    pub(super) fn branch_point(&self, radius: f64, [c, s]: [f64; 2], height: f64) -> Point3 {
        let [x, y, z] = self.axes;
        self.foot + x * (radius * (c - s) * (c + s)) + y * (radius * 2.0 * c * s) + z * height
    }

    /// The polynomials of a piece.
    pub(super) fn forms(&self, piece: &LoopPiece) -> PieceForms {
        let [s, c] = piece.halves();
        let minus = |p: &Polynomial, q: &Polynomial| p + &(q * -1.0);
        let (ss, sc, cc, q) = (&s * &s, &s * &c, &c * &c, piece.value());
        let (beyond_s, beyond_c) = (minus(&q, &ss), minus(&q, &cc));
        let weight = &(&beyond_s * &beyond_c) * (0.5 / (self.delta * self.root));
        let n = &(&(&ss + &cc) * &q) * 0.5;
        let m = &(&minus(&cc, &ss) * &q) * 0.5;
        let y = &sc * &q;
        let across = &minus(&(&q * &q), &(&sc * &sc)) * 0.5;
        let tangent = self.half_lean().tan();
        let [by_s, by_c] = piece.gradient();
        PieceForms {
            height: &(&across + &(&m * self.cos)) * (1.0 / self.sin),
            along: &(&m + &(&across * self.cos)) * (1.0 / self.sin),
            reach: &(&n + &(&y * -self.tau)) * (1.0 / self.root),
            across: [m, &(&y + &(&n * -self.tau)) * (1.0 / self.root)],
            on_branch: self.unboosted_forms([&c, &s]),
            on_main: self.unboosted_forms([&q, &sc]),
            factor: [&(&beyond_c * &by_c) * (1.0 + tangent), &(&beyond_s * &by_s) * (1.0 - tangent)],
            weight,
        }
    }

    /// Half the angle by which the main pipe leans from a right angle to the branch.
    pub(super) fn half_lean(&self) -> f64 {
        0.5 * (-self.cos).atan2(self.sin)
    }
}
