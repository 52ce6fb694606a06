//! Closed grids made circular: they close as nets, without a crease, on every kind of tube and ring
//! (`docs/math/circular-meshes.md#closed-grids`).
#![allow(clippy::unwrap_used, reason = "helpers of tests")]
#![allow(clippy::print_stdout, reason = "the long runs print their tables")]

use cyclide::{
    Error, Point3, Vec3,
    curve::{Circle, ParamCurve},
    error::PatchError,
    surface::{CyclidicNet, NetFrame, QuadGrid},
    topology::surface_joints,
};
use cyclide_grids::{Border, CircularMesh, CircularMeshOptions, make_circular, make_circular_watched};
use std::f64::consts::{PI, TAU};

/// A surface over two parameters from 0 to 1, closed along the first or along both.
type Surface = fn(f64, f64) -> [f64; 3];

fn elliptic_cylinder(u: f64, v: f64) -> [f64; 3] {
    let u = TAU * u;
    [3.0 * u.cos(), 2.0 * u.sin(), 4.0 * v]
}

/// An elliptic tower that tapers and turns: axes of the ellipse, whole turn, height.
fn turned([a, b]: [f64; 2], turn: f64, height: f64, [u, v]: [f64; 2]) -> [f64; 3] {
    let (u, r) = (TAU * u, 1.0 - v / 4.0);
    let (x, y) = (0.5 * a * r * u.cos(), 0.5 * b * r * u.sin());
    let (sine, cosine) = (turn * v).sin_cos();
    [x * cosine - y * sine, x * sine + y * cosine, height * v]
}

fn twisted_tower(u: f64, v: f64) -> [f64; 3] {
    turned([60.0, 40.0], PI / 3.0, 200.0, [u, v])
}

fn soft_tower(u: f64, v: f64) -> [f64; 3] {
    turned([44.0, 36.0], PI / 6.0, 120.0, [u, v])
}

fn hyperboloid(u: f64, v: f64) -> [f64; 3] {
    let (u, z) = (TAU * u, 2.0 * v - 1.0);
    let r = (1.0 + z * z).sqrt();
    [3.0 * r * u.cos(), 2.0 * r * u.sin(), 4.0 * z]
}

fn bump_cylinder(u: f64, v: f64) -> [f64; 3] {
    let u = TAU * u;
    let r = 2.0 * (1.0 + 0.1 * (3.0 * u).cos() * (PI * v).sin() + 0.05 * (2.0 * u + 1.0).sin() * v);
    [r * u.cos(), r * u.sin(), 5.0 * v]
}

fn undulating_ring(u: f64, v: f64) -> [f64; 3] {
    let (u, v) = (TAU * u, TAU * v);
    let r = 1.2 * (1.0 + 0.15 * (3.0 * u).cos());
    [(5.0 + r * v.cos()) * u.cos(), (5.0 + r * v.cos()) * u.sin(), r * v.sin() + 0.3 * (2.0 * u).sin()]
}

fn elliptic_ring(u: f64, v: f64) -> [f64; 3] {
    let (u, v) = (TAU * u, TAU * v);
    [(6.0 + 1.3 * v.cos()) * u.cos(), (4.0 + 1.3 * v.cos()) * u.sin(), v.sin()]
}

/// The surfaces: name, surface, whether a ring, counts of the test, counts of the long run.
type Row = (&'static str, Surface, bool, &'static [[usize; 2]], &'static [[usize; 2]]);
const SURFACES: [Row; 7] = [
    ("elliptic cylinder", elliptic_cylinder, false, &[[12, 5], [13, 5]], &[[24, 10], [48, 20], [25, 10]]),
    ("twisted tower", twisted_tower, false, &[[12, 15], [13, 15]], &[[24, 30], [25, 30]]),
    ("soft tower", soft_tower, false, &[[12, 15]], &[[24, 30], [48, 60]]),
    ("hyperboloid", hyperboloid, false, &[[12, 8], [13, 8]], &[[24, 16], [25, 16]]),
    ("bump cylinder", bump_cylinder, false, &[[12, 6], [12, 8]], &[[24, 16], [12, 6]]),
    (
        "undulating ring",
        undulating_ring,
        true,
        &[[18, 8], [19, 8], [18, 9], [19, 9]],
        &[[36, 16], [37, 16], [36, 17], [37, 17]],
    ),
    (
        "elliptic ring",
        elliptic_ring,
        true,
        &[[18, 8], [19, 8], [18, 9], [19, 9]],
        &[[36, 16], [37, 16], [36, 17], [37, 17], [72, 32]],
    ),
];

fn grid(surface: Surface, ring: bool, [m, n]: [usize; 2]) -> QuadGrid {
    let rows = if ring { n } else { n - 1 };
    let point = |k: usize| Point3::from(surface((k % m) as f64 / m as f64, (k / m) as f64 / rows as f64));
    QuadGrid::new((0..m * n).map(point).collect(), [m, n], [true, ring]).unwrap()
}

/// Whatever becomes of the shape: `shape_guard.rs` is about that.
fn circular(grid: &QuadGrid, border: Border<'_>) -> cyclide::Result<CircularMesh> {
    let options = CircularMeshOptions { border, allow_shape_change: true, ..Default::default() };
    make_circular(grid, &options)
}

/// What is measured on a net over a grid made circular.
struct Measured {
    gap: f64,
    crease: f64,
    singular: usize,
    free_edges: usize,
}

/// The net is built by the rules of any net, and its joints, those of the seam among them, are measured.
fn measured(mesh: &CircularMesh) -> Measured {
    let net = CyclidicNet::new(mesh.grid.clone(), NetFrame::Auto).unwrap();
    let shell = net.to_shell().unwrap();
    let joints = surface_joints(&shell);
    let largest = |of: fn(&cyclide::topology::SurfaceJoint) -> f64| joints.iter().map(of).fold(0.0, f64::max);
    Measured {
        gap: largest(|joint| joint.gap),
        crease: largest(|joint| joint.angle),
        singular: net.singular_patches().len(),
        free_edges: shell.edge_uses().iter().filter(|&&uses| uses == 1).count(),
    }
}

fn size(grid: &QuadGrid) -> f64 {
    let far = |p: &Point3| grid.points().iter().map(|q| p.distance(*q)).fold(0.0, f64::max);
    grid.points().first().map_or(0.0, far)
}

/// What must hold of a closed grid that was made circular; a line for the long run.
fn check(name: &str, before: &QuadGrid) -> String {
    let start = std::time::Instant::now();
    let mesh = circular(before, Border::Free).map_err(|e| format!("{name}: {e}")).unwrap();
    let (took, report) = (start.elapsed().as_secs_f64(), &mesh.report);
    assert!(report.residual_after < 1e-12 && report.rejected_quads.is_empty(), "{name}: {report:?}");
    let (mut angles, mut stretches) = ([0.0_f64; 2], [0.0_f64; 2]);
    for (d, change) in report.closing.iter().enumerate() {
        assert_eq!(change.is_some(), before.closed()[d], "{name}");
        let Some(c) = change else { continue };
        angles = [angles[0].max(c.angle_before), angles[1].max(c.angle_after)];
        stretches = [stretches[0].max(c.stretch_before), stretches[1].max(c.stretch_after)];
    }
    // The limits of builders are 1e-9; the theory found 6e-13 and 4e-12 on 72 by 32 quads, less on smaller ones.
    assert!(angles[1] <= 1e-11 && stretches[1] <= 1e-11, "{name}: {:?}", report.closing);
    let m = measured(&mesh);
    // Coordinates up to the size are rounded by 1e-16 of it, times the few operations that make a point of a patch.
    assert!(m.gap <= 3e-14 * size(before), "{name}: gap {:e}", m.gap);
    // Normals agree up to the rounding of their patches: far below what is called a crease.
    assert!(m.crease <= 1e-9, "{name}: crease {:e}", m.crease);
    let open = 2 * before.size()[0];
    assert_eq!((m.singular, m.free_edges), (0, if before.closed()[1] { 0 } else { open }), "{name}");
    let edge = report.median_edge;
    assert!(report.moves.max <= 3.0 * edge, "{name}: {:?}", report.moves);
    format!(
        "| {name} {}x{} | {} | {:.3}/{:.3} | {:.0e} | {:.1e}, {:.0e} | {:.1e}, {:.0e} | {:.0e} | {:.0e} | {took:.2} |",
        before.size()[0],
        before.size()[1],
        report.steps,
        report.moves.max / edge,
        report.moves.mean / edge,
        report.residual_after,
        angles[0],
        angles[1],
        stretches[0],
        stretches[1],
        m.gap / size(before),
        m.crease,
    )
}

#[test]
fn tubes_and_rings_of_every_kind_close() {
    for (name, surface, ring, counts, _) in SURFACES {
        for &count in counts {
            check(name, &grid(surface, ring, count));
        }
    }
}

#[test]
fn coarse_tubes_close() {
    for m in 3..=6 {
        for n in [2, 3, 5] {
            check("bump cylinder", &grid(bump_cylinder, false, [m, n]));
        }
    }
}

/// `cargo test --workspace --test closed_nets -- --ignored --nocapture`
#[test]
#[ignore = "minutes"]
fn tubes_and_rings_in_full() {
    println!(
        "| surface | steps | moves/h | quad | angle before, after | stretch before, after | gap/size | crease | s |"
    );
    for (name, surface, ring, _, counts) in SURFACES {
        for &count in counts {
            println!("{}", check(name, &grid(surface, ring, count)));
        }
    }
}

/// What holds of borders of closed grids, for `docs/math/circular-meshes.md#closed-grids`: both rows pinned, or on the
/// closed curves through them.
#[test]
#[ignore = "minutes"]
fn borders_in_full() {
    for (name, surface, _, _, _) in SURFACES.into_iter().filter(|row| !row.2) {
        for m in [12, 13, 24] {
            let before = grid(surface, false, [m, 9]);
            let curve = |v: f64| {
                let points: Vec<Point3> = (0..96).map(|k| Point3::from(surface(f64::from(k) / 96.0, v))).collect();
                cyclide::curve::CircleSpline::fair(
                    &points,
                    &cyclide::construct::FairSplineOptions { closed: true, ..Default::default() },
                )
            };
            let [first, last] = [curve(0.0).unwrap(), curve(1.0).unwrap()];
            for (border, held) in [
                (Border::Pinned, "pinned"),
                (Border::OnCurves([Some(&first), None, None, None]), "one on a curve"),
                (Border::OnCurves([Some(&first), Some(&last), None, None]), "both on curves"),
            ] {
                match circular(&before, border) {
                    Ok(mesh) if !mesh.report.rejected_quads.is_empty() => {
                        println!("{name} {:?} {held}: {} quads cross", before.size(), mesh.report.rejected_quads.len());
                    }
                    Ok(mesh) => {
                        let (m, r) = (measured(&mesh), &mesh.report);
                        let (angle, moved) = (r.closing[0].unwrap().angle_after, r.moves.max / r.median_edge);
                        println!(
                            "{name} {:?} {held}: {} steps, moves {moved:.3}, residual {:.0e}, angle {angle:.0e}, crease {:.0e}, \
                             singular {}",
                            before.size(),
                            r.steps,
                            r.residual_after,
                            m.crease,
                            m.singular
                        );
                    }
                    Err(error) => println!("{name} {:?} {held}: {error}", before.size()),
                }
            }
        }
    }
}

#[test]
fn what_closes_is_returned_bit_for_bit() {
    // Round an odd number of planar rectangles frames come back; round an even number they do not.
    let odd = grid(elliptic_cylinder, false, [9, 4]);
    let mesh = circular(&odd, Border::Free).unwrap();
    assert_eq!((mesh.report.steps, &mesh.grid), (0, &odd));
    let even = grid(elliptic_cylinder, false, [8, 4]);
    let mesh = circular(&even, Border::Free).unwrap();
    assert!(mesh.report.residual_before < 1e-15 && mesh.report.steps > 0, "{:?}", mesh.report);
    let change = mesh.report.closing[0].unwrap();
    assert!(change.angle_before > 1e-3 && change.angle_after < 1e-12, "{change:?}");
    assert!(CyclidicNet::new(even, NetFrame::Auto).is_err());
}

#[test]
fn a_net_far_from_the_origin_closes() {
    let near = grid(bump_cylinder, false, [12, 8]);
    let away = Vec3::new(1e6, -2e6, 5e5);
    let points = near.points().iter().map(|p| *p + away).collect();
    let mesh = circular(&QuadGrid::new(points, near.size(), near.closed()).unwrap(), Border::Free).unwrap();
    let m = measured(&mesh);
    // Points are rounded by 2e-10 there, edges are 1 long.
    assert!(m.crease < 1e-8 && m.gap < 1e-8 && mesh.report.closing[0].unwrap().angle_after < 1e-8, "{}", m.crease);
}

/// Circles in planes z, of a hyperboloid or a tube that is no surface of revolution between them.
fn between_circles(n: usize, m: usize, radii: [f64; 2], wave: f64) -> (QuadGrid, [Circle; 2]) {
    let circle = |r: f64, z: f64| {
        let at = |a: f64| Point3::new(r * a.cos(), r * a.sin(), z);
        Circle::through_points([0.0, 2.0, 4.0].map(at)).unwrap()
    };
    let point = |k: usize| {
        let (u, v) = (TAU * (k % m) as f64 / m as f64, (k / m) as f64 / (n - 1) as f64);
        let bulge = (PI * v).sin();
        let r = radii[0] * (1.0 - v) + radii[1] * v + wave * bulge * (2.0 * u + 0.5).sin();
        Point3::new(r * u.cos(), r * u.sin(), 5.0 * v)
    };
    let grid = QuadGrid::new((0..m * n).map(point).collect(), [m, n], [true, false]).unwrap();
    (grid, [circle(radii[0], 0.0), circle(radii[1], 5.0)])
}

#[test]
fn border_rows_slide_on_circles() {
    for m in [12, 13] {
        let (before, [first, last]) = between_circles(8, m, [2.0, 1.5], 0.3);
        for sides in [[true, true], [true, false], [false, true]] {
            let curves: [Option<&dyn ParamCurve>; 2] = [sides[0].then_some(&first), sides[1].then_some(&last)];
            let mesh = circular(&before, Border::OnCurves([curves[0], curves[1], None, None])).unwrap();
            let (closed, seam) = (mesh.report.closing[0].unwrap(), measured(&mesh));
            assert!(closed.angle_after < 1e-11 && seam.crease < 1e-9, "{m} {sides:?}: {closed:?}");
            for (used, (circle, j)) in sides.into_iter().zip([(&first, 0), (&last, 7)]) {
                let off = |i: usize| circle.closest_point(mesh.grid.point(i, j)).distance;
                // Rounding of points of size 5.
                assert!(!used || (0..m).all(|i| off(i) < 1e-14), "{m} {sides:?}");
            }
        }
    }
}

#[test]
fn pinned_rows_close_if_they_can() {
    // Planar rows of an odd number of edges bring every frame back that they may bring back.
    let (odd, _) = between_circles(8, 13, [2.0, 1.5], 0.1);
    let mesh = circular(&odd, Border::Pinned).unwrap();
    assert!(mesh.report.steps > 0 && measured(&mesh).crease < 1e-9);
    let row = |grid: &QuadGrid, j: usize| -> Vec<Point3> { (0..13).map(|i| grid.point(i, j)).collect() };
    assert_eq!([row(&mesh.grid, 0), row(&mesh.grid, 7)], [row(&odd, 0), row(&odd, 7)]);
    // A row that turns frames can never close, and nothing is searched: of an ellipse, or bent out of its plane.
    for (first, last) in [(0.0, 0.3), (0.3, 0.0)] {
        for m in [12, 13] {
            let mut points = between_circles(8, m, [2.0, 1.5], 0.0).0.points().to_vec();
            let bent = |k: usize, wave: f64| Vec3::new(wave * (k as f64).cos(), 0.0, wave * (2.0 * k as f64).sin());
            for k in 0..m {
                points[k] += bent(k, first);
                points[7 * m + k] += bent(k, last);
            }
            let before = QuadGrid::new(points, [m, 8], [true, false]).unwrap();
            let mut steps = 0;
            let options = CircularMeshOptions { border: Border::Pinned, ..Default::default() };
            let error = make_circular_watched(&before, &options, &mut |_| steps += 1).unwrap_err();
            // The row that is to blame is named: the first one that turns them.
            let row = if first > 0.0 { 0 } else { 7 };
            let named = |line, angle| line == Some(row) && angle > 1e-3;
            let told = matches!(error, Error::Patch(PatchError::NetDoesNotClose { direction: 0, line, angle, .. }) if named(line, angle));
            assert!(told && error.to_string().contains(&format!("along pinned row {row} ")), "{error}");
            assert_eq!(steps, 0);
        }
    }
}
