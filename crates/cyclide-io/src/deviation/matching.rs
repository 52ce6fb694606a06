//! Matching the samples of one curve with places on another that advance.
//!
//! Each sample may be matched with its foot on any window nearby. Among all choices whose places advance from the
//! start to the end (falling back by no more than the distance itself, which is what a rounded corner costs), the
//! one with the smallest largest distance is found by dynamic programming: a discrete Fréchet distance. Going greedily
//! from foot to foot would lose the way at cusps and where a curve runs back over itself.

use super::track::{Foot, Track, Window};
use cyclide::Point3;

/// Inner samples of a window, as parts of it.
const SAMPLES: [f64; 4] = [0.0, 0.25, 0.5, 0.75];
/// Places are looked for this part of the length around the expected one, plus twice the difference of the lengths,
/// and no farther than the second number.
const BAND: [f64; 2] = [0.01, 0.25];
/// What measuring lengths may cost, relative.
const LENGTH_ROUNDING: f64 = 1e-9;

/// A sample of a curve.
#[derive(Clone, Copy)]
struct Sample {
    /// Window and part of it.
    window: usize,
    part: f64,
    point: Point3,
    /// The windows of the other curve that are looked at, and where it is expected among them.
    band: (usize, usize),
    expected: usize,
}

/// A place where a sample may be matched: the smallest largest distance on the way there, and where it was.
#[derive(Clone, Copy)]
struct State {
    position: f64,
    largest: f64,
    worst: (usize, usize),
}

/// Largest distance from the points of `a` to the places on `b` that they are matched with.
pub(super) fn one_way(a: &Track<'_>, b: &Track<'_>) -> f64 {
    let samples = samples(a, b);
    let nearest = samples.iter().map(|s| nearest(b, s)).fold(0.0, f64::max);
    let scale = samples.iter().map(|s| s.point.to_vec().max_abs()).fold(0.0, f64::max);
    let mut reach = 2.0 * nearest + 16.0 * f64::EPSILON * scale;
    loop {
        if let Some(end) = best_match(b, &samples, reach) {
            let (sample, window) = end.worst;
            return end.largest.max(refined(a, b, &samples[sample], window));
        }
        reach *= 4.0;
        // Everything is within reach: the curves have no matching at all.
        if !(reach < 1e3 * scale) {
            return reach;
        }
    }
}

fn samples(a: &Track<'_>, b: &Track<'_>) -> Vec<Sample> {
    let drift = (BAND[0] * b.length + 2.0 * (a.length - b.length).abs()).min(BAND[1] * b.length);
    let stretch = if a.length > 0.0 { b.length / a.length } else { 0.0 };
    let at = |window: usize, part: f64, point: Point3| {
        let w = &a.windows[window];
        let position = (w.position + part * w.length) * stretch;
        // The speed in a window varies: its samples may be anywhere in it.
        let half = drift + w.length * stretch;
        let index = |position: f64| b.windows.partition_point(|w| w.position + w.length < position);
        let last = b.windows.len() - 1;
        let band = (index(position - half).min(last), index(position + half).min(last));
        Sample { window, part, point, band, expected: index(position).min(last) }
    };
    let mut samples: Vec<Sample> = Vec::with_capacity(SAMPLES.len() * a.windows.len() + 1);
    for (i, w) in a.windows.iter().enumerate() {
        for part in SAMPLES {
            samples.push(at(i, part, if part > 0.0 { a.point(w, part) } else { w.start.point }));
        }
    }
    let last = a.windows.len() - 1;
    samples.push(at(last, 1.0, a.windows[last].end.point));
    samples
}

/// True if the window may have a point within `reach` of `p`.
fn in_reach(w: &Window, p: Point3, reach: f64) -> bool {
    let far = reach + 1.01 * w.length;
    (p - w.start.point).length_squared() <= far * far
}

/// Distance to the nearest point in the sample's band.
fn nearest(b: &Track<'_>, sample: &Sample) -> f64 {
    let mut best = b.foot(&b.windows[sample.expected], sample.point).distance;
    for w in &b.windows[sample.band.0..=sample.band.1] {
        if in_reach(w, sample.point, best) {
            best = best.min(b.foot(w, sample.point).distance);
        }
    }
    best
}

/// The best matching with all distances within `reach`, if there is one.
fn best_match(b: &Track<'_>, samples: &[Sample], reach: f64) -> Option<State> {
    let slack = reach + LENGTH_ROUNDING * b.length;
    // Before the first sample there is only the start.
    let mut before = vec![State { position: 0.0, largest: 0.0, worst: (0, 0) }];
    let mut now: Vec<State> = Vec::new();
    for (i, sample) in samples.iter().enumerate() {
        now.clear();
        let mut reachable = 0;
        let mut best: Option<State> = None;
        for window in sample.band.0..=sample.band.1 {
            let w = &b.windows[window];
            if !in_reach(w, sample.point, reach) {
                continue;
            }
            let Foot { position, distance } = b.foot(w, sample.point);
            if distance > reach || (i == 0 && position > slack) {
                continue;
            }
            // States are in order of their positions: those that are not ahead are a growing front part.
            while let Some(state) = before.get(reachable).filter(|s| s.position <= position + slack) {
                best = best.filter(|b| b.largest <= state.largest).or(Some(*state));
                reachable += 1;
            }
            if let Some(best) = best {
                let (largest, worst) =
                    if distance > best.largest { (distance, (i, window)) } else { (best.largest, best.worst) };
                now.push(State { position, largest, worst });
            }
        }
        std::mem::swap(&mut before, &mut now);
        if before.is_empty() {
            return None;
        }
    }
    let at_end = before.into_iter().filter(|s| s.position >= b.length - slack);
    at_end.min_by(|a, b| a.largest.total_cmp(&b.largest))
}

/// The distance near the sample that is worst, at its largest between the neighbouring samples (golden section).
fn refined(a: &Track<'_>, b: &Track<'_>, sample: &Sample, window: usize) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_895;
    let step = SAMPLES[1];
    if sample.part < step || sample.part > 1.0 - step {
        return 0.0;
    }
    // The places of the neighbouring samples are no farther along than the window of the samples is long.
    let (matched, length) = (&b.windows[window], a.windows[sample.window].length);
    let first = b.windows.partition_point(|w| w.position + w.length < matched.position - length);
    let last = b.windows.partition_point(|w| w.position <= matched.position + matched.length + length);
    let around = &b.windows[first..last];
    let value = |part: f64| {
        let p = a.point(&a.windows[sample.window], part);
        let best = b.foot(matched, p).distance;
        around.iter().fold(best, |best, w| if in_reach(w, p, best) { best.min(b.foot(w, p).distance) } else { best })
    };
    let (mut low, mut high) = (sample.part - step, sample.part + step);
    let (mut c, mut d) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut at_c, mut at_d) = (value(c), value(d));
    for _ in 0..24 {
        if at_c > at_d {
            (high, d, at_d) = (d, c, at_c);
            c = high - GOLDEN * (high - low);
            at_c = value(c);
        } else {
            (low, c, at_c) = (c, d, at_d);
            d = low + GOLDEN * (high - low);
            at_d = value(d);
        }
    }
    at_c.max(at_d)
}
