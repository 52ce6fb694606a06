//! Making arcs: from weights, tangents, a third point, a bulge, a center, complex weights.
//!
//! Every constructor refuses as `parameter-out-of-range` coordinates above 1e150, distances above 4e150 or below 1e-150
//! (and not 0), and a weight ratio longer than 1e30 or shorter than 1e-30: beyond, derivatives leave the range of
//! doubles. An arc that turns by a full circle less 3.9e-7 radians or more (a bulge of ten millions) is refused as
//! `nearly-full-circle`.

use super::{Arc, FULL_CIRCLE_LIMIT, POLE_LIMIT};
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ArcError, Error, ErrorItem, NumberError, PointError, Result};

/// Largest cosine between chord and weight that counts as rounding of the input (`000`, Proposition 4).
const PERPENDICULAR_LIMIT: f64 = 1e-9;

/// Part of a weight ratio along the chord that counts as rounding of a quotient of quaternions, relative to the ratio.
const RATIO_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The chord between two points with its length, refusing equal doubles.
fn chord(a: Point3, b: Point3, first: usize, second: usize) -> Result<(Vec3, f64)> {
    for (index, p) in [(first, a), (second, b)] {
        range::check_point(index, p.to_vec())?;
    }
    let c = b - a;
    let l = c.length();
    if l == 0.0 {
        return Err(PointError::CoincidentPoints { first, second, distance: l, limit: 0.0 }.into());
    }
    range::check_distance(l)?;
    Ok((c, l))
}

/// A tangent with its length, refusing zero and non-finite ones.
fn tangent(v: Vec3, index: usize) -> Result<f64> {
    if !v.is_finite() {
        return Err(NumberError::NotFinite { what: ErrorItem::Tangent, index }.into());
    }
    match v.length() {
        0.0 => Err(PointError::ZeroTangent { index }.into()),
        l => Ok(l),
    }
}

impl Arc {
    /// The straight segment between two points, at uniform speed.
    ///
    /// # Errors
    /// `not-finite`. Equal points give a constant arc.
    pub fn segment(start: Point3, end: Point3) -> Result<Self> {
        Self::from_ratio(start, end, 1.0, Vec3::ZERO)
    }

    /// The arc with end points and quaternion weights (`000`, (11)). Multiplying both weights on the right by a
    /// common quaternion changes nothing; the ratio must be perpendicular to the chord up to 1e-9, and the part
    /// along the chord is dropped. Equal ends are legal and give a constant arc (poles of surfaces of revolution).
    ///
    /// # Errors
    /// `not-finite`, `zero-weight`, `pole-on-segment`, `not-in-im-h`.
    pub fn from_weights(start: Point3, end: Point3, start_weight: Quat, end_weight: Quat) -> Result<Self> {
        for (index, w) in [start_weight, end_weight].into_iter().enumerate() {
            if !w.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::Weight, index }.into());
            }
            if w.norm() == 0.0 {
                return Err(ArcError::ZeroWeight { index }.into());
            }
        }
        let inverse = start_weight.inverse().ok_or(ArcError::ZeroWeight { index: 0 })?;
        Self::from_weight_ratio(start, end, end_weight * inverse)
    }

    /// The arc with end points and weight ratio `w1 w0^-1`.
    ///
    /// # Errors
    /// As [`from_weights`](Self::from_weights).
    pub fn from_weight_ratio(start: Point3, end: Point3, ratio: Quat) -> Result<Self> {
        if let (Some(c), Some(p)) = ((end - start).unit(), ratio.vector().unit()) {
            let cosine = c.dot(p);
            // A nearly real ratio carries its rounding in the vector part: measured against |w|, it is nothing.
            let along = cosine.abs() * (ratio.vector().length() / ratio.norm());
            if cosine.abs() > PERPENDICULAR_LIMIT && along > RATIO_ROUNDING {
                return Err(ArcError::NotInImH { cosine, limit: PERPENDICULAR_LIMIT }.into());
            }
        }
        Self::from_ratio_across(start, end, ratio)?.short_of_full_circle()
    }

    /// As [`from_weight_ratio`](Self::from_weight_ratio), dropping any part of the ratio along the chord.
    pub(crate) fn from_ratio_across(start: Point3, end: Point3, ratio: Quat) -> Result<Self> {
        let p = ratio.vector();
        Self::from_ratio(start, end, ratio.w, (end - start).unit().map_or(p, |c| p - c * p.dot(c)))
    }

    /// The arc that starts with derivative `v0 = xi'(0)`; its length sets the parametrisation (`000`, Remark 4, (22)).
    ///
    /// # Errors
    /// `not-finite`, `coincident-points`, `zero-tangent`, `tangent-opposes-chord`.
    pub fn from_start_tangent(start: Point3, end: Point3, v0: Vec3) -> Result<Self> {
        let (c, l) = chord(start, end, 0, 1)?;
        tangent(v0, 0)?;
        let (c, v) = (c / l, v0 / l);
        Self::from_ratio(start, end, c.dot(v), v.cross(c)).map_err(|e| opposes(e, 0))?.short_of_full_circle()
    }

    /// The arc that ends with derivative `v1 = xi'(1)` (`000`, (23)).
    ///
    /// # Errors
    /// As [`from_start_tangent`](Self::from_start_tangent).
    pub fn from_end_tangent(start: Point3, end: Point3, v1: Vec3) -> Result<Self> {
        let (c, l) = chord(start, end, 0, 1)?;
        let vl = tangent(v1, 1)?;
        // w = v1^-1 c = (<v1,c>, c × v1)/|v1|², here with unit vectors and the length put back.
        let (c, v) = (c / l, v1 / vl);
        let scale = l / vl;
        let arc = Self::from_ratio(start, end, v.dot(c) * scale, c.cross(v) * scale).map_err(|e| opposes(e, 1))?;
        arc.short_of_full_circle()
    }

    /// The arc from `start` through `middle` (reached at `t = 1/2`) to `end` (`000`, Remark 3, corrected:
    /// `w = (a1-b)^-1 (b-a0)`, which is translation invariant).
    ///
    /// # Errors
    /// `not-finite`, `coincident-points` (any two equal), `point-at-infinity` (the middle point is on the chord's
    /// line outside the chord).
    pub fn from_three_points(start: Point3, middle: Point3, end: Point3) -> Result<Self> {
        chord(start, end, 0, 2)?;
        let (e0, l0) = chord(start, middle, 0, 1)?;
        let (e1, l1) = chord(middle, end, 1, 2)?;
        let (u0, u1, scale) = (e0 / l0, e1 / l1, l0 / l1);
        let p = u0.cross(u1) * scale;
        // e0 × e1 is perpendicular to the chord e0 + e1 up to rounding.
        let p = (end - start).unit().map_or(p, |cu| p - cu * p.dot(cu));
        let arc = Self::from_ratio(start, end, u0.dot(u1) * scale, p).map_err(|e| match e {
            Error::Arc(ArcError::PoleOnSegment { .. }) => Error::at_infinity(ErrorItem::Point, 1),
            other => other,
        })?;
        arc.short_of_full_circle()
    }

    /// The arc with DXF bulge `tan(sweep/4)`, counter-clockwise about `normal` for a positive bulge; `normal` need
    /// not be unit and only its part perpendicular to the chord counts. Bulge 0 is the segment.
    ///
    /// # Errors
    /// `not-finite`, `zero-axis` (normal zero or along the chord), `nearly-full-circle` (a bulge beyond 1e7).
    pub fn from_bulge(start: Point3, end: Point3, normal: Vec3, bulge: f64) -> Result<Self> {
        if !bulge.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Bulge, index: 0 }.into());
        }
        if bulge == 0.0 {
            return Self::segment(start, end);
        }
        let zero = Error::zero_axis(ErrorItem::Normal);
        let mut n = normal.unit().ok_or_else(|| zero.clone())?;
        if let Some(cu) = (end - start).unit() {
            let across = n - cu * n.dot(cu);
            if across.length() <= PERPENDICULAR_LIMIT {
                let (length, limit) = (across.length(), PERPENDICULAR_LIMIT);
                return Err(PointError::ZeroAxis { what: ErrorItem::Normal, index: 0, length, limit }.into());
            }
            n = across.unit().ok_or(zero)?;
        }
        // alpha = 2 atan B: cos = (1-B²)/(1+B²), sin = 2B/(1+B²), without trigonometry; 1/B² may overflow, B² too.
        let b = bulge.abs();
        let (r, s) = if b <= 1.0 {
            let d = 1.0 + b * b;
            ((1.0 - b) * (1.0 + b) / d, 2.0 * b / d)
        } else {
            let q = 1.0 / b;
            let d = 1.0 + q * q;
            ((q - 1.0) * (q + 1.0) / d, 2.0 * q / d)
        };
        // So large that the half circle less the sweep is rounded away: the pole is then on the chord.
        let full = |e| match e {
            Error::Arc(ArcError::PoleOnSegment { .. }) => {
                Error::Arc(ArcError::NearlyFullCircle { rest: 4.0 * b.recip().atan(), limit: FULL_CIRCLE_LIMIT })
            }
            other => other,
        };
        Self::from_ratio(start, end, r, n * s.copysign(bulge)).map_err(full)?.short_of_full_circle()
    }

    /// The arc from `start` turning by `sweep` radians about the axis through `center` along `normal`,
    /// right-handed for positive `sweep`; `|sweep| < 2 pi`. The start is projected to the plane of the center.
    ///
    /// # Errors
    /// `not-finite`, `zero-axis`, `zero-radius`, `sweep-out-of-range`, `nearly-full-circle`.
    pub fn from_center(center: Point3, normal: Vec3, start: Point3, sweep: f64) -> Result<Self> {
        range::check_point(0, center.to_vec())?;
        range::check_point(1, start.to_vec())?;
        if !normal.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Normal, index: 0 }.into());
        }
        let limit = std::f64::consts::TAU;
        if !(sweep.abs() < limit) {
            return Err(NumberError::SweepOutOfRange { sweep, min: -limit, max: limit }.into());
        }
        let n = normal.unit().ok_or(Error::zero_axis(ErrorItem::Normal))?;
        let v = start - center;
        let d = v - n * v.dot(n);
        let limit = 1e-14 * v.length();
        if d.length() <= limit || d.max_abs() == 0.0 {
            return Err(NumberError::ZeroRadius { radius: d.length(), limit }.into());
        }
        let (s, c) = (0.5 * sweep).sin_cos();
        // The end: d turned by the sweep. The chord is 2 sin(sweep/2) times a perpendicular of the normal.
        let chord = (n.cross(d) * c - d * s) * (2.0 * s);
        let p0 = center + d;
        Self::from_ratio(p0, p0 + chord, c, n * s)?.short_of_full_circle()
    }

    /// The planar arc with complex ends and weights (`000`, Proposition 1), placed at height 0: a complex weight
    /// ratio `r + i s` is the quaternion `r - s k`, so it turns *clockwise* for `s > 0`.
    ///
    /// # Errors
    /// As [`from_weights`](Self::from_weights).
    pub fn from_complex(start: [f64; 2], end: [f64; 2], start_weight: [f64; 2], end_weight: [f64; 2]) -> Result<Self> {
        let point = |a: [f64; 2]| Point3::new(a[0], a[1], 0.0);
        let weight = |w: [f64; 2]| Quat::new(w[0], 0.0, 0.0, -w[1]);
        Self::from_weights(point(start), point(end), weight(start_weight), weight(end_weight))
    }

    /// Start, end and weight ratio as complex numbers, the inverse of [`from_complex`](Self::from_complex) with start
    /// weight 1; `None` unless the arc lies at height 0.
    #[must_use]
    pub fn to_complex(&self) -> Option<[[f64; 2]; 3]> {
        let (p, level) = (self.p, self.p0.z == 0.0 && self.p1.z == 0.0);
        let planar = level && p.x == 0.0 && p.y == 0.0;
        planar.then_some([[self.p0.x, self.p0.y], [self.p1.x, self.p1.y], [self.r, -p.z]])
    }
}

fn opposes(error: Error, index: usize) -> Error {
    match error {
        Error::Arc(ArcError::PoleOnSegment { real, vector, .. }) => {
            Error::Arc(ArcError::TangentOpposesChord { index, angle: vector.atan2(-real), limit: POLE_LIMIT })
        }
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_complex_form_goes_both_ways() {
        let arc = Arc::from_complex([-1.0, 1.0], [1.0, 0.0], [1.0, 0.0], [-0.75, -0.5]).unwrap();
        let [start, end, ratio] = arc.to_complex().unwrap();
        assert_eq!(arc, Arc::from_complex(start, end, [1.0, 0.0], ratio).unwrap());
        assert_eq!(ratio.map(f64::to_bits), [-0.75_f64, -0.5].map(f64::to_bits));
        let tilted =
            Arc::from_three_points(Point3::ORIGIN, Point3::new(1.0, 0.0, 1.0), Point3::new(2.0, 0.0, 0.0)).unwrap();
        assert!(tilted.to_complex().is_none());
    }
}
