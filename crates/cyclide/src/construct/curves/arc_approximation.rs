//! Smooth curves as G1 arcs within a tolerance, by biarcs as long as the tolerance allows.
//!
//! A biarc takes its ends and end tangents from the curve, so the result is G1 and interpolates at every second
//! joint, and its distance from the curve is of third order in its length: the number of arcs doubles per decade of
//! the tolerance (`docs/math/arc-splines.md#arcs-for-a-smooth-curve`, in the joint formula of [`Biarc`]; the greedy
//! length and the halving of the rest are ours). The distance is sampled in both directions, not certified.

use super::biarc::{Biarc, BiarcRule};
use crate::base::vector::{Point3, Vec3};
use crate::curve::{Arc, BlendSegment, CircleSpline, Correspondence, CurvePlace, Span};
use crate::error::{Error, NumberError, PointError, Result};
use std::ops::Range;

/// Turn of the curve's arcs over one interval of a stretch, radians: 15 degrees.
const INTERVAL_TURN: f64 = std::f64::consts::PI / 12.0;
/// Samples on each biarc at least.
const SAMPLES: usize = 48;
/// Samples on each interval of a stretch.
const INTERVAL_SAMPLES: f64 = 24.0;
/// Halvings of the way from one sample to the next where the parameter runs fast.
const MOST_HALVINGS: u32 = 40;
/// The part of the tolerance that distances may use. They are sampled, with a parabola through the three samples at
/// each largest one: with four samples to a lobe it misses at most 0.8 % of the top. A biarc over a smooth
/// piece has four lobes, over a joint of order 1 up to six, and where the speed of the parameter varies some of them have
/// half as many samples as the others.
const SAFETY: f64 = 0.98;
/// A biarc is as long as it may be up to this factor.
const LENGTH_RESOLUTION: f64 = 1.05;
/// Feet go back by no more than this part of an arc: rounding of their parameters.
const PLACE_ROUNDING: f64 = 1e-9;
/// Samples for each step of the parameter, at most: they are about as many as the curve is longer than the biarc.
const SAMPLES_PER_STEP: usize = 64;
/// Most biarcs per segment, and the shortest one as part of an interval.
const PIECE_CAP: usize = 4096;

impl CircleSpline {
    /// The curve as a chain of arcs and straight segments within `tolerance` of it (sampled in both directions), G1
    /// wherever the curve is. Segments that are arcs stay as they are; the others share biarcs across their nodes
    /// where the tolerance allows. The flag is true if every segment was an arc: then the chain is exact.
    ///
    /// # Errors
    /// `too-many-pieces` if a segment would need more than 4096 biarcs, `arc-through-infinity` for a segment whose tangents
    /// come within 5e-7 of the reversed chord: its points have lost their digits.
    pub fn to_g1_arcs(&self, tolerance: f64) -> Result<(Vec<Arc>, bool)> {
        self.g1_arcs(tolerance).map(|(arcs, exact, _)| (arcs, exact))
    }

    /// As [`to_g1_arcs`](Self::to_g1_arcs), with the parts of the curve that the arcs stand for.
    pub(crate) fn g1_arcs(&self, tolerance: f64) -> Result<(Vec<Arc>, bool, Correspondence)> {
        let n = self.segments().len();
        let mut arcs = Vec::new();
        let mut exact = true;
        let runs = self.smooth_runs();
        let start = CurvePlace::new(runs.first().map_or(0, |run| run.start), 0.0);
        let mut parts = Correspondence { start, spans: Vec::new() };
        for run in runs {
            let mut i = run.start;
            while i < run.end {
                if let Some(arc) = self.segments()[i % n].to_arc() {
                    arcs.push(arc);
                    parts.spans.push(Span { pieces: 1, end: CurvePlace::after(i) });
                    i += 1;
                } else {
                    let is_arc = |j: &usize| self.segments()[j % n].to_arc().is_some();
                    let stretch = (i + 1..run.end).find(is_arc).unwrap_or(run.end);
                    (i..stretch).try_for_each(|j| self.segments()[j % n].check_finite(j % n))?;
                    Stretch::new(self, i..stretch, tolerance).append_biarcs(&mut arcs, &mut parts.spans)?;
                    exact = false;
                    i = stretch;
                }
            }
        }
        Ok((arcs, exact, parts))
    }
}

/// Consecutive segments that join G1, cut into intervals of little turning, under one parameter: the number of the
/// interval plus the fraction of it. So neither steps nor samples leap over a part that runs far out.
struct Stretch<'a> {
    spline: &'a CircleSpline,
    intervals: Vec<Interval>,
    tolerance: f64,
    /// Most biarcs made.
    cap: usize,
}

/// A part of a segment, whose number runs on beyond the last one where a run passes the seam.
#[derive(Clone, Copy)]
struct Interval {
    segment: usize,
    from: f64,
    to: f64,
}

/// A place on the stretch.
#[derive(Clone, Copy)]
struct Place {
    v: f64,
    point: Point3,
    tangent: Vec3,
}

impl<'a> Stretch<'a> {
    fn new(spline: &'a CircleSpline, range: Range<usize>, tolerance: f64) -> Self {
        let cap = PIECE_CAP * range.len();
        let mut intervals = Vec::with_capacity(range.len());
        for segment in range {
            let mut from = 0.0;
            spline.segments()[segment % spline.segments().len()].steps_of_turn(INTERVAL_TURN, &mut |to| {
                intervals.push(Interval { segment, from, to });
                from = to;
            });
        }
        Self { spline, intervals, tolerance, cap }
    }

    /// Segment and its own parameter; at a joint the interval before it if `before`.
    fn locate(&self, v: f64, before: bool) -> (usize, f64) {
        let floor = if before { v.ceil() - 1.0 } else { v.floor() };
        // A place next to the end may round to it.
        let i = (floor as usize).min(self.intervals.len() - 1);
        let (Interval { segment, from, to }, s) = (self.intervals[i], v - i as f64);
        (segment, from * (1.0 - s) + to * s)
    }

    fn segment(&self, segment: usize) -> &BlendSegment {
        &self.spline.segments()[segment % self.spline.segments().len()]
    }

    fn place(&self, v: f64, before: bool) -> Result<Place> {
        let (piece, s) = self.locate(v, before);
        let jet = self.segment(piece).jet(s);
        let index = piece % self.spline.segments().len();
        let tangent = jet.tangent().ok_or(PointError::ZeroTangent { index })?;
        Ok(Place { v, point: jet.point, tangent })
    }

    /// Covers the segments with biarcs, each as long as the tolerance allows; the last two share the rest.
    fn append_biarcs(&self, arcs: &mut Vec<Arc>, spans: &mut Vec<Span>) -> Result<()> {
        let end = self.place(self.intervals.len() as f64, true)?;
        let mut from = self.place(0.0, false)?;
        let mut step = 1.0;
        let mut count = 0;
        while from.v < end.v {
            count += 1;
            let (mut biarc, mut to) = self.longest(&from, &end, step)?;
            let (used, rest) = (to.v - from.v, end.v - to.v);
            step = used;
            if rest > 0.0 && rest < used {
                let middle = self.place(from.v + 0.5 * (end.v - from.v), false)?;
                if let Some(shorter) = self.biarc_within(&from, &middle) {
                    (biarc, to) = (shorter, middle);
                }
            }
            if count > self.cap {
                return Err(self.too_many(from.v));
            }
            arcs.extend(biarc.arcs());
            let (piece, s) = self.locate(to.v, true);
            spans.push(Span { pieces: 2, end: CurvePlace { piece, s } });
            from = to;
        }
        Ok(())
    }

    /// The longest biarc from a place that stays within the tolerance, to a few per cent of its length.
    fn longest(&self, from: &Place, end: &Place, guess: f64) -> Result<(Biarc, Place)> {
        let all = end.v - from.v;
        let mut best = None;
        let (mut good, mut bad) = (0.0, f64::INFINITY);
        let mut step = guess.min(all);
        loop {
            let to = if step >= all { *end } else { self.place(from.v + step, false)? };
            match self.biarc_within(from, &to) {
                Some(biarc) => {
                    best = Some((biarc, to));
                    good = step;
                    if step >= all {
                        break;
                    }
                }
                None => bad = step,
            }
            if bad <= good * LENGTH_RESOLUTION {
                break;
            }
            if bad * (PIECE_CAP as f64) < 1.0 {
                break;
            }
            step = if bad.is_finite() { 0.5 * (good + bad) } else { (1.5 * step).min(all) };
        }
        best.ok_or_else(|| self.too_many(from.v))
    }

    fn too_many(&self, v: f64) -> Error {
        let segment = self.locate(v, false).0 % self.spline.segments().len();
        Error::Number(NumberError::TooManyPieces {
            what: "segment",
            segment: Some(segment),
            needed: (self.cap + 1) as f64,
            cap: self.cap,
            remedy: "use a larger tolerance",
        })
    }

    /// The biarc between two places, if it and the curve stay within the tolerance of each other.
    ///
    /// Every sample of the curve has its foot on the biarc within the tolerance, and the feet advance from end to
    /// end without leaps: then every part of the biarc is near the curve too. Samples lie closer where the parameter is
    /// slow to turn and fast to run, so that none is farther from the next than twice the mean.
    fn biarc_within(&self, from: &Place, to: &Place) -> Option<Biarc> {
        let biarc = Biarc::new(from.point, from.tangent, to.point, to.tangent, BiarcRule::EqualD).ok()?;
        let count = (((to.v - from.v) * INTERVAL_SAMPLES).ceil() as usize).max(SAMPLES);
        let longest = 2.0 * biarc.length() / count as f64;
        let mut walk = Walk::new(&biarc, from.point, self.tolerance);
        let mut last_v = from.v;
        let mut ahead: Vec<(f64, u32)> = Vec::new();
        let mut left = SAMPLES_PER_STEP * count;
        for i in 1..=count {
            ahead.push((if i == count { to.v } else { from.v + (to.v - from.v) * (i as f64 / count as f64) }, 0));
            while let Some((v, halvings)) = ahead.pop() {
                // The curve is this many times as long as the biarc, as over a loop whose ends nearly touch.
                left = left.checked_sub(1)?;
                let sample = if v >= to.v { walk.end(to.point) } else { walk.sample(self.point(v)) };
                // Far off the biarc: no need to look closer.
                if !(sample.distance <= walk.limit) {
                    return None;
                }
                if halvings < MOST_HALVINGS && sample.point.distance(walk.last.point) > longest {
                    ahead.extend([(v, halvings + 1), (0.5 * (last_v + v), halvings + 1)]);
                    continue;
                }
                if !walk.advances_to(sample) {
                    return None;
                }
                last_v = v;
            }
        }
        Some(biarc)
    }

    fn point(&self, v: f64) -> Point3 {
        let (piece, s) = self.locate(v, false);
        self.segment(piece).point(s)
    }
}

/// A sample of the curve with its foot on a biarc.
#[derive(Clone, Copy)]
struct Sample {
    point: Point3,
    distance: f64,
    /// Arc number plus parameter of the foot.
    place: f64,
    /// Length of the biarc up to the foot.
    length: f64,
}

/// The feet of the curve's samples along a biarc.
struct Walk<'a> {
    biarc: &'a Biarc,
    tolerance: f64,
    limit: f64,
    last: Sample,
    /// The distance before the last one.
    before: f64,
}

impl<'a> Walk<'a> {
    fn new(biarc: &'a Biarc, start: Point3, tolerance: f64) -> Self {
        let last = Sample { point: start, distance: 0.0, place: 0.0, length: 0.0 };
        Self { biarc, tolerance, limit: SAFETY * tolerance, last, before: 0.0 }
    }

    fn sample(&self, point: Point3) -> Sample {
        let (foot, place) = foot(self.biarc, point);
        let [first, second] = self.biarc.arcs();
        let length = if place <= 1.0 { first.length_to(place) } else { first.length() + second.length_to(place - 1.0) };
        Sample { point, distance: point.distance(foot), place, length }
    }

    fn end(&self, point: Point3) -> Sample {
        Sample { point, distance: 0.0, place: 2.0, length: self.biarc.length() }
    }

    /// Goes on to a sample, if it is near the biarc and its foot ahead of the last one.
    fn advances_to(&mut self, sample: Sample) -> bool {
        let near = top_of_parabola(self.before, self.last.distance, sample.distance) <= self.limit;
        let onward = sample.place >= self.last.place - PLACE_ROUNDING;
        // Feet advance like the samples, along the biarc: projection onto a curve this near cannot leap, except over a loop,
        // whose ends may be next to each other.
        let step = sample.point.distance(self.last.point);
        let leaps = sample.length - self.last.length > 2.0 * step + self.tolerance;
        // Where they leave a part out, as at a hairpin of the curve, the biarc may still run far from it there.
        let between = place_on(self.biarc, 0.5 * (self.last.place + sample.place));
        let follows = between.distance_to_segment([self.last.point, sample.point]) <= self.limit;
        self.before = self.last.distance;
        self.last = sample;
        near && onward && follows && !leaps
    }
}

/// Largest value over three samples one step apart, between them by the parabola through them.
fn top_of_parabola(a: f64, b: f64, c: f64) -> f64 {
    let bend = 2.0 * b - a - c;
    if b >= a && b >= c && bend > 0.0 { b + (a - c) * (a - c) / (8.0 * bend) } else { a.max(b).max(c) }
}

/// The point of a biarc at a place.
fn place_on(biarc: &Biarc, place: f64) -> Point3 {
    let [first, second] = biarc.arcs();
    if place < 1.0 { first.point(place.max(0.0)) } else { second.point((place - 1.0).min(1.0)) }
}

/// The nearest point of a biarc and its place, arc number plus parameter.
fn foot(biarc: &Biarc, point: Point3) -> (Point3, f64) {
    let [first, second] = biarc.arcs().map(|arc| arc.closest_point(point));
    if first.distance <= second.distance { (first.point, first.t) } else { (second.point, 1.0 + second.t) }
}
