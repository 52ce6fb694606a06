//! A torus inverted in a sphere: a Dupin cyclide, patch by patch, exact.
//!
//! `cargo run --release --example invert_torus`
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

use cyclide::{
    Point3,
    conformal::{Conformal, Mobius},
    model::{Model, Units},
    surface::DupinCyclide,
};
use cyclide_io::{ExportOptions, Format, formats::export};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let torus = DupinCyclide::new(4.0, 0.0, 1.4)?;
    let map = Mobius::inversion(Point3::new(7.5, 0.0, 2.0), 7.0)?;
    let mut model = Model::new(Units::Metre);
    for (k, net) in torus.nets([12, 10])?.into_iter().enumerate() {
        let image = net.transformed(&map)?;
        println!("{} patches", image.patches().count());
        model = model.with_surface(format!("cyclide {k}"), image);
    }
    let file = export(&model, Format::Glb, &ExportOptions::default())?;
    let path = std::env::temp_dir().join("cyclide.glb");
    std::fs::write(&path, file.bytes)?;
    println!("{}", path.display());
    Ok(())
}
