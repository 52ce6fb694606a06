//! Point lists for the laws.

use cyclide::{
    Point3, Vec3,
    construct::{FairEnd, FairSplineOptions},
    curve::CircleSpline,
};
use proptest::prelude::*;

pub fn p(x: f64, y: f64, z: f64) -> Point3 {
    Point3::new(x, y, z)
}

fn decades(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|e| 10.0_f64.powf(e))
}

fn vector() -> impl Strategy<Value = Vec3> {
    (-1.0..1.0, -1.0..1.0, -1.0..1.0).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

/// Where the steps of a walk lie.
fn flattened(points: Vec<Point3>, flat: bool) -> Vec<Point3> {
    points.into_iter().map(|q| if flat { p(q.x, q.y, 0.0) } else { q }).collect()
}

fn sums(steps: impl IntoIterator<Item = Vec3>) -> Vec<Point3> {
    let mut at = Point3::ORIGIN;
    let next = steps.into_iter().map(|step| {
        at += step;
        at
    });
    std::iter::once(Point3::ORIGIN).chain(next).collect()
}

/// Walks that turn by up to about a radian from step to step, in the plane or in space, unevenly spaced.
pub fn tame() -> impl Strategy<Value = Vec<Point3>> {
    let step = (-0.5..0.5, -0.5..0.5, 0.5..2.0);
    (prop::collection::vec(step, 3..20), any::<bool>()).prop_map(|(steps, flat)| {
        let (mut heading, mut climb) = (0.3_f64, 0.0_f64);
        let step = |(turn, rise, length): (f64, f64, f64)| {
            heading += 1.6 * turn;
            climb = 0.7 * climb + rise;
            Vec3::new(heading.cos(), heading.sin(), climb) * length
        };
        flattened(sums(steps.into_iter().map(step)), flat)
    })
}

/// Anything: random steps, steps of very different length, zigzags, right-angled stairs, nearly straight and nearly back.
pub fn wild() -> impl Strategy<Value = Vec<Point3>> {
    let any_step = vector();
    let uneven = (vector(), decades(-3.0..0.0)).prop_map(|(v, s)| v * s);
    let stairs = (0..4_usize, 0.3..1.0).prop_map(|(k, s)| [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::Y][k] * s);
    let clouds = prop::collection::vec(any_step, 3..14);
    let uneven = prop::collection::vec(uneven, 3..14);
    let stairs = prop::collection::vec((stairs, vector()).prop_map(|(s, v)| s + v * 1e-3), 3..14);
    let zigzag = prop::collection::vec((vector(), 0.3..1.0), 3..14).prop_map(|steps| {
        let to_and_fro =
            |(i, (v, s)): (usize, (Vec3, f64))| (if i % 2 == 0 { Vec3::X } else { -Vec3::X }) * s + v * 0.15;
        steps.into_iter().enumerate().map(to_and_fro).collect::<Vec<_>>()
    });
    (prop_oneof![clouds, uneven, stairs, zigzag], any::<bool>()).prop_map(|(steps, flat)| flattened(sums(steps), flat))
}

pub fn end() -> impl Strategy<Value = FairEnd> {
    prop_oneof![
        2 => Just(FairEnd::Circle),
        1 => Just(FairEnd::Arc),
        1 => Just(FairEnd::Free),
        1 => vector().prop_map(|v| FairEnd::Clamped(v + Vec3::new(0.01, 0.02, 0.03))),
    ]
}

pub fn options() -> impl Strategy<Value = FairSplineOptions> {
    let tension = prop_oneof![3 => Just(0.0), 1 => 0.0..1.0, 1 => Just(1.0)];
    let tight = prop_oneof![3 => Just(None), 1 => (0.01..0.49).prop_map(Some)];
    let flags = (any::<bool>(), any::<bool>(), any::<bool>());
    (flags, end(), end(), tension, tight).prop_map(
        |((closed, straight_runs, cut_sharp_turns), start, end, tension, tight)| FairSplineOptions {
            closed,
            ends: [start, end],
            tension,
            straight_runs,
            tight,
            corners: Vec::new(),
            cut_sharp_turns,
        },
    )
}

/// The spline, or `None` where neighbors happen to coincide.
pub fn spline(points: &[Point3], options: &FairSplineOptions) -> Option<CircleSpline> {
    match CircleSpline::fair(points, options) {
        Ok(spline) => Some(spline),
        Err(error) => {
            assert!(["coincident-points", "arc-through-infinity"].contains(&error.reason()), "{error}");
            None
        }
    }
}

pub fn closed() -> FairSplineOptions {
    FairSplineOptions { closed: true, ..Default::default() }
}

pub fn with_ends(ends: [FairEnd; 2]) -> FairSplineOptions {
    FairSplineOptions { ends, straight_runs: false, ..Default::default() }
}

/// Largest absolute coordinate.
pub fn reach(points: &[Point3]) -> f64 {
    points.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max)
}

/// Points over all segments, 16 for each.
pub fn samples(spline: &CircleSpline) -> Vec<Point3> {
    let on = |s: &cyclide::curve::BlendSegment| (0..16).map(|i| s.point(f64::from(i) / 16.0)).collect::<Vec<_>>();
    spline.segments().iter().flat_map(on).collect()
}
