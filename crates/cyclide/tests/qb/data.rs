//! Random data, and curves of which the digits are known.

use cyclide::{
    Point3, Vec3,
    conformal::Mobius,
    construct::{NodeParameters, QbInterpolation},
    curve::QbCurve,
};
use cyclide_testkit::generators::{direction, point};
use proptest::prelude::*;

/// Parameters with both ends.
pub const PARAMETERS: [f64; 9] = [0.0, 1e-6, 0.125, 0.3, 0.5, 0.625, 0.8, 1.0 - 1e-6, 1.0];

/// Ends and derivatives that point forward, within 80 degrees of the chord and from a fifth of it to five times as long.
#[derive(Debug, Clone, Copy)]
pub struct Forward {
    pub ends: [Point3; 2],
    pub velocities: [Vec3; 2],
}

impl Forward {
    pub fn span(&self) -> QbCurve {
        QbCurve::invariant_span(self.ends, self.velocities).unwrap()
    }

    pub fn chord(&self) -> Vec3 {
        self.ends[1] - self.ends[0]
    }
}

pub fn forward() -> impl Strategy<Value = Forward> {
    let speed = || (-0.7..0.7_f64).prop_map(|e| 10.0_f64.powf(e));
    let tangent = || (direction(), 0.0..1.39_f64, speed());
    (point(), direction(), 0.1..1.0_f64, tangent(), tangent()).prop_map(|(start, along, length, a, b)| {
        let velocity = |(side, angle, speed): (Vec3, f64, f64)| {
            let across = (side - along * side.dot(along)).unit().unwrap_or(along.any_perpendicular());
            (along * angle.cos() + across * angle.sin()) * (speed * length)
        };
        Forward { ends: [start, start + along * length], velocities: [velocity(a), velocity(b)] }
    })
}

/// An odd number of points in the cube.
pub fn odd_points() -> impl Strategy<Value = Vec<Point3>> {
    prop_oneof![Just(3_usize), Just(5), Just(7), Just(9)].prop_flat_map(|n| prop::collection::vec(point(), n))
}

/// Parameters of points that are given as such, at least a twentieth of a step from each other.
pub fn spread(n: usize) -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.05..1.0_f64, n - 1).prop_map(|steps| {
        let total: f64 = steps.iter().sum();
        let mut sum = 0.0;
        let inner = steps.iter().map(move |h| {
            sum += h / total;
            sum.min(1.0)
        });
        let mut t: Vec<f64> = std::iter::once(0.0).chain(inner).collect();
        if let Some(last) = t.last_mut() {
            *last = 1.0;
        }
        t
    })
}

/// The curve through points, if it keeps its digits: no needle, no run far away.
pub fn tame(points: &[Point3], t: &[f64]) -> Option<QbInterpolation> {
    let found = QbInterpolation::through_points(points, &NodeParameters::Given(t.to_vec())).ok()?;
    let well = found.reach() < 3.0 && found.attainability().iter().all(|a| *a > 1e-2);
    well.then_some(found)
}

/// An inversion about a point outside the cube, and some way off it.
pub fn outside_inversion() -> impl Strategy<Value = Mobius> {
    (direction(), 4.0..8.0_f64).prop_map(|(d, distance)| Mobius::inversion(Point3::ORIGIN + d * distance, 2.0).unwrap())
}
