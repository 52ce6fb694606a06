//! Why the cells of a grid are no part of it that can be made.

/// What is wrong with the cells of a grid that is not whole, or with what is asked of it.
///
/// ```
/// use cyclide::{Error, GridCell, GridCellFault, GridError, Point3, QuadGrid};
/// let points = (0..16).map(|k| Point3::new(f64::from(k % 4), f64::from(k / 4), 0.0)).collect();
/// let hole = |i, j| if (i, j) == (1, 1) { GridCell::Outside } else { GridCell::Patch };
/// let error = QuadGrid::new(points, [4, 4], [false; 2])?.with_cells(hole).unwrap_err();
/// assert_eq!(error, Error::Grid(GridError::CellsUnfit { fault: GridCellFault::Enclosed, index: 4 }));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum GridCellFault {
    /// No cell is left.
    None,
    /// A cell is not connected to the first one.
    Apart,
    /// A cell meets others only at a corner.
    Corner,
    /// A cell is outside although the grid surrounds it.
    Enclosed,
    /// A cell of the grid has no point at a corner.
    NoPoint,
    /// The grid is closed.
    Closed,
    /// Curves for the sides of a grid that is not whole.
    Curves,
}

impl GridCellFault {
    /// The fault in words, with what helps.
    pub(super) fn words(self, cell: usize) -> String {
        match self {
            Self::None => "the grid has no quads left".to_owned(),
            Self::Apart => format!("quad {cell} is not connected to the first one: make each piece a separate grid"),
            Self::Corner => {
                format!("quad {cell} meets another only at a corner: leave it out, or fill in a quad beside it")
            }
            Self::Enclosed => format!("the grid surrounds quad {cell}, which is outside: make it an opening"),
            Self::NoPoint => format!("quad {cell} has no point at a corner"),
            Self::Closed => "a closed grid must be whole: none of its quads can be left out".to_owned(),
            Self::Curves => "a stepped border has no sides for curves: leave it free, or hold it".to_owned(),
        }
    }
}
