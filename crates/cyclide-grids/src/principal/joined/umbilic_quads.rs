//! The quads round umbilics, added to those that walks find.

use super::super::cross_field::SingularVertex;
use super::super::point_grid::PointGrid;
use super::completion::{Filling, filling};
use super::{Surface, quad_borders};
use cyclide::{Point3, Vec3};
use std::collections::HashSet;

/// How often quads that walks found round an umbilic are taken away, where they do not go round it as they should.
const MOST_ROUNDS: usize = 4;
/// Rounds in which vertices that are made up go to the middle of their neighbors.
const AVERAGED: usize = 200;

/// Points, and quads by their corners counter-clockwise.
pub(super) struct QuadMesh {
    pub(super) points: Vec<Point3>,
    pub(super) quads: Vec<[usize; 4]>,
}

impl QuadMesh {
    pub(super) fn new(points: Vec<Point3>, mut quads: Vec<[usize; 4]>) -> Self {
        quad_borders::drop_loose(&mut quads);
        Self { points, quads }
    }

    /// Fills the loop of the border round an umbilic: the vertex there, and how many quads more than those at it. `None` where no loop
    /// goes round it as lines of curvature do, as near the border.
    pub(super) fn fill_round(
        &mut self,
        umbilic: SingularVertex,
        surface: &Surface<'_>,
        edge: f64,
    ) -> Option<(usize, usize)> {
        let around = (4 - 2 * umbilic.halves).unsigned_abs() as usize;
        let centre = surface.table.points[umbilic.vertex];
        for _ in 0..MOST_ROUNDS {
            let counts = quad_borders::counts(&self.quads, self.points.len());
            let turns = |border: &[usize]| border.iter().map(|v| counts[*v] as i64 - 2).sum::<i64>();
            let off = |border: &[usize]| self.middle(border).distance(centre);
            let border = quad_borders::loops(&self.quads)
                .into_iter()
                .filter(|border| turns(border) == around as i64)
                .min_by(|a, b| off(a).total_cmp(&off(b)))?;
            if let Some(filling) = filling(&border, &counts, around, self.points.len()) {
                let (vertex, more) = (self.points.len(), filling.quads.len() - around);
                self.add(filling, centre, surface, edge);
                return Some((vertex, more));
            }
            let on: HashSet<usize> = border.into_iter().collect();
            self.quads.retain(|quad| !quad.iter().any(|v| on.contains(v)));
            quad_borders::drop_loose(&mut self.quads);
        }
        None
    }

    fn middle(&self, vertices: &[usize]) -> Point3 {
        let sum = vertices.iter().fold(Vec3::ZERO, |sum, v| sum + self.points[*v].to_vec());
        Point3::ORIGIN + sum / vertices.len() as f64
    }

    /// The new vertices, except the umbilic, lie between their neighbors and on the surface.
    fn add(&mut self, filling: Filling, centre: Point3, surface: &Surface<'_>, edge: f64) {
        let first = self.points.len();
        self.points.extend((0..filling.new).map(|_| centre));
        let mut neighbors: Vec<Vec<usize>> = vec![Vec::new(); filling.new];
        for quad in &filling.quads {
            for k in 0..4 {
                let [a, b] = [quad[k], quad[(k + 1) % 4]];
                if a >= first {
                    neighbors[a - first].push(b);
                }
                if b >= first {
                    neighbors[b - first].push(a);
                }
            }
        }
        for _ in 0..AVERAGED {
            for (k, neighbors) in neighbors.iter().enumerate().skip(1) {
                self.points[first + k] = self.middle(neighbors);
            }
        }
        let near = PointGrid::new(&surface.table.points, edge);
        for p in &mut self.points[first + 1..] {
            let nearest = near.nearest(*p, 1);
            *p = nearest.first().and_then(|(_, v)| surface.jets[*v].above(*p)).unwrap_or(*p);
        }
        self.quads.extend(filling.quads);
    }

    /// Whether a quad, but for those at umbilics, is turned over at a corner.
    pub(super) fn is_folded(&self, umbilics: &[(usize, usize)], surface: &Surface<'_>, edge: f64) -> bool {
        let near = PointGrid::new(&surface.table.points, edge);
        let at_umbilic: HashSet<usize> = umbilics.iter().map(|(v, _)| *v).collect();
        let quads = self.quads.iter().filter(|quad| !quad.iter().any(|v| at_umbilic.contains(v)));
        quads.into_iter().any(|quad| {
            let corners = quad.map(|v| self.points[v]);
            let Some((_, v)) = near.nearest(self.middle(quad), 1).first().copied() else { return true };
            let normal = surface.jets[v].normal();
            (0..4).any(|k| {
                let [here, on, back] = [k, (k + 1) % 4, (k + 3) % 4].map(|k| corners[k]);
                !((on - here).cross(back - here).dot(normal) > 0.0)
            })
        })
    }

    /// With the vertices that quads use only; those of umbilics, the first of each pair, get their new numbers.
    pub(super) fn of_used(self, umbilics: &mut Vec<(usize, usize)>) -> Self {
        let mut number: Vec<Option<usize>> = vec![None; self.points.len()];
        let mut points = Vec::new();
        let mut quads = self.quads;
        for v in quads.iter_mut().flatten() {
            *v = *number[*v].get_or_insert_with(|| {
                points.push(self.points[*v]);
                points.len() - 1
            });
        }
        *umbilics = umbilics.iter().filter_map(|(v, umbilic)| Some((number[*v]?, *umbilic))).collect();
        Self { points, quads }
    }
}
