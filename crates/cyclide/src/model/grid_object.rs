//! Grids of quads on their way to files: what they are, and the lines that are drawn of them.

use std::collections::HashSet;

use super::object::CurveObject;
use crate::base::vector::Point3;
use crate::curve::ArcPath;
use crate::error::Result;
use crate::surface::{QuadGrid, QuadLayout};

/// Regular grids of quads: some that lie apart, or those of a mesh, which join round its extraordinary vertices. Nets are made of the grids;
/// whoever draws or measures curves takes the lines.
///
/// ```
/// use cyclide::{Point3, model::{GridObject, Item}, surface::QuadGrid};
/// let points = (0..6).map(|k| Point3::new(f64::from(k % 3), f64::from(k / 3), 0.0)).collect();
/// let item = Item::new("g", GridObject::apart(vec![QuadGrid::new(points, [3, 2], [false; 2])?])?);
/// // Two lines along s and three along t.
/// assert_eq!(item.curves().len(), 5);
/// assert!(item.grids().is_some_and(|laid| laid.grids()[0].quads() == [2, 1] && laid.layout().is_none()));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct GridObject {
    grids: Vec<QuadGrid>,
    layout: Option<QuadLayout>,
    lines: Vec<CurveObject>,
}

impl GridObject {
    /// Grids that share nothing.
    ///
    /// # Errors
    /// As [`ArcPath::rounded_polyline`], of neighbors at one place.
    pub fn apart(grids: Vec<QuadGrid>) -> Result<Self> {
        let mut lines = Vec::new();
        for grid in &grids {
            add_lines(&mut lines, grid, |_, _| true)?;
        }
        Ok(Self { grids, layout: None, lines })
    }

    /// The grids of a mesh. What several of them share is drawn once.
    ///
    /// # Errors
    /// As [`apart`](Self::apart).
    pub fn joined(layout: QuadLayout) -> Result<Self> {
        let (mut lines, mut drawn) = (Vec::new(), HashSet::new());
        for piece in layout.pieces() {
            add_lines(&mut lines, &piece.grid, |a, b| {
                let [a, b] = [a, b].map(|v| piece.vertices[v]);
                drawn.insert([a.min(b), a.max(b)])
            })?;
        }
        let grids = layout.pieces().iter().map(|piece| piece.grid.clone()).collect();
        Ok(Self { grids, layout: Some(layout), lines })
    }

    /// The grids.
    #[must_use]
    pub fn grids(&self) -> &[QuadGrid] {
        &self.grids
    }

    /// The mesh that they are of, if they join.
    #[must_use]
    pub fn layout(&self) -> Option<&QuadLayout> {
        self.layout.as_ref()
    }

    /// Their lines as polylines, grid by grid, those along s first.
    #[must_use]
    pub fn lines(&self) -> &[CurveObject] {
        &self.lines
    }
}

/// The lines of a grid, in parts between edges that are not wanted; a closed one is drawn whole.
fn add_lines(
    lines: &mut Vec<CurveObject>,
    grid: &QuadGrid,
    mut wanted: impl FnMut(usize, usize) -> bool,
) -> Result<()> {
    for (line, closed) in grid.lines() {
        let edges: Vec<bool> = line.windows(2).map(|edge| closed || wanted(edge[0], edge[1])).collect();
        let mut from = 0;
        for run in edges.chunk_by(|a, b| a == b) {
            let to = from + run.len();
            if run[0] {
                let points: Vec<Point3> = line[from..=to].iter().map(|v| grid.points()[*v]).collect();
                lines.push(ArcPath::rounded_polyline(&points, closed, &vec![0.0; points.len()])?.into());
            }
            from = to;
        }
    }
    Ok(())
}
