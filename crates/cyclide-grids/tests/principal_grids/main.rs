//! Grids along the lines of curvature of meshes.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod faults;
mod joined;
mod oracle;
mod surfaces;

use cyclide::{
    Point3, Vec3,
    surface::{CyclidicNet, GridCell, NetFrame},
    topology::surface_joints,
};
use cyclide_grids::{
    CircularMesh, CircularMeshOptions, GridBorder, PrincipalGridOptions, PrincipalGrids, UmbilicRule, make_circular,
    principal_grids,
};
use std::f64::consts::PI;
use surfaces::Mesh;

fn edge(length: f64) -> PrincipalGridOptions {
    PrincipalGridOptions::new(length)
}

fn laid(mesh: &Mesh, options: &PrincipalGridOptions) -> cyclide::Result<PrincipalGrids> {
    principal_grids(&mesh.points, &mesh.triangles, options)
}

fn circular(grids: &PrincipalGrids, k: usize) -> CircularMesh {
    make_circular(&grids.grids[k], &CircularMeshOptions::default()).unwrap()
}

/// The largest move over the median edge.
fn moves(mesh: &CircularMesh) -> f64 {
    mesh.report.moves.max / mesh.report.median_edge
}

fn reasons(grids: &PrincipalGrids) -> Vec<&'static str> {
    grids.warnings().iter().map(cyclide::Warning::reason).collect()
}

/// Moves and coverage as the mathematics were accepted with; the bending is what it was.
#[test]
fn surfaces_without_umbilics() {
    let vault = surfaces::vault([60, 40]);
    for (name, mesh, most, least) in [
        ("hypar", surfaces::hypar(48), 0.03, 0.42),
        ("shear", surfaces::shear(48), 0.03, 0.55),
        ("paraboloid", surfaces::paraboloid(48), 0.06, 0.75),
        ("saddle", surfaces::saddle(), 0.03, 0.29),
        ("vault", vault, 0.1, 0.3),
    ] {
        let grids = laid(&mesh, &edge(0.5)).unwrap();
        assert!(grids.grids.len() == 1 && grids.warnings().is_empty(), "{name}: {:?}", grids.warnings());
        let report = &grids.report;
        assert!(report.coverage >= least && report.coverage < 1.0, "{name}: covers {}", report.coverage);
        assert!(report.umbilics.is_empty() && !report.denoised && report.return_shift.is_none());
        let made = circular(&grids, 0);
        let bending = made.report.shape.and_then(|shape| shape.bending).unwrap();
        assert!(moves(&made) <= most && (0.99..=1.01).contains(&bending), "{name}: {} {bending}", moves(&made));
        assert!(made.report.rejected_quads.is_empty() && made.warnings().is_empty(), "{name}: {:?}", made.warnings());
        if name == "vault" {
            let in_hole = |p: &Point3| (p.x - 1.0).abs() < 1.9 && p.y.abs() < 1.1;
            assert!(report.holes == 1 && !grids.grids[0].points().iter().any(in_hole));
        }
    }
}

/// All whole cells: the border follows that of the surface in steps, and the hole of the vault is an opening.
#[test]
fn a_border_in_steps_covers_more() {
    let vault = surfaces::vault([60, 40]);
    for (name, mesh, most, least) in [
        ("hypar", surfaces::hypar(48), 0.03, 0.84),
        ("shear", surfaces::shear(48), 0.03, 0.84),
        ("paraboloid", surfaces::paraboloid(48), 0.08, 0.84),
        ("vault", vault, 0.1, 0.84),
    ] {
        let inside = laid(&mesh, &edge(0.5)).unwrap().report.coverage;
        let grids = laid(&mesh, &PrincipalGridOptions { border: GridBorder::Staircase, ..edge(0.5) }).unwrap();
        let (grid, coverage) = (&grids.grids[0], grids.report.coverage);
        assert!(coverage >= least && coverage > inside && coverage < 1.0, "{name}: covers {coverage}, {inside}");
        let made = circular(&grids, 0);
        assert!(moves(&made) <= most && made.warnings().is_empty(), "{name}: {} {:?}", moves(&made), made.warnings());
        let [m, n] = grid.quads();
        let openings = (0..m * n).filter(|k| grid.cell(k % m, k / m) == GridCell::Opening).count();
        assert_eq!(openings > 0, name == "vault", "{name}: {openings}");
        let net = CyclidicNet::new(made.grid, NetFrame::Auto).unwrap();
        assert!(net.singular_patches().is_empty(), "{name}");
        // Normals that agree to rounding.
        assert!(surface_joints(&net.to_shell().unwrap()).iter().all(|joint| joint.angle < 1e-7), "{name}");
        if name == "vault" {
            let body = net.thick(0.1).unwrap().outer;
            assert!(body.is_closed());
            let handles = body.vertices().len() as i64 - body.edges().len() as i64 + body.faces().len() as i64;
            assert_eq!(handles, 0, "a ring has one");
        }
    }
}

/// Points are moved off the triangles onto the fits: the distance of the hypar is that of a cubic, far below the sag of a chord.
#[test]
fn points_lie_on_the_surface() {
    let grids = laid(&surfaces::hypar(24), &edge(0.5)).unwrap();
    let off = grids.grids[0].points().iter().map(|p| (p.z - 0.05 * p.x * p.y).abs()).fold(0.0, f64::max);
    // Cubics in planes tilted by up to 0.4 miss a hypar by its fourth-order terms there; the sag is 0.05 0.5^2 / 8.
    assert!(off < 2e-4, "{off}");
}

#[test]
fn noise_is_smoothed_away() {
    let given = surfaces::hypar_along(48);
    let slight = laid(&given.clone().noisy(1e-3), &edge(0.5)).unwrap();
    assert!(!slight.report.denoised && moves(&circular(&slight, 0)) <= 0.05);
    let strong = laid(&given.clone().noisy(1e-2), &edge(0.5)).unwrap();
    assert!(strong.report.denoised && moves(&circular(&strong, 0)) <= 0.1);
    // Half the noise is across; the fits take up some of it.
    assert!((2e-3..8e-3).contains(&strong.report.noise), "{}", strong.report.noise);
    let kept = PrincipalGridOptions { denoise: Some(false), ..edge(0.5) };
    assert!(!laid(&given.noisy(1e-2), &kept).unwrap().report.denoised);
}

/// What a cubic misses of a tube whose mesh has edges as long as the grid's is no noise: points stay on the surface, and the return
/// shift stays. Noise that is there is still found on a finer mesh.
#[test]
fn coarse_meshes_are_not_noisy() {
    let hyperboloid = laid(&surfaces::hyperboloid([24, 16]), &edge(0.58)).unwrap();
    let off = |p: &Point3| {
        let z = p.z / 4.0;
        let waist = (1.0 + z * z).sqrt();
        // Distance to first order.
        let f = (p.x / 3.0).powi(2) + (p.y / 2.0).powi(2) - waist * waist;
        f.abs() / (2.0 * Vec3::new(p.x / 9.0, p.y / 4.0, -z / 4.0).length())
    };
    let most = |grids: &PrincipalGrids| grids.grids[0].points().iter().map(off).fold(0.0, f64::max);
    // The fits miss it by a hundredth of an edge or so, smoothing did by a third.
    assert!(!hyperboloid.report.denoised && most(&hyperboloid) < 0.03 * 0.58, "{}", most(&hyperboloid));
    let noisy = laid(&surfaces::hyperboloid([96, 64]).noisy(2e-3), &edge(0.58)).unwrap();
    assert!(noisy.report.denoised && most(&noisy) < 0.01 * 0.58, "{}", most(&noisy));

    let tower = laid(&surfaces::tower(60.0, 40.0, PI / 3.0, 200.0, [24, 30]), &edge(7.0)).unwrap();
    let shift = tower.report.return_shift.unwrap();
    assert!(!tower.report.denoised && shift > 0.7 && reasons(&tower).contains(&"spiral-lines"), "{shift}");
    let bump = laid(&surfaces::bump_cylinder([24, 16]), &edge(0.48)).unwrap();
    assert!(!bump.report.denoised && bump.report.noise > 1e-3, "{}", bump.report.noise);
}

/// Three rows of vertices among the nearest say little of slopes across them: no umbilics come of that.
#[test]
fn long_triangles_keep_directions() {
    let band = Mesh::of_grid([120, 40], true, |u, v| {
        let ((sine, cosine), angle) = ((2.0 * PI * u).sin_cos(), 2.6 * v - 1.3);
        let r = 5.0 + 2.0 * angle.cos();
        Point3::new(r * cosine, r * sine, 2.0 * angle.sin())
    });
    let grids = laid(&band, &edge(0.4)).unwrap();
    assert!(grids.report.umbilics_found == 0 && grids.warnings().is_empty(), "{:?}", grids.warnings());
    // Smoothing turns exact directions by as little on a mesh of twice the fineness.
    assert!(grids.report.turn < 5e-3 && grids.report.return_shift.unwrap() < 4e-3, "{:?}", grids.report);
}

/// Places and indices of umbilics; pieces beside them keep the shape.
#[test]
fn umbilics_are_cut_or_smoothed() {
    let mesh = surfaces::nurbs(2, 40);
    let grids = laid(&mesh, &edge(0.8)).unwrap();
    let report = &grids.report;
    assert!(reasons(&grids).contains(&"pieces") && grids.grids.len() > 1);
    assert_eq!(report.umbilics.iter().map(|u| u.halves).collect::<Vec<_>>(), [-1, -1]);
    // No grid reaches an umbilic, and the largest keeps the acceptance of the mathematics.
    for u in &report.umbilics {
        let near = grids.grids.iter().flat_map(|g| g.points()).any(|p| p.distance(u.point) < 0.4);
        assert!(!near, "{u:?}");
    }
    let made = circular(&grids, 0);
    let turn = made.report.shape.and_then(|shape| shape.normal_turn).unwrap();
    let coverage = report.pieces[0].coverage;
    assert!(coverage >= 0.3 && moves(&made) <= 0.3 && turn <= 0.06, "{coverage} {} {turn}", moves(&made));

    let smooth = laid(&mesh, &PrincipalGridOptions { umbilics: UmbilicRule::Smooth, ..edge(0.8) }).unwrap();
    assert!(smooth.grids.len() == 1 && reasons(&smooth).contains(&"umbilics-smoothed"));
    assert!(smooth.report.umbilics.is_empty() && smooth.report.umbilics_found == 2);
    assert!(smooth.report.coverage > 0.6 && smooth.report.smoothing > 16.0 && smooth.report.turn > 0.1);
}

/// An ellipsoid's cap: its umbilics are at known places.
#[test]
fn umbilics_of_an_ellipsoid() {
    let [a, b, c] = [4.0, 3.9, 2.0];
    let cap =
        Mesh::roof([-2.2, 2.2], [-2.2, 2.2], [44, 44], |x, y| c * (1.0_f64 - x * x / (a * a) - y * y / (b * b)).sqrt());
    let grids = laid(&cap, &edge(0.3)).unwrap();
    let x = a * ((a * a - b * b) / (a * a - c * c)).sqrt();
    let mut found: Vec<_> = grids.report.umbilics.iter().map(|u| (u.point.x, u.point.y, u.halves)).collect();
    found.sort_by(|p, q| p.0.total_cmp(&q.0));
    assert_eq!(found.len(), 2, "{found:?}");
    for ((at, across, halves), wanted) in found.into_iter().zip([-x, x]) {
        // A vertex of the mesh, whose edges are a tenth.
        assert!((at - wanted).abs() < 0.3 && across.abs() < 0.15 && halves == 1, "{at} {across} {halves}: {wanted}");
    }
}

#[test]
fn tubes_close() {
    let soft = surfaces::tower(44.0, 36.0, PI / 6.0, 120.0, [48, 60]);
    let grids = laid(&soft, &edge(5.0)).unwrap();
    assert!(grids.grids[0].closed() == [true, false] && reasons(&grids).is_empty(), "{:?}", grids.warnings());
    let shift = grids.report.return_shift.unwrap();
    assert!((0.3..0.6).contains(&shift) && grids.report.coverage > 0.9, "{shift}");
    assert!(moves(&circular(&grids, 0)) <= 0.4);
    let columns = PrincipalGridOptions { columns: Some(17), ..edge(5.0) };
    assert_eq!(laid(&soft, &columns).unwrap().grids[0].size()[0], 17);

    // Triangles that bad ones cut off leave the columns as they are: of the tower's fine mesh some do.
    let cut_off = laid(&surfaces::tower(50.0, 40.0, 0.3, 200.0, [120, 150]), &edge(6.0)).unwrap();
    assert!(cut_off.grids[0].size()[0] == 21 && cut_off.report.pieces[0].edges[1] < 9.0, "{:?}", cut_off.report.pieces);

    let straight = laid(&surfaces::hyperboloid([48, 32]), &edge(0.8)).unwrap();
    assert!(straight.grids[0].closed()[0] && straight.report.return_shift.unwrap() < 0.05);
    assert!(moves(&circular(&straight, 0)) <= 0.1);

    let open = laid(&soft, &PrincipalGridOptions { closed: Some(false), ..edge(5.0) }).unwrap();
    assert!(!open.grids[0].closed()[0] && open.report.return_shift.is_none());
}

/// A tower whose lines come back 3 to 4 m higher: as the mathematics traced them.
#[test]
fn spirals_are_told_and_refused() {
    let tower = surfaces::tower(60.0, 40.0, PI / 3.0, 200.0, [48, 60]);
    let grids = laid(&tower, &edge(6.5)).unwrap();
    assert!(reasons(&grids).contains(&"spiral-lines") && grids.grids[0].closed()[0]);
    let shift = grids.report.return_shift.unwrap();
    assert!((3.0..4.6).contains(&shift), "{shift}");
    // Finer than the mesh: what cubics miss of it is no noise.
    let fine = edge(2.8);
    assert_eq!(laid(&tower, &fine).unwrap_err().reason(), "spiral-lines");
    let closed = PrincipalGridOptions { closed: Some(true), ..fine };
    assert!(laid(&tower, &closed).unwrap().grids[0].closed()[0]);
}

/// A tube with a door has a closed band above it.
#[test]
fn a_hole_in_a_tube_is_kept_free() {
    let tube = surfaces::bump_cylinder([48, 40]).without(|p| p.x > 1.2 && p.z < 1.6 && p.z > 0.6);
    let grids = laid(&tube, &edge(0.4)).unwrap();
    let grid = &grids.grids[0];
    assert!(grid.closed()[0] && grids.report.holes == 2);
    assert!(grid.points().iter().all(|p| p.z > 1.5), "the door");
}

#[test]
fn a_grid_may_cover_the_surface() {
    let mesh = surfaces::hypar(32);
    let grids = laid(&mesh, &PrincipalGridOptions { border: GridBorder::Cover, ..edge(0.6) }).unwrap();
    let grid = &grids.grids[0];
    assert!(grids.grids.len() == 1 && grids.report.coverage > 1.5, "{}", grids.report.coverage);
    let corners = mesh.points.iter().filter(|p| p.x.abs() > 5.9 && p.y.abs() > 5.9);
    for corner in corners {
        let nearest = grid.points().iter().map(|p| p.distance(*corner)).fold(f64::INFINITY, f64::min);
        assert!(nearest < 0.6, "{nearest} from {corner:?}");
    }
    // Continued over half the box, the hypar is missed by a hundredth of an edge or so near the mesh.
    let inside = grid.points().iter().filter(|p| p.x.abs() < 6.5 && p.y.abs() < 6.5);
    let off = inside.map(|p| (p.z - 0.05 * p.x * p.y).abs()).fold(0.0, f64::max);
    assert!(off < 0.05, "{off}");
    let made = circular(&grids, 0);
    let bending = made.report.shape.and_then(|shape| shape.bending).unwrap();
    assert!(moves(&made) <= 0.15 && (0.98..=1.02).contains(&bending), "{} {bending}", moves(&made));
}

/// The same bits in every run; in other units and at another place the same grid but for rounding.
#[test]
fn grids_follow_the_surface() {
    let mesh = surfaces::paraboloid(24);
    let grids = laid(&mesh, &edge(0.75)).unwrap();
    assert_eq!(grids, laid(&mesh, &edge(0.75)).unwrap());
    let shift = Vec3::new(300.0, -70.0, 20.0);
    let map = |p: &Point3| Point3::ORIGIN + p.to_vec() * 16.0 + shift;
    let moved = Mesh { points: mesh.points.iter().map(map).collect(), triangles: mesh.triangles.clone() };
    let other = laid(&moved, &edge(12.0)).unwrap();
    assert_eq!(grids.grids[0].size(), other.grids[0].size());
    let apart = grids.grids[0].points().iter().zip(other.grids[0].points()).map(|(p, q)| map(p).distance(*q));
    // Rounding at 300 is 3e-14 relative; curvatures amplify it by the inverse square of the mesh's edges.
    let apart = apart.fold(0.0, f64::max);
    assert!(apart < 1e-6, "{apart}");
}

/// A point that no triangle uses changes nothing.
#[test]
fn unused_points_are_left_out() {
    let mesh = surfaces::hypar(16);
    let mut other = mesh.clone();
    other.points.insert(0, Point3::new(1.0, 2.0, 99.0));
    other.triangles.iter_mut().flatten().for_each(|v| *v += 1);
    assert_eq!(laid(&mesh, &edge(0.9)).unwrap(), laid(&other, &edge(0.9)).unwrap());
}
