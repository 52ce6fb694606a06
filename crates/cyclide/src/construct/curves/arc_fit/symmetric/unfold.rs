//! The whole path of the pieces between two axes and their mirror images (`docs/math/arc-fitting.md#symmetry`).

use super::Symmetric;
use super::axes::{Flat, Sector};
use crate::base::planar::{Point2, Vec2};
use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::piece::{Piece, Place, Span};
use crate::curve::Arc;
use std::ops::Range;

/// Where a point is kept exactly and its mirror image is this part of a piece off it, the piece is bent to it.
const EXACT: f64 = 1e-9;
/// A bulge whose arc, with its mirror image, turns by 340 degrees.
const LARGEST_BULGE: f64 = 0.916;

/// A piece in the plane, and the places on the trace between which it stands.
#[derive(Clone, Copy)]
struct Bow {
    ends: [Point2; 2],
    bulge: f64,
    places: [f64; 2],
}

impl Flat<'_> {
    /// The whole path of a sector and its mirror images.
    pub(super) fn unfolded(&self, sector: &Sector, pieces: &[Piece]) -> Option<Vec<Piece>> {
        let Symmetric { trace, frame, .. } = self.symmetric;
        let Range { start, end } = sector.places;
        let bow = |piece: &Piece| Bow {
            ends: [piece.arc.start(), piece.arc.end()].map(|p| frame.to_local(p).0),
            bulge: piece.arc.bulge_vector().dot(frame.z()),
            places: [piece.span.from.along(), piece.span.to.along()],
        };
        let bows: Vec<Bow> = pieces.iter().map(bow).collect();
        let [first, second] = sector.normals;
        let mut whole: Vec<Bow> = Vec::new();
        let mirror = |sum: usize, normal: Vec2| -> Vec<Bow> {
            bows.iter().rev().map(|bow| bow.mirrored(sum as f64, |p| self.mirrored(p, normal))).collect()
        };
        if !trace.closed {
            let middle = self.points.len() - 1;
            let image = mirror(middle, first);
            let [before, behind] = if start == 0 { [&bows, &image] } else { [&image, &bows] };
            whole.extend(before);
            self.join(&mut whole, behind, middle)?;
        } else {
            let reach = end - start;
            let image = mirror(end, second);
            let pair = |turned: usize| -> [Vec<Bow>; 2] {
                let turn = |p: Point2| (0..turned).fold(p, |p, _| self.mirrored(self.mirrored(p, first), second));
                [&bows, &image].map(|copy| copy.iter().map(|bow| bow.moved((turned * reach) as f64, turn)).collect())
            };
            for turned in 0..self.points.len() / reach {
                let [copy, image] = pair(turned);
                self.join(&mut whole, &copy, start)?;
                self.join(&mut whole, &image, end)?;
            }
            // The last meets the first.
            if !self.symmetric.is_corner(start) {
                let first = whole.remove(0);
                let last = whole.pop()?;
                whole.push(last.with(&first.moved(self.points.len() as f64, |p| p))?);
            }
        }
        self.arcs(&whole)
    }

    /// Adds bows behind others; at an axis the two there are one.
    fn join(&self, whole: &mut Vec<Bow>, more: &[Bow], half: usize) -> Option<()> {
        match (whole.last_mut(), more) {
            (Some(last), [next, rest @ ..]) if !self.symmetric.is_corner(half) => {
                *last = last.with(next)?;
                whole.extend(rest);
            }
            _ => whole.extend(more),
        }
        Some(())
    }

    /// Bows as pieces that share their joints, and keep corners and ends exactly.
    fn arcs(&self, bows: &[Bow]) -> Option<Vec<Piece>> {
        let Symmetric { trace, frame, .. } = self.symmetric;
        let kept = |place: f64| {
            Some((2.0 * place) as usize).filter(|half| (2.0 * place).fract() == 0.0 && self.symmetric.is_kept(*half))
        };
        let joint = |p: Point2, place: f64| -> Point3 {
            kept(place).map_or_else(|| frame.to_world(p), |half| trace.point(half / 2))
        };
        let count = bows.len();
        let piece = |i: usize| {
            let (bow, next) = (&bows[i], &bows[(i + 1) % count]);
            let from = joint(bow.ends[0], bow.places[0]);
            let to = if i + 1 == count && !trace.closed {
                joint(bow.ends[1], bow.places[1])
            } else {
                joint(next.ends[0], next.places[0])
            };
            let span = Span { from: place(bow.places[0]), to: place(bow.places[1]) };
            let smooth = kept(bow.places[0]).is_none() && (trace.closed || i > 0);
            let arc = self.between(bow, [from, to])?;
            Some(Piece { arc, span, smooth })
        };
        (0..count).map(piece).collect()
    }

    /// The arc of a bow with its ends where they are kept: with the tangent that it has at the other.
    fn between(&self, bow: &Bow, [from, to]: [Point3; 2]) -> Option<Arc> {
        let frame = self.symmetric.frame;
        let ends = bow.ends.map(|p| frame.to_world(p));
        let arc = Arc::from_bulge(from, to, frame.z(), bow.bulge).ok()?;
        let exact = EXACT * from.distance(to);
        match [from.distance(ends[0]) <= exact, to.distance(ends[1]) <= exact] {
            [false, true] | [true, false] if bow.bulge == 0.0 => None,
            [true, false] => {
                let tangent = Arc::from_bulge(ends[0], ends[1], frame.z(), bow.bulge).ok()?.start_tangent()?;
                Arc::from_start_tangent(from, to, tangent * from.distance(to)).ok()
            }
            [false, true] => {
                let tangent = Arc::from_bulge(ends[0], ends[1], frame.z(), bow.bulge).ok()?.end_tangent()?;
                Arc::from_end_tangent(from, to, tangent * from.distance(to)).ok()
            }
            _ => Some(arc),
        }
    }
}

fn place(along: f64) -> Place {
    Place { index: along as usize, fraction: along.fract() }
}

impl Bow {
    /// The mirror image, which runs the other way: places go to what is left of a sum.
    fn mirrored(&self, sum: f64, image: impl Fn(Point2) -> Point2) -> Self {
        let [from, to] = self.ends.map(image);
        Self { ends: [to, from], places: [sum - self.places[1], sum - self.places[0]], ..*self }
    }

    fn moved(&self, places: f64, image: impl Fn(Point2) -> Point2) -> Self {
        Self { ends: self.ends.map(image), places: self.places.map(|place| place + places), ..*self }
    }

    /// One arc of this and its mirror image behind it.
    fn with(&self, next: &Self) -> Option<Self> {
        let bulge = 2.0 * self.bulge / (1.0 - self.bulge * self.bulge);
        let one = Self { ends: [self.ends[0], next.ends[1]], bulge, places: [self.places[0], next.places[1]] };
        (self.bulge.abs() <= LARGEST_BULGE).then_some(one)
    }
}
