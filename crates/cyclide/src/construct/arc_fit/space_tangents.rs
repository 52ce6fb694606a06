//! Candidate tangents at the points of a curve in space (`docs/math/arc-fitting.md#space`).
//!
//! The tangents of the curve itself are not the best joints of arcs: a spline of arcs of length `l` on a spiral errs
//! less if its tangents are off by `kappa' l²/12`. So besides the three-point tangent each point offers the tangent
//! of the widest circle through it that keeps within the tolerance of the points around, turned a little either way.

use super::super::arc_spline::estimate_tangents;
use crate::base::vector::{Point3, Vec3};
use crate::curve::Arc;

/// Turns of the wide tangent, in units of tolerance over mean chord.
const TURNS: [f64; 5] = [0.0, 2.5, -2.5, 5.0, -5.0];
/// Largest turn, radians.
const MAX_TURN: f64 = 0.5;
/// Widest window, in points to each side.
const MAX_WINDOW: usize = 256;

/// A run of points; of a closed curve, the whole ring.
pub(super) struct Run<'a> {
    pub points: &'a [Point3],
    pub ring: bool,
}

impl Run<'_> {
    /// The point, counted around a ring.
    pub fn at(&self, index: usize) -> Point3 {
        self.points[index % self.points.len()]
    }

    /// Number of edges.
    pub fn edges(&self) -> usize {
        self.points.len() - usize::from(!self.ring)
    }

    /// Candidate unit tangents at a point; empty only where the points turn back on themselves.
    pub fn tangents(&self, k: usize, tolerance: f64) -> Vec<Vec3> {
        let n = self.points.len();
        if n == 2 {
            return (self.points[1] - self.points[0]).unit().into_iter().collect();
        }
        let near = self.window(k, 1);
        let mut found: Vec<Vec3> = near.and_then(|w| w.tangent()).into_iter().collect();
        let Some(wide) = self.widest(k, tolerance) else { return found };
        let Some(tangent) = wide.tangent() else { return found };
        let [a, b, c] = wide.points;
        let normal = (b - a).cross(c - b).unit().unwrap_or(tangent.any_perpendicular());
        let mean = 0.5 * (a.distance(b) + b.distance(c));
        let unit = (2.5 * tolerance / mean).min(0.5 * MAX_TURN) / 2.5;
        found.extend(TURNS.iter().filter_map(|turn| {
            let (s, c) = (turn * unit).sin_cos();
            (tangent * c + normal.cross(tangent) * s).unit()
        }));
        found
    }

    /// The points `m` before and after `k`; at an end of an open run the first three, `m` apart.
    fn window(&self, k: usize, m: usize) -> Option<Window> {
        let n = self.points.len();
        let (indices, place) = if self.ring {
            if 2 * m >= n {
                return None;
            }
            ([k + n - m, k, k + m], 1)
        } else if k == 0 {
            ([0, m, 2 * m], 0)
        } else if k == n - 1 {
            ([(n - 1).checked_sub(2 * m)?, n - 1 - m, n - 1], 2)
        } else {
            ([k.checked_sub(m)?, k, k + m], 1)
        };
        if !self.ring && indices[2] >= n {
            return None;
        }
        Some(Window { points: indices.map(|i| self.at(i)), first: indices[0], count: 2 * m, place })
    }

    /// The largest window whose points are all within the tolerance of its circle, by doubling and bisection.
    fn widest(&self, k: usize, tolerance: f64) -> Option<Window> {
        let fits = |m: usize| self.window(k, m).filter(|w| w.fits(self, tolerance));
        let mut best = (1, fits(1)?);
        let mut fails = 2;
        while fails <= MAX_WINDOW {
            match fits(fails) {
                Some(window) => best = (fails, window),
                None => break,
            }
            fails *= 2;
        }
        while best.0 + 1 < fails.min(MAX_WINDOW) {
            let middle = usize::midpoint(best.0, fails.min(MAX_WINDOW));
            match fits(middle) {
                Some(window) => best = (middle, window),
                None => fails = middle,
            }
        }
        Some(best.1)
    }
}

/// Three points of a run and the place among them of the tangent wanted.
struct Window {
    points: [Point3; 3],
    first: usize,
    count: usize,
    place: usize,
}

impl Window {
    fn tangent(&self) -> Option<Vec3> {
        estimate_tangents(&self.points, false).ok().map(|t| t[self.place])
    }

    fn fits(&self, run: &Run<'_>, tolerance: f64) -> bool {
        let [a, b, c] = self.points;
        let Ok(arc) = Arc::from_three_points(a, b, c) else { return false };
        (1..self.count).all(|i| arc.closest_point(run.at(self.first + i)).distance <= tolerance)
    }
}
