//! Points in a row that lie on a straight line within the rounding of their coordinates: a curve that begins at their end begins in
//! the direction of that line (`docs/math/arc-fitting.md#outlines`).

use super::decimals::decimal_step;
use crate::base::vector::Point3;
use crate::construct::curves::arc_fit::input::diameter;

/// So many edges in a straight line are a run; three points may be so by chance, where a curve turns from one side to the other.
const FEWEST: usize = 3;
const BY_CHANCE: usize = 2;
/// Points rounded to a step are off the line through two others by less than so many steps.
const STEPS: f64 = 1.5;
/// What is rounded to no step is off by less than this part of its size.
const EXACT: f64 = 1e-9;

/// The straight runs of a polyline.
#[derive(Default)]
pub(super) struct StraightRuns {
    inside: Vec<bool>,
    /// The edges of the longest run that ends at each point.
    edges: Vec<usize>,
    /// How far points may be off them.
    off: f64,
}

impl StraightRuns {
    pub fn off(&self) -> f64 {
        self.off
    }

    /// Of open points, or of closed ones from one of them on that is inside of none.
    pub fn of(points: &[Point3], closed_from: Option<usize>) -> Self {
        let n = points.len();
        let off = decimal_step(points).map_or(EXACT * diameter(points), |step| STEPS * step);
        let row: Vec<Point3> = match closed_from {
            Some(first) => (0..=n).map(|k| points[(first + k) % n]).collect(),
            None => points.to_vec(),
        };
        let number = |k: usize| (closed_from.unwrap_or(0) + k) % n;
        let mut found = Self { inside: vec![false; n], edges: vec![0; n], off };
        let mut from = 0;
        while from + 1 < row.len() {
            let to = from + longest(&row[from..], off);
            if to - from >= FEWEST {
                (from + 1..to).for_each(|k| found.inside[number(k)] = true);
            }
            for k in [from, to].map(number) {
                found.edges[k] = found.edges[k].max(to - from);
            }
            from = to;
        }
        found
    }

    /// Between the ends of one.
    pub fn is_inside(&self, vertex: usize) -> bool {
        self.inside[vertex]
    }

    pub fn ends_at(&self, vertex: usize) -> bool {
        self.edges[vertex] >= FEWEST
    }

    /// Also one of three points.
    pub fn may_end_at(&self, vertex: usize) -> bool {
        self.edges[vertex] >= BY_CHANCE
    }
}

/// How many edges from the first point on are in a straight line, at least one: by doubling, then by halving.
fn longest(row: &[Point3], off: f64) -> usize {
    let last = row.len() - 1;
    let is_straight = |count: usize| {
        let Some(along) = (row[count] - row[0]).unit() else { return false };
        let across = |p: &Point3| (*p - row[0]).cross(along).length();
        let ahead = row[..=count].windows(2).all(|w| (w[1] - w[0]).dot(along) > 0.0);
        ahead && row[1..count].iter().all(|p| across(p) <= off)
    };
    let (mut straight, mut bent) = (1, 2);
    while bent <= last && is_straight(bent) {
        straight = bent;
        bent = (2 * bent).min(last + usize::from(bent == last));
    }
    while bent - straight > 1 {
        let middle = straight + (bent - straight) / 2;
        *(if is_straight(middle) { &mut straight } else { &mut bent }) = middle;
    }
    straight
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rectangle of 60 x 40 with chamfers of 3, turned, a point every 3 or so, rounded to hundredths.
    fn chamfered() -> Vec<Point3> {
        let corners =
            [[3.0, 0.0], [57.0, 0.0], [60.0, 3.0], [60.0, 37.0], [57.0, 40.0], [3.0, 40.0], [0.0, 37.0], [0.0, 3.0]];
        let (sin, cos) = 0.3_f64.sin_cos();
        let round = |v: f64| (100.0 * v).round() / 100.0;
        let side = |i: usize| {
            let ([a, b], [c, d]) = (corners[i], corners[(i + 1) % 8]);
            let count = if i % 2 == 1 { 1 } else { 12 };
            (0..count).map(move |k| f64::from(k) / f64::from(count)).map(move |t| [a + (c - a) * t, b + (d - b) * t])
        };
        let turned = |[x, y]: [f64; 2]| Point3::new(round(x * cos - y * sin), round(x * sin + y * cos), 0.0);
        (0..8).flat_map(side).map(turned).collect()
    }

    #[test]
    fn sides_of_rounded_points_are_straight_and_arcs_are_not() {
        let points = chamfered();
        let runs = StraightRuns::of(&points, Some(0));
        assert_eq!(points.len(), 52);
        for i in 0..52 {
            let is_end = [0, 12].contains(&(i % 13));
            assert_eq!((runs.ends_at(i), runs.is_inside(i)), (is_end, !is_end), "{i}");
        }
        let circle: Vec<Point3> =
            (0..60).map(|k| 0.1 * f64::from(k)).map(|a| Point3::new(a.cos(), a.sin(), 0.0)).collect();
        let runs = StraightRuns::of(&circle, None);
        assert!((0..60).all(|i| !runs.ends_at(i) && !runs.is_inside(i)));
    }
}
