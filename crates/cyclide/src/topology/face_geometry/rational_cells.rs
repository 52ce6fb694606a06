//! Cells of rational faces: two triangles each, certified by the hulls of second derivatives (see
//! `rational::surface_bounds`).

use super::cells::{CellDistances, are_cuts};
use crate::rational::{RationalBezierSurface, SecondDerivatives};

/// A direction in which the surface bends by less than this part of the other is not cut for the deviation of a cell.
const SMALL_BEND: f64 = 0.125;

/// The certified distances between a surface cut at the given parameters and the triangles over the corners of its cells.
pub(super) fn grid_distances(surface: &RationalBezierSurface, s: &[f64], t: &[f64], tolerance: f64) -> CellDistances {
    if !(are_cuts(s) && are_cuts(t)) {
        return CellDistances::unknown([s, t]);
    }
    if surface.is_plane_quad() {
        // Cells are quads in the plane, whose triangles cover them.
        return CellDistances::even([s, t], 0.0, 0.0);
    }
    let [mut columns, mut rows] = [vec![0.0_f64; s.len() - 1], vec![0.0_f64; t.len() - 1]];
    let mut worst = 0.0_f64;
    for (i, s) in s.windows(2).enumerate() {
        let strip = surface.part([s[0], s[1]], [0.0, 1.0]);
        for (j, t) in t.windows(2).enumerate() {
            let bends = strip.part([0.0, 1.0], [t[0], t[1]]).second_derivatives();
            let distance = bends.distance_from_triangles();
            let SecondDerivatives { ss, st, tt } = bends;
            let (along_s, along_t) = (ss + st, tt + st);
            // Larger than all others, also where nothing is known.
            worst = worst.max(if distance.is_nan() { f64::INFINITY } else { distance });
            if !(along_s < SMALL_BEND * along_t) {
                columns[i] = columns[i].max(distance);
            }
            if !(along_t < SMALL_BEND * along_s) {
                rows[j] = rows[j].max(distance);
            }
        }
    }
    // Distances fall with the square of the number of cuts.
    let excess = |distances: Vec<f64>| distances.into_iter().map(|distance| (distance / tolerance).sqrt()).collect();
    CellDistances { distance: worst, excess: [excess(columns), excess(rows)] }
}
