//! Nets over part of a rectangle of quads: a border in steps, openings.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use cyclide::{
    Error, Point3, Vec3,
    conformal::{Conformal as _, Mobius},
    error::{GridCellFault, GridError},
    surface::{CyclidicNet, DupinCyclide, GridCell, NetFrame, ParamSurface as _, QuadGrid},
    topology::{Body, surface_joints},
    volume::{CyclideGrid, CyclideVolume},
};

/// Quads along s and t.
const SIZE: [usize; 2] = [9, 7];

/// What the quads are: corners cut off in steps, and an opening of two.
fn cell(i: usize, j: usize) -> GridCell {
    match (i, j) {
        (0..=2, 0) | (0, 1) | (7..=8, 5..) | (8, 4) => GridCell::Outside,
        (4..=5, 3) => GridCell::Opening,
        _ => GridCell::Patch,
    }
}

/// A part of a ring cyclide in quads, and its frame at the first vertex of a quad.
fn ring() -> CyclidicNet {
    DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([16, 16]).unwrap().remove(0)
}

fn points(net: &CyclidicNet) -> Vec<Point3> {
    let [m, n] = SIZE.map(|n| n + 1);
    (0..m * n).map(|k| net.grid().point(k % m + 2, k / m + 1)).collect()
}

fn in_steps(points: Vec<Point3>) -> QuadGrid {
    QuadGrid::new(points, SIZE.map(|n| n + 1), [false; 2]).unwrap().with_cells(cell).unwrap()
}

/// The net of the part, whose first vertex is that of quad (3, 0).
fn net() -> CyclidicNet {
    let ring = ring();
    let [v1, v2, _] = ring.vertex_frame(5, 1);
    CyclidicNet::new(in_steps(points(&ring)), NetFrame::First(v1, v2)).unwrap()
}

fn kept() -> impl Iterator<Item = [usize; 2]> {
    let all = (0..SIZE[1]).flat_map(|j| (0..SIZE[0]).map(move |i| [i, j]));
    all.filter(|[i, j]| cell(*i, *j) == GridCell::Patch)
}

#[test]
fn patches_are_those_of_the_whole() {
    let (ring, net) = (ring(), net());
    let with_patches: Vec<_> = net.patches().collect();
    assert_eq!(with_patches.len(), kept().count());
    for ([i, j], patch) in kept().zip(&with_patches) {
        let whole = ring.patch(i + 2, j + 1);
        for (s, t) in [(0.3, 0.6), (0.0, 0.5), (1.0, 1.0)] {
            // The same surface; weights may run at other speeds, corners are the same.
            let (_, off) = (patch.point(s, t), ring_distance(patch.point(s, t)));
            assert!(off < 1e-13, "({i}, {j}): {off}");
            let turned = patch.normal(s, t).unwrap().angle(normal_of_ring(patch.point(s, t)));
            assert!(turned < 1e-7, "({i}, {j}): {turned}");
        }
        assert_eq!(patch.corners(), whole.corners());
    }
    let shell = net.to_shell().unwrap();
    assert_eq!(shell.faces().len(), kept().count());
    // Angles of normals that agree to rounding.
    assert!(surface_joints(&shell).iter().all(|joint| joint.angle < 1e-7 && joint.gap < 1e-13));
}

/// How far a point is from the ring with a = 4, c = 1, mu = 2, by its equation.
fn ring_distance(p: Point3) -> f64 {
    let (value, gradient) = ring_equation(p);
    (value / gradient.length()).abs()
}

fn normal_of_ring(p: Point3) -> Vec3 {
    ring_equation(p).1
}

fn ring_equation(p: Point3) -> (f64, Vec3) {
    let (a, c, mu, b2) = (4.0, 1.0, 2.0, 15.0);
    let (q, x) = (p.to_vec().length_squared() + b2 - mu * mu, a * p.x - c * mu);
    let value = q * q - 4.0 * x * x - 4.0 * b2 * p.y * p.y;
    let gradient = p.to_vec() * (4.0 * q) - Vec3::new(8.0 * a * x, 8.0 * b2 * p.y, 0.0);
    (value, gradient)
}

/// The frame that is fitted is that of the ring, wherever it starts.
#[test]
fn the_frame_is_fitted_from_what_is_there() {
    let ring = ring();
    let auto = CyclidicNet::new(in_steps(points(&ring)), NetFrame::Auto).unwrap();
    assert!(auto.singular_patches().is_empty());
    let far = auto.patches().map(|patch| ring_distance(patch.point(0.5, 0.5))).fold(0.0, f64::max);
    // Tangents of circles are exact: rounding.
    assert!(far < 1e-13, "{far}");
}

/// The corners of what is outside may be anywhere.
#[test]
fn what_is_outside_does_not_matter() {
    let given = points(&ring());
    let has = |i: usize, j: usize| i < SIZE[0] && j < SIZE[1] && cell(i, j) != GridCell::Outside;
    let used = |k: usize| {
        let (i, j) = (k % (SIZE[0] + 1), k / (SIZE[0] + 1));
        has(i, j) || (i > 0 && has(i - 1, j)) || (j > 0 && has(i, j - 1)) || (i > 0 && j > 0 && has(i - 1, j - 1))
    };
    let missing: Vec<Option<Point3>> = given.iter().enumerate().map(|(k, p)| used(k).then_some(*p)).collect();
    assert_eq!(missing.iter().filter(|p| p.is_none()).count(), 9);
    let grid = QuadGrid::of_cells(&missing, SIZE.map(|n| n + 1), cell).unwrap();
    let made = CyclidicNet::new(grid, NetFrame::Auto).unwrap();
    let whole = CyclidicNet::new(in_steps(given), NetFrame::Auto).unwrap();
    for (a, b) in made.patches().zip(whole.patches()) {
        // Lengths of weights are means over all vertices: places move along the same patch.
        assert!(a.point(0.5, 0.0).distance(b.point(0.5, 0.0)) < 1e-13);
        assert_eq!(a.corners(), b.corners());
    }
    let without = QuadGrid::of_cells(&missing, SIZE.map(|n| n + 1), |_, _| GridCell::Patch).unwrap_err();
    assert_eq!(without, Error::Grid(GridError::CellsUnfit { fault: GridCellFault::NoPoint, index: 0 }));
}

/// Vertices less edges plus faces: 2 of a ball, 0 of a ring.
fn characteristic(body: &Body) -> i64 {
    let shell = &body.outer;
    shell.vertices().len() as i64 - shell.edges().len() as i64 + shell.faces().len() as i64
}

#[test]
fn a_thick_one_is_closed_round_its_opening() {
    let net = net();
    for h in [0.3, -0.2] {
        let body = net.thick(h).unwrap();
        assert!(body.voids.is_empty() && body.outer.is_closed() && characteristic(&body) == 0);
        // Steiner: the volume between parallel surfaces is the integral of (A(x) over x), a quadratic, so Simpson is exact.
        let area = |x: f64| {
            if x == 0.0 { net.to_shell().unwrap().area() } else { net.offset(x).unwrap().to_shell().unwrap().area() }
        };
        let simpson = h.abs() / 6.0 * (area(0.0) + 4.0 * area(0.5 * h) + area(h));
        let volume = body.outer.volume();
        // The quadrature of areas goes to 1e-10 or so.
        assert!((volume - simpson).abs() < 1e-9 * simpson, "{volume} {simpson}");
    }
}

#[test]
fn images_keep_the_steps() {
    let net = net();
    let map = Mobius::inversion(Point3::new(1.0, 9.0, 4.0), 5.0).unwrap();
    let image = net.transformed(&map).unwrap();
    assert_eq!((image.grid().cell(4, 3), image.grid().cell(0, 0)), (GridCell::Opening, GridCell::Outside));
    for (patch, image) in net.patches().zip(image.patches()) {
        let expected = map.map_point(patch.point(0.4, 0.7)).unwrap();
        // A few roundings of coordinates below 10.
        assert!(image.point(0.4, 0.7).distance(expected) < 1e-13);
    }
    assert!(net.grid().seams().is_empty());
}

#[test]
fn layers_are_over_all_patches_and_share_faces() {
    let net = net();
    let distances = [-0.02, 0.0, 0.05];
    let layers = CyclideGrid::layers(&net, &distances).unwrap();
    assert_eq!(layers.blocks().count(), 2 * net.patches_with_quads().count());
    let [m, n, _] = layers.size();
    let mut shared = 0;
    for (i, j) in (0..n).flat_map(|j| (0..m).map(move |i| (i, j))) {
        assert_eq!(layers.has_block([i, j, 1]), net.grid().cell(i, j) == GridCell::Patch);
        for (axis, next) in [[i + 1, j, 1], [i, j + 1, 1], [i, j, 0]].into_iter().enumerate() {
            if layers.has_block([i, j, 1]) && layers.has_block(next) {
                let end = usize::from(axis < 2);
                let faces = [layers.block([i, j, 1]), layers.block(next)].map(|block| block.faces());
                let (own, other) = (faces[0][2 * axis + end], faces[1][2 * axis + 1 - end]);
                assert_eq!((own.corners(), own.weights()), (other.corners(), other.weights()));
                shared += 1;
            }
        }
    }
    assert!(shared > 2 * net.patches_with_quads().count());
    // As many blocks as figures that are known to 1e-12.
    for (h, layer) in [(-0.02, 0), (0.05, 1)] {
        let of_layer = layers.blocks().skip(layer * layers.blocks().count() / 2).take(layers.blocks().count() / 2);
        let sum: f64 = of_layer.map(|block| block.measure().volume).sum();
        let solid = net.thick(h).unwrap().outer.volume();
        assert!((sum / solid - 1.0).abs() < 1e-9, "{sum} {solid}");
    }
    // Both layers together have the boundary of one solid, with the openings through it.
    let blocks: Vec<_> = layers.blocks().collect();
    let bodies = CyclideVolume::outer_bodies(&blocks).unwrap();
    assert!(bodies.len() == 1 && bodies[0].is_solid() && bodies[0].voids.is_empty());
}

mod circular {
    use super::*;
    use cyclide::error::GridError;
    use cyclide_grids::{Border, CircularMeshOptions, make_circular};

    /// A saddle whose grid runs along its lines of curvature, not circular by far.
    fn saddle() -> QuadGrid {
        let [m, n] = SIZE.map(|n| n + 1);
        let place = |k: usize| (0.2 * (k % m) as f64 - 0.9, 0.2 * (k / m) as f64 - 0.7);
        let points = (0..m * n).map(place).map(|(x, y)| Point3::new(x + 0.1 * x * y, y, 0.3 * (x * x - y * y)));
        in_steps(points.collect())
    }

    fn made(options: &CircularMeshOptions<'_>) -> cyclide_grids::CircularMesh {
        make_circular(&saddle(), options).unwrap()
    }

    #[test]
    fn quads_of_the_part_are_made_circular() {
        let free = made(&CircularMeshOptions::default());
        assert!(free.report.residual_before > 1e-3 && free.report.residual_after < 1e-12);
        let net = CyclidicNet::new(free.grid.clone(), NetFrame::Auto).unwrap();
        assert!(net.singular_patches().is_empty());
        let joints = surface_joints(&net.to_shell().unwrap());
        assert!(joints.iter().all(|joint| joint.angle < 1e-7));
        // The first corner is no corner of a quad, and stays.
        assert_eq!(free.grid.point(0, 0), saddle().point(0, 0));
        // Less is asked for than of the whole, which moves no less.
        let whole = QuadGrid::new(saddle().points().to_vec(), SIZE.map(|n| n + 1), [false; 2]).unwrap();
        let whole = make_circular(&whole, &CircularMeshOptions::default()).unwrap();
        assert!(free.report.moves.max < 1.2 * whole.report.moves.max);
    }

    #[test]
    fn a_border_in_steps_may_be_held() {
        let options = CircularMeshOptions { border: Border::Pinned, allow_shape_change: true, ..Default::default() };
        match make_circular(&saddle(), &options) {
            Ok(mesh) => {
                // The inward corner of the steps at the first row, and one of its border.
                for (i, j) in [(3, 0), (3, 1), (1, 1), (9, 4), (5, 0)] {
                    assert_eq!(mesh.grid.point(i, j), saddle().point(i, j), "({i}, {j})");
                }
                assert_ne!(mesh.grid.point(4, 2), saddle().point(4, 2));
            }
            // Held all round there may be no such grid.
            Err(error) => assert_eq!(error.reason(), "not-converged"),
        }
        let curve = cyclide::curve::Arc::segment(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0)).unwrap();
        let border = Border::OnCurves([Some(&curve), None, None, None]);
        let options = CircularMeshOptions { border, ..CircularMeshOptions::default() };
        let refused = make_circular(&saddle(), &options).unwrap_err();
        assert_eq!(refused, Error::Grid(GridError::CellsUnfit { fault: GridCellFault::Curves, index: 0 }));
    }
}
