//! Checks of what comes in, merging of equal neighbors, and the plane of the data (`docs/math/arc-fitting.md#limits`).

use crate::base::bounds::Aabb;
use crate::base::frame::Frame;
use crate::base::planar::Point2;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, NumberError, PointError, Result};
use crate::warning::{PointWarning, Warning};

/// Neighbors closer than this times the diameter are one point,
const MERGE_LIMIT: f64 = 1e-9;
/// unless the tolerance tells them apart: closer than this times the tolerance.
const MERGE_TOLERANCE: f64 = 0.01;
/// They are one point too if they are closer than this part of the usual edge, and of the tolerance: as a closing point is that was
/// rounded otherwise.
const MERGE_EDGE: f64 = 0.01;
const MERGE_WITHIN: f64 = 0.2;
/// Without a tolerance short edges are what was drawn, but for those below this part of the usual one, and for a closing edge that is
/// the only short one.
const MERGE_ROUNDED: f64 = 1e-5;
/// The last points of a closed polyline may be its first one again, drawn by hand: closer than this part of the usual edge, and of the
/// tolerance.
const SEAM_EDGE: f64 = 0.1;
const SEAM_WITHIN: f64 = 0.9;
/// Off-plane distances up to this times the diameter are rounding.
const PLANE_LIMIT: f64 = 1e-9;
/// Off-plane distances up to this times the tolerance do not matter.
const PLANE_TOLERANCE: f64 = 1e-3;

/// # Errors
/// `too-few-points`, `not-finite`.
pub(super) fn check_points(points: &[Point2], needed: usize) -> Result<()> {
    check(points.len(), needed, |i| points[i].is_finite())
}

fn check(given: usize, needed: usize, finite: impl Fn(usize) -> bool) -> Result<()> {
    if given < needed {
        return Err(PointError::TooFewPoints { given, needed }.into());
    }
    match (0..given).find(|i| !finite(*i)) {
        Some(index) => Err(NumberError::NotFinite { what: ErrorItem::Point, index }.into()),
        None => Ok(()),
    }
}

/// Which of the last points of a closed polyline count as its first one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::construct) enum Seam {
    /// Those that repeat it, as other neighbors do.
    Repeated,
    /// Those that are within the tolerance of it, and closer than neighbors are.
    Near,
}

/// Points that all differ from their neighbors, with the index each had in the user's list.
pub(in crate::construct) struct Distinct {
    pub points: Vec<Point3>,
    pub source: Vec<usize>,
    /// Points of the user's list from this index on were merged with the one at this position.
    tail: (usize, usize),
    pub warnings: Vec<Warning>,
    /// How far a point that was merged is from the one that stands for it.
    pub moved: f64,
}

impl Distinct {
    /// Merges neighbors that are equal to within the tolerance; an open polyline keeps its first and its last point, a
    /// closed one its first.
    ///
    /// # Errors
    /// `too-few-points`, `not-finite`, `coincident-points` (all equal).
    pub fn new(points: &[Point3], closed: bool, tolerance: f64) -> Result<Self> {
        Self::with_seam(points, closed, tolerance, Seam::Repeated)
    }

    /// The same where the last points may count as the first.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_seam(points: &[Point3], closed: bool, tolerance: f64, seam: Seam) -> Result<Self> {
        let needed = if closed { 3 } else { 2 };
        check(points.len(), needed, |i| points[i].is_finite())?;
        let diameter = diameter(points);
        if !diameter.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::DistanceFromPoint, index: 0 }.into());
        }
        let mut edges: Vec<f64> = points.windows(2).map(|w| w[0].distance(w[1])).collect();
        let usual = *edges.select_nth_unstable_by(points.len() / 2 - usize::from(points.len() < 3), f64::total_cmp).1;
        let limit = (MERGE_LIMIT * diameter).min(MERGE_TOLERANCE * tolerance);
        let near = (MERGE_EDGE * usual).min(MERGE_WITHIN * tolerance);
        let is_drawn = tolerance.is_infinite() && edges.iter().any(|edge| *edge > limit && *edge <= near);
        let at_seam = limit.max(match seam {
            Seam::Near => (SEAM_EDGE * usual).min(SEAM_WITHIN * tolerance),
            Seam::Repeated if is_drawn => MERGE_ROUNDED * usual,
            Seam::Repeated => near,
        });
        let limit = limit.max(if tolerance.is_infinite() { MERGE_ROUNDED * usual } else { near });
        let mut source = vec![0];
        for (i, p) in points.iter().enumerate().skip(1) {
            if p.distance(points[source[source.len() - 1]]) > limit {
                source.push(i);
            }
        }
        let last = points.len() - 1;
        let kept = source.len();
        let dropped = |source: &[usize]| (0..=last).find(|i| source.get(*i) != Some(i)).unwrap_or(last);
        let mut first = dropped(&source);
        let mut tail = (points.len(), 0);
        if closed {
            while source.len() > 1 && points[source[source.len() - 1]].distance(points[0]) <= at_seam {
                tail.0 = source.pop().unwrap_or(0);
            }
        } else if source.len() > 1 && source[kept - 1] != last {
            tail = (source[kept - 1], kept - 1);
            source[kept - 1] = last;
            first = dropped(&source);
        }
        if source.len() == 1 {
            let distance = points[0].distance(points[1]);
            return Err(PointError::CoincidentPoints { first: 0, second: 1, distance, limit }.into());
        }
        if source.len() < needed {
            return Err(PointError::TooFewPoints { given: source.len(), needed }.into());
        }
        let closing = closed && tail.0 < points.len();
        let closing = closing.then(|| {
            let distance = points[tail.0..].iter().map(|p| p.distance(points[0])).fold(0.0, f64::max);
            Warning::Point(PointWarning::ClosingPointMerged { index: tail.0, distance })
        });
        let count = points.len() - kept;
        let merged = (count > 0).then_some(Warning::Point(PointWarning::PointsMerged { first, count, limit }));
        let warnings = merged.into_iter().chain(closing).collect();
        let kept = source.iter().map(|i| points[*i]).collect();
        let mut distinct = Self { points: kept, source, tail, warnings, moved: 0.0 };
        if !distinct.warnings.is_empty() {
            let moved = |(i, p): (usize, &Point3)| p.distance(distinct.points[distinct.position(i)]);
            distinct.moved = points.iter().enumerate().map(moved).fold(0.0, f64::max);
        }
        Ok(distinct)
    }

    /// Points that were chosen or made from those of a list, each with the index it stands for, rising.
    pub fn of(points: Vec<Point3>, source: Vec<usize>, warnings: Vec<Warning>) -> Self {
        Self { points, source, tail: (usize::MAX, 0), warnings, moved: 0.0 }
    }

    /// The same points in another order.
    pub fn in_order(&self, order: &[usize]) -> Self {
        let points = order.iter().map(|i| self.points[*i]).collect();
        let source = order.iter().map(|i| self.source[*i]).collect();
        Self { points, source, tail: (usize::MAX, 0), warnings: self.warnings.clone(), moved: self.moved }
    }

    /// Position in the merged list, in the order it came in, of a point of the user's list.
    pub fn position(&self, index: usize) -> usize {
        let (first, position) = self.tail;
        if index >= first { position } else { self.source.partition_point(|s| *s <= index).saturating_sub(1) }
    }
}

/// Diagonal of the box around the points.
pub(in crate::construct) fn diameter(points: &[Point3]) -> f64 {
    let mut bounds = Aabb::of_point(points[0]);
    for p in &points[1..] {
        bounds = bounds.including(*p);
    }
    (bounds.max - bounds.min).length()
}

/// The frame of the plane the points lie in, with its origin in the first of them so that big offsets of the
/// coordinates cost no digits; `None` if they are not planar. Data in a coordinate plane get its axes.
pub(in crate::construct) fn plane(points: &[Point3], tolerance: f64) -> Option<Frame> {
    let origin = points[0];
    let farthest = |measure: &dyn Fn(Vec3) -> f64| {
        let values = points.iter().map(|p| *p - origin);
        values.max_by(|a, b| measure(*a).total_cmp(&measure(*b))).unwrap_or(Vec3::X)
    };
    let size = diameter(points);
    let along = farthest(&|v| v.length()).unit()?;
    let across = farthest(&|v| v.cross(along).length());
    let normal = if across.cross(along).length() > PLANE_LIMIT * size {
        along.cross(across).unit()?
    } else {
        // On a line: the plane that contains the first axes as far as possible.
        [Vec3::Z, Vec3::Y].into_iter().find(|n| n.dot(along).abs() < 1e-3).unwrap_or(along.any_perpendicular())
    };
    let leading = [normal.z, normal.y, normal.x].into_iter().find(|c| c.abs() > 0.5).unwrap_or(1.0);
    let frame = Frame::from_normal(origin, normal * leading.signum(), Vec3::X).ok()?;
    let limit = (PLANE_LIMIT * size).min(PLANE_TOLERANCE * tolerance);
    points.iter().all(|p| frame.to_local(*p).1.abs() <= limit).then_some(frame)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn merged_points_are_found_where_they_went() {
        let at = |xs: &[f64]| -> Vec<Point3> { xs.iter().map(|x| Point3::new(*x, x * x, 0.0)).collect() };
        let closed = Distinct::new(&at(&[0.0, 1.0, 1.0, 2.0, 0.0, 0.0]), true, 0.1).unwrap();
        assert_eq!([0, 1, 2, 3, 4, 5].map(|i| closed.position(i)), [0, 1, 1, 2, 0, 0]);
        let open = Distinct::new(&at(&[0.0, 0.0, 1.0, 2.0, 2.0]), false, 0.1).unwrap();
        assert_eq!([0, 1, 2, 3, 4].map(|i| open.position(i)), [0, 0, 1, 2, 2]);
        assert_eq!(open.source, [0, 2, 4]);
    }

    #[test]
    fn what_the_tolerance_tells_apart_stays() {
        // 1e-10 apart in data of size 2.
        let points = [0.0, 1.0, 1.0 + 1e-10, 2.0].map(|x| Point3::new(x, 0.0, 0.0));
        let merged = Distinct::new(&points, false, 0.1).unwrap();
        assert_eq!(merged.source, [0, 1, 3]);
        // The rounding of 1 + 1e-10.
        assert!((merged.moved - 1e-10).abs() < 1e-16);
        assert_eq!(Distinct::new(&points, false, 1e-10).unwrap().source, [0, 1, 2, 3]);
    }

    #[test]
    fn short_edges_of_an_outline_stay_where_there_is_no_tolerance() {
        // A strip of 300 by 0.5: its short edges are less than a hundredth of the others.
        let strip = [[0.0, 0.0], [300.0, 0.0], [300.0, 0.5], [0.0, 0.5]].map(|[x, y]| Point3::new(x, y, 0.0));
        let kept = |points: &[Point3]| Distinct::new(points, true, f64::INFINITY).unwrap().points.len();
        assert_eq!(kept(&strip), 4);
        let square = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [0.005, 0.0]];
        assert_eq!(kept(&square.map(|[x, y]| Point3::new(x, y, 0.0))), 4);
    }

    #[test]
    fn what_closes_is_said_to_repeat_the_first_point() {
        let at = |xs: &[f64]| -> Vec<Point3> { xs.iter().map(|x| Point3::new(*x, x * x, 0.0)).collect() };
        let reasons = |points: &[f64], seam| {
            let found = Distinct::with_seam(&at(points), true, 0.1, seam).unwrap();
            (found.points.len(), found.warnings.iter().map(Warning::reason).collect::<Vec<_>>())
        };
        assert_eq!(reasons(&[0.0, 1.0, 2.0, 0.0], Seam::Repeated), (3, vec!["closing-point-merged"]));
        let both = vec!["points-merged", "closing-point-merged"];
        assert_eq!(reasons(&[0.0, 1.0, 1.0, 2.0, 0.0], Seam::Repeated), (3, both));
        // Within the tolerance, and nearer than neighbors are.
        let near = [0.0, 1.0, 2.0, 0.05];
        assert_eq!(reasons(&near, Seam::Repeated), (4, vec![]));
        assert_eq!(reasons(&near, Seam::Near), (3, vec!["closing-point-merged"]));
        let found = Distinct::with_seam(&at(&near), true, 0.1, Seam::Near).unwrap();
        assert!((found.moved - 0.05_f64.hypot(0.0025)).abs() < 1e-15 && found.position(3) == 0);
        assert_eq!(reasons(&[0.0, 0.06, 0.12, 0.18, 0.24, 0.05], Seam::Near).0, 6);
        assert_eq!(reasons(&[0.0, 1.0, 2.0, 0.11], Seam::Near).0, 4);
    }

    #[test]
    fn a_closing_point_that_was_rounded_otherwise_is_merged() {
        let square = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [0.005, 0.0]];
        let points = square.map(|[x, y]| Point3::new(x, y, 0.0));
        assert_eq!(Distinct::new(&points, true, 0.05).unwrap().points.len(), 4);
        // The tolerance tells it apart.
        assert_eq!(Distinct::new(&points, true, 0.01).unwrap().points.len(), 5);
    }
}
