//! Meshes that are none, and random ones: named errors, nothing else.

use crate::shapes;
use cyclide::{
    Point3, Vec3,
    surface::{NormalWeights, SmoothMesh, SmoothTriangle, VertexNormals},
};
use proptest::prelude::*;

fn refused(points: &[Point3], triangles: &[[usize; 3]]) -> cyclide::Error {
    SmoothMesh::new(points, triangles, VertexNormals::AngleWeighted).unwrap_err()
}

#[test]
fn what_is_no_mesh_is_refused_by_number() {
    let (points, triangles) = shapes::tetrahedron();
    assert_eq!(refused(&points, &[]).reason(), "no-triangles");
    let error = refused(&points, &[[0, 1, 2], [0, 4, 1]]);
    assert_eq!((error.reason(), error.index()), ("no-such-vertex", Some(1)));
    for degenerate in [[2, 1, 2], [0, 0, 0]] {
        let error = refused(&points, &[triangles[0], degenerate]);
        assert_eq!((error.reason(), error.index()), ("degenerate-triangle", Some(1)));
    }
    let mut bent = points.clone();
    bent[3] = bent[0].lerp(bent[1], 0.25);
    let error = refused(&bent, &triangles);
    assert_eq!((error.reason(), error.index()), ("degenerate-triangle", Some(2)));
    let mut more = triangles.clone();
    more.push([0, 1, 3]);
    let error = refused(&points, &more);
    assert_eq!(error.reason(), "non-manifold-edge");
    assert!(error.to_string().contains("3 triangles"), "{error}");
    let mut turned = triangles.clone();
    turned[2].swap(0, 1);
    let error = refused(&points, &turned);
    assert_eq!(error.reason(), "inconsistent-orientation");
    assert!(error.to_string().contains("triangles 0 and 2 both run from vertex"), "{error}");
    let mut far = points.clone();
    far[1] = Point3::new(0.0, f64::NAN, 0.0);
    assert_eq!((refused(&far, &triangles).reason(), refused(&far, &triangles).index()), ("not-finite", Some(0)));
    far[1] = Point3::new(0.0, 1e160, 0.0);
    assert_eq!(refused(&far, &triangles).reason(), "parameter-out-of-range");
    // Two triangles back to back.
    assert_eq!(refused(&points, &[[0, 1, 2], [0, 2, 1]]).reason(), "undefined-normal");
}

#[test]
fn normals_that_do_not_fit_are_refused() {
    let (points, triangles) = shapes::octahedron();
    let radial: Vec<Vec3> = points.iter().map(|p| p.to_vec()).collect();
    let with = |change: &dyn Fn(&mut Vec<Vec3>)| {
        let mut normals = radial.clone();
        change(&mut normals);
        SmoothMesh::new(&points, &triangles, VertexNormals::Given(&normals)).map(|_| ()).unwrap_err().reason()
    };
    assert_eq!(with(&|n| n.truncate(5)), "count-differs");
    assert_eq!(with(&|n| n[2] = Vec3::ZERO), "undefined-normal");
    assert_eq!(with(&|n| n[2] = Vec3::new(0.0, f64::NAN, 1.0)), "not-finite");
    assert_eq!(with(&|n| n[0] = Vec3::new(1.0, -1.0, 0.0)), "normal-along-edge");
    // At the ends of the edge from X to Y.
    assert_eq!(with(&|n| (n[0], n[1]) = (Vec3::Z, -Vec3::Z)), "opposite-normals");
    let flat = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
    let reason = |normals| SmoothTriangle::new(flat, normals).unwrap_err().reason();
    assert_eq!(reason([Vec3::X, Vec3::Z, Vec3::Z]), "normal-along-edge");
    assert_eq!(reason([-Vec3::Z, Vec3::Z, Vec3::Z]), "opposite-normals");
    assert_eq!(reason([Vec3::ZERO, Vec3::Z, Vec3::Z]), "undefined-normal");
}

#[test]
fn thin_and_badly_scaled_triangles_are_smooth_too() {
    // Aspect ratios up to 1e9, one by one beside a good triangle.
    for thin in [1e-3, 1e-6, 1e-9] {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.1], [0.3, thin, 0.05], [0.5, -0.8, -0.1]].map(Point3::from);
        let surface = SmoothMesh::new(&points, &[[0, 1, 2], [1, 0, 3]], VertexNormals::AngleWeighted).unwrap();
        let mesh = surface.tessellate(8).unwrap();
        assert!(mesh.positions.iter().all(|p| p.is_finite()) && mesh.normals.iter().all(|n| n.is_finite()));
    }
    for scale in [1e-140, 1e-6, 1e6, 1e140] {
        let (points, triangles) = shapes::icosahedron();
        let points: Vec<Point3> = points.iter().map(|p| Point3::ORIGIN + p.to_vec() * scale).collect();
        let surface = SmoothMesh::new(&points, &triangles, VertexNormals::AngleWeighted).unwrap();
        let mesh = surface.tessellate(4).unwrap();
        for p in mesh.positions {
            assert!((p.distance(Point3::ORIGIN) / scale - 1.0).abs() < 5e-4, "{scale}");
        }
    }
}

/// Two cones that touch with their tips: a vertex with two fans has a normal for each.
#[test]
fn fans_that_touch_in_a_vertex_are_apart() {
    let (points, triangles) = shapes::disc(6);
    let lifted: Vec<Point3> = points.iter().map(|p| Point3::new(p.x, p.y, 0.5 * p.x.hypot(p.y))).collect();
    let lowered = points.iter().take(6).map(|p| Point3::new(p.x, p.y, -0.5));
    let all: Vec<Point3> = lifted.into_iter().chain(lowered).collect();
    let mirrored = triangles.iter().map(|&[c, a, b]| [c, b + 7, a + 7]);
    let both: Vec<[usize; 3]> = triangles.iter().copied().chain(mirrored).collect();
    let surface = SmoothMesh::new(&all, &both, VertexNormals::AngleWeighted).unwrap();
    assert_eq!(surface.normals().len(), 14);
    assert!(surface.tessellate(5).is_ok());
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -1.0..1.0, 1 => Just(0.0), 1 => Just(1.0), 1 => -1e-9..1e-9, 1 => -1e100..1e100]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Random points and triangles: a surface with finite points and unit normals, or a named error.
    #[test]
    fn random_meshes_are_meshed_or_refused(
        points in prop::collection::vec([number(), number(), number()], 3..8),
        triangles in prop::collection::vec([0_usize..8, 0_usize..8, 0_usize..8], 1..5),
        crease in prop::option::of(0.0..3.2),
    ) {
        let points: Vec<Point3> = points.into_iter().map(Point3::from).collect();
        let normals = crease.map_or(VertexNormals::AngleWeighted, |angle| VertexNormals::Creased { angle, weights: NormalWeights::Angle });
        let made = SmoothMesh::new(&points, &triangles, normals).and_then(|surface| surface.tessellate(5));
        match made {
            Ok(mesh) => {
                prop_assert!(mesh.positions.iter().all(|p| p.is_finite()));
                prop_assert!(mesh.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-12));
            }
            Err(error) => prop_assert!(!error.reason().is_empty() && !error.to_string().contains("NaN")),
        }
    }

    /// One triangle with any normals, which is never refused for its topology.
    #[test]
    fn random_triangles_are_finite_or_refused(
        corners in [[-1.0..1.0, -1.0..1.0, -1.0..1.0], [-1.0..1.0, -1.0..1.0, -1.0..1.0], [-1.0..1.0, -1.0..1.0, -1.0..1.0]],
        normals in [[number(), number(), number()], [number(), number(), number()], [number(), number(), number()]],
        at in [0.0..1.0, 0.0..1.0, 1e-12..1.0],
    ) {
        let Ok(patch) = SmoothTriangle::new(corners.map(Point3::from), normals.map(Vec3::from)) else { return Ok(()) };
        if let Ok((p, n)) = patch.point_and_normal(at) {
            prop_assert!(p.is_finite() && (n.length() - 1.0).abs() < 1e-12, "{patch:?}");
            prop_assert_eq!(p, patch.point(at).unwrap());
        }
    }
}
