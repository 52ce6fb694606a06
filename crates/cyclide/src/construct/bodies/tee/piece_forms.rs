//! What the pieces of a loop say about their balls, as polynomials.

use super::crossing::Crossing;
use super::loop_piece::LoopPiece;
use crate::rational::Polynomial;

/// What a piece of the loop says about its balls, as polynomials over it.
pub(in crate::construct::bodies) struct PieceForms {
    /// Weight, and times it: coordinates of the center across the branch, along the branch from the foot, the place of the contact along the main pipe from the foot, and
    /// the radius. Of skins below the place of the contact is counted from where the mantle begins.
    pub(in crate::construct::bodies) weight: Polynomial,
    pub(in crate::construct::bodies) across: [Polynomial; 2],
    pub(in crate::construct::bodies) height: Polynomial,
    pub(in crate::construct::bodies) along: Polynomial,
    pub(in crate::construct::bodies) radius: Polynomial,
    /// Cosine and sine of half the angles of the contacts, up to a factor.
    pub(in crate::construct::bodies) on_branch: [Polynomial; 2],
    pub(in crate::construct::bodies) on_main: [Polynomial; 2],
    /// First and last component of the factor that takes one contact to the other.
    pub(in crate::construct::bodies) factor: [Polynomial; 2],
}

impl Crossing {
    /// The polynomials of a piece.
    pub(in crate::construct::bodies) fn forms(&self, piece: &LoopPiece) -> PieceForms {
        if self.equal {
            return equal(self, piece);
        }
        let [s, c] = piece.halves();
        let minus = |p: &Polynomial, q: &Polynomial| p + &(q * -1.0);
        let (ss, sc, cc, q) = (&s * &s, &s * &c, &c * &c, piece.value());
        let [[a, b], [e, d]] = self.infinite;
        let (beyond_c, beyond_s) = (minus(&(&q * a), &(&cc * b)), minus(&(&q * e), &(&ss * d)));
        // Coordinates of balls are projective: weights are positive.
        let sign = self.unit.signum();
        let weight = &(&beyond_c * &beyond_s) * (sign / self.unit);
        let y = &(&sc * &q) * sign;
        let first = [&(&minus(&cc, &ss) * &q) * (0.5 * sign), y.clone(), &(&(&ss + &cc) * &q) * (0.5 * sign)];
        let (qq, square) = (&q * &q, &sc * &sc);
        let second = [&minus(&qq, &square) * (0.5 * sign), y, &(&qq + &square) * (0.5 * sign)];
        let along = |row: [f64; 3], [m, y, n]: &[Polynomial; 3]| &(&(m * row[0]) + &(y * row[1])) + &(n * row[2]);
        let [x_row, y_row, l_row] = self.boosts[0].rows();
        let across = [x_row, y_row].map(|row| along(row, &first));
        let up = along(self.boosts[1].rows()[0], &second);
        let height = &(&up + &(&across[0] * self.cos)) * (1.0 / self.sin);
        let (taper_sin, taper_cos) = self.taper.sin_cos();
        let radius =
            &(&(&along(l_row, &first) * taper_cos) + &(&height * taper_sin)) + &(&weight * -self.reach_of_branch());
        let [by_s, by_c] = piece.gradient();
        PieceForms {
            along: &(&(&across[0] + &(&up * self.cos)) * (1.0 / self.sin)) + &(&radius * -self.main[1].sin()),
            on_branch: self.boosts[0].halves([&c, &s]),
            on_main: self.boosts[1].halves([&q, &sc]),
            // Of balls inside the main pipe only, the root that it comes from is the other one.
            factor: [&beyond_c * &by_c, &(&beyond_s * &by_s) * self.radii[1].signum()],
            height,
            across,
            radius,
            weight,
        }
    }
}

/// Those of pipes of one radius (`docs/math/pipe-tees.md#equal-pipes`).
fn equal(crossing: &Crossing, piece: &LoopPiece) -> PieceForms {
    let [s, c] = piece.halves();
    let reach = piece.factor(piece.from);
    let ahead = piece.is_ahead();
    let norm = &(&s * &s) + &(&c * &c);
    let (cos, sin) = (&(&c * &c) + &(&(&s * &s) * -1.0), &(&s * &c) * 2.0);
    let across = [&cos * reach, &sin * reach];
    let up = &across[0] * if ahead { 1.0 } else { -1.0 };
    let tan = (crossing.sin / (1.0 + crossing.cos)).abs();
    let [along_way, beside] = if ahead { [&norm, &sin] } else { [&sin, &norm] };
    PieceForms {
        along: &(&across[0] + &(&up * crossing.cos)) * (1.0 / crossing.sin),
        height: &(&up + &(&across[0] * crossing.cos)) * (1.0 / crossing.sin),
        radius: &norm * (reach - crossing.radii[0]),
        factor: [along_way * tan, beside.clone()],
        on_main: if ahead { [c.clone(), s.clone()] } else { [s.clone(), c.clone()] },
        on_branch: [c, s],
        across,
        weight: norm,
    }
}
