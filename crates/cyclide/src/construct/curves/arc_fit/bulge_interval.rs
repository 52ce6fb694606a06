//! All arcs with given ends that stay within a tolerance of a polyline: one interval of bulges per orientation,
//! in constant time per vertex and edge (`docs/math/arc-fitting.md#feasible-bulges`).
//!
//! The arcs over a chord foliate the plane minus the outer rays of the chord line, so the arcs that meet a disc
//! about a vertex are an interval of bulges; an edge is the intersection of such intervals over its points; running
//! with the arc (M) is a half-line. Everything together is one interval: nothing is searched.

use super::chord::{ChordFrame, mirrored};
use crate::base::planar::{Point2, Vec2};
use crate::error::{NumberError, Result, check_tolerance};
use std::f64::consts::TAU;

/// The feasible bulges of a span: intervals of `|bulge| = tan(sweep/4)`, or `None` where no arc will do.
///
/// ```
/// use cyclide::{Point2, construct::feasible_bulges};
/// let points = [[-1.0, 0.0], [0.0, -0.5], [1.0, 0.0]].map(|[x, y]| Point2::new(x, y));
/// let [least, most] = feasible_bulges(&points, 0.01, false, 3.0)?.ccw.expect("arcs to the left");
/// assert!(least < 0.5 && 0.5 < most); // the arc through the middle point has the bulge 1/2
/// # Ok::<(), cyclide::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BulgeIntervals {
    /// Counter-clockwise arcs; `[0, x]` includes the line.
    pub ccw: Option<[f64; 2]>,
    /// Clockwise arcs; `[0, x]` includes the line.
    pub cw: Option<[f64; 2]>,
}

/// Every bulge of an arc from the first to the last point that passes within `tolerance` of each vertex (V), runs
/// with every edge (M; not asked of two samples alone) and, if `edges`, stays within `tolerance` of the edges themselves (E). Sweeps go up to
/// `max_sweep` radians, in `(0, 2 pi)`.
///
/// Extra turns (W of [`certify_arc`](super::certify_arc)) are not excluded here: test the bulge chosen.
///
/// ```
/// use cyclide::Point2;
/// let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]].map(|[x, y]| Point2::new(x, y));
/// let bulges = cyclide::construct::feasible_bulges(&points, 0.1, false, std::f64::consts::PI)?;
/// // Arcs to both sides, and the line.
/// assert!(bulges.ccw.is_some_and(|[least, _]| least == 0.0) && bulges.cw.is_some());
/// # Ok::<(), cyclide::Error>(())
/// ```
///
/// # Errors
/// `tolerance-not-positive`, `sweep-out-of-range`, `too-few-points` (fewer than 2), `not-finite`,
/// `coincident-points` (first and last equal).
pub fn feasible_bulges(points: &[Point2], tolerance: f64, edges: bool, max_sweep: f64) -> Result<BulgeIntervals> {
    check_tolerance(tolerance)?;
    if !(max_sweep > 0.0 && max_sweep < TAU) {
        return Err(NumberError::SweepOutOfRange { sweep: max_sweep, min: 0.0, max: TAU }.into());
    }
    let frame = ChordFrame::new(points)?;
    let t = tolerance / frame.half;
    let limit = (0.25 * max_sweep).tan();
    let left: Vec<Vec2> = points.iter().map(|p| frame.local(*p)).collect();
    let right: Vec<Vec2> = left.iter().map(|v| mirrored(*v)).collect();
    let solve = |p: &[Vec2]| counter_clockwise(p, t, edges, limit);
    Ok(BulgeIntervals { ccw: solve(&left), cw: solve(&right) })
}

/// Feasible bulges `b >= 0` in chord coordinates.
fn counter_clockwise(points: &[Vec2], t: f64, edges: bool, limit: f64) -> Option<[f64; 2]> {
    let mut range = Range { lo: 0.0, hi: limit };
    let m = points.len() - 1;
    // Infeasible spans mostly die on the middle vertex and the quarters.
    for k in [m / 2, m / 4, 3 * m / 4].into_iter().chain(0..=m).filter(|k| *k > 0 && *k < m) {
        range.vertex(points[k], t)?;
    }
    // Two samples alone say nothing about the way between them: every arc over the chord will do.
    if edges || m > 1 {
        for step in points.windows(2) {
            range.step(step[0], step[1])?;
        }
    }
    if edges {
        // After all vertices and steps: the rule reads off the bounds reached so far.
        for step in points.windows(2) {
            range.edge(step[0], step[1], t)?;
        }
    }
    Some([range.lo, range.hi])
}

/// The interval so far; every condition narrows it, `None` is empty.
struct Range {
    lo: f64,
    hi: f64,
}

impl Range {
    fn at_least(&mut self, b: f64) -> Option<()> {
        self.lo = self.lo.max(b);
        (self.lo <= self.hi).then_some(())
    }

    fn at_most(&mut self, b: f64) -> Option<()> {
        self.hi = self.hi.min(b);
        (self.lo <= self.hi).then_some(())
    }

    /// V: the arc meets the disc of radius `t` about the vertex.
    fn vertex(&mut self, v: Vec2, t: f64) -> Option<()> {
        let Vec2 { x, y } = v;
        let pa = (x + 1.0) * (x + 1.0) + y * y - t * t;
        let pc = (x - 1.0) * (x - 1.0) + y * y - t * t;
        if pa <= 0.0 || pc <= 0.0 {
            return Some(()); // the disc contains an end of the chord
        }
        let g = x * x + y * y - 1.0 - t * t;
        let root = (pa * pc).sqrt();
        if g <= 0.0 {
            self.at_least(-2.0 * (y + t) / (root - g))?;
            return self.at_most(-2.0 * (y - t) / (root - g));
        }
        let u = 0.5 * (root + g);
        if y < -t {
            self.at_least(u / (t - y))?;
            self.at_most(u / (-y - t))
        } else if y <= t {
            self.at_least(u / (t - y))
        } else {
            None
        }
    }

    /// M: `-D b² + 2 X b + D >= 0`, each bound in its form without cancellation.
    fn step(&mut self, p: Vec2, q: Vec2) -> Option<()> {
        let (x, d) = (p.cross(q), q.x - p.x);
        let s = x.hypot(d);
        if d > 0.0 {
            self.at_most(if x >= 0.0 { (x + s) / d } else { d / (s - x) })
        } else if d < 0.0 {
            self.at_least(if x <= 0.0 { (s - x) / -d } else { -d / (s + x) })
        } else if x < 0.0 {
            self.at_most(0.0)
        } else {
            Some(())
        }
    }

    /// E: `(1+e_x) b² - 2 w b + (1-e_x) <= 0` while the foot of the center is inside the edge.
    ///
    /// Where the foot leaves the edge the condition is that of a vertex, which holds already; so if a bound breaks
    /// E and the whole condition has no root there, nothing feasible is left.
    fn edge(&mut self, p: Vec2, q: Vec2, t: f64) -> Option<()> {
        let Some(e) = (q - p).unit() else { return Some(()) };
        let (from, to) = (e.dot(p), e.dot(q));
        let inside = |b: f64| {
            // k e_y with k = (1-b²)/(2b), the height of the center; infinite for the line.
            let foot = if b > 0.0 {
                0.5 * (1.0 / b - b) * e.y
            } else if e.y == 0.0 {
                0.0
            } else {
                return false;
            };
            from <= foot && foot <= to
        };
        let (at_lo, at_hi) = (inside(self.lo), inside(self.hi));
        if !(at_lo || at_hi) {
            return Some(());
        }
        let (minus, plus) = one_minus_and_plus(e);
        let w = t + p.cross(e);
        let (r1, r2) = if w == 0.0 && e.y == 0.0 && e.x > 0.0 {
            (0.0, 0.0)
        } else if w <= 0.0 || w < e.y.abs() {
            return None;
        } else {
            let root = w + ((w - e.y) * (w + e.y)).sqrt();
            (minus / root, root / plus)
        };
        if at_lo && self.lo < r1 {
            self.at_least(r1)?;
        }
        if at_hi && self.hi > r2 {
            self.at_most(r2)?;
        }
        Some(())
    }
}

/// `1 - e_x` and `1 + e_x` of a unit vector without cancellation.
pub(super) fn one_minus_and_plus(e: Vec2) -> (f64, f64) {
    if e.x > 0.0 { (e.y * e.y / (1.0 + e.x), 1.0 + e.x) } else { (1.0 - e.x, e.y * e.y / (1.0 - e.x)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_points_alone_bind_nothing_and_their_edge_binds_the_sagitta() {
        let points = [Point2::new(1.0, 2.0), Point2::new(5.0, 5.0)]; // half chord 2.5
        let limit = (0.25 * 6.0_f64).tan();
        let free = feasible_bulges(&points, 0.5, false, 6.0).unwrap();
        assert_eq!((free.ccw, free.cw), (Some([0.0, limit]), Some([0.0, limit])));
        // The sagitta is bulge times half chord: at most 0.5.
        let bound = feasible_bulges(&points, 0.5, true, 6.0).unwrap();
        for [lo, hi] in [bound.ccw.unwrap(), bound.cw.unwrap()] {
            assert!(lo == 0.0 && (hi - 0.2).abs() < 1e-15, "{lo} {hi}");
        }
    }
}
