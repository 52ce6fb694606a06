//! A rectangular grid of points, the vertices of a net of quads.

use super::grid_cells::GridCell;
use crate::base::range;
use crate::base::vector::Point3;
use crate::error::{ErrorItem, PointError, Result};

/// Vertices of a regular net of quads: `size[0]` along s, `size[1]` along t, s fastest. A closed direction joins its
/// last vertices to its first, which are not repeated. Of an open grid quads may be left out: [`with_cells`](Self::with_cells).
///
/// ```
/// use cyclide::{Point3, surface::QuadGrid};
/// let points = (0..6).map(|k| Point3::new(f64::from(k % 3), f64::from(k / 3), 0.0)).collect();
/// let grid = QuadGrid::new(points, [3, 2], [false; 2])?;
/// assert_eq!((grid.quads(), grid.corners(1, 0)), ([2, 1], [1, 2, 4, 5]));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct QuadGrid {
    points: Vec<Point3>,
    size: [usize; 2],
    closed: [bool; 2],
    /// What each quad is, s fastest; `None` if all have patches.
    cells: Option<Vec<GridCell>>,
}

impl QuadGrid {
    /// Grid from its points, s fastest. An open direction needs at least 2 vertices, a closed one 3.
    ///
    /// # Errors
    /// `too-few-points` (the count is not `size[0] size[1]`, or a direction is too short), `not-finite`,
    /// `parameter-out-of-range`.
    pub fn new(points: Vec<Point3>, size: [usize; 2], closed: [bool; 2]) -> Result<Self> {
        for d in 0..2 {
            let needed = if closed[d] { 3 } else { 2 };
            if size[d] < needed {
                return Err(PointError::TooFewPoints { given: size[d], needed }.into());
            }
        }
        if points.len() != size[0] * size[1] {
            return Err(PointError::TooFewPoints { given: points.len(), needed: size[0] * size[1] }.into());
        }
        for (index, p) in points.iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        Ok(Self { points, size, closed, cells: None })
    }

    /// The same grid of other points.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_points(&self, points: Vec<Point3>) -> Result<Self> {
        Self::new(points, self.size, self.closed).map(|grid| grid.masked(self.cells.clone()))
    }

    /// The grid with cells that were checked.
    pub(in crate::surface) fn masked(self, cells: Option<Vec<GridCell>>) -> Self {
        Self { cells, ..self }
    }

    /// What each quad is, if not all have patches.
    pub(in crate::surface) fn cells(&self) -> Option<&[GridCell]> {
        self.cells.as_deref()
    }

    /// Refuses a grid that is a point at its place.
    ///
    /// # Errors
    /// `below-rounding-of-place`.
    pub(in crate::surface) fn check_place(&self) -> Result<()> {
        range::check_place(ErrorItem::Surface, &self.points)
    }

    /// The grid of one quad with its corners in binary order.
    pub(in crate::surface) fn of_corners(corners: [Point3; 4]) -> Self {
        Self { points: corners.to_vec(), size: [2, 2], closed: [false, false], cells: None }
    }

    /// Vertices along s and along t.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Whether each direction is closed.
    #[must_use]
    pub fn closed(&self) -> [bool; 2] {
        self.closed
    }

    /// All points, s fastest.
    #[must_use]
    pub fn points(&self) -> &[Point3] {
        &self.points
    }

    /// Quads along s and along t, of the whole rectangle.
    #[must_use]
    pub fn quads(&self) -> [usize; 2] {
        [0, 1].map(|d| if self.closed[d] { self.size[d] } else { self.size[d] - 1 })
    }

    /// Index of vertex `(i, j)`, counted round in closed directions.
    #[must_use]
    pub fn index(&self, i: usize, j: usize) -> usize {
        let wrap = |k: usize, d: usize| if self.closed[d] { k % self.size[d] } else { k };
        wrap(i, 0) + wrap(j, 1) * self.size[0]
    }

    /// Vertex `(i, j)`, counted round in closed directions.
    ///
    /// # Panics
    /// If it is outside an open direction.
    #[must_use]
    pub fn point(&self, i: usize, j: usize) -> Point3 {
        self.points[self.index(i, j)]
    }

    /// Indices of the corners of quad `(i, j)` in binary order: (0,0), (1,0), (0,1), (1,1).
    #[must_use]
    pub fn corners(&self, i: usize, j: usize) -> [usize; 4] {
        [self.index(i, j), self.index(i + 1, j), self.index(i, j + 1), self.index(i + 1, j + 1)]
    }
}
