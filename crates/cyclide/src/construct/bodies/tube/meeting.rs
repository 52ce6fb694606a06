//! Whether a tube runs into itself: pairs of parts of its arcs, halved until they are apart, are neighbors, or are so short that their balls are compared
//! (`docs/math/tubes.md#meeting`).

use super::super::center_line::{CenterLine, Crossing};
use super::ball::{Ball, Way};
use super::ball_arc::{BallArc, Station};
use crate::base::bounds::Aabb;
use crate::base::box_tree::BoxTree;
use crate::base::segments::nearest_of_segments;
use crate::base::vector::{Point3, Vec3};
use crate::error::{PipeError, Result};
use std::f64::consts::PI;
use std::ops::Range;

/// Pairs of parts that are looked at before a tube is given up as too near itself to tell.
pub(super) const MOST_PAIRS: usize = 20_000_000;
/// Parts no longer than this many of their radii are not halved: balls of them are compared.
pub(super) const SHORT: f64 = 0.5;
/// Steps in which the nearest balls beside two that meet are looked for, each half of the one before; and moves with one step.
const NARROWINGS: usize = 60;
const MOVES: usize = 64;
/// Tubes may touch: distances that are short of the sum of radii by less than this part do.
pub(super) const TOUCHING: f64 = 1e-6;

/// The arcs of a tube, and what becomes of its ends.
pub(super) struct Course<'a> {
    pub(super) arcs: &'a [BallArc],
    pub(super) closed: bool,
    /// The ends are the rest of the balls there; else the tube ends with the circles of contact.
    pub(super) round: bool,
}

/// A ball on a tube.
#[derive(Clone, Copy)]
struct Place {
    /// Number of its arc, and parameter on it.
    at: f64,
    ball: Ball,
    /// Conformal length before it.
    conformal: f64,
    source: usize,
    section: Section,
    /// So near to an end that is not round that the tube has the section only, not the whole ball.
    cut: bool,
}

/// The disk in which a tube has the ball: its rim is the circle of contact.
#[derive(Clone, Copy)]
pub(super) struct Section {
    pub(super) center: Point3,
    pub(super) axis: Vec3,
    pub(super) radius: f64,
}

impl Section {
    fn of(Station { ball, tangent }: Station) -> Self {
        let size = tangent.v.length();
        let axis = tangent.v / size;
        Self { center: ball.center + axis * (-ball.radius * tangent.r / size), axis, radius: ball.radius / size }
    }

    /// Distance from a point.
    fn distance(self, p: Point3) -> f64 {
        let v = p - self.center;
        let height = v.dot(self.axis);
        height.hypot(((v - self.axis * height).length() - self.radius).max(0.0))
    }

    /// True if two disks share a point: their parts of the line in which their planes meet do.
    pub(super) fn meets(self, other: Self) -> bool {
        let Some(line) = self.axis.cross(other.axis).unit() else { return false };
        // From the first center in its plane to the other plane.
        let to_plane = line.cross(self.axis);
        let lean = to_plane.dot(other.axis);
        let foot = self.center + to_plane * ((other.center - self.center).dot(other.axis) / lean);
        let part = |disk: Self| {
            let along = (disk.center - foot).dot(line);
            let off = (disk.center - foot).length_squared() - along * along;
            let half = (disk.radius * disk.radius * (1.0 - TOUCHING) - off).max(0.0).sqrt();
            (along, half)
        };
        let ((a, half_a), (b, half_b)) = (part(self), part(other));
        half_a > 0.0 && half_b > 0.0 && (a - b).abs() < half_a + half_b
    }
}

/// Two balls that are where only one tube may be.
pub(super) struct Meeting {
    pub(super) tubes: [usize; 2],
    sources: [usize; 2],
    /// In the middle between both.
    point: Point3,
    pub(super) distance: f64,
    limit: f64,
}

impl Meeting {
    fn of(pair: [(usize, &Place); 2]) -> Self {
        let [a, b] = pair.map(|(_, place)| place.ball);
        Self {
            tubes: pair.map(|(number, _)| number),
            sources: pair.map(|(_, place)| place.source),
            point: a.center.midpoint(b.center),
            distance: a.center.distance(b.center),
            limit: a.radius + b.radius,
        }
    }
}

/// Refuses a tube of which parts that are a conformal half turn or more apart along it run into each other.
///
/// # Errors
/// `pipe-meets-itself`.
pub(super) fn check(course: Course<'_>) -> Result<()> {
    let tube = Tracked::new(0, course);
    let skip = |a: &Range<usize>, b: &Range<usize>| tube.conformal[b.end] - tube.conformal[a.start] <= PI;
    let mut left = MOST_PAIRS;
    let found = tube.tree.find_within(skip, |i, j| meeting([&tube, &tube], [i, j], &mut left));
    found.map_or(Ok(()), |Meeting { sources: [first, second], point, distance, limit, .. }| {
        let arcs = tube.course.arcs;
        let line = CenterLine {
            count: arcs.len(),
            closed: tube.course.closed,
            point: &|arc, s| arcs[arc].station(s).ball.center,
            sagitta: &|arc, range| arcs[arc].sagitta(range),
        };
        // No thinner tube helps there: that is said first.
        let crossing = line.crossing(limit);
        let ([first, second], point, distance) = crossing
            .map_or(([first, second], point, distance), |Crossing { pieces, point, distance }| {
                (pieces.map(|arc| arcs[arc].source), point, distance)
            });
        let [first, second] = [first.min(second), first.max(second)];
        Err(PipeError::MeetsItself { first, second, point: point.to_array(), distance, limit }.into())
    })
}

/// The first balls of different tubes that meet.
pub(super) fn first(tubes: Vec<Course<'_>>) -> Option<Meeting> {
    let tubes: Vec<Tracked<'_>> = tubes.into_iter().enumerate().map(|(k, course)| Tracked::new(k, course)).collect();
    let mut left = MOST_PAIRS;
    tubes.iter().enumerate().find_map(|(k, second)| {
        tubes[..k]
            .iter()
            .find_map(|first| first.tree.find_between(&second.tree, |i, j| meeting([first, second], [i, j], &mut left)))
    })
}

/// A tube with the lengths before its arcs and the boxes of their balls.
struct Tracked<'a> {
    number: usize,
    course: Course<'a>,
    conformal: Vec<f64>,
    ways: Vec<f64>,
    tree: BoxTree,
}

/// A part of an arc.
#[derive(Clone, Copy)]
struct Part {
    arc: usize,
    range: [f64; 2],
    ends: [Ball; 2],
    tangents: [Way; 2],
    /// No ball is farther than this from those of the straight way.
    off: f64,
    conformal: [f64; 2],
}

impl Part {
    fn chord(&self) -> f64 {
        self.ends[0].center.distance(self.ends[1].center)
    }

    /// Its length in its own radii, the smaller one.
    fn steps(&self) -> f64 {
        self.chord() / self.ends[0].radius.min(self.ends[1].radius)
    }

    fn most(&self) -> f64 {
        self.ends[0].radius.max(self.ends[1].radius) + self.off
    }

    /// True if they are so far apart along the way of their chords that no balls meet, with the nearest places of the chords.
    fn nearest(&self, other: &Self) -> (bool, [f64; 2]) {
        let chords = [self, other].map(|part| part.ends.map(|ball| ball.center));
        let (distance, at) = nearest_of_segments(chords);
        let off = self.off + other.off;
        (distance - off >= (self.most() + other.most()) * (1.0 - TOUCHING), at)
    }

    /// The largest radial part of its unit tangents, by those at its ends, of which those between are sums with weights of less than 1/cos of half the turn in all.
    fn steepest(&self) -> f64 {
        let half = (0.5 * (1.0 + self.tangents[0].dot(self.tangents[1]))).sqrt();
        self.tangents[0].r.abs().max(self.tangents[1].r.abs()) / half.min(1.0)
    }
}

/// True if parts that follow each other run on in one direction so steadily that balls of theirs that meet are less than a conformal half turn apart: directions
/// of centers are within an angle with the cosine `c` of one, radii change by less than `m` of the length, and with `u = m/c`
/// ```text
/// 2/(c u) log(1/(1 - u)) <= pi
/// ```
fn runs_on(parts: &[&Part]) -> bool {
    let directions = || parts.iter().flat_map(|part| part.tangents).filter_map(|tangent| tangent.v.unit());
    let Some(axis) = directions().fold(Vec3::ZERO, |sum, v| sum + v).unit() else { return false };
    let cosine = directions().map(|v| v.dot(axis)).fold(1.0, f64::min);
    let steepest = parts.iter().map(|part| part.steepest()).fold(0.0, f64::max);
    let slope = steepest / 1_f64.hypot(steepest) / cosine;
    if !(cosine > 0.0 && slope < 1.0) {
        return false;
    }
    let grown = if slope > 1e-9 { -(-slope).ln_1p() / slope } else { 1.0 };
    2.0 * grown / cosine <= PI
}

/// The first meeting of balls of two arcs, of one tube or of different ones.
fn meeting([first, second]: [&Tracked<'_>; 2], [i, j]: [usize; 2], left: &mut usize) -> Option<Meeting> {
    let same = first.number == second.number;
    let mut waiting = vec![(first.part(i, [0.0, 1.0]), second.part(j, [0.0, 1.0]))];
    while let Some((a, b)) = waiting.pop() {
        *left = left.saturating_sub(1);
        if same && first.are_neighbors(a.conformal, b.conformal) {
            continue;
        }
        if same && a.arc == b.arc && a.range.map(f64::to_bits) == b.range.map(f64::to_bits) {
            if *left > 0 && !runs_on(&[&a]) {
                let [one, other] = first.halves(&a);
                waiting.extend([(other, other), (one, other), (one, one)]);
            }
            continue;
        }
        let mut at = [0.5; 2];
        if same && (first.follows(&a, &b) || first.follows(&b, &a)) {
            if runs_on(&[&a, &b]) {
                continue;
            }
        } else {
            let apart;
            (apart, at) = a.nearest(&b);
            if apart {
                continue;
            }
        }
        if a.steps().max(b.steps()) <= SHORT || *left == 0 {
            let found = compared([first, second], [&a, &b], at, *left == 0);
            if found.is_some() {
                return found;
            }
        } else if a.steps() > b.steps() {
            waiting.extend(first.halves(&a).map(|half| (half, b)));
        } else {
            waiting.extend(second.halves(&b).map(|half| (a, half)));
        }
    }
    None
}

/// Compares balls of two short parts: in their middles, where their chords are nearest, and at ends of tubes.
fn compared(tubes: [&Tracked<'_>; 2], parts: [&Part; 2], nearest: [f64; 2], given_up: bool) -> Option<Meeting> {
    let places = [0, 1].map(|k| {
        let (tube, [from, to]) = (tubes[k], parts[k].range);
        let ends = [(0, 0.0), (tube.course.arcs.len() - 1, 1.0)].into_iter();
        let ends = ends.filter(|(arc, s)| !tube.course.closed && parts[k].arc == *arc && parts[k].range.contains(s));
        let inside = [0.5, nearest[k]].map(|x| from + (to - from) * x);
        let all = inside.into_iter().chain(ends.map(|(_, s)| s));
        all.map(|s| tube.place(parts[k].arc, s)).collect::<Vec<_>>()
    });
    let same = tubes[0].number == tubes[1].number;
    for a in &places[0] {
        for b in &places[1] {
            let apart = same && tubes[0].are_neighbors([a.conformal; 2], [b.conformal; 2]);
            if !apart && (given_up || share(a, b)) {
                let [a, b] = deepest(tubes, [a, b]);
                let mut pair = [(tubes[0].number, &a), (tubes[1].number, &b)];
                pair.sort_by_key(|(number, place)| (*number, place.source));
                return Some(Meeting::of(pair));
            }
        }
    }
    None
}

/// The balls beside two that meet which reach deepest into each other: the first two found say little of how near the tubes come. Both are moved along their
/// tubes, in steps that grow smaller, as long as that goes on and they are no neighbors.
fn deepest(tubes: [&Tracked<'_>; 2], [a, b]: [&Place; 2]) -> [Place; 2] {
    let same = tubes[0].number == tubes[1].number;
    let room = |[a, b]: &[Place; 2]| a.ball.center.distance(b.ball.center) - a.ball.radius - b.ball.radius;
    let mut best = [*a, *b];
    let mut step = 0.5;
    for _ in 0..NARROWINGS {
        for _ in 0..MOVES {
            let moved = (0..9).filter(|k| *k != 4).filter_map(|k| {
                let by = [f64::from(k / 3) - 1.0, f64::from(k % 3) - 1.0].map(|way| way * step);
                let pair = [tubes[0].place_at(best[0].at + by[0])?, tubes[1].place_at(best[1].at + by[1])?];
                let conformal = [pair[0].conformal, pair[1].conformal];
                let [before, behind] = [conformal[0].min(conformal[1]), conformal[0].max(conformal[1])];
                let near = same && tubes[0].are_neighbors([before; 2], [behind; 2]);
                (!near).then_some(pair)
            });
            let Some(next) = moved.min_by(|p, q| room(p).total_cmp(&room(q))).filter(|next| room(next) < room(&best))
            else {
                break;
            };
            best = next;
        }
        step *= 0.5;
    }
    best
}

/// True if what the tubes have of two balls shares space.
fn share(a: &Place, b: &Place) -> bool {
    let apart = match (a.cut, b.cut) {
        (false, false) => a.ball.center.distance(b.ball.center) >= (a.ball.radius + b.ball.radius) * (1.0 - TOUCHING),
        (true, false) => a.section.distance(b.ball.center) >= b.ball.radius * (1.0 - TOUCHING),
        (false, true) => b.section.distance(a.ball.center) >= a.ball.radius * (1.0 - TOUCHING),
        (true, true) => !a.section.meets(b.section),
    };
    !apart
}

impl<'a> Tracked<'a> {
    fn new(number: usize, course: Course<'a>) -> Self {
        let (mut conformal, mut ways) = (vec![0.0], vec![0.0]);
        let (mut length, mut way) = (0.0, 0.0);
        let mut boxes = Vec::with_capacity(course.arcs.len());
        for arc in course.arcs {
            let [a, b] = arc.centers();
            let middle = arc.ball(0.5).center;
            length += arc.conformal_length([0.0, 1.0]);
            way += a.distance(middle) + middle.distance(b);
            conformal.push(length);
            ways.push(way);
            boxes.push(Aabb::of_point(a).including(b).grown(arc.radii()[1] + arc.sagitta([0.0, 1.0])));
        }
        Self { number, course, conformal, ways, tree: BoxTree::new(&boxes) }
    }

    fn part(&self, arc: usize, range: [f64; 2]) -> Part {
        let own = &self.course.arcs[arc];
        let [from, to] = range.map(|s| own.station(s));
        let conformal = range.map(|s| self.conformal_length(arc, s));
        let (ends, tangents) = ([from.ball, to.ball], [from.tangent, to.tangent]);
        Part { arc, range, ends, tangents, off: own.sagitta(range), conformal }
    }

    fn halves(&self, part: &Part) -> [Part; 2] {
        let [from, to] = part.range;
        let middle = 0.5 * (from + to);
        [[from, middle], [middle, to]].map(|range| self.part(part.arc, range))
    }

    fn conformal_length(&self, arc: usize, s: f64) -> f64 {
        if s >= 1.0 {
            self.conformal[arc + 1]
        } else {
            self.conformal[arc] + self.course.arcs[arc].conformal_length([0.0, s])
        }
    }

    fn place(&self, arc: usize, s: f64) -> Place {
        let own = &self.course.arcs[arc];
        let station = own.station(s);
        let ball = station.ball;
        let [start, end] = own.centers();
        let before = self.ways[arc] + start.distance(ball.center);
        let behind = self.ways[self.ways.len() - 1] - self.ways[arc + 1] + end.distance(ball.center);
        let cut = !self.course.closed && !self.course.round && before.min(behind) < ball.radius;
        let conformal = self.conformal_length(arc, s);
        Place { at: arc as f64 + s, ball, conformal, source: own.source, section: Section::of(station), cut }
    }

    /// The ball at a number of an arc and a parameter on it; round and round on a closed tube, none beyond the ends of an open one.
    fn place_at(&self, at: f64) -> Option<Place> {
        let count = self.course.arcs.len() as f64;
        let at = if self.course.closed { at.rem_euclid(count) } else { at };
        let arc = at.floor().min(count - 1.0);
        (0.0..=count).contains(&at).then(|| self.place(arc as usize, at - arc))
    }

    /// True if all places of a part are less than a conformal half turn before those of one behind it, or, round the other way, behind them.
    fn are_neighbors(&self, [from, end]: [f64; 2], [start, to]: [f64; 2]) -> bool {
        let round = self.conformal[self.conformal.len() - 1] - (start - end).max(0.0);
        to - from <= PI || (self.course.closed && round <= PI)
    }

    /// True if a part starts where another one ends.
    fn follows(&self, part: &Part, next: &Part) -> bool {
        let last = self.course.arcs.len() - 1;
        let ([_, end], [start, _]) = (part.range, next.range);
        if end < 1.0 {
            return part.arc == next.arc && end.to_bits() == start.to_bits();
        }
        let behind = if part.arc < last { Some(part.arc + 1) } else { self.course.closed.then_some(0) };
        start == 0.0 && behind == Some(next.arc)
    }
}
