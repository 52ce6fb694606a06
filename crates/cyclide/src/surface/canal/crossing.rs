//! A cylinder that a thinner one enters at a right angle, and pieces of canal surfaces of balls outside both
//! (`docs/math/canal-blends.md#a-branch-that-enters-a-pipe`).
//!
//! The main cylinder has the radius `r1` and runs along x through `(0, 0, -h)`, the branch `r2` along y through `(0, 0, h)`; `D = r1 - r2 > 2|h|`. A ball
//! touches the branch at the angle `f` about its axis, from z towards x. With `l = r2 + R`
//! ```text
//! center = (l sin f, y, h + l cos f),   y² = (l + D)² - (2h + l cos f)²
//! ```
//! is a conic in `(l, y)` for each `f`, with a point at infinity in the direction `(1, g sin f)`, `g = ±1`. So `y = g l sin f + T` gives
//! ```text
//! l = (T² - D² + 4h²)/(2 (D - 2h cos f - g T sin f))
//! ```
//! and every polynomial `T` a rational family of balls. `g = -1` serves the angles from 0 to pi, `g = 1` those from -pi to 0.

use super::{CanalPatch, RollingBall};
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, ErrorItem, Result};
use crate::rational::{Polynomial, PolynomialRow, QuatPolynomial};

/// A cylinder and a thinner one that enters it at a right angle: the main one along x through `(0, 0, -h)`, the branch along y through
/// `(0, 0, h)`, so far inside that it does not come out at the side.
///
/// ```
/// use cyclide::CrossingCylinders;
/// let pair = CrossingCylinders::new([2.0, 1.0], 0.25)?; // axes 0.5 apart
/// let ball = pair.ball(0.3, 0.4)?;
/// assert!((ball.center.y.hypot(ball.center.z + 0.25) - 2.4).abs() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrossingCylinders {
    radii: [f64; 2],
    half_gap: f64,
}

/// A rational piece of the balls between two crossing cylinders, and what they touch.
#[derive(Debug, Clone)]
pub(crate) struct CrossingPiece {
    /// The canal patch from the main cylinder to the branch.
    pub(crate) patch: CanalPatch,
    /// `(W x, W y)`, `W` of the centres: where contacts are along the axes.
    pub(crate) along: [Polynomial; 2],
    /// `W`, positive inside.
    pub(crate) weight: Polynomial,
    /// Half-angle vectors `[cos, sin]` of the contacts about the axes, from z, up to a factor: towards y on the main cylinder, towards x on the branch.
    pub(crate) half_angles: [[Polynomial; 2]; 2],
}

impl CrossingCylinders {
    /// From the radii of the main cylinder and the branch, and half the distance of their axes, which may be negative or zero.
    ///
    /// # Errors
    /// `not-finite`, `radius-not-positive`, `parameter-out-of-range` (beyond 1e-150 to 1e150), `branch-too-wide` (unless `2|h| + r2 < r1`).
    pub fn new(radii: [f64; 2], half_gap: f64) -> Result<Self> {
        for (index, radius) in radii.into_iter().enumerate() {
            if !radius.is_finite() {
                return Err(Error::NotFinite { what: ErrorItem::Radius, index });
            }
            if radius <= 0.0 {
                return Err(Error::RadiusNotPositive { radius });
            }
            range::check_distance(radius)?;
        }
        if !half_gap.is_finite() {
            return Err(Error::NotFinite { what: ErrorItem::Distance, index: 0 });
        }
        let [main, branch] = radii;
        let (reach, limit) = (branch + 2.0 * half_gap.abs(), main * (1.0 - NARROWEST_SIDE));
        if !(reach <= limit) {
            return Err(Error::BranchTooWide { reach, limit });
        }
        Ok(Self { radii, half_gap })
    }

    /// The radii.
    #[must_use]
    pub fn radii(&self) -> [f64; 2] {
        self.radii
    }

    /// Half the distance of the axes, from the main one to the branch along z.
    #[must_use]
    pub fn half_gap(&self) -> f64 {
        self.half_gap
    }

    /// The ball of a radius that touches the branch at an angle about its axis, from z towards x, where the branch leaves the main cylinder
    /// along y.
    ///
    /// # Errors
    /// `not-finite`, `no-positive-radius`.
    pub fn ball(&self, angle: f64, radius: f64) -> Result<RollingBall> {
        if !angle.is_finite() {
            return Err(Error::NotFinite { what: ErrorItem::Angle, index: 0 });
        }
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(Error::NoPositiveRadius { radius });
        }
        let ([r1, r2], h, (sin, cos)) = (self.radii, self.half_gap, angle.sin_cos());
        let [l, y] = [r2 + radius, self.height([radius, 0.0], angle)[0]];
        let center = Point3::new(l * sin, y, h + l * cos);
        let normals = [Vec3::new(0.0, y, center.z + h) / (r1 + radius), Vec3::new(sin, 0.0, cos)];
        Ok(RollingBall { center, radius, contacts: normals.map(|n| center - n * radius), normals })
    }

    /// `y` of the centre and its derivative by the angle, from the radius and its derivative.
    fn height(&self, [radius, growth]: [f64; 2], angle: f64) -> [f64; 2] {
        let ([r1, r2], gap, (sin, cos)) = (self.radii, 2.0 * self.half_gap, angle.sin_cos());
        let (from_main, l) = (r1 + radius, r2 + radius);
        let z = gap + l * cos;
        let y = ((from_main - z) * (from_main + z)).sqrt();
        [y, (from_main * growth - z * (growth * cos - l * sin)) / y]
    }

    /// `T` and its derivative by the angle.
    fn chart(&self, law: [f64; 2], angle: f64, side: f64) -> [f64; 2] {
        let ([y, slope], (sin, cos)) = (self.height(law, angle), angle.sin_cos());
        let l = self.radii[1] + law[0];
        [y - side * l * sin, slope - side * (law[1] * sin + l * cos)]
    }

    /// The two pieces between two angles less than half a turn apart, both between 0 and pi or both between -pi and 0: G1 to all others whose balls and
    /// derivatives by the angle agree, `[R, R']` at both ends.
    pub(crate) fn pieces(&self, angles: [f64; 2], laws: [[f64; 2]; 2]) -> [CrossingPiece; 2] {
        let side = if angles[0] + angles[1] > 0.0 { -1.0 } else { 1.0 };
        let middle = 0.5 * (angles[0] + angles[1]);
        let [start, end] = [0, 1].map(|k| self.chart(laws[k], angles[k], side));
        // The half-angle vector runs on a chord: angles start and end with this derivative.
        let speed = 2.0 * (0.25 * (angles[1] - angles[0])).sin();
        let (first, second) = (start[0] + 0.5 * speed * start[1], end[0] - 0.5 * speed * end[1]);
        let joint = 0.5 * (first + second);
        [
            self.piece([angles[0], middle], side, [start[0], first, joint]),
            self.piece([middle, angles[1]], side, [joint, second, end[0]]),
        ]
    }

    /// The piece between two angles with the Bernstein coefficients of `T`.
    fn piece(&self, angles: [f64; 2], side: f64, chart: [f64; 3]) -> CrossingPiece {
        let ([r1, r2], h) = (self.radii, self.half_gap);
        let (d, gap) = (r1 - r2, 2.0 * h);
        let [(s0, c0), (s1, c1)] = angles.map(|angle| (0.5 * angle).sin_cos());
        let (c, e) = (Polynomial::new(vec![c0, c1]), Polynomial::new(vec![s0, s1]));
        let (mirrored, t) = (&e * side, Polynomial::new(chart.to_vec()));
        let (cc, ee, ce) = (&c * &c, &e * &e, &c * &mirrored);
        let one = &cc + &ee;
        // T² - D² + 4h²: nothing cancels, as T is larger than the root of the others by the radius.
        let square = &(&t * &t) + &Polynomial::constant((gap - d) * (gap + d));
        let weight = &(&(&cc * (d - gap)) + &(&ee * (d + gap))) - &(&(&ce * &t) * 2.0);
        let across = &square * 0.5;
        let center = PolynomialRow([
            &(&c * &e) * &square,
            &(&ce * &square) + &(&t * &weight),
            &(&across * &(&cc - &ee)) + &(&weight * h),
            weight.clone(),
        ]);
        let radius = &(&across * &one) - &(&weight * r2);
        // The half-angle vector (a, b) of the contact with the main cylinder.
        let a = &(&c * &t) - &(&mirrored * (d + gap));
        let b = &(&c * (d - gap)) - &(&mirrored * &t);
        let half_angles = [[a, b], [c, e]];
        let turns = self.turns(&half_angles, &t, &square, [side, c0 * s1 - s0 * c1]);
        let mut patch = CanalPatch { center, radius, turns };
        patch.take_minor_arc();
        patch.even_ends();
        let along = [patch.center.0[0].clone(), patch.center.0[1].clone()];
        CrossingPiece { patch, along, weight, half_angles }
    }

    /// The quaternions of both contacts: `q1 = a - b i` and `q2 kappa`, `q2 = c + e j`, with `w = c e' - e c'`, `S = T² - D² + 4h²`:
    /// `kappa = -(S w + T' a e) - (T' b c + g S w) k`.
    fn turns(
        &self,
        [[a, b], [c, e]]: &[[Polynomial; 2]; 2],
        t: &Polynomial,
        square: &Polynomial,
        [side, wronskian]: [f64; 2],
    ) -> [QuatPolynomial; 2] {
        let zero = || Polynomial::constant(0.0);
        let (rate, turned) = (t.derivative(), square * wronskian);
        let real = &turned + &(&rate * &(a * e));
        let third = &(&rate * &(b * c)) + &(&turned * side);
        let kappa = QuatPolynomial([&real * -1.0, zero(), zero(), &third * -1.0]);
        let q1 = QuatPolynomial([a.clone(), b * -1.0, zero(), zero()]);
        let q2 = QuatPolynomial([c.clone(), zero(), e.clone(), zero()]);
        [q1, &q2 * &kappa]
    }
}

impl CrossingPiece {
    /// The angle about the branch from the start of the piece.
    pub(crate) fn turned(&self, s: f64) -> f64 {
        let [c, e] = &self.half_angles[1];
        let [[c0, e0], [c1, e1]] = [0.0, s].map(|s| [c.value(s), e.value(s)]);
        2.0 * (c0 * e1 - e0 * c1).atan2(c0 * c1 + e0 * e1)
    }
}

/// The part of the main cylinder that the branch must leave at its side: nearer to the edge the contact curves fold together.
const NARROWEST_SIDE: f64 = 1e-6;
