//! A curve through `2n + 1` points: the quaternion Loewner system.
//!
//! With the nodes split into `n + 1` of the even and `n` of the odd indices,
//! ```text
//! sum over i of (a_2i - a_j)/(t_2i - t_j) w_2i = 0   for every odd j
//! x(t) = (sum a_2i w_2i/(t - t_2i)) (sum w_2i/(t - t_2i))^-1
//! ```
//! A null vector always exists. The curve meets a point if numerator and denominator do not both vanish there: `w_2i` of an even node,
//! the second sum of an odd one. Where one does, and only there, the other points lie on a curve of lower degree that
//! misses it (`docs/math/qb-interpolation.md#loewner-system`; source: `003`, (2), whose theorem lacks that condition).

use super::elimination::{NullVector, null_vector};
use super::finish::{ATTAINED, MISSED, QbInterpolation, end_points, one_point, placed, with_roots};
use super::frame::DataFrame;
use super::overdetermined::{MOST_CONDITIONS, from_some};
use super::parameters::NodeParameters;
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::Point3;
use crate::curve::QbCurve;
use crate::error::{ErrorItem, InterpolationError, NumberError, Result};

impl QbInterpolation {
    /// The curve through an odd number of points, in their order, at their parameters; those given have to be in `[0, 1]` and differ, in any
    /// order. Through `2n + 1` points it has the degree `n`, or less where they lie on a curve of lower degree. Of more than 25 points, which
    /// ask for a degree above 12, 25 that are spread over all make the curve, and the others have to be on it.
    ///
    /// # Errors
    /// `count-differs`, `even-point-count`, `not-finite`, `parameter-out-of-range`, `coincident-points` (of parameters by distance),
    /// `repeated-parameter`, `unattainable-point`, `degree-too-high` (above 12), `curve-through-infinity`.
    pub fn through_points(points: &[Point3], parameters: &NodeParameters) -> Result<Self> {
        if let NodeParameters::Given(given) = parameters
            && given.len() != points.len()
        {
            return Err(NumberError::CountDiffers {
                what: ErrorItem::Parameter,
                given: given.len(),
                needed: points.len(),
            }
            .into());
        }
        if points.len().is_multiple_of(2) {
            return Err(InterpolationError::EvenPointCount { given: points.len() }.into());
        }
        for (index, p) in points.iter().enumerate() {
            range::check_point(index, p.to_vec())?;
        }
        let t = parameters.of(points)?;
        check_parameters(&t)?;
        let frame = DataFrame::of(points);
        range::check_distance(frame.radius)?;
        if frame.radius <= 0.0 {
            return Self::finish(one_point(points[0]), frame, t, vec![1.0; points.len()]);
        }
        let local: Vec<Quat> = points.iter().map(|p| frame.local(*p)).collect();
        let check = |curve: &QbCurve| check_met(curve, &t, &local, frame);
        let (curve, attainability) = if t.len() <= MOST_CONDITIONS {
            let found = through(&t, &local, frame)?;
            check(&found.0)?;
            found
        } else {
            let through_some = |chosen: &[(usize, usize)]| {
                let (s, a): (Vec<f64>, Vec<Quat>) = chosen.iter().map(|(k, _)| (t[*k], local[*k])).unzip();
                through(&s, &a, frame).map(|(curve, _)| curve)
            };
            let curve = from_some(&in_order(&t), through_some, check)?;
            let attainability = t.iter().map(|t| curve.weight_at(*t)).collect();
            (curve, attainability)
        };
        let [start, end] = end_points(&t, points);
        Self::finish(curve.with_ends(start, end), frame, t, attainability)
    }
}

/// The curve through points in the frame of the data, before it is looked at, and what is left of its weight at each.
///
/// # Errors
/// `unattainable-point`.
fn through(t: &[f64], a: &[Quat], frame: DataFrame) -> Result<(QbCurve, Vec<f64>)> {
    let (solved, n) = (solve(t, a), t.len() / 2);
    let attainability = solved.attainability(t);
    check_attained(&attainability)?;
    let pairs = if solved.rank < n { drop_degree(t, a, solved.rank) } else { pairs_of(t, a, &solved.entries) };
    Ok((placed(pairs, frame, [None; 2]), attainability))
}

/// Refuses nodes of whose weight too little is left.
pub(super) fn check_attained(attainability: &[f64]) -> Result<()> {
    let failing: Vec<usize> = (0..attainability.len()).filter(|k| attainability[*k] <= ATTAINED).collect();
    match failing.first() {
        Some(&first) => Err(InterpolationError::UnattainablePoint {
            points: failing,
            measured: attainability[first],
            limit: ATTAINED,
        }
        .into()),
        None => Ok(()),
    }
}

/// The nodes as their parameters follow each other.
pub(super) fn in_order(t: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..t.len()).collect();
    order.sort_by(|a, b| t[*a].total_cmp(&t[*b]));
    order
}

/// Refuses parameters outside `[0, 1]` and equal ones.
pub(super) fn check_parameters(t: &[f64]) -> Result<()> {
    if let Some(value) = t.iter().find(|t| !(0.0..=1.0).contains(*t)) {
        return Err(
            NumberError::ParameterOutOfRange { name: ErrorItem::Parameter, value: *value, min: 0.0, max: 1.0 }.into()
        );
    }
    match in_order(t).windows(2).find(|w| t[w[0]] - t[w[1]] == 0.0) {
        Some(w) => {
            let [first, second] = [w[0].min(w[1]), w[0].max(w[1])];
            Err(InterpolationError::RepeatedParameter { first, second, value: t[first] }.into())
        }
        None => Ok(()),
    }
}

/// The weights of the even nodes.
fn solve(t: &[f64], a: &[Quat]) -> NullVector {
    let n = t.len() / 2;
    let entry = |i: usize, j: usize| (a[2 * i] - a[2 * j + 1]) * (1.0 / (t[2 * i] - t[2 * j + 1]));
    let rows = (0..n).map(|j| (0..=n).map(|i| entry(i, j)).collect()).collect();
    null_vector(rows, n + 1)
}

impl NullVector {
    /// For each node what is left of its weight, relative to what it is made of.
    fn attainability(&self, t: &[f64]) -> Vec<f64> {
        let largest = self.entries.iter().map(|w| w.norm()).fold(0.0, f64::max);
        let terms = |s: f64| self.entries.iter().enumerate().map(move |(i, w)| *w * (1.0 / (s - t[2 * i])));
        let odd = |s: f64| {
            let sum = terms(s).fold(Quat::ZERO, |sum, term| sum + term);
            sum.norm() / terms(s).map(Quat::norm).sum::<f64>()
        };
        (0..t.len()).map(|k| if k % 2 == 0 { self.entries[k / 2].norm() / largest } else { odd(t[k]) }).collect()
    }
}

/// The curve of lower degree through all points, from so many of them that are spread.
fn drop_degree(t: &[f64], a: &[Quat], degree: usize) -> Vec<(Quat, Quat)> {
    let order = in_order(t);
    let last = t.len() - 1;
    let chosen: Vec<usize> =
        (0..=2 * degree).map(|k| order[if degree > 0 { k * last / (2 * degree) } else { 0 }]).collect();
    let t: Vec<f64> = chosen.iter().map(|k| t[*k]).collect();
    let a: Vec<Quat> = chosen.iter().map(|k| a[*k]).collect();
    let solved = solve(&t, &a);
    pairs_of(&t, &a, &solved.entries)
}

/// The Bernstein pairs of a curve in barycentric form.
fn pairs_of(t: &[f64], a: &[Quat], weights: &[Quat]) -> Vec<(Quat, Quat)> {
    let n = weights.len() - 1;
    let mut pairs = vec![(Quat::ZERO, Quat::ZERO); n + 1];
    for (i, w) in weights.iter().enumerate() {
        let others = (0..=n).filter(|k| *k != i).map(|k| t[2 * k]);
        for (pair, f) in pairs.iter_mut().zip(with_roots(others)) {
            let d = *w * f;
            *pair = (pair.0 + a[2 * i] * d, pair.1 + d);
        }
    }
    pairs
}

/// Refuses a curve that misses a point, in the frame of the data.
fn check_met(curve: &QbCurve, t: &[f64], a: &[Quat], frame: DataFrame) -> Result<()> {
    let distance = |k: usize| (curve.local_point(t[k]) / frame.radius - a[k].vector()).length();
    let missed: Vec<usize> = (0..t.len()).filter(|k| !(distance(*k) <= MISSED)).collect();
    match missed.first() {
        Some(&first) => {
            Err(InterpolationError::UnattainablePoint { points: missed, measured: distance(first), limit: MISSED }
                .into())
        }
        None => Ok(()),
    }
}
