//! Principal directions on the triangles: an angle each, how it turns over edges, and the singular places of the field.

use std::f64::consts::PI;

use super::mesh_table::{MeshTable, NONE, before};
use super::shape_tensors::{Tensor, product};
use cyclide::Vec3;

/// A line in each triangle, the direction of the larger principal curvature.
#[derive(Debug, Clone)]
pub(super) struct CrossField {
    /// A unit vector of each triangle along the line; its sign means nothing before combing.
    pub(super) along: Vec<Vec3>,
    /// Difference of the eigenvalues.
    pub(super) confidence: Vec<f64>,
}

/// Where a field has no direction: how often it turns round there, in halves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct SingularVertex {
    pub(super) vertex: usize,
    pub(super) halves: i32,
}

impl CrossField {
    /// The mean of the corners' tensors, in the plane of each triangle.
    pub(super) fn new(table: &MeshTable, tensors: &[Tensor]) -> Self {
        let mut field = Self { along: Vec::new(), confidence: Vec::new() };
        for (f, corners) in table.triangles.iter().enumerate() {
            let mean: Tensor = std::array::from_fn(|k| corners.iter().map(|&v| tensors[v][k]).sum::<f64>() / 3.0);
            let normal = table.normals[f];
            let x = table.vector(3 * f).unit().unwrap_or_else(|| normal.any_perpendicular());
            let y = normal.cross(x);
            let p = 0.5 * (product(&mean, x, x) - product(&mean, y, y));
            let q = product(&mean, x, y);
            let angle = 0.5 * q.atan2(p);
            field.along.push(x * angle.cos() + y * angle.sin());
            field.confidence.push(2.0 * p.hypot(q));
        }
        field
    }

    /// The angle of a triangle's line to one of its half edges, or to the half edge's twin's direction.
    fn angle_to(&self, table: &MeshTable, f: usize, edge: Vec3) -> f64 {
        let side = table.normals[f].cross(edge);
        self.along[f].dot(side).atan2(self.along[f].dot(edge))
    }

    /// By how much the line turns over a half edge, from its triangle to the other: as little as can be.
    fn turn(&self, table: &MeshTable, half: usize) -> f64 {
        let (edge, other) = (table.vector(half), table.twin(half));
        let turn = self.angle_to(table, other / 3, edge) - self.angle_to(table, half / 3, edge);
        turn - PI * (turn / PI).round()
    }

    /// True if the directions of two triangles agree over a half edge, and do not point opposite ways.
    pub(super) fn agrees(&self, table: &MeshTable, half: usize) -> bool {
        let (edge, other) = (table.vector(half), table.twin(half));
        let turn = self.angle_to(table, other / 3, edge) - self.angle_to(table, half / 3, edge);
        turn.cos() >= 0.0
    }

    /// The turns round a vertex, from the first triangle of its fan to the last, or round to the first.
    fn turn_of_fan(&self, table: &MeshTable, vertex: usize) -> f64 {
        // Counter-clockwise from one triangle into the next: over the half edge that ends at the vertex.
        table.fan(vertex).map(before).filter(|half| table.twin(*half) != NONE).map(|half| self.turn(table, half)).sum()
    }

    /// Vertices inside round which the line turns.
    pub(super) fn singular_vertices(&self, table: &MeshTable) -> Vec<SingularVertex> {
        let inside = (0..table.points.len()).filter(|v| !table.is_on_border(*v));
        let index = |vertex: usize| {
            let angles: f64 = table.fan(vertex).map(|half| table.angle(half)).sum();
            let turns = self.turn_of_fan(table, vertex) + 2.0 * PI - angles;
            SingularVertex { vertex, halves: (turns / PI).round() as i32 }
        };
        inside.map(index).filter(|s| s.halves != 0).collect()
    }

    /// How often the line turns round in what would fill a loop of the border, in halves: 0 for the hole in a roof, 2 for the ends of a
    /// tube. The outer border of a roof gives 4: seen from it, what fills it lies round the outside.
    pub(super) fn halves_of_border(&self, table: &MeshTable, border: &[usize]) -> i32 {
        let at = |half: &usize| {
            let vertex = table.ends(*half)[0];
            let angles: f64 = table.fan(vertex).map(|half| table.angle(half)).sum();
            // The fan runs back along the border.
            -self.turn_of_fan(table, vertex) - (PI - angles)
        };
        // Against the border's own direction the line turns by this much.
        2 - (border.iter().map(at).sum::<f64>() / PI).round() as i32
    }

    /// The mean angle to the lines of another field, radians, weighted.
    pub(super) fn mean_angle(&self, other: &Self, weights: &[f64]) -> f64 {
        let angle = |f: usize| self.along[f].dot(other.along[f]).abs().min(1.0).acos();
        let sum: f64 = weights.iter().enumerate().map(|(f, w)| w * angle(f)).sum();
        sum / weights.iter().sum::<f64>().max(f64::MIN_POSITIVE)
    }
}
