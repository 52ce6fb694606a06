//! Random patches of Dupin cyclides: concircular quads in every order of size and place, with random frames.

use crate::generators::{direction, point};
use cyclide::{Point3, Vec3, surface::CyclidePatch};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// What a patch is made of.
#[derive(Debug, Clone, Copy)]
pub struct PatchData {
    /// Corners in binary order.
    pub corners: [Point3; 4],
    /// Directions at the first corner.
    pub frame: [Vec3; 2],
}

/// A patch with its data and what its rounding depends on.
#[derive(Debug, Clone, Copy)]
pub struct PatchCase {
    /// The patch.
    pub patch: CyclidePatch,
    /// What it was made of.
    pub data: PatchData,
    /// Size over the shortest distance of two corners.
    pub aspect: f64,
    /// Largest `max|w|²/|D|²` on a 9×9 grid: how much the denominator magnifies rounding, and the patch its corners.
    pub reach: f64,
}

impl PatchCase {
    /// The patch of the data, if it is one.
    #[must_use]
    pub fn new(data: PatchData) -> Option<Self> {
        let patch = CyclidePatch::from_corners_and_frame(data.corners, data.frame[0], data.frame[1]).ok()?;
        let c = patch.corners();
        let sides = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)].map(|(i, j)| c[i].distance(c[j]));
        let shortest = sides.into_iter().filter(|d| *d > 0.0).fold(f64::INFINITY, f64::min);
        let largest = patch.weights().iter().map(|w| w.norm_squared()).fold(0.0, f64::max);
        let places = (0..81).map(|i| (f64::from(i % 9) / 8.0, f64::from(i / 9) / 8.0));
        let least = places.map(|(s, t)| patch.denominator(s, t).norm_squared()).fold(f64::INFINITY, f64::min);
        Some(Self { patch, data, aspect: patch.size() / shortest, reach: largest / least })
    }

    /// Rounding of a point of the patch, a length, in `units` of the last place of the largest number in play: corners
    /// are rounded by their coordinates, directions from one to the next are then wrong by that over their
    /// distance, and the quotient magnifies it.
    #[must_use]
    pub fn rounding(&self, units: f64) -> f64 {
        let far = self.data.corners.iter().map(|a| a.to_vec().max_abs()).fold(self.patch.size(), f64::max);
        units * f64::EPSILON * far * self.aspect * self.reach
    }
}

/// Four points on a circle in the order a0, a1, a3, a2 with the given gaps (parts of `share` of the circle).
fn quad(plane: [Vec3; 2], gaps: [f64; 4], share: f64, start: f64) -> [Vec3; 4] {
    let unit = share * TAU / gaps.iter().sum::<f64>();
    // A small share of a large circle: the radius keeps the quad of unit size.
    let radius = 1.0 / share.min(1.0);
    let at = |angle: f64| {
        // Relative to the start, without cancellation: chords of an angle.
        let (sin, cos) = (0.5 * angle).sin_cos();
        let (ss, cs) = start.sin_cos();
        let chord = 2.0 * radius * sin;
        let (along, across) = (-(ss * cos + cs * sin), cs * cos - ss * sin);
        (plane[0] * along + plane[1] * across) * chord
    };
    let [a1, a3, a2] = [gaps[0], gaps[0] + gaps[1], gaps[0] + gaps[1] + gaps[2]].map(|g| at(g * unit));
    [Vec3::ZERO, a1, a2, a3]
}

fn orthonormal_pair() -> impl Strategy<Value = [Vec3; 2]> {
    (direction(), direction()).prop_filter_map("parallel", |(a, b)| {
        let across = b - a * b.dot(a);
        (across.length() > 0.1).then(|| across.unit().map(|u| [a, u])).flatten()
    })
}

fn data(
    gaps: impl Strategy<Value = [f64; 4]>,
    share: impl Strategy<Value = f64>,
    scale: impl Strategy<Value = f64>,
    offset: impl Strategy<Value = f64>,
) -> impl Strategy<Value = PatchData> {
    let shape = (orthonormal_pair(), gaps, share, 0.0..TAU, orthonormal_pair());
    (shape, scale, offset, point()).prop_map(|((plane, gaps, share, start, frame), scale, offset, place)| {
        let corners = quad(plane, gaps, share, start);
        let corners = corners.map(|a| Point3::ORIGIN + (a + place.to_vec() * offset) * scale);
        PatchData { corners, frame }
    })
}

/// Quads on whole circles or small parts of one, with gaps of every order down to 1e-3, sizes 1e-6, 1 and 1e6, up to
/// 1e4 sizes away from the origin; any frame, so that a third of the patches are singular.
pub fn patch() -> impl Strategy<Value = PatchCase> {
    let gap = || prop_oneof![3 => 0.1..1.0, 1 => (-3.0..-1.0).prop_map(|e: f64| 10f64.powf(e))];
    let gaps = [gap(), gap(), gap(), gap()];
    let share = prop_oneof![3 => Just(1.0), 1 => 0.1..1.0, 1 => (-4.0..-1.0).prop_map(|e: f64| 10f64.powf(e))];
    let scale = prop_oneof![3 => Just(1.0), 1 => Just(1e-6), 1 => Just(1e6)];
    let offset = prop_oneof![2 => Just(0.0), 1 => Just(1.0), 1 => Just(1e4)];
    data(gaps, share, scale, offset)
        .prop_filter_map("refused", PatchCase::new)
        .prop_filter("passes close to infinity", |case| case.reach < 1e6)
}

/// Patches well away from every degeneration, of sizes 1e-6, 1 and 1e6 near the origin: for laws whose own bounds grow
/// fast with the condition.
pub fn tame_patch() -> impl Strategy<Value = PatchCase> {
    let gaps = [0.3..1.0, 0.3..1.0, 0.3..1.0, 0.3..1.0];
    let scale = prop_oneof![3 => Just(1.0), 1 => Just(1e-6), 1 => Just(1e6)];
    data(gaps, 0.2..1.0, scale, 0.0..1.0)
        .prop_filter_map("refused", PatchCase::new)
        .prop_filter("passes close to infinity", |case| case.reach < 30.0)
}

/// Patches with a side of one point: `a3 = a1` or `a3 = a2`.
pub fn triangular_patch() -> impl Strategy<Value = PatchCase> {
    let gaps = [0.3..1.0, 0.3..1.0, 0.3..1.0, 0.3..1.0];
    (data(gaps, Just(1.0), Just(1.0), 0.0..1.0), any::<bool>())
        .prop_filter_map("refused", |(mut data, first)| {
            data.corners[3] = data.corners[if first { 1 } else { 2 }];
            PatchCase::new(data)
        })
        .prop_filter("passes close to infinity", |case| case.reach < 30.0)
}
