//! Cells of rational faces: two triangles each, certified by the hulls of second derivatives (see
//! `rational::surface_bounds`), on planes and cylinders by their corners.

use super::cells::{CellDistances, are_cuts};
use super::developable_cells::{Developable, DevelopableCell, chord_distances};
use crate::base::vector::Point3;
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
    let sides = Developable::of(surface).map(|developable| (developable, Sides::new(surface, s, t)));
    let [mut columns, mut rows] = [vec![0.0_f64; s.len() - 1], vec![0.0_f64; t.len() - 1]];
    let mut worst = 0.0_f64;
    for (i, s) in s.windows(2).enumerate() {
        let mut strip = None;
        for (j, t) in t.windows(2).enumerate() {
            let unrolled =
                sides.as_ref().and_then(|(developable, sides)| developable.cell(sides.corners(i, j), sides.off(i, j)));
            let DevelopableCell { distance, along: [along_s, along_t] } = unrolled.unwrap_or_else(|| {
                let strip = strip.get_or_insert_with(|| surface.part([s[0], s[1]], [0.0, 1.0]));
                let bends = strip.part([0.0, 1.0], [t[0], t[1]]).second_derivatives();
                let SecondDerivatives { ss, st, tt } = bends;
                DevelopableCell { distance: bends.distance_from_triangles(), along: [ss + st, tt + st] }
            });
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

/// The corners of the cells of a surface, and what its four sides are off the chords between them.
struct Sides {
    points: Vec<Point3>,
    count: usize,
    /// Along s at both ends of t, along t at both ends of s.
    off: [[Vec<f64>; 2]; 2],
}

impl Sides {
    fn new(surface: &RationalBezierSurface, s: &[f64], t: &[f64]) -> Self {
        let points = t.iter().flat_map(|&t| s.iter().map(move |&s| (s, t))).map(|(s, t)| surface.point(s, t)).collect();
        let along_s = [0.0, 1.0].map(|end| chord_distances(&surface.s_line(end), s));
        let along_t = [0.0, 1.0].map(|end| chord_distances(&surface.t_line(end), t));
        Self { points, count: s.len(), off: [along_s, along_t] }
    }

    fn corners(&self, i: usize, j: usize) -> [Point3; 4] {
        [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)].map(|(i, j)| self.points[i + j * self.count])
    }

    /// What the sides of a cell on the border are off, the largest along s and along t.
    fn off(&self, i: usize, j: usize) -> [f64; 2] {
        let [columns, rows] = self.off.each_ref().map(|sides| sides[0].len());
        let at = |direction: usize, k: usize, across: usize, last: usize| {
            let [first, second] = &self.off[direction];
            let low = if across == 0 { first[k] } else { 0.0 };
            if across + 1 == last { low.max(second[k]) } else { low }
        };
        [at(0, i, j, rows), at(1, j, i, columns)]
    }
}
