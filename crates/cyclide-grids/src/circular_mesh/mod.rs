//! Quad grids made circular: vertices moved a little so that the corners of every quad lie on one circle, which is what
//! a net of cyclide patches needs (`docs/math/circular-meshes.md#search`).

mod block;
mod border;
mod closing;
mod curvature;
mod dense_rows;
mod dissection;
mod fairness;
mod finish;
mod guard;
mod input_surface;
mod layout;
mod neighbors;
mod normal_equations;
mod options;
mod report;
mod residual;
mod search;

pub use layout::{CircularLayout, make_layout_circular, make_layout_circular_watched};
pub use options::{Border, CircularMeshOptions};
pub use report::{CircularMeshReport, ClosingChange, LineAngles, RoundChange, VertexMoves};
pub use search::CircularMeshStep;

use border::Holds;
use closing::Closing;
use cyclide::Aabb;
use cyclide::Point3;
#[cfg(doc)]
use cyclide::ShapeChange;
use cyclide::Warning;
use cyclide::surface::QuadGrid;
use cyclide::workspace::check_distance;
use cyclide::{
    Result,
    error::{GridError, PointError},
};
use guard::Guard;
use normal_equations::Pattern;
use report::Comparison;
use search::Problem;

/// Vertices of an edge closer than this part of the grid's size coincide.
const COINCIDENT_LIMIT: f64 = 1e-12;

/// A grid with circular quads and what it took.
///
/// ```
/// use cyclide::{Point3, surface::QuadGrid};
/// use cyclide_grids::{CircularMeshOptions, make_circular};
/// let saddle = (0..25).map(|k| (0.1 * f64::from(k % 5), 0.1 * f64::from(k / 5)));
/// let saddle = saddle.map(|(u, v)| Point3::new(u, v + 0.01 * u * u, u * u - v * v)).collect();
/// let made = make_circular(&QuadGrid::new(saddle, [5, 5], [false; 2])?, &CircularMeshOptions::default())?;
/// assert!(made.report.residual_after < 1e-10 && made.grid.size() == [5, 5]);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct CircularMesh {
    /// The grid; every quad's corners lie on one circle or line.
    pub grid: QuadGrid,
    /// Steps, residuals, moves, angles to curvature lines, rejected quads.
    pub report: CircularMeshReport,
    warnings: Vec<Warning>,
}

impl CircularMesh {
    /// Doubts: grid lines across the curvature lines, a changed shape, long moves, vertices off the input surface, zigzag
    /// grid lines.
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}

/// Moves the vertices of a grid until the corners of every quad lie on one circle (or line).
///
/// The residual of a quad is the vector part of `d_01 d_13 d_32 d_20` (unit sides, quaternion product); it is brought
/// below 1e-12 (1e-10 where the search gets no further) by Levenberg-Marquardt steps damped by a fairness metric, with
/// the constants of `docs/math/circular-meshes.md#search`: grid lines stay smooth, vertices slide along the surface
/// more easily than they leave it. The result is a circular net, the discrete form of a net of curvature lines: a grid
/// roughly along the curvature lines of its surface moves little (hundredths of the surface's width), one 45 degrees
/// off ends nearly planar: a result that has lost the shape of its input is refused ([`ShapeChange`],
/// [`CircularMeshOptions::allow_shape_change`]). The last corners are then projected onto the circle of the others
/// where that lowers the residual further. A grid that is circular and closes as given is returned bit for bit.
///
/// In closed directions the grid closes as a net: the frame that is carried round comes back, and the lines across with
/// their speed ([`QuadGrid::closing`]). That costs moves of hundredths of an edge and is solved together with the circles
/// (`docs/math/circular-meshes.md#closed-grids`).
///
/// Where quads are left out ([`QuadGrid::with_cells`]) the border in steps is the border, and vertices that belong to no quad stay.
///
/// Free of scale; the same input gives the same bits on the same kind of processor. A step on 40 × 40 quads takes some
/// hundredths of a second.
///
/// ```
/// use cyclide::{Point3, surface::QuadGrid};
/// use cyclide_grids::{CircularMeshOptions, make_circular};
/// let saddle = |k: usize| {
///     let (u, v) = ((k % 9) as f64 / 4.0 - 1.0, (k / 9) as f64 / 4.0 - 1.0);
///     Point3::new(u, v, 0.4 * (u * u - v * v))
/// };
/// let grid = QuadGrid::new((0..81).map(saddle).collect(), [9, 9], [false, false])?;
/// let mesh = make_circular(&grid, &CircularMeshOptions::default())?;
/// assert!(mesh.report.residual_after < 1e-12 && mesh.report.rejected_quads.is_empty());
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// `parameter-out-of-range` (an option, a border curve in a closed direction, a coordinate out of range), `cells-unfit` (curves for
/// the sides of a grid with quads left out),
/// `coincident-points` (the ends of an edge), `border-curves-apart` (at a corner between two curves),
/// `collapsed-on-curve` (neighbors have the same nearest point on the curve of their side), `not-converged` (with the
/// step and the residual reached: the border is held too tightly, or the grid is folded), `net-does-not-close` (a pinned
/// closed row that turns the frame, which nothing can close; or the quads have circles and a direction does not close),
/// `shape-lost` (unless allowed, or quads cross: those are named in the report).
pub fn make_circular(grid: &QuadGrid, options: &CircularMeshOptions<'_>) -> Result<CircularMesh> {
    make_circular_watched(grid, options, &mut |_| ())
}

/// [`make_circular`] whose
///
/// # Errors
/// Those of [`make_circular`].
pub fn make_circular_watched(
    grid: &QuadGrid,
    options: &CircularMeshOptions<'_>,
    progress: &mut dyn FnMut(&CircularMeshStep),
) -> Result<CircularMesh> {
    options.check(grid)?;
    let world_edge = median_edge(grid)?;
    let input = grid;
    let grid = &border::corners_on_curves(input, options.border, world_edge)?;
    // The search works about the middle of the grid in units near its edge: powers of two, which round nothing.
    let bounds = Aabb::of_points(grid.points().iter().copied());
    let origin = bounds.map_or(Point3::ORIGIN, |b| b.min.midpoint(b.max));
    let scale = world_edge.log2().round().exp2();
    closing::check_pinned(grid, options.border)?;
    let holds = Holds::new(grid, options.border, origin, scale);
    let mut points: Vec<Point3> = grid.points().iter().map(|p| Point3::ORIGIN + (*p - origin) / scale).collect();

    let quads = residual::quads(grid);
    let closing = Closing::new(grid);
    let triples = fairness::triples(grid);
    let normals = input_surface::normals(grid.points(), grid, [1; 2]);
    let measure = |points: &[Point3]| residual::residuals(points, &quads).map_or(1.0, |r| residual::largest(&r));
    let residual_before = measure(&points);
    let closing_before = [input.closing(0)?, input.closing(1)?];

    let given = points.clone();
    holds.settle(&mut points);
    check_distinct(&points, &quads)?;
    let edge = world_edge / scale;
    let terms = quads.iter().map(|q| &q[..]).chain(triples.iter().map(|t| &t[..]));
    // Rings may lose rank at their solution. Their last digits depend on rounding, and with this order some are worse.
    let order = (grid.closed() != [true; 2]).then(|| dissection::elimination_order(grid));
    let pattern = Pattern::new(points.len(), order.as_deref(), terms).ok_or(search::refused(0, residual_before))?;
    let metric = fairness::metric(&pattern, &triples, &normals, edge);
    let (max_steps, is_large) = (options.max_steps, search::is_large(grid.quads()));
    let problem =
        Problem { quads: &quads, closing: &closing, pattern, metric, holds: &holds, edge, is_large, max_steps };
    let steps = problem.search(&mut points, progress)?;
    if steps > 0 {
        finish::sweep(&mut points, grid, (&quads, &closing), &holds);
    }

    let moved = steps > 0 || matches!(options.border, Border::OnCurves(_));
    let to_world = |(v, p): (usize, &Point3)| {
        if moved && !holds.is_pinned(v) { origin + p.to_vec() * scale } else { grid.points()[v] }
    };
    let after: Vec<Point3> = points.iter().enumerate().map(to_world).collect();
    let rejected_quads = report::rejected(&after, grid);
    let shape = Guard { grid, before: &given, after: &points, edge }.shape_change();
    let refusable = !options.allow_shape_change && rejected_quads.is_empty();
    if let Some(change) = shape.filter(|change| refusable && change.is_lost()) {
        return Err(GridError::ShapeLost { change: Box::new(change) }.into());
    }
    let comparison = Comparison { before: input, after: &after, normals: &normals };
    let moves = comparison.moves();
    let [angle_before, angle_after] = comparison.angles();
    let warnings = report::warnings((&after, &triples), &moves, world_edge, shape.as_ref());
    let residual_after = measure(&after);
    let made = grid.with_points(after)?;
    let report = CircularMeshReport {
        steps,
        residual_before,
        residual_after,
        median_edge: world_edge,
        moves,
        angle_before,
        angle_after,
        closing: report::closing(closing_before, &made)?,
        round: None,
        shape,
        rejected_quads,
    };
    Ok(CircularMesh { grid: made, report, warnings })
}

/// # Errors
/// `collapsed-on-curve`: the edges as given have a length, so that only a border curve can bring their ends together.
fn check_distinct(points: &[Point3], quads: &[[usize; 4]]) -> Result<()> {
    let sides = quads.iter().flat_map(|&[a, b, c, d]| [[a, b], [c, d], [a, c], [b, d]]);
    match sides.into_iter().find(|&[a, b]| points[a] == points[b]) {
        Some([first, second]) => Err(GridError::CollapsedOnCurve { first, second }.into()),
        None => Ok(()),
    }
}

/// The median length of the grid's edges.
///
/// # Errors
/// `coincident-points`, `parameter-out-of-range`.
fn median_edge(grid: &QuadGrid) -> Result<f64> {
    let used = grid.used_vertices();
    let of_quads = grid.points().iter().zip(&used).filter(|(_, used)| **used).map(|(p, _)| *p);
    let size = Aabb::of_points(of_quads).map_or(0.0, Aabb::diagonal);
    let [m, n] = grid.size();
    let edges = (0..n).flat_map(|j| (0..m).map(move |i| (i, j))).flat_map(|(i, j)| {
        let next = [(grid.has_edge([i, j], 0), (i + 1, j)), (grid.has_edge([i, j], 1), (i, j + 1))];
        next.into_iter().filter(|(exists, _)| *exists).map(move |(_, (k, l))| [grid.index(i, j), grid.index(k, l)])
    });
    median(grid.points(), edges, size)
}

/// The median length of edges of a surface of this size.
///
/// # Errors
/// `coincident-points`, `parameter-out-of-range`.
fn median(points: &[Point3], edges: impl Iterator<Item = [usize; 2]>, size: f64) -> Result<f64> {
    let limit = COINCIDENT_LIMIT * size;
    let mut lengths = Vec::new();
    for [first, second] in edges {
        let distance = points[first].distance(points[second]);
        if !(distance > limit) {
            return Err(PointError::CoincidentPoints { first, second, distance, limit }.into());
        }
        check_distance(distance)?;
        lengths.push(distance);
    }
    lengths.sort_by(f64::total_cmp);
    Ok(lengths[lengths.len() / 2])
}
