//! The law of a radius through values at angles, once round: no rational loop of balls has it exactly, so loops follow it within a tolerance.

use crate::error::{ErrorItem, NumberError, PointError, Result};
use std::f64::consts::TAU;

/// Angles nearer to each other than this are one.
pub(in crate::construct::bodies) const SAME_ANGLE: f64 = 1e-9;

pub(in crate::construct::bodies) fn check_radius(radius: f64, index: usize) -> Result<()> {
    if !radius.is_finite() {
        return Err(NumberError::NotFinite { what: ErrorItem::Radius, index }.into());
    }
    if radius <= 0.0 {
        return Err(NumberError::RadiusNotPositive { what: ErrorItem::Radius, index, radius }.into());
    }
    Ok(())
}

/// A law through values at angles: cubic between them, flat at least and largest values, so that it passes none of them.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::construct::bodies) struct Law {
    /// Angle in `[0, 2π)`, radius, slope; ascending.
    values: Vec<[f64; 3]>,
}

impl Law {
    /// # Errors
    /// `too-few-points`, `not-finite`, `radius-not-positive`, `coincident-points`.
    pub(in crate::construct::bodies) fn new(given: &[[f64; 2]]) -> Result<Self> {
        if given.is_empty() {
            return Err(PointError::TooFewPoints { given: 0, needed: 1 }.into());
        }
        for (index, [angle, radius]) in given.iter().enumerate() {
            if !angle.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::Angle, index }.into());
            }
            check_radius(*radius, index)?;
        }
        let mut order: Vec<usize> = (0..given.len()).collect();
        let turned = |k: usize| given[k][0].rem_euclid(TAU);
        order.sort_by(|&a, &b| turned(a).total_cmp(&turned(b)));
        let count = order.len();
        let gap = |k: usize| {
            let (from, to) = (turned(order[k]), turned(order[(k + 1) % count]));
            if k + 1 == count { to + TAU - from } else { to - from }
        };
        for k in 0..count {
            if count > 1 && gap(k) <= SAME_ANGLE {
                let (first, second) = (order[k], order[(k + 1) % count]);
                let (first, second) = (first.min(second), first.max(second));
                return Err(PointError::CoincidentPoints { first, second, distance: gap(k), limit: SAME_ANGLE }.into());
            }
        }
        let chord = |k: usize| (given[order[(k + 1) % count]][1] - given[order[k]][1]) / gap(k);
        let slope = |k: usize| {
            let before = (k + count - 1) % count;
            let (left, right) = (chord(before), chord(k));
            if left * right <= 0.0 {
                return 0.0;
            }
            // The weighted harmonic mean, which keeps cubics between their ends.
            let (a, b) = (2.0 * gap(k) + gap(before), gap(k) + 2.0 * gap(before));
            (a + b) / (a / left + b / right)
        };
        Ok(Self { values: (0..count).map(|k| [turned(order[k]), given[order[k]][1], slope(k)]).collect() })
    }

    /// The angles of its values.
    pub(in crate::construct::bodies) fn angles(&self) -> impl Iterator<Item = f64> {
        self.values.iter().map(|[angle, _, _]| *angle)
    }

    /// The least of its radii, and the largest.
    pub(in crate::construct::bodies) fn range(&self) -> [f64; 2] {
        let range = [f64::INFINITY, f64::NEG_INFINITY];
        self.values.iter().fold(range, |[low, high], [_, radius, _]| [low.min(*radius), high.max(*radius)])
    }

    /// The values before and behind an angle.
    fn around(&self, angle: f64) -> [[f64; 3]; 2] {
        let count = self.values.len();
        let angle = angle.rem_euclid(TAU);
        let next = self.values.iter().position(|[a, _, _]| *a > angle).unwrap_or(0);
        [self.values[(next + count - 1) % count], self.values[next]]
    }

    /// From the value before an angle to that behind it the rise of the radius, and the smaller radius.
    pub(in crate::construct::bodies) fn rise(&self, angle: f64) -> (f64, f64) {
        let [[_, r0, _], [_, r1, _]] = self.around(angle);
        (r1 - r0, r0.min(r1))
    }

    /// Radius and slope at an angle.
    pub(in crate::construct::bodies) fn at(&self, angle: f64) -> [f64; 2] {
        let [[a0, r0, s0], [a1, r1, s1]] = self.around(angle);
        let mut gap = (a1 - a0).rem_euclid(TAU);
        if gap == 0.0 {
            gap = TAU;
        }
        let x = (angle - a0).rem_euclid(TAU) / gap;
        let (d, y) = (r1 - r0, 1.0 - x);
        let radius = r0 + d * x * x * (3.0 - 2.0 * x) + gap * x * y * (s0 * y - s1 * x);
        let slope = (6.0 * d * x * y) / gap + s0 * y * (1.0 - 3.0 * x) + s1 * x * (1.0 - 3.0 * y);
        [radius, slope]
    }
}
