//! The points near a place: a hash of cubes that hold a few points each.

use std::collections::HashMap;

use cyclide::Aabb;
use cyclide::Point3;

/// Shells of cubes that are searched one after the other; if the points are not found in them, all points are looked at.
const MOST_SHELLS: i64 = 24;

pub(super) struct PointGrid<'a> {
    points: &'a [Point3],
    origin: Point3,
    cell: f64,
    cells: HashMap<[i64; 3], Vec<usize>>,
}

impl<'a> PointGrid<'a> {
    /// Grid of cubes with this side, which should be near the distance of neighbors.
    pub(super) fn new(points: &'a [Point3], cell: f64) -> Self {
        let origin = Aabb::of_points(points.iter().copied()).map_or(Point3::ORIGIN, |b| b.min);
        let mut grid = Self { points, origin, cell, cells: HashMap::with_capacity(points.len()) };
        for (index, p) in points.iter().enumerate() {
            grid.cells.entry(grid.key(*p)).or_default().push(index);
        }
        grid
    }

    fn key(&self, p: Point3) -> [i64; 3] {
        // The cast saturates.
        ((p - self.origin) / self.cell).to_array().map(|x| x.floor() as i64)
    }

    /// The `count` nearest points (all, if there are fewer) with their distances, the nearest first; of equally near ones those that come
    /// first.
    pub(super) fn nearest(&self, p: Point3, count: usize) -> Vec<(f64, usize)> {
        let count = count.min(self.points.len());
        let mut found: Vec<(f64, usize)> = Vec::new();
        for shell in 0..MOST_SHELLS {
            self.in_shell(p, shell, &mut |index| found.push((p.distance(self.points[index]), index)));
            // Whatever is nearer than this many cubes has been seen.
            let seen = shell as f64 * self.cell;
            if found.iter().filter(|(distance, _)| *distance <= seen).count() >= count {
                return first(found, count);
            }
        }
        first(self.points.iter().enumerate().map(|(index, q)| (p.distance(*q), index)).collect(), count)
    }

    /// True if a point is nearer than a distance of one or two cubes.
    pub(super) fn is_near(&self, p: Point3, distance: f64) -> bool {
        let shells = (distance / self.cell).ceil().min(MOST_SHELLS as f64) as i64;
        let mut near = false;
        for shell in 0..=shells {
            self.in_shell(p, shell, &mut |index| near |= p.distance(self.points[index]) < distance);
        }
        near
    }

    fn in_shell(&self, p: Point3, shell: i64, visit: &mut dyn FnMut(usize)) {
        let [x, y, z] = self.key(p);
        for dx in -shell..=shell {
            for dy in -shell..=shell {
                let on_side = dx.abs() == shell || dy.abs() == shell;
                let step = if on_side || shell == 0 { 1 } else { 2 * shell as usize };
                for dz in (-shell..=shell).step_by(step) {
                    let key = [x.saturating_add(dx), y.saturating_add(dy), z.saturating_add(dz)];
                    self.cells.get(&key).into_iter().flatten().for_each(|&index| visit(index));
                }
            }
        }
    }
}

fn first(mut found: Vec<(f64, usize)>, count: usize) -> Vec<(f64, usize)> {
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    found.truncate(count);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_what_a_look_at_all_points_finds() {
        // Points of a helix, uneven along it.
        let points: Vec<Point3> = (0..400)
            .map(|k| {
                let t = 0.01 * f64::from(k) + 0.004 * f64::from(k * k % 17);
                Point3::new(t.cos(), t.sin(), 0.1 * t)
            })
            .collect();
        for cell in [0.01, 0.1, 10.0] {
            let grid = PointGrid::new(&points, cell);
            for p in points.iter().step_by(37) {
                let all = first(points.iter().enumerate().map(|(k, q)| (p.distance(*q), k)).collect(), 24);
                assert_eq!(grid.nearest(*p, 24), all);
            }
            let off = points[7] + cyclide::Vec3::X * 0.05;
            let least = points.iter().map(|p| p.distance(off)).fold(f64::INFINITY, f64::min);
            assert!(grid.is_near(off, least * 1.001) && !grid.is_near(off, least * 0.999));
        }
        assert_eq!(PointGrid::new(&points, 1.0).nearest(points[0], 1000).len(), 400);
    }
}
