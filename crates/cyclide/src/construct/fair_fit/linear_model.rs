//! The curve to first order in the displacements of its nodes: distances of the data and variation of curvature
//! (`docs/math/fair-fits.md#linear-model`).
//!
//! ```text
//! distance   r_i(y) = Q_i^T (p_i - x_i) - Q_i^T D(s_i)                                   (2)
//! variation  dV = P D''' + k² P D' - 3 (t.D'' + K.D') K - 3 (t.D') V                      (3), in the middle of a segment
//! ```
//! `D = sum_k L_k N_k y_k` with the functions of [`spline_basis`](super::spline_basis) and `R` normal directions at
//! each node: 1 in the plane, 2 in space. A row has `N = 4 R` columns: those of the four nodes round a segment.

use super::feet::Foot;
use super::spline_basis::{Cubic, functions, value};
use super::tube_curve::TubeCurve;
use crate::base::vector::Vec3;

/// One datum: its distance from the curve across it is `at_rest - columns y`, in units of the tube's radius.
#[derive(Debug, Clone, Copy)]
pub(super) struct DistanceRow<const R: usize, const N: usize> {
    pub columns: [[f64; N]; R],
    pub at_rest: [f64; R],
    /// Square of the distance along the curve, which no displacement changes: not 0 beyond an open end.
    pub along: f64,
}

/// One segment: its share of `J` is the square of `at_rest + columns y`.
#[derive(Debug, Clone, Copy)]
pub(super) struct VariationRow<const R: usize, const N: usize> {
    pub columns: [[f64; N]; R],
    pub at_rest: [f64; R],
}

/// The linear model of a curve over its data; lengths in units of `unit`.
pub(super) struct LinearModel<const R: usize, const N: usize> {
    pub closed: bool,
    pub nodes: usize,
    pub unit: f64,
    pub functions: Vec<[Cubic; 4]>,
    /// Normal directions at the nodes; zero where a node is fixed.
    pub normals: Vec<[Vec3; R]>,
    /// The data that may bind, ordered by the segment of their foot: those of segment `j` are `first[j]..first[j + 1]`.
    pub first: Vec<usize>,
    pub rows: Vec<DistanceRow<R, N>>,
    /// Index of the datum of each row.
    pub datum: Vec<usize>,
    /// Per segment; `None` where the variation of the curve is 0 for good (the arcs at open ends).
    pub variation: Vec<Option<VariationRow<R, N>>>,
}

/// `R` unit vectors perpendicular to a unit vector and each other; in the plane the left normal.
pub(super) fn normals<const R: usize>(tangent: Vec3) -> [Vec3; R] {
    let first = if R == 1 { Vec3::new(-tangent.y, tangent.x, 0.0) } else { tangent.any_perpendicular() };
    std::array::from_fn(|a| if a == 0 { first } else { tangent.cross(first) })
}

impl<const R: usize, const N: usize> LinearModel<R, N> {
    pub fn new(curve: &TubeCurve, feet: &[Foot], fixed: [bool; 2], unit: f64) -> Self {
        let nodes = curve.nodes.len();
        let chords: Vec<f64> = curve.segments.iter().map(|s| s.chord).collect();
        let functions = functions(&chords, curve.closed);
        let mut directions: Vec<[Vec3; R]> = curve.tangents.iter().map(|t| normals(*t)).collect();
        for (end, node) in [(fixed[0], 0), (fixed[1], nodes - 1)] {
            if end && !curve.closed {
                directions[node] = [Vec3::ZERO; R];
            }
        }
        let (first, datum) = binding(feet, by_segment(feet, chords.len()));
        let mut model = Self {
            closed: curve.closed,
            nodes,
            unit,
            functions,
            normals: directions,
            first,
            rows: Vec::new(),
            variation: Vec::with_capacity(chords.len()),
            datum,
        };
        model.rows = model.datum.iter().map(|i| model.distance_row(&feet[*i])).collect();
        for j in 0..chords.len() {
            let row = model.variation_row(curve, j);
            model.variation.push(row);
        }
        model
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        R * self.nodes
    }

    /// The node of slot `slot` of a segment; `None` beyond open ends.
    pub fn node(&self, segment: usize, slot: usize) -> Option<usize> {
        let k = segment + slot;
        if self.closed { Some((k + self.nodes - 1) % self.nodes) } else { k.checked_sub(1).filter(|k| *k < self.nodes) }
    }

    /// The first unknown of each slot of a segment.
    pub fn unknowns_of(&self, segment: usize) -> [Option<usize>; 4] {
        std::array::from_fn(|slot| self.node(segment, slot).map(|k| k * R))
    }

    /// The normal direction that stands for a column of a segment's rows.
    fn direction(&self, segment: usize, column: usize) -> Vec3 {
        self.node(segment, column / R).map_or(Vec3::ZERO, |k| self.normals[k][column % R])
    }

    pub fn distance_row(&self, foot: &Foot) -> DistanceRow<R, N> {
        let (j, u) = (foot.place.segment, foot.place.u);
        let across: [Vec3; R] = normals(foot.tangent);
        let values: [f64; 4] = self.functions[j].each_ref().map(|f| value(f, u));
        let mut columns = [[0.0; N]; R];
        for c in 0..N {
            let moved = self.direction(j, c) * values[c / R];
            for (row, q) in columns.iter_mut().zip(across) {
                row[c] = q.dot(moved);
            }
        }
        let along = foot.error.dot(foot.tangent) / self.unit;
        DistanceRow { columns, at_rest: across.map(|q| q.dot(foot.error) / self.unit), along: along * along }
    }

    fn variation_row(&self, curve: &TubeCurve, j: usize) -> Option<VariationRow<R, N>> {
        let end = j == 0 || j + 1 == curve.segments.len();
        if end && !curve.closed {
            return None;
        }
        let segment = &curve.segments[j];
        let h = segment.chord;
        let tangent = segment.point(0.5).d1.unit()?;
        let across: [Vec3; R] = normals(tangent);
        let flat = |v: Vec3| v - tangent * v.dot(tangent);
        let k = flat((segment.curvature[0] + segment.curvature[1]) * 0.5);
        // The size of V is the same at both ends; between them its direction turns.
        let size = segment.variation[0].length();
        let v = flat(segment.variation[0] + segment.variation[1]).unit().unwrap_or(Vec3::ZERO) * size;
        let weight = h.sqrt();
        let mut columns = [[0.0; N]; R];
        for c in 0..N {
            let f = &self.functions[j][c / R];
            let n = self.direction(j, c) * self.unit;
            let d1 = n * ((f[1] + f[2] + 0.75 * f[3]) / h);
            let d2 = n * ((2.0 * f[2] + 3.0 * f[3]) / (h * h));
            let d3 = n * (6.0 * f[3] / (h * h * h));
            let dv =
                d3 + d1 * k.length_squared() - k * (3.0 * (tangent.dot(d2) + k.dot(d1))) - v * (3.0 * tangent.dot(d1));
            for (row, b) in columns.iter_mut().zip(across) {
                row[c] = b.dot(dv) * weight;
            }
        }
        Some(VariationRow { columns, at_rest: across.map(|b| b.dot(v) * weight) })
    }

    /// Where the nodes go by displacements `y`.
    pub fn displacements(&self, y: &[f64]) -> Vec<Vec3> {
        let last = self.functions.len() - 1;
        let at = |node: usize| {
            let (segment, u) = if node > last { (last, 1.0) } else { (node, 0.0) };
            let moved = (0..N).map(|c| {
                let Some(k) = self.node(segment, c / R) else { return Vec3::ZERO };
                self.normals[k][c % R] * (value(&self.functions[segment][c / R], u) * y[k * R + c % R])
            });
            moved.fold(Vec3::ZERO, |sum, d| sum + d) * self.unit
        };
        (0..self.nodes).map(at).collect()
    }
}

/// More data than this over a segment: only those that stand out can bind.
const CROWDED: usize = 128;
/// Parts of a crowded segment; in each the data farthest out to six sides are kept.
const BINS: usize = 32;

/// Without the data of crowded segments that stand behind others: a displacement of the curve moves all data of a short
/// part of a segment alike, so those in the middle reach no bound before those outside do.
fn binding(feet: &[Foot], (first, datum): (Vec<usize>, Vec<usize>)) -> (Vec<usize>, Vec<usize>) {
    if first.windows(2).all(|w| w[1] - w[0] <= CROWDED) {
        return (first, datum);
    }
    let (mut starts, mut kept) = (vec![0], Vec::new());
    for data in first.windows(2).map(|w| &datum[w[0]..w[1]]) {
        if data.len() <= CROWDED {
            kept.extend(data);
        } else {
            let mut farthest = [[(f64::NEG_INFINITY, 0); 6]; BINS];
            for i in data {
                let (e, u) = (feet[*i].error, feet[*i].place.u);
                let bin = ((u * BINS as f64) as usize).min(BINS - 1);
                for (out, far) in [e.x, -e.x, e.y, -e.y, e.z, -e.z].into_iter().zip(&mut farthest[bin]) {
                    if out > far.0 {
                        *far = (out, *i);
                    }
                }
            }
            let mut chosen: Vec<usize> =
                farthest.iter().flatten().filter(|far| far.0.is_finite()).map(|far| far.1).collect();
            chosen.sort_unstable();
            chosen.dedup();
            kept.extend(chosen);
        }
        starts.push(kept.len());
    }
    (starts, kept)
}

/// The data in the order of the segments of their feet.
pub(super) fn by_segment(feet: &[Foot], segments: usize) -> (Vec<usize>, Vec<usize>) {
    let mut first = vec![0; segments + 1];
    for f in feet {
        first[f.place.segment + 1] += 1;
    }
    for j in 0..segments {
        first[j + 1] += first[j];
    }
    let mut next = first.clone();
    let mut datum = vec![0; feet.len()];
    for (i, f) in feet.iter().enumerate() {
        datum[next[f.place.segment]] = i;
        next[f.place.segment] += 1;
    }
    (first, datum)
}

#[cfg(test)]
mod tests {
    use super::super::feet::{COLD, Place};
    use super::*;
    use crate::base::vector::Point3;

    /// A closed wavy curve through many nodes, data beside it.
    fn wavy(nodes: usize) -> (TubeCurve, Vec<Point3>) {
        let at = |a: f64, r: f64| Point3::new(r * a.cos(), 1.3 * r * a.sin(), 0.0);
        let radius = |a: f64| 10.0 + (3.0 * a).cos() + 0.4 * (5.0 * a).sin();
        let turn = |i: usize, n: usize| std::f64::consts::TAU * i as f64 / n as f64;
        let ring = (0..nodes).map(|i| at(turn(i, nodes), radius(turn(i, nodes)))).collect();
        let data = (0..97).map(|i| at(turn(i, 97), radius(turn(i, 97)) + 0.05 * (i as f64 * 2.3).sin())).collect();
        (TubeCurve::new(ring, true, None).unwrap(), data)
    }

    fn feet(curve: &TubeCurve, data: &[Point3]) -> Vec<Foot> {
        let m = curve.segments.len() as f64;
        let place = |i: usize| {
            let position = m * i as f64 / data.len() as f64;
            Place { segment: position as usize, u: position.fract() }
        };
        curve.feet(data, (0..data.len()).map(place), COLD)
    }

    #[test]
    fn distances_and_variation_change_as_the_exact_spline_does() {
        const NODES: usize = 240;
        let (curve, data) = wavy(NODES);
        let at_rest = feet(&curve, &data);
        let model = LinearModel::<1, 4>::new(&curve, &at_rest, [false; 2], 1.0);
        // A displacement with three waves, small enough for first order.
        let small = 1e-5;
        let y: Vec<f64> =
            (0..NODES).map(|i| small * (std::f64::consts::TAU * 3.0 * i as f64 / NODES as f64).sin()).collect();
        let moves = model.displacements(&y);
        let nodes = curve.nodes.iter().zip(&moves).map(|(x, v)| *x + *v).collect();
        let moved = TubeCurve::new(nodes, true, Some(&curve.tangents)).unwrap();
        let after = feet(&moved, &data);
        let product = |columns: &[f64; 4], j: usize| -> f64 {
            columns.iter().zip(model.unknowns_of(j)).map(|(c, k)| k.map_or(0.0, |k| c * y[k])).sum()
        };
        for j in 0..NODES {
            for i in model.first[j]..model.first[j + 1] {
                let (row, datum) = (&model.rows[i], model.datum[i]);
                let left = Vec3::new(-after[datum].tangent.y, after[datum].tangent.x, 0.0);
                let change = left.dot(after[datum].error) - row.at_rest[0];
                // The spline as a cubic: chords of 0.3 with curvature up to 0.3, so (0.1)² of the displacement.
                let model = -product(&row.columns[0], j);
                assert!((change - model).abs() < 0.02 * small, "datum {datum}: {change} {model}");
            }
        }
        let largest = model.variation.iter().flatten().zip(0..).map(|(r, j)| product(&r.columns[0], j).abs());
        let largest = largest.fold(0.0, f64::max);
        for (j, row) in model.variation.iter().enumerate() {
            let row = row.unwrap();
            let signed = |c: &TubeCurve| {
                let s = &c.segments[j];
                let t = s.point(0.0).d1.unit().unwrap();
                s.variation[0].dot(Vec3::new(-t.y, t.x, 0.0)) * curve.segments[j].chord.sqrt()
            };
            let change = signed(&moved) - signed(&curve);
            // The same of its third derivative, which is largest where the curvature is: 5 % with half the nodes, so
            // a quarter of that here.
            let model = product(&row.columns[0], j);
            assert!((change - model).abs() < 0.02 * largest, "segment {j}: {change} {model} of {largest}");
        }
    }

    #[test]
    fn a_circle_that_grows_keeps_no_variation() {
        // D = y n gives y''' + k² y' + 3 k k' y = 0 for constant y on a circle.
        let at = |i: usize| {
            let a = std::f64::consts::TAU * i as f64 / 40.0;
            Point3::new(5.0 * a.cos(), 5.0 * a.sin(), 0.0)
        };
        let curve = TubeCurve::new((0..40).map(at).collect(), true, None).unwrap();
        let model = LinearModel::<1, 4>::new(&curve, &feet(&curve, &[at(1), at(7)]), [false; 2], 1.0);
        for (j, row) in model.variation.iter().enumerate() {
            let sum: f64 = row.unwrap().columns[0].iter().sum();
            let largest = row.unwrap().columns[0].iter().fold(0.0, |m: f64, c| m.max(c.abs()));
            // Exact for equal spacing up to the difference of chord and arc, 1e-3 here.
            assert!(sum.abs() < 1e-3 * largest, "segment {j}: {sum} {largest}");
        }
    }
}
