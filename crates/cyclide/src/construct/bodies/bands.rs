//! Sewing of surfaces that go round an axis or along a pair of curves: rings of edges, and bands of faces between them.

use super::turned_patch::turned_patch;
use crate::base::vector::Point3;
use crate::curve::Arc;
use crate::error::{Error, ErrorItem, Result};
use crate::rational::{PolynomialRow, RationalBezierSurface};
use crate::topology::{Body, EdgeCurve, FaceEdge, FaceSurface, Sewing};

/// Vertices of neighbouring rings nearer to each other than this part of the coordinates are one.
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
    /// With whether the ring runs along it.
    edges: Vec<Option<FaceEdge>>,
}

impl Ring {
    /// The part of a closed ring from edge `from` up to edge `to`, open.
    pub(super) fn part(&self, from: usize, to: usize) -> Self {
        let n = self.vertices.len();
        let vertices = (from..=to).map(|i| self.vertices[i % n]).collect();
        Self { vertices, edges: self.edges[from..to].to_vec() }
    }

    /// The same edges backwards, of an open ring.
    pub(super) fn reversed(&self) -> Self {
        let turned = |edge: &Option<FaceEdge>| edge.map(|e| FaceEdge { forward: !e.forward, ..e });
        Self {
            vertices: self.vertices.iter().rev().copied().collect(),
            edges: self.edges.iter().rev().map(turned).collect(),
        }
    }

    /// This open ring closed by another one from its end to its start.
    pub(super) fn closed_by(&self, other: &Self) -> Self {
        let inner = |ring: &Self| ring.vertices[..ring.edges.len()].to_vec();
        Self {
            vertices: [inner(self), inner(other)].concat(),
            edges: [self.edges.clone(), other.edges.clone()].concat(),
        }
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

    /// Adds the edges along curves from the last vertex of an open ring to its first: the ends are these vertices.
    pub(super) fn way_back(&mut self, ring: &Ring, curves: Vec<EdgeCurve>) -> Ring {
        let between = curves.iter().skip(1).map(EdgeCurve::start);
        let (start, end) = (ring.vertices[ring.vertices.len() - 1], ring.vertices[0]);
        let mut vertices = vec![start];
        vertices.extend(between.map(|p| self.sewing.vertex(p)));
        vertices.push(end);
        self.ring_through(vertices, curves)
    }

    fn ring_through(&mut self, vertices: Vec<usize>, curves: Vec<EdgeCurve>) -> Ring {
        let edges = curves.into_iter().enumerate().map(|(i, curve)| {
            let [start, end] = [vertices[i], vertices[(i + 1) % vertices.len()]];
            let points = [start, end].map(|vertex| self.sewing.vertices[vertex]);
            let edge = self.sewing.edge(start, end, curve.with_ends(Some(points[0]), Some(points[1])));
            Some(FaceEdge { edge, forward: true })
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
            let along_t = [between[i], between[next]].map(|edge| edge.map(|edge| FaceEdge { edge, forward: true }));
            let along_s = [from.edges[i], to.edges[i]];
            let arc = |edge: Option<FaceEdge>| {
                edge.filter(|edge| edge.forward).and_then(|edge| self.sewing.edges[edge.edge].curve.arc())
            };
            let all_arcs = along_s.iter().chain(&along_t).all(|edge| edge.is_none() || arc(*edge).is_some());
            let patch = all_arcs.then(|| turned_patch(&surface, corners, along_s.map(arc), along_t.map(arc))).flatten();
            let surface = patch.map_or_else(|| surface.into(), FaceSurface::from);
            self.sewing.face_along(surface, [along_s[0], along_s[1], along_t[0], along_t[1]], true);
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
                    return Err(Error::NotAShell { item: ErrorItem::Face, index: i, detail });
                }
            };
            RationalBezierSurface::from_polynomial_rows(&[PolynomialRow::of_rows(&from), PolynomialRow::of_rows(&to)])
        })
    }

    /// The rows of an edge of a ring, or the point that stands for it.
    fn rows(&self, ring: &Ring, i: usize) -> std::result::Result<Vec<[f64; 4]>, Point3> {
        let rows = |FaceEdge { edge, forward }: FaceEdge| {
            let mut rows = rows_of(&self.sewing.edges[edge].curve);
            if !forward {
                rows.reverse();
            }
            rows
        };
        ring.edges[i].map(rows).ok_or(self.sewing.vertices[ring.vertices[i]])
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
