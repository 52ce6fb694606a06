//! B-spline surfaces of documents, sampled to meshes.
//!
//! A surface is a curve of curves: the rows of control points are made Bézier curves, span by span, and so are the columns of what comes
//! out. What is left are rational Bézier patches, which are sampled.

use std::f64::consts::FRAC_PI_8;

use cyclide::{
    Error as KernelError, Point3, Vec3,
    error::PointError,
    rational::{NurbsCurve, RationalBezierSurface},
};

use crate::document::kinds::nurbs::knots_words;
use crate::document::kinds::principal_grid::surface_sources::NurbsSurfaceSpec;
use crate::document::kinds::smooth_mesh::Given;
use crate::document::locate::Step;
use crate::document::objects::Builder;
use crate::error::{Error, Result};
use crate::input::polygon_mesh::PolygonMesh;

/// Most vertices of a mesh over a surface.
const MOST_VERTICES: f64 = 500_000.0;

/// Fewest edges along a span.
const FEWEST: f64 = 4.0;

/// Largest turn from one edge to the next.
const MOST_TURN: f64 = FRAC_PI_8;

/// Lines that are measured, about.
const MEASURED_LINES: usize = 512;

/// Edges along the lines that are measured, as a part of those of the grid: a little less than half, for what lies between these lines.
const EDGE: f64 = 0.475;

/// Borders this near to each other, as a part of the size of the surface, are one: what programs write has some ten digits.
const ROUNDING: f64 = 1e-9;

/// The borders, in the words of messages.
const BORDERS: [[&str; 2]; 2] = [
    ["where the rows of control points begin", "where the rows of control points end"],
    ["of the first row of control points", "of the last row of control points"],
];

/// A surface as patches, one for each knot span, those along the rows first.
struct Patches {
    spans: [usize; 2],
    patches: Vec<RationalBezierSurface>,
}

impl Patches {
    /// The point at a place that counts spans.
    fn point(&self, place: [f64; 2]) -> Point3 {
        let span = |d: usize| (place[d] as usize).min(self.spans[d] - 1);
        let (a, b) = (span(0), span(1));
        self.patches[b * self.spans[0] + a].point(place[0] - a as f64, place[1] - b as f64)
    }

    /// How many edges the steps of each span take: none longer than `edge`, none that turns too far from the one before, and so many
    /// in all.
    fn demands(&self, direction: usize, edge: f64) -> Vec<Vec<f64>> {
        let degree = |d: usize| self.patches.first().map_or(1, |patch| patch.degrees()[d]);
        let steps = 4 * degree(direction).max(4);
        // Of many spans, between which little happens, two lines each are enough.
        let beside = (2 * degree(1 - direction)).min((MEASURED_LINES / self.spans[1 - direction]).max(2));
        let lines = (0..=beside * self.spans[1 - direction]).map(|k| k as f64 / beside as f64);
        let lines: Vec<f64> = lines.collect();
        let demands = (0..self.spans[direction]).map(|span| {
            let mut demand = vec![FEWEST / steps as f64; steps];
            for &line in &lines {
                let place = |k: usize| span as f64 + k as f64 / steps as f64;
                let point = |k: usize| self.point(if direction == 0 { [place(k), line] } else { [line, place(k)] });
                let points: Vec<Point3> = (0..=steps).map(point).collect();
                let chords: Vec<Vec3> = points.windows(2).map(|pair| pair[1] - pair[0]).collect();
                for (k, chord) in chords.iter().enumerate() {
                    let turn = k.checked_sub(1).map_or(0.0, |before| chords[before].angle(*chord));
                    demand[k] = demand[k].max(chord.length() / edge).max(turn / MOST_TURN);
                }
            }
            demand
        });
        demands.collect()
    }
}

impl Builder<'_> {
    /// The mesh over a B-spline surface, for a grid with edges of this length.
    pub(in crate::document) fn mesh_of_nurbs(&self, spec: &NurbsSurfaceSpec, edge_length: f64) -> Result<Given> {
        let surface = self.patches(spec)?;
        // What is no length is refused by the kernel.
        let edge = if edge_length > 0.0 { EDGE * edge_length } else { f64::INFINITY };
        let fewest = FEWEST * FEWEST * surface.patches.len() as f64;
        let demands = if fewest > MOST_VERTICES { [vec![], vec![]] } else { [0, 1].map(|d| surface.demands(d, edge)) };
        let counts = demands.each_ref().map(|spans| 1.0 + spans.iter().map(|demand| edges_of(demand)).sum::<f64>());
        let count = fewest.max(counts[0] * counts[1]);
        if !(count <= MOST_VERTICES) {
            let words = format!(
                "a mesh of the surface with edges half as long, and at least {FEWEST} along each knot span, requires {count:.0} vertices; the limit is {MOST_VERTICES}: use longer edges, or a part of the surface"
            );
            let place = if fewest > MOST_VERTICES { ["nurbs".into()] } else { ["edge_length".into()] };
            return Err(self.refused_in_words(place, "too-many-pieces", words));
        }
        let places = demands.each_ref().map(|spans| places(spans));
        let lines: Vec<Vec<Point3>> =
            places[1].iter().map(|&t| places[0].iter().map(|&s| surface.point([s, t])).collect()).collect();
        let size = lines.iter().flatten().map(|p| p.distance(lines[0][0])).fold(0.0, f64::max);
        let mesh = mesh_over(&lines, ROUNDING * size).map_err(|[direction, end]| {
            let words = format!(
                "the border {} is a single point, a pole, where lines of curvature are singular: split the surface near the pole and remove the part that contains it",
                BORDERS[direction][end]
            );
            self.refused_in_words(["nurbs".into(), "control_points".into()], "collapsed-side", words)
        })?;
        Ok(Given { mesh, file: None, field: "nurbs", shared: false, lists_normals: false })
    }

    fn patches(&self, spec: &NurbsSurfaceSpec) -> Result<Patches> {
        let place = |field: &str, row: Option<usize>| {
            [Step::from("nurbs"), field.into()].into_iter().chain(row.map(Step::from)).collect::<Vec<_>>()
        };
        let [along, across] = spec.degrees.map(|degree| degree as usize);
        let columns = spec.control_points.first().map_or(0, Vec::len);
        let uneven = |field: &str, row: usize, count: usize| {
            let words = format!("the row has {count} entries, the first row of control points has {columns}");
            self.refused_in_words(place(field, Some(row)), "count-differs", words)
        };
        if let Some((j, row)) = spec.control_points.iter().enumerate().find(|(_, row)| row.len() != columns) {
            return Err(uneven("control_points", j, row.len()));
        }
        if let Some(weights) = &spec.weights {
            let (given, needed) = (weights.len(), spec.control_points.len());
            if given != needed {
                let words = format!("{given} rows of weights for {needed} rows of control points");
                return Err(self.refused_in_words(place("weights", None), "count-differs", words));
            }
            if let Some((j, row)) = weights.iter().enumerate().find(|(_, row)| row.len() != columns) {
                return Err(uneven("weights", j, row.len()));
            }
        }
        let mut rows = Vec::with_capacity(spec.control_points.len());
        for (j, points) in spec.control_points.iter().enumerate() {
            let weights = spec.weights.as_ref().map_or_else(|| vec![1.0; columns], |weights| weights[j].clone());
            let points = points.iter().map(|p| p.point()).collect();
            let curve = NurbsCurve::clamped(along, spec.knots[0].clone(), points, weights);
            rows.push(bezier_rows(&curve.map_err(|e| self.refused_spline(0, j, &e))?));
        }
        let Some(count) = rows.first().map(Vec::len) else {
            let error = KernelError::Point(PointError::TooFewPoints { given: 0, needed: across + 1 });
            return Err(self.refused_at(place("control_points", None), &error));
        };
        let mut lines = Vec::with_capacity(count);
        for k in 0..count {
            let column = rows.iter().map(|row| row[k]);
            let (points, weights) = column.map(|[x, y, z, w]| (Point3::new(x / w, y / w, z / w), w)).unzip();
            let curve = NurbsCurve::clamped(across, spec.knots[1].clone(), points, weights);
            lines.push(bezier_rows(&curve.map_err(|e| self.refused_spline(1, 0, &e))?));
        }
        let spans = [count / (along + 1), lines[0].len() / (across + 1)];
        let patch = |k: usize| {
            let (a, b) = (k % spans[0] * (along + 1), k / spans[0] * (across + 1));
            let rows = lines[a..=a + along].iter().flat_map(|line| line[b..=b + across].iter().copied()).collect();
            RationalBezierSurface::new([along, across], rows)
        };
        let patches = (0..spans[0] * spans[1]).map(patch).collect::<cyclide::Result<_>>();
        Ok(Patches { spans, patches: patches.map_err(|e| self.refused_spline(1, 0, &e))? })
    }

    /// The message for what the kernel said of a row of control points, or of what goes from row to row.
    fn refused_spline(&self, direction: usize, row: usize, error: &KernelError) -> Error {
        let mut steps: Vec<Step> = vec!["nurbs".into()];
        let path = error.path();
        match (path.field, direction) {
            (Some("degree"), d) => steps.extend(["degrees".into(), d.into()]),
            (Some("knots"), d) => steps.extend(["knots".into(), d.into()]),
            (Some(field), 0) => steps.extend([field.into(), row.into()]),
            _ => steps.push("control_points".into()),
        }
        if path.field.is_some_and(|field| field == "knots" || direction == 0) {
            steps.extend(path.index.map(Step::from));
        }
        match knots_words(error) {
            Some(words) if !self.document.text.is_empty() => self.refused_in_words(steps, error.reason(), words),
            _ => self.refused_at(steps, error),
        }
    }
}

/// Homogeneous rows of the spans of a curve, one span after the other.
fn bezier_rows(curve: &NurbsCurve) -> Vec<[f64; 4]> {
    curve.to_beziers().iter().flat_map(|span| span.rows().to_vec()).collect()
}

/// How many edges a span has.
fn edges_of(demand: &[f64]) -> f64 {
    // What is a whole number but for rounding is that.
    (demand.iter().sum::<f64>() - 1e-9).ceil()
}

/// The places of the vertices, evenly by what the steps take.
fn places(spans: &[Vec<f64>]) -> Vec<f64> {
    let mut places = vec![0.0];
    for (span, demand) in spans.iter().enumerate() {
        let count = edges_of(demand);
        let scale = count / demand.iter().sum::<f64>();
        let (mut done, mut next) = (0.0, 1.0);
        for (k, part) in demand.iter().map(|part| part * scale).enumerate() {
            while next < count - 0.5 && next <= done + part {
                places.push(span as f64 + (k as f64 + (next - done) / part) / demand.len() as f64);
                next += 1.0;
            }
            done += part;
        }
        places.push(span as f64 + 1.0);
    }
    places
}

/// Quads between lines of points; lines that close, and the first and the last one where they are the same, share vertices.
///
/// # Errors
/// A border that is one point: its direction and its end.
fn mesh_over(lines: &[Vec<Point3>], rounding: f64) -> std::result::Result<PolygonMesh, [usize; 2]> {
    let counts = [lines[0].len(), lines.len()];
    let at = |i: usize, j: usize| lines[j][i];
    let border = |direction: usize, end: usize| -> Vec<Point3> {
        let k = end * (counts[direction] - 1);
        (0..counts[1 - direction]).map(|other| if direction == 0 { at(k, other) } else { at(other, k) }).collect()
    };
    let mut closed = [false; 2];
    for direction in [0, 1] {
        let ends = [0, 1].map(|end| border(direction, end));
        if let Some(end) = ends.iter().position(|points| points.iter().all(|p| p.distance(points[0]) <= rounding)) {
            return Err([direction, end]);
        }
        closed[direction] = ends[0].iter().zip(&ends[1]).all(|(p, q)| p.distance(*q) <= rounding);
    }
    let [columns, rows] = [0, 1].map(|d| counts[d] - usize::from(closed[d]));
    let number = |i: usize, j: usize| j % rows * columns + i % columns;
    let cells = (1..counts[1]).flat_map(|j| (1..counts[0]).map(move |i| (i, j)));
    let quad = |(i, j)| vec![number(i - 1, j - 1), number(i, j - 1), number(i, j), number(i - 1, j)];
    let points = (0..rows * columns).map(|k| at(k % columns, k / columns)).collect();
    Ok(PolygonMesh { points, faces: cells.map(quad).collect(), ..PolygonMesh::default() })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A saddle whose parameter runs ten times as fast at one end, and a bend in the middle of a span.
    #[test]
    fn edges_are_short_and_even_however_the_parameter_runs() {
        let rows = |x: [f64; 3]| x.map(|x| [[x, 0.0, 0.0, 1.0], [x, 1.0, x, 1.0]]).concat();
        let patch = RationalBezierSurface::new([2, 1], rows([0.0, 0.5, 9.0])).unwrap();
        let surface = Patches { spans: [1, 1], patches: vec![patch] };
        let along = places(&surface.demands(0, 0.5));
        for t in [0.0, 0.3, 1.0] {
            let points: Vec<Point3> = along.iter().map(|s| surface.point([*s, t])).collect();
            let edges: Vec<f64> = points.windows(2).map(|pair| pair[0].distance(pair[1])).collect();
            let (least, most) = edges.iter().fold((f64::MAX, 0.0_f64), |(a, b), e| (a.min(*e), b.max(*e)));
            // Steps of a sixteenth of a span are taken as straight.
            assert!(most < 0.5 * 1.05 && least > 0.2, "{least} {most}");
        }
        assert_eq!(places(&surface.demands(1, 1e9)).len(), 5);
        let bend = [[0.0, 0.0], [4.0, 0.0], [4.0, 0.0], [4.0, 0.0], [4.0, 4.0]];
        let rows = bend.map(|[x, z]| [[x, 0.0, z, 1.0], [x, 1.0, z, 1.0]]).concat();
        let patch = RationalBezierSurface::new([4, 1], rows).unwrap();
        let surface = Patches { spans: [1, 1], patches: vec![patch] };
        // A right angle is four turns.
        assert!(places(&surface.demands(0, 1e9)).len() > 5);
    }

    #[test]
    fn borders_that_coincide_share_vertices_and_poles_are_found() {
        let ring = |turn: f64, r: f64, z: f64| Point3::new(r * turn.cos(), r * turn.sin(), z);
        let line = |r: f64, z: f64| (0..=8).map(|k| ring(f64::from(k) * 2.0 * FRAC_PI_8, r, z)).collect::<Vec<_>>();
        let tube = mesh_over(&[line(1.0, 0.0), line(2.0, 1.0), line(1.0, 2.0)], 1e-9).unwrap();
        assert_eq!((tube.points.len(), tube.faces.len()), (24, 16));
        assert!(tube.faces.iter().flatten().all(|v| *v < 24));
        assert_eq!(mesh_over(&[line(1.0, 0.0), line(0.0, 1.0)], 1e-9), Err([1, 1]));
    }
}
