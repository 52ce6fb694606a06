//! The corners of the holes of a crossing: where the contacts run at 45 degrees to their pipes.

use super::balls::Balls;
use crate::error::Result;
use std::f64::consts::TAU;

/// Angles at which a corner is looked for first, and steps in which it is then narrowed down.
const PLACES: u32 = 128;
const STEPS: u32 = 60;
/// Corners of both holes, and angles of the law, nearer to each other than this are one node.
const NEAR: f64 = 0.1;

/// Where a loop of balls is parted: at the corners of both holes, and at the values of the law.
pub(super) struct Corners {
    /// Angles in rising order, the last once round from the first.
    pub(super) bounds: Vec<f64>,
    /// For both pipes the corners towards its end, at low and at high angles, and towards its start, at high and at low angles: the number of the bound.
    pub(super) of_pipes: [[usize; 4]; 2],
}

/// What parts a loop.
#[derive(Debug, Clone, Copy)]
enum Mark {
    Corner { pipe: usize, which: usize },
    Value,
}

/// Marks that are one bound: at most one corner of each pipe, and one value.
#[derive(Debug, Clone, Copy)]
struct Bound {
    from: f64,
    corners: [Option<(usize, f64)>; 2],
    value: Option<f64>,
}

impl Bound {
    fn takes(&self, mark: Mark, at: f64) -> bool {
        let free = match mark {
            Mark::Corner { pipe, .. } => self.corners[pipe].is_none(),
            Mark::Value => self.value.is_none(),
        };
        free && at - self.from < NEAR
    }

    fn add(&mut self, mark: Mark, at: f64) {
        match mark {
            Mark::Corner { pipe, which } => self.corners[pipe] = Some((which, at)),
            Mark::Value => self.value = Some(at),
        }
    }

    /// The law is met at its values; a corner may be a little off.
    fn at(&self) -> f64 {
        let corners: Vec<f64> = self.corners.iter().flatten().map(|(_, at)| *at).collect();
        self.value.unwrap_or_else(|| corners.iter().sum::<f64>() / corners.len() as f64)
    }
}

impl Corners {
    /// # Errors
    /// As those of a place of the loop.
    pub(super) fn new(balls: &Balls<'_>) -> Result<Self> {
        let mut marks = Vec::new();
        for (pipe, which) in (0..2).flat_map(|pipe| (0..4).map(move |which| (pipe, which))) {
            marks.push((corner(balls, pipe, which)?, Mark::Corner { pipe, which }));
        }
        let values: Vec<f64> = balls.law.angles().collect();
        if values.len() > 1 {
            marks.extend(values.into_iter().map(|at| (at, Mark::Value)));
        }
        marks.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Marks are put together from the widest gap on.
        let count = marks.len();
        let gap = |k: usize| if k == 0 { marks[0].0 + TAU - marks[count - 1].0 } else { marks[k].0 - marks[k - 1].0 };
        let widest = (0..count).max_by(|&a, &b| gap(a).total_cmp(&gap(b))).unwrap_or(0);
        marks.rotate_left(widest);
        let turned =
            marks.iter().enumerate().map(|(k, &(at, mark))| (if k + widest >= count { at + TAU } else { at }, mark));
        let mut bounds: Vec<Bound> = Vec::new();
        for (at, mark) in turned {
            if !bounds.last().is_some_and(|bound| bound.takes(mark, at)) {
                bounds.push(Bound { from: at, corners: [None; 2], value: None });
            }
            if let Some(bound) = bounds.last_mut() {
                bound.add(mark, at);
            }
        }
        let mut corners = Self { bounds: Vec::new(), of_pipes: [[0; 4]; 2] };
        for (k, bound) in bounds.iter().enumerate() {
            for (pipe, corner) in bound.corners.iter().enumerate() {
                if let Some((which, _)) = corner {
                    corners.of_pipes[pipe][*which] = k;
                }
            }
            corners.bounds.push(bound.at());
        }
        corners.bounds.push(corners.bounds[0] + TAU);
        Ok(corners)
    }
}

/// The angle of the ball whose contact is farthest towards an end of a pipe and, at 45 degrees to that, towards low or high angles.
fn corner(balls: &Balls<'_>, pipe: usize, which: usize) -> Result<f64> {
    let along = if which < 2 { 1.0 } else { -1.0 };
    let round = balls.mantles[pipe].radius * if which == 0 || which == 3 { -1.0 } else { 1.0 };
    let lead = |[a, f]: [f64; 2]| along * a + round * f;
    let step = TAU / f64::from(PLACES);
    let mut best = (0.0, f64::NEG_INFINITY);
    for k in 0..PLACES {
        let angle = step * f64::from(k);
        let value = lead(balls.contacts(angle)?.at[pipe]);
        if value > best.1 {
            best = (angle, value);
        }
    }
    let (mut low, mut high) = (best.0 - step, best.0 + step);
    for _ in 0..STEPS {
        let middle = 0.5 * (low + high);
        if lead(balls.contacts(middle)?.rates[pipe]) > 0.0 { low = middle } else { high = middle }
    }
    Ok((0.5 * (low + high)).rem_euclid(TAU) % TAU)
}
