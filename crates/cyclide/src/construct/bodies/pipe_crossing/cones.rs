//! Pipes that are cones, one or both: the image of two skew cylinders under a motion of the space of balls (`docs/math/pipe-crossings.md#tapered-pipes`).
//!
//! Balls of one radius are a closed curve of places there too, told by an angle of its own, as those of another radius have another middle.

use super::contacts::{Contacts, PieceForms};
use crate::base::planar::{Point2, Vec2};
use crate::base::vector::Vec3;
use crate::construct::bodies::pierced::Mantle;
use crate::error::{CrossingError, Error, ErrorItem, NumberError, Result};
use crate::rational::Polynomial;
use crate::surface::{BallLine, BallVector, CanalPatch, MovedCylinders, SkewCylinders, TorusPiece};
use std::f64::consts::PI;

/// Two pipes, one at least a cone. Balls are counted from the middle between the axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct ConePair {
    moved: MovedCylinders,
    smallest_radius: f64,
    /// For both pipes where a ball is along the axis: at the origin of the cylinders, and for a step along x and y.
    along: [[f64; 3]; 2],
    /// For both pipes the half directions of contacts that were along the common perpendicular and against it.
    halves: [[[f64; 2]; 2]; 2],
}

impl ConePair {
    /// # Errors
    /// `angle-out-of-range` (axes whose angle is not above the sum of the tapers, or its supplement is not: cones that meet without end), `crossing-axes-too-near`.
    pub(super) fn new(axes: &SkewCylinders, mantles: &[Mantle; 2]) -> Result<Self> {
        let (angle, least) = (axes.angle(), mantles[0].taper.abs() + mantles[1].taper.abs());
        let out_of_range =
            Error::Number(NumberError::AngleOutOfRange { name: ErrorItem::Angle, angle, min: least, max: PI - least });
        if !(angle > least && angle < PI - least) {
            return Err(out_of_range);
        }
        let middle = Vec3::Z * axes.half_gap();
        let balls = mantles.map(|mantle| {
            let (sin, cos) = mantle.taper.sin_cos();
            let through = BallVector { center: mantle.origin.to_vec() - middle, radius: -mantle.radius * cos };
            BallLine { through, direction: BallVector { center: mantle.along, radius: sin } }
        });
        let too_near = Error::Crossing(CrossingError::AxesTooNear {
            distance: 2.0 * axes.half_gap(),
            limit: least_distance(&balls),
        });
        let moved = MovedCylinders::new(balls).ok_or(too_near)?;
        let smallest_radius = moved.smallest_radius().ok_or(out_of_range)?;
        let along = balls.map(|line| moved.along(line.direction));
        let [_, across] = moved.still().second_axis();
        let halves = [0, 1].map(|pipe: usize| {
            let side = if pipe == 0 { Vec3::Y } else { across };
            let half = |sin: f64, cos: f64| {
                let n = moved.motion().normal(side * sin + Vec3::Z * cos);
                let (s, c) = (0.5 * n.dot(mantles[pipe].sideways).atan2(n.dot(mantles[pipe].up))).sin_cos();
                [c, s]
            };
            let (start, quarter, end) = (half(0.0, 1.0), half(1.0, 0.0), half(0.0, -1.0));
            // A projective map by three of its values: that in the middle is the sum of both others.
            let det = |[a, b]: [f64; 2], [c, d]: [f64; 2]| a * d - b * c;
            let size = det(start, end);
            [start.map(|x| x * det(quarter, end) / size), end.map(|x| x * det(start, quarter) / size)]
        });
        Ok(Self { moved, smallest_radius, along, halves })
    }

    pub(super) fn moved(&self) -> &MovedCylinders {
        &self.moved
    }

    pub(super) fn smallest_radius(&self) -> f64 {
        self.smallest_radius
    }

    /// # Errors
    /// `radius-too-small`, `sphere-at-infinity`.
    pub(super) fn place(&self, radius: f64, angle: f64) -> Result<(Point2, Vec2)> {
        let circle = self.moved.radius_loop(radius)?;
        Ok((circle.place(angle), circle.rate(angle)))
    }

    /// # Errors
    /// As [`place`](Self::place).
    pub(super) fn contacts(&self, radius: f64, angle: f64) -> Result<Contacts> {
        let (place, rate) = self.place(radius, angle)?;
        let still = self.moved.still();
        let (width, [plus, minus], [_, across]) = (still.width(), still.sides().map(f64::sqrt), still.second_axis());
        let [(sin_a, cos_a), (sin_b, cos_b)] = [2.0 * place.x, 2.0 * place.y].map(f64::sin_cos);
        let weight = 2.0 * (place.y - place.x).sin() * (place.y + place.x).sin();
        let weight_rate = 2.0 * (sin_b * rate.y - sin_a * rate.x);
        // Across both cylinders, with their rates.
        let over_weight = |value: f64, slope: f64| {
            let quotient = width * value / weight;
            [quotient, (width * slope - quotient * weight_rate) / weight]
        };
        let y = over_weight(sin_a, 2.0 * cos_a * rate.x);
        let xi = over_weight(sin_b, 2.0 * cos_b * rate.y);
        let x = [0, 1].map(|k: usize| (xi[k] - y[k] * across.y) / across.x);
        let mut contacts = Contacts { at: [[0.0; 2]; 2], rates: [[0.0; 2]; 2] };
        for pipe in 0..2 {
            let [start, by_x, by_y] = self.along[pipe];
            let (at, speed) = if pipe == 0 { (place.x, rate.x) } else { (place.y, rate.y) };
            let ([[c0, s0], [c1, s1]], (sin, cos)) = (self.halves[pipe], at.sin_cos());
            let (sin, cos) = (plus * sin, minus * cos);
            let [c, s] = [c0 * cos + c1 * sin, s0 * cos + s1 * sin];
            let sign = if c < 0.0 { -1.0 } else { 1.0 };
            contacts.at[pipe] = [start + by_x * x[0] + by_y * y[0], 2.0 * (sign * s).atan2(sign * c)];
            let turn = 2.0 * width * (c0 * s1 - s0 * c1) / (c * c + s * s);
            contacts.rates[pipe] = [by_x * x[1] + by_y * y[1], turn * speed];
        }
        Ok(contacts)
    }

    /// # Errors
    /// As [`CanalPatch::along`].
    pub(super) fn forms(&self, piece: &TorusPiece) -> Result<PieceForms> {
        let [patch, still] = self.moved.patches(piece)?;
        let [x, y, _, weight] = &still.center().0;
        let along = self.along.map(|[start, by_x, by_y]| &(&(weight * start) + &(x * by_x)) + &(y * by_y));
        let halves: [[Polynomial; 2]; 2] = CanalPatch::half_directions(self.moved.still(), piece)?;
        let halves = [0, 1].map(|pipe: usize| {
            let ([c, s], [from, to]) = (&halves[pipe], self.halves[pipe]);
            [0, 1].map(|k: usize| &(c * from[k]) + &(s * to[k]))
        });
        Ok(PieceForms { patch: patch.with_even_ends(), halves, along })
    }
}

/// The distance of two axes at which their common perpendicular in the space of balls has the length 0.
fn least_distance([first, second]: &[BallLine; 2]) -> f64 {
    let (p, q) = (first.direction, second.direction);
    let (pp, pq, qq) = (p.dot(p), p.dot(q), q.dot(q));
    let between = second.through.radius - first.through.radius;
    // The part of the axis of radii along both directions has this square.
    let share =
        (p.radius * p.radius * qq - 2.0 * p.radius * q.radius * pq + q.radius * q.radius * pp) / (pp * qq - pq * pq);
    between.abs() * (1.0 + share).sqrt()
}
