//! How far a chain of arcs is from the curve that it stands for, proved (`docs/math/tubes.md#along-a-curve-of-another-kind`).

use crate::base::vector::Point3;
use crate::curve::{Arc, ArcPath, Correspondence, CurvePlace, ParamCurve, PieceForm, PieceHull};
use crate::error::Result;

/// Chords of a part of the curve, at first and at most.
const CHORDS: [usize; 2] = [8, 1 << 17];
/// The part of the limit that may be left open between places.
const OPEN: f64 = 0.1;

/// What is proved of a chain of arcs and a curve: to each point of one belongs a point of the other, in order along both.
#[derive(Debug, Clone, Copy)]
pub(super) struct Beside {
    /// Distance of points that belong together.
    pub(super) distance: f64,
    /// How much farther along one of them is, as part of the whole length; 0 if it was not asked for.
    pub(super) lag: f64,
}

/// A part of the curve within one of its pieces.
struct Part<'a> {
    curve: &'a dyn ParamCurve,
    piece: usize,
    from: f64,
    to: f64,
}

/// The bound for arcs and the parts of the curve that they stand for; infinite where there is no proof. Places are added where more than a tenth of the limit is open
/// between two: a parameter that runs unevenly has them where the way is.
///
/// # Errors
/// `too-many-pieces` (a curve whose hulls need too many parts).
pub(super) fn beside(
    curve: &dyn ParamCurve,
    arcs: &ArcPath,
    parts: &Correspondence,
    limit: f64,
    with_lag: bool,
) -> Result<Beside> {
    let whole = if with_lag { [crate::curve::length(curve), arcs.length()] } else { [1.0, 1.0] };
    let mut found = Beside { distance: 0.0, lag: 0.0 };
    // Lengths of the curve and of the arcs before the part.
    let mut ways = [0.0; 2];
    let (mut start, mut arc) = (parts.start, 0);
    let mut hull: Option<(usize, PieceHull)> = None;
    for span in &parts.spans {
        let own = &arcs.arcs()[arc..arc + span.pieces];
        arc += span.pieces;
        let stretch = parts_between(curve, start, span.end);
        start = span.end;
        let mut lengths = [0.0; 2];
        if with_lag {
            lengths[0] = stretch.iter().map(|p| curve.piece_length(p.piece, p.from, p.to)).sum();
            lengths[1] = own.iter().map(Arc::length).sum();
        }
        let Walked { measured, open, lag } =
            Walk { stretch: &stretch, arcs: own, with_lag }.walked(&mut hull, limit)?;
        found.distance = found.distance.max(measured + open);
        if with_lag {
            // Both ends of the stretch, and what is between them.
            let ahead = |ways: [f64; 2]| (ways[0] / whole[0] - ways[1] / whole[1]).abs();
            let after = [ways[0] + lengths[0], ways[1] + lengths[1]];
            let inner = (lag + (lengths[0] - lengths[1]).abs()) / whole[0].min(whole[1]);
            found.lag = found.lag.max(ahead(ways).max(ahead(after)) + inner);
        }
        ways = [ways[0] + lengths[0], ways[1] + lengths[1]];
        if !(found.distance <= limit) {
            // No need to look farther.
            return Ok(found);
        }
    }
    Ok(found)
}

/// The parts of the pieces between two places.
fn parts_between(curve: &dyn ParamCurve, start: CurvePlace, end: CurvePlace) -> Vec<Part<'_>> {
    let n = curve.piece_count();
    let ends = |piece| (if piece == start.piece { start.s } else { 0.0 }, if piece == end.piece { end.s } else { 1.0 });
    let part = |piece| {
        let (from, to) = ends(piece);
        (from < to).then_some(Part { curve, piece: piece % n, from, to })
    };
    (start.piece..=end.piece).filter_map(part).collect()
}

/// A stretch of the curve beside its arcs.
struct Walk<'a> {
    stretch: &'a [Part<'a>],
    arcs: &'a [Arc],
    with_lag: bool,
}

/// Largest distance at places, what may be more between them, and how much farther along one of two points that belong together may be.
struct Walked {
    measured: f64,
    open: f64,
    lag: f64,
}

const UNPROVED: Walked = Walked { measured: f64::INFINITY, open: 0.0, lag: 0.0 };

impl Walk<'_> {
    /// Chords between places of the curve and between their feet on the arcs: points that divide both alike are as near as their ends, and
    /// curve and arcs are near to the chords.
    fn walked(&self, hull: &mut Option<(usize, PieceHull)>, limit: f64) -> Result<Walked> {
        let (Some(first), Some(last)) = (self.arcs.first(), self.arcs.last()) else { return Ok(UNPROVED) };
        let mut walked = Walked { measured: 0.0, open: 0.0, lag: 0.0 };
        let (mut place, mut foot) = (0.0, first.start());
        let mut way = [0.0_f64; 2];
        for (number, part) in self.stretch.iter().enumerate() {
            let mut before = part.curve.piece_point(part.piece, part.from);
            walked.measured = walked.measured.max(before.distance(foot));
            let at = |k: usize| part.from + (part.to - part.from) * (k as f64 / CHORDS[0] as f64);
            // Ends of chords that are ahead, the next one last.
            let mut ends: Vec<f64> =
                (1..=CHORDS[0]).rev().map(|k| if k == CHORDS[0] { part.to } else { at(k) }).collect();
            let (mut chords, mut from) = (CHORDS[0], part.from);
            while let Some(&to) = ends.last() {
                let s = [from, to];
                let point = part.curve.piece_point(part.piece, to);
                let is_end = number + 1 == self.stretch.len() && ends.len() == 1;
                // Points belong together in any order that rises.
                let next = if is_end { self.arcs.len() as f64 } else { self.foot(point, place, limit) };
                let next_foot = if is_end { last.end() } else { self.point(next) };
                let distance = point.distance(next_foot);
                walked.measured = walked.measured.max(distance);
                if !(distance <= limit) {
                    return Ok(walked);
                }
                let bends = [part.bend(s, [before, point], hull, limit)?, self.bend([place, next], [foot, next_foot])];
                let middle = 0.5 * (from + to);
                if !(bends[0] + bends[1] <= OPEN * limit) && chords < CHORDS[1] && from < middle && middle < to {
                    chords += 1;
                    ends.push(middle);
                    continue;
                }
                walked.open = walked.open.max(bends[0] + bends[1]);
                if self.with_lag {
                    let lengths = [part.curve.piece_length(part.piece, s[0], s[1]), self.length([place, next])];
                    let more = [lengths[0] - before.distance(point), lengths[1] - foot.distance(next_foot)];
                    let ends = (way[0] - way[1]).abs().max((way[0] + lengths[0] - way[1] - lengths[1]).abs());
                    walked.lag =
                        walked.lag.max(ends + 2.0 * (more[0].max(0.0) + more[1].max(0.0)) + bends[0] + bends[1]);
                    way = [way[0] + lengths[0], way[1] + lengths[1]];
                }
                ends.pop();
                (before, place, foot, from) = (point, next, next_foot, to);
            }
        }
        Ok(walked)
    }

    /// Number and parameter of the nearest point of the arcs that is not before a place. From there on they are followed while they come nearer; only if that ends
    /// beyond the limit all are looked at. Any place would do for the proof, and a bad one costs distance.
    fn foot(&self, point: Point3, place: f64, limit: f64) -> f64 {
        let first = self.arc_at(place).0;
        let foot = |k: usize| (k, self.arcs[k].closest_point(point));
        let mut best = foot(first);
        for next in (first + 1..self.arcs.len()).map(foot) {
            if next.1.distance > best.1.distance {
                break;
            }
            best = next;
        }
        if best.1.distance > limit {
            let all = (first..self.arcs.len()).map(foot);
            best = all.min_by(|(_, a), (_, b)| a.distance.total_cmp(&b.distance)).unwrap_or(best);
        }
        (best.0 as f64 + best.1.t).max(place)
    }

    fn point(&self, place: f64) -> Point3 {
        let (k, t) = self.arc_at(place);
        self.arcs[k].point(t)
    }

    fn arc_at(&self, place: f64) -> (usize, f64) {
        let k = (place.floor() as usize).min(self.arcs.len() - 1);
        (k, place - k as f64)
    }

    /// The parts of arcs between two places, by their arc and parameters.
    fn between(&self, [from, to]: [f64; 2]) -> impl Iterator<Item = (&Arc, [f64; 2])> {
        let (first, last) = (self.arc_at(from).0, self.arc_at(to).0);
        let part = move |k: usize| [(from - k as f64).max(0.0), (to - k as f64).min(1.0)];
        (first..=last).map(move |k| (&self.arcs[k], part(k))).filter(|(_, [s, t])| s < t)
    }

    fn length(&self, places: [f64; 2]) -> f64 {
        self.between(places).map(|(arc, [s, t])| arc.length_to(t) - arc.length_to(s)).sum()
    }

    /// How far the arcs between two places are from a chord: each from its own chord, and its ends from the whole one.
    fn bend(&self, places: [f64; 2], chord: [Point3; 2]) -> f64 {
        let bend = |(arc, [s, t]): (&Arc, [f64; 2])| {
            let length = arc.length_to(t) - arc.length_to(s);
            // The height of an arc of this length is below the parabola's.
            let height = 0.125 * arc.curvature() * length * length;
            let ends = [s, t].map(|s| arc.point(s).distance_to_segment(chord));
            height + ends[0].max(ends[1])
        };
        self.between(places).map(bend).fold(0.0, f64::max)
    }
}

impl Part<'_> {
    /// How far the curve between two parameters is from its chord.
    fn bend(&self, s: [f64; 2], chord: [Point3; 2], hull: &mut Option<(usize, PieceHull)>, limit: f64) -> Result<f64> {
        match self.curve.piece_form(self.piece) {
            PieceForm::Arc(arc) => {
                let length = arc.length_to(s[1]) - arc.length_to(s[0]);
                Ok(0.125 * arc.curvature() * length * length)
            }
            PieceForm::Circle(circle) => {
                let length = self.curve.piece_length(self.piece, s[0], s[1]);
                Ok(0.125 * length * length / circle.radius())
            }
            PieceForm::Free => {
                if hull.as_ref().is_none_or(|(piece, _)| *piece != self.piece) {
                    *hull = Some((self.piece, self.curve.piece_hull(self.piece, 0.25 * OPEN * limit)?));
                }
                Ok(hull.as_mut().map_or(f64::INFINITY, |(_, hull)| hull.deviation(s, chord)))
            }
        }
    }
}
