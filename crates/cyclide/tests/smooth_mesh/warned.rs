//! What surfaces are warned of: folds, edges smoothed away, borders that lie on each other.

use crate::shapes::{self, Mesh};
use cyclide::{
    Point3, Warning,
    surface::{NormalWeights, SmoothMesh, VertexNormals},
    warning::MeshWarning,
};
use std::f64::consts::{FRAC_PI_2, PI};

fn warnings(mesh: &Mesh, normals: VertexNormals) -> Vec<Warning> {
    SmoothMesh::new(&mesh.0, &mesh.1, normals).unwrap().warnings()
}

fn reasons(mesh: &Mesh, normals: VertexNormals) -> Vec<&'static str> {
    warnings(mesh, normals).iter().map(Warning::reason).collect()
}

/// The unit cube stretched to a box.
fn boxed(sizes: [f64; 3]) -> Mesh {
    let (points, triangles) = shapes::cube();
    let low = points.iter().map(|p| p.x).fold(f64::INFINITY, f64::min);
    let size = points.iter().map(|p| p.x).fold(f64::NEG_INFINITY, f64::max) - low;
    let stretched = |p: &Point3| {
        let at = [p.x, p.y, p.z].map(|x| (x - low) / size);
        Point3::new(at[0] * sizes[0], at[1] * sizes[1], at[2] * sizes[2])
    };
    (points.iter().map(stretched).collect(), triangles)
}

#[test]
fn smooth_shapes_are_not_warned_of() {
    let fine = shapes::quartered(shapes::icosphere(), shapes::on_sphere);
    for mesh in [shapes::icosphere(), fine, shapes::torus(16, 10), shapes::disc(24)] {
        assert_eq!(reasons(&mesh, VertexNormals::AngleWeighted), Vec::<&str>::new());
    }
    // Creases that are asked for are kept, and others were.
    let creased = VertexNormals::Creased { angle: 0.6, weights: NormalWeights::Angle };
    assert_eq!(reasons(&boxed([4.0, 3.0, 2.0]), creased), Vec::<&str>::new());
    assert_eq!(reasons(&shapes::cylinder(24), creased), Vec::<&str>::new());
}

#[test]
fn sharp_edges_that_are_smoothed_away_are_counted() {
    let mesh = boxed([40.0, 30.0, 20.0]);
    let found = warnings(&mesh, VertexNormals::AngleWeighted);
    let sharp = found.iter().find(|warning| warning.reason() == "sharp-edges-smoothed").unwrap();
    let Warning::Mesh(MeshWarning::SharpEdgesSmoothed { angle, count, limit, .. }) = sharp else { panic!("{sharp}") };
    assert!(*count == 12 && (angle - FRAC_PI_2).abs() < 1e-12 && *limit < *angle, "{sharp}");
    assert!(sharp.to_string().contains("12 edge(s)") && sharp.to_string().contains("`crease_angle`"), "{sharp}");
    // Normals that are given are meant so.
    let centre = Point3::new(20.0, 15.0, 10.0);
    let normals: Vec<_> = mesh.0.iter().map(|p| *p - centre).collect();
    assert!(!reasons(&mesh, VertexNormals::Given(&normals)).contains(&"sharp-edges-smoothed"));
}

#[test]
fn folds_are_found_with_their_edge() {
    for sizes in [[1.0, 1.0, 0.01], [1.0, 1.0, 100.0]] {
        let mesh = boxed(sizes);
        let surface = SmoothMesh::new(&mesh.0, &mesh.1, VertexNormals::AngleWeighted).unwrap();
        let found = surface.warnings();
        let fold = found.iter().find(|warning| warning.reason() == "folds-back").unwrap_or_else(|| panic!("{sizes:?}"));
        let &Warning::Mesh(MeshWarning::FoldsBack { vertices: [from, to], triangle, angle, count }) = fold else {
            panic!("{fold}")
        };
        assert!(angle > 0.9 * PI && count > 0 && from < to, "{fold}");
        assert!(mesh.1[triangle].contains(&from) && mesh.1[triangle].contains(&to), "{fold}");
        // What the comparison finds at its places.
        assert!(surface.comparison().unwrap().jump > FRAC_PI_2, "{sizes:?}");
    }
}

#[test]
fn borders_that_lie_on_each_other_are_not_joined() {
    // Every triangle with vertices of its own, a millionth apart.
    let (points, triangles) = shapes::icosphere();
    let off = |k: usize| 1e-6 * ((k * 7919) as f64).sin();
    let loose: Vec<Point3> = triangles
        .as_flattened()
        .iter()
        .enumerate()
        .map(|(k, &v)| points[v] + (Point3::new(off(k), off(k + 1), off(k + 2)) - Point3::ORIGIN))
        .collect();
    let own: Vec<[usize; 3]> = (0..triangles.len()).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    let found = warnings(&(loose, own), VertexNormals::AngleWeighted);
    let [Warning::Mesh(MeshWarning::LooseBorders { count, borders, gap, .. })] = found[..] else { panic!("{found:?}") };
    assert!(count == 240 && borders == 240 && gap > 1e-8 && gap < 4e-6, "{found:?}");
    // A vertex inside an edge: the triangle on one side is cut there, the other is not.
    let (mut points, mut triangles) = shapes::icosphere();
    let [a, b, c] = triangles[0];
    points.push(points[a].midpoint(points[b]));
    triangles[0] = [a, points.len() - 1, c];
    triangles.push([points.len() - 1, b, c]);
    let found = warnings(&(points, triangles), VertexNormals::AngleWeighted);
    let [Warning::Mesh(MeshWarning::LooseBorders { vertices, count: 3, borders: 3, gap })] = found[..] else {
        panic!("{found:?}")
    };
    assert!(gap < 1e-15 && vertices.iter().any(|v| [a, b].contains(v)), "{found:?}");
    assert_eq!(found[0].reason(), "open-seam");
    // A hole is one.
    let (points, mut triangles) = shapes::icosphere();
    triangles.pop();
    assert_eq!(reasons(&(points, triangles), VertexNormals::AngleWeighted), Vec::<&str>::new());
}
