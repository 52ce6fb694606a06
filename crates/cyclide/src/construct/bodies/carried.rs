//! Vectors across a spine that are carried along a piece of it by the rotation of its arc, and by a twist about it: rational.

use super::bands::rows_of;
use super::rotated_rows::rotated_rows;
use crate::base::quat::Quat;
use crate::base::vector::Vec3;
use crate::curve::Arc;
use crate::error::Result;
use crate::rational::{Polynomial, PolynomialRow, RationalBezierSurface};
use crate::topology::EdgeCurve;

/// A piece of a spine, an arc of at most a third of a turn with even weights, and how a frame turns about it.
pub(super) struct Carrier {
    arc: Arc,
    /// Tangent at the start, unit.
    axis: Vec3,
    twist: f64,
    spine: PolynomialRow,
    /// Weights of the twist.
    twisting: Polynomial,
}

impl Carrier {
    pub(super) fn new(arc: Arc, axis: Vec3, twist: f64) -> Self {
        let spine = PolynomialRow::of_rows(&rows_of(&EdgeCurve::Arc(arc)));
        let twisting = match twist == 0.0 {
            true => Polynomial::constant(1.0),
            false => Polynomial::new(vec![1.0, (0.5 * twist).cos(), 1.0]),
        };
        Self { arc, axis, twist, spine, twisting }
    }

    /// True if lines along it are straight.
    pub(super) fn is_straight(&self) -> bool {
        self.arc.is_straight() && self.twist == 0.0
    }

    /// The rotation along an arc without a twist, as the weight ratio of what it sweeps.
    pub(super) fn ratio(&self) -> Option<Quat> {
        (self.twist == 0.0).then(|| self.arc.weight_ratio())
    }

    /// A vector across in the weights of the rotation and of the twist.
    fn carried(&self, way: Vec3) -> [Polynomial; 3] {
        let along = |v: Vec3| -> [Polynomial; 3] {
            if self.arc.is_straight() {
                return v.to_array().map(Polynomial::constant);
            }
            let rows = rotated_rows(self.arc.weight_ratio(), v).map(Vec3::to_array);
            [0, 1, 2].map(|d: usize| Polynomial::new(rows.iter().map(|row| row[d]).collect()))
        };
        if self.twist == 0.0 {
            return along(way);
        }
        let twisted = rotated_rows(Quat::from_axis_angle(self.axis, self.twist), way);
        let basis = |i: usize| Polynomial::new((0..3).map(|j| f64::from(u8::from(i == j))).collect());
        let parts = [0, 1, 2].map(|i: usize| along(twisted[i]).map(|entry| &entry * &basis(i)));
        [0, 1, 2].map(|d: usize| &(&parts[0][d] + &parts[1][d]) + &parts[2][d])
    }

    /// The line of a homogeneous row `[way, weight]` of a section across the start, whose vectors grow by a factor along the piece.
    pub(super) fn row(&self, (way, weight): (Vec3, f64), factor: &Polynomial) -> PolynomialRow {
        let carried = self.carried(way).map(|entry| &entry * factor);
        let spine = &(&self.spine * &self.twisting) * weight;
        &spine + &PolynomialRow::direction(carried)
    }
}

/// The surface with these rows as its lines along t, or along t from 1 to 0.
pub(super) fn surface_of(rows: Vec<PolynomialRow>, back: bool) -> Result<RationalBezierSurface> {
    let degree = rows.iter().flat_map(|row| &row.0).map(Polynomial::degree).max().unwrap_or(0).max(1);
    let m = rows.len();
    let mut all = Vec::with_capacity(m * (degree + 1));
    for row in rows {
        let entries = row.0.map(|entry| entry.elevated(degree));
        let at = |j: usize| [0, 1, 2, 3].map(|d: usize| entries[d].coefficients()[j]);
        if back {
            all.extend((0..=degree).rev().map(at));
        } else {
            all.extend((0..=degree).map(at));
        }
    }
    RationalBezierSurface::new([m.saturating_sub(1), degree], all)
}
