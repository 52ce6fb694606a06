//! How fast and how fair are fair fits: reads points (`x,y` or `x,y,z` per line) from a file, prints JSON.
//!
//! `cargo run --release --example fair_fit_time -- points.csv closed 0.4 0` fits within 0.4 with center 0. It is the
//! half of `benches/compare_fits.py` that runs our side.
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

use cyclide::{
    Point3,
    construct::{FairFit, FairFitOptions},
    curve::fairness,
};
use std::error::Error;
use std::time::Instant;

/// Repetitions; the smallest time is printed.
const REPETITIONS: usize = 5;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, closed, tolerance, centre] = &arguments[..] else {
        return Err("usage: fair_fit_time FILE closed|open TOLERANCE CENTRE".into());
    };
    let mut points = Vec::new();
    for line in std::fs::read_to_string(file)?.lines() {
        let numbers = line.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        points.push(match numbers[..] {
            [x, y] => Point3::new(x, y, 0.0),
            [x, y, z] => Point3::new(x, y, z),
            _ => return Err("two or three numbers per line".into()),
        });
    }
    let options = FairFitOptions {
        closed: closed == "closed",
        centre: centre.parse()?,
        ..FairFitOptions::new(tolerance.parse()?)
    };
    let mut seconds = f64::INFINITY;
    let mut fit = FairFit::new(&points, &options)?;
    for _ in 0..REPETITIONS {
        let start = Instant::now();
        fit = FairFit::new(&points, &options)?;
        seconds = seconds.min(start.elapsed().as_secs_f64());
    }
    let (sheet, fair) = (fit.certificate(), fairness(fit.spline()));
    println!(
        "{{\"seconds\": {seconds}, \"nodes\": {}, \"deviation\": {}, \"rms\": {}, \"polyline\": {}, \"variation\": {}, \"sign_changes\": {}, \"extrema\": {}}}",
        sheet.nodes,
        sheet.deviation,
        sheet.rms,
        sheet.polyline_deviation,
        or_null(fair.variation),
        or_null(fair.sign_changes),
        fair.extrema,
    );
    Ok(())
}

fn or_null(value: Option<impl ToString>) -> String {
    value.map_or("null".to_owned(), |value| value.to_string())
}
