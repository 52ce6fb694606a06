//! Points that are one but for rounding: between them edges and faces would have directions of rounding.

use super::hull;
use crate::base::bounds::Aabb;
use crate::base::vector::Point3;
use crate::error::{PolyhedronError, Result};
use std::collections::HashMap;

/// Cells are not smaller than this part of the size of all points: places in them are integers.
const SMALLEST_CELL: f64 = 1e-15;

/// The points that are farther from each other than a distance, and the others.
pub(super) struct Distinct {
    kept: Vec<usize>,
    /// Points that are left out, each with one that is kept and within the distance.
    pub(super) dropped: Vec<[usize; 2]>,
    /// The distance.
    within: f64,
}

impl Distinct {
    /// The first of all points that are within a distance of one that is kept, so that no two of these are.
    pub(super) fn new(points: &[Point3], within: f64) -> Self {
        let mut distinct = Self { kept: Vec::with_capacity(points.len()), dropped: Vec::new(), within };
        let Some(bounds) = Aabb::of_points(points.iter().copied()) else { return distinct };
        let size = within.max(SMALLEST_CELL * bounds.diagonal());
        let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::with_capacity(points.len());
        for (index, &p) in points.iter().enumerate() {
            let cell = (p - bounds.min).to_array().map(|v| (v / size).floor() as i64);
            let near = (0..27).filter_map(|k| {
                let step = [k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1];
                let [x, y, z] = [0, 1, 2].map(|c| cell[c].saturating_add(step[c]));
                cells.get(&[x, y, z])
            });
            let nearest = near.flatten().map(|&k| (points[k].distance(p), k)).min_by(|a, b| a.0.total_cmp(&b.0));
            match nearest {
                Some((distance, other)) if distance <= within => distinct.dropped.push([index, other]),
                _ => {
                    cells.entry(cell).or_default().push(index);
                    distinct.kept.push(index);
                }
            }
        }
        distinct
    }

    /// The triangles of the hull of those that are kept, by the numbers of all.
    ///
    /// # Errors
    /// `flat-polyhedron`.
    pub(super) fn hull(&self, points: &[Point3]) -> Result<Vec<Vec<usize>>> {
        // Of fewer than four places all are in one plane, and the others as near to it as to them.
        if self.kept.len() < 4 {
            let off = self.dropped.iter().map(|&[index, other]| points[index].distance(points[other]));
            return Err(PolyhedronError::Flat { thickness: off.fold(0.0, f64::max), limit: self.within }.into());
        }
        let kept: Vec<Point3> = self.kept.iter().map(|&k| points[k]).collect();
        let triangles = hull::triangles(&kept)?;
        Ok(triangles.into_iter().map(|corners| corners.into_iter().map(|k| self.kept[k]).collect()).collect())
    }
}
