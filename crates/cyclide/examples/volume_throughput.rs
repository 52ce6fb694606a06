//! How fast are points and Jacobians of a block on a grid of 100 by 100 by 100? Prints JSON.
//!
//! `cargo run --release --example volume_throughput`. It is the half of `benches/compare_volumes.py` that runs our side.
#![allow(clippy::print_stdout, reason = "an example program reports by printing")]

mod timing;
mod volume_rows;

use cyclide::Result;
use timing::smallest;

/// Parameters in each direction.
const COUNT: usize = 100;

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
