//! Edges that are kept sharp.

use crate::shapes::{self, Mesh};
use cyclide::{
    Point3, Vec3,
    conformal::Mobius,
    mesh::MeshFace,
    surface::{NormalWeights, SmoothMesh, TriangleSurface, VertexNormals},
};
use std::f64::consts::{FRAC_PI_4, PI};

fn creased(mesh: &Mesh, angle: f64) -> SmoothMesh {
    SmoothMesh::new(&mesh.0, &mesh.1, VertexNormals::Creased { angle, weights: NormalWeights::Angle }).unwrap()
}

#[test]
fn a_cube_stays_a_cube() {
    let surface = creased(&shapes::cube(), FRAC_PI_4);
    assert_eq!(surface.edges().iter().filter(|edge| edge.is_sharp()).count(), 12);
    assert_eq!(surface.normals().len(), 24);
    let measure = surface.measure().unwrap();
    // Flat faces: every rule is exact.
    assert!((measure.area - 6.0).abs() < 1e-13 && (measure.volume.unwrap() - 1.0).abs() < 1e-14, "{measure:?}");
    // Flat faces need no parts.
    assert_eq!(surface.tessellate_within(1e-12).unwrap().divisions, 1);
    let mesh = surface.tessellate(4).unwrap();
    for face in &mesh.faces {
        let [a, b, c] = [0, 1, 2].map(|k| mesh.positions[face.corners()[k].position]);
        let flat = (b - a).cross(c - a).unit().unwrap();
        for corner in face.corners() {
            assert!((mesh.normals[corner.normal] - flat).length() < 1e-15);
        }
    }
}

/// The rims of a cylinder run in both tangent planes, so they are its circles.
#[test]
fn the_rims_of_a_cylinder_are_circles() {
    for n in [6, 9, 24] {
        let surface = creased(&shapes::cylinder(n), FRAC_PI_4 * 1.5);
        let sharp: Vec<_> = surface.edges().iter().filter(|edge| edge.is_sharp()).collect();
        assert_eq!(sharp.len(), 2 * n);
        for edge in sharp {
            assert!(edge.curve().is_arc());
            for k in 0..=10 {
                let p = edge.curve().point(f64::from(k) / 10.0);
                assert!((p.x.hypot(p.y) - 1.0).abs() < 1e-15 && [0.0, 1.0].contains(&p.z));
            }
        }
        let measure = surface.measure().unwrap();
        let mut off: f64 = 0.0;
        for index in 0..surface.triangles().len() {
            let patch = surface.triangle(index).unwrap();
            for (i, j) in [(1.0, 2.0), (3.0, 3.0), (5.0, 1.0), (2.0, 6.0)] {
                let p = patch.point([i, j, 9.0 - i - j]).unwrap();
                let flat = p.z.abs().min((p.z - 1.0).abs());
                off = off.max(flat.min((p.x.hypot(p.y) - 1.0).abs()));
            }
        }
        // Falls with the fourth power of the angle: 1.1e-2 for 6, 7.7e-5 for 24, most of it on the diagonals.
        let step = 2.0 * PI / n as f64;
        assert!(off < 2e-2 * step.powi(4), "{n}: {off:e}");
        assert!((measure.volume.unwrap() / PI - 1.0).abs() < 2e-2 * step.powi(4), "{n} {measure:?}");
    }
}

#[test]
fn creases_have_a_normal_on_each_side() {
    let n = 5;
    let surface = creased(&shapes::cylinder(9), 1.0);
    let mesh = surface.tessellate(n).unwrap();
    for face in &mesh.faces {
        let MeshFace::Triangle(corners) = face else { panic!("triangles only") };
        let [a, b, c] = corners.map(|c| mesh.positions[c.position]);
        let flat = (b - a).cross(c - a).unit().unwrap();
        for corner in corners {
            // A step of 40 degrees in five parts, and the skew of the triangles.
            assert!(mesh.normals[corner.normal].angle(flat) < 0.2);
        }
    }
    // Rims once more than positions, vertices on them too.
    let rims = 2 * 9 * n;
    assert_eq!(mesh.normals.len(), mesh.positions.len() + rims);
}

/// A crease that ends inside a face, and one beyond any angle.
#[test]
fn creases_may_end_anywhere() {
    let (mut points, triangles) = shapes::graph(6, |_, _| 0.0);
    // A ridge along the middle row that fades out.
    for (k, p) in points.iter_mut().enumerate() {
        let (i, j) = (k / 7, k % 7);
        if i == 3 {
            *p = Point3::new(p.x, p.y, 0.06 * (6 - j) as f64);
        }
    }
    let mesh = (points, triangles);
    let surface = creased(&mesh, 0.6);
    let sharp = surface.edges().iter().filter(|edge| edge.is_sharp()).count();
    assert!(sharp > 0 && sharp < 30, "{sharp}");
    assert!(surface.tessellate_within(1e-3).is_ok());
    assert!(creased(&mesh, PI).edges().iter().all(|edge| !edge.is_sharp()));
    for wrong in [-0.1, 4.0, f64::NAN] {
        let refused =
            SmoothMesh::new(&mesh.0, &mesh.1, VertexNormals::Creased { angle: wrong, weights: NormalWeights::Angle });
        assert_eq!(refused.unwrap_err().reason(), "angle-out-of-range");
    }
}

/// Normals given for corners that differ across edges make creases there; equal ones do not.
#[test]
fn normals_given_at_corners_say_where_creases_are() {
    let (points, triangles) = shapes::cube();
    let flat = |t: &[usize; 3]| {
        let [a, b, c] = t.map(|v| points[v]);
        (b - a).cross(c - a)
    };
    let faceted: Vec<[Vec3; 3]> = triangles.iter().map(|t| [flat(t); 3]).collect();
    let given = SmoothMesh::new(&points, &triangles, VertexNormals::GivenAtCorners(&faceted)).unwrap();
    let creased = creased(&(points.clone(), triangles.clone()), 1.0);
    // The diagonals of the faces are no creases.
    assert_eq!(given.edges().iter().filter(|edge| edge.is_sharp()).count(), 12);
    for t in 0..triangles.len() {
        for at in [[1.0, 1.0, 1.0], [3.0, 2.0, 0.0]] {
            let [p, q] = [&given, &creased].map(|mesh| mesh.triangle(t).unwrap().point(at).unwrap());
            assert!(p.distance(q) < 1e-15);
        }
    }
    // Those of the smooth surface, to four digits as files have them, give it back to these.
    let smooth = crate::laws::smooth(&(points.clone(), triangles.clone()));
    let digits = |n: Vec3| Vec3::from(n.to_array().map(|x| (1e4 * x).round() / 1e4));
    let corners: Vec<[Vec3; 3]> =
        smooth.corner_normals().iter().map(|c| c.map(|n| digits(smooth.normals()[n]))).collect();
    let read = SmoothMesh::new(&points, &triangles, VertexNormals::GivenAtCorners(&corners)).unwrap();
    assert!(read.edges().iter().all(|edge| !edge.is_sharp()));
    let apart = |t: usize| {
        let [p, q] = [&read, &smooth].map(|mesh| mesh.triangle(t).unwrap().point([1.0; 3]).unwrap());
        p.distance(q)
    };
    assert!((0..triangles.len()).all(|t| apart(t) < 1e-4));
    let wrong = |given: &[[Vec3; 3]]| {
        SmoothMesh::new(&points, &triangles, VertexNormals::GivenAtCorners(given)).unwrap_err().reason()
    };
    assert_eq!(wrong(&corners[1..]), "count-differs");
    assert_eq!(wrong(&vec![[Vec3::ZERO; 3]; 12]), "undefined-normal");
    assert_eq!(wrong(&vec![[Vec3::X * f64::NAN; 3]; 12]), "not-finite");
}

/// Creases stay creases however faint, and a mirror keeps the outer side outside.
#[test]
fn similar_images_keep_creases() {
    let mesh = shapes::cylinder(12);
    let surface = creased(&mesh, 0.6);
    let sharp = |mesh: &SmoothMesh| mesh.edges().iter().filter(|edge| edge.is_sharp()).count();
    assert!(sharp(&surface) > 0 && sharp(&surface) < surface.edges().len());
    let mirror = Mobius::reflection(Point3::new(0.3, 0.0, 1.0), Vec3::new(1.0, 2.0, -2.0)).unwrap();
    let TriangleSurface::Mesh(image) = TriangleSurface::from(surface.clone()).similar(&mirror).unwrap() else {
        panic!("a mesh")
    };
    assert_eq!(sharp(&image), sharp(&surface));
    let [own, other] = [&surface, &image].map(|mesh| mesh.measure().unwrap());
    // As many roundings as places of the quadrature.
    assert!((own.area / other.area - 1.0).abs() < 1e-12 && own.volume.is_some() == other.volume.is_some());
    for t in 0..mesh.1.len() {
        let (p, n) = surface.triangle(t).unwrap().point_and_normal([1.0, 2.0, 3.0]).unwrap();
        let (q, m) = image.triangle(t).unwrap().point_and_normal([1.0, 3.0, 2.0]).unwrap();
        assert!(mirror.map_point(p).unwrap().distance(q) < 1e-13);
        assert!((mirror.push_forward(p, n).unwrap() - m).length() < 1e-12);
    }
}
