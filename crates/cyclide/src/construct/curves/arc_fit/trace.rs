//! The polyline the curve is matched with, and the chains of joints over it.

use super::beam::ChainJoint;
use crate::base::vector::Point3;

/// Points along the polyline in order: its vertices, and points on its edges where arcs meet between vertices.
pub(super) struct Trace {
    pub points: Vec<Point3>,
    /// The vertex each point is; `None` for points on an edge.
    pub vertex: Vec<Option<usize>>,
    /// How much farther than the tolerance the curve may be from each point; 0 at vertices.
    pub slack: Vec<f64>,
    /// How much farther than the tolerance the curve may bulge out over the edge that ends in each point.
    pub bulge: Vec<f64>,
    /// Whether a straight run goes on from each point, after a turn between straight runs.
    pub straight_ahead: Vec<bool>,
    /// Whether the edge that begins in each point is bound as the vertices are, where they are what is meant otherwise.
    pub bound: Vec<bool>,
    pub closed: bool,
}

impl Trace {
    pub fn empty(closed: bool) -> Self {
        Self {
            points: Vec::new(),
            vertex: Vec::new(),
            slack: Vec::new(),
            bulge: Vec::new(),
            straight_ahead: Vec::new(),
            bound: Vec::new(),
            closed,
        }
    }

    pub fn of_points(points: &[Point3], closed: bool) -> Self {
        let n = points.len();
        let vertex = (0..n).map(Some).collect();
        let none = vec![0.0; n];
        Self {
            points: points.to_vec(),
            vertex,
            slack: none.clone(),
            bulge: none,
            straight_ahead: vec![false; n],
            bound: vec![false; n],
            closed,
        }
    }

    /// Length of the edge between vertices in which the place with this index is, or which begins there.
    pub fn edge_at(&self, index: usize) -> f64 {
        let n = self.points.len();
        let is_vertex = |i: &usize| self.vertex[i % n].is_some();
        let from = (0..n).map(|k| index + n - k).find(is_vertex).unwrap_or(index);
        let to = (1..=n).map(|k| index + k).find(is_vertex).unwrap_or(index);
        self.point(from).distance(self.point(to))
    }

    /// A vertex, and the slack of the edge that ends there.
    pub fn push(&mut self, point: Point3, vertex: usize, bulge: f64) {
        self.points.push(point);
        self.vertex.push(Some(vertex));
        self.slack.push(0.0);
        self.bulge.push(bulge);
        self.straight_ahead.push(false);
        self.bound.push(false);
    }

    /// A point on an edge with this slack.
    pub fn push_loose(&mut self, point: Point3, slack: f64) {
        self.points.push(point);
        self.vertex.push(None);
        self.slack.push(slack);
        self.bulge.push(slack);
        self.straight_ahead.push(false);
        self.bound.push(false);
    }

    /// Point at an index that may have wrapped around.
    pub fn point(&self, index: usize) -> Point3 {
        self.points[index % self.points.len()]
    }

    /// Where the vertices stand; both in ascending order.
    pub fn positions_of(&self, vertices: &[usize]) -> Vec<usize> {
        let mut places = self.vertex.iter().enumerate();
        vertices.iter().filter_map(|v| places.find(|(_, w)| **w == Some(*v)).map(|(i, _)| i)).collect()
    }

    /// The last vertex at or before a position.
    pub fn vertex_before(&self, position: usize) -> usize {
        self.vertex[..=position].iter().rev().find_map(|v| *v).unwrap_or(0)
    }

    /// Index ranges between corners, ends included; those that pass the seam of a closed polyline exceed its length.
    pub fn runs(&self, corners: &[usize]) -> Vec<(usize, usize)> {
        let n = self.points.len();
        let mut ends = corners.to_vec();
        if self.closed {
            ends.extend(corners.first().map(|c| c + n));
        } else {
            ends.insert(0, 0);
            ends.push(n - 1);
        }
        ends.windows(2).map(|w| (w[0], w[1])).collect()
    }
}

/// Tangent-continuous joints over a run of the trace; vertices count from `first`.
pub(super) struct Chain {
    pub first: usize,
    pub joints: Vec<ChainJoint>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_are_found_among_extra_points() {
        let mut trace = Trace::empty(false);
        for vertex in [Some(0), None, None, Some(1), Some(2), None, Some(3)] {
            match vertex {
                Some(vertex) => trace.push(Point3::ORIGIN, vertex, 0.0),
                None => trace.push_loose(Point3::ORIGIN, 0.0),
            }
        }
        assert_eq!(trace.positions_of(&[0, 2, 3]), [0, 4, 6]);
    }
}
