//! Reads STEP files with truck and prints a line of JSON per shell: counts, whether its topology is closed, and the same of
//! its mesh with its volume; a line with `error` for a file that truck does not read.

use std::panic::catch_unwind;
use truck_meshalgo::prelude::*;
use truck_stepio::r#in::{Table, ruststep};

/// Chord error of the mesh, of the shell's size.
const RELATIVE_TOLERANCE: f64 = 1e-3;

fn main() {
    for path in std::env::args().skip(1) {
        match shells(&path) {
            Ok(lines) => lines.iter().for_each(|line| println!("{line}")),
            Err(error) => println!("{{\"error\": {error:?}}}"),
        }
    }
}

fn shells(path: &str) -> Result<Vec<String>, String> {
    let text = std::fs::read_to_string(path).map_err(|e| e.to_string())?;
    let exchange = ruststep::parser::parse(&text).map_err(|e| e.to_string())?;
    let table = Table::from_data_section(exchange.data.first().ok_or("no data")?);
    let mut numbers: Vec<&u64> = table.shell.keys().collect();
    numbers.sort();
    numbers.into_iter().map(|number| shell(&table, *number)).collect()
}

fn shell(table: &Table, number: u64) -> Result<String, String> {
    let shell = table.to_compressed_shell(&table.shell[&number]).map_err(|e| e.to_string())?;
    let (vertices, edges, faces) = (shell.vertices.len(), shell.edges.len(), shell.faces.len());
    let topology = truck_topology::Shell::extract(shell.clone()).map_err(|e| e.to_string())?.shell_condition();
    let mesh = catch_unwind(|| {
        let size = shell.robust_triangulation(0.1).to_polygon().bounding_box().diameter();
        let meshed = shell.robust_triangulation(RELATIVE_TOLERANCE * size);
        let count = meshed.faces.iter().filter(|face| face.surface.is_some()).count();
        let mut mesh = meshed.to_polygon();
        mesh.put_together_same_attrs(50.0 * TOLERANCE).remove_degenerate_faces().remove_unused_attrs();
        (count, mesh.shell_condition(), mesh.volume())
    });
    let (meshed, mesh, volume) = mesh.map_err(|_| "the mesh failed".to_owned())?;
    Ok(format!(
        "{{\"vertices\": {vertices}, \"edges\": {edges}, \"faces\": {faces}, \"topology\": \"{topology:?}\", \
         \"meshed\": {meshed}, \"mesh\": \"{mesh:?}\", \"volume\": {volume:e}}}"
    ))
}
