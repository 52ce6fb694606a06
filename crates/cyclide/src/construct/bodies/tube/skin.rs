//! The shell of a tube: four faces over each arc of balls, and those that close its ends.

use super::ring::Ring;
use crate::base::quat::Quat;
use crate::base::vector::{Point3, Vec3};
use crate::construct::bodies::PipeEnds;
use crate::curve::Arc;
use crate::error::Result;
use crate::rational::{Polynomial, PolynomialRow, RationalBezierSurface};
use crate::surface::CyclidePatch;
use crate::topology::{Sewing, Shell};
use std::f64::consts::{PI, TAU};

/// From a ring to the next: the next one with the places that lines of curvature lead to, and with those that the faces end at.
pub(super) struct Step {
    pub(super) carried: Ring,
    /// Which ring is reached.
    pub(super) next: usize,
    /// The place of that ring which the first place leads to.
    pub(super) renumbered: usize,
    /// Whether the faces lead elsewhere than the lines of curvature.
    pub(super) turned: bool,
}

/// A skin on its way to a shell: the tube of balls that are smaller by a depth.
pub(super) struct Skin<'a> {
    rings: &'a [Ring],
    depth: f64,
    sewing: Sewing,
    /// Of each ring: its first vertex and its first edge.
    firsts: Vec<[usize; 2]>,
}

impl<'a> Skin<'a> {
    pub(super) fn new(rings: &'a [Ring], steps: &[Step], depth: f64) -> Result<Self> {
        let mut skin = Self { rings, depth, sewing: Sewing::default(), firsts: Vec::new() };
        for ring in rings {
            let first = skin.sewing.vertices.len();
            skin.sewing.vertices.extend((0..4).map(|k| ring.point(k, depth)));
            skin.firsts.push([first, skin.sewing.edges.len()]);
            for k in 0..4 {
                skin.sewing.arc(first + k, first + (k + 1) % 4, ring.ratio(k))?;
            }
        }
        for (index, step) in steps.iter().enumerate() {
            if step.turned { skin.add_turned(index, step)? } else { skin.add_principal(index, step)? }
        }
        Ok(skin)
    }

    /// The principal patch from a place on, between a ring and where the lines of curvature lead.
    fn patch(&self, index: usize, step: &Step, place: usize) -> Result<CyclidePatch> {
        let (from, next) = (&self.rings[index], (place + 1) % 4);
        let corners = [
            from.point(place, self.depth),
            from.point(next, self.depth),
            step.carried.point(place, self.depth),
            step.carried.point(next, self.depth),
        ];
        CyclidePatch::from_corners_and_frame(corners, from.axis.cross(from.radial(place)), from.way(place))
    }

    /// The principal patches round an arc, with the parameter of the ring across and one parameter along.
    fn patches(&self, index: usize, step: &Step) -> Result<Vec<CyclidePatch>> {
        let mut patches = Vec::with_capacity(4);
        let mut along = 1.0;
        for k in 0..4 {
            let patch = self.patch(index, step, k)?;
            let [w, ws, wt, wst] = patch.weights();
            let (s, t) = (self.rings[index].ratio(k).norm() * w.norm() / ws.norm(), along * w.norm() / wt.norm());
            let weights = [w, ws * s, wt * t, wst * (s * t)];
            along = weights[3].norm() / weights[1].norm();
            let [v1, v2, _] = patch.frame();
            patches.push(CyclidePatch::from_weights(self.corners(index, step, k), weights, v1, v2)?);
        }
        Ok(patches)
    }

    /// The vertices that a face from a place on lies between.
    fn corners(&self, index: usize, step: &Step, place: usize) -> [Point3; 4] {
        let ([from, _], [to, _]) = (self.firsts[index], self.firsts[step.next]);
        let at = |k: usize| to + (k + step.renumbered) % 4;
        [from + place, from + (place + 1) % 4, at(place), at(place + 1)].map(|vertex| self.sewing.vertices[vertex])
    }

    fn add_principal(&mut self, index: usize, step: &Step) -> Result<()> {
        let at = |k: usize| (k + step.renumbered) % 4;
        let patches = self.patches(index, step)?;
        let ([from, from_edge], [to, to_edge]) = (self.firsts[index], self.firsts[step.next]);
        let first_line = self.sewing.edges.len();
        for (k, patch) in patches.iter().enumerate() {
            let ends = [from + k, to + at(k)];
            let [start, end] = ends.map(|vertex| self.sewing.vertices[vertex]);
            let line: Arc = patch.t_line(0.0)?.with_start(start).with_end(end);
            self.sewing.edge(ends[0], ends[1], line);
        }
        for (k, patch) in patches.into_iter().enumerate() {
            let edges = [from_edge + k, to_edge + at(k), first_line + k, first_line + (k + 1) % 4];
            self.sewing.face(patch, edges.map(Some), true);
        }
        Ok(())
    }

    /// Faces whose sides lead from places to others than the lines of curvature do: on the same cyclide, of degree (4, 2).
    fn add_turned(&mut self, index: usize, step: &Step) -> Result<()> {
        let at = |k: usize| (k + step.renumbered) % 4;
        let (from, to) = (&self.rings[index], &self.rings[step.next]);
        let whole = Whole::new(&self.patch(index, step, 0)?, [from.gap(0), step.carried.gap(0)]);
        let starts = from.angles();
        // The nearest turns of the places reached.
        let ends = [0, 1, 2, 3].map(|k| {
            let own = step.carried.angles()[k];
            let reached = step.carried.angle(to.radial(at(k)));
            own + (reached - own + PI).rem_euclid(TAU) - PI
        });
        let weights = |k: usize| [from.weights[k % 4], to.weights[at(k)]];
        let sides = [0, 1, 2, 3].map(|k| whole.side([starts[k], ends[k]], weights(k)));
        let last = whole.side([starts[0] + TAU, ends[0] + TAU], weights(0));
        let ([first, first_edge], [second, second_edge]) = (self.firsts[index], self.firsts[step.next]);
        let mut surfaces = Vec::new();
        for k in 0..4 {
            let next = if k == 3 { &last } else { &sides[k + 1] };
            let corners = [first + k, second + at(k), first + (k + 1) % 4, second + at(k + 1)];
            let surface = RationalBezierSurface::from_polynomial_rows(&whole.rows(&sides[k], next))?;
            surfaces.push(surface.with_corners(corners.map(|vertex| self.sewing.vertices[vertex])));
        }
        let first_line = self.sewing.edges.len();
        for (k, surface) in surfaces.iter().enumerate() {
            let ends = [first + k, second + at(k)];
            let [start, end] = ends.map(|vertex| self.sewing.vertices[vertex]);
            self.sewing.edge(ends[0], ends[1], surface.s_line(0.0).with_ends(Some(start), Some(end)));
        }
        for (k, surface) in surfaces.into_iter().enumerate() {
            let edges = [first_line + k, first_line + (k + 1) % 4, first_edge + k, second_edge + at(k)];
            self.sewing.face(surface, edges.map(Some), false);
        }
        Ok(())
    }

    /// The shell with its ends closed by themselves; `steps` leave the last ring of an open tube.
    pub(super) fn closed(mut self, ends: PipeEnds, is_open: bool) -> Result<Shell> {
        for is_last in [false, true].into_iter().filter(|_| is_open) {
            match ends {
                PipeEnds::Open => {}
                PipeEnds::Flat => self.add_disk(is_last)?,
                PipeEnds::Round => self.add_cap(is_last)?,
            }
        }
        self.sewing.finish()
    }

    fn end(&self, is_last: bool) -> usize {
        if is_last { self.rings.len() - 1 } else { 0 }
    }

    /// A disk of four sectors.
    fn add_disk(&mut self, is_last: bool) -> Result<()> {
        let end = self.end(is_last);
        let ring = &self.rings[end];
        let center = self.sewing.vertex(ring.center(self.depth));
        let [vertex, edge] = self.firsts[end];
        let radial = self.sewing.edges.len();
        for k in 0..4 {
            self.sewing.segment(center, vertex + k)?;
        }
        for k in 0..4 {
            let next = (k + 1) % 4;
            let corners = [center, vertex + k, center, vertex + next].map(|v| self.sewing.vertices[v]);
            let (way, u) = (ring.radial(k), ring.ratio(k));
            let patch = CyclidePatch::from_weights(corners, [Quat::ONE, Quat::ONE, u, u], way, ring.axis.cross(way))?;
            self.sewing.face(patch, [Some(radial + k), Some(radial + next), None, Some(edge + k)], is_last);
        }
        Ok(())
    }

    /// The part of the ball at an end that lies beyond the ring: four faces that meet in its pole.
    fn add_cap(&mut self, is_last: bool) -> Result<()> {
        let end = self.end(is_last);
        let ring = &self.rings[end];
        let out = if is_last { ring.axis } else { -ring.axis };
        let pole = self.sewing.vertex(ring.ball.center + out * (ring.ball.radius - self.depth));
        let [vertex, edge] = self.firsts[end];
        let ratio = |k: usize| {
            let (normal, axis) = (ring.normals[k], ring.normals[k].cross(out));
            // Half the angle between both, from its cosine and sine.
            let half = 0.5 * axis.length().atan2(normal.dot(out));
            Quat::from_parts(half.cos(), axis.unit().unwrap_or(axis) * half.sin())
        };
        let meridian = self.sewing.edges.len();
        for k in 0..4 {
            self.sewing.arc(vertex + k, pole, ratio(k))?;
        }
        for k in 0..4 {
            let next = (k + 1) % 4;
            let corners = [vertex + k, pole, vertex + next, pole].map(|v| self.sewing.vertices[v]);
            let u = ring.ratio(k);
            let normal = ring.normals[k];
            let weights = [Quat::ONE, ratio(k), u, u * ratio(k)];
            let up = out - normal * out.dot(normal);
            let patch = CyclidePatch::from_weights(corners, weights, up, ring.axis.cross(ring.radial(k)))?;
            self.sewing.face(patch, [Some(meridian + k), Some(meridian + next), Some(edge + k), None], !is_last);
        }
        Ok(())
    }

    /// Both skins as one, rings between their ends: ruled along the normals, parts of cones or planes.
    pub(super) fn with_bore(mut self, bore: Self) -> Result<Shell> {
        let (vertices, edges) = (self.sewing.vertices.len(), self.sewing.edges.len());
        self.sewing.vertices.extend(bore.sewing.vertices);
        for edge in bore.sewing.edges {
            self.sewing.edge(edge.start + vertices, edge.end + vertices, edge.curve);
        }
        for mut face in bore.sewing.faces {
            face.sides.iter_mut().flatten().for_each(|side| side.edge += edges);
            self.sewing.face_along(face.surface, face.sides, !face.same_sense);
        }
        for is_last in [false, true] {
            let end = self.end(is_last);
            let ring = &self.rings[end];
            let ([vertex, edge], [inner, inner_edge]) = (self.firsts[end], bore.firsts[end]);
            let radial = self.sewing.edges.len();
            for k in 0..4 {
                self.sewing.segment(vertices + inner + k, vertex + k)?;
            }
            for k in 0..4 {
                let next = (k + 1) % 4;
                let corners = [vertices + inner + k, vertex + k, vertices + inner + next, vertex + next];
                let corners = corners.map(|v| self.sewing.vertices[v]);
                let (way, u): (Vec3, Quat) = (ring.normals[k], ring.ratio(k));
                let across = ring.axis.cross(ring.radial(k));
                let patch = CyclidePatch::from_weights(corners, [Quat::ONE, Quat::ONE, u, u], way, across)?;
                let sides = [radial + k, radial + next, edges + inner_edge + k, edge + k];
                self.sewing.face(patch, sides.map(Some), is_last);
            }
        }
        self.sewing.finish()
    }
}

/// A whole piece of tube as a principal patch, whose parameter across runs on round it.
struct Whole {
    /// Rows of the parameter across, of degree 2, each a polynomial along.
    rows: [PolynomialRow; 3],
    /// Angles that the patch takes at its start and at its end, and the roots of the weights of its rows there.
    ends: [(f64, [f64; 2]); 2],
}

impl Whole {
    fn new(patch: &CyclidePatch, gaps: [f64; 2]) -> Self {
        let surface = patch.to_rational();
        let rows = surface.rows();
        let row = |i: usize| PolynomialRow::of_rows(&rows[3 * i..3 * i + 3]);
        let end = |j: usize| (gaps[j], [rows[2 * j][3].sqrt(), rows[6 + 2 * j][3].sqrt()]);
        Self { rows: [0, 1, 2].map(row), ends: [end(0), end(1)] }
    }

    /// The homogeneous parameter across along a side that runs between two angles from the first place, linear, with the weights of the side's ends.
    fn side(&self, angles: [f64; 2], weights: [f64; 2]) -> [Polynomial; 2] {
        let place = |end: usize| {
            let (gap, [w0, w1]) = self.ends[end];
            let angle = angles[end];
            let place = [w1 * (0.5 * (gap - angle)).sin(), w0 * (0.5 * angle).sin()];
            let weight = self
                .product(&place.map(Polynomial::constant), &place.map(Polynomial::constant))
                .weight()
                .value(end as f64);
            place.map(|v| v * (weights[end] / weight).sqrt())
        };
        let [a, b] = [place(0), place(1)];
        [0, 1].map(|d: usize| Polynomial::new(vec![a[d], b[d]]))
    }

    /// The polar form across at two sides.
    fn product(&self, a: &[Polynomial; 2], b: &[Polynomial; 2]) -> PolynomialRow {
        let mixed = &(&a[0] * &b[1]) + &(&a[1] * &b[0]);
        let ends = &(&self.rows[0] * &(&a[0] * &b[0])) + &(&self.rows[2] * &(&a[1] * &b[1]));
        &ends + &(&self.rows[1] * &mixed)
    }

    /// The rows of the face between two sides.
    fn rows(&self, a: &[Polynomial; 2], b: &[Polynomial; 2]) -> [PolynomialRow; 3] {
        [self.product(a, a), self.product(a, b), self.product(b, b)]
    }
}
