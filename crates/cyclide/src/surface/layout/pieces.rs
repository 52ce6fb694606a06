//! The regular grids of a mesh: the straight lines of edges from its extraordinary vertices cut it into them.

use super::connections::{Connections, side};
use super::{LayoutPiece, RoundVertex};
use crate::base::vector::Point3;
use crate::error::{Error, GridCellFault, GridError, LayoutFault, Result};
use crate::surface::{GridCell, QuadGrid};
use std::collections::{HashSet, VecDeque};

/// Quads of the rectangle round a grid, at most: a long diagonal band has few of them.
const MOST_QUADS: usize = 10_000_000;

/// The inner vertices without four quads, with what is round them.
pub(super) fn extraordinary(connections: &Connections, on_border: &[bool]) -> Result<Vec<RoundVertex>> {
    let mut found = Vec::new();
    // The extraordinary vertex whose quads have this corner.
    let mut owner: Vec<Option<usize>> = vec![None; on_border.len()];
    for vertex in (0..on_border.len()).filter(|v| !on_border[*v]) {
        let Some(fan) = connections.round(vertex).filter(|fan| fan.len() != 4) else { continue };
        let quads: Vec<usize> = fan.iter().map(|(quad, _)| *quad).collect();
        let ring: Vec<usize> = fan.iter().flat_map(|(_, pair)| *pair).collect();
        let crowded = Err(GridError::NotAQuadLayout { fault: LayoutFault::Crowded, index: vertex }.into());
        if ring.iter().any(|v| on_border[*v]) {
            return crowded;
        }
        for v in ring.iter().chain([&vertex]) {
            if owner[*v].replace(vertex).is_some_and(|other| other != vertex) {
                return crowded;
            }
        }
        found.push(RoundVertex { vertex, ring, quads });
    }
    Ok(found)
}

/// The edges of the straight lines from extraordinary vertices to the border, or to others.
fn cuts(connections: &Connections, round: &[RoundVertex]) -> HashSet<[usize; 2]> {
    let ends: HashSet<usize> = round.iter().map(|at| at.vertex).collect();
    let mut cuts = HashSet::new();
    for RoundVertex { vertex, ring, .. } in round {
        for first in ring.iter().step_by(2) {
            let (mut a, mut b) = (*vertex, *first);
            // A line from the other end has come this way already.
            while cuts.insert(side(a, b)) && !ends.contains(&b) {
                let Some(next) = connections.onward(a, b) else { break };
                (a, b) = (b, next);
            }
        }
    }
    cuts
}

/// The grids, that of the first quad first; quads round extraordinary vertices are in none.
pub(super) fn pieces(connections: &Connections, points: &[Point3], round: &[RoundVertex]) -> Result<Vec<LayoutPiece>> {
    let cuts = cuts(connections, round);
    let mut open_quads = vec![false; connections.quads.len()];
    round.iter().flat_map(|at| &at.quads).for_each(|quad| open_quads[*quad] = true);
    let mut reached = vec![false; connections.quads.len()];
    let mut pieces = Vec::new();
    for first in 0..connections.quads.len() {
        if reached[first] {
            continue;
        }
        let placed = placed(connections, &cuts, first)?;
        placed.iter().for_each(|(quad, ..)| reached[*quad] = true);
        let kept =
            |(quad, corners, at): (usize, [usize; 4], [i64; 2])| (!open_quads[quad]).then_some((quad, corners, at));
        let placed: Vec<_> = placed.into_iter().filter_map(kept).collect();
        if !placed.is_empty() {
            pieces.push(piece(&placed, points, round)?);
        }
    }
    Ok(pieces)
}

/// A quad with its corners in binary order, and its column and row.
type Placed = (usize, [usize; 4], [i64; 2]);

/// The quads that hang together without crossing a cut, in rows and columns: s runs along the first side of the first one.
fn placed(connections: &Connections, cuts: &HashSet<[usize; 2]>, first: usize) -> Result<Vec<Placed>> {
    let [a0, a1, a3, a2] = connections.quads[first];
    let mut places: std::collections::HashMap<usize, ([usize; 4], [i64; 2])> =
        [(first, ([a0, a1, a2, a3], [0, 0]))].into();
    let mut order = VecDeque::from([first]);
    let mut found = Vec::new();
    while let Some(quad) = order.pop_front() {
        let (corners, at) = places[&quad];
        found.push((quad, corners, at));
        let [a0, a1, a2, a3] = corners;
        // The side, corner by corner, and where its ends stand in the quad on the other side.
        let sides = [
            ([a1, a3], [0, 2], [1, 0]),
            ([a0, a2], [1, 3], [-1, 0]),
            ([a2, a3], [0, 1], [0, 1]),
            ([a0, a1], [2, 3], [0, -1]),
        ];
        for ([p, q], [to_p, to_q], step) in sides {
            if cuts.contains(&side(p, q)) {
                continue;
            }
            let Some(next) = connections.across(quad, [p, q]) else { continue };
            let other = |v: usize, not: usize| connections.beside(next, v)?.into_iter().find(|w| *w != not);
            let (Some(beside_p), Some(beside_q)) = (other(p, q), other(q, p)) else { continue };
            let mut corners = [0; 4];
            (corners[to_p], corners[to_q]) = (p, q);
            // The corners opposite along the step.
            let along = if step[0] == 0 { 2 } else { 1 };
            (corners[to_p ^ along], corners[to_q ^ along]) = (beside_p, beside_q);
            let place = (corners, [at[0] + step[0], at[1] + step[1]]);
            match places.get(&next) {
                Some(known) if *known == place => {}
                Some(_) => {
                    return Err(GridError::NotAQuadLayout { fault: LayoutFault::Overlapping, index: next }.into());
                }
                None => {
                    places.insert(next, place);
                    order.push_back(next);
                }
            }
        }
    }
    Ok(found)
}

fn piece(placed: &[Placed], points: &[Point3], round: &[RoundVertex]) -> Result<LayoutPiece> {
    let refused = |fault, index| Err(GridError::NotAQuadLayout { fault, index }.into());
    let ends = |d: usize| {
        let places = || placed.iter().map(|(_, _, at)| at[d]);
        (places().min().unwrap_or(0), places().max().unwrap_or(0))
    };
    let ends = [ends(0), ends(1)];
    let quads = ends.map(|(low, high)| (high - low + 1).unsigned_abs() as usize);
    if quads[0].saturating_mul(quads[1]) > MOST_QUADS {
        return refused(LayoutFault::Overlapping, placed[0].0);
    }
    let size = quads.map(|n| n + 1);
    let mut cells: Vec<Option<usize>> = vec![None; quads[0] * quads[1]];
    let mut vertices: Vec<Option<usize>> = vec![None; size[0] * size[1]];
    for (quad, corners, at) in placed {
        let [i, j] = [0, 1].map(|d| (at[d] - ends[d].0).unsigned_abs() as usize);
        // Two sheets over each other are no grid.
        if cells[i + j * quads[0]].replace(*quad).is_some() {
            return refused(LayoutFault::Overlapping, *quad);
        }
        for (k, v) in corners.iter().enumerate() {
            let place = &mut vertices[i + k % 2 + (j + k / 2) * size[0]];
            if place.replace(*v).is_some_and(|other| other != *v) {
                return refused(LayoutFault::Overlapping, *quad);
            }
        }
    }
    let given: Vec<Option<Point3>> = vertices.iter().map(|v| v.map(|v| points[v])).collect();
    let cell = |i: usize, j: usize| if cells[i + j * quads[0]].is_some() { GridCell::Patch } else { GridCell::Outside };
    match QuadGrid::of_cells(&given, size, cell) {
        Ok(grid) => Ok(LayoutPiece { grid, vertices, quads: cells }),
        Err(Error::Grid(GridError::CellsUnfit { fault: GridCellFault::Enclosed, .. })) if !round.is_empty() => {
            refused(LayoutFault::Holes, round[0].vertex)
        }
        // What is left between two extraordinary vertices falls apart.
        Err(Error::Grid(GridError::CellsUnfit { .. })) if !round.is_empty() => {
            refused(LayoutFault::Crowded, round[0].vertex)
        }
        Err(error) => Err(error),
    }
}
