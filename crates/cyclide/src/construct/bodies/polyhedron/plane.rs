//! Planes of faces, and vertices moved onto them.

use crate::base::bounds::Aabb;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, PolyhedronError, Result};

/// Rounds in which vertices go to their planes and these to their vertices.
const MOST_ROUNDS: usize = 200;
/// Steps to the common point of the planes of one vertex: of conjugate gradients as many as there are coordinates.
const STEPS: usize = 3;
/// Roundings of a coordinate by which a vertex may be off its planes.
const ROUNDINGS: f64 = 8.0;
/// Times so much what is left off the planes at the end is too much.
const LEFT: f64 = 64.0;

/// A plane through a point across a unit normal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plane {
    pub(super) through: Point3,
    pub(super) normal: Vec3,
}

impl Plane {
    /// The plane of a loop: through the middle of its corners, with Newell's normal. `None` for a loop without area.
    pub(super) fn of_loop(points: &[Point3], corners: &[usize]) -> Option<Self> {
        Self::through_middle(corners.iter().map(|&v| points[v]), area_vector(points, corners))
    }

    pub(super) fn through_middle(points: impl Iterator<Item = Point3>, normal: Vec3) -> Option<Self> {
        let mut points = points.peekable();
        let first = *points.peek()?;
        let (sum, count) = points.fold((Vec3::ZERO, 0.0), |(sum, n), p| (sum + (p - first), n + 1.0));
        Some(Self { through: first + sum / count, normal: normal.unit()? })
    }

    /// Height of a point above the plane.
    pub(super) fn distance(&self, p: Point3) -> f64 {
        (p - self.through).dot(self.normal)
    }
}

/// Newell's normal, twice the area long: the sum of the cross products about the first corner, which loses no digits far from
/// the origin, nor along faces that are a millionth as wide as long (`docs/math/polyhedron-offsets.md#polyhedron`).
pub(super) fn area_vector(points: &[Point3], corners: &[usize]) -> Vec3 {
    let Some((&first, rest)) = corners.split_first() else { return Vec3::ZERO };
    let way = |v: usize| points[v] - points[first];
    rest.windows(2).fold(Vec3::ZERO, |sum, w| sum + cross(way(w[0]), way(w[1])))
}

/// The cross product of vectors that may be nearly parallel, each coordinate to its last digits (W. Kahan's difference of two
/// products). That of rounded products is off in every direction, along the vectors too.
fn cross(a: Vec3, b: Vec3) -> Vec3 {
    let difference = |a: f64, b: f64, c: f64, d: f64| {
        let cd = c * d;
        a.mul_add(b, -cd) - c.mul_add(d, -cd)
    };
    Vec3::new(difference(a.y, b.z, a.z, b.y), difference(a.z, b.x, a.x, b.z), difference(a.x, b.y, a.y, b.x))
}

/// What is to be said of points that bound no body: how far they are from the plane in their middle across a normal; points on a line,
/// which have none, are in one.
pub(super) fn flat(points: impl Iterator<Item = Point3>, normal: Vec3, limit: f64) -> Error {
    let (mut points, normal) = (points.peekable(), normal.unit().unwrap_or_default());
    let first = points.peek().copied().unwrap_or_default();
    let heights = points.map(|p| (p - first).dot(normal));
    let [low, high] = heights.fold([0.0_f64; 2], |[low, high], height| [low.min(height), high.max(height)]);
    Error::Polyhedron(PolyhedronError::Flat { thickness: 0.5 * (high - low), limit })
}

/// Refuses faces with a corner farther from their plane than the limit.
///
/// # Errors
/// `non-planar-face`, `not-a-face` (no area).
pub(super) fn check_planar(points: &[Point3], loops: &[Vec<usize>], limit: f64) -> Result<()> {
    for (face, corners) in loops.iter().enumerate().filter(|(_, corners)| corners.len() > 3) {
        let plane = Plane::of_loop(points, corners);
        let plane = plane.ok_or(PolyhedronError::NotAFace { face, detail: "its corners are on a line" })?;
        let off = corners.iter().map(|&v| (v, plane.distance(points[v]).abs()));
        let (vertex, distance) = off.fold((0, 0.0), |far, at| if at.1 > far.1 { at } else { far });
        if distance > limit {
            return Err(PolyhedronError::NonPlanarFace { face, vertex, distance, limit }.into());
        }
    }
    Ok(())
}

/// The rounding of coordinates of a polyhedron, as it is seen in distances from planes.
pub(super) fn rounding(points: &[Point3]) -> f64 {
    Aabb::of_points(points.iter().copied()).map_or(0.0, |b| ROUNDINGS * f64::EPSILON * b.max_abs().max(b.diagonal()))
}

/// The vertices moved, as little as they can, until the corners of every face of more than three are in one plane to the
/// rounding of their coordinates: those of a vertex at a time go to its planes, then each plane to its vertices. With three
/// planes or fewer at every vertex one round is enough.
///
/// # Errors
/// `non-planar-face` where the last round does not end there.
pub(super) fn made_planar(points: &[Point3], loops: &[Vec<usize>]) -> Result<Vec<Point3>> {
    let mut points = points.to_vec();
    let faces: Vec<usize> = (0..loops.len()).filter(|&f| loops[f].len() > 3).collect();
    let used: Vec<Point3> = loops.iter().flatten().map(|&v| points[v]).collect();
    let rounding = rounding(&used);
    let mut at: Vec<Vec<usize>> = vec![Vec::new(); points.len()];
    for (k, &face) in faces.iter().enumerate() {
        loops[face].iter().for_each(|&v| at[v].push(k));
    }
    for round in 0..=MOST_ROUNDS {
        let planes: Vec<Plane> = faces.iter().filter_map(|&f| Plane::of_loop(&points, &loops[f])).collect();
        if planes.len() < faces.len() {
            break;
        }
        let mut worst = (0, 0, 0.0);
        for (plane, &face) in planes.iter().zip(&faces) {
            for &vertex in &loops[face] {
                let off = plane.distance(points[vertex]).abs();
                if off > worst.2 {
                    worst = (face, vertex, off);
                }
            }
        }
        let (face, vertex, distance) = worst;
        if distance <= rounding {
            break;
        }
        if round == MOST_ROUNDS {
            let limit = LEFT * rounding;
            if distance > limit {
                return Err(PolyhedronError::NonPlanarFace { face, vertex, distance, limit }.into());
            }
            break;
        }
        for (vertex, of_vertex) in at.iter().enumerate().filter(|(_, of_vertex)| !of_vertex.is_empty()) {
            let of_vertex: Vec<Plane> = of_vertex.iter().map(|&k| planes[k]).collect();
            points[vertex] = onto(points[vertex], &of_vertex);
        }
    }
    Ok(points)
}

/// The point of all planes that is nearest to a point; nearly so where there is none, or where planes are nearly one: the least
/// squares by conjugate gradients, which move along the normals only.
fn onto(p: Point3, planes: &[Plane]) -> Point3 {
    let mut way = Vec3::ZERO;
    let gradient = |way: Vec3| {
        planes.iter().fold(Vec3::ZERO, |sum, plane| sum - plane.normal * (plane.distance(p) + way.dot(plane.normal)))
    };
    let mut left = gradient(way);
    let (mut along, mut size) = (left, left.length_squared());
    let first = size;
    for _ in 0..STEPS {
        let across: f64 = planes.iter().map(|plane| along.dot(plane.normal).powi(2)).sum();
        if !(size > 1e-30 * first && across > 0.0) {
            break;
        }
        way += along * (size / across);
        left = gradient(way);
        let next = left.length_squared();
        along = left + along * (next / size);
        size = next;
    }
    p + way
}
