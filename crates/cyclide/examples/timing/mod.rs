//! Times of short runs.

use std::time::Instant;

/// Repetitions; the smallest time counts.
const REPETITIONS: usize = 15;

/// Smallest seconds of a run; its result counts, so that nothing can be left out.
pub fn smallest(mut run: impl FnMut() -> f64) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..REPETITIONS {
        let start = Instant::now();
        let some_number = std::hint::black_box(run());
        least = least.min(start.elapsed().as_secs_f64());
        assert!(some_number.is_finite(), "results are finite");
    }
    least
}
