//! Which quads of a grid there are: a border in steps, openings.

use super::quad_grid::QuadGrid;
use crate::base::vector::Point3;
use crate::error::{GridCellFault, GridError, PointError, Result};
use std::collections::VecDeque;

/// What a quad of a [`QuadGrid`] is.
///
/// ```
/// use cyclide::{Point3, surface::{GridCell, QuadGrid}};
/// let points = (0..9).map(|k| Point3::new(f64::from(k % 3), f64::from(k / 3), 0.0)).collect();
/// let grid = QuadGrid::new(points, [3, 3], [false; 2])?;
/// let steps = grid.with_cells(|i, j| if (i, j) == (1, 1) { GridCell::Outside } else { GridCell::Patch })?;
/// assert_eq!((steps.cell(0, 1), steps.cell(1, 1), steps.is_whole()), (GridCell::Patch, GridCell::Outside, false));
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum GridCell {
    /// It has a patch.
    #[default]
    Patch,
    /// It is part of the grid, with its corners on one circle, but has no patch.
    Opening,
    /// It is no part of the grid: its corners may be anywhere.
    Outside,
}

impl QuadGrid {
    /// The open grid with the quads that `cell` says, for quads along s and along t. The quads that are not outside hang together
    /// along their sides and go round nothing that is outside, so that a frame carried along them comes to every one alike; those
    /// with patches hang together too, and neither of these meet in a corner alone.
    ///
    /// # Errors
    /// `cells-unfit`, with the quad (s fastest).
    pub fn with_cells(self, cell: impl Fn(usize, usize) -> GridCell) -> Result<Self> {
        let refused = |fault, index| Err(GridError::CellsUnfit { fault, index }.into());
        if self.closed() != [false; 2] {
            return refused(GridCellFault::Closed, 0);
        }
        let size = self.quads();
        let cells: Vec<GridCell> = quads(size).map(|[i, j]| cell(i, j)).collect();
        for holds in [|cell: &GridCell| *cell != GridCell::Outside, |cell: &GridCell| *cell == GridCell::Patch] {
            let kept: Vec<bool> = cells.iter().map(holds).collect();
            if let Some((fault, index)) = fault(&kept, size) {
                return refused(fault, index);
            }
        }
        let outside: Vec<bool> = cells.iter().map(|cell| *cell == GridCell::Outside).collect();
        if let Some(index) = enclosed(&outside, size) {
            return refused(GridCellFault::Enclosed, index);
        }
        let whole = cells.iter().all(|cell| *cell == GridCell::Patch);
        Ok(self.masked((!whole).then_some(cells)))
    }

    /// An open grid of which points are missing, with the quads that `cell` says, as [`with_cells`](Self::with_cells). Missing
    /// points, which are corners of what is outside only, take the place of one near them along the grid.
    ///
    /// ```
    /// use cyclide::{Point3, surface::{GridCell, QuadGrid}};
    /// // Without its last corner.
    /// let points: Vec<_> = (0..9).map(|k| (k < 8).then(|| Point3::new(f64::from(k % 3), f64::from(k / 3), 0.0))).collect();
    /// let cell = |i, j| if (i, j) == (1, 1) { GridCell::Outside } else { GridCell::Patch };
    /// assert_eq!(QuadGrid::of_cells(&points, [3, 3], cell)?.quads(), [2, 2]);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`new`](Self::new) and [`with_cells`](Self::with_cells), which also refuses quads without all corners.
    pub fn of_cells(
        points: &[Option<Point3>],
        size: [usize; 2],
        cell: impl Fn(usize, usize) -> GridCell,
    ) -> Result<Self> {
        let count = size[0].saturating_mul(size[1]);
        if points.len() != count {
            return Err(PointError::TooFewPoints { given: points.len(), needed: count }.into());
        }
        let mut filled = points.to_vec();
        let mut open: VecDeque<usize> = (0..count).filter(|k| filled[*k].is_some()).collect();
        if open.is_empty() {
            return Err(GridError::CellsUnfit { fault: GridCellFault::None, index: 0 }.into());
        }
        while let Some(k) = open.pop_front() {
            for next in beside(k, size) {
                if filled[next].is_none() {
                    filled[next] = filled[k];
                    open.push_back(next);
                }
            }
        }
        let grid = Self::new(filled.into_iter().flatten().collect(), size, [false; 2])?;
        let no_point = |[i, j]: &[usize; 2]| {
            cell(*i, *j) != GridCell::Outside && grid.corners(*i, *j).iter().any(|k| points[*k].is_none())
        };
        if let Some([i, j]) = quads(grid.quads()).find(no_point) {
            return Err(GridError::CellsUnfit { fault: GridCellFault::NoPoint, index: i + j * grid.quads()[0] }.into());
        }
        grid.with_cells(cell)
    }

    /// What quad `(i, j)` is.
    ///
    /// # Panics
    /// If there is no such quad in the rectangle.
    #[must_use]
    pub fn cell(&self, i: usize, j: usize) -> GridCell {
        let [m, n] = self.quads();
        assert!(i < m && j < n, "quad ({i}, {j}) of a grid of {m} x {n}");
        self.cells().map_or(GridCell::Patch, |cells| cells[i + j * m])
    }

    /// True if every quad of the rectangle has a patch.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.cells().is_none()
    }

    /// The grid lines, those along s first, each with its vertices and whether it is closed. Where quads are left out lines end, and
    /// go on behind: every edge of a patch is on one line.
    ///
    /// ```
    /// use cyclide::{Point3, surface::{GridCell, QuadGrid}};
    /// let points = (0..9).map(|k| Point3::new(f64::from(k % 3), f64::from(k / 3), 0.0)).collect();
    /// let grid = QuadGrid::new(points, [3, 3], [false; 2])?;
    /// let steps = grid.with_cells(|i, j| if (i, j) == (1, 1) { GridCell::Outside } else { GridCell::Patch })?;
    /// assert_eq!(steps.lines()[2], (vec![6, 7], false)); // the last row, without its last edge
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn lines(&self) -> Vec<(Vec<usize>, bool)> {
        let mut lines = Vec::new();
        for d in 0..2 {
            for k in 0..self.size()[1 - d] {
                let vertices = self.line(d, k);
                if self.is_whole() {
                    lines.push((vertices, self.closed()[d]));
                    continue;
                }
                let goes_on = |i: usize| self.patches_beside(if d == 0 { [i, k] } else { [k, i] }, d).contains(&true);
                let mut from = 0;
                for i in (0..vertices.len()).filter(|i| !goes_on(*i)) {
                    if i > from {
                        lines.push((vertices[from..=i].to_vec(), false));
                    }
                    from = i + 1;
                }
            }
        }
        lines
    }

    /// Whether quad `(i, j)` is part of the grid.
    pub fn has_quad(&self, i: usize, j: usize) -> bool {
        self.cell(i, j) != GridCell::Outside
    }

    /// The quads that are part of the grid, s fastest.
    pub fn all_quads(&self) -> impl Iterator<Item = [usize; 2]> {
        quads(self.quads()).filter(|[i, j]| self.has_quad(*i, *j))
    }

    /// The quads before and after the edge from a vertex along direction `d`, of the rectangle.
    fn beside(&self, at: [usize; 2], d: usize) -> [Option<[usize; 2]>; 2] {
        let (across, size) = (1 - d, self.quads());
        if at[d] >= size[d] || at[across] >= self.size()[across] {
            return [None; 2];
        }
        let k = at[across];
        let before = k.checked_sub(1).or(self.closed()[across].then(|| size[across] - 1));
        [before, (k < size[across]).then_some(k)].map(|k| {
            k.map(|k| {
                let mut quad = at;
                quad[across] = k;
                quad
            })
        })
    }

    /// Whether the quads before and after the edge from a vertex along direction `d` have patches.
    pub fn patches_beside(&self, at: [usize; 2], d: usize) -> [bool; 2] {
        self.beside(at, d).map(|quad| quad.is_some_and(|[i, j]| self.cell(i, j) == GridCell::Patch))
    }

    /// Whether the edge from a vertex along direction `d` is a side of a quad of the grid.
    pub fn has_edge(&self, at: [usize; 2], d: usize) -> bool {
        self.beside(at, d).into_iter().flatten().any(|[i, j]| self.has_quad(i, j))
    }

    /// Whether the edge is a side of one quad of the grid alone.
    pub fn is_border_edge(&self, at: [usize; 2], d: usize) -> bool {
        self.beside(at, d).into_iter().flatten().filter(|[i, j]| self.has_quad(*i, *j)).count() == 1
    }

    /// Whether each vertex is a corner of a quad of the grid.
    pub fn used_vertices(&self) -> Vec<bool> {
        let mut used = vec![self.is_whole(); self.points().len()];
        if !self.is_whole() {
            self.all_quads().for_each(|[i, j]| self.corners(i, j).into_iter().for_each(|k| used[k] = true));
        }
        used
    }

    /// The vertices on the border of the grid; of one that is not whole, those of the border in steps.
    pub fn border_vertices(&self) -> Vec<usize> {
        let [m, n] = self.size();
        let mut border = vec![false; m * n];
        for at in (0..n).flat_map(|j| (0..m).map(move |i| [i, j])) {
            for d in (0..2).filter(|d| self.is_border_edge(at, *d)) {
                border[self.index(at[0], at[1])] = true;
                border[self.index(at[0] + 1 - d, at[1] + d)] = true;
            }
        }
        (0..m * n).filter(|k| border[*k]).collect()
    }
}

fn quads([m, n]: [usize; 2]) -> impl Iterator<Item = [usize; 2]> {
    (0..n).flat_map(move |j| (0..m).map(move |i| [i, j]))
}

/// What is wrong with cells that shall be one piece, and where.
fn fault(kept: &[bool], [m, n]: [usize; 2]) -> Option<(GridCellFault, usize)> {
    let Some(first) = kept.iter().position(|kept| *kept) else { return Some((GridCellFault::None, 0)) };
    let reached = flooded(kept, [m, n], first);
    if let Some(apart) = (0..m * n).find(|k| kept[*k] && !reached[*k]) {
        return Some((GridCellFault::Apart, apart));
    }
    // The four quads round every inner vertex.
    for k in (1..n).flat_map(|j| (1..m).map(move |i| i + j * m)) {
        let around = [k - m - 1, k - m, k - 1, k].map(|k| kept[k]);
        if around == [true, false, false, true] || around == [false, true, true, false] {
            return Some((GridCellFault::Corner, if kept[k] { k } else { k - 1 }));
        }
    }
    None
}

/// A cell that is outside although the grid goes all round it.
fn enclosed(outside: &[bool], [m, n]: [usize; 2]) -> Option<usize> {
    let on_border = |k: usize| k.is_multiple_of(m) || k % m == m - 1 || k / m == 0 || k / m == n - 1;
    let mut free = vec![false; m * n];
    for k in (0..m * n).filter(|k| on_border(*k) && outside[*k]) {
        if !free[k] {
            free.iter_mut().zip(flooded(outside, [m, n], k)).for_each(|(free, reached)| *free |= reached);
        }
    }
    (0..m * n).find(|k| outside[*k] && !free[*k])
}

/// The places beside one of a rectangle.
pub fn beside(k: usize, [m, n]: [usize; 2]) -> impl Iterator<Item = usize> {
    let (i, j) = (k % m, k / m);
    let next = [(i > 0, k.wrapping_sub(1)), (i + 1 < m, k + 1), (j > 0, k.wrapping_sub(m)), (j + 1 < n, k + m)];
    next.into_iter().filter(|(exists, _)| *exists).map(|(_, next)| next)
}

/// The cells of a kind to which there is a way from one of them.
pub fn flooded(kind: &[bool], [m, n]: [usize; 2], first: usize) -> Vec<bool> {
    let mut reached = vec![false; m * n];
    let mut open = vec![first];
    reached[first] = true;
    while let Some(k) = open.pop() {
        for next in beside(k, [m, n]) {
            if kind[next] && !std::mem::replace(&mut reached[next], true) {
                open.push(next);
            }
        }
    }
    reached
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;

    /// The grid whose quads are drawn, the first row at the bottom: `#` a patch, `o` an opening.
    fn drawn(rows: &[&str]) -> Result<QuadGrid> {
        let [m, n] = [rows[0].len(), rows.len()];
        let points = (0..(m + 1) * (n + 1)).map(|k| Point3::new((k % (m + 1)) as f64, (k / (m + 1)) as f64, 0.0));
        QuadGrid::new(points.collect(), [m + 1, n + 1], [false; 2])?.with_cells(|i, j| {
            match rows[n - 1 - j].as_bytes()[i] {
                b'#' => GridCell::Patch,
                b'o' => GridCell::Opening,
                _ => GridCell::Outside,
            }
        })
    }

    fn unfit(rows: &[&str]) -> (GridCellFault, usize) {
        match drawn(rows) {
            Err(Error::Grid(GridError::CellsUnfit { fault, index })) => (fault, index),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn one_piece_round_nothing() {
        assert!(drawn(&["##.", "###", ".##"]).is_ok());
        assert!(drawn(&["####", "#oo#", "####"]).is_ok());
        assert!(drawn(&["##", "##"]).unwrap().is_whole());
        assert_eq!(unfit(&["...", "..."]), (GridCellFault::None, 0));
        assert_eq!(unfit(&["##.##", "##.##"]), (GridCellFault::Apart, 3));
        assert_eq!(unfit(&["###", "#.#", "###"]), (GridCellFault::Enclosed, 4));
        assert_eq!(unfit(&["##.", "#.#", "###"]), (GridCellFault::Corner, 7));
        // Patches that meet in a corner between two openings.
        assert_eq!(unfit(&["####", "#o##", "##o#", "####"]).0, GridCellFault::Corner);
    }

    #[test]
    fn edges_and_borders() {
        let grid = drawn(&["#..", "#o#", "###"]).unwrap();
        assert!(grid.has_edge([1, 2], 0) && !grid.has_edge([2, 3], 0) && !grid.has_edge([3, 0], 0));
        assert_eq!(grid.patches_beside([1, 1], 0), [true, false]);
        assert!(grid.is_border_edge([1, 2], 0) && !grid.is_border_edge([1, 1], 0));
        let inner: Vec<usize> = (0..16).filter(|k| !grid.border_vertices().contains(k)).collect();
        // Vertices (1, 1) and (2, 1), and the two that no quad has.
        assert_eq!(inner, [5, 6, 14, 15]);
        assert_eq!(grid.used_vertices().iter().filter(|used| **used).count(), 14);
    }
}
