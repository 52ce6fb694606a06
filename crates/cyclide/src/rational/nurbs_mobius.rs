//! Images of rational B-splines under Möbius maps: rational B-splines of twice the degree.
//!
//! With the homogeneous form `(X, w)` of a span, `X` the point from the origin of the map times the weight as an
//! imaginary quaternion, the map `x -> target + (a x + b)(c x + d)^-1` gives numerator and denominator
//! `N = a X + b w` and `D = c X + d w`, of the degree of the span, and `N D^-1 = N ~D / |D|²`: the new weight is `|D|²`, the
//! new row `Im(N ~D) + target |D|²` (`docs/math/rational-curves.md#images-under-maps`). `|D|²` is positive where the curve does not meet the
//! pole of the map, its Bernstein coefficients need not be: then the span is halved.

use super::quaternion_polynomial::QuatPolynomial;
use super::{NurbsCurve, Polynomial, PolynomialRow, RationalBezier};
use crate::base::bernstein;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::conformal::hpoint::HPoint;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::{Error, ErrorItem, NumberError, PointError, Result};

/// Smallest weight of a part relative to its largest one, as long as it may be halved for it: readers refuse weights of 0, and
/// small ones lose digits.
const EVEN: f64 = 1e-3;
/// Halvings for weights that are positive but uneven.
const EVEN_HALVINGS: u32 = 8;
/// Roundings of the coordinates by which a curve must miss the pole.
const POLE_ROUNDINGS: f64 = 16.0;
/// Halvings of a span until its weights are positive: what then is not is at the pole.
const MOST_HALVINGS: u32 = 40;

impl Conformal for NurbsCurve {
    /// The image under any map, exact: under a similarity with the same knots and weights, else of twice the degree,
    /// every knot as often as the degree, over the knots from 0 to 1, spans halved where weights would not be positive.
    ///
    /// ```
    /// use cyclide::{Point3, conformal::{Conformal, Mobius}, curve::ParamCurve, rational::NurbsCurve};
    /// let points = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 2.0, 0.0]].map(Point3::from).to_vec();
    /// let curve = NurbsCurve::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], points, vec![1.0; 3])?;
    /// let inversion = Mobius::inversion(Point3::ORIGIN, 1.0)?;
    /// let image = curve.transformed(&inversion)?;
    /// assert_eq!(image.degree(), 4);
    /// assert!(image.point(0.3).distance(inversion.map_point(curve.point(0.3)).expect("finite")) < 1e-15);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `point-at-infinity` if the curve meets the point that goes there; `parameter-out-of-range` if twice the degree is above
    /// [`MOST_DEGREE`](NurbsCurve::MOST_DEGREE); `not-finite` if a control point overflows.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        if map.is_similarity() {
            return self.similar(map);
        }
        let degree = 2 * self.degree();
        if degree > Self::MOST_DEGREE {
            let max = Self::MOST_DEGREE as f64;
            return Err(NumberError::ParameterOutOfRange {
                name: ErrorItem::Degree,
                value: degree as f64,
                min: 1.0,
                max,
            }
            .into());
        }
        let (mut parts, mut intervals) = (Vec::new(), Vec::new());
        for (span, ends) in self.breaks().windows(2).enumerate() {
            // Halved before they are multiplied, from the origin of the map: next to the pole the products would cancel.
            let rows = local_rows(map, self.span_rows(span));
            let nearest = POLE_ROUNDINGS * f64::EPSILON * reach(self.span_rows(span));
            let limit = weight_at(map, &rows, nearest);
            let mut ahead = vec![(rows, ends[1] - ends[0], 0)];
            while let Some((rows, interval, halvings)) = ahead.pop() {
                let image = image_rows(map, &rows);
                if is_settled(&image, halvings) {
                    if image.iter().any(|row| row[3] <= limit) {
                        return Err(at_infinity(map, &rows[0], span, nearest));
                    }
                    parts.push(RationalBezier::from_rows_unchecked(image));
                    intervals.push(interval);
                } else if halvings == MOST_HALVINGS {
                    return Err(at_infinity(map, &rows[0], span, nearest));
                } else {
                    let (left, right) = bernstein::split(&rows, 0.5);
                    ahead.extend([(right, 0.5 * interval, halvings + 1), (left, 0.5 * interval, halvings + 1)]);
                }
            }
        }
        let image = Self::from_beziers(&parts, &intervals)?;
        let original = self.control_points();
        Ok(if original[0] == original[original.len() - 1] { image.closed_by_rounding() } else { image })
    }
}

/// The rows of a span from the origin of the map.
fn local_rows(map: &Mobius, rows: &[[f64; 4]]) -> Vec<[f64; 4]> {
    let source = map.origins()[0];
    rows.iter().map(|&[x, y, z, w]| [x - source.x * w, y - source.y * w, z - source.z * w, w]).collect()
}

/// Largest coordinate of the control points.
fn reach(rows: &[[f64; 4]]) -> f64 {
    rows.iter().flat_map(|r| [0, 1, 2].map(|k| (r[k] / r[3]).abs())).fold(0.0, f64::max)
}

/// The least weight in the image of a point of a span at this distance from the pole.
fn weight_at(map: &Mobius, rows: &[[f64; 4]], distance: f64) -> f64 {
    let least = rows.iter().map(|r| r[3]).fold(f64::INFINITY, f64::min);
    (map.matrix()[2].norm() * least * distance).powi(2)
}

/// The rows of the image of rows from the origin of the map.
fn image_rows(map: &Mobius, rows: &[[f64; 4]]) -> Vec<[f64; 4]> {
    let target = map.origins()[1].to_vec();
    let [a, b, c, d] = map.matrix().map(QuatPolynomial::constant);
    let entry = |k: usize| Polynomial::new(rows.iter().map(|r| r[k]).collect());
    let weight = entry(3);
    let x = QuatPolynomial([Polynomial::constant(0.0), entry(0), entry(1), entry(2)]);
    let numerator = &(&a * &x) + &(&b * &weight);
    let denominator = &(&c * &x) + &(&d * &weight);
    let image_weight = denominator.dot(&denominator);
    let [_, x, y, z] = (&numerator * &denominator.conj()).0;
    let moved = |k: usize, entry: &Polynomial| entry + &(&image_weight * target[k]);
    let row = PolynomialRow([moved(0, &x), moved(1, &y), moved(2, &z), image_weight.clone()]);
    RationalBezier::from_polynomial_row(&row).rows().to_vec()
}

/// True if all weights are positive, and even or halved often enough.
fn is_settled(rows: &[[f64; 4]], halvings: u32) -> bool {
    let (least, most) = rows.iter().fold((f64::INFINITY, 0.0_f64), |(lo, hi), r| (lo.min(r[3]), hi.max(r[3])));
    least > 0.0 && (least >= EVEN * most || halvings >= EVEN_HALVINGS)
}

/// The error about a span that meets the pole, from a row beside it.
fn at_infinity(map: &Mobius, &[x, y, z, w]: &[f64; 4], index: usize, limit: f64) -> Error {
    let pole = map.inverse().map_pair(HPoint { n: Quat::ONE, d: Quat::ZERO }).quotient();
    let point = map.origins()[0] + Vec3::new(x, y, z) / w;
    let distance = pole.map_or(0.0, |pole| point.distance(Point3::ORIGIN + pole.vector()));
    Error::Point(PointError::AtInfinity { what: ErrorItem::Curve, index, distance, limit })
}
