//! Places of a triangle.

use crate::error::{Error, ErrorItem, NumberError, Result};

/// Barycentric coordinates in any scale: integers `(i, j, N-i-j)` are the same bits on both sides of a shared edge, fractions
/// that were made to sum to 1 are not.
#[derive(Debug, Clone, Copy)]
pub(super) struct Barycentric {
    raw: [f64; 3],
    sum: f64,
}

impl Barycentric {
    /// # Errors
    /// `parameter-out-of-range`: not finite, negative, or all zero.
    pub(super) fn new(raw: [f64; 3]) -> Result<Self> {
        let refused = |value| {
            Error::Number(NumberError::ParameterOutOfRange {
                name: ErrorItem::BarycentricCoordinate,
                value,
                min: 0.0,
                max: f64::MAX,
            })
        };
        if let Some(&wrong) = raw.iter().find(|v| !(**v >= 0.0 && v.is_finite())) {
            return Err(refused(wrong));
        }
        let largest = raw.iter().fold(0.0, |m: f64, v| m.max(*v));
        if largest == 0.0 {
            return Err(NumberError::ParameterOutOfRange {
                name: ErrorItem::LargestBarycentricCoordinate,
                value: 0.0,
                min: f64::MIN_POSITIVE,
                max: f64::MAX,
            }
            .into());
        }
        // A power of two: the ratios keep their bits, and neither sums nor products over- or underflow to nothing.
        let raw = if (1e-100..1e100).contains(&largest) { raw } else { raw.map(|v| v / exponent(largest)) };
        Ok(Self { raw, sum: raw[0] + raw[1] + raw[2] })
    }

    /// The corner, if the place is one.
    pub(super) fn corner(&self) -> Option<usize> {
        let others = |i: usize| self.raw[(i + 1) % 3] == 0.0 && self.raw[(i + 2) % 3] == 0.0;
        (0..3).find(|&i| others(i))
    }

    /// The side (opposite to the corner of that number), if the place is on one and no corner.
    pub(super) fn side(&self) -> Option<usize> {
        if self.corner().is_some() { None } else { self.raw.iter().position(|v| *v == 0.0) }
    }

    /// The largest coordinate.
    pub(super) fn largest(&self) -> usize {
        (1..3).fold(0, |best, i| if self.raw[i] > self.raw[best] { i } else { best })
    }

    /// The smallest coordinate.
    pub(super) fn smallest(&self) -> usize {
        (1..3).fold(0, |best, i| if self.raw[i] < self.raw[best] { i } else { best })
    }

    /// With the sum 1, to rounding.
    pub(super) fn coordinates(&self) -> [f64; 3] {
        self.raw.map(|v| v / self.sum)
    }

    /// How far the place is from a corner: 0 there, 1 on the opposite side, exactly.
    pub(super) fn off_corner(&self, corner: usize) -> f64 {
        if self.raw[corner] == 0.0 {
            return 1.0;
        }
        (self.raw[(corner + 1) % 3] + self.raw[(corner + 2) % 3]) / self.sum
    }

    /// The parameter from one corner to another of the line through the third one and the place.
    pub(super) fn between(&self, from: usize, to: usize) -> f64 {
        self.raw[to] / (self.raw[from] + self.raw[to])
    }
}

/// The power of two below a positive number.
fn exponent(v: f64) -> f64 {
    2.0_f64.powf(v.log2().floor().clamp(-1021.0, 1022.0))
}
