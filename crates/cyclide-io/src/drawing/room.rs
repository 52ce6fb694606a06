//! Which places of a drawing are taken by curves and combs.

use cyclide::{Point3, Vec3};
use std::collections::HashMap;

/// Cells along the drawing.
const CELLS: f64 = 220.0;
/// A tooth may pass through a curve that is this near to its own foot, and through a comb, cells.
const NEAR: f64 = 2.0;
const TOUCHING: f64 = 1.0;
/// Teeth may be this much longer before they meet another curve: it has teeth of its own.
const HALF_WAY: f64 = 1.8;

/// The cells that a comb takes, with the curve it belongs to.
pub(super) type Taken = HashMap<(i64, i64), usize>;

/// A coarse map of a drawing.
#[derive(Clone)]
pub(super) struct Room {
    axes: [Vec3; 2],
    cell: f64,
    /// The curves that pass through a cell.
    curves: HashMap<(i64, i64), Vec<usize>>,
    combs: Taken,
}

impl Room {
    pub(super) fn new(size: f64, axes: [Vec3; 2]) -> Self {
        Self { axes, cell: size / CELLS, curves: HashMap::new(), combs: HashMap::new() }
    }

    fn flat(&self, p: Point3) -> (f64, f64) {
        let [x, y] = self.axes.map(|axis| p.to_vec().dot(axis) / self.cell);
        (x, y)
    }

    /// The cells between two places, and how far each is from the first one, in cells.
    fn cells(from: (f64, f64), to: (f64, f64)) -> impl Iterator<Item = ((i64, i64), f64)> {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = dx.hypot(dy);
        let steps = (1.5 * length).ceil().clamp(1.0, 4.0 * CELLS);
        (0..=steps as usize).map(move |i| {
            let part = i as f64 / steps;
            let (x, y) = (from.0 + dx * part, from.1 + dy * part);
            ((x.floor() as i64, y.floor() as i64), length * part)
        })
    }

    /// A curve through points of it that follow each other.
    pub(super) fn add_curve(&mut self, curve: usize, points: impl Iterator<Item = Point3>) {
        let mut last: Option<(f64, f64)> = None;
        for p in points {
            let p = self.flat(p);
            for (cell, _) in Self::cells(last.unwrap_or(p), p) {
                let owners = self.curves.entry(cell).or_default();
                if owners.last() != Some(&curve) {
                    owners.push(curve);
                }
            }
            last = Some(p);
        }
    }

    /// True if another curve passes through a cell, and this one not even near: one that runs along it is not hidden by
    /// its comb any more than itself.
    fn is_of_other(&self, curve: usize, (x, y): (i64, i64)) -> bool {
        let owners = |dx: i64, dy: i64| self.curves.get(&(x + dx, y + dy)).map_or(&[][..], Vec::as_slice);
        let near = |curve: usize| (-1..=1).any(|dx| (-1..=1).any(|dy| owners(dx, dy).contains(&curve)));
        owners(0, 0).iter().any(|owner| *owner != curve) && !near(curve)
    }

    /// Teeth to be tried, against other combs and, if asked for, other curves.
    pub(super) fn trial(&self, curves_too: bool) -> Trial<'_> {
        Trial { room: self, curves_too, taken: HashMap::new(), teeth: 0, hits: 0 }
    }

    /// The cells that tried teeth take.
    pub(super) fn keep(&mut self, taken: Taken) {
        for (cell, curve) in taken {
            self.combs.entry(cell).or_insert(curve);
        }
    }
}

/// Teeth that are tried.
pub(super) struct Trial<'a> {
    room: &'a Room,
    curves_too: bool,
    taken: Taken,
    teeth: usize,
    hits: usize,
}

impl Trial<'_> {
    /// A tooth of a curve.
    pub(super) fn add(&mut self, curve: usize, foot: Point3, tip: Point3) {
        let (foot, tip) = (self.room.flat(foot), self.room.flat(tip));
        let mut hit = false;
        let other = |owner: Option<&usize>| owner.is_some_and(|o| *o != curve);
        for (cell, distance) in Room::cells(foot, tip) {
            hit |= distance > TOUCHING && other(self.room.combs.get(&cell));
            // Contours of one object may touch each other, and their combs with them.
            hit |= distance > NEAR && other(self.taken.get(&cell));
            self.taken.entry(cell).or_insert(curve);
        }
        if self.curves_too {
            let beyond = (foot.0 + HALF_WAY * (tip.0 - foot.0), foot.1 + HALF_WAY * (tip.1 - foot.1));
            hit |=
                Room::cells(foot, beyond).any(|(cell, distance)| distance > NEAR && self.room.is_of_other(curve, cell));
        }
        self.teeth += 1;
        self.hits += usize::from(hit);
    }

    /// The part of the teeth that are in the way of something, and the cells that all of them take.
    pub(super) fn finish(self) -> (f64, Taken) {
        (self.hits as f64 / self.teeth.max(1) as f64, self.taken)
    }
}
