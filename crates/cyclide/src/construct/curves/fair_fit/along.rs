//! What lies near a place of a curve, found without a look at all of it.

/// Distance of two positions in segments, round the ring of so many if closed.
pub(super) fn apart(a: f64, b: f64, ring: Option<usize>) -> f64 {
    let d = (a - b).abs();
    ring.map_or(d, |n| d.min(n as f64 - d))
}

/// Values at positions along a curve, in the order of these.
pub(super) struct Along<T> {
    values: Vec<(f64, T)>,
    ring: Option<usize>,
}

impl<T: Copy> Along<T> {
    pub(super) fn new(values: impl Iterator<Item = (f64, T)>, ring: Option<usize>) -> Self {
        let mut values: Vec<(f64, T)> = values.collect();
        values.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self { values, ring }
    }

    /// The values within `reach` of a position.
    pub(super) fn near(&self, at: f64, reach: f64) -> impl Iterator<Item = T> + '_ {
        let turn = self.ring.map_or(0.0, |n| n as f64);
        let turns = if self.ring.is_some() { &[-1.0, 0.0, 1.0][..] } else { &[0.0] };
        let mut from = 0;
        let ranges = turns.iter().map(move |k| {
            // A little more than the reach: the distance itself decides.
            let (low, high) = (at + k * turn - reach - 1.0, at + k * turn + reach + 1.0);
            // Round a small ring ranges would overlap.
            let first = self.values.partition_point(|(p, _)| *p < low).max(from);
            from = self.values.partition_point(|(p, _)| *p <= high).max(first);
            first..from
        });
        let near = ranges.flat_map(|range| &self.values[range]);
        near.filter(move |(p, _)| apart(*p, at, self.ring) <= reach).map(|(_, value)| *value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_near_is_found_once() {
        for n in [3_usize, 4, 7, 200] {
            let places: Vec<f64> = (0..3 * n).map(|i| (i as f64 * 0.618_034 * n as f64) % n as f64).collect();
            for ring in [None, Some(n)] {
                let along = Along::new(places.iter().copied().enumerate().map(|(i, p)| (p, i)), ring);
                for (k, reach) in (0..n).flat_map(|k| [(k, 1.6), (k, 2.0), (k, 0.0)]) {
                    let mut found: Vec<usize> = along.near(k as f64, reach).collect();
                    found.sort_unstable();
                    let all = (0..places.len()).filter(|i| apart(places[*i], k as f64, ring) <= reach);
                    assert_eq!(found, all.collect::<Vec<_>>(), "{n} {ring:?} {k} {reach}");
                }
            }
        }
    }
}
