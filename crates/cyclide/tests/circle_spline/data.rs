//! Point lists for the laws, and how far rounding moves a segment.

use cyclide::{
    Point3, Vec3,
    curve::{BlendSegment, BlendVariant, CircleSpline, CircleSplineOptions, ParamCurve},
};
use proptest::prelude::*;

pub fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn decades(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|e| 10.0_f64.powf(e))
}

/// Sizes near 1, small and large.
pub fn scale() -> impl Strategy<Value = f64> {
    prop_oneof![3 => Just(1.0), 1 => Just(1e-6), 1 => Just(1e6), 1 => decades(-30.0..30.0)]
}

/// A step from one point to the next: general, tiny, nearly straight on, or nearly back.
#[derive(Debug, Clone, Copy)]
enum Step {
    By(Vec3),
    Onward(f64, Vec3),
}

fn vector() -> impl Strategy<Value = Vec3> {
    (-1.0..1.0, -1.0..1.0, -1.0..1.0).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

fn step() -> impl Strategy<Value = Step> {
    let small = decades(-10.0..-2.0);
    prop_oneof![
        6 => vector().prop_map(Step::By),
        1 => (vector(), decades(-6.0..-1.0)).prop_map(|(v, s)| Step::By(v * s)),
        2 => (0.2..3.0, vector(), small).prop_map(|(f, v, h)| Step::Onward(f, v * h)),
        1 => (-3.0..-0.2, vector(), decades(-6.0..-1.0)).prop_map(|(f, v, h)| Step::Onward(f, v * h)),
    ]
}

fn walk(steps: &[Step]) -> Vec<Point3> {
    let mut at = Point3::ORIGIN;
    let mut last = Vec3::new(0.5, 0.3, -0.2);
    let mut points = vec![at];
    for step in steps {
        last = match step {
            Step::By(v) => *v,
            // The onward step does not shrink for ever.
            Step::Onward(f, v) => (last * *f + *v) * (0.5 / (last * *f + *v).length().max(0.1)),
        };
        at += last;
        points.push(at);
    }
    points
}

/// Lists of 4 to 8 points in space: general ones and ones with tiny steps, straight runs and turns back.
pub fn points() -> impl Strategy<Value = Vec<Point3>> {
    let shape = prop::collection::vec(step(), 3..8).prop_map(|steps| walk(&steps));
    (shape, scale()).prop_map(|(points, s)| points.into_iter().map(|p| Point3::ORIGIN + p.to_vec() * s).collect())
}

/// Points without near-degenerate steps.
pub fn tame_points() -> impl Strategy<Value = Vec<Point3>> {
    prop::collection::vec(vector().prop_map(Step::By), 3..8).prop_map(|steps| walk(&steps))
}

pub fn variant() -> impl Strategy<Value = BlendVariant> {
    prop_oneof![Just(BlendVariant::Trigonometric), Just(BlendVariant::Rational)]
}

pub fn options() -> impl Strategy<Value = CircleSplineOptions> {
    (any::<bool>(), 1_u32..=4, variant()).prop_map(|(closed, order, variant)| CircleSplineOptions {
        closed,
        order,
        variant,
        ..CircleSplineOptions::default()
    })
}

/// The spline, or `None` where neighbors happen to coincide.
pub fn spline(points: &[Point3], options: &CircleSplineOptions) -> Option<CircleSpline> {
    match CircleSpline::from_points(points, options) {
        Ok(spline) => Some(spline),
        Err(error) => {
            assert_eq!(error.reason(), "coincident-points", "{error}");
            None
        }
    }
}

/// Largest absolute coordinate.
pub fn reach(points: &[Point3]) -> f64 {
    points.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max)
}

/// Smallest `|u + t|²` over samples of the segment: from `|N|² = (1-2l)² + l m |u+t|²` and `|x-x1| = |d| l/|N|`.
pub fn infinity_distance_squared(segment: &BlendSegment) -> f64 {
    (1..64).map(|i| infinity_distance_squared_at(segment, f64::from(i) / 64.0)).fold(4.0, f64::min).max(1e-300)
}

/// The same, the least of all: from the least of many samples on by thirds.
pub fn least_infinity_distance_squared(segment: &BlendSegment) -> f64 {
    let value = |l: f64| infinity_distance_squared_at(segment, l);
    let place = |i: i32| f64::from(i) / 1024.0;
    let least = (2..1023).min_by(|i, j| value(place(*i)).total_cmp(&value(place(*j)))).unwrap_or(512);
    let (mut low, mut high) = (place(least - 1), place(least + 1));
    for _ in 0..40 {
        let third = (high - low) / 3.0;
        if value(low + third) < value(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    value(0.5 * (low + high)).min(value(place(least))).max(1e-300)
}

fn infinity_distance_squared_at(segment: &BlendSegment, l: f64) -> f64 {
    let n = segment.chord_length() * l / segment.point(l).distance(segment.start());
    (n * n - (1.0 - 2.0 * l).powi(2)) / (l * (1.0 - l))
}

/// How far rounding of the coordinates (size `reach`) moves a segment: the tangents by eps times size over shortest
/// chord (and over the sum of the unit chords at a sharp turn), the curve by that over `|t1 + t2|`, times
/// `|d|/|u+t|²` (`docs/math/circle-blends.md#rational-form`). A multiple of it is the tolerance of the laws.
pub fn rounding_of(points: &[Point3], spline: &CircleSpline) -> Vec<f64> {
    let (n, size) = (points.len(), reach(points));
    let chord = |i: usize| points[(i + 1) % n] - points[i % n];
    let condition_of_tangent = |i: usize| {
        let (e, d) = (chord((i + n - 1) % n), chord(i));
        let sum = (e / e.length() + d / d.length()).length().max(1e-300);
        1.0 / (sum * e.length().min(d.length()))
    };
    let inner = |i: usize| spline.is_closed() || (i > 0 && i + 1 < n);
    let of_segment = |(i, s): (usize, &BlendSegment)| {
        let mut tangent = 1.0 / s.chord_length();
        for node in [i, (i + 1) % n] {
            if inner(node) {
                tangent = tangent.max(condition_of_tangent(node));
            }
        }
        let apart = 2.0 * (0.5 * s.theta()).cos().abs().max(1e-300);
        let w2 = infinity_distance_squared(s);
        f64::EPSILON * (size + size * tangent * s.chord_length() / (apart.min(1.0) * w2.min(1.0)))
    };
    spline.segments().iter().enumerate().map(of_segment).collect()
}

/// The smallest sum of unit chords at a node: below about 1e-6 rounding may decide about a cusp.
pub fn sharpest_turn(points: &[Point3], closed: bool) -> f64 {
    let n = points.len();
    let chord = |i: usize| (points[(i + 1) % n] - points[i % n]).unit().unwrap();
    let nodes = if closed { 0..n } else { 1..n - 1 };
    nodes.map(|i| (chord((i + n - 1) % n) + chord(i)).length()).fold(2.0, f64::min)
}
