//! Pipes that are cones: balls that touch both, tangent planes, walls, and the volume under the envelope of balls of exactly one radius, each found by itself.

use super::{canals, normal};
use cyclide::{
    Error, Point3, Vec3,
    construct::{CrossingPipe, CrossingSide, MadeCrossing, PipeCrossing, TeeEnds},
    error::{BallError, CrossingError, NumberError, PipeError},
    surface::ParamSurface,
    topology::{Body, surface_joints},
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const ENDS: [f64; 2] = [-6.0, 7.0];

/// Radii and tapers, the distance of the axes, their angle in degrees, and the side of the ball.
#[derive(Debug, Clone, Copy)]
struct Cones {
    pipes: [[f64; 2]; 2],
    distance: f64,
    degrees: f64,
    side: CrossingSide,
}

/// With the radius of a ball: both kinds of pairs, tapers of either sign, a bridge, and what two have in common.
const CASES: [(Cones, f64); 7] = [
    (Cones { pipes: [[2.0, 0.12], [2.0, -0.1]], distance: 3.0, degrees: 90.0, side: CrossingSide::Outside }, 0.5),
    (Cones { pipes: [[2.0, 0.0], [3.0, 0.2]], distance: 3.5, degrees: 70.0, side: CrossingSide::Outside }, 0.6),
    (Cones { pipes: [[2.0, 0.1], [1.5, 0.1]], distance: 3.9, degrees: 100.0, side: CrossingSide::Outside }, 0.9),
    (Cones { pipes: [[3.0, -0.25], [1.6, 0.0]], distance: 3.0, degrees: 115.0, side: CrossingSide::Outside }, 0.3),
    (Cones { pipes: [[2.0, 0.12], [2.0, 0.0]], distance: 1.6, degrees: 90.0, side: CrossingSide::Inside }, 0.4),
    (Cones { pipes: [[2.0, -0.2], [3.0, 0.15]], distance: 2.5, degrees: 65.0, side: CrossingSide::Inside }, 0.4),
    // The middles of the loops are far from the common normal.
    (Cones { pipes: [[2.0, 0.2], [2.0, 0.2]], distance: 4.2, degrees: 90.0, side: CrossingSide::Outside }, 0.4),
];

impl Cones {
    fn whole(&self, blend: f64) -> PipeCrossing {
        let pipes = self.pipes.map(|[radius, taper]| CrossingPipe { radius, taper, ends: ENDS });
        let crossing =
            PipeCrossing::new(pipes, self.distance, blend).and_then(|c| c.with_angle(self.degrees.to_radians()));
        crossing.expect("a pair").with_side(self.side)
    }

    fn sign(&self) -> f64 {
        if self.side == CrossingSide::Inside { -1.0 } else { 1.0 }
    }

    /// Axis, the direction across it that angles go towards, and that up to the other pipe.
    fn frame(&self, pipe: usize) -> [Vec3; 3] {
        let (sin, cos) = self.degrees.to_radians().sin_cos();
        if pipe == 0 {
            [Vec3::X, Vec3::Y, Vec3::Z]
        } else {
            [Vec3::new(cos, sin, 0.0), Vec3::new(sin, -cos, 0.0), -Vec3::Z]
        }
    }

    /// Place along a pipe and angle round it, how far a point is outside, and the outer normal there.
    fn seen(&self, pipe: usize, p: Point3) -> ([f64; 2], f64, Vec3) {
        let ([along, side, up], [radius, taper]) = (self.frame(pipe), self.pipes[pipe]);
        let way = p.to_vec() - Vec3::Z * if pipe == 0 { 0.0 } else { self.distance };
        let [a, y, z] = [along, side, up].map(|axis| way.dot(axis));
        let (sin, cos) = taper.sin_cos();
        let out = (side * y + up * z) / y.hypot(z);
        ([a, y.atan2(z)], (y.hypot(z) - radius) * cos + a * sin, out * cos + along * sin)
    }

    /// The ball of a radius in a direction from a vertical line, from one near it.
    fn ball(&self, line: Point3, angle: f64, radius: f64, near: [f64; 2]) -> ([f64; 2], Point3) {
        let (sin, cos) = angle.sin_cos();
        let place = |[off, z]: [f64; 2]| Point3::new(line.x + off * cos, line.y + off * sin, z);
        let miss = |at: [f64; 2]| [0, 1].map(|pipe| self.seen(pipe, place(at)).1 - radius);
        let mut at = near;
        for _ in 0..40 {
            let h = 1e-6;
            let (f, fx, fz) = (miss(at), miss([at[0] + h, at[1]]), miss([at[0], at[1] + h]));
            let [[a, c], [b, d]] = [fx, fz].map(|g| [0, 1].map(|k: usize| (g[k] - f[k]) / h));
            let det = a * d - b * c;
            at = [at[0] - (f[0] * d - b * f[1]) / det, at[1] - (a * f[1] - c * f[0]) / det];
        }
        (at, place(at))
    }

    /// Volume under the envelope of balls of one radius, by quadrature of `z n_z` over it and over the pipes outside the contacts, by Green's theorem.
    fn volume(&self, radius: f64, start: Point3, line: Point3) -> f64 {
        let (steps, sign) = (4000, self.sign());
        let step = TAU / f64::from(steps);
        let way = start - line;
        let (mut near, first) = ([way.x.hypot(way.y), start.z], way.y.atan2(way.x));
        let balls: Vec<Point3> = (0..=steps + 1)
            .map(|k| {
                let (at, center) = self.ball(line, first + f64::from(k) * step, sign * radius, near);
                near = at;
                center
            })
            .collect();
        let (mut strip, mut holes) = (0.0, [0.0; 2]);
        for k in 1..=steps as usize {
            let motion = (balls[k + 1] - balls[k - 1]) / (2.0 * step);
            let bend = (balls[k + 1] + (balls[k - 1] - balls[k]) - balls[k]) / (step * step);
            let axis = motion.unit().expect("a motion");
            let normals = [0, 1].map(|pipe| self.seen(pipe, balls[k]).2 * sign);
            let turn = normals[0].dot(normals[1]).clamp(-1.0, 1.0).acos();
            // From the ball into its envelope; what a step of the ball sweeps of that is less where it bends towards it.
            let parts = 64;
            for j in 0..parts {
                let part = (f64::from(j) + 0.5) / f64::from(parts);
                let n = (normals[0] * ((1.0 - part) * turn).sin() + normals[1] * (part * turn).sin()) / turn.sin();
                let point = balls[k] - n * radius;
                let area =
                    (motion.length() + radius * n.dot(bend - axis * bend.dot(axis)) / motion.length()) * radius * turn;
                strip += point.to_vec().z * n.z * sign * area * step / f64::from(parts);
            }
            for (pipe, hole) in holes.iter_mut().enumerate() {
                let [[a0, f0], [a1, f1]] = [k - 1, k].map(|k| {
                    let n = self.seen(pipe, balls[k]).2;
                    self.seen(pipe, balls[k] - n * (sign * radius)).0
                });
                let ([r, taper], f, a) = (self.pipes[pipe], 0.5 * (f0 + f1), 0.5 * (a0 + a1));
                let t = taper.tan();
                let (once, twice) = (r * a - 0.5 * t * a * a, r * r * a - r * t * a * a + t * t * a * a * a / 3.0);
                let (low, way) = if pipe == 0 { (0.0, 1.0) } else { (self.distance, -1.0) };
                *hole += way * (f1 - f0) * f.cos() * (f.cos() * twice - low * once);
            }
        }
        let whole: f64 = self
            .pipes
            .iter()
            .map(|[r, taper]| {
                let [low, high] = ENDS.map(|end| r - taper.tan() * end);
                PI / 3.0 * (ENDS[1] - ENDS[0]) * (low * low + low * high + high * high)
            })
            .sum();
        if self.side == CrossingSide::Inside {
            strip + holes[0] + holes[1]
        } else {
            whole + strip - holes[0] - holes[1]
        }
    }
}

fn check_joints(body: &Body, cones: &Cones) {
    for joint in body.shells().flat_map(surface_joints) {
        let crease = cones.pipes.iter().any(|[_, taper]| ((joint.angle - FRAC_PI_2).abs() - taper.abs()).abs() < 1e-9);
        assert!(joint.gap < 1e-12 * ENDS[1] && (joint.angle < 1e-8 || crease), "{cones:?} {joint:?}");
    }
}

#[test]
fn every_circle_of_the_blend_is_on_one_ball_that_touches_both_cones() {
    for (cones, blend) in CASES {
        let MadeCrossing { body, blend: facts, .. } =
            cones.whole(blend).made().unwrap_or_else(|e| panic!("{cones:?}: {e}"));
        assert!(body.is_solid());
        check_joints(&body, &cones);
        let [least, most] = facts.radii;
        assert!(least >= 0.999 * blend && most <= 1.001 * blend && least < most, "{least} {most}");
        let canals = canals(&body);
        assert_eq!(canals.len(), facts.pieces);
        for (surface, face) in canals {
            for s in [0.0, 0.3, 0.8] {
                let contacts = [0.0, 1.0].map(|t| surface.point(s, t));
                let normals = [0.0, 1.0].map(|t| normal(surface, face, s, t));
                for pipe in 0..2 {
                    let (_, off, n) = cones.seen(pipe, contacts[pipe]);
                    assert!(off.abs() < 1e-12 * ENDS[1] && (n - normals[pipe]).length() < 1e-8, "{off}");
                }
                let turn = normals[0] - normals[1];
                let radius = (contacts[1] - contacts[0]).dot(turn) / turn.length_squared();
                let center = contacts[0] + normals[0] * radius;
                assert!(radius * cones.sign() > least - 1e-9 && radius * cones.sign() < most + 1e-9);
                for t in [0.25, 0.7] {
                    let (q, n) = (surface.point(s, t), normal(surface, face, s, t));
                    assert!((q + n * radius).distance(center) < 1e-8 * cones.distance, "{t}");
                }
            }
        }
    }
}

#[test]
fn bodies_have_the_volume_under_the_envelope() {
    for (cones, blend) in CASES {
        let whole = cones.whole(blend).with_tolerance(1e-5 * blend).expect("a tolerance");
        let body = whole.made().expect("a crossing").body;
        // The loop goes round the middle of its balls.
        let centers: Vec<Point3> = canals(&body)
            .into_iter()
            .map(|(surface, face)| surface.point(0.0, 0.0) + normal(surface, face, 0.0, 0.0) * (cones.sign() * blend))
            .collect();
        let middle = centers.iter().fold(Vec3::ZERO, |sum, c| sum + c.to_vec()) / centers.len() as f64;
        let expected = cones.volume(blend, centers[0], Point3::ORIGIN + middle);
        let volume = body.outer.volume();
        // Of the radius, within 1e-5 of its own, and of the quadrature, second order in its steps.
        assert!((volume / expected - 1.0).abs() < 1e-5, "{cones:?}: {volume} {expected}");
    }
}

#[test]
fn walls_of_cones_have_one_thickness() {
    let wall = 0.2;
    for (cones, blend) in CASES {
        let inside = cones.side == CrossingSide::Inside;
        let whole = cones.whole(blend).with_wall(wall).expect("a wall");
        let tube = whole.made().expect("a tube").body;
        assert!(tube.is_solid() && tube.voids.len() == usize::from(inside));
        check_joints(&tube, &cones);
        let body = whole.with_ends(TeeEnds::Closed).made().expect("a hollow").body;
        assert!(body.is_solid() && body.voids.len() == 1);
        check_joints(&body, &cones);
        let faces = canals(&body);
        let (outer, inner) = faces.split_at(faces.len() / 2);
        for ((outside, face), (inside, _)) in outer.iter().zip(inner) {
            for (s, t) in [(0.0, 0.0), (0.3, 0.4), (0.7, 1.0)] {
                let below = outside.point(s, t) - normal(outside, face, s, t) * wall;
                assert!(below.distance(inside.point(s, t)) < 1e-10);
            }
        }
        // All else of the hollow is on a cone below one of both, or on a disk as far from an end.
        for face in body.voids.iter().flat_map(|shell| shell.faces()) {
            let p = face.surface.point(0.4, 0.6);
            let off = [0, 1].map(|pipe| (cones.seen(pipe, p).1 + wall).abs());
            let on_disk = [0, 1].iter().any(|&pipe| {
                let [[a, _], ..] = [cones.seen(pipe, p).0];
                (a - ENDS[0] - wall).abs() < 1e-12 || (a - ENDS[1] + wall).abs() < 1e-12
            });
            let on_canal = inner.iter().any(|(surface, _)| surface.point(0.4, 0.6).distance(p) == 0.0);
            assert!(off[0].min(off[1]) < 1e-11 || on_disk || on_canal, "{off:?}");
        }
    }
}

#[test]
fn a_taper_of_nothing_is_a_cylinder_and_pipes_may_change_places() {
    let volume = |pipes: [[f64; 2]; 2], scale: f64| {
        let pipes =
            pipes.map(|[radius, taper]| CrossingPipe { radius: scale * radius, taper, ends: ENDS.map(|e| e * scale) });
        let crossing = PipeCrossing::new(pipes, 3.5 * scale, 0.6 * scale).and_then(|c| c.with_angle(1.2));
        crossing.and_then(|c| c.made()).expect("a crossing").body.outer.volume() / scale.powi(3)
    };
    // The volume changes as the taper, and with the places of the pieces by what the radius may be off.
    let (none, next) = (volume([[2.0, 0.0], [3.0, 0.0]], 1.0), volume([[2.0, 1e-12], [3.0, 0.0]], 1.0));
    assert!((next / none - 1.0).abs() < 1e-6, "{next} {none}");
    let own = volume([[2.0, 0.1], [3.0, -0.15]], 1.0);
    for scale in [1e-6, 1e-3, 1e6] {
        assert!((volume([[2.0, 0.1], [3.0, -0.15]], scale) / own - 1.0).abs() < 1e-10, "{scale}");
    }
    assert!((volume([[3.0, -0.15], [2.0, 0.1]], 1.0) / own - 1.0).abs() < 1e-6);
}

#[test]
fn cones_that_are_no_crossing_are_refused_with_their_measures() {
    let refused = |cones: Cones, blend: f64| cones.whole(blend).made().map(|_| ()).expect_err("no crossing");
    let (cones, blend) = CASES[0];
    // A cone that comes to its apex before its end: 2 less 7 tan 0.3.
    let Error::Pipe(PipeError::ConeReachesApex { apex, reached, .. }) =
        refused(Cones { pipes: [[2.0, 0.3], [2.0, 0.0]], ..cones }, blend)
    else {
        panic!("an apex")
    };
    assert!((apex - 2.0 / 0.3_f64.tan()).abs() < 1e-13 && (reached - 7.0).abs() < 1e-15, "{apex} {reached}");
    // Axes at an angle that the tapers fill.
    let tapers = Cones { pipes: [[2.0, 0.1], [2.0, 0.12]], degrees: 12.0, ..cones };
    assert!(
        matches!(refused(tapers, blend), Error::Number(NumberError::AngleOutOfRange { min, .. }) if (min - 0.22).abs() < 1e-15)
    );
    // Radii that differ by more than the axes are apart; the limit is that of cylinders as the taper goes to nothing.
    let near = Cones { pipes: [[2.0, 1e-9], [3.0, 0.0]], distance: 0.9, ..cones };
    assert!(
        matches!(refused(near, blend), Error::Crossing(CrossingError::AxesTooNear { limit, .. }) if (limit - 1.0).abs() < 1e-8)
    );
    let apart = Cones { distance: 5.0, ..cones };
    assert!(
        matches!(refused(apart, 0.3), Error::Ball(BallError::RadiusTooSmall { limit, .. }) if limit > 0.4 && limit < 0.5)
    );
    let mixed = Cones { side: CrossingSide::Mixed, ..cones };
    assert_eq!(refused(mixed, blend).reason(), "crossing-needs-cylinders");
    let law = cones.whole(blend).with_radii(&[[0.0, 0.5], [2.0, 0.6]]).and_then(|c| c.made());
    assert_eq!(law.map(|_| ()).expect_err("a law").reason(), "crossing-needs-cylinders");
    let pipe = |taper| CrossingPipe { radius: 2.0, taper, ends: ENDS };
    assert_eq!(PipeCrossing::new([pipe(0.0), pipe(f64::NAN)], 3.0, 0.5).expect_err("a number").reason(), "not-finite");
    assert_eq!(refused(Cones { pipes: [[2.0, 2.0], [2.0, 0.0]], ..cones }, blend).reason(), "radius-not-positive");
}
