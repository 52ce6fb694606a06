//! What is reported of volumes.

use cyclide::{
    Point3, Vec3,
    topology::Shell,
    volume::{CyclideVolume, FoldVerdict, GridQuality, ParamVolume as _, StructuredGrid},
};
use serde::Serialize;

use super::CellLawReport;
use super::figures::{Line, measure, plural, range, short};
use super::range::RangeReport;
use super::surface::number;

/// Places per direction at which cells are measured.
const PLACES: usize = 9;

/// The report on an object of volumes. Lengths are in the document's units.
///
/// ```
/// use cyclide_io::{Document, report::{GeometryReport, ObjectReport}};
/// let corners = "[[0,0,0], [2,0,0], [0,3,0], [2,3,0], [0,0,1], [2,0,1], [0,3,1]]";
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"b": {{"type": "cyclide-volume", "corners": {corners}}}}}}}"#);
/// let document: Document = text.parse()?;
/// let report = ObjectReport::new(&document.build()?[0], None);
/// let GeometryReport::Volume(found) = report.geometry else { unreachable!("by its type") };
/// assert!((found.volume - 6.0).abs() < 1e-12 && (found.area - 22.0).abs() < 1e-12);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct VolumeReport {
    /// Blocks.
    pub blocks: usize,
    /// Total volume of all blocks; for a block that folds, the volume of its reversed parts is subtracted.
    pub volume: f64,
    /// Centroid of all blocks together.
    pub centroid: [f64; 3],
    /// Area of the faces of all blocks: those between two blocks count twice.
    pub area: f64,
    /// Why volume and centroid or the area are unknown: they are then NaN, in JSON null.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_known: Vec<String>,
    /// Whether blocks fold: the worst of them.
    pub folds: FoldsReport,
    /// The determinant of the derivatives by the parameters, at 9 x 9 x 9 points of each block, including corners and midpoints of its
    /// sides, and where it [folds](Self::folds): negative if the block is left-handed or folds. Between these points it may be smaller or
    /// larger.
    pub jacobian: RangeReport,
    /// Largest cosine between two parameter lines at these points: zero, up to rounding.
    pub orthogonality: f64,
    /// Largest quotient of the speeds of two parameter lines at these points, except where a line is one point.
    pub aspect_ratio: f64,
    /// Length of the shortest side of a block that is not a point.
    pub shortest_side: f64,
    /// Sides of blocks that are one point, as at the poles of spheres.
    pub point_sides: usize,
    /// The 27 real weights of every block, before blocks are cut so that all are positive.
    pub weights: RangeReport,
    /// The cells into which blocks are divided, if any.
    pub cells: Option<CellsReport>,
    /// Parts with positive weights: hexahedra in files with volumes.
    pub parts: Option<usize>,
    /// Largest real part of the quaternion quotient, a length: how far rounding moves blocks out of three-space.
    pub residual: f64,
}

/// Whether a block folds, and where.
///
/// ```
/// use cyclide_io::report::FoldsReport;
/// let text = serde_json::to_string(&FoldsReport::Folded { block: 0, at: [0.5, 0.0, 1.0] });
/// assert_eq!(text.expect("it is plain"), r#"{"verdict":"folded","block":0,"at":[0.5,0.0,1.0]}"#);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(tag = "verdict", rename_all = "kebab-case")]
pub enum FoldsReport {
    /// No block folds, proved.
    Regular,
    /// One does.
    Folded {
        /// Which block, from 0.
        block: usize,
        /// Where: s, t, u.
        at: [f64; 3],
    },
    /// It is undecided for one, and none is known to fold.
    Undecided {
        /// Which block, from 0.
        block: usize,
        /// Where: s, t, u.
        at: [f64; 3],
    },
}

impl FoldsReport {
    fn new(volumes: &[CyclideVolume]) -> Self {
        let mut found = Self::Regular;
        for (block, volume) in volumes.iter().enumerate() {
            match volume.folds() {
                FoldVerdict::Folded { at } => return Self::Folded { block, at },
                FoldVerdict::Undecided { at, .. } if found == Self::Regular => found = Self::Undecided { block, at },
                _ => {}
            }
        }
        found
    }

    fn text(&self) -> String {
        let place = |block: usize, at: [f64; 3]| {
            let [s, t, u] = at.map(short);
            format!("block {block} near s = {s}, t = {t}, u = {u}")
        };
        match *self {
            Self::Regular => "none, proved".to_owned(),
            Self::Folded { block, at } => place(block, at),
            Self::Undecided { block, at } => format!("not decided: {}", place(block, at)),
        }
    }
}

/// The cells into which blocks are divided: hexahedra between the nodes of a structured grid. Counts and the worst value of each
/// measure.
///
/// ```
/// use cyclide_io::{Document, report::{GeometryReport, ObjectReport}};
/// let corners = "[[0,0,0], [2,0,0], [0,3,0], [2,3,0], [0,0,1], [2,0,1], [0,3,1]]";
/// let text = format!(r#"{{"cyclide": 1, "objects": {{"b": {{"type": "cyclide-volume", "corners": {corners}, "cells": 4}}}}}}"#);
/// let document: Document = text.parse()?;
/// let GeometryReport::Volume(found) = ObjectReport::new(&document.build()?[0], None).geometry else { unreachable!("by its type") };
/// let cells = found.cells.ok_or("it has cells")?;
/// assert!((cells.count, cells.nodes, cells.inverted) == (64, 125, 0) && (cells.scaled_jacobian - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CellsReport {
    /// Cells of every block along s, t and u.
    pub divisions: [usize; 3],
    /// All cells.
    pub count: usize,
    /// Nodes, each once.
    pub nodes: usize,
    /// Largest cosine between two parameter lines at a node: zero, up to rounding.
    pub orthogonality: f64,
    /// Least scaled Jacobian of the hexahedra with straight sides: 1 for boxes, not positive if one is inverted.
    pub scaled_jacobian: f64,
    /// The cell that has it.
    pub worst: CellPlace,
    /// Largest ratio of the longest to the shortest side.
    pub aspect_ratio: f64,
    /// The shortest side that is not a point.
    pub shortest_side: f64,
    /// Inverted cells: the scaled Jacobian, or that of the block at a node, is not positive.
    pub inverted: usize,
    /// The first of these.
    pub first_inverted: Option<CellPlace>,
    /// Cells with a side of zero length.
    pub collapsed: usize,
    /// The laws of the cells along s, t and u; none if only the parameters are known.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub laws: Vec<CellLawReport>,
}

/// Which cell of a structured grid.
///
/// ```
/// use cyclide_io::report::CellPlace;
/// let text = serde_json::to_string(&CellPlace { block: 3, at: [0, 7, 1] });
/// assert_eq!(text.expect("it is plain"), r#"{"block":3,"at":[0,7,1]}"#);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct CellPlace {
    /// Its block, from 0.
    pub block: usize,
    /// Its indices in the block along s, t and u, from 0.
    pub at: [usize; 3],
}

impl CellPlace {
    fn text(&self) -> String {
        let [i, j, k] = self.at;
        format!("block {}, cell {i}, {j}, {k}", self.block)
    }
}

impl CellsReport {
    fn new(places: &[Vec<f64>; 3], quality: &GridQuality) -> Self {
        let divisions = places.each_ref().map(|places| places.len() - 1);
        let [m, n, l] = divisions;
        let place =
            |cell: usize| CellPlace { block: cell / (m * n * l), at: [cell % m, cell / m % n, cell / (m * n) % l] };
        Self {
            divisions,
            count: quality.cells,
            nodes: quality.nodes,
            orthogonality: quality.orthogonality,
            scaled_jacobian: quality.scaled_jacobian,
            worst: place(quality.worst_cell),
            aspect_ratio: quality.aspect_ratio,
            shortest_side: quality.shortest_side,
            inverted: quality.inverted,
            first_inverted: quality.first_inverted.map(place),
            collapsed: quality.collapsed,
            laws: Vec::new(),
        }
    }

    fn lines(&self, units: &str, line: Line<'_>) -> std::fmt::Result {
        let [i, j, k] = self.divisions;
        line(
            "grid",
            format!("{} ({i} x {j} x {k} a block), {}", plural(self.count, "cell"), plural(self.nodes, "node")),
        )?;
        if let Some(text) = CellLawReport::text(&self.laws) {
            line("grading", text)?;
        }
        let mut text = format!(
            "scaled Jacobian from {} ({}), aspect ratio up to {}, sides from {} {units}, right angles at nodes to {} (cosine)",
            short(self.scaled_jacobian),
            self.worst.text(),
            short(self.aspect_ratio),
            short(self.shortest_side),
            short(self.orthogonality),
        );
        if let Some(first) = &self.first_inverted {
            text += &format!(", {} inverted (first: {})", self.inverted, first.text());
        }
        if self.collapsed > 0 {
            text += &format!(", {} with a side of zero length", self.collapsed);
        }
        line("quality", text)
    }
}

impl VolumeReport {
    /// Measures volumes, and the cells at these parameters.
    #[must_use]
    pub fn new(volumes: &[CyclideVolume], places: Option<&[Vec<f64>; 3]>) -> Self {
        let grid = places.and_then(|places| StructuredGrid::new(volumes, places.clone()).ok());
        Self::of(volumes, places.zip(grid.map(|grid| grid.quality())))
    }

    /// As [`new`](Self::new), with cells that were measured.
    pub(super) fn of(volumes: &[CyclideVolume], cells: Option<(&[Vec<f64>; 3], GridQuality)>) -> Self {
        let origin = volumes.first().map_or(Point3::ORIGIN, |volume| volume.corners()[0]);
        let mut report = Self {
            blocks: volumes.len(),
            volume: 0.0,
            centroid: origin.to_array(),
            area: 0.0,
            not_known: Vec::new(),
            folds: FoldsReport::new(volumes),
            jacobian: RangeReport::EMPTY,
            orthogonality: 0.0,
            aspect_ratio: 1.0,
            shortest_side: f64::INFINITY,
            point_sides: 0,
            weights: RangeReport::EMPTY,
            cells: cells.map(|(places, quality)| CellsReport::new(places, &quality)),
            parts: Some(0),
            residual: 0.0,
        };
        let mut moment = Vec3::ZERO;
        for volume in volumes {
            let measured = volume.measure();
            report.volume += number(measured.known().map(|known| known.volume), &mut report.not_known);
            moment += (measured.centroid - origin) * measured.volume;
            // Faces of no extent, of which there is no shell, have no area.
            for shell in volume.faces().into_iter().filter_map(|face| Shell::from_surface(face).ok()) {
                report.area += number(shell.known_area(), &mut report.not_known);
            }
            report.measure_cells(volume);
            for row in volume.to_rational().rows() {
                report.weights = report.weights.with(row[3], row[3]);
            }
            let parts = volume.to_rational_parts().ok().map(|parts| parts.len());
            report.parts = report.parts.zip(parts).map(|(sum, parts)| sum + parts);
        }
        if let FoldsReport::Folded { block, at } | FoldsReport::Undecided { block, at } = report.folds {
            let found = volumes[block].jacobian(at);
            report.jacobian = report.jacobian.with(found, found);
        }
        // Of no volume, and so of one that is not known, there is none.
        if report.volume != 0.0 {
            report.centroid = (origin + moment / report.volume).to_array();
        }
        report
    }

    fn measure_cells(&mut self, volume: &CyclideVolume) {
        let step = |k: usize| k as f64 / (PLACES - 1) as f64;
        for k in 0..PLACES.pow(3) {
            let at = [step(k % PLACES), step(k / PLACES % PLACES), step(k / PLACES / PLACES)];
            let metric = volume.metric(at);
            // A zero has one sign.
            let jacobian = metric.jacobian + 0.0;
            self.jacobian = self.jacobian.with(jacobian, jacobian);
            self.orthogonality = self.orthogonality.max(metric.orthogonality());
            self.residual = self.residual.max(metric.residual);
            if metric.standing.contains(&true) {
                continue;
            }
            let speeds = metric.first.map(Vec3::length);
            let (least, most) = speeds.iter().fold((f64::INFINITY, 0.0_f64), |(lo, hi), v| (lo.min(*v), hi.max(*v)));
            self.aspect_ratio = self.aspect_ratio.max(most / least);
        }
        for side in (0..3).flat_map(|axis| volume.sides(axis)) {
            match side {
                Some(arc) => self.shortest_side = self.shortest_side.min(arc.length()),
                None => self.point_sides += 1,
            }
        }
    }

    pub(super) fn facts(&self, facts: &mut Vec<String>) {
        facts.push(plural(self.blocks, "block"));
    }

    pub(super) fn lines(&self, units: &str, line: Line<'_>) -> std::fmt::Result {
        line("volume", measure(self.volume, units, "³"))?;
        line("area", measure(self.area, units, "²"))?;
        if self.volume.is_finite() {
            line("centroid", self.centroid.map(short).join(", "))?;
        }
        for reason in &self.not_known {
            line("not known", reason.clone())?;
        }
        line("folds", self.folds.text())?;
        let jacobian = range(&self.jacobian);
        line(
            "cells",
            format!("Jacobian {jacobian}, aspect ratio up to {}, at 9 x 9 x 9 points", short(self.aspect_ratio)),
        )?;
        line("lines", format!("cross at right angles to {} (cosine)", short(self.orthogonality)))?;
        let points = match self.point_sides {
            0 => String::new(),
            1 => ", 1 of zero length".to_owned(),
            count => format!(", {count} of zero length"),
        };
        line("sides", format!("from {} {units}{points}", short(self.shortest_side)))?;
        if let Some(cells) = &self.cells {
            cells.lines(units, line)?;
        }
        let parts = self.parts.map_or(String::new(), |parts| format!(", positive in {}", plural(parts, "part")));
        line("weights", range(&self.weights) + &parts)
    }
}
