//! Sections of seams in runs, by which those that may hold a point are found without looking at each (`docs/math/torus-splines.md#seams`).
//!
//! How far a point is beyond a section, along the curve, across or in height, changes from one section to the next by what the middle moves and the frame
//! turns, at most. So those that are too near for it to come to nothing are passed over: a high and thin seam has many sections within its own height.

use super::meeting::{Inside, Place};
use crate::base::vector::{Point3, Vec3};
use std::collections::HashMap;
use std::ops::Range;

/// Sections one behind the other on one curve, about as far as a section reaches.
pub(super) struct Run {
    pub(super) sections: Range<usize>,
    /// How far from its middle a section reaches.
    reach: f64,
    /// The middle of the one in their midst, and how far the others are from there.
    middle: Point3,
    spread: f64,
    /// From a section to the next its middle moves by this at most.
    step: f64,
    /// Along each direction of the frame the same, and what the direction turns.
    changes: [[f64; 2]; 3],
}

/// All runs, looked up by the cube that their middle is in.
pub(super) struct Runs {
    runs: Vec<Run>,
    reach: f64,
    /// Side of a cube.
    side: f64,
    cubes: HashMap<[i64; 3], Vec<usize>>,
}

fn frame(place: &Place) -> [Vec3; 3] {
    [place.moving.tangent, place.moving.across, place.moving.normal]
}

impl Run {
    fn new(places: &[Place], sections: Range<usize>, reach: f64) -> Self {
        let middle = places[sections.start.midpoint(sections.end - 1)].moving.point;
        let spread =
            places[sections.clone()].iter().map(|place| place.moving.point.distance(middle)).fold(0.0, f64::max);
        let mut run = Self { sections: sections.clone(), reach, middle, spread, step: 0.0, changes: [[0.0; 2]; 3] };
        for pair in places[sections].windows(2) {
            let motion = pair[1].moving.point - pair[0].moving.point;
            run.step = run.step.max(motion.length());
            for (change, (from, to)) in run.changes.iter_mut().zip(frame(&pair[0]).into_iter().zip(frame(&pair[1]))) {
                *change = [change[0].max(motion.dot(to).abs()), change[1].max((to - from).length())];
            }
        }
        run
    }

    /// False where none of the sections can hold a point.
    pub(super) fn may_hold(&self, point: Point3) -> bool {
        self.middle.distance(point) <= self.reach + self.spread
    }

    /// The next section, from one on, beyond which a point is not.
    pub(super) fn next_holding(
        &self,
        places: &[Place],
        from: usize,
        point: Point3,
        inside: &Inside,
        spacing: f64,
    ) -> Option<usize> {
        let mut k = from;
        while k < self.sections.end {
            let moving = &places[k].moving;
            let v = point - moving.point;
            let away = v.length() - self.reach;
            let steps = if away > 0.0 {
                away / self.step
            } else {
                // Until the middle has moved by the reach the point is within twice of it.
                let beyond = inside.beyond(v, moving, spacing);
                if beyond.iter().all(|x| *x <= 0.0) {
                    return Some(k);
                }
                let needed = beyond.into_iter().zip(self.changes);
                let needed = needed.map(|(x, [motion, turn])| x / (motion + 2.0 * self.reach * turn));
                needed.fold(0.0, f64::max).min(self.reach / self.step)
            };
            // Rounding aside. Of a single section no step is known, and there is none to take.
            k = k.saturating_add((steps * (1.0 - 1e-9)).ceil().max(1.0) as usize);
        }
        None
    }
}

impl Runs {
    /// By how far from its middle a section reaches, and how far apart they are.
    pub(super) fn new(places: &[Place], reach: f64, spacing: f64) -> Self {
        let most = (reach / spacing).ceil().max(1.0) as usize;
        let mut runs = Vec::new();
        for spline in places.chunk_by(|a, b| a.spline == b.spline) {
            let first = runs.last().map_or(0, |run: &Run| run.sections.end);
            let starts = (0..spline.len()).step_by(most);
            runs.extend(starts.map(|k| Run::new(places, first + k..first + (k + most).min(spline.len()), reach)));
        }
        let spread = runs.iter().fold(0.0, |most: f64, run| most.max(run.spread));
        let mut all = Self { reach, side: 2.0 * reach + spread, runs, cubes: HashMap::new() };
        for (k, run) in all.runs.iter().enumerate() {
            all.cubes.entry(cube(run.middle, all.side)).or_default().push(k);
        }
        all
    }

    /// Gathers the runs of which a section may hold a point of the section about a middle.
    pub(super) fn gather<'a>(&'a self, middle: Point3, found: &mut Vec<&'a Run>) {
        found.clear();
        let [x, y, z] = cube(middle, self.side);
        let near = (0..27).map(|k: i64| [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1]);
        let runs = near.filter_map(|at| self.cubes.get(&at)).flatten().map(|&k| &self.runs[k]);
        found.extend(runs.filter(|run| run.middle.distance(middle) <= 2.0 * self.reach + run.spread));
    }
}

fn cube(p: Point3, side: f64) -> [i64; 3] {
    p.to_array().map(|v| (v / side).floor() as i64)
}
