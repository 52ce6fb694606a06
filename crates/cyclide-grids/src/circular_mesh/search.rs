//! The Levenberg-Marquardt search (`docs/math/circular-meshes.md#search`).

use super::block::Block;
use super::border::Holds;
use super::closing::Closing;
use super::dense_rows::{SparseRow, solve};
use super::normal_equations::{BlockMatrix, Pattern, Workspace};
use super::residual::{derivatives, largest, residuals};
use cyclide::{Error, Result, error::GridError};
use cyclide::{Point3, Vec3};

/// The search ends when no residual is longer: far below the 1e-9 that a patch accepts, far above rounding.
const RESIDUAL_LIMIT: f64 = 1e-12;
/// A search that gets no further is still a success below this: patches accept ten times as much, and closed
/// directions do.
const GOOD_ENOUGH: f64 = 1e-10;
/// The damping at the start.
const DAMPING: f64 = 1.0;
/// The damping at the start on grids with more quads than [`LARGE`] in a direction: the farther a grid reaches, the longer are
/// the waves that bend it for next to nothing, and both of 200 by 200 quads that were tried refused two steps first.
const DAMPING_LARGE: f64 = 25.0;
/// See [`DAMPING_LARGE`].
const LARGE: usize = 150;
/// Growth of the damping after a rejected step.
const REJECTED: f64 = 5.0;
/// A step that moves a vertex by more than this part of the median edge is rejected.
const STEP_LIMIT: f64 = 0.5;
/// On grids with more quads than [`LARGE`] in a direction one of up to so many times as much is shortened instead: half as many steps,
/// and a step is dear there.
const SHORTENED: f64 = 5.0;
/// The search is given up when so many accepted steps have not brought the squared residuals down to [`STALLED_AT`]
/// of what they were.
const STALL_STEPS: usize = 20;
/// See [`STALL_STEPS`].
const STALLED_AT: f64 = 0.99;
/// Steps of a closed grid after the limit is reached: residuals of 1e-12 add up round it.
const POLISH: usize = 3;
/// A closed grid that closes up to [`GOOD_ENOUGH`] is done after so many more steps: where both counts are even the
/// last digits may take hundreds.
const TAIL: usize = 30;

/// One step of the search, for a progress display.
///
/// ```
/// use cyclide::{Point3, surface::QuadGrid};
/// use cyclide_grids::{CircularMeshOptions, make_circular_watched};
/// let saddle = (0..25).map(|k| (0.1 * f64::from(k % 5), 0.1 * f64::from(k / 5)));
/// let saddle = saddle.map(|(u, v)| Point3::new(u, v + 0.01 * u * u, u * u - v * v)).collect();
/// let mut residuals = Vec::new();
/// let grid = QuadGrid::new(saddle, [5, 5], [false; 2])?;
/// make_circular_watched(&grid, &CircularMeshOptions::default(), &mut |step| residuals.push(step.residual))?;
/// assert!(residuals.last() < residuals.first());
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CircularMeshStep {
    /// Steps tried, from 1.
    pub step: usize,
    /// False if the step was rejected: the damping grows and the next step is shorter.
    pub accepted: bool,
    /// Largest residual of a quad now, or of the equations of a closed direction; dimensionless, 0 for corners on one
    /// circle.
    pub residual: f64,
    /// The residual at which the search ends.
    pub target: f64,
    /// Damping of the next step.
    pub damping: f64,
}

/// The problem: what does not change during the search.
pub(super) struct Problem<'a> {
    pub(super) quads: &'a [[usize; 4]],
    pub(super) closing: &'a Closing,
    pub(super) pattern: Pattern,
    pub(super) metric: BlockMatrix,
    pub(super) holds: &'a Holds<'a>,
    /// Median edge of the input.
    pub(super) edge: f64,
    /// More quads than [`LARGE`] in a direction.
    pub(super) is_large: bool,
    pub(super) max_steps: usize,
}

/// What must vanish.
pub(super) struct Residuals {
    quads: Vec<Vec3>,
    /// Of closed directions, weighted.
    closing: Vec<f64>,
}

impl Residuals {
    /// `None` if an edge has no direction.
    pub(super) fn of(points: &[Point3], quads: &[[usize; 4]], closing: &Closing) -> Option<Self> {
        Some(Self { quads: residuals(points, quads)?, closing: closing.values(points)? })
    }

    pub(super) fn largest(&self) -> f64 {
        self.closing.iter().fold(largest(&self.quads), |most, c| most.max(c.abs()))
    }

    /// The sum of their squares.
    fn cost(&self) -> f64 {
        let quads: f64 = self.quads.iter().map(|r| r.length_squared()).sum();
        quads + self.closing.iter().map(|c| c * c).sum::<f64>()
    }
}

/// The problem about a place.
struct Linearized {
    /// `J^T J` and `-J^T r` of the quads.
    matrix: BlockMatrix,
    downhill: Vec<Vec3>,
    /// Gradients of the equations of closed directions.
    rows: Vec<SparseRow>,
}

impl Problem<'_> {
    /// Moves the points until every quad is circular and the closed directions close; gives the number of steps.
    ///
    /// # Errors
    /// `not-converged`, `net-does-not-close`.
    pub(super) fn search(
        &self,
        points: &mut Vec<Point3>,
        progress: &mut dyn FnMut(&CircularMeshStep),
    ) -> Result<usize> {
        let mut r = self.residuals(points).ok_or(refused(0, f64::INFINITY))?;
        let mut workspace = None;
        let mut damping = if self.is_large { DAMPING_LARGE } else { DAMPING };
        let mut costs = vec![r.cost()];
        let mut linear = None;
        let mut polish = if self.closing.is_empty() { 0 } else { POLISH };
        let mut tail = 0;
        for step in 1..=self.max_steps {
            let residual = r.largest();
            if residual < RESIDUAL_LIMIT {
                // A grid as given is left as it is, and a step that was rejected polishes no more.
                if step == 1 || polish == 0 || linear.is_some() {
                    return Ok(step - 1);
                }
                polish -= 1;
            }
            let stalled =
                costs.len() > STALL_STEPS && costs[costs.len() - 1] > STALLED_AT * costs[costs.len() - 1 - STALL_STEPS];
            if stalled || tail > TAIL {
                return self.given_up(points, &r, step - 1);
            }
            if linear.is_none() {
                linear = Some(self.linearized(points, &r).ok_or(refused(step - 1, residual))?);
            }
            if workspace.is_none() {
                workspace = Some(self.pattern.workspace().ok_or(refused(step - 1, residual))?);
            }
            let both = linear.as_ref().zip(workspace.as_mut());
            let trial = both.and_then(|(linear, workspace)| self.trial(points, (linear, &r), damping, workspace));
            let accepted = match trial {
                Some((moved, residuals)) if residuals.cost() <= r.cost() => {
                    let fell = residuals.cost() / r.cost();
                    damping /= if fell < 0.5 {
                        10.0
                    } else if fell < 0.9 {
                        3.0
                    } else {
                        1.5
                    };
                    (*points, r) = (moved, residuals);
                    costs.push(r.cost());
                    linear = None;
                    true
                }
                _ => {
                    damping *= REJECTED;
                    false
                }
            };
            if !self.closing.is_empty() {
                tail = if self.is_good_enough(points, &r) { tail + 1 } else { 0 };
            }
            progress(&CircularMeshStep { step, accepted, residual: r.largest(), target: RESIDUAL_LIMIT, damping });
        }
        self.given_up(points, &r, self.max_steps)
    }

    /// A search that gets no further is a success all the same where patches accept what it has found.
    fn given_up(&self, points: &[Point3], r: &Residuals, steps: usize) -> Result<usize> {
        if !(largest(&r.quads) < GOOD_ENOUGH) {
            return Err(refused(steps, r.largest()));
        }
        self.closing.check(points)?;
        Ok(steps)
    }

    fn residuals(&self, points: &[Point3]) -> Option<Residuals> {
        Residuals::of(points, self.quads, self.closing)
    }

    fn is_good_enough(&self, points: &[Point3], r: &Residuals) -> bool {
        largest(&r.quads) < GOOD_ENOUGH && self.closing.is_below(points, GOOD_ENOUGH)
    }

    fn linearized(&self, points: &[Point3], r: &Residuals) -> Option<Linearized> {
        let mut matrix = self.pattern.zero();
        let mut downhill = vec![Vec3::ZERO; points.len()];
        for (quad, r) in self.quads.iter().zip(&r.quads) {
            let by_corner = derivatives(points, *quad)?;
            for (i, &u) in quad.iter().enumerate() {
                let transposed = by_corner[i].transposed();
                downhill[u] -= transposed.apply(*r);
                for (j, &v) in quad.iter().enumerate().take(i + 1) {
                    self.pattern.add(&mut matrix, u, v, transposed * by_corner[j]);
                }
            }
        }
        Some(Linearized { matrix, downhill, rows: self.closing.gradients(points)? })
    }

    /// The points after a step and their residuals, if there is such a step and it is not too long.
    fn trial(
        &self,
        points: &[Point3],
        about: (&Linearized, &Residuals),
        damping: f64,
        workspace: &mut Workspace,
    ) -> Option<(Vec<Point3>, Residuals)> {
        let mut projectors = self.holds.projectors(points);
        let mut moves = self.moves(about, damping, &projectors, workspace)?;
        while self.holds.stop_at_ends(points, &moves, &mut projectors) {
            moves = self.moves(about, damping, &projectors, workspace)?;
        }
        let longest_tried = if self.is_large { SHORTENED } else { 1.0 } * STEP_LIMIT * self.edge;
        if !moves.iter().all(|m| m.length() <= longest_tried) {
            return None;
        }
        let longest = moves.iter().map(|m| m.length()).fold(0.0, f64::max);
        if longest > STEP_LIMIT * self.edge {
            // Along the valley of grids that still leave much free the way is right, and only too long.
            let part = STEP_LIMIT * self.edge / longest;
            moves.iter_mut().for_each(|m| *m *= part);
        }
        let mut moved: Vec<Point3> = points.iter().zip(moves).map(|(p, m)| *p + m).collect();
        self.holds.settle(&mut moved);
        let r = self.residuals(&moved)?;
        Some((moved, r))
    }

    fn moves(
        &self,
        (linear, r): (&Linearized, &Residuals),
        damping: f64,
        projectors: &[Block],
        workspace: &mut Workspace,
    ) -> Option<Vec<Vec3>> {
        let factored = self.pattern.factored(workspace, (&linear.matrix, &self.metric, damping), projectors)?;
        Some(solve(&factored, projectors, &linear.rows, &r.closing, &linear.downhill))
    }
}

/// Whether a grid of so many quads is one of those whose steps are dear.
pub(super) fn is_large(quads: [usize; 2]) -> bool {
    quads[0].max(quads[1]) > LARGE
}

/// The error of a search that ends with this residual.
pub(super) fn refused(step: usize, residual: f64) -> Error {
    Error::Grid(GridError::NotConverged { step, residual, limit: RESIDUAL_LIMIT })
}
