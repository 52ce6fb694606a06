//! Three points and the derivatives at both ends: degree 2, in closed form without a division by a tangent
//! (`docs/math/qb-interpolation.md#three-points-and-two-tangents`; source: `003`, (9) to (11), whose conditions are incomplete).
//!
//! ```text
//! tau = t/(1 - t),  d = a4 - a0
//! L = tau d42 - d20 d^-1 v1,   R = d20/tau - d42 d^-1 v0
//! den: 1, (d^-1 v1 P2 + d^-1 v0)/2, P2 = L^-1 R      num: a0, a0 P1 + v0/2, a4 P2
//! ```

use super::finish::{MISSED, QbInterpolation, placed};
use super::frame::DataFrame;
use super::hermite::QbNode;
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::curve::QbCurve;
use crate::error::{Error, ErrorItem, InterpolationError, NumberError, Result};

/// `L`, `R` or the denominator in the middle up to this part of what they are sums of vanish.
const VANISHES: f64 = 1e-11;

/// Derivatives are at most as many sizes of the data long: third derivatives hold powers of them.
const MOST_SPEED: f64 = 1e30;

impl QbInterpolation {
    /// The curve of degree 2 that starts at the first point with the first derivative, passes the second at `t`, and ends at the third with
    /// the second derivative. A derivative may be zero: the curve then has a cusp there. Of one arc the degree is 1.
    ///
    /// ```
    /// use cyclide::{Point3, Vec3, construct::QbInterpolation};
    /// let points = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.5], [2.0, 0.0, 0.0]].map(Point3::from);
    /// let found = QbInterpolation::three_points_two_tangents(points, [Vec3::Y * 3.0, Vec3::Y * -3.0], 0.5)?;
    /// assert!(found.curve().point(0.5).distance(points[1]) < 1e-15);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `parameter-out-of-range` (`t` in `(0, 1)`, derivatives beyond 1e30 sizes of the data), `not-finite`, `unattainable-point` (of the three points 0, 1 or 2),
    /// `curve-through-infinity`.
    pub fn three_points_two_tangents(points: [Point3; 3], tangents: [Vec3; 2], t: f64) -> Result<Self> {
        for (index, p) in points.iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        for (index, v) in tangents.iter().enumerate() {
            range::check_derivative(index, *v)?;
        }
        if !(t > 0.0 && t < 1.0) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::T, value: t, min: 0.0, max: 1.0 }.into());
        }
        let parameters = vec![0.0, t, 1.0];
        let frame = DataFrame::of(&points);
        range::check_distance(frame.radius)?;
        let (value, max) = (tangents.iter().map(|v| v.length()).fold(0.0, f64::max), MOST_SPEED * frame.radius);
        if value > max && frame.radius > 0.0 {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::Tangent, value, min: 0.0, max }.into());
        }
        let Some(inverse) = Quat::from(points[2] - points[0]).inverse() else {
            // Closed: no chord to divide by.
            let node =
                |k: usize, derivatives: Vec<Vec3>| QbNode { parameter: parameters[k], point: points[k], derivatives };
            return Self::through_nodes(&[node(0, vec![tangents[0]]), node(1, Vec::new()), node(2, vec![tangents[1]])]);
        };
        let pairs = closed_form(points, tangents, t, inverse, frame)?;
        let curve = placed(pairs, DataFrame { radius: 1.0, ..frame }, [Some(points[0]), Some(points[2])]);
        check_met(&curve, points, tangents, t, frame)?;
        let attainability = parameters.iter().map(|t| curve.weight_at(*t)).collect();
        Self::finish(curve, frame, parameters, attainability)
    }
}

/// The pairs, measured from the center of the data.
fn closed_form(
    [a0, a2, a4]: [Point3; 3],
    [v0, v1]: [Vec3; 2],
    t: f64,
    inverse: Quat,
    frame: DataFrame,
) -> Result<Vec<(Quat, Quat)>> {
    let tau = t / (1.0 - t);
    let (d20, d42) = (Quat::from(a2 - a0), Quat::from(a4 - a2));
    let (alpha, beta) = (inverse * Quat::from(v0), inverse * Quat::from(v1));
    let left = (d42 * tau, d20 * beta);
    let right = (d20 * (1.0 / tau), d42 * alpha);
    let vanishes = |(a, b): (Quat, Quat)| (a - b).norm() <= VANISHES * (a.norm() + b.norm());
    let measure = |(a, b): (Quat, Quat)| (a - b).norm() / (a.norm() + b.norm()).max(f64::MIN_POSITIVE);
    let missed = |point: usize, measured: f64| {
        Error::Interpolation(InterpolationError::UnattainablePoint { points: vec![point], measured, limit: VANISHES })
    };
    let local = |p: Point3| Quat::from(p - frame.center);
    match (vanishes(left), vanishes(right)) {
        (true, true) => return Ok(vec![(local(a0), Quat::ONE), (local(a4) * alpha, alpha)]),
        (true, false) => return Err(missed(0, measure(left))),
        (false, true) => return Err(missed(2, measure(right))),
        (false, false) => {}
    }
    let last = (left.0 - left.1).inverse().unwrap_or(Quat::ZERO) * (right.0 - right.1);
    let middle = (beta * last + alpha) * 0.5;
    let s = 1.0 - t;
    let terms = [Quat::ONE * (s * s), middle * (2.0 * s * t), last * (t * t)];
    let (sum, size) = (terms[0] + terms[1] + terms[2], terms.iter().map(|q| q.norm()).sum::<f64>());
    if sum.norm() <= VANISHES * size {
        return Err(missed(1, sum.norm() / size));
    }
    Ok(vec![(local(a0), Quat::ONE), (local(a0) * middle + Quat::from(v0 * 0.5), middle), (local(a4) * last, last)])
}

/// Refuses a curve that misses a point or a tangent: between the limit above and 1e-8 rounding is divided by little.
fn check_met(curve: &QbCurve, points: [Point3; 3], tangents: [Vec3; 2], t: f64, frame: DataFrame) -> Result<()> {
    let r = frame.radius;
    let place = (curve.local_point(t) - (points[1] - frame.center)).length() / r;
    let slope = |end: f64, v: Vec3| (curve.jet(end).d1 - v).length() / (v.length() + r);
    let [first, last] = [slope(0.0, tangents[0]), slope(1.0, tangents[1])];
    match [(0, first), (1, place), (2, last)].into_iter().find(|(_, off)| !(*off <= MISSED)) {
        Some((point, measured)) => {
            Err(InterpolationError::UnattainablePoint { points: vec![point], measured, limit: MISSED }.into())
        }
        None => Ok(()),
    }
}
