//! How fast motions are made and evaluated, and curves through five and seven points: reads poses (`t,x,y,z,qw,qx,qy,qz` per line) from a
//! file, prints JSON.
//!
//! `cargo run --release --example motion_throughput -- poses.csv 16` evaluates 16 poses per span. It is the half of
//! `benches/compare_motions.py` that runs our side.
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

use cyclide::{
    Point3, Vec3,
    construct::{NodeParameters, QbInterpolation},
    motion::{Motion, Pose, RationalMotion, ScrewMotion, TimedPose},
};
use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

/// Repetitions; the smallest time is printed.
const REPETITIONS: usize = 5;
/// Curves made for one time.
const CURVES: u32 = 10_000;
const USAGE: &str = "usage: motion_throughput FILE SAMPLES_PER_SPAN";

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().ok_or(USAGE)?;
    let samples: usize = arguments.next().ok_or(USAGE)?.parse()?;
    let mut poses = Vec::new();
    for line in std::fs::read_to_string(file)?.lines() {
        let numbers = line.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        let [time, x, y, z, qw, qx, qy, qz] = numbers[..] else { return Err("eight numbers per line".into()) };
        poses.push(TimedPose { time, pose: Pose::new([qw, qx, qy, qz].into(), Vec3::new(x, y, z))? });
    }
    let count = samples * (poses.len() - 1);
    measure("spline", || RationalMotion::spline(&poses).map(Motion::from), count)?;
    measure("screws", || ScrewMotion::new(&poses).map(Motion::from), count)?;
    for points in [5, 7] {
        let given: Vec<Point3> = (0..points).map(place).collect();
        let start = Instant::now();
        for _ in 0..CURVES {
            black_box(QbInterpolation::through_points(black_box(&given), &NodeParameters::Uniform)?);
        }
        let build = start.elapsed().as_secs_f64() / f64::from(CURVES);
        let given: Vec<[f64; 3]> = given.iter().map(|p| [p.x, p.y, p.z]).collect();
        println!(r#"{{"name": "interpolation", "points": {points}, "build": {build:e}, "given": {given:?}}}"#);
    }
    Ok(())
}

/// Points in general position.
fn place(k: usize) -> Point3 {
    let a = k as f64;
    Point3::new((1.3 * a).cos() * 3.0, (0.9 * a).sin() * 3.0, a + (2.1 * a).sin())
}

/// Prints the smallest times of construction and evaluation.
fn measure(name: &str, make: impl Fn() -> cyclide::Result<Motion>, count: usize) -> Result<(), Box<dyn Error>> {
    let (mut build, mut evaluate) = (f64::INFINITY, f64::INFINITY);
    let mut out = vec![Pose::IDENTITY; count];
    for _ in 0..REPETITIONS {
        let start = Instant::now();
        let motion = make()?;
        let built = Instant::now();
        let [first, last] = motion.domain();
        for (i, pose) in out.iter_mut().enumerate() {
            *pose = motion.pose(first + (last - first) * (i as f64 / count as f64));
        }
        evaluate = evaluate.min(built.elapsed().as_secs_f64());
        build = build.min((built - start).as_secs_f64());
    }
    // A sum of the output, so that no evaluation can be left out.
    let sum: f64 = out.iter().map(|pose| pose.translation().x + pose.rotation().w).sum();
    println!(r#"{{"name": "{name}", "build": {build:e}, "evaluate": {evaluate:e}, "sum": {sum:e}}}"#);
    Ok(())
}
