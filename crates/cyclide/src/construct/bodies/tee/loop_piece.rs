//! Pieces of the loop of balls round a branch: on each the factor `k` is `a + b cos φ + c sin φ`, a quadratic form of the sine and cosine of
//! half the boosted angle `φ` (`docs/math/pipe-tees.md#loops`).

use crate::rational::Polynomial;

/// A piece of the loop between two boosted angles, less than half a turn apart.
#[derive(Debug, Clone, Copy)]
pub(in crate::construct::bodies) struct LoopPiece {
    pub(in crate::construct::bodies) from: f64,
    pub(in crate::construct::bodies) to: f64,
    /// The form by its coefficients in the coordinates along both end directions: those of short pieces keep their digits so.
    form: [f64; 3],
}

impl LoopPiece {
    /// A piece with one factor all along.
    pub(in crate::construct::bodies) fn constant(from: f64, to: f64, factor: f64) -> Self {
        Self { from, to, form: [factor, factor * (0.5 * (to - from)).cos(), factor] }
    }

    /// The form with these values and slopes at both ends and in C1 at the middle: two pieces.
    pub(in crate::construct::bodies) fn hermite([from, to]: [f64; 2], ends: [[f64; 2]; 2]) -> [Self; 2] {
        let middle = 0.5 * (from + to);
        let (sin, cos) = (0.5 * (middle - from)).sin_cos();
        let first = ends[0][0] * cos + ends[0][1] * sin;
        let last = ends[1][0] * cos - ends[1][1] * sin;
        let value = (first + last) / (2.0 * cos);
        [
            Self { from, to: middle, form: [ends[0][0], first, value] },
            Self { from: middle, to, form: [value, last, ends[1][0]] },
        ]
    }

    /// Sine and cosine of half the angle as linear polynomials, of length 1 at both ends.
    pub(in crate::construct::bodies) fn halves(&self) -> [Polynomial; 2] {
        let ([s0, c0], [s1, c1]) = (half(self.from), half(self.to));
        [Polynomial::new(vec![s0, s1]), Polynomial::new(vec![c0, c1])]
    }

    /// The form as a polynomial.
    pub(in crate::construct::bodies) fn value(&self) -> Polynomial {
        Polynomial::new(self.form.to_vec())
    }

    /// Half its derivatives by the sine and by the cosine, linear.
    pub(in crate::construct::bodies) fn gradient(&self) -> [Polynomial; 2] {
        let ([s0, c0], [s1, c1]) = (half(self.from), half(self.to));
        let d = (0.5 * (self.from - self.to)).sin();
        let [b0, b1, b2] = self.form;
        let ends = |along: [f64; 2]| {
            let at = |first: f64, second: f64| (first * along[1] - second * along[0]) / d;
            Polynomial::new(vec![at(b0, b1), at(b1, b2)])
        };
        [ends([c0, c1]), ends([-s0, -s1])]
    }

    /// The value of the form at an angle, which is the factor there.
    pub(in crate::construct::bodies) fn factor(&self, angle: f64) -> f64 {
        self.mixed([angle, angle])
    }

    /// The part between two angles: the same form.
    pub(in crate::construct::bodies) fn part(&self, from: f64, to: f64) -> Self {
        Self { from, to, form: [[from, from], [from, to], [to, to]].map(|pair| self.mixed(pair)) }
    }

    /// The bilinear form at two angles.
    fn mixed(&self, angles: [f64; 2]) -> f64 {
        let d = (0.5 * (self.to - self.from)).sin();
        let [[a0, a1], [b0, b1]] =
            angles.map(|angle| [(0.5 * (self.to - angle)).sin() / d, (0.5 * (angle - self.from)).sin() / d]);
        self.form[0] * a0 * b0 + self.form[1] * (a0 * b1 + a1 * b0) + self.form[2] * a1 * b1
    }

    /// Whether it is in the crotch towards the end of the main pipe.
    pub(super) fn is_ahead(&self) -> bool {
        (0.5 * (self.from + self.to)).cos() > 0.0
    }

    /// The angle at a parameter of the piece.
    pub(in crate::construct::bodies) fn angle(&self, t: f64) -> f64 {
        // The chord between the half directions is cut at t.
        let half = 0.5 * (self.to - self.from);
        self.from + half + 2.0 * (2.0 * (t - 0.5) * (0.5 * half).tan()).atan()
    }
}

/// The loop of the balls of a blend.
pub(super) struct Loop {
    pub(super) pieces: Vec<LoopPiece>,
    /// The largest difference of a radius from the law.
    pub(super) deviation: f64,
}

fn half(angle: f64) -> [f64; 2] {
    let (s, c) = (0.5 * angle).sin_cos();
    [s, c]
}
