//! A radius that changes with an angle: C1, periodic, between neighbouring stations within their range.
//!
//! Cubics between stations with slopes that vanish where the secants on both sides differ in sign, and are their harmonic mean elsewhere (F. N. Fritsch
//! and J. Butland, *A method for constructing local monotone piecewise cubic interpolants*, 1984).

use crate::error::{Error, ErrorItem, Result};
use std::f64::consts::TAU;

/// Stations nearer to each other than this, radians, are one.
const NEAREST: f64 = 1e-3;

/// Angles in `[0, 2 pi)`, increasing, with radii and slopes.
#[derive(Debug, Clone)]
pub(super) struct RadiusLaw {
    stations: Vec<[f64; 3]>,
}

impl RadiusLaw {
    /// Through `[angle, radius]`.
    pub(super) fn new(given: &[[f64; 2]]) -> Result<Self> {
        if given.is_empty() {
            return Err(Error::TooFewPoints { given: 0, needed: 1 });
        }
        for (index, [angle, radius]) in given.iter().enumerate() {
            for (what, value) in [(ErrorItem::Angle, angle), (ErrorItem::Radius, radius)] {
                if !value.is_finite() {
                    return Err(Error::NotFinite { what, index });
                }
            }
            if *radius <= 0.0 {
                return Err(Error::NoPositiveRadius { radius: *radius });
            }
        }
        let mut order: Vec<(usize, f64, f64)> =
            given.iter().enumerate().map(|(i, [angle, radius])| (i, angle.rem_euclid(TAU), *radius)).collect();
        order.sort_by(|a, b| a.1.total_cmp(&b.1));
        let n = order.len();
        for i in 0..n {
            let (next, turn) = (order[(i + 1) % n], if i + 1 == n { TAU } else { 0.0 });
            let distance = next.1 + turn - order[i].1;
            if n > 1 && distance < NEAREST {
                return Err(Error::CoincidentPoints { first: order[i].0, second: next.0, distance, limit: NEAREST });
            }
        }
        let secant = |i: usize| {
            let (a, b) = (order[i % n], order[(i + 1) % n]);
            (b.2 - a.2) / (b.1 - a.1 + if i % n + 1 == n { TAU } else { 0.0 })
        };
        let slope = |i: usize| {
            let (before, after) = (secant(i + n - 1), secant(i));
            if before * after > 0.0 { 2.0 * before * after / (before + after) } else { 0.0 }
        };
        Ok(Self { stations: (0..n).map(|i| [order[i].1, order[i].2, slope(i)]).collect() })
    }

    /// The angles of the stations; of a constant law none, as they are no matter.
    pub(super) fn angles(&self) -> impl Iterator<Item = f64> + '_ {
        self.stations.iter().filter(|_| self.stations.len() > 1).map(|station| station[0])
    }

    /// The radius and its derivative.
    pub(super) fn at(&self, angle: f64) -> [f64; 2] {
        let (angle, n) = (angle.rem_euclid(TAU), self.stations.len());
        let after = self.stations.partition_point(|station| station[0] <= angle);
        let (from, to) = (self.stations[(after + n - 1) % n], self.stations[after % n]);
        let length = if n == 1 { TAU } else { (to[0] - from[0]).rem_euclid(TAU) };
        let u = (angle - from[0]).rem_euclid(TAU) / length;
        let (rise, [m0, m1]) = (to[1] - from[1], [from[2], to[2]].map(|m| m * length));
        // Hermite's cubic about its start: a constant is one to the bit.
        let (b, c) = (3.0 * rise - 2.0 * m0 - m1, m0 + m1 - 2.0 * rise);
        [from[1] + u * (m0 + u * (b + u * c)), (m0 + u * (2.0 * b + 3.0 * u * c)) / length]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_through_stations_and_stays_between_them() {
        let given = [[0.5, 1.0], [2.0, 3.0], [-1.0, 2.0], [4.0, 2.5]];
        let law = RadiusLaw::new(&given).unwrap();
        for [angle, radius] in given {
            assert!((law.at(angle)[0] - radius).abs() < 1e-15);
        }
        for k in 0..=200 {
            let x = 0.1 * f64::from(k) - 7.0;
            let [value, slope] = law.at(x);
            assert!((1.0..=3.0).contains(&value));
            let difference = (law.at(x + 1e-6)[0] - law.at(x - 1e-6)[0]) / 2e-6;
            assert!((slope - difference).abs() < 1e-5, "{x}");
        }
        let constant = RadiusLaw::new(&[[9.0, 0.3]]).unwrap().at(-20.0);
        assert!((constant[0] - 0.3).abs() + constant[1].abs() == 0.0);
        assert_eq!(RadiusLaw::new(&[[0.0, 1.0], [TAU, 2.0]]).unwrap_err().reason(), "coincident-points");
    }
}
