//! The ups and downs of the curvature along a smooth run.

/// A place at which the curvature turns or a piece ends: its value, and below which swing nothing counts there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Swing {
    pub(super) value: f64,
    pub(super) floor: f64,
}

/// The curvature of a smooth run: between two neighbouring entries it is monotone.
#[derive(Debug, Default)]
pub(super) struct Run {
    swings: Vec<Swing>,
    closed: bool,
}

impl Run {
    pub(super) fn new() -> Self {
        Self::default()
    }

    pub(super) fn push(&mut self, swing: Swing) {
        self.swings.push(swing);
    }

    /// The end is the start: the walk begins at the largest value.
    pub(super) fn close(&mut self) {
        self.closed = true;
        let largest = |best: usize, i: usize| if self.swings[i].value > self.swings[best].value { i } else { best };
        let first = (0..self.swings.len()).fold(0, largest);
        self.swings.rotate_left(first);
        self.swings.extend(self.swings.first().copied());
    }

    /// Places where the value passes from above its noise to below it, or back.
    pub(super) fn sign_changes(&self) -> usize {
        let mut side = 0.0;
        let mut count = 0;
        for swing in self.swings.iter().filter(|s| s.value.abs() > s.floor) {
            count += usize::from(side * swing.value.signum() < 0.0);
            side = swing.value.signum();
        }
        count
    }

    /// Extrema inside the run; of a closed one all, an even number.
    pub(super) fn extrema(&self) -> usize {
        let turns = self.turns();
        // A closed run starts and ends at its largest value, which is one extremum if anything swings at all.
        turns.inner + usize::from(self.closed && turns.inner > 0)
    }

    /// The way up and down, small swings left out.
    pub(super) fn total_variation(&self) -> f64 {
        self.turns().way
    }

    /// Follows the values and turns round only after a swing back by more than the noise.
    fn turns(&self) -> Turns {
        let mut turns = Turns { inner: 0, way: 0.0 };
        let Some(&first) = self.swings.first() else {
            return turns;
        };
        // The values reached downwards and upwards since the last turn, until a direction is known.
        let (mut low, mut high, mut rising) = (first, first, None);
        for &swing in &self.swings {
            let beyond = |from: Swing| (swing.value - from.value).abs() > from.floor.max(swing.floor);
            match rising {
                None => {
                    low = if swing.value < low.value { swing } else { low };
                    high = if swing.value > high.value { swing } else { high };
                    if swing.value > low.value && beyond(low) {
                        (rising, high) = (Some(true), swing);
                        turns.way += swing.value - low.value;
                    } else if swing.value < high.value && beyond(high) {
                        (rising, low) = (Some(false), swing);
                        turns.way += high.value - swing.value;
                    }
                }
                Some(true) if swing.value >= high.value => {
                    turns.way += swing.value - high.value;
                    high = swing;
                }
                Some(true) if beyond(high) => {
                    turns.inner += 1;
                    turns.way += high.value - swing.value;
                    (rising, low) = (Some(false), swing);
                }
                Some(false) if swing.value <= low.value => {
                    turns.way += low.value - swing.value;
                    low = swing;
                }
                Some(false) if beyond(low) => {
                    turns.inner += 1;
                    turns.way += swing.value - low.value;
                    (rising, high) = (Some(true), swing);
                }
                Some(_) => {}
            }
        }
        turns
    }
}

struct Turns {
    inner: usize,
    way: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(values: &[f64], closed: bool) -> Run {
        let mut run = Run::new();
        for &value in values {
            run.push(Swing { value, floor: 0.01 });
        }
        if closed {
            run.close();
        }
        run
    }

    #[test]
    fn small_swings_do_not_count() {
        let r = run(&[0.0, 1.0, 0.995, 1.0, -1.0, -0.995, 2.0], false);
        assert_eq!((r.extrema(), r.sign_changes()), (2, 2));
        assert!((r.total_variation() - 6.0).abs() < 1e-12);
        assert_eq!(run(&[1.0, 1.005, 1.0], false).extrema(), 0);
        assert_eq!(run(&[], true).extrema(), 0);
    }

    #[test]
    fn a_closed_run_has_as_many_ups_as_downs() {
        let r = run(&[0.0, 1.0, -1.0, 0.5, -0.5], true);
        assert_eq!((r.extrema(), r.sign_changes()), (4, 4));
        // 1 + 2 + 1.5 + 1, and 0.5 back to the start.
        assert!((r.total_variation() - 6.0).abs() < 1e-12);
        assert_eq!(run(&[1.0, 1.0, 1.0], true).extrema(), 0);
        assert_eq!(run(&[1.0, 2.0, 1.0], true).extrema(), 2);
    }
}
