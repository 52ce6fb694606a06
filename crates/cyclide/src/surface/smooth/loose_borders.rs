//! Borders of a mesh that lie on each other without being joined: triangles whose vertices are nearly the same, vertices inside an
//! edge of a neighbor.

use super::SmoothMesh;
use crate::base::bounds::Aabb;
use crate::base::vector::Point3;
use crate::warning::{MeshWarning, Warning};
use std::collections::HashMap;

/// A border edge whose middle is nearer to another one than this part of its length lies on it.
const NEAR: f64 = 0.01;
/// Edges that reach over more cells of the grid are not put into it: all are compared with them.
const MOST_CELLS: f64 = 64.0;
/// Comparisons for an edge on average, after which nothing is said.
const MOST_COMPARED: usize = 256;

/// A border edge.
struct Border {
    vertices: [usize; 2],
    ends: [Point3; 2],
}

impl SmoothMesh {
    /// Border edges whose middles lie on other ones.
    pub(super) fn loose_borders(&self) -> Option<Warning> {
        let free = self.edges.iter().filter(|edge| edge.second.is_none());
        let borders: Vec<Border> = free
            .map(|edge| Border { vertices: edge.vertices, ends: edge.vertices.map(|v| self.positions[v]) })
            .collect();
        let grid = Grid::new(&borders)?;
        let mut compared = MOST_COMPARED * (borders.len() + 64);
        let (mut count, mut gap, mut first) = (0, 0.0, None);
        for (index, border) in borders.iter().enumerate() {
            let near = grid.nearest(&borders, index, NEAR * border.length(), &mut compared)?;
            if let Some(distance) = near {
                count += 1;
                gap = distance.max(gap);
                first.get_or_insert(border.vertices);
            }
        }
        Some(Warning::Mesh(MeshWarning::LooseBorders { vertices: first?, count, borders: borders.len(), gap }))
    }
}

impl Border {
    fn length(&self) -> f64 {
        self.ends[0].distance(self.ends[1])
    }

    fn distance(&self, p: Point3) -> f64 {
        let [a, b] = self.ends;
        let (way, chord) = (p - a, b - a);
        let along = (way.dot(chord) / chord.length_squared()).clamp(0.0, 1.0);
        (way - chord * along).length()
    }
}

/// Edges by the cells that their boxes reach.
struct Grid {
    origin: Point3,
    cell: f64,
    edges: HashMap<[i64; 3], Vec<usize>>,
    long: Vec<usize>,
}

impl Grid {
    /// With cells of the median length; none without edges.
    fn new(borders: &[Border]) -> Option<Self> {
        let bounds = Aabb::of_points(borders.iter().flat_map(|border| border.ends))?;
        let mut lengths: Vec<f64> = borders.iter().map(Border::length).collect();
        let middle = lengths.len() / 2;
        let cell = *lengths.select_nth_unstable_by(middle, f64::total_cmp).1;
        let mut grid = Self { origin: bounds.min, cell, edges: HashMap::new(), long: Vec::new() };
        for (index, border) in borders.iter().enumerate() {
            let [a, b] = border.ends;
            let [low, high] = grid.range(Aabb::of_point(a).including(b), 0.0);
            let cells: f64 = (0..3).map(|k| (high[k] - low[k]) as f64 + 1.0).product();
            if cells > MOST_CELLS {
                grid.long.push(index);
            } else {
                each_cell(low, high, |key| grid.edges.entry(key).or_default().push(index));
            }
        }
        Some(grid)
    }

    /// The cells of a box and a margin.
    fn range(&self, bounds: Aabb, margin: f64) -> [[i64; 3]; 2] {
        // Casts saturate: cells far out are one.
        let index = |p: Point3, out: f64| (p - self.origin).to_array().map(|x| ((x + out) / self.cell).floor() as i64);
        let [low, high] = [index(bounds.min, -margin), index(bounds.max, margin)];
        // Differences stay in range.
        [low, high].map(|key| key.map(|k| k.clamp(i64::MIN / 4, i64::MAX / 4)))
    }

    /// The distance of the middle of an edge from the nearest other one within a limit. `None` where too much would have to be compared.
    #[expect(clippy::option_option, reason = "nothing near is an answer, too much work is none")]
    fn nearest(&self, borders: &[Border], index: usize, within: f64, left: &mut usize) -> Option<Option<f64>> {
        let [a, b] = borders[index].ends;
        let middle = a.midpoint(b);
        let [low, high] = self.range(Aabb::of_point(middle), within);
        let mut candidates = self.long.clone();
        if (0..3).any(|k| high[k] - low[k] > 3) {
            return None;
        }
        each_cell(low, high, |key| candidates.extend(self.edges.get(&key).into_iter().flatten()));
        *left = left.checked_sub(candidates.len())?;
        let others = candidates.into_iter().filter(|&other| other != index);
        let nearest = others.map(|other| borders[other].distance(middle)).fold(f64::INFINITY, f64::min);
        Some((nearest <= within).then_some(nearest))
    }
}

fn each_cell(low: [i64; 3], high: [i64; 3], mut cell: impl FnMut([i64; 3])) {
    for x in low[0]..=high[0] {
        for y in low[1]..=high[1] {
            (low[2]..=high[2]).for_each(|z| cell([x, y, z]));
        }
    }
}
