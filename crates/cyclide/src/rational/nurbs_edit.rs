//! Rational B-splines cut and moved: exact operations on knots and control points.

use super::nurbs_curve::{NurbsCurve, homogeneous_rows, insert_knot, multiplicity};
use crate::base::cut::{check_interval, place_of_cut};
use crate::base::vector::Point3;
use crate::conformal::mobius::Mobius;
use crate::error::{Error, ErrorItem, Result};

impl NurbsCurve {
    /// The image under a similarity or a reflection: control points move, knots and weights stay.
    ///
    /// # Errors
    /// `not-a-similarity`; `not-finite` if a control point overflows.
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        map.check_similarity()?;
        let moved = |(index, p): (usize, &Point3)| {
            map.map_point(*p).filter(|p| p.is_finite()).ok_or(Error::NotFinite { what: ErrorItem::ControlPoint, index })
        };
        let points = self.control_points().iter().enumerate().map(moved).collect::<Result<_>>()?;
        Self::new(self.degree(), self.knots().to_vec(), points, self.weights().to_vec())
    }

    /// The two parts before and after the knot-domain parameter `u`, each over its part of the domain; exact (knot
    /// insertion, W. Boehm, 1980), meeting in the same control point.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless `u` is inside the domain.
    pub fn split_at_knot(&self, u: f64) -> Result<(Self, Self)> {
        let (first, last) = self.domain();
        if !(u > first && u < last) {
            return Err(Error::ParameterOutOfRange { name: ErrorItem::U, value: u, min: first, max: last });
        }
        let degree = self.degree();
        let mut knots = self.knots().to_vec();
        let mut rows = homogeneous_rows(self.control_points(), self.weights());
        for _ in multiplicity(&knots, u)..degree {
            insert_knot(degree, &mut knots, &mut rows, u);
        }
        let from = knots.partition_point(|k| *k < u);
        // The curve passes its control point `from - 1` at `u`.
        let at = |j: usize| vec![u; j];
        let left = [&knots[..from], &at(degree + 1)].concat();
        let right = [&at(degree + 1), &knots[from + degree..]].concat();
        Ok((Self::from_rows(degree, left, &rows[..from])?, Self::from_rows(degree, right, &rows[from - 1..])?))
    }

    /// The two parts before and after a global parameter in `(0, 1)` of the curve as a
    /// [`ParamCurve`](crate::ParamCurve) (one piece per knot span).
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
        check_interval(t0, t1)?;
        let left = if t1 < 1.0 { self.split(t1)?.0 } else { self.clone() };
        // The knot domain is kept, so the place of the first cut is still the same number.
        if t0 > 0.0 { Ok(left.split_at_knot(self.knot_of_cut(t0)?)?.1) } else { Ok(left) }
    }

    /// The knot-domain parameter of a global parameter in `(0, 1)`.
    fn knot_of_cut(&self, t: f64) -> Result<f64> {
        let (span, s) = place_of_cut(t, self.span_count())?;
        let (a, b) = (self.breaks()[span], self.breaks()[span + 1]);
        Ok(a + s * (b - a))
    }
}
