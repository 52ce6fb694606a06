//! Nets to test, and measures of them.

use cyclide::{
    Point3, Vec3,
    conformal::Mobius,
    surface::{CyclidicNet, DupinCyclide, NetFrame, ParamSurface, QuadGrid},
};
use std::f64::consts::TAU;

/// Parameters `(a, c, mu)`: rings near every limit, a torus, horns, spindles, both with one node.
pub(crate) const RINGS: [[f64; 3]; 5] =
    [[1.0, 0.35, 0.6], [3.0, 0.0, 1.0], [2.0, 1.9, 1.95], [10.0, 2.0, 2.001], [1e4, 3e3, 9.99e3]];
pub(crate) const HORNS: [[f64; 3]; 4] = [[1.0, 0.5, 0.2], [2.0, 1.5, 0.0], [1.0, 0.5, 0.5], [5.0, 4.0, 3.99]];
pub(crate) const SPINDLES: [[f64; 3]; 4] = [[1.0, 0.3, 1.2], [1.0, 0.0, 1.5], [1.0, 0.5, 1.0], [2.0, 1.8, 20.0]];

/// The point of a cyclide in its own frame at the angles `(th, ps)`, by
/// `docs/math/cyclides-and-nets.md#cyclides-by-parameters`.
pub(crate) fn closed_form([a, c, mu]: [f64; 3], th: f64, ps: f64) -> Point3 {
    let b2 = (a - c) * (a + c);
    let b = b2.sqrt();
    let ((st, ct), (sp, cp)) = (th.sin_cos(), ps.sin_cos());
    let den = a - c * ct * cp;
    let p = [mu * (c - a * ct * cp) + b2 * ct, b * st * (a - mu * cp), b * sp * (c * ct - mu)];
    Point3::from(p.map(|x| x / den))
}

/// A part of a ring cyclide as a grid in lines of curvature, unevenly spaced.
pub(crate) fn cyclide_grid(parameters: [f64; 3], size: [usize; 2], closed: [bool; 2]) -> QuadGrid {
    let angle = |k: usize, d: usize| {
        let x = k as f64 / if closed[d] { size[d] as f64 } else { 1.6 * size[d] as f64 };
        TAU * (x + 0.03 * (TAU * x).sin()) + 0.2
    };
    let places = (0..size[1]).flat_map(|j| (0..size[0]).map(move |i| (i, j)));
    let points = places.map(|(i, j)| closed_form(parameters, angle(i, 0), angle(j, 1))).collect();
    QuadGrid::new(points, size, closed).unwrap()
}

/// The image of a grid under the inversion in a sphere off the surface.
pub(crate) fn inverted(grid: &QuadGrid, center: Point3, radius: f64) -> QuadGrid {
    let map = Mobius::inversion(center, radius).unwrap();
    let points = grid.points().iter().map(|p| map.map_point(*p).unwrap()).collect();
    QuadGrid::new(points, grid.size(), grid.closed()).unwrap()
}

/// A generic circular grid that lies on no cyclide: two curves of points, and every further vertex on the circle of
/// its three predecessors, where that is nearest to the parallelogram.
pub(crate) fn generic_grid(size: [usize; 2]) -> QuadGrid {
    let [m, n] = size;
    let mut points = vec![Point3::ORIGIN; m * n];
    for (i, p) in points[..m].iter_mut().enumerate() {
        let x = i as f64;
        *p = Point3::new(x, 0.15 * (0.7 * x).sin(), 0.4 * (0.35 * x).sin());
    }
    for j in 1..n {
        let y = j as f64;
        points[j * m] = Point3::new(0.2 * (0.5 * y).sin(), y, 0.6 * (0.3 * y).cos() - 0.6);
        for i in 1..m {
            let [a0, a1, a2] = [points[i - 1 + (j - 1) * m], points[i + (j - 1) * m], points[i - 1 + j * m]];
            let inverse = |p: Point3| (p - a0) / -(p - a0).length_squared();
            let (b1, b2) = (inverse(a1), inverse(a2));
            let wanted = inverse(a1 + (a2 - a0));
            let x = ((wanted - b1).dot(b2 - b1) / (b2 - b1).length_squared()).clamp(0.2, 0.8);
            let b3 = b1 + (b2 - b1) * x;
            points[i + j * m] = a0 + b3 * (-1.0 / b3.length_squared());
        }
    }
    QuadGrid::new(points, size, [false; 2]).unwrap()
}

/// Nets of all kinds: open, closed in one direction, closed in both; on a cyclide, inverted, generic.
pub(crate) fn nets() -> Vec<(&'static str, CyclidicNet)> {
    let ring = [2.0, 0.7, 1.1];
    let center = Point3::new(0.4, 0.5, 2.6);
    let auto = |grid| CyclidicNet::new(grid, NetFrame::Auto).unwrap();
    vec![
        ("open part of a cyclide", auto(cyclide_grid(ring, [9, 7], [false; 2]))),
        ("inverted strip closed along s", auto(inverted(&cyclide_grid(ring, [10, 5], [true, false]), center, 1.5))),
        ("strip closed along t, odd", auto(cyclide_grid(ring, [4, 7], [false, true]))),
        ("inverted ring", auto(inverted(&cyclide_grid(ring, [8, 9], [true, true]), center, 1.5))),
        ("generic", auto(generic_grid([8, 6]))),
        ("closed form ring", DupinCyclide::new(2.0, 0.7, 1.1).unwrap().nets([4, 4]).unwrap().remove(0)),
    ]
}

/// Places in a patch.
pub(crate) const PLACES: [f64; 5] = [0.0, 0.21, 0.5, 0.83, 1.0];

/// Largest angle between the normals of neighboring patches on their common edges, radians.
pub(crate) fn kink(net: &CyclidicNet) -> f64 {
    joints(net).map(|([n0, n1], _)| n0.angle(n1)).fold(0.0, f64::max)
}

/// Largest distance between equal parameters on the two sides of common edges.
pub(crate) fn gap(net: &CyclidicNet) -> f64 {
    joints(net).map(|(_, [p0, p1])| p0.distance(p1)).fold(0.0, f64::max)
}

/// Normals and points on both sides at places of all inner edges.
fn joints(net: &CyclidicNet) -> impl Iterator<Item = ([Vec3; 2], [Point3; 2])> {
    let ([m, n], closed) = (net.size(), net.grid().closed());
    let pairs = (0..m * n).flat_map(move |quad| {
        let (i, j) = (quad % m, quad / m);
        let along_s = (closed[0] || i + 1 < m).then_some(((i + 1) % m, j, true));
        let along_t = (closed[1] || j + 1 < n).then_some((i, (j + 1) % n, false));
        [along_s, along_t].into_iter().flatten().map(move |next| ((i, j), next))
    });
    pairs.flat_map(move |((i, j), (i1, j1, right))| {
        let (here, there) = (net.patch(i, j), net.patch(i1, j1));
        PLACES.map(|x| {
            let (p, q) = if right { ((1.0, x), (0.0, x)) } else { ((x, 1.0), (x, 0.0)) };
            ([here.unit_normal(p.0, p.1), there.unit_normal(q.0, q.1)], [here.point(p.0, p.1), there.point(q.0, q.1)])
        })
    })
}
