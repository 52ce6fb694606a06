//! Sewing of surfaces that go round an axis or along a pair of curves: rings of edges, and bands of faces between them.

use super::planar_area::Cover;
use super::turned_patch::turned_patch;
use crate::base::vector::Point3;
use crate::curve::Arc;
use crate::error::{ErrorItem, Result, ShellError};
use crate::rational::{PolynomialRow, RationalBezierSurface};
use crate::topology::{Body, EdgeCurve, FaceEdge, FaceSurface, Sewing};

/// Vertices of neighboring rings nearer to each other than this part of the coordinates are one.
const SAME_POINT: f64 = 1e-12;

/// Rings and bands on their way to a shell.
#[derive(Debug, Default)]
pub(super) struct Bands {
    sewing: Sewing,
}

/// Edges one behind the other, or one point in place of them all.
#[derive(Debug, Clone)]
pub(super) struct Ring {
    /// The start of each edge, and the end of the last one if the ring is open.
    vertices: Vec<usize>,
    edges: Vec<Option<usize>>,
}

impl Ring {
    /// The same closed ring from the vertex with this number on.
    pub(super) fn turned(&self, by: usize) -> Self {
        let mut ring = self.clone();
        ring.vertices.rotate_left(by);
        ring.edges.rotate_left(by);
        ring
    }
}

impl Bands {
    /// Adds the edges along curves that follow each other, `closed` if the last one ends where the first begins. Ends
    /// become the start of the next one bit for bit.
    pub(super) fn ring(&mut self, curves: Vec<EdgeCurve>, closed: bool) -> Ring {
        let end = curves.last().filter(|_| !closed).map(EdgeCurve::end);
        let vertices = curves.iter().map(EdgeCurve::start).chain(end).map(|p| self.sewing.vertex(p)).collect();
        self.ring_through(vertices, curves)
    }

    /// As [`ring`](Self::ring) beside another one of as many edges, with which it shares the vertices where both meet.
    pub(super) fn ring_beside(&mut self, curves: Vec<EdgeCurve>, closed: bool, other: &Ring) -> Ring {
        let end = curves.last().filter(|_| !closed).map(EdgeCurve::end);
        let points: Vec<Point3> = curves.iter().map(EdgeCurve::start).chain(end).collect();
        let size = points.iter().map(|p| p.to_vec().max_abs()).fold(0.0, f64::max);
        let vertices = points.into_iter().zip(&other.vertices).map(|(p, &beside)| {
            if p.distance(self.sewing.vertices[beside]) <= SAME_POINT * size { beside } else { self.sewing.vertex(p) }
        });
        let vertices = vertices.collect();
        self.ring_through(vertices, curves)
    }

    fn ring_through(&mut self, vertices: Vec<usize>, curves: Vec<EdgeCurve>) -> Ring {
        let edges = curves.into_iter().enumerate().map(|(i, curve)| {
            let [start, end] = [vertices[i], vertices[(i + 1) % vertices.len()]];
            let points = [start, end].map(|vertex| self.sewing.vertices[vertex]);
            Some(self.sewing.edge(start, end, curve.with_ends(Some(points[0]), Some(points[1]))))
        });
        let edges = edges.collect();
        Ring { vertices, edges }
    }

    /// Adds one point that stands for a ring beside another.
    pub(super) fn pole(&mut self, point: Point3, beside: &Ring) -> Ring {
        let vertex = self.sewing.vertex(point);
        Ring { vertices: vec![vertex; beside.vertices.len()], edges: vec![None; beside.edges.len()] }
    }

    /// Adds faces between two rings of as many edges, as patches where they are parts of a plane, cylinder, cone, sphere or torus: `across(i)` joins vertex i of the first ring to that of the second, `surface(i)`
    /// runs in s along edge i of both and in t from the first to the second.
    pub(super) fn band(
        &mut self,
        [from, to]: [&Ring; 2],
        across: impl Fn(usize, [Point3; 2]) -> Result<EdgeCurve>,
        surface: impl Fn(&Self, usize) -> Result<RationalBezierSurface>,
    ) -> Result<()> {
        let mut between = Vec::with_capacity(from.vertices.len());
        for (i, (&start, &end)) in from.vertices.iter().zip(&to.vertices).enumerate() {
            let ends = [start, end].map(|vertex| self.sewing.vertices[vertex]);
            between.push(if start == end {
                None
            } else {
                Some(self.sewing.edge(start, end, across(i, ends)?.with_ends(Some(ends[0]), Some(ends[1]))))
            });
        }
        for i in 0..from.edges.len() {
            let next = (i + 1) % from.vertices.len();
            let corners = [from.vertices[i], from.vertices[next], to.vertices[i], to.vertices[next]];
            let corners = corners.map(|vertex| self.sewing.vertices[vertex]);
            let surface = surface(self, i)?.with_corners(corners);
            let arc = |edge: Option<usize>| edge.and_then(|edge| self.sewing.edges[edge].curve.arc());
            let [along_s, along_t] = [[from.edges[i], to.edges[i]], [between[i], between[next]]];
            let all_arcs = along_s.iter().chain(&along_t).all(|edge| edge.is_none() || arc(*edge).is_some());
            let patch = all_arcs.then(|| turned_patch(&surface, corners, along_s.map(arc), along_t.map(arc))).flatten();
            let surface = patch.map_or_else(|| surface.into(), FaceSurface::from);
            self.sewing.face(surface, [from.edges[i], to.edges[i], between[i], between[next]], true);
        }
        Ok(())
    }

    /// Adds the ruled faces between two rings: planes, cylinders and cones among them. The ends of all edges have the weight 1.
    pub(super) fn ruled(&mut self, rings: [&Ring; 2]) -> Result<()> {
        let segment = |_, [from, to]: [Point3; 2]| Ok(Arc::segment(from, to)?.into());
        self.band(rings, segment, |bands, i| {
            let [from, to] = rings.map(|ring| bands.rows(ring, i));
            let [from, to] = match (from, to) {
                (Ok(from), Ok(to)) => [from, to],
                (Ok(from), Err(pole)) => [from.clone(), gathered(&from, pole)],
                (Err(pole), Ok(to)) => [gathered(&to, pole), to],
                (Err(_), Err(_)) => {
                    let detail = "a ruled face joins two points";
                    return Err(ShellError::NotAShell { item: ErrorItem::Face, index: i, detail }.into());
                }
            };
            RationalBezierSurface::from_polynomial_rows(&[PolynomialRow::of_rows(&from), PolynomialRow::of_rows(&to)])
        })
    }

    /// The rows of an edge of a ring, or the point that stands for it.
    fn rows(&self, ring: &Ring, i: usize) -> std::result::Result<Vec<[f64; 4]>, Point3> {
        ring.edges[i].map(|edge| rows_of(&self.sewing.edges[edge].curve)).ok_or(self.sewing.vertices[ring.vertices[i]])
    }

    /// Adds the faces of a plane area between closed rings, the edges of which run along its contours, over an image of the plane. `same_sense` if the outside
    /// is where the contours are seen to run counter-clockwise.
    pub(super) fn cover(
        &mut self,
        cover: &Cover,
        rings: &[&Ring],
        image: impl Fn(Point3) -> Point3,
        same_sense: bool,
    ) -> Result<()> {
        let vertices = rings.iter().flat_map(|ring| ring.vertices.iter().copied()).collect();
        let edges = rings.iter().flat_map(|ring| ring.edges.iter().flatten());
        let edges: Vec<FaceEdge> = edges.map(|&edge| FaceEdge { edge, forward: true }).collect();
        cover.sew(&mut self.sewing, vertices, &edges, image, same_sense)
    }

    /// The body: closed outside outwards.
    pub(super) fn finish(self) -> Result<Body> {
        self.sewing.finish_body()
    }
}

/// The homogeneous rows of a curve; of a segment at uniform speed its ends.
pub(super) fn rows_of(curve: &EdgeCurve) -> Vec<[f64; 4]> {
    match curve {
        EdgeCurve::Arc(arc) => match arc.bezier_rows() {
            [from, [.., r], to @ [.., n]] if arc.is_straight() && is_one(r) && is_one(n) => vec![from, to],
            rows => rows.to_vec(),
        },
        EdgeCurve::Rational(_) => curve.bezier_rows(),
    }
}

/// Up to rounding.
fn is_one(weight: f64) -> bool {
    (weight - 1.0).abs() <= f64::EPSILON
}

/// A point as a curve with the weights of another one, so that rulings to it are straight lines at uniform speed.
fn gathered(rows: &[[f64; 4]], p: Point3) -> Vec<[f64; 4]> {
    rows.iter().map(|&[.., w]| [p.x * w, p.y * w, p.z * w, w]).collect()
}
