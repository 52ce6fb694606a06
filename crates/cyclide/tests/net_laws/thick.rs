//! Solids between a surface and its offset: beyond focal sets, over poles and nodes, under inversions.

use crate::derived::layer;
use cyclide::{
    Point3, Vec3,
    conformal::{Conformal, Mobius},
    model::SurfaceObject,
    surface::{CyclidePatch, CyclidicNet, DupinCyclide, NetFrame, ParamSurface, QuadGrid},
    topology::{Body, Shell},
};
use std::f64::consts::PI;

/// Half the angle of the cylinder.
const HALF: f64 = 0.6;

/// `n` by `n` patches of the unit cylinder about z over 2 `HALF` and heights 0 to 2, normal outward.
fn cylinder(n: usize) -> CyclidicNet {
    let at = |k: usize| k as f64 / n as f64;
    let place = |i: usize, j: usize| {
        let angle = HALF * (2.0 * at(i) - 1.0);
        Point3::new(angle.cos(), angle.sin(), 2.0 * at(j))
    };
    let points = (0..=n).flat_map(|j| (0..=n).map(move |i| place(i, j))).collect();
    let grid = QuadGrid::new(points, [n + 1, n + 1], [false, false]).unwrap();
    CyclidicNet::new(grid, NetFrame::First(Vec3::new(HALF.sin(), HALF.cos(), 0.0), Vec3::Z)).unwrap()
}

/// A patch of the unit sphere about the origin, normal outward, to latitude `top`.
fn sphere(top: f64) -> CyclidePatch {
    let at = |lon: f64, lat: f64| Point3::new(lat.cos() * lon.cos(), lat.cos() * lon.sin(), lat.sin());
    let corners = [at(0.0, 0.0), at(0.9, 0.0), at(0.0, top), at(0.9, top)];
    CyclidePatch::from_corners_and_frame(corners, Vec3::Y, Vec3::Z).unwrap()
}

fn thick(patch: CyclidePatch, h: f64) -> Body {
    match SurfaceObject::Patch(patch).thick(h).unwrap().unwrap() {
        SurfaceObject::Body(body) => body,
        other => panic!("{other:?}"),
    }
}

/// A closed solid with its outside outwards and hollows, with this volume.
fn check(body: &Body, want: f64) {
    assert!(body.is_solid());
    assert!(body.outer.volume() > 0.0 && body.voids.iter().all(|void| void.volume() < 0.0));
    let volume: f64 = body.shells().map(Shell::volume).sum();
    // Quadrature to 1e-12 of area times diameter, which is up to 1e3 times the volume here.
    assert!((volume / want - 1.0).abs() < 1e-9, "{volume} {want}");
    for shell in body.shells() {
        let (v, e, f) = (shell.vertices().to_vec(), shell.edges().to_vec(), shell.faces().to_vec());
        assert_eq!(&Shell::new(v, e, f).unwrap(), shell);
    }
}

#[test]
fn solids_behind_the_axis_of_a_cylinder() {
    // Radius 1 to -1/2 and on by h along the same normals: between the radii 1/2 and |h - 1/2|.
    for h in [0.2, -0.2] {
        let other: f64 = h - 0.5;
        let want = 2.0 * HALF * (0.25 - other * other).abs();
        let beyond = cylinder(1).patch(0, 0).offset(-1.5).unwrap();
        assert!(beyond.is_flipped());
        let body = thick(beyond, h);
        check(&body, want);
        // It is the offset of this patch, not of another one with these corners.
        for (s, t) in [(0.2, 0.3), (0.5, 0.5), (0.9, 0.1)] {
            let p = beyond.point(s, t) + beyond.unit_normal(s, t) * h;
            let off = body
                .outer
                .faces()
                .iter()
                .map(|f| f.surface.patch().unwrap().locate(p).distance)
                .fold(f64::INFINITY, f64::min);
            assert!(off < 1e-14, "{off:e}");
        }
        check(&cylinder(2).offset(-1.5).unwrap().thick(h).unwrap(), want);
    }
}

#[test]
fn solids_behind_the_centre_of_a_sphere() {
    // Both families run backwards: f_s × f_t is along the normal again.
    let beyond = sphere(0.8).offset(-1.5).unwrap();
    assert!(!beyond.is_flipped());
    for h in [0.2_f64, -0.2] {
        let cubes = (0.125 - (0.5 - h).powi(3)).abs();
        check(&thick(beyond, h), 0.9 * 0.8_f64.sin() * cubes / 3.0);
    }
}

#[test]
fn hollow_solids_behind_the_circle_of_centres_of_a_torus() {
    // The tube has the radii 1.5 and |h - 1.5|, by Pappus.
    let net = DupinCyclide::new(4.0, 0.0, 1.0).unwrap().nets([4, 4]).unwrap().remove(0).offset(-2.5).unwrap();
    assert_eq!(net.flipped_patches().len(), 16);
    for h in [0.2_f64, -0.2] {
        let body = net.thick(h).unwrap();
        assert_eq!(body.voids.len(), 1);
        check(&body, 2.0 * PI * PI * 4.0 * (2.25 - (h - 1.5).powi(2)).abs());
    }
}

#[test]
fn patches_against_each_other_bound_no_solid() {
    // The ring cyclide 1 < 2 < 4 moved inwards by 2: mu = 0, both parts of a horn in one net, nodes between patches.
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([4, 4]).unwrap().remove(0);
    let both = ring.offset(-2.0).unwrap();
    assert!(both.singular_patches().is_empty());
    assert_eq!(both.flipped_patches().len(), 8);
    for h in [0.01, -0.01] {
        let error = both.thick(h).unwrap_err();
        assert_eq!(error.reason(), "offset-not-regular");
        // No distance at all is right.
        assert!(error.to_string().ends_with("no distance is accepted"), "{error}");
    }
}

#[test]
fn patches_with_a_pole_are_made_thick() {
    let octant = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::Z].map(|v| Point3::ORIGIN + v);
    let octant = CyclidePatch::from_corners_and_frame(octant, Vec3::Y, Vec3::Z).unwrap();
    for h in [0.2_f64, -0.2] {
        let body = thick(octant, h);
        check(&body, PI / 6.0 * ((1.0 + h).powi(3) - 1.0).abs());
        // Two triangles and three rims; a prism with triangles at its ends has 6 vertices and 9 edges.
        let outer = &body.outer;
        assert_eq!((outer.faces().len(), outer.vertices().len(), outer.edges().len()), (5, 6, 9));
    }
}

#[test]
fn a_node_gets_a_rim_with_a_tip() {
    let mut made = 0;
    for d in [DupinCyclide::new(1.0, 0.5, 0.2).unwrap(), DupinCyclide::new(1.0, 0.3, 1.2).unwrap()] {
        for lobe in d.nets([4, 4]).unwrap() {
            for h in [0.03, -0.03] {
                // On the hollow side the lines near the node have their centers at any distance: refused.
                let patch = lobe.patch(0, 0);
                if patch.offset_is_regular(h) {
                    let body = thick(patch, h);
                    check(&body, layer(&patch.into(), h));
                    assert_eq!((body.outer.faces().len(), body.outer.vertices().len()), (6, 7));
                    made += 1;
                } else {
                    let error = SurfaceObject::Patch(patch).thick(h).unwrap().unwrap_err();
                    assert_eq!(error.reason(), "offset-not-regular");
                }
            }
        }
    }
    assert_eq!(made, 4, "one side of each part");
}

#[test]
fn offsets_on_a_focal_set_are_refused() {
    let torus = DupinCyclide::new(4.0, 0.0, 1.0).unwrap().nets([4, 4]).unwrap().remove(0);
    let refused = [
        torus.offset(-1.0).unwrap_err(),
        torus.patch(1, 2).offset(-1.0).unwrap_err(),
        cylinder(2).offset(-1.0).unwrap_err(),
        sphere(0.8).offset(-1.0).unwrap_err(),
    ];
    for error in refused {
        assert_eq!(error.reason(), "offset-on-focal-set");
        assert!(error.to_string().contains("distance -1 lies on the focal set"), "{error}");
    }
    // A thousandth of a millionth away it is a thin tube.
    let thin = torus.offset(-1.0 + 1e-9).unwrap().to_shell().unwrap();
    assert!((thin.area() / (4.0 * PI * PI * 4.0 * 1e-9) - 1.0).abs() < 1e-5);
    let error = torus.thick(0.0).unwrap_err().to_string();
    assert_eq!(error, "distance = 0 is outside 1e-150 to 1e150");
}

#[test]
fn a_hollow_solid_turned_inside_out_has_its_hollow_outside() {
    let body = DupinCyclide::new(4.0, 0.0, 1.0).unwrap().nets([6, 6]).unwrap().remove(0).thick(-0.4).unwrap();
    let volume: f64 = body.shells().map(Shell::volume).sum();
    // In the hollow, in the material, and in the hole of the ring.
    let [hollow, material, hole] = [4.0, 4.8, 0.0].map(|x| Mobius::inversion(Point3::new(x, 0.2, 0.1), 1.5).unwrap());
    for map in [hollow, hole] {
        let image = body.transformed(&map).unwrap();
        assert!(image.is_solid() && image.voids.len() == 1);
        assert!(image.outer.volume() > 0.0 && image.voids[0].volume() < 0.0);
        assert!(image.outer.bounds().contains(image.voids[0].bounds()), "the outer shell encloses the hollow");
        // The material is between the images of the surfaces still: a point of it stays inside.
        let back = image.transformed(&map).unwrap();
        let again: f64 = back.shells().map(Shell::volume).sum();
        // Two inversions at sizes up to 1e2.
        assert!((again / volume - 1.0).abs() < 1e-9, "{again} {volume}");
        assert!(back.outer.bounds().contains(back.voids[0].bounds()));
    }
    // The hollow's wall is the outer shell of one image, the void's of the other.
    let faces = |body: &Body| body.outer.faces()[0].surface.patch().unwrap().corners()[0];
    let (swapped, kept) = (body.transformed(&hollow).unwrap(), body.transformed(&hole).unwrap());
    assert_eq!(Some(faces(&swapped)), hollow.map_point(body.voids[0].faces()[0].surface.patch().unwrap().corners()[0]));
    assert_eq!(Some(faces(&kept)), hole.map_point(faces(&body)));
    assert_eq!(body.transformed(&material).unwrap_err().reason(), "point-at-infinity");
}

#[test]
fn area_and_volume_where_singular_lines_run_through_patches() {
    // The ring moved inwards until it is a horn, in one net whose patches the nodes are inside of.
    let ring = DupinCyclide::new(4.0, 1.0, 2.0).unwrap().nets([4, 4]).unwrap().remove(0);
    let shell = ring.offset(-1.3).unwrap().to_shell().unwrap();
    assert!(shell.faces().iter().any(|face| !face.surface.patch().unwrap().is_regular()));
    let cut = shell.with_regular_faces().unwrap();
    assert!(cut.faces().iter().all(|face| face.surface.patch().unwrap().is_regular()));
    assert!((shell.area() / cut.area() - 1.0).abs() < 1e-12, "{} {}", shell.area(), cut.area());
    assert!((shell.volume() / cut.volume() - 1.0).abs() < 1e-11, "{} {}", shell.volume(), cut.volume());
    // The same horn as two closed parts: f_s × f_t is outward on both in the net, too.
    let parts = DupinCyclide::new(4.0, 1.0, 0.7).unwrap().to_bodies([4, 4]).unwrap();
    let [small, large] = [&parts[0].outer, &parts[1].outer];
    assert!((shell.area() / (small.area() + large.area()) - 1.0).abs() < 1e-12);
    let want = large.volume() + small.volume();
    assert!((shell.volume() / want - 1.0).abs() < 1e-11, "{} {want}", shell.volume());
}
