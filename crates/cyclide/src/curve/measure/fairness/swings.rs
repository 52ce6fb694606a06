//! The ups and downs of the curvature along a smooth run.

/// A place at which the curvature turns or a piece ends: its value, and below which swing nothing counts there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Swing {
    pub(super) value: f64,
    pub(super) floor: f64,
}

/// How a smooth run swings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Course {
    /// Places where the value passes from above its noise to below it, or back.
    pub(super) sign_changes: usize,
    /// Extrema inside the run; of a closed one all, an even number.
    pub(super) extrema: usize,
    /// The way up and down, small swings left out.
    pub(super) total_variation: f64,
}

/// Follows the curvature along a run: between two neighboring values that `walk` hands over it is monotone. The end of
/// a closed run is its start, and the walk begins at the largest value. The values are made anew for each walk: of long
/// curves they would be most of the memory.
pub(super) fn course(walk: impl Fn(&mut dyn FnMut(Swing)), closed: bool) -> Course {
    let mut follower = Follower::default();
    if closed {
        let first = largest(&walk);
        for is_second in [false, true] {
            let mut index = 0;
            walk(&mut |swing| {
                if if is_second { index <= first } else { index >= first } {
                    follower.push(swing);
                }
                index += 1;
            });
        }
    } else {
        walk(&mut |swing| follower.push(swing));
    }
    let Follower { sign_changes, inner, way, .. } = follower;
    // A closed run starts and ends at its largest value, which is one extremum if anything swings at all.
    Course { sign_changes, extrema: inner + usize::from(closed && inner > 0), total_variation: way }
}

/// Which value is the largest, the first of equal ones.
fn largest(walk: impl Fn(&mut dyn FnMut(Swing))) -> usize {
    let (mut best, mut index) = (None, 0);
    walk(&mut |swing| {
        if best.is_none_or(|(_, value)| swing.value > value) {
            best = Some((index, swing.value));
        }
        index += 1;
    });
    best.map_or(0, |(index, _)| index)
}

/// Turns round only after a swing back by more than the noise.
#[derive(Default)]
struct Follower {
    /// The values reached downwards and upwards since the last turn.
    reached: Option<[Swing; 2]>,
    /// `None` until a direction is known.
    rising: Option<bool>,
    inner: usize,
    way: f64,
    /// Sign of the last value that is more than noise.
    side: f64,
    sign_changes: usize,
}

impl Follower {
    fn push(&mut self, swing: Swing) {
        if swing.value.abs() > swing.floor {
            self.sign_changes += usize::from(self.side * swing.value.signum() < 0.0);
            self.side = swing.value.signum();
        }
        let [low, high] = self.reached.get_or_insert([swing; 2]);
        let beyond = |from: &Swing| (swing.value - from.value).abs() > from.floor.max(swing.floor);
        match self.rising {
            None => {
                *low = if swing.value < low.value { swing } else { *low };
                *high = if swing.value > high.value { swing } else { *high };
                if swing.value > low.value && beyond(low) {
                    (self.rising, *high) = (Some(true), swing);
                    self.way += swing.value - low.value;
                } else if swing.value < high.value && beyond(high) {
                    (self.rising, *low) = (Some(false), swing);
                    self.way += high.value - swing.value;
                }
            }
            Some(true) if swing.value >= high.value => {
                self.way += swing.value - high.value;
                *high = swing;
            }
            Some(true) if beyond(high) => {
                self.inner += 1;
                self.way += high.value - swing.value;
                (self.rising, *low) = (Some(false), swing);
            }
            Some(false) if swing.value <= low.value => {
                self.way += low.value - swing.value;
                *low = swing;
            }
            Some(false) if beyond(low) => {
                self.inner += 1;
                self.way += swing.value - low.value;
                (self.rising, *high) = (Some(true), swing);
            }
            Some(_) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(values: &[f64], closed: bool) -> Course {
        course(|push| values.iter().for_each(|&value| push(Swing { value, floor: 0.01 })), closed)
    }

    #[test]
    fn small_swings_do_not_count() {
        let r = run(&[0.0, 1.0, 0.995, 1.0, -1.0, -0.995, 2.0], false);
        assert_eq!((r.extrema, r.sign_changes), (2, 2));
        assert!((r.total_variation - 6.0).abs() < 1e-12);
        assert_eq!(run(&[1.0, 1.005, 1.0], false).extrema, 0);
        assert_eq!(run(&[], true).extrema, 0);
    }

    #[test]
    fn a_closed_run_has_as_many_ups_as_downs() {
        let r = run(&[0.0, 1.0, -1.0, 0.5, -0.5], true);
        assert_eq!((r.extrema, r.sign_changes), (4, 4));
        // 1 + 2 + 1.5 + 1, and 0.5 back to the start.
        assert!((r.total_variation - 6.0).abs() < 1e-12);
        assert_eq!(run(&[1.0, 1.0, 1.0], true).extrema, 0);
        assert_eq!(run(&[1.0, 2.0, 1.0], true).extrema, 2);
    }
}
