//! The C1 biarc of linear complex functions: an angle that runs in one direction between given values and slopes.
//!
//! An angle is a point of the real projective line, the class of a complex number up to a real factor; a linear complex function
//! turns monotonically. With step `D`, slopes `m0`, `m1` and lengths `h0`, `h1` of the two pieces
//! ```text
//! Z = h1 sqrt|m1| + h0 sqrt|m0| e^(iD),   middle angle x = arg Z,   middle slope sgn(D) sin² D/|Z|²
//! end over start:  sqrt|m0|/|sin D| Z  for the first piece,  |sin D|/sqrt|m1| e^(iD)/Z  for the second
//! ```
//! (`docs/math/torus-splines.md#biarcs-on-the-projective-line`). Imaginary parts are written out, so that tiny steps keep
//! their digits.

use crate::base::complex::Complex;
use crate::error::{CurveError, ErrorItem, NumberError, Result, TorusError};
use crate::surface::Course;
use std::f64::consts::PI;

/// Steps, and slopes times lengths, accepted, radians: ratios of complex numbers and their squares stay finite.
const STEP_RANGE: [f64; 2] = [1e-60, 1e60];

/// Lengths of the parameter accepted.
const LENGTH_RANGE: [f64; 2] = [1e-100, 1e100];

/// An angle over two pieces of a parameter, C1, with given values and slopes at both ends: the argument of a linear complex function
/// on each.
///
/// ```
/// use cyclide::construct::ProjectiveBiarc;
/// let biarc = ProjectiveBiarc::new(0.2, 1.0, [0.5, 2.0], [1.0, 1.0])?;
/// assert!((biarc.offset(2.0) - 1.0).abs() < 1e-15 && biarc.offset(1.0) == biarc.mid_offset());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProjectiveBiarc {
    start: f64,
    lengths: [f64; 2],
    mid: f64,
    mid_slope: f64,
    courses: [Course; 2],
}

impl ProjectiveBiarc {
    /// From the angle `start` by `step`, both radians, over pieces of the given lengths, with the given slopes at both ends: step and
    /// slopes of one sign, or all zero for an angle that stands still.
    ///
    /// # Errors
    /// `not-finite`, `empty-interval` (a length that is not positive), `not-monotone`, `span-too-large` (`|step| >= pi`),
    /// `parameter-out-of-range` (step, or slope times length, outside 1e-60 to 1e60; lengths outside 1e-100 to 1e100).
    pub fn new(start: f64, step: f64, slopes: [f64; 2], lengths: [f64; 2]) -> Result<Self> {
        Self::of_coordinate(0, start, step, slopes, lengths)
    }

    /// The same of one of the two coordinates of a curve.
    pub(super) fn of_coordinate(
        coordinate: usize,
        start: f64,
        step: f64,
        slopes: [f64; 2],
        lengths: [f64; 2],
    ) -> Result<Self> {
        check(coordinate, start, step, slopes, lengths)?;
        if step == 0.0 {
            return Ok(Self { start, lengths, mid: 0.0, mid_slope: 0.0, courses: [Course::STILL; 2] });
        }
        let [h0, h1] = lengths;
        let [r0, r1] = slopes.map(|m| m.abs().sqrt());
        let (sin, cos) = step.sin_cos();
        let (p, q) = (h0 * r0, h1 * r1);
        let z = Complex::new(q + p * cos, p * sin);
        let (first, length) = (r0 / sin.abs(), z.norm());
        // e^(iD) conj Z = h0 r0 + h1 r1 e^(iD), over |Z|² in two steps.
        let second = sin.abs() / r1 / length / length;
        let (x, rest) = (z.arg(), Complex::new(p + q * cos, q * sin));
        let courses = [Course { step: x, ratio: z * first }, Course { step: rest.arg(), ratio: rest * second }];
        Ok(Self { start, lengths, mid: x, mid_slope: (sin / length).powi(2).copysign(step), courses })
    }

    /// The angle at the start, radians.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.start
    }

    /// How far the angle has gone where the pieces meet, radians.
    #[must_use]
    pub fn mid_offset(&self) -> f64 {
        self.mid
    }

    /// Slope where the pieces meet.
    #[must_use]
    pub fn mid_slope(&self) -> f64 {
        self.mid_slope
    }

    /// How far the angle has gone at the parameter `u`, from 0 to the sum of both lengths (clamped), radians.
    #[must_use]
    pub fn offset(&self, u: f64) -> f64 {
        let [h0, h1] = self.lengths;
        let [first, second] = self.courses;
        if u < h0 { first.turn((u / h0).max(0.0)) } else { self.mid + second.turn(((u - h0) / h1).min(1.0)) }
    }

    pub(super) fn courses(&self) -> [Course; 2] {
        self.courses
    }
}

/// Refuses what no biarc joins.
fn check(coordinate: usize, start: f64, step: f64, slopes: [f64; 2], lengths: [f64; 2]) -> Result<()> {
    for (what, value) in [(ErrorItem::Angle, start), (ErrorItem::Angle, step)] {
        if !value.is_finite() {
            return Err(NumberError::NotFinite { what, index: coordinate }.into());
        }
    }
    for index in 0..2 {
        if !(lengths[index] > 0.0) {
            return Err(CurveError::EmptyInterval { index, length: lengths[index], limit: 0.0 }.into());
        }
        within(ErrorItem::Parameter, lengths[index], LENGTH_RANGE)?;
        if !slopes[index].is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Tangent, index }.into());
        }
    }
    if step.abs() >= PI {
        return Err(TorusError::SpanTooLarge { coordinate, step, limit: PI }.into());
    }
    let still = step == 0.0 && slopes.iter().all(|m| *m == 0.0);
    let of_one_sign = slopes.iter().all(|m| m * step.signum() > 0.0) && step != 0.0;
    if still {
        return Ok(());
    }
    if !of_one_sign {
        return Err(TorusError::NotMonotone { coordinate, step, slopes }.into());
    }
    within(ErrorItem::Angle, step.abs(), STEP_RANGE)?;
    (0..2).try_for_each(|k| within(ErrorItem::TangentOverSpan, slopes[k].abs() * lengths[k], STEP_RANGE))
}

/// Refuses a number outside its range.
pub(super) fn within(name: ErrorItem, value: f64, [min, max]: [f64; 2]) -> Result<()> {
    if (min..=max).contains(&value) {
        Ok(())
    } else {
        Err(NumberError::ParameterOutOfRange { name, value, min, max }.into())
    }
}
