//! Paths of points of a body under a rational motion: exact rational curves of twice the degree.

use super::rational_motion::RationalMotion;
use crate::base::vector::{Point3, Vec3};
use crate::error::{ErrorItem, NumberError, Result};
use crate::rational::{NurbsCurve, RationalBezier};

/// Ends that differ by up to this part of the coordinates are one, if they also do
const SAME_PLACE: f64 = 1e-12;
/// by this part of the extent of the path: far from the origin all of a short path is rounding.
const SAME_END: f64 = 1e-6;
/// Parts of a path up to so many roundings of its coordinates are points: of the products with the rotation and their sums.
const AT_REST: f64 = 64.0 * f64::EPSILON;
/// Slopes of homogeneous coordinates that differ by less than this part of the largest are one.
const SAME_SLOPE: f64 = 1e-12;

impl RationalMotion {
    /// The path of a point of the body: exact, of twice the [degree](Self::degree), over the knots `[0, 1]`, which are the
    /// times on the scale of the whole motion. Where the motion is C1, so are the knots (of multiplicity one less than the degree). Spans over which
    /// the point rests are no part of it, and their times are left out.
    ///
    /// # Errors
    /// `not-finite` (the point is not, or its path overflows).
    pub fn trajectory(&self, point: Point3) -> Result<NurbsCurve> {
        if !point.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Point, index: 0 }.into());
        }
        let motion = self.without_rests().with_positive_weights();
        let mut all = Vec::with_capacity(motion.times().len() - 1);
        for (row, ends) in
            motion.homogeneous_paths_about_centre([point.x, point.y, point.z, 1.0]).zip(motion.times().windows(2))
        {
            let curve = RationalBezier::new(RationalBezier::from_polynomial_row(&row).rows().to_vec())?;
            all.push((curve, ends[1] - ends[0]));
        }
        // A turn about the point moves it no more than a rest.
        if all.iter().any(|(curve, _)| !is_at_rest(curve, motion.centre())) {
            all.retain(|(curve, _)| !is_at_rest(curve, motion.centre()));
        }
        let (mut curves, mut times): (Vec<RationalBezier>, _) = (Vec::new(), vec![motion.times()[0]]);
        for (curve, step) in all {
            times.push(times[times.len() - 1] + step);
            // One point for both, also where rounding is more than the coordinates, near the origin.
            let start = curves.last().map(|before| before.point(1.0));
            curves.push(curve.with_ends(start, None));
        }
        // A motion that comes back to rounding closes the path.
        if let (Some(first), Some(last)) = (curves.first(), curves.last()) {
            let (start, end) = (first.point(0.0), last.point(1.0));
            let extent = curves.iter().map(|curve| curve.point(0.5).distance(start)).fold(0.0, f64::max);
            let size = (start.to_vec() + motion.centre()).max_abs().max(extent);
            let apart = start.distance(end);
            if apart <= SAME_PLACE * size && apart <= SAME_END * extent {
                let closed = last.clone().with_ends(None, Some(start));
                curves.pop();
                curves.push(closed);
            }
        }
        let degree = curves.iter().map(RationalBezier::degree).max().unwrap_or(1);
        let curves: Vec<RationalBezier> = curves.iter().map(|curve| raised(curve, degree)).collect();
        joined(&curves, &times, motion.centre())
    }
}

/// Whether a path, in coordinates from a center, is one point to rounding.
fn is_at_rest(curve: &RationalBezier, centre: Vec3) -> bool {
    let points = || curve.rows().iter().map(|[x, y, z, w]| Vec3::new(x / w, y / w, z / w));
    let start = curve.point(0.0).to_vec();
    let size = points().map(Vec3::max_abs).fold(centre.max_abs(), f64::max);
    points().all(|p| (p - start).max_abs() <= AT_REST * size)
}

/// The curve with a degree that is not lower.
fn raised(curve: &RationalBezier, degree: usize) -> RationalBezier {
    match degree - curve.degree() {
        0 => curve.clone(),
        more => curve.multiplied(&vec![1.0; more + 1]),
    }
}

/// The curves as one B-spline over `[0, 1]`, moved by a vector. A joint at which the homogeneous forms meet C1 lies between its neighbors: it is left out, and
/// the knot is there once less.
fn joined(curves: &[RationalBezier], times: &[f64], by: Vec3) -> Result<NurbsCurve> {
    let degree = curves[0].degree();
    let duration = times[times.len() - 1] - times[0];
    let mut knots = vec![0.0; degree + 1];
    let mut rows: Vec<[f64; 4]> = Vec::new();
    for (i, curve) in curves.iter().enumerate() {
        let (rest, end) = (&curve.rows()[1..], (times[i + 1] - times[0]) / duration);
        rows.extend(if i == 0 { curve.rows() } else { rest });
        let Some(next) = curves.get(i + 1) else {
            knots.extend(std::iter::repeat_n(1.0, degree + 1));
            break;
        };
        let steps = [times[i + 1] - times[i], times[i + 2] - times[i + 1]];
        let smooth = degree > 1 && meet_smoothly(curve.rows(), next.rows(), steps);
        if smooth {
            rows.pop();
        }
        knots.extend(std::iter::repeat_n(end, degree - usize::from(smooth)));
    }
    let points = rows.iter().map(|[x, y, z, w]| Point3::new(x / w, y / w, z / w) + by).collect();
    NurbsCurve::new(degree, knots, points, rows.iter().map(|row| row[3]).collect())
}

/// Whether the homogeneous derivatives of two curves are one where they meet, to rounding.
fn meet_smoothly(before: &[[f64; 4]], after: &[[f64; 4]], [h0, h1]: [f64; 2]) -> bool {
    let last = before.len() - 1;
    (0..4).all(|d| {
        let (left, right) = ((before[last][d] - before[last - 1][d]) / h0, (after[1][d] - after[0][d]) / h1);
        let size = before.iter().chain(after).fold(0.0, |m: f64, row| m.max(row[d].abs()));
        (left - right).abs() <= SAME_SLOPE * (left.abs() + right.abs() + size / h0.min(h1))
    })
}
