//! Patches to tessellate: random ones, surfaces of revolution, awkward ones.

use cyclide::{Point3, Vec3, surface::CyclidePatch};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A patch of the surface of revolution about z: the meridian arc starts at radius and height `(r0, z0)` in the direction
/// `(dr, dz)` and ends at `(r1, z1)`; turned from the angle `u[0]` to `u[1]`
/// (`docs/math/revolution-and-pipes.md#patches-of-revolution`).
pub fn revolved([r0, z0]: [f64; 2], [r1, z1]: [f64; 2], [dr, dz]: [f64; 2], u: [f64; 2]) -> CyclidePatch {
    let at = |r: f64, z: f64, u: f64| Point3::new(r * u.cos(), r * u.sin(), z);
    let (a0, a1, a2) = (at(r0, z0, u[0]), at(r0, z0, u[1]), at(r1, z1, u[0]));
    // A pole is one point, to the bit.
    let a3 = if r1 == 0.0 { a2 } else { at(r1, z1, u[1]) };
    let (sine, cosine) = u[0].sin_cos();
    let norm = dr.hypot(dz);
    let v2 = Vec3::new(dr * cosine, dr * sine, dz) / norm;
    CyclidePatch::from_corners_and_frame([a0, a1, a2, a3], Vec3::new(-sine, cosine, 0.0), v2).unwrap()
}

/// The patch over the angles `u` round the axis and `v` round the tube of a torus with radii 2 and 0.5.
pub fn torus(u: [f64; 2], v: [f64; 2]) -> CyclidePatch {
    let at = |v: f64| [2.0 + 0.5 * v.cos(), 0.5 * v.sin()];
    revolved(at(v[0]), at(v[1]), [-v[0].sin(), v[0].cos()], u)
}

/// One eighth of the unit sphere, with a pole.
pub fn octant() -> CyclidePatch {
    revolved([1.0, 0.0], [0.0, 1.0], [0.0, 1.0], [0.0, FRAC_PI_2])
}

/// Known patches by name: plane, sphere, cylinder, cone, torus, poles, edges of half a circle and more.
pub fn known() -> Vec<(&'static str, CyclidePatch)> {
    let square = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [2.0, 1.0, 0.0]].map(Point3::from);
    vec![
        ("rectangle", CyclidePatch::from_corners_and_frame(square, Vec3::X, Vec3::Y).unwrap()),
        ("bent rectangle", {
            let v1 = Vec3::new(0.8, 0.0, 0.6);
            CyclidePatch::from_corners_and_frame(square, v1, Vec3::Y).unwrap()
        }),
        ("annulus", revolved([1.0, 0.5], [2.0, 0.5], [1.0, 0.0], [0.3, 2.0])),
        ("cylinder", revolved([1.0, 0.0], [1.0, 3.0], [0.0, 1.0], [0.0, 2.5])),
        ("cone", revolved([1.0, 0.0], [2.0, 3.0], [1.0, 3.0], [0.0, 2.5])),
        ("cone to its tip", revolved([1.0, 0.0], [0.0, 3.0], [-1.0, 3.0], [0.0, 2.5])),
        ("octant", octant()),
        ("sphere zone", revolved([0.8, -0.6], [0.8, 0.6], [0.6, 0.8], [0.0, 4.0])),
        ("quarter torus", torus([0.0, FRAC_PI_2], [0.0, FRAC_PI_2])),
        ("half torus", torus([0.0, PI], [-FRAC_PI_2, FRAC_PI_2])),
        ("torus, long way", torus([0.0, 1.5 * PI], [0.2, 0.2 + 1.2 * PI])),
        ("spindle with both tips inside", {
            // Tube of radius 1 about (0.5, 0): the meridian crosses the axis, there and back.
            let at = |v: f64| [0.5 + v.cos(), v.sin()];
            revolved(at(1.4), at(4.7), [-1.4_f64.sin(), 1.4_f64.cos()], [0.4, 1.4])
        }),
        ("lens between two tips", lens(1.001)),
        ("narrow lens between two tips", lens(1.0 + 1e-7)),
        ("lens ending at its tip", lens_to_its_tip()),
    ]
}

/// Part of a spindle torus with a tube of the given radius about the circle of radius 1: from before the first tip through
/// the inner side to behind the second. The tips are close together for a radius near 1.
fn lens(radius: f64) -> CyclidePatch {
    let at = |v: f64| [1.0 + radius * v.cos(), radius * v.sin()];
    let tip = (-1.0 / radius).acos();
    let (low, high) = (tip - 0.3, TAU - tip + 0.3);
    revolved(at(low), at(high), [-low.sin(), low.cos()], [0.0, FRAC_PI_2])
}

/// As [`lens`], to the second tip: a line that is one point, and a side that is.
fn lens_to_its_tip() -> CyclidePatch {
    let at = |v: f64| [1.0 + 1.001 * v.cos(), 1.001 * v.sin()];
    let tip = (-1.0_f64 / 1.001).acos();
    let low = tip - 0.3;
    revolved(at(low), [0.0, -1.001 * tip.sin()], [-low.sin(), low.cos()], [0.0, FRAC_PI_2])
}

/// A random patch: four points of a random circle in cyclic order and a random frame. Some have singular lines.
/// `None` if the patch passes through infinity. The last corner may be the one given.
fn random(angles: [f64; 4], frame: [f64; 3], last: Option<usize>) -> Option<CyclidePatch> {
    let [a, b, c] = frame;
    // Rotations about z, x, z: any frame.
    let turn = |v: Vec3, angle: f64, axis: Vec3| {
        let (s, c) = angle.sin_cos();
        v * c + axis.cross(v) * s + axis * (axis.dot(v) * (1.0 - c))
    };
    let rotate = |v: Vec3| turn(turn(turn(v, c, Vec3::Z), b, Vec3::X), a, Vec3::Z);
    let mut sorted = angles;
    sorted.sort_by(f64::total_cmp);
    let at = |k: usize| Point3::new(sorted[k].cos(), sorted[k].sin(), 0.25);
    let mut corners = [at(0), at(1), at(3), at(2)];
    corners[3] = corners[last.unwrap_or(3)];
    CyclidePatch::from_corners_and_frame(corners, rotate(Vec3::X), rotate(Vec3::Y)).ok()
}

/// Random patches of size about 1; a third of them have a singular line, a quarter a side of one point.
pub fn patch() -> impl Strategy<Value = CyclidePatch> {
    let angle = || 0.0..TAU;
    let four = (angle(), angle(), angle(), angle()).prop_map(|(a, b, c, d)| [a, b, c, d]);
    let frame = (angle(), 0.0..PI, angle()).prop_map(|(a, b, c)| [a, b, c]);
    let last = prop_oneof![6 => Just(None), 1 => Just(Some(1)), 1 => Just(Some(2))];
    (four, frame, last).prop_filter_map("distinct corners, not through infinity", |(angles, frame, last)| {
        random(angles, frame, last).filter(|patch| {
            let [a0, a1, a2, a3] = patch.corners();
            let sides = [(a0, a1), (a0, a2), (a1, a3), (a2, a3)].map(|(a, b)| a.distance(b));
            let shortest = sides.into_iter().filter(|&d| d > 0.0).fold(f64::INFINITY, f64::min);
            // Rounding grows with the square of the size over that of the corner circle, which is 1.
            shortest > 1e-3 && patch.bounds().max_abs() < 30.0
        })
    })
}
