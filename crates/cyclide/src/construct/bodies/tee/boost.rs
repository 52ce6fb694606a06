//! Angles of contacts, and the coordinates in which all contacts of a pipe are those of one circle (`docs/math/pipe-tees.md#balls`): a Lorentz boost, then a
//! turn.

use crate::rational::Polynomial;

/// From the boosted coordinates of a pipe to the true ones: `(m, y, n)` with `m² + y² = n²` to `(X, Y, L)` with `X² + Y² = L²`.
#[derive(Debug, Clone, Copy)]
pub(in crate::construct::bodies) struct Boost {
    /// The velocity of the boost, and `√(1 - τ²)`.
    pub(in crate::construct::bodies) tau: f64,
    pub(in crate::construct::bodies) root: f64,
    /// `((1 + τ)/(1 - τ))^¼`.
    quarter: f64,
    /// The turn, an angle.
    turn: f64,
}

impl Boost {
    /// With a turn given by a direction.
    pub(in crate::construct::bodies) fn new(tau: f64, [cos, sin]: [f64; 2]) -> Self {
        Self {
            tau,
            root: ((1.0 - tau) * (1.0 + tau)).sqrt(),
            quarter: ((1.0 + tau) / (1.0 - tau)).sqrt().sqrt(),
            turn: sin.atan2(cos),
        }
    }

    /// The cosine of the turn.
    pub(in crate::construct::bodies) fn turn_cos(&self) -> f64 {
        self.turn.cos()
    }

    /// The rows of the linear map from `(m, y, n)` to `(X, Y, L)`.
    pub(in crate::construct::bodies) fn rows(&self) -> [[f64; 3]; 3] {
        let (sin, cos) = self.turn.sin_cos();
        let (one, tau) = (1.0 / self.root, self.tau / self.root);
        [[cos, -sin * one, sin * tau], [sin, cos * one, -cos * tau], [0.0, -tau, one]]
    }

    /// Cosine and sine of half the true angle, up to a factor, from those of half the boosted one.
    pub(in crate::construct::bodies) fn halves(&self, [c, s]: [&Polynomial; 2]) -> [Polynomial; 2] {
        let (sum, difference) = (&(c + s) * (0.5 / self.quarter), &(c + &(s * -1.0)) * (0.5 * self.quarter));
        let (c, s) = (&sum + &difference, &sum + &(&difference * -1.0));
        if self.turn == 0.0 {
            return [c, s];
        }
        let (sin, cos) = (0.5 * self.turn).sin_cos();
        [&(&c * cos) + &(&s * -sin), &(&s * cos) + &(&c * sin)]
    }

    /// The boosted angle of a true one.
    pub(in crate::construct::bodies) fn boosted_angle(&self, angle: f64) -> f64 {
        let (s, c) = (0.5 * (angle - self.turn)).sin_cos();
        let (sum, difference) = ((c + s) * self.quarter, (c - s) / self.quarter);
        2.0 * (sum - difference).atan2(sum + difference)
    }

    /// The true angle of a boosted one.
    pub(in crate::construct::bodies) fn true_angle(&self, boosted: f64) -> f64 {
        let (s, c) = (0.5 * boosted).sin_cos();
        let (sum, difference) = ((c + s) / self.quarter, (c - s) * self.quarter);
        self.turn + 2.0 * (sum - difference).atan2(sum + difference)
    }

    /// The derivative of the true angle by the boosted one.
    pub(in crate::construct::bodies) fn speed(&self, boosted: f64) -> f64 {
        self.root / (1.0 - self.tau * boosted.sin())
    }
}
