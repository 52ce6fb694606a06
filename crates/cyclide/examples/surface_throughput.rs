//! How fast are points and normals of a patch on a 1000 by 1000 grid? Prints JSON, one line per kind.
//!
//! `cargo run --release --example surface_throughput`. It is the half of `benches/compare_surfaces.py` that runs our side.
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

mod timing;
mod torus_grid;

use cyclide::{Result, surface::ParamSurface};
use timing::smallest;

/// Parameters in each direction.
const COUNT: usize = 1000;

fn main() -> Result<()> {
    let (patch, s) = (torus_grid::patch()?, torus_grid::parameters(COUNT));
    let mut kept = vec![0.0; 6 * COUNT * COUNT];
    let last = |out: &[f64]| out.last().copied().unwrap_or(f64::NAN);
    // The torus equation at every point, before anything is measured.
    torus_grid::points(&patch, &s, &mut kept[..3 * COUNT * COUNT]);
    let off = |row: &[f64], i: usize| ((row[i].hypot(row[COUNT + i]) - 2.0).hypot(row[2 * COUNT + i]) - 0.5).abs();
    let rows = kept.chunks(3 * COUNT).take(COUNT);
    let worst = rows.flat_map(|row| (0..COUNT).map(move |i| off(row, i))).fold(0.0, f64::max);
    assert!(worst < 1e-14, "{worst:e} off the torus");
    let points_kept = smallest(|| {
        torus_grid::points(&patch, &s, &mut kept[..3 * COUNT * COUNT]);
        kept[3 * COUNT * COUNT - 1]
    });
    let points_fresh = smallest(|| {
        let points = torus_grid::fresh_points(&patch, &s);
        last(&points)
    });
    let normals_kept = smallest(|| {
        let (points, normals) = kept.split_at_mut(3 * COUNT * COUNT);
        torus_grid::points_and_normals(&patch, &s, points, normals);
        last(normals)
    });
    let normals_fresh = smallest(|| {
        // Two arrays, as the peers make them.
        let [points, normals] = torus_grid::fresh_points_and_normals(&patch, &s);
        last(&points) + last(&normals)
    });
    // What memory allows: a fresh buffer of one number only.
    let filled = smallest(|| last(&vec![std::hint::black_box(1.5); 3 * COUNT * COUNT]));
    let filled_twice = smallest(|| {
        let [points, normals] = [1.5, 0.5].map(|number| vec![std::hint::black_box(number); 3 * COUNT * COUNT]);
        last(&points) + last(&normals)
    });
    let one_by_one = smallest(|| s.iter().map(|t| s.iter().map(|s| patch.point(*s, *t).x).sum::<f64>()).sum());
    for (name, kind, buffer, seconds) in [
        ("memory, filled with one number", "points", "fresh", filled),
        ("cyclide", "points", "fresh", points_fresh),
        ("cyclide", "points", "kept", points_kept),
        ("cyclide", "points", "none, one at a time", one_by_one),
        ("memory, filled with one number", "normals", "fresh", filled_twice),
        ("cyclide", "normals", "fresh", normals_fresh),
        ("cyclide", "normals", "kept", normals_kept),
    ] {
        println!(r#"{{"name": "{name}", "kind": "{kind}", "buffer": "{buffer}", "seconds": {seconds:e}}}"#);
    }
    Ok(())
}
