//! Balls told by their contact with one surface, and a plane or a sphere that they touch besides
//! (`docs/math/canal-blends.md#contact-with-a-plane-or-a-sphere`).

use super::RollingBall;
use crate::base::vector::{Point3, Vec3};
use crate::error::{BallError, Error, ErrorItem, NumberError, Result};

/// Values relative to the lengths of the input up to which tangent planes are parallel.
const PARALLEL: f64 = 1e-14;

/// The second surface of a ball whose contact with the first one is given.
///
/// ```
/// use cyclide::{Point3, Vec3, surface::{ContactPartner, RollingBall}};
/// let floor = ContactPartner::Plane { normal: Vec3::Z, offset: 0.0 };
/// let ball = RollingBall::at_contact(Point3::new(0.0, 0.0, 2.0), Vec3::X, floor)?;
/// assert_eq!((ball.radius, ball.contacts[1]), (2.0, Point3::new(2.0, 0.0, 0.0)));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactPartner {
    /// The plane `normal · x = offset`; the ball is on the side that the normal points to. The normal may have any length, which
    /// the offset refers to as well.
    Plane {
        /// Normal.
        normal: Vec3,
        /// Product of the normal with the points of the plane.
        offset: f64,
    },
    /// A sphere that the ball touches from outside; with a negative radius the ball is inside.
    Sphere {
        /// Center.
        center: Point3,
        /// Radius, or less than zero.
        radius: f64,
    },
}

impl RollingBall {
    /// The ball that touches a surface at `point`, on the side of its `normal` (of any length), and the partner.
    ///
    /// # Errors
    /// `not-finite`, `zero-axis`, `parallel-contact`, `no-positive-radius`.
    pub fn at_contact(point: Point3, normal: Vec3, partner: ContactPartner) -> Result<Self> {
        if !(point.is_finite() && normal.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Point, index: 0 }.into());
        }
        let n = normal.unit().ok_or(Error::zero_axis(ErrorItem::Normal))?;
        match partner {
            ContactPartner::Plane { normal, offset } => on_plane(point, n, normal, offset),
            ContactPartner::Sphere { center, radius } => on_sphere(point, n, center, radius),
        }
    }
}

/// `R = (N·p - offset)/(1 - N·n)`; the difference is half the square of that of the normals, which cancels nothing.
fn on_plane(point: Point3, n: Vec3, normal: Vec3, offset: f64) -> Result<RollingBall> {
    if !(normal.is_finite() && offset.is_finite()) {
        return Err(NumberError::NotFinite { what: ErrorItem::Plane, index: 0 }.into());
    }
    let (unit, length) = (normal.unit().ok_or(Error::zero_axis(ErrorItem::Plane))?, normal.length());
    let apart = 0.5 * (unit - n).length_squared();
    if apart <= PARALLEL {
        return Err(BallError::ParallelContact { measured: apart, limit: PARALLEL }.into());
    }
    let radius = (unit.dot(point.to_vec()) - offset / length) / apart;
    finish(point, n, radius, |center| (center - unit * radius, unit))
}

/// `R = (r² - g²)/(2(n·g - r))` with the way `g` from the center to the point.
fn on_sphere(point: Point3, n: Vec3, center: Point3, r: f64) -> Result<RollingBall> {
    if !(center.is_finite() && r.is_finite()) {
        return Err(NumberError::NotFinite { what: ErrorItem::Center, index: 0 }.into());
    }
    let g = point - center;
    let (below, size) = (2.0 * (n.dot(g) - r), g.length() + r.abs());
    if below.abs() <= PARALLEL * size {
        return Err(BallError::ParallelContact { measured: below.abs(), limit: PARALLEL * size }.into());
    }
    let radius = (r - g.length()) * (r + g.length()) / below;
    finish(point, n, radius, |m| {
        let outward = ((m - center) / (r + radius)).unit().unwrap_or(n);
        (center + outward * r, outward)
    })
}

fn finish(point: Point3, n: Vec3, radius: f64, second: impl Fn(Point3) -> (Point3, Vec3)) -> Result<RollingBall> {
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(BallError::NoPositiveRadius { radius }.into());
    }
    let center = point + n * radius;
    let (contact, normal) = second(center);
    Ok(RollingBall { center, radius, contacts: [point, contact], normals: [n, normal] })
}
