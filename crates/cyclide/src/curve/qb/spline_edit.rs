//! Chains of QB curves reversed, cut and moved.

use super::QbCurve;
use super::spline::QbSpline;
use crate::base::cut::{check_past_start, interval, place_of_cut};
use crate::conformal::mobius::{Conformal, Mobius};
use crate::curve::circle_spline::{kinks_past_start, renumbered, warnings_past_start};
use crate::error::{ErrorItem, NumberError, Result};

impl QbSpline {
    /// The same points run backwards over the same interval of knots; a closed curve still starts at the same point.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let n = self.spans.len();
        let (first, last) = (self.knots[0], self.knots[n]);
        // The mirror image of each end is the other end, to the bit.
        let mirrored = |(i, k): (usize, &f64)| match i {
            0 => last,
            i if i == n => first,
            _ => first + (last - k),
        };
        let mut knots: Vec<f64> = self.knots.iter().enumerate().map(mirrored).collect();
        knots.reverse();
        keep_increasing(&mut knots);
        let joint = |i: &usize| if self.closed { (n - i) % n } else { n - i };
        let mut kinks: Vec<usize> = self.kinks.iter().map(joint).collect();
        kinks.sort_unstable();
        let spans = self.spans.iter().rev().map(QbCurve::reversed).collect();
        let warnings = self.warnings.iter().filter_map(|w| renumbered(w, |i| Some(joint(&i)), |s| Some(n - 1 - s)));
        Self::from_parts(spans, knots, self.closed, kinks, warnings.collect())
    }

    /// The part between two global parameters, `0 <= t0 < t1 <= 1`, as an open chain of the same points. Parameters within rounding of a
    /// joint cut there.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn restricted(&self, t0: f64, t1: f64) -> Result<Self> {
        let [t0, t1] = interval(t0, t1)?;
        let n = self.spans.len();
        let (first, s0) = if t0 > 0.0 { place_of_cut(t0, n)? } else { (0, 0.0) };
        let (end, s1) = if t1 < 1.0 { place_of_cut(t1, n)? } else { (n, 0.0) };
        let last = if s1 > 0.0 { end } else { end.saturating_sub(1) };
        let range = |i: usize| [if i == first { s0 } else { 0.0 }, if i == end { s1 } else { 1.0 }];
        let knot = |i: usize, s: f64| self.knots[i] + s * (self.knots[i + 1] - self.knots[i]);
        let (mut spans, mut knots) = (Vec::new(), vec![knot(first, s0)]);
        for i in first..=last {
            let [from, to] = range(i);
            spans.push(self.spans[i].restricted(from, to)?);
            knots.push(if to < 1.0 { knot(i, to) } else { self.knots[i + 1] });
        }
        if spans.is_empty() || knots.windows(2).any(|w| w[0] >= w[1]) {
            // Both ends within rounding of one place.
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::T1, value: t1, min: t0, max: 1.0 }.into());
        }
        let kinks = self.kinks.iter().filter(|k| **k > first && **k <= last).map(|k| k - first).collect();
        let joint = |i: usize| (i > first && i <= last).then(|| i - first);
        let span = |i: usize| (i >= first && i <= last).then(|| i - first);
        let warnings = self.warnings.iter().filter_map(|w| renumbered(w, joint, span)).collect();
        Ok(Self::from_parts(spans, knots, false, kinks, warnings))
    }

    /// The part of a closed chain from a global parameter past its start to a smaller one, `0 < t1 < t0 < 1`, as an open chain of the same
    /// points; its knots go on past the last one.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn restricted_past_start(&self, t0: f64, t1: f64) -> Result<Self> {
        check_past_start(self.closed, t0, t1)?;
        let (mut before, after) = (self.restricted(t0, 1.0)?, self.restricted(0.0, t1)?);
        let n = before.spans.len();
        let (end, start) = (before.knots[n], after.knots[0]);
        before.knots.extend(after.knots[1..].iter().map(|knot| end + (knot - start)));
        if before.knots.windows(2).any(|w| w[0] >= w[1]) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::T1, value: t1, min: 0.0, max: t0 }.into());
        }
        before.kinks.extend(kinks_past_start(&self.kinks, &after.kinks, n));
        before.warnings = warnings_past_start(&self.warnings, before.warnings, &after.warnings, n);
        before.spans.extend(after.spans);
        Ok(before)
    }

    /// The two parts before and after a global parameter in `(0, 1)`, as open chains that meet in the same doubles.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn split(&self, t: f64) -> Result<(Self, Self)> {
        Ok((self.restricted(0.0, t)?, self.restricted(t, 1.0)?))
    }
}

/// Parts knots that rounding has made equal, by as little as there is; the first and the last stay.
fn keep_increasing(knots: &mut [f64]) {
    let last = knots.len() - 1;
    for i in 1..last {
        knots[i] = knots[i].max(knots[i - 1].next_up());
    }
    for i in (1..last).rev() {
        knots[i] = knots[i].min(knots[i + 1].next_down());
    }
}

impl Conformal for QbSpline {
    /// The image under a Möbius map, with the same knots and as smooth.
    ///
    /// # Errors
    /// `curve-through-infinity`, wrapped with the span.
    fn transformed(&self, map: &Mobius) -> Result<Self> {
        let spans = self.spans.iter().enumerate().map(|(i, s)| s.transformed(map).map_err(|e| e.in_span(i)));
        Ok(Self { spans: spans.collect::<Result<_>>()?, ..self.clone() })
    }
}
