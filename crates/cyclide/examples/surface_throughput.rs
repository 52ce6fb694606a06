//! How fast are points and normals of a patch on a 1000 by 1000 grid? Prints JSON, one line per kind.
//!
//! `cargo run --release --example surface_throughput`. It is the half of `benches/compare_surfaces.py` that runs our side.
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

mod torus_grid;

use cyclide::{ParamSurface, Result};
use std::time::Instant;

/// Parameters in each direction.
const COUNT: usize = 1000;
/// Repetitions; the smallest time is printed.
const REPETITIONS: usize = 15;

/// Smallest seconds of a run; its result counts, so that nothing can be left out.
fn smallest(mut run: impl FnMut() -> f64) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..REPETITIONS {
        let start = Instant::now();
        let some_number = std::hint::black_box(run());
        least = least.min(start.elapsed().as_secs_f64());
        assert!(some_number.is_finite(), "points are finite");
    }
    least
}

fn main() -> Result<()> {
    let (patch, s) = (torus_grid::patch()?, torus_grid::parameters(COUNT));
    let mut kept = vec![0.0; 6 * COUNT * COUNT];
    let last = |out: &[f64]| out.last().copied().unwrap_or(f64::NAN);
    // The torus equation at every point, before anything is measured.
    torus_grid::points(&patch, &s, &mut kept[..3 * COUNT * COUNT]);
    let [x, y, z] = [0, 1, 2].map(|k| &kept[k * COUNT * COUNT..(k + 1) * COUNT * COUNT]);
    let off = |((x, y), z): ((&f64, &f64), &f64)| ((x.hypot(*y) - 2.0).hypot(*z) - 0.5).abs();
    let worst = x.iter().zip(y).zip(z).map(off).fold(0.0, f64::max);
    assert!(worst < 1e-14, "{worst:e} off the torus");
    let points_kept = smallest(|| {
        torus_grid::points(&patch, &s, &mut kept[..3 * COUNT * COUNT]);
        kept[3 * COUNT * COUNT - 1]
    });
    let points_fresh = smallest(|| {
        let mut fresh = vec![0.0; 3 * COUNT * COUNT];
        torus_grid::points(&patch, &s, &mut fresh);
        last(&fresh)
    });
    let normals_kept = smallest(|| {
        torus_grid::points_and_normals(&patch, &s, &mut kept);
        last(&kept)
    });
    let normals_fresh = smallest(|| {
        let mut fresh = vec![0.0; 6 * COUNT * COUNT];
        torus_grid::points_and_normals(&patch, &s, &mut fresh);
        last(&fresh)
    });
    let one_by_one = smallest(|| s.iter().map(|t| s.iter().map(|s| patch.point(*s, *t).x).sum::<f64>()).sum());
    for (kind, buffer, seconds) in [
        ("points", "fresh", points_fresh),
        ("points", "kept", points_kept),
        ("points", "none, one at a time", one_by_one),
        ("normals", "fresh", normals_fresh),
        ("normals", "kept", normals_kept),
    ] {
        println!(r#"{{"name": "cyclide", "kind": "{kind}", "buffer": "{buffer}", "seconds": {seconds:e}}}"#);
    }
    Ok(())
}
