//! Lines across a pipe or along it, from vertex to vertex, and the strip between two of them: faces of four sides where their steps face each other, of three where
//! one has more; exact.

use super::mantle::{Border, Mantle, between, half};
use super::skin::{Ring, Skin};
use crate::error::Result;
use crate::rational::Polynomial;
use std::f64::consts::TAU;

/// A step of both lines is one face if that leaves them no farther apart along the strip than this many times what a step of one does.
const FACING: f64 = 1.5;
/// Half directions whose sine is below this are one.
const SAME_DIRECTION: f64 = 5e-13;

/// A line on a pipe.
#[derive(Debug, Clone)]
pub(in crate::construct::bodies) struct Rail {
    vertices: Vec<usize>,
    edges: Vec<usize>,
    angles: Vec<f64>,
    places: Vec<f64>,
    /// Across the pipe, half directions along the edges, of length 1 at both ends and on the sheet of the angles; a line along it is straight in half
    /// directions and places.
    across: Option<Vec<[Polynomial; 2]>>,
}

/// Which vertices of two lines are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::construct::bodies) enum Pairing {
    /// Each with the one of its number: the lines have as many.
    NodeByNode,
    /// Such as are near.
    Nearest,
}

impl Rail {
    /// A line along a pipe.
    pub(in crate::construct::bodies) fn lengthwise(
        vertices: Vec<usize>,
        edges: Vec<usize>,
        places: Vec<f64>,
        angles: Vec<f64>,
    ) -> Self {
        Self { vertices, edges, angles, places, across: None }
    }

    /// An open part of a ring at a place, its first angle as near to another as whole turns allow.
    pub(in crate::construct::bodies) fn of_part(part: &Ring, place: f64, near: Option<f64>) -> Self {
        let all: Vec<f64> = part.angles().collect();
        let mut angles = vec![near.map_or(all[0], |near| all[0] - TAU * ((all[0] - near) / TAU).round())];
        for pair in all.windows(2) {
            angles.push(angles[angles.len() - 1] + (pair[1] - pair[0]).rem_euclid(TAU));
        }
        let across = part.along.iter().zip(angles.windows(2)).map(|(way, ends)| on_sheet(way, ends)).collect();
        let places = vec![place; angles.len()];
        Self { vertices: part.vertices.clone(), edges: part.edges.clone(), angles, places, across: Some(across) }
    }

    /// The line about the pipe by an angle farther, of which the lines of its own know nothing.
    pub(in crate::construct::bodies) fn turned(mut self, angle: f64) -> Self {
        debug_assert!(self.across.is_none());
        self.angles.iter_mut().for_each(|own| *own += angle);
        self
    }

    /// Two lines along a pipe with the edge between them.
    pub(in crate::construct::bodies) fn followed_by(mut self, edge: usize, other: Self) -> Self {
        self.vertices.extend(other.vertices);
        self.edges.push(edge);
        self.edges.extend(other.edges);
        self.angles.extend(other.angles);
        self.places.extend(other.places);
        self
    }

    pub(in crate::construct::bodies) fn first_angle(&self) -> f64 {
        self.angles[0]
    }

    /// The half direction at an end.
    pub(in crate::construct::bodies) fn end(&self, last: bool) -> (usize, [f64; 2]) {
        let k = if last { self.edges.len() } else { 0 };
        (self.vertices[k], half(self.angles[k]))
    }

    fn is_closed(&self) -> bool {
        self.vertices.first() == self.vertices.last()
    }

    /// What grows along the line.
    fn keys(&self) -> &[f64] {
        if self.across.is_some() { &self.angles } else { &self.places }
    }

    /// The border along a step, or at a vertex.
    fn border(&self, k: usize, moves: usize) -> Border {
        if moves == 0 {
            return Border {
                half: half(self.angles[k]).map(Polynomial::constant),
                along: Polynomial::constant(self.places[k]),
            };
        }
        match &self.across {
            Some(ways) => Border { half: ways[k].clone(), along: Polynomial::constant(self.places[k]) },
            None => Border {
                half: between([half(self.angles[k]), half(self.angles[k + 1])]),
                along: Polynomial::new(vec![self.places[k], self.places[k + 1]]),
            },
        }
    }

    fn side(&self, k: usize, moves: usize) -> Option<(usize, usize)> {
        (moves == 1).then(|| (self.edges[k], self.vertices[k]))
    }

    /// With the places of another line where they differ by rounding.
    fn settled(&self, other: &Self, radius: f64) -> Self {
        let mut settled = self.clone();
        if self.across.is_some() {
            return settled;
        }
        // Of the holes, not of the pipe, which may be long.
        let inside = self.places.get(1..self.places.len() - 1).unwrap_or_default();
        let (low, high) = inside.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &x| (a.min(x), b.max(x)));
        let rounding = 1e-13 * (radius + (high - low).max(0.0)) + 8.0 * f64::EPSILON * low.abs().max(high.abs());
        for place in &mut settled.places {
            if let Some(same) = other.places.iter().find(|x| (**x - *place).abs() <= rounding) {
                *place = *same;
            }
        }
        settled
    }
}

/// Half directions along an edge, of length 1 at both ends, on the sheet of its angles.
fn on_sheet(way: &[Polynomial; 2], ends: &[f64]) -> [Polynomial; 2] {
    let value = |p: &Polynomial, last: bool| p.coefficients()[if last { p.degree() } else { 0 }];
    let size = |angle: f64, last: bool| {
        let ([c, s], [own, beside]) = (way.each_ref().map(|p| value(p, last)), half(angle));
        (c * own + s * beside).signum() / c.hypot(s)
    };
    let even = Polynomial::new(vec![size(ends[0], false), size(ends[1], true)]);
    way.each_ref().map(|p| p * &even)
}

impl Pairing {
    /// How far both lines go on with the next face.
    fn moves(self, rails: [&Rail; 2], at: [usize; 2]) -> [usize; 2] {
        let left = [0, 1].map(|k: usize| rails[k].edges.len() - at[k]);
        match left {
            [0, _] => return [0, 1],
            [_, 0] => return [1, 0],
            [1, 1] => return [1, 1],
            _ if self == Self::NodeByNode => return [1, 1],
            _ => {}
        }
        // How far both ends of the next edge across would be apart along the strip.
        let [first, second] = rails.map(Rail::keys);
        let apart = |moves: [usize; 2]| (first[at[0] + moves[0]] - second[at[1] + moves[1]]).abs();
        let alone = [apart([1, 0]), apart([0, 1])];
        if apart([1, 1]) <= FACING * alone[0].min(alone[1]) {
            [1, 1]
        } else if alone[0] < alone[1] {
            [1, 0]
        } else {
            [0, 1]
        }
    }
}

impl Skin<'_> {
    /// The faces between two lines, of which the second is farther along the pipe or farther round it, and the edges between their first and their last
    /// vertices: one if both go all round.
    ///
    /// # Errors
    /// As [`RationalBezierSurface::new`](crate::rational::RationalBezierSurface::new).
    pub(in crate::construct::bodies) fn between_rails(
        &mut self,
        mantle: &Mantle,
        [first, second]: [&Rail; 2],
        pairing: Pairing,
    ) -> Result<[usize; 2]> {
        let settled = second.settled(first, mantle.radius);
        let rails = [first, &settled];
        let last = rails.map(|rail| rail.edges.len());
        let closed = rails.iter().all(|rail| rail.is_closed());
        let one = Polynomial::constant(1.0);
        let mut at = [0, 0];
        let start = self.link(mantle, rails, at)?;
        let mut before = start;
        while at != last {
            let moves = pairing.moves(rails, at);
            let to = [0, 1].map(|k: usize| at[k] + moves[k]);
            let behind = if closed && to == last { start } else { self.link(mantle, rails, to)? };
            let borders = [0, 1].map(|k: usize| rails[k].border(at[k], moves[k]));
            let surface = mantle.between(&one, &borders[0], &borders[1])?;
            let vertex = |k: usize, of: [usize; 2]| rails[k].vertices[of[k]];
            let vertices = [vertex(0, at), vertex(0, to), vertex(1, at), vertex(1, to)];
            let surface = surface.with_corners(vertices.map(|v| self.sewing.vertices[v]));
            let outwards = mantle.off_axis(surface.point(0.5, 0.5)) * if self.inner { -1.0 } else { 1.0 };
            let [side, beside] = [0, 1].map(|k: usize| rails[k].side(at[k], moves[k]));
            self.plane_face(
                surface,
                [side, beside, Some((before, vertices[0])), Some((behind, vertices[1]))],
                outwards,
            );
            (at, before) = (to, behind);
        }
        Ok([start, before])
    }

    /// The edge between a vertex of one line and one of the other.
    fn link(&mut self, mantle: &Mantle, rails: [&Rail; 2], at: [usize; 2]) -> Result<usize> {
        let ends = [0, 1].map(|k: usize| rails[k].vertices[at[k]]);
        let halves = [0, 1].map(|k: usize| half(rails[k].angles[at[k]]));
        let [[a, b], [c, d]] = halves;
        if (a * d - b * c).abs() <= SAME_DIRECTION {
            return self.sewing.segment(ends[0], ends[1]);
        }
        let points = ends.map(|v| self.sewing.vertices[v]);
        let curve = mantle.across(points, halves, [0, 1].map(|k: usize| rails[k].places[at[k]]))?;
        Ok(self.edge(ends, curve))
    }
}
