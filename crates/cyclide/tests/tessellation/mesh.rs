//! Meshes of patches, rings and nets.

use super::checks::{deviation, edges, sound, sound_of};
use super::data;
use cyclide::{
    Point3,
    mesh::{tessellate, tessellate_all},
    surface::CyclidePatch,
    topology::{Body, Shell},
};
use proptest::prelude::*;
use std::f64::consts::FRAC_PI_2;

fn body(patch: CyclidePatch) -> Body {
    Body { outer: Shell::from_surface(patch).unwrap(), voids: Vec::new() }
}

#[test]
fn known_patches_are_meshed_within_the_bound() {
    for (name, patch) in data::known() {
        let body = body(patch);
        let mut before = 0;
        // Places per cell: the finer the cells, the fewer, to keep the number of points in hand.
        for (tolerance, places) in [(1e-1, 6), (1e-2, 6), (1e-3, 6), (1e-4, 3), (1e-5, 2)] {
            let size = body.bounds().diagonal();
            let mesh = tessellate(&body, tolerance * size).unwrap();
            sound(name, &mesh);
            assert!(mesh.bound <= tolerance * size, "{name}: {:e}", mesh.bound);
            let [there, back] = deviation(&body, &mesh, places);
            assert!(there <= mesh.bound, "{name} {tolerance:e}: surface {there:e}, bound {:e}", mesh.bound);
            assert!(back <= mesh.bound, "{name} {tolerance:e}: mesh {back:e}, bound {:e}", mesh.bound);
            assert!(mesh.faces.len() >= before, "{name}: fewer cells for a smaller tolerance");
            before = mesh.faces.len();
        }
    }
}

#[test]
fn coarse_meshes_have_no_hole_between_two_points() {
    for (name, patch) in data::known().into_iter().filter(|(name, _)| name.contains("lens")) {
        let body = body(patch);
        for tolerance in [1e300, 1.0, 0.3, 0.1, 0.03, 0.01, 0.003] {
            let mesh = tessellate(&body, tolerance).unwrap();
            sound(name, &mesh);
            let [there, back] = deviation(&body, &mesh, 6);
            assert!(there <= mesh.bound && back <= mesh.bound, "{name}: {there:e} {back:e}, bound {:e}", mesh.bound);
        }
    }
}

#[test]
fn flat_directions_are_not_cut() {
    let count = |name: &str, tolerance: f64| {
        let (_, patch) = data::known().into_iter().find(|(n, _)| *n == name).unwrap();
        tessellate(&body(patch), tolerance).unwrap().faces.len()
    };
    assert_eq!(count("rectangle", 1e-12), 1);
    for (name, patch) in data::known().into_iter().filter(|(name, _)| ["annulus", "cylinder", "cone"].contains(name)) {
        for exponent in 2..14 {
            let mesh = tessellate(&body(patch), 0.5_f64.powi(2 * exponent)).unwrap();
            assert!(mesh.sources.iter().all(|source| source.t[1] - source.t[0] >= 1.0), "{name} 4^-{exponent}");
        }
    }
    // 2.5 radians of radius 1: R(1 - cos(angle/2n)) <= 1e-4 needs n = 89.
    assert!((89..=90).contains(&count("cylinder", 1e-4)), "{}", count("cylinder", 1e-4));
}

#[test]
fn the_border_of_a_mesh_is_that_of_the_patch() {
    for (name, patch) in data::known() {
        let body = body(patch);
        let mesh = tessellate(&body, 1e-3).unwrap();
        let border = edges(&mesh).into_iter().filter(|(_, uses)| uses.len() == 1);
        for ((a, b), _) in border {
            for vertex in [a, b] {
                let p = mesh.positions[vertex];
                let on = body
                    .outer
                    .edges()
                    .iter()
                    .map(|e| e.curve.arc().unwrap().closest_point(p).distance)
                    .fold(f64::INFINITY, f64::min);
                assert!(on <= 1e-14, "{name}: {on:e} off the border");
            }
        }
        // The shell's vertices come first, to the bit.
        assert!(body.outer.vertices().iter().all(|v| mesh.positions.contains(v)), "{name}");
    }
}

#[test]
fn counts_follow_the_tolerance() {
    // Both counts grow with the root of the tolerance, so cells with the tolerance.
    let body = body(data::torus([0.0, FRAC_PI_2], [0.0, FRAC_PI_2]));
    let cells = [1e-3, 1e-4, 1e-5].map(|tolerance| tessellate(&body, tolerance).unwrap().faces.len() as f64);
    for pair in cells.windows(2) {
        assert!((8.0..12.0).contains(&(pair[1] / pair[0])), "{cells:?}");
    }
    // The sum of the two sagittas of equal cells: 7000.
    assert!(cells[1] < 6500.0, "{cells:?}");
}

#[test]
fn poles_get_triangles_and_one_normal() {
    let mesh = tessellate(&body(data::octant()), 1e-3).unwrap();
    let triangles = mesh.faces.iter().filter(|f| f.corners().len() == 3).count();
    assert!(triangles > 4 && mesh.faces.len() > 2 * triangles);
    // A smooth pole: as many normals as vertices.
    assert_eq!(mesh.normals.len(), mesh.positions.len());
    let (_, cone) = data::known().into_iter().find(|(n, _)| *n == "cone to its tip").unwrap();
    let mesh = tessellate(&body(cone), 1e-3).unwrap();
    assert!(mesh.faces.iter().all(|f| f.corners().len() == 3), "one row of triangles");
    assert_eq!(mesh.normals.len(), mesh.positions.len() - 1 + mesh.faces.len(), "each has its normal at the tip");
}

#[test]
fn tolerances_out_of_range_have_named_errors() {
    let torus = body(data::torus([0.0, FRAC_PI_2], [0.0, FRAC_PI_2]));
    let reason = |tolerance: f64| tessellate(&torus, tolerance).unwrap_err().reason();
    assert_eq!(reason(0.0), "tolerance-not-positive");
    assert_eq!(reason(f64::NAN), "tolerance-not-positive");
    assert_eq!(reason(f64::INFINITY), "not-finite");
    assert_eq!(reason(1e-16), "parameter-out-of-range");
    assert_eq!(reason(1e-9), "too-many-pieces");
    // Beyond the size: the coarsest mesh whose arcs turn by 120 degrees at most.
    assert_eq!(tessellate(&torus, 1e300).unwrap().faces.len(), 1);
}

#[test]
fn several_bodies_are_one_mesh() {
    let bodies = [body(data::octant()), body(data::torus([0.0, 1.0], [0.0, 1.0]))];
    let mesh = tessellate_all(&bodies, 1e-2).unwrap();
    sound("two bodies", &mesh);
    let single: usize = bodies.iter().map(|b| tessellate(b, 1e-2).unwrap().faces.len()).sum();
    assert_eq!(mesh.faces.len(), single);
    assert!(mesh.sources.iter().any(|s| s.shell == 1));
}

/// The tolerances of the property below, of the size.
fn tolerance() -> impl Strategy<Value = f64> {
    (-4.0..-1.0).prop_map(|e: f64| 10.0_f64.powf(e))
}

proptest! {
    #[test]
    fn random_patches_are_meshed_within_the_bound(patch in data::patch(), relative in tolerance()) {
        let body = body(patch);
        let tolerance = relative * body.bounds().diagonal();
        let mesh = tessellate(&body, tolerance).unwrap();
        // Where |D|² is small a point is a quotient of small numbers, each rounded as the large ones are.
        let grid = || (0..=32_u32).flat_map(|i| (0..=32_u32).map(move |j| (f64::from(i) / 32.0, f64::from(j) / 32.0)));
        let squares = || grid().map(|(s, t)| patch.denominator(s, t).norm_squared());
        sound_of("random", &mesh, squares().fold(0.0, f64::max) / squares().fold(f64::INFINITY, f64::min));
        prop_assert!(mesh.bound <= tolerance);
        let [there, back] = deviation(&body, &mesh, 3);
        prop_assert!(there <= mesh.bound && back <= mesh.bound, "{there:e} {back:e} {:e}", mesh.bound);
    }

    #[test]
    fn size_does_not_matter(patch in data::patch(), exponent in -6_i32..6) {
        let scale = 10.0_f64.powi(exponent);
        let corners = patch.corners().map(|p| Point3::ORIGIN + p.to_vec() * scale);
        let [v1, v2, _] = patch.frame();
        let other = CyclidePatch::from_weights(corners, patch.weights(), v1, v2).unwrap();
        let (a, b) = (tessellate(&body(patch), 1e-2).unwrap(), tessellate(&body(other), 1e-2 * scale).unwrap());
        // Rounding may move a cut, and a count on the verge.
        let (counts, verge) = ([&a, &b].map(|m| m.faces.len() as f64), 1.2 * (a.faces.len() as f64).sqrt() + 2.0);
        prop_assert!((counts[0] - counts[1]).abs() <= verge, "{counts:?}");
        prop_assert!((a.bound * scale - b.bound).abs() <= 0.2 * b.bound, "{:e} {:e}", a.bound * scale, b.bound);
    }
}
