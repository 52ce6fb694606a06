//! Meshes of rational faces on planes and cylinders, whose parameters run unevenly on them.

use super::checks::{descent_distance, edges, polygon, polygon_distance};
use cyclide::{
    Point3,
    construct::{PipeTee, TeeBranch, TeeMain},
    mesh::{SurfaceMesh, tessellate},
    rational::RationalBezierSurface,
    surface::PatchKind,
    topology::{Body, FaceSurface},
};

fn tee(angle: f64, offset: f64) -> Body {
    let main = TeeMain { radius: 30.0, taper: 0.0, ends: [-90.0, 90.0] };
    let branch = TeeBranch { angle, offset, ..TeeBranch::upright(18.0, 80.0, 6.0) };
    PipeTee::new(main, vec![branch]).and_then(|tee| tee.made()).unwrap().body
}

/// The polygons of a face.
fn polygons(mesh: &SurfaceMesh, face: usize) -> Vec<Vec<Point3>> {
    let own = mesh.faces.iter().zip(&mesh.sources).filter(|(_, source)| source.face == face);
    own.map(|(polygon_of, _)| polygon(mesh, polygon_of)).collect()
}

/// Largest distance of places of the surface from the polygons, and of places of the polygons from the surface.
fn deviation(surface: &RationalBezierSurface, polygons: &[Vec<Point3>]) -> [f64; 2] {
    let grid = || (0..=24).flat_map(|i| (0..=24).map(move |j| (f64::from(i) / 24.0, f64::from(j) / 24.0)));
    let nearest = |p: Point3| polygons.iter().map(|q| polygon_distance(p, q)).fold(f64::INFINITY, f64::min);
    let there = grid().map(|(s, t)| nearest(surface.point(s, t))).fold(0.0, f64::max);
    let back = |p: Point3| {
        let start = grid().min_by(|a, b| {
            let off = |&(s, t): &(f64, f64)| surface.point(s, t).distance(p);
            off(a).total_cmp(&off(b))
        });
        let (s, t) = start.unwrap();
        descent_distance(surface, p, s, t)
    };
    // Middles of sides, and of the polygons.
    let places = polygons.iter().flat_map(|q| {
        let middle = q.iter().skip(1).fold(q[0].to_vec(), |sum, p| sum + p.to_vec()) / q.len() as f64;
        let sides = (0..q.len()).map(|k| q[k].midpoint(q[(k + 1) % q.len()]));
        sides.chain([Point3::ORIGIN + middle]).collect::<Vec<_>>()
    });
    [there, places.map(back).fold(0.0, f64::max)]
}

#[test]
fn faces_on_planes_and_cylinders_are_within_the_bound() {
    for (angle, offset) in [(1.57, 0.0), (0.9, 7.0)] {
        let body = tee(angle, offset);
        for tolerance in [3.0, 0.3] {
            let mesh = tessellate(&body, tolerance).unwrap();
            let twice = |uses: Vec<bool>| uses.len() == 2 && uses[0] != uses[1];
            assert!(edges(&mesh).into_values().all(twice), "closed");
            assert!(mesh.bound <= tolerance);
            for (index, face) in body.outer.faces().iter().enumerate() {
                let FaceSurface::Rational(surface) = &face.surface else { panic!("a rational face") };
                if matches!(surface.recognize(), PatchKind::Cyclide) {
                    continue;
                }
                let [there, back] = deviation(surface, &polygons(&mesh, index));
                assert!(there <= mesh.bound && back <= mesh.bound, "{index}: {there:e} {back:e} {:e}", mesh.bound);
            }
        }
    }
}

#[test]
fn walls_are_cut_as_their_rings_are() {
    // Rulings between uneven curves: second derivatives of the parameters would ask for cuts along them.
    let body = tee(0.9, 7.0);
    let mesh = tessellate(&body, 0.02).unwrap();
    for (index, face) in body.outer.faces().iter().enumerate() {
        let FaceSurface::Rational(surface) = &face.surface else { panic!("a rational face") };
        if !matches!(surface.degrees(), [6 | 8, 1]) {
            continue;
        }
        assert!(matches!(surface.recognize(), PatchKind::Cylinder { .. }));
        let cells = mesh.sources.iter().filter(|source| source.face == index);
        assert!(cells.into_iter().all(|source| source.t[1] - source.t[0] >= 1.0), "{index}");
        // Nor is the mesh folded on the face: triangles are on the outer side of the normals.
        for (polygon_of, source) in mesh.faces.iter().zip(&mesh.sources).filter(|(_, source)| source.face == index) {
            let q = polygon(&mesh, polygon_of);
            let (s, t) = (0.5 * (source.s[0] + source.s[1]), 0.5 * (source.t[0] + source.t[1]));
            let jet = surface.jet(s, t);
            let side = if face.same_sense { 1.0 } else { -1.0 };
            let normal = jet.ds.cross(jet.dt) * side;
            assert!((q[1] - q[0]).cross(q[2] - q[0]).dot(normal) > 0.0, "{index}");
        }
    }
}
