//! The equations of closed directions, which the search solves beside those of the quads
//! (`docs/math/circular-meshes.md#closed-grids`).
//!
//! One closed line is enough: where the quads are circular all lines along it fail by the same angle. The strips need
//! an equation each.

use super::dense_rows::SparseRow;
use super::options::Border;
use cyclide::Point3;
use cyclide::surface::{GridClosing, QuadGrid, QuadLayout, RingClosing, StripClosing};
use cyclide::workspace::{RoundClosing, closing_limit};
use cyclide::{
    Result,
    error::{GridError, PatchError},
};

/// Weight of the equations of strips, against those of quads and lines: with 1 the vertices of a tower move a quarter
/// farther, with 0.01 rings take twice the steps.
const STRIP_WEIGHT: f64 = 0.1;

/// A closed line or strip of the grid, or what is round extraordinary vertices.
enum Closed {
    /// Its vertices.
    Line(Vec<usize>),
    /// The corners of its quads.
    Strip(Vec<[usize; 4]>),
    /// All of them together.
    Round(RoundClosing),
}

/// What it is that closes.
enum Whole {
    /// A grid of this size, and which of its directions are closed.
    Grid([usize; 2], [bool; 2]),
    /// Grids round these extraordinary vertices, with the largest angle that a net accepts.
    Layout(Vec<usize>, f64),
}

/// The closed lines and strips whose equations are solved; none of an open grid.
pub(super) struct Closing {
    equations: Vec<Closed>,
    whole: Whole,
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
        Self { equations, whole: Whole::Grid(grid.size(), grid.closed()) }
    }

    /// All closed strips, and what is round the extraordinary vertices.
    pub(super) fn of_layout(layout: &QuadLayout) -> Self {
        let round = RoundClosing::new(layout);
        let strips = layout.closed_strips().into_iter().map(Closed::Strip);
        let equations = (!round.is_empty()).then_some(Closed::Round(round)).into_iter().chain(strips).collect();
        let limit = layout.pieces().iter().map(|piece| closing_limit(&piece.grid)).fold(0.0, f64::max);
        Self { equations, whole: Whole::Layout(layout.round().iter().map(|at| at.vertex).collect(), limit) }
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
                Closed::Round(round) => values.extend(round.values(points)?),
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
                Closed::Round(round) => rows.extend(round.gradients(points)?),
            }
        }
        Some(rows)
    }

    /// Whether frames and speeds come back up to a limit.
    pub(super) fn is_below(&self, points: &[Point3], limit: f64) -> bool {
        let closes = |closed: &Closed| match closed {
            Closed::Line(line) => ring(points, line).is_some_and(|ring| ring.angle() <= limit),
            Closed::Strip(quads) => strip(points, quads).is_some_and(|strip| strip.equation().abs() <= limit),
            Closed::Round(round) => round.angle(points).0 <= limit,
        };
        self.equations.iter().all(closes)
    }

    /// Refuses points with which a direction of the grid, or what is round an extraordinary vertex, fails to close.
    ///
    /// # Errors
    /// `net-does-not-close`, `ring-does-not-close`.
    pub(super) fn check(&self, points: &[Point3]) -> Result<()> {
        let grid = match &self.whole {
            Whole::Grid(size, closed) => QuadGrid::new(points.to_vec(), *size, *closed)?,
            Whole::Layout(vertices, limit) => return self.check_round(points, vertices, *limit),
        };
        let limit = closing_limit(&grid);
        for direction in 0..2 {
            if let Some(GridClosing { angle, stretch, .. }) = grid.closing(direction)?
                && !(angle.max(stretch) <= limit)
            {
                return Err(PatchError::NetDoesNotClose { direction, line: None, angle, stretch, limit }.into());
            }
        }
        Ok(())
    }

    fn check_round(&self, points: &[Point3], vertices: &[usize], limit: f64) -> Result<()> {
        for closed in &self.equations {
            if let Closed::Round(round) = closed {
                let (angle, at) = round.angle(points);
                if !(angle <= limit) {
                    return Err(GridError::RingDoesNotClose { vertex: vertices[at], angle, limit }.into());
                }
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
                return Err(
                    PatchError::NetDoesNotClose { direction, line: Some(line), angle, stretch: 0.0, limit }.into()
                );
            }
        }
    }
    Ok(())
}
