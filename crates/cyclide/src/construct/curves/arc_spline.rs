//! Tangent-continuous chains of arcs through points: one biarc per span, or one arc per span from a start tangent.
//!
//! Tangents at the points are given or estimated: at an inner point the tangent of the circle through it and its two
//! neighbors, at the ends of an open chain that circle's tangent at the end point
//! (`docs/math/arc-splines.md#three-point-tangents`):
//!
//! ```text
//! T_k ∝ e0 |e1|/|e0|² + e1/|e1|,   e0 = P_k - P_{k-1},  e1 = P_{k+1} - P_k
//! T_0 = reflect(T_1, P_1 - P_0),   T_{n-1} = reflect(T_{n-2}, P_{n-1} - P_{n-2})
//! ```
//! Local, and exact on circles and lines. The spline is G1 at every point and joint, curvature jumps.

use super::biarc::{Biarc, BiarcRule, starting};
use crate::base::vector::{Point3, Vec3};
use crate::curve::ArcPath;
use crate::error::{ArcError, Error, ErrorItem, NumberError, PointError, Result};

/// Two unit chords that sum to less than this turn back on themselves: their circle is a line through infinity and
/// its tangent is noise (`docs/math/circle-blends.md#node-tangent`, has the same limit).
const CUSP_LIMIT: f64 = 1e-9;

/// Options of [`ArcPath::spline`].
///
/// ```
/// use cyclide::{Point3, construct::ArcSplineOptions, curve::{ArcPath, joints}};
/// let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
/// let path = ArcPath::spline(&square, &ArcSplineOptions { closed: true, ..Default::default() })?;
/// assert!(joints(&path).iter().all(|joint| joint.angle < 1e-12)); // arcs, and no kinks
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ArcSplineOptions {
    /// Join the last point to the first; do not repeat the first point.
    pub closed: bool,
    /// How the joint inside each span is chosen.
    pub rule: BiarcRule,
    /// Directions at the points, of any length, one per point; estimated if absent.
    pub tangents: Option<Vec<Vec3>>,
}

impl ArcPath {
    /// The G1 arc spline through the points: a biarc per span, `2 (n-1)` arcs, `2 n` if closed. Arc `2k` ends in the
    /// joint of span `k`, which runs from point `k` to the next.
    ///
    /// # Errors
    /// `too-few-points` (fewer than 2, or 3 if closed), `not-finite`, `coincident-points` (neighbors, equal
    /// doubles; closed: last and first too), `tangent-undefined` (only for estimated tangents: the points turn back on
    /// themselves), `count-differs`; a span without a biarc gives the biarc's reason with the index of the span.
    pub fn spline(points: &[Point3], options: &ArcSplineOptions) -> Result<Self> {
        check_points(points, options.closed)?;
        let tangents = match &options.tangents {
            Some(given) if given.len() != points.len() => {
                return Err(NumberError::CountDiffers {
                    what: ErrorItem::Tangent,
                    given: given.len(),
                    needed: points.len(),
                }
                .into());
            }
            Some(given) => given.clone(),
            None => estimate_tangents(points, options.closed)?,
        };
        if let Some(index) = tangents.iter().position(|t| *t == Vec3::ZERO) {
            return Err(PointError::ZeroTangent { index }.into());
        }
        let spans = span_count(points.len(), options.closed);
        let mut arcs = Vec::with_capacity(2 * spans);
        for k in 0..spans {
            let next = (k + 1) % points.len();
            let biarc = Biarc::new(points[k], tangents[k], points[next], tangents[next], options.rule);
            arcs.extend(biarc.map_err(|e| e.in_span(k))?.arcs());
        }
        Ok(Self::from_joined(arcs, options.closed))
    }

    /// One arc per span from a single start direction; each arc starts in the end tangent of the one before,
    /// `T_{k+1} = 2<T_k,ĉ_k>ĉ_k - T_k` (`000`, (24), (25)). If closed, a last arc returns to the first point, in
    /// general with a kink there.
    ///
    /// An error of the start tangent is never damped and alternates in sign, so such chains oscillate: prefer
    /// [`spline`](Self::spline) unless this is what is wanted.
    ///
    /// # Errors
    /// `too-few-points`, `not-finite`, `coincident-points`, `zero-tangent`; `tangent-opposes-chord` with the index of
    /// the span where the chain would pass through infinity.
    pub fn chain_from_tangent(points: &[Point3], closed: bool, start_tangent: Vec3) -> Result<Self> {
        check_points(points, closed)?;
        if !start_tangent.is_finite() {
            return Err(NumberError::NotFinite { what: ErrorItem::Tangent, index: 0 }.into());
        }
        let mut t = start_tangent.unit().ok_or(PointError::ZeroTangent { index: 0 })?;
        let spans = span_count(points.len(), closed);
        let mut arcs = Vec::with_capacity(spans);
        for k in 0..spans {
            let (a, b) = (points[k], points[(k + 1) % points.len()]);
            arcs.push(starting(a, t, b).map_err(|e| e.in_span(k))?);
            // Normalized again: the reflection keeps the length only up to rounding, which would add up.
            t = t.reflect(chord(points, k)?).unit().ok_or(PointError::ZeroTangent { index: k })?;
        }
        Ok(Self::from_joined(arcs, closed))
    }
}

/// Unit tangents at the points, estimated from the circle through each point and its neighbors
/// (`docs/math/arc-splines.md#three-point-tangents`); exact where the points lie on a circle or line. Two points give
/// their chord.
///
/// ```
/// use cyclide::Point3;
/// // Those of the circle through three points.
/// let points = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point3::from);
/// let tangents = cyclide::construct::estimate_tangents(&points, false)?;
/// assert!(tangents.iter().zip(points).all(|(tangent, p)| tangent.dot(p.to_vec()).abs() < 1e-12));
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// `too-few-points` (fewer than 2, or 3 if closed), `not-finite`, `coincident-points` (neighbors); `tangent-undefined` where the
/// points turn back on themselves (sum of the unit chords at most 1e-9): split the points there.
pub fn estimate_tangents(points: &[Point3], closed: bool) -> Result<Vec<Vec3>> {
    check_points(points, closed)?;
    let n = points.len();
    if n == 2 {
        let u = chord(points, 0)?;
        return Ok(vec![u, u]);
    }
    let inner = |k: usize| {
        let (a, b) = ((k + n - 1) % n, k);
        let (u0, u1) = (chord(points, a)?, chord(points, b)?);
        let (l0, l1) = (points[a].distance(points[k]), points[k].distance(points[(k + 1) % n]));
        let sum = (u0 + u1).length();
        if sum <= CUSP_LIMIT {
            return Err(ArcError::Cusp { index: k, measured: sum, limit: CUSP_LIMIT }.into());
        }
        // u0/l0 + u1/l1, scaled so that neither quotient overflows.
        let m = l0.max(l1);
        (u0 * (l1 / m) + u1 * (l0 / m)).unit().ok_or(Error::Arc(ArcError::Cusp {
            index: k,
            measured: sum,
            limit: CUSP_LIMIT,
        }))
    };
    if closed {
        return (0..n).map(inner).collect();
    }
    let mut tangents = vec![Vec3::ZERO; n];
    for (k, tangent) in tangents.iter_mut().enumerate().take(n - 1).skip(1) {
        *tangent = inner(k)?;
    }
    // Reflections of unit vectors in unit chords: unit up to rounding.
    let end = |t: Vec3, span: usize| {
        t.reflect(chord(points, span)?).unit().ok_or(Error::Point(PointError::ZeroTangent { index: span }))
    };
    tangents[0] = end(tangents[1], 0)?;
    tangents[n - 1] = end(tangents[n - 2], n - 2)?;
    Ok(tangents)
}

fn span_count(points: usize, closed: bool) -> usize {
    if closed { points } else { points - 1 }
}

/// Unit chord of span `k` (cyclic).
fn chord(points: &[Point3], k: usize) -> Result<Vec3> {
    (points[(k + 1) % points.len()] - points[k])
        .unit()
        .ok_or(Error::Number(NumberError::NotFinite { what: ErrorItem::Chord, index: k }))
}

fn check_points(points: &[Point3], closed: bool) -> Result<()> {
    let needed = if closed { 3 } else { 2 };
    if points.len() < needed {
        return Err(PointError::TooFewPoints { given: points.len(), needed }.into());
    }
    if let Some(index) = points.iter().position(|p| !p.is_finite()) {
        return Err(NumberError::NotFinite { what: ErrorItem::Point, index }.into());
    }
    for first in 0..span_count(points.len(), closed) {
        let second = (first + 1) % points.len();
        let distance = points[first].distance(points[second]);
        if distance == 0.0 {
            return Err(PointError::CoincidentPoints { first, second, distance, limit: 0.0 }.into());
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{Arc, ParamCurve};

    fn circle(n: usize, turn: f64) -> Vec<Point3> {
        let at = |i: usize| {
            let (s, c) = (turn * i as f64 / n as f64).sin_cos();
            Point3::new(2.0 * c + 1.0, 2.0 * s, 0.5)
        };
        (0..n).map(at).collect()
    }

    /// Largest angle between neighboring arcs.
    fn kink(path: &ArcPath) -> f64 {
        let n = path.arcs().len();
        let joints = if path.is_closed() { n } else { n - 1 };
        (0..joints)
            .map(|i| {
                let u = path.arcs()[i].end_tangent().unwrap();
                let v = path.arcs()[(i + 1) % n].start_tangent().unwrap();
                u.cross(v).length().atan2(u.dot(v))
            })
            .fold(0.0, f64::max)
    }

    #[test]
    fn a_circle_is_reproduced_open_and_closed() {
        for closed in [false, true] {
            let points = circle(9, if closed { std::f64::consts::TAU } else { 4.0 });
            let path = ArcPath::spline(&points, &ArcSplineOptions { closed, ..Default::default() }).unwrap();
            assert_eq!(path.arcs().len(), if closed { 18 } else { 16 });
            for a in path.arcs() {
                assert!((a.curvature() - 0.5).abs() < 1e-13);
            }
            assert!(kink(&path) < 1e-14);
        }
    }

    #[test]
    fn the_chain_follows_a_circle_and_names_the_span_that_fails() {
        let points = circle(7, 4.0);
        let path = ArcPath::chain_from_tangent(&points, false, Vec3::Y).unwrap();
        assert!(kink(&path) < 1e-14);
        assert!(path.arcs().iter().all(|a| (a.curvature() - 0.5).abs() < 1e-13));
        // A line walked on, then back: the second span starts against its chord.
        let back = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 0.0, 0.0]].map(Point3::from);
        let e = ArcPath::chain_from_tangent(&back, false, Vec3::X).unwrap_err();
        assert_eq!((e.reason(), e.index()), ("tangent-opposes-chord", Some(1)));
    }

    #[test]
    fn collinear_points_give_segments() {
        let points: Vec<Point3> = [0.0, 1.0, 3.0, 3.5].map(|x| Point3::new(x, 2.0 * x, -x)).to_vec();
        let path = ArcPath::spline(&points, &ArcSplineOptions::default()).unwrap();
        assert!(path.arcs().iter().all(Arc::is_straight));
    }

    #[test]
    fn given_tangents_are_kept() {
        let points = circle(4, 3.0);
        let tangents = vec![Vec3::new(0.0, 0.0, 3.0), Vec3::X, Vec3::new(1.0, 1.0, 1.0), Vec3::new(0.0, -1e-3, 0.0)];
        let options = ArcSplineOptions { tangents: Some(tangents.clone()), ..Default::default() };
        let path = ArcPath::spline(&points, &options).unwrap();
        for (k, t) in tangents.iter().enumerate().take(3) {
            let got = path.arcs()[2 * k].start_tangent().unwrap();
            assert!((got - t.unit().unwrap()).length() < 1e-14);
        }
        assert!(kink(&path) < 1e-13);
    }

    #[test]
    fn refuses_by_name_and_place() {
        let point = |x: f64, y: f64| Point3::new(x, y, 0.0);
        let spline = |points: &[Point3], closed| {
            let e = ArcPath::spline(points, &ArcSplineOptions { closed, ..Default::default() }).unwrap_err();
            (e.reason(), e.index())
        };
        let (a, b, c) = (point(0.0, 0.0), point(1.0, 0.0), point(1.0, 1.0));
        assert_eq!(spline(&[a], false), ("too-few-points", None));
        assert_eq!(spline(&[a, b], true), ("too-few-points", None));
        assert_eq!(spline(&[a, b, b, c], false), ("coincident-points", Some(2)));
        assert_eq!(spline(&[a, b, c, a], true), ("coincident-points", Some(0)));
        assert_eq!(spline(&[a, b, point(f64::NAN, 0.0)], false), ("not-finite", Some(2)));
        // Turning back, by the same and by another length.
        for x in [0.0, 0.5] {
            assert_eq!(spline(&[a, b, point(x, 0.0), c], false), ("tangent-undefined", Some(1)));
        }
        let options = |tangents| ArcSplineOptions { tangents: Some(tangents), ..Default::default() };
        let e = ArcPath::spline(&[a, b, c], &options(vec![Vec3::X])).unwrap_err();
        assert_eq!(e.reason(), "count-differs");
        let e = ArcPath::spline(&[a, b, c], &options(vec![Vec3::X, Vec3::X, Vec3::ZERO])).unwrap_err();
        assert_eq!((e.reason(), e.index()), ("zero-tangent", Some(2)));
        let e = ArcPath::spline(&[a, b, c], &options(vec![Vec3::Y, -Vec3::Y, -Vec3::Y])).unwrap_err();
        assert_eq!((e.reason(), e.index()), ("no-finite-biarc", Some(1)));
    }

    #[test]
    fn two_points_give_their_segment() {
        let points = [[1.0, 2.0, 3.0], [4.0, 4.0, 4.0]].map(Point3::from);
        let path = ArcPath::spline(&points, &ArcSplineOptions::default()).unwrap();
        assert!(path.arcs().iter().all(Arc::is_straight));
        assert_eq!(path.point(1.0), points[1]);
    }
}
