//! The pieces of a path between two axes of symmetry, which it crosses at right angles (`docs/math/arc-fitting.md#symmetry`).

use super::Symmetric;
use super::axes::{Flat, Sector};
use crate::base::planar::Vec2;
use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::beam::{ChainJoint, Goal, Run, search};
use crate::construct::curves::arc_fit::certificate::deviation_of;
use crate::construct::curves::arc_fit::chain_bulge;
use crate::construct::curves::arc_fit::options::Effort;
use crate::construct::curves::arc_fit::piece::{Piece, Place, Span};
use crate::construct::curves::arc_fit::polish::{polished, polished_between};
use crate::construct::curves::arc_fit::straighten::straighten_between;
use crate::curve::Arc;
use std::ops::Range;

/// A straight piece that turns by less than this many radians when it is cut at an axis stays a line.
const STRAIGHT: f64 = 1e-6;

impl Flat<'_> {
    /// The pieces over a sector, run by run between corners.
    pub(super) fn over(&self, sector: &Sector, effort: Effort) -> Option<Vec<Piece>> {
        let Symmetric { trace, corners, tolerance, options, .. } = self.symmetric;
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
            all.extend(self.finished(found, axes, sector));
        }
        Some(all)
    }

    /// Nearly straight pieces of a run are made lines, and all are moved to the least deviation.
    fn finished(&self, found: Vec<Piece>, axes: [bool; 2], sector: &Sector) -> Vec<Piece> {
        let Symmetric { trace, frame, tolerance, options, .. } = self.symmetric;
        let mut straight = found.clone();
        let across = [0, 1].map(|k| axes[k].then(|| frame.vector_to_world(sector.normals[k])));
        straighten_between(&mut straight, across, trace, frame.z(), *tolerance, options.target);
        let pieces = if options.limits_kept(&straight) { straight } else { found };
        match axes {
            [false, false] => polished(pieces, trace, frame, *tolerance, options),
            axes => polished_between(pieces, axes, trace, frame, *tolerance, options),
        }
    }

    /// The pieces over a sector of a path over the whole trace, cut at its axes so that they cross them at right angles.
    pub(super) fn of_path(&self, sector: &Sector, path: &[Piece]) -> Option<Vec<Piece>> {
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
            self.finished(run, [axes[0] && w[0] == 0, axes[1] && w[1] == count], sector)
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
}

/// A place counted in half steps.
fn half_place(half: usize) -> Place {
    Place { index: half / 2, fraction: 0.5 * (half % 2) as f64 }
}
