//! The Levenberg-Marquardt search (`docs/math/circular-meshes.md#search`).

use super::border::Holds;
use super::normal_equations::{BlockMatrix, Pattern};
use super::residual::{derivatives, largest, residuals};
use crate::base::vector::{Point3, Vec3};
use crate::error::{Error, Result};

/// The search ends when no residual is longer: far below the 1e-9 that a patch accepts, far above rounding.
const RESIDUAL_LIMIT: f64 = 1e-12;
/// A search that gets no further is still a success below this: patches accept ten times as much.
const GOOD_ENOUGH: f64 = 1e-10;
/// The damping at the start.
const DAMPING: f64 = 1.0;
/// Growth of the damping after a rejected step.
const REJECTED: f64 = 5.0;
/// A step that moves a vertex by more than this part of the median edge is rejected.
const STEP_LIMIT: f64 = 0.5;
/// The search is given up when so many accepted steps have not brought the squared residuals down to [`STALLED_AT`]
/// of what they were.
const STALL_STEPS: usize = 20;
/// See [`STALL_STEPS`].
const STALLED_AT: f64 = 0.99;

/// One step of the search, for a progress display.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CircularMeshStep {
    /// Steps tried, from 1.
    pub step: usize,
    /// False if the step was rejected: the damping grows and the next step is shorter.
    pub accepted: bool,
    /// Largest residual of a quad now; dimensionless, 0 for corners on one circle.
    pub residual: f64,
    /// The residual at which the search ends.
    pub target: f64,
    /// Damping of the next step.
    pub damping: f64,
}

/// The problem: what does not change during the search.
pub(super) struct Problem<'a> {
    pub(super) quads: &'a [[usize; 4]],
    pub(super) pattern: Pattern,
    pub(super) metric: BlockMatrix,
    pub(super) holds: &'a Holds<'a>,
    /// Median edge of the input.
    pub(super) edge: f64,
    pub(super) max_steps: usize,
}

impl Problem<'_> {
    /// Moves the points until every quad is circular; gives the number of steps.
    ///
    /// # Errors
    /// `not-converged`.
    pub(super) fn search(
        &self,
        points: &mut Vec<Point3>,
        progress: &mut dyn FnMut(&CircularMeshStep),
    ) -> Result<usize> {
        let mut r = residuals(points, self.quads).ok_or(refused(0, f64::INFINITY))?;
        let mut damping = DAMPING;
        let mut costs = vec![cost(&r)];
        let mut linear = None;
        for step in 1..=self.max_steps {
            let residual = largest(&r);
            let stalled =
                costs.len() > STALL_STEPS && costs[costs.len() - 1] > STALLED_AT * costs[costs.len() - 1 - STALL_STEPS];
            if residual < RESIDUAL_LIMIT {
                return Ok(step - 1);
            }
            if stalled {
                return if residual < GOOD_ENOUGH { Ok(step - 1) } else { Err(refused(step - 1, residual)) };
            }
            let (matrix, downhill) =
                linear.get_or_insert_with(|| self.linearised(points, &r).unwrap_or((self.pattern.zero(), Vec::new())));
            let mut projectors = self.holds.projectors(points);
            let mut moves = self.pattern.solve((matrix, &self.metric, damping), &projectors, downhill);
            while moves.as_ref().is_some_and(|moves| self.holds.stop_at_ends(points, moves, &mut projectors)) {
                moves = self.pattern.solve((matrix, &self.metric, damping), &projectors, downhill);
            }
            let trial = moves.and_then(|moves| self.trial(points, &moves));
            let accepted = match trial {
                Some((moved, residuals)) if cost(&residuals) <= cost(&r) => {
                    let fell = cost(&residuals) / cost(&r);
                    damping /= if fell < 0.5 {
                        10.0
                    } else if fell < 0.9 {
                        3.0
                    } else {
                        1.5
                    };
                    (*points, r) = (moved, residuals);
                    costs.push(cost(&r));
                    linear = None;
                    true
                }
                _ => {
                    damping *= REJECTED;
                    false
                }
            };
            progress(&CircularMeshStep { step, accepted, residual: largest(&r), target: RESIDUAL_LIMIT, damping });
        }
        let residual = largest(&r);
        if residual < GOOD_ENOUGH { Ok(self.max_steps) } else { Err(refused(self.max_steps, residual)) }
    }

    /// `J^T J` and `-J^T r`.
    fn linearised(&self, points: &[Point3], r: &[Vec3]) -> Option<(BlockMatrix, Vec<Vec3>)> {
        let mut matrix = self.pattern.zero();
        let mut downhill = vec![Vec3::ZERO; points.len()];
        for (quad, r) in self.quads.iter().zip(r) {
            let by_corner = derivatives(points, *quad)?;
            for (i, &u) in quad.iter().enumerate() {
                let transposed = by_corner[i].transposed();
                downhill[u] -= transposed.apply(*r);
                for (j, &v) in quad.iter().enumerate().take(i + 1) {
                    self.pattern.add(&mut matrix, u, v, transposed * by_corner[j]);
                }
            }
        }
        Some((matrix, downhill))
    }

    /// The points after a step and their residuals, if the step is not too long.
    fn trial(&self, points: &[Point3], moves: &[Vec3]) -> Option<(Vec<Point3>, Vec<Vec3>)> {
        if !moves.iter().all(|m| m.length() <= STEP_LIMIT * self.edge) {
            return None;
        }
        let mut moved: Vec<Point3> = points.iter().zip(moves).map(|(p, m)| *p + *m).collect();
        self.holds.settle(&mut moved);
        let r = residuals(&moved, self.quads)?;
        Some((moved, r))
    }
}

/// The error of a search that ends with this residual.
pub(super) fn refused(step: usize, residual: f64) -> Error {
    Error::NotConverged { step, residual, limit: RESIDUAL_LIMIT }
}

fn cost(r: &[Vec3]) -> f64 {
    r.iter().map(|r| r.length_squared()).sum()
}
