//! What closes skins: disks, rings between two skins, and the parts of the main pipe between two stretches.

use super::skin::{Ring, Skin};
use crate::base::vector::{Point3, Vec3};
use crate::error::Result;
use crate::rational::RationalBezierSurface;

impl Ring {
    /// The edges with the vertices at which they start and end.
    pub(in crate::construct::bodies) fn steps(&self) -> impl Iterator<Item = (usize, [usize; 2])> + '_ {
        let count = self.vertices.len();
        self.edges.iter().enumerate().map(move |(k, &edge)| (edge, [self.vertices[k], self.vertices[(k + 1) % count]]))
    }
}

impl Skin<'_> {
    /// The homogeneous rows of an edge from this vertex on.
    fn rows_from(&self, edge: usize, start: usize) -> Vec<[f64; 4]> {
        let edge = &self.sewing.edges[edge];
        let mut rows = edge.curve.bezier_rows();
        if edge.start != start {
            rows.reverse();
        }
        rows
    }

    /// A disk within a ring.
    pub(in crate::construct::bodies) fn disk(&mut self, ring: &Ring, centre: Point3, outwards: Vec3) -> Result<()> {
        let middle = self.sewing.vertex(centre);
        let spokes = ring.vertices.iter().map(|&v| self.sewing.segment(v, middle)).collect::<Result<Vec<_>>>()?;
        let count = spokes.len();
        for (k, (edge, [start, end])) in ring.steps().enumerate() {
            let towards = |row: [f64; 4]| [row, [centre.x * row[3], centre.y * row[3], centre.z * row[3], row[3]]];
            let rows: Vec<[f64; 4]> = self.rows_from(edge, start).into_iter().flat_map(towards).collect();
            let corners = [self.sewing.vertices[start], self.sewing.vertices[end], centre, centre];
            let surface = RationalBezierSurface::new([rows.len() / 2 - 1, 1], rows)?.with_corners(corners);
            self.plane_face(
                surface,
                [Some((edge, start)), None, Some((spokes[k], start)), Some((spokes[(k + 1) % count], end))],
                outwards,
            );
        }
        Ok(())
    }

    /// The plane ring between two rings about one point that run side by side.
    pub(in crate::construct::bodies) fn between_rings(
        &mut self,
        outer: &Ring,
        inner: &Ring,
        outwards: Vec3,
    ) -> Result<()> {
        let pairs = outer.vertices.iter().zip(&inner.vertices);
        let spokes = pairs.map(|(&a, &b)| self.sewing.segment(a, b)).collect::<Result<Vec<_>>>()?;
        let count = spokes.len();
        for (k, ((edge, [a, b]), (inside, [c, d]))) in outer.steps().zip(inner.steps()).enumerate() {
            let (first, second) = (self.rows_from(edge, a), self.rows_from(inside, c));
            let rows: Vec<[f64; 4]> = first.into_iter().zip(second).flat_map(|(p, q)| [p, q]).collect();
            let corners = [a, b, c, d].map(|v| self.sewing.vertices[v]);
            let surface = RationalBezierSurface::new([rows.len() / 2 - 1, 1], rows)?.with_corners(corners);
            let sides = [(edge, a), (inside, c), (spokes[k], a), (spokes[(k + 1) % count], b)];
            self.plane_face(surface, sides.map(Some), outwards);
        }
        Ok(())
    }
}
