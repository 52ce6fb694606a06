//! The four families of circles, the six types of quartics between two of them, and the switches from type to type.

use super::class::{UnitPair, unit_of};
use crate::base::complex::Complex;
use crate::base::planar::Vec2;
use crate::error::Result;

/// A family of circles on a torus; one circle of each passes through every point.
///
/// ```
/// use cyclide::{Frame, Point2, surface::{CircleFamily, Torus}};
/// let torus = Torus::new(Frame::WORLD, 5.0, 2.0)?;
/// let circle = torus.circle(CircleFamily::Villarceau, Point2::new(0.3, 0.4))?;
/// assert!((circle.radius() - 5.0).abs() < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CircleFamily {
    /// Round the axis, `B` constant.
    Parallel,
    /// Villarceau circles along which `A` and `B` rise together.
    Villarceau,
    /// Villarceau circles along which `B` falls as `A` rises.
    MirrorVillarceau,
    /// Round the tube, `A` constant.
    Meridian,
}

impl CircleFamily {
    /// All four, in the order of the complex coordinates.
    pub const ALL: [Self; 4] = [Self::Parallel, Self::Villarceau, Self::MirrorVillarceau, Self::Meridian];

    /// The number of its complex coordinate, 0 to 3.
    #[must_use]
    pub const fn index(self) -> usize {
        match self {
            Self::Parallel => 0,
            Self::Villarceau => 1,
            Self::MirrorVillarceau => 2,
            Self::Meridian => 3,
        }
    }

    /// How far the place moves for each radian of its coordinate.
    #[must_use]
    pub const fn direction(self) -> Vec2 {
        match self {
            Self::Parallel => Vec2::new(1.0, 0.0),
            Self::Villarceau => Vec2::new(1.0, 1.0),
            Self::MirrorVillarceau => Vec2::new(1.0, -1.0),
            Self::Meridian => Vec2::new(0.0, 1.0),
        }
    }
}

/// A type of quartic curves on a torus: the coordinates of two families of circles run, linearly as complex numbers, the other two
/// rest.
///
/// Such a curve is nowhere tangent to a circle of either family. The coordinates are linear functions of the place; all types but that
/// between the Villarceau circles have them modulo pi one to one, that one has two pairs for every place.
///
/// ```
/// use cyclide::{Vec2, surface::{CircleFamily, QuarticType}};
/// let kind = QuarticType::between(CircleFamily::Parallel, CircleFamily::Villarceau).expect("they differ");
/// assert_eq!(kind.local(Vec2::new(0.5, 0.2)), [0.3, 0.2]); // (A - B, B)
/// assert_eq!(kind.back([0.3, 0.2]), Vec2::new(0.5, 0.2));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct QuarticType {
    first: CircleFamily,
    second: CircleFamily,
}

impl QuarticType {
    /// All six, by their families in order.
    pub const ALL: [Self; 6] = {
        use CircleFamily::{Meridian, MirrorVillarceau, Parallel, Villarceau};
        [
            Self { first: Parallel, second: Villarceau },
            Self { first: Parallel, second: MirrorVillarceau },
            Self { first: Parallel, second: Meridian },
            Self { first: Villarceau, second: MirrorVillarceau },
            Self { first: Villarceau, second: Meridian },
            Self { first: MirrorVillarceau, second: Meridian },
        ]
    };

    /// The type between two families, in their order; `None` if they are one and the same.
    #[must_use]
    pub fn between(one: CircleFamily, other: CircleFamily) -> Option<Self> {
        let (first, second) = if one.index() < other.index() { (one, other) } else { (other, one) };
        (first != second).then_some(Self { first, second })
    }

    /// Its families, that of the first coordinate first.
    #[must_use]
    pub const fn families(self) -> [CircleFamily; 2] {
        [self.first, self.second]
    }

    /// The two coordinates of a place or a speed, as a vector from the place (0, 0).
    #[must_use]
    pub fn local(self, v: Vec2) -> [f64; 2] {
        use CircleFamily::{Meridian, MirrorVillarceau, Parallel, Villarceau};
        let (a, b) = (v.x, v.y);
        match (self.first, self.second) {
            (Parallel, Villarceau) => [a - b, b],
            (Parallel, MirrorVillarceau) => [a + b, -b],
            (Villarceau, Meridian) => [a, b - a],
            (MirrorVillarceau, Meridian) => [a, a + b],
            (Villarceau, MirrorVillarceau) => [0.5 * (a + b), 0.5 * (a - b)],
            _ => [a, b],
        }
    }

    /// The place or speed with these coordinates: the inverse of [`local`](Self::local).
    #[must_use]
    pub fn back(self, [first, second]: [f64; 2]) -> Vec2 {
        self.first.direction() * first + self.second.direction() * second
    }

    /// The coordinates of the same point in another type, as complex numbers of length 1, from complex numbers `[re, im]` in this
    /// type: without angles and without poles. Of the two answers for the type between the Villarceau circles that with a
    /// positive real part of the first number is given; the other one is both numbers times the imaginary unit.
    ///
    /// Speeds switch by [`local`](Self::local) of [`back`](Self::back).
    ///
    /// # Errors
    /// `not-finite`, `zero-coordinate`.
    pub fn switch(self, to: Self, coordinates: [[f64; 2]; 2]) -> Result<[[f64; 2]; 2]> {
        let units = [unit_of(0, coordinates[0])?, unit_of(1, coordinates[1])?];
        Ok(to.split(&self.join(units)).map(|z| [z.re, z.im]))
    }

    /// The directions of `A` and `B` from those of the two coordinates.
    pub(super) fn join(self, units: [Complex; 2]) -> UnitPair {
        let mut all = [Complex::ONE; 4];
        all[self.first.index()] = units[0];
        all[self.second.index()] = units[1];
        UnitPair::of_coordinates(all)
    }

    /// The directions of the two coordinates from those of `A` and `B`.
    fn split(self, UnitPair { a, b }: &UnitPair) -> [Complex; 2] {
        use CircleFamily::{Meridian, MirrorVillarceau, Parallel, Villarceau};
        let (a, b) = (*a, *b);
        match (self.first, self.second) {
            (Parallel, Villarceau) => [a * b.conj(), b],
            (Parallel, MirrorVillarceau) => [a * b, b.conj()],
            (Villarceau, Meridian) => [a, b * a.conj()],
            (MirrorVillarceau, Meridian) => [a, a * b],
            (Villarceau, MirrorVillarceau) => {
                let root = (a * b).unit_sqrt();
                [root, a * root.conj()]
            }
            _ => [a, b],
        }
    }
}
