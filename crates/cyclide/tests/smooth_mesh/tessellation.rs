//! Meshes of smooth surfaces.

use crate::laws::smooth;
use crate::shapes;
use cyclide::{
    Point3, Vec3,
    mesh::{MOST_PIECES, MeshFace, SurfaceMesh},
};
use std::collections::HashMap;

/// How often each directed edge between positions is used, by the bits of its ends.
fn directed_edges(mesh: &SurfaceMesh) -> HashMap<[[u64; 3]; 2], usize> {
    let bits = |p: Point3| p.to_array().map(f64::to_bits);
    let mut edges = HashMap::new();
    for face in &mesh.faces {
        let corners = face.corners();
        for (k, corner) in corners.iter().enumerate() {
            let next = corners[(k + 1) % corners.len()];
            let ends = [corner, &next].map(|c| bits(mesh.positions[c.position]));
            *edges.entry(ends).or_insert(0) += 1;
        }
    }
    edges
}

#[test]
fn meshes_are_watertight_to_the_bit() {
    for (name, mesh) in shapes::all() {
        let surface = smooth(&mesh);
        for divisions in [1, 2, 3, 7] {
            let mesh = surface.tessellate(divisions).unwrap();
            assert_eq!(mesh.faces.len(), surface.triangles().len() * divisions * divisions);
            assert_eq!(mesh.sources.len(), mesh.faces.len());
            let edges = directed_edges(&mesh);
            assert!(edges.values().all(|uses| *uses == 1), "{name} {divisions}");
            let open = edges.keys().filter(|[a, b]| !edges.contains_key(&[*b, *a])).count();
            let boundary = surface.edges().iter().filter(|edge| edge.triangles().1.is_none()).count();
            assert_eq!(open, boundary * divisions, "{name} {divisions}");
            // Positions are not repeated, and all of them are used.
            let mut used = vec![false; mesh.positions.len()];
            mesh.faces.iter().flat_map(MeshFace::corners).for_each(|c| used[c.position] = true);
            assert!(used.iter().all(|u| *u), "{name} {divisions}");
        }
    }
}

#[test]
fn normals_of_the_mesh_are_those_of_the_surface() {
    for (name, mesh) in shapes::all() {
        let surface = smooth(&mesh);
        let n = 6;
        let mesh = surface.tessellate(n).unwrap();
        for (face, source) in mesh.faces.iter().zip(&mesh.sources) {
            let MeshFace::Triangle(corners) = face else { panic!("triangles only") };
            let [p, q, r] = corners.map(|c| mesh.positions[c.position]);
            let flat = (q - p).cross(r - p).unit().unwrap();
            for corner in corners {
                let normal: Vec3 = mesh.normals[corner.normal];
                assert!((normal.length() - 1.0).abs() < 1e-14);
                // Seven degrees of a triangle of the cube, whose faces bulge, are 45 at most over the sixth part of an edge.
                assert!(normal.dot(flat) > 0.7, "{name} {source:?}: {}", normal.dot(flat));
            }
            // The source says where: its middle is next to the triangle.
            let [s, t] = [source.s, source.t].map(|r| 0.5 * (r[0] + r[1]));
            let patch = surface.triangle(source.face).unwrap();
            let middle = patch.point([s, t, (1.0 - s - t).max(0.0)]).unwrap();
            assert!(middle.distance(p) < 2.0 * p.distance(q).max(p.distance(r)), "{name} {source:?}");
        }
    }
}

#[test]
fn tolerances_are_kept_at_samples_that_were_not_measured() {
    for (name, mesh) in shapes::all() {
        let surface = smooth(&mesh);
        for tolerance in [1e-2, 1e-3] {
            let fine = surface.tessellate_within(tolerance).unwrap();
            assert!(fine.mesh.bound <= tolerance, "{name}");
            assert_eq!(fine.mesh.bound.to_bits(), (1.25 * fine.deviation).to_bits());
            assert_eq!(fine.mesh.faces.len(), surface.triangles().len() * fine.divisions * fine.divisions);
            // Not many more than needed: three fifths as many divisions are too few.
            if fine.divisions > 4 {
                assert!(surface.sampled_deviation(fine.divisions * 3 / 5).unwrap() > tolerance, "{name} {tolerance}");
            }
            for (face, source) in fine.mesh.faces.iter().zip(&fine.mesh.sources).step_by(11) {
                let [a, b, c] = [0, 1, 2].map(|k| fine.mesh.positions[face.corners()[k].position]);
                let normal = (b - a).cross(c - a).unit().unwrap();
                // Between the middle and a corner of the cell.
                let at = |w: f64| source.s[0] * w + source.s[1] * (1.0 - w);
                let (s, t) = (at(0.6), source.t[0] * 0.6 + source.t[1] * 0.4);
                let p = surface.triangle(source.face).unwrap().point([s, t, (1.0 - s - t).max(0.0)]).unwrap();
                let off = normal.dot(p - a).abs();
                // Half a cell away it may be that of a neighbor.
                assert!(off < 4.0 * tolerance, "{name} {tolerance}: {off:e}");
            }
        }
    }
}

#[test]
fn the_number_of_divisions_grows_like_the_root_of_the_tolerance() {
    let surface = smooth(&shapes::icosphere());
    let divisions: Vec<usize> =
        [1e-1, 1e-2, 1e-3, 1e-4].iter().map(|t| surface.tessellate_within(*t).unwrap().divisions).collect();
    for pair in divisions.windows(2) {
        let ratio = pair[1] as f64 / pair[0] as f64;
        assert!((2.3..4.3).contains(&ratio), "{divisions:?}: the root of 10 but for whole numbers");
    }
}

/// Round the corners of the border the lines of the surface bend within it, by an angle that does not fall with the size of the parts: in a
/// plane only the border leaves the mesh, a circle here.
#[test]
fn what_bends_within_the_surface_needs_no_divisions() {
    for corners in [7_u32, 24] {
        let at = |k: u32| (std::f64::consts::TAU * f64::from(k) / f64::from(corners)).sin_cos();
        let rim = (0..corners).map(|k| Point3::new(at(k).1, at(k).0, 0.0));
        let points: Vec<Point3> = std::iter::once(Point3::ORIGIN).chain(rim).collect();
        let count = corners as usize;
        let triangles: Vec<[usize; 3]> = (0..count).map(|k| [0, 1 + k, 1 + (k + 1) % count]).collect();
        let disc = smooth(&(points, triangles));
        for tolerance in [1e-2, 1e-3, 1e-4, 1e-5] {
            let made = disc.tessellate_within(tolerance).unwrap();
            // A chord of the circle is off it by 1 - cos of half its angle.
            let is_near = |divisions: usize| {
                let half = std::f64::consts::PI / f64::from(corners) / divisions as f64;
                1.25 * (1.0 - half.cos()) <= tolerance
            };
            let n = made.divisions;
            assert!(is_near(n), "{corners} {tolerance}: {n}");
            // Four fifths of the divisions are too few.
            assert!(n == 1 || !is_near((4 * n / 5).max(1)), "{corners} {tolerance}: {n}");
        }
    }
}

#[test]
fn too_many_triangles_are_refused_before_they_are_made() {
    let surface = smooth(&shapes::icosahedron());
    assert_eq!(surface.tessellate(0).unwrap_err().reason(), "parameter-out-of-range");
    let most = ((MOST_PIECES / 20) as f64).sqrt() as usize;
    assert_eq!(surface.tessellate(most + 1).unwrap_err().reason(), "too-many-pieces");
    assert_eq!(surface.tessellate(usize::MAX).unwrap_err().reason(), "too-many-pieces");
    assert_eq!(surface.tessellate_within(1e-15).unwrap_err().reason(), "too-many-pieces");
    for (tolerance, reason) in
        [(0.0, "tolerance-not-positive"), (f64::NAN, "tolerance-not-positive"), (f64::INFINITY, "not-finite")]
    {
        assert_eq!(surface.tessellate_within(tolerance).unwrap_err().reason(), reason);
    }
}

#[test]
fn vertices_without_triangles_are_left_out() {
    let (mut points, triangles) = shapes::tetrahedron();
    points.insert(0, Point3::new(f64::NAN, 0.0, 0.0));
    let triangles: Vec<[usize; 3]> = triangles.into_iter().map(|t| t.map(|v| v + 1)).collect();
    let mesh = smooth(&(points, triangles)).tessellate(3).unwrap();
    assert_eq!(mesh.positions.len(), 4 + 6 * 2 + 4);
    assert!(mesh.positions.iter().all(|p| p.is_finite()));
}
