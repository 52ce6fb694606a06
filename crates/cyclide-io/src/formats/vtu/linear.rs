//! Blocks as plain hexahedra with straight sides, for readers that have no Bézier cells: cells of type 12, whose nodes are points of the blocks and are shared.

use super::arrays::{Arrays, Number};
use super::linear_distance::LinearDistance;
use super::order::{KIND, ORDER};
use super::quality::{NAMES, Quality};
use super::reader;
use crate::check::file_content::FileContent;
use crate::check::made::Made;
use crate::check::read_error::ReadError;
use crate::export::error::ExportError;
use crate::export::exported::{Exported, Promise, Written};
use crate::export::job::Job;
use crate::export::provenance::Provenances;
use crate::export::rational_cells::block_of;
use cyclide::{
    Point3,
    model::Model,
    volume::{CellQuality, StructuredGrid},
};
use std::collections::HashMap;

const NO_BLOCKS: &str = "linear cells require blocks, and the model has none: write Bézier cells";
const NOT_DIVIDED: &str = "its blocks are not divided into cells: set `cells`, or write Bézier cells";
/// The grids of all objects with blocks, with the number of each object.
fn grids(model: &Model, provenances: &Provenances<'_>) -> Result<Vec<(usize, StructuredGrid)>, ExportError> {
    let mut grids = Vec::new();
    for (index, item) in model.items.iter().enumerate().filter(|(_, item)| !item.volumes().is_empty()) {
        let Some(places) = provenances.places(index) else {
            return Err(ExportError::NotInFormat { object: item.name.clone(), format: "VTU", detail: NOT_DIVIDED });
        };
        let made = StructuredGrid::new(item.volumes(), places.clone());
        let refused = |source| ExportError::Surface { object: item.name.clone(), surface: 0, source };
        grids.push((index, made.map_err(refused)?));
    }
    if grids.is_empty() {
        let object = model.items.first().map(|item| item.name.clone()).unwrap_or_default();
        return Err(ExportError::NotInFormat { object, format: "VTU", detail: NO_BLOCKS });
    }
    Ok(grids)
}

/// Writes the blocks of a model.
pub(super) fn write(job: &Job<'_>) -> Result<Exported, ExportError> {
    let grids = grids(job.model, &job.provenances)?;
    let mut written = Written { plain_cells: true, ..Written::default() };
    for body in job.bodies {
        let own = grids.iter().find(|(item, _)| *item == body.item && block_of(job.model, body).is_some());
        written.bodies.push(own.map_or(Promise::EXACT, |(_, grid)| {
            let [m, n, l] = grid.divisions();
            let first = body.surface * m * n * l;
            let mut distance = LinearDistance::default();
            (first..first + m * n * l).for_each(|cell| add(&mut distance, grid, cell, &corners(grid, cell)));
            Promise::proved(distance.bound())
        }));
    }
    let others = job.model.items.iter().filter(|item| !item.curves().is_empty() || !item.surfaces().is_empty());
    let names: Vec<&str> = others.map(|item| item.name.as_str()).collect();
    let note = format!("only blocks are written as linear cells; left out: {}", names.join(", "));
    let notes = if names.is_empty() { Vec::new() } else { vec![note] };
    let mut arrays = Arrays::new(job.options.vtu_encoding);
    let text = text(&mut arrays, &grids, job);
    Ok(written.exported(arrays.finish(text), notes))
}

fn text(arrays: &mut Arrays, grids: &[(usize, StructuredGrid)], job: &Job<'_>) -> String {
    let points: usize = grids.iter().map(|(_, grid)| grid.nodes().len()).sum();
    let cells: usize = grids.iter().map(|(_, grid)| grid.cell_count()).sum();
    let mut out = super::head(job, points, cells);
    out.push_str("<CellData>\n");
    let objects = grids.iter().flat_map(|(item, grid)| (0..grid.cell_count()).map(|_| *item as f64));
    arrays.push(&mut out, Number::Int32, reader::OBJECT, 1, objects);
    let blocks = grids.iter().flat_map(|(_, grid)| (0..grid.cell_count()).map(|cell| grid.cell_place(cell).0 as f64));
    arrays.push(&mut out, Number::Int32, reader::PART, 1, blocks);
    let of_cells = qualities(grids);
    for (k, name) in NAMES.into_iter().enumerate() {
        arrays.push(&mut out, Number::Float64, name, 1, of_cells.iter().map(|quality| quality[k]));
    }
    out.push_str("</CellData>\n<Points>\n");
    let places = grids.iter().flat_map(|(_, grid)| grid.nodes()).flat_map(|p| p.to_array());
    arrays.push(&mut out, Number::Float64, reader::POINTS, 3, places);
    out.push_str("</Points>\n<Cells>\n");
    arrays.push(&mut out, Number::Int64, reader::CONNECTIVITY, 1, connectivity(grids).into_iter().map(|k| k as f64));
    arrays.push(&mut out, Number::Int64, reader::OFFSETS, 1, (1..=cells).map(|k| (8 * k) as f64));
    arrays.push(&mut out, Number::UInt8, reader::TYPES, 1, (0..cells).map(|_| f64::from(KIND)));
    out.push_str("</Cells>\n</Piece>\n</UnstructuredGrid>\n");
    out
}

/// The nodes of all cells in VTK's order.
fn connectivity(grids: &[(usize, StructuredGrid)]) -> Vec<usize> {
    let mut first = 0;
    let mut all = Vec::new();
    for (_, grid) in grids {
        all.extend(grid.cells().flat_map(|cell| ORDER.map(|corner| first + cell[corner])));
        first += grid.nodes().len();
    }
    all
}

/// As of Bézier cells.
fn qualities(grids: &[(usize, StructuredGrid)]) -> Vec<Quality> {
    let of = |quality: CellQuality| {
        let CellQuality { orthogonality, scaled_jacobian, aspect_ratio, shortest_side, jacobian, .. } = quality;
        [orthogonality, scaled_jacobian, aspect_ratio, shortest_side, jacobian]
    };
    grids.iter().flat_map(|(_, grid)| grid.cell_qualities()).map(of).collect()
}

/// The corners of a cell, binary order.
fn corners(grid: &StructuredGrid, cell: usize) -> [Point3; 8] {
    grid.cell(cell).map(|node| grid.nodes()[node])
}

/// Adds a cell of a grid, and a hexahedron with these corners.
fn add(distance: &mut LinearDistance, grid: &StructuredGrid, cell: usize, corners: &[Point3; 8]) {
    let (block, at) = grid.cell_place(cell);
    let block = &grid.blocks()[block];
    let [s, t, u] = std::array::from_fn(|axis| [grid.places()[axis][at[axis]], grid.places()[axis][at[axis] + 1]]);
    // Of a left-handed block s and t are exchanged.
    let ranges = if block.is_right_handed() { [s, t, u] } else { [t, s, u] };
    distance.add(&block.right_handed(), ranges, corners);
}

/// Holds what was read against the model: the distance of each body.
pub(super) fn deviations(made: &Made<'_>, content: &FileContent, read: &reader::Plain) -> Result<Vec<f64>, ReadError> {
    let (model, bodies) = (made.ready.model, &made.ready.bodies);
    let grids =
        grids(model, &made.ready.provenances).map_err(|error| ReadError::syntax("the model", error.to_string()))?;
    let count: usize = grids.iter().map(|(_, grid)| grid.cell_count()).sum();
    if content.volumes.len() != count || read.connectivity != connectivity(&grids) {
        return Err(ReadError::syntax(reader::CONNECTIVITY, "its cells do not match the blocks"));
    }
    if read.qualities != qualities(&grids) {
        return Err(ReadError::syntax("CellData", "the quality of a cell does not match its block"));
    }
    let of_blocks: HashMap<(usize, usize), usize> =
        bodies.iter().enumerate().map(|(index, body)| ((body.item, body.surface), index)).collect();
    let mut distances = vec![LinearDistance::default(); bodies.len()];
    let mut first = 0;
    for (item, grid) in &grids {
        for cell in 0..grid.cell_count() {
            let (block, _) = grid.cell_place(cell);
            if read.tags[first + cell] != [*item, block] {
                return Err(ReadError::Volume { volume: first + cell, detail: "it is assigned to the wrong block" });
            }
            let rows = content.volumes[first + cell].volume.rows();
            // The last parameter is the fastest of rows, the first of corners.
            let corner = |k: usize| {
                let [x, y, z, _] = rows[(k & 1) << 2 | (k & 2) | k >> 2];
                Point3::new(x, y, z)
            };
            if let Some(body) = of_blocks.get(&(*item, block)) {
                add(&mut distances[*body], grid, cell, &std::array::from_fn(corner));
            }
        }
        first += grid.cell_count();
    }
    Ok(distances.into_iter().map(LinearDistance::bound).collect())
}
