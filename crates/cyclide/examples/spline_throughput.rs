//! How fast circle splines and Möbius splines are made and evaluated: reads points (`x,y,z` per line) from a file, prints JSON.
//!
//! `cargo run --release --example spline_throughput -- points.csv 16` evaluates 16 points per segment. It is the half
//! of `benches/compare_scipy.py` that runs our side.
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

use cyclide::{
    Point3,
    construct::{FairSplineOptions, MoebiusSplineOptions},
    curve::{BlendVariant, CircleSpline, CircleSplineOptions, ParamCurve, QbSpline},
};
use std::error::Error;
use std::time::Instant;

/// Repetitions; the smallest time is printed.
const REPETITIONS: usize = 5;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().ok_or("usage: spline_throughput FILE SAMPLES_PER_SEGMENT")?;
    let samples: usize = arguments.next().ok_or("usage: spline_throughput FILE SAMPLES_PER_SEGMENT")?.parse()?;
    let mut points = Vec::new();
    for line in std::fs::read_to_string(file)?.lines() {
        let xyz = line.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        let [x, y, z] = xyz[..] else { return Err("three numbers per line".into()) };
        points.push(Point3::new(x, y, z));
    }
    let count = samples * points.len();
    let parameters: Vec<f64> = (0..count).map(|i| i as f64 / count as f64).collect();
    let mut out = vec![Point3::default(); count];

    let flat: Vec<Point3> = points.iter().map(|p| Point3::new(p.x, p.y, 0.0)).collect();
    let circle = |variant| {
        let options = CircleSplineOptions { closed: true, variant, ..Default::default() };
        let points = &points;
        move || CircleSpline::from_points(points, &options)
    };
    let fair = |points| {
        let options = FairSplineOptions { closed: true, ..Default::default() };
        move || CircleSpline::fair(points, &options)
    };
    measure("circle spline, rational, order 2", circle(BlendVariant::Rational), &parameters, &mut out)?;
    measure("circle spline, trigonometric, order 2", circle(BlendVariant::Trigonometric), &parameters, &mut out)?;
    measure("fair spline", fair(&points), &parameters, &mut out)?;
    measure("fair spline, planar", fair(&flat), &parameters, &mut out)?;
    let options = MoebiusSplineOptions { closed: true, ..Default::default() };
    measure("Möbius spline", || QbSpline::through_points(&points, &options), &parameters, &mut out)
}

/// Prints the smallest times of construction and evaluation.
fn measure<C: ParamCurve>(
    name: &str,
    make: impl Fn() -> cyclide::Result<C>,
    parameters: &[f64],
    out: &mut [Point3],
) -> Result<(), Box<dyn Error>> {
    let (mut build, mut evaluate) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..REPETITIONS {
        let start = Instant::now();
        let spline = make()?;
        let built = Instant::now();
        spline.points_into(parameters, out);
        evaluate = evaluate.min(built.elapsed().as_secs_f64());
        build = build.min((built - start).as_secs_f64());
    }
    // A sum of the output, so that no evaluation can be left out.
    let sum: f64 = out.iter().map(|p| p.x + p.y + p.z).sum();
    println!(r#"{{"name": "{name}", "build": {build:e}, "evaluate": {evaluate:e}, "sum": {sum:e}}}"#);
    Ok(())
}
