//! The report on grids along lines of curvature.

use std::fmt;

use serde::Serialize;

use super::figures::{Line, plural, short};
use super::range::RangeReport;
use crate::document::BuiltObject;

/// The lines of curvature of a surface, and the grids along them.
///
/// ```
/// let place = |k: usize| [0.5 * (k % 17) as f64, 0.5 * (k / 17) as f64];
/// let vertices: Vec<[f64; 3]> = (0..289).map(place).map(|[x, y]| [x, y, 0.05 * (x - 4.0) * (y - 4.0)]).collect();
/// let faces: Vec<[usize; 4]> = (0..256).map(|k| k / 16 * 17 + k % 16).map(|a| [a, a + 1, a + 18, a + 17]).collect();
/// let grid = format!(r#"{{"type": "principal-grid", "vertices": {vertices:?}, "faces": {faces:?}, "edge_length": 0.7}}"#);
/// let document: cyclide_io::Document = format!(r#"{{"cyclide": 1, "objects": {{"g": {grid}}}}}"#).parse()?;
/// let report = cyclide_io::report::ObjectReport::new(&document.build()?[0], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// let laid = found.principal.expect("by its type");
/// assert!(laid.coverage > 0.4 && laid.umbilics.is_empty() && laid.pieces[0].edges.max < 0.75);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PrincipalReport {
    /// The grids, the largest first.
    pub pieces: Vec<GridPieceReport>,
    /// The fraction of the area of the surface that they cover.
    pub coverage: f64,
    /// Their extent: the value of the field `border`.
    pub border: &'static str,
    /// Distance of the vertices from a smooth surface: the median over fits to neighbors.
    pub noise: f64,
    /// True if the noise was smoothed away.
    pub denoised: bool,
    /// How much the directions were smoothed.
    pub smoothing: f64,
    /// Mean angle by which smoothing turned the directions, in radians.
    pub turn: f64,
    /// Umbilics before the directions were smoothed beyond the minimum.
    pub umbilics_found: usize,
    /// Remaining umbilics, which grids avoid.
    pub umbilics: Vec<UmbilicReport>,
    /// For a tube: the shift of its lines of curvature along the tube after one turn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub return_shift: Option<f64>,
    /// Borders of the surface besides the outer one.
    pub holes: usize,
    /// For grids that share their borders: the number of umbilics around which they join.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joined_round: Option<usize>,
}

/// One grid.
///
/// ```
/// let place = |k: usize| [0.5 * (k % 17) as f64, 0.5 * (k / 17) as f64];
/// let vertices: Vec<[f64; 3]> = (0..289).map(place).map(|[x, y]| [x, y, 0.05 * (x - 4.0) * (y - 4.0)]).collect();
/// let faces: Vec<[usize; 4]> = (0..256).map(|k| k / 16 * 17 + k % 16).map(|a| [a, a + 1, a + 18, a + 17]).collect();
/// let grid = format!(r#"{{"type": "principal-grid", "vertices": {vertices:?}, "faces": {faces:?}, "edge_length": 0.7}}"#);
/// let document: cyclide_io::Document = format!(r#"{{"cyclide": 1, "objects": {{"g": {grid}}}}}"#).parse()?;
/// let report = cyclide_io::report::ObjectReport::new(&document.build()?[0], None);
/// let cyclide_io::report::GeometryReport::Curves(found) = report.geometry else { unreachable!("by its type") };
/// let piece = &found.principal.expect("by its type").pieces[0];
/// assert!(piece.columns > 5 && piece.rows > 5 && !piece.closed);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct GridPieceReport {
    /// Points along s.
    pub columns: usize,
    /// Points along t.
    pub rows: usize,
    /// True if it is closed along s.
    pub closed: bool,
    /// The fraction of the area of the surface that it covers.
    pub coverage: f64,
    /// The lengths of its edges.
    pub edges: RangeReport,
}

/// A point where a surface bends equally in all directions.
///
/// ```
/// let report = cyclide_io::report::UmbilicReport { point: [0.0; 3], index: -0.5 };
/// assert!(report.index < 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct UmbilicReport {
    /// Where it is.
    pub point: [f64; 3],
    /// The number of turns of the lines of curvature around it: a half or minus a half.
    pub index: f64,
}

/// The document's word for how far grids go.
const fn border_word(border: cyclide_grids::GridBorder) -> &'static str {
    match border {
        cyclide_grids::GridBorder::Inside => "inside",
        cyclide_grids::GridBorder::Staircase => "staircase",
        cyclide_grids::GridBorder::Cover => "cover",
    }
}

/// So many umbilics are shown as text.
const SHOWN: usize = 6;

impl PrincipalReport {
    /// Of an object that lays grids.
    pub(super) fn new(built: &BuiltObject) -> Option<Box<Self>> {
        let (laid, found) = (built.item.grids()?, built.facts.principal_grid()?);
        let piece = |(grid, piece): (&cyclide::surface::QuadGrid, &cyclide_grids::GridPiece)| GridPieceReport {
            columns: grid.size()[0],
            rows: grid.size()[1],
            closed: grid.closed()[0],
            coverage: piece.coverage,
            edges: RangeReport { min: piece.edges[0], max: piece.edges[1] },
        };
        let umbilic =
            |u: &cyclide_grids::Umbilic| UmbilicReport { point: u.point.to_array(), index: 0.5 * f64::from(u.halves) };
        Some(Box::new(Self {
            pieces: laid.grids().iter().zip(&found.pieces).map(piece).collect(),
            coverage: found.coverage,
            border: border_word(found.border),
            noise: found.noise,
            denoised: found.denoised,
            smoothing: found.smoothing,
            turn: found.turn,
            umbilics_found: found.umbilics_found,
            umbilics: found.umbilics.iter().map(umbilic).collect(),
            return_shift: found.return_shift,
            holes: found.holes,
            joined_round: laid.layout().map(|mesh| mesh.round().len()),
        }))
    }

    /// The lines of the text.
    pub(super) fn lines(&self, units: &str, line: Line<'_>) -> fmt::Result {
        for (index, piece) in self.pieces.iter().enumerate() {
            let closed = if piece.closed { ", closed along s" } else { "" };
            let [min, max, part] = [piece.edges.min, piece.edges.max, 100.0 * piece.coverage].map(short);
            let size = format!("{} by {} points{closed}", piece.columns, piece.rows);
            line(&format!("grid {index}"), format!("{size}, edges {min} to {max} {units}, {part} % of the surface"))?;
        }
        if let Some(round) = self.joined_round {
            line("joined", format!("the grids share their borders around {}", plural(round, "umbilic")))?;
        }
        let smoothing = short(self.smoothing);
        let mut text = format!("smoothed by {smoothing}, which turned them by {} rad on average", short(self.turn));
        if self.denoised {
            text += &format!("; noise of {} {units} was smoothed away first", short(self.noise));
        }
        if let Some(shift) = self.return_shift {
            text +=
                &format!("; after one turn around the tube the lines are shifted by {} {units} along it", short(shift));
        }
        line("directions", text)?;
        for umbilic in self.umbilics.iter().take(SHOWN) {
            line("umbilic", format!("at {}, index {}", umbilic.point.map(short).join(", "), short(umbilic.index)))?;
        }
        match self.umbilics.len().checked_sub(SHOWN) {
            Some(more) if more > 0 => line("", format!("and {} (--json has all)", plural(more, "more umbilic"))),
            _ => Ok(()),
        }
    }
}
