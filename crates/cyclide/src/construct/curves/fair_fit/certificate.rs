//! The proof sheet of a fair fit: bounds on the finished curve that share no code with the fit
//! (`docs/math/fair-fits.md#certificate`).
//!
//! *Points to curve.* The distance at a foot is a bound whether the foot is the nearest point or not, so the largest of
//! them at most the tolerance is the proof.
//!
//! *Both ways.* Where the feet advance with the points, the quartics are cut at feet and nodes. For a piece with
//! positive weights and control points `c_j`, and points `e_0 .. e_4` in order on the part of the edge it stands for,
//!
//! ```text
//! Fréchet distance of piece and part <= max |c_j - e_j|
//! ```
//! since the part with the same weights is a monotone way along it, and the difference is a convex combination of
//! the `c_j - e_j`. Pieces are halved until the bound is close to a distance that occurs. Where feet step back only the
//! distance from curve to polyline is bounded: that to one edge is convex, so no piece is farther than its control
//! points.

use crate::base::bernstein;
use crate::base::vector::{Point3, Vec3};
use crate::rational::RationalBezier;

/// Bounds are refined until they exceed a distance that occurs by less than this factor.
const CLOSE: f64 = 1.02;
/// Halvings of a piece at most: a bound that is not close by then is taken as it is.
const DEPTH: u32 = 20;
/// Edges tried on either side of those between two neighboring feet.
const EDGES_BESIDE: usize = 1;
/// Edges tried in all, where feet jump over many.
const MOST_EDGES: usize = 64;

type Row = [f64; 4];

/// What is proved about a smooth piece; points are counted in the piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PieceSheet {
    /// Largest distance of a point from the curve, and the point.
    pub vertex: (f64, usize),
    pub squares: f64,
    /// The largest distance that two points next to each other both have, and the first of them.
    pub beside: (f64, usize),
    /// Bound on the distance between curve and polyline.
    pub polyline: f64,
    /// The first point whose foot steps back, and their number.
    pub back: Option<(usize, usize)>,
    /// Sum of the squared fourth differences of the distances, as vectors, and their number: what is left of them is no
    /// smooth change.
    pub roughness: (f64, usize),
}

/// Certifies one piece: its quartics, its points in order and the positions `segment + parameter` of their feet.
pub(super) fn certify(curve: &[RationalBezier], closed: bool, points: &[Point3], feet: &[f64]) -> PieceSheet {
    let errors: Vec<Vec3> = points.iter().zip(feet).map(|(p, foot)| *p - at(curve, *foot)).collect();
    let roughness = roughness(&errors);
    let mut sheet =
        PieceSheet { vertex: (0.0, 0), squares: 0.0, beside: (0.0, 0), polyline: 0.0, back: None, roughness };
    for (i, error) in errors.iter().enumerate() {
        let distance = error.length();
        if distance > sheet.vertex.0 {
            sheet.vertex = (distance, i);
        }
        sheet.squares += distance * distance;
    }
    let both = errors.windows(2).map(|w| w[0].length().min(w[1].length()));
    sheet.beside = both.zip(0..).fold(sheet.beside, |most, next| if next.0 > most.0 { next } else { most });
    let m = curve.len() as f64;
    // Positions that start at the first foot and go on past the seam; open curves are matched end with end.
    let mut along: Vec<f64> = feet.iter().map(|f| if *f < feet[0] && closed { f + m } else { *f }).collect();
    if closed {
        along.push(feet[0] + m);
    } else {
        along[0] = 0.0;
        along[points.len() - 1] = m;
    }
    let backward = |i: &usize| along[i + 1] < along[*i];
    let mut steps_back = (0..along.len() - 1).filter(backward);
    sheet.back = steps_back.next().map(|i| ((i + 1) % points.len(), 1 + steps_back.count()));
    let mut bound = Bound { points, proved: sheet.vertex.0, met: sheet.vertex.0 };
    if sheet.back.is_none() {
        for i in 0..along.len() - 1 {
            bound.match_edge(curve, closed, [along[i], along[i + 1]], [points[i], points[(i + 1) % points.len()]]);
        }
    } else {
        bound.curve_to_polyline(curve, &along, closed);
    }
    sheet.polyline = bound.proved;
    sheet
}

/// Sum of the squared fourth differences, and their number.
fn roughness(errors: &[Vec3]) -> (f64, usize) {
    let fourth = |w: &[Vec3]| (w[0] + w[4] - (w[1] + w[3]) * 4.0 + w[2] * 6.0).length_squared();
    (errors.windows(5).map(fourth).sum(), errors.len().saturating_sub(4))
}

/// The point at a position.
pub(super) fn at(curve: &[RationalBezier], position: f64) -> Point3 {
    // A foot at the end of the last segment stays on it.
    let j = (position as usize).min(curve.len() - 1);
    curve[j].point(position - j as f64)
}

/// The rows of a part of a quartic.
fn part(curve: &RationalBezier, [a, b]: [f64; 2]) -> Vec<Row> {
    let after = if a > 0.0 { bernstein::split(curve.rows(), a).1 } else { curve.rows().to_vec() };
    if b < 1.0 { bernstein::split(&after, (b - a) / (1.0 - a)).0 } else { after }
}

/// A range of positions cut at the nodes: segments with parts of their parameter.
fn cut(m: usize, closed: bool, [from, to]: [f64; 2]) -> impl Iterator<Item = (usize, [f64; 2])> {
    let first = if closed { from as usize } else { (from as usize).min(m - 1) };
    let last = (to.ceil() as usize).max(first + 1);
    (first..last).map(move |j| (j % m, [(from - j as f64).max(0.0), (to - j as f64).min(1.0)]))
}

fn control_point(row: &Row) -> Option<Point3> {
    // A weight that is not positive: no hull. Halving helps.
    (row[3] > 0.0).then(|| Point3::new(row[0] / row[3], row[1] / row[3], row[2] / row[3]))
}

/// Where on an edge a point projects to, within bounds.
pub(super) fn projection([a, b]: [Point3; 2], p: Point3, [from, to]: [f64; 2]) -> f64 {
    let edge = b - a;
    let square = edge.length_squared();
    if square > 0.0 { ((p - a).dot(edge) / square).clamp(from, to) } else { from }
}

struct Bound<'a> {
    points: &'a [Point3],
    /// Largest bound of a piece so far.
    proved: f64,
    /// Largest distance met so far: the bound need not be closer to it.
    met: f64,
}

impl Bound<'_> {
    /// The curve between two feet against the edge between their points.
    fn match_edge(&mut self, curve: &[RationalBezier], closed: bool, feet: [f64; 2], edge: [Point3; 2]) {
        let mut from = 0.0;
        let parts: Vec<_> = cut(curve.len(), closed, feet).collect();
        for (k, (j, range)) in parts.iter().enumerate() {
            let rows = part(&curve[*j], *range);
            let to = match rows.last().and_then(control_point) {
                Some(end) if k + 1 < parts.len() => projection(edge, end, [from, 1.0]),
                _ => 1.0,
            };
            self.match_part(&rows, edge, [from, to], DEPTH);
            from = to;
        }
    }

    fn match_part(&mut self, rows: &[Row], edge: [Point3; 2], range: [f64; 2], depth: u32) {
        let bound = self.matched(rows, edge, range);
        if depth > 0 && bound.is_none_or(|b| b > CLOSE * self.met) {
            let (left, right) = bernstein::split(rows, 0.5);
            if let Some(middle) = right.first().and_then(control_point) {
                let cut = projection(edge, middle, range);
                self.match_part(&left, edge, [range[0], cut], depth - 1);
                self.match_part(&right, edge, [cut, range[1]], depth - 1);
                return;
            }
        }
        self.proved = self.proved.max(bound.unwrap_or(f64::INFINITY));
    }

    /// The largest `|c_j - e_j|` of a part of the curve and a part of an edge; `None` without a hull.
    fn matched(&mut self, rows: &[Row], edge: [Point3; 2], [from, to]: [f64; 2]) -> Option<f64> {
        let last = rows.len() - 1;
        let (mut s, mut bound) = (from, 0.0_f64);
        for (k, row) in rows.iter().enumerate() {
            let c = control_point(row)?;
            s = match k {
                0 => from,
                k if k == last => to,
                _ => projection(edge, c, [s, to]),
            };
            let distance = c.distance(edge[0].lerp(edge[1], s));
            if k == 0 || k == last {
                self.met = self.met.max(distance);
            }
            bound = bound.max(distance);
        }
        Some(bound)
    }

    /// Every part of the curve against the nearest edge round those of the feet beside it.
    fn curve_to_polyline(&mut self, curve: &[RationalBezier], along: &[f64], closed: bool) {
        let n = self.points.len();
        let mut feet: Vec<(f64, usize)> = along.iter().take(n).copied().zip(0..n).collect();
        feet.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let m = curve.len() as f64;
        let (first, last) = (feet[0], feet[n - 1]);
        if closed {
            feet.push((first.0 + m, first.1 + n));
        } else {
            feet.insert(0, (0.0, first.1));
            feet.push((m, last.1));
        }
        for w in feet.windows(2) {
            let (low, high) = (w[0].1.min(w[1].1), w[0].1.max(w[1].1));
            let edges = low + n - EDGES_BESIDE..high + n + 1 + EDGES_BESIDE;
            // Round the seam of a closed polyline both numbers count from the end.
            let edges: Vec<[Point3; 2]> = edges
                .take(MOST_EDGES)
                .filter(|i| closed || (n..2 * n - 1).contains(i))
                .map(|i| [self.points[i % n], self.points[(i + 1) % n]])
                .collect();
            for (j, range) in cut(curve.len(), closed, [w[0].0, w[1].0]) {
                self.nearest_edge(&part(&curve[j], range), &edges, DEPTH);
            }
        }
    }

    fn nearest_edge(&mut self, rows: &[Row], edges: &[[Point3; 2]], depth: u32) {
        let distance =
            |c: Point3, edge: &[Point3; 2]| c.distance(edge[0].lerp(edge[1], projection(*edge, c, [0.0, 1.0])));
        let hull: Option<Vec<Point3>> = rows.iter().map(control_point).collect();
        let bound = hull.as_ref().map_or(f64::INFINITY, |hull| {
            let farthest = |edge: &[Point3; 2]| hull.iter().map(|c| distance(*c, edge)).fold(0.0, f64::max);
            edges.iter().map(farthest).fold(f64::INFINITY, f64::min)
        });
        for end in [rows.first(), rows.last()].into_iter().flatten().filter_map(control_point) {
            let nearest = edges.iter().map(|edge| distance(end, edge)).fold(f64::INFINITY, f64::min);
            self.met = self.met.max(nearest);
        }
        if depth > 0 && bound > CLOSE * self.met {
            let (left, right) = bernstein::split(rows, 0.5);
            self.nearest_edge(&left, edges, depth - 1);
            self.nearest_edge(&right, edges, depth - 1);
        } else {
            self.proved = self.proved.max(bound);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A parabola from (0, 0) to (2, 0) with its top at (1, h).
    fn parabola(h: f64) -> RationalBezier {
        let row = |x: f64, y: f64| [x, y, 0.0, 1.0];
        RationalBezier::new(vec![row(0.0, 0.0), row(1.0, 2.0 * h), row(2.0, 0.0)]).unwrap()
    }

    fn points(xy: &[[f64; 2]]) -> Vec<Point3> {
        xy.iter().map(|[x, y]| Point3::new(*x, *y, 0.0)).collect()
    }

    #[test]
    fn both_bounds_are_close_above_the_distances() {
        // Over one edge the parabola's top is the farthest point, h away, and no vertex is off.
        let sheet = certify(&[parabola(0.5)], false, &points(&[[0.0, 0.0], [2.0, 0.0]]), &[0.0, 1.0]);
        assert!(sheet.vertex.0 < 1e-15 && sheet.back.is_none());
        assert!(sheet.polyline >= 0.5 && sheet.polyline <= 0.5 * CLOSE * 1.01, "{}", sheet.polyline);
        // Its own top as a vertex: the largest distance of the two halves from their edges (slope 1/2) is h/4 at the
        // middle of each, across the edge.
        let sheet = certify(&[parabola(0.5)], false, &points(&[[0.0, 0.0], [1.0, 0.5], [2.0, 0.0]]), &[0.0, 0.5, 1.0]);
        let least = 0.125 / 1.25_f64.sqrt();
        assert!(sheet.polyline >= least && sheet.polyline <= 1.05 * least, "{} {least}", sheet.polyline);
    }

    #[test]
    fn a_step_back_leaves_the_bound_from_curve_to_polyline() {
        let data = points(&[[0.0, 0.0], [1.2, 0.1], [0.8, 0.1], [2.0, 0.0]]);
        let sheet = certify(&[parabola(0.0)], false, &data, &[0.0, 0.6, 0.4, 1.0]);
        assert_eq!(sheet.back, Some((2, 1)));
        assert!(sheet.vertex.0 > 0.099 && sheet.vertex.0 < 0.101);
        // The line is nowhere farther than 0.1 from the polyline.
        assert!(sheet.polyline >= 0.0999 && sheet.polyline < 0.1025, "{}", sheet.polyline);
    }

    #[test]
    fn a_curve_that_runs_back_over_its_polyline_is_not_called_near() {
        // From (0,0) out to (2, 0) and back to (0, 0) over two edges that stay near the start: Hausdorff 1.8.
        let out = parabola(0.0);
        let back = RationalBezier::new(out.rows().iter().rev().copied().collect()).unwrap();
        let sheet = certify(&[out, back], false, &points(&[[0.0, 0.0], [0.2, 0.0], [0.0, 0.0]]), &[0.0, 0.1, 2.0]);
        assert!(sheet.polyline >= 1.8, "{}", sheet.polyline);
    }
}
