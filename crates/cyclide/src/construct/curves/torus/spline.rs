//! Splines through points of a torus, which always succeed (`docs/math/torus-splines.md#the-general-problem`).
//!
//! Each segment is joined by two pieces of the type that fits best; where none fits well, it is halved along the cubic through its
//! data, and where that does not help, joined by a detour of arcs and lines in the plane of the torus.

use super::detour::detour;
use super::spline_data::{Data, shortest_step};
use super::spline_options::TorusSplineOptions;
use super::spline_span::{Hermite, TypedSpan};
use crate::base::planar::Point2;
use crate::base::vector::Point3;
use crate::error::{Result, TorusError};
use crate::surface::{SegmentMethod, Torus, TorusChain, TorusSpline};
use std::f64::consts::TAU;

/// Types of a smaller quality are not taken where a segment can be halved: the curve would come nearly to a stop.
const GOOD: f64 = 0.03;

/// Most halvings of a segment.
const HALVINGS: u32 = 5;

impl TorusSpline {
    /// The spline through points on or near a torus: each is replaced by the nearest point of the torus, which must be within
    /// `tolerance`.
    ///
    /// ```
    /// use cyclide::{Frame, Point3, construct::TorusSplineOptions, surface::{Torus, TorusSpline}};
    /// let torus = Torus::new(Frame::WORLD, 3.0, 1.0)?;
    /// let points = [[4.01, 0.0, 0.0], [0.0, 3.0, 1.02], [-2.0, 0.0, 0.0]].map(Point3::from);
    /// let seam = TorusSpline::through_points(&torus, &points, 0.05, &TorusSplineOptions::default())?;
    /// assert!(seam.jet_at_knot(1.0).point.distance(Point3::new(0.0, 3.0, 1.0)) < 1e-15);
    /// # Ok::<(), cyclide::Error>(())
    /// ```
    ///
    /// # Errors
    /// `point-on-axis`, `point-on-core-circle`, `point-off-torus`, `not-finite`, `tolerance-not-positive`, and as
    /// [`through_places`](Self::through_places).
    pub fn through_points(
        torus: &Torus,
        points: &[Point3],
        tolerance: f64,
        options: &TorusSplineOptions,
    ) -> Result<Self> {
        Self::through_places(torus, &torus.locate_all(points, tolerance)?, options)
    }

    /// The spline through places of a torus, parametrically C1, with the tangents, knots and half turns of the options. Any such data
    /// have one: where tangents turn back the curve makes a loop.
    ///
    /// # Errors
    /// `too-few-points` (2 are needed, 1 of a closed curve that winds), `not-finite`, `count-differs` (tangents, knots, half turns),
    /// `zero-tangent`, `coincident-points` (neighbors modulo pi, unless loops are asked for), `empty-interval` (knots that do not
    /// increase, or a span below 1e-12 of the whole), `parameter-out-of-range` (angles above 1e6, more than 2,000 half turns, a
    /// tangent times the length of its span outside 1e-12 to 1e12), `too-many-pieces`.
    pub fn through_places(torus: &Torus, places: &[Point2], options: &TorusSplineOptions) -> Result<Self> {
        let data = Data::new(torus, places, options)?;
        let mut chain = TorusChain::starting_at(data.knots[0]);
        for segment in 0..data.steps.len() {
            append_segment(&data, segment, &mut chain)?;
        }
        Ok(chain.into_spline(torus, data.closed, data.places[data.places.len() - 1]))
    }
}

fn append_segment(data: &Data, segment: usize, chain: &mut TorusChain) -> Result<()> {
    let (start, end) = (data.knots[segment], data.knots[segment + 1]);
    // The end of a segment is its knot to the bit.
    let knot = |part: f64| if part >= 1.0 { end } else { start + part * (end - start) };
    let whole = Hermite { start: data.places[segment], step: data.steps[segment], rates: data.ways(segment) };
    let (mut spans, method) = join(&whole)?;
    if whole.step.length() > TAU {
        share_rounding(&mut spans, data.places[(segment + 1) % data.places.len()]);
    }
    let quality = spans.iter().map(|span| span.quality).fold(1.0, f64::min);
    for span in &spans {
        span.append(chain, knot, end - start)?;
    }
    chain.end_segment(method, quality);
    Ok(())
}

/// Shares among the spans what so many steps miss the end by: rounding of turns, which would be a gap at the next segment.
fn share_rounding(spans: &mut [TypedSpan], end: Point2) {
    let Some(last) = spans.last() else { return };
    let missing = shortest_step(last.data.start + last.data.step, end);
    for span in spans {
        let [from, to] = span.part;
        span.data.start += missing * from;
        span.data.step += missing * (to - from);
    }
}

/// The spans of a segment.
fn join(whole: &Hermite) -> Result<(Vec<TypedSpan>, SegmentMethod)> {
    let mut spans = Vec::new();
    if append_halves(whole, [0.0, 1.0], HALVINGS, &mut spans) {
        let method = if spans.len() == 1 { SegmentMethod::Direct } else { SegmentMethod::Halved };
        return Ok((spans, method));
    }
    let mut from = 0.0;
    let mut typed = |(data, to): (Hermite, f64)| {
        // Every span of a detour turns by less than 45 degrees, which is inside the cone of some type.
        let (kind, quality) = data.best().ok_or_else(|| TorusError::NotMonotone {
            coordinate: 0,
            step: data.step.length(),
            slopes: data.rates.map(|rate| rate.length()),
        })?;
        let part = [from, to];
        from = to;
        Ok(TypedSpan { data, kind, quality, part })
    };
    let spans = detour(whole).into_iter().map(&mut typed).collect::<Result<_>>()?;
    Ok((spans, SegmentMethod::Detour))
}

/// Appends the spans of data, halved until each has a good type; false if the halvings do not suffice.
fn append_halves(data: &Hermite, [from, to]: [f64; 2], halvings: u32, spans: &mut Vec<TypedSpan>) -> bool {
    if let Some((kind, quality)) = data.best().filter(|(_, quality)| *quality >= GOOD) {
        spans.push(TypedSpan { data: *data, kind, quality, part: [from, to] });
        return true;
    }
    if halvings == 0 {
        return false;
    }
    let (middle, [first, second]) = (0.5 * (from + to), data.halves());
    append_halves(&first, [from, middle], halvings - 1, spans)
        && append_halves(&second, [middle, to], halvings - 1, spans)
}
