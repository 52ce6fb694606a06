//! What border vertices may do: the directions of their moves, and the way back to their curve after a move.

use super::block::Block;
use super::options::Border;
use cyclide::curve::{CurveIndex, ParamCurve};
use cyclide::surface::QuadGrid;
use cyclide::{Error, Result, error::GridError};
use cyclide::{Point3, Vec3};

/// Two curves meet where they come as close as this part of the median edge.
const MEETING: f64 = 1e-9;
/// Rounds of projections from one curve to the other in search of their common point.
const PROJECTIONS: usize = 1000;

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
                for v in grid.border_vertices() {
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

    /// Of vertices of which some are held where they are.
    pub(super) fn pinned(held: &[bool]) -> Self {
        let holds = held.iter().map(|held| if *held { Hold::Pinned } else { Hold::Free }).collect();
        Self { holds, curves: Vec::new(), origin: Point3::ORIGIN, scale: 1.0 }
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

impl Holds<'_> {
    /// Holds the vertices at the end of an open curve that would move beyond it; true if there are any. Without this
    /// they would be brought back each time, and the other vertices never get the moves that suit.
    pub(super) fn stop_at_ends(&self, points: &[Point3], moves: &[Vec3], projectors: &mut [Block]) -> bool {
        let mut any = false;
        for (v, hold) in self.holds.iter().enumerate() {
            let Hold::Curve(k) = *hold else { continue };
            let (curve, index) = &self.curves[k];
            if curve.is_closed() || projectors[v] == Block::ZERO {
                continue;
            }
            let t = index.closest_point(self.origin + points[v].to_vec() * self.scale).t;
            let onward = moves[v].dot(curve.jet(t).d1);
            if (t <= 0.0 && onward < 0.0) || (t >= 1.0 && onward > 0.0) {
                projectors[v] = Block::ZERO;
                any = true;
            }
        }
        any
    }
}

/// The grid with its corners between two sides on curves moved to the point where the curves meet. A corner on both
/// stays bit for bit.
///
/// # Errors
/// `border-curves-apart`: they do not meet within a median edge of the corner.
pub(super) fn corners_on_curves(grid: &QuadGrid, border: Border<'_>, edge: f64) -> Result<QuadGrid> {
    let Border::OnCurves(sides) = border else { return Ok(grid.clone()) };
    let [m, n] = grid.size();
    let mut points = grid.points().to_vec();
    for ([i, j], [a, b]) in [([0, 0], [0, 2]), ([m - 1, 0], [0, 3]), ([0, n - 1], [1, 2]), ([m - 1, n - 1], [1, 3])] {
        let (Some(a), Some(b)) = (sides[a], sides[b]) else { continue };
        let vertex = grid.index(i, j);
        points[vertex] = common_point(points[vertex], a, b, edge).map_err(|distance| {
            let limit = MEETING * edge;
            Error::Grid(GridError::BorderCurvesApart { vertex, distance, limit })
        })?;
    }
    grid.with_points(points)
}

/// The common point of two curves near a point, by projections from one to the other; their distance if there is none.
fn common_point(p: Point3, a: &dyn ParamCurve, b: &dyn ParamCurve, edge: f64) -> std::result::Result<Point3, f64> {
    let (a, b) = (CurveIndex::new(a), CurveIndex::new(b));
    let enough = MEETING * edge;
    if a.closest_point(p).distance.max(b.closest_point(p).distance) <= enough {
        return Ok(p);
    }
    let (mut at, mut gap) = (a.closest_point(p).point, f64::INFINITY);
    for _ in 0..PROJECTIONS {
        let on_b = b.closest_point(at);
        let on_a = a.closest_point(on_b.point);
        at = on_a.point;
        if !(on_a.distance < gap) {
            break;
        }
        gap = on_a.distance;
    }
    let near = at.distance(p) <= edge;
    if gap <= enough && near { Ok(at) } else { Err(if near { gap } else { at.distance(p) }) }
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
