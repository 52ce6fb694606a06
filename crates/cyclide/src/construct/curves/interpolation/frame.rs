//! Data moved to their middle and scaled to their size, so that limits mean the same for all.

use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};

/// The middle of the data and their size.
#[derive(Debug, Clone, Copy)]
pub(super) struct DataFrame {
    pub(super) center: Point3,
    /// Positive, but if all data are one point.
    pub(super) radius: f64,
}

impl DataFrame {
    /// Of points: their centroid, and the largest distance from it.
    pub(super) fn of(points: &[Point3]) -> Self {
        let Some(&first) = points.first() else { return Self { center: Point3::ORIGIN, radius: 0.0 } };
        let mean = points.iter().fold(Vec3::ZERO, |sum, p| sum + (*p - first) / points.len() as f64);
        let center = first + mean;
        Self { center, radius: points.iter().map(|p| p.distance(center)).fold(0.0, f64::max) }
    }

    /// As large as these lengths at least.
    pub(super) fn including(self, lengths: impl IntoIterator<Item = f64>) -> Self {
        Self { radius: lengths.into_iter().fold(self.radius, f64::max), ..self }
    }

    /// A point seen from the middle, in sizes.
    pub(super) fn local(&self, p: Point3) -> Quat {
        Quat::from((p - self.center) / self.radius)
    }
}
