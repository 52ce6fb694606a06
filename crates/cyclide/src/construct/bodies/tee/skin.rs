//! A skin of a tee, outer or inner: the blends, the walls of the branches, and the main pipe in stretches round their holes.

use super::canal::{Ball, Canal};
use super::crossing::Crossing;
use super::equal;
use super::partition::Partition;
use crate::base::quat::Quat;
use crate::base::vector::Point3;
use crate::construct::bodies::pierced::{Hole, HolePiece, Node, Ring, Skin};
use crate::error::Result;
use crate::rational::{RationalBezier, RationalBezierSurface};

/// A branch with its loop, cut.
pub(super) struct Branch<'a> {
    pub(super) crossing: &'a Crossing,
    pub(super) partition: &'a Partition,
    /// Where it ends.
    pub(super) length: f64,
    /// Where its stretch of the main pipe begins and ends.
    pub(super) stretch: [f64; 2],
    /// The vertices at its flanks, at low angles and at high ones, that another branch as wide as the main pipe has too.
    pub(super) flanks: Option<[usize; 2]>,
}

/// The flanks of the hole of a branch as wide as the main pipe, for a branch opposite.
pub(super) fn known_flanks(hole: &Hole) -> [usize; 2] {
    [hole.contacts[hole.sides[1]], hole.contacts[0]]
}

impl Skin<'_> {
    /// The faces of a branch, with its hole in the main pipe and the ring at its end.
    pub(super) fn branch(&mut self, branch: &Branch) -> Result<(Hole, Ring)> {
        let crossing = branch.crossing;
        let canals: Vec<Canal> =
            branch.partition.pieces.iter().map(|piece| Canal::new(crossing, piece, self.depth)).collect();
        let balls: Vec<Ball> = canals.iter().map(Canal::ball).collect();
        let (hole, on_branch) = self.blend(branch, &canals, &balls)?;
        let end = self.wall(branch, &canals, &balls, &on_branch)?;
        Ok((hole, end))
    }

    /// The blend, with the vertices and edges of its contact with the branch.
    fn blend(&mut self, branch: &Branch, canals: &[Canal], balls: &[Ball]) -> Result<(Hole, [Vec<usize>; 2])> {
        let crossing = branch.crossing;
        let count = canals.len();
        let mantle = crossing.main_pipe(self.depth);
        let upper: Vec<Point3> =
            balls.iter().map(|ball| crossing.branch_point(self.depth, ball.on_branch, ball.height)).collect();
        let lower: Vec<Point3> = balls.iter().map(|ball| mantle.point(ball.on_main, ball.along)).collect();
        let known = |k: usize| {
            let [low, high] = branch.flanks?;
            if k == 0 { Some(low) } else { (k == branch.partition.sides[1]).then_some(high) }
        };
        let contacts: Vec<usize> =
            lower.iter().enumerate().map(|(k, &p)| known(k).unwrap_or_else(|| self.sewing.vertex(p))).collect();
        // At the flanks of equal pipes both contacts are one point.
        let points: Vec<bool> =
            branch.partition.pieces.iter().map(|piece| equal::begins_in_a_point(crossing, piece)).collect();
        let tops: Vec<usize> =
            (0..count).map(|k| if points[k] { contacts[k] } else { self.sewing.vertex(upper[k]) }).collect();
        let mut top_edges = Vec::new();
        let mut edges = Vec::new();
        let (mut circles, mut pieces) = (Vec::new(), Vec::new());
        for (k, canal) in canals.iter().enumerate() {
            let next = (k + 1) % count;
            let piece = on_main(crossing, canal);
            let contact = RationalBezier::from_polynomial_row(&mantle.border(&piece.half, &piece.along, &piece.weight));
            let top = RationalBezier::from_polynomial_row(&canal.on_branch());
            top_edges.push(self.edge([tops[k], tops[next]], top.into()));
            edges.push(self.edge([contacts[k], contacts[next]], contact.into()));
            pieces.push(piece);
            let ratio = canal.arc_ratio(0.0).unwrap_or(Quat::ONE);
            circles.push(if points[k] { None } else { Some(self.sewing.arc(tops[k], contacts[k], ratio)?) });
        }
        for (k, canal) in canals.iter().enumerate() {
            let next = (k + 1) % count;
            let surface = canal
                .surface()?
                .with_corners([tops[k], tops[next], contacts[k], contacts[next]].map(|v| self.sewing.vertices[v]));
            let centre = canal.centres().point(0.5);
            let outwards = centre - surface.point(0.5, 0.5);
            let along = [Some((top_edges[k], tops[k])), Some((edges[k], contacts[k]))];
            let across = [k, next].map(|k| circles[k].map(|circle| (circle, tops[k])));
            let outwards = if self.inner { -outwards } else { outwards };
            self.plane_face(surface, [along[0], along[1], across[0], across[1]], outwards);
        }
        let nodes = balls.iter().map(|ball| Node { half: ball.on_main, along: ball.along }).collect();
        let hole = Hole {
            mantle,
            pieces,
            nodes,
            contacts,
            edges,
            sides: branch.partition.sides,
            slant: 0.0,
            stretch: branch.stretch,
        };
        Ok((hole, [tops, top_edges]))
    }

    /// The wall of the branch, from the blend to its end.
    fn wall(&mut self, branch: &Branch, canals: &[Canal], balls: &[Ball], on_branch: &[Vec<usize>; 2]) -> Result<Ring> {
        let crossing = branch.crossing;
        let (count, height) = (canals.len(), branch.length);
        let [tops, top_edges] = on_branch;
        let ends: Vec<Point3> =
            balls.iter().map(|ball| crossing.branch_point(self.depth, ball.on_branch, height)).collect();
        let vertices: Vec<usize> = ends.iter().map(|&p| self.sewing.vertex(p)).collect();
        let axis = crossing.axes[2];
        let mut edges = Vec::new();
        for (k, canal) in canals.iter().enumerate() {
            let half = |end: usize| {
                let [c, s] = canal.forms.on_branch.each_ref().map(|p| p.value(end as f64));
                Quat::from_parts(c, axis * s)
            };
            let ratio = half(1) * half(0).inverse().unwrap_or(Quat::ONE);
            edges.push(self.sewing.arc(vertices[k], vertices[(k + 1) % count], ratio)?);
        }
        let rulings = (0..count).map(|k| self.sewing.segment(tops[k], vertices[k])).collect::<Result<Vec<_>>>()?;
        for (k, canal) in canals.iter().enumerate() {
            let next = (k + 1) % count;
            let corners = [tops[k], tops[next], vertices[k], vertices[next]].map(|v| self.sewing.vertices[v]);
            let rows = [canal.on_branch(), canal.beside_branch(height)];
            let surface = RationalBezierSurface::from_polynomial_rows(&rows)?.with_corners(corners);
            let way = surface.point(0.5, 0.5) - crossing.foot;
            let outwards = way - axis * way.dot(axis);
            let starts = [tops[k], vertices[k], tops[k], tops[next]];
            self.face(surface, [top_edges[k], edges[k], rulings[k], rulings[next]], starts, outwards);
        }
        Ok(Ring { vertices, edges, halves: Vec::new(), along: Vec::new() })
    }
}

/// The contact of a canal with the main pipe.
fn on_main(crossing: &Crossing, canal: &Canal) -> HolePiece {
    let forms = &canal.forms;
    HolePiece {
        half: forms.on_main.clone(),
        along: &forms.along + &(&forms.weight * crossing.at),
        weight: forms.weight.clone(),
    }
}
