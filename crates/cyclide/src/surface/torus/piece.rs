//! One quartic piece on a torus: two coordinates that run, each a linear complex function of the parameter.
//!
//! `z(s) = z(0) ((1-s) + s w)` turns by `arg w` in all, monotonically; with `u = (1-s) + s w`, `r = (w-1)/u`
//! ```text
//! al' = Im r = Im w / |u|²,   al'' = -Im r²,   al''' = 2 Im r³
//! ```
//! which keeps all digits of tiny turns. A coordinate with a real ratio stands still: its ratio is 1 exactly, and the piece is an
//! arc of a circle (`docs/math/torus-splines.md#quartic-pieces`).

use super::class::UnitPair;
use super::coordinates::Jet3;
use super::family::QuarticType;
use crate::base::complex::Complex;
use crate::base::planar::{Point2, Vec2};

/// How one coordinate runs over a piece: the step of its angle, and the complex number at the end over that at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Course {
    pub(crate) step: f64,
    pub(crate) ratio: Complex,
}

impl Course {
    /// A coordinate that stands still.
    pub(crate) const STILL: Self = Self { step: 0.0, ratio: Complex::ONE };

    /// The complex number at `s` over that at the start.
    fn at(&self, s: f64) -> Complex {
        Complex::new((1.0 - s) + s * self.ratio.re, s * self.ratio.im)
    }

    /// The turn up to `s`.
    pub(crate) fn turn(&self, s: f64) -> f64 {
        if s >= 1.0 { self.step } else { self.at(s).arg() }
    }

    /// First to third derivative of the angle.
    fn jet(&self, s: f64) -> [f64; 3] {
        let u = self.at(s);
        let n = u.norm_squared();
        let im = self.ratio.im / n;
        let re = ((self.ratio.re - 1.0) * u.re + self.ratio.im * u.im) / n;
        [im, -2.0 * re * im, 2.0 * im * (3.0 * re * re - im * im)]
    }

    pub(super) fn is_still(&self) -> bool {
        self.ratio.im == 0.0
    }

    /// The part between two parameters.
    fn restricted(&self, s0: f64, s1: f64) -> Self {
        if self.is_still() {
            return *self;
        }
        let (u0, u1) = (self.at(s0), self.at(s1));
        let n = u0.norm_squared();
        // Im(u1 conj u0) = (s1 - s0) Im w, without the difference of the products.
        let re = (u1.re * u0.re + u1.im * u0.im) / n;
        let ratio = Complex::new(re, (s1 - s0) * self.ratio.im / n);
        Self { step: ratio.arg(), ratio }
    }

    fn reversed(&self) -> Self {
        let n = self.ratio.norm_squared();
        Self { step: -self.step, ratio: Complex::new(self.ratio.re / n, -self.ratio.im / n) }
    }
}

/// A rational quartic on a torus, or an arc of one of its circles: two coordinates run over `s` in `[0, 1]`, each in one direction
/// and by less than pi.
///
/// ```
/// use cyclide::{Frame, Point2, construct::TorusSplineOptions, surface::{Torus, TorusSpline}};
/// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
/// let places = [Point2::new(0.0, 0.0), Point2::new(0.5, 0.3), Point2::new(1.1, 0.2)];
/// let spline = TorusSpline::through_places(&torus, &places, &TorusSplineOptions::default())?;
/// let piece = &spline.pieces()[0];
/// assert!(torus.point(piece.place(0.0)).distance(torus.point(places[0])) == 0.0);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorusPiece {
    kind: QuarticType,
    start: Point2,
    /// The complex coordinates at the start, of length 1.
    units: [Complex; 2],
    courses: [Course; 2],
}

impl TorusPiece {
    /// From a place, with the course of each coordinate of the type.
    pub(crate) fn new(kind: QuarticType, start: Point2, courses: [Course; 2]) -> Self {
        let units = kind.local(start - Point2::default()).map(Complex::at_angle);
        Self { kind, start, units, courses }
    }

    /// Its type.
    #[must_use]
    pub fn quartic_type(&self) -> QuarticType {
        self.kind
    }

    /// Polynomial degree of the exact rational form: 4, or 2 for an arc of a circle, on which one coordinate stands still.
    #[must_use]
    pub fn degree(&self) -> usize {
        2 * self.courses.iter().filter(|c| !c.is_still()).count().max(1)
    }

    /// Place at the start.
    #[must_use]
    pub fn start(&self) -> Point2 {
        self.start
    }

    /// How far the place moves over the piece, whole turns counted.
    #[must_use]
    pub fn step(&self) -> Vec2 {
        self.kind.back(self.courses.map(|c| c.step))
    }

    /// The complex numbers `[re, im]` of both coordinates at the start and at the end: between them they are linear.
    #[must_use]
    pub fn linear_coordinates(&self) -> [[[f64; 2]; 2]; 2] {
        let ends = |i: usize| [self.units[i], self.units[i] * self.courses[i].ratio].map(|z| [z.re, z.im]);
        [ends(0), ends(1)]
    }

    /// The place at `s` in `[0, 1]`; it runs on from the start without leaps.
    #[must_use]
    pub fn place(&self, s: f64) -> Point2 {
        self.start + self.moved(s)
    }

    /// How far the place has moved at `s`, to the digits of the move itself.
    pub(crate) fn moved(&self, s: f64) -> Vec2 {
        self.kind.back(self.courses.map(|c| c.turn(s)))
    }

    /// Speed of the place at `s`, by `s`.
    #[must_use]
    pub fn rate(&self, s: f64) -> Vec2 {
        self.kind.back(self.courses.map(|c| c.jet(s)[0]))
    }

    /// The directions of both angles at `s`.
    pub(super) fn unit_pair(&self, s: f64) -> UnitPair {
        let units = std::array::from_fn(|i| {
            let z = self.units[i] * self.courses[i].at(s);
            z * (1.0 / z.norm())
        });
        self.kind.join(units)
    }

    /// The same up to positive factors, as polynomials of `s`: what runs along one angle is of degree 2 at most.
    pub(super) fn direction_polynomials(&self, s: f64) -> UnitPair {
        self.kind.join(std::array::from_fn(|i| self.units[i] * self.courses[i].at(s)))
    }

    /// Derivatives of both angles at `s`.
    pub(super) fn rates(&self, s: f64) -> Jet3 {
        let [p, q] = self.courses.map(|c| c.jet(s));
        let [d, e] = self.kind.families().map(|f| f.direction());
        Jet3 {
            a: std::array::from_fn(|k| d.x * p[k] + e.x * q[k]),
            b: std::array::from_fn(|k| d.y * p[k] + e.y * q[k]),
        }
    }

    pub(super) fn course(&self, coordinate: usize) -> (Complex, Course) {
        (self.units[coordinate], self.courses[coordinate])
    }

    /// The part between two parameters of the piece, `0 <= s0 < s1 <= 1`.
    pub(crate) fn part(&self, s0: f64, s1: f64) -> Self {
        let units = std::array::from_fn(|i| {
            let z = self.units[i] * self.courses[i].at(s0);
            z * (1.0 / z.norm())
        });
        Self { start: self.place(s0), units, courses: self.courses.map(|c| c.restricted(s0, s1)), ..*self }
    }

    /// The same points run backwards.
    pub(super) fn reversed(&self) -> Self {
        let ends: [Complex; 2] = std::array::from_fn(|i| self.units[i] * self.courses[i].ratio);
        Self {
            start: self.start + self.step(),
            units: ends.map(|z| z * (1.0 / z.norm())),
            courses: self.courses.map(|c| c.reversed()),
            ..*self
        }
    }

    /// With `A` turned into `-A`: parallels run back, both kinds of Villarceau circles change places and run back.
    pub(super) fn mirrored(&self) -> Self {
        use super::family::CircleFamily::{Meridian, MirrorVillarceau, Parallel, Villarceau};
        let back = |i: usize| {
            let (Course { step, ratio }, unit) = (self.courses[i], self.units[i]);
            (unit.conj(), Course { step: -step, ratio: ratio.conj() })
        };
        let same = |i: usize| (self.units[i], self.courses[i]);
        let [first, second] = self.kind.families();
        let image = |family, i: usize| match family {
            Parallel => (Parallel, back(i)),
            Villarceau => (MirrorVillarceau, back(i)),
            MirrorVillarceau => (Villarceau, back(i)),
            Meridian => (Meridian, same(i)),
        };
        let (mut one, mut other) = (image(first, 0), image(second, 1));
        if one.0.index() > other.0.index() {
            std::mem::swap(&mut one, &mut other);
        }
        let kind = QuarticType::between(one.0, other.0).unwrap_or(self.kind);
        let start = Point2::new(-self.start.x, self.start.y);
        Self { kind, start, units: [one.1.0, other.1.0], courses: [one.1.1, other.1.1] }
    }
}
