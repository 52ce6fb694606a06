//! Helices: exact in the kernel, in files rational curves that lie on their cylinder exactly (`docs/math/ellipses-and-helices.md`).

use super::plane_axes::plane_axes;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{CurveError, ErrorItem, NumberError, Result};
use crate::rational::{NurbsCurve, Polynomial, RationalBezier};
use std::f64::consts::TAU;

/// Pieces of a turn at first and at most.
const PIECES: [f64; 2] = [4.0, 256.0];
/// Pieces in all.
const MOST_PIECES: f64 = 16384.0;
/// Coordinates are rounded by so many units in the last place: sums of the places of circle, height and center.
const ROUNDINGS: f64 = 4.0;
/// Places of a piece whose height is compared.
const PLACES: usize = 64;

/// A helix about an axis.
///
/// ```
/// use cyclide::{Point3, Vec3, construct::Helix, curve::length};
/// let spring = Helix::new(Point3::ORIGIN, Vec3::Z, None, 10.0, 5.0, 4.0)?;
/// let (curve, bound) = spring.to_nurbs(1e-6)?;
/// assert!(bound <= 1e-6 && (length(&curve) - spring.length()).abs() < 1e-6);
/// assert!(spring.point(1.0).distance(Point3::new(10.0, 0.0, 20.0)) < 1e-14);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Helix {
    center: Point3,
    axes: [Vec3; 3],
    radius: f64,
    pitch: f64,
    turns: f64,
}

impl Helix {
    /// From a point of the axis at the height of the start, the axis, the direction from the axis to the start (as far as it is across; x of space if none is given, or y where
    /// x is the axis), the radius, the rise along the axis over one turn, and the number of turns: negative turns left-handed, so that it rises by `pitch` times the
    /// number of turns however it is turned.
    ///
    /// # Errors
    /// `not-finite`, `parameter-out-of-range` (coordinates; the pitch or the turns beyond the range of the kernel's numbers, no turns), `radius-not-positive`, `zero-axis`.
    pub fn new(
        center: Point3,
        axis: Vec3,
        x_direction: Option<Vec3>,
        radius: f64,
        pitch: f64,
        turns: f64,
    ) -> Result<Self> {
        range::check_point(0, center.to_vec())?;
        for (index, value) in [radius, pitch, turns].into_iter().enumerate() {
            if !value.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::Radius, index }.into());
            }
        }
        if radius <= 0.0 {
            return Err(NumberError::RadiusNotPositive { what: ErrorItem::Radius, index: 0, radius }.into());
        }
        range::check_distance(radius)?;
        range::check_point(0, Vec3::new(pitch, pitch * turns, 0.0))?;
        if turns == 0.0 {
            return Err(NumberError::AngleOutOfRange {
                name: ErrorItem::Turn,
                angle: 0.0,
                min: -TAU * MOST_PIECES,
                max: TAU * MOST_PIECES,
            }
            .into());
        }
        Ok(Self { center, axes: plane_axes(axis, x_direction)?, radius, pitch, turns })
    }

    /// The point at a part of the turns, from 0 to 1.
    #[must_use]
    pub fn point(&self, t: f64) -> Point3 {
        let angle = TAU * self.turns * t;
        let [x, y, z] = self.axes;
        self.center + x * (self.radius * angle.cos()) + y * (self.radius * angle.sin()) + z * (self.height() * t)
    }

    /// The derivative by the part of the turns.
    #[must_use]
    pub fn derivative(&self, t: f64) -> Vec3 {
        let (rate, angle) = (TAU * self.turns, TAU * self.turns * t);
        let [x, y, z] = self.axes;
        (y * angle.cos() - x * angle.sin()) * (self.radius * rate) + z * self.height()
    }

    /// The rise along the axis.
    #[must_use]
    pub fn height(&self) -> f64 {
        self.pitch * self.turns.abs()
    }

    /// The length.
    #[must_use]
    pub fn length(&self) -> f64 {
        (TAU * self.turns * self.radius).hypot(self.height())
    }

    /// The curvature, the same everywhere.
    #[must_use]
    pub fn curvature(&self) -> f64 {
        let slope = self.pitch / TAU;
        self.radius / (self.radius * self.radius + slope * slope)
    }

    /// The torsion, the same everywhere; negative of a left-handed helix.
    #[must_use]
    pub fn torsion(&self) -> f64 {
        let slope = self.pitch * self.turns.signum() / TAU;
        slope / (self.radius * self.radius + slope * slope)
    }

    /// A rational curve of degree 5 with the bound of its distance from the helix, proved: it lies on the cylinder exactly, and at each angle its height differs from that
    /// of the helix by no more than the bound, the rounding of
    /// coordinates of this size included, which may be above the tolerance. Joints are tangent-continuous, and have the tangents of the helix.
    ///
    /// # Errors
    /// `tolerance-not-positive`; `too-many-pieces`.
    pub fn to_nurbs(&self, tolerance: f64) -> Result<(NurbsCurve, f64)> {
        if !(tolerance > 0.0) {
            return Err(NumberError::ToleranceNotPositive { tolerance }.into());
        }
        let mut per_turn = PIECES[0];
        loop {
            let count = (per_turn * self.turns.abs()).ceil().max(1.0);
            if count > MOST_PIECES {
                let remedy = "use a larger tolerance or fewer turns";
                return Err(NumberError::TooManyPieces {
                    what: "the helix",
                    segment: None,
                    needed: count,
                    cap: MOST_PIECES as usize,
                    remedy,
                }
                .into());
            }
            let (height, off) = self.rise(TAU * self.turns / count, count);
            let size = self.center.to_vec().max_abs() + self.radius + self.height().abs();
            let rounding = ROUNDINGS * f64::EPSILON * size;
            if off <= tolerance.max(rounding) || per_turn >= PIECES[1] {
                if !(off <= tolerance.max(rounding)) {
                    return Err(CurveError::NotWithinTolerance { piece: 0, bound: off, tolerance }.into());
                }
                // Far from the origin rounding is more than what is left out.
                return Ok((self.pieces(count as usize, &height)?, off + rounding));
            }
            per_turn *= 2.0;
        }
    }

    /// The cubic of the height over a piece that turns by an angle, by Hermite data, and a bound of its difference from the height at the same angle. The
    /// parameter `t` of the arc has the angle `2 atan2(t sin h, 1 - t + t cos h)`, `h` half the angle of the piece, and the derivative
    /// `2 sin(h)/|q|^2`, `|q|^2 = 1 - 2 t (1 - t)(1 - cos h)`.
    fn rise(&self, angle: f64, count: f64) -> (Polynomial, f64) {
        let rise = self.height() / count;
        let (sin, cos) = (0.5 * angle.abs()).sin_cos();
        let slope = rise / angle.abs();
        let end = slope * 2.0 * sin;
        let height = Polynomial::new(vec![0.0, end / 3.0, rise - end / 3.0, rise]);
        let at = |t: f64| (height.value(t) - slope * 2.0 * (t * sin).atan2(1.0 - t + t * cos)).abs();
        // The angle less its cubic has the third derivative D, D(t) = 2 sin(h) (1/|q|^2)'' less a constant: between places it cannot grow by more than the slope
        // times their distance, and that is looked at as well.
        let h = 1.0 / PLACES as f64;
        let least = 0.5 * (1.0 + cos);
        let (bend, third) = (2.0 * (1.0 - cos), 2.0 * sin * slope.abs());
        // |(1/u)'| and |(1/u)''| for u = |q|^2, |u'| <= bend, u'' = 2 bend.
        let second = third * (2.0 * bend / (least * least) + 2.0 * bend * bend / (least * least * least));
        let cubic = height.coefficients();
        let cubic = 6.0 * (cubic[3] - 3.0 * cubic[2] + 3.0 * cubic[1] - cubic[0]).abs();
        let measured = (1..PLACES).map(|k| at(k as f64 * h)).fold(0.0, f64::max);
        // A function with values at places h apart is within h^3/(9 sqrt(3)) of its third derivative of the parabola through three of them, which is within 5/4 of these.
        (height, 1.25 * measured + (second + cubic) * h * h * h / (9.0 * 3.0_f64.sqrt()))
    }

    fn pieces(&self, count: usize, height: &Polynomial) -> Result<NurbsCurve> {
        let angle = TAU * self.turns / count as f64;
        let (weight, rise) = ((0.5 * angle).cos(), self.height() / count as f64);
        let [x, y, z] = self.axes;
        let weights = Polynomial::new(vec![1.0, weight, 1.0]);
        let out = |angle: f64| (x * angle.cos() + y * angle.sin()) * self.radius;
        let piece = |k: usize| {
            let from = angle * k as f64;
            let control = [out(from), out(from + 0.5 * angle), out(from + angle)];
            let base = self.center.to_vec() + z * (rise * k as f64);
            let entry = |d: usize| {
                let circle = Polynomial::new(control.iter().map(|v| v.to_array()[d]).collect());
                let level = &(&circle + &(&weights * base.to_array()[d])).elevated(5);
                level + &(&(&weights * height) * z.to_array()[d])
            };
            let entries = [entry(0), entry(1), entry(2), weights.elevated(5)];
            let row = |j: usize| [0, 1, 2, 3].map(|d: usize| entries[d].coefficients()[j]);
            RationalBezier::new((0..=5).map(row).collect())
        };
        let pieces: Vec<RationalBezier> = (0..count).map(piece).collect::<Result<_>>()?;
        NurbsCurve::from_beziers(&pieces, &vec![1.0; count])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::ParamCurve as _;

    /// Far from the origin the bound says what rounding does, also where it is above the tolerance; near it, it is below.
    #[test]
    fn the_bound_includes_rounding() {
        for (place, tolerance) in [(0.0, 1e-6), (5.334e6, 1e-12), (1e9, 1e-3), (5.334e6, 1e-3)] {
            let helix = Helix::new(Point3::new(place, place, 100.0), Vec3::Z, None, 15.0, 8.0, 5.0).unwrap();
            let (curve, bound) = helix.to_nurbs(tolerance).unwrap();
            let mut most = 0.0_f64;
            for piece in 0..curve.piece_count() {
                for k in 0..=8 {
                    let point = curve.piece_jet(piece, f64::from(k) / 8.0).point;
                    // Differences of such coordinates are exact.
                    let [x, y, z] = [point.x - place, point.y - place, point.z - 100.0];
                    let angle = y.atan2(x);
                    let angle = angle + TAU * ((z / 8.0 * TAU - angle) / TAU).round();
                    most = most.max((x.hypot(y) - 15.0).abs()).max((z - 8.0 * angle / TAU).abs());
                }
            }
            assert!(most <= bound, "{place} {tolerance}: {most} {bound}");
            assert!(bound <= tolerance + 16.0 * f64::EPSILON * (place + 200.0), "{bound}");
        }
    }
}
