//! Rational B-splines cut and moved: exact operations on knots and control points.

use super::nurbs_curve::{NurbsCurve, check_multiplicities, check_numbers, insert_knot, multiplicity};
use super::nurbs_weights::{check_even, scaled_rows};
use crate::base::cut::{check_past_start, interval, place_of_cut};
use crate::base::vector::Point3;
use crate::conformal::mobius::Mobius;
use crate::error::{CurveError, Error, ErrorItem, NumberError, PointError, Result};

impl NurbsCurve {
    /// The image under a similarity or a reflection: control points move, knots and weights stay.
    ///
    /// # Errors
    /// `not-a-similarity`; `not-finite` if a control point overflows.
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        map.check_similarity()?;
        let moved = |(index, p): (usize, &Point3)| {
            map.map_point(*p)
                .filter(|p| p.is_finite())
                .ok_or(Error::Number(NumberError::NotFinite { what: ErrorItem::ControlPoint, index }))
        };
        let points = self.control_points().iter().enumerate().map(moved).collect::<Result<_>>()?;
        Self::with_any_weights(self.degree(), self.knots().to_vec(), points, self.weights().to_vec())
    }

    /// The two parts before and after the knot-domain parameter `u`, each over its part of the domain; exact (knot
    /// insertion, W. Boehm, 1980), meeting in the same control point.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless `u` is inside the domain.
    pub fn split_at_knot(&self, u: f64) -> Result<(Self, Self)> {
        let (first, last) = self.domain();
        if !(u > first && u < last) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::U, value: u, min: first, max: last }.into());
        }
        let mut parts = self.cut_at_knots(&[u])?.into_iter();
        match (parts.next(), parts.next()) {
            (Some(left), Some(right)) => Ok((left, right)),
            // Not reached: one cut makes two parts.
            _ => Err(PointError::TooFewPoints { given: 1, needed: 2 }.into()),
        }
    }

    /// The parts between knot-domain parameters inside the domain, which increase.
    pub(crate) fn cut_at_knots(&self, cuts: &[f64]) -> Result<Vec<Self>> {
        let degree = self.degree();
        let mut knots = self.knots().to_vec();
        let mut rows = scaled_rows(self.control_points(), self.weights());
        for &u in cuts {
            for _ in multiplicity(&knots, u)..degree {
                insert_knot(degree, &mut knots, &mut rows, u);
            }
        }
        let mut parts = Vec::with_capacity(cuts.len() + 1);
        let (mut start, mut inner) = (vec![self.domain().0; degree + 1], degree + 1);
        for &u in cuts {
            // The curve passes its control point `from - 1` at `u`.
            let from = knots.partition_point(|k| *k < u);
            let end = vec![u; degree + 1];
            let row = inner - degree - 1;
            parts.push(Self::from_rows(degree, [&start[..], &knots[inner..from], &end].concat(), &rows[row..from])?);
            (start, inner) = (end, from + degree);
        }
        let row = inner - degree - 1;
        parts.push(Self::from_rows(degree, [&start[..], &knots[inner..]].concat(), &rows[row..])?);
        Ok(parts)
    }

    /// Curve from knots that need not be clamped: the part over `knots[degree]` to `knots[points]`, where all basis
    /// functions are there, clamped exactly by knot insertion (W. Boehm, 1980). Knots that are clamped stay as they
    /// are. Where start and end are one control row up to rounding, as of a periodic curve, they become the same
    /// point: the curve is closed.
    ///
    /// ```
    /// use cyclide::{Point3, curve::ParamCurve, rational::NurbsCurve};
    /// // A periodic quadratic: the first two control points again at the end.
    /// let points = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
    /// let knots = (0..9).map(f64::from).collect();
    /// let curve = NurbsCurve::clamped(2, knots, points.map(Point3::from).to_vec(), vec![1.0; 6])?;
    /// assert_eq!((curve.domain(), curve.point(0.0), curve.is_closed()), ((2.0, 6.0), Point3::new(1.0, 0.0, 0.0), true));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`new`](Self::new); `empty-interval` if the part has no length.
    pub fn clamped(degree: usize, knots: Vec<f64>, points: Vec<Point3>, weights: Vec<f64>) -> Result<Self> {
        let curve = Self::clamped_with_any_weights(degree, knots, points, weights)?;
        check_even(&curve)?;
        Ok(curve)
    }

    /// As [`clamped`](Self::clamped), however uneven the weights are.
    pub(super) fn clamped_with_any_weights(
        degree: usize,
        knots: Vec<f64>,
        points: Vec<Point3>,
        weights: Vec<f64>,
    ) -> Result<Self> {
        check_numbers(degree, &knots, &points, &weights)?;
        let ends = [knots[degree], knots[points.len()]];
        let [a, b] = ends;
        if !(b > a) {
            return Err(CurveError::EmptyInterval { index: 0, length: b - a, limit: 0.0 }.into());
        }
        if ends.iter().all(|u| multiplicity(&knots, *u) > degree) {
            return Self::with_any_weights(degree, knots, points, weights);
        }
        check_multiplicities(degree, &knots)?;
        let mut knots = knots;
        let mut rows = scaled_rows(&points, &weights);
        for u in ends {
            for _ in multiplicity(&knots, u)..degree {
                insert_knot(degree, &mut knots, &mut rows, u);
            }
        }
        // The curve starts in its control point `after - degree - 1` and ends in `before - 1`.
        let (after, before) = (knots.partition_point(|k| *k <= a), knots.partition_point(|k| *k < b));
        let clamped = [&vec![a; degree + 1][..], &knots[after..before], &vec![b; degree + 1]].concat();
        let rows = &mut rows[after - degree - 1..before];
        join_ends(rows);
        Self::from_rows(degree, clamped, rows)
    }

    /// The two parts before and after a global parameter in `(0, 1)` of the curve as a
    /// [`ParamCurve`](crate::curve::ParamCurve) (one piece per knot span).
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn split(&self, t: f64) -> Result<(Self, Self)> {
        self.split_at_knot(self.knot_of_cut(t)?)
    }

    /// The part between two global parameters, `0 <= t0 < t1 <= 1`.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn restricted(&self, t0: f64, t1: f64) -> Result<Self> {
        let [t0, t1] = interval(t0, t1)?;
        let left = if t1 < 1.0 { self.split(t1)?.0 } else { self.clone() };
        // The knot domain is kept, so the place of the first cut is still the same number.
        if t0 > 0.0 { Ok(left.split_at_knot(self.knot_of_cut(t0)?)?.1) } else { Ok(left) }
    }

    /// The part of a closed curve from a global parameter past its start to a smaller one, `0 < t1 < t0 < 1`, exact: the knots go on past the last one,
    /// which stands as often as the degree, and the weights after it are scaled to meet those before.
    ///
    /// # Errors
    /// `parameter-out-of-range`; `weight-not-positive` if a weight overflows.
    pub fn restricted_past_start(&self, t0: f64, t1: f64) -> Result<Self> {
        let (first, last) = (self.control_points()[0], self.control_points()[self.control_points().len() - 1]);
        check_past_start(first == last, t0, t1)?;
        let (before, after) = (self.restricted(t0, 1.0)?, self.restricted(0.0, t1)?);
        let (degree, (start, end)) = (self.degree(), self.domain());
        let joint = before.knots().len() - 1;
        let moved = after.knots()[degree + 1..].iter().map(|knot| end + (knot - start));
        let knots = before.knots()[..joint].iter().copied().chain(moved).collect();
        let points = [before.control_points(), &after.control_points()[1..]].concat();
        let scale = before.weights()[before.weights().len() - 1] / after.weights()[0];
        let weights = before.weights().iter().copied().chain(after.weights()[1..].iter().map(|w| w * scale)).collect();
        Self::new(degree, knots, points, weights)
    }

    /// The knot-domain parameter of a global parameter in `(0, 1)`.
    fn knot_of_cut(&self, t: f64) -> Result<f64> {
        let (span, s) = place_of_cut(t, self.span_count())?;
        let (a, b) = (self.breaks()[span], self.breaks()[span + 1]);
        Ok(a + s * (b - a))
    }
}

/// Roundings of the largest entry by which the two ends of a periodic curve may differ.
const END_ROUNDINGS: f64 = 16.0;

/// Makes the last row the first one where they differ by rounding.
fn join_ends(rows: &mut [[f64; 4]]) {
    let largest = rows.iter().flatten().fold(0.0_f64, |m, v| m.max(v.abs()));
    if let [first, .., last] = rows
        && first.iter().zip(last.iter()).all(|(a, b)| (a - b).abs() <= END_ROUNDINGS * f64::EPSILON * largest)
    {
        *last = *first;
    }
}
