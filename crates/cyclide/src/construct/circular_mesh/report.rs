//! What making a grid circular did to it.

use super::input_surface;
use super::residual::side_product;
use crate::base::vector::{Point3, Vec3};
use crate::shape_change::{ACROSS, ShapeChange};
use crate::surface::QuadGrid;
use crate::warning::Warning;

/// A move above this many median edges is warned of.
const FAR_MOVE: f64 = 2.0;
/// A distance from the input surface above this many median edges is warned of.
const FAR_OFF: f64 = 1.0;
/// Grid lines that turn by less than this at a typical vertex (radians) are smooth enough, whatever their turns do.
const SMOOTH_TURN: f64 = 0.01;
/// Neighbouring turns agree by less than this: independent errors of the vertices give -2/3, smooth curves 1.
const ZIGZAG: f64 = 0.0;

/// Lengths and angles of what was done; lengths in the unit of the points.
#[derive(Debug, Clone, PartialEq)]
pub struct CircularMeshReport {
    /// Steps of the search, rejected ones included; 0 if the grid was circular as given.
    pub steps: usize,
    /// Largest residual of a quad before: length of the vector part of the product of its four unit sides; 0 for
    /// corners on one circle, at most 1.
    pub residual_before: f64,
    /// The same after, of the points as returned.
    pub residual_after: f64,
    /// Median edge of the input.
    pub median_edge: f64,
    /// How far the vertices moved.
    pub moves: VertexMoves,
    /// Angles of the input's grid lines to the curvature lines of the input.
    pub angle_before: Option<LineAngles>,
    /// Angles of the resulting grid lines to the curvature lines of the input at the same vertices.
    pub angle_after: Option<LineAngles>,
    /// How much of the shape changed; `None` for an input that is flat.
    pub shape: Option<ShapeChange>,
    /// Quads (s fastest) whose sides cross, or with a side of no length: no patch fits into them.
    pub rejected_quads: Vec<usize>,
}

/// How far the vertices moved.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct VertexMoves {
    /// The longest move.
    pub max: f64,
    /// The vertex (s fastest) that made it.
    pub farthest_vertex: usize,
    /// The mean length of a move.
    pub mean: f64,
    /// The longest part of a move along the input's normal at the vertex.
    pub max_normal: f64,
    /// The mean of these parts.
    pub mean_normal: f64,
    /// The largest height of a moved vertex over the input's quads near it (triangulated both ways, and continued flat
    /// beyond the border).
    pub max_off_surface: f64,
    /// The vertex that has it.
    pub farthest_off_vertex: usize,
}

/// Angles of grid lines to the nearer curvature line, in `[0, pi/4]`, radians. Estimated from the vertices by local
/// quadrics; border vertices and those where the surface is nearly flat or spherical do not count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineAngles {
    /// The median.
    pub median: f64,
    /// The largest.
    pub max: f64,
}

impl LineAngles {
    fn of(mut angles: Vec<f64>) -> Option<Self> {
        angles.sort_by(f64::total_cmp);
        Some(Self { median: *angles.get(angles.len() / 2)?, max: *angles.last()? })
    }
}

/// Before and after, for the report and the warnings.
pub(super) struct Comparison<'a> {
    pub(super) before: &'a QuadGrid,
    pub(super) after: &'a [Point3],
    pub(super) normals: &'a [Option<Vec3>],
    pub(super) triples: &'a [[usize; 3]],
}

impl Comparison<'_> {
    pub(super) fn moves(&self) -> VertexMoves {
        let points = self.before.points();
        let mut moves = VertexMoves::default();
        let share = 1.0 / points.len() as f64;
        for (v, (from, to)) in points.iter().zip(self.after).enumerate() {
            let (length, normal) = (from.distance(*to), self.normals[v].map_or(0.0, |n| n.dot(*to - *from).abs()));
            let off = if length == 0.0 { 0.0 } else { input_surface::height(*to, v, points, self.before) };
            moves.mean += length * share;
            moves.mean_normal += normal * share;
            moves.max_normal = moves.max_normal.max(normal);
            if length > moves.max {
                (moves.max, moves.farthest_vertex) = (length, v);
            }
            if off > moves.max_off_surface {
                (moves.max_off_surface, moves.farthest_off_vertex) = (off, v);
            }
        }
        moves
    }

    /// Angles to the curvature lines of the input, before and after.
    pub(super) fn angles(&self) -> [Option<LineAngles>; 2] {
        let lines = input_surface::curvature_lines(self.before.points(), self.before);
        let of = |points| LineAngles::of(input_surface::line_angles(points, self.before, &lines));
        [of(self.before.points()), of(self.after)]
    }

    /// Doubts about the result, those about its shape first (`docs/math/circular-meshes.md#guard`).
    pub(super) fn warnings(&self, moves: &VertexMoves, edge: f64, shape: Option<&ShapeChange>) -> Vec<Warning> {
        let mut warnings = Vec::new();
        if let Some(shape) = shape {
            if let Some(angle) = shape.runs_across() {
                warnings.push(Warning::AcrossCurvatureLines { angle, limit: ACROSS });
            }
            if shape.is_doubtful() {
                warnings.push(Warning::ShapeChanged { change: *shape });
            }
        }
        if moves.max > FAR_MOVE * edge {
            let (vertex, distance) = (moves.farthest_vertex, moves.max);
            warnings.push(Warning::MovedFar { vertex, distance, limit: FAR_MOVE * edge });
        }
        if moves.max_off_surface > FAR_OFF * edge {
            let (vertex, distance) = (moves.farthest_off_vertex, moves.max_off_surface);
            warnings.push(Warning::LeftSurface { vertex, distance, limit: FAR_OFF * edge });
        }
        if let Some((agreement, turn)) = zigzag(self.after, self.triples) {
            warnings.push(Warning::Zigzag { agreement, turn });
        }
        warnings
    }
}

/// Quads without an embedded circular shape.
pub(super) fn rejected(points: &[Point3], quads: &[[usize; 4]]) -> Vec<usize> {
    let embedded = |quad: &[usize; 4]| side_product(points, *quad).is_some_and(|product| product.w < 0.0);
    quads.iter().enumerate().filter(|(_, quad)| !embedded(quad)).map(|(index, _)| index).collect()
}

/// How neighbouring turns of the grid lines agree (cosine, weighted by their sizes) and the mean turn, if they zigzag:
/// the turn at a vertex is the second difference over the mean edge there.
fn zigzag(points: &[Point3], triples: &[[usize; 3]]) -> Option<(f64, f64)> {
    let second = |t: &[usize; 3]| (points[t[2]] - points[t[1]]) - (points[t[1]] - points[t[0]]);
    let (mut agreement, mut size, mut turn, mut count) = (0.0, 0.0, 0.0, 0usize);
    for triple in triples {
        turn += second(triple).length() / (0.5 * points[triple[0]].distance(points[triple[2]])).max(f64::MIN_POSITIVE);
        count += 1;
    }
    let following: std::collections::HashMap<[usize; 2], usize> =
        triples.iter().enumerate().map(|(k, t)| ([t[0], t[1]], k)).collect();
    for triple in triples {
        if let Some(&next) = following.get(&[triple[1], triple[2]]) {
            let (a, b) = (second(triple), second(&triples[next]));
            agreement += a.dot(b);
            size += a.length() * b.length();
        }
    }
    let turn = turn / count.max(1) as f64;
    (turn > SMOOTH_TURN && agreement < ZIGZAG * size).then(|| (agreement / size, turn))
}
