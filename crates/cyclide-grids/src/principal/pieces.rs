//! Grids laid one after the other, each as large as it can be on what the others left.

use super::PrincipalStage;
use super::cover::covering;
use super::jets::VertexJet;
use super::lattice::{Lattice, Piece};
use super::mesh_table::MeshTable;
use super::point_grid::PointGrid;
use super::report::GridPiece;
use super::staircase;
use super::walker::Walker;
use crate::principal_rules::GridBorder;
use cyclide::Point3;
use cyclide::Result;
use cyclide::surface::{GridCell, QuadGrid};

/// Places of the lattice that are tried along each direction.
const PHASES: usize = 3;
/// Triangles from which walks start, far from each other, where sheets are cut.
const SEEDS: usize = 4;
/// Triangles nearer than this part of an edge to a grid count as covered.
const MARGIN: f64 = 0.75;

/// How the lattice is laid.
pub(super) struct Steps {
    pub(super) lengths: [f64; 2],
    /// Of a surface that comes back to itself.
    pub(super) columns: Option<i64>,
    pub(super) cut: bool,
    pub(super) most: usize,
    pub(super) border: GridBorder,
}

/// The grids in the units of the search, largest first.
///
/// # Errors
/// As of `QuadGrid::new`, which cannot be on points of the surface.
pub(super) fn laid(
    base: &Walker<'_>,
    jets: &[VertexJet],
    steps: &Steps,
    progress: &mut dyn FnMut(PrincipalStage),
) -> Result<Vec<QuadGrid>> {
    let table = base.sheet.table;
    if steps.border == GridBorder::Cover {
        progress(PrincipalStage::Lattice { grids: 0 });
        let lattices = lattices(base, steps, seeds(base, 1));
        // Of several the first.
        let widest = lattices.reduce(|best, found| if found.count() > best.count() { found } else { best });
        let Some(grid) = widest.and_then(|lattice| covering(&lattice, &|place| base.point(place, jets))) else {
            return Ok(Vec::new());
        };
        return Ok(vec![grid?]);
    }
    let mut open = base.open.to_vec();
    let mut grids = Vec::new();
    while grids.len() < steps.most {
        progress(PrincipalStage::Lattice { grids: grids.len() });
        let walker = Walker { open: &open, ..*base };
        let seeds = seeds(&walker, if steps.cut || !grids.is_empty() { SEEDS } else { 1 });
        let mut best: Option<Piece> = None;
        for lattice in lattices(&walker, steps, seeds) {
            let found = match steps.border {
                GridBorder::Staircase => lattice.piece_in_steps(),
                _ => lattice.largest_piece(),
            };
            best = match (best, found) {
                (Some(best), Some(found)) if (best.closed, best.count) >= (found.closed, found.count) => Some(best),
                (best, found) => found.or(best),
            };
        }
        let Some(piece) = best else { break };
        let points: Vec<Option<Point3>> = piece.places.iter().map(|at| at.map(|at| walker.point(at, jets))).collect();
        let made = match &piece.cells {
            Some(cells) => staircase::grid(points, piece.size, cells),
            None => points
                .into_iter()
                .collect::<Option<_>>()
                .map(|points| QuadGrid::new(points, piece.size, [piece.closed, false])),
        };
        let Some(grid) = made.transpose()? else { break };
        cover(table, &grid, &mut open, steps.lengths[1].abs());
        grids.push(grid);
    }
    Ok(grids)
}

/// The lattices from all seeds in all phases.
fn lattices<'a>(walker: &'a Walker<'a>, steps: &'a Steps, seeds: Vec<usize>) -> impl Iterator<Item = Lattice<'a>> {
    let places = seeds.into_iter().flat_map(|seed| (0..PHASES * PHASES).map(move |phase| (seed, phase)));
    places.filter_map(|(seed, phase)| {
        let part = |k: usize, d: usize| k as f64 / PHASES as f64 * steps.lengths[d];
        let phase = [part(phase % PHASES, 0), part(phase / PHASES, 1)];
        Lattice::new(walker, seed, steps.lengths, phase, steps.columns)
    })
}

/// Triangles far from everything that stops a walk, and from each other: of the deepest triangle, then of those that are deep and far
/// from the ones before.
pub(super) fn seeds(walker: &Walker<'_>, count: usize) -> Vec<usize> {
    let table = walker.sheet.table;
    let faces = table.triangles.len();
    let spread = |from: &mut dyn Iterator<Item = usize>| {
        let mut steps = vec![usize::MAX; faces];
        let mut queue: std::collections::VecDeque<usize> = from.collect();
        queue.iter().for_each(|f| steps[*f] = 0);
        while let Some(f) = queue.pop_front() {
            for other in (3 * f..3 * f + 3).filter_map(|half| walker.sheet.across(half)).map(|half| half / 3) {
                if walker.open[other] && steps[other] == usize::MAX {
                    steps[other] = steps[f] + 1;
                    queue.push_back(other);
                }
            }
        }
        steps
    };
    let stops =
        |f: usize| (3 * f..3 * f + 3).any(|half| walker.sheet.across(half).is_none_or(|other| !walker.open[other / 3]));
    let mut depth = spread(&mut (0..faces).filter(|f| walker.open[*f] && stops(*f)));
    let mut seeds = Vec::new();
    for _ in 0..count {
        let inside = (0..faces).filter(|f| walker.open[*f] && depth[*f] > 0);
        // Of several the first.
        let Some(seed) = inside.max_by(|a, b| depth[*a].cmp(&depth[*b]).then(b.cmp(a))) else { break };
        seeds.push(seed);
        let away = spread(&mut std::iter::once(seed));
        depth.iter_mut().zip(away).for_each(|(depth, away)| *depth = (*depth).min(away));
    }
    seeds
}

/// Closes what a grid covers to those that follow.
fn cover(table: &MeshTable, grid: &QuadGrid, open: &mut [bool], edge: f64) {
    let near = PointGrid::new(grid.points(), edge);
    for (f, open) in open.iter_mut().enumerate().filter(|(_, open)| **open) {
        *open = !near.is_near(table.centroid(f), MARGIN * edge);
    }
}

/// What a grid on a surface of this area is like.
pub(super) fn measured(grid: &QuadGrid, area: f64) -> GridPiece {
    GridPiece { coverage: area_of(grid) / area, edges: extreme_edges(grid) }
}

/// The quads that have patches.
fn patches(grid: &QuadGrid) -> impl Iterator<Item = (usize, usize)> {
    let [columns, rows] = grid.quads();
    let quads = (0..rows).flat_map(move |j| (0..columns).map(move |i| (i, j)));
    quads.filter(|(i, j)| grid.cell(*i, *j) == GridCell::Patch)
}

fn area_of(grid: &QuadGrid) -> f64 {
    let area = |(i, j)| {
        let [a, b, c, d] = grid.corners(i, j).map(|k| grid.points()[k]);
        // Half the cross product of the diagonals.
        0.5 * (d - a).cross(c - b).length()
    };
    patches(grid).map(area).sum()
}

fn extreme_edges(grid: &QuadGrid) -> [f64; 2] {
    let lengths = patches(grid).flat_map(|(i, j)| {
        let [a, b, c, d] = grid.corners(i, j).map(|k| grid.points()[k]);
        [a.distance(b), c.distance(d), a.distance(c), b.distance(d)]
    });
    lengths.fold([f64::INFINITY, 0.0], |[low, high], x| [low.min(x), high.max(x)])
}

/// The weight of each triangle: the mean of its corners.
pub(super) fn weights_of_faces(triangles: &[[usize; 3]], weights: &[f64]) -> Vec<f64> {
    triangles.iter().map(|corners| corners.iter().map(|v| weights[*v]).sum::<f64>() / 3.0).collect()
}

/// Triangles near singular places, where directions mean nothing.
pub(super) fn far_from(table: &MeshTable, places: &[Point3], distance: f64) -> Vec<bool> {
    let far = |f: usize| places.iter().all(|p| p.distance(table.centroid(f)) >= distance);
    (0..table.triangles.len()).map(far).collect()
}
