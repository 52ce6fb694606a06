//! Random spherical cubes, near boxes and far from them, of any size and place.

use cyclide::{Point3, Vec3, volume::SphericalCube};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// So many cases, the same in every run.
#[must_use]
pub fn deterministic(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, rng_seed: RngSeed::Fixed(1), ..ProptestConfig::default() }
}

/// Vectors with coordinates below a size.
pub fn vector(size: f64) -> impl Strategy<Value = Vec3> {
    (-size..size, -size..size, -size..size).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

/// Embedded cubes near boxes, of any size and place.
pub fn cube() -> impl Strategy<Value = SphericalCube> {
    awkward_cube(0.3, 0..1, 1)
}

/// Embedded cubes of sizes from 1e-6 to 1e6: boxes with so much noise, flattened along each direction by up to 10 to the power of `-flat`, up to
/// `ten * 10^far` sizes from the origin.
pub fn awkward_cube(noise: f64, far: std::ops::Range<i32>, flat: i32) -> impl Strategy<Value = SphericalCube> {
    let sides = (vector(noise), vector(noise), vector(noise));
    let inside = (0.5..2.0, 0.5..2.0, 0.5..2.0);
    let flattened = (0..flat, 0..flat, 0..flat);
    (sides, inside, 0.0..=1.0, -6..=6, vector(10.0), far, flattened).prop_filter_map(
        "a cube",
        |((a, b, c), (x, y, z), turn, exponent, place, far, (p, q, r))| {
            let (size, place) = (10f64.powi(exponent), place * 10f64.powi(far));
            let at = |v: Vec3, flat: i32| Point3::ORIGIN + (place + v * 10f64.powi(-flat)) * size;
            let corners = [at(Vec3::ZERO, 0), at(Vec3::X + a, p), at(Vec3::Y + b, q), at(Vec3::Z + c, r)];
            SphericalCube::from_barycentric(corners, [x, y, z], turn).ok()
        },
    )
}
