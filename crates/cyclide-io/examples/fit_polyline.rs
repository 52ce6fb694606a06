//! The fewest arcs and segments within a tolerance of a dense polyline, as a DXF for a machine.
//!
//! `cargo run --release --example fit_polyline`
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

use cyclide::{
    Point3,
    construct::{ArcFit, ArcFitOptions},
    curve::length,
    model::{Model, Units},
};
use cyclide_io::{ExportOptions, Format, formats::export};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    // What a scan of an oval template may give: 400 points.
    let at = |k: u32| f64::from(k) * std::f64::consts::TAU / 400.0;
    let points: Vec<Point3> = (0..400).map(|k| Point3::new(80.0 * at(k).cos(), 50.0 * at(k).sin(), 0.0)).collect();

    let mut options = ArcFitOptions::new(0.05);
    options.closed = true;
    let fit = ArcFit::new(&points, &options)?;
    let certificate = fit.certificate();
    println!("{} points, {} arcs, {:.4} mm off at most", points.len(), fit.path().arcs().len(), certificate.deviation);
    println!("length {:.3} mm", length(fit.path()));

    let model = Model::new(Units::Millimetre).with_curve("template", fit.path().clone());
    let file = export(&model, Format::Dxf, &ExportOptions::default())?;
    let path = std::env::temp_dir().join("template.dxf");
    std::fs::write(&path, file.bytes)?;
    println!("{}", path.display());
    Ok(())
}
