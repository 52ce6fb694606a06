//! Points that are one but for rounding: between them edges and faces would have directions of rounding.

use super::hull;
use crate::base::bounds::Aabb;
use crate::base::vector::Point3;
use crate::error::{Error, Result};
use std::collections::HashMap;

/// Cells are not smaller than this part of the size of all points: places in them are integers.
const SMALLEST_CELL: f64 = 1e-15;

/// The points that are farther from each other than a distance.
pub(super) struct Distinct {
    kept: Vec<usize>,
    within: f64,
    /// The largest distance of another point from one that is kept.
    pub(super) farthest: f64,
}

impl Distinct {
    /// The first of all points that are within a distance of one that is kept, so that no two of these are.
    pub(super) fn new(points: &[Point3], within: f64) -> Self {
        let mut distinct = Self { kept: Vec::with_capacity(points.len()), within, farthest: 0.0 };
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
            let nearest = near.flatten().map(|&k| points[k].distance(p)).fold(f64::INFINITY, f64::min);
            if nearest <= within {
                distinct.farthest = distinct.farthest.max(nearest);
            } else {
                cells.entry(cell).or_default().push(index);
                distinct.kept.push(index);
            }
        }
        distinct
    }

    /// The triangles of the hull of those that are kept, by the numbers of all.
    ///
    /// # Errors
    /// `flat-polyhedron`.
    pub(super) fn hull(&self, points: &[Point3]) -> Result<Vec<Vec<usize>>> {
        if self.kept.len() < 4 {
            return Err(Error::FlatPolyhedron { thickness: self.farthest, limit: self.within });
        }
        let kept: Vec<Point3> = self.kept.iter().map(|&k| points[k]).collect();
        let triangles = hull::triangles(&kept)?;
        Ok(triangles.into_iter().map(|corners| corners.into_iter().map(|k| self.kept[k]).collect()).collect())
    }
}
