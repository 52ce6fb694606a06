//! The equations of closed directions, which the search solves beside those of the quads
//! (`docs/math/circular-meshes.md#closed-grids`).
//!
//! One closed line is enough: where the quads are circular all lines along it fail by the same angle. The strips need
//! an equation each.

use super::dense_rows::SparseRow;
use super::options::Border;
use crate::base::vector::Point3;
use crate::error::{Error, Result};
use crate::surface::{GridClosing, QuadGrid, RingClosing, StripClosing, closing_limit};

/// Weight of the equations of strips, against those of quads and lines: with 1 the vertices of a tower move a quarter
/// farther, with 0.01 rings take twice the steps.
const STRIP_WEIGHT: f64 = 0.1;

/// A closed line or strip of the grid.
enum Closed {
    /// Its vertices.
    Line(Vec<usize>),
    /// The corners of its quads.
    Strip(Vec<[usize; 4]>),
}

/// The closed lines and strips whose equations are solved; none of an open grid.
pub(super) struct Closing {
    equations: Vec<Closed>,
    size: [usize; 2],
    closed: [bool; 2],
}

impl Closing {
    /// The middle line and all strips of each closed direction.
    pub(super) fn new(grid: &QuadGrid) -> Self {
        let of_direction = |d: usize| {
            let middle = Closed::Line(grid.line(d, grid.size()[1 - d] / 2));
            let strips = (0..grid.quads()[1 - d]).map(move |k| Closed::Strip(grid.strip(d, k)));
            std::iter::once(middle).chain(strips)
        };
        let equations = (0..2).filter(|d| grid.closed()[*d]).flat_map(of_direction).collect();
        Self { equations, size: grid.size(), closed: grid.closed() }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.equations.is_empty()
    }

    /// What must vanish, weighted; `None` if an edge has no direction or a quad no diagonals.
    pub(super) fn values(&self, points: &[Point3]) -> Option<Vec<f64>> {
        let mut values = Vec::new();
        for closed in &self.equations {
            match closed {
                Closed::Line(line) => values.extend(ring(points, line)?.equations()),
                Closed::Strip(quads) => values.push(STRIP_WEIGHT * strip(points, quads)?.equation()),
            }
        }
        Some(values)
    }

    /// Their gradients.
    pub(super) fn gradients(&self, points: &[Point3]) -> Option<Vec<SparseRow>> {
        let mut rows = Vec::new();
        for closed in &self.equations {
            match closed {
                Closed::Line(line) => {
                    let gradients = ring(points, line)?.gradients();
                    rows.extend(gradients.into_iter().map(|row| line.iter().copied().zip(row).collect()));
                }
                Closed::Strip(quads) => {
                    let gradients = strip(points, quads)?.gradients();
                    let corners = quads.iter().zip(gradients).flat_map(|(quad, row)| quad.iter().copied().zip(row));
                    rows.push(corners.map(|(vertex, gradient)| (vertex, gradient * STRIP_WEIGHT)).collect());
                }
            }
        }
        Some(rows)
    }

    /// Whether frames and speeds come back up to a limit.
    pub(super) fn is_below(&self, points: &[Point3], limit: f64) -> bool {
        let closes = |closed: &Closed| match closed {
            Closed::Line(line) => ring(points, line).is_some_and(|ring| ring.angle() <= limit),
            Closed::Strip(quads) => strip(points, quads).is_some_and(|strip| strip.equation().abs() <= limit),
        };
        self.equations.iter().all(closes)
    }

    /// Refuses points with which a direction of the grid fails to close.
    ///
    /// # Errors
    /// `net-does-not-close`.
    pub(super) fn check(&self, points: &[Point3]) -> Result<()> {
        let grid = QuadGrid::new(points.to_vec(), self.size, self.closed)?;
        let limit = closing_limit(&grid);
        for direction in 0..2 {
            if let Some(GridClosing { angle, stretch }) = grid.closing(direction)?
                && !(angle.max(stretch) <= limit)
            {
                return Err(Error::NetDoesNotClose { direction, angle, stretch, limit });
            }
        }
        Ok(())
    }
}

fn ring(points: &[Point3], line: &[usize]) -> Option<RingClosing> {
    RingClosing::new(&line.iter().map(|&v| points[v]).collect::<Vec<_>>()).ok()
}

fn strip(points: &[Point3], quads: &[[usize; 4]]) -> Option<StripClosing> {
    StripClosing::new(quads.iter().map(|quad| quad.map(|v| points[v])).collect()).ok()
}

/// Refuses pinned closed rows or columns that fail by an angle: in a circular net all lines along them fail by the
/// same.
///
/// # Errors
/// `net-does-not-close`.
pub(super) fn check_pinned(grid: &QuadGrid, border: Border<'_>) -> Result<()> {
    if !matches!(border, Border::Pinned) {
        return Ok(());
    }
    let limit = closing_limit(grid);
    for direction in (0..2).filter(|d| grid.closed()[*d] && !grid.closed()[1 - d]) {
        for line in [0, grid.size()[1 - direction] - 1] {
            let points: Vec<Point3> = grid.line(direction, line).into_iter().map(|v| grid.points()[v]).collect();
            let angle = RingClosing::new(&points)?.angle();
            if !(angle <= limit) {
                return Err(Error::NetDoesNotClose { direction, angle, stretch: 0.0, limit });
            }
        }
    }
    Ok(())
}
