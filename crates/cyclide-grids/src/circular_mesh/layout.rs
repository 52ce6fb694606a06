//! Meshes with extraordinary vertices made circular: all their grids together (`docs/math/circular-meshes.md#extraordinary-vertices`).

use super::border::Holds;
use super::closing::Closing;
use super::guard::{Guard, whole_change};
use super::normal_equations::Pattern;
use super::options::{Border, CircularMeshOptions};
use super::report::{CircularMeshReport, Comparison, LineAngles, RoundChange, VertexMoves, rejected};
use super::search::{CircularMeshStep, Problem, is_large, refused};
use super::{check_distinct, fairness, input_surface, median, residual};
use cyclide::Aabb;
use cyclide::ShapeChange;
use cyclide::Warning;
use cyclide::surface::{LayoutPiece, QuadGrid, QuadLayout};
use cyclide::workspace::RoundClosing;
use cyclide::{Point3, Vec3};
use cyclide::{
    Result,
    error::{GridCellFault, GridError},
};
use std::cmp::Ordering;

/// Grids round extraordinary vertices with circular quads, and what it took.
///
/// ```
/// use cyclide::{Point3, surface::QuadLayout};
/// use cyclide_grids::{CircularMeshOptions, make_layout_circular};
/// let points: Vec<_> = (0..6).map(|k| Point3::new(f64::from(k % 3), f64::from(k / 3), 0.0)).collect();
/// let layout = QuadLayout::new(points, &[[0, 1, 4, 3], [1, 2, 5, 4]])?;
/// let made = make_layout_circular(&layout, &CircularMeshOptions::default())?;
/// assert_eq!((made.report.steps, &made.layout), (0, &layout)); // circular as given
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct CircularLayout {
    /// The grids; every quad's corners lie on one circle or line.
    pub layout: QuadLayout,
    /// Steps, residuals, moves, angles to curvature lines, rejected quads: vertices and quads are those of the mesh.
    pub report: CircularMeshReport,
    warnings: Vec<Warning>,
}

impl CircularLayout {
    /// Doubts: see [`CircularMesh::warnings`](super::CircularMesh::warnings).
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}

/// Moves the vertices of a mesh until every quad has a circle and the net closes round each extraordinary vertex, whose own quads stay open.
///
/// It is the search of [`make_circular`](super::make_circular), of all grids at once. Round an extraordinary vertex of n quads the frame that
/// is carried along the ring comes back turned by `n - 4` quarter turns about the normal of the net there: four equations
/// for each of them, one of which follows, two unknowns for all. A mesh whose edges cross at right angles nearly everywhere moves little: some hundredths of an edge on spheres and planes, some tenths on
/// domes. Where the principal curvatures differ much an odd number of quads round a vertex cannot follow the lines of curvature, whose
/// two families would change places round it; the surface then changes, or is refused (`shape-lost`).
///
/// ```
/// use cyclide::{Point3, surface::{NetLayout, QuadLayout}};
/// use cyclide_grids::{CircularMeshOptions, make_layout_circular};
/// // Five sectors of 4 x 4 quads on a dome: a sector is a quarter of the plane, bent to a fifth.
/// let (n, k) = (5, 4);
/// let place = |i: usize, a: usize, b: usize| {
///     let (r, angle) = ((a as f64).hypot(b as f64).powf(4.0 / n as f64), (b as f64).atan2(a as f64));
///     let turn = 4.0 / n as f64 * angle + std::f64::consts::TAU * i as f64 / n as f64;
///     let (x, y) = (r * turn.cos(), r * turn.sin());
///     Point3::new(x, y, -0.05 * (x * x + y * y))
/// };
/// let (mut points, mut quads) = (Vec::<Point3>::new(), Vec::new());
/// for q in 0..n * k * k {
///     let (i, a, b) = (q / (k * k), q % k, q / k % k);
///     quads.push([(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)].map(|(a, b)| {
///         let p = place(i, a, b);
///         points.iter().position(|q| q.distance(p) < 1e-9).unwrap_or_else(|| { points.push(p); points.len() - 1 })
///     }));
/// }
/// let layout = QuadLayout::new(points, &quads)?;
/// let made = make_layout_circular(&layout, &CircularMeshOptions::default())?;
/// assert!(made.report.moves.max < 0.3 * made.report.median_edge);
/// assert_eq!(NetLayout::new(made.layout)?.to_shell()?.faces().len(), n * (k * k - 1));
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// Those of [`make_circular`](super::make_circular); `ring-does-not-close`; `cells-unfit` for border curves, which need a single grid.
pub fn make_layout_circular(layout: &QuadLayout, options: &CircularMeshOptions<'_>) -> Result<CircularLayout> {
    make_layout_circular_watched(layout, options, &mut |_| ())
}

/// [`make_layout_circular`] whose `progress` is called after each step.
///
/// # Errors
/// Those of [`make_layout_circular`].
pub fn make_layout_circular_watched(
    layout: &QuadLayout,
    options: &CircularMeshOptions<'_>,
    progress: &mut dyn FnMut(&CircularMeshStep),
) -> Result<CircularLayout> {
    options.check_steps()?;
    if let Border::OnCurves(_) = options.border {
        return Err(GridError::CellsUnfit { fault: GridCellFault::Curves, index: 0 }.into());
    }
    let used = layout.used_vertices();
    let world = layout.points();
    let world_edge = median_edge(layout, &used)?;
    let of_quads = world.iter().zip(&used).filter(|(_, used)| **used).map(|(p, _)| *p);
    let bounds = Aabb::of_points(of_quads);
    let origin = bounds.map_or(Point3::ORIGIN, |b| b.min.midpoint(b.max));
    let scale = world_edge.log2().round().exp2();
    let edge = world_edge / scale;
    let given: Vec<Point3> = world.iter().map(|p| Point3::ORIGIN + (*p - origin) / scale).collect();
    let mut points = given.clone();

    let quads = layout.quads();
    let closing = Closing::of_layout(layout);
    let triples = layout.triples();
    let normals = layout.normals(world);
    let measure = |points: &[Point3]| residual::residuals(points, &quads).map_or(1.0, |r| residual::largest(&r));
    let residual_before = measure(&points);
    check_distinct(&points, &quads)?;
    // What belongs to no quad of a grid stays.
    let pinned = matches!(options.border, Border::Pinned);
    let held: Vec<bool> =
        used.iter().zip(layout.on_border()).map(|(used, border)| !used || pinned && *border).collect();
    let holds = Holds::pinned(&held);
    let terms = quads.iter().map(|q| &q[..]).chain(triples.iter().map(|t| &t[..]));
    let pattern = Pattern::new(points.len(), None, terms).ok_or(refused(0, residual_before))?;
    let metric = fairness::metric(&pattern, &triples, &normals, edge);
    let longest = layout.pieces().iter().map(|piece| piece.grid.quads()).max_by_key(|n| n[0].max(n[1]));
    let (max_steps, is_large) = (options.max_steps, is_large(longest.unwrap_or_default()));
    let problem =
        Problem { quads: &quads, closing: &closing, pattern, metric, holds: &holds, edge, is_large, max_steps };
    let steps = problem.search(&mut points, progress)?;

    let moved = points
        .iter()
        .enumerate()
        .map(|(v, p)| if held[v] || steps == 0 { world[v] } else { origin + p.to_vec() * scale });
    let after = layout.with_points(moved.collect())?;
    let pieces = Pieces { before: layout, after: &after, normals: &normals };
    let rejected_quads = pieces.rejected();
    let shape = pieces.shape(&given, &points, edge);
    let refusable = !options.allow_shape_change && rejected_quads.is_empty();
    if let Some(change) = shape.filter(|change| refusable && change.is_lost()) {
        return Err(GridError::ShapeLost { change: Box::new(change) }.into());
    }
    let moves = pieces.moves();
    let [angle_before, angle_after] = pieces.angles();
    let warnings = super::report::warnings((after.points(), &triples), &moves, world_edge, shape.as_ref());
    let residual_after = measure(after.points());
    let round = RoundClosing::new(layout);
    let round = (!round.is_empty()).then(|| RoundChange {
        vertices: layout.round().len(),
        angle_before: round.angle(world).0,
        angle_after: round.angle(after.points()).0,
    });
    let report = CircularMeshReport {
        steps,
        residual_before,
        residual_after,
        median_edge: world_edge,
        moves,
        angle_before,
        angle_after,
        closing: [None; 2],
        round,
        shape,
        rejected_quads,
    };
    Ok(CircularLayout { layout: after, report, warnings })
}

/// The median length of the edges of the grids.
///
/// # Errors
/// `coincident-points`, `parameter-out-of-range`.
fn median_edge(layout: &QuadLayout, used: &[bool]) -> Result<f64> {
    let of_quads = layout.points().iter().zip(used).filter(|(_, used)| **used).map(|(p, _)| *p);
    let size = Aabb::of_points(of_quads).map_or(0.0, Aabb::diagonal);
    median(layout.points(), layout.edges().into_iter(), size)
}

/// The grids before and after.
struct Pieces<'a> {
    before: &'a QuadLayout,
    after: &'a QuadLayout,
    /// At the vertices of the mesh.
    normals: &'a [Option<Vec3>],
}

impl Pieces<'_> {
    fn each(&self) -> impl Iterator<Item = (&LayoutPiece, &QuadGrid)> {
        self.before.pieces().iter().zip(self.after.pieces().iter().map(|piece| &piece.grid))
    }

    /// The quads of the mesh that no patch fits into.
    fn rejected(&self) -> Vec<usize> {
        let of_piece = |(piece, after): (&LayoutPiece, &QuadGrid)| -> Vec<usize> {
            rejected(after.points(), after).into_iter().filter_map(|k| piece.quads[k]).collect()
        };
        let mut quads: Vec<usize> = self.each().flat_map(of_piece).collect();
        quads.sort_unstable();
        quads
    }

    /// The change of the grid whose shape has changed most, or of the whole; `given` and `points` are those of the mesh in units near
    /// its edge.
    fn shape(&self, given: &[Point3], points: &[Point3], edge: f64) -> Option<ShapeChange> {
        let of_piece = |(piece, _): (&LayoutPiece, &QuadGrid)| {
            let [before, after] = [given, points].map(|all| -> Vec<Point3> {
                // Where the grid has no vertex of the mesh stands a point near it.
                let near = |k: usize| piece.vertices[k].unwrap_or_else(|| self.before.base());
                (0..piece.vertices.len()).map(|k| all[near(k)]).collect()
            });
            Guard { grid: &piece.grid, before: &before, after: &after, edge }.shape_change()
        };
        let whole = whole_change([given, points], [self.normals, &self.after.normals(self.after.points())]);
        let lost = |change: &ShapeChange| (change.is_lost(), change.turn);
        let order = |a: &ShapeChange, b: &ShapeChange| lost(a).partial_cmp(&lost(b)).unwrap_or(Ordering::Equal);
        let of_pieces = self.each().filter_map(of_piece).max_by(order);
        // The grids tell more where they tell as much.
        match (of_pieces, whole) {
            (Some(of_pieces), Some(whole)) if !whole.is_lost() || of_pieces.is_lost() => Some(of_pieces),
            (of_pieces, whole) => whole.or(of_pieces),
        }
    }

    fn moves(&self) -> VertexMoves {
        let mut all = VertexMoves::default();
        let mut count = 0.0;
        for (piece, after) in self.each() {
            let normals: Vec<Option<Vec3>> = piece.vertices.iter().map(|v| v.and_then(|v| self.normals[v])).collect();
            let comparison = Comparison { before: &piece.grid, after: after.points(), normals: &normals };
            let moves = comparison.moves();
            let vertices = piece.grid.used_vertices().iter().filter(|used| **used).count() as f64;
            count += vertices;
            all.mean += moves.mean * vertices;
            all.mean_normal += moves.mean_normal * vertices;
            all.max_normal = all.max_normal.max(moves.max_normal);
            let number = |k: usize| piece.vertices[k].unwrap_or_default();
            if moves.max > all.max {
                (all.max, all.farthest_vertex) = (moves.max, number(moves.farthest_vertex));
            }
            if moves.max_off_surface > all.max_off_surface {
                (all.max_off_surface, all.farthest_off_vertex) =
                    (moves.max_off_surface, number(moves.farthest_off_vertex));
            }
        }
        all.mean /= f64::max(count, 1.0);
        all.mean_normal /= f64::max(count, 1.0);
        all
    }

    /// Angles to the curvature lines of the input, before and after.
    fn angles(&self) -> [Option<LineAngles>; 2] {
        let (mut before, mut after) = (Vec::new(), Vec::new());
        for (piece, moved) in self.each() {
            let lines = input_surface::curvature_lines(piece.grid.points(), &piece.grid);
            before.extend(input_surface::line_angles(piece.grid.points(), &piece.grid, &lines));
            after.extend(input_surface::line_angles(moved.points(), &piece.grid, &lines));
        }
        [before, after].map(LineAngles::of)
    }
}
