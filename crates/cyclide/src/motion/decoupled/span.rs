//! Places and turns over one span, by the part of it that is done.

use crate::base::bernstein;
use crate::base::jet::CurveJet;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::curve::{CircleSpline, ParamCurve};

/// Where the origin of the body is.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum PlaceSpan {
    /// A polynomial, by its Bézier points.
    Polynomial(Vec<[f64; 3]>),
    /// On a piece of a curve, of which the parameter is a cubic with these Bernstein coefficients.
    OnCurve { piece: usize, law: [f64; 4] },
}

impl PlaceSpan {
    pub(super) fn line([a, b]: [Vec3; 2]) -> Self {
        Self::Polynomial(vec![a.to_array(), b.to_array()])
    }

    pub(super) fn place(&self, u: f64, curve: Option<&CircleSpline>) -> Vec3 {
        match (self, curve) {
            (Self::Polynomial(points), _) => Vec3::from(bernstein::eval(points, u)),
            (Self::OnCurve { piece, law }, Some(curve)) => curve.piece_point(*piece, parameter(law, u)[0]).to_vec(),
            (Self::OnCurve { .. }, None) => Vec3::ZERO,
        }
    }

    /// Place and derivatives.
    pub(super) fn jet(&self, u: f64, curve: Option<&CircleSpline>) -> CurveJet {
        match (self, curve) {
            (Self::Polynomial(points), _) => {
                let [p, d1, d2, d3]: [[f64; 3]; 4] = bernstein::derivatives(points, u);
                let [d1, d2, d3] = [d1, d2, d3].map(Vec3::from);
                CurveJet { point: Point3::from(p), d1, d2, d3 }
            }
            (Self::OnCurve { piece, law }, Some(curve)) => {
                let [s, s1, s2, s3] = parameter(law, u);
                let CurveJet { point, d1, d2, d3 } = curve.piece_jet(*piece, s);
                CurveJet {
                    point,
                    d1: d1 * s1,
                    d2: d2 * (s1 * s1) + d1 * s2,
                    d3: d3 * (s1 * s1 * s1) + d2 * (3.0 * s1 * s2) + d1 * s3,
                }
            }
            (Self::OnCurve { .. }, None) => {
                CurveJet { point: Point3::ORIGIN, d1: Vec3::ZERO, d2: Vec3::ZERO, d3: Vec3::ZERO }
            }
        }
    }
}

/// The parameter on a piece of a curve, with its derivatives.
fn parameter(law: &[f64; 4], u: f64) -> [f64; 4] {
    let [s, rest @ ..] = bernstein::derivatives::<1, 4>(&law.map(|c| [c]), u).map(|[value]| value);
    let [s1, s2, s3] = rest;
    [s.clamp(0.0, 1.0), s1, s2, s3]
}

/// How the body is turned.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum TurnSpan {
    /// About one axis of the world at constant speed: the shortest arc on the sphere of unit quaternions.
    Slerp { ends: [Quat; 2], axis: Vec3, half_angle: f64 },
    /// A cubic in the quaternions, by its Bézier points, of any length.
    Cubic([[f64; 4]; 4]),
}

/// A rotation with angular velocity, acceleration and jerk in the world.
pub(super) struct TurnJet {
    pub(super) rotation: Quat,
    pub(super) angular: [Vec3; 3],
}

impl TurnSpan {
    /// From one rotation to another on the same side.
    pub(super) fn slerp([a, b]: [Quat; 2]) -> Self {
        let turn = rotation_vector([a, b]);
        let angle = turn.length();
        let axis = if angle > 0.0 { turn / angle } else { Vec3::ZERO };
        Self::Slerp { ends: [a, b], axis, half_angle: 0.5 * angle }
    }

    /// The cubic from one rotation to another with these angular velocities by the part of the span.
    pub(super) fn hermite([a, b]: [Quat; 2], [from, to]: [Vec3; 2]) -> Self {
        // q' = ω q/2.
        let inner = |q: Quat, omega: Vec3| (q + Quat::from(omega * (1.0 / 6.0)) * q).to_array();
        Self::Cubic([a.to_array(), inner(a, from), inner(b, -to), b.to_array()])
    }

    pub(super) fn rotation(&self, u: f64) -> Quat {
        match self {
            Self::Slerp { ends, .. } if u <= 0.0 => ends[0],
            Self::Slerp { ends, .. } if u >= 1.0 => ends[1],
            Self::Slerp { ends, axis, half_angle } => Quat::from_axis_angle(*axis, 2.0 * half_angle * u) * ends[0],
            Self::Cubic(points) => unit(Quat::from(bernstein::eval(points, u))),
        }
    }

    /// The rotation and what the body does.
    pub(super) fn jet(&self, u: f64) -> TurnJet {
        match self {
            Self::Slerp { axis, half_angle, .. } => {
                let angular = [*axis * (2.0 * half_angle), Vec3::ZERO, Vec3::ZERO];
                TurnJet { rotation: self.rotation(u), angular }
            }
            Self::Cubic(points) => {
                let rows: [[f64; 4]; 4] = bernstein::derivatives(points, u);
                let scale = 1.0 / Quat::from(rows[0]).norm();
                let p = rows.map(|row| Quat::from(row) * scale);
                TurnJet { rotation: p[0], angular: angular_jet(p) }
            }
        }
    }
}

/// Angular velocity, acceleration and jerk of a quaternion that now has length 1, by its derivatives: with `F_k = p⁽ᵏ⁾ p⁻¹` it is `ω = 2 Im F_1`, and
/// `F_1' = F_2 − F_1²`, `F_1″ = F_3 − F_2 F_1 − F_1' F_1 − F_1 F_1'`.
pub(in super::super) fn angular_jet(p: [Quat; 4]) -> [Vec3; 3] {
    let [first, second, third] = [1, 2, 3].map(|k| p[k] * p[0].conj());
    let turning = second - first * first;
    let jerk = third - second * first - turning * first - first * turning;
    [first, turning, jerk].map(|q| q.vector() * 2.0)
}

/// The turn from one rotation to another on the same side, along its axis in the world, as long as its angle.
pub(super) fn rotation_vector([a, b]: [Quat; 2]) -> Vec3 {
    let between = b * a.conj();
    let sine = between.vector().length();
    if sine > 0.0 { between.vector() * (2.0 * sine.atan2(between.w) / sine) } else { Vec3::ZERO }
}

pub(super) fn unit(q: Quat) -> Quat {
    q * (1.0 / q.norm())
}
