//! One arc, one line or one circle for everything: tried before any search (`docs/math/arc-fitting.md#tube-beam`).

use super::beam::ChainJoint;
use super::chord::{ChordFrame, mirrored};
use super::curvature_interval::JointFrame;
use super::options::ArcLimits;
use super::{certify_arc, feasible_bulges};
use crate::base::planar::{Point2, Vec2};

/// Largest sweep of a single arc, radians: beyond, ends and bulge fix it badly.
const MAX_SWEEP: f64 = 350.0 / 180.0 * std::f64::consts::PI;
/// Part of the feasible interval kept clear at each end.
const INTERVAL_MARGIN: f64 = 0.02;
/// A line is preferred if it deviates by at most this part of the tolerance.
const LINE_PREFERENCE: f64 = 0.2;

/// One arc or line from the first to the last point within the tolerance, as a chain of one.
pub(super) fn single_arc(points: &[Point2], tolerance: f64, edges: bool, limits: ArcLimits) -> Option<Vec<ChainJoint>> {
    let bulge = single_bulge(points, tolerance, edges)?;
    let (a, b) = (points[0], points[points.len() - 1]);
    let curvature = 4.0 * bulge.abs() / ((1.0 + bulge * bulge) * a.distance(b));
    if bulge != 0.0 && (curvature > limits.curvature || 4.0 * bulge.abs().atan() < limits.length * curvature) {
        return None;
    }
    let chord = (b - a).unit()?;
    // Half the sweep before and after the chord: sine and cosine of 2 atan(bulge).
    let d = 1.0 + bulge * bulge;
    let (sine, cosine) = (2.0 * bulge / d, (1.0 - bulge) * (1.0 + bulge) / d);
    let joint = |vertex: usize, joint: Point2, side: f64| ChainJoint {
        vertex,
        frame: JointFrame { joint, tangent: chord * cosine + chord.left() * (side * sine) },
        straight: bulge == 0.0,
    };
    Some(vec![joint(0, a, -1.0), joint(points.len() - 1, b, 1.0)])
}

fn single_bulge(points: &[Point2], tolerance: f64, edges: bool) -> Option<f64> {
    let intervals = feasible_bulges(points, tolerance, edges, MAX_SWEEP).ok()?;
    let deviation = |bulge: f64| {
        let c = certify_arc(points, bulge, None).ok().filter(|c| c.proves())?;
        let d = if edges { c.deviation } else { c.vertex_deviation };
        (d <= tolerance).then_some(d)
    };
    let line_feasible = [intervals.ccw, intervals.cw].into_iter().flatten().any(|i| i[0] == 0.0);
    if line_feasible && deviation(0.0).is_some_and(|d| d <= LINE_PREFERENCE * tolerance) {
        return Some(0.0);
    }
    let frame = ChordFrame::new(points).ok()?;
    let candidate = |interval: Option<[f64; 2]>, sign: f64| {
        let [lo, hi] = interval?;
        let margin = INTERVAL_MARGIN * (hi - lo);
        let best = least_squares(points, &frame, sign).clamp(lo + margin, hi - margin);
        Some((sign * best, deviation(sign * best)?))
    };
    let both = [candidate(intervals.ccw, 1.0), candidate(intervals.cw, -1.0)];
    both.into_iter().flatten().min_by(|a, b| a.1.total_cmp(&b.1)).map(|(bulge, _)| bulge)
}

/// `k = sum y (x²+y²-1)/(2 sum y²)` in chord coordinates, as a bulge.
fn least_squares(points: &[Point2], frame: &ChordFrame, sign: f64) -> f64 {
    let (mut above, mut below) = (0.0, 0.0);
    for p in points {
        let v = frame.local(*p);
        let v = if sign < 0.0 { mirrored(v) } else { v };
        above += v.y * (v.dot(v) - 1.0);
        below += 2.0 * v.y * v.y;
    }
    let k = if below > 0.0 { above / below } else { f64::INFINITY };
    if k >= 0.0 { 1.0 / (k + k.hypot(1.0)) } else { k.hypot(1.0) - k }
}

/// A full circle within the tolerance of a closed polyline, as two arcs that meet over the first vertex and the one
/// nearest to half a turn from it.
pub(super) fn single_circle(
    points: &[Point2],
    tolerance: f64,
    edges: bool,
    limits: ArcLimits,
) -> Option<Vec<ChainJoint>> {
    let n = points.len();
    let center = circle_center(points)?;
    let spokes: Vec<Vec2> = points.iter().map(|p| *p - center).collect();
    let (least, most) =
        spokes.iter().map(|u| u.length()).fold((f64::INFINITY, 0.0_f64), |(a, b), l| (a.min(l), b.max(l)));
    let radius = 0.5 * (least + most);
    // It is written as two half circles.
    let is_allowed = radius * limits.curvature >= 1.0 && std::f64::consts::PI * radius >= limits.length;
    if !(most - radius <= tolerance && radius > tolerance && is_allowed) {
        return None;
    }
    let direction = spokes[0].cross(spokes[1]).signum();
    let mut turned = vec![0.0];
    for i in 0..n {
        let (u, v) = (spokes[i], spokes[(i + 1) % n]);
        let area = direction * u.cross(v);
        let edge = v - u;
        let foot_inside = u.dot(edge) < 0.0 && v.dot(edge) > 0.0;
        if area < 0.0 || (edges && foot_inside && radius - area / edge.length() > tolerance) {
            return None;
        }
        turned.push(turned[i] + area.atan2(u.dot(v)));
    }
    // W: exactly one turn.
    let full = std::f64::consts::TAU;
    if (turned[n] - full).abs() > 1e-6 {
        return None;
    }
    let half = (1..n).min_by(|a, b| {
        let off = |i: usize| (turned[i] - 0.5 * full).abs();
        off(*a).total_cmp(&off(*b))
    })?;
    let joint = |vertex: usize| {
        let u = spokes[vertex % n].unit()?;
        let frame = JointFrame { joint: center + u * radius, tangent: u.left() * direction };
        Some(ChainJoint { vertex, frame, straight: false })
    };
    Some(vec![joint(0)?, joint(half)?, joint(n)?])
}

/// Center of the least-squares circle `x²+y² - 2ax - 2by + c = 0` about the centroid.
fn circle_center(points: &[Point2]) -> Option<Point2> {
    let n = points.len() as f64;
    let sum = points.iter().fold(Vec2::default(), |s, p| s + (*p - points[0]));
    let middle = points[0] + sum * (1.0 / n);
    let (mut xx, mut xy, mut yy, mut xr, mut yr) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for p in points {
        let v = *p - middle;
        let r = v.dot(v);
        xx += v.x * v.x;
        xy += v.x * v.y;
        yy += v.y * v.y;
        xr += v.x * r;
        yr += v.y * r;
    }
    let det = xx * yy - xy * xy;
    // Nearly on a line: no circle that closed data could mean.
    if !(det > 1e-12 * (xx + yy) * (xx + yy)) {
        return None;
    }
    Some(middle + Vec2::new(xr * yy - yr * xy, yr * xx - xr * xy) * (0.5 / det))
}
