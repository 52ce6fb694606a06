//! Why the cells left in a grid cannot be built.

/// What is wrong with the cells of an incomplete grid, or with the use of it.
///
/// ```
/// use cyclide::{Error, Point3, error::{GridCellFault, GridError}, surface::{GridCell, QuadGrid}};
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
    /// A cell meets another only at a corner.
    Corner,
    /// A cell is outside although the grid surrounds it.
    Enclosed,
    /// A cell of the grid has no point at a corner.
    NoPoint,
    /// The grid is closed.
    Closed,
    /// Curves are given for the sides of an incomplete grid.
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
            Self::Closed => "a closed grid must be complete: none of its quads can be left out".to_owned(),
            Self::Curves => {
                "curves need the sides of a complete grid, and this border is stepped: leave it free, or pin it"
                    .to_owned()
            }
        }
    }
}
