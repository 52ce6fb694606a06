//! A lattice of points at equal steps of the coordinates, found by walking from point to point, and its cells.

use std::collections::{HashMap, VecDeque};

use super::rectangles::{Rectangle, largest, longest_band};
use super::staircase;
use super::walker::{Place, Walker};
use cyclide::surface::GridCell;

/// Cells along each side of a piece at least.
pub(super) const LEAST_CELLS: usize = 3;
/// Points closer than this part of a step are the same.
const SAME: f64 = 1e-6;
/// Cells of the box of all points at most: sheets lie over each other a few times, not without end.
const MOST_BOX: i64 = 8_000_000;

/// Points by their place in the lattice.
pub(super) struct Lattice<'a> {
    walker: &'a Walker<'a>,
    /// Lengths of the steps along both coordinates.
    steps: [f64; 2],
    /// Columns after which the first coordinate comes back.
    columns: Option<i64>,
    places: HashMap<[i64; 2], Place>,
    /// Edges from a point along s and along t that hold.
    edges: HashMap<[i64; 2], [bool; 2]>,
    lowest: [i64; 2],
    highest: [i64; 2],
}

/// A rectangle of cells with all corners, or one round a grid in steps.
pub(super) struct Piece {
    /// `None` where a grid in steps has no point.
    pub(super) places: Vec<Option<Place>>,
    /// Points along s and t.
    pub(super) size: [usize; 2],
    pub(super) closed: bool,
    /// Cells on the surface.
    pub(super) count: usize,
    /// What each cell of a grid in steps is.
    pub(super) cells: Option<Vec<GridCell>>,
}

impl<'a> Lattice<'a> {
    /// The points that walks reach from one near the middle of a triangle; `None` if there is none.
    pub(super) fn new(
        walker: &'a Walker<'a>,
        seed: usize,
        steps: [f64; 2],
        phase: [f64; 2],
        columns: Option<i64>,
    ) -> Option<Self> {
        let middle = walker.middle(seed);
        let number = [0, 1].map(|d| ((middle.at[d] - phase[d]) / steps[d]).floor());
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
        let first = corners.into_iter().find_map(|corner| {
            let way = [0, 1].map(|d| phase[d] + (number[d] + corner[d]) * steps[d] - middle.at[d]);
            walker.walk(middle, way)
        })?;
        let mut lattice = Self {
            walker,
            steps,
            columns,
            places: HashMap::from([([0, 0], first)]),
            edges: HashMap::new(),
            lowest: [0; 2],
            highest: [0; 2],
        };
        lattice.spread();
        Some(lattice)
    }

    fn spread(&mut self) {
        let mut queue: VecDeque<[i64; 2]> = VecDeque::from([[0, 0]]);
        while let Some(at) = queue.pop_front() {
            for (d, sign) in [(0, 1), (0, -1), (1, 1), (1, -1)] {
                let mut to = at;
                to[d] += sign;
                if let (0, Some(columns)) = (d, self.columns) {
                    to[0] = to[0].rem_euclid(columns);
                }
                let start = if sign > 0 { at } else { to };
                if self.edges.get(&start).is_some_and(|edges| edges[d]) {
                    continue;
                }
                let mut step = [0.0; 2];
                step[d] = sign as f64 * self.steps[d];
                let Some(end) = self.walker.walk(self.places[&at], step) else { continue };
                match self.places.get(&to) {
                    Some(known) if !self.same(*known, end) => continue,
                    Some(_) => {}
                    None => {
                        let low = [0, 1].map(|d| self.lowest[d].min(to[d]));
                        let high = [0, 1].map(|d| self.highest[d].max(to[d]));
                        if (high[0] - low[0] + 1) * (high[1] - low[1] + 1) > MOST_BOX {
                            continue;
                        }
                        (self.lowest, self.highest) = (low, high);
                        self.places.insert(to, end);
                        queue.push_back(to);
                    }
                }
                self.edges.entry(start).or_default()[d] = true;
            }
        }
    }

    /// True if two places are one: on one triangle, or on two between which there is no way.
    fn same(&self, a: Place, b: Place) -> bool {
        if a.face == b.face {
            return (0..2).all(|d| (a.at[d] - b.at[d]).abs() <= SAME * self.steps[d].abs());
        }
        // On an edge, or at a corner: the points of space agree.
        let [p, q] = [a, b].map(|place| self.walker.flat_point(place));
        p.distance(q) <= SAME * self.steps[0].abs().max(self.steps[1].abs())
    }

    /// Points found.
    pub(super) fn count(&self) -> usize {
        self.places.len()
    }

    pub(super) fn is_closed(&self) -> bool {
        self.columns.is_some()
    }

    /// The box of all points, with rings beyond it (not round a lattice that closes), and the place of each point that was found, s
    /// fastest; `None` if it has more points than `most`, or no cell.
    pub(super) fn boxed(&self, rings: i64, most: usize) -> Option<([usize; 2], Vec<Option<Place>>)> {
        let (mut low, mut high) = (self.lowest.map(|n| n - rings), self.highest.map(|n| n + rings));
        if let Some(columns) = self.columns {
            (low[0], high[0]) = (0, columns - 1);
        }
        let size = [0, 1].map(|d| usize::try_from(high[d] - low[d] + 1).unwrap_or(0));
        if size.iter().any(|n| *n < LEAST_CELLS) || size[0].saturating_mul(size[1]) > most {
            return None;
        }
        let points = (low[1]..=high[1]).flat_map(|j| (low[0]..=high[0]).map(move |i| [i, j]));
        Some((size, points.map(|at| self.places.get(&at).copied()).collect()))
    }

    fn holds(&self, at: [i64; 2], d: usize) -> bool {
        self.edges.get(&at).is_some_and(|edges| edges[d])
    }

    fn wrapped(&self, x: i64) -> i64 {
        self.columns.map_or(x, |columns| x.rem_euclid(columns))
    }

    /// The box of all cells: its first one, its columns, and of every cell, row by row, whether its four edges hold.
    fn valid_cells(&self) -> ([i64; 2], usize, Vec<bool>) {
        let low = [if self.columns.is_some() { 0 } else { self.lowest[0] }, self.lowest[1]];
        let across = self.columns.map_or(self.highest[0] - low[0], |columns| columns);
        let [columns, rows] = [across, self.highest[1] - low[1]].map(|n| n.max(0) as usize);
        let mut valid = Vec::with_capacity(columns * rows);
        for (j, i) in (0..rows as i64).flat_map(|j| (0..columns as i64).map(move |i| (j, i))) {
            let at = [low[0] + i, low[1] + j];
            let right = [self.wrapped(at[0] + 1), at[1]];
            valid.push(
                self.holds(at, 0) && self.holds(at, 1) && self.holds([at[0], at[1] + 1], 0) && self.holds(right, 1),
            );
        }
        (low, columns, valid)
    }

    /// The largest rectangle of cells whose four edges hold; of a lattice that comes back all round, if there is such a band.
    pub(super) fn largest_piece(&self) -> Option<Piece> {
        let (low, columns, valid) = self.valid_cells();
        let band = self.columns.and_then(|_| longest_band(&valid, columns, LEAST_CELLS));
        let closed = band.is_some();
        let Rectangle { from, size } = band.or_else(|| largest(&valid, columns, LEAST_CELLS))?;
        let points = [size[0] + usize::from(!closed), size[1] + 1];
        let mut places = Vec::with_capacity(points[0] * points[1]);
        for (j, i) in (0..points[1]).flat_map(|j| (0..points[0]).map(move |i| (j, i))) {
            let at = [self.wrapped(low[0] + (from[0] + i) as i64), low[1] + (from[1] + j) as i64];
            places.push(Some(*self.places.get(&at)?));
        }
        Some(Piece { places, size: points, closed, count: size[0] * size[1], cells: None })
    }

    /// All cells that hang together round the largest rectangle of them; of a lattice that comes back only a band, which has no steps.
    pub(super) fn piece_in_steps(&self) -> Option<Piece> {
        if self.is_closed() {
            return self.largest_piece();
        }
        let (low, columns, valid) = self.valid_cells();
        let all = staircase::piece(&valid, [columns, valid.len() / columns.max(1)], LEAST_CELLS)?;
        // The box of what is left.
        let inside: Vec<[usize; 2]> =
            (0..all.len()).filter(|k| all[*k] != GridCell::Outside).map(|k| [k % columns, k / columns]).collect();
        let [from, to] = [0, 1].map(|end| {
            [0, 1].map(|d| {
                let along = inside.iter().map(|cell| cell[d]);
                if end == 0 { along.min() } else { along.max() }.unwrap_or(0)
            })
        });
        let cells: Vec<GridCell> =
            (from[1]..=to[1]).flat_map(|j| (from[0]..=to[0]).map(move |i| i + j * columns)).map(|k| all[k]).collect();
        let count = cells.iter().filter(|cell| **cell == GridCell::Patch).count();
        let size = [0, 1].map(|d| to[d] - from[d] + 2);
        let at = |i: usize, j: usize| [low[0] + (from[0] + i) as i64, low[1] + (from[1] + j) as i64];
        let places = (0..size[1]).flat_map(|j| (0..size[0]).map(move |i| (i, j)));
        let places = places.map(|(i, j)| self.places.get(&at(i, j)).copied()).collect();
        Some(Piece { places, size, closed: false, count, cells: Some(cells) })
    }
}
