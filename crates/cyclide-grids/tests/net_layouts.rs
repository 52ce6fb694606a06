//! Laws of nets round extraordinary vertices: they close without a crease, hang together along shared arcs with one parameter, and keep
//! the shape where it allows them.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use cyclide::{
    Error, Point3, Vec3,
    conformal::{Conformal, Mobius},
    error::GridError,
    surface::{CyclidicNet, NetLayout, ParamSurface, QuadLayout},
    topology::surface_joints,
    volume::{CyclideGrid, CyclideVolume, FineEnd, Grading, StructuredGrid},
};
use cyclide_grids::{CircularMeshOptions, make_layout_circular};
use cyclide_testkit::layouts::{ball, cap, pair};

fn made(layout: &QuadLayout) -> NetLayout {
    let made = make_layout_circular(layout, &CircularMeshOptions::default()).unwrap();
    assert!(made.report.residual_after < 1e-12 && made.report.rejected_quads.is_empty());
    let round = made.report.round.unwrap();
    // A product of unit quaternions along a walk of less than 100 edges.
    assert!(round.angle_after < 1e-11, "{round:?}");
    NetLayout::new(made.layout).unwrap()
}

/// The largest angle between faces at their edges.
fn crease(net: &NetLayout) -> f64 {
    surface_joints(&net.to_shell().unwrap()).iter().map(|joint| joint.angle).fold(0.0, f64::max)
}

#[test]
fn caps_close_without_a_crease() {
    for sectors in [3, 5, 6, 7] {
        let dome = cap(sectors, 5, |x, y| -0.3 * (x * x + y * y));
        let report = make_layout_circular(&dome, &CircularMeshOptions::default()).unwrap().report;
        // Some tenths of an edge: the sectors are bent squares.
        assert!(report.moves.max < 0.5 * report.median_edge, "{sectors}: {report:?}");
        assert!(report.round.unwrap().angle_before > 0.1);
        let net = made(&dome);
        let shell = net.to_shell().unwrap();
        assert_eq!(shell.faces().len(), sectors * 24);
        // Frames carried over twenty edges.
        assert!(crease(&net) < 1e-9, "{sectors}: {}", crease(&net));
        assert!(net.nets().iter().all(|net| net.singular_patches().is_empty()));
        // All normals look the same way.
        assert!(net.nets().iter().all(|net| net.patches().all(|patch| patch.unit_normal(0.5, 0.5).z > 0.5)));
    }
}

#[test]
fn monkey_saddle_follows_its_lines_of_curvature() {
    // Its umbilic has index -1/2: six sectors are its lines of curvature.
    let saddle = cap(6, 6, |x, y| 0.2 * (x * x * x - 3.0 * x * y * y));
    let report = make_layout_circular(&saddle, &CircularMeshOptions::default()).unwrap().report;
    // At the corners of the border, along the surface.
    assert!(report.moves.max < 0.5 * report.median_edge, "{report:?}");
    assert!(report.moves.max_off_surface < 0.02 * report.median_edge, "{report:?}");
    assert!(report.angle_after.unwrap().median < 0.01, "{report:?}");
    assert!(crease(&made(&saddle)) < 1e-9);
}

#[test]
fn ball_with_eight_corners() {
    // Its lines cross at 120 degrees in the corners: with the other sign of the product frames would turn once more round them.
    for (k, bulge) in [(6, 0.0), (7, 0.0), (8, 0.0), (9, 0.0), (6, 0.1)] {
        let net = made(&ball(k, bulge));
        assert_eq!((net.nets().len(), net.layout().round().len()), (6, 8));
        assert!(crease(&net) < 1e-9, "{k} {bulge}: {}", crease(&net));
        let shell = net.to_shell().unwrap();
        assert_eq!(shell.faces().len(), 6 * (k * k - 4));
        // One piece of a sphere with eight openings.
        let characteristic = shell.vertices().len() as i64 + shell.faces().len() as i64 - shell.edges().len() as i64;
        assert_eq!(characteristic, 2 - 8);
        // Outwards everywhere.
        let outwards = |net: &CyclidicNet| {
            net.patches().all(|patch| patch.unit_normal(0.5, 0.5).dot(patch.point(0.5, 0.5).to_vec()) > 0.5)
        };
        assert!(net.nets().iter().all(outwards), "{k}");
    }
}

#[test]
fn offsets_and_solids_hang_together() {
    let net = made(&cap(5, 5, |x, y| -0.3 * (x * x + y * y)));
    let body = net.thick(0.05).unwrap();
    assert!(body.is_solid());
    // Both skins, and rims over 5 x 10 edges of the border and 10 of the opening.
    assert_eq!(body.outer.faces().len(), 2 * 5 * 24 + 50 + 10);
    let volume = body.outer.volume();
    let area = net.to_shell().unwrap().area();
    assert!((volume / (0.05 * area) - 1.0).abs() < 0.05, "{volume} {area}");
    let back = net.offset(0.05).unwrap().offset(-0.05).unwrap();
    let off = net.layout().points().iter().zip(back.layout().points()).map(|(p, q)| p.distance(*q));
    assert!(off.fold(0.0, f64::max) < 1e-14);
    // The other way round the outside is the other side.
    let below = net.thick(-0.05).unwrap();
    assert!(below.is_solid() && below.outer.volume() > 0.0);
}

#[test]
fn maps_keep_nets_together() {
    let net = made(&cap(3, 4, |x, y| -0.3 * (x * x + y * y)));
    let inversion = Mobius::inversion(Point3::new(0.3, -0.2, 3.0), 2.0).unwrap();
    let image = net.transformed(&inversion).unwrap();
    assert!(crease(&image) < 1e-9);
    let turned = net.transformed(&Mobius::rotation(Point3::ORIGIN, Vec3::new(0.6, 0.0, 0.8), 1.0).unwrap()).unwrap();
    let (before, after) = (net.to_shell().unwrap().area(), turned.to_shell().unwrap().area());
    assert!((after / before - 1.0).abs() < 1e-12);
}

#[test]
fn similar_meshes_have_similar_nets() {
    let dome = cap(5, 4, |x, y| -0.3 * (x * x + y * y));
    let net = made(&dome);
    // A power of two, which rounds nothing.
    let scaled =
        dome.with_points(dome.points().iter().map(|p| Point3::ORIGIN + p.to_vec() * 1024.0).collect()).unwrap();
    let large = made(&scaled);
    let off = net.layout().points().iter().zip(large.layout().points());
    assert!(off.map(|(p, q)| (p.to_vec() * 1024.0 - q.to_vec()).length()).fold(0.0, f64::max) < 1e-9);
}

#[test]
fn what_is_circular_stays() {
    let net = made(&cap(5, 4, |x, y| -0.3 * (x * x + y * y)));
    let again = make_layout_circular(net.layout(), &CircularMeshOptions::default()).unwrap();
    assert_eq!((again.report.steps, &again.layout), (0, net.layout()));
}

#[test]
fn without_extraordinary_vertices_it_is_the_net_of_the_grid() {
    let points: Vec<Point3> = (0..12).map(|k| Point3::new(f64::from(k % 4), f64::from(k / 4), 0.0)).collect();
    let quads: Vec<[usize; 4]> = (0..6).map(|q| q % 3 + 4 * (q / 3)).map(|a| [a, a + 1, a + 5, a + 4]).collect();
    let net = NetLayout::new(QuadLayout::new(points, &quads).unwrap()).unwrap();
    assert!((net.to_shell().unwrap().area() - 6.0).abs() < 1e-12);
}

#[test]
fn what_does_not_close_is_refused() {
    // Its quads have circles; their frames go round the corner of a cube.
    let cube = ball(4, 0.0);
    let flat = cube.points().iter().map(|p| {
        let v = p.to_vec();
        Point3::ORIGIN + v * (1.0 / v.max_abs())
    });
    let cube = cube.with_points(flat.collect()).unwrap();
    match NetLayout::new(cube) {
        Err(Error::Grid(GridError::RingDoesNotClose { angle, .. })) => assert!(angle > 1.0),
        other => panic!("{other:?}"),
    }
}

#[test]
fn threes_and_fives_together() {
    // Two of each, on a plane, a dome and a ball, of a mesh that was divided and smoothed.
    let heights: [fn(f64, f64) -> f64; 3] =
        [|_, _| 0.0, |x, y| -0.06 * (x * x + y * y), |x, y| (36.0 - x * x - y * y).sqrt()];
    for height in heights {
        let layout = pair(height);
        assert_eq!((layout.round().len(), layout.quads().len()), (4, 1600 - 16));
        let report = make_layout_circular(&layout, &CircularMeshOptions::default()).unwrap().report;
        assert!(report.moves.max < 1.5 * report.median_edge, "{report:?}");
        let net = made(&layout);
        assert!(crease(&net) < 1e-9, "{}", crease(&net));
        // Below a degree: the normals of the net are those of the mesh.
        assert!(net.tilt() < 0.02, "{}", net.tilt());
    }
}

/// Blocks between offsets of all pieces hang together, also where one is turned against the other: as one solid, and in a grid of cells.
#[test]
fn layers_share_faces_across_pieces() {
    for (net, openings) in [(made(&cap(5, 4, |x, y| -0.3 * (x * x + y * y))), 1), (made(&ball(5, 0.1)), 8)] {
        let grids = CyclideGrid::layers_of_layout(&net, &[-0.02, 0.0, 0.05]).unwrap();
        let blocks: Vec<CyclideVolume> = grids.iter().flat_map(CyclideGrid::blocks).collect();
        let shell = net.to_shell().unwrap();
        let (quads, layers) = (shell.faces().len(), 2);
        assert_eq!(blocks.len(), layers * quads);
        let volume: f64 = blocks.iter().map(|block| block.measure().volume).sum();
        let solid: f64 = [-0.02, 0.05].map(|h| net.thick(h).unwrap().outer.volume()).iter().sum();
        // Each is known to 1e-12 or better.
        assert!((volume / solid - 1.0).abs() < 1e-9, "{volume} {solid}");
        // Every vertex of the three skins once, bit for bit.
        let corners: std::collections::BTreeSet<[u64; 3]> = blocks
            .iter()
            .flat_map(|block| block.corners().map(|p| p.to_array().map(|x| (x + 0.0).to_bits())))
            .collect();
        assert_eq!(corners.len(), (layers + 1) * shell.vertices().len());
        // Nodes at even places are those of the shell's edges, faces and blocks: no face between two pieces has its own.
        let places = || Grading::Uniform.places(3).unwrap();
        let grid = StructuredGrid::new(&blocks, [places(), places(), places()]).unwrap();
        let of_skin = shell.vertices().len() + 2 * shell.edges().len() + 4 * quads;
        assert_eq!(grid.nodes().len(), (3 * layers + 1) * of_skin);
        assert!(grid.quality().scaled_jacobian > 0.5);
        // What is outside is one solid without hollows: both skins, and a rim of two layers over every free edge.
        let bodies = CyclideVolume::outer_bodies(&blocks).unwrap();
        let free = shell.edge_uses().iter().filter(|uses| **uses == 1).count();
        assert_eq!((bodies.len(), bodies[0].outer.faces().len()), (1, 2 * quads + layers * free));
        assert!(bodies[0].is_solid() && (bodies[0].outer.volume() / solid - 1.0).abs() < 1e-9);
        let characteristic = bodies[0].outer.vertices().len() as i64 + bodies[0].outer.faces().len() as i64
            - bodies[0].outer.edges().len() as i64;
        // A disc or a sphere with openings, doubled.
        assert_eq!(characteristic, if openings == 1 { 0 } else { 2 * (2 - 8) });
        // The skins between layers run on over all pieces.
        let skins = CyclideVolume::coordinate_bodies(&blocks, 2, &[0.0, 1.0]).unwrap();
        assert_eq!(skins.iter().map(|(_, skin)| skin.outer.faces().len()).collect::<Vec<_>>(), [quads; 3]);
    }
}

/// Cells fit across pieces if they are at the same places on the sides that meet: else nodes are the blocks' own, and it is told.
#[test]
fn unlike_cells_do_not_fit_turned_neighbors() {
    let net = made(&cap(5, 4, |x, y| -0.3 * (x * x + y * y)));
    let grids = CyclideGrid::layers_of_layout(&net, &[0.0, 0.05]).unwrap();
    let blocks: Vec<CyclideVolume> = grids.iter().flat_map(CyclideGrid::blocks).collect();
    let even = |n: usize| Grading::Uniform.places(n).unwrap();
    let grid = |s: Vec<f64>, t: Vec<f64>| StructuredGrid::new(&blocks, [s, t, even(3)]).unwrap();
    let graded = |fine| Grading::Geometric { ratio: 1.5, fine }.places(4).unwrap();
    let nodes = grid(even(4), even(4)).nodes().len();
    // Seen from both ends they are the same.
    let both = grid(graded(FineEnd::Both), graded(FineEnd::Both));
    assert_eq!((both.nodes().len(), both.faces_apart()), (nodes, 0));
    // The s of a sector is the t of the next one.
    let unlike = grid(graded(FineEnd::Both), even(4));
    assert!(unlike.nodes().len() > nodes);
    // Where sectors join there are three faces, four quads less the open one.
    assert_eq!((unlike.faces_apart(), grid(even(4), even(2)).faces_apart()), (5 * 3, 5 * 3));
}
