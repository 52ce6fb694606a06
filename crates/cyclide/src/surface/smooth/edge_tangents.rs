//! The directions in which the edges of a smooth mesh leave their vertices.
//!
//! Between smooth faces it is that of the chord, without its part along the normal. An open boundary takes the tangents of the circles
//! through three neighboring vertices, without their parts along the normals: it is smooth, and of points of a circle that circle.
//! A crease runs in both tangent planes at its vertices: along the product of their normals.

use super::connect::{Connections, MeshEdge};
use super::side::tangent_across;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Chord;
use crate::error::Result;

/// A boundary that turns by more at a vertex has a corner there, radians: 60 degrees.
const BOUNDARY_CORNER: f64 = std::f64::consts::FRAC_PI_3;
/// Normals on both sides of a crease at a smaller angle than this (its sine) do not tell the direction of the crease.
const FAINT_CREASE: f64 = 0.05;
/// A crease that leaves its chord by more than this, as a cosine, is taken for a corner.
const CREASE_OFF_CHORD: f64 = 0.5;

/// All that the tangents of edges are made from.
pub(super) struct EdgeTangents<'a> {
    pub(super) positions: &'a [Point3],
    pub(super) triangles: &'a [[usize; 3]],
    pub(super) connections: &'a Connections,
    /// Unit normals of the fans.
    pub(super) normals: &'a [Vec3],
    /// Boundary vertices before and behind each fan, where it has both.
    boundary: Vec<[Option<usize>; 2]>,
}

impl<'a> EdgeTangents<'a> {
    pub(super) fn new(
        positions: &'a [Point3],
        triangles: &'a [[usize; 3]],
        connections: &'a Connections,
        normals: &'a [Vec3],
    ) -> Self {
        let mut boundary = vec![[None; 2]; normals.len()];
        for edge in connections.edges.iter().filter(|edge| edge.second.is_none()) {
            let (side, fans) = (edge.first, connections.fans[edge.first.triangle]);
            let [from, to] = side.ends();
            let vertices = triangles[side.triangle];
            boundary[fans[from]][1] = Some(vertices[to]);
            boundary[fans[to]][0] = Some(vertices[from]);
        }
        Self { positions, triangles, connections, normals, boundary }
    }

    /// How many corners the boundary has.
    pub(super) fn boundary_corners(&self) -> usize {
        let is_corner = |fan: &usize| self.boundary_turn(*fan).is_some_and(|[into, out]| is_corner(&into, &out));
        (0..self.boundary.len()).filter(is_corner).count()
    }

    /// The chords of the boundary to and from the vertex of a fan.
    fn boundary_turn(&self, fan: usize) -> Option<[Chord; 2]> {
        let [before, behind] = self.boundary[fan];
        let vertex = self.connections.fan_vertices[fan];
        let [a, b, c] = [before?, vertex, behind?].map(|v| self.positions[v]);
        Some([Chord::new(a, b), Chord::new(b, c)])
    }

    /// Unit tangents at both ends of an edge, along its curve from the lower vertex.
    ///
    /// # Errors
    /// `normal-along-edge`.
    pub(super) fn of(&self, edge: &MeshEdge, chord: &Chord) -> Result<[Vec3; 2]> {
        let start = self.at(edge, chord, 0)?;
        Ok([start, self.at(edge, chord, 1)?])
    }

    fn at(&self, edge: &MeshEdge, chord: &Chord, end: usize) -> Result<Vec3> {
        let vertex = edge.vertices[end];
        let corner_of = |triangle: usize| self.triangles[triangle].iter().position(|v| *v == vertex).unwrap_or(0);
        let corner = corner_of(edge.first.triangle);
        let fan = |triangle: usize| self.connections.fans[triangle][corner_of(triangle)];
        let first = fan(edge.first.triangle);
        let normal = self.normals[first];
        let special = match edge.second {
            None => self.along_boundary(edge, first, normal),
            Some(second) if edge.sharp => {
                let other = self.normals[fan(second.triangle)];
                along_crease(chord.unit, normal, other)
            }
            Some(_) => None,
        };
        special.map_or_else(|| tangent_across(chord.unit, normal, corner).map(|(tangent, _)| tangent), Ok)
    }

    /// The tangent of the boundary at the vertex of a fan, in the direction of the edge; `None` at its corners.
    fn along_boundary(&self, edge: &MeshEdge, fan: usize, normal: Vec3) -> Option<Vec3> {
        let [into, out] = self.boundary_turn(fan)?;
        if is_corner(&into, &out) {
            return None;
        }
        let forwards = self.triangles[edge.first.triangle][edge.first.ends()[0]] == edge.vertices[0];
        let tangent = tangent_across(into.tangent_to(&out)?, normal, 0).ok()?.0;
        Some(if forwards { tangent } else { -tangent })
    }
}

fn is_corner(into: &Chord, out: &Chord) -> bool {
    into.turn(out) > BOUNDARY_CORNER
}

/// The tangent of a crease: in both tangent planes, or across the mean normal where that does not tell.
fn along_crease(chord: Vec3, normal: Vec3, other: Vec3) -> Option<Vec3> {
    let both = normal.cross(other);
    if let Some(line) =
        both.unit().filter(|line| both.length() > FAINT_CREASE && line.dot(chord).abs() > CREASE_OFF_CHORD)
    {
        return Some(if line.dot(chord) > 0.0 { line } else { -line });
    }
    let mean = (normal + other).unit()?;
    tangent_across(chord, mean, 0).ok().map(|(tangent, _)| tangent)
}
