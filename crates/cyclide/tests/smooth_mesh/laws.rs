//! Points, normals, boundaries, measures.

use crate::shapes::{self, Mesh};
use cyclide::{
    Point3, Quat, Vec3,
    conformal::Mobius,
    surface::{SmoothMesh, SmoothTriangle, VertexNormals},
};
use std::f64::consts::PI;

pub(crate) fn smooth(mesh: &Mesh) -> SmoothMesh {
    SmoothMesh::new(&mesh.0, &mesh.1, VertexNormals::AngleWeighted).unwrap()
}

fn patches(mesh: &SmoothMesh) -> impl Iterator<Item = SmoothTriangle> + '_ {
    (0..mesh.triangles().len()).map(|i| mesh.triangle(i).unwrap())
}

fn places(n: u32) -> impl Iterator<Item = [f64; 3]> {
    (0..=n).flat_map(move |i| (0..=n - i).map(move |j| [i, j, n - i - j].map(f64::from)))
}

/// The largest distance from a known surface, at places inside every triangle.
fn deviation(mesh: &SmoothMesh, off: impl Fn(Point3) -> f64) -> f64 {
    let off = &off;
    patches(mesh).flat_map(|t| places(12).map(move |at| off(t.point(at).unwrap()))).fold(0.0, f64::max)
}

#[test]
fn deviations_from_spheres_and_the_torus_are_as_derived() {
    let sphere = |p: Point3| (p.distance(Point3::ORIGIN) - 1.0).abs();
    let torus = |p: Point3| ((p.x.hypot(p.y) - 1.0).hypot(p.z) - 0.4).abs();
    // `docs/math/triangle-surfaces.md#comparison-with-pn-triangles`, the table, at places that do not miss the middles
    // of triangles.
    for (mesh, off, want) in [
        (shapes::icosahedron(), &sphere as &dyn Fn(Point3) -> f64, 4.24e-4),
        (shapes::icosphere(), &sphere, 1.11e-5),
        (shapes::torus(16, 10), &torus, 2.91e-3),
    ] {
        let got = deviation(&smooth(&mesh), off);
        assert!((got / want - 1.0).abs() < 0.02, "{got:e}, {want:e}");
    }
}

/// Angles as weights are exact on a sphere by symmetry only, Max's on any mesh.
#[test]
fn weights_for_spheres_are_exact_on_spheres() {
    let sphere = |p: Point3| (p.distance(Point3::ORIGIN) - 1.0).abs();
    // An uneven one: moved along itself.
    let uneven = |p: Point3| shapes::on_sphere(p + Vec3::new(0.3 * p.y, 0.2 * p.z * p.x, -0.25 * p.x));
    let (points, triangles) = shapes::quartered(shapes::icosphere(), shapes::on_sphere);
    let mesh = (points.into_iter().map(uneven).collect::<Vec<_>>(), triangles);
    let [by_angle, by_sphere] = [VertexNormals::AngleWeighted, VertexNormals::SphereWeighted]
        .map(|normals| SmoothMesh::new(&mesh.0, &mesh.1, normals).unwrap());
    for (corners, normals) in by_sphere.triangles().iter().zip(by_sphere.corner_normals()) {
        for k in 0..3 {
            let radial = mesh.0[corners[k]].to_vec();
            // Rounding over edges of a tenth.
            assert!((by_sphere.normals()[normals[k]] - radial).length() < 1e-14);
        }
    }
    let [angle, sphere] = [&by_angle, &by_sphere].map(|surface| deviation(surface, sphere));
    assert!(angle > 1000.0 * sphere && sphere < 2e-6, "{angle:e} {sphere:e}");
    let torus = |p: Point3| ((p.x.hypot(p.y) - 1.0).hypot(p.z) - 0.4).abs();
    let (points, triangles) = shapes::torus(16, 10);
    let fine = SmoothMesh::new(&points, &triangles, VertexNormals::SphereWeighted).unwrap();
    // By angles 2.9e-3.
    let off = deviation(&fine, torus);
    assert!(off < 2.1e-3, "{off:e}");
}

#[test]
fn vertices_and_their_normals_come_out_to_the_bit() {
    for (name, mesh) in shapes::all() {
        let surface = smooth(&mesh);
        for (index, patch) in patches(&surface).enumerate() {
            for k in 0..3 {
                let mut at = [0.0; 3];
                at[k] = 3.0;
                assert_eq!(patch.point(at).unwrap(), mesh.0[mesh.1[index][k]], "{name}");
                let normal = surface.normals()[surface.corner_normals()[index][k]];
                assert_eq!(patch.normal(at).unwrap(), normal);
                assert!((normal.length() - 1.0).abs() < 1e-15);
            }
        }
    }
}

#[test]
fn neighbors_share_points_and_normals_of_edges_to_the_bit() {
    let mut checked = 0;
    for (name, mesh) in shapes::all() {
        let surface = smooth(&mesh);
        for (index, edge) in surface.edges().iter().enumerate() {
            let (first, Some(second)) = edge.triangles() else { continue };
            for n in [3, 7, 8, 10, 13] {
                for k in 0..=n {
                    let at = |triangle: usize| {
                        let [low, high] =
                            edge.vertices().map(|v| mesh.1[triangle].iter().position(|w| *w == v).unwrap());
                        let mut at = [0.0; 3];
                        (at[low], at[high]) = (f64::from(n - k), f64::from(k));
                        surface.triangle(triangle).unwrap().point_and_normal(at).unwrap()
                    };
                    assert_eq!(at(first), at(second), "{name} edge {index}");
                    checked += 1;
                }
            }
        }
    }
    assert!(checked > 30_000);
}

/// The normal a little inside tends to that on the edge, from both sides, in proportion to the distance: G1.
#[test]
fn the_tangent_plane_is_continuous_across_edges_and_at_corners() {
    for (name, mesh) in shapes::all() {
        let surface = smooth(&mesh);
        for (index, patch) in patches(&surface).enumerate() {
            for corner in 0..3 {
                for mu in [0.02, 0.1, 0.3, 0.5, 0.8] {
                    let at = |inside: f64| {
                        let mut at = [inside; 3];
                        (at[(corner + 1) % 3], at[(corner + 2) % 3]) =
                            ((1.0 - inside) * (1.0 - mu), (1.0 - inside) * mu);
                        at
                    };
                    let on_edge = patch.normal(at(0.0)).unwrap();
                    let near = patch.normal(at(1e-7)).unwrap();
                    // The second derivatives grow like 1/(distance from the corner): 50 of them, times 1e-7/0.02.
                    assert!(near.angle(on_edge) < 3e-4, "{name} {index} {corner} {mu}: {:e}", near.angle(on_edge));
                    let nearer = patch.normal(at(1e-10)).unwrap();
                    assert!(nearer.angle(on_edge) < 1e-6, "{name} {index} {corner} {mu}");
                }
                for (distance, part) in [(1e-2, 0.2), (1e-3, 0.5), (1e-4, 0.9), (1e-6, 0.3)] {
                    let mut at = [0.0; 3];
                    at[corner] = 1.0 - distance;
                    (at[(corner + 1) % 3], at[(corner + 2) % 3]) = (distance * part, distance * (1.0 - part));
                    let angle = patch.normal(at).unwrap().angle(patch.normals()[corner]);
                    // `docs/math/triangle-surfaces.md#smooth-meshes`: at most 106 degrees, 1.85 radians, times the
                    // distance; 2.2 on the cylinder of 9.
                    assert!(angle < 2.5 * distance, "{name} {index} {corner}: {angle} at {distance}");
                }
            }
        }
    }
}

#[test]
fn normals_are_those_of_finite_differences() {
    for (name, mesh) in shapes::all() {
        let surface = smooth(&mesh);
        for patch in patches(&surface).step_by(7) {
            for at in [[0.2, 0.3, 0.5], [0.31, 0.6, 0.09], [1.0 / 3.0; 3]] {
                let h = 1e-6;
                let moved = |k: usize| {
                    let (mut plus, mut minus) = (at, at);
                    (plus[k], plus[2]) = (at[k] + h, at[2] - h);
                    (minus[k], minus[2]) = (at[k] - h, at[2] + h);
                    (patch.point(plus).unwrap() - patch.point(minus).unwrap()) / (2.0 * h)
                };
                let want = moved(0).cross(moved(1)).unit().unwrap();
                let got = patch.normal(at).unwrap();
                // Rounding 1e-16/h over edges of a fifth, truncation h².
                assert!((got - want).length() < 1e-8, "{name} {at:?}: {got:?} {want:?}");
            }
        }
    }
}

#[test]
fn similarities_map_the_surface_with_its_mesh() {
    let turn = Quat::new(0.4, -0.2, 0.7, 0.5);
    for (scale, far) in [(1e-6, 0.0), (1.0, 0.0), (1e6, 0.0), (1.0, 1e6)] {
        let map = Mobius::similarity(turn, scale, Vec3::new(3.0 + far, -2.0, 1.0 - far) * scale).unwrap();
        let image = |p: Point3| map.map_point(p).unwrap();
        for (name, mesh) in shapes::all() {
            let moved = smooth(&(mesh.0.iter().map(|p| image(*p)).collect(), mesh.1.clone()));
            let surface = smooth(&mesh);
            // Far out coordinates are rounded to 1e-10, and that of the normals is one over edges of a tenth.
            let limit = scale * (1e-13 + far * 1e-14);
            for (a, b) in patches(&surface).zip(patches(&moved)).step_by(5) {
                for at in places(5) {
                    let distance = b.point(at).unwrap().distance(image(a.point(at).unwrap()));
                    assert!(distance < limit, "{name} {scale} {far}: {distance:e}");
                }
            }
        }
    }
}

#[test]
fn flat_meshes_stay_flat_and_their_round_boundaries_are_circles() {
    let surface = smooth(&shapes::disc(7));
    assert!(!surface.is_closed());
    for patch in patches(&surface) {
        for at in places(9) {
            let p = patch.point(at).unwrap();
            assert!(p.z == 0.0 && p.x.hypot(p.y) < 1.0 + 1e-15);
        }
    }
    for edge in surface.edges().iter().filter(|edge| edge.triangles().1.is_none()) {
        assert!(edge.curve().is_arc());
        for k in 0..=20 {
            let p = edge.curve().point(f64::from(k) / 20.0);
            assert!((p.x.hypot(p.y) - 1.0).abs() < 4e-16);
        }
    }
    let measure = surface.measure().unwrap();
    // The disc itself, as the boundary is its circle; the corners on it are flat and smooth.
    assert!((measure.area - PI).abs() < 10.0 * measure.area_error + 1e-9, "{measure:?}");
    assert!(measure.volume.is_none());
}

/// Boundaries are G1 where they turn by less than 60 degrees, and keep their corners elsewhere.
#[test]
fn open_boundaries_are_smooth_but_for_corners() {
    let mesh = shapes::graph(6, |x, y| 0.2 * (5.0 * x).sin() * (3.0 * y).cos());
    let surface = smooth(&mesh);
    let boundary: Vec<_> = surface.edges().iter().filter(|edge| edge.triangles().1.is_none()).collect();
    let (mut smooth_ones, mut corners) = (0, 0);
    for vertex in 0..mesh.0.len() {
        let tangents: Vec<Vec3> = boundary
            .iter()
            .filter_map(|edge| match edge.vertices() {
                [low, _] if low == vertex => Some(edge.curve().start_tangent()),
                [_, high] if high == vertex => Some(-edge.curve().end_tangent()),
                _ => None,
            })
            .collect();
        let [a, b] = tangents[..] else { continue };
        let kink = a.angle(-b);
        if kink > 1.0 {
            corners += 1;
        } else {
            // Rounding of two directions.
            assert!(kink < 1e-14, "vertex {vertex}: {kink}");
            smooth_ones += 1;
        }
    }
    assert_eq!((smooth_ones, corners), (20, 4));
}

#[test]
fn measures_of_a_sphere() {
    let mesh = shapes::quartered(shapes::icosphere(), shapes::on_sphere);
    let measure = SmoothMesh::new(&mesh.0, &mesh.1, VertexNormals::SphereWeighted).unwrap().measure().unwrap();
    let (area, volume) = (4.0 * PI, 4.0 / 3.0 * PI);
    // The surface is within 2.1e-7 of the sphere with 320 triangles.
    assert!((measure.area / area - 1.0).abs() < 1e-6, "{measure:?}");
    assert!((measure.volume.unwrap() / volume - 1.0).abs() < 1e-6, "{measure:?}");
    assert!(measure.area_error < 1e-4 * area && measure.volume_error < 1e-4 * volume, "{measure:?}");
}

/// Quadrature against meshes: volumes of N and 2N divisions, extrapolated.
#[test]
fn measures_agree_with_fine_meshes() {
    for (name, mesh) in shapes::all() {
        let surface = smooth(&mesh);
        let measure = surface.measure().unwrap();
        let [coarse, fine] = [12, 24].map(|n| surface.tessellate(n).unwrap());
        let extrapolated = |f: &dyn Fn(&cyclide::mesh::SurfaceMesh) -> f64| (4.0 * f(&fine) - f(&coarse)) / 3.0;
        let area = extrapolated(&|m| m.area());
        // The error of meshes is not a pure square beside the corners, where second derivatives jump.
        assert!((area / measure.area - 1.0).abs() < 3e-4, "{name}: {area} {measure:?}");
        if let Some(volume) = measure.volume {
            let mesh_volume = extrapolated(&|m| m.volume());
            assert!((mesh_volume / volume - 1.0).abs() < 3e-4, "{name}: {mesh_volume} {measure:?}");
        }
    }
}

#[test]
fn given_normals_are_used_and_backward_ones_are_told() {
    let mesh = shapes::icosahedron();
    let radial: Vec<Vec3> = mesh.0.iter().map(|p| p.to_vec() * 2.5).collect();
    let given = SmoothMesh::new(&mesh.0, &mesh.1, VertexNormals::Given(&radial)).unwrap();
    assert!(given.warnings().is_empty());
    // Angle-weighted normals of vertices on a sphere are radial by symmetry here.
    for (a, b) in patches(&given).zip(patches(&smooth(&mesh))) {
        assert!(a.point([1.0, 2.0, 3.0]).unwrap().distance(b.point([1.0, 2.0, 3.0]).unwrap()) < 1e-14);
    }
    let mut turned = radial.clone();
    // Exactly opposite ones would differ by the chords to the neighbors and leave nothing across.
    turned[4] = Vec3::new(0.3, -0.2, 0.5) - turned[4];
    let folded = SmoothMesh::new(&mesh.0, &mesh.1, VertexNormals::Given(&turned)).unwrap();
    let found = folded.warnings();
    assert!(found[1..].iter().all(|warning| warning.reason() == "folds-back"), "{found:?}");
    let warning = &found[0];
    assert_eq!(warning.reason(), "normal-faces-backward");
    assert!(warning.to_string().contains("5 normal(s)") && warning.to_string().contains("vertex 4"), "{warning}");
}
