//! A skin of a crossing, outer or inner: the blend, and both pipes round their holes.

use super::ball_loop::{BallLoop, LoopPiece};
use super::{CrossingPipe, CrossingSide};
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::pierced::{Hole, Mantle, Node, Ring, Skin};
use crate::error::Result;
use crate::rational::RationalBezier;
use crate::surface::SkewCylinders;

/// The first pipe about the x axis, the second above it, each seen from the other one.
pub(super) fn mantle(axes: &SkewCylinders, pipe: usize, &CrossingPipe { radius, taper, .. }: &CrossingPipe) -> Mantle {
    if pipe == 0 {
        return Mantle { radius, taper, origin: Point3::ORIGIN, along: Vec3::X, sideways: Vec3::Y, up: Vec3::Z };
    }
    let origin = Point3::new(0.0, 0.0, 2.0 * axes.half_gap());
    let [along, sideways] = axes.second_axis();
    Mantle { radius, taper, origin, along, sideways, up: -Vec3::Z }
}

/// What has been sewn of the contacts with a pipe, in the order of the loop.
struct Contacts {
    mantle: Mantle,
    nodes: Vec<Node>,
    vertices: Vec<usize>,
    edges: Vec<usize>,
}

impl Skin<'_> {
    /// The faces of a crossing whose pipes go from place to place, and the rings at their ends: both of the first pipe, both of the second; of a pipe
    /// that leaves only a cap none.
    pub(super) fn crossing(
        &mut self,
        mantles: &[Mantle; 2],
        balls: &BallLoop,
        stretches: [[f64; 2]; 2],
        side: CrossingSide,
    ) -> Result<Vec<Ring>> {
        let depths = [0, 1].map(|pipe: usize| self.depth * side.depth_sign(pipe));
        let contacts = [0, 1].map(|pipe: usize| self.contacts(mantles[pipe].below(depths[pipe]), &balls.pieces, pipe));
        self.strip(mantles[0].origin.midpoint(mantles[1].origin).to_vec(), balls, &contacts, side)?;
        let mut rings = Vec::new();
        for (pipe, contacts) in contacts.into_iter().enumerate() {
            // Places of a skin below are counted from a moved origin.
            let stretch = stretches[pipe].map(|at| at + depths[pipe] * mantles[pipe].taper.sin());
            let hole = hole(balls, contacts, pipe, stretch);
            if side.leaves(pipe) {
                rings.extend(self.stretch(hole)?);
            } else {
                self.cap(&hole, side.depth_sign(pipe) > 0.0)?;
            }
        }
        Ok(rings)
    }

    fn contacts(&mut self, mantle: Mantle, pieces: &[LoopPiece], pipe: usize) -> Contacts {
        let nodes: Vec<Node> = pieces.iter().map(|piece| piece.node(pipe)).collect();
        let vertices: Vec<usize> =
            nodes.iter().map(|node| self.sewing.vertex(mantle.point(node.half, node.along))).collect();
        let edges = pieces.iter().enumerate().map(|(k, piece)| {
            let row = mantle.border(&piece.halves[pipe], &piece.along[pipe], piece.patch.center().weight());
            self.edge([vertices[k], vertices[(k + 1) % pieces.len()]], RationalBezier::from_polynomial_row(&row).into())
        });
        let edges = edges.collect();
        Contacts { mantle, nodes, vertices, edges }
    }

    /// The blend, whose balls are counted from the middle between the axes.
    fn strip(
        &mut self,
        middle: Vec3,
        balls: &BallLoop,
        [first, second]: &[Contacts; 2],
        side: CrossingSide,
    ) -> Result<()> {
        let count = balls.pieces.len();
        let mut circles = Vec::with_capacity(count);
        for (k, piece) in balls.pieces.iter().enumerate() {
            let ratio = piece.patch.arc_ratio(0.0).unwrap_or(Quat::ONE);
            circles.push(self.sewing.arc(first.vertices[k], second.vertices[k], ratio)?);
        }
        for (k, piece) in balls.pieces.iter().enumerate() {
            let next = (k + 1) % count;
            let corners = [first.vertices[k], first.vertices[next], second.vertices[k], second.vertices[next]];
            let canal = piece.patch.offset(self.depth * side.ball_depth_sign()).moved(middle);
            let surface = canal.to_rational()?.with_corners(corners.map(|v| self.sewing.vertices[v]));
            let towards_centre = canal.ball(0.5).0 - surface.point(0.5, 0.5);
            let outwards = if side.is_in_material() { -towards_centre } else { towards_centre };
            let starts = [first.vertices[k], second.vertices[k], first.vertices[k], first.vertices[next]];
            self.face(surface, [first.edges[k], second.edges[k], circles[k], circles[next]], starts, outwards);
        }
        Ok(())
    }
}

/// The hole of a pipe, from its corner on.
fn hole(balls: &BallLoop, contacts: Contacts, pipe: usize, stretch: [f64; 2]) -> Hole {
    let order = balls.hole_order(pipe);
    let piece = |&k: &usize| {
        let border = balls.pieces[k].border(pipe);
        if order.ahead { border } else { border.reversed() }
    };
    let nodes: Vec<Node> = order.nodes.iter().map(|&node| contacts.nodes[node]).collect();
    // The corners on both sides of the hole, which an upright hole has at one angle.
    let [low, high, back_high, back_low] = [0, 1, 2, 3].map(|side: usize| nodes[order.sides[side] % nodes.len()]);
    let angle = |node: Node| 2.0 * node.half[1].atan2(node.half[0]);
    let slope = |front: Node, back: Node| (angle(front) - angle(back)) / (front.along - back.along);
    let slant = 0.5 * (slope(high, back_high) + slope(low, back_low));
    Hole {
        mantle: contacts.mantle,
        pieces: order.pieces.iter().map(piece).collect(),
        nodes,
        contacts: order.nodes.iter().map(|&node| contacts.vertices[node]).collect(),
        edges: order.pieces.iter().map(|&piece| contacts.edges[piece]).collect(),
        sides: order.sides,
        // What is rounding is none.
        slant: if (slant * (high.along - back_high.along)).abs() < 1e-9 { 0.0 } else { slant },
        stretch,
    }
}
