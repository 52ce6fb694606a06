//! How long a tessellation takes and how many nodes it has: prints JSON for a quarter by quarter patch of the torus with
//! radii 2 and 0.5 and for the whole torus.
//!
//! `cargo run --release --example tessellation_time -- 1e-4`. It is the half of `benches/compare_tessellation.py` that runs
//! our side.
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

use cyclide::{
    Point3, Vec3,
    mesh::tessellate,
    surface::{CyclidePatch, DupinCyclide},
    topology::{Body, Shell},
};
use std::error::Error;
use std::time::Instant;

/// Repetitions; the smallest time is printed.
const REPETITIONS: usize = 20;

fn main() -> Result<(), Box<dyn Error>> {
    let tolerance: f64 = std::env::args().nth(1).ok_or("usage: tessellation_time TOLERANCE")?.parse()?;
    let corners = [[2.5, 0.0, 0.0], [0.0, 2.5, 0.0], [2.0, 0.0, 0.5], [0.0, 2.0, 0.5]].map(Point3::from);
    let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z)?;
    let shells = [("patch", Shell::from_surface(patch)?), ("torus", DupinCyclide::new(2.0, 0.0, 0.5)?.to_shell()?)];
    for (name, outer) in shells {
        let body = Body { outer, voids: Vec::new() };
        let mut best = f64::INFINITY;
        let mut mesh = tessellate(&body, tolerance)?;
        for _ in 0..REPETITIONS {
            let start = Instant::now();
            mesh = tessellate(&body, tolerance)?;
            best = best.min(start.elapsed().as_secs_f64());
        }
        // At the middle of each cell: distance from the torus.
        let middle = |k: usize| {
            let corners = mesh.faces[k].corners();
            let sum = corners.iter().map(|c| mesh.positions[c.position].to_vec()).fold(Vec3::ZERO, |a, b| a + b);
            let p = sum / corners.len() as f64;
            ((p.x.hypot(p.y) - 2.0).hypot(p.z) - 0.5).abs()
        };
        let deviation = (0..mesh.faces.len()).map(middle).fold(0.0, f64::max);
        println!(
            r#"{{"name": "{name}", "time": {best:e}, "nodes": {}, "triangles": {}, "bound": {:e}, "deviation": {deviation:e}}}"#,
            mesh.positions.len(),
            mesh.triangle_count(),
            mesh.bound
        );
    }
    Ok(())
}
