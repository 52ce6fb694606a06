//! A bent patch made thick: a closed solid whose second skin is at an exact distance.
//!
//! `cargo run --release --example offset_solid`
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

use cyclide::{
    Point3, Vec3,
    model::{Model, Units},
    surface::{CyclidePatch, CyclidicNet},
};
use cyclide_io::{ExportOptions, Format, formats::export};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let corners = [[-40.0, -30.0, 0.0], [40.0, -30.0, 0.0], [-30.0, 40.0, 0.0], [30.0, 40.0, 0.0]].map(Point3::from);
    let frame = [Vec3::new(8.0, -1.0, 4.0), Vec3::new(-1.0, 8.0, 4.0)].map(|v| v / 9.0);
    let patch = CyclidePatch::from_corners_and_frame(corners, frame[0], frame[1])?;
    let solid = CyclidicNet::from(patch).thick(3.0)?;
    println!("volume {:.2} mm³, area {:.2} mm²", solid.outer.volume(), solid.outer.area());

    let model = Model::new(Units::Millimetre).with_surface("shell", solid);
    for (format, name) in [(Format::Step, "shell.step"), (Format::Stl, "shell.stl")] {
        let path = std::env::temp_dir().join(name);
        std::fs::write(&path, export(&model, format, &ExportOptions::default())?.bytes)?;
        println!("{}", path.display());
    }
    Ok(())
}
