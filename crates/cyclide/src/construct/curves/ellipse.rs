//! Ellipses and their arcs, as exact rational quadratics (`docs/math/ellipses-and-helices.md`).

use super::plane_axes::plane_axes;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, NumberError, Result};
use crate::rational::{NurbsCurve, RationalBezier};
use std::f64::consts::{FRAC_PI_2, TAU};

/// An ellipse.
///
/// ```
/// use cyclide::{Point3, Vec3, construct::Ellipse, curve::length};
/// let ellipse = Ellipse::new(Point3::ORIGIN, Vec3::Z, None, [5.0, 3.0])?;
/// let curve = ellipse.to_nurbs(0.0, std::f64::consts::TAU)?;
/// assert!(curve.degree() == 2 && ellipse.point(0.0) == Point3::new(5.0, 0.0, 0.0));
/// assert!((length(&curve) - 25.526_998_863_398_12).abs() < 1e-9);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipse {
    center: Point3,
    axes: [Vec3; 2],
}

impl Ellipse {
    /// From its center, the normal about which it runs counter-clockwise, the direction of the first semi-axis (as far as it is across the normal; x of space if none
    /// is given, or y where x is the normal), and both semi-axes.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates), `radius-not-positive`, `zero-axis`.
    pub fn new(center: Point3, normal: Vec3, x_direction: Option<Vec3>, semi_axes: [f64; 2]) -> Result<Self> {
        range::check_point(0, center.to_vec())?;
        for (index, &radius) in semi_axes.iter().enumerate() {
            range::check_radius(ErrorItem::Radius, index, radius)?;
        }
        let [x, y, _] = plane_axes(normal, x_direction)?;
        Ok(Self { center, axes: [x * semi_axes[0], y * semi_axes[1]] })
    }

    /// The point of an angle of the parameter: `center + cos(angle) a + sin(angle) b`.
    #[must_use]
    pub fn point(&self, angle: f64) -> Point3 {
        let [cos, sin] = cos_sin(angle);
        self.center + self.axes[0] * cos + self.axes[1] * sin
    }

    /// The arc from an angle of the parameter on over another, negative clockwise, exact: pieces of at most a quarter. A whole turn is closed.
    ///
    /// # Errors
    /// `not-finite`, `angle-out-of-range` (0, or more than a turn).
    pub fn to_nurbs(&self, start: f64, sweep: f64) -> Result<NurbsCurve> {
        if !(start.is_finite() && sweep.is_finite()) {
            return Err(NumberError::NotFinite { what: ErrorItem::Angle, index: 0 }.into());
        }
        if sweep == 0.0 || sweep.abs() > TAU * (1.0 + f64::EPSILON) {
            return Err(
                NumberError::AngleOutOfRange { name: ErrorItem::Angle, angle: sweep, min: -TAU, max: TAU }.into()
            );
        }
        let count = (sweep.abs() / FRAC_PI_2 - 1e-9).ceil().max(1.0);
        let step = sweep / count;
        let at = |k: f64| start + step * k;
        let row = |angle: f64, weight: f64| {
            let [cos, sin] = cos_sin(angle);
            let p = self.center.to_vec() * weight + self.axes[0] * cos + self.axes[1] * sin;
            [p.x, p.y, p.z, weight]
        };
        let [weight, _] = cos_sin(0.5 * step);
        let piece = |k: usize| {
            let k = k as f64;
            RationalBezier::new(vec![row(at(k), 1.0), row(at(k + 0.5), weight), row(at(k + 1.0), 1.0)])
        };
        let pieces: Vec<RationalBezier> = (0..count as usize).map(piece).collect::<Result<_>>()?;
        let curve = NurbsCurve::from_beziers(&pieces, &vec![1.0; pieces.len()])?;
        Ok(if sweep.abs() >= TAU * (1.0 - f64::EPSILON) { curve.closed_by_rounding() } else { curve })
    }
}

/// Cosine and sine; at quarters of a turn, up to rounding, exact.
fn cos_sin(angle: f64) -> [f64; 2] {
    let quarters = (angle / FRAC_PI_2).round();
    if (angle - quarters * FRAC_PI_2).abs() <= 4.0 * f64::EPSILON * angle.abs().max(1.0) {
        return match quarters.rem_euclid(4.0) as u8 {
            0 => [1.0, 0.0],
            1 => [0.0, 1.0],
            2 => [-1.0, 0.0],
            _ => [0.0, -1.0],
        };
    }
    let (sin, cos) = angle.sin_cos();
    [cos, sin]
}
