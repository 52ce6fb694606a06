//! Points and derivatives of QB curves: the quotient rule, with the new denominator always on the right
//! (`docs/math/qb-curves.md#derivatives`).

use super::{QbCurve, Row, denominator, numerator};
use crate::base::bernstein;
use crate::base::jet::CurveJet;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};

impl QbCurve {
    /// The point at `t`, at both ends as it was given; not finite where the curve passes through infinity.
    #[must_use]
    pub fn point(&self, t: f64) -> Point3 {
        self.end_at(t).unwrap_or_else(|| self.origin + self.local_point(t))
    }

    /// Point and derivatives at `t`.
    #[must_use]
    pub fn jet(&self, t: f64) -> CurveJet {
        let rows: [Row; 4] = bernstein::derivatives(&self.rows, t);
        let (n, d) = (rows.each_ref().map(numerator), rows.each_ref().map(denominator));
        let inverse = inverse(d[0]);
        let c0 = n[0] * inverse;
        let c1 = (n[1] - c0 * d[1]) * inverse;
        let c2 = (n[2] - c0 * d[2] - c1 * d[1] * 2.0) * inverse;
        let c3 = (n[3] - c0 * d[3] - (c1 * d[2] + c2 * d[1]) * 3.0) * inverse;
        let point = self.end_at(t).unwrap_or_else(|| self.origin + c0.vector());
        let jet = CurveJet { point, d1: c1.vector(), d2: c2.vector(), d3: c3.vector() };
        if t > 0.0 && t < 1.0 {
            return jet;
        }
        let size = self.origin.to_vec().max_abs().max((point - self.origin).max_abs());
        jet.without_rounding((size + jet.d2.max_abs()) * self.degree() as f64)
    }

    /// The derivatives of the orders 1 to `count` at `t`, by `t`.
    ///
    /// ```
    /// # use cyclide::{Point3, Quat, Vec3, conformal::HPoint, curve::QbCurve};
    /// let ends = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
    /// let turn = Quat::from_axis_angle(Vec3::Z, std::f64::consts::FRAC_PI_2);
    /// let quarter = QbCurve::new(&[HPoint::weighted(ends[0], Quat::ONE), HPoint::weighted(ends[1], turn)])?;
    /// let derivatives = quarter.derivatives(0.3, 5);
    /// assert_eq!((derivatives[0], derivatives[2]), (quarter.jet(0.3).d1, quarter.jet(0.3).d3));
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    #[must_use]
    pub fn derivatives(&self, t: f64, count: usize) -> Vec<Vec3> {
        let pairs = self.derivatives_of_pairs(t, count);
        let inverse = inverse(pairs[0].1);
        let mut found: Vec<Quat> = Vec::with_capacity(count + 1);
        for (k, (n, _)) in pairs.iter().enumerate() {
            // n^(k) = sum over j of C(k, j) c^(j) d^(k-j)
            let mut choose = 1.0;
            let mut rest = *n;
            for (j, c) in found.iter().enumerate() {
                rest -= *c * pairs[k - j].1 * choose;
                choose = choose * (k - j) as f64 / (j + 1) as f64;
            }
            found.push(rest * inverse);
        }
        found.into_iter().skip(1).map(Quat::vector).collect()
    }

    /// Numerator and denominator with their derivatives up to the given order.
    fn derivatives_of_pairs(&self, t: f64, order: usize) -> Vec<(Quat, Quat)> {
        let mut differences = self.rows.clone();
        let mut factor = 1.0;
        let mut out = Vec::with_capacity(order + 1);
        for _ in 0..=order {
            let value = if differences.is_empty() { [0.0; 8] } else { bernstein::eval(&differences, t) };
            let row = value.map(|x| x * factor);
            out.push((numerator(&row), denominator(&row)));
            factor *= differences.len().saturating_sub(1) as f64;
            let difference = |pair: &[Row]| std::array::from_fn(|d| pair[1][d] - pair[0][d]);
            differences = differences.windows(2).map(difference).collect();
        }
        out
    }

    /// Numerator and denominator at `t`, the numerator measured from the origin inside.
    pub(crate) fn local_pair(&self, t: f64) -> (Quat, Quat) {
        let row: Row = bernstein::eval(&self.rows, t);
        (numerator(&row), denominator(&row))
    }

    /// The point at `t`, measured from the origin inside.
    pub(crate) fn local_point(&self, t: f64) -> Vec3 {
        let (n, d) = self.local_pair(t);
        (n * inverse(d)).vector()
    }

    /// The largest sum of the lengths of a numerator and its denominator, the numerators measured from the origin inside.
    pub(crate) fn largest_pair(&self) -> f64 {
        self.rows.iter().map(|row| numerator(row).norm() + denominator(row).norm()).fold(0.0, f64::max)
    }

    /// Length of the denominator at `t`, relative to what it is a sum of.
    pub(crate) fn weight_at(&self, t: f64) -> f64 {
        let lengths: Vec<[f64; 1]> = self.rows.iter().map(|row| [denominator(row).norm()]).collect();
        self.local_pair(t).1.norm() / bernstein::eval(&lengths, t)[0]
    }

    fn end_at(&self, t: f64) -> Option<Point3> {
        if t <= 0.0 {
            self.ends[0]
        } else if t >= 1.0 {
            self.ends[1]
        } else {
            None
        }
    }
}

/// The inverse of a denominator; not finite for zero, where the curve is at infinity.
fn inverse(d: Quat) -> Quat {
    d.conj() * (1.0 / d.norm_squared())
}
