//! Silhouettes and depth against closed forms.

use super::*;
use crate::formats::png::eye::UP;
use crate::formats::png::scene::raster::bands;
use cyclide::Vec3;
use cyclide::{surface::CyclidePatch, topology::Shell};
use std::f64::consts::TAU;

const SIZE: (usize, usize) = (800, 600);

fn camera(shells: &[Shell], toward: Vec3) -> Camera {
    let points: Vec<Point3> = shells.iter().flat_map(|s| s.vertices().iter().copied()).collect();
    let right = UP.cross(toward).unit().unwrap_or(Vec3::X);
    Camera::new(&points, [right, toward.cross(right), toward], false, (SIZE.0 as f64, SIZE.1 as f64))
}

fn shell(patch: cyclide::Result<CyclidePatch>) -> Shell {
    Shell::from_surface(patch.unwrap()).unwrap()
}

/// A sphere of eight triangular patches.
fn sphere(centre: Point3, radius: f64) -> Vec<Shell> {
    let octant = |k: u32| {
        let sign = |bit: u32| if k >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let (x, y, z) = (Vec3::X * sign(0), Vec3::Y * sign(1), Vec3::Z * sign(2));
        let corners = [x, y, z, z].map(|v| centre + v * radius);
        shell(CyclidePatch::from_corners_and_frame(corners, y, z))
    };
    (0..8).map(octant).collect()
}

/// A torus about the z axis, of patches over equal angles.
fn torus(large: f64, small: f64, count: usize) -> Vec<Shell> {
    let angle = |i: usize| TAU * i as f64 / count as f64;
    let patch = |i: usize, j: usize| {
        let at = |i: usize, j: usize| {
            let (rho, z) = (large + small * angle(j).cos(), small * angle(j).sin());
            Point3::new(rho * angle(i).cos(), rho * angle(i).sin(), z)
        };
        let along = Vec3::new(-angle(i).sin(), angle(i).cos(), 0.0);
        let outward = Vec3::new(angle(i).cos(), angle(i).sin(), 0.0);
        let up = Vec3::Z * angle(j).cos() - outward * angle(j).sin();
        let corners = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
        shell(CyclidePatch::from_corners_and_frame(corners, along, up))
    };
    (0..count * count).map(|k| patch(k % count, k / count)).collect()
}

fn facets(shells: Vec<Shell>, camera: &Camera) -> Facets {
    let mut facets = Facets::default();
    for (index, outer) in shells.into_iter().enumerate() {
        let body = cyclide::topology::Body { outer, voids: Vec::new() };
        let mesh = cyclide::mesh::tessellate(&body, MESH * camera.unit()).unwrap();
        facets.add_body(&body, &mesh, index, camera);
    }
    facets
}

/// Calls `each` with every sample's place and facet.
fn samples(facets: &Facets, mut each: impl FnMut(f64, f64, u32)) {
    bands(&facets.corners, SIZE, |band| {
        for (row, x) in (0..band.rows).flat_map(|row| (0..band.width).map(move |x| (row, x))) {
            for (k, seen) in band.seen(x, row).iter().enumerate() {
                let (sx, sy) = sample_place(k, x, band.top + row);
                each(sx, sy, *seen);
            }
        }
    });
}

#[test]
fn a_sphere_covers_the_rays_that_meet_it() {
    let (centre, radius) = (Point3::new(3.0, -2.0, 5.0), 1.5);
    let camera = camera(&sphere(centre, radius), Vec3::new(0.5, -0.8, 0.5).unit().unwrap());
    let to_centre = centre - camera.eye();
    let limit = (to_centre.length_squared() - radius * radius).sqrt();
    let (mut wrong, mut covered) = (0, 0);
    samples(&facets(sphere(centre, radius), &camera), |x, y, seen| {
        let meets = camera.ray(x, y).dot(to_centre) >= limit;
        covered += u32::from(meets);
        wrong += u32::from(meets != (seen != NOTHING));
    });
    // The mesh is a quarter of a pixel off at most, on a radius of more than 200 pixels; ten times inside the 1 %.
    assert!(covered > 8 * 100_000 && f64::from(wrong) < 0.001 * f64::from(covered), "{wrong} of {covered}");
}

#[test]
fn a_torus_from_above_is_a_ring() {
    let (large, small) = (3.0, 1.0);
    // Twelve patches a turn: vertices stand at the outermost points of the picture, which is fitted to vertices here.
    let camera = camera(&torus(large, small, 12), UP);
    let mut covered = 0;
    samples(&facets(torus(large, small, 12), &camera), |_, _, seen| covered += u32::from(seen != NOTHING));
    // Tangents from the eye on the axis to the tube's circle: the angle to its center and the asin of its half width.
    let above = camera.eye().z;
    let (middle, half) = (large.atan2(above), (small / large.hypot(above)).asin());
    let focal = camera.project(Point3::new(large, 0.0, 0.0)).x - camera.project(Point3::ORIGIN).x;
    let focal = focal * above / large;
    let ring = 0.5 * TAU * focal * focal * ((middle + half).tan().powi(2) - (middle - half).tan().powi(2));
    let measured = f64::from(covered) / SAMPLE_COUNT as f64;
    assert!((measured / ring - 1.0).abs() < 0.002, "{measured} pixels, {ring} by the tangents");
}

#[test]
fn the_nearer_of_two_spheres_is_seen() {
    let toward = Vec3::new(0.5, -0.8, 0.5).unit().unwrap();
    let (near, far) = (Point3::ORIGIN + toward * 3.0, Point3::ORIGIN);
    for order in [[near, far], [far, near]] {
        let shells: Vec<Shell> = order.iter().flat_map(|c| sphere(*c, 1.0)).collect();
        let camera = camera(&shells, toward);
        let facets = facets(shells, &camera);
        let (mut of_near, mut of_far) = (0, 0);
        let (to_near, limit) = (near - camera.eye(), ((near - camera.eye()).length_squared() - 1.0).sqrt());
        samples(&facets, |x, y, seen| {
            // A pixel off the outline the answer is certain.
            let along = camera.ray(x, y).dot(to_near);
            if let (true, Some(Paint::Surface { surface, .. })) =
                (along > limit * (1.0 + 1e-4), facets.paints.get(seen as usize))
            {
                let first = *surface < 8;
                if first == (order[0] == near) { of_near += 1 } else { of_far += 1 }
            }
        });
        assert!(of_near > 100_000 && of_far == 0, "{of_near} and {of_far}");
    }
}

/// Facets that share edges cover every sample of their union exactly once.
#[test]
fn neighbors_leave_no_gap() {
    let shells = torus(3.0, 1.0, 8);
    let camera = camera(&shells, Vec3::new(0.1, -0.2, 0.97).unit().unwrap());
    let facets = facets(shells, &camera);
    let mut inside = vec![false; SIZE.0 * SIZE.1 * SAMPLE_COUNT];
    let mut index = 0;
    samples(&facets, |_, _, seen| {
        inside[index] = seen != NOTHING;
        index += 1;
    });
    // A hole is a sample without facet whose pixel has one and all whose eight neighbors are full.
    let full = |pixel: usize| (0..SAMPLE_COUNT).all(|k| inside[pixel * SAMPLE_COUNT + k]);
    let holes = (1..SIZE.1 - 1).flat_map(|y| (1..SIZE.0 - 1).map(move |x| y * SIZE.0 + x)).filter(|&p| {
        let around = [p - 1, p + 1, p - SIZE.0, p + SIZE.0];
        !full(p) && around.into_iter().all(full)
    });
    assert_eq!(holes.count(), 0);
}
