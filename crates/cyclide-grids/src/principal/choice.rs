//! Which layout of grids covers most of a surface, where nobody asked for one.

use super::{PrincipalGridOptions, PrincipalGrids, PrincipalStage, principal_grids_watched};
use crate::principal_rules::{GridBorder, UmbilicRule};
use cyclide::Point3;
use cyclide::Result;
use cyclide::{Warning, warning::PrincipalGridWarning};

/// The part of a surface below which a grid is said to miss some of it, and other layouts are tried.
const MOST: f64 = 0.9;

/// What of a layout may be chosen by how much of the surface it covers.
///
/// ```
/// let free = cyclide_grids::FreeLayout::default();
/// assert!(!free.border && !free.umbilics);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FreeLayout {
    /// The border: [`GridBorder::Inside`] may become [`GridBorder::Staircase`].
    pub border: bool,
    /// What becomes of umbilics: [`UmbilicRule::Pieces`] may become [`UmbilicRule::Joined`].
    pub umbilics: bool,
}

/// As [`principal_grids`](super::principal_grids), by the layout that covers most of the surface among those that are free: the one of the options where that
/// covers 90 %, else a border in steps if that covers more, and one mesh joined round umbilics if there are any and that covers more.
/// Warns with `partly-covered` where less than 90 % is covered then. The report says which layout was taken.
///
/// ```
/// use cyclide::Point3;
/// use cyclide_grids::{FreeLayout, GridBorder, PrincipalGridOptions, covering_principal_grids};
/// // A hypar whose rulings the mesh follows: a rectangle along the lines of curvature, at 45 degrees, covers half of it.
/// let at = |k: usize| (0.25 * (k % 25) as f64 - 3.0, 0.25 * (k / 25) as f64 - 3.0);
/// let points: Vec<Point3> = (0..625).map(at).map(|(x, y)| Point3::new(x, y, 0.1 * x * y)).collect();
/// let quads = (0..24).flat_map(|j| (0..24).map(move |i| 25 * j + i));
/// let triangles: Vec<[usize; 3]> = quads.flat_map(|a| [[a, a + 1, a + 26], [a, a + 26, a + 25]]).collect();
/// let free = FreeLayout { border: true, umbilics: true };
/// let laid = covering_principal_grids(&points, &triangles, &PrincipalGridOptions::new(0.5), free)?;
/// assert!(laid.report.border == GridBorder::Staircase && laid.report.coverage > 0.8);
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// Those of [`principal_grids`](super::principal_grids) with the options as they are.
pub fn covering_principal_grids(
    points: &[Point3],
    triangles: &[[usize; 3]],
    options: &PrincipalGridOptions,
    free: FreeLayout,
) -> Result<PrincipalGrids> {
    covering_principal_grids_watched(points, triangles, options, free, &mut |_| ())
}

/// [`covering_principal_grids`] whose `progress` hears of every stage.
///
/// # Errors
/// Those of [`covering_principal_grids`].
pub fn covering_principal_grids_watched(
    points: &[Point3],
    triangles: &[[usize; 3]],
    options: &PrincipalGridOptions,
    free: FreeLayout,
    progress: &mut dyn FnMut(PrincipalStage),
) -> Result<PrincipalGrids> {
    let mut best = principal_grids_watched(points, triangles, options, progress)?;
    let steps = PrincipalGridOptions { border: GridBorder::Staircase, ..*options };
    let joined = PrincipalGridOptions { umbilics: UmbilicRule::Joined, ..steps };
    let may_step = free.border && options.border == GridBorder::Inside;
    // Joined grids end in steps: a border that was asked for is kept.
    let may_join = free.umbilics && (may_step || options.border == GridBorder::Staircase);
    for (trial, wanted) in [(steps, may_step), (joined, may_join && !best.report.umbilics.is_empty())] {
        if !wanted || best.report.coverage >= MOST {
            continue;
        }
        // A layout that cannot be laid is none to choose.
        if let Ok(other) = principal_grids_watched(points, triangles, &trial, progress)
            && other.report.coverage > best.report.coverage
        {
            best = other;
        }
    }
    let coverage = best.report.coverage;
    if coverage < MOST {
        // Steps that were tried cover no more.
        let rectangles = best.report.border == GridBorder::Inside && !may_step;
        let umbilics = best.report.umbilics.len();
        best.warnings.push(Warning::PrincipalGrid(PrincipalGridWarning::PartlyCovered {
            coverage,
            limit: MOST,
            rectangles,
            umbilics,
        }));
    }
    Ok(best)
}
