//! A stretch of a pipe with holes beside each other: rows of holes along the pipe, each between two lines of its own, and strips between the rows
//! (`docs/math/pipe-tees.md#branches-beside-each-other`).

use super::lines::{Hole, RuledSide};
use super::mantle::{Mantle, between, half};
use super::rail::{Pairing, Rail};
use super::skin::{Ring, Skin};
use crate::error::{PointError, Result};
use std::f64::consts::{PI, TAU};

/// Angle from the middle of a hole to the lines behind it, for one that goes so far round to either side: both arcs to them and the arc between them are of a third of a
/// turn at most, or the lines are a third of the way behind it.
fn behind(reach: f64) -> f64 {
    (TAU / 3.0).max(reach + (PI - reach) / 3.0)
}

/// Holes one behind the other along a pipe.
pub(in crate::construct::bodies) struct HoleRow {
    /// From low places to high ones, with the angles by which their axes are turned from those of the pipe, on the sheet of the lines.
    pub(in crate::construct::bodies) holes: Vec<(Hole, f64)>,
    /// The angles of the lines beside the row, high and low, in the axes of the pipe.
    pub(in crate::construct::bodies) lines: [f64; 2],
}

/// A row that has been sewn, in the axes of the pipe.
struct SewnRow {
    /// Open, at both ends of the stretch.
    rings: [Ring; 2],
    /// At high angles and at low ones.
    lines: [Rail; 2],
}

impl Skin<'_> {
    /// The stretch of a pipe round a hole, with the rings at its ends.
    ///
    /// # Errors
    /// As [`RationalBezierSurface::new`](crate::rational::RationalBezierSurface::new).
    pub(in crate::construct::bodies) fn stretch(&mut self, hole: Hole) -> Result<[Ring; 2]> {
        let [middle, reach] = hole.breadth();
        let (mantle, behind) = (hole.mantle, behind(reach));
        let row = HoleRow { holes: vec![(hole, 0.0)], lines: [middle + behind, middle - behind] };
        self.rows(&mantle, &[row], Pairing::NodeByNode)
    }

    /// The stretch of a pipe with rows of holes, in the order of their angles, and the rings at its ends.
    ///
    /// # Errors
    /// As [`RationalBezierSurface::new`](crate::rational::RationalBezierSurface::new).
    pub(in crate::construct::bodies) fn rows(
        &mut self,
        mantle: &Mantle,
        rows: &[HoleRow],
        pairing: Pairing,
    ) -> Result<[Ring; 2]> {
        let sewn = rows.iter().map(|row| self.row(mantle, row)).collect::<Result<Vec<_>>>()?;
        let mut rings = [Ring::default(), Ring::default()];
        for (k, row) in sewn.iter().enumerate() {
            let next = match sewn.get(k + 1) {
                Some(next) => next.lines[1].clone(),
                None => sewn[0].lines[1].clone().turned(TAU),
            };
            let edges = self.between_rails(mantle, [&row.lines[0], &next], pairing)?;
            for (side, ring) in rings.iter_mut().enumerate() {
                let [from, to] = [&row.lines[0], &next].map(|line| line.end(side == 1).1);
                ring.extend(&row.rings[side]);
                ring.edges.push(edges[side]);
                ring.along.push(between([from, to]));
            }
        }
        Ok(rings)
    }

    fn row(&mut self, mantle: &Mantle, row: &HoleRow) -> Result<SewnRow> {
        let mut sewn: Option<SewnRow> = None;
        for (hole, turn) in &row.holes {
            let part = self.round_hole(hole, row.lines.map(|angle| angle - turn))?;
            let next = SewnRow {
                rings: part.rings.map(|ring| ring.turned(*turn)),
                lines: part.lines.map(|line| line.turned(*turn)),
            };
            sewn = Some(match sewn {
                Some(before) => self.behind_each_other(mantle, before, next)?,
                None => next,
            });
        }
        sewn.ok_or(crate::error::Error::Point(PointError::TooFewPoints { given: 0, needed: 1 }))
    }

    /// Two parts of a row with what is between them.
    fn behind_each_other(&mut self, mantle: &Mantle, before: SewnRow, next: SewnRow) -> Result<SewnRow> {
        let ([start, end], [beyond, last]) = (before.rings, next.rings);
        let place = |skin: &Self, ring: &Ring| mantle.place(skin.sewing.vertices[ring.vertices[0]]);
        let end = Rail::of_part(&end, place(self, &end), None);
        let beyond = Rail::of_part(&beyond, place(self, &beyond), Some(end.first_angle()));
        let [low, high] = self.between_rails(mantle, [&end, &beyond], Pairing::Nearest)?;
        let ([high_line, low_line], [high_beyond, low_beyond]) = (before.lines, next.lines);
        let lines = [high_line.followed_by(high, high_beyond), low_line.followed_by(low, low_beyond)];
        Ok(SewnRow { rings: [start, last], lines })
    }

    /// The stretch of a pipe with two holes, each half way round it, that share their outermost nodes: all of it is ruled to its ends.
    ///
    /// # Errors
    /// As [`RationalBezierSurface::new`](crate::rational::RationalBezierSurface::new).
    pub(in crate::construct::bodies) fn between_halves(&mut self, holes: [&Hole; 2]) -> Result<[Ring; 2]> {
        let [start, end] = [0, 1].map(|side: usize| -> Result<Ring> {
            let outermost = |side: &RuledSide, k: usize| (side.ring.vertices[k], side.rulings[k]);
            let first = self.ruled_side(holes[0], side, [None; 2])?;
            let known = [outermost(&first, first.rulings.len() - 1), outermost(&first, 0)];
            let second = self.ruled_side(holes[1], side, known.map(Some))?;
            let turn = holes[0].mantle.angle_of(holes[1].mantle.up);
            let mut ring = first.ring;
            ring.drop_last();
            let mut other = second.ring.turned(turn);
            other.drop_last();
            ring.extend(&other);
            Ok(ring)
        });
        Ok([start?, end?])
    }

    /// Joins the ring at the end of one stretch with that at the start of the next, whose axes are turned by an angle.
    ///
    /// # Errors
    /// As [`RationalBezierSurface::new`](crate::rational::RationalBezierSurface::new).
    pub(in crate::construct::bodies) fn join(
        &mut self,
        mantle: &Mantle,
        from: &Ring,
        to: &Ring,
        turn: f64,
    ) -> Result<()> {
        let place = |skin: &Self, ring: &Ring| mantle.place(skin.sewing.vertices[ring.vertices[0]]);
        let first = Rail::of_part(&from.opened(None), place(self, from), None);
        let near = Some(first.first_angle());
        let second = Rail::of_part(&to.clone().turned(turn).opened(near), place(self, to), near);
        self.between_rails(mantle, [&first, &second], Pairing::Nearest)?;
        Ok(())
    }
}

/// A half direction turned by an angle.
fn turned(angle: f64, [c, s]: [f64; 2]) -> [f64; 2] {
    let [cos, sin] = half(angle);
    [c * cos - s * sin, s * cos + c * sin]
}

impl Ring {
    /// Angles of the vertices, each on any sheet.
    pub(super) fn angles(&self) -> impl Iterator<Item = f64> + '_ {
        self.halves.iter().map(|[c, s]| 2.0 * s.atan2(*c))
    }

    /// In axes from which its own are turned by an angle.
    fn turned(mut self, angle: f64) -> Self {
        if angle == 0.0 {
            return self;
        }
        let [cos, sin] = half(angle);
        for own in &mut self.halves {
            *own = turned(angle, *own);
        }
        for [c, s] in &mut self.along {
            (*c, *s) = (&(&*c * cos) + &(&*s * -sin), &(&*s * cos) + &(&*c * sin));
        }
        self
    }

    /// From the vertex nearest to an angle, or from its first one, once round and back to it.
    fn opened(&self, near: Option<f64>) -> Self {
        let off = |angle: f64| near.map_or(0.0, |near| (angle - near - TAU * ((angle - near) / TAU).round()).abs());
        let offs: Vec<f64> = self.angles().map(off).collect();
        let first = (1..offs.len()).fold(0, |best, k| if offs[k] < offs[best] { k } else { best });
        let mut open = self.clone();
        open.vertices.rotate_left(first);
        open.edges.rotate_left(first);
        open.halves.rotate_left(first);
        open.along.rotate_left(first);
        open.vertices.push(open.vertices[0]);
        open.halves.push(open.halves[0]);
        open
    }

    /// Goes on with another part.
    fn extend(&mut self, other: &Self) {
        self.vertices.extend(&other.vertices);
        self.edges.extend(&other.edges);
        self.halves.extend(&other.halves);
        self.along.extend(other.along.iter().cloned());
    }

    fn drop_last(&mut self) {
        self.vertices.pop();
        self.halves.pop();
    }
}
