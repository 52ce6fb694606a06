//! The circles in which the balls of a tube touch it, with four places on each (`docs/math/tubes.md#rings`).

use super::ball::{Ball, Way};
use super::ball_arc::Station;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Places that lines of curvature bring nearer together or farther apart than this, radians, are spread anew.
const GAPS: [f64; 2] = [0.9, 2.2];

/// A circle of contact with the outward normals at four places of it, counter-clockwise about the way of the balls.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ring {
    pub(super) ball: Ball,
    tangent: Way,
    /// Unit, along the way of the center.
    pub(super) axis: Vec3,
    pub(super) normals: [Vec3; 4],
    /// Weights of the places as ends of the arcs between them: so faces before and behind have one parameter across.
    pub(super) weights: [f64; 4],
}

impl Ring {
    /// The ring of a station with its places at quarters, from a direction across the way.
    pub(super) fn quarters(station: Station, first: Vec3) -> Self {
        let Station { ball, tangent } = station;
        let axis = tangent.v.unit().unwrap_or(tangent.v);
        let first = (first - axis * first.dot(axis)).unit().unwrap_or_else(|| axis.any_perpendicular());
        let mut ring = Self { ball, tangent, axis, normals: [Vec3::default(); 4], weights: [1.0; 4] };
        ring.normals = ring.spread(first, 0.0);
        ring
    }

    /// The normals at quarters from a direction and an angle on.
    fn spread(&self, first: Vec3, angle: f64) -> [Vec3; 4] {
        let size = self.tangent.v.length();
        let (height, rim) = (-self.tangent.r / size, 1.0 / size);
        let second = self.axis.cross(first);
        [0, 1, 2, 3].map(|k| {
            let (sin, cos) = (angle + f64::from(k) * FRAC_PI_2).sin_cos();
            self.axis * height + (first * cos + second * sin) * rim
        })
    }

    /// The ring at the next station with its places carried there along the lines of curvature.
    pub(super) fn carried(&self, station: Station) -> Self {
        let Station { ball, tangent } = station;
        let axis = tangent.v.unit().unwrap_or(tangent.v);
        // A null way (a, -1) stays one. Its time is the square of the spinor of the place, which is carried linearly as the parameter across is.
        let ways = [0, 1, 2, 3].map(|k| {
            let way = Way { v: self.normals[k], r: -1.0 } * self.weights[k];
            way.carried([self.tangent, tangent])
        });
        let mean = -0.25 * ways.iter().map(|way| way.r).sum::<f64>();
        let normals = ways.map(|way| (way.v / -way.r).unit().unwrap_or(axis));
        Self { ball, tangent, axis, normals, weights: ways.map(|way| -way.r / mean) }
    }

    /// Angles of directions about the axis from that of the first place, between 0 and a turn.
    pub(super) fn angle(&self, direction: Vec3) -> f64 {
        let first = self.normals[0] - self.axis * self.normals[0].dot(self.axis);
        direction.dot(self.axis.cross(first)).atan2(direction.dot(first)).rem_euclid(TAU) % TAU
    }

    /// The angles of the places, that of the first one 0.
    pub(super) fn angles(&self) -> [f64; 4] {
        let mut angles = self.normals.map(|normal| self.angle(normal));
        angles[0] = 0.0;
        angles
    }

    /// The angle from a place to the next.
    pub(super) fn gap(&self, place: usize) -> f64 {
        let angles = self.angles();
        if place == 3 { TAU - angles[3] } else { angles[place + 1] - angles[place] }
    }

    /// The same ring with its places at quarters again where they have come too near to each other.
    pub(super) fn respread(&self) -> Option<Self> {
        let uneven = (0..4).any(|k| !(GAPS[0]..=GAPS[1]).contains(&self.gap(k)));
        uneven.then(|| {
            let turn =
                self.angles().iter().enumerate().map(|(k, angle)| angle - k as f64 * FRAC_PI_2).sum::<f64>() / 4.0;
            let first = self.normals[0] - self.axis * self.normals[0].dot(self.axis);
            Self { normals: self.spread(first.unit().unwrap_or(first), turn), weights: [1.0; 4], ..*self }
        })
    }

    /// The point of a place on the tube of balls smaller by a depth.
    pub(super) fn point(&self, place: usize, depth: f64) -> Point3 {
        self.ball.center + self.normals[place] * (self.ball.radius - depth)
    }

    /// The center of the circle.
    pub(super) fn center(&self, depth: f64) -> Point3 {
        self.ball.center + self.axis * (self.normals[0].dot(self.axis) * (self.ball.radius - depth))
    }

    /// From the axis to a place, not unit.
    pub(super) fn radial(&self, place: usize) -> Vec3 {
        let normal = self.normals[place];
        normal - self.axis * normal.dot(self.axis)
    }

    /// The weight ratio of the arc from a place to the next.
    pub(super) fn ratio(&self, place: usize) -> Quat {
        let (sin, cos) = (0.5 * self.gap(place)).sin_cos();
        let size = (self.weights[(place + 1) % 4] / self.weights[place]).sqrt();
        Quat::from_parts(cos * size, self.axis * (sin * size))
    }

    /// The direction of the line of curvature at a place.
    pub(super) fn way(&self, place: usize) -> Vec3 {
        self.tangent.v + self.normals[place] * self.tangent.r
    }
}
