//! Circle splines reversed, cut and moved: the result is a circle spline again, segment by segment.

use super::CircleSpline;
use crate::base::cut::{check_past_start, interval, place_of_cut};
use crate::conformal::mobius::Mobius;
use crate::error::{ErrorItem, NumberError, Result};
use crate::warning::{CurveWarning, PointWarning, Warning};

impl CircleSpline {
    /// The same points run backwards; a closed curve still starts at the same node.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let n = self.segments.len();
        let node = |i: usize| if self.closed { (n - i) % n } else { n - i };
        let mut kinks: Vec<usize> = self.kinks.iter().map(|k| node(*k)).collect();
        kinks.sort_unstable();
        Self {
            segments: self.segments.iter().rev().map(|s| s.reversed()).collect(),
            closed: self.closed,
            kinks,
            warnings: self
                .warnings
                .iter()
                .filter_map(|w| renumbered(w, |i| Some(node(i)), |s| Some(n - 1 - s)))
                .collect(),
        }
    }

    /// The image under a similarity or a reflection, with the same parameter. (A circle spline is not a circle
    /// spline any more after other Möbius maps.)
    ///
    /// # Errors
    /// `not-a-similarity`, or as [`BlendSegment::similar`](crate::curve::BlendSegment::similar), wrapped with the segment.
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        let segments = self.segments.iter().enumerate().map(|(i, s)| s.similar(map).map_err(|e| e.in_span(i)));
        Ok(Self { segments: segments.collect::<Result<_>>()?, ..self.clone() })
    }

    /// The part between two global parameters, `0 <= t0 < t1 <= 1`, as an open curve of the same points; segments
    /// that are cut keep their shape (their parameter is stretched to `[0, 1]`). Parameters within rounding of a joint
    /// cut there.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn restricted(&self, t0: f64, t1: f64) -> Result<Self> {
        let [t0, t1] = interval(t0, t1)?;
        let n = self.segments.len();
        let (first, l0) = if t0 > 0.0 { place_of_cut(t0, n)? } else { (0, 0.0) };
        let (end, l1) = if t1 < 1.0 { place_of_cut(t1, n)? } else { (n, 0.0) };
        let last = if l1 > 0.0 { end } else { end.saturating_sub(1) };
        let part = |i: usize| {
            let from = if i == first { l0 } else { 0.0 };
            let to = if i == end { l1 } else { 1.0 };
            self.segments[i].restricted(from, to)
        };
        let segments = (first..=last).map(part).collect::<Result<Vec<_>>>()?;
        if segments.is_empty() {
            // Both ends within rounding of one joint.
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::T1, value: t1, min: t0, max: 1.0 }.into());
        }
        let kinks = self.kinks.iter().filter(|k| **k > first && **k <= last).map(|k| k - first).collect();
        let node = |i: usize| (i > first && i <= last).then(|| i - first);
        let segment = |i: usize| (i >= first && i <= last).then(|| i - first);
        let warnings = self.warnings.iter().filter_map(|w| renumbered(w, node, segment));
        Ok(Self { segments, closed: false, kinks, warnings: warnings.collect() })
    }

    /// The part of a closed curve from a global parameter past its start to a smaller one, `0 < t1 < t0 < 1`, as an open curve of the
    /// same points.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn restricted_past_start(&self, t0: f64, t1: f64) -> Result<Self> {
        check_past_start(self.closed, t0, t1)?;
        let (mut before, after) = (self.restricted(t0, 1.0)?, self.restricted(0.0, t1)?);
        let n = before.segments.len();
        before.kinks.extend(kinks_past_start(&self.kinks, &after.kinks, n));
        before.warnings = warnings_past_start(&self.warnings, before.warnings, &after.warnings, n);
        before.segments.extend(after.segments);
        Ok(before)
    }

    /// The two parts before and after a global parameter in `(0, 1)`, as open curves. Exact: no approximation, and
    /// they meet in the same doubles.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn split(&self, t: f64) -> Result<(Self, Self)> {
        Ok((self.restricted(0.0, t)?, self.restricted(t, 1.0)?))
    }
}

/// The warning with its node or segments renumbered; `None` if they are gone.
pub(crate) fn renumbered(
    warning: &Warning,
    node_of: impl Fn(usize) -> Option<usize>,
    segment_of: impl Fn(usize) -> Option<usize>,
) -> Option<Warning> {
    let mut warning = warning.clone();
    match &mut warning {
        Warning::Curve(
            CurveWarning::Cusp { node }
            | CurveWarning::SharpTurn { node, .. }
            | CurveWarning::SharpTurnCut { node, .. },
        )
        | Warning::Point(PointWarning::UnevenSpacing { node, .. }) => *node = node_of(*node)?,
        Warning::Curve(CurveWarning::LongWay { segment } | CurveWarning::OppositeCircles { segment }) => {
            *segment = segment_of(*segment)?
        }
        Warning::Curve(CurveWarning::Relaxed { segments }) => {
            segments.retain_mut(|(segment, _)| segment_of(*segment).map(|new| *segment = new).is_some());
            segments.sort_unstable_by_key(|(segment, _)| *segment);
            if segments.is_empty() {
                return None;
            }
        }
        _ => {}
    }
    Some(warning)
}

/// The kinks of what comes after `n` pieces that end in the start of a closed curve: one there, if the curve has one, and those `after`.
pub(in crate::curve) fn kinks_past_start<'a>(
    whole: &[usize],
    after: &'a [usize],
    n: usize,
) -> impl Iterator<Item = usize> + use<'a> {
    let at_start = whole.first() == Some(&0);
    at_start.then_some(n).into_iter().chain(after.iter().map(move |kink| kink + n))
}

/// The warnings of the `n` pieces `before` the start of a closed curve, of the start and of the pieces `after`, each once.
pub(in crate::curve) fn warnings_past_start(
    whole: &[Warning],
    before: Vec<Warning>,
    after: &[Warning],
    n: usize,
) -> Vec<Warning> {
    let at_start = whole.iter().filter_map(|w| renumbered(w, |node| (node == 0).then_some(n), |_| None));
    let after = after.iter().filter_map(|w| renumbered(w, |node| Some(node + n), |segment| Some(segment + n)));
    let mut all = before;
    for warning in at_start.chain(after) {
        if !all.contains(&warning) {
            all.push(warning);
        }
    }
    all
}
