//! The part of the main pipe between the stretches of two branches, whose rings have different vertices: four sides where they face each
//! other, three where one has more; exact.

use super::crossing::Crossing;
use crate::base::vector::Vec3;
use crate::construct::bodies::pierced::{Border, Mantle, Ring, Skin};
use crate::error::Result;
use crate::rational::Polynomial;
use std::f64::consts::{PI, TAU};

/// Steps of both rings are one face if they end within this part of the shorter.
const FACING: f64 = 0.4;

/// A ring counted on from a vertex, in the axes of one branch.
struct Walk<'a> {
    ring: &'a Ring,
    /// Half the angle from those axes to its own.
    turn: [f64; 2],
    first: usize,
    /// Angles of the vertices from the first on, once round and back to it.
    angles: Vec<f64>,
}

impl<'a> Walk<'a> {
    fn new(ring: &'a Ring, half_turn: f64, near: Option<f64>) -> Self {
        let (sin, cos) = half_turn.sin_cos();
        let turn = [cos, sin];
        let angle = |half: [f64; 2]| {
            let [c, s] = turned(turn, half);
            2.0 * s.atan2(c)
        };
        let all: Vec<f64> = ring.halves.iter().map(|&half| angle(half)).collect();
        let count = all.len();
        let off = |k: usize| near.map_or(0.0, |near| (all[k] - near - TAU * ((all[k] - near) / TAU).round()).abs());
        let first = (1..count).fold(0, |best, k| if off(k) < off(best) { k } else { best });
        let start = near.map_or(all[first], |near| all[first] - TAU * ((all[first] - near) / TAU).round());
        let mut angles = vec![start];
        for k in 1..=count {
            let step = (all[(first + k) % count] - all[(first + k - 1) % count]).rem_euclid(TAU);
            angles.push(angles[k - 1] + step);
        }
        Self { ring, turn, first, angles }
    }

    fn at(&self, k: usize) -> usize {
        (self.first + k) % self.ring.vertices.len()
    }

    fn vertex(&self, k: usize) -> usize {
        self.ring.vertices[self.at(k)]
    }

    fn half(&self, k: usize) -> [f64; 2] {
        let (s, c) = (0.5 * self.angles[k]).sin_cos();
        [c, s]
    }

    /// Half directions along the step from a vertex on, of length 1 at both ends, on the sheet of the angles.
    fn along(&self, k: usize) -> [Polynomial; 2] {
        let [c, s] = &self.ring.along[self.at(k)];
        let [cos, sin] = self.turn;
        let turned = [&(c * cos) + &(s * -sin), &(s * cos) + &(c * sin)];
        let end = |p: &Polynomial, last: bool| p.coefficients()[if last { p.degree() } else { 0 }];
        let [from, to] = [self.half(k), self.half(k + 1)];
        let size = |half: [f64; 2], last: bool| {
            let [c, s] = turned.each_ref().map(|p| end(p, last));
            (c * half[0] + s * half[1]).signum() / c.hypot(s)
        };
        let even = Polynomial::new(vec![size(from, false), size(to, true)]);
        turned.map(|p| &p * &even)
    }
}

fn turned([cos, sin]: [f64; 2], [c, s]: [f64; 2]) -> [f64; 2] {
    [c * cos - s * sin, s * cos + c * sin]
}

impl Skin<'_> {
    /// Joins the ring at the end of one stretch with that at the start of the next.
    ///
    /// # Errors
    /// As [`RationalBezierSurface::new`](crate::RationalBezierSurface::new).
    pub(super) fn join(&mut self, crossings: [&Crossing; 2], rings: [&Ring; 2]) -> Result<()> {
        let [a, b] = crossings;
        let mantle = a.main_pipe(self.depth);
        let turn = b.up.dot(a.sideways).atan2(b.up.dot(a.up));
        let from = Walk::new(rings[0], 0.0, None);
        let to = Walk::new(rings[1], 0.5 * turn, Some(from.angles[0]));
        let place = |skin: &Self, walk: &Walk| skin.sewing.vertices[walk.vertex(0)].x;
        let places = [place(self, &from), place(self, &to)];
        let (mut i, mut j) = (0, 0);
        let (last_i, last_j) = (from.angles.len() - 1, to.angles.len() - 1);
        let first = self.link(&mantle, [&from, &to], [0, 0], places)?;
        let mut before = first;
        while i < last_i || j < last_j {
            let step = |walk: &Walk, k: usize, last: usize| if k < last { walk.angles[k + 1] } else { f64::INFINITY };
            let (next_i, next_j) = (step(&from, i, last_i), step(&to, j, last_j));
            let shorter = (next_i - from.angles[i]).min(next_j - to.angles[j]);
            let both = i < last_i && j < last_j && (next_i - next_j).abs() <= FACING * shorter;
            let ends = [i < last_i && i + 1 == last_i, j < last_j && j + 1 == last_j];
            let (di, dj) = if both || ends == [true, true] {
                (1, 1)
            } else if next_i < next_j {
                (1, 0)
            } else {
                (0, 1)
            };
            let (end_i, end_j) = (i + di, j + dj);
            let behind = if end_i == last_i && end_j == last_j {
                first
            } else {
                self.link(&mantle, [&from, &to], [end_i, end_j], places)?
            };
            let half = |walk: &Walk, k: usize, moves: usize| {
                if moves == 1 { walk.along(k) } else { walk.half(k).map(Polynomial::constant) }
            };
            let [first_border, second_border] = [(&from, i, di, places[0]), (&to, j, dj, places[1])]
                .map(|(walk, k, moves, at)| Border { half: half(walk, k, moves), along: Polynomial::constant(at) });
            let one = Polynomial::constant(1.0);
            let surface = mantle.between(&one, &first_border, &second_border)?;
            let vertices = [from.vertex(i), from.vertex(end_i), to.vertex(j), to.vertex(end_j)];
            let surface = surface.with_corners(vertices.map(|v| self.sewing.vertices[v]));
            let middle = surface.point(0.5, 0.5);
            let outwards = Vec3::new(0.0, middle.y, middle.z) * if self.inner { -1.0 } else { 1.0 };
            let side = |walk: &Walk, k: usize, moves: usize| {
                (moves == 1).then(|| (walk.ring.edges[walk.at(k)], walk.vertex(k)))
            };
            let sides =
                [side(&from, i, di), side(&to, j, dj), Some((before, vertices[0])), Some((behind, vertices[1]))];
            self.plane_face(surface, sides, outwards);
            (i, j, before) = (end_i, end_j, behind);
        }
        Ok(())
    }

    /// The edge between a vertex of one ring and one of the other.
    fn link(&mut self, mantle: &Mantle, [from, to]: [&Walk; 2], [i, j]: [usize; 2], places: [f64; 2]) -> Result<usize> {
        debug_assert!((from.angles[i] - to.angles[j]).abs() < PI);
        let ends = [from.vertex(i), to.vertex(j)];
        if (from.angles[i] - to.angles[j]).abs() <= 1e-12 {
            return self.sewing.segment(ends[0], ends[1]);
        }
        let points = ends.map(|v| self.sewing.vertices[v]);
        let curve = mantle.across(points, [from.half(i), to.half(j)], places)?;
        Ok(self.edge(ends, curve))
    }
}
