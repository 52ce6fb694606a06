//! How fast are points and Jacobians of a block on a grid of 100 by 100 by 100? Prints JSON.
//!
//! `cargo run --release --example volume_throughput`. It is the half of `benches/compare_volumes.py` that runs our side.
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

mod volume_rows;

use cyclide::Result;
use std::time::Instant;

/// Parameters in each direction.
const COUNT: usize = 100;
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
    let (block, s) = (volume_rows::block()?, volume_rows::parameters(COUNT));
    let mut kept = vec![0.0; 4 * COUNT.pow(3)];
    let last = |out: &[f64]| out.last().copied().unwrap_or(f64::NAN);
    let rows_kept = smallest(|| {
        volume_rows::rows(&block, &s, &mut kept);
        last(&kept)
    });
    let rows_fresh = smallest(|| {
        let mut fresh = vec![0.0; 4 * COUNT.pow(3)];
        volume_rows::rows(&block, &s, &mut fresh);
        last(&fresh)
    });
    let one_by_one = smallest(|| volume_rows::one_by_one(&block, &s));
    // The exact form for the peers, rows [wx, wy, wz, w] at 9 i + 3 j + k with i along s.
    let form: Vec<String> = block.to_rational().rows().iter().map(|row| format!("{row:?}")).collect();
    // What they are checked with: x, y, z and the Jacobian at (s, t, u) = (3, 50, 97)/99.
    let place = |k: usize| kept[4 * COUNT * (50 + COUNT * 97) + k * COUNT + 3];
    println!(
        "{{\"count\": {COUNT}, \"kept\": {rows_kept}, \"fresh\": {rows_fresh}, \"one by one\": {one_by_one}, \"check\": {:?}, \"rows\": [{}]}}",
        [0, 1, 2, 3].map(place),
        form.join(", ")
    );
    Ok(())
}
