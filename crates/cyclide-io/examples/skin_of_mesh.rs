//! A smooth skin over a grid of points: the vertices move until every quad has a circle, then patches of Dupin cyclides fill
//! the quads, and a second skin runs at an exact distance.
//!
//! `cargo run --release --example skin_of_mesh`
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

use cyclide::{
    Point3,
    model::{Model, Units},
    surface::{CyclidicNet, NetFrame, QuadGrid},
};
use cyclide_grids::{CircularMeshOptions, make_circular};
use cyclide_io::{ExportOptions, Format, formats::export};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let shell = |i: usize, j: usize| {
        let [x, y] = [i as f64 - 3.0, j as f64 - 2.0];
        Point3::new(x, y, -0.04 * x * x - 0.07 * y * y)
    };
    // 7 by 5 points, s fastest.
    let points = (0..35).map(|k| shell(k % 7, k / 7)).collect();
    let grid = QuadGrid::new(points, [7, 5], [false, false])?;
    let circular = make_circular(&grid, &CircularMeshOptions::default())?;
    println!("vertices moved by {:.4} m at most", circular.report.moves.max);

    let outer = CyclidicNet::new(circular.grid, NetFrame::Auto)?;
    let inner = outer.offset(-0.2)?;
    let model = Model::new(Units::Metre).with_surface("outer", outer).with_surface("inner", inner);
    let file = export(&model, Format::Step, &ExportOptions::default())?;
    let path = std::env::temp_dir().join("skins.step");
    std::fs::write(&path, file.bytes)?;
    println!("{}", path.display());
    Ok(())
}
