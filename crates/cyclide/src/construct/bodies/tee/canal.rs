//! The envelope of the balls of a piece of the loop, between their contacts: exact, of degree (12, 2)
//! (`docs/math/pipe-tees.md#canal`).

use super::crossing::Crossing;
use super::loop_piece::LoopPiece;
use super::piece_forms::PieceForms;
use crate::base::quat::Quat;
use crate::error::Result;
use crate::rational::{Polynomial, PolynomialRow, QuatPolynomial, RationalBezier, RationalBezierSurface};
use crate::surface::CanalPatch;
use std::f64::consts::FRAC_PI_2;

/// The canal of a piece: its balls, and the turns of the third axis into the normals at both contacts.
pub(in crate::construct::bodies) struct Canal<'a> {
    crossing: &'a Crossing,
    /// How far below the outer skin: radii of pipes are smaller by that, radii of balls larger.
    depth: f64,
    pub(in crate::construct::bodies) forms: PieceForms,
    patch: CanalPatch,
}

/// A ball where it touches both pipes.
#[derive(Debug, Clone, Copy)]
pub(in crate::construct::bodies) struct Ball {
    /// Cosine and sine of half the angle of its contact round the branch, of length 1.
    pub(in crate::construct::bodies) on_branch: [f64; 2],
    /// The same round the main pipe, from `up` towards `sideways`.
    pub(in crate::construct::bodies) on_main: [f64; 2],
    /// Place of the contact along the branch, from its foot.
    pub(in crate::construct::bodies) height: f64,
    /// Place of the contact along the main pipe.
    pub(in crate::construct::bodies) along: f64,
}

impl<'a> Canal<'a> {
    pub(in crate::construct::bodies) fn new(crossing: &'a Crossing, piece: &LoopPiece, depth: f64) -> Self {
        let forms = crossing.forms(piece);
        let (lean_sin, lean_cos) = crossing.half_lean().sin_cos();
        let [k0, k3] = forms.factor.clone();
        let zero = || Polynomial::constant(0.0);
        let [c, s] = &forms.on_branch;
        // (c + s e3) and the turn of the third axis to the normal on the line c = 1; kappa on its side, where it costs no degree.
        let (rise_sin, rise_cos) = (0.5 * (FRAC_PI_2 - crossing.taper)).sin_cos();
        let branch = QuatPolynomial([c * rise_cos, s * -rise_sin, c * rise_sin, s * rise_cos]);
        let first = &branch * &QuatPolynomial([k0, zero(), zero(), k3]).conj();
        let [c, s] = &forms.on_main;
        // Of a cone the normal rises too.
        let (rise_sin, rise_cos) = (0.5 * crossing.main[1]).sin_cos();
        let [even, odd] = [
            [lean_cos * rise_cos - lean_sin * rise_sin, lean_sin * rise_cos + lean_cos * rise_sin],
            [lean_cos * rise_cos + lean_sin * rise_sin, lean_sin * rise_cos - lean_cos * rise_sin],
        ];
        let second = QuatPolynomial([c * even[0], s * -odd[0], c * even[1], s * odd[1]]);
        let axes = QuatPolynomial::constant(crossing.turn());
        let [first, second] = [&axes * &first, &axes * &second];
        // Both contacts weigh as much at the ends, and the shorter arc is meant.
        let sign = if first.dot(&second).coefficients().iter().sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
        let even = [0.0, 1.0].map(|end| sign * first.value(end).norm() / second.value(end).norm());
        let second = &second * &Polynomial::new(even.to_vec());
        let radius = &forms.radius + &(&forms.weight * depth);
        let [x, y] = forms.across.clone();
        let center = crossing.placed([x, y, forms.height.clone()], forms.weight.clone());
        let patch = CanalPatch::from_turns(center, radius, [first, second]);
        Self { crossing, depth, forms, patch }
    }

    /// The patch of its balls, from the contact with the branch to that with the main pipe.
    pub(in crate::construct::bodies) fn into_patch(self) -> CanalPatch {
        self.patch
    }

    /// The surface: s along the loop, t from the branch to the main pipe.
    pub(in crate::construct::bodies) fn surface(&self) -> Result<RationalBezierSurface> {
        self.patch.to_rational()
    }

    /// The radius of the balls times the weight.
    pub(in crate::construct::bodies) fn radius(&self) -> &Polynomial {
        self.patch.radius()
    }

    /// The ratio of the weights of the arc between the contacts at an end of the piece.
    pub(in crate::construct::bodies) fn arc_ratio(&self, end: f64) -> Option<Quat> {
        self.patch.arc_ratio(end)
    }

    /// The place of the contact along the branch, times the weight.
    pub(in crate::construct::bodies) fn height(&self) -> Polynomial {
        &self.forms.height + &(self.radius() * -self.crossing.taper.sin())
    }

    /// The contact with the branch, of degree 6.
    pub(in crate::construct::bodies) fn on_branch(&self) -> PolynomialRow {
        let (forms, height) = (&self.forms, self.height());
        let [c, s] = &forms.on_branch;
        let foot = self.crossing.branch_radius(self.depth, 0.0);
        let radius = &(&forms.weight * foot) + &(&height * -self.crossing.taper.tan());
        let norm = &(c * c) + &(s * s);
        let [x, y] = [&(c * c) + &(&(s * s) * -1.0), &(c * s) * 2.0].map(|p| &p * &radius);
        self.crossing.placed([x, y, &height * &norm], &forms.weight * &norm)
    }

    /// A circle of the branch at a place along it, below the contact, with its parameter and its weights.
    pub(in crate::construct::bodies) fn beside_branch(&self, height: f64) -> PolynomialRow {
        let forms = &self.forms;
        let [c, s] = &forms.on_branch;
        let radius = self.crossing.branch_radius(self.depth, height);
        let norm = &(&(c * c) + &(s * s)) * &forms.weight;
        let across = [&(c * c) + &(&(s * s) * -1.0), &(c * s) * 2.0].map(|p| &(&p * &forms.weight) * radius);
        let [x, y] = across;
        self.crossing.placed([x, y, &norm * height], norm)
    }

    /// The ball at the start.
    pub(in crate::construct::bodies) fn ball(&self) -> Ball {
        let forms = &self.forms;
        let unit = |half: &[Polynomial; 2]| {
            let [c, s] = half.each_ref().map(|p| p.value(0.0));
            let length = c.hypot(s);
            [c / length, s / length]
        };
        let weight = forms.weight.value(0.0);
        Ball {
            on_branch: unit(&forms.on_branch),
            on_main: unit(&forms.on_main),
            height: self.height().value(0.0) / weight,
            along: self.crossing.at + forms.along.value(0.0) / weight,
        }
    }

    /// The centers of the balls.
    pub(in crate::construct::bodies) fn centres(&self) -> RationalBezier {
        RationalBezier::from_polynomial_row(self.patch.center())
    }

    /// The radii of the balls as a curve along x.
    pub(in crate::construct::bodies) fn radii(&self) -> RationalBezier {
        let zero = Polynomial::constant(0.0);
        RationalBezier::from_polynomial_row(&PolynomialRow([
            self.radius().clone(),
            zero.clone(),
            zero,
            self.forms.weight.clone(),
        ]))
    }
}
