//! A branch that stands inside the breadth of its main pipe, and the balls that touch both from outside
//! (`docs/math/pipe-tees.md#balls`).

use super::boost::Boost;
use super::{TeeBranch, TeeMain};
use crate::base::frame::Frame;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::pierced::Mantle;
use crate::error::{Error, ErrorItem, NumberError, PipeError, Result, TeeError};
use crate::rational::{Polynomial, PolynomialRow};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

/// Smallest sine of the angle between a line of a branch and its main pipe.
const SMALLEST_SINE: f64 = 0.05;
/// The part of what there is room for that a branch leaves at least: with less, digits are lost that the faces need.
const LEAST_ROOM: f64 = 1e-4;

/// Two pipes in their place: the main pipe about the x axis, and the branch, thinner than it, its axis passing that of the main pipe nearer than their radii differ;
/// cylinders or cones.
#[derive(Debug, Clone, Copy)]
pub(in crate::construct::bodies) struct Crossing {
    /// Which branch, from 0, for what is refused of it.
    pub(in crate::construct::bodies) branch: usize,
    /// Radii of branch and main pipe at their feet; negative where balls touch from inside.
    pub(in crate::construct::bodies) radii: [f64; 2],
    /// The angle by which the branch grows thinner.
    pub(in crate::construct::bodies) taper: f64,
    /// The radius of the main pipe where x is zero, and the angle by which it grows thinner along x.
    pub(in crate::construct::bodies) main: [f64; 2],
    /// Whether both are of one radius and their axes meet: the balls are on two ellipses (`docs/math/pipe-tees.md#equal-pipes`).
    pub(in crate::construct::bodies) equal: bool,
    /// Of the contacts round branch and main pipe.
    pub(in crate::construct::bodies) boosts: [Boost; 2],
    /// What balls at infinity are told by: the weight of a ball is `(A q - B c²)(C q - D s²)/unit`.
    pub(in crate::construct::bodies) infinite: [[f64; 2]; 2],
    pub(in crate::construct::bodies) unit: f64,
    /// Sine and cosine of the angle between the axes.
    pub(in crate::construct::bodies) sin: f64,
    pub(in crate::construct::bodies) cos: f64,
    /// The foot on the axis of the main pipe, as its place along it.
    pub(in crate::construct::bodies) at: f64,
    /// The foot on the axis of the branch.
    pub(in crate::construct::bodies) foot: Point3,
    /// Across the main pipe: sideways and towards the branch.
    pub(in crate::construct::bodies) sideways: Vec3,
    pub(in crate::construct::bodies) up: Vec3,
    /// Across the branch, the first nearest to the direction of the main pipe; its own direction last.
    pub(in crate::construct::bodies) axes: [Vec3; 3],
}

/// What the tapers of branch and main pipe, the first two, add to the form that both have in common, in parts of the offset: `p`, across the branch, and
/// less the same up from the main pipe (`docs/math/pipe-tees.md#tapered-branches`).
fn leans(branch: &TeeBranch, main_taper: f64) -> [f64; 2] {
    let ((sin, cos), own, main) = (branch.angle.sin_cos(), branch.taper.sin(), main_taper.sin());
    [(main - own * cos) / sin, (main * cos - own) / sin]
}

/// The boosts of branch and main pipe, of this radius at the foot, from the form that both have in common.
fn boosts(index: usize, [main, main_taper]: [f64; 2], branch: &TeeBranch) -> Result<[Boost; 2]> {
    let (own_cos, main_cos, offset) = (branch.taper.cos(), main_taper.cos(), branch.offset);
    let room = main * main_cos - branch.radius * own_cos;
    let leans = leans(branch, main_taper);
    let across = leans.map(|lean| room.hypot(offset * lean));
    let taus = [-offset * own_cos / across[0], -offset * main_cos / across[1]];
    // On the edge of it the loop is degenerate: it comes to a point.
    if !(room > LEAST_ROOM * main * own_cos && taus.iter().all(|tau| tau.abs() < 1.0 - LEAST_ROOM)) {
        let beside = ((own_cos - leans[0]) * (own_cos + leans[0])).max(0.0).sqrt() / own_cos;
        let reach = branch.radius + offset.abs() * beside;
        let limit = main * main_cos / own_cos;
        return Err(TeeError::BranchTooWide { branch: index, reach, limit, rest: LEAST_ROOM * limit, offset }.into());
    }
    Ok([
        Boost::new(taus[0], [room / across[0], -offset * leans[0] / across[0]]),
        Boost::new(taus[1], [room / across[1], offset * leans[1] / across[1]]),
    ])
}

/// What balls at infinity are told by. Of `A`, `B`, `C`, `D` the products are given, and `AB/CD`, the square of the tangent of half the angle between both axes as lines
/// of balls.
fn infinite_balls(branch: &TeeBranch, main_taper: f64, boosts: &[Boost; 2]) -> [[f64; 2]; 2] {
    let (own_cos, main_cos) = (branch.taper.cos(), main_taper.cos());
    let [first, second] = boosts.each_ref().map(Boost::turn_cos);
    let (whole, leans) = (first / boosts[0].root, leans(branch, main_taper));
    let ac = 0.5 * second * (main_cos * whole + leans[1]);
    let [ad, bc] = [1.0, -1.0].map(|sign| 0.5 * first * (own_cos * whole + sign * leans[0]));
    let half = |own: f64, main: f64| 0.5 * (branch.angle + own * branch.taper + main * main_taper);
    let tangents = half(-1.0, 1.0).sin() * half(1.0, -1.0).sin() / (half(1.0, 1.0).cos() * half(-1.0, -1.0).cos());
    let scale = (ad / (ac * ac * bc) * tangents).sqrt().sqrt();
    [[scale * ac, scale * bc], [1.0 / scale, ad / (ac * scale)]]
}

/// The quadratic of the factor k of a loop that vanishes where it has a ball of a given radius, at a boosted angle.
#[derive(Debug, Clone, Copy)]
struct FactorForm {
    /// Of the weight and of what the radius and that of the branch come from, without the radius: `a₂k² + a₁k + a₀`.
    weight: [f64; 3],
    reach: [f64; 3],
    /// Their derivatives by the angle.
    weight_by_angle: [f64; 3],
    reach_by_angle: [f64; 3],
}

impl Crossing {
    /// A branch in the axes of a main pipe of this radius, with walls of this thickness.
    ///
    /// # Errors
    /// `angle-out-of-range` (a line of the branch along the main pipe), `radius-not-positive` (a branch that comes to an end before its own),
    /// `tee-branch-too-wide`, `tee-pipe-too-short` (it comes to an end inside the main pipe).
    pub(in crate::construct::bodies) fn new(
        index: usize,
        pipe: &TeeMain,
        branch: &TeeBranch,
        wall: f64,
    ) -> Result<Self> {
        let (sin, cos) = branch.angle.sin_cos();
        let taper_cos = branch.taper.cos();
        let main = if pipe.taper == 0.0 { pipe.radius } else { pipe.radius - branch.at * pipe.taper.tan() };
        let least = SMALLEST_SINE.asin() + branch.taper.abs() + pipe.taper.abs();
        if least > FRAC_PI_2 {
            // No angle is far enough from both directions of the main pipe.
            let max = FRAC_PI_2 - SMALLEST_SINE.asin() - pipe.taper.abs();
            let error = Error::Number(NumberError::ParameterOutOfRange {
                name: ErrorItem::Taper,
                value: branch.taper,
                min: -max,
                max,
            });
            return Err(error.in_branch(index, ErrorItem::Taper));
        }
        if !(branch.angle >= least && branch.angle <= PI - least) {
            let error = Error::Number(NumberError::AngleOutOfRange {
                name: ErrorItem::Angle,
                angle: branch.angle,
                min: least,
                max: PI - least,
            });
            return Err(error.in_branch(index, ErrorItem::Angle));
        }
        let end = branch.radius - branch.length * branch.taper.tan() - wall / taper_cos;
        if !(end > 0.0) && branch.taper > 0.0 && wall < branch.radius * taper_cos {
            let apex = (branch.radius - wall / taper_cos) / branch.taper.tan();
            return Err(Error::from(PipeError::ConeReachesApex { pipe: 0, apex, reached: branch.length })
                .in_branch(index, ErrorItem::Taper));
        }
        if !(end > 0.0) {
            return Err(Error::from(NumberError::RadiusNotPositive { what: ErrorItem::Radius, index: 0, radius: end })
                .in_branch(index, ErrorItem::Taper));
        }
        #[expect(
            clippy::float_cmp,
            reason = "pipes of one radius are of the same double: nearly equal ones have no loop of this kind"
        )]
        let equal = branch.radius == main && branch.offset == 0.0 && branch.taper == 0.0 && pipe.taper == 0.0;
        let boosts = if equal { [Boost::new(0.0, [1.0, 0.0]); 2] } else { boosts(index, [main, pipe.taper], branch)? };
        let (turn_sin, turn_cos) = branch.azimuth.sin_cos();
        let up = Vec3::new(0.0, -turn_sin, turn_cos);
        let sideways = Vec3::new(0.0, turn_cos, turn_sin);
        let along = Vec3::X;
        let crossing = Self {
            branch: index,
            radii: [branch.radius, main],
            taper: branch.taper,
            main: [pipe.radius, pipe.taper],
            equal,
            boosts,
            infinite: if equal { [[1.0; 2]; 2] } else { infinite_balls(branch, pipe.taper, &boosts) },
            unit: if equal { main } else { main * pipe.taper.cos() - branch.radius * taper_cos },
            sin,
            cos,
            at: branch.at,
            foot: Point3::new(branch.at, 0.0, 0.0) + sideways * branch.offset,
            sideways,
            up,
            axes: [along * sin - up * cos, sideways, along * cos + up * sin],
        };
        if equal || crossing.has_balls() {
            return Ok(crossing);
        }
        Err(TeeError::PipeTooShort { what: ErrorItem::Branch, branch: index, end: branch.length, needed: main / sin }
            .into())
    }

    /// A row in the axes of the branch, from its foot.
    pub(in crate::construct::bodies) fn placed(&self, [x, y, z]: [Polynomial; 3], weight: Polynomial) -> PolynomialRow {
        let (foot, [ex, ey, ez]) = (self.foot.to_vec(), self.axes);
        let along =
            |ex: f64, ey: f64, ez: f64, foot: f64| &(&(&x * ex) + &(&y * ey)) + &(&(&z * ez) + &(&weight * foot));
        let rows = [along(ex.x, ey.x, ez.x, foot.x), along(ex.y, ey.y, ez.y, foot.y), along(ex.z, ey.z, ez.z, foot.z)];
        let [x, y, z] = rows;
        PolynomialRow([x, y, z, weight])
    }

    /// The rotation from the axes of space to those of the branch.
    pub(in crate::construct::bodies) fn turn(&self) -> Quat {
        Frame::of_axes(self.foot, self.axes).rotation()
    }

    /// A skin of the main pipe.
    pub(in crate::construct::bodies) fn main_pipe(&self, depth: f64) -> Mantle {
        let [radius, taper] = self.main;
        let outer =
            Mantle { radius, taper, origin: Point3::ORIGIN, along: Vec3::X, sideways: self.sideways, up: self.up };
        outer.below(depth)
    }

    /// The boosted angle of a contact round the branch at the true angle.
    pub(in crate::construct::bodies) fn boosted_angle(&self, angle: f64) -> f64 {
        self.boosts[0].boosted_angle(angle)
    }

    /// The true angle of a boosted one round the branch, in `[0, 2π)`.
    pub(in crate::construct::bodies) fn true_angle(&self, boosted: f64) -> f64 {
        self.boosts[0].true_angle(boosted).rem_euclid(TAU) % TAU
    }

    /// Pipes, branch and main, that pass each other at a distance below the sum of their radii, of which that one has a negative radius that balls are inside.
    pub(in crate::construct::bodies) fn passing(radii: [f64; 2], distance: f64, angle: f64) -> Self {
        let delta = radii[1] - radii[0];
        let boosts = [Boost::new(-distance / delta.abs(), [delta.signum(), 0.0]); 2];
        let branch = TeeBranch { angle, ..TeeBranch::upright(radii[0], 0.0, 0.0) };
        let (sin, cos) = angle.sin_cos();
        let (along, sideways, up) = (Vec3::X, Vec3::Z, -Vec3::Y);
        Self {
            branch: 0,
            radii,
            taper: 0.0,
            main: [radii[1], 0.0],
            equal: false,
            boosts,
            infinite: infinite_balls(&branch, 0.0, &boosts),
            unit: delta,
            sin,
            cos,
            at: 0.0,
            foot: Point3::ORIGIN + sideways * distance,
            sideways,
            up,
            axes: [along * sin - up * cos, sideways, along * cos + up * sin],
        }
    }

    /// The sum of the forms of five coordinates from which the radius of a ball and that of the branch come, `R + r cos w`: `cos w L + sin w h`, of
    /// `(m₁, y, n₁, m₂, n₂)`.
    fn reach_form(&self) -> [f64; 5] {
        let (sin, cos) = self.taper.sin_cos();
        let [[x, _, l], [up, ..]] = [self.boosts[0].rows(), self.boosts[1].rows()];
        let lean = sin / self.sin;
        [
            lean * self.cos * x[0],
            cos * l[1] + lean * (self.cos * x[1] + up[1]),
            cos * l[2] + lean * self.cos * x[2],
            lean * up[0],
            lean * up[2],
        ]
    }

    fn factor_form(&self, boosted: f64) -> FactorForm {
        let (sin, cos) = boosted.sin_cos();
        let (ss, cc, sc) = (0.5 * (1.0 - cos), 0.5 * (1.0 + cos), 0.5 * sin);
        let (square, by_square) = (sc * sc, 0.5 * sin * cos);
        let [[a, b], [c, d]] = self.infinite;
        let [m1, y, n1, m2, n2] = self.reach_form();
        FactorForm {
            weight: [b * d * square / self.unit, -(a * d * ss + b * c * cc) / self.unit, a * c / self.unit],
            reach: [0.5 * (n2 - m2) * square, 0.5 * (n1 + m1 * cos + y * sin), 0.5 * (n2 + m2)],
            weight_by_angle: [b * d * by_square / self.unit, -0.5 * sin * (a * d - b * c) / self.unit, 0.0],
            reach_by_angle: [0.5 * (n2 - m2) * by_square, 0.5 * (y * cos - m1 * sin), 0.0],
        }
    }

    /// The radius of the branch times the cosine of its taper: what balls reach beyond their own radius.
    pub(super) fn reach_of_branch(&self) -> f64 {
        self.radii[0] * self.taper.cos()
    }

    /// Whether there is a loop at all: the apex of a branch that grows thinner is outside the main pipe.
    pub(in crate::construct::bodies) fn has_balls(&self) -> bool {
        let form = self.factor_form(FRAC_PI_4);
        self.reach_of_branch() * form.weight[2] > form.reach[2]
    }

    /// The factor k of the loop at a boosted angle for a ball of this radius, with its derivative.
    pub(in crate::construct::bodies) fn factor_of_radius(
        &self,
        boosted: f64,
        radius: f64,
        derivative: f64,
    ) -> [f64; 2] {
        let form = self.factor_form(boosted);
        let reach = radius + self.reach_of_branch();
        let [a0, a1, a2] = std::array::from_fn(|k| reach * form.weight[k] - form.reach[k]);
        // The root of larger size: of balls inside one pipe only both are negative.
        let root = -(a1 * a1 - 4.0 * a2 * a0).sqrt().copysign(a1);
        let factor = (root - a1) / (2.0 * a2);
        let by_angle =
            |k: usize| derivative * form.weight[k] + reach * form.weight_by_angle[k] - form.reach_by_angle[k];
        [factor, -(by_angle(0) + factor * (by_angle(1) + factor * by_angle(2))) / root]
    }

    /// The radius of the ball at a boosted angle of a loop with this factor.
    pub(in crate::construct::bodies) fn radius_of_factor(&self, boosted: f64, factor: f64) -> f64 {
        let (sin, cos) = (0.5 * boosted).sin_cos();
        let [[a, b], [c, d]] = self.infinite;
        // As a product, without the difference of nearly equal numbers.
        let weight = (a * factor - b * cos * cos) * (c * factor - d * sin * sin) / self.unit;
        let [r0, r1, r2] = self.factor_form(boosted).reach;
        (r0 + factor * (r1 + factor * r2)) / weight - self.reach_of_branch()
    }

    /// The factor above which all balls of a loop are finite.
    pub(in crate::construct::bodies) fn least_factor(&self) -> f64 {
        let [[a, b], [c, d]] = self.infinite;
        (b / a).max(d / c)
    }

    /// The radius of the branch at a height, of a skin below the outer one by a depth.
    pub(in crate::construct::bodies) fn branch_radius(&self, depth: f64, height: f64) -> f64 {
        if self.taper == 0.0 {
            return self.radii[0] - depth;
        }
        self.radii[0] - depth / self.taper.cos() - height * self.taper.tan()
    }

    /// The point of a skin of the branch at a half angle of length 1 and a place along it.
    pub(in crate::construct::bodies) fn branch_point(&self, depth: f64, [c, s]: [f64; 2], height: f64) -> Point3 {
        let ([x, y, z], radius) = (self.axes, self.branch_radius(depth, height));
        self.foot + x * (radius * (c - s) * (c + s)) + y * (radius * 2.0 * c * s) + z * height
    }

    /// Half the angle by which the main pipe leans from a right angle to the branch.
    pub(in crate::construct::bodies) fn half_lean(&self) -> f64 {
        0.5 * (-self.cos).atan2(self.sin)
    }
}
