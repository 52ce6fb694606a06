//! A piece of a loop of contacts round a tube, with all that is made from it exactly: the canal of its balls, both curves of contact, what is left
//! of the sphere (`docs/math/contact-blends.md#pieces`).

use super::setup::{Base, Setup};
use crate::base::quat::Quat;
use crate::base::vector::Vec3;
use crate::rational::{Polynomial, PolynomialRow, QuatPolynomial, RationalBezier};
use crate::surface::CanalPatch;

/// Contact heights over a piece.
#[derive(Debug, Clone)]
pub(super) enum Heights {
    /// One height.
    Level(f64),
    /// `z/W` with the weight W of the half directions, a combination of 1, cosine and sine of the angle: balls on a sphere `[e, r]`.
    Turning { z: Polynomial, sphere: [f64; 2] },
    /// Quadratics `z/d`: balls of one radius on a plane.
    Quotient { z: Polynomial, d: Polynomial, normal: [f64; 2] },
}

/// Between two angles, less than half a turn apart.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    pub(super) ends: [f64; 2],
    heights: Heights,
    /// The turn of the tube's first axis to the angle, linear: `cos + sin k`, of length 1 at both ends.
    half: QuatPolynomial,
    weight: Polynomial,
    /// Cosine and sine of the angle times the weight.
    across: [Polynomial; 2],
    /// The canal of the outer skin, with even arcs at both ends.
    pub(super) canal: CanalPatch,
    /// A turn of the third axis to the second normals.
    second: QuatPolynomial,
}

impl Piece {
    pub(super) fn new(setup: &Setup, ends: [f64; 2], heights: Heights) -> Self {
        let [(s0, c0), (s1, c1)] = ends.map(|angle| (0.5 * angle).sin_cos());
        let (c, s) = (Polynomial::new(vec![c0, c1]), Polynomial::new(vec![s0, s1]));
        let zero = || Polynomial::constant(0.0);
        let half = QuatPolynomial([c.clone(), zero(), zero(), s.clone()]);
        let weight = Polynomial::new(vec![1.0, (0.5 * (ends[1] - ends[0])).cos(), 1.0]);
        let across = [&(&c * &c) - &(&s * &s), &(&c * &s) * 2.0];
        let family = Family {
            setup,
            weight: &weight,
            across: &across,
            half: &half,
            rate: 2.0 * (0.5 * (ends[1] - ends[0])).sin(),
        };
        let (canal, second) = family.canal(&heights);
        Self { ends, heights, half, weight, across, canal, second }
    }

    /// The contact with the tube at a depth.
    pub(super) fn on_tube(&self, setup: &Setup, depth: f64) -> RationalBezier {
        let (rho, rise, w) = (setup.rho - depth * setup.cos, depth * setup.sin, &self.weight);
        let round = |radius: &Polynomial, z: Polynomial, w: Polynomial| {
            let [x, y] = self.across.each_ref().map(|p| p * radius);
            setup.placed([x, y, z, w])
        };
        let constant = Polynomial::constant;
        let row = match &self.heights {
            Heights::Level(z) => round(&constant(rho + setup.tan * z), w * (z + rise), w.clone()),
            Heights::Turning { z, .. } if setup.tan == 0.0 => round(&constant(rho), z + &(w * rise), w.clone()),
            Heights::Turning { z, .. } => round(&(&(w * rho) + &(z * setup.tan)), &(z + &(w * rise)) * w, w * w),
            Heights::Quotient { z, d, .. } => round(&(&(d * rho) + &(z * setup.tan)), &(z + &(d * rise)) * w, d * w),
        };
        RationalBezier::from_polynomial_row(&row)
    }

    /// The contact with the plane or the sphere at a depth.
    pub(super) fn on_base(&self, setup: &Setup, depth: f64) -> RationalBezier {
        let row = match setup.base {
            Base::Plane([n0, n1]) => {
                let normal = setup.frame.x() * n0 + setup.frame.z() * n1;
                let down = setup.ball + setup.sigma * depth;
                let PolynomialRow([x, y, z, w]) = self.canal.center();
                let moved = |entry: &Polynomial, n: f64| entry - &(w * (n * down));
                PolynomialRow([moved(x, normal.x), moved(y, normal.y), moved(z, normal.z), w.clone()])
            }
            Base::Sphere { e, r } => {
                let (center, radius) = (setup.point([e, 0.0, 0.0]), setup.sphere_at(r, depth));
                let norm = self.second.dot(&self.second);
                let k = QuatPolynomial::constant(Quat::new(0.0, 0.0, 0.0, 1.0));
                let QuatPolynomial([_, x, y, z]) = &(&self.second * &k) * &self.second.conj();
                let entry = |c: f64, n: &Polynomial| &(&norm * c) + &(n * radius);
                PolynomialRow([entry(center.x, &x), entry(center.y, &y), entry(center.z, &z), norm.clone()])
            }
        };
        RationalBezier::from_polynomial_row(&row)
    }

    /// The sphere at a depth from the contact along great circles to a pole, given by the turn of the third axis to the normal there, with even arcs at both ends.
    pub(super) fn to_pole(&self, setup: &Setup, [e, r]: [f64; 2], depth: f64, pole: Quat) -> CanalPatch {
        let center = setup.point([e, 0.0, 0.0]).to_vec();
        let row = [center.x, center.y, center.z, 1.0].map(Polynomial::constant);
        let radius = Polynomial::constant(-setup.sphere_at(r, depth));
        let QuatPolynomial([w, _, _, z]) = &QuatPolynomial::constant(pole.conj()) * &self.second;
        let zero = || Polynomial::constant(0.0);
        let last = &QuatPolynomial::constant(pole) * &QuatPolynomial([w, zero(), zero(), z]);
        CanalPatch::from_turns(PolynomialRow(row), radius, [self.second.clone(), last]).with_even_ends()
    }

    /// The second normal.
    pub(super) fn second_normal(&self, s: f64) -> Vec3 {
        let turn = self.second.value(s);
        (turn * (1.0 / turn.norm())).rotate(Vec3::Z)
    }

    /// The height of the contact at a depth, above the origin.
    pub(super) fn height_at(&self, setup: &Setup, depth: f64, s: f64) -> f64 {
        let height = match &self.heights {
            Heights::Level(z) => *z,
            Heights::Turning { z, .. } => z.value(s) / self.weight.value(s),
            Heights::Quotient { z, d, .. } => z.value(s) / d.value(s),
        };
        height + depth * setup.sin
    }

    /// The angle round the tube.
    pub(super) fn angle_at(&self, s: f64) -> f64 {
        let [c, _, _, sin] = self.half.value(s).to_array();
        let start = self.ends[0];
        // Continuous from the start on.
        let (s0, c0) = (0.5 * start).sin_cos();
        start + 2.0 * (sin * c0 - c * s0).atan2(c * c0 + sin * s0)
    }
}

/// What the canal of a piece is made from.
struct Family<'a> {
    setup: &'a Setup,
    weight: &'a Polynomial,
    across: &'a [Polynomial; 2],
    half: &'a QuatPolynomial,
    /// The derivative of the angle times the weight.
    rate: f64,
}

impl Family<'_> {
    fn canal(&self, heights: &Heights) -> (CanalPatch, QuatPolynomial) {
        let axes = QuatPolynomial::constant(self.setup.frame.rotation());
        let contact = QuatPolynomial::constant(self.setup.contact_turn());
        let turn = &(&axes * self.half) * &contact;
        let (balls, second) = match heights {
            Heights::Level(z) => (self.level(*z), self.level_second(*z, &axes, &turn)),
            Heights::Quotient { z, d, normal } => (self.on_plane([z, d], *normal), self.to_plane(&turn, *normal)),
            Heights::Turning { z, sphere: [e, r] } => {
                let (balls, second) = self.on_sphere(z, [*e, *r]);
                (balls, &axes * &second)
            }
        };
        let canal = CanalPatch::from_contact_frames(balls.center, balls.radius, &turn, balls.motion, second.clone());
        (canal.with_even_ends(), second)
    }

    /// The row of centers at a distance from the axis and a height, both over a weight; the distance lacks the weight of the turn.
    fn row(&self, from_axis: &Polynomial, height: Polynomial, weight: Polynomial) -> PolynomialRow {
        let [x, y] = self.across.each_ref().map(|p| p * from_axis);
        self.setup.placed([x, y, height, weight])
    }

    fn level(&self, z: f64) -> Balls {
        let (setup, w) = (self.setup, self.weight);
        let from_axis = setup.center_at_origin() + setup.tan * z;
        let height = z - setup.ball * setup.sigma * setup.sin;
        Balls {
            center: self.row(&Polynomial::constant(from_axis), w * height, w.clone()),
            radius: w * setup.ball,
            motion: [Polynomial::constant(0.0), Polynomial::constant(-setup.sigma)],
        }
    }

    /// The turn to the second normals of balls at one height.
    fn level_second(&self, z: f64, axes: &QuatPolynomial, turn: &QuatPolynomial) -> QuatPolynomial {
        let (setup, constant) = (self.setup, Polynomial::constant);
        match setup.base {
            Base::Plane(normal) => self.to_plane(turn, normal),
            Base::Sphere { r, .. } => {
                let from_axis = constant(setup.rho + setup.tan * z - r * setup.sigma * setup.cos);
                axes * &self.mirrored([&from_axis, &from_axis], &constant(z + r * setup.sigma * setup.sin))
            }
        }
    }

    /// The centers on a cone about the axis, in a plane: their distances from the axis are one over the rise `d/W` of the lines of the tube.
    fn on_plane(&self, [z, d]: [&Polynomial; 2], [_, n1]: [f64; 2]) -> Balls {
        let setup = self.setup;
        let down = setup.ball * setup.sigma * setup.sin;
        let from_axis = setup.center_at_origin() * n1 + setup.tan * (setup.ball + n1 * down);
        Balls {
            center: self.row(&Polynomial::constant(from_axis), z - &(d * down), d.clone()),
            radius: d * setup.ball,
            motion: [&wronskian(z, d) * (1.0 / setup.cos), d * (-setup.sigma * self.rate * from_axis)],
        }
    }

    /// The balls, and the turn to the second normals in the axes of the tube.
    ///
    /// Where both surfaces nearly touch along the same plane, all depends on the small way `v` from the center of the sphere to the contact moved by `r` along its normal:
    /// its entries, `n·v` and `v²` are sums of its small parts, so that they agree to the last digits of their own and not of the radii.
    fn on_sphere(&self, z: &Polynomial, [e, r]: [f64; 2]) -> (Balls, QuatPolynomial) {
        let (setup, w) = (self.setup, self.weight);
        let (sigma, sin, cos) = (setup.sigma, setup.sin, setup.cos);
        // The distance of the moved contact from the axis where it is as high as the center, less and plus that of the center.
        let level = setup.rho - r * sigma / cos;
        let [near, far] = [level - e, level + e];
        let up = z + &(w * (r * sigma * sin));
        let rise = &up * setup.tan;
        let [less, from_axis, more] = [near, level, far].map(|distance| &(w * distance) + &rise);
        let [c, s] = [&self.half.0[0], &self.half.0[3]].map(|half| half * half);
        // The normal times the way, and the square of the way.
        let apart = &(&(&c * near) + &(&s * far)) * (sigma * cos);
        let square = {
            let bent = &(&(w * e) - &more) * (4.0 * e);
            &(&(&more * &more) + &(&bent * &c)) + &(&up * &up)
        };
        // The weight is positive.
        let sign = if apart.value(0.5) < 0.0 { -1.0 } else { 1.0 };
        let apart = &apart * (2.0 * sign);
        let square = &square * sign;
        let center_from_axis = &(&from_axis * &apart) - &(&square * (sigma * cos));
        let height = &(&(&up * &apart) + &(&square * (sigma * sin))) * w;
        let weight = &(w * w) * &apart;
        let radius = &(&square * w) * -1.0;
        let radius = &radius - &(&weight * r);
        let motion = [&(&wronskian(z, w) * &apart) * (1.0 / cos), &center_from_axis * (-sigma * self.rate)];
        let second = self.mirrored([&less, &more], &up);
        (Balls { center: self.row(&center_from_axis, height, weight), radius, motion }, second)
    }

    /// `(turn k - N turn) i`: the turn to the normal of the plane.
    fn to_plane(&self, turn: &QuatPolynomial, [n0, n1]: [f64; 2]) -> QuatPolynomial {
        let setup = self.setup;
        let normal = setup.frame.x() * n0 + setup.frame.z() * n1;
        let [i, k] = [Quat::new(0.0, 1.0, 0.0, 0.0), Quat::new(0.0, 0.0, 0.0, 1.0)];
        let first = turn * &QuatPolynomial::constant(k * i);
        let second = &(&QuatPolynomial::constant(Quat::from(normal * -1.0)) * turn) * &QuatPolynomial::constant(i);
        &first + &second
    }

    /// `v turn i` in the axes of the tube, with the way v to the moved contact from a point on the first axis: the distance of the contact from the third axis less and plus that
    /// of the point, and its height.
    fn mirrored(&self, [less, more]: [&Polynomial; 2], up: &Polynomial) -> QuatPolynomial {
        let [c, s] = [&self.half.0[0], &self.half.0[3]];
        let sum = QuatPolynomial([&(s * up) * -1.0, less * c, more * s, up * c]);
        let i = Quat::new(0.0, 1.0, 0.0, 0.0);
        &sum * &QuatPolynomial::constant(self.setup.contact_turn() * i)
    }
}

/// Balls `[X m, X]`, `X R`, and the motion of the center along the ruling and round, up to one positive factor.
struct Balls {
    center: PolynomialRow,
    radius: Polynomial,
    motion: [Polynomial; 2],
}

/// `a' b - a b'` of two quadratics, a quadratic.
fn wronskian(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let coefficients = |p: &Polynomial| -> [f64; 3] {
        let p = p.elevated(2);
        std::array::from_fn(|k| p.coefficients()[k])
    };
    let (a, b) = (coefficients(a), coefficients(b));
    let minor = |i: usize, j: usize| a[j] * b[i] - a[i] * b[j];
    Polynomial::new(vec![2.0 * minor(0, 1), minor(0, 2), 2.0 * minor(1, 2)])
}
