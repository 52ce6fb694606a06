//! What is done where the fairest spline does not exist or swings out: smaller blends, down to those of order 2
//! (`docs/math/fair-splines.md#relaxation`). Continuous curvature holds for every choice of blends.

use super::newton::Search;
use super::run::Run;
use crate::base::vector::Vec3;
use crate::curve::Chord;

/// Most steps of the search.
const STEPS: usize = 30;
/// Chord angles below 150 degrees are accepted: beyond, curves many times as long as their polygon were seen.
const LEAST_COSINE: f64 = -0.866_025_403_784_438_6;
/// The factors of the last two tries.
const HALVINGS: [f64; 3] = [1.0, 0.5, 0.25];

/// Tangents and blends of a run.
pub(super) struct Solution {
    /// Unit tangents at the nodes.
    pub(super) tangents: Vec<Vec3>,
    /// Blends of the segments.
    pub(super) blends: Vec<f64>,
    /// True if the blends are smaller than asked for.
    pub(super) relaxed: bool,
}

/// The solution with the blends asked for; `None` if there is none, or one that swings out.
pub(super) fn fair(run: &Run, blends: &[f64]) -> Option<Solution> {
    if blends.iter().all(|e| *e == 0.0) {
        return Some(Solution { tangents: local_tangents(run), blends: blends.to_vec(), relaxed: false });
    }
    if run.is_given() {
        // One chord between two given tangents: nothing to choose.
        let tangents = run.start();
        return Some(Solution { tangents, blends: blends.to_vec(), relaxed: false });
    }
    accepted(run, blends.to_vec(), false)
}

/// The solution with smaller blends.
pub(super) fn relaxed(run: &Run, blends: &[f64], tension: f64) -> Solution {
    let mut bounds = turn_factors(run.chords, run.closed);
    bounds.iter_mut().for_each(|r| *r *= 1.0 - tension);
    if run.plane.is_none() {
        let start = run.start();
        for (i, bound) in bounds.iter_mut().enumerate() {
            *bound =
                bound.min(space_bound(&run.chords[i], start[i], start[if i + 1 == start.len() { 0 } else { i + 1 }]));
        }
    }
    let smaller: Vec<f64> = blends.iter().zip(&bounds).map(|(e, bound)| e.min(*bound)).collect();
    for factor in HALVINGS {
        let tried: Vec<f64> = smaller.iter().map(|e| factor * e).collect();
        // The blends asked for have been tried.
        let known = tried.iter().zip(blends).all(|(a, b)| a.total_cmp(b).is_eq());
        if let (false, Some(solution)) = (known, accepted(run, tried, true)) {
            return solution;
        }
    }
    Solution { tangents: local_tangents(run), blends: vec![0.0; blends.len()], relaxed: true }
}

fn accepted(run: &Run, blends: Vec<f64>, relaxed: bool) -> Option<Solution> {
    let found = run.solve(&blends, None, Search { steps: STEPS, damped: true })?;
    (found.least_cosine > LEAST_COSINE).then_some(Solution { tangents: found.units, blends, relaxed })
}

/// The tangents of blends 0: those of order 2, and the chord at free ends.
fn local_tangents(run: &Run) -> Vec<Vec3> {
    let zeros = vec![0.0; run.chords.len()];
    // Its equations are solved at the start but for free ends, and there by Newton's method on one angle.
    run.solve(&zeros, None, Search { steps: STEPS, damped: true }).map_or_else(|| run.start(), |found| found.units)
}

/// The factor of each segment by the turns at its nodes: 1 up to turns of 120 degrees, 0 from 161.8 degrees on.
pub(super) fn turn_factors(chords: &[Chord], closed: bool) -> Vec<f64> {
    let m = chords.len();
    let node = |i: usize| {
        if !closed && (i == 0 || i == m) {
            return 1.0;
        }
        let cosine = chords[if i == 0 { m - 1 } else { i - 1 }].unit.dot(chords[if i == m { 0 } else { i }].unit);
        ((20.0 * (1.0 + cosine) - 1.0) / 9.0).clamp(0.0, 1.0)
    };
    (0..m).map(|i| node(i).min(node(i + 1))).collect()
}

/// The largest blend with which the segment's block is positive definite in space, at the given tangents.
fn space_bound(chord: &Chord, from: Vec3, to: Vec3) -> f64 {
    let u = chord.unit;
    let t2 = to.reflect(u);
    let long_way = (u + from).dot(u + t2) < 0.0;
    let half = 0.5 * (from + t2).length() * if long_way { -1.0 } else { 1.0 };
    let least = u.dot(from).min(u.dot(t2));
    if least <= 0.0 || half <= 0.0 {
        return 0.0;
    }
    // Infinite where the arcs agree.
    (0.8 * least * half / (2.0 * (1.0 - half * half).max(0.0))).min(1.0)
}
