//! Coordinates whose lines follow the principal directions: two least-squares problems, each aligned with one family and only spread
//! along the other.

use super::sheet::Sheet;
use crate::base::vector::Vec3;
use crate::construct::sparse_solver::SymmetricSum;

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

/// What is known of the seam: the corners on its left, and the directions whose period is to be found (others have none).
pub(super) struct Seam<'a> {
    pub(super) left: &'a [bool],
    pub(super) free: [bool; 2],
}

/// Gradients of the three barycentric coordinates of a triangle.
pub(super) fn gradients(sheet: &Sheet<'_>, f: usize) -> [Vec3; 3] {
    let (normal, double) = (sheet.table.normals[f], 2.0 * sheet.table.areas[f]);
    std::array::from_fn(|k| normal.cross(sheet.table.vector(3 * f + (k + 1) % 3)) / double)
}

/// `None` if a system has no solution in doubles.
pub(super) fn coordinates(sheet: &Sheet<'_>, weights: &[f64], seam: Option<&Seam<'_>>) -> Option<Coordinates> {
    let (places, count) = sheet.places();
    let (parts, part_count) = sheet.parts();
    let active = || (0..sheet.active.len()).filter(|f| sheet.active[*f]);
    let mut result = Coordinates { corners: vec![[[0.0; 2]; 3]; sheet.active.len()], periods: [0.0; 2] };
    for d in 0..2 {
        let period = seam.is_some_and(|seam| seam.free[d]).then_some(count);
        let size = count + usize::from(period.is_some());
        let mut sum = SymmetricSum::new(size);
        let mut right = vec![0.0; size];
        let mut fixed = vec![false; part_count];
        for f in active() {
            let [along, across] = [sheet.directions[f][d], sheet.directions[f][1 - d]];
            let weight = sheet.table.areas[f] * weights[f].clamp(WEIGHTS[0], WEIGHTS[1]);
            let gradients = gradients(sheet, f);
            let terms = |direction: Vec3| {
                let mut terms = Vec::with_capacity(6);
                for k in 0..3 {
                    let slope = gradients[k].dot(direction);
                    terms.push((places[3 * f + k], slope));
                    if let (Some(period), Some(seam)) = (period, seam)
                        && seam.left[3 * f + k]
                    {
                        terms.push((period, slope));
                    }
                }
                terms
            };
            sum.add_square(&terms(across), weight);
            let spread = terms(along);
            sum.add_square(&spread, SPREAD * weight);
            spread.iter().for_each(|(k, slope)| right[*k] += SPREAD * weight * slope);
        }
        let mean = sum.mean_diagonal();
        for f in active() {
            if !fixed[parts[f]] {
                // The constant, which nothing else fixes.
                fixed[parts[f]] = true;
                sum.add(places[3 * f], places[3 * f], mean);
            }
        }
        // Corners of triangles left out.
        let mut used = vec![false; size];
        active().for_each(|f| (0..3).for_each(|k| used[places[3 * f + k]] = true));
        period.into_iter().for_each(|k| used[k] = true);
        used.iter().enumerate().filter(|(_, used)| !**used).for_each(|(k, _)| sum.add(k, k, mean));
        sum.factor()?.solve(&mut right)?;
        result.periods[d] = period.map_or(0.0, |k| right[k]);
        for f in active() {
            for k in 0..3 {
                let turn = seam.is_some_and(|seam| seam.left[3 * f + k]);
                result.corners[f][k][d] = right[places[3 * f + k]] + if turn { result.periods[d] } else { 0.0 };
            }
        }
    }
    Some(result)
}

impl Coordinates {
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

    /// Leaves out the triangles that are turned over, or whose lines are far off the directions.
    pub(super) fn leave_out_bad(&self, sheet: &mut Sheet<'_>) {
        for f in 0..sheet.active.len() {
            let [u, v] = self.slopes(sheet, f);
            let turned_over = !(u.cross(v).dot(sheet.table.normals[f]) > 0.0);
            let off = [u, v].iter().zip(sheet.directions[f]).any(|(slope, d)| !(slope.angle(d) <= MOST_OFF));
            if turned_over || off {
                sheet.active[f] = false;
            }
        }
    }
}
