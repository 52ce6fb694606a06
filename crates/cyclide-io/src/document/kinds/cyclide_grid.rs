//! Blocks in a grid.

use cyclide::{
    error::{PartError, PatchError, PoseError},
    surface::DupinCyclide,
    volume::{CyclideGrid, CyclideVolume},
};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::document::coordinates::Coordinates;
use crate::document::kinds::TypeWord;
use crate::document::kinds::cyclide::SEGMENTS;
use crate::document::kinds::fields::cells::CellsSpec;
use crate::document::kinds::fields::comment::Comment;
use crate::document::kinds::fields::frame::{FrameSpec, frame_of_axes, volume_frame};
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::document::objects::kind::{Kind, Shape};
use crate::error::{Error, Result};

/// With `mu` less below `c` than this part of `a` a cyclide has one node.
const ONE_NODE: f64 = 1e-12;

/// Points of two planes that are one may be so far apart, relative to the size of the grid.
const ONE_POINT: f64 = 1e-9;

/// Blocks in a grid, whose neighbors share faces, vertices and parameters. The grid is given by points on three
/// coordinate planes, or it fills the space between parallel Dupin cyclides (closed in both directions for rings).
///
/// ```
/// use cyclide_io::Document;
/// let tube = r#""tube": {"type": "cyclide-grid", "whole": {"a": 4, "c": 1, "mu": [1.5, 1.8, 2], "segments": [8, 6]}, "cells": 4}"#;
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{tube}}}}}"#).parse::<Document>()?.build()?;
/// assert_eq!(built[0].item.volumes().len(), 8 * 6 * 2);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CyclideGridSpec {
    /// The word `cyclide-grid`.
    #[schemars(with = "String", extend("const" = "cyclide-grid"))]
    pub r#type: TypeWord,
    /// A comment for readers; the program ignores it.
    #[serde(default)]
    pub comment: Comment,
    /// Construction geometry: built and reported, not written to files.
    #[serde(default)]
    pub construction: bool,
    /// Points on three coordinate planes; alternatively `whole`.
    pub planes: Option<CoordinatePlanesSpec>,
    /// With `planes`: directions of increasing s and t at the first vertex, perpendicular and of any length; that of u
    /// is perpendicular to both, on the side of the third edge. Default: `"auto"`, which takes the frame of a
    /// `cyclide-volume` there.
    pub frame: Option<FrameSpec>,
    /// The space between parallel cyclides.
    pub whole: Option<WholeCyclideSpec>,
    /// How every block is divided into cells, for VTU cells, `report` and `sample`.
    pub cells: Option<CellsSpec>,
}

/// Points on the three planes on which one of the indices along s, t, u is 0; the corners of every quad lie on one
/// circle. All other points follow from them.
///
/// ```
/// use cyclide_io::Document;
/// let planes = r#"{"st": [[[0,0,0], [1,0,0], [3,0,0]], [[0,1,0], [1,1,0], [3,1,0]]],
///     "su": [[[0,0,0], [1,0,0], [3,0,0]], [[0,0,2], [1,0,2], [3,0,2]]], "tu": [[[0,0,0], [0,1,0]], [[0,0,2], [0,1,2]]]}"#;
/// let built = format!(r#"{{"cyclide": 1, "objects": {{"g": {{"type": "cyclide-grid", "planes": {planes}}}}}}}"#).parse::<Document>()?.build()?;
/// assert_eq!(built[0].item.volumes().len(), 2);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct CoordinatePlanesSpec {
    /// Rows of points of the plane u = 0: s increases along a row, t from row to row.
    #[schemars(length(min = 2))]
    pub st: Vec<Vec<Coordinates>>,
    /// Rows of points of the plane t = 0: s increases along a row, u from row to row. Its first row is the first row of
    /// `st`.
    #[schemars(length(min = 2))]
    pub su: Vec<Vec<Coordinates>>,
    /// Rows of points of the plane s = 0: t increases along a row, u from row to row. Its first row is the first column
    /// of `st`, its first column the first column of `su`.
    #[schemars(length(min = 2))]
    pub tu: Vec<Vec<Coordinates>>,
}

/// A whole Dupin cyclide and its parallels, as of a [`CyclideSpec`](super::CyclideSpec).
///
/// ```
/// use cyclide_io::Document;
/// let wall = r#""w": {"type": "cyclide-grid", "whole": {"a": 3, "mu": [0.5, 1]}}"#;
/// let built = format!(r#"{{"cyclide": 1, "objects": {{{wall}}}}}"#).parse::<Document>()?.build()?;
/// let volume: f64 = built[0].item.volumes().iter().map(|block| block.measure().volume).sum();
/// assert!((volume - 1.5 * std::f64::consts::PI.powi(2) * 3.0).abs() < 1e-9);
/// # Ok::<(), cyclide_io::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct WholeCyclideSpec {
    /// Half the long axis of the ellipse of centers.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub a: f64,
    /// Distance of the foci of that ellipse from its center, less than `a`. Default 0: tori.
    #[serde(default)]
    #[schemars(range(min = 0.0))]
    pub c: f64,
    /// Mean radii of the tubes between which the blocks lie, increasing: u grows outwards, and a ring has c < mu < a.
    /// If the last one is a spindle (mu > a) or the first one a horn (mu < c), the blocks lie along its outer part,
    /// from node to node.
    #[schemars(length(min = 2), inner(range(min = 0.0)))]
    pub mu: Vec<f64>,
    /// Position of the center. Default: the origin.
    pub center: Option<Coordinates>,
    /// Axis of the ring, of any length. Default `[0, 0, 1]`.
    pub axis: Option<Coordinates>,
    /// Direction of the long axis, perpendicular to `axis`, of any length. Default `[1, 0, 0]`, or for another `axis`
    /// the direction nearest to it.
    pub x_direction: Option<Coordinates>,
    /// Number of blocks around the hole and around the tube; odd numbers are rounded up. Default `[4, 4]`.
    #[schemars(inner(range(min = 3, max = 4096)))]
    pub segments: Option<[u32; 2]>,
}

impl Kind for CyclideGridSpec {
    fn build(&self, at: &mut Builder<'_>) -> Result<Shape> {
        at.check_block_count(blocks_of_grid(self), if self.whole.is_some() { "whole" } else { "planes" })?;
        let volumes = at.cyclide_grid(self)?;
        at.divided(volumes, self.cells.as_ref(), "type")
    }
}

impl Builder<'_> {
    /// The blocks of a grid.
    pub(in crate::document) fn cyclide_grid(&self, spec: &CyclideGridSpec) -> Result<Vec<CyclideVolume>> {
        let grid = match (&spec.planes, &spec.whole) {
            (Some(planes), None) => self.grid_of_planes(planes, spec.frame.unwrap_or_default())?,
            (None, Some(whole)) if spec.frame.is_none() => self.grid_of_cyclide(whole)?,
            (None, Some(_)) => return Err(self.unfit("`frame` requires `planes`: a cyclide has its own frame")),
            _ => return Err(self.unfit("either `planes` or `whole` is required")),
        };
        Ok(grid.blocks().collect())
    }

    fn grid_of_cyclide(&self, spec: &WholeCyclideSpec) -> Result<CyclideGrid> {
        let mu = spec.mu.as_slice();
        let [first, .., outer] = *mu else {
            return Err(self.unfit("`mu` of `whole` requires the radii of at least two tubes"));
        };
        let place = |k: usize| [Step::from("whole"), Step::from("mu"), Step::from(k)];
        if let Some(k) = (1..mu.len()).find(|&k| !(mu[k] > mu[k - 1])) {
            let error =
                cyclide::Error::Pose(PoseError::ParametersNotIncreasing { index: k, value: mu[k], before: mu[k - 1] });
            return Err(self.refused_at(place(k), &error));
        }
        // Outwards the outer part of a horn gets longer: what is common to all is that of the first. That of a spindle gets shorter.
        let of_horn = spec.c - first > ONE_NODE * spec.a;
        let base = if of_horn { first } else { outer };
        let made = || {
            let frame = frame_of_axes(spec.center, spec.axis, spec.x_direction)?;
            let segments = spec.segments.unwrap_or(SEGMENTS).map(|n| n as usize);
            let cyclide = DupinCyclide::new(spec.a, spec.c, base)?.placed(frame);
            let distances: Vec<f64> = mu.iter().map(|mu| mu - base).collect();
            CyclideGrid::of_cyclide(&cyclide, segments, &distances)
        };
        made().map_err(|e| {
            let Some(distance) = folding_offset(&e) else { return self.refused_at([Step::from("whole")], &e) };
            let off = |k: &usize| (mu[*k] - base - distance).abs();
            let k = (0..mu.len()).min_by(|j, k| off(j).total_cmp(&off(k))).unwrap_or_default();
            let words = format!(
                "mu = {}: between this value and mu = {base} there are centers of curvature, where blocks would fold; they are at mu from 0 to c = {} and from a = {} upward",
                mu[k], spec.c, spec.a
            );
            self.refused_in_words(place(k), e.reason(), words)
        })
    }

    fn grid_of_planes(&self, planes: &CoordinatePlanesSpec, frame: FrameSpec) -> Result<CyclideGrid> {
        let (st, su, tu) = (&planes.st, &planes.su, &planes.tu);
        let columns = |rows: &[Vec<Coordinates>]| rows.first().map_or(0, Vec::len);
        let [m, n, l] = [columns(st), st.len(), su.len()];
        for (name, rows, wanted) in [("st", st, [m, n]), ("su", su, [m, l]), ("tu", tu, [n, l])] {
            let odd = rows.iter().position(|row| row.len() != wanted[0]);
            if odd.is_some() || rows.len() != wanted[1] {
                let row = odd.unwrap_or(0);
                let message = format!(
                    "the planes have {m} points along s, {n} along t and {l} along u: `{name}` has {} rows, row {row} of {} points",
                    rows.len(),
                    rows.get(row).map_or(0, Vec::len),
                );
                return Err(Error::Input(self.diagnostic(["planes".into(), name.into()], &message)));
            }
        }
        if [m, n, l].contains(&0) {
            return Err(self.unfit("the planes have no points"));
        }
        // Lines that are of two planes.
        let first = st[0][0].point();
        let all = [st, su, tu].into_iter().flatten().flatten();
        let size = all.map(|p| p.point().distance(first)).fold(0.0, f64::max);
        let along_s = st[0].iter().zip(&su[0]).enumerate().map(|(i, (p, q))| ("su", 0, i, p, q, "st"));
        let along_t = st.iter().zip(&tu[0]).enumerate().map(|(j, (row, q))| ("tu", 0, j, &row[0], q, "st"));
        let along_u = su.iter().zip(tu).enumerate().map(|(k, (p, q))| ("tu", k, 0, &p[0], &q[0], "su"));
        for (name, row, column, wanted, given, of) in along_s.chain(along_t).chain(along_u) {
            let distance = given.point().distance(wanted.point());
            if !(distance <= ONE_POINT * size) {
                let message =
                    format!("this point must coincide with that of `{of}`, but its distance from it is {distance:.3e}");
                let place = ["planes".into(), name.into(), row.into(), column.into()];
                return Err(self.refused_in_words(place, "not-concircular", message));
            }
        }
        let point = |[i, j, k]: [usize; 3]| match [i, j, k] {
            [i, j, 0] => st[j][i].point(),
            [i, 0, k] => su[k][i].point(),
            [_, j, k] => tu[k][j].point(),
        };
        let size = [m, n, l].map(|points| points.saturating_sub(1));
        let made = CyclideGrid::from_coordinate_planes(size, point, volume_frame(frame));
        made.map_err(|e| self.refused_frame(frame, &e).unwrap_or_else(|| self.refused_at([Step::from("planes")], &e)))
    }
}

/// The blocks of a grid, as far as its numbers say; segments are rounded up to even numbers.
pub(in crate::document) fn blocks_of_grid(spec: &CyclideGridSpec) -> f64 {
    if let Some(whole) = &spec.whole {
        let segments = whole.segments.unwrap_or(SEGMENTS).map(|n| f64::from(n) + f64::from(n % 2));
        return segments[0] * segments[1] * whole.mu.len().saturating_sub(1) as f64;
    }
    spec.planes.as_ref().map_or(0.0, |planes| {
        let columns = planes.st.first().map_or(0, Vec::len);
        [columns, planes.st.len(), planes.su.len()].map(|n| n.saturating_sub(1) as f64).into_iter().product()
    })
}

/// The distance of an offset that is refused since layers fold there.
fn folding_offset(error: &cyclide::Error) -> Option<f64> {
    match error {
        cyclide::Error::Part(PartError::InQuad { cause, .. }) => folding_offset(cause),
        cyclide::Error::Patch(PatchError::OffsetNotRegular { distance, .. }) => Some(*distance),
        _ => None,
    }
}
