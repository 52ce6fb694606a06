//! The part of a pipe round a hole, between two lines along the pipe: rulings to its ends, arcs beside it, and corners (`docs/math/pipe-tees.md#faces`).

use super::mantle::{Border, Mantle, between, half};
use super::rail::Rail;
use super::skin::{Ring, Skin};
use crate::error::Result;
use crate::rational::{Polynomial, PolynomialRow, RationalBezier, RationalBezierSurface};

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

/// What has been sewn round a hole: from its line at low angles to that at high ones.
pub(super) struct Part {
    /// At the start and at the end of the stretch, open, from the low line to the high one.
    pub(super) rings: [Ring; 2],
    /// At high angles and at low ones.
    pub(super) lines: [Rail; 2],
}

/// The faces that are ruled from a hole to one end of the stretch.
pub(super) struct RuledSide {
    /// Open, from low angles to high ones.
    pub(super) ring: Ring,
    /// From the hole to the vertices of that.
    pub(super) rulings: Vec<usize>,
}

impl Hole {
    /// The middle of its angles, as if it were upright, and how far they reach to either side.
    pub(super) fn breadth(&self) -> [f64; 2] {
        let angle = |node: &Node| 2.0 * node.half[1].atan2(node.half[0]) - self.slant * node.along;
        let angles = || self.nodes.iter().map(angle);
        let (low, high) = (angles().fold(f64::INFINITY, f64::min), angles().fold(f64::NEG_INFINITY, f64::max));
        [0.5 * (low + high), 0.5 * (high - low)]
    }
}

impl Skin<'_> {
    /// The part of a pipe round a hole, between lines at these angles in its axes, high and low.
    ///
    /// # Errors
    /// As [`RationalBezierSurface::new`].
    pub(super) fn round_hole(&mut self, hole: &Hole, angles: [f64; 2]) -> Result<Part> {
        let [_, front, back, rear, count] = hole.sides;
        let start = self.ruled_side(hole, 0, [None; 2])?;
        let end = self.ruled_side(hole, 1, [None; 2])?;
        // The nodes beside the hole from low places to high ones.
        let high = self.line(hole, (front..=back).rev().collect(), angles[0])?;
        let low = self.line(hole, (rear..=count).collect(), angles[1])?;
        self.beside(hole, [front, back], &high, true)?;
        self.beside(hole, [rear, count], &low, false)?;
        let rings =
            [self.with_corners(hole, start, [&high, &low], 0)?, self.with_corners(hole, end, [&high, &low], 1)?];
        Ok(Part { rings, lines: [high, low].map(Line::into_rail) })
    }

    /// What is ruled from a hole towards the start or the end of its stretch. The outermost rulings may be there already, with their vertices there.
    pub(super) fn ruled_side(
        &mut self,
        hole: &Hole,
        side: usize,
        known: [Option<(usize, usize)>; 2],
    ) -> Result<RuledSide> {
        let [first, front, back, rear, count] = hole.sides;
        let at = hole.stretch[side];
        let nodes = if side == 1 { first..front } else { back..rear };
        // The loop comes back from high angles to low ones.
        let mut order: Vec<usize> = (nodes.start..=nodes.end).collect();
        let mut steps: Vec<usize> = nodes.collect();
        if side == 0 {
            order.reverse();
            steps.reverse();
        }
        let (mut ring, mut rulings) = (Ring::default(), Vec::new());
        let last = order.len() - 1;
        for (j, &k) in order.iter().enumerate() {
            let half = hole.nodes[k % count].half;
            let there = if j == 0 {
                known[0]
            } else if j == last {
                known[1]
            } else {
                None
            };
            let (vertex, ruling) = match there {
                Some(both) => both,
                None => {
                    let vertex = self.sewing.vertex(hole.mantle.point(half, at));
                    (vertex, self.sewing.segment(hole.contacts[k % count], vertex)?)
                }
            };
            ring.vertices.push(vertex);
            ring.halves.push(half);
            rulings.push(ruling);
        }
        for (j, &k) in steps.iter().enumerate() {
            let piece = &hole.pieces[k];
            // As the loop runs.
            let [from, to] = if side == 1 { [j, j + 1] } else { [j + 1, j] };
            let ends = [from, to].map(|j| ring.vertices[j]);
            let circle = RationalBezier::from_polynomial_row(&hole.mantle.circle(&piece.half, at));
            let edge = self.edge(ends, circle.into());
            ring.edges.push(edge);
            ring.along.push(if side == 1 {
                piece.half.clone()
            } else {
                piece.half.each_ref().map(Polynomial::reversed)
            });
            let rows: [PolynomialRow; 2] = [
                hole.mantle.border(&piece.half, &piece.along, &piece.weight),
                hole.mantle.border(&piece.half, &(&piece.weight * at), &piece.weight),
            ];
            let surface = RationalBezierSurface::from_polynomial_rows(&rows)?;
            let contacts = [hole.contacts[k], hole.contacts[(k + 1) % count]];
            let edges = [hole.edges[k], edge, rulings[from], rulings[to]];
            self.part_of_pipe(&hole.mantle, surface, [contacts[0], contacts[1], ends[0], ends[1]], edges);
        }
        Ok(RuledSide { ring, rulings })
    }

    /// A line beside a hole at an angle, with arcs to it from these nodes.
    fn line(&mut self, hole: &Hole, nodes: Vec<usize>, upright: f64) -> Result<Line> {
        let (count, last) = (hole.pieces.len(), nodes.len());
        let along = nodes.iter().map(|&k| hole.nodes[k % count].along);
        let places: Vec<f64> =
            std::iter::once(hole.stretch[0]).chain(along).chain(std::iter::once(hole.stretch[1])).collect();
        // Beyond the hole lines are straight.
        let angles: Vec<f64> = (0..places.len()).map(|k| upright + hole.slant * places[k.clamp(1, last)]).collect();
        let points = places.iter().zip(&angles).map(|(&at, &angle)| hole.mantle.point(half(angle), at));
        let vertices: Vec<usize> = points.map(|p| self.sewing.vertex(p)).collect();
        let mut line = Line {
            vertices,
            places,
            angles,
            edges: Vec::new(),
            arcs: Vec::new(),
            ends: [0, last - 1].map(|j| nodes[j] % count),
        };
        for k in 0..=last {
            let ends = [line.vertices[k], line.vertices[k + 1]];
            let edge = if line.angles[k] - line.angles[k + 1] == 0.0 {
                self.sewing.segment(ends[0], ends[1])?
            } else {
                let along = Polynomial::new(vec![line.places[k], line.places[k + 1]]);
                let border = between([half(line.angles[k]), half(line.angles[k + 1])]);
                let row = hole.mantle.border(&border, &along, &Polynomial::constant(1.0));
                self.edge(ends, RationalBezier::from_polynomial_row(&row).into())
            };
            line.edges.push(edge);
        }
        for (j, &k) in nodes.iter().enumerate() {
            let (contact, vertex) = (hole.contacts[k % count], line.vertices[j + 1]);
            let ends = [contact, vertex].map(|v| self.sewing.vertices[v]);
            let arc = hole.mantle.arc(ends, hole.nodes[k % count].half, half(line.angles[j + 1]))?;
            line.arcs.push(self.sewing.edge(contact, vertex, arc));
        }
        Ok(line)
    }

    fn part_of_pipe(
        &mut self,
        mantle: &Mantle,
        surface: RationalBezierSurface,
        vertices: [usize; 4],
        edges: [usize; 4],
    ) {
        let surface = surface.with_corners(vertices.map(|v| self.sewing.vertices[v]));
        let outwards = mantle.off_axis(surface.point(0.5, 0.5));
        self.face(surface, edges, [vertices[0], vertices[2], vertices[0], vertices[1]], outwards);
    }

    /// The parts beside a hole, with arcs to a line.
    fn beside(&mut self, hole: &Hole, [from, to]: [usize; 2], line: &Line, is_high: bool) -> Result<()> {
        let count = hole.pieces.len();
        let steps = to - from;
        for (k, piece) in hole.pieces.iter().enumerate().take(to).skip(from) {
            // Lines run from low places to high ones, the loop comes back along the one at high angles.
            let place = |node: usize| if is_high { steps - (node - from) } else { node - from };
            let (start, end) = (place(k), place(k + 1));
            let contacts = [hole.contacts[k], hole.contacts[(k + 1) % count]];
            let vertices = [start, end].map(|p| line.vertices[p + 1]);
            let size = |end: f64| {
                let [c, s] = piece.half.each_ref().map(|p| p.value(end));
                c.hypot(s)
            };
            let even = Polynomial::new(vec![size(0.0), size(1.0)]);
            let straight = Polynomial::new([start, end].map(|p| line.places[p + 1]).to_vec());
            let first = Border { half: piece.half.clone(), along: piece.along.clone() };
            let targets = [start, end].map(|p| half(line.angles[p + 1]));
            let second = Border {
                half: between(targets).map(|coordinate| &coordinate * &even),
                along: &straight * &piece.weight,
            };
            let surface = hole.mantle.between(&piece.weight, &first, &second)?;
            let arcs = [start, end].map(|p| line.arcs[p]);
            let segment = line.edges[start.min(end) + 1];
            let vertices = [contacts[0], contacts[1], vertices[0], vertices[1]];
            self.part_of_pipe(&hole.mantle, surface, vertices, [hole.edges[k], segment, arcs[0], arcs[1]]);
        }
        Ok(())
    }

    /// The corners between what is ruled to an end of the stretch and both lines, high and low: the ring there, open.
    fn with_corners(&mut self, hole: &Hole, ruled: RuledSide, lines: [&Line; 2], side: usize) -> Result<Ring> {
        let RuledSide { mut ring, rulings } = ruled;
        let one = Polynomial::constant(1.0);
        for (k, line) in lines.into_iter().enumerate() {
            let last = line.places.len() - 1;
            let (place, beside, segment, inside) =
                if side == 0 { (0, 1, 0, 0) } else { (last, last - 1, last - 1, line.arcs.len() - 1) };
            let target = half(line.angles[place]);
            let node = line.ends[side];
            let (contact, from) = (hole.contacts[node], hole.nodes[node].half);
            // At the end at high angles or at low ones.
            let outermost = if k == 0 { rulings.len() - 1 } else { 0 };
            let (vertex, ruling) = (ring.vertices[outermost], rulings[outermost]);
            let behind = line.vertices[place];
            let ends = [vertex, behind].map(|v| self.sewing.vertices[v]);
            let arc = hole.mantle.arc(ends, from, target)?;
            let edge = self.sewing.edge(vertex, behind, arc);
            let places = vec![line.places[beside], hole.stretch[side]];
            let border = |half: [f64; 2]| Border {
                half: half.map(Polynomial::constant),
                along: Polynomial::new(places.clone()),
            };
            let surface = hole.mantle.between(&one, &border(from), &border(target))?;
            let edges = [ruling, line.edges[segment], line.arcs[inside], edge];
            self.part_of_pipe(&hole.mantle, surface, [contact, vertex, line.vertices[beside], behind], edges);
            let at = if k == 0 { ring.vertices.len() } else { 0 };
            ring.vertices.insert(at, behind);
            ring.halves.insert(at, target);
            let (at, way) = if k == 0 { (ring.edges.len(), [from, target]) } else { (0, [target, from]) };
            ring.edges.insert(at, edge);
            ring.along.insert(at, between(way));
        }
        Ok(ring)
    }
}

/// A line beside a hole.
struct Line {
    /// From the start to the end of the stretch, with their places and angles as they are reached from the hole, and edges between them.
    vertices: Vec<usize>,
    places: Vec<f64>,
    angles: Vec<f64>,
    edges: Vec<usize>,
    /// The arcs from the hole, from low places to high ones.
    arcs: Vec<usize>,
    /// The nodes of the first and the last of these.
    ends: [usize; 2],
}

impl Line {
    fn into_rail(self) -> Rail {
        Rail::lengthwise(self.vertices, self.edges, self.places, self.angles)
    }
}
