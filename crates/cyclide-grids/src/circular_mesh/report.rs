//! What making a grid circular did to it.

use super::input_surface;
use super::residual::side_product;
use cyclide::Result;
use cyclide::ShapeChange;
use cyclide::surface::{GridClosing, QuadGrid};
use cyclide::{Point3, Vec3};
use cyclide::{Warning, warning::CircularWarning};

/// A move above this many median edges is warned of.
const FAR_MOVE: f64 = 2.0;
/// A distance from the input surface above this many median edges is warned of.
const FAR_OFF: f64 = 1.0;
/// Grid lines that turn by less than this at a typical vertex (radians) are smooth enough, whatever their turns do.
const SMOOTH_TURN: f64 = 0.01;
/// Neighboring turns agree by less than this: independent errors of the vertices give -2/3, smooth curves 1.
const ZIGZAG: f64 = 0.0;

/// Lengths and angles of what was done; lengths in the unit of the points.
///
/// ```
/// use cyclide::{Point3, surface::QuadGrid};
/// use cyclide_grids::{CircularMeshOptions, make_circular};
/// let saddle = (0..25).map(|k| (0.1 * f64::from(k % 5), 0.1 * f64::from(k / 5)));
/// let saddle = saddle.map(|(u, v)| Point3::new(u, v + 0.01 * u * u, u * u - v * v)).collect();
/// let grid = QuadGrid::new(saddle, [5, 5], [false; 2])?;
/// let report = make_circular(&grid, &CircularMeshOptions::default())?.report;
/// assert!(report.residual_after < report.residual_before && report.rejected_quads.is_empty());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
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
    /// What closing took, along s and along t; `None` of an open direction.
    pub closing: [Option<ClosingChange>; 2],
    /// What closing round extraordinary vertices took, of a mesh that has some.
    pub round: Option<RoundChange>,
    /// How much of the shape changed; `None` for an input that is flat.
    pub shape: Option<ShapeChange>,
    /// Quads (s fastest) whose sides cross, or with a side of no length: no patch fits into them.
    pub rejected_quads: Vec<usize>,
}

/// How far a closed direction was from closing as a net, and is ([`GridClosing`]).
///
/// ```
/// use cyclide::{Point3, surface::QuadGrid};
/// use cyclide_grids::{CircularMeshOptions, make_circular};
/// let at = |k: usize| {
///     let (a, z) = (std::f64::consts::TAU * (k % 8) as f64 / 8.0, (k / 8) as f64);
///     Point3::new(3.0 * a.cos(), 2.0 * a.sin(), z)
/// };
/// let tube = QuadGrid::new((0..32).map(at).collect(), [8, 4], [true, false])?;
/// let [along_s, along_t] = make_circular(&tube, &CircularMeshOptions::default())?.report.closing;
/// let closing = along_s.expect("it is closed along s");
/// assert!(closing.angle_before > 1e-3 && closing.angle_after < 1e-12 && along_t.is_none());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ClosingChange {
    /// Largest angle by which a frame came back turned in the grid as given, radians.
    pub angle_before: f64,
    /// The same of the grid as returned.
    pub angle_after: f64,
    /// Largest difference from 1 of the ratio of the speeds of lines across, after and before a turn, in the grid as
    /// given.
    pub stretch_before: f64,
    /// The same of the grid as returned.
    pub stretch_after: f64,
}

/// How far a mesh was from closing round its extraordinary vertices, and is.
///
/// ```
/// use cyclide::{Point3, surface::QuadLayout};
/// use cyclide_grids::{CircularMeshOptions, make_layout_circular};
/// let points: Vec<_> = (0..6).map(|k| Point3::new(f64::from(k % 3), f64::from(k / 3), 0.0)).collect();
/// let layout = QuadLayout::new(points, &[[0, 1, 4, 3], [1, 2, 5, 4]])?;
/// let made = make_layout_circular(&layout, &CircularMeshOptions::default())?;
/// assert!(made.report.round.is_none()); // there are none
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct RoundChange {
    /// The number of these vertices.
    pub vertices: usize,
    /// Largest angle by which a frame came back turned besides quarter turns in the mesh as given, radians.
    pub angle_before: f64,
    /// The same of the mesh as returned.
    pub angle_after: f64,
}

/// What closing took, of each direction.
///
/// # Errors
/// `coincident-points`.
pub(super) fn closing(before: [Option<GridClosing>; 2], made: &QuadGrid) -> Result<[Option<ClosingChange>; 2]> {
    let mut changes = [None; 2];
    for (direction, change) in changes.iter_mut().enumerate() {
        if let (Some(before), Some(after)) = (before[direction], made.closing(direction)?) {
            *change = Some(ClosingChange {
                angle_before: before.angle,
                angle_after: after.angle,
                stretch_before: before.stretch,
                stretch_after: after.stretch,
            });
        }
    }
    Ok(changes)
}

/// How far the vertices moved.
///
/// ```
/// use cyclide::{Point3, surface::QuadGrid};
/// use cyclide_grids::{CircularMeshOptions, make_circular};
/// let plane = (0..9).map(|k| Point3::new(f64::from(k % 3), f64::from(k / 3), 0.0)).collect();
/// let grid = QuadGrid::new(plane, [3, 3], [false; 2])?;
/// let moves = make_circular(&grid, &CircularMeshOptions::default())?.report.moves;
/// assert_eq!(moves.max, 0.0); // its quads have circles as they are
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
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
///
/// ```
/// use cyclide::{Point3, surface::QuadGrid};
/// use cyclide_grids::{CircularMeshOptions, make_circular};
/// let saddle = (0..81).map(|k| (0.1 * f64::from(k % 9), 0.1 * f64::from(k / 9)));
/// let saddle = saddle.map(|(u, v)| Point3::new(u, v, u * u - v * v)).collect();
/// let grid = QuadGrid::new(saddle, [9, 9], [false; 2])?;
/// let options = CircularMeshOptions { allow_shape_change: true, ..Default::default() };
/// let report = make_circular(&grid, &options)?.report;
/// assert!(report.angle_after.is_some_and(|angles| angles.median <= angles.max && angles.max < 0.8));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct LineAngles {
    /// The median.
    pub median: f64,
    /// The largest.
    pub max: f64,
}

impl LineAngles {
    pub(super) fn of(mut angles: Vec<f64>) -> Option<Self> {
        angles.sort_by(f64::total_cmp);
        Some(Self { median: *angles.get(angles.len() / 2)?, max: *angles.last()? })
    }
}

/// Before and after, for the report and the warnings.
pub(super) struct Comparison<'a> {
    pub(super) before: &'a QuadGrid,
    pub(super) after: &'a [Point3],
    pub(super) normals: &'a [Option<Vec3>],
}

impl Comparison<'_> {
    pub(super) fn moves(&self) -> VertexMoves {
        let points = self.before.points();
        let mut moves = VertexMoves::default();
        // Vertices of no quad have not moved.
        let share = 1.0 / self.before.used_vertices().iter().filter(|used| **used).count().max(1) as f64;
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
}

/// Doubts about the result, those about its shape first (`docs/math/circular-meshes.md#guard`).
pub(super) fn warnings(
    (after, triples): (&[Point3], &[[usize; 3]]),
    moves: &VertexMoves,
    edge: f64,
    shape: Option<&ShapeChange>,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if let Some(shape) = shape {
        if let Some(angle) = shape.runs_across() {
            warnings
                .push(Warning::Circular(CircularWarning::AcrossCurvatureLines { angle, limit: ShapeChange::ACROSS }));
        }
        if shape.is_doubtful() {
            warnings.push(Warning::Circular(CircularWarning::ShapeChanged { change: *shape }));
        }
    }
    if moves.max > FAR_MOVE * edge {
        let (vertex, distance) = (moves.farthest_vertex, moves.max);
        warnings.push(Warning::Circular(CircularWarning::MovedFar { vertex, distance, limit: FAR_MOVE * edge }));
    }
    if moves.max_off_surface > FAR_OFF * edge {
        let (vertex, distance) = (moves.farthest_off_vertex, moves.max_off_surface);
        warnings.push(Warning::Circular(CircularWarning::LeftSurface { vertex, distance, limit: FAR_OFF * edge }));
    }
    if let Some((agreement, turn)) = zigzag(after, triples) {
        warnings.push(Warning::Circular(CircularWarning::Zigzag { agreement, turn }));
    }
    warnings
}

/// Quads without an embedded circular shape.
pub(super) fn rejected(points: &[Point3], grid: &QuadGrid) -> Vec<usize> {
    let embedded =
        |[i, j]: &[usize; 2]| side_product(points, grid.corners(*i, *j)).is_some_and(|product| product.w < 0.0);
    grid.all_quads().filter(|quad| !embedded(quad)).map(|[i, j]| i + j * grid.quads()[0]).collect()
}

/// How neighboring turns of the grid lines agree (cosine, weighted by their sizes) and the mean turn, if they zigzag:
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
