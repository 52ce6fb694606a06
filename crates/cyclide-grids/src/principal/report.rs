//! What was found of the surface, and what the grids are like.

use crate::principal_rules::GridBorder;
use cyclide::Point3;

/// A place where a surface bends alike in all directions.
///
/// ```
/// use cyclide::Point3;
/// use cyclide_grids::Umbilic;
/// let lemon = Umbilic { point: Point3::ORIGIN, halves: 1 };
/// assert!(lemon.halves > 0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Umbilic {
    /// Where it is.
    pub point: Point3,
    /// How many half turns the lines of curvature make round it.
    pub halves: i32,
}

/// One of several grids.
///
/// ```
/// let piece = cyclide_grids::GridPiece { coverage: 0.5, edges: [0.9, 1.1] };
/// assert!(piece.edges[0] < piece.edges[1]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GridPiece {
    /// The part of the surface's area that it covers.
    pub coverage: f64,
    /// Its shortest and its longest edge.
    pub edges: [f64; 2],
}

/// What [`principal_grids`](super::principal_grids) found and did.
///
/// ```
/// let report = cyclide_grids::PrincipalGridReport::default();
/// assert!(report.umbilics.is_empty() && report.return_shift.is_none());
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct PrincipalGridReport {
    /// Of each grid.
    pub pieces: Vec<GridPiece>,
    /// The part of the surface's area that all grids cover.
    pub coverage: f64,
    /// How far the grids go.
    pub border: GridBorder,
    /// The distance of the vertices from a smooth surface: the median of the rms distances from fits to neighbors, as given.
    /// Of a coarse mesh of a curved surface that is mostly what the fits miss of its shape.
    pub noise: f64,
    /// Whether that was smoothed away.
    pub denoised: bool,
    /// How much the directions were smoothed.
    pub smoothing: f64,
    /// By how much smoothing turned the directions, radians: the mean, weighted by the difference of the principal curvatures.
    pub turn: f64,
    /// The umbilics before the field was smoothed any further than it always is.
    pub umbilics_found: usize,
    /// Those that are left.
    pub umbilics: Vec<Umbilic>,
    /// Of a surface that comes back to itself: by how much its lines of curvature come back higher or lower.
    pub return_shift: Option<f64>,
    /// Borders of the surface besides the outer one.
    pub holes: usize,
}
