//! Laws of structured grids: rows agree with places one by one, neighbors share nodes, cells are right (`docs/math/volumes.md#structured-grids`).

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::{
    Point3, Vec3,
    surface::{CyclidePatch, CyclidicNet, DupinCyclide},
    volume::{CyclideGrid, CyclideVolume, FineEnd, Grading, ParamVolume, SphericalCube, StructuredGrid, VolumeFrame},
};
use cyclide_testkit::volumes::{cube, deterministic};
use proptest::prelude::*;
use std::collections::HashMap;

fn uniform(cells: usize) -> Vec<f64> {
    Grading::Uniform.places(cells).unwrap()
}

/// The wall of a ring cyclide, closed in both directions.
fn wall() -> Vec<CyclideVolume> {
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap();
    CyclideGrid::of_cyclide(&ring, [4, 4], &[-0.6, -0.2, 0.0]).unwrap().blocks().collect()
}

proptest! {
    #![proptest_config(deterministic(200))]

    /// Points and Jacobians of rows are those of places one by one, within the bound that `VolumeRow` states.
    #[test]
    fn rows_are_the_places_of_the_volume(cube in cube(), t in 0.0..=1.0, u in 0.0..=1.0, count in 0usize..600) {
        let block = CyclideVolume::new(&cube, VolumeFrame::Auto);
        prop_assume!(block.is_ok());
        let block = block.unwrap();
        let s: Vec<f64> = (0..count).map(|i| i as f64 / (count as f64 - 1.0).max(1.0)).collect();
        let mut lanes = vec![f64::NAN; 7 * count];
        let mut lane = lanes.chunks_mut(count.max(1));
        let mut next = || lane.next().unwrap_or_default();
        let (mut alone, mut points) = ([next(), next(), next()], [next(), next(), next()]);
        let jacobians = next();
        let row = block.row([t, u]);
        row.points(&s, alone.each_mut().map(|l| &mut **l));
        row.points_and_jacobians(&s, points.each_mut().map(|l| &mut **l), jacobians);
        let squares = |f: fn(f64, f64) -> f64, start: f64| {
            s.iter().map(|s| block.denominator([*s, t, u]).norm_squared()).fold(start, f)
        };
        let r = squares(f64::max, 0.0) / squares(f64::min, f64::INFINITY);
        let reach = s.iter().map(|s| block.point([*s, t, u]).distance(block.corners()[0])).fold(block.size(), f64::max);
        // The largest sizes of the coefficients of q2(.,u) and q3(.,t), which these sums are not below.
        let [q1, q2, q3] = block.speeds();
        let largest = |q: [[f64; 3]; 3]| q.iter().flatten().fold(0.0_f64, |m, c| m.max(c.abs()));
        let first = {
            let value = |c: [f64; 3], x: f64| (1.0 - x) * (1.0 - x) * c[0] + 2.0 * x * (1.0 - x) * c[1] + x * x * c[2];
            value(q1.map(|row| value(row, u)), t).abs()
        };
        for (i, s) in s.iter().enumerate() {
            let (p, j) = (block.point([*s, t, u]), block.jacobian([*s, t, u]));
            let far = p.to_vec().max_abs().max(block.corners()[0].to_vec().max_abs());
            let bound = 32.0 * f64::EPSILON * r * reach + 2.0 * f64::EPSILON * far;
            for (k, p) in p.to_array().into_iter().enumerate() {
                prop_assert!((points[k][i] - p).abs() <= bound, "{:e} of {bound:e}", points[k][i] - p);
                prop_assert_eq!(points[k][i].to_bits(), alone[k][i].to_bits());
            }
            let squared = block.denominator([*s, t, u]).norm_squared();
            let bound = 64.0 * f64::EPSILON * r * (first / squared) * (largest(q2) / squared) * (largest(q3) / squared);
            prop_assert!((jacobians[i] - j).abs() <= bound, "{:e} of {bound:e}", jacobians[i] - j);
        }
    }

    /// Nodes are points of the block, and lines through them cross at right angles.
    #[test]
    fn nodes_are_orthogonal(cube in cube(), ratio in 0.5..2.0) {
        let block = CyclideVolume::new(&cube, VolumeFrame::Auto);
        prop_assume!(block.is_ok());
        let block = block.unwrap();
        let law = Grading::Geometric { ratio, fine: FineEnd::Start };
        let grid = StructuredGrid::graded(&[block], [5, 4, 3], [law, Grading::Uniform, law]).unwrap();
        let place = block.corners().iter().map(|p| p.to_vec().max_abs()).fold(block.size(), f64::max);
        let [s, t, u] = grid.places().clone();
        for (k, node) in grid.block_nodes(0).enumerate() {
            let at = [s[k % 6], t[k / 6 % 5], u[k / 30]];
            prop_assert!(grid.nodes()[node].distance(block.point(at)) < 1e-12 * place);
        }
        prop_assert!(grid.quality().orthogonality < 1e-13 * place / block.size());
    }
}

/// The volume of a hexahedron by the rule that is exact for trilinear maps.
fn volume_of(p: [Point3; 8]) -> f64 {
    let places = [0.5 - 0.5 / 3.0_f64.sqrt(), 0.5 + 0.5 / 3.0_f64.sqrt()];
    let mut sum = 0.0;
    for s in places {
        for t in places {
            for u in places {
                let weight = |k: usize, d: usize, x: f64| if k >> d & 1 == 1 { x } else { 1.0 - x };
                let along = |d: usize| {
                    (0..8).filter(|k| k >> d & 1 == 0).fold(Vec3::ZERO, |v, k| {
                        let others: f64 = (0..3).filter(|e| *e != d).map(|e| weight(k, e, [s, t, u][e])).product();
                        v + (p[k | 1 << d] - p[k]) * others
                    })
                };
                sum += along(0).cross(along(1)).dot(along(2)) / 8.0;
            }
        }
    }
    sum
}

#[test]
fn a_wall_is_closed_without_gaps() {
    let blocks = wall();
    let exact: f64 = blocks.iter().map(|block| block.measure().volume).sum();
    let mut errors = Vec::new();
    for n in [2, 4, 8] {
        let grid = StructuredGrid::new(&blocks, [uniform(n), uniform(n), uniform(3)]).unwrap();
        assert_eq!((grid.nodes().len(), grid.cell_count()), (16 * n * n * 7, 32 * n * n * 3));
        // Every side of a cell has two cells, but on the skin, inside and outside.
        let mut faces: HashMap<[usize; 4], usize> = HashMap::new();
        let mut volume = 0.0;
        for nodes in grid.cells() {
            for face in [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 4, 5], [2, 3, 6, 7], [0, 2, 4, 6], [1, 3, 5, 7]] {
                let mut key = face.map(|k| nodes[k]);
                key.sort_unstable();
                *faces.entry(key).or_default() += 1;
            }
            volume += volume_of(nodes.map(|k| grid.nodes()[k]));
        }
        assert!(faces.values().all(|&count| count <= 2));
        assert_eq!(faces.values().filter(|&&count| count == 1).count(), 2 * 16 * n * n);
        let quality = grid.quality();
        assert!(quality.orthogonality < 1e-13 && quality.inverted == 0 && quality.collapsed == 0, "{quality:?}");
        errors.push((volume - exact).abs() / exact);
    }
    // Straight sides are off by the square of their length.
    assert!(errors[0] / errors[1] > 3.5 && errors[1] / errors[2] > 3.7 && errors[2] < 0.02, "{errors:?}");
}

#[test]
fn nodes_are_shared_but_not_between_arcs_with_the_same_ends() {
    let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z]).unwrap();
    let block = |v1: Vec3, v2: Vec3| CyclideVolume::new(&cube, VolumeFrame::First(v1, v2)).unwrap();
    let (straight, bent) = (block(Vec3::X, Vec3::Y), block(Vec3::new(1.0, 0.2, 0.0), Vec3::new(-0.2, 1.0, 0.0)));
    let nodes = |blocks: &[CyclideVolume]| {
        StructuredGrid::new(blocks, [uniform(2), uniform(2), uniform(2)]).unwrap().nodes().len()
    };
    // Only the node inside is not shared.
    assert_eq!(nodes(&[straight, straight]), 28);
    // Sides along z have no bend in either; all others, and all faces, are apart.
    assert_eq!(nodes(&[straight, bent]), 27 + 27 - 8 - 4);
}

#[test]
fn cells_are_right_handed_and_folds_are_counted() {
    let sides = [Vec3::Y * 2.0, Vec3::X, Vec3::Z * 0.5];
    let left = CyclideVolume::new(&SphericalCube::cuboid(Point3::ORIGIN, sides).unwrap(), VolumeFrame::Auto).unwrap();
    let grid = StructuredGrid::new(&[left], [uniform(2), uniform(1), uniform(1)]).unwrap();
    let quality = grid.quality();
    assert!((quality.scaled_jacobian - 1.0).abs() < 1e-15 && (quality.aspect_ratio - 2.0).abs() < 1e-14);
    assert!((quality.shortest_side - 0.5).abs() < 1e-15 && quality.inverted == 0);
    assert!(grid.jacobians(0).iter().all(|j| (j + 1.0).abs() < 1e-14)); // -2 x 1 x 1/2
    let frame = VolumeFrame::First(Vec3::new(0.0, 0.1, 1.0), Vec3::new(0.0, -1.0, 0.1));
    let folded =
        CyclideVolume::new(&SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X, Vec3::Y, Vec3::Z]).unwrap(), frame);
    let quality = StructuredGrid::new(&[folded.unwrap()], [uniform(8), uniform(8), uniform(8)]).unwrap().quality();
    assert!(quality.inverted > 0 && quality.first_inverted.is_some() && quality.scaled_jacobian < 0.0, "{quality:?}");
}

#[test]
fn first_cells_are_as_high_as_asked() {
    let blocks = wall();
    for (axis, at_end) in [(0, false), (1, true), (2, true)] {
        let share = StructuredGrid::share_of_height(&blocks, axis, at_end, 0.01).unwrap();
        let fine = if at_end { FineEnd::End } else { FineEnd::Start };
        let law = Grading::geometric_from_first(share, 20, fine).unwrap();
        let mut places = [uniform(1), uniform(1), uniform(1)];
        places[axis] = law.places(20).unwrap();
        let grid = StructuredGrid::new(&blocks, places).unwrap();
        let first = if at_end { 19 } else { 0 };
        let heights = (0..grid.cell_count()).filter(|&cell| grid.cell_place(cell).1[axis] == first).flat_map(|cell| {
            let nodes = grid.cell(cell);
            (0..8).filter(move |k| k >> axis & 1 == 0).map(move |k| [nodes[k], nodes[k | 1 << axis]])
        });
        let heights: Vec<f64> = heights.map(|[a, b]| grid.nodes()[a].distance(grid.nodes()[b])).collect();
        let highest = heights.iter().copied().fold(0.0, f64::max);
        // Chords are shorter than arcs by a few millionths of them.
        assert!(highest < 0.01 * (1.0 + 1e-12) && highest > 0.01 * (1.0 - 1e-5), "{axis}: {highest}");
    }
    let error = StructuredGrid::share_of_height(&blocks, 2, false, 0.3).unwrap_err();
    assert_eq!(error.reason(), "parameter-out-of-range");
}

#[test]
fn sides_of_one_point_are_one_node() {
    // The outer part of a spindle, inwards: at its nodes sides of the skin are points.
    let spindle = DupinCyclide::new(3.0, 0.0, 3.5).unwrap();
    let grid = CyclideGrid::of_cyclide(&spindle, [4, 6], &[-0.3, 0.0]).unwrap();
    let blocks: Vec<CyclideVolume> = grid.blocks().collect();
    let made = StructuredGrid::new(&blocks, [uniform(3), uniform(3), uniform(2)]).unwrap();
    let quality = made.quality();
    assert!(quality.collapsed > 0 && quality.inverted == 0 && quality.orthogonality < 1e-12, "{quality:?}");
    let bodies = CyclideVolume::outer_bodies(&blocks).unwrap();
    assert!(bodies.len() == 1 && bodies[0].is_solid());
    let exact: f64 = blocks.iter().map(|block| block.measure().volume).sum();
    // A hollow that touches the skin in its two nodes.
    let volume = bodies[0].shells().map(cyclide::topology::Shell::volume).sum::<f64>();
    assert!((volume - exact).abs() < 1e-9 * exact, "{volume} {exact}"); // quadratures of both
}

/// An eighth of a shell about the origin, whose face at the pole of the sphere is a line, with its directions in this order.
fn wedge(order: [usize; 3]) -> CyclideVolume {
    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
    let octant = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
    let layer = CyclideGrid::layers(&CyclidicNet::from(octant), &[0.0, 0.1]).unwrap();
    layer.block([0, 0, 0]).permuted(order).unwrap()
}

#[test]
fn a_face_that_is_a_line_has_the_nodes_of_a_side() {
    let exact = (1.1_f64.powi(3) - 1.0) * std::f64::consts::PI / 6.0; // of an eighth of a ball
    for order in [[0, 1, 2], [1, 0, 2], [2, 0, 1], [1, 2, 0], [0, 2, 1], [2, 1, 0]] {
        let block = wedge(order);
        let grid = StructuredGrid::new(&[block], [uniform(4), uniform(4), uniform(4)]).unwrap();
        let quality = grid.quality();
        // 5 x 5 x 5 nodes, but of five along the line one each; the cells along it are collapsed.
        assert_eq!((grid.nodes().len(), quality.inverted, quality.collapsed), (105, 0, 16), "{order:?}");
        // Angles of triangles at the pole: half of 180 less 22.5 degrees, and the bend.
        assert!(quality.scaled_jacobian > 0.95 && quality.aspect_ratio < 20.0, "{quality:?}");
        // Five faces, nine sides, and the axis once.
        let body = block.to_body().unwrap();
        let counts = (body.outer.faces().len(), body.outer.edges().len(), body.outer.vertices().len());
        assert!(counts == (5, 9, 6) && body.is_solid(), "{counts:?}");
        assert!((body.outer.volume() - exact).abs() < 1e-9 * exact, "quadrature of the faces");
        let outer = CyclideVolume::outer_bodies(&[block]).unwrap();
        assert!(outer.len() == 1 && outer[0].is_solid() && outer[0].outer.faces().len() == 5);
    }
}

#[test]
fn rounding_at_points_is_no_fold() {
    // The inner skin has one node, in which sides across the tube are one point.
    let outer = DupinCyclide::new(4.0, 1.0, 2.0).unwrap();
    let blocks: Vec<_> = CyclideGrid::of_cyclide(&outer, [4, 4], &[-1.0, 0.0]).unwrap().blocks().collect();
    for cells in 1..=9 {
        let quality = StructuredGrid::new(&blocks, [uniform(cells), uniform(cells), uniform(cells)]).unwrap().quality();
        assert!(
            quality.inverted == 0 && quality.collapsed > 0 && quality.scaled_jacobian > 0.3,
            "{cells}: {quality:?}"
        );
    }
}

/// A horn torus and a torus inside it: where the hole is a point the blocks end in the plane of the ring.
#[test]
fn sides_that_shrink_to_the_middle_of_a_horn_torus_are_no_edges() {
    let horn = DupinCyclide::new(4.0, 0.0, 4.0).unwrap();
    let blocks: Vec<_> = CyclideGrid::of_cyclide(&horn, [4, 4], &[-2.0, 0.0]).unwrap().blocks().collect();
    let exact = 2.0 * std::f64::consts::PI.powi(2) * 4.0 * (16.0 - 4.0);
    let volume: f64 = blocks.iter().map(|block| block.to_body().unwrap().outer.volume()).sum();
    assert!((volume - exact).abs() < 1e-9 * exact, "{volume} {exact}");
    let skin = CyclideVolume::outer_bodies(&blocks).unwrap();
    let volume: f64 = skin.iter().flat_map(|body| body.shells()).map(cyclide::topology::Shell::volume).sum();
    assert!(skin.len() == 1 && skin[0].voids.len() == 1 && (volume - exact).abs() < 1e-9 * exact, "{volume}");
    // A spindle: of the blocks at its nodes one side is a point.
    let spindle = DupinCyclide::new(4.0, 1.0, 4.5).unwrap();
    let blocks: Vec<_> = CyclideGrid::of_cyclide(&spindle, [4, 4], &[-1.5, 0.0]).unwrap().blocks().collect();
    let bodies: Vec<_> = blocks.iter().map(|block| block.to_body().unwrap().outer).collect();
    assert!(bodies.iter().any(|shell| shell.vertices().len() == 7));
    for (shell, block) in bodies.iter().zip(&blocks) {
        assert!(shell.is_closed() && shell.edges().len() == shell.vertices().len() + 4); // Euler: six faces
        assert!(shell.edges().iter().all(|edge| edge.curve.start().distance(edge.curve.end()) > 0.1));
        let volume = block.measure().volume;
        assert!((shell.volume() - volume).abs() < 1e-8 * volume, "{} {volume}", shell.volume());
    }
}

#[test]
fn what_folds_bounds_no_solid() {
    let cube = SphericalCube::cuboid(Point3::ORIGIN, [Vec3::X * 2.0, Vec3::Y * 3.0, Vec3::Z]).unwrap();
    let block = |frame| CyclideVolume::new(&cube, frame).unwrap();
    let folded = block(VolumeFrame::First(Vec3::Y, Vec3::Z));
    let error = CyclideVolume::outer_bodies(&[block(VolumeFrame::Auto), folded]).unwrap_err();
    assert_eq!(error.reason(), "folded-volume");
    assert!(error.to_string().starts_with("block 1: lines of the volume run backwards near s = "), "{error}");
}

#[test]
fn the_outer_boundary_of_a_wall_is_two_skins() {
    let blocks = wall();
    let exact: f64 = blocks.iter().map(|block| block.measure().volume).sum();
    let bodies = CyclideVolume::outer_bodies(&blocks).unwrap();
    let [body] = bodies.as_slice() else { panic!("{} bodies", bodies.len()) };
    assert!(body.is_solid() && body.voids.len() == 1);
    let volume = body.shells().map(cyclide::topology::Shell::volume).sum::<f64>();
    assert!((volume - exact).abs() < 1e-9 * exact, "{volume} {exact}");
    // Two boxes apart are two solids, a box of eight blocks is one with 24 faces.
    let block = |x: f64, y: f64, z: f64| {
        let cube = SphericalCube::cuboid(Point3::new(x, y, z), [Vec3::X, Vec3::Y, Vec3::Z]).unwrap();
        CyclideVolume::new(&cube, VolumeFrame::Auto).unwrap()
    };
    assert_eq!(CyclideVolume::outer_bodies(&[block(0.0, 0.0, 0.0), block(3.0, 0.0, 0.0)]).unwrap().len(), 2);
    let eight: Vec<CyclideVolume> =
        (0..8).map(|k| block(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2))).collect();
    let bodies = CyclideVolume::outer_bodies(&eight).unwrap();
    assert!(bodies.len() == 1 && bodies[0].outer.faces().len() == 24);
    assert!((bodies[0].outer.volume() - 8.0).abs() < 1e-12);
}

#[test]
fn what_is_no_grid_is_named() {
    let blocks = wall();
    let reason = |places| StructuredGrid::new(&blocks, places).unwrap_err().reason();
    assert_eq!(reason([vec![0.0], uniform(2), uniform(2)]), "too-few-points");
    assert_eq!(reason([vec![0.0, 0.9], uniform(2), uniform(2)]), "parameter-out-of-range");
    assert_eq!(reason([vec![0.0, 0.5, 0.5, 1.0], uniform(2), uniform(2)]), "parameters-not-increasing");
    assert_eq!(reason([uniform(1000), uniform(1000), uniform(2)]), "too-many-pieces");
    assert_eq!(StructuredGrid::new(&[], [uniform(1), uniform(1), uniform(1)]).unwrap_err().reason(), "too-few-points");
    // Layers past the tube's middle, and with nothing in between.
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap();
    let refused = |distances: &[f64]| CyclideGrid::of_cyclide(&ring, [4, 4], distances).unwrap_err();
    assert_eq!(refused(&[0.0, f64::NAN]).reason(), "not-finite");
    assert_eq!(refused(&[0.0, 1.0, 0.5]).reason(), "parameters-not-increasing");
    let error = refused(&[-1.7, 0.0]);
    assert!(error.reason() == "offset-not-regular" && error.index().is_some(), "{error}");
    // The smallest radius of the tube is mu - c.
    assert!(error.to_string().contains("-1"), "{error}");
}
