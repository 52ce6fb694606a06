//! Corners that the noise of measured points hides: where two straight runs of points meet in one of them, a smooth curve through
//! them all cuts the corner by more than the noise (`docs/math/fair-fits.md#noise`).

use super::FairFitOptions;
use super::edged::Edged;
use super::measured::read;
use super::noise::{self, Denoised};
use crate::base::vector::{Point3, Vec3};
use crate::construct::curves::arc_fit::input::Distinct;
use crate::construct::curves::outline::CORNER_ANGLE;

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
/// Rounds in which corners that the others explain are given up.
const ROUNDS: usize = 12;

/// The reading with those corners too, or as it was.
pub(super) fn with_meeting_sides(
    distinct: &Distinct,
    options: &FairFitOptions,
    edged: Edged,
    found: Denoised,
) -> (Edged, Denoised) {
    let offs = offs(&distinct.points, &found);
    // Most points lie on sides, where their neighbours tell their noise: a curve that cuts corners everywhere takes the cuts for some.
    let most = noise::most_noise(&distinct.points, options.closed, found.directions).unwrap_or(found.deviation);
    let noises = [most.min(found.deviation), if most < OF_CUTS * found.deviation { most } else { found.deviation }];
    let meets = |i: &usize| {
        let meets = |noise: &f64| offs[*i] > OFF_BEFORE * noise && meet(&distinct.points, *i, options, *noise);
        edged.corners.binary_search(i).is_err() && noises.iter().any(meets)
    };
    let mut added: Vec<usize> = (0..offs.len()).filter(meets).collect();
    // Of neighbours the farthest.
    let n = offs.len();
    let apart = |i: usize, j: usize| if options.closed { i.abs_diff(j).min(n - i.abs_diff(j)) } else { i.abs_diff(j) };
    let all = added.clone();
    added.retain(|i| all.iter().all(|j| i == j || apart(*i, *j) > SIDE[0] || offs[*j] < offs[*i]));
    for _ in 0..ROUNDS {
        if added.is_empty() {
            break;
        }
        let mut corners: Vec<usize> = edged.corners.iter().chain(&added).copied().collect();
        corners.sort_unstable();
        let sharper = Edged { corners, straight: edged.straight.clone() };
        let Some(sharp) = read(distinct, options, &sharper) else { break };
        let count = added.len();
        added.retain(|i| offs[*i] > OFF * sharp.deviation);
        if added.len() == count {
            // A corner may have been an outlier of the smooth curve.
            let explains = sharp.deviation < found.deviation || sharp.outliers.len() < found.outliers.len();
            return if explains { (sharper, sharp) } else { (edged, found) };
        }
    }
    (edged, found)
}

/// How far the smooth curve is off each point.
fn offs(points: &[Point3], found: &Denoised) -> Vec<f64> {
    let mut offs = vec![0.0; points.len()];
    for (i, place) in found.kept.iter().zip(&found.places) {
        offs[*i] = points[*i].distance(*place);
    }
    for (i, distance) in &found.outliers {
        offs[*i] = *distance;
    }
    offs
}

/// Whether the points on both sides of one lie in straight lines that meet in it, at an angle.
fn meet(points: &[Point3], at: usize, options: &FairFitOptions, noise: f64) -> bool {
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
                return (meets && straight).then_some(direction);
            }
        }
        None
    };
    let turn = side(false).zip(side(true)).map_or(0.0, |(before, after)| (-before).angle(after));
    turn > options.corner_angle.unwrap_or(CORNER_ANGLE)
}

/// The straight line through points in order: a place, and its direction.
fn line(points: &[Point3]) -> Option<(Point3, Vec3)> {
    let n = points.len() as f64;
    let middle = points[0] + points.iter().fold(Vec3::ZERO, |sum, p| sum + (*p - points[0])) / n;
    let step = |(i, p): (usize, &Point3)| (*p - middle) * (i as f64 - 0.5 * (n - 1.0));
    let direction = points.iter().enumerate().map(step).fold(Vec3::ZERO, |sum, v| sum + v).unit()?;
    Some((middle, direction))
}
