//! The distance of two curves whose parts are known to belong together: each part from its own, both ways.
//!
//! Of every part the distance is the largest of: every sample of one from the nearest point of the other, both ways, and
//! start from start and end from end. As the parts follow each other along both curves, swapped, doubled or lost pieces
//! are found out, and no search over the whole curve can lose its way. The work is linear in the number of parts.

use super::track::Track;
use cyclide::{
    Point3,
    curve::{Correspondence, CurvePlace, ParamCurve},
};

/// Inner samples of a window, as parts of it.
const SAMPLES: [f64; 4] = [0.0, 0.25, 0.5, 0.75];
/// Rounding of the parameter of a place, relative to it: a few operations.
const PLACE_ROUNDING: f64 = 4.0 * f64::EPSILON;
/// What it may move a place by without being looked at, relative to the coordinates.
const SEEN: f64 = 1e-11;
/// Steps of the golden section that finds the largest distance between two samples.
const GOLDEN_STEPS: u32 = 24;

/// The largest distance so far from the samples of one curve, and where it is.
#[derive(Clone, Copy, Default)]
struct Worst {
    distance: f64,
    /// Number of the span, and in it the window and the part of the window.
    span: usize,
    window: usize,
    part: f64,
}

/// The largest distance between a curve and another form of it, part by part, both ways.
pub(super) fn apart(curve: &dyn ParamCurve, form: &dyn ParamCurve, parts: &Correspondence, plan: bool) -> f64 {
    let (mut a, mut b) = (Track::new(curve, plan), Track::new(form, plan));
    let mut worst = [Worst::default(); 2];
    let mut largest = 0.0_f64;
    each_span(parts, |span, ours, theirs| {
        let leeway = leeway(curve, ours);
        set(&mut b, theirs);
        if let Some(sure) = leeway.sure {
            set(&mut a, sure);
            one_way(&a, &b, span, &mut worst[0]);
        }
        if leeway.is_coarse {
            set(&mut a, leeway.possible);
        }
        one_way(&b, &a, span, &mut worst[1]);
        largest = larger(largest, if leeway.is_coarse { ends_off(&a, &b) } else { ends_apart(&a, &b) });
    });
    // Between the samples the distance may be larger: it is looked for where it is largest at them.
    let found = worst;
    each_span(parts, |span, ours, theirs| {
        if !found.iter().any(|worst| worst.span == span) {
            return;
        }
        let leeway = leeway(curve, ours);
        set(&mut b, theirs);
        if let Some(sure) = leeway.sure.filter(|_| found[0].span == span) {
            set(&mut a, sure);
            largest = larger(largest, refined(&a, &b, &found[0]));
        }
        if found[1].span == span {
            set(&mut a, leeway.possible);
            largest = larger(largest, refined(&b, &a, &found[1]));
        }
    });
    largest
}

/// Calls a function for each span with its number, its part of the curve and its part of the form.
fn each_span(parts: &Correspondence, mut visit: impl FnMut(usize, [CurvePlace; 2], [CurvePlace; 2])) {
    let (mut from, mut piece) = (parts.start, 0);
    for (number, span) in parts.spans.iter().enumerate() {
        let next = piece + span.pieces;
        visit(number, [from, span.end], [piece, next].map(|piece| CurvePlace::new(piece, 0.0)));
        (from, piece) = (span.end, next);
    }
}

/// What a part of a curve may be, given by parameters that are rounded.
struct Leeway {
    /// What belongs to it in any case; `None` where that is nothing.
    sure: Option<[CurvePlace; 2]>,
    /// What may belong to it.
    possible: [CurvePlace; 2],
    /// True if rounding of the parameters can be seen; else both are the part as given.
    is_coarse: bool,
}

/// A curve that passes near infinity runs nearly all of its way in a tiny range of its parameter, whose numbers cannot tell
/// places apart that are: the part may begin and end by so much earlier or later along the curve, but not beside it.
fn leeway(curve: &dyn ParamCurve, ends: [CurvePlace; 2]) -> Leeway {
    let is_coarse = |place: &CurvePlace| {
        let jet = curve.piece_jet(place.piece % curve.piece_count(), place.s);
        let moved = PLACE_ROUNDING * place.s * jet.d1.length();
        place.s < 1.0 && moved > SEEN * jet.point.to_vec().max_abs()
    };
    if !ends.iter().any(is_coarse) {
        return Leeway { sure: Some(ends), possible: ends, is_coarse: false };
    }
    let moved = |place: CurvePlace, by: f64| {
        let s = if place.s < 1.0 { (place.s * (1.0 + by * PLACE_ROUNDING)).min(1.0) } else { place.s };
        CurvePlace::new(place.piece, s)
    };
    let [from, to] = ends;
    let (sure, possible) = ([moved(from, 1.0), moved(to, -1.0)], [moved(from, -1.0), moved(to, 1.0)]);
    Leeway { sure: sure[1].is_from(sure[0]).then_some(sure), possible, is_coarse: true }
}

/// The larger of two distances; not a number is larger than all.
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b <= a { a } else { b }
}

fn set(track: &mut Track<'_>, [from, to]: [CurvePlace; 2]) {
    track.set_part(from, to);
}

/// The larger distance of start from start and end from end.
fn ends_apart(a: &Track<'_>, b: &Track<'_>) -> f64 {
    let apart = |p: Option<Point3>, q: Option<Point3>| p.zip(q).map_or(0.0, |(p, q)| p.distance(q));
    larger(apart(a.start(), b.start()), apart(a.end(), b.end()))
}

/// The larger distance of the ends of `b` from the part of `a`, which may be longer than `b`.
fn ends_off(a: &Track<'_>, b: &Track<'_>) -> f64 {
    let off = |p: Option<Point3>| p.map_or(0.0, |p| nearest(a, p, &mut 0));
    larger(off(b.start()), off(b.end()))
}

/// Notes the largest distance from the samples of the part of `a` to the part of `b`. Its last point is an end, whose
/// distance is known.
fn one_way(a: &Track<'_>, b: &Track<'_>, span: usize, worst: &mut Worst) {
    let mut near = 0;
    for (window, w) in a.windows.iter().enumerate() {
        for part in SAMPLES {
            let p = if part > 0.0 { a.point(w, part) } else { w.start.point };
            let distance = nearest(b, p, &mut near);
            // Not a number is worse than anything, and stays so.
            if !(distance <= worst.distance || worst.distance.is_nan()) {
                *worst = Worst { distance, span, window, part };
            }
        }
    }
}

/// Distance to the nearest point of the part; `near` is the window that had the last one, which is tried first.
fn nearest(b: &Track<'_>, p: Point3, near: &mut usize) -> f64 {
    let first = (*near).min(b.windows.len() - 1);
    let mut best = b.distance(&b.windows[first], p);
    for (index, w) in b.windows.iter().enumerate() {
        if index != first && w.may_be_within(best, p) {
            let distance = b.distance(w, p);
            if distance < best {
                (best, *near) = (distance, index);
            }
        }
    }
    best
}

/// The distance near the sample that is worst, at its largest between the neighboring samples (golden section).
fn refined(a: &Track<'_>, b: &Track<'_>, worst: &Worst) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_895;
    let Some(w) = a.windows.get(worst.window) else { return worst.distance };
    let mut near = 0;
    let mut value = |part: f64| nearest(b, a.point(w, part), &mut near);
    let step = SAMPLES[1];
    let (mut low, mut high) = ((worst.part - step).max(0.0), (worst.part + step).min(1.0));
    let (mut c, mut d) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut at_c, mut at_d) = (value(c), value(d));
    for _ in 0..GOLDEN_STEPS {
        if at_c > at_d {
            (high, d, at_d) = (d, c, at_c);
            c = high - GOLDEN * (high - low);
            at_c = value(c);
        } else {
            (low, c, at_c) = (c, d, at_d);
            d = low + GOLDEN * (high - low);
            at_d = value(d);
        }
    }
    larger(worst.distance, larger(at_c, at_d))
}

#[cfg(test)]
mod tests {
    use super::*;
    use cyclide::{
        Quat, Vec3,
        conformal::HPoint,
        construct::{QbInterpolation, QbNode},
        curve::{Arc, ArcPath, CircleSpline, CircleSplineOptions, QbCurve},
        model::{CurveChain, Lower as _, Lowered},
    };

    /// Two half circles and two sides, with the arcs in some order.
    fn slot(order: [usize; 4]) -> CurveChain {
        let at = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [8.0, 6.0, 0.0], [0.0, 6.0, 0.0]].map(Point3::from);
        let piece =
            |i: usize| Arc::from_bulge(at[i], at[(i + 1) % 4], Vec3::Z, if i.is_multiple_of(2) { 0.0 } else { 1.0 });
        let pieces = order.map(|i| cyclide::model::ChainPiece::Arc(piece(i).unwrap())).to_vec();
        CurveChain::new(pieces, true, f64::INFINITY).unwrap()
    }

    #[test]
    fn swapped_and_doubled_pieces_are_as_far_off_as_the_curve_is_wide() {
        let (slot, far) = (slot([0, 1, 2, 3]), |order| {
            apart(&slot([0, 1, 2, 3]), &slot(order), &Correspondence::one_to_one(4), false)
        });
        assert!(apart(&slot, &slot, &Correspondence::one_to_one(4), false) < 1e-14);
        for order in [[0, 3, 2, 1], [0, 1, 0, 3], [2, 3, 0, 1]] {
            assert!(far(order) > 5.0, "{order:?}");
        }
    }

    /// A part is not measured against its neighbors: parts given wrongly by a tenth of a piece are found out.
    #[test]
    fn a_wrong_correspondence_is_found_out() {
        let points = [[0.0, 0.0, 0.0], [4.0, 1.0, 0.0], [5.0, 4.0, 1.0], [1.0, 3.0, 2.0]].map(Point3::from);
        let spline = CircleSpline::from_points(&points, &CircleSplineOptions::default()).unwrap();
        let Lowered { form, correspondence: mut parts, .. } = spline.lower_to_chain(1e-3).unwrap();
        assert!(apart(&spline, &form, &parts, false) < 1e-13);
        parts.spans[0].end = CurvePlace::new(0, 0.9);
        assert!(apart(&spline, &form, &parts, false) > 0.1);
    }

    #[test]
    fn a_part_without_pieces_is_measured_against_a_point() {
        let segment = |x0: f64, x1: f64| Arc::segment(Point3::new(x0, 0.0, 0.0), Point3::new(x1, 0.0, 0.0)).unwrap();
        let path = ArcPath::new(vec![segment(0.0, 1.0), segment(1.0, 1.25), segment(1.25, 2.0)], false).unwrap();
        let form = ArcPath::new(vec![segment(0.0, 1.0), segment(1.25, 2.0)], false);
        assert!(form.is_err(), "it does not hang together");
        let form = CurveChain::new(
            [segment(0.0, 1.0), segment(1.25, 2.0)].map(cyclide::model::ChainPiece::Arc).to_vec(),
            false,
            1.0,
        );
        let parts = Correspondence::one_to_one(3).recounted([1, 0, 1]);
        let distance = apart(&path, &form.unwrap(), &parts, false);
        assert!((distance - 0.25).abs() < 1e-15, "{distance}");
    }

    /// From 0 to 1 along the x-axis, and between the parameters 0.8 ± 1e-4 once round a circle of radius `r`: the complex curve
    /// `t + 2 i r e/(e - i (t - c))`, in quaternions `i (x - y k)` for `x + i y`.
    fn with_a_loop(r: f64) -> QbCurve {
        let (e, c) = (1e-4, 0.8);
        let weight = |t: f64| Quat::new(e, 0.0, 0.0, t - c);
        let rise = Quat::new(0.0, 0.0, 0.0, -2.0 * r * e);
        let (first, last) = (weight(0.0), weight(1.0));
        let pairs = [(rise, first), (rise + first * 0.5, (first + last) * 0.5), (rise + last, last)];
        QbCurve::new(&pairs.map(|(n, d)| HPoint { n: Quat::new(0.0, 1.0, 0.0, 0.0) * n, d })).unwrap()
    }

    /// A curve that stops in the origin has no direction there, and its exact form, whose control points are rounded, has any.
    #[test]
    fn a_stop_in_the_origin_is_no_maze() {
        let node = |parameter: f64, x: f64, y: f64, derivatives: &[Vec3]| QbNode {
            parameter,
            point: Point3::new(x, y, 0.0),
            derivatives: derivatives.to_vec(),
        };
        // The first is the centripetal parameter.
        for t in [1.0 / (1.0 + 2.0_f64.powf(0.25)), 0.4, 0.6] {
            let nodes = [node(0.0, 0.0, 0.0, &[Vec3::ZERO]), node(t, 1.0, 0.0, &[]), node(1.0, 0.0, 1.0, &[Vec3::Y])];
            let through = QbInterpolation::through_nodes(&nodes).unwrap();
            let curve = cyclide::curve::QbSpline::from_curve(through.curve().clone()).unwrap();
            let Lowered { form, correspondence, .. } = curve.lower_to_chain(1e-3).unwrap();
            // The weights of the form differ by a thousand: so many roundings of its coordinates.
            assert!(apart(&curve, &form, &correspondence, false) < 1e-12, "{t}");
        }
    }

    /// Ends, tangents and speeds of a stretch say nothing of a loop between them.
    #[test]
    fn a_loop_in_a_tiny_range_of_the_parameter_is_seen() {
        for r in [0.3, 1e-2, 1e-3] {
            let curve = with_a_loop(r);
            let [a, b] = [0.0, 1.0].map(|t| curve.point(t));
            let straight = Arc::segment(a, b).unwrap();
            let parts = Correspondence::one_to_one(1);
            // The loop is as high as it is wide; the rest of the curve is nearer to the segment than 2 r e/0.2.
            for (a, b) in [(&curve as &dyn ParamCurve, &straight as &dyn ParamCurve), (&straight, &curve)] {
                let distance = apart(a, b, &parts, false);
                assert!((distance / (2.0 * r) - 1.0).abs() < 2e-3, "{r} {distance}");
            }
            // And nothing is wrong with the exact form, which is cut at other places.
            let Lowered { form, correspondence, .. } =
                cyclide::curve::QbSpline::from_curve(curve.clone()).unwrap().lower_to_chain(1e-3).unwrap();
            // Pairs next to a common zero: their denominators are 1e-4 of what they are sums of.
            assert!(apart(&curve, &form, &correspondence, false) < 1e-11);
        }
    }
}
