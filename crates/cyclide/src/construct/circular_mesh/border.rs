//! What border vertices may do: the directions of their moves, and the way back to their curve after a move.

use super::block::Block;
use super::options::Border;
use crate::base::vector::Point3;
use crate::curve::{CurveIndex, ParamCurve};
use crate::surface::QuadGrid;

/// What holds one vertex.
#[derive(Clone, Copy, PartialEq)]
enum Hold {
    Free,
    Pinned,
    /// Slides on the curve of this index.
    Curve(usize),
}

/// The vertices of the grid with what holds them. Positions here are those of the search: `(x - origin) / scale`.
pub(super) struct Holds<'a> {
    holds: Vec<Hold>,
    curves: Vec<(&'a dyn ParamCurve, CurveIndex<'a>)>,
    origin: Point3,
    scale: f64,
}

impl<'a> Holds<'a> {
    pub(super) fn new(grid: &QuadGrid, border: Border<'a>, origin: Point3, scale: f64) -> Self {
        let mut holds = vec![Hold::Free; grid.points().len()];
        let mut curves = Vec::new();
        match border {
            Border::Free => {}
            Border::Pinned => {
                for v in (0..4).flat_map(|side| side_vertices(grid, side)) {
                    holds[v] = Hold::Pinned;
                }
            }
            Border::OnCurves(sides) => {
                for (side, curve) in sides.into_iter().enumerate() {
                    let Some(curve) = curve else { continue };
                    for v in side_vertices(grid, side) {
                        holds[v] = if holds[v] == Hold::Free { Hold::Curve(curves.len()) } else { Hold::Pinned };
                    }
                    curves.push((curve, CurveIndex::new(curve)));
                }
            }
        }
        Self { holds, curves, origin, scale }
    }

    pub(super) fn is_pinned(&self, v: usize) -> bool {
        self.holds[v] == Hold::Pinned
    }

    pub(super) fn is_free(&self, v: usize) -> bool {
        self.holds[v] == Hold::Free
    }

    /// The vertices of curves at the nearest point of their curve.
    pub(super) fn settle(&self, points: &mut [Point3]) {
        for (hold, p) in self.holds.iter().zip(points) {
            if let Hold::Curve(k) = *hold {
                let world = self.origin + p.to_vec() * self.scale;
                let nearest = self.curves[k].1.closest_point(world).point;
                *p = Point3::ORIGIN + (nearest - self.origin) / self.scale;
            }
        }
    }

    /// The moves each vertex may make to first order: all, none, or along the tangent of its curve.
    pub(super) fn projectors(&self, points: &[Point3]) -> Vec<Block> {
        let projector = |(hold, p): (&Hold, &Point3)| match *hold {
            Hold::Free => Block::IDENTITY,
            Hold::Pinned => Block::ZERO,
            Hold::Curve(k) => {
                let (curve, index) = &self.curves[k];
                let t = index.closest_point(self.origin + p.to_vec() * self.scale).t;
                curve.jet(t).d1.unit().map_or(Block::ZERO, Block::square)
            }
        };
        self.holds.iter().zip(points).map(projector).collect()
    }
}

/// Vertices of a side of the grid (t=0, t=1, s=0, s=1); none in a closed direction.
fn side_vertices(grid: &QuadGrid, side: usize) -> Vec<usize> {
    let [m, n] = grid.size();
    if grid.closed()[1 - side / 2] {
        return Vec::new();
    }
    match side {
        0 => (0..m).map(|i| grid.index(i, 0)).collect(),
        1 => (0..m).map(|i| grid.index(i, n - 1)).collect(),
        2 => (0..n).map(|j| grid.index(0, j)).collect(),
        _ => (0..n).map(|j| grid.index(m - 1, j)).collect(),
    }
}
