//! A curve through points with derivatives: the same system, confluent.
//!
//! A node with the Taylor coefficients `c_0, ..., c_(m-1)` of the curve at its parameter asks of those of numerator and denominator
//! ```text
//! n_k - sum over j of c_j d_(k-j) = 0,   k < m
//! ```
//! in the `2n + 2` Bernstein coefficients of a curve of degree `n`, with `2n + 1` conditions in all
//! (`docs/math/qb-interpolation.md#derivatives`; own derivation).

use super::elimination::null_vector;
use super::finish::{MISSED, QbInterpolation, end_points, one_point, placed};
use super::frame::DataFrame;
use super::loewner::{check_attained, check_parameters, in_order};
use super::overdetermined::{MOST_CONDITIONS, from_some};
use crate::base::quat::Quat;
use crate::base::range;
use crate::base::vector::{Point3, Vec3};
use crate::curve::QbCurve;
use crate::error::{ErrorItem, InterpolationError, NumberError, Result};

/// A point that a curve passes at a parameter, with as many of its derivatives there as are given.
///
/// ```
/// use cyclide::{Point3, Vec3, construct::{QbInterpolation, QbNode}};
/// let node = |parameter, point: [f64; 3], derivatives| QbNode { parameter, point: Point3::from(point), derivatives };
/// let ends = [node(0.0, [0.0, 0.0, 0.0], vec![Vec3::X]), node(1.0, [1.0, 1.0, 0.0], vec![])];
/// let arc = QbInterpolation::through_nodes(&ends)?; // three conditions: degree 1
/// assert!((arc.curve().jet(0.0).d1 - Vec3::X).length() < 1e-15);
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct QbNode {
    /// The parameter, in `[0, 1]`.
    pub parameter: f64,
    /// The point there.
    pub point: Point3,
    /// Derivatives by the parameter: first, second and so on.
    pub derivatives: Vec<Vec3>,
}

/// What a node asks for: its parameter and the Taylor coefficients, in the frame of the data.
struct Jet {
    t: f64,
    taylor: Vec<Quat>,
}

impl QbInterpolation {
    /// The curve through nodes in any order; points and derivatives are an odd number together, `2n + 1` for a curve of degree `n`. Of more than
    /// 25 of them 25 make the curve, as of [points](Self::through_points).
    ///
    /// # Errors
    /// `even-point-count`, `not-finite`, `parameter-out-of-range`, `repeated-parameter`, `unattainable-point`, `degree-too-high`
    /// (above 12), `curve-through-infinity`.
    pub fn through_nodes(nodes: &[QbNode]) -> Result<Self> {
        let conditions: usize = nodes.iter().map(|node| 1 + node.derivatives.len()).sum();
        if conditions.is_multiple_of(2) {
            return Err(InterpolationError::EvenPointCount { given: conditions }.into());
        }
        for (index, node) in nodes.iter().enumerate() {
            range::check_point(index, node.point.to_vec())?;
            node.derivatives.iter().try_for_each(|d| range::check_derivative(index, *d))?;
            if !node.parameter.is_finite() {
                return Err(NumberError::NotFinite { what: ErrorItem::Parameter, index }.into());
            }
        }
        let t: Vec<f64> = nodes.iter().map(|node| node.parameter).collect();
        check_parameters(&t)?;
        let points: Vec<Point3> = nodes.iter().map(|node| node.point).collect();
        let spread = DataFrame::of(&points).radius;
        let frame = DataFrame::of(&points).including(nodes.iter().flat_map(taylor_lengths));
        range::check_distance(frame.radius)?;
        if frame.radius <= 0.0 {
            return Self::finish(one_point(points[0]), frame, t, vec![1.0; nodes.len()]);
        }
        let jets: Vec<Jet> = nodes.iter().map(|node| jet_of(node, frame)).collect();
        let check = |curve: &QbCurve| check_met(curve, &jets, frame, spread);
        let (curve, attainability) = if conditions <= MOST_CONDITIONS {
            let found = through(&jets, frame)?;
            check(&found.0)?;
            found
        } else {
            let owners: Vec<usize> =
                in_order(&t).into_iter().flat_map(|k| std::iter::repeat_n(k, jets[k].taylor.len())).collect();
            let first = |&(k, count): &(usize, usize)| Jet { t: t[k], taylor: jets[k].taylor[..count].to_vec() };
            let through_some = |chosen: &[(usize, usize)]| {
                through(&chosen.iter().map(first).collect::<Vec<_>>(), frame).map(|(curve, _)| curve)
            };
            let curve = from_some(&owners, through_some, check)?;
            let attainability = t.iter().map(|t| size_at(&curve, *t)).collect();
            (curve, attainability)
        };
        let [start, end] = end_points(&t, &points);
        // How far the curve runs is measured by its points, where there are several.
        let seen = if spread > 0.0 { DataFrame { radius: spread, ..frame } } else { frame };
        Self::finish(curve.with_ends(start, end), seen, t, attainability)
    }
}

/// The curve that jets ask for in the frame of the data, before it is looked at, and what is left of its weight at each.
///
/// # Errors
/// `unattainable-point`.
fn through(jets: &[Jet], frame: DataFrame) -> Result<(QbCurve, Vec<f64>)> {
    let degree = jets.iter().map(|jet| jet.taylor.len()).sum::<usize>() / 2;
    let solved = null_vector(rows_of(jets, degree), 2 * degree + 2);
    let found = pairs_of(&solved.entries);
    let general = placed(found.clone(), DataFrame { radius: 1.0, ..frame }, [None; 2]);
    let attainability: Vec<f64> = jets.iter().map(|jet| size_at(&general, jet.t)).collect();
    check_attained(&attainability)?;
    let lower = solved.rank.saturating_sub(degree + 1);
    let pairs =
        if lower < degree { pairs_of(&null_vector(rows_of(jets, lower), 2 * lower + 2).entries) } else { found };
    Ok((placed(pairs, frame, [None; 2]), attainability))
}

fn factorials() -> impl Iterator<Item = f64> {
    (1..).scan(1.0, |product, k| {
        *product *= f64::from(k);
        Some(*product)
    })
}

/// Lengths of the Taylor coefficients above the point.
fn taylor_lengths(node: &QbNode) -> impl Iterator<Item = f64> + '_ {
    node.derivatives.iter().zip(factorials()).map(|(d, factorial)| d.length() / factorial)
}

fn jet_of(node: &QbNode, frame: DataFrame) -> Jet {
    let scaled =
        node.derivatives.iter().zip(factorials()).map(|(d, factorial)| Quat::from(*d / (factorial * frame.radius)));
    Jet { t: node.parameter, taylor: std::iter::once(frame.local(node.point)).chain(scaled).collect() }
}

/// The rows of the system in the denominators' coefficients, then the numerators'.
fn rows_of(jets: &[Jet], degree: usize) -> Vec<Vec<Quat>> {
    let mut rows = Vec::new();
    for jet in jets {
        let basis: Vec<Vec<f64>> = (0..jet.taylor.len()).map(|k| taylor_of_basis(degree, k, jet.t)).collect();
        for k in 0..jet.taylor.len() {
            let of_denominator = |i: usize| {
                let sum = (0..=k).fold(Quat::ZERO, |sum, j| sum + jet.taylor[j] * basis[k - j][i]);
                -sum
            };
            let numerators = basis[k].iter().map(|b| Quat::ONE * *b);
            rows.push((0..=degree).map(of_denominator).chain(numerators).collect());
        }
    }
    rows
}

/// The `k`-th Taylor coefficients of the Bernstein polynomials of a degree at `t`.
fn taylor_of_basis(degree: usize, k: usize, t: f64) -> Vec<f64> {
    if k > degree {
        return vec![0.0; degree + 1];
    }
    let lower = degree - k;
    let choose = |n: usize, i: usize| (0..i).fold(1.0, |c, j| c * (n - j) as f64 / (j + 1) as f64);
    let power = |x: f64, e: usize| x.powi(e as i32);
    let bernstein = |i: usize| choose(lower, i) * power(t, i) * power(1.0 - t, lower - i);
    let entry = |i: usize| {
        let terms = (0..=k).filter(|j| *j <= i && i - j <= lower);
        let sum: f64 = terms
            .map(|j| if (k - j).is_multiple_of(2) { choose(k, j) } else { -choose(k, j) } * bernstein(i - j))
            .sum();
        choose(degree, k) * sum
    };
    (0..=degree).map(entry).collect()
}

fn pairs_of(entries: &[Quat]) -> Vec<(Quat, Quat)> {
    let (denominators, numerators) = entries.split_at(entries.len() / 2);
    numerators.iter().copied().zip(denominators.iter().copied()).collect()
}

/// Numerator and denominator at a parameter, relative to the largest of their coefficients.
fn size_at(curve: &QbCurve, t: f64) -> f64 {
    let (n, d) = curve.local_pair(t);
    (n.norm() + d.norm()) / curve.largest_pair()
}

/// Refuses a curve that misses a derivative, in the frame of the data, or a point, in the size of the points where they have one: derivatives
/// may be so long that points differ by rounding beside them.
fn check_met(curve: &QbCurve, jets: &[Jet], frame: DataFrame, spread: f64) -> Result<()> {
    let size = if spread > 0.0 { spread / frame.radius } else { 1.0 };
    let distance = |jet: &Jet| {
        let place = (curve.local_point(jet.t) / frame.radius - jet.taylor[0].vector()).length() / size;
        let derivatives = curve.derivatives(jet.t, jet.taylor.len() - 1);
        let taylor = derivatives.iter().zip(factorials()).map(|(d, factorial)| *d / factorial);
        let off = taylor
            .zip(&jet.taylor[1..])
            .map(|(got, want)| (got / frame.radius - want.vector()).length() / want.norm().max(1.0));
        off.fold(place, |m: f64, x| if m.is_nan() || x <= m { m } else { x })
    };
    let missed: Vec<usize> = (0..jets.len()).filter(|k| !(distance(&jets[*k]) <= MISSED)).collect();
    match missed.first() {
        Some(&first) => Err(InterpolationError::UnattainablePoint {
            measured: distance(&jets[first]),
            points: missed,
            limit: MISSED,
        }
        .into()),
        None => Ok(()),
    }
}
