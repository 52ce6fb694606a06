//! Whether a tube meets itself.
//!
//! Two points of a spine whose curvature stays below `1/r`, a way of `π r` or more apart along it and nearer than `2 r`, have tubes
//! that meet; the nearest such pairs are joined by a line across the spine at both (or end at an end), and if there are none the tube
//! is free of itself (the reach of a curve: Federer 1959, Theorem 4.18; Schur's theorem for the bound of the way). From the middles of short chords such pairs are
//! found by closest points in turns. What a tube has beyond the balls about its spine, the spikes of miters and the rims of slanted plane ends, is
//! looked at by points of its own. Chords are looked up by the cubes they lie in, so that time is linear in the length over the radius.

use super::super::center_line::{CenterLine, Crossing};
use super::PipeEnds;
use super::frame::Spine;
use crate::base::vector::{Point3, Vec3};
use crate::curve::ParamCurve as _;
use crate::error::{Error, PipeError, Result};
use std::collections::HashMap;
use std::f64::consts::PI;

/// Chords of a spine, at most.
const MOST_CHORDS: f64 = 2e5;
/// Closest points in turns, at most.
const TURNS: usize = 64;
/// Tubes may touch: distances that are short of twice the radius by less than this part do.
const TOUCHING: f64 = 1e-9;

/// Points of the rim of a plane end.
const RIM: usize = 32;

/// A place on the spine.
#[derive(Debug, Clone, Copy)]
struct Place {
    piece: usize,
    point: Point3,
    /// Length of the spine before it.
    way: f64,
}

/// The spine with the lengths before its pieces.
struct Measured<'a> {
    spine: &'a Spine,
    before: Vec<f64>,
    length: f64,
    radius: f64,
    ends: PipeEnds,
}

/// Refuses a spine about which a tube meets itself.
///
/// # Errors
/// `pipe-meets-itself`.
pub(super) fn check(spine: &Spine, radius: f64, ends: PipeEnds) -> Result<()> {
    // Where the spine itself crosses, no thinner pipe helps: that is said first.
    first_overlap(spine, radius, ends).map_err(|error| crossing(spine, radius).unwrap_or(error))
}

/// Where pieces of the spine cross.
fn crossing(spine: &Spine, radius: f64) -> Option<Error> {
    let arc = |piece: usize| &spine.pieces[piece].arc;
    let sagitta = |piece: usize, [from, to]: [f64; 2]| {
        0.125 * arc(piece).curvature() * arc(piece).piece_length(0, from, to).powi(2)
    };
    let line = CenterLine {
        count: spine.pieces.len(),
        closed: spine.closed,
        point: &|piece, t| arc(piece).point(t),
        sagitta: &sagitta,
    };
    let limit = 2.0 * radius;
    line.crossing(limit).map(|Crossing { pieces, point, distance }| {
        let [first, second] = pieces.map(|piece| spine.pieces[piece].source);
        PipeError::MeetsItself { first, second, point: point.to_array(), distance, limit }.into()
    })
}

fn first_overlap(spine: &Spine, radius: f64, ends: PipeEnds) -> Result<()> {
    let measured = Measured::new(spine, radius, ends);
    let step = (0.5 * radius).max(measured.length / MOST_CHORDS);
    let middles = measured.middles(step);
    let cube = 2.0 * radius + step;
    let key = |p: Point3| key(p, cube);
    let mut cubes: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
    for (k, middle) in middles.iter().enumerate() {
        cubes.entry(key(middle.point)).or_default().push(k);
    }
    for middle in &middles {
        let mut seen: Vec<usize> = Vec::new();
        for other in around(key(middle.point)).filter_map(|at| cubes.get(&at)).flatten().map(|&k| &middles[k]) {
            let near = middle.point.distance(other.point) < cube;
            if !near || !measured.is_apart(middle, other) || seen.contains(&other.piece) {
                continue;
            }
            seen.push(other.piece);
            measured.check_pair(*middle, *other)?;
        }
    }
    for (own, p) in measured.outside_balls() {
        for other in around(key(p)).filter_map(|at| cubes.get(&at)).flatten().map(|&k| &middles[k]) {
            if measured.is_apart(&own, other) {
                measured.check_point(&own, p, other.piece)?;
            }
        }
    }
    Ok(())
}

/// Two tubes of one radius that run into each other, and how near their spines are.
pub(super) struct Meeting {
    pub(super) spines: [usize; 2],
    pub(super) distance: f64,
}

/// The first tubes about different spines, in their order, that meet.
pub(super) fn first_meeting(spines: &[Spine], radius: f64, ends: PipeEnds) -> Option<Meeting> {
    let all: Vec<Measured<'_>> = spines.iter().map(|spine| Measured::new(spine, radius, ends)).collect();
    let length: f64 = all.iter().map(|one| one.length).sum();
    let step = (0.5 * radius).max(length / MOST_CHORDS);
    let cube = 2.0 * radius + step;
    let mut cubes: HashMap<[i64; 3], Vec<(usize, Place)>> = HashMap::new();
    for (index, own) in all.iter().enumerate() {
        for middle in own.middles(step) {
            let near = around(key(middle.point, cube)).filter_map(|at| cubes.get(&at)).flatten();
            for (first, other) in
                near.filter(|(first, other)| *first < index && other.point.distance(middle.point) < cube)
            {
                if let Some(distance) = own.distance_if_met(middle, &all[*first], *other) {
                    return Some(Meeting { spines: [*first, index], distance });
                }
            }
            cubes.entry(key(middle.point, cube)).or_default().push((index, middle));
        }
    }
    None
}

/// The cube of this width that a point lies in.
fn key(p: Point3, cube: f64) -> [i64; 3] {
    p.to_array().map(|v| (v / cube).floor() as i64)
}

/// A cube and those beside it.
fn around([x, y, z]: [i64; 3]) -> impl Iterator<Item = [i64; 3]> {
    (0..27).map(move |k: i64| [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1])
}

impl<'a> Measured<'a> {
    fn new(spine: &'a Spine, radius: f64, ends: PipeEnds) -> Self {
        let mut before = Vec::with_capacity(spine.pieces.len());
        let mut length = 0.0;
        for piece in &spine.pieces {
            before.push(length);
            length += piece.arc.length();
        }
        Self { spine, before, length, radius, ends }
    }

    /// The middles of chords that are not longer than a step.
    fn middles(&self, step: f64) -> Vec<Place> {
        let mut middles = Vec::new();
        for (k, piece) in self.spine.pieces.iter().enumerate() {
            let length = piece.arc.length();
            let count = (length / step).ceil().max(1.0);
            for i in 0..count as usize {
                let part = (i as f64 + 0.5) / count;
                let point = piece.arc.point_at_length(part);
                middles.push(Place { piece: k, point, way: self.before[k] + part * length });
            }
        }
        middles
    }

    /// True if the way between two places is that of half a turn about the pipe's radius, and no miter parts them.
    fn is_apart(&self, a: &Place, b: &Place) -> bool {
        let straight = (a.way - b.way).abs();
        let way = if self.spine.closed { straight.min(self.length - straight) } else { straight };
        way >= PI * self.radius * (1.0 - TOUCHING) && !self.have_a_mitre(a.piece, b.piece)
    }

    /// True for segments that share a corner: each lies on its side of the miter.
    fn have_a_mitre(&self, a: usize, b: usize) -> bool {
        let mitred = |k: usize, next: usize| self.spine.behind(k).0 == next && self.spine.stations[next].mitred;
        mitred(a, b) || mitred(b, a)
    }

    /// From a place and one of another spine to the nearest two on their pieces.
    fn nearest_pair(&self, from: Place, other: &Self, to: Place) -> (Place, Place) {
        let (mut a, mut b) = (from, to);
        let mut distance = f64::INFINITY;
        for _ in 0..TURNS {
            b = other.nearest_on(b.piece, a.point);
            a = self.nearest_on(a.piece, b.point);
            let now = a.point.distance(b.point);
            if !(now < distance * (1.0 - TOUCHING)) {
                break;
            }
            distance = now;
        }
        (a, b)
    }

    /// The distance of two spines next to a place of each, if their tubes meet there.
    fn distance_if_met(&self, from: Place, other: &Self, to: Place) -> Option<f64> {
        let (a, b) = self.nearest_pair(from, other, to);
        let distance = a.point.distance(b.point);
        let meets = distance < 2.0 * self.radius * (1.0 - TOUCHING) && !self.ends_part(&a, other, &b);
        meets.then_some(distance)
    }

    fn check_pair(&self, from: Place, to: Place) -> Result<()> {
        let (a, b) = self.nearest_pair(from, self, to);
        let limit = 2.0 * self.radius;
        let distance = a.point.distance(b.point);
        if distance >= limit * (1.0 - TOUCHING) || !self.is_apart(&a, &b) || self.ends_part(&a, self, &b) {
            return Ok(());
        }
        let point = a.point.midpoint(b.point).to_array();
        let [first, second] = [a, b].map(|place| self.spine.pieces[place.piece].source);
        Err(PipeError::MeetsItself { first: first.min(second), second: first.max(second), point, distance, limit }
            .into())
    }

    /// Points of the tube that are farther than the radius from the spine, or at it beside an end, with the place they belong to.
    fn outside_balls(&self) -> Vec<(Place, Point3)> {
        let mut points = Vec::new();
        let stations = self.spine.stations.iter().enumerate();
        for (k, station) in stations {
            let piece = k.min(self.spine.pieces.len() - 1);
            let own = Place { piece, point: station.point, way: if k == piece { self.before[k] } else { self.length } };
            if station.mitred {
                let [before, behind] = station.ways;
                // Outwards, as long as the miter is.
                let reach = 2.0 * self.radius / (before + behind).length();
                let Some(out) = (before - behind).unit() else { continue };
                let count = (2.0 * reach / self.radius).ceil() as usize;
                points.extend((1..=count).map(|i| (own, station.point + out * (reach * i as f64 / count as f64))));
            } else if self.way_out(&own).is_some() && self.ends != PipeEnds::Round {
                let [u, v, ..] = station.directions();
                let rim = (0..RIM).map(|i| i as f64 * 2.0 * PI / RIM as f64);
                points.extend(rim.map(|a| (own, station.point + (u * a.cos() + v * a.sin()) * self.radius)));
            }
        }
        points
    }

    /// Refuses a point of the tube that lies in the tube about a piece.
    fn check_point(&self, own: &Place, p: Point3, piece: usize) -> Result<()> {
        let foot = self.nearest_on(piece, p);
        let (distance, limit) = (foot.point.distance(p), self.radius);
        // At a plane end of the other piece the tube stops.
        let before_end = self.ends != PipeEnds::Round
            && self.way_out(&foot).is_some_and(|out| (p - foot.point).dot(out) > -TOUCHING * limit);
        if distance >= limit * (1.0 - TOUCHING) || before_end || !self.is_apart(own, &foot) {
            return Ok(());
        }
        let point = foot.point.midpoint(p).to_array();
        let [first, second] = [own.piece, piece].map(|piece| self.spine.pieces[piece].source);
        Err(PipeError::MeetsItself { first: first.min(second), second: first.max(second), point, distance, limit }
            .into())
    }

    fn nearest_on(&self, piece: usize, p: Point3) -> Place {
        let arc = &self.spine.pieces[piece].arc;
        let foot = arc.closest_point(p);
        Place { piece, point: foot.point, way: self.before[piece] + arc.piece_length(0, 0.0, foot.t) }
    }

    /// True if a plane end lies between both places: the tube stops there, half a ball short.
    fn ends_part(&self, a: &Place, other: &Self, b: &Place) -> bool {
        if self.ends == PipeEnds::Round {
            return false;
        }
        match (self.way_out(a), other.way_out(b)) {
            (None, None) => false,
            (Some(out), None) => self.is_before_disk(a.point, out, b.point),
            (None, Some(out)) => self.is_before_disk(b.point, out, a.point),
            (Some(one), Some(other)) => {
                // Each disk before the plane of the other one.
                let reach = self.radius * one.cross(other).length();
                let way = b.point - a.point;
                way.dot(one) >= reach || -way.dot(other) >= reach
            }
        }
    }

    /// True if a tube about a point is free of the disk at an end.
    fn is_before_disk(&self, center: Point3, out: Vec3, p: Point3) -> bool {
        let way = p - center;
        let ahead = way.dot(out);
        let beside = (way - out * ahead).length();
        ahead >= 0.0 && ahead.hypot((beside - self.radius).max(0.0)) >= self.radius * (1.0 - TOUCHING)
    }

    /// The direction out of the end that a place is.
    fn way_out(&self, place: &Place) -> Option<Vec3> {
        if self.spine.closed {
            return None;
        }
        let (first, last) = (self.spine.stations.first()?, self.spine.stations.last()?);
        if place.point == first.point {
            Some(-first.ways[0])
        } else if place.point == last.point {
            Some(last.ways[1])
        } else {
            None
        }
    }
}
