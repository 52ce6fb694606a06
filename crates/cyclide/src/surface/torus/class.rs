//! Points of a torus by complex classes: four complex numbers of which only the directions modulo pi matter.

use super::Torus;
use crate::base::complex::Complex;
use crate::base::planar::Point2;
use crate::base::vector::Point3;
use crate::error::{Error, ErrorItem, NumberError, Result, TorusError};
use std::f64::consts::TAU;

/// The directions of `A` and `B` as complex numbers of length 1, each up to its sign.
#[derive(Debug, Clone, Copy)]
pub(super) struct UnitPair {
    pub(super) a: Complex,
    pub(super) b: Complex,
}

/// The same place of a torus with both angles within a turn, to the rounding of angles of this size: sines and cosines are those of the
/// angle itself, however many turns it has. What is within a turn stays as it is.
pub(crate) fn within_a_turn(place: Point2) -> Point2 {
    let reduced = |angle: f64| if angle.abs() <= TAU { angle } else { Complex::at_angle(angle).arg() };
    Point2::new(reduced(place.x), reduced(place.y))
}

impl UnitPair {
    pub(super) fn at(place: Point2) -> Self {
        Self { a: Complex::at_angle(place.x), b: Complex::at_angle(place.y) }
    }

    /// The number of length 1 at the longitude `2A`; products of directions drift off the length 1 by rounding.
    pub(super) fn longitude(&self) -> Complex {
        (self.a * self.a) * (1.0 / self.a.norm_squared())
    }

    /// `sin² B` and `sin B cos B`.
    pub(super) fn tube_squares(&self) -> (f64, f64) {
        let n = self.b.norm_squared();
        (self.b.im * self.b.im / n, self.b.re * self.b.im / n)
    }

    /// From the directions of the four coordinates: `A = al0 + al1 + al2`, `B = al1 - al2 + al3`.
    pub(super) fn of_coordinates([z0, z1, z2, z3]: [Complex; 4]) -> Self {
        Self { a: z0 * z1 * z2, b: z1 * z2.conj() * z3 }
    }
}

/// A point of every torus as four complex coordinates `[re, im]`, each up to a real factor: a step of the angle of the first one
/// runs along a parallel, of the second and third along the two Villarceau circles, of the fourth along a meridian.
///
/// Four complex polynomials give every rational curve on a torus (`docs/math/torus-splines.md#four-complex-polynomials`).
///
/// ```
/// use cyclide::{Frame, Point2, surface::{Torus, TorusClasses}};
/// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
/// let classes = TorusClasses::new([[1.0, 1.0], [1.0, 0.0], [-2.0, 0.0], [3.0, 3.0]])?; // al = 45, 0, 0, 45 degrees
/// let place = Point2::new(std::f64::consts::FRAC_PI_4, std::f64::consts::FRAC_PI_4);
/// assert!(torus.point_of_classes(&classes).distance(torus.point(place)) < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorusClasses {
    units: [Complex; 4],
}

impl TorusClasses {
    /// The classes of four complex numbers `[re, im]`.
    ///
    /// # Errors
    /// `not-finite`, `zero-coordinate`.
    pub fn new(coordinates: [[f64; 2]; 4]) -> Result<Self> {
        let mut units = [Complex::ONE; 4];
        for (index, (unit, z)) in units.iter_mut().zip(coordinates).enumerate() {
            *unit = unit_of(index, z)?;
        }
        Ok(Self { units })
    }

    /// The place modulo pi, each angle in `(-pi, pi]`.
    #[must_use]
    pub fn place(&self) -> Point2 {
        let pair = UnitPair::of_coordinates(self.units);
        Point2::new(pair.a.arg(), pair.b.arg())
    }
}

/// The direction of a complex number `[re, im]`.
///
/// # Errors
/// `not-finite`, `zero-coordinate`, with the index given.
pub(super) fn unit_of(index: usize, [re, im]: [f64; 2]) -> Result<Complex> {
    if !(re.is_finite() && im.is_finite()) {
        return Err(NumberError::NotFinite { what: ErrorItem::Coordinate, index }.into());
    }
    // Scaled first: the square of the length of huge numbers is infinite, that of tiny ones zero.
    let largest = re.abs().max(im.abs());
    Complex::new(re / largest, im / largest).unit().ok_or(Error::Torus(TorusError::ZeroCoordinate { index }))
}

impl Torus {
    /// The point with these complex coordinates, without angles.
    #[must_use]
    pub fn point_of_classes(&self, classes: &TorusClasses) -> Point3 {
        self.world_point(self.shape.point(&UnitPair::of_coordinates(classes.units)))
    }
}
