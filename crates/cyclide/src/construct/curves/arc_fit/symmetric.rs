//! Symmetric data get symmetric arcs: the chain over the part of a trace between two neighbouring axes of symmetry, which it
//! crosses at right angles, and its mirror images (`docs/math/arc-fitting.md#symmetry`).

use super::beam::{ChainJoint, Goal, Run, search};
use super::certificate::{certify, deviation_of};
use super::chain_bulge;
use super::curvature_interval::JointFrame;
use super::options::{ArcFitOptions, Effort};
use super::piece::{Piece, Place, Span};
use super::polish::{polished, polished_between};
use super::straighten::straighten_between;
use super::trace::Trace;
use crate::base::frame::Frame;
use crate::base::planar::{Point2, Vec2};
use crate::base::vector::Point3;
use crate::curve::Arc;
use std::ops::Range;

/// Mirror images are this part of the tolerance off the points at most.
const ALIKE: f64 = 0.2;
/// Where a point is kept exactly and its mirror image is this part of a piece off it, the piece is bent to it.
const EXACT: f64 = 1e-9;
/// A bulge whose arc, with its mirror image, turns by 340 degrees.
const LARGEST_BULGE: f64 = 0.916;

/// A symmetric path may have one piece in so many more, and one: its count is even, or odd, whether or not that is the least.
const MORE: usize = 10;
/// A line that crosses an axis at a right angle but for this many radians is one.
const STRAIGHT: f64 = 1e-6;
/// But none more than one that is within this part of the tolerance.
const NEAR: f64 = 0.05;
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

/// The part of a trace between two axes; places count half steps.
struct Sector {
    places: Range<usize>,
    /// Unit normals of the axes, in the direction of the trace there.
    normals: [Vec2; 2],
}

/// A piece in the plane, and the places on the trace between which it stands.
#[derive(Clone, Copy)]
struct Bow {
    ends: [Point2; 2],
    bulge: f64,
    places: [f64; 2],
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
        // What is as near as that is symmetric, but for its joints.
        let more = if off(other) > NEAR * self.tolerance { other.len() / MORE + 1 } else { 0 };
        let most = other.len() + more;
        let limit = (FARTHER * off(other)).max(ENOUGH * self.tolerance);
        let lines = |path: &[Piece]| path.iter().filter(|piece| piece.arc.is_straight()).count();
        let order = |a: &(f64, Vec<Piece>), b: &(f64, Vec<Piece>)| {
            let fewest = a.1.len().cmp(&b.1.len()).then(lines(&b.1).cmp(&lines(&a.1)));
            fewest.then(a.0.total_cmp(&b.0))
        };
        // Of sectors whose pieces are found in a way.
        let best = |sectors: &[Sector], pieces: &dyn Fn(&Sector) -> Option<Vec<Piece>>| {
            let paths = sectors.iter().filter_map(|sector| data.unfolded(sector, &pieces(sector)?));
            let near = paths.filter(|path| path.len() <= most && passes(path)).map(|path| (off(&path), path));
            near.filter(|path| path.0 <= limit).min_by(order)
        };
        data.sectors().iter().find_map(|sectors| {
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

/// The trace in its plane.
struct Flat<'a> {
    points: &'a [Point2],
    center: Point2,
    symmetric: &'a Symmetric<'a>,
}

impl Flat<'_> {
    /// Sectors to try, the better ones first: those of all axes that the points have, then those of one of them. Of each kind there
    /// are two, which begin at either of their axes.
    fn sectors(&self) -> Vec<Vec<Sector>> {
        let n = self.points.len();
        if n < 3 {
            return Vec::new();
        }
        if !self.symmetric.trace.closed {
            let middle = n - 1;
            let half = |normal: Vec2| {
                [0..middle, middle..2 * middle].map(|places| Sector { places, normals: [normal; 2] }).into()
            };
            return self.normal(middle).map(half).into_iter().collect();
        }
        let mut axes = (0..n).filter_map(|sum| Some((sum, self.normal(sum)?)));
        let Some(first) = axes.next() else { return Vec::new() };
        let next = axes.next();
        let opposite = (first.0 + n, self.normal_at(first.0 + n, first.1));
        let pair = |(from, normal): (usize, Vec2), (to, other): (usize, Vec2)| {
            let reach = to - from;
            let image = normal - other * (2.0 * normal.dot(other));
            let beyond = self.normal_at(to + reach, image);
            vec![
                Sector { places: from..to, normals: [normal, other] },
                Sector { places: to..to + reach, normals: [other, beyond] },
            ]
        };
        next.into_iter().chain([opposite]).map(|to| pair(first, to)).collect()
    }

    /// The unit normal of the axis that takes each point to the one at the rest of the sum, if there is one, in the direction of the
    /// trace at half of the sum.
    fn normal(&self, sum: usize) -> Option<Vec2> {
        let n = self.points.len();
        let trace = self.symmetric.trace;
        let allowed = ALIKE * self.symmetric.tolerance;
        let image = |i: usize| (sum + n - i) % n;
        let out = |i: usize| (self.points[i] - self.center).length();
        let is_like = |i: usize| {
            let j = image(i);
            (out(i) - out(j)).abs() <= allowed
                && trace.vertex[i].is_some() == trace.vertex[j].is_some()
                && (trace.slack[i] - trace.slack[j]).abs() <= allowed
                && self.symmetric.is_corner(2 * i) == self.symmetric.is_corner(2 * j)
        };
        if !(0..n).all(is_like) {
            return None;
        }
        let across = |i: usize| self.points[image(i)] - self.points[i];
        let farthest = (0..n).max_by(|i, j| across(*i).length().total_cmp(&across(*j).length()))?;
        let along = across(farthest);
        let whole =
            (0..n).map(across).fold(Vec2::default(), |sum, v| if v.dot(along) < 0.0 { sum - v } else { sum + v });
        let normal = whole.unit()?;
        (0..n)
            .all(|i| self.mirrored(self.points[i], normal).distance(self.points[image(i)]) <= allowed)
            .then(|| self.normal_at(sum, normal))
    }

    /// A normal, or its opposite, as the trace runs at a place.
    fn normal_at(&self, half: usize, normal: Vec2) -> Vec2 {
        let n = self.points.len();
        let step = self.points[(half + 2) / 2 % n] - self.points[(half + 2 * n - 1) / 2 % n];
        if step.dot(normal) < 0.0 { -normal } else { normal }
    }

    fn mirrored(&self, p: Point2, normal: Vec2) -> Point2 {
        p + normal * (-2.0 * (p - self.center).dot(normal))
    }

    /// The joint on an axis nearest to the trace there, and the tangent across it.
    fn on_axis(&self, place: Point2, tangent: Vec2) -> JointFrame {
        JointFrame { joint: place + tangent * -(place - self.center).dot(tangent), tangent }
    }

    /// The pieces over a sector, run by run between corners.
    fn over(&self, sector: &Sector, effort: Effort) -> Option<Vec<Piece>> {
        let Symmetric { trace, corners, frame, tolerance, options, .. } = self.symmetric;
        let (n, Range { start, end }) = (self.points.len(), sector.places.clone());
        let laps = (0..3).flat_map(|lap| corners.iter().map(move |c| 2 * (c + lap * n)));
        let mut stops = vec![start];
        stops.extend(laps.filter(|half| start < *half && *half < end));
        stops.push(end);
        let mut all = Vec::new();
        for stop in stops.windows(2) {
            let axes = [0, 1].map(|k| !self.symmetric.is_kept(stop[k]));
            let run = Run::between(self.points, trace, stop[0]..stop[1]);
            let tube = run.tube(*tolerance, options.limits());
            let start = match axes[0] {
                true => tube.axis_fan(self.on_axis(tube.points[0], sector.normals[0])),
                false => tube.start_fan(),
            };
            let goal = match axes[1] {
                true => Goal::Axis(self.on_axis(tube.points[tube.last()], sector.normals[1])),
                false => Goal::Point,
            };
            if let Some(side) = self.side(stop, axes, sector) {
                all.push(side);
                continue;
            }
            let joints = search(&tube, &start, goal, effort.beam()).ok()?;
            let found = self.pieces(&joints, stop, axes)?;
            let mut straight = found.clone();
            let across = [0, 1].map(|k| axes[k].then(|| frame.vector_to_world(sector.normals[k])));
            straighten_between(&mut straight, across, trace, frame.z(), *tolerance, options.target);
            let pieces = if options.limits_kept(&straight) { straight } else { found };
            all.extend(self.polished(pieces, axes));
        }
        Some(all)
    }

    fn polished(&self, pieces: Vec<Piece>, axes: [bool; 2]) -> Vec<Piece> {
        let Symmetric { trace, frame, tolerance, options, .. } = self.symmetric;
        match axes {
            [false, false] => polished(pieces, trace, frame, *tolerance, options),
            axes => polished_between(pieces, axes, trace, frame, *tolerance, options),
        }
    }

    /// The pieces over a sector of a path over the whole trace, cut at its axes so that they cross them at right angles.
    fn of_path(&self, sector: &Sector, path: &[Piece]) -> Option<Vec<Piece>> {
        let n = self.points.len();
        let ends = [sector.places.start, sector.places.end];
        let places = ends.map(|half| half as f64 / 2.0);
        let on_lap = |lap: usize| {
            let later = move |place: Place| Place { index: place.index + lap * n, ..place };
            path.iter().map(move |p| Piece { span: Span { from: later(p.span.from), to: later(p.span.to) }, ..*p })
        };
        let inside = |p: &Piece| p.span.to.along() > places[0] && p.span.from.along() < places[1];
        let mut pieces: Vec<Piece> = (0..3).flat_map(on_lap).filter(inside).collect();
        let axes = ends.map(|half| !self.symmetric.is_kept(half));
        let count = pieces.len();
        if count < 2 {
            return None;
        }
        for (k, i) in [(0, 0), (1, count - 1)] {
            if axes[k] {
                pieces[i] = self.cut(&pieces[i], k == 0, ends[k], sector.normals[k])?;
            }
        }
        // Run by run between corners.
        let mut starts: Vec<usize> = (1..count).filter(|i| !pieces[*i].smooth).collect();
        starts.insert(0, 0);
        starts.push(count);
        let runs = starts.windows(2).map(|w| {
            let mut run = pieces[w[0]..w[1]].to_vec();
            run[0].smooth = false;
            self.polished(run, [axes[0] && w[0] == 0, axes[1] && w[1] == count])
        });
        Some(runs.flatten().collect())
    }

    /// A piece from an axis that it crosses, or to it, with the tangent that it has at its other end.
    fn cut(&self, piece: &Piece, from_axis: bool, half: usize, normal: Vec2) -> Option<Piece> {
        let frame = self.symmetric.frame;
        let (end, tangent) = match from_axis {
            true => (piece.arc.end(), piece.arc.end_tangent()?),
            false => (piece.arc.start(), piece.arc.start_tangent()?),
        };
        let (at, tangent) = (frame.to_local(end).0, frame.vector_to_local(tangent));
        let chord = (tangent + normal).unit()?;
        let joint = at + chord * ((self.center - at).dot(normal) / chord.dot(normal));
        let across = frame.vector_to_world(normal) * at.distance(joint);
        let (on_axis, place) = (frame.to_world(joint), half_place(half));
        let (arc, span) = match from_axis {
            true => (Arc::from_start_tangent(on_axis, end, across), Span { from: place, ..piece.span }),
            false => (Arc::from_end_tangent(end, on_axis, across), Span { to: place, ..piece.span }),
        };
        let arc = if piece.arc.is_straight() && arc.as_ref().is_ok_and(|arc| arc.angle() < STRAIGHT) {
            Arc::segment(if from_axis { on_axis } else { end }, if from_axis { end } else { on_axis })
        } else {
            arc
        };
        Some(Piece { arc: arc.ok()?, span, ..*piece })
    }

    /// Half of a straight side between a corner and its mirror image, where that is within the tolerance.
    fn side(&self, stop: &[usize], axes: [bool; 2], sector: &Sector) -> Option<Piece> {
        let Symmetric { trace, frame, tolerance, options, .. } = self.symmetric;
        let span = Span { from: half_place(stop[0]), to: half_place(stop[1]) };
        let [from, to] = [span.from, span.to].map(|place| place.point(trace));
        let foot = |p: Point3, normal: Vec2| frame.to_world(self.on_axis(frame.to_local(p).0, normal).joint);
        let arc = match axes {
            [true, false] => Arc::segment(foot(to, sector.normals[0]), to),
            [false, true] => Arc::segment(from, foot(from, sector.normals[1])),
            _ => return None,
        };
        let piece = Piece { arc: arc.ok()?, span, smooth: false };
        deviation_of(&piece, trace, options.target).filter(|off| off <= tolerance).map(|_| piece)
    }

    fn pieces(&self, joints: &[ChainJoint], stop: &[usize], axes: [bool; 2]) -> Option<Vec<Piece>> {
        let Symmetric { trace, frame, .. } = self.symmetric;
        let last = joints.len() - 1;
        let at = |i: usize| match i {
            0 => half_place(stop[0]),
            i if i == last => half_place(stop[1]),
            i => Place::over(stop[0] / 2 + joints[i].vertex),
        };
        let point = |i: usize| {
            let is_kept = (i == 0 && !axes[0]) || (i == last && !axes[1]);
            if is_kept { at(i).point(trace) } else { frame.to_world(joints[i].frame.joint) }
        };
        let piece = |i: usize| {
            let arc =
                Arc::from_bulge(point(i - 1), point(i), frame.z(), chain_bulge(&joints[i - 1], &joints[i])).ok()?;
            Some(Piece { arc, span: Span { from: at(i - 1), to: at(i) }, smooth: i > 1 })
        };
        (1..=last).map(piece).collect()
    }

    /// The whole path of a sector and its mirror images.
    fn unfolded(&self, sector: &Sector, pieces: &[Piece]) -> Option<Vec<Piece>> {
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

/// A place counted in half steps.
fn half_place(half: usize) -> Place {
    Place { index: half / 2, fraction: 0.5 * (half % 2) as f64 }
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
