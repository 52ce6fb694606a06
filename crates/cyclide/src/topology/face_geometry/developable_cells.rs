//! Cells of rational faces on planes and on cylinders of revolution: only what leaves the surface counts, and not how fast parameters run on
//! it (`docs/math/tessellation.md#faces-on-planes-and-cylinders`).

use crate::base::bernstein;
use crate::base::frame::Frame;
use crate::base::vector::{Point3, Vec3};
use crate::rational::{RationalBezier, RationalBezierSurface};
use crate::surface::PatchKind;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The plane or cylinder on which a rational surface lies, unrolled.
pub(super) struct Developable {
    frame: Frame,
    /// None of a plane.
    radius: Option<f64>,
}

/// What is known of a cell.
pub(super) struct DevelopableCell {
    /// How far its triangles are from the surface, both ways.
    pub(super) distance: f64,
    /// The parts of that along s and along t.
    pub(super) along: [f64; 2],
}

impl Developable {
    /// None if the surface is neither.
    pub(super) fn of(surface: &RationalBezierSurface) -> Option<Self> {
        match surface.recognize() {
            PatchKind::Plane { frame } => Some(Self { frame, radius: None }),
            PatchKind::Cylinder { frame, radius, .. } => Some(Self { frame, radius: Some(radius) }),
            _ => None,
        }
    }

    /// The direction in which parameter lines on it bend off it: the normal, zero of a plane.
    pub(super) fn normal(&self, p: Point3) -> Vec3 {
        let (flat, _) = self.frame.to_local(p);
        let out = self.frame.x() * flat.x + self.frame.y() * flat.y;
        self.radius.and_then(|_| out.unit()).unwrap_or(Vec3::ZERO)
    }

    /// A point unrolled: lengths round the axis, counted from the side that the first axis of the frame points away from, and along it.
    fn unrolled(&self, p: Point3) -> [f64; 2] {
        let (flat, height) = self.frame.to_local(p);
        match self.radius {
            Some(radius) => [radius * (-flat.y).atan2(-flat.x), height],
            None => [flat.x, flat.y],
        }
    }

    /// The way from one unrolled point to another, the shorter one round the axis.
    fn way(&self, a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
        let [x, y] = [b[0] - a[0], b[1] - a[1]];
        let Some(radius) = self.radius else { return [x, y] };
        let turn = TAU * radius;
        [x - turn * (x / turn).round(), y]
    }

    /// How far a chord over this length round the axis is below the surface.
    fn sagitta(&self, length: f64) -> f64 {
        let Some(radius) = self.radius else { return 0.0 };
        let quarter = (0.25 * length / radius).min(0.25 * PI).sin();
        2.0 * radius * quarter * quarter
    }

    /// The cell over four corners at (0,0), (1,0), (0,1), (1,1), with what its sides on the border of the face are off their chords, along s and
    /// along t; none if its triangles would lie over each other or turn too far.
    pub(super) fn cell(&self, corners: [Point3; 4], off: [f64; 2]) -> Option<DevelopableCell> {
        let [a, b, c, d] = corners.map(|p| self.unrolled(p));
        let round = [self.way(a, b), self.way(b, d), self.way(d, c), self.way(c, a)];
        let size = round.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
        let turns: [f64; 4] = std::array::from_fn(|k| {
            let (p, q) = (round[k], round[(k + 1) % 4]);
            p[0] * q[1] - p[1] * q[0]
        });
        // Convex, but for sides that are one point.
        let flat = 1e-12 * size * size;
        let convex = turns.iter().all(|&t| t >= -flat) || turns.iter().all(|&t| t <= flat);
        let diagonals = [self.way(a, d), self.way(b, c)];
        let width = round.iter().chain(&diagonals).fold(0.0_f64, |m, way| m.max(way[0].abs()));
        let small = self.radius.is_none_or(|radius| width <= FRAC_PI_2 * radius);
        if !(convex && small) {
            return None;
        }
        let along = [(round[0], round[2], off[0]), (round[1], round[3], off[1])]
            .map(|(p, q, off)| self.sagitta(p[0].abs().max(q[0].abs())) + off);
        Some(DevelopableCell { distance: self.sagitta(width) + off[0] + off[1], along })
    }
}

/// How far the parts of a curve between cuts are from their chords: as far as their control points.
pub(super) fn chord_distances(curve: &RationalBezier, cuts: &[f64]) -> Vec<f64> {
    cuts.windows(2)
        .map(|ends| {
            let mut rows = curve.rows().to_vec();
            bernstein::restrict(&mut rows, [ends[0], ends[1]]);
            let points: Vec<Point3> = rows.iter().map(|[x, y, z, w]| Point3::new(x / w, y / w, z / w)).collect();
            let (Some(&from), Some(&to)) = (points.first(), points.last()) else { return f64::INFINITY };
            points.iter().map(|&p| p.distance_to_segment([from, to])).fold(0.0, f64::max)
        })
        .collect()
}
