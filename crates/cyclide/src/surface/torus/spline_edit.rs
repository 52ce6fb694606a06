//! Splines on a torus run backwards, cut and moved.

use super::spline::{TorusSegment, TorusSpline};
use crate::base::cut::{check_past_start, interval, place_of_cut};
use crate::base::planar::Point2;
use crate::base::vector::Vec3;
use crate::conformal::mobius::Mobius;
use crate::curve::ParamCurve as _;
use crate::error::{ErrorItem, NumberError, Result};

impl TorusSpline {
    /// The same points run backwards over the same interval of knots.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let (n, [first, last]) = (self.pieces.len(), [self.knots[0], self.knots[self.pieces.len()]]);
        // The mirror image of each end is the other end, to the bit.
        let mirrored = |(i, k): (usize, &f64)| {
            if i == n {
                first
            } else if i == 0 {
                last
            } else {
                first + (last - k)
            }
        };
        let mut knots: Vec<f64> = self.knots.iter().enumerate().map(mirrored).collect();
        knots.reverse();
        let segment = |s: &TorusSegment| TorusSegment { pieces: n - s.pieces.end..n - s.pieces.start, ..s.clone() };
        Self {
            pieces: self.pieces.iter().rev().map(super::piece::TorusPiece::reversed).collect(),
            knots,
            joints: self.joints.iter().rev().copied().collect(),
            unrolled: self.unrolled.iter().rev().copied().collect(),
            segments: self.segments.iter().rev().map(segment).collect(),
            ..*self
        }
    }

    /// The part between two global parameters, `0 <= t0 < t1 <= 1`, as an open curve of the same points; segments that are cut keep how they
    /// were joined and their quality. Parameters within rounding of a joint cut there.
    ///
    /// ```
    /// use cyclide::{Frame, curve::ParamCurve, surface::{Torus, TorusSpline}};
    /// let trefoil = TorusSpline::knot(&Torus::new(Frame::WORLD, 3.0, 1.0)?, [2, 3], Default::default())?;
    /// let half = trefoil.restricted(0.0, 0.5)?;
    /// assert!(half.point(1.0).distance(trefoil.point(0.5)) < 1e-14 && !half.is_closed());
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn restricted(&self, t0: f64, t1: f64) -> Result<Self> {
        let [t0, t1] = interval(t0, t1)?;
        let n = self.pieces.len();
        let (first, s0) = if t0 > 0.0 { place_of_cut(t0, n)? } else { (0, 0.0) };
        let (end, s1) = if t1 < 1.0 { place_of_cut(t1, n)? } else { (n, 0.0) };
        let count = if s1 > 0.0 { end + 1 } else { end }.saturating_sub(first);
        let range = |i: usize| [if i == first { s0 } else { 0.0 }, if i == end { s1 } else { 1.0 }];
        let knot = |i: usize, s: f64| match s {
            s if s <= 0.0 => self.knots[i],
            s if s >= 1.0 => self.knots[i + 1],
            _ => self.knots[i] + s * (self.knots[i + 1] - self.knots[i]),
        };
        let (mut knots, mut joints, mut unrolled) = (Vec::new(), Vec::new(), Vec::new());
        let mut pieces = Vec::with_capacity(count);
        for i in first..first + count {
            let [from, to] = range(i);
            let whole = from <= 0.0 && to >= 1.0;
            pieces.push(if whole { self.pieces[i] } else { self.pieces[i].part(from, to) });
            let ends = [from, to].into_iter().skip(usize::from(i > first));
            for s in ends {
                knots.push(knot(i, s));
                joints.push(self.piece_point(i, s));
                unrolled.push(self.unrolled_place(i, s));
            }
        }
        if pieces.is_empty() || knots.windows(2).any(|w| w[0] >= w[1]) {
            // Both ends within rounding of one place.
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::T1, value: t1, min: t0, max: 1.0 }.into());
        }
        let inside = |s: &TorusSegment| {
            let [a, b] = [s.pieces.start, s.pieces.end].map(|i| i.clamp(first, first + count) - first);
            (a < b).then(|| TorusSegment { pieces: a..b, ..s.clone() })
        };
        let segments = self.segments.iter().filter_map(inside).collect();
        Ok(Self { torus: self.torus, pieces, knots, joints, unrolled, closed: false, segments })
    }

    /// The part of a closed curve from a global parameter past its start to a smaller one, `0 < t1 < t0 < 1`, as an open curve of the
    /// same points; its knots go on past the last one, and its turns are counted on.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn restricted_past_start(&self, t0: f64, t1: f64) -> Result<Self> {
        check_past_start(self.closed, t0, t1)?;
        let (mut before, after) = (self.restricted(t0, 1.0)?, self.restricted(0.0, t1)?);
        let n = before.pieces.len();
        let (end, turned) = (before.knots[n] - after.knots[0], before.unrolled[n] - after.unrolled[0]);
        before.knots.extend(after.knots[1..].iter().map(|knot| end + knot));
        if before.knots.windows(2).any(|w| w[0] >= w[1]) {
            return Err(NumberError::ParameterOutOfRange { name: ErrorItem::T1, value: t1, min: 0.0, max: t0 }.into());
        }
        before.joints.extend_from_slice(&after.joints[1..]);
        before.unrolled.extend(after.unrolled[1..].iter().map(|place| *place + turned));
        let moved = |s: TorusSegment| TorusSegment { pieces: s.pieces.start + n..s.pieces.end + n, ..s };
        before.segments.extend(after.segments.into_iter().map(moved));
        before.pieces.extend(after.pieces);
        Ok(before)
    }

    /// The two parts before and after a global parameter in `(0, 1)`, as open curves that meet in the same doubles.
    ///
    /// # Errors
    /// `parameter-out-of-range`.
    pub fn split(&self, t: f64) -> Result<(Self, Self)> {
        Ok((self.restricted(0.0, t)?, self.restricted(t, 1.0)?))
    }

    /// The image under a similarity or a reflection, with the same knots.
    ///
    /// # Errors
    /// As [`Torus::similar`](super::Torus::similar).
    pub fn similar(&self, map: &Mobius) -> Result<Self> {
        let torus = self.torus.similar(map)?;
        let (frame, origin) = (self.torus.frame(), self.torus.frame().origin());
        let image = |v: Vec3| map.push_forward(origin, v).unwrap_or(v);
        let turned = image(frame.x()).cross(image(frame.y())).dot(image(frame.z())) < 0.0;
        let mut moved = Self { torus, ..self.clone() };
        if turned {
            moved.pieces.iter_mut().for_each(|piece| *piece = piece.mirrored());
            moved.unrolled.iter_mut().for_each(|place| *place = Point2::new(-place.x, place.y));
        }
        for (joint, place) in moved.joints.iter_mut().zip(&moved.unrolled) {
            *joint = torus.point(*place);
        }
        if let (true, Some(first)) = (self.closed, moved.joints.first().copied()) {
            moved.joints.pop();
            moved.joints.push(first);
        }
        Ok(moved)
    }
}
