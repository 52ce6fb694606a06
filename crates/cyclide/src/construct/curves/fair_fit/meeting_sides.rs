//! Corners that the noise of measured points hides: where two straight runs of points meet in one of them, a smooth curve through
//! them all cuts the corner by more than the noise (`docs/math/fair-fits.md#noise`).

use super::FairFitOptions;
use super::edged::{Edged, in_plan};
use super::measured::read;
use super::noise::{self, Denoised};
use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::arc_fit::input::Distinct;
use crate::construct::curves::outline::CORNER_ANGLE;
use std::borrow::Cow;

/// Points on either side of a corner that must lie in a straight line, at least and at most,
const SIDE: [usize; 2] = [5, 60];
/// and over at least so many deviations of the noise, of which one edge is this part at most: a wrong point is far off.
const LENGTH: f64 = 12.0;
const EDGE: f64 = 0.5;
/// Points of a straight run are off its line by less than this many deviations of the noise.
const STRAIGHT: f64 = 3.0;
/// The corner itself may be this many times as far off both lines: it lies beyond their ends, where their direction counts too.
const BEYOND: f64 = 1.5;
/// The smooth curve is off the corner by more than this many deviations of the noise with it,
const OFF: f64 = 3.0;
/// and by more than this many of the noise without.
const OFF_BEFORE: f64 = 2.5;
/// What the smooth curve leaves is not the noise where neighbours tell less than this part of it.
const OF_CUTS: f64 = 0.6;
/// A curve that is free enough to bend in each corner is off none of them. All of them together are corners where the curve with them
/// leaves no more noise with this part of that freedom: for false ones it needs as much or more.
const FREEDOM: f64 = 0.7;
/// Rounds in which corners that the others explain are given up.
const ROUNDS: usize = 12;

/// The reading with those corners too, or as it was.
pub(super) fn with_meeting_sides(
    distinct: &Distinct,
    options: &FairFitOptions,
    edged: Edged,
    found: Denoised,
) -> (Edged, Denoised) {
    // A corner may have been an outlier of the smooth curve.
    let explains =
        |was: &Denoised, is: &Denoised| is.deviation < was.deviation || is.outliers.len() < was.outliers.len();
    let is_simpler =
        |was: &Denoised, is: &Denoised| is.deviation <= was.deviation && is.freedom() < FREEDOM * was.freedom();
    let (edged, found) = Meetings::new(distinct, options, &edged, &found)
        .each()
        .filter(|(_, sharp)| explains(&found, sharp))
        .unwrap_or((edged, found));
    Meetings::new(distinct, options, &edged, &found)
        .together()
        .filter(|(_, sharp)| is_simpler(&found, sharp))
        .unwrap_or((edged, found))
}

/// Points in which sides may meet.
struct Meetings<'a> {
    distinct: &'a Distinct,
    options: &'a FairFitOptions,
    edged: &'a Edged,
    points: Cow<'a, [Point3]>,
    /// How far the smooth curve is off each point.
    offs: Vec<f64>,
    /// What the noise may be.
    noises: [f64; 2],
}

impl<'a> Meetings<'a> {
    fn new(distinct: &'a Distinct, options: &'a FairFitOptions, edged: &'a Edged, found: &Denoised) -> Self {
        // Most points lie on sides, where their neighbours tell their noise: a curve that cuts corners everywhere takes the cuts for some.
        let most = noise::most_noise(&distinct.points, options.closed, found.directions).unwrap_or(found.deviation);
        let noises = [most.min(found.deviation), if most < OF_CUTS * found.deviation { most } else { found.deviation }];
        let points = in_plan(&distinct.points, options);
        let offs = offs(&distinct.points, &points, found);
        Self { distinct, options, edged, points, offs, noises }
    }

    /// The reading with the corners that the smooth curve cuts, each by more than the noise.
    fn each(&self) -> Option<(Edged, Denoised)> {
        let mut added = self.alone(OFF_BEFORE, |i, _| -self.offs[i]);
        for _ in 0..ROUNDS {
            let (sharper, sharp) = self.with(&added)?;
            let count = added.len();
            added.retain(|i| self.offs[*i] > OFF * sharp.deviation);
            if added.len() == count {
                return Some((sharper, sharp));
            }
        }
        None
    }

    /// The reading with all of them.
    fn together(&self) -> Option<(Edged, Denoised)> {
        self.with(&self.alone(0.0, |_, misfit| misfit))
    }

    fn with(&self, added: &[usize]) -> Option<(Edged, Denoised)> {
        if added.is_empty() {
            return None;
        }
        let mut corners: Vec<usize> = self.edged.corners.iter().chain(added).copied().collect();
        corners.sort_unstable();
        let sharper = Edged { corners, straight: self.edged.straight.clone() };
        let sharp = read(self.distinct, self.options, &sharper)?;
        Some((sharper, sharp))
    }

    /// Points that the smooth curve is off by that many deviations of the noise, of neighbours the least in rank, which is of a point and
    /// its distance from both sides.
    fn alone(&self, off: f64, rank: impl Fn(usize, f64) -> f64) -> Vec<usize> {
        let Self { points, options, offs, .. } = self;
        let n = offs.len();
        let meets = |i: usize| {
            let misfit = |noise: &f64| meet(points, i, options, *noise).filter(|_| offs[i] >= off * noise);
            self.noises.iter().find_map(misfit).filter(|_| self.edged.corners.binary_search(&i).is_err())
        };
        let all: Vec<(usize, f64)> = (0..n).filter_map(|i| Some((i, rank(i, meets(i)?)))).collect();
        let apart =
            |i: usize, j: usize| if options.closed { i.abs_diff(j).min(n - i.abs_diff(j)) } else { i.abs_diff(j) };
        let is_least = |a: &&(usize, f64)| all.iter().all(|b| a.0 == b.0 || apart(a.0, b.0) > SIDE[0] || a.1 < b.1);
        all.iter().filter(is_least).map(|a| a.0).collect()
    }
}

/// How far the smooth curve is off each point, in plan if that is where they are.
fn offs(points: &[Point3], plan: &[Point3], found: &Denoised) -> Vec<f64> {
    let is_plan = points != plan;
    let flat = |p: Point3| if is_plan { Point3::new(p.x, p.y, 0.0) } else { p };
    let mut offs = vec![0.0; plan.len()];
    for (i, place) in found.kept.iter().zip(&found.places) {
        offs[*i] = plan[*i].distance(flat(*place));
    }
    for (i, distance) in &found.outliers {
        if !is_plan {
            offs[*i] = *distance;
        } else if found.kept.binary_search(i).is_err() {
            // It may be off by its height alone.
            offs[*i] = beside_places(plan[*i], *i, found, flat);
        }
    }
    offs
}

/// How far a point is from the smoothed ones beside it.
fn beside_places(point: Point3, at: usize, found: &Denoised, flat: impl Fn(Point3) -> Point3) -> f64 {
    let after = found.kept.partition_point(|i| *i < at);
    let places = |k: usize| found.places.get(k).copied().map(&flat);
    match (after.checked_sub(1).and_then(&places), places(after)) {
        (Some(a), Some(b)) => noise::from_segment(point, a, b),
        (Some(only), None) | (None, Some(only)) => point.distance(only),
        (None, None) => 0.0,
    }
}

/// How far one point is off both lines, where the points on both sides of it lie in straight lines that meet in it, at an angle.
fn meet(points: &[Point3], at: usize, options: &FairFitOptions, noise: f64) -> Option<f64> {
    let n = points.len();
    let side = |forward: bool| {
        let count = if options.closed {
            (n - 1) / 2
        } else if forward {
            n - 1 - at
        } else {
            at
        };
        let all = (1..=count.min(SIDE[1])).map(|k| points[if forward { at + k } else { at + n - k } % n]);
        let mut own: Vec<Point3> = Vec::new();
        let mut longest = 0.0_f64;
        for p in all {
            let length = own.first().map_or(0.0, |first| p.distance(*first));
            longest = longest.max(p.distance(*own.last().unwrap_or(&points[at])));
            own.push(p);
            if own.len() >= SIDE[0] && length >= LENGTH * noise {
                let (middle, direction) = line(&own)?;
                let off = |p: &Point3| {
                    let v = *p - middle;
                    (v - direction * v.dot(direction)).length()
                };
                let meets = off(&points[at]) < BEYOND * STRAIGHT * noise;
                let straight = longest < EDGE * length && own.iter().all(|p| off(p) < STRAIGHT * noise);
                return (meets && straight).then_some((direction, off(&points[at])));
            }
        }
        None
    };
    let ((before, off_before), (after, off_after)) = side(false).zip(side(true))?;
    let turns = (-before).angle(after) > options.corner_angle.unwrap_or(CORNER_ANGLE);
    turns.then_some(off_before + off_after)
}

/// The straight line through points in order: a place, and its direction.
fn line(points: &[Point3]) -> Option<(Point3, Vec3)> {
    let n = points.len() as f64;
    let middle = points[0] + points.iter().fold(Vec3::ZERO, |sum, p| sum + (*p - points[0])) / n;
    let step = |(i, p): (usize, &Point3)| (*p - middle) * (i as f64 - 0.5 * (n - 1.0));
    let direction = points.iter().enumerate().map(step).fold(Vec3::ZERO, |sum, v| sum + v).unit()?;
    Some((middle, direction))
}
