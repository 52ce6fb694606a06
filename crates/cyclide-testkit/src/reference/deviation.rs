//! Judging fitted paths on their own: distances by search along each arc, kinks from chords and bulges.

use cyclide::{
    Point3, Vec3,
    curve::{Arc, ArcPath, ParamCurve},
};

/// Steps of the coarse search per arc: more than one per 6 degrees of a full circle.
const STEPS: usize = 64;

/// The largest distance of any of the points to the path.
pub(super) fn largest_distance(path: &ArcPath, points: &[Point3]) -> f64 {
    points.iter().map(|p| distance(path, *p)).fold(0.0, f64::max)
}

/// Distance of a point to the path: for each arc a coarse search over its length, then golden sections around the best
/// step. The distance to a circular arc has one minimum between two neighbors of the best sample.
fn distance(path: &ArcPath, p: Point3) -> f64 {
    path.arcs().iter().map(|arc| distance_to_arc(arc, p)).fold(f64::INFINITY, f64::min)
}

fn distance_to_arc(arc: &Arc, p: Point3) -> f64 {
    let at = |l: f64| arc.point_at_length(l).distance(p);
    let h = 1.0 / STEPS as f64;
    let best =
        (0..=STEPS).map(|i| (at(i as f64 * h), i)).fold((f64::INFINITY, 0), |b, c| if c.0 < b.0 { c } else { b });
    let (mut a, mut b) = ((best.1 as f64 - 1.0).max(0.0) * h, ((best.1 + 1) as f64 * h).min(1.0));
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let mut least = best.0;
    // The distance is flat at its minimum: a bracket of 1e-8 gives it to 1e-16 relative.
    while b - a > 1e-8 * h {
        let (m0, m1) = (b - golden * (b - a), a + golden * (b - a));
        let (d0, d1) = (at(m0), at(m1));
        least = least.min(d0).min(d1);
        if d0 < d1 { b = m1 } else { a = m0 }
    }
    least
}

/// The largest angle between the tangents on both sides of a joint, the closing joint included.
pub(super) fn largest_kink(path: &ArcPath) -> f64 {
    let n = path.arcs().len();
    let joints = if path.is_closed() { n } else { n - 1 };
    let kink = |i: usize| {
        let (_, end) = end_tangents(&path.arcs()[i]);
        let (start, _) = end_tangents(&path.arcs()[(i + 1) % n]);
        end.cross(start).length().atan2(end.dot(start))
    };
    (0..joints).map(kink).fold(0.0, f64::max)
}

/// Directions at both ends from chord `c` and bulge vector `b`: the chord turned by half the sweep `4 atan|b|` against
/// and along the normal.
fn end_tangents(arc: &Arc) -> (Vec3, Vec3) {
    let (c, b) = (arc.chord(), arc.bulge_vector());
    let b2 = b.dot(b);
    // cos(alpha) and sin(alpha) u, times 1 + b².
    let (along, across) = (c * (1.0 - b2), c.cross(b) * 2.0);
    (along + across, along - across)
}
