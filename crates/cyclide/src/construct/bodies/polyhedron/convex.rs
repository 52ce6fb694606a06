//! Whether a closed polyhedron is convex: at every edge, and round every vertex (H. Tietze, S. Nakajima, 1928: what is convex
//! there is so as a whole).

use super::faces::{FaceSide, Faces};
use super::plane::area_vector;
use super::spherical_polygon::SphericalPolygon;
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, PolyhedronError, Result};
use std::f64::consts::{PI, TAU};

/// The angle between the normals of the two faces of an edge, positive where they turn away from each other.
pub(super) fn edge_angle(points: &[Point3], faces: &Faces, at: FaceSide, [n, m]: [Vec3; 2]) -> f64 {
    let [from, to] = faces.ends(at).map(|v| points[v]);
    let across = n.cross(m);
    across.length().atan2(n.dot(m)).copysign(across.dot(to - from))
}

/// Refuses edges at which the faces turn towards each other.
///
/// # Errors
/// `not-convex`.
pub(super) fn check_edges(points: &[Point3], faces: &Faces, normals: &[Vec3]) -> Result<()> {
    let each: Vec<usize> = (0..normals.len()).collect();
    reflex(points, faces, normals, &each).map_or(Ok(()), Err)
}

/// Refuses faces that run round themselves more than once or have a corner that turns inwards by more than `within`. Edges and
/// normals round the vertices do not show it: those of a prism over a pentagram are convex, one by one.
///
/// # Errors
/// `not-a-face`.
pub(super) fn check_faces(points: &[Point3], faces: &Faces, normals: &[Vec3], within: f64) -> Result<()> {
    for (face, (corners, normal)) in faces.loops().iter().zip(normals).enumerate() {
        let mut turn = 0.0;
        for k in 0..corners.len() {
            let at = |ahead: usize| points[corners[(k + ahead) % corners.len()]];
            let (before, after) = (at(1) - at(0), at(2) - at(1));
            let sine = before.cross(after).dot(*normal);
            // The distance from the line of the neighbors: between short sides angles are rounding.
            if -sine > within * at(0).distance(at(2)) {
                return Err(PolyhedronError::NotAFace {
                    face,
                    detail: "it is not convex: one of its corners turns inwards",
                }
                .into());
            }
            turn += sine.atan2(before.dot(after));
        }
        // Whole turns, but for rounding.
        if !((turn - TAU).abs() < PI) {
            return Err(PolyhedronError::NotAFace {
                face,
                detail: "its sides cross: they run round it more than once",
            }
            .into());
        }
    }
    Ok(())
}

/// What is to be said about the edges between groups of faces, if some are reflex.
pub(super) fn reflex_edge(points: &[Point3], faces: &Faces, group: &[usize]) -> Option<Error> {
    let normals = faces.loops().iter().map(|corners| area_vector(points, corners).unit().unwrap_or_default());
    reflex(points, faces, &normals.collect::<Vec<_>>(), group)
}

fn reflex(points: &[Point3], faces: &Faces, normals: &[Vec3], group: &[usize]) -> Option<Error> {
    let (mut edges, mut reflex) = (0, 0);
    let mut worst = (0.0, [0, 0]);
    for at in faces.edges() {
        let pair = [at.face, faces.across(at).face];
        if group[pair[0]] == group[pair[1]] {
            continue;
        }
        edges += 1;
        let angle = edge_angle(points, faces, at, pair.map(|face| normals[face]));
        if !(angle > 0.0) {
            reflex += 1;
            if reflex == 1 || angle < worst.0 {
                worst = (angle, faces.ends(at));
            }
        }
    }
    let (angle, [first, second]) = worst;
    (reflex > 0).then_some(Error::Polyhedron(PolyhedronError::NotConvex { first, second, angle, reflex, edges }))
}

/// The polygon of the normals round each vertex; `None` for vertices that no face has.
///
/// Its apex is the middle of its outline: the sum of the corners may be next to one of them, and far from another one, as at the
/// rim of a flat polyhedron. The integral of a side of the angle a is the vector to its middle, `2 sin(a/2)` long.
///
/// # Errors
/// `not-in-open-hemisphere`.
pub(super) fn normal_polygons(
    points: &[Point3],
    faces: &Faces,
    fans: &[Vec<FaceSide>],
    normals: &[Vec3],
) -> Result<Vec<Option<SphericalPolygon>>> {
    let polygon = |fan: &Vec<FaceSide>| {
        let around: Vec<Vec3> = fan.iter().map(|at| normals[at.face]).collect();
        let sides = fan.iter().map(|&at| {
            let side = faces.before(at);
            let [from, to] = faces.ends(side).map(|v| points[v]);
            let pair = [at.face, faces.across(side).face].map(|face| normals[face]);
            let half = 0.5 * pair[0].cross(pair[1]).length().atan2(pair[0].dot(pair[1]));
            let axis = edge_axis(pair, to - from);
            (pair[0] * half.cos() + axis.cross(pair[0]) * half.sin()) * half.sin()
        });
        let apex = sides.fold(Vec3::ZERO, |sum, middle| sum + middle).unit();
        let apex = apex.ok_or(Error::Polyhedron(PolyhedronError::NotInOpenHemisphere {
            side: None,
            measured: 0.0,
            limit: 0.0,
        }));
        (!around.is_empty()).then(|| SphericalPolygon::about(around, apex?)).transpose()
    };
    fans.iter().map(polygon).collect()
}

/// Below this sine of the angle between two normals their cross product has fewer digits than the edge.
const SMALL_SINE: f64 = 1e-3;

/// The axis of the cylinder along an edge, across both normals: their cross product, or the edge where that is better known.
pub(super) fn edge_axis([n, m]: [Vec3; 2], along: Vec3) -> Vec3 {
    let cross = n.cross(m);
    if cross.length() >= SMALL_SINE {
        return cross.unit().unwrap_or(Vec3::ZERO);
    }
    // Nearly the same normal, or nearly opposite ones: what is common to both.
    let common = if n.dot(m) > 0.0 { n + m } else { n - m };
    let across = common.unit().map_or(along, |common| along - common * along.dot(common));
    across.unit().unwrap_or(Vec3::ZERO)
}
