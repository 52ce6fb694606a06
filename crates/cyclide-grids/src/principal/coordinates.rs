//! Coordinates whose lines follow the principal directions: two least-squares problems, each aligned with one family and only spread
//! along the other.

use super::sheet::Sheet;
use super::unknowns::Unknowns;
use crate::sparse_solver::SymmetricSum;
use cyclide::Vec3;

/// Weight of the spreading against the aligning.
const SPREAD: f64 = 0.01;
/// Weights of triangles lie between these.
const WEIGHTS: [f64; 2] = [0.01, 4.0];
/// Triangles whose coordinate lines are farther off the principal directions are left out: 30 degrees.
const MOST_OFF: f64 = std::f64::consts::PI / 6.0;

/// Coordinates of the corners of triangles.
pub(super) struct Coordinates {
    /// Of each corner of each triangle.
    pub(super) corners: Vec<[[f64; 2]; 3]>,
    /// What is added on the left of the seam.
    pub(super) periods: [f64; 2],
}

/// Gradients of the three barycentric coordinates of a triangle.
pub(super) fn gradients(sheet: &Sheet<'_>, f: usize) -> [Vec3; 3] {
    let (normal, double) = (sheet.table.normals[f], 2.0 * sheet.table.areas[f]);
    std::array::from_fn(|k| normal.cross(sheet.table.vector(3 * f + (k + 1) % 3)) / double)
}

/// Coordinates of an open surface, or of one with a seam: the corners on its left, and the directions whose period is to be found
/// (others have none). `None` if a system has no solution in doubles.
pub(super) fn coordinates(
    sheet: &Sheet<'_>,
    weights: &[f64],
    seam: Option<(&[bool], [bool; 2])>,
) -> Option<Coordinates> {
    let weights = Weights::new(weights, WEIGHTS[0]);
    let mut result = Coordinates { corners: vec![[[0.0; 2]; 3]; sheet.active.len()], periods: [0.0; 2] };
    for d in 0..2 {
        let mut unknowns = Unknowns::new(sheet);
        let period = seam.filter(|(_, free)| free[d]).map(|(left, _)| unknowns.add_period(left));
        let values = solved(sheet, &weights, &unknowns, d, &[])?;
        result.periods[d] = period.map_or(0.0, |k| values[k]);
        result.set(sheet, &unknowns, d, &values);
    }
    Some(result)
}

/// Weights of the triangles by their area, of both terms.
pub(super) struct Weights {
    pub(super) aligning: Vec<f64>,
    pub(super) spreading: Vec<f64>,
}

impl Weights {
    /// `evenness` is the least weight that spreading is reckoned by.
    pub(super) fn new(weights: &[f64], evenness: f64) -> Self {
        let aligning: Vec<f64> = weights.iter().map(|w| w.clamp(WEIGHTS[0], WEIGHTS[1])).collect();
        let spreading = aligning.iter().map(|w| SPREAD * w.max(evenness)).collect();
        Self { aligning, spreading }
    }
}

/// An unknown that is another one plus a number.
pub(super) struct Tie {
    pub(super) unknown: usize,
    pub(super) to: usize,
    pub(super) offset: f64,
}

/// The unknowns of one coordinate; `None` if there is no solution in doubles.
pub(super) fn solved(
    sheet: &Sheet<'_>,
    weights: &Weights,
    unknowns: &Unknowns,
    d: usize,
    ties: &[Tie],
) -> Option<Vec<f64>> {
    let active = || (0..sheet.active.len()).filter(|f| sheet.active[*f]);
    let size = unknowns.count;
    let mut sum = SymmetricSum::new(size);
    let mut right = vec![0.0; size];
    let mut tied: Vec<(usize, f64)> = (0..size).map(|k| (k, 0.0)).collect();
    ties.iter().for_each(|tie| tied[tie.unknown] = (tie.to, tie.offset));
    for f in active() {
        let [along, across] = [sheet.directions[f][d], sheet.directions[f][1 - d]];
        let area = sheet.table.areas[f];
        let gradients = gradients(sheet, f);
        let mut add = |direction: Vec3, weight: f64, wanted: f64| {
            let (mut terms, mut rest) = (Vec::with_capacity(6), wanted);
            for (k, gradient) in gradients.iter().enumerate() {
                let slope = gradient.dot(direction);
                for (unknown, factor) in unknowns.terms(3 * f + k) {
                    let (unknown, offset) = tied[unknown];
                    terms.push((unknown, slope * factor));
                    rest -= slope * factor * offset;
                }
            }
            sum.add_square(&terms, weight);
            terms.iter().for_each(|(k, slope)| right[*k] += weight * slope * rest);
        };
        add(across, weights.aligning[f] * area, 0.0);
        add(along, weights.spreading[f] * area, 1.0);
    }
    let mean = sum.mean_diagonal();
    let mut fixed = vec![false; unknowns.part_count];
    let mut used = vec![false; size];
    for f in active() {
        if !fixed[unknowns.parts[f]] {
            // The constant, which nothing else fixes.
            fixed[unknowns.parts[f]] = true;
            let place = tied[unknowns.places[3 * f].place].0;
            sum.add(place, place, mean);
        }
        (0..3).flat_map(|k| unknowns.terms(3 * f + k)).for_each(|(k, _)| used[tied[k].0] = true);
    }
    // Corners of triangles left out, and what is tied to others.
    used.iter().enumerate().filter(|(_, used)| !**used).for_each(|(k, _)| sum.add(k, k, mean));
    sum.factor()?.solve(&mut right)?;
    ties.iter().for_each(|tie| right[tie.unknown] = right[tie.to] + tie.offset);
    Some(right)
}

impl Coordinates {
    /// One coordinate of all corners.
    pub(super) fn set(&mut self, sheet: &Sheet<'_>, unknowns: &Unknowns, d: usize, values: &[f64]) {
        for f in (0..sheet.active.len()).filter(|f| sheet.active[*f]) {
            for k in 0..3 {
                self.corners[f][k][d] = unknowns.terms(3 * f + k).map(|(k, factor)| factor * values[k]).sum();
            }
        }
    }

    /// Gradients of both coordinates on a triangle.
    pub(super) fn slopes(&self, sheet: &Sheet<'_>, f: usize) -> [Vec3; 2] {
        let gradients = gradients(sheet, f);
        [0, 1].map(|d| (0..3).fold(Vec3::ZERO, |sum, k| sum + gradients[k] * self.corners[f][k][d]))
    }

    /// How fast a coordinate grows along its gradient, the mean over the area.
    pub(super) fn mean_speed(&self, sheet: &Sheet<'_>, d: usize) -> f64 {
        let areas = &sheet.table.areas;
        let active = || (0..sheet.active.len()).filter(|f| sheet.active[*f]);
        let sum: f64 = active().map(|f| areas[f] * self.slopes(sheet, f)[d].length()).sum();
        sum / active().map(|f| areas[f]).sum::<f64>()
    }

    /// Whether a triangle is turned over.
    pub(super) fn is_folded(&self, sheet: &Sheet<'_>, f: usize) -> bool {
        let [u, v] = self.slopes(sheet, f);
        !(u.cross(v).dot(sheet.table.normals[f]) > 0.0)
    }

    /// The largest angle of a coordinate line of a triangle to its principal direction.
    pub(super) fn angle_off(&self, sheet: &Sheet<'_>, f: usize) -> f64 {
        let angles = self.slopes(sheet, f).into_iter().zip(sheet.directions[f]).map(|(slope, d)| slope.angle(d));
        angles.fold(0.0, |largest, angle| if angle <= largest { largest } else { angle })
    }

    /// Leaves out the triangles that are turned over.
    pub(super) fn leave_out_folded(&self, sheet: &mut Sheet<'_>) {
        for f in 0..sheet.active.len() {
            sheet.active[f] &= !self.is_folded(sheet, f);
        }
    }

    /// Leaves out the triangles that are turned over, or whose lines are far off the directions.
    pub(super) fn leave_out_bad(&self, sheet: &mut Sheet<'_>) {
        self.leave_out_folded(sheet);
        for f in 0..sheet.active.len() {
            if !(self.angle_off(sheet, f) <= MOST_OFF) {
                sheet.active[f] = false;
            }
        }
    }
}
