//! Which points of a polyline are corners, and which of its edges are straight sides: the reading of points that are
//! given without a word about what they are (`docs/math/arc-fitting.md#outlines`).
//!
//! Points are samples of a smooth curve wherever such a curve explains them. Nobody samples a curve with fewer than six
//! points to a full turn, and no sampling (equal steps, equal angles, equal sagittas) jumps in length and sagitta at
//! once from one edge to the next but where the curve turns into a straight line. So a point is a *corner* that turns
//! more than samples do, and an edge is a *straight side* that is much longer than the samples beside it and would be
//! left by much more than they are. Everything is measured in angles and in ratios of lengths; the tolerance only says
//! what noise may have caused.

mod decimals;
mod predicted;
mod reader;
mod sides;
mod straight_runs;
mod turns;

use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::input::diameter;
use crate::warning::{FitWarning, Warning};
pub(super) use decimals::decimal_step;
use reader::Reader;
use std::f64::consts::PI;

/// No smooth curve is farther than this part of it from the edge between two of its samples: an arc of 65 degrees, more than which
/// none has between two (`docs/math/arc-fitting.md#outlines`).
pub(super) const SAMPLE_SAGITTA: f64 = 0.146;
/// A finer reading of an outline has at most this many times the corners.
const MORE: usize = 2;
/// Where a curve leaves the edges, corners and sides are looked for that last over these parts of the tolerance: details of an
/// outline may be smaller than that, and its sides are not. With them the curve
pub(super) const FINER: [f64; 2] = [1.0 / 8.0, 1.0 / 64.0];
/// has to be within this many tolerances of all edges.
pub(super) const NEAR: f64 = 2.0;
/// Turns above this may be corners.
pub(super) const CORNER_ANGLE: f64 = PI / 6.0;
/// A turn above this is a reversal: no smooth curve turns so far from one sample to the next.
const CUSP_ANGLE: f64 = 150.0 * PI / 180.0;
/// No smooth curve is sampled with fewer points to a full turn than this angle gives; a hexagon turns by 60 degrees.
const LARGEST_SAMPLE_TURN: f64 = 65.0 * PI / 180.0;
/// Corners leave others without support; so often at most.
const MAX_PASSES: usize = 16;
/// Figures of fewer points than this are polygons as well as samples,
const FEW_POINTS: usize = 24;
/// if their points turn by more than this: a 24th of a full turn.
const LARGE_TURN: f64 = PI / 12.0;
/// Turns below this, a sixtieth of a degree, are none.
const SOME_TURN: f64 = PI / 10_800.0;
/// A curve through samples is farther from their polyline than this many tolerances.
const AWAY: f64 = 2.0;
/// Without a tolerance noise may move points by this part of their size.
const EXACT: f64 = 1e-9;

/// What the points of a polyline are read as.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::construct) struct Outline {
    /// Corners in ascending order, with their turn in radians; the ends of an open polyline are none.
    pub corners: Vec<(usize, f64)>,
    /// Whether the edge that begins at each point is a straight side: the curve keeps to it, both ways. (The last entry of
    /// an open polyline means nothing.)
    pub straight: Vec<bool>,
    /// Whether the curve keeps to the edge that begins at each point: straight sides, and in an outline with corners or
    /// straight sides the edges between samples as far as arcs of several samples can keep to them.
    pub bound: Vec<bool>,
    /// Whether points that are not where their neighbors say were taken for noisy samples.
    pub has_noise: bool,
    /// Points where a straight run of others ends at an angle that no samples have: corners whatever noise may do.
    pub firm: Vec<usize>,
}

/// What points are that are not where their neighbors say.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scattered {
    /// Vertices of an outline.
    Vertices,
    /// Measured, with noise.
    Noise,
}

impl Outline {
    /// Reads the points of a polyline; neighbors must differ.
    ///
    /// `angle`, in radians: turns above it are corners and nothing else is, but for the points `forced` (by index,
    /// ascending). `None`: turns above 30 degrees, where samples of a smooth curve do not explain them, and reversals, above
    /// 150 degrees. `tolerance`: how far noise may have moved the points. `scattered`: whether it may have moved them farther.
    pub fn read(
        points: &[Point3],
        closed: bool,
        tolerance: f64,
        angle: Option<f64>,
        forced: &[usize],
        scattered: Scattered,
    ) -> Self {
        let mut reader = Reader::new(points, closed, tolerance, scattered);
        let noisy = scattered == Scattered::Noise && reader.is_noisy();
        let limit = angle.unwrap_or(CORNER_ANGLE) * (1.0 + 1e-9);
        for i in 0..points.len() {
            let turn = reader.turn(i);
            let evident = turn > limit && (angle.is_some() || reader.is_evident_corner(i, noisy));
            let evident = evident || (angle.is_none() && reader.is_firm(i) && reader.lasts(i));
            // Points that noise moves past each other turn back too.
            let reversal = angle.is_none() && turn > CUSP_ANGLE && reader.lasts(i);
            reader.corner[i] = reader.is_inside(i) && (forced.binary_search(&i).is_ok() || reversal || evident);
        }
        if noisy {
            return reader.finished(false);
        }
        reader.find_straight_sides();
        if angle.is_none() {
            reader.zigzags().into_iter().for_each(|i| reader.corner[i] = true);
            for _ in 0..MAX_PASSES {
                let (mut turns, edges) = (reader.unsupported_turns(limit), reader.edges_between_scattered_points());
                turns.extend(reader.kinks());
                if turns.is_empty() && edges.is_empty() {
                    break;
                }
                turns.into_iter().for_each(|i| reader.corner[i] = true);
                edges.into_iter().for_each(|edge| reader.held[edge] = true);
                reader.find_straight_sides();
            }
        }
        let has_sides = reader.corner.contains(&true) || reader.straight.contains(&true);
        reader.finished(has_sides)
    }

    /// The other reading, of a finer tolerance, is another one of the same figure: it has more details, where noise would have
    /// nothing else.
    pub fn is_coarser(&self, other: &Self) -> bool {
        self != other && other.corners.len() <= MORE * self.corners.len()
    }

    /// What is said where points of an outline, or of a figure of few points, that turn by a lot were read as samples, and that matters:
    /// the curve is `distance` from their polyline. `has_target`: the fit has a target `polyline` that keeps to all edges.
    pub fn read_as_curve(
        &self,
        points: &[Point3],
        closed: bool,
        tolerance: f64,
        distance: f64,
        has_target: bool,
    ) -> Option<Warning> {
        let n = points.len();
        let is_few = n < FEW_POINTS;
        if !(is_few || self.has_noise || self.bound.contains(&true)) || distance <= AWAY * tolerance {
            return None;
        }
        let is_sample = |i: &usize| {
            let corner = self.corners.binary_search_by_key(i, |corner| corner.0).is_ok();
            !corner && !self.straight[*i] && !self.straight[(i + n - 1) % n]
        };
        // Few points are a polygon as well whatever they turn by.
        let least = if is_few { SOME_TURN } else { LARGE_TURN };
        let turn = |i: usize| (points[i] - points[(i + n - 1) % n]).angle(points[(i + 1) % n] - points[i]);
        let inside = if closed { 0..n } else { 1..n - 1 };
        let (count, turn) = inside
            .filter(is_sample)
            .map(turn)
            .filter(|turn| *turn > least)
            .fold((0, 0.0_f64), |most, turn| (most.0 + 1, most.1.max(turn)));
        (count > 0).then_some(Warning::Fit(FitWarning::ReadAsCurve { count, turn, distance, has_target }))
    }
}

/// What the points of a polyline are if no curve is meant: the numbers of those that are corners, and of those where an edge begins
/// that is a straight side, both ascending. A polyline of samples of a smooth curve has neither (`docs/math/arc-fitting.md#outlines`).
///
/// Lengths may have any unit. Two equal neighbors, or fewer than three points, or numbers that are not finite: there are none.
///
/// ```
/// use cyclide::{Point3, construct::outline_corners};
/// let rectangle = [[0.0, 0.0], [60.0, 0.0], [60.0, 40.0], [0.0, 40.0]].map(|[x, y]| Point3::new(x, y, 0.0));
/// assert_eq!(outline_corners(&rectangle, true), (vec![0, 1, 2, 3], vec![]));
/// let circle: Vec<Point3> = (0..40).map(|k| f64::from(k) * 0.157).map(|a| Point3::new(a.cos(), a.sin(), 0.0)).collect();
/// assert_eq!(outline_corners(&circle, false), (vec![], vec![]));
/// ```
#[must_use]
pub fn outline_corners(points: &[Point3], closed: bool) -> (Vec<usize>, Vec<usize>) {
    let n = points.len();
    let edges = if closed { n } else { n.saturating_sub(1) };
    let edge = |i: usize| points[i].distance(points[(i + 1) % n]);
    let size = diameter(points);
    if n < 3 || !size.is_finite() || (0..edges).any(|i| !(edge(i) > EXACT * size)) {
        return (Vec::new(), Vec::new());
    }
    let outline = Outline::read(points, closed, EXACT * size, None, &[], Scattered::Vertices);
    let sides = (0..edges).filter(|i| outline.straight[*i]).collect();
    (outline.corners.into_iter().map(|corner| corner.0).collect(), sides)
}

/// What is said of corners that are kept, one line for all of them; `source` has the number of each point in the user's list.
pub(in crate::construct) fn kept_corners(corners: &[(usize, f64)], source: &[usize]) -> Option<Warning> {
    let (_, angle) = *corners.first()?;
    let angles = corners.iter().map(|corner| corner.1);
    let (least, most) = angles.fold((angle, angle), |(least, most), a| (least.min(a), most.max(a)));
    let vertex = corners.iter().map(|corner| source[corner.0]).min()?;
    Some(Warning::Fit(FitWarning::CornerKept { vertex, count: corners.len(), least, most }))
}

#[cfg(test)]
mod tests;
