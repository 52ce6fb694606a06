//! A skin of a tee, outer or inner: the blends, the walls of the branches, and the main pipe in stretches round their holes.

use super::canal::{Ball, Canal, curve};
use super::crossing::Crossing;
use super::cylinder::{Border, Cylinder};
use super::partition::Partition;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Arc;
use crate::error::Result;
use crate::rational::{Polynomial, PolynomialRow, RationalBezierSurface};
use crate::topology::{EdgeCurve, FaceEdge, Sewing};
use std::f64::consts::TAU;

/// Angle from the middle of a hole to the lines behind it: both arcs to them and the arc between them are of a third of a turn at most.
const BEHIND: f64 = TAU / 3.0;

/// Edges one after the other round a pipe, each from one vertex to the next.
#[derive(Debug, Clone, Default)]
pub(super) struct Ring {
    pub(super) vertices: Vec<usize>,
    pub(super) edges: Vec<usize>,
    /// Half directions at the vertices, in the axes of the main pipe; none round a branch.
    pub(super) halves: Vec<[f64; 2]>,
    /// Half directions along the edges.
    pub(super) along: Vec<[Polynomial; 2]>,
}

/// A branch with its loop, cut.
pub(super) struct Branch<'a> {
    pub(super) crossing: &'a Crossing,
    pub(super) partition: &'a Partition,
    /// Where it ends.
    pub(super) length: f64,
    /// Where its stretch of the main pipe begins and ends.
    pub(super) stretch: [f64; 2],
}

/// The rings that bound what was sewn of a branch: its own end, and both ends of its stretch.
pub(super) struct Rings {
    pub(super) branch: Ring,
    pub(super) main: [Ring; 2],
}

/// A skin being sewn: how far below the outer one it lies, and whether it bounds the material from inside.
pub(super) struct Skin<'a> {
    pub(super) sewing: &'a mut Sewing,
    pub(super) depth: f64,
    pub(super) inner: bool,
}

/// Vertices and edges round the hole of a branch.
struct Hole {
    balls: Vec<Ball>,
    /// Contacts with the main pipe, and the edges from each to the next.
    contacts: Vec<usize>,
    edges: Vec<usize>,
}

impl Skin<'_> {
    /// The faces of a branch and of its stretch.
    pub(super) fn branch(&mut self, branch: &Branch) -> Result<Rings> {
        let crossing = branch.crossing;
        let canals: Vec<Canal> =
            branch.partition.pieces.iter().map(|piece| Canal::new(crossing, piece, self.depth)).collect();
        let (hole, on_branch) = self.blend(branch, &canals)?;
        let end = self.wall(branch, &canals, &hole.balls, &on_branch)?;
        let main = self.stretch(branch, &canals, &hole)?;
        Ok(Rings { branch: end, main })
    }

    /// The blend, with the vertices and edges of its contact with the branch.
    fn blend(&mut self, branch: &Branch, canals: &[Canal]) -> Result<(Hole, [Vec<usize>; 2])> {
        let crossing = branch.crossing;
        let count = canals.len();
        let balls: Vec<Ball> = canals.iter().map(Canal::ball).collect();
        let cylinder = Cylinder::new(crossing, self.depth);
        let upper: Vec<Point3> =
            balls.iter().map(|ball| crossing.branch_point(self.depth, ball.on_branch, ball.height)).collect();
        let lower: Vec<Point3> = balls.iter().map(|ball| cylinder.point(ball.on_main, ball.along)).collect();
        let [tops, contacts] =
            [&upper, &lower].map(|points| points.iter().map(|&p| self.sewing.vertex(p)).collect::<Vec<_>>());
        let mut top_edges = Vec::new();
        let mut edges = Vec::new();
        let mut circles = Vec::new();
        for (k, canal) in canals.iter().enumerate() {
            let next = (k + 1) % count;
            let forms = &canal.forms;
            let on_main = cylinder.border(&forms.on_main, &absolute(crossing, canal), &forms.weight);
            top_edges.push(self.edge([tops[k], tops[next]], curve(&canal.on_branch()).into()));
            edges.push(self.edge([contacts[k], contacts[next]], curve(&on_main).into()));
            let ratio = canal.arc_ratio(0.0).unwrap_or(Quat::ONE);
            circles.push(self.sewing.arc(tops[k], contacts[k], ratio)?);
        }
        for (k, canal) in canals.iter().enumerate() {
            let next = (k + 1) % count;
            let surface = canal.surface()?.with_corners([upper[k], upper[next], lower[k], lower[next]]);
            let centre = canal.centres().point(0.5);
            let outwards = centre - surface.point(0.5, 0.5);
            let starts = [tops[k], contacts[k], tops[k], tops[next]];
            self.face(surface, [top_edges[k], edges[k], circles[k], circles[next]], starts, outwards);
        }
        Ok((Hole { balls, contacts, edges }, [tops, top_edges]))
    }

    /// The wall of the branch, from the blend to its end.
    fn wall(&mut self, branch: &Branch, canals: &[Canal], balls: &[Ball], on_branch: &[Vec<usize>; 2]) -> Result<Ring> {
        let crossing = branch.crossing;
        let (count, height) = (canals.len(), branch.length);
        let [tops, top_edges] = on_branch;
        let ends: Vec<Point3> =
            balls.iter().map(|ball| crossing.branch_point(self.depth, ball.on_branch, height)).collect();
        let vertices: Vec<usize> = ends.iter().map(|&p| self.sewing.vertex(p)).collect();
        let axis = crossing.axes[2];
        let mut edges = Vec::new();
        for (k, canal) in canals.iter().enumerate() {
            let half = |end: usize| {
                let [c, s] = canal.forms.on_branch.each_ref().map(|p| super::canal::value(p, end as f64));
                Quat::from_parts(c, axis * s)
            };
            let ratio = half(1) * half(0).inverse().unwrap_or(Quat::ONE);
            edges.push(self.sewing.arc(vertices[k], vertices[(k + 1) % count], ratio)?);
        }
        let rulings = (0..count).map(|k| self.sewing.segment(tops[k], vertices[k])).collect::<Result<Vec<_>>>()?;
        for (k, canal) in canals.iter().enumerate() {
            let next = (k + 1) % count;
            let corners = [tops[k], tops[next], vertices[k], vertices[next]].map(|v| self.sewing.vertices[v]);
            let rows = [canal.on_branch(), canal.beside_branch(height)];
            let surface = RationalBezierSurface::from_polynomial_rows(&rows)?.with_corners(corners);
            let way = surface.point(0.5, 0.5) - crossing.foot;
            let outwards = way - axis * way.dot(axis);
            let starts = [tops[k], vertices[k], tops[k], tops[next]];
            self.face(surface, [top_edges[k], edges[k], rulings[k], rulings[next]], starts, outwards);
        }
        Ok(Ring { vertices, edges, halves: Vec::new(), along: Vec::new() })
    }

    /// The stretch of the main pipe round the hole, with the rings at its ends.
    fn stretch(&mut self, branch: &Branch, canals: &[Canal], hole: &Hole) -> Result<[Ring; 2]> {
        let [first, front, back, rear, count] = branch.partition.sides;
        let node = |k: usize| k % count;
        let mut lines = Lines::new(self, branch, hole)?;
        // Towards both ends: rulings.
        let mut ring_sides = [Ring::default(), Ring::default()];
        for (side, nodes) in [(1, first..front), (0, back..rear)] {
            let at = branch.stretch[side];
            let ring = &mut ring_sides[side];
            for k in nodes.start..=nodes.end {
                let half = hole.balls[node(k)].on_main;
                ring.vertices.push(lines.skin.sewing.vertex(lines.cylinder.point(half, at)));
                ring.halves.push(half);
            }
            let mut rulings = Vec::new();
            for (k, &vertex) in (nodes.start..=nodes.end).zip(&ring.vertices) {
                rulings.push(lines.skin.sewing.segment(hole.contacts[node(k)], vertex)?);
            }
            for (j, k) in nodes.enumerate() {
                lines.ruled(
                    &canals[k],
                    at,
                    [hole.contacts[k], hole.contacts[node(k + 1)]],
                    hole.edges[k],
                    ring,
                    &rulings,
                    j,
                )?;
            }
            lines.rulings[side] = rulings;
        }
        lines.beside(canals, hole, [front, back], 0)?;
        lines.beside(canals, hole, [rear, count], 1)?;
        lines.behind()?;
        let [start, end] = ring_sides;
        let ends = [lines.close(start, 0)?, lines.close(end, 1)?];
        Ok(ends)
    }

    /// Adds an edge along a rational curve.
    pub(super) fn edge(&mut self, ends: [usize; 2], curve: EdgeCurve) -> usize {
        let [start, end] = ends.map(|v| self.sewing.vertices[v]);
        self.sewing.edge(ends[0], ends[1], curve.with_ends(Some(start), Some(end)))
    }

    /// Adds a face with the vertices at which its sides start, outside on the side of a direction in its middle, of the inner skin on the other.
    fn face(&mut self, surface: RationalBezierSurface, edges: [usize; 4], starts: [usize; 4], outwards: Vec3) {
        let outwards = if self.inner { -outwards } else { outwards };
        self.plane_face(surface, [0, 1, 2, 3].map(|k: usize| Some((edges[k], starts[k]))), outwards);
    }

    /// Adds a face with its sides, edges and the vertices at which they start, outside on the side of a direction in its middle.
    pub(super) fn plane_face(
        &mut self,
        surface: RationalBezierSurface,
        sides: [Option<(usize, usize)>; 4],
        outwards: Vec3,
    ) {
        let edges = &self.sewing.edges;
        let sides = sides.map(|side| side.map(|(edge, start)| FaceEdge { edge, forward: edges[edge].start == start }));
        let ahead = surface.unit_normal(0.5, 0.5).dot(outwards) > 0.0;
        self.sewing.face_along(surface, sides, ahead);
    }
}

/// The place along the main pipe times the weight.
fn absolute(crossing: &Crossing, canal: &Canal) -> Polynomial {
    &canal.forms.along + &(&canal.forms.weight * crossing.at)
}

/// The lines beside and behind a hole.
struct Lines<'a, 'b> {
    skin: &'a mut Skin<'b>,
    cylinder: Cylinder,
    crossing: &'a Crossing,
    stretch: [f64; 2],
    /// Half directions of both lines behind, the second as it is reached from the first, and as it is from the hole.
    halves: [[f64; 2]; 2],
    second: [f64; 2],
    /// Vertices along both lines from the start to the end of the stretch, with their places, and edges between them.
    vertices: [Vec<usize>; 2],
    places: [Vec<f64>; 2],
    edges: [Vec<usize>; 2],
    rulings: [Vec<usize>; 2],
    /// The arcs from the hole to both lines, from low places to high ones.
    arcs: [Vec<usize>; 2],
    /// Contacts and half directions of the first and the last of these.
    outermost: [[(usize, [f64; 2]); 2]; 2],
    across: Vec<usize>,
}

impl<'a, 'b> Lines<'a, 'b> {
    fn new(skin: &'a mut Skin<'b>, branch: &Branch<'a>, hole: &Hole) -> Result<Self> {
        let [_, front, back, rear, count] = branch.partition.sides;
        let cylinder = Cylinder::new(branch.crossing, skin.depth);
        let angle = |ball: &Ball| 2.0 * ball.on_main[1].atan2(ball.on_main[0]);
        let angles = || hole.balls.iter().map(angle);
        let middle = 0.5 * (angles().fold(f64::INFINITY, f64::min) + angles().fold(f64::NEG_INFINITY, f64::max));
        let half = |angle: f64| {
            let (s, c) = (0.5 * angle).sin_cos();
            [c, s]
        };
        let mut lines = Self {
            skin,
            cylinder,
            crossing: branch.crossing,
            stretch: branch.stretch,
            halves: [half(middle + BEHIND), half(middle + 2.0 * BEHIND)],
            second: half(middle - BEHIND),
            vertices: [Vec::new(), Vec::new()],
            places: [Vec::new(), Vec::new()],
            edges: [Vec::new(), Vec::new()],
            rulings: [Vec::new(), Vec::new()],
            arcs: [Vec::new(), Vec::new()],
            outermost: [[(0, [0.0; 2]); 2]; 2],
            across: Vec::new(),
        };
        // The nodes beside the hole from low places to high ones.
        let nodes = [(front..=back).rev().collect::<Vec<_>>(), (rear..=count).collect()];
        for (line, nodes) in nodes.into_iter().enumerate() {
            let along = nodes.iter().map(|&k| hole.balls[k % count].along);
            let places: Vec<f64> =
                std::iter::once(branch.stretch[0]).chain(along).chain(std::iter::once(branch.stretch[1])).collect();
            let target = if line == 0 { lines.halves[0] } else { lines.second };
            let points = places.iter().map(|&at| lines.cylinder.point(target, at));
            let vertices: Vec<usize> = points.map(|p| lines.skin.sewing.vertex(p)).collect();
            for pair in vertices.windows(2) {
                let edge = lines.skin.sewing.segment(pair[0], pair[1])?;
                lines.edges[line].push(edge);
            }
            for (&k, &vertex) in nodes.iter().zip(&vertices[1..]) {
                let (contact, from) = (hole.contacts[k % count], hole.balls[k % count].on_main);
                let ends = [contact, vertex].map(|v| lines.skin.sewing.vertices[v]);
                let arc = lines.cylinder.arc(ends, from, target)?;
                let edge = lines.skin.sewing.edge(contact, vertex, arc);
                lines.arcs[line].push(edge);
            }
            let outer = |k: usize| (hole.contacts[k % count], hole.balls[k % count].on_main);
            lines.outermost[line] = [outer(nodes[0]), outer(nodes[nodes.len() - 1])];
            (lines.vertices[line], lines.places[line]) = (vertices, places);
        }
        Ok(lines)
    }

    fn add(&mut self, surface: RationalBezierSurface, vertices: [usize; 4], edges: [usize; 4]) {
        let corners = vertices.map(|v| self.skin.sewing.vertices[v]);
        let surface = surface.with_corners(corners);
        let middle = surface.point(0.5, 0.5);
        let outwards = Vec3::new(0.0, middle.y, middle.z);
        let starts = [vertices[0], vertices[2], vertices[0], vertices[1]];
        self.skin.face(surface, edges, starts, outwards);
    }

    /// A part ruled from the hole to an end of the stretch, with its edge there.
    #[expect(clippy::too_many_arguments, reason = "one piece of one side, with the borders that it shares")]
    fn ruled(
        &mut self,
        canal: &Canal,
        at: f64,
        contacts: [usize; 2],
        edge: usize,
        ring: &mut Ring,
        rulings: &[usize],
        j: usize,
    ) -> Result<()> {
        let forms = &canal.forms;
        let ends = [ring.vertices[j], ring.vertices[j + 1]];
        let end_edge = self.skin.edge(ends, curve(&self.cylinder.circle(&forms.on_main, at)).into());
        ring.edges.push(end_edge);
        ring.along.push(forms.on_main.clone());
        let rows: [PolynomialRow; 2] = [
            self.cylinder.border(&forms.on_main, &absolute(self.crossing, canal), &forms.weight),
            self.cylinder.border(&forms.on_main, &(&forms.weight * at), &forms.weight),
        ];
        let surface = RationalBezierSurface::from_polynomial_rows(&rows)?;
        self.add(surface, [contacts[0], contacts[1], ends[0], ends[1]], [edge, end_edge, rulings[j], rulings[j + 1]]);
        Ok(())
    }

    /// The parts beside the hole, with arcs to a line.
    fn beside(&mut self, canals: &[Canal], hole: &Hole, [from, to]: [usize; 2], line: usize) -> Result<()> {
        let count = canals.len();
        let target = if line == 0 { self.halves[0] } else { self.second };
        let steps = to - from;
        for (k, canal) in canals.iter().enumerate().take(to).skip(from) {
            // Lines run from low places to high ones, the loop comes back along the first.
            let place = |node: usize| if line == 0 { steps - (node - from) } else { node - from };
            let (start, end) = (place(k), place(k + 1));
            let contacts = [hole.contacts[k], hole.contacts[(k + 1) % count]];
            let vertices = [start, end].map(|p| self.vertices[line][p + 1]);
            let forms = &canal.forms;
            let size = |end: f64| {
                let [c, s] = forms.on_main.each_ref().map(|p| super::canal::value(p, end));
                c.hypot(s)
            };
            let even = [size(0.0), size(1.0)];
            let straight = Polynomial::new([start, end].map(|p| self.places[line][p + 1]).to_vec());
            let first = Border { half: forms.on_main.clone(), along: absolute(self.crossing, canal) };
            let second = Border {
                half: target.map(|v| Polynomial::new(even.map(|size| size * v).to_vec())),
                along: &straight * &forms.weight,
            };
            let surface = self.cylinder.between(&forms.weight, &first, &second)?;
            let arcs = [start, end].map(|p| self.arcs[line][p]);
            let segment = self.edges[line][start.min(end) + 1];
            self.add(
                surface,
                [contacts[0], contacts[1], vertices[0], vertices[1]],
                [hole.edges[k], segment, arcs[0], arcs[1]],
            );
        }
        Ok(())
    }

    /// The parts behind, between both lines.
    fn behind(&mut self) -> Result<()> {
        let one = Polynomial::constant(1.0);
        let last = self.places[0].len() - 1;
        let size = (self.stretch[1] - self.stretch[0]).abs();
        for k in 0..=last {
            let ends = [0, 1].map(|line: usize| self.vertices[line][k]);
            let points = ends.map(|v| self.skin.sewing.vertices[v]);
            let mut along = [self.places[0][k], self.places[1][k]];
            // What is rounding is none.
            if (along[0] - along[1]).abs() <= 1e-13 * size {
                along[1] = along[0];
            }
            let curve = self.cylinder.across(points, self.halves, along)?;
            let edge = self.skin.edge(ends, curve);
            self.across.push(edge);
        }
        for k in 0..last {
            let border = |line: usize| Border {
                half: self.halves[line].map(Polynomial::constant),
                along: Polynomial::new(vec![self.places[line][k], self.places[line][k + 1]]),
            };
            let surface = self.cylinder.between(&one, &border(0), &border(1))?;
            let [a, b] = [0, 1].map(|line: usize| [self.vertices[line][k], self.vertices[line][k + 1]]);
            let edges = [self.edges[0][k], self.edges[1][k], self.across[k], self.across[k + 1]];
            self.add(surface, [a[0], a[1], b[0], b[1]], edges);
        }
        Ok(())
    }

    /// The corners at an end of the stretch, and the ring there from low angles to high ones.
    fn close(&mut self, mut ring: Ring, side: usize) -> Result<Ring> {
        let last = self.places[0].len() - 1;
        let (place, inside) = if side == 0 { (0, 0) } else { (last, self.arcs[0].len() - 1) };
        if side == 0 {
            // The loop came from high angles to low ones.
            ring.vertices.reverse();
            ring.edges.reverse();
            ring.halves.reverse();
            ring.along = ring.along.into_iter().rev().map(|half| half.map(|p| p.reversed())).collect();
            self.rulings[0].reverse();
        }
        let one = Polynomial::constant(1.0);
        let mut corner_edges = Vec::new();
        for line in [0, 1] {
            let target = if line == 0 { self.halves[0] } else { self.second };
            let (contact, half) = self.outermost[line][side];
            let (vertex, ruling) = if line == 0 {
                (ring.vertices[ring.vertices.len() - 1], self.rulings[side][self.rulings[side].len() - 1])
            } else {
                (ring.vertices[0], self.rulings[side][0])
            };
            let behind = self.vertices[line][place];
            let ends = [vertex, behind].map(|v| self.skin.sewing.vertices[v]);
            let arc: Arc = self.cylinder.arc(ends, half, target)?;
            let edge = self.skin.sewing.edge(vertex, behind, arc);
            let beside = self.vertices[line][if side == 0 { 1 } else { last - 1 }];
            let segment = self.edges[line][if side == 0 { 0 } else { last - 1 }];
            let places = vec![self.places[line][if side == 0 { 1 } else { last - 1 }], self.stretch[side]];
            let border = |half: [f64; 2]| Border {
                half: half.map(Polynomial::constant),
                along: Polynomial::new(places.clone()),
            };
            let surface = self.cylinder.between(&one, &border(half), &border(target))?;
            let edges = [ruling, segment, self.arcs[line][inside], edge];
            self.add(surface, [contact, vertex, beside, behind], edges);
            corner_edges.push((edge, half));
        }
        // Once round: to the first line, behind to the second, and back.
        let constant = |from: [f64; 2], to: [f64; 2]| [0, 1].map(|d: usize| Polynomial::new(vec![from[d], to[d]]));
        let high = corner_edges[0].1;
        let low = corner_edges[1].1;
        ring.edges.extend([corner_edges[0].0, self.across[place], corner_edges[1].0]);
        ring.vertices.extend([0, 1].map(|line: usize| self.vertices[line][place]));
        ring.halves.extend([self.halves[0], self.second]);
        ring.along.extend([
            constant(high, self.halves[0]),
            constant(self.halves[0], self.halves[1]),
            constant(self.second, low),
        ]);
        Ok(ring)
    }
}
