//! QB curves cut, raised, reversed, reparametrised and moved: linear operations on the pairs, all of them exact.

use super::{QbCurve, Row, denominator, numerator};
use crate::base::bernstein;
use crate::base::cut::interval;
use crate::base::quat::Quat;
use crate::base::vector::Point3;
use crate::conformal::mobius::{Conformal, Mobius};
use crate::error::{Error, ErrorItem, NumberError, Result};

impl QbCurve {
    /// The two parts before and after a parameter, each over `[0, 1]` (de Casteljau on the pairs), meeting in the same doubles.
    ///
    /// # Errors
    /// `parameter-out-of-range` unless `0 < t < 1`.
    pub fn split(&self, t: f64) -> Result<(Self, Self)> {
        if !(t > 0.0 && t < 1.0) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::T, value: t, min: 0.0, max: 1.0 }.into());
        }
        let (left, right) = bernstein::split(&self.rows, t);
        let middle = Some(self.point(t)).filter(|p| p.is_finite());
        let part = |rows: Vec<Row>, ends| Self { origin: self.origin, rows: rows.into(), ends };
        Ok((part(left, [self.ends[0], middle]), part(right, [middle, self.ends[1]])))
    }

    /// The part between two parameters, `0 <= t0 < t1 <= 1`, over `[0, 1]`.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn restricted(&self, t0: f64, t1: f64) -> Result<Self> {
        let [t0, t1] = interval(t0, t1)?;
        let mut rows = self.rows.clone();
        bernstein::restrict(&mut rows, [t0, t1]);
        let end = |t: f64| Some(self.point(t)).filter(|p| p.is_finite());
        Ok(Self { origin: self.origin, rows, ends: [end(t0), end(t1)] })
    }

    /// The same curve with pairs of the next higher degree.
    #[must_use]
    pub fn elevated(&self) -> Self {
        let n = self.degree() + 1;
        let mixed = |j: usize| -> Row {
            let part = j as f64 / n as f64;
            let before = if j > 0 { self.rows[j - 1] } else { [0.0; 8] };
            let own = if j < n { self.rows[j] } else { [0.0; 8] };
            std::array::from_fn(|d| before[d] * part + own[d] * (1.0 - part))
        };
        Self { rows: (0..=n).map(mixed).collect(), ..self.clone() }
    }

    /// The same points run backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let [start, end] = self.ends;
        Self { origin: self.origin, rows: self.rows.iter().rev().copied().collect(), ends: [end, start] }
    }

    /// The same points over `[0, 1]` at other parameters: what was at `ct/(1 - t + ct)` is at `t`.
    ///
    /// # Errors
    /// `scale-not-positive` (`c`).
    pub fn reparametrized(&self, c: f64) -> Result<Self> {
        if !(c > 0.0 && c.is_finite()) {
            return Err(NumberError::ScaleNotPositive { factor: c }.into());
        }
        let powers = std::iter::successors(Some(1.0), |power| Some(power * c));
        let rows: Vec<Row> = self.rows.iter().zip(powers).map(|(row, power)| row.map(|x| x * power)).collect();
        if rows.iter().flatten().any(|x| !x.is_finite()) {
            return Err(NumberError::ScaleNotPositive { factor: c }.into());
        }
        let pairs = rows.iter().map(|row| (numerator(row), denominator(row)));
        let [start, end] = self.ends;
        Ok(Self::from_local(self.origin, pairs).with_ends(start, end))
    }

    /// The image, wherever it runs.
    fn mapped(&self, map: &Mobius) -> Self {
        let ([a, b, c, d], [source, target]) = (map.matrix(), map.origins());
        let shift = Quat::from(self.origin - source);
        let pair = |row: &Row| {
            let (y, p) = (numerator(row) + shift * denominator(row), denominator(row));
            (a * y + b * p, c * y + d * p)
        };
        let image = Self::from_local(target, self.rows.iter().map(pair));
        let end = |p: Option<Point3>| p.and_then(|p| map.map_point(p));
        let [start, last] = self.ends.map(end);
        let image = image.with_ends(start, last);
        let near = image.ends.into_iter().flatten().next();
        near.map_or(image.clone(), |point| image.about(point))
    }
}

impl Conformal for QbCurve {
    /// The image under a Möbius map, at the same parameters: its pairs are mapped.
    ///
    /// # Errors
    /// `curve-through-infinity`.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let image = self.mapped(map);
        if image.rows.iter().flatten().any(|x| !x.is_finite()) {
            return Err(Error::at_infinity(ErrorItem::Curve, 0));
        }
        image.check_finite()?;
        Ok(image)
    }
}
