//! The stretch of a pipe round a hole: rulings to its ends, arcs beside it, and what is behind (`docs/math/pipe-tees.md#faces`).

use super::mantle::{Border, Mantle};
use super::skin::{Ring, Skin};
use crate::curve::Arc;
use crate::error::Result;
use crate::rational::{Polynomial, PolynomialRow, RationalBezier, RationalBezierSurface};
use std::f64::consts::{PI, TAU};

/// Angle from the middle of a hole to the lines behind it, for one that goes so far round to either side: both arcs to them and the arc between them are of a third of a
/// turn at most, or the lines are a third of the way behind it.
fn behind(reach: f64) -> f64 {
    (TAU / 3.0).max(reach + (PI - reach) / 3.0)
}

/// The half direction of an angle.
fn half(angle: f64) -> [f64; 2] {
    let (s, c) = (0.5 * angle).sin_cos();
    [c, s]
}

/// From one half direction to another, of degree 0 where they are one.
fn between([from, to]: [[f64; 2]; 2]) -> [Polynomial; 2] {
    let one = (0..2).all(|d: usize| from[d] - to[d] == 0.0);
    [0, 1].map(|d: usize| Polynomial::new(if one { vec![from[d]] } else { vec![from[d], to[d]] }))
}

/// A place of the border of a hole: half direction of length 1, and place along the pipe.
#[derive(Debug, Clone, Copy)]
pub(in crate::construct::bodies) struct Node {
    pub(in crate::construct::bodies) half: [f64; 2],
    pub(in crate::construct::bodies) along: f64,
}

/// A piece of the border of a hole: half direction, place along the pipe times the weight, and the weight.
#[derive(Debug, Clone)]
pub(in crate::construct::bodies) struct HolePiece {
    pub(in crate::construct::bodies) half: [Polynomial; 2],
    pub(in crate::construct::bodies) along: Polynomial,
    pub(in crate::construct::bodies) weight: Polynomial,
}

impl HolePiece {
    /// The same run backwards.
    pub(in crate::construct::bodies) fn reversed(self) -> Self {
        let Self { half, along, weight } = self;
        Self { half: half.map(|p| p.reversed()), along: along.reversed(), weight: weight.reversed() }
    }
}

/// A hole in a pipe, whose border has been sewn: from its corner at the end of the pipe and low angles on towards higher angles.
pub(in crate::construct::bodies) struct Hole {
    pub(in crate::construct::bodies) mantle: Mantle,
    pub(in crate::construct::bodies) pieces: Vec<HolePiece>,
    /// The starts of the pieces, their vertices, and the edges from each to the next.
    pub(in crate::construct::bodies) nodes: Vec<Node>,
    pub(in crate::construct::bodies) contacts: Vec<usize>,
    pub(in crate::construct::bodies) edges: Vec<usize>,
    /// The numbers of the pieces that start the sides: towards the end of the pipe, beside it, towards its start, beside it on the other side, as many pieces as on the first; last that of
    /// all pieces.
    pub(in crate::construct::bodies) sides: [usize; 5],
    /// How much the hole leans: by how much the lines behind it go round the pipe for a step along it.
    pub(in crate::construct::bodies) slant: f64,
    /// Where the stretch begins and ends.
    pub(in crate::construct::bodies) stretch: [f64; 2],
}

impl Skin<'_> {
    /// The stretch of a pipe round a hole, with the rings at its ends.
    ///
    /// # Errors
    /// As [`RationalBezierSurface::new`].
    pub(in crate::construct::bodies) fn stretch(&mut self, hole: &Hole) -> Result<[Ring; 2]> {
        let [first, front, back, rear, count] = hole.sides;
        let node = |k: usize| k % count;
        let mut lines = Lines::new(self, hole)?;
        // Towards both ends: rulings.
        let mut ring_sides = [Ring::default(), Ring::default()];
        for (side, nodes) in [(1, first..front), (0, back..rear)] {
            let at = hole.stretch[side];
            let ring = &mut ring_sides[side];
            for k in nodes.start..=nodes.end {
                let half = hole.nodes[node(k)].half;
                ring.vertices.push(lines.skin.sewing.vertex(lines.mantle.point(half, at)));
                ring.halves.push(half);
            }
            let mut rulings = Vec::new();
            for (k, &vertex) in (nodes.start..=nodes.end).zip(&ring.vertices) {
                rulings.push(lines.skin.sewing.segment(hole.contacts[node(k)], vertex)?);
            }
            for (j, k) in nodes.enumerate() {
                lines.ruled(
                    &hole.pieces[k],
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
        lines.beside(hole, [front, back], 0)?;
        lines.beside(hole, [rear, count], 1)?;
        lines.behind()?;
        let [start, end] = ring_sides;
        let ends = [lines.close(start, 0)?, lines.close(end, 1)?];
        Ok(ends)
    }
}

/// The lines beside and behind a hole.
struct Lines<'a, 'b> {
    skin: &'a mut Skin<'b>,
    mantle: Mantle,
    stretch: [f64; 2],
    /// Vertices along both lines from the start to the end of the stretch, with their places and angles as they are reached from the hole, and edges between
    /// them.
    vertices: [Vec<usize>; 2],
    places: [Vec<f64>; 2],
    angles: [Vec<f64>; 2],
    edges: [Vec<usize>; 2],
    rulings: [Vec<usize>; 2],
    /// The arcs from the hole to both lines, from low places to high ones.
    arcs: [Vec<usize>; 2],
    /// Contacts and half directions of the first and the last of these.
    outermost: [[(usize, [f64; 2]); 2]; 2],
    across: Vec<usize>,
}

impl<'a, 'b> Lines<'a, 'b> {
    fn new(skin: &'a mut Skin<'b>, hole: &'a Hole) -> Result<Self> {
        let [_, front, back, rear, count] = hole.sides;
        // As if the hole were upright.
        let angle = |node: &Node| 2.0 * node.half[1].atan2(node.half[0]) - hole.slant * node.along;
        let angles = || hole.nodes.iter().map(angle);
        let (low, high) = (angles().fold(f64::INFINITY, f64::min), angles().fold(f64::NEG_INFINITY, f64::max));
        let (middle, behind) = (0.5 * (low + high), behind(0.5 * (high - low)));
        let mut lines = Self {
            skin,
            mantle: hole.mantle,
            stretch: hole.stretch,
            vertices: [Vec::new(), Vec::new()],
            places: [Vec::new(), Vec::new()],
            angles: [Vec::new(), Vec::new()],
            edges: [Vec::new(), Vec::new()],
            rulings: [Vec::new(), Vec::new()],
            arcs: [Vec::new(), Vec::new()],
            outermost: [[(0, [0.0; 2]); 2]; 2],
            across: Vec::new(),
        };
        // The nodes beside the hole from low places to high ones.
        let nodes = [(front..=back).rev().collect::<Vec<_>>(), (rear..=count).collect()];
        for (line, nodes) in nodes.into_iter().enumerate() {
            let along = nodes.iter().map(|&k| hole.nodes[k % count].along);
            let places: Vec<f64> =
                std::iter::once(hole.stretch[0]).chain(along).chain(std::iter::once(hole.stretch[1])).collect();
            // Beyond the hole lines are straight.
            let last = nodes.len();
            let upright = if line == 0 { middle + behind } else { middle - behind };
            let angles: Vec<f64> = (0..places.len()).map(|k| upright + hole.slant * places[k.clamp(1, last)]).collect();
            let points = places.iter().zip(&angles).map(|(&at, &angle)| lines.mantle.point(half(angle), at));
            let vertices: Vec<usize> = points.map(|p| lines.skin.sewing.vertex(p)).collect();
            for k in 0..=last {
                let ends = [vertices[k], vertices[k + 1]];
                let edge = if angles[k] - angles[k + 1] == 0.0 {
                    lines.skin.sewing.segment(ends[0], ends[1])?
                } else {
                    let along = Polynomial::new(vec![places[k], places[k + 1]]);
                    let border = between([half(angles[k]), half(angles[k + 1])]);
                    let row = lines.mantle.border(&border, &along, &Polynomial::constant(1.0));
                    lines.skin.edge(ends, RationalBezier::from_polynomial_row(&row).into())
                };
                lines.edges[line].push(edge);
            }
            for (j, &k) in nodes.iter().enumerate() {
                let (contact, vertex) = (hole.contacts[k % count], vertices[j + 1]);
                let ends = [contact, vertex].map(|v| lines.skin.sewing.vertices[v]);
                let arc = lines.mantle.arc(ends, hole.nodes[k % count].half, half(angles[j + 1]))?;
                let edge = lines.skin.sewing.edge(contact, vertex, arc);
                lines.arcs[line].push(edge);
            }
            let outer = |k: usize| (hole.contacts[k % count], hole.nodes[k % count].half);
            lines.outermost[line] = [outer(nodes[0]), outer(nodes[nodes.len() - 1])];
            (lines.vertices[line], lines.places[line], lines.angles[line]) = (vertices, places, angles);
        }
        Ok(lines)
    }

    fn add(&mut self, surface: RationalBezierSurface, vertices: [usize; 4], edges: [usize; 4]) {
        let corners = vertices.map(|v| self.skin.sewing.vertices[v]);
        let surface = surface.with_corners(corners);
        let middle = surface.point(0.5, 0.5);
        let outwards = self.mantle.off_axis(middle);
        let starts = [vertices[0], vertices[2], vertices[0], vertices[1]];
        self.skin.face(surface, edges, starts, outwards);
    }

    /// A part ruled from the hole to an end of the stretch, with its edge there.
    #[expect(clippy::too_many_arguments, reason = "one piece of one side, with the borders that it shares")]
    fn ruled(
        &mut self,
        piece: &HolePiece,
        at: f64,
        contacts: [usize; 2],
        edge: usize,
        ring: &mut Ring,
        rulings: &[usize],
        j: usize,
    ) -> Result<()> {
        let ends = [ring.vertices[j], ring.vertices[j + 1]];
        let end_edge =
            self.skin.edge(ends, RationalBezier::from_polynomial_row(&self.mantle.circle(&piece.half, at)).into());
        ring.edges.push(end_edge);
        ring.along.push(piece.half.clone());
        let rows: [PolynomialRow; 2] = [
            self.mantle.border(&piece.half, &piece.along, &piece.weight),
            self.mantle.border(&piece.half, &(&piece.weight * at), &piece.weight),
        ];
        let surface = RationalBezierSurface::from_polynomial_rows(&rows)?;
        self.add(surface, [contacts[0], contacts[1], ends[0], ends[1]], [edge, end_edge, rulings[j], rulings[j + 1]]);
        Ok(())
    }

    /// The parts beside the hole, with arcs to a line.
    fn beside(&mut self, hole: &Hole, [from, to]: [usize; 2], line: usize) -> Result<()> {
        let count = hole.pieces.len();
        let steps = to - from;
        for (k, piece) in hole.pieces.iter().enumerate().take(to).skip(from) {
            // Lines run from low places to high ones, the loop comes back along the first.
            let place = |node: usize| if line == 0 { steps - (node - from) } else { node - from };
            let (start, end) = (place(k), place(k + 1));
            let contacts = [hole.contacts[k], hole.contacts[(k + 1) % count]];
            let vertices = [start, end].map(|p| self.vertices[line][p + 1]);
            let size = |end: f64| {
                let [c, s] = piece.half.each_ref().map(|p| p.value(end));
                c.hypot(s)
            };
            let even = Polynomial::new(vec![size(0.0), size(1.0)]);
            let straight = Polynomial::new([start, end].map(|p| self.places[line][p + 1]).to_vec());
            let first = Border { half: piece.half.clone(), along: piece.along.clone() };
            let targets = [start, end].map(|p| half(self.angles[line][p + 1]));
            let second = Border {
                half: between(targets).map(|coordinate| &coordinate * &even),
                along: &straight * &piece.weight,
            };
            let surface = self.mantle.between(&piece.weight, &first, &second)?;
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

    /// Half directions of both lines behind at a vertex, the second as it is reached from the first.
    fn behind_at(&self, k: usize) -> [[f64; 2]; 2] {
        [half(self.angles[0][k]), half(self.angles[1][k] + TAU)]
    }

    /// The parts behind, between both lines.
    fn behind(&mut self) -> Result<()> {
        let one = Polynomial::constant(1.0);
        let last = self.places[0].len() - 1;
        // Of the hole, not of the stretch, which may be long.
        let [from, to] = [self.places[0][1], self.places[0][last - 1]];
        let rounding = 1e-13 * (self.mantle.radius + (to - from).abs()) + 8.0 * f64::EPSILON * from.abs().max(to.abs());
        for k in 0..=last {
            let ends = [0, 1].map(|line: usize| self.vertices[line][k]);
            let points = ends.map(|v| self.skin.sewing.vertices[v]);
            let mut along = [self.places[0][k], self.places[1][k]];
            // What is rounding is none.
            if (along[0] - along[1]).abs() <= rounding {
                along[1] = along[0];
            }
            let curve = self.mantle.across(points, self.behind_at(k), along)?;
            let edge = self.skin.edge(ends, curve);
            self.across.push(edge);
        }
        for k in 0..last {
            let [starts, ends] = [self.behind_at(k), self.behind_at(k + 1)];
            let border = |line: usize| Border {
                half: between([starts[line], ends[line]]),
                along: Polynomial::new(vec![self.places[line][k], self.places[line][k + 1]]),
            };
            let surface = self.mantle.between(&one, &border(0), &border(1))?;
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
            let target = half(self.angles[line][place]);
            let (contact, from) = self.outermost[line][side];
            let (vertex, ruling) = if line == 0 {
                (ring.vertices[ring.vertices.len() - 1], self.rulings[side][self.rulings[side].len() - 1])
            } else {
                (ring.vertices[0], self.rulings[side][0])
            };
            let behind = self.vertices[line][place];
            let ends = [vertex, behind].map(|v| self.skin.sewing.vertices[v]);
            let arc: Arc = self.mantle.arc(ends, from, target)?;
            let edge = self.skin.sewing.edge(vertex, behind, arc);
            let beside = self.vertices[line][if side == 0 { 1 } else { last - 1 }];
            let segment = self.edges[line][if side == 0 { 0 } else { last - 1 }];
            let places = vec![self.places[line][if side == 0 { 1 } else { last - 1 }], self.stretch[side]];
            let border = |half: [f64; 2]| Border {
                half: half.map(Polynomial::constant),
                along: Polynomial::new(places.clone()),
            };
            let surface = self.mantle.between(&one, &border(from), &border(target))?;
            let edges = [ruling, segment, self.arcs[line][inside], edge];
            self.add(surface, [contact, vertex, beside, behind], edges);
            corner_edges.push((edge, from));
        }
        // Once round: to the first line, behind to the second, and back.
        let [first, second] = self.behind_at(place);
        let as_from_hole = half(self.angles[1][place]);
        let high = corner_edges[0].1;
        let low = corner_edges[1].1;
        ring.edges.extend([corner_edges[0].0, self.across[place], corner_edges[1].0]);
        ring.vertices.extend([0, 1].map(|line: usize| self.vertices[line][place]));
        ring.halves.extend([first, as_from_hole]);
        ring.along.extend([between([high, first]), between([first, second]), between([as_from_hole, low])]);
        Ok(ring)
    }
}
