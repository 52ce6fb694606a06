//! The fairest closed spline through points, exact in STEP.
//!
//! `cargo run --release --example spline_to_step`
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

use cyclide::{
    Point3,
    construct::FairSplineOptions,
    curve::{CircleSpline, joints},
    model::{Model, Units},
};
use cyclide_io::{ExportOptions, Format, formats::export};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let points = [[0.0, 0.0, 0.0], [40.0, 10.0, 0.0], [60.0, 50.0, 20.0], [20.0, 60.0, 5.0]].map(Point3::from);
    let spline = CircleSpline::fair(&points, &FairSplineOptions { closed: true, ..Default::default() })?;
    let jump = joints(&spline).iter().map(|joint| joint.curvature_jump).fold(0.0, f64::max);
    println!("{} segments, curvature jumps by {jump:.1e} at most", spline.segments().len());

    let model = Model::new(Units::Millimetre).with_curve("loop", spline);
    let file = export(&model, Format::Step, &ExportOptions::default())?;
    assert!(file.exact);
    let path = std::env::temp_dir().join("loop.step");
    std::fs::write(&path, file.bytes)?;
    println!("{}", path.display());
    Ok(())
}
