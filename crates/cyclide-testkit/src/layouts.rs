//! Meshes of quads with extraordinary vertices.

use cyclide::{Point3, QuadLayout, Vec3};
use std::f64::consts::TAU;

/// Points that are equal but for rounding are one.
#[derive(Default)]
struct Mesh {
    points: Vec<Point3>,
    quads: Vec<[usize; 4]>,
}

impl Mesh {
    fn quad(&mut self, corners: [Point3; 4]) {
        let number = |points: &mut Vec<Point3>, p: Point3| {
            points.iter().position(|q| q.distance(p) < 1e-9).unwrap_or_else(|| {
                points.push(p);
                points.len() - 1
            })
        };
        let quad = corners.map(|p| number(&mut self.points, p));
        self.quads.push(quad);
    }

    #[allow(clippy::expect_used, reason = "these meshes are discs and spheres of quads")]
    fn layout(self) -> QuadLayout {
        QuadLayout::new(self.points, &self.quads).expect("a mesh of quads")
    }
}

/// Sectors of `k` x `k` quads round one vertex; the edges cross at right angles in the plane.
#[must_use]
pub fn cap(sectors: usize, k: usize, height: impl Fn(f64, f64) -> f64) -> QuadLayout {
    let bend = 4.0 / sectors as f64;
    let place = |i: usize, a: usize, b: usize| {
        let r = ((a as f64).hypot(b as f64) / k as f64).powf(bend);
        let angle = bend * (b as f64).atan2(a as f64) + TAU * i as f64 / sectors as f64;
        let (x, y) = (r * angle.cos(), r * angle.sin());
        Point3::new(x, y, height(x, y))
    };
    let mut mesh = Mesh::default();
    for q in 0..sectors * k * k {
        let (i, a, b) = (q / (k * k), q % k, q / k % k);
        mesh.quad([(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)].map(|(a, b)| place(i, a, b)));
    }
    mesh.layout()
}

/// A cube of `k` x `k` quads a side, pressed on a sphere: eight vertices of three quads, closed.
#[must_use]
pub fn ball(k: usize, bulge: f64) -> QuadLayout {
    let mut mesh = Mesh::default();
    for side in 0..6 {
        let (axis, up) = (side / 2, side % 2 == 0);
        for q in 0..k * k {
            let corner = |a: usize, b: usize| {
                // Equal angles between the planes through the centre.
                let t = [a, b].map(|c| ((c as f64 / k as f64 - 0.5) * TAU / 4.0).tan());
                let mut p = [0.0; 3];
                p[axis] = if up { 1.0 } else { -1.0 };
                (p[(axis + 1) % 3], p[(axis + 2) % 3]) = (t[0], t[1]);
                let d = Vec3::from(p);
                Point3::ORIGIN + d * ((1.0 + bulge * p[2] / d.length()) / d.length())
            };
            let (a, b) = (q % k, q / k);
            let corners = [(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)].map(|(a, b)| corner(a, b));
            mesh.quad(if up { corners } else { [corners[0], corners[3], corners[2], corners[1]] });
        }
    }
    mesh.layout()
}
