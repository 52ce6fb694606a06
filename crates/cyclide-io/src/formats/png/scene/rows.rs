//! Work on the rows of a picture, on all cores where there are several.

use std::panic::resume_unwind;
use std::thread;

/// What is made of the numbers from 0 to a count, in their order.
pub(super) fn side_by_side<T: Send>(count: usize, make: impl Fn(usize) -> T + Sync) -> Vec<T> {
    // Where there are no threads, as in a browser, this is not known.
    let workers = thread::available_parallelism().map_or(1, usize::from).min(count);
    if workers <= 1 {
        return (0..count).map(make).collect();
    }
    let part = count.div_ceil(workers);
    let make = &make;
    thread::scope(|scope| {
        let parts: Vec<_> = (0..workers)
            .map(|k| scope.spawn(move || (k * part..((k + 1) * part).min(count)).map(make).collect::<Vec<T>>()))
            .collect();
        parts.into_iter().flat_map(|part| part.join().unwrap_or_else(|panic| resume_unwind(panic))).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_is_made_once_and_in_order() {
        for count in [0, 1, 2, 7, 1000] {
            assert_eq!(side_by_side(count, |k| 3 * k), (0..count).map(|k| 3 * k).collect::<Vec<_>>());
        }
    }
}
