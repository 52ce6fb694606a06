//! Regular grids along the lines of curvature of a mesh: what nets with circular quads follow without losing the shape
//! (`docs/math/principal-grids.md`).

mod arc_length;
mod choice;
mod continuation;
mod coordinates;
mod cover;
mod cross_field;
mod cuts;
mod denoise;
mod field;
mod jets;
mod joined;
mod ladder;
mod lattice;
mod layout;
mod mesh_table;
mod options;
mod passages;
mod pieces;
mod point_grid;
mod rectangles;
mod report;
mod shape_tensors;
mod sheet;
mod staircase;
mod unknowns;
mod walker;

pub use choice::{FreeLayout, covering_principal_grids, covering_principal_grids_watched};
pub use field::PrincipalField;
pub use options::PrincipalGridOptions;
pub use report::{GridPiece, PrincipalGridReport, Umbilic};

use crate::principal_rules::{GridBorder, UmbilicRule};
use arc_length::by_arc_length;
use coordinates::coordinates;
use cross_field::CrossField;
use cyclide::Aabb;
use cyclide::Point3;
use cyclide::surface::{QuadGrid, QuadLayout};
use cyclide::workspace::check_point;
use cyclide::{
    Error, Result,
    error::{GridError, PrincipalGridError, SurfaceFault},
};
use cyclide::{Warning, warning::PrincipalGridWarning};
use jets::{CUBIC, jets};
use joined::{NotJoined, Surface};
use layout::Layout;
use mesh_table::MeshTable;
use passages::Passages;
use pieces::{Steps, far_from, laid, weights_of_faces};
use shape_tensors::ShapeTensors;
use sheet::Sheet;
use walker::Walker;

/// Vertices of a fit, and of one in noise.
const FIT: usize = 24;
const FIT_IN_NOISE: usize = 40;
/// A difference of the principal curvatures below this part of the curvatures, or of one over the surface's size, is none: planes and
/// spheres.
const FLAT: f64 = 1e-3;
const FLAT_IN_SIZE: f64 = 1e-6;
/// The area over the square of the box's diagonal up to which a surface has none.
const NO_AREA: f64 = 1e-14;
/// Lines of curvature that come back higher by this part of an edge are spirals worth a word, and by this much no closed lines.
const SPIRAL: f64 = 0.1;
const OPEN_SPIRAL: f64 = 1.0;
/// Edges whose lengths differ by more than this factor are uneven.
const UNEVEN: f64 = 3.0;

/// A mesh round umbilics that runs across the lines of curvature on more than this part of the surface is told.
const OFF_LINES: f64 = 0.01;

/// What is being done.
///
/// ```
/// let stage = cyclide_grids::PrincipalStage::Lattice { grids: 0 };
/// assert_ne!(stage, cyclide_grids::PrincipalStage::Curvature);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum PrincipalStage {
    /// Fits to the neighbors of every vertex.
    Curvature,
    /// The directions were smoothed this much, and have so many umbilics.
    Directions {
        /// Weight of smoothness.
        smoothing: f64,
        /// Umbilics left.
        umbilics: usize,
    },
    /// Coordinates along the directions.
    Coordinates,
    /// So many grids are laid, and the next is looked for.
    Lattice {
        /// Grids found.
        grids: usize,
    },
}

/// Grids along the lines of curvature of a surface.
///
/// ```
/// use cyclide::Point3;
/// use cyclide_grids::{CircularMeshOptions, PrincipalGridOptions, make_circular, principal_grids};
/// // A hypar whose rulings the mesh follows: its lines of curvature run across them at 45 degrees.
/// let at = |k: usize| (0.25 * (k % 25) as f64 - 3.0, 0.25 * (k / 25) as f64 - 3.0);
/// let points: Vec<Point3> = (0..625).map(at).map(|(x, y)| Point3::new(x, y, 0.1 * x * y)).collect();
/// let quads = (0..24).flat_map(|j| (0..24).map(move |i| 25 * j + i));
/// let triangles: Vec<[usize; 3]> = quads.flat_map(|a| [[a, a + 1, a + 26], [a, a + 26, a + 25]]).collect();
/// let laid = principal_grids(&points, &triangles, &PrincipalGridOptions::new(0.5))?;
/// let made = make_circular(&laid.grids[0], &CircularMeshOptions::default())?;
/// assert!(made.report.moves.max < 0.03 * 0.5 && made.warnings().is_empty());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct PrincipalGrids {
    /// The grids, the largest first; of a joined mesh in its own order. The normal of the surface is that of growing s and t.
    pub grids: Vec<QuadGrid>,
    /// What was found and done.
    pub report: PrincipalGridReport,
    /// The surface and the directions that the grids follow.
    pub field: PrincipalField,
    /// With [`UmbilicRule::Joined`] on a surface with umbilics: the mesh that the grids are of.
    pub joined: Option<QuadLayout>,
    warnings: Vec<Warning>,
}

impl PrincipalGrids {
    /// Doubts: umbilics smoothed away, several pieces, lines that are spirals, uneven edges.
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// With what concerns all grids.
    fn measured(mut self) -> Self {
        self.report.coverage = self.report.pieces.iter().map(|piece| piece.coverage).sum();
        let ratio = |piece: &GridPiece| piece.edges[1] / piece.edges[0];
        let worst = self.report.pieces.iter().enumerate().max_by(|a, b| ratio(a.1).total_cmp(&ratio(b.1)));
        if let Some((piece, &GridPiece { edges, .. })) = worst.filter(|(_, piece)| ratio(piece) > UNEVEN) {
            self.warnings.push(Warning::PrincipalGrid(PrincipalGridWarning::UnevenEdges {
                piece,
                edges,
                limit: UNEVEN,
            }));
        }
        self
    }
}

/// Lays regular grids along the lines of curvature of a triangle mesh.
///
/// Curvatures come from cubics fitted to the nearest vertices (noise is smoothed away first), directions from a field that is smoothed
/// as little as rids it of umbilics, coordinates from two sparse least-squares problems, each aligned with one family of lines, the
/// points from straight walks in these coordinates. The largest rectangle of cells is the grid, or all cells that hang together
/// ([`GridBorder`]). The steps and constants are those of
/// `docs/math/principal-grids.md`.
///
/// The mesh is one piece with a border: a roof, with holes or without, or a tube, which gets a grid closed along s. The same input
/// gives the same bits on the same kind of processor. Time and memory grow a little faster than the mesh.
///
/// # Errors
/// `no-triangles`, `no-such-vertex`, `not-finite`, `parameter-out-of-range`, `not-a-surface`; `flat-surface` (a plane or a sphere has no
/// lines of curvature), `umbilics-remain`, `field-not-orientable`, `spiral-lines`, `no-grid` (no 3 × 3 cells of this size find room),
/// `not-converged` (a system of equations without a solution in doubles).
pub fn principal_grids(
    points: &[Point3],
    triangles: &[[usize; 3]],
    options: &PrincipalGridOptions,
) -> Result<PrincipalGrids> {
    principal_grids_watched(points, triangles, options, &mut |_| ())
}

/// [`principal_grids`] whose `progress` hears of every stage.
///
/// # Errors
/// Those of [`principal_grids`].
pub fn principal_grids_watched(
    points: &[Point3],
    triangles: &[[usize; 3]],
    options: &PrincipalGridOptions,
    progress: &mut dyn FnMut(PrincipalStage),
) -> Result<PrincipalGrids> {
    for (index, p) in points.iter().enumerate() {
        check_point(index, p.to_vec())?;
    }
    let given = MeshTable::new(points, triangles)?;
    let bounds = Aabb::of_points(given.points.iter().copied());
    let area: f64 = given.areas.iter().sum();
    // Points on a line, but for rounding.
    if !(area > NO_AREA * bounds.map_or(0.0, Aabb::diagonal).powi(2)) {
        return Err(PrincipalGridError::NotASurface { fault: SurfaceFault::NoArea, index: 0 }.into());
    }
    options.check(area)?;
    // The search works about the middle of the surface in units near an edge: powers of two, which round nothing.
    let origin = bounds.map_or(Point3::ORIGIN, |b| b.min.midpoint(b.max));
    let scale = options.edge_length.log2().round().exp2();
    let moved: Vec<Point3> = given.points.iter().map(|p| Point3::ORIGIN + (*p - origin) / scale).collect();
    let edge = options.edge_length / scale;
    let to_world = |p: Point3| origin + p.to_vec() * scale;

    progress(PrincipalStage::Curvature);
    let mut table = given.moved(&moved)?;
    let mut fits = jets(&table, FIT, CUBIC);
    let noise = denoise::noise(&fits);
    let denoised = denoise::denoised(&table, noise, edge, options.denoise)?;
    let noisy = denoised.is_some();
    if let Some(smooth) = denoised {
        table = smooth;
        fits = jets(&table, FIT_IN_NOISE, CUBIC);
    }
    let tensors = ShapeTensors::new(&fits);
    let size = bounds.map_or(0.0, Aabb::diagonal) / scale;
    let limit = (FLAT * tensors.median_curvature).max(FLAT_IN_SIZE / size);
    let difference = tensors.median_difference;
    if !(difference > limit) {
        return Err(PrincipalGridError::FlatSurface {
            difference: difference / scale,
            limit: limit / scale,
            noise: None,
        }
        .into());
    }
    let by_noise = denoise::difference(&table, noise, noisy);
    if difference <= by_noise && (noisy || denoise::is_noise(&table, noise)) {
        let (difference, limit) = (difference / scale, by_noise / scale);
        return Err(PrincipalGridError::FlatSurface { difference, limit, noise: Some(noise * scale) }.into());
    }
    let smoothed = ladder::smoothed(&table, &tensors, options.umbilics, noisy, progress)?;
    let weights = weights_of_faces(&table.triangles, &tensors.weights);
    let as_measured = CrossField::new(&table, tensors.directions());
    let mut report = PrincipalGridReport {
        noise: noise * scale,
        denoised: noisy,
        smoothing: smoothed.mu,
        turn: smoothed.field.mean_angle(&as_measured, &weights),
        umbilics_found: smoothed.found,
        holes: table.borders.len() - 1,
        ..Default::default()
    };
    let umbilic = |vertex: usize, halves| Umbilic { point: to_world(table.points[vertex]), halves };
    report.umbilics = smoothed.singular.iter().map(|s| umbilic(s.vertex, s.halves)).collect();
    // One grid has no room for umbilics.
    let one_grid = options.umbilics == UmbilicRule::Smooth || options.border == GridBorder::Cover;
    if let (true, [first, ..]) = (one_grid, &report.umbilics[..]) {
        let (count, at, halves) = (report.umbilics.len(), first.point.to_array(), first.halves);
        return Err(PrincipalGridError::UmbilicsRemain { count, at, halves, smoothing: smoothed.mu }.into());
    }
    let mut warnings = Vec::new();
    if report.umbilics_found > report.umbilics.len() {
        let count = report.umbilics_found - report.umbilics.len();
        warnings.push(Warning::PrincipalGrid(PrincipalGridWarning::UmbilicsSmoothed { count, turn: report.turn }));
    }

    let layout = Layout::new(&table, &smoothed.field, &smoothed.singular, options.closed != Some(false));
    let joins = options.umbilics == UmbilicRule::Joined;
    let by_hole = (0..layout.halves.len()).find(|k| *k != layout.outer && layout.halves[*k] % 2 != 0);
    if let (true, Some(hole)) = (one_grid || joins && smoothed.singular.is_empty(), by_hole) {
        let at = to_world(table.points[table.ends(table.borders[hole][0])[0]]).to_array();
        return Err(PrincipalGridError::FieldNotOrientable { at, halves: layout.halves[hole] }.into());
    }
    if joins && !smoothed.singular.is_empty() {
        progress(PrincipalStage::Coordinates);
        let (singular, outer) = (&smoothed.singular, layout.outer);
        let surface =
            Surface { table: &table, field: &smoothed.field, singular, outer, jets: &fits, weights: &weights };
        let place = |vertex: usize| to_world(table.points[vertex]).to_array();
        let found = surface.joined(edge).map_err(|NotJoined { vertex, fault }| {
            let at = place(vertex);
            Error::PrincipalGrid(PrincipalGridError::UmbilicsNotJoined { at, fault })
        })?;
        warnings.extend(found.left_out.first().map(|first| {
            let (count, at) = (found.left_out.len(), place(*first));
            Warning::PrincipalGrid(PrincipalGridWarning::UmbilicsLeftOut { count, at })
        }));
        if found.off_lines > OFF_LINES {
            let (part, angle) = (found.off_lines, joined::OFF);
            warnings.push(Warning::PrincipalGrid(PrincipalGridWarning::OffCurvatureLines {
                part,
                angle,
                limit: OFF_LINES,
            }));
        }
        report.border = GridBorder::Staircase;
        let mesh = found.layout;
        let mesh = mesh.with_points(mesh.points().iter().map(|p| to_world(*p)).collect())?;
        let grids: Vec<QuadGrid> = mesh.pieces().iter().map(|piece| piece.grid.clone()).collect();
        report.pieces = grids.iter().map(|grid| pieces::measured(grid, given.areas.iter().sum())).collect();
        let field = PrincipalField::new(&given, &fits, &smoothed.field);
        return Ok(PrincipalGrids { grids, joined: Some(mesh), report, field, warnings }.measured());
    }
    let singular: Vec<Point3> = smoothed.singular.iter().map(|s| table.points[s.vertex]).collect();
    let active = far_from(&table, &singular, edge);
    let mut sheet = Sheet::new(&table, &smoothed.field, active, &layout.cuts);
    progress(PrincipalStage::Coordinates);
    let mut laid_out = match &layout.left {
        None => coordinates(&sheet, &weights, None).ok_or_else(no_solution)?,
        Some(left) => {
            let both = coordinates(&sheet, &weights, Some((left, [true; 2]))).ok_or_else(no_solution)?;
            // s runs along the lines that come back.
            let [round, shift] = if both.periods[0].abs() >= both.periods[1].abs() {
                both.periods
            } else {
                sheet.directions.iter_mut().for_each(|[d1, d2]| (*d1, *d2) = (*d2, -*d1));
                [both.periods[1], both.periods[0]]
            };
            if !(round.abs() >= 3.0 * edge) {
                return Err(
                    PrincipalGridError::NoGrid { edge: options.edge_length, least: lattice::LEAST_CELLS }.into()
                );
            }
            // The coordinate runs more slowly than arc length where its lines spread.
            let across = usize::from(both.periods[0].abs() >= both.periods[1].abs());
            let shift = shift.abs() / both.mean_speed(&sheet, across);
            report.return_shift = Some(shift * scale);
            let (world, edge_length) = (shift * scale, options.edge_length);
            if shift > OPEN_SPIRAL * edge && options.closed != Some(true) {
                return Err(PrincipalGridError::SpiralLines { shift: world, edge: edge_length }.into());
            }
            if shift > SPIRAL * edge {
                warnings.push(Warning::PrincipalGrid(PrincipalGridWarning::SpiralLines {
                    shift: world,
                    edge: edge_length,
                }));
            }
            coordinates(&sheet, &weights, Some((left, [true, false]))).ok_or_else(no_solution)?
        }
    };
    laid_out.leave_out_bad(&mut sheet);
    by_arc_length(&sheet, &mut laid_out, &weights);

    let cut = !layout.cuts.is_empty();
    let mut steps = Steps {
        lengths: [edge; 2],
        columns: None,
        cut,
        most: options.most_pieces.unwrap_or(1),
        // What is joined ends in steps, with umbilics or without.
        border: if joins && options.border == GridBorder::Inside { GridBorder::Staircase } else { options.border },
    };
    report.border = steps.border;
    if cut && options.most_pieces.is_none() {
        steps.most = options::MOST_PIECES;
    }
    if layout.left.is_some() {
        let round = laid_out.periods[0];
        let columns = options.columns.map_or((round.abs() / edge).round().max(3.0), |n| n as f64);
        (steps.columns, steps.lengths[0]) = (Some(columns as i64), round / columns);
    }
    let open = sheet.active.clone();
    let passages = layout.left.as_deref().map(|left| Passages::over_seam(&sheet, left, &laid_out)).unwrap_or_default();
    let walker = Walker { sheet: &sheet, coordinates: &laid_out, passages: &passages, open: &open };
    let found = laid(&walker, &fits, &steps, progress)?;
    if found.is_empty() {
        return Err(PrincipalGridError::NoGrid { edge: options.edge_length, least: lattice::LEAST_CELLS }.into());
    }
    let mut grids = Vec::new();
    for grid in found {
        let points = grid.points().iter().map(|p| to_world(*p)).collect();
        grids.push(grid.with_points(points)?);
    }
    report.pieces = grids.iter().map(|grid| pieces::measured(grid, given.areas.iter().sum())).collect();
    if grids.len() > 1 || cut {
        let coverage = report.pieces.iter().map(|piece| piece.coverage).sum();
        warnings.push(Warning::PrincipalGrid(PrincipalGridWarning::Pieces { count: grids.len(), coverage }));
    }
    let field = PrincipalField::new(&given, &fits, &smoothed.field);
    Ok(PrincipalGrids { grids, joined: None, report, field, warnings }.measured())
}

/// A system of equations that doubles cannot solve, or memory not hold.
fn no_solution() -> Error {
    Error::Grid(GridError::NotConverged { step: 0, residual: f64::INFINITY, limit: 0.0 })
}
