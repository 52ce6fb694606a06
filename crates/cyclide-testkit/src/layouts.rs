//! Meshes of quads with extraordinary vertices.

use cyclide::{Point3, Vec3, surface::QuadLayout};
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
                // Equal angles between the planes through the center.
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

/// A plane of 5 x 5 quads of which two neighbors are a pentagon and a triangle, divided three times and smoothed: two vertices of three
/// quads and two of five.
#[must_use]
pub fn pair(height: impl Fn(f64, f64) -> f64) -> QuadLayout {
    let at = |i: usize, j: usize| i + 6 * j;
    let mut points: Vec<[f64; 2]> = (0..36).map(|k| [(k % 6) as f64 - 2.5, (k / 6) as f64 - 2.5]).collect();
    let face = |k: usize| match (k % 5, k / 5) {
        (1, 2) => vec![at(1, 2), at(2, 2), at(3, 3), at(2, 3), at(1, 3)],
        (2, 2) => vec![at(2, 2), at(3, 2), at(3, 3)],
        (i, j) => vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)],
    };
    let mut faces: Vec<Vec<usize>> = (0..25).map(face).collect();
    for _ in 0..3 {
        faces = divided(&mut points, &faces);
        smooth(&mut points, &faces);
    }
    let quads: Vec<[usize; 4]> = faces.iter().map(|face| [face[0], face[1], face[2], face[3]]).collect();
    let points = points.into_iter().map(|[x, y]| Point3::new(x, y, height(x, y))).collect();
    Mesh { points, quads }.layout()
}

fn mean(points: &[[f64; 2]], of: &[usize]) -> [f64; 2] {
    [0, 1].map(|k| of.iter().map(|v| points[*v][k]).sum::<f64>() / of.len() as f64)
}

/// Every face cut into quads from its middle to the middles of its sides.
fn divided(points: &mut Vec<[f64; 2]>, faces: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut middles = std::collections::HashMap::new();
    let mut quads = Vec::new();
    for face in faces {
        let n = face.len();
        let centre = points.len();
        points.push(mean(points, face));
        let mut middle = |points: &mut Vec<[f64; 2]>, a: usize, b: usize| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                points.push(mean(points, &[a, b]));
                points.len() - 1
            })
        };
        let sides: Vec<usize> = (0..n).map(|k| middle(points, face[k], face[(k + 1) % n])).collect();
        quads.extend((0..n).map(|k| vec![face[k], sides[k], centre, sides[(k + n - 1) % n]]));
    }
    quads
}

/// Inner vertices moved to the middle of their neighbors, again and again.
fn smooth(points: &mut [[f64; 2]], quads: &[Vec<usize>]) {
    let mut next = vec![Vec::new(); points.len()];
    for quad in quads {
        (0..4).for_each(|k| next[quad[k]].push(quad[(k + 1) % 4]));
    }
    // Each edge of an inner vertex is there once from it and once to it.
    let is_inner = |v: usize, next: &[Vec<usize>]| next[v].iter().all(|w| next[*w].contains(&v));
    let inner: Vec<usize> = (0..points.len())
        .filter(|v| is_inner(*v, &next) && quads.iter().flatten().filter(|w| *w == v).count() == next[*v].len())
        .collect();
    for _ in 0..200 {
        inner.iter().for_each(|v| points[*v] = mean(points, &next[*v]));
    }
}
