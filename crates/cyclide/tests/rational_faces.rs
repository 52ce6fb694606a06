//! Shells of rational faces: what they are, measured, cut and tessellated as shells of patches are.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use cyclide::{
    Point3, Vec3,
    conformal::{Conformal as _, Mobius},
    mesh::{MeshFace, SurfaceMesh, tessellate},
    rational::RationalBezierSurface,
    surface::{CyclidePatch, ParamSurface},
    topology::{Body, EdgeCurve, FaceGeometry as _, FaceSurface, Shell, ShellEdge, surface_joints},
};
use cyclide_testkit::rational_faces::{egg, egg_profile, smooth_pair};
use std::collections::HashMap;
use std::f64::consts::PI;

/// The integral over `[0, 1]` by Simpson's rule: below 1e-12 for profiles this smooth.
fn simpson(f: impl Fn(f64) -> f64) -> f64 {
    let n = 2000;
    let at = |k: usize| f(k as f64 / n as f64);
    let inner: f64 = (1..n).map(|k| if k % 2 == 1 { 4.0 } else { 2.0 } * at(k)).sum();
    (at(0) + inner + at(n)) / (3 * n) as f64
}

#[test]
fn an_egg_is_a_closed_solid_with_the_measures_of_its_profile() {
    let egg = egg();
    assert!(egg.is_solid());
    let volume = simpson(|x| {
        let [r, _, _, dz] = egg_profile(x);
        PI * r * r * dz
    });
    let area = simpson(|x| {
        let [r, _, dr, dz] = egg_profile(x);
        2.0 * PI * r * dr.hypot(dz)
    });
    assert!((egg.outer.known_volume().unwrap() / volume - 1.0).abs() < 1e-11);
    assert!((egg.outer.known_area().unwrap() / area - 1.0).abs() < 1e-10);
    // The largest radius is that of the box, to what the box may be too large.
    let radius = (0..=4000).map(|k| egg_profile(f64::from(k) / 4000.0)[0]).fold(0.0, f64::max);
    let bounds = egg.bounds();
    for side in [bounds.max.x, bounds.max.y, -bounds.min.x, -bounds.min.y] {
        assert!(side >= radius && side < radius + 1e-6, "{side} {radius}");
    }
    assert!((bounds.min.z + 1.0).abs() < 1e-12 && bounds.max.z >= 1.5);
    for joint in surface_joints(&egg.outer) {
        assert!(joint.gap < 1e-14 && joint.angle < 1e-12, "{joint:?}");
    }
}

#[test]
fn a_smooth_pair_meets_without_a_crease() {
    let pair = smooth_pair();
    let joints = surface_joints(&pair);
    assert_eq!(joints.len(), 1);
    assert!(joints[0].gap < 1e-14 && joints[0].angle < 1e-12, "{joints:?}");
    assert!(!pair.is_closed());
    let [a, b] = [&pair.faces()[0].surface, &pair.faces()[1].surface];
    assert!(matches!(a, FaceSurface::Rational(_)) && a.patch().is_none() && b.is_regular());
}

/// Free and repeated sides of the polygons of a mesh.
fn open_sides(mesh: &SurfaceMesh) -> usize {
    let mut sides: HashMap<(usize, usize), i32> = HashMap::new();
    for face in &mesh.faces {
        let corners: Vec<usize> = face.corners().iter().map(|c| c.position).collect();
        for k in 0..corners.len() {
            let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
            *sides.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
        }
    }
    sides.values().filter(|uses| **uses != 0).count()
}

#[test]
fn meshes_are_watertight_and_within_their_bound() {
    let egg = egg();
    let pair = Body { outer: smooth_pair(), voids: Vec::new() };
    for tolerance in [0.1, 1e-2, 1e-3] {
        for body in [&egg, &pair] {
            let mesh = tessellate(body, tolerance).unwrap();
            assert!(mesh.bound <= tolerance && mesh.bound > 0.02 * tolerance, "{} {tolerance}", mesh.bound);
            assert_eq!(mesh.faces.len(), mesh.sources.len());
            assert!(mesh.faces.iter().all(|face| matches!(face, MeshFace::Triangle(_))));
            let faces = body.outer.faces();
            for (polygon, source) in mesh.faces.iter().zip(&mesh.sources) {
                let face = &faces[source.face];
                let [a, b, c] = [0, 1, 2].map(|k| mesh.positions[polygon.corners()[k].position]);
                // The middle of a triangle is near the cell.
                let middle = Point3::ORIGIN + (a.to_vec() + b.to_vec() + c.to_vec()) / 3.0;
                let mut nearest = f64::INFINITY;
                for k in 0..=24 {
                    for l in 0..=24 {
                        let at = |[from, to]: [f64; 2], k: usize| from + (to - from) * k as f64 / 24.0;
                        nearest = nearest.min(face.surface.point(at(source.s, k), at(source.t, l)).distance(middle));
                    }
                }
                let step = a.distance(b).max(b.distance(c)).max(c.distance(a)) / 24.0;
                assert!(nearest <= mesh.bound + step, "{nearest}");
                // Counter-clockwise seen from outside.
                let normal = (b - a).cross(c - a);
                let outward = mesh.normals[polygon.corners()[0].normal];
                assert!(normal.dot(outward) > 0.0, "{normal:?} {outward:?}");
            }
        }
        let mesh = tessellate(&egg, tolerance).unwrap();
        assert_eq!(open_sides(&mesh), 0);
        let volume = egg.outer.volume();
        assert!(mesh.volume() > 0.0 && (mesh.volume() - volume).abs() <= mesh.bound * egg.outer.area() * 1.1);
    }
}

#[test]
fn cuts_and_similar_images_keep_the_surface() {
    let egg = egg();
    let halved = egg.outer.halved(|_, _| [true, true], 2).unwrap();
    assert_eq!(halved.faces().len(), 16 * egg.outer.faces().len());
    let checked = Shell::new(halved.vertices().to_vec(), halved.edges().to_vec(), halved.faces().to_vec());
    assert!(checked.unwrap().is_closed());
    assert!((halved.volume() / egg.outer.volume() - 1.0).abs() < 1e-12);
    let turn = Mobius::reflection(Point3::new(3.0, 0.0, 1.0), Vec3::new(1.0, 2.0, -2.0)).unwrap();
    let image = egg.transformed(&turn).unwrap();
    assert!((image.outer.volume() / egg.outer.volume() - 1.0).abs() < 1e-12 && image.is_solid());
    let inversion = Mobius::inversion(Point3::new(9.0, 1.0, 4.0), 3.0).unwrap();
    assert_eq!(egg.transformed(&inversion).unwrap_err().reason(), "not-a-similarity");
    // Far from the origin the volume is known as well.
    let far = egg.transformed(&Mobius::translation(Vec3::new(1e6, -2e6, 3e6)).unwrap()).unwrap();
    assert!((far.outer.volume() / egg.outer.volume() - 1.0).abs() < 1e-8);
}

/// The derivatives of a surface are the limits of differences, and its normal is across them.
fn derivatives_are_those_of_the_points(surface: &dyn ParamSurface) {
    let step = 1e-5;
    for [s, t] in [[0.2, 0.3], [0.5, 0.7], [0.9, 0.4]] {
        let (jet, at) = (surface.jet(s, t), |s, t| surface.point(s, t));
        let size = jet.ds.length() + jet.dt.length();
        assert!(jet.point.distance(at(s, t)) < 1e-14 * (1.0 + size));
        let ds = (at(s + step, t) - at(s - step, t)) / (2.0 * step);
        let dt = (at(s, t + step) - at(s, t - step)) / (2.0 * step);
        // The square of the step times third derivatives, and rounding over the step.
        assert!((jet.ds - ds).length() + (jet.dt - dt).length() < 1e-8 * size, "{jet:?} {ds:?} {dt:?}");
        let normal = surface.normal(s, t).unwrap();
        assert!((normal.dot(ds).abs() + normal.dot(dt).abs()) < 1e-8 * size && (normal.length() - 1.0).abs() < 1e-14);
    }
}

#[test]
fn every_kind_of_surface_has_the_derivatives_of_its_points() {
    let corners = [[-4.0, -3.0, 0.0], [4.0, -3.0, 0.0], [-3.0, 4.0, 0.0], [3.0, 4.0, 0.0]].map(Point3::from);
    let frame = [Vec3::new(8.0, -1.0, 4.0), Vec3::new(-1.0, 4.0, 3.0)];
    let patch = CyclidePatch::from_corners_and_frame(corners, frame[0], frame[1]).unwrap();
    derivatives_are_those_of_the_points(&patch);
    derivatives_are_those_of_the_points(&patch.to_rational());
    for face in egg().outer.faces() {
        derivatives_are_those_of_the_points(&face.surface);
    }
}

#[test]
fn what_is_no_shell_is_refused() {
    let pair = smooth_pair();
    let parts = || (pair.vertices().to_vec(), pair.edges().to_vec(), pair.faces().to_vec());
    let refused = |(v, e, f): (Vec<_>, Vec<ShellEdge>, Vec<_>), says: &str| {
        let error = Shell::new(v, e, f).unwrap_err();
        assert!(error.reason() == "not-a-shell" && error.to_string().contains(says), "{says}: {error}");
    };
    let (mut v, e, f) = parts();
    v[0].x += 1e-9;
    refused((v, e, f), "end at the vertices");
    // The same points at another speed.
    let (v, mut e, f) = parts();
    let EdgeCurve::Rational(curve) = &e[1].curve else { panic!("a rational edge") };
    let rows = curve.rows().iter().zip([1.0, 2.0, 4.0, 8.0]).map(|(row, k)| row.map(|x| x * k)).collect();
    e[1].curve = cyclide::rational::RationalBezier::new(rows).unwrap().into();
    refused((v, e, f), "another parameter");
    let (v, e, mut f) = parts();
    let FaceSurface::Rational(surface) = &f[0].surface else { panic!("a rational face") };
    let mut rows = surface.rows().to_vec();
    rows[5] = rows[5].map(|x| -x);
    f[0].surface = RationalBezierSurface::new([3, 3], rows).unwrap().into();
    refused((v, e, f), "not positive");
}

/// An octant of the unit sphere: the side t = 1 is one point.
fn octant() -> (CyclidePatch, RationalBezierSurface) {
    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]].map(Point3::from);
    let patch = CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap();
    (patch, patch.to_rational())
}

#[test]
fn jets_normals_lines_and_parts_are_those_of_the_patch() {
    let (patch, surface) = octant();
    for (s, t) in [(0.0, 0.0), (0.3, 0.2), (0.7, 0.9), (1.0, 0.5)] {
        let (a, b) = (patch.jet(s, t), surface.jet(s, t));
        let off = |v: Vec3, w: Vec3| (v - w).length();
        let largest = [
            a.point.distance(b.point),
            off(a.ds, b.ds),
            off(a.dt, b.dt),
            off(a.dss, b.dss),
            off(a.dst, b.dst),
            off(a.dtt, b.dtt),
        ];
        // Second derivatives are some units large.
        assert!(largest.into_iter().all(|off| off < 2e-14), "{s} {t}: {largest:?}");
        assert!(off(patch.normal(s, t).unwrap(), surface.unit_normal(s, t)) < 1e-14);
        assert!(surface.s_line(t).point(s).distance(a.point) < 1e-15);
        assert!(surface.t_line(s).point(t).distance(a.point) < 1e-15);
    }
    let part = surface.part([0.2, 0.7], [0.4, 1.0]);
    for (s, t) in [(0.0, 0.0), (0.5, 0.25), (1.0, 1.0)] {
        let there = surface.point(0.2 + 0.5 * s, 0.4 + 0.6 * t);
        assert!(part.point(s, t).distance(there) < 1e-15);
    }
    // At the pole the normal is the limit.
    let near = surface.unit_normal(0.5, 1.0 - 1e-6);
    assert!((surface.unit_normal(0.5, 1.0) - near).length() < 3e-6);
    assert!((surface.unit_normal(0.5, 1.0).dot(Vec3::Z).abs() - 1.0).abs() < 1e-13);
}

#[test]
fn a_similar_surface_is_similar_everywhere() {
    let (_, surface) = octant();
    let map = Mobius::reflection(Point3::new(3.0, 0.0, 1.0), Vec3::new(1.0, 2.0, -2.0)).unwrap();
    let image = surface.similar(&map).unwrap();
    let want = map.map_point(surface.point(0.3, 0.6)).unwrap();
    assert!(image.point(0.3, 0.6).distance(want) < 1e-14);
    let far = Mobius::inversion(Point3::new(5.0, 1.0, 4.0), 3.0).unwrap();
    assert_eq!(surface.similar(&far).unwrap_err().reason(), "not-a-similarity");
}
