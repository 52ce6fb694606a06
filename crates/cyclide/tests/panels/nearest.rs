use crate::shapes::{Random, cone, cylinder, general, grid_distance, plane, radii, rank, ring, sphere, torus};
use cyclide::{
    Frame, Point3, Vec3,
    conformal::Conformal,
    panel::{NearSurface, NearestSurfaces},
    surface::{CyclidePatch, ParamSurface, PatchKind},
};

fn all(near: &NearestSurfaces) -> Vec<NearSurface> {
    [Some(near.plane), near.cylinder, near.cone, near.sphere, near.torus].into_iter().flatten().collect()
}

#[test]
fn panels_of_simple_surfaces_are_found_to_lie_on_them() {
    let mut random = Random::new(1);
    let pieces: [(CyclidePatch, usize, [f64; 2]); 8] = [
        (plane(), 0, [0.0, 0.0]),
        (cylinder(), 1, [2.0, 0.0]),
        (cone(), 2, [0.4, 0.0]),
        (sphere(1.5), 3, [1.5, 0.0]),
        (torus(0.0), 4, [3.0, 1.0]),
        (torus(1.2), 4, [3.0, 1.0]),
        (torus(1.4), 4, [3.0, 1.0]),
        (torus(2.9), 4, [3.0, 1.0]),
    ];
    for (patch, kind, expected) in pieces {
        for (scale, far) in [(1.0, 0.0), (1e-6, 1e-6), (1e6, 1e6), (1.0, 1e5), (1e6, 1.0)] {
            let moved = patch.transformed(&random.similarity(scale, far)).unwrap();
            let near = NearestSurfaces::new(&moved);
            // 1e-12 of the size; far away the points themselves are rounded, by 1e5 times 1e-16, and fits are to those.
            let limit = 1e-12 * moved.size() + 4.0 * f64::EPSILON * far;
            let found = near.simplest_within(limit).unwrap_or_else(|| panic!("kind {kind}, {scale}, {far}: {near:?}"));
            assert_eq!(rank(&found.surface), kind, "{scale} {far}");
            assert_eq!(rank(&found.surface), rank(&moved.recognize()), "as files know it");
            let lengths = if kind == 2 { 1.0 } else { scale };
            for (radius, expected) in radii(&found.surface).into_iter().zip(expected) {
                // Radii follow from bulges of a twentieth of the size at least, and of less on the torus.
                let rounding = 1e-9 + 1e4 * limit / moved.size();
                assert!(
                    (radius / lengths - expected).abs() <= rounding * (1.0 + expected),
                    "{kind}: {radius} {expected}"
                );
            }
            // The placement says the same.
            assert!(grid_distance(&moved, &found.surface) <= limit + 64.0 * f64::EPSILON * (far + moved.size()));
            let alone = NearSurface::simplest(&moved, limit).unwrap().unwrap();
            assert!(rank(&alone.surface) == kind && alone.max_distance <= limit);
        }
    }
}

#[test]
fn the_plane_of_a_cap_halves_its_rise() {
    // A square panel of a sphere about its pole: the least largest distance is half of the height over its corners.
    let (radius, half) = (10.0_f64, 0.7_f64);
    let z = (radius * radius - 2.0 * half * half).sqrt();
    let corners = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)].map(|(x, y)| Point3::new(half * x, half * y, z));
    let normal = corners[0].to_vec().unit().unwrap();
    let toward = Vec3::X - normal * normal.x;
    let patch = CyclidePatch::from_corners_and_frame(corners, toward, normal.cross(toward)).unwrap();
    let rise = patch.point(0.5, 0.5).z - z;
    let near = NearestSurfaces::new(&patch);
    let distance = near.plane.max_distance;
    assert!(distance >= 0.5 * rise * (1.0 - 1e-9) && distance <= 0.5 * rise * 1.005, "{distance} {rise}");
    assert!(near.sphere.unwrap().max_distance < 1e-14 * radius);
}

/// A surface with its frame and radii changed by a little.
fn changed(kind: &PatchKind, by: f64, random: &mut Random) -> PatchKind {
    let mut frame = |f: &Frame, size: f64| {
        let origin = f.origin() + random.vector() * (by * size);
        Frame::from_normal(origin, f.z() + random.vector() * by, f.x()).unwrap()
    };
    match *kind {
        PatchKind::Plane { frame: f } => PatchKind::Plane { frame: frame(&f, 1.0) },
        PatchKind::Sphere { frame: f, radius, outward } => {
            let frame = frame(&f, radius);
            PatchKind::Sphere { frame, radius: radius * (1.0 + by * random.between(-1.0, 1.0)), outward }
        }
        PatchKind::Cylinder { frame: f, radius, outward } => {
            let frame = frame(&f, radius);
            PatchKind::Cylinder { frame, radius: radius * (1.0 + by * random.between(-1.0, 1.0)), outward }
        }
        PatchKind::Cone { frame: f, radius, half_angle, outward } => {
            let frame = frame(&f, radius);
            let half_angle = half_angle + by * random.between(-1.0, 1.0);
            PatchKind::Cone { frame, radius: radius * (1.0 + by * random.between(-1.0, 1.0)), half_angle, outward }
        }
        PatchKind::Torus { frame: f, major_radius, minor_radius, outward } => {
            let frame = frame(&f, minor_radius);
            let major_radius = major_radius + by * minor_radius * random.between(-1.0, 1.0);
            let minor_radius = minor_radius * (1.0 + by * random.between(-1.0, 1.0));
            PatchKind::Torus { frame, major_radius, minor_radius, outward }
        }
        PatchKind::Cyclide => PatchKind::Cyclide,
    }
}

/// True of a cone whose tip is at the panel, where it is no surface: fits to panels that are bent both ways have several such valleys.
fn has_tip_at(near: &NearSurface, size: f64) -> bool {
    matches!(near.surface, PatchKind::Cone { radius, half_angle, .. } if radius < 2.0 * size * half_angle.sin())
}

/// A panel as nets have them: the middle part of a general patch, whose normals turn by some tenths.
fn usual(random: &mut Random) -> CyclidePatch {
    general(random).sub_patch([0.35, 0.65], [0.35, 0.65]).unwrap()
}

#[test]
fn no_surface_beside_the_nearest_is_nearer() {
    let mut random = Random::new(2);
    let mut panels = vec![ring([12, 10]).remove(7), ring([10, 12]).remove(20), sphere(2.0), torus(0.8)];
    panels.extend((0..6).map(|_| usual(&mut random)));
    for (number, patch) in panels.iter().enumerate() {
        for near in all(&NearestSurfaces::new(patch)) {
            let at_grid = grid_distance(patch, &near.surface);
            assert!(near.max_distance >= at_grid * (1.0 - 1e-9) - 1e-13, "{number}: {near:?} {at_grid}");
            let (s, t) = near.place;
            let there = near.surface.distance(patch.point(s, t)).unwrap();
            assert!((there - near.max_distance).abs() < 1e-9 * patch.size(), "{number}: the place is told");
            if near.max_distance < 1e-9 || has_tip_at(&near, patch.size()) {
                continue;
            }
            // A walk of random steps that keeps what is better: fits are to half a percent, and cones and tori have several valleys.
            let (mut best, mut least) = (near.surface, at_grid);
            for step in 0..600 {
                let trial = changed(&best, 0.1 * 0.5_f64.powi(step / 40), &mut random);
                let distance = grid_distance(patch, &trial);
                if distance < least {
                    (best, least) = (trial, distance);
                }
            }
            assert!(least > 0.97 * near.max_distance, "{number}: {:?} {} {least}", near.surface, near.max_distance);
        }
    }
}

#[test]
fn the_simplest_becomes_simpler_as_the_tolerance_grows() {
    for patch in ring([8, 4]) {
        let near = NearestSurfaces::new(&patch);
        let mut before = 5;
        for k in 0..40 {
            let tolerance = 1e-9 * 2.0_f64.powi(k);
            let found = near.simplest_within(tolerance);
            let kind = found.map_or(5, |near| rank(&near.surface));
            assert!(kind <= before && found.is_none_or(|near| near.max_distance <= tolerance));
            assert_eq!(NearSurface::simplest(&patch, tolerance).unwrap().map_or(5, |near| rank(&near.surface)), kind);
            before = kind;
        }
        assert_eq!(before, 0, "all are planes to someone");
    }
    assert_eq!(NearSurface::simplest(&plane(), 0.0).unwrap_err().reason(), "tolerance-not-positive");
}

#[test]
fn distances_move_and_scale_with_the_panel() {
    let mut random = Random::new(3);
    for _ in 0..20 {
        let patch = usual(&mut random);
        let own = all(&NearestSurfaces::new(&patch));
        for scale in [1e-6, 1.0, 1e6] {
            let moved = patch.transformed(&random.similarity(scale, scale)).unwrap();
            let again = all(&NearestSurfaces::new(&moved));
            assert_eq!(own.len(), again.len());
            for (a, b) in own.iter().zip(&again).filter(|(a, _)| !has_tip_at(a, patch.size())) {
                // Fits stop within half a percent of the least: rounding may stop them a step apart.
                assert!((a.max_distance * scale / b.max_distance - 1.0).abs() < 0.02, "{a:?} {b:?}");
            }
        }
    }
}
