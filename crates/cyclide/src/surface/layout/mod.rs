//! Meshes of quads with extraordinary vertices as regular grids that join (`docs/math/circular-meshes.md#extraordinary-vertices`).
//!
//! The straight lines of edges from the extraordinary vertices to the border, or to other ones, cut a mesh into regular grids. The
//! quads round an extraordinary vertex stay open: at a vertex of a net two lines of curvature cross at right angles, which three or
//! five patches round one vertex cannot. What is left closes round each of these openings as a net does where the frame that is
//! carried round comes back turned by the quarter turns that are missing there, or too many.

mod closing;
mod connections;
mod lengths;
mod net_layout;
mod pieces;

pub use closing::RoundClosing;
pub use net_layout::NetLayout;

use super::QuadGrid;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, GridError, LayoutFault, PointError, Result};
use connections::{Connections, side};
use std::collections::{BTreeSet, HashMap, VecDeque};

/// A mesh of quads as regular grids that share their border vertices, with openings round its extraordinary vertices: inner vertices without
/// four quads.
///
/// ```
/// use cyclide::{Point3, surface::QuadLayout};
/// // Three sectors of 3 x 3 quads round one vertex, as the corner of a cube seen from outside.
/// let cube = |i: usize, a: usize, b: usize| {
///     let mut p = [3.0; 3];
///     (p[i], p[(i + 1) % 3]) = (3.0 - a as f64, 3.0 - b as f64);
///     p
/// };
/// let mut points: Vec<[f64; 3]> = Vec::new();
/// let mut number = |p: [f64; 3]| points.iter().position(|q| *q == p).unwrap_or_else(|| { points.push(p); points.len() - 1 });
/// let mut quads = Vec::new();
/// for k in 0..27 {
///     let (i, a, b) = (k / 9, k % 3, k / 3 % 3);
///     quads.push([(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)].map(|(a, b)| number(cube(i, a, b))));
/// }
/// let layout = QuadLayout::new(points.into_iter().map(Point3::from).collect(), &quads)?;
/// assert_eq!((layout.pieces().len(), layout.round().len(), layout.round()[0].ring.len()), (3, 1, 6));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct QuadLayout {
    points: Vec<Point3>,
    pieces: Vec<LayoutPiece>,
    round: Vec<RoundVertex>,
    connections: Connections,
    on_border: Vec<bool>,
}

/// One of the grids of a [`QuadLayout`].
///
/// ```
/// use cyclide::{Point3, surface::QuadLayout};
/// let points: Vec<_> = (0..6).map(|k| Point3::new(f64::from(k % 3), f64::from(k / 3), 0.0)).collect();
/// let layout = QuadLayout::new(points, &[[0, 1, 4, 3], [1, 2, 5, 4]])?;
/// assert_eq!((layout.pieces()[0].grid.quads(), layout.pieces()[0].vertices[4]), ([2, 1], Some(4)));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct LayoutPiece {
    /// The grid; s runs along the first side of its first quad, and `s × t` is on the same side for all grids.
    pub grid: QuadGrid,
    /// The vertex of the mesh at each point of the grid, s fastest; `None` where it has none.
    pub vertices: Vec<Option<usize>>,
    /// The quad of the mesh at each place of the grid, s fastest; `None` of one that is outside.
    pub quads: Vec<Option<usize>>,
}

/// An extraordinary vertex, and what is open round it.
///
/// ```
/// # use cyclide::{Point3, surface::QuadLayout};
/// let points: Vec<_> = (0..9).map(|k| Point3::new(f64::from(k % 3), f64::from(k / 3), 0.0)).collect();
/// let quads: Vec<[usize; 4]> = [0, 1, 3, 4].map(|a| [a, a + 1, a + 4, a + 3]).into();
/// assert!(QuadLayout::new(points, &quads)?.round().is_empty()); // four quads round the inner vertex
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct RoundVertex {
    /// The vertex.
    pub vertex: usize,
    /// The vertices round its quads, counter-clockwise: those at its edges and those opposite in turn.
    pub ring: Vec<usize>,
    /// Its quads.
    pub quads: Vec<usize>,
}

impl QuadLayout {
    /// From the vertices and the quads of a mesh, each by its corners in cyclic order. Quads may be turned either way.
    ///
    /// # Errors
    /// `not-a-quad-layout` with the quad or vertex: see [`LayoutFault`]; `not-finite`, `parameter-out-of-range`; `cells-unfit` of a
    /// mesh without extraordinary vertices that is no part of a rectangle.
    pub fn new(points: Vec<Point3>, quads: &[[usize; 4]]) -> Result<Self> {
        for (index, p) in points.iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        let connections = Connections::new(points.len(), quads)?;
        let on_border = connections.check_vertices()?;
        let round = pieces::extraordinary(&connections, &on_border)?;
        if let Some(first) = round.first() {
            check_plain(&connections, first.vertex)?;
        }
        let pieces = pieces::pieces(&connections, &points, &round)?;
        Ok(Self { points, pieces, round, connections, on_border })
    }

    /// The same grids of other points.
    ///
    /// # Errors
    /// `too-few-points`, `not-finite`, `parameter-out-of-range`.
    pub fn with_points(&self, points: Vec<Point3>) -> Result<Self> {
        if points.len() != self.points.len() {
            return Err(PointError::TooFewPoints { given: points.len(), needed: self.points.len() }.into());
        }
        let of_piece = |piece: &LayoutPiece| {
            let old = piece.grid.points();
            let moved = piece.vertices.iter().zip(old).map(|(v, old)| v.map_or(*old, |v| points[v])).collect();
            Ok(LayoutPiece { grid: piece.grid.with_points(moved)?, ..piece.clone() })
        };
        let pieces = self.pieces.iter().map(of_piece).collect::<Result<_>>()?;
        Ok(Self { points, pieces, ..self.clone() })
    }

    /// The vertices of the mesh.
    #[must_use]
    pub fn points(&self) -> &[Point3] {
        &self.points
    }

    /// The grids, that of the first quad first.
    #[must_use]
    pub fn pieces(&self) -> &[LayoutPiece] {
        &self.pieces
    }

    /// The extraordinary vertices.
    #[must_use]
    pub fn round(&self) -> &[RoundVertex] {
        &self.round
    }

    /// Refuses a mesh that is a point at its place.
    pub(super) fn check_place(&self) -> Result<()> {
        range::check_place(ErrorItem::Surface, &self.points)
    }

    /// The vertex from which frames are carried: the first one of the first grid.
    pub fn base(&self) -> usize {
        self.pieces[0].vertices.iter().flatten().next().copied().unwrap_or_default()
    }

    /// The corners of a quad of the mesh in cyclic order, if there is one.
    #[must_use]
    pub fn corners(&self, quad: usize) -> Option<[usize; 4]> {
        self.connections.quads.get(quad).copied()
    }

    /// The corners of all quads of the grids in binary order, piece by piece; those round extraordinary vertices are not among them.
    #[must_use]
    pub fn quads(&self) -> Vec<[usize; 4]> {
        let of_piece = |piece: &LayoutPiece| -> Vec<[usize; 4]> {
            let corners = |[i, j]: [usize; 2]| piece.grid.corners(i, j).map(|k| piece.vertices[k].unwrap_or_default());
            piece.grid.all_quads().map(corners).collect()
        };
        self.pieces.iter().flat_map(of_piece).collect()
    }

    /// Whether each vertex belongs to a grid.
    pub fn used_vertices(&self) -> Vec<bool> {
        let mut used = vec![false; self.points.len()];
        self.pieces.iter().flat_map(|piece| &piece.vertices).flatten().for_each(|v| used[*v] = true);
        used
    }

    /// Whether each vertex is on the border of the mesh.
    pub fn on_border(&self) -> &[bool] {
        &self.on_border
    }

    /// The edges of the grids, each once, in the order of their quads.
    pub fn edges(&self) -> Vec<[usize; 2]> {
        let mut known = BTreeSet::new();
        let sides = |[a0, a1, a2, a3]: [usize; 4]| [[a0, a1], [a2, a3], [a0, a2], [a1, a3]];
        self.quads().into_iter().flat_map(sides).filter(|[a, b]| known.insert(side(*a, *b))).collect()
    }

    /// Vertices next to each other along straight lines of edges, three by three.
    pub fn triples(&self) -> Vec<[usize; 3]> {
        let edges = self.edges();
        let known: BTreeSet<[usize; 2]> = edges.iter().map(|[a, b]| side(*a, *b)).collect();
        let both_ways = edges.into_iter().flat_map(|[a, b]| [[a, b], [b, a]]);
        let triple = |[a, b]: [usize; 2]| {
            let c = self.connections.onward(a, b).filter(|c| known.contains(&side(b, *c)))?;
            (a < c).then_some([a, b, c])
        };
        both_ways.filter_map(triple).collect()
    }

    /// Strips of quads that come back to themselves, by the corners of their quads in binary order, s along the strip.
    pub fn closed_strips(&self) -> Vec<Vec<[usize; 4]>> {
        let mut open = vec![false; self.connections.quads.len()];
        self.round.iter().flat_map(|at| &at.quads).for_each(|quad| open[*quad] = true);
        let mut crossed = BTreeSet::new();
        let mut strips = Vec::new();
        for (quad, corners) in self.connections.quads.iter().enumerate().filter(|(quad, _)| !open[*quad]) {
            for k in 0..2 {
                let start = [corners[k], corners[(k + 3) % 4]];
                if crossed.contains(&side(start[0], start[1])) {
                    continue;
                }
                if let Some(strip) = self.strip(quad, start, &open) {
                    strip.iter().for_each(|[a0, _, a2, _]| {
                        crossed.insert(side(*a0, *a2));
                    });
                    strips.push(strip);
                }
            }
        }
        strips
    }

    /// The strip of quads from one of them away from one of its sides, if it comes back there.
    fn strip(&self, first: usize, start: [usize; 2], open: &[bool]) -> Option<Vec<[usize; 4]>> {
        let (mut quad, mut entry, mut strip) = (first, start, Vec::new());
        loop {
            let [right, left] = entry;
            let other = |v: usize, not: usize| self.connections.beside(quad, v)?.into_iter().find(|w| *w != not);
            let exit = [other(right, left)?, other(left, right)?];
            strip.push([right, exit[0], left, exit[1]]);
            if exit == start {
                return Some(strip);
            }
            quad = self.connections.across(quad, exit).filter(|quad| !open[*quad])?;
            entry = exit;
            // A one-sided strip would come back the other way round; oriented meshes have none.
            if strip.len() > self.connections.quads.len() {
                return None;
            }
        }
    }

    /// For each extraordinary vertex a closed walk along edges of the grids: from the base to the ring, round it and back; with the
    /// edges before the ring.
    pub(crate) fn walks(&self) -> Vec<(Vec<usize>, usize)> {
        let mut before: HashMap<usize, usize> = HashMap::new();
        let mut next: HashMap<usize, Vec<usize>> = HashMap::new();
        for [a, b] in self.edges() {
            next.entry(a).or_default().push(b);
            next.entry(b).or_default().push(a);
        }
        let base = self.base();
        let mut open = VecDeque::from([base]);
        while let Some(v) = open.pop_front() {
            for w in next.get(&v).into_iter().flatten().filter(|w| **w != base) {
                before.entry(*w).or_insert_with(|| {
                    open.push_back(*w);
                    v
                });
            }
        }
        let walk = |at: &RoundVertex| {
            // To the nearest vertex of the ring.
            let path = |end: usize| {
                let mut path = vec![end];
                while let Some(v) = before.get(&path[path.len() - 1]) {
                    path.push(*v);
                }
                path.reverse();
                path
            };
            let paths: Vec<Vec<usize>> = at.ring.iter().step_by(2).map(|v| path(*v)).collect();
            let nearest = (0..paths.len()).min_by_key(|k| paths[*k].len()).unwrap_or_default();
            let path = &paths[nearest];
            let around = (1..=at.ring.len()).map(|k| at.ring[(2 * nearest + k) % at.ring.len()]);
            let back = path.iter().rev().skip(1).copied();
            let mut walk: Vec<usize> = path.iter().copied().chain(around).chain(back).collect();
            // It is back at the base.
            walk.pop();
            (walk, path.len() - 1)
        };
        self.round.iter().map(walk).collect()
    }

    /// The mean direction of the quads of the grids round each vertex; `None` where it vanishes.
    pub fn normals(&self, points: &[Point3]) -> Vec<Option<Vec3>> {
        let mut sums = vec![Vec3::ZERO; points.len()];
        for [a0, a1, a2, a3] in self.quads() {
            let across = (points[a3] - points[a0]).cross(points[a2] - points[a1]);
            [a0, a1, a2, a3].into_iter().for_each(|v| sums[v] += across);
        }
        sums.into_iter().map(Vec3::unit).collect()
    }
}

/// Refuses what is neither a disc nor closed like a sphere.
fn check_plain(connections: &Connections, vertex: usize) -> Result<()> {
    let vertices: BTreeSet<usize> = connections.quads.iter().flatten().copied().collect();
    let edges: Vec<bool> = connections.edges().map(|(_, on_border)| on_border).collect();
    let characteristic = (vertices.len() + connections.quads.len()) as i64 - edges.len() as i64;
    let wanted = if edges.contains(&true) { 1 } else { 2 };
    if characteristic == wanted {
        return Ok(());
    }
    Err(GridError::NotAQuadLayout { fault: LayoutFault::Holes, index: vertex }.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;

    /// Sectors of `k` x `k` quads round one vertex, over a plane grid whose edges cross at right angles.
    pub(super) fn cap(sectors: usize, k: usize, height: impl Fn(f64, f64) -> f64) -> QuadLayout {
        let (mut points, mut quads) = (Vec::<Point3>::new(), Vec::new());
        for q in 0..sectors * k * k {
            let (i, a, b) = (q / (k * k), q % k, q / k % k);
            quads.push([(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)].map(|(a, b)| {
                let bend = 4.0 / sectors as f64;
                let r = ((a as f64).hypot(b as f64) / k as f64).powf(bend);
                let angle = bend * (b as f64).atan2(a as f64) + std::f64::consts::TAU * i as f64 / sectors as f64;
                let (x, y) = (r * angle.cos(), r * angle.sin());
                let p = Point3::new(x, y, height(x, y));
                points.iter().position(|q| q.distance(p) < 1e-9).unwrap_or_else(|| {
                    points.push(p);
                    points.len() - 1
                })
            }));
        }
        QuadLayout::new(points, &quads).unwrap()
    }

    #[test]
    fn sectors_are_pieces() {
        for sectors in [3, 5, 6, 7] {
            let layout = cap(sectors, 4, |x, y| 0.1 * x * y);
            assert_eq!(layout.pieces().len(), sectors);
            assert!(layout.pieces().iter().all(|piece| piece.grid.quads() == [4, 4] && !piece.grid.is_whole()));
            assert_eq!(layout.quads().len(), sectors * 15);
            assert_eq!(layout.round()[0].ring.len(), 2 * sectors);
            // Of the straight lines of k edges, 2 k + 1 in a sector but two that end at its vertex, each with 2 k edges or k.
            assert!(layout.closed_strips().is_empty());
            let (walk, before) = &layout.walks()[0];
            assert_eq!(walk.len(), 2 * before + 2 * sectors);
        }
    }

    #[test]
    fn four_quads_round_a_vertex_are_ordinary() {
        let layout = cap(4, 3, |x, y| x * y);
        assert_eq!((layout.pieces().len(), layout.round().len()), (1, 0));
        assert!(layout.pieces()[0].grid.is_whole());
        assert_eq!(layout.pieces()[0].grid.quads(), [6, 6]);
    }

    #[test]
    fn faults_are_named() {
        let fault = |points: usize, quads: &[[usize; 4]]| {
            let points = (0..points).map(|k| Point3::new(k as f64, (k * k) as f64, 0.0)).collect();
            match QuadLayout::new(points, quads) {
                Err(Error::Grid(GridError::NotAQuadLayout { fault, index })) => (fault, index),
                other => panic!("{other:?}"),
            }
        };
        assert_eq!(fault(4, &[]), (LayoutFault::NoQuads, 0));
        assert_eq!(fault(4, &[[0, 1, 2, 4]]), (LayoutFault::NoSuchVertex, 0));
        assert_eq!(fault(4, &[[0, 1, 2, 1]]), (LayoutFault::RepeatedCorner, 0));
        assert_eq!(fault(8, &[[0, 1, 2, 3], [0, 1, 4, 5], [1, 0, 6, 7]]), (LayoutFault::ThirdQuad, 2));
        assert_eq!(fault(8, &[[0, 1, 2, 3], [4, 5, 6, 7]]), (LayoutFault::Apart, 1));
        assert_eq!(fault(7, &[[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]]), (LayoutFault::Crowded, 0));
        // Four quads round a vertex of the border, and one more.
        let fan: Vec<[usize; 4]> = (0..4).map(|k| [0, 2 * k + 1, 2 * k + 2, 2 * k + 3]).collect();
        assert_eq!(fault(10, &fan), (LayoutFault::Border, 0));
        // A band with a half twist.
        let band: Vec<[usize; 4]> = (0..3).map(|k| [k, k + 1, k + 5, k + 4]).chain([[3, 4, 0, 7]]).collect();
        assert_eq!(fault(8, &band).0, LayoutFault::OneSided);
    }
}
