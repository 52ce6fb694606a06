//! The smooth runs of a chain of segments between its kinks.

use std::ops::Range;

/// The runs of `n` segments between kinks, the rising indices of the segments that start with one, as ranges in order. In a closed chain
/// with kinks the first run starts at the first kink and the last one passes the seam: indices are to be taken modulo `n`.
pub(crate) fn smooth_runs(n: usize, closed: bool, kinks: &[usize]) -> Vec<Range<usize>> {
    let (first, last) = if closed { kinks.first().map_or((0, n), |k| (*k, k + n)) } else { (0, n) };
    let mut runs = Vec::with_capacity(kinks.len() + 1);
    let mut from = first;
    for &k in kinks.iter().filter(|k| **k > first) {
        runs.push(from..k);
        from = k;
    }
    runs.push(from..last);
    runs
}
