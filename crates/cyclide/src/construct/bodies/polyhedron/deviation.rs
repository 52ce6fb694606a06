//! How far the surface of a polyhedron is from the points and faces that it was made from.
//!
//! Both bodies are convex, and so is the distance from a convex body: it is largest at a corner of the other one. Of each corner the
//! faces round it are looked at, which bounds the distance from the surface from above.

use super::faces::{FaceSide, Faces};
use super::plane::area_vector;
use crate::base::vector::{Point3, Vec3};

/// Faces over their points.
#[derive(Clone, Copy)]
pub(super) struct Surface<'a> {
    pub(super) points: &'a [Point3],
    pub(super) faces: &'a Faces,
}

/// The vertex that is farthest from the other surface, given or made, and its distance. `group` tells the face made of each one given;
/// `fans` are those of the faces given.
pub(super) fn farthest(given: Surface, made: Surface, group: &[usize], fans: &[Vec<FaceSide>]) -> (usize, f64) {
    let mut worst = (0, 0.0);
    let mut is_corner = vec![false; given.points.len()];
    made.faces.loops().iter().flatten().for_each(|&v| is_corner[v] = true);
    for (vertex, fan) in fans.iter().enumerate().filter(|(_, fan)| !fan.is_empty()) {
        let (old, new) = (given.points[vertex], made.points[vertex]);
        let moved = if is_corner[vertex] { old.distance(new) } else { f64::INFINITY };
        if moved == 0.0 {
            continue;
        }
        let nearest = |distances: &mut dyn Iterator<Item = f64>| distances.fold(moved, f64::min);
        let mut off = nearest(&mut fan.iter().map(|at| made.distance(group[at.face], old)));
        if is_corner[vertex] {
            off = off.max(nearest(&mut fan.iter().map(|at| given.distance(at.face, new))));
        }
        if off > worst.1 {
            worst = (vertex, off);
        }
    }
    worst
}

impl Surface<'_> {
    /// Distance of a point from a face, a convex polygon.
    fn distance(&self, face: usize, p: Point3) -> f64 {
        let corners = &self.faces.loops()[face];
        let sides = || {
            let next = corners.iter().skip(1).chain(corners.first());
            corners.iter().zip(next).map(|(&a, &b)| [self.points[a], self.points[b]])
        };
        let normal = area_vector(self.points, corners).unit().unwrap_or(Vec3::ZERO);
        if normal != Vec3::ZERO && sides().all(|[a, b]| (b - a).cross(p - a).dot(normal) >= 0.0) {
            return corners.first().map_or(f64::INFINITY, |&a| (p - self.points[a]).dot(normal).abs());
        }
        sides().map(|[a, b]| from_segment(p, a, b)).fold(f64::INFINITY, f64::min)
    }
}

fn from_segment(p: Point3, a: Point3, b: Point3) -> f64 {
    let (way, chord) = (p - a, b - a);
    let along = way.dot(chord) / chord.length_squared();
    let t = if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.0 };
    (way - chord * t).length()
}
