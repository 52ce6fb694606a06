//! The blend of a pipe with a plate by a neck: a rolling ball touches both, exact
//! (`docs/math/circular-surfaces.md#neck`; source: `000`, section 7, (31), Fig. 7, corrected).
//!
//! The plate is the plane z = 0, with its outside above; the pipe of radius R leans by the angle φ from the normal of the plate towards
//! +y, its axis meets the plate in the origin. (With the pipe upright and the plane `z = a y` instead: `a = tan φ`, and
//! the neck is turned about x by -φ.) With σ = 1 outside the pipe and -1 inside it, q = R + σ ρ and (c, s) on the unit circle, the center of
//! a ball of radius ρ and its contacts with pipe and plate are
//!
//! ```text
//! (q c, ρ tan φ + q s/cos φ, ρ),    centre - σ ρ (c, s cos φ, -s sin φ),    centre - (0, 0, ρ)
//! ```
//!
//! From contact to contact runs an arc that leaves the pipe along v. For the envelope of the balls it is the characteristic circle,
//! `v = (-c s sin φ, -s² sin φ cos φ, s² sin² φ - 1)`; the plainer variant goes down the ruling of the pipe,
//! `v = -(0, sin φ, cos φ)`. The squares of chord and v are products of `l = 1 + σ s sin φ` and `m = 1 - σ s sin φ`, which cancels the
//! common factors of the rows of the arc: over a part of the turn both variants are rational of degree (4, 2),
//!
//! ```text
//! envelope:  [a0, 1],     √½ [m a0 + ρ v, m],              m [a1, 1]
//! vertical:  l [a0, 1],   √½ [a0 cos φ + ρ l v, cos φ],    [a1, 1]
//! ```
//!
//! Weights are positive, as the arcs turn by less than half a turn, and so are their Bernstein coefficients over each quarter from 0 on:
//! that of m in the middle is `cos δ - σ sin φ sin θ`, δ half the angle of the part and θ its middle. Both are tangent to pipe and plate along the contacts.

mod body;

pub use body::{NeckBody, PlateShape};

use super::ellipse_ring::{Ellipse, Sector, direction};
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Arc;
use crate::error::{ErrorItem, NumberError, PipeError, Result};
use crate::rational::{Polynomial, PolynomialRow, RationalBezierSurface};
use crate::warning::{BodyWarning, Warning};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, SQRT_2};

/// Largest angle between the axis of the pipe and the normal of the plate: beyond, the contact on the plate is more than 500 times as
/// long as it is wide.
const LARGEST_SLOPE: f64 = FRAC_PI_2 - 2e-3;

/// Arcs of a body are made even where the weight of an end is below this part of that of the other.
const UNEVEN: f64 = 1.0 / 16.0;

/// The side of the pipe on which the ball rolls.
///
/// ```
/// use cyclide::{Vec3, construct::{NeckBlend, NeckSide, NeckVariant}};
/// let reach = |side| NeckBlend::new(3.0, 0.8, 0.0, side, NeckVariant::Pipe).map(|neck| neck.contact_on_plate(0.0).to_vec().length());
/// assert!((reach(NeckSide::Outside)? - 3.8).abs() < 1e-12 && (reach(NeckSide::Inside)? - 2.2).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(description = "The side of a pipe on which a ball rolls.")
)]
pub enum NeckSide {
    /// The corner between a pipe and the plate.
    #[default]
    Outside,
    /// The corner between the inner wall of a pipe and its floor.
    Inside,
}

/// The arcs of a neck.
///
/// Each arc of the envelope is a part of a circle of the radius ρ of the ball.
///
/// ```
/// use cyclide::construct::{NeckBlend, NeckSide, NeckVariant};
/// let arc = |variant| NeckBlend::new(3.0, 0.8, 0.5, NeckSide::Outside, variant).and_then(|neck| neck.arc(0.3));
/// // Both touch pipe and plate in the same points, along other arcs.
/// assert!(arc(NeckVariant::Pipe)?.start().distance(arc(NeckVariant::Vertical)?.start()) < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize), serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(description = "The arcs of a neck."))]
#[non_exhaustive]
pub enum NeckVariant {
    /// The envelope of the ball: a pipe surface with the radius of the ball.
    #[default]
    Pipe,
    /// Arcs in planes parallel to the axis of the pipe; they leave the pipe tangent to its straight lines.
    Vertical,
}

/// The blend of a pipe with a plate.
///
/// ```
/// use cyclide::construct::{NeckBlend, NeckSide, NeckVariant};
/// let neck = NeckBlend::new(3.0, 0.8, 0.0, NeckSide::Outside, NeckVariant::Pipe)?;
/// let arc = neck.arc(0.0)?;
/// assert!((arc.radius().expect("it turns") - 0.8).abs() < 1e-12);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NeckBlend {
    pipe_radius: f64,
    ball_radius: f64,
    cos: f64,
    sin: f64,
    /// 1 outside the pipe, -1 inside.
    sign: f64,
    variant: NeckVariant,
}

impl NeckBlend {
    /// A neck of a pipe of radius `pipe_radius` that leans by `slope` radians from the normal of the plate z = 0 towards +y.
    ///
    /// # Errors
    /// `not-finite`; `radius-not-positive`; `ball-does-not-fit` (inside, a ball as large as the pipe); `angle-out-of-range`
    /// (a slope of a right angle, or 2e-3 less); `parameter-out-of-range` (radii beyond 1e150).
    pub fn new(pipe_radius: f64, ball_radius: f64, slope: f64, side: NeckSide, variant: NeckVariant) -> Result<Self> {
        for (what, radius) in [(ErrorItem::PipeRadius, pipe_radius), (ErrorItem::BallRadius, ball_radius)] {
            range::check_radius(what, 0, radius)?;
        }
        if side == NeckSide::Inside && ball_radius >= pipe_radius {
            return Err(PipeError::BallDoesNotFit { radius: ball_radius, limit: pipe_radius }.into());
        }
        if !(slope.abs() <= LARGEST_SLOPE) {
            return Err(NumberError::AngleOutOfRange {
                name: ErrorItem::Slope,
                angle: slope,
                min: -LARGEST_SLOPE,
                max: LARGEST_SLOPE,
            }
            .into());
        }
        let sign = if side == NeckSide::Outside { 1.0 } else { -1.0 };
        let (sin, cos) = slope.sin_cos();
        Ok(Self { pipe_radius, ball_radius, cos, sin, sign, variant })
    }

    /// Direction of the axis of the pipe, away from the plate.
    #[must_use]
    pub fn axis(&self) -> Vec3 {
        Vec3::new(0.0, self.sin, self.cos)
    }

    /// The center of the ball at an angle round the pipe; 0 is the direction x.
    #[must_use]
    pub fn center(&self, angle: f64) -> Point3 {
        self.centers().point(direction(angle))
    }

    /// Where the ball touches the pipe.
    #[must_use]
    pub fn contact_on_pipe(&self, angle: f64) -> Point3 {
        self.on_pipe().point(direction(angle))
    }

    /// Where the ball touches the plate.
    #[must_use]
    pub fn contact_on_plate(&self, angle: f64) -> Point3 {
        self.on_plate().point(direction(angle))
    }

    /// The arc of the neck at an angle, from pipe to plate, with the parameter that it has in the [surface](Self::surface).
    ///
    /// # Errors
    /// As [`Arc::from_start_tangent`], only beyond the range of the kernel's numbers.
    pub fn arc(&self, angle: f64) -> Result<Arc> {
        let place = direction(angle);
        let [a0, a1] = [self.on_pipe(), self.on_plate()].map(|ellipse| ellipse.point(place));
        Arc::from_start_tangent(a0, a1, self.leaving(place) * (SQRT_2 * self.ball_radius))
    }

    /// The neck between two angles, less than half a turn apart, exact: of degree (4, 2), s round the pipe, t from pipe to plate.
    /// Its weights are positive if neither π/2 nor -π/2, where the contact is highest and lowest, lies inside.
    ///
    /// # Errors
    /// `angle-out-of-range` unless `0 < to - from < π`.
    pub fn surface(&self, from: f64, to: f64) -> Result<RationalBezierSurface> {
        if !(to - from > 0.0 && to - from < std::f64::consts::PI) {
            return Err(NumberError::AngleOutOfRange {
                name: ErrorItem::Angle,
                angle: to - from,
                min: 0.0,
                max: std::f64::consts::PI,
            }
            .into());
        }
        self.over(&Sector::new(from, to))
    }

    /// What should be known of it (`neck-folds`): the envelope outside a pipe, with a large ball and a pipe that leans, runs through itself on the steep
    /// side. The centers of the ball run along an ellipse whose smallest radius of curvature is `q cos φ`; where the arc comes through the
    /// direction of its center of curvature, a larger ball folds the envelope. A solid of it is refused. The vertical variant never folds: seen along the
    /// axis of the pipe, its points at the part `l` of the way lie on the circle of radius `R + σ l ρ` about a center moved by `l ρ sin φ`, and
    /// such circles lie one in the other.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let folds =
            self.folds_beyond().map(|limit| Warning::Body(BodyWarning::NeckFolds { radius: self.ball_radius, limit }));
        folds.into_iter().collect()
    }

    /// The largest ball that does not fold the neck, if this one does.
    fn folds_beyond(&self) -> Option<f64> {
        let limit = (self.pipe_radius + self.ball_radius) * self.cos;
        (self.variant == NeckVariant::Pipe && self.sign > 0.0 && self.ball_radius > limit).then_some(limit)
    }

    /// The exact form over a sector.
    fn over(&self, sector: &Sector) -> Result<RationalBezierSurface> {
        RationalBezierSurface::from_polynomial_rows(&self.rows(sector))
    }

    /// The form that bodies have. Where the pipe leans so far that the arcs at its highest or lowest contact are very uneven, they are even at
    /// both ends of the sector: rows times 1, ϱ and ϱ², a change of the parameter t, ϱ linear between the roots of the ratio of their end weights; of degree (6, 2).
    /// Readers project the arc onto the face, and an uneven one ends beside its corner by more than they overlook.
    fn even_over(&self, sector: &Sector) -> Result<RationalBezierSurface> {
        if !self.is_uneven() {
            return self.over(sector);
        }
        let [first, middle, last] = self.rows(sector);
        let root = |end: [f64; 2]| self.unevenness(end).sqrt();
        let (ratio, one) = (Polynomial::new(vec![root(sector.start), root(sector.end)]), Polynomial::new(vec![1.0; 2]));
        let rows = [&first * &(&one * &one), &middle * &(&one * &ratio), &last * &(&ratio * &ratio)];
        RationalBezierSurface::from_polynomial_rows(&rows)
    }

    /// As [`arc`](Self::arc), with the parameter that it has in a body.
    fn even_arc(&self, angle: f64) -> Result<Arc> {
        let arc = self.arc(angle)?;
        Ok(if self.is_uneven() { arc.evened() } else { arc })
    }

    fn is_uneven(&self) -> bool {
        1.0 - self.sin.abs() < UNEVEN
    }

    /// The weight of the start of an arc as part of that of its end.
    fn unevenness(&self, [_, sin]: [f64; 2]) -> f64 {
        let across = self.sign * self.sin * sin;
        match self.variant {
            NeckVariant::Pipe => 1.0 / (1.0 - across),
            NeckVariant::Vertical => 1.0 + across,
        }
    }

    /// The rows at the module.
    fn rows(&self, sector: &Sector) -> [PolynomialRow; 3] {
        let Sector { cos, sin, one, .. } = sector;
        let [a0, a1] = [self.on_pipe(), self.on_plate()].map(|ellipse| ellipse.row(sector));
        let bent = |sign: f64| one + &(sin * (sign * self.sign * self.sin));
        match self.variant {
            NeckVariant::Pipe => {
                let m = bent(-1.0);
                let squared = sin * sin;
                let v = [
                    &(cos * sin) * -self.sin,
                    &squared * (-self.sin * self.cos),
                    &(&squared * (self.sin * self.sin)) + &(&(one * one) * -1.0),
                ];
                let middle = &(&a0 * &m) + &(&PolynomialRow::direction(v) * self.ball_radius);
                [&a0 * one, &middle * FRAC_1_SQRT_2, &a1 * &m]
            }
            NeckVariant::Vertical => {
                let l = bent(1.0);
                let down = self.axis() * -self.ball_radius;
                let v = [down.x, down.y, down.z].map(|d| &(one * &l) * d);
                let middle = &(&a0 * &(one * self.cos)) + &PolynomialRow::direction(v);
                [&a0 * &l, &middle * FRAC_1_SQRT_2, &a1 * one]
            }
        }
    }

    /// The direction in which the arc leaves the pipe, with the length that it has at the module.
    fn leaving(&self, [cos, sin]: [f64; 2]) -> Vec3 {
        match self.variant {
            NeckVariant::Pipe => {
                let across = self.sin * sin;
                Vec3::new(-across * cos, -across * sin * self.cos, across * across - 1.0)
            }
            NeckVariant::Vertical => -self.axis(),
        }
    }

    /// Distance of the ball's center from the axis.
    fn reach(&self) -> f64 {
        self.pipe_radius + self.sign * self.ball_radius
    }

    fn centers(&self) -> Ellipse {
        self.at_height(self.ball_radius, self.reach())
    }

    fn on_plate(&self) -> Ellipse {
        let centers = self.centers();
        Ellipse { center: Point3::new(0.0, centers.center.y, 0.0), ..centers }
    }

    fn on_pipe(&self) -> Ellipse {
        let (centers, back) = (self.centers(), self.sign * self.ball_radius);
        let v = centers.v - Vec3::new(0.0, self.cos, -self.sin) * back;
        Ellipse { u: Vec3::new(self.pipe_radius, 0.0, 0.0), v, ..centers }
    }

    /// Where a pipe of this radius about the axis meets the plane at this height.
    fn at_height(&self, z: f64, radius: f64) -> Ellipse {
        let center = Point3::new(0.0, z * self.sin / self.cos, z);
        Ellipse { center, u: Vec3::new(radius, 0.0, 0.0), v: Vec3::new(0.0, radius / self.cos, 0.0) }
    }

    /// The circle round the axis with this radius at this distance from the plate along the axis.
    fn round_axis(&self, height: f64, radius: f64) -> Ellipse {
        let across = Vec3::new(0.0, self.cos, -self.sin);
        Ellipse { center: Point3::ORIGIN + self.axis() * height, u: Vec3::new(radius, 0.0, 0.0), v: across * radius }
    }

    /// The greatest height along the axis that the contact with the pipe comes to.
    fn top(&self) -> f64 {
        (self.reach() * self.sin.abs() + self.ball_radius) / self.cos
    }
}
