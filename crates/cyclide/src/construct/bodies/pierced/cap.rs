//! What is within the border of a hole, as a part of the pipe: faces from each piece of the border to a point in its middle, exact.

use super::lines::{Hole, HolePiece, Node};
use super::mantle::Border;
use super::skin::Skin;
use crate::base::vector::Vec3;
use crate::error::Result;
use crate::rational::Polynomial;

impl Node {
    /// In the middle of others.
    pub(in crate::construct::bodies) fn between(nodes: &[Self]) -> Self {
        let middle = |of: fn(&Self) -> f64| {
            let (low, high) = nodes
                .iter()
                .map(of)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
            0.5 * (low + high)
        };
        let (s, c) = middle(|node| node.half[1].atan2(node.half[0])).sin_cos();
        Self { half: [c, s], along: middle(|node| node.along) }
    }
}

impl HolePiece {
    /// How much the border turns about a place inside it at a parameter: positive everywhere the one way or negative everywhere the other, faces that are
    /// straight in half directions and places from the border to it do not overlap.
    ///
    /// With the half angle d and the length a from the place, a point a part r of the way out has the tangent `r sin d/(1 - r (1 - cos d))` of its half
    /// angle and the length `r a`: its Jacobian has the sign of `a d' (cos d + r (1 - cos d)) - a' sin d`, linear in r.
    pub(in crate::construct::bodies) fn turns_about(&self, place: Node, s: f64) -> [f64; 2] {
        let ([c, dc], [v, dv]) = (self.half[0].jet::<2>(s), self.half[1].jet::<2>(s));
        let ([a, da], [w, dw]) = (self.along.jet::<2>(s), self.weight.jet::<2>(s));
        let norm = c * c + v * v;
        let (along, along_rate, rate) = (a / w - place.along, (da - a / w * dw) / w, (c * dv - v * dc) / norm);
        let [p, q] = place.half;
        let (cos, sin) = ((c * p + v * q) / norm.sqrt(), (v * p - c * q) / norm.sqrt());
        [cos, 1.0].map(|part| along * rate * part - along_rate * sin)
    }
}

impl Skin<'_> {
    /// Fills a hole by parts of its pipe, whose outer side is that away from the axis if `away`.
    ///
    /// # Errors
    /// As [`RationalBezierSurface::new`](crate::rational::RationalBezierSurface::new).
    pub(in crate::construct::bodies) fn cap(&mut self, hole: &Hole, away: bool) -> Result<()> {
        let (mantle, count) = (hole.mantle, hole.pieces.len());
        let middle = Node::between(&hole.nodes);
        let centre = self.sewing.vertex(mantle.point(middle.half, middle.along));
        let mut spokes = Vec::with_capacity(count);
        for (node, &vertex) in hole.nodes.iter().zip(&hole.contacts) {
            let ends = [vertex, centre].map(|v| self.sewing.vertices[v]);
            let curve = mantle.across(ends, [node.half, middle.half], [node.along, middle.along])?;
            spokes.push(self.edge([vertex, centre], curve));
        }
        for (k, piece) in hole.pieces.iter().enumerate() {
            let next = (k + 1) % count;
            let size = |end: f64| {
                let [c, s] = piece.half.each_ref().map(|p| p.value(end));
                c.hypot(s)
            };
            let even = Polynomial::new(vec![size(0.0), size(1.0)]);
            let border = Border { half: piece.half.clone(), along: piece.along.clone() };
            let point = Border { half: middle.half.map(|x| &even * x), along: &piece.weight * middle.along };
            let vertices = [hole.contacts[k], hole.contacts[next], centre, centre];
            let surface = mantle.between(&piece.weight, &border, &point)?;
            let corners = vertices.map(|v| self.sewing.vertices[v]);
            // Rounding of the axis, far beyond a small hole, would leave a side of some length there, and normals of its directions.
            let surface = surface.with_corners(corners).with_end_point(corners[2]);
            let outwards: Vec3 = mantle.off_axis(surface.point(0.5, 0.5)) * if away != self.inner { 1.0 } else { -1.0 };
            let sides = [(hole.edges[k], vertices[0]), (spokes[k], vertices[0]), (spokes[next], vertices[1])];
            self.plane_face(surface, [Some(sides[0]), None, Some(sides[1]), Some(sides[2])], outwards);
        }
        Ok(())
    }
}
