//! Folds: where a speed is not positive (`docs/math/volumes.md#folds`).

use super::super::fold::{FoldVerdict, Sign, sign};
use super::{CyclideVolume, corners_at_start, others};
use crate::base::quat::Quat;
use crate::base::vector::Point3;
use crate::warning::{VolumeWarning, Warning};

/// Faces whose lines in one direction all start and end as points are lines themselves where these are shorter than that, relative to the
/// rounding of the speeds: corners are on their circles to 1e-9.
const LINE: f64 = 1e5;

/// Rounding of a speed in units of the products it is a sum of.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

impl CyclideVolume {
    /// Whether the volume folds: it does not if its three speeds are positive, which their Bernstein coefficients prove, those of quarters
    /// where those of the whole do not. Random frames fold most blocks, that of [`VolumeFrame::Auto`](super::VolumeFrame::Auto) few.
    #[must_use]
    pub fn folds(&self) -> FoldVerdict {
        let mut undecided = None;
        for axis in 0..3 {
            // The speed does not depend on its own parameter: the middle of the line.
            let place = |[x, y]: [f64; 2]| {
                let mut at = [0.5; 3];
                let [i, j] = others(axis);
                (at[i], at[j]) = (x, y);
                at
            };
            match sign(&self.speeds[axis], self.rounding) {
                Sign::Positive => {}
                Sign::NotPositive(at) => return FoldVerdict::Folded { at: place(at) },
                Sign::Undecided(at, depth) => {
                    undecided = undecided.or(Some(FoldVerdict::Undecided { at: place(at), depth }));
                }
            }
        }
        undecided.unwrap_or(FoldVerdict::Regular)
    }

    /// What should be known of it: `volume-folds`, `volume-fold-undecided`.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        match self.folds() {
            FoldVerdict::Regular => Vec::new(),
            FoldVerdict::Folded { at } => vec![Warning::Volume(VolumeWarning::Folds { at })],
            FoldVerdict::Undecided { at, depth } => vec![Warning::Volume(VolumeWarning::FoldUndecided { at, depth })],
        }
    }

    /// The directions whose lines stand still at a place, up to rounding: their speed, which is one along the whole line, is zero there. So are lines on
    /// which a side, or a face of a wedge, is one point.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, surface::{CyclidePatch, CyclidicNet}, volume::CyclideGrid};
    /// let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
    /// let octant = CyclidicNet::from(CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z)?); // its pole at t = 1
    /// let wedge = CyclideGrid::layers(&octant, &[0.0, 0.1])?.block([0, 0, 0]);
    /// assert_eq!(wedge.standing_lines([0.3, 1.0, 0.5]), [true, false, false]);
    /// assert_eq!(wedge.standing_lines([0.3, 0.9, 0.5]), [false; 3]);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn standing_lines(&self, at: [f64; 3]) -> [bool; 3] {
        self.speeds_at(at).map(|speed| speed.abs() <= self.rounding)
    }
}

/// Rounding of the speeds: of the products `~w_i (a_j - a_i) w_j`, of rounded corners and weights.
pub(super) fn speed_rounding(corners: &[Point3; 8], weights: &[Quat; 8], scale: f64) -> f64 {
    let weight = weights.iter().map(|w| w.norm_squared()).fold(0.0, f64::max);
    let place = corners.iter().map(|p| p.to_vec().max_abs()).fold(scale, f64::max);
    ROUNDING * weight * place
}

/// Speeds in a direction, those of sides of one point exactly zero; so are those over a face between two such sides that is a line.
pub(super) fn still_at_points(
    mut q: [[f64; 3]; 3],
    corners: &[Point3; 8],
    axis: usize,
    rounding: f64,
) -> [[f64; 3]; 3] {
    let is_point = corners_at_start(axis).map(|k| corners[k] == corners[k | 1 << axis]);
    for (k, _) in is_point.iter().enumerate().filter(|(_, point)| **point) {
        q[2 * (k & 1)][2 * (k >> 1)] = 0.0;
    }
    for (k, l) in [(0, 1), (2, 3), (0, 2), (1, 3)] {
        let between = &mut q[(k & 1) + (l & 1)][(k >> 1) + (l >> 1)];
        if is_point[k] && is_point[l] && between.abs() <= LINE * rounding {
            *between = 0.0;
        }
    }
    q
}
