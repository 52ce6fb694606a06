//! Meshes of whole cyclides, nets and thick shells: watertight, oriented, of the right volume.

use super::checks::{deviation, edges, sound};
use cyclide::{
    Point3,
    conformal::{Conformal, Mobius},
    mesh::{LineKind, SurfaceMesh, parameter_lines, tessellate},
    surface::{CyclidicNet, DupinCyclide, NetFrame, QuadGrid},
    topology::Body,
};
use std::f64::consts::PI;

/// Fails unless every edge has two polygons, or one where the shell has one face.
fn watertight(name: &str, body: &Body, mesh: &SurfaceMesh) {
    let border: Vec<_> =
        body.shells().flat_map(|s| s.edges().iter().zip(s.edge_uses())).filter(|(_, n)| *n == 1).collect();
    for ((a, b), uses) in edges(mesh) {
        if uses.len() == 1 {
            let middle = mesh.positions[a].midpoint(mesh.positions[b]);
            let near = border
                .iter()
                .map(|(e, _)| e.curve.arc().unwrap().closest_point(middle).distance)
                .fold(f64::INFINITY, f64::min);
            assert!(near <= mesh.bound, "{name}: an open edge {near:e} from the border");
        }
    }
    if body.is_solid() {
        assert!(edges(mesh).values().all(|uses| uses.len() == 2), "{name}: a closed body has an open edge");
    }
}

fn check(name: &str, body: &Body, tolerance: f64) -> SurfaceMesh {
    let mesh = tessellate(body, tolerance).unwrap();
    sound(name, &mesh);
    watertight(name, body, &mesh);
    assert!(mesh.bound <= tolerance, "{name}: {:e}", mesh.bound);
    let [there, back] = deviation(body, &mesh, 2);
    assert!(there <= mesh.bound && back <= mesh.bound, "{name}: {there:e} {back:e}, bound {:e}", mesh.bound);
    let (area, volume): (f64, f64) =
        body.shells().map(|s| (s.area(), s.volume())).fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
    if body.is_solid() {
        assert!(mesh.volume() > 0.0, "{name}: inside out");
        assert!((mesh.volume() - volume).abs() <= mesh.bound * area, "{name}: {} {volume}", mesh.volume());
    }
    // Chords of an arc of angle x are shorter by x²/24, 5 % at an angle of 1: cells turn less where the mesh is fine.
    if tolerance <= 1e-2 * body.bounds().diagonal() {
        assert!((mesh.area() / area - 1.0).abs() < 0.05, "{name}: {} {area}", mesh.area());
    }
    mesh
}

/// A vase: a surface of revolution with a wavy profile, in quads.
fn vase(size: [usize; 2], closed: bool) -> CyclidicNet {
    let place = |i: usize, j: usize| {
        let (u, z) =
            (std::f64::consts::TAU * i as f64 / (size[0] as f64 + if closed { 0.0 } else { 4.0 }), 0.3 * j as f64);
        let r = 1.0 + 0.25 * (2.0 * z).sin();
        Point3::new(r * u.cos(), r * u.sin(), z)
    };
    let points = (0..size[1]).flat_map(|j| (0..size[0]).map(move |i| place(i, j))).collect();
    CyclidicNet::new(QuadGrid::new(points, size, [closed, false]).unwrap(), NetFrame::Auto).unwrap()
}

#[test]
fn whole_cyclides_are_watertight() {
    for [a, c, mu] in [[2.0, 0.0, 0.5], [2.0, 0.7, 1.0], [1.0, 0.9, 0.95], [1.0, 0.5, 0.2], [1.0, 0.3, 1.2]] {
        for body in DupinCyclide::new(a, c, mu).unwrap().to_bodies([4, 4]).unwrap() {
            for tolerance in [3e-1, 1e-2, 1e-3] {
                check(&format!("cyclide {a} {c} {mu}"), &body, tolerance);
            }
        }
    }
}

#[test]
fn a_ring_has_the_volume_of_the_quadrature() {
    let torus = Body { outer: DupinCyclide::new(2.0, 0.0, 0.5).unwrap().to_shell().unwrap(), voids: Vec::new() };
    let exact = 2.0 * PI.powi(2) * 2.0 * 0.25;
    let mut before = f64::INFINITY;
    for tolerance in [1e-1, 1e-2, 1e-3] {
        let mesh = tessellate(&torus, tolerance).unwrap();
        let off = (mesh.volume() - exact).abs();
        assert!(off <= mesh.bound * torus.outer.area() && off < before, "{off:e}");
        before = off;
        // One smooth surface: as many normals as vertices, and Euler's number of a torus.
        assert_eq!(mesh.normals.len(), mesh.positions.len());
        assert_eq!(mesh.positions.len() + mesh.faces.len(), edges(&mesh).len());
    }
}

#[test]
fn images_near_infinity_have_as_many_cells_wherever_the_pole_is() {
    let torus = DupinCyclide::new(3.0, 0.0, 1.0).unwrap().to_bodies([6, 6]).unwrap().remove(0);
    for distance in [1e-2, 1e-3, 1e-4] {
        // Nearest to the pole are a vertex, a point of no account, and one at an eighth of an edge.
        let cells = [0.0, 0.1, PI / 24.0].map(|angle: f64| {
            let center = Point3::new(3.0 * angle.cos(), 3.0 * angle.sin(), 1.0 + distance);
            let image = torus.transformed(&Mobius::inversion(center, 1.0).unwrap()).unwrap();
            let tolerance = 1e-3 * image.bounds().diagonal();
            let mesh = tessellate(&image, tolerance).unwrap();
            assert!(mesh.bound <= tolerance);
            mesh.faces.len() as f64
        });
        let [least, most] =
            [cells.iter().fold(f64::INFINITY, |a, &b| a.min(b)), cells.iter().fold(0.0, |a, &b| b.max(a))];
        assert!(most <= 2.0 * least, "{distance:e}: {cells:?}");
    }
}

#[test]
fn nets_and_thick_shells_are_watertight() {
    for closed in [false, true] {
        let net = vase([9, 7], closed);
        let open = Body { outer: net.to_shell().unwrap(), voids: Vec::new() };
        let thick = net.thick(0.05).unwrap();
        for tolerance in [1e-1, 3e-3] {
            let skin = check("net", &open, tolerance);
            assert_eq!(skin.normals.len(), skin.positions.len(), "the net is smooth: one normal per vertex");
            let solid = check("thick net", &thick, tolerance);
            assert!(solid.normals.len() > solid.positions.len(), "the rim has normals of its own");
        }
    }
}

#[test]
fn hollow_bodies_have_the_volume_between_their_skins() {
    let ring = DupinCyclide::new(2.0, 0.7, 1.0).unwrap();
    let net = ring.nets([6, 6]).unwrap().remove(0);
    let body = net.thick(0.1).unwrap();
    assert_eq!(body.voids.len(), 1);
    let mesh = check("hollow ring", &body, 1e-3);
    // The closed form of the volume between the offsets is not needed: that of the faces is.
    let volume: f64 = body.shells().map(cyclide::topology::Shell::volume).sum();
    assert!(volume > 0.0 && (mesh.volume() / volume - 1.0).abs() < 0.1);
}

#[test]
fn parameter_lines_are_on_the_surface() {
    let net = vase([9, 5], true);
    let body = Body { outer: net.to_shell().unwrap(), voids: Vec::new() };
    let (tolerance, inner) = (1e-3, 3);
    let lines = parameter_lines(&body, inner, tolerance).unwrap();
    let edges = lines.iter().filter(|l| l.kind == LineKind::Edge).count();
    assert_eq!(edges, body.outer.edges().len());
    assert_eq!(lines.len() - edges, body.outer.faces().len() * 2 * inner);
    for line in &lines {
        assert_eq!(line.points.len(), line.normals.len());
        for (p, n) in line.points.iter().zip(&line.normals) {
            // Outside of a vase, whichever side that is: the normal has unit length and stands off the axis.
            assert!((n.length() - 1.0).abs() < 1e-12);
            let radial = p.to_vec() - cyclide::Vec3::Z * p.z;
            assert!(n.dot(radial).abs() > 0.5 * radial.length(), "{n:?} at {p:?}");
        }
        for (p, n) in line.points.windows(2).zip(line.normals.windows(2)) {
            // Chords lie in the surface up to their sagitta, and normals vary slowly.
            assert!((p[1] - p[0]).dot(n[0]).abs() <= 8.0 * tolerance && n[0].dot(n[1]) > 0.5);
        }
    }
}
