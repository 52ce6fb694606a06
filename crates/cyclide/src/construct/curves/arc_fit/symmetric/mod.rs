//! Symmetric data get symmetric arcs: the chain over the part of a trace between two neighboring axes of symmetry, which it
//! crosses at right angles, and its mirror images (`docs/math/arc-fitting.md#symmetry`).

mod axes;
mod sector;
mod unfold;

use super::certificate::certify;
use super::options::{ArcFitOptions, Effort};
use super::piece::Piece;
use super::trace::Trace;
use crate::base::frame::Frame;
use crate::base::planar::{Point2, Vec2};
use axes::{Flat, Sector};

/// A symmetric path may have one piece in so many more, and one: its count is even, or odd, whether or not that is the least.
const MORE: usize = 10;
/// It is at most so many times as far from the points as another, or this part of the tolerance.
const FARTHER: f64 = 2.0;
const ENOUGH: f64 = 0.5;
/// Paths of fewer pieces are as symmetric as their points.
const FEWEST: usize = 3;

/// A trace with axes of symmetry and what is wanted over it.
pub(super) struct Symmetric<'a> {
    pub trace: &'a Trace,
    /// Places on the trace.
    pub corners: Vec<usize>,
    pub frame: &'a Frame,
    pub tolerance: f64,
    pub options: &'a ArcFitOptions,
    pub effort: Effort,
}

impl Symmetric<'_> {
    /// The path over the whole trace that is as symmetric as its points: with all their axes, else with one, and of few more pieces
    /// than another that is not. It must pass a test.
    pub fn path(&self, other: &[Piece], passes: impl Fn(&[Piece]) -> bool) -> Option<Vec<Piece>> {
        if other.len() < FEWEST {
            return None;
        }
        let flat: Vec<Point2> = self.trace.points.iter().map(|p| self.frame.to_local(*p).0).collect();
        let sum = flat.iter().fold(Vec2::default(), |sum, p| sum + (*p - flat[0]));
        let center = flat[0] + sum * (1.0 / flat.len() as f64);
        let data = Flat { points: &flat, center, symmetric: self };
        let off = |path: &[Piece]| certify(path, self.trace, self.options.target, true).deviation;
        let all = data.sectors();
        // What is symmetric, except in its joints, gets no more pieces, and its lines stay lines.
        let is_symmetric = all.first().is_some_and(|sectors| data.is_symmetric(other, sectors));
        let most = other.len() + if is_symmetric { 0 } else { other.len() / MORE + 1 };
        let limit = (FARTHER * off(other)).max(ENOUGH * self.tolerance);
        let lines_of = |path: &[Piece]| path.iter().filter(|piece| piece.arc.is_straight()).count();
        let order = |a: &(f64, Vec<Piece>), b: &(f64, Vec<Piece>)| {
            let fewest = a.1.len().cmp(&b.1.len()).then(lines_of(&b.1).cmp(&lines_of(&a.1)));
            fewest.then(a.0.total_cmp(&b.0))
        };
        let fewest_lines = if is_symmetric { lines_of(other) } else { 0 };
        // Of sectors whose pieces are found in a way.
        let best = |sectors: &[Sector], pieces: &dyn Fn(&Sector) -> Option<Vec<Piece>>| {
            let paths = sectors.iter().filter_map(|sector| data.unfolded(sector, &pieces(sector)?));
            let near = paths
                .filter(|path| path.len() <= most && lines_of(path) >= fewest_lines && passes(path))
                .map(|path| (off(&path), path));
            near.filter(|path| path.0 <= limit).min_by(order)
        };
        all.iter().find_map(|sectors| {
            let mut found = best(sectors, &|sector| data.of_path(sector, other));
            for effort in [self.effort, Effort::Best] {
                if found.as_ref().is_some_and(|path| path.1.len() <= other.len()) {
                    break;
                }
                let more = best(sectors, &|sector| data.over(sector, effort));
                found = found.into_iter().chain(more).min_by(order);
            }
            found.map(|path| path.1)
        })
    }

    fn is_corner(&self, half: usize) -> bool {
        half.is_multiple_of(2) && self.corners.binary_search(&(half / 2 % self.trace.points.len())).is_ok()
    }

    /// An end of an open trace or a corner: kept exactly.
    fn is_kept(&self, half: usize) -> bool {
        let last = 2 * (self.trace.points.len() - 1);
        self.is_corner(half) || (!self.trace.closed && (half == 0 || half == last))
    }
}
