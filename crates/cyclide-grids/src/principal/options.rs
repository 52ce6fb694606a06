//! What the user can ask of [`principal_grids`](super::principal_grids).

use crate::principal_rules::{GridBorder, UmbilicRule};
use cyclide::{
    Result,
    error::{ErrorItem, NumberError},
};

/// Options of [`principal_grids`](super::principal_grids).
///
/// ```
/// use cyclide_grids::PrincipalGridOptions;
/// let options = PrincipalGridOptions { most_pieces: Some(2), ..PrincipalGridOptions::new(0.5) };
/// assert!(options.edge_length == 0.5 && options.closed.is_none());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalGridOptions {
    /// Length of the edges of the grid, in the mean; the edges of the mesh should not be longer.
    pub edge_length: f64,
    /// What becomes of umbilics.
    pub umbilics: UmbilicRule,
    /// How far the grid goes. Covering a surface takes one grid: it has no umbilics then, or they are smoothed.
    pub border: GridBorder,
    /// Whether a surface that comes back to itself, as a tube does, gets a grid that is closed along s: yes also where its lines of
    /// curvature are spirals (`true`), never (`false`), or where they are not (`None`).
    pub closed: Option<bool>,
    /// Columns of a closed grid, at least 3; by the edge length if `None`.
    pub columns: Option<usize>,
    /// Grids laid at most, the largest first, 1 to 4; `None` for one, or four where the surface is cut.
    pub most_pieces: Option<usize>,
    /// Whether noise is smoothed away first: where there is more than a thousandth of an edge, and the mesh is fine enough to tell it
    /// from shape, if `None`.
    pub denoise: Option<bool>,
}

/// Grids laid at most.
pub(super) const MOST_PIECES: usize = 4;
/// Columns of a closed grid at least, and at most.
const COLUMNS: [usize; 2] = [3, 10_000];
/// Cells that the whole surface would have, at most.
pub(super) const MOST_CELLS: f64 = 1e6;

impl PrincipalGridOptions {
    /// The usual options with an edge length.
    #[must_use]
    pub fn new(edge_length: f64) -> Self {
        let (umbilics, border) = (UmbilicRule::Pieces, GridBorder::Inside);
        Self { edge_length, umbilics, border, closed: None, columns: None, most_pieces: None, denoise: None }
    }

    /// # Errors
    /// `parameter-out-of-range`.
    pub(super) fn check(&self, area: f64) -> Result<()> {
        let out = |name, value, min, max| Err(NumberError::ParameterOutOfRange { name, value, min, max }.into());
        // Longer edges than the surface is wide: no grid, or none that could be told from rounding.
        let (least, most) = ((area / MOST_CELLS).sqrt(), area.sqrt());
        if !(self.edge_length >= least && self.edge_length <= most) {
            return out(ErrorItem::EdgeLength, self.edge_length, least, most);
        }
        let count = |name, given: Option<usize>, min: usize, max: usize| match given {
            Some(n) if !(min..=max).contains(&n) => out(name, n as f64, min as f64, max as f64),
            _ => Ok(()),
        };
        count(ErrorItem::Columns, self.columns, COLUMNS[0], COLUMNS[1])?;
        count(ErrorItem::MostPieces, self.most_pieces, 1, MOST_PIECES)
    }
}
